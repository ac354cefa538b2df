"""The level of PIX after a reset, and the values that words at the same boundary read from PIX."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects import Selection
from nscc_runtime.effects.views import Pixels, Word

Bits = NDArray[np.bool_]
Values = NDArray[np.float64]


class Resets:
    """The reset levels of some pixels; arrays are (pixels,). Boundaries are rising numbers."""

    def __init__(self, effects: Selection, pixels: int) -> None:
        self._leaving, self._letting_in = effects.at("resets"), effects.at("level")
        self._level_e, self._last = np.zeros(pixels), np.full(pixels, -1.0)

    def reset(self, pixels: Pixels, acting: Bits, word: Word, boundary: float) -> None:
        """Set the reset level of the pixels in `acting`."""
        level = np.zeros_like(self._level_e)
        for change in self._leaving:
            level = change(pixels, level, word)
        self._level_e = np.where(acting, level, self._level_e)
        self._last = np.where(acting, boundary, self._last)

    def unseen(self, boundary: float) -> Bits:
        """Return a mask of pixels where words do not read the charge of PIX: PIX was reset at this
        boundary, and no effect lets light into the level."""
        return np.asarray((self._last == boundary) & (not self._letting_in))

    def lit(self, boundary: float) -> Bits:
        """Return a mask of pixels where words read the reset level plus light since the reset."""
        return np.asarray((self._last == boundary) & bool(self._letting_in))

    def read_level(self, pixels: Pixels, charge: Values, word: Word, boundary: float) -> Values:
        """Return the value that a word reads from PIX when PIX contains `charge`."""
        charge_and_level = np.where(self.unseen(boundary), 0.0, charge)
        for lit in self._letting_in:
            charge_and_level = np.where(self._last == boundary, lit(pixels, charge, word), charge)
        return charge_and_level + self._level_e
