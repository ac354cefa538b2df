"""Runs of two steps, and the scenes that they are evaluated on."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from scipy.io import savemat

from nscc_training.loop.train import train
from nscc_training.settings import settings_of

SMALL: dict[str, dict[str, Any]] = {
    "data": {"patch": 16, "scenes": 2, "val_items": 1},
    "train": {"steps": 2, "batch": 1, "validate_every": 2},
}

STILL: dict[str, dict[str, Any]] = {
    "shutter": {"class": "b", "slots": 16, "tile": [4, 4], "init": "random", "noise": 0.5},
    "data": {"patch": 16, "scenes": 3, "val_items": 2},
    "train": {"steps": 6, "batch": 2, "validate_every": 2, "code_rate": 0.05},
}
CLIP: dict[str, dict[str, Any]] = {
    "shutter": {
        "class": "codebook",
        "slots": 8,
        "tile": [4, 4],
        "rows": 16,
        "init": "random",
        "relaxation": "gumbel",
        "words_weight": 0.01,
    },
    "decoder": {"name": "unet3d"},
    "loss": {"name": "l1"},
    "data": {"protocol": "video-v1", "patch": 16, "scenes": 3, "val_items": 2},
    "train": {"steps": 4, "batch": 2, "validate_every": 2, "code_rate": 0.05},
}
FILES = {
    "checkpoint.safetensors",
    "config.resolved.toml",
    "environment.json",
    "metrics.csv",
    "shutter.nsl",
    "codes.npz",
    "capture.toml",
    "decoder.safetensors",
    "split.json",
    "result.json",
    "model_card.md",
}


def run(values: dict[str, dict[str, Any]], out: Path, **more: Any) -> None:
    train(settings_of(values), out, **more)


def changed(values: dict[str, dict[str, Any]], section: str, **keys: Any) -> dict[str, Any]:
    return {**values, section: {**values.get(section, {}), **keys}}


def trained(out: Path, **sections: dict[str, Any]) -> Path:
    values = {
        name: {**SMALL.get(name, {}), **sections.get(name, {})} for name in {*SMALL, *sections}
    }
    train(settings_of(values), out)
    return out


def clip(path: Path, frames: int, side: int) -> np.ndarray:
    rng = np.random.default_rng(3)
    ground = np.kron(rng.integers(20, 230, (side // 8, side // 8)), np.ones((8, 8)))
    orig = np.stack([np.roll(ground, k, axis=1) for k in range(frames)], axis=2).astype(np.uint8)
    mask = (rng.random((side, side, 8)) < 0.5).astype(np.uint8)
    meas = (orig[..., :8].astype(float) * mask).sum(axis=2)[..., None]
    savemat(path, {"orig": orig, "mask": mask, "meas": meas})
    return orig


def one_crop(path: Path) -> np.ndarray:
    """Write a panorama of one crop that can be exposed as the protocol says; its light there."""
    import cv2

    light = cv2.resize(np.exp(np.random.default_rng(1).uniform(-4, 4, (64, 128))), (1024, 512))
    light[:, 256:] = 1.0
    cv2.imwrite(str(path), np.repeat(light[..., None], 3, 2).astype("f4"))
    stored = cv2.imread(str(path), cv2.IMREAD_UNCHANGED)[128:384, :256, 1]
    return np.asarray(stored, float)
