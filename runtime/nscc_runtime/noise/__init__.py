"""Random numbers for the sensor's effects, each a pure function of a key and of a pixel's index.

The index of a pixel is row * cols + col in the whole array, so results do not depend on tiles,
threads or order."""

from __future__ import annotations

from nscc_runtime.noise.arrays import keys, normals, poisson, uniforms
from nscc_runtime.noise.keys import key
from nscc_runtime.noise.poisson_law import RATE_CAP

__all__ = ["RATE_CAP", "key", "keys", "normals", "poisson", "uniforms"]
