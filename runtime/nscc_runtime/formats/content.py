"""What is written: light that is a picture or a clip, and the arrays that tell all of it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.pictures.tone import Tone, fitted

Arrays = Mapping[str, NDArray[Any]]


@dataclass(frozen=True, eq=False)
class Content:
    """One product, as every format can take it.

    `light` is (rows, cols) of a picture, (T, rows, cols) of a clip (`moving`), with an axis of red,
    green and blue at the end where it is in `colour`; None for what is neither. `arrays` go into
    an .npz, their first into an .npy, unless `main` gives it; `whole` writes the .npz instead where
    more belongs into it. `benchmark` gives the arrays of a .mat. `codes` (shape of `light`) are
    shown as they are, unless a `tone` is asked for; light is shown by its `tone`, by default that
    named in `usual`, with `white` (default: a percentile) as white, in the light's `unit`.
    """

    arrays: Arrays
    light: NDArray[Any] | None = None
    moving: bool = False
    colour: bool = False
    codes: NDArray[np.uint8] | None = None
    whole: Callable[[Any], object] | None = None
    main: Callable[[], NDArray[Any]] | None = None
    benchmark: Callable[[], Arrays] | None = None
    tone: str | None = None
    usual: str = "log"
    white: float | None = None
    unit: str = "e"

    @cached_property
    def shown_by(self) -> Tone | None:
        """The tone curve of `shown`; None where codes are shown."""
        if self.light is None or (self.codes is not None and self.tone is None):
            return None
        return fitted(self.tone or self.usual, self.light, self.white)

    @property
    def shown(self) -> NDArray[np.uint8]:
        """The light as a screen shows it."""
        tone = self.shown_by
        if tone is None:
            assert self.codes is not None  # formats of pictures take what has light or codes
            return self.codes
        return tone(self.light if self.light is not None else np.zeros(0))

    @property
    def told(self) -> str:
        """How light became greys, for those who look at them."""
        tone = self.shown_by
        if tone is None:
            return "codes as read out"
        return f"{tone.name}, white {tone.white:.4g}{f' {self.unit}' if self.unit else ''}"

    def lacks(self, kinds: str) -> str | None:
        """Why a format of these `kinds` (picture, clip, arrays) cannot hold it; None if it can."""
        if "arrays" in kinds:
            return None
        if self.light is None:
            return "this is neither a picture nor a clip"
        if self.moving and "clip" not in kinds:
            return "this is a clip"
        if not self.moving and "picture" not in kinds:
            return "this is a single picture"
        return None
