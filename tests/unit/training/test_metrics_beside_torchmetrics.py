"""PSNR and SSIM against those of torchmetrics, on any pictures."""

from __future__ import annotations

import numpy as np
import pytest
import torch
from cpu_torchvision import declare_operators
from hypothesis import given
from hypothesis import strategies as st

from nscc_training import metrics

declare_operators()
from torchmetrics.functional.image import (  # noqa: E402
    peak_signal_noise_ratio,
    structural_similarity_index_measure,
)

EDGE = 5


@given(
    st.integers(11, 40),
    st.integers(11, 40),
    st.sampled_from([1.0, 255.0, 3e4]),
    st.integers(0, 2**32 - 1),
    st.floats(1e-3, 0.5),
)
def test_psnr_and_ssim_are_those_of_torchmetrics(
    rows: int, cols: int, data_range: float, seed: int, noise: float
) -> None:
    generator = np.random.default_rng(seed)
    truth = data_range * generator.random((rows, cols))
    result = truth + data_range * noise * generator.standard_normal((rows, cols))
    pair = [torch.from_numpy(x)[None, None] for x in (result, truth)]
    psnr_db = peak_signal_noise_ratio(pair[0], pair[1], data_range=data_range)
    _, windows = structural_similarity_index_measure(
        pair[0], pair[1], data_range=data_range, reduction="none", return_full_image=True
    )
    # torchmetrics also has windows that reach beyond the edge, over reflected pixels.
    ssim = windows[0, 0, EDGE:-EDGE, EDGE:-EDGE].mean()
    assert metrics.psnr(truth, result, data_range) == pytest.approx(float(psnr_db), abs=1e-5)
    assert metrics.ssim(truth, result, data_range) == pytest.approx(float(ssim), abs=1e-5)
