"""Record which effects saturated a pixel while its words run (`nscc_runtime.effects.marks`)."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from nscc.operations import Op
from nscc_runtime.effects import Selection
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.effects.views import Pixels

Full = NDArray[np.uint8]
Values = NDArray[np.float64]

ADDED, SUBTRACTED, LEVEL = 1, 2, 4


class Marks:
    """Saturation marks of some pixels, by register and PIX; arrays are (pixels,).

    `full`: bits that tell whether the content includes a full PIX with positive sign (ADDED), with
    negative sign (SUBTRACTED), or in a reset level (LEVEL). `lost`: electrons that registers lost.
    """

    def __init__(
        self, effects: Selection, sensor: Sensor, registers: Iterable[str], pixels: int
    ) -> None:
        self.effects, self.sensor = effects, sensor
        self.mark = {at: effects.marking(at) for at in ("well", "subtracted", "level", "registers")}
        self.full = {name: np.zeros(pixels, np.uint8) for name in registers}
        self.lost = {name: np.zeros(pixels) for name in registers}

    def fill(self, full: NDArray[np.bool_]) -> None:
        """Mark PIX as full where the mask is True."""
        self.full["PIX"] = self.full["PIX"] | full.astype(np.uint8) * np.uint8(ADDED)

    def fallen(self, pixels: Pixels, charge: Values) -> Values:
        """Return the charge of PIX after saturation; mark PIX as full where charge is lost."""
        for effect, clip in self.effects.acting("well"):
            charge_before, charge = charge, clip(pixels, charge)
            if "well" in effect.marks:
                self.fill(charge < charge_before)
        return charge

    def clip_register(self, pixels: Pixels, value: Values, lost_e: Values) -> tuple[Values, Values]:
        """Return a register's value after saturation, and the electrons lost including `lost_e`."""
        for effect, clip in self.effects.acting("registers"):
            value_before, value = value, clip(pixels, value)
            if "registers" in effect.marks:
                lost_e = lost_e + np.abs(value_before - value)
        return value, lost_e

    def empty(self, acting: NDArray[np.bool_]) -> None:
        """Clear the marks of PIX where it is reset."""
        self.full["PIX"] = np.where(acting, np.uint8(0), self.full["PIX"])

    def gathered(
        self, op: Op, unseen: NDArray[np.bool_], lit: NDArray[np.bool_]
    ) -> tuple[Full, Values]:
        """Return the marks and lost electrons that a bus word's result inherits from its sources.

        `unseen`: where the word does not read the charge of PIX. `lit`: where it reads a reset
        level with light."""
        full, lost_e = np.zeros_like(self.full["PIX"]), np.zeros_like(self.lost["PIX"])
        for name in op.sources:
            source_full = self.full[name]
            if name == "PIX":
                source_full = np.where(unseen, np.uint8(0), source_full)
                source_full = source_full | np.where(
                    lit & (source_full != 0), np.uint8(LEVEL), np.uint8(0)
                )
            full |= source_full
            lost_e = lost_e + self.lost[name]
        return inverted(full), lost_e / op.operation.divisor

    def write(self, name: str, acting: NDArray[np.bool_], full: Full, lost_e: Values) -> None:
        """Set the marks and lost electrons of a register where `acting`."""
        self.full[name] = np.where(acting, full, self.full[name])
        self.lost[name] = np.where(acting, lost_e, self.lost[name])

    def read_out(self, name: str, gain: float) -> NDArray[np.uint8]:
        """Return the bits of `saturated_by` (pixels,) of a register's readout."""
        full = inverted(self.full[name]) if gain < 0 else self.full[name]
        bits = np.zeros_like(full)
        for at, is_marked in (
            ("well", full & ADDED), ("subtracted", full & SUBTRACTED), ("level", full & LEVEL)
        ):  # fmt: skip
            mark = self.mark[at]
            if mark is not None:
                bits |= np.where(is_marked, np.uint8(mark.bit), np.uint8(0))
        mark = self.mark["registers"]
        if mark is not None:
            exceeds = self.lost[name] > mark.least_e(self.sensor)
            bits |= np.where(exceeds, np.uint8(mark.bit), np.uint8(0))
        return bits


def inverted(full: Full) -> Full:
    """Return the marks of the negated value: ADDED and SUBTRACTED are exchanged."""
    exchanged = (full & ADDED) * SUBTRACTED | (full & SUBTRACTED) // SUBTRACTED
    return np.asarray(exchanged | full & LEVEL, np.uint8)
