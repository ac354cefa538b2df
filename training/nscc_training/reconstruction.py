"""The result of a reconstruction, and warnings about overexposed frames."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nscc.diagnostics.diagnostic import Diagnostic, Severity
from nscc_runtime.formats import Content

_OVEREXPOSED = 0.25
"""Fraction of saturated pixels above which a warning is given."""


@dataclass(frozen=True, eq=False)
class Reconstruction:
    """A reconstructed picture or clip.

    `light` is float32, a picture (rows, cols) in electrons over the frame, or a clip (T, rows,
    cols) in electrons per slot; with `colour` the last axis is red, green, blue. `messages` are
    warnings about the frame. `decode_s` is the decoding time in seconds. `method` names the method
    of the decoder for any code, else it is empty."""

    light: NDArray[np.float32]
    still: bool
    colour: bool
    messages: tuple[Diagnostic, ...]
    decode_s: float
    method: str = ""

    @property
    def content(self) -> Content:
        """The reconstruction in the form for all output formats."""
        arrays = {"image" if self.still else "video": self.light}
        if self.method:
            arrays["method"] = np.array(self.method)
        # Time is the last axis of clips in MATLAB.
        turned = arrays if self.still else arrays | {"video": np.moveaxis(self.light, 0, -1)}
        return Content(
            arrays, self.light, not self.still, self.colour, benchmark=lambda: turned,
            usual="log" if self.still else "srgb",
        )  # fmt: skip


def overexposed(name: str, saturated: NDArray[np.bool_]) -> Iterator[Diagnostic]:
    """Yield a warning (NS0844) if too many pixels of a frame are saturated."""
    share = float(saturated.mean()) if saturated.size else 0.0
    if share > _OVEREXPOSED:
        yield Diagnostic(
            "NS0844",
            f"{100 * share:.3g} % of the pixels of '{name}' are saturated",
            severity=Severity.WARNING,
            notes=("a saturated pixel gives the decoder only a lower limit of the light",),
            helps=("expose the scene with less light, or use shutters that close early",),
        )  # fmt: skip
