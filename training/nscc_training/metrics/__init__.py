"""How far a reconstruction is from the truth. Data ranges are always given, never guessed."""

from __future__ import annotations

from nscc_training.metrics.psnr import (
    FrameScores,
    frame_scores,
    mu_psnr,
    psnr,
    psnr_of_mse,
    pu21_psnr,
)
from nscc_training.metrics.ssim import ssim
from nscc_training.metrics.temporal import temporal_error

__all__ = [
    "FrameScores",
    "frame_scores",
    "mu_psnr",
    "psnr",
    "psnr_of_mse",
    "pu21_psnr",
    "ssim",
    "temporal_error",
]
