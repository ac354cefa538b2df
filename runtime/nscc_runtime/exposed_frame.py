"""An exposed frame, as the emulator and devices return it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from nscc.arrays import Bools, Bytes, Floats


@dataclass(frozen=True, eq=False)
class Exposure:
    """One exposed frame, before the ADC.

    `exposure_e` float64 (buckets, rows, cols): electrons, in the order of `Container.buckets`; +0
    for a pixel that never opens. `valid` bool, the same shape: False where the value is not finite
    or meaningless. `saturated_by` uint8, the same shape: saturation marks
    (`nscc_runtime.effects.effect`); None if saturation is impossible."""

    exposure_e: Floats
    valid: Bools
    saturated_by: Bytes | None = None


@dataclass(frozen=True, eq=False)
class Executed:
    """One frame of pixels that look: the exposure, and the final digital registers that are read,
    kept or contain code, as planes (rows, cols)."""

    exposure: Exposure
    planes: Mapping[str, Bools]
