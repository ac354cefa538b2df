"""Finished runs in Python: learned shutters, training curves, captures and reconstructions."""

from __future__ import annotations

import csv
import os
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from torch import nn

from nscc import html
from nscc.arrays import Bytes, Floats, Floats32
from nscc.diagnostics.arguments import as_array, path_of, shown, warn, wrong_argument
from nscc.emit.notebook import shutter_chart
from nscc.mappings import JsonObject
from nscc.shutter_program import ShutterProgram, compile
from nscc.toml.arguments import argument
from nscc.toml.kinds import Flag
from nscc_runtime import exposing
from nscc_runtime.captured import Capture
from nscc_runtime.frame_file import last_codes
from nscc_runtime.python_arguments import LightLike
from nscc_runtime.scene_settings import Scene
from nscc_training import run_folder
from nscc_training.code_choices import LOOKS
from nscc_training.encoders import Encoder
from nscc_training.frame_reading import Dark, FrameRead, by_colour, mean_dark, read_dark, read_frame
from nscc_training.loop.decoding import decoded_frame
from nscc_training.measures import METRIC_NAMES, score_text
from nscc_training.reconstruct import likelihoods, reconstructed
from nscc_training.run_files import run_capture
from nscc_training.run_folder import RunFolder

_CURVES = "metrics.csv"
DarkLike = Capture | str | os.PathLike[str]
FrameLike = DarkLike | NDArray[np.integer[Any]]


@dataclass(frozen=True, eq=False, repr=False)
class Run:
    """A finished training run.

    Parameters
    ----------
    folder : RunFolder
        The loaded parts of the run.
    """

    folder: RunFolder

    @property
    def path(self) -> Path:
        """The folder of the run."""
        return self.folder.path

    @property
    def still(self) -> bool:
        """Whether the run reconstructs pictures instead of clips."""
        return self.folder.setup.still

    @property
    def encoder(self) -> Encoder:
        """The learned shutters: `encoder.codes()` are int64 on the tile, by field."""
        return self.folder.setup.encoder

    @property
    def decoder(self) -> nn.Module:
        """The learned decoder, from frames (batch, rows, cols) and shutters (N, rows, cols)."""
        return self.folder.setup.decoder

    @property
    def result(self) -> JsonObject:
        """The scores of the run: `result.json`."""
        return self.folder.result

    @cached_property
    def program(self) -> ShutterProgram:
        """The learned shutters as a program, `shutter.nsl`, compiled as by `nscc run`."""
        return compile(self.path / "shutter.nsl", target=self.folder.setup.chip.file)

    @cached_property
    def curves(self) -> dict[str, Floats]:
        """The columns of the log `metrics.csv` by name, each a float64 array (lines,).

        Empty cells are NaN. In the column `split`, 1 means validation and 0 training."""
        with open(self.path / _CURVES, encoding="utf-8", newline="") as file:
            rows = [*csv.DictReader(file)]

        def number(name: str, text: str) -> float:
            """Return the cell `text` of the column `name` as a number: 1 for the split "val" and 0
            for "train", NaN if it is empty."""
            if name == "split":
                return float(text == "val")
            return float(text) if text else float("nan")

        names = rows[0] if rows else ()
        return {name: np.array([number(name, row[name]) for row in rows]) for name in names}

    def capture(self, light: LightLike, **options: Any) -> Capture:
        """Capture a scene with the program and sensor of the run.

        A scene without exposure gets that of the run, as with `nscc run --like`.

        Parameters
        ----------
        light : array, Light, Scene or str
            Light in electrons per slot (N, rows, cols) or over the frame, or a scene or its name.
        **options
            Further arguments of `nscc_runtime.capture`.

        Returns
        -------
        Capture
        """
        like = run_capture(self.path)
        if isinstance(light, str | os.PathLike):
            light = Scene(os.fspath(light))
        if isinstance(light, Scene):
            light = replace(
                light,
                exposure=light.exposure or like.exposure_of(light.name),
                transfer=light.transfer or like.transfer,
            )
        return exposing.capture(self.program, light, **{"sensor": like.sensor, **options})

    def reconstruct(
        self, frame: FrameLike, *, force: bool = False, dark: DarkLike | None = None
    ) -> Floats32:
        """Decode a frame.

        Parameters
        ----------
        frame : Capture, str, PathLike or array of int
            A capture, a frame file, or converter codes, (rows, cols) or of two buckets (2, rows,
            cols). Codes are not checked against program and sensor.
        force : bool
            Warn instead of refusing a frame of another program or sensor.
        dark : Capture, str or PathLike, optional
            A capture without light, with many repeats. Its mean is subtracted.

        Returns
        -------
        array of float32
            Electrons over the frame (rows, cols), or electrons per slot (T, rows, cols) of a clip,
            the unit of `Capture.truth_e`. Colours are the last axis.

        Raises
        ------
        Rejected
            NS0819 for a frame of another program or sensor, or a dark frame of another program or
            with light; NS0789 for other arguments, or for a run with classes.
        """
        if self.folder.setup.classes:
            raise wrong_argument("reconstruct: this run names classes; use `classify`")
        return self._decoded(frame, force=force, dark=dark)

    def _decoded(
        self, frame: FrameLike, *, force: bool = False, dark: DarkLike | None = None
    ) -> Floats32:
        """Return the decoder's output for a frame: light in electrons, or scores of classes.

        `frame` is a capture, a frame file or an array of converter codes. With `force`, another
        program or sensor is only a warning. `dark` is a dark capture or file, or None. Raises
        Rejected (NS0819, NS0789). Warnings are shown by Python's `warnings`."""
        if isinstance(frame, str | os.PathLike):
            read, name = read_frame(Path(frame)), str(frame)
        elif isinstance(frame, Capture):
            about = frame.meta
            in_colours = "colours" in about
            buckets = self.folder.setup.buckets
            if frame.frame.shape[-3] != buckets or (frame.frame.ndim != 3 and not in_colours):
                expected = "one bucket" if buckets == 1 else "two buckets"
                raise wrong_argument(
                    f"reconstruct takes {expected} of one exposure, not {shown(frame.frame)}"
                )
            codes, full = (
                by_colour(values, in_colours) for values in (frame.frame, frame.saturated)
            )
            read = FrameRead(codes, saturated=full, meta=about, shutter=None)
            name = "the capture"
        else:
            codes = self._codes(frame)
            # Codes alone do not say which pixels are saturated: those with the last code count.
            full = last_codes(codes, self.folder.setup.target) != 0
            return decoded_frame(self.folder.setup, codes, full)
        dark_frames = None if dark is None else self._dark(dark)
        forced = argument("reconstruct", "force", Flag(), force)
        light, messages = reconstructed(self.folder, read, name, dark_frames, force=forced)
        warn(messages)
        return light

    def classify(self, frame: FrameLike, **options: Any) -> dict[str, float]:
        """Name the class of a frame, for a run that was trained with classes.

        Parameters
        ----------
        frame : Capture, str, PathLike or array of int
            A capture, a frame file, or converter codes, (rows, cols).
        **options
            `force` and `dark`, as `reconstruct` takes them.

        Returns
        -------
        dict of str to float
            The likelihoods of the classes, most likely first. Their sum is 1.

        Raises
        ------
        Rejected
            NS0819 for a frame of another program or sensor; NS0789 for other arguments, or for a
            run without classes.
        """
        classes = self.folder.setup.classes
        if not classes:
            raise wrong_argument("classify needs a run that was trained with classes (class-v1)")
        return likelihoods(classes, self._decoded(frame, **options))

    def __repr__(self) -> str:
        """Return path, class of shutters, slots, tile, decoder and last score as one line."""
        spec, score = self.encoder.spec, self._score()
        return (
            f"<nscc run {str(self.path)!r}: class {spec.kind}, {spec.slots} slots, tile "
            f"{spec.tile[0]} x {spec.tile[1]}, {self.folder.setup.settings.decoder.name}{score}>"
        )

    def _repr_html_(self) -> str:
        """Return the run as HTML for notebooks: curves, shutters and the folded text of the
        program."""
        spec, setup = self.encoder.spec, self.folder.setup
        about = (
            f"class {spec.kind}, {spec.slots} slots, {setup.settings.decoder.name}{self._score()}"
        )
        return html.card(
            str(self.path),
            about,
            curve_chart(self.curves),
            self._shutters(),
            html.folded("the program", html.plain(self.folder.program)),
        )

    def _score(self) -> str:
        """Return the last score of the run as text that follows other text, such as ", 31.2 dB"; ""
        without a score."""
        metric = self.folder.setup.protocol.metrics[0]
        scores = [v for v in self.curves.get(metric, np.array([])) if np.isfinite(v)]
        return f", {score_text(metric, scores[-1])}" if scores else ""

    def _shutters(self) -> html.Html:
        """Return the chart of the different shutters of the tile, each labelled with the first code
        that has it. It is empty for pixels that look, whose open time depends on the light."""
        spec, codes = self.encoder.spec, self.encoder.codes()
        if spec.kind == LOOKS:
            return html.Html()  # the open time of a pixel depends on the light
        opened = self.encoder.hard().cpu().numpy().astype(bool).reshape(spec.slots, -1).T
        rows, first = np.unique(opened, axis=0, return_index=True)
        flat = {name: values.reshape(-1) for name, values in codes.items() if name != "book"}
        labels = [
            ", ".join(f"{name} {values[at]}" for name, values in flat.items()) or "all pixels"
            for at in first
        ]
        slot_us = [self.folder.setup.chip.slot_us] * spec.slots
        if spec.buckets == 1:
            return shutter_chart(rows[:, None], labels, slot_us, ("exposure",))
        return shutter_chart(np.stack([rows, ~rows], axis=1), labels, slot_us, ("first", "second"))

    def _dark(self, dark: DarkLike) -> Dark:
        """Return the dark frame `dark`, the path of a file or a capture, with the mean over its
        repeats. Raise Rejected (NS0819) for a file that is not a valid dark frame."""
        if not isinstance(dark, Capture):
            return read_dark(path_of("reconstruct: dark", dark), self.folder.setup.buckets)
        codes = dark.frame.reshape(-1, *dark.frame.shape[-3:])
        offset = mean_dark(codes, self.folder.setup.model.adc_offset_lsb)
        full = float(dark.saturated.mean())
        return Dark("the dark capture", offset, dark.meta, dark.container.slot_us, full)

    def _codes(self, frame: object) -> Bytes:
        """Check `frame`, an array of converter codes, and return it as uint8 (rows, cols), or (2,
        rows, cols) for two buckets.

        A single bucket may have an axis of its own. Raises WrongArgument for another size or type,
        or codes outside the converter's range."""
        target = self.folder.setup.target
        size: tuple[int, ...] = (target.rows, target.cols)
        if self.folder.setup.buckets > 1:
            size = (self.folder.setup.buckets, *size)
        values = as_array("reconstruct", "the frame", frame)
        if values.shape == (1, *size):
            values = values[0]
        top = self.folder.setup.model.top_code
        if values.dtype.kind not in "ui" or values.shape != size:
            raise wrong_argument(
                f"reconstruct takes a capture, a frame file or its codes {size}, not {shown(frame)}"
            )
        if values.min() < 0 or values.max() > top:
            raise wrong_argument(
                f"reconstruct: codes must be 0..{top}, but these are {values.min()}..{values.max()}"
            )
        return values.astype(np.uint8)


def load_run(path: str | os.PathLike[str], *, trust_code: bool = False) -> Run:
    """Load a finished run.

    Parameters
    ----------
    path : str or PathLike
        A folder, or the name of a shipped run: hdr, clip.
    trust_code : bool
        Allow a run that names Python code of its own, which loading executes.

    Returns
    -------
    Run

    Raises
    ------
    Rejected
        NS0818 if the folder contains no finished run, NS0823 if the run needs `trust_code`.
    """
    trusted = argument("load_run", "trust_code", Flag(), trust_code)
    return Run(run_folder.load_run(path_of("load_run", path), trust_code=trusted))


_WIDTH, _HEIGHT, _LEFT, _TOP, _BELOW = 350.0, 130.0, 66.0, 20.0, 20.0


def curve_chart(curves: Mapping[str, Floats]) -> html.Html:
    """Return two charts over the training steps: the validation score (PSNR, or the fraction of
    right classes), and the training loss.

    `curves` are the columns of `metrics.csv` by name, arrays of one length: `step`, `split` (1 for
    validation), `loss`, and `correct` or `psnr_db`."""
    val = curves["split"] == 1
    metric = "correct" if "correct" in curves else "psnr_db"
    return html.side_by_side(
        _chart(title, curves["step"][rows], curves[name][rows], colour)
        for title, name, rows, colour in (
            (f"validation {METRIC_NAMES[metric]}", metric, val, html.SERIES[0]),
            ("training loss", "loss", ~val, html.SERIES[1]),
        )
    )


def _chart(title: str, steps: Floats, values: Floats, colour: str) -> html.Html:
    """Return the SVG chart of `values` over `steps` (both of one length), with the range of values
    and the last step at its axes, `title` above, and the line in `colour`. It is empty without
    finite values."""
    known = np.isfinite(values)
    steps, values = steps[known], values[known]
    if not len(values):
        return html.Html()
    low, high = float(values.min()), float(values.max())
    span, last = (high - low) or 1.0, float(steps.max()) or 1.0
    x = _LEFT + (_WIDTH - _LEFT) * steps / last
    y = _TOP + _HEIGHT * (1 - (values - low) / span)
    points = " ".join(f"{a:.1f},{b:.1f}" for a, b in zip(x, y, strict=True))
    frame = f"M{_LEFT:g} {_TOP:g}v{_HEIGHT:g}H{_WIDTH:g}"
    # Offsets of the texts from the frame are in pixels of the drawing.
    shapes = [
        f"<path d='{frame}' fill='none' stroke='currentColor' stroke-opacity='.4'/>",
        f"<polyline points='{points}' fill='none' stroke='{colour}' stroke-width='1.5'/>",
        f"<circle cx='{x[-1]:.1f}' cy='{y[-1]:.1f}' r='3' fill='{colour}'/>",
        html.words(_LEFT, 13, title),
        html.words(_LEFT - 5, _TOP + 10, f"{high:.4g}", "end"),
        html.words(_LEFT - 5, _TOP + _HEIGHT, f"{low:.4g}", "end"),
        html.words(_WIDTH, _TOP + _HEIGHT + 15, f"step {last:g}", "end"),
    ]
    return html.drawing(_WIDTH + 5, _TOP + _HEIGHT + _BELOW, shapes, title)
