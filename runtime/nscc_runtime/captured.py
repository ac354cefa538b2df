"""What a capture gives in Python: the arrays of a frame file, and where they come from."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc import html
from nscc.diagnostics.arguments import wrong_argument
from nscc.files import write_whole
from nscc.words.container import Container
from nscc_runtime.effects import Selection
from nscc_runtime.frame_file import KEEP, Frame, FrameFile, Provenance, frame_lines, meta
from nscc_runtime.light import Light
from nscc_runtime.merge import Readout, light_estimate, readouts
from nscc_runtime.plan_file import plan_table
from nscc_runtime.planner.audit import Audit
from nscc_runtime.planner.plan import Plan
from nscc_runtime.response import Response, response_of

_SIDE = 256
"""Pixels that a picture has at least on a page."""


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class Capture(Frame):
    """One scene captured; with `repeat` its arrays have a leading axis K.

    `frame` uint8, codes of the converter; `exposure_e` float64, electrons before it; `valid` and
    `saturated` bool, `saturated_by` uint8; each (buckets, rows, cols) as in a frame file. `plan`
    says what was simulated, and to what error; None where that was no plan's to decide. `audit` is
    what was measured, where asked for. `light` and `container` are what was exposed, and with which
    words; `effects` were simulated; `origin` goes into `meta`.
    """

    container: Container
    light: Light
    effects: Selection
    origin: Provenance
    plan: Plan | None = None
    audit: Audit | None = None

    @property
    def truth_e(self) -> NDArray[np.floating[Any]]:
        """What a shutter that is always open would see: electrons over the frame (rows, cols) of a
        still, electrons a slot (N, rows, cols) of a clip. The unit of reconstructions."""
        return self.light.total_e() if self.light.kind == "still" else self.light.dense()

    @property
    def response(self) -> Response:
        """How an exposure follows from light: gain, and what is there in the dark."""
        return response_of(self.container, self.origin.sensor, self.effects)

    def light_e_per_s(self) -> NDArray[np.float64]:
        """The light that the frame tells of, electrons a second (buckets, rows, cols); NaN where no
        pixel tells any.

        Around each pixel the light of unsaturated ones, free of what the words add, divided by the
        time that they were open: as the picture of `nscc run --png`. Of repeats the first.
        """
        told = (light_estimate(each) for each in self._readouts())
        return np.stack([np.where(known, light, np.nan) for light, known in told])

    @property
    def meta(self) -> dict[str, Any]:
        """How it was made, as JSON values: `meta` of a frame file."""
        return meta(self.container, self.light, self, self.origin)

    def save(self, path: str | os.PathLike[str], keep: Sequence[str] = ()) -> Path:
        """Write the frame file that `nscc run -o` writes; where it went.

        `keep` names what else goes in, of light, truth, shutter, codes. Raises Rejected
        (NS0784) where nothing can be written.
        """
        out = Path(path)
        named = (keep,) if isinstance(keep, str) else tuple(keep)
        for name in named:
            if name not in KEEP:
                raise wrong_argument(f"save can keep {', '.join(KEEP)}, not {name[:60]!r}")
        if out.suffix.lower() != ".npz":
            raise wrong_argument(
                f"a capture is saved as an .npz file, not as '{out.name}'",
                helps=(f"save('{out.stem or 'frame'}.npz'), which numpy.load reads",),
            )
        shutters = self.container.table.shutters if "shutter" in named else None
        file = FrameFile.of(self.container, self.light, self, self.meta, named, shutters)
        write_whole(out, file.write)
        return out

    def __repr__(self) -> str:
        shape = " x ".join(map(str, self.frame.shape))
        mean = float(self.exposure_e[self.valid].mean()) if self.valid.any() else 0.0
        how = self.origin.fidelity if self.plan is None else (
            f"error {self.plan.predicted_e:.3g} e predicted"
        )  # fmt: skip
        return f"<nscc capture: {shape}, codes {self._codes()}, mean {mean:.6g} e, {how}>"

    def _repr_html_(self) -> str:
        first = self.first.frame
        scale = max(1, round(_SIDE / first.shape[2]))
        pictures = html.side_by_side(
            html.picture(_png(image), name, scale * first.shape[2])
            for image, name in zip(first, self.container.buckets, strict=True)
        )
        lines = html.plain("\n".join(frame_lines(self.container, self)))
        told = html.Html()
        if self.plan is not None:
            summary = f"what was simulated, to {self.plan.tolerance_e:.4g} e"
            told = html.folded(summary, html.plain(plan_table(self.plan, self.audit)))
        effects = "by a plan" if self.plan is not None else f"fidelity {self.origin.fidelity}"
        subtitle = f"{' x '.join(map(str, self.frame.shape))}, codes {self._codes()}, {effects}"
        return html.card("capture", subtitle, pictures, lines, told)

    def _readouts(self) -> list[Readout]:
        return readouts(self.container, self.first, self.response)

    def _codes(self) -> str:
        return f"{self.frame.min()}..{self.frame.max()}"


def _png(image: NDArray[np.uint8]) -> bytes:
    import cv2

    _, data = cv2.imencode(".png", np.ascontiguousarray(image))
    return data.tobytes()
