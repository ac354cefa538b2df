"""Random numbers for the sensor's effects, each a pure function of a key and of a pixel's index.

The index of a pixel is row * cols + col in the whole array, so results do not depend on tiles,
threads or order."""

from __future__ import annotations

from nscc_runtime.noise.arrays import RATE_CAP, normals, poisson, uniforms
from nscc_runtime.noise.keys import key

__all__ = ["RATE_CAP", "key", "normals", "poisson", "uniforms"]
