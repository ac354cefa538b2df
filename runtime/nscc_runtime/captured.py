"""The result of a capture in Python: the arrays of a frame file, and the settings of the
capture."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc import html
from nscc.arrays import Array, Bools, Bytes, Floats
from nscc.diagnostics.arguments import path_of
from nscc.files import write_together
from nscc.mappings import JsonObject, NamedValues
from nscc.toml.arguments import argument
from nscc.toml.kinds import TextKind
from nscc.words.container import Container
from nscc_runtime.formats import check_ending, endings, file_of
from nscc_runtime.formats.content import frame_content
from nscc_runtime.frame_file import KEEP, Frame, FrameFile, meta
from nscc_runtime.light import Light
from nscc_runtime.merge import light_estimate, readouts
from nscc_runtime.pictures.tone import TONES
from nscc_runtime.pieces import Taken
from nscc_runtime.planning.audit import Audit
from nscc_runtime.planning.plan import Plan
from nscc_runtime.planning.plan_file import plan_table
from nscc_runtime.response import Response, with_decode_arrays
from nscc_runtime.run_messages import frame_lines

_SIDE, _MOST = 256, 1024
"""Side of a picture in a notebook, in pixels: about `_SIDE` at least, `_MOST` at most."""


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class Capture(Frame):
    """One captured scene. With `repeat`, all arrays have a leading axis of K frames.

    The frame has the shape of the array, or of the picture if the picture was exposed in pieces.
    Colours are a leading axis.

    Parameters
    ----------
    frame : array of uint8
        Codes of the analog-to-digital converter, (buckets, rows, cols).
    exposure_e : array of float64
        Electrons before conversion, (buckets, rows, cols).
    valid : array of bool
        Pixels that are usable, (buckets, rows, cols).
    saturated_by : array of uint8
        Causes of saturation as bits, (buckets, rows, cols).
    told : mapping
        States, open slots and light of a program whose pixels look, by name.
    exposed : Taken
        The scene, the program and the settings of the capture.
    """

    exposed: Taken

    @property
    def plan(self) -> Plan | None:
        """The plan (the effects that are simulated) of the capture; None if no plan was made."""
        return self.exposed.simulated.plan

    @property
    def audit(self) -> Audit | None:
        """The result of the audit; None if none was requested."""
        return self.exposed.simulated.audit

    @property
    def container(self) -> Container:
        """The words, with a code for every pixel of the frame."""
        return self.exposed.container

    @property
    def light(self) -> Light:
        """The exposed light; for a colour capture the red light."""
        return self.exposed.light

    @property
    def truth_e(self) -> NDArray[np.floating[Any]]:
        """The light without shutters, in the unit of reconstructions. Electrons over the frame
        (rows, cols) for a still, electrons per slot (N, rows, cols) for a clip."""
        return self.light.total_e() if self.light.kind == "still" else self.light.dense()

    @property
    def images(self) -> dict[str, Floats]:
        """The images that the program reads, by name: electrons before the converter, (rows, cols),
        with `repeat` after an axis of frames. Empty for a program without images."""
        return self._pictures_read("image_")

    @property
    def planes(self) -> dict[str, Bools]:
        """The planes that the program reads, by name: bool (rows, cols), with `repeat` after an
        axis of frames. Empty for a program without planes."""
        return self._pictures_read("plane_")

    @property
    def margin(self) -> Bools | None:
        """Mask (rows, cols) of pixels that depend on light beyond the array; None for a program
        without images and planes."""
        return self.told.get("margin")

    @property
    def reports(self) -> NamedValues:
        """The reports of the program on its planes, by "KIND PLANE".

        `any` is a bool. `events` is int32 (events, 2), columns and rows in reading order. `box`
        contains the smallest column and row and the largest column and row, or is None if no bit is
        1. `count` is an int, the number of bits, and `sum` a float, the electrons of an image.
        `flood` is whether a flood was complete. With `repeat`, each is a list."""
        pictures = self.container.pictures
        reports: NamedValues = {}
        for report in pictures.reports:
            key, name = report.key, report.subject
            values, counts = self.told[key], self.told.get(f"{key}_count")
            # The axes of one frame's report; one more is that of repeated frames.
            repeated = values.ndim > {"events": 2, "box": 1}.get(report.kind, 0)
            frames = range(len(values)) if repeated else [...]
            frame_values = [
                _report(report.kind, values[n], None if counts is None else counts[n])
                for n in frames
            ]
            reports[f"{report.kind} {name}"] = frame_values if repeated else frame_values[0]
        return reports

    def _pictures_read(self, prefix: str) -> dict[str, Array]:
        """Return the arrays `told` with the keys `prefix` + name, by name, of those images and
        planes that are read out and have one."""
        keys = {name: f"{prefix}{name}" for name in self.container.pictures.reads}
        return {name: self.told[key] for name, key in keys.items() if key in self.told}

    @property
    def response(self) -> Response:
        """The response of the sensor with which the capture was made: gain, offset and variance of
        each exposure."""
        return self.exposed.response(self.exposed.simulated.origin.sensor)

    def light_e_per_s(self) -> Floats:
        """Estimate the light from the unsaturated pixels of each neighbourhood.

        The offset that the words add is subtracted, and the result is divided by the open time, as
        in the picture of `nscc run --png`. Repeated captures use the first frame, colour captures
        the red frame.

        Returns
        -------
        array of float64
            Electrons per second, (buckets, rows, cols); NaN if no neighbour gives a value.
        """
        estimates = map(light_estimate, readouts(self.container, self.first, self.response))
        return np.stack([np.where(known, light, np.nan) for light, known in estimates])

    @property
    def meta(self) -> JsonObject:
        """The settings of the capture as JSON values: `meta` of a frame file."""
        origin = self.exposed.simulated.origin
        return meta(self.container, self.light, self, origin) | self.exposed.meta_entries

    def save(
        self,
        path: str | os.PathLike[str],
        keep: str | Sequence[str] = (),
        *,
        tone: str | None = None,
    ) -> Path:
        """Write the capture to a file, as `nscc run -o` does.

        Parameters
        ----------
        path : str or PathLike
            The ending selects the format: `.npz` for a frame file; `.hdr`, `.exr`, `.pfm` or
            `.tiff` for electrons; `.png`, `.gif` or `.mp4` for converter codes.
        keep : str or sequence of str
            Further contents of a frame file: `light`, `truth`, `shutter`, `codes`.
        tone : str, optional
            Tone curve with which `.png`, `.gif` and `.mp4` show electrons; None shows converter
            codes.

        Returns
        -------
        Path
            The file that was written.

        Raises
        ------
        Rejected
            NS0786 for other endings, NS0784 if the file cannot be written, NS0789 for other
            arguments.
        """
        out = path_of("save", path)
        check_ending(out, endings(), "a frame")
        named = tuple(keep) if isinstance(keep, list | tuple | set) else (keep,)
        for name in named:
            argument("save", "keep", TextKind(KEEP), name)
        if tone is not None:
            argument("save", "tone", TextKind(tuple(TONES)), tone)
        shutters = self.container.table.shutters
        file = FrameFile.of(self.container, self.light, self, self.meta, named, shutters)
        content = frame_content(
            with_decode_arrays(file, self.container),
            self.container,
            self.light,
            lambda: shutters,
            tone,
        )
        write_together({out: file_of(out, content, "a frame")})
        return out

    def __repr__(self) -> str:
        """Return shape, codes, mean exposure (e) and the kind of simulation as one line."""
        shape = " x ".join(map(str, self.frame.shape))
        mean = float(self.exposure_e.mean(where=self.valid)) if self.valid.any() else 0.0
        how = self._fidelity
        if self.plan is not None:
            predicted_e = self.plan.predicted_e
            how = "planned" if predicted_e is None else f"error {predicted_e:.3g} e predicted"
        return f"<nscc capture: {shape}, codes {self._codes()}, mean {mean:.6g} e, {how}>"

    def _repr_html_(self) -> str:
        """Return the capture as HTML for notebooks: pictures of all buckets, figures, and its plan
        (the effects that are simulated). Of repeated frames the first is shown, of colours all
        three as one picture."""
        shown = np.moveaxis(self.frame, 0, -1) if self._in_colours else self.first.frame
        # Large pictures are thinned out to every `step`-th pixel, small ones enlarged.
        cols = shown.shape[2]
        step, scale = -(-max(shown.shape[1:3]) // _MOST), max(1, round(_SIDE / cols))
        pictures = html.side_by_side(
            html.picture(_png(image[::step, ::step]), name, scale * cols // step)
            for image, name in zip(shown, self.container.buckets_read, strict=True)
        )
        lines = html.plain("\n".join(frame_lines(self.container, self)))
        plan_card = html.Html()
        if self.plan is not None:
            summary = f"what was simulated, to {self.plan.allowed}"
            plan_card = html.folded(summary, html.plain(plan_table(self.plan, self.audit)))
        effects = "by a plan" if self.plan is not None else f"fidelity {self._fidelity}"
        subtitle = f"{' x '.join(map(str, self.frame.shape))}, codes {self._codes()}, {effects}"
        return html.card("capture", subtitle, pictures, lines, plan_card)

    @property
    def _in_colours(self) -> bool:
        """Whether the scene was exposed once for each colour."""
        return "colours" in self.exposed.meta_entries

    @property
    def _fidelity(self) -> str:
        """How the frame was made: by a plan (the effects that are simulated), by the reference, or
        on a device."""
        return self.exposed.simulated.origin.fidelity

    def _codes(self) -> str:
        """The range of the codes as text, such as 3..255; "of no bucket" for a frame without
        buckets."""
        return f"{self.frame.min()}..{self.frame.max()}" if self.frame.size else "of no bucket"


def _report(kind: str, values: Array, count: Any) -> Any:
    """Return the value of one frame's report of this `kind` from its array `values`: a bool or
    number for "any", "flood", "count" and "sum"; for "events" the first `count` rows, (events, 2);
    for "box" a tuple of four numbers, or None if no bit is 1 (-1 in the array). `count` is ignored
    but for "events"."""
    if kind in ("any", "flood", "count", "sum"):
        return values.item()
    if kind == "events":
        return values[: int(count)]
    return None if values[0] < 0 else tuple(values.tolist())


def _png(image: Bytes) -> bytes:
    """Return the uint8 `image`, (rows, cols) of grey or (rows, cols, 3) of red, green and blue, as
    the bytes of a PNG file."""
    import cv2

    # OpenCV orders colours blue, green, red.
    _, data = cv2.imencode(
        ".png", np.ascontiguousarray(image[..., ::-1] if image.ndim == 3 else image)
    )
    return data.tobytes()
