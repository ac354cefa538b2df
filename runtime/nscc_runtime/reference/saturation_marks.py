"""What cut the pixels' values off while their words run (`nscc_runtime.effects.marks`)."""

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
    """Of some pixels, by register and PIX: `full`, whether what it holds has a full PIX ADDED or
    SUBTRACTED, or that of a LEVEL, and `lost`, electrons that registers lost on its way. Arrays are
    (pixels,).
    """

    def __init__(
        self, effects: Selection, sensor: Sensor, registers: Iterable[str], pixels: int
    ) -> None:
        self.effects, self.sensor = effects, sensor
        self.mark = {at: effects.marking(at) for at in ("well", "subtracted", "level", "registers")}
        self.full = {name: np.zeros(pixels, np.uint8) for name in registers}
        self.lost = {name: np.zeros(pixels) for name in registers}

    def fill(self, full: NDArray[np.bool_]) -> None:
        """PIX is full there."""
        self.full["PIX"] = self.full["PIX"] | full.astype(np.uint8) * np.uint8(ADDED)

    def fallen(self, pixels: Pixels, charge: Values) -> Values:
        """What PIX holds of its charge: it is full where that is less."""
        for effect, clip in self.effects.acting("well"):
            charge_before, charge = charge, clip(pixels, charge)
            if "well" in effect.marks:
                self.fill(charge < charge_before)
        return charge

    def clip_register(self, pixels: Pixels, value: Values, lost_e: Values) -> tuple[Values, Values]:
        """What a register holds of a value with which so much was lost, and what is then."""
        for effect, clip in self.effects.acting("registers"):
            value_before, value = value, clip(pixels, value)
            if "registers" in effect.marks:
                lost_e = lost_e + np.abs(value_before - value)
        return value, lost_e

    def empty(self, acting: NDArray[np.bool_]) -> None:
        """PIX is reset there."""
        self.full["PIX"] = np.where(acting, np.uint8(0), self.full["PIX"])

    def gathered(
        self, op: Op, unseen: NDArray[np.bool_], lit: NDArray[np.bool_]
    ) -> tuple[Full, Values]:
        """What the result of a bus word has of its sources', but where it does not see what PIX
        holds; `lit`: where it reads the level of a reset."""
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
        """A register holds that there."""
        self.full[name] = np.where(acting, full, self.full[name])
        self.lost[name] = np.where(acting, lost_e, self.lost[name])

    def read_out(self, name: str, gain: float) -> NDArray[np.uint8]:
        """The bits of `saturated_by` (pixels,) of a register's readout."""
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
    """What is added of the negative was subtracted."""
    exchanged = (full & ADDED) * SUBTRACTED | (full & SUBTRACTED) // SUBTRACTED
    return np.asarray(exchanged | full & LEVEL, np.uint8)
