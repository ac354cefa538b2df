"""The content of an output file: a picture or a clip of light, and the arrays of the result."""

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
    """The content of an output file, in the form that every file format accepts.

    Attributes
    ----------
    arrays : mapping of str to array
        The arrays of an .npz file. An .npy file contains `main()`, or the first array if None.
    light : array, optional
        A picture (rows, cols) or a clip (T, rows, cols) in `unit`, with a last axis of red, green,
        blue if `colour`. None if the content is neither picture nor clip.
    moving, colour : bool
        Whether `light` is a clip, and whether it has colours.
    codes : array, optional
        Codes of the converter, uint8, with the shape of `light`. They are shown unless `tone` is
        set.
    write_npz : callable, optional
        Writes the .npz file if it contains more than `arrays`.
    benchmark : callable, optional
        Returns the arrays of a .mat file.
    tone, usual : str
        The requested tone curve (None if not requested), and the default tone curve.
    white : float, optional
        The light shown as white; None for a percentile.
    picture : callable
        Turns `light` or `codes` of other shapes into a picture. It is called for one frame of a
        clip at a time, because a clip may be larger than memory.
    """

    arrays: Arrays
    light: NDArray[Any] | None = None
    moving: bool = False
    colour: bool = False
    codes: NDArray[np.uint8] | None = None
    write_npz: Callable[[Any], object] | None = None
    main: Callable[[], NDArray[Any]] | None = None
    benchmark: Callable[[], Arrays] | None = None
    tone: str | None = None
    usual: str = "log"
    white: float | None = None
    unit: str = "e"
    picture: Callable[[NDArray[Any]], NDArray[Any]] = np.asarray

    @cached_property
    def shown_by(self) -> Tone | None:
        """The tone curve that `shown` applies; None if codes are shown."""
        if self.light is None or (self.codes is not None and self.tone is None):
            return None
        light = np.stack([*self.pictures]) if self.moving else self.picture(self.light)
        return fitted(self.tone or self.usual, light, self.white)

    @property
    def pictures(self) -> Iterator[NDArray[Any]]:
        """The light as an iterator of pictures: the frames of a clip, or one picture."""
        return self._pictures(self.light)

    @property
    def shown(self) -> Iterator[NDArray[np.uint8]]:
        """The pictures for display (uint8) as an iterator, after the tone curve."""
        tone = self.shown_by
        return self._pictures(self.codes) if tone is None else map(tone, self.pictures)

    def _pictures(self, values: NDArray[Any] | None) -> Iterator[NDArray[Any]]:
        assert values is not None  # `lacks` refuses content without light
        return map(self.picture, values if self.moving else [values])

    @property
    def tone_text(self) -> str:
        """A text with the tone curve and its white level."""
        tone = self.shown_by
        if tone is None:
            return "codes as read out"
        return f"{tone.name}, white {tone.white:.4g}{f' {self.unit}' if self.unit else ''}"

    def lacks(self, kinds: str) -> str | None:
        """Return the reason why a format of `kinds` cannot hold the content; None if it can."""
        if "arrays" in kinds:
            return None
        if self.light is None:
            return "this is neither a picture nor a clip"
        if self.moving and "clip" not in kinds:
            return "this is a clip"
        if not self.moving and "picture" not in kinds:
            return "this is a single picture"
        return None
