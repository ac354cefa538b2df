"""The sheet of a demo: ground truth, ordinary camera, readout, reconstruction, error, and PSNR."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from nscc.arrays import Array, Bytes, Floats
from nscc_runtime.pictures.images import Image, image_sheet
from nscc_runtime.pictures.tone import Tone, fitted
from nscc_training.code_choices import over_array
from nscc_training.demo.expose import Exposed, FrameAndDark, Looked
from nscc_training.design.bracket import merged_bracket
from nscc_training.design.chip import DesignChip
from nscc_training.metrics import finite_mean, mu_psnr, psnr

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_SIDE_PIXELS = 512
"""Approximate side of a panel in pixels; pictures are magnified by whole numbers."""
_SIDE_INCHES = 3.6
"""Side of a panel in inches."""
_MOMENTS = 4
"""Number of frames of a clip that are shown."""
_CORNER = 16
"""Most rows and columns of the array whose shutters are shown."""
_ERROR_TOP = 64
"""Error, in grey levels of 255, that has the last colour of the scale."""
_PEAK_PERCENTILE = 99.9
"""Percentile of light that is the peak of PSNR for HDR stills, as in protocol hdr-v1."""


@dataclass(frozen=True, eq=False)
class Shown:
    """The content of a sheet.

    `light` is the reconstruction of `exposed_scene` in electrons, over the frame (rows, cols, [3])
    or per slot (T, rows, cols, [3]), as the ground truth. `how` names the method, which took
    `decode_s` seconds. `display` means that the scene is in display encoding. `tone` names a tone
    curve of `nscc_runtime.pictures.tone`; None chooses one by the scene (`curve`)."""

    exposed_scene: Exposed
    display: bool
    tone: str | None
    light: Array
    how: str
    decode_s: float

    @property
    def still(self) -> bool:
        """Whether the scene is a still."""
        return self.exposed_scene.still

    @cached_property
    def truth(self) -> Array:
        """The ground truth in electrons: over the frame (rows, cols, [3]) for a still, per slot (T,
        rows, cols, [3]) for a clip."""
        return self.exposed_scene.truth()

    @property
    def white_e(self) -> float | None:
        """The electrons that the display shows as white, over the frame for a still, per slot for a
        clip; None if the scene is not in display encoding."""
        return self.exposed_scene.white_e() if self.display else None

    @property
    def curve(self) -> str:
        """The name of the tone curve: the chosen one, else a logarithm for stills of linear light
        and sRGB for all other scenes."""
        return self.tone or ("log" if self.still and not self.display else "srgb")

    @cached_property
    def fitted(self) -> Tone:
        """The tone curve, fitted to the ground truth. All panels use it, so that their greys are
        comparable."""
        return fitted(self.curve, self.truth, self.white_e)

    @cached_property
    def usual_light(self) -> Floats:
        """The light estimated from always open pixels, in electrons, in the shape of the ground
        truth."""
        return self._camera_light(self.exposed_scene.usual)

    @cached_property
    def fair_light(self) -> Floats | None:
        """The light of an ordinary camera at its best, in electrons, in the shape of the ground
        truth; None for a clip with one readout, for which it would be the always open camera."""
        fair = self.exposed_scene.fair
        return None if fair is None else self._camera_light(fair)

    def _camera_light(self, shot: FrameAndDark) -> Floats:
        """Return the light that an ordinary camera measured, in electrons: over the frame for a
        still, per slot for a clip. Each frame of a clip fills the slots in which it was open.

        `shot` has one readout for each of its frames, which all pixels share."""
        # All pixels of an ordinary camera have one shutter, (readouts, slots).
        shutters = shot.taken.container.table.shutters[0]
        frames: list[Floats] = []
        for open_slots, exposure_e in zip(
            shutters.sum(axis=-1), self._exposures_e(shot), strict=True
        ):
            frames += [exposure_e / open_slots] * int(open_slots)
        # For a still `frames` repeats the light of one slot; times the slots it is that of the
        # frame.
        return frames[0] * shutters.shape[-1] if self.still else np.stack(frames)

    def _exposures_e(self, shot: FrameAndDark) -> list[Array]:
        """Return the electrons of each readout of `shot` above the mean of its dark frames, one
        array (rows, cols, [3]) a readout. Noise can make them negative.

        A scene larger than the array is exposed in parts, and the dark frame is repeated over them.
        """
        exposures_e = []
        for k, dark_codes in enumerate(shot.dark.simulated.frame.frame.mean(axis=0)):
            codes = self.exposed_scene.codes(shot.taken, k)
            offset = over_array(dark_codes, *codes.shape[:2])
            offset = offset if codes.ndim == 2 else offset[..., None]
            exposures_e.append((codes - offset) * self.exposed_scene.sensor.electrons_per_lsb)
        return exposures_e

    @cached_property
    def bracket_light(self) -> Floats | None:
        """The light that an ordinary bracket (readouts of different exposure times in one frame)
        measured, in electrons over the frame, (rows, cols, [3]). It is merged without a network.
        None if there is no bracket: for a clip, or if the chip has too few registers."""
        shot = self.exposed_scene.bracket
        if shot is None:
            return None
        capture = shot.taken
        # The frame is ([3,] readouts, rows, cols); readouts become the first axis.
        saturated = np.moveaxis(capture.simulated.frame.saturated, -3, 0)
        if saturated.ndim == 4:  # colours become the last axis
            saturated = np.moveaxis(saturated, 1, -1)
        exposure_e = np.stack(self._exposures_e(shot))
        open_share = capture.container.table.shutters[0].mean(axis=-1)
        chip = DesignChip.of(capture.container.target, self.exposed_scene.sensor)
        return merged_bracket(exposure_e, open_share, saturated, chip)

    @property
    def bracket_db(self) -> float | None:
        """The PSNR of an ordinary bracket, in dB; None if there is none."""
        return None if self.bracket_light is None else self.decibels(self.bracket_light)

    @property
    def fair_db(self) -> float | None:
        """The PSNR of an ordinary camera at its best, in dB; None if there is none."""
        return None if self.fair_light is None else self.decibels(self.fair_light)

    @property
    def psnr_db(self) -> float:
        """The PSNR of the reconstruction, in dB."""
        return self.decibels(self.light)

    @property
    def open_db(self) -> float:
        """The PSNR of the light estimated from always open pixels, in dB."""
        return self.decibels(self.usual_light)

    @property
    def looked_db(self) -> float | None:
        """The PSNR of the light estimated by pixels that look, in dB; None for a clip."""
        looked = self.exposed_scene.looked
        return None if looked is None else self.decibels(looked.light)

    @property
    def measure(self) -> str:
        """The name of the score that `decibels` returns: PSNR in display encoding, or PSNR-mu for
        stills of linear light."""
        return "PSNR" if self.display or not self.still else "PSNR-mu"

    @property
    def camera_db(self) -> float:
        """The score of an ordinary camera: the better one of always open and automatic exposure."""
        return self.open_db if self.fair_db is None else max(self.open_db, self.fair_db)

    def decibels(self, light: Array) -> float:
        """Return the score of `light`, which has the shape of the truth, in dB.

        Clips and display scenes are compared in display encoding, averaged over the frames that
        differ from the truth; +inf if none does. Linear light with a high dynamic range is compared
        by mu-law PSNR, with the 99.9th percentile as peak."""
        truth = np.asarray(self.truth, np.float64)
        if self.measure == "PSNR-mu":
            # A scene without light has no peak; any is right.
            peak = float(np.percentile(truth, _PEAK_PERCENTILE)) or float(truth.max()) or 1.0
            return mu_psnr(truth, np.asarray(light, np.float64), peak)
        screen = fitted("srgb", truth, self.white_e)
        white = screen.white or 1.0
        truth_on_screen, light_on_screen = (
            screen.curve(np.clip(x / white, 0, 1)) for x in (truth, light)
        )
        pairs = (
            [(truth_on_screen, light_on_screen)]
            if self.still
            else zip(truth_on_screen, light_on_screen, strict=True)
        )
        return finite_mean(psnr(a, b, 1.0) for a, b in pairs)


def demo_sheet(shown: Shown) -> Figure:
    """Draw the sheet of the demo's results: rows of panels, for a still or for a clip, below a
    headline.

    The headline compares the better reconstruction, by the decoder or by pixels that look, with the
    better ordinary camera, and says whether it is worse. It adds the score of a bracket if there is
    one."""
    name = shown.exposed_scene.scene.name
    results = [(shown.psnr_db, shown.how)]
    if shown.looked_db is not None:
        results.append((shown.looked_db, "pixels that look"))
    best_db, how = max(results)
    worse = ", worse than" if best_db < shown.camera_db else ";"
    title = (
        f"{name if name.startswith('builtin:') else Path(name).name}: {shown.measure} "
        f"{best_db:.1f} dB by {how}{worse} an ordinary camera {shown.camera_db:.1f} dB"
    )
    if shown.bracket_db is not None:
        title += f", an ordinary bracket {shown.bracket_db:.1f} dB"
    rows = _still_rows(shown) if shown.still else _clip_rows(shown)
    return image_sheet(rows, title, _SIDE_INCHES)


def _readout(shown: Shown) -> Image:
    """Return the panel of the coded readout, in grey levels of its converter codes; of several
    readouts, the last, because the first may be uncoded."""
    exposed_scene, last = shown.exposed_scene, shown.exposed_scene.readouts - 1
    codes = fitted("srgb", np.array([0.0]), float(exposed_scene.container.target.top_code))
    title = "readout" if last == 0 else f"the last of {readouts_text(exposed_scene.readouts)}"
    note = f"one exposure through the shutters, emulated in {_time(exposed_scene.coded.seconds)}"
    return Image(_fit(codes(exposed_scene.codes(exposed_scene.coded.taken, last))), title, note)


def _decoder_text(shown: Shown) -> str:
    """Return a line on what reconstructed the scene, its score, and the time it took."""
    worse = ", worse than an ordinary camera" if shown.psnr_db < shown.camera_db else ""
    return f"{shown.how}: {shown.measure} {shown.psnr_db:.1f} dB{worse}, in {_time(shown.decode_s)}"


def _tone(shown: Shown) -> str:
    """Return the name of the tone curve and its white in electrons as text: "NAME, white W
    electrons"."""
    return f"{shown.fitted.name}, white {shown.fitted.white:.3g} electrons"


def _still_rows(shown: Shown) -> list[list[Image]]:
    """Return the rows of panels for a still, from top to bottom.

    First the truth, beside an ordinary camera and its error; then pixels that look, if they exposed
    the scene; last the reconstruction, its error, shutters and readout, and an ordinary bracket if
    there is one."""
    truth, light = shown.fitted(shown.truth), shown.fitted(shown.light)
    rows = [
        [
            Image(_fit(light), "reconstruction", _decoder_text(shown)),
            _error(truth, light),
            _shutters(shown),
            _readout(shown),
        ]
    ]
    if shown.bracket_light is not None and shown.exposed_scene.bracket is not None:
        container = shown.exposed_scene.bracket.taken.container
        lengths_ms = container.table.shutters[0] @ np.array(container.slot_us) * 1e-3
        lengths = ", ".join(f"{length:.3g}" for length in lengths_ms)
        note = (
            f"readouts of {lengths} ms in one exposure time, merged: {shown.measure} "
            f"{shown.bracket_db:.1f} dB"
        )
        bracket = shown.fitted(np.maximum(shown.bracket_light, 0))
        rows[0].append(Image(_fit(bracket), "an ordinary bracket", note))
    if shown.exposed_scene.looked is not None:
        rows.insert(0, _of_looks(shown, shown.exposed_scene.looked, truth))
    first = [Image(_fit(truth), "truth", _tone(shown))]
    if shown.exposed_scene.fair is not None and shown.fair_light is not None:
        container = shown.exposed_scene.fair.taken.container
        open_ms = sum(container.slot_us) * float(container.table.shutters[0, 0].mean()) * 1e-3
        usual = shown.fitted(np.maximum(shown.fair_light, 0))
        note = (
            f"automatic exposure, {open_ms:.3g} ms for all pixels: "
            f"{shown.measure} {shown.fair_db:.1f} dB; always open {shown.open_db:.1f} dB"
        )
        first += [Image(_fit(usual), "an ordinary camera", note), _error(truth, usual)]
    return [first, *rows]


def _clip_rows(shown: Shown) -> list[list[Image]]:
    """Return the rows of panels for a clip.

    The first has the always open camera, the readout and the shutters. The next have `_MOMENTS`
    frames, evenly spread from first to last: truth, reconstruction, error, and a burst of ordinary
    frames if there is one. A clip of fewer frames shows some of them twice."""
    exposed_scene = shown.exposed_scene
    moments = np.linspace(0, len(shown.truth) - 1, _MOMENTS).round().astype(int)
    truth, light = (shown.fitted(x[moments]) for x in (shown.truth, shown.light))
    codes = fitted("srgb", np.array([0.0]), float(exposed_scene.container.target.top_code))
    usual = Image(
        _fit(codes(exposed_scene.codes(exposed_scene.usual.taken))),
        "always open",
        f"an ordinary camera: {shown.measure} {shown.open_db:.1f} dB",
    )
    rows = [
        [usual, _readout(shown), _shutters(shown)],
        _row(truth, [f"truth, frame {k + 1} of {len(shown.truth)}" for k in moments], _tone(shown)),
        _row(light, ["reconstruction", *[""] * (_MOMENTS - 1)], _decoder_text(shown)),
        [_error(a, b, k > 0) for k, (a, b) in enumerate(zip(truth, light, strict=True))],
    ]
    if shown.fair_light is not None:
        note = f"as many readouts, nothing coded: {shown.measure} {shown.fair_db:.1f} dB"
        titles = [f"a burst of {exposed_scene.readouts} ordinary frames", *[""] * (_MOMENTS - 1)]
        burst = np.maximum(shown.fair_light[moments], 0)
        rows.append(_row(shown.fitted(burst), titles, note))
    return rows


def _of_looks(shown: Shown, looked: Looked, truth: Bytes) -> list[Image]:
    """Return the three panels for pixels that look at their light: what they measured (`looked`),
    its error, and when they closed. `truth` (rows, cols, [3]) is the true light as shown, 0 to 255.
    """
    light = shown.fitted(looked.light)
    note = (
        f"exposures over their times, no decoder: {shown.measure} {shown.looked_db:.1f} dB, in "
        f"{_time(looked.seconds)}"
    )
    shortest, longest = looked.open_us.min(), looked.open_us.max()
    # At least one doubling is the whole scale: if all pixels close together, nothing is divided by
    # 0.
    times = np.log2(looked.open_us / shortest) / max(1.0, np.log2(longest / shortest))
    closed = f"open for {shortest * 1e-3:.3g} to {longest * 1e-3:.3g} ms: yellow is longest"
    return [
        Image(_fit(light), "pixels that look", note),
        _error(truth, light),
        Image(_fit(_coloured(times)), "when they closed", closed),
    ]


def readouts_text(count: int) -> str:
    """Return "N readouts of one exposure", with `count` as a word. Raises KeyError for a count that
    is not 1 to 4."""
    words = {1: "one readout", 2: "two readouts", 3: "three readouts", 4: "four readouts"}
    return f"{words[count]} of one exposure"


def _time(seconds: float) -> str:
    """Return the time in seconds as text, with two digits and a no-break space before the unit,
    which is "s"."""
    return f"{seconds:.2g}\N{NO-BREAK SPACE}s"


def _row(frames: Bytes, titles: Sequence[str], note: str) -> list[Image]:
    """Return one row of panels: `frames` (count, rows, cols, [3]), each below its title; `titles`
    has one text for each frame. `note` is written below the first panel only."""
    return [
        Image(_fit(frame), title, note if k == 0 else "")
        for k, (frame, title) in enumerate(zip(frames, titles, strict=True))
    ]


def _error(truth: Bytes, light: Bytes, quiet: bool = False) -> Image:
    """Return a panel that shows the absolute differences between `truth` and `light` (rows, cols,
    [3]) in colours. Both are grey levels or colours as shown, 0 to 255; differences of colours are
    averaged.

    `quiet` leaves out its title and scale."""
    difference = np.abs(truth.astype(np.float64) - light)
    if difference.ndim == 3:
        difference = difference.mean(axis=-1)
    note = f"between the greys shown: mean {difference.mean():.1f} of 255"
    scale = "" if quiet else f"; dark is 0, yellow {_ERROR_TOP} and more"
    colours = _coloured(difference / _ERROR_TOP)
    return Image(_fit(colours), "" if quiet else "error", note + scale)


def _shutters(shown: Shown) -> Image:
    """Return a panel of the shutters of the pixels in the array's upper left corner, at most
    `_CORNER` on its longer side. Of several readouts the last is shown. Colours show for a clip the
    mean time at which a pixel is open, for a still for how long it is open."""
    exposed_scene, container = shown.exposed_scene, shown.exposed_scene.container
    size = exposed_scene.codes(exposed_scene.coded.taken).shape[:2]
    assert container.pixel_codes is not None  # the frame has been exposed
    # In proportion to the array; at least 4, so that a tile of a narrow array is seen.
    rows, cols = (max(4, _CORNER * side // max(size)) for side in size)
    lanes = container.table.shutter_of_code[container.pixel_codes[:rows, :cols]]
    # The last readout: the first of several is always open.
    corner, slot_us = container.table.shutters[:, -1][lanes], np.array(container.slot_us)
    open_us = corner @ slot_us
    shortest, longest = (f"{time_us * 1e-3:.3g}" for time_us in (open_us.min(), open_us.max()))
    length = longest if shortest == longest else f"{shortest} to {longest}"
    corner_text = f"of {rows} x {cols} pixels, open for {length} ms"
    if shown.still:
        # The square root tells short exposure times apart.
        image = _coloured(np.sqrt(open_us / open_us.max()))
        return Image(_fit(image), "shutters", f"{corner_text}: yellow is longest")
    # The mean of the middles of the open slots, weighted by their lengths. A pixel that never opens
    # gets 0, because its weights are 0.
    middle_us = np.cumsum(slot_us) - slot_us / 2
    mean_open_us = corner @ (slot_us * middle_us) / np.maximum(open_us, 1e-9)
    note = f"{corner_text} of {slot_us.sum() * 1e-3:.3g}: dark is early, yellow late"
    return Image(_fit(_coloured(mean_open_us / slot_us.sum())), "shutters", note)


def _coloured(scale: Floats) -> Bytes:
    """Return `scale`, values from 0 to 1, as colours of the scale viridis from dark blue to yellow:
    uint8, with RGB as the last axis. Values beyond 0 or 1 get the first or last colour."""
    from matplotlib import colormaps

    colours = np.asarray(colormaps["viridis"](np.clip(scale, 0, 1)))[..., :3]
    return np.asarray(np.rint(255 * colours), np.uint8)


def _fit(image: Bytes) -> Bytes:
    """Return an image (rows, cols, [3]), scaled so that its longer side is about `_SIDE_PIXELS`. A
    small one is magnified by a whole number, by repeating pixels; a large one is reduced by
    averaging."""
    side = max(image.shape[:2])
    # Up to 1.5 times the side, a picture is shown without resampling.
    if side > 1.5 * _SIDE_PIXELS:
        import cv2

        factor = _SIDE_PIXELS / side
        size = (max(1, round(image.shape[1] * factor)), max(1, round(image.shape[0] * factor)))
        return np.asarray(cv2.resize(image, size, interpolation=cv2.INTER_AREA), np.uint8)
    zoom = max(1, round(_SIDE_PIXELS / side))
    return image.repeat(zoom, axis=0).repeat(zoom, axis=1)
