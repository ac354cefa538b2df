"""What is written: light that is a picture or a clip, and the arrays that tell all of it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
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
    named in `usual`, with `white` (default: a percentile) as white, in the light's `unit`. Light
    and codes of other shapes have a `picture` made of them, of each frame of a clip when a format
    comes to it: films are larger than memory.
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
    picture: Callable[[NDArray[Any]], NDArray[Any]] = np.asarray

    @cached_property
    def shown_by(self) -> Tone | None:
        """The tone curve of `shown`; None where codes are shown."""
        if self.light is None or (self.codes is not None and self.tone is None):
            return None
        light = np.stack([*self.pictures]) if self.moving else self.picture(self.light)
        return fitted(self.tone or self.usual, light, self.white)

    @property
    def pictures(self) -> Iterator[NDArray[Any]]:
        """The light: frame by frame of a clip, or a single picture."""
        return self._pictures(self.light)

    @property
    def shown(self) -> Iterator[NDArray[np.uint8]]:
        """The same as a screen shows it."""
        tone = self.shown_by
        return self._pictures(self.codes) if tone is None else map(tone, self.pictures)

    def _pictures(self, values: NDArray[Any] | None) -> Iterator[NDArray[Any]]:
        assert values is not None  # formats of pictures take what has light or codes
        return map(self.picture, values if self.moving else [values])

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
