"""Exposure of a demo's scene: with coded shutters, an ordinary camera, and dark frames of both."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from pathlib import Path
from typing import NamedTuple

import numpy as np

from nscc.arrays import Array, Bytes, Floats
from nscc.compiler import compile_file
from nscc.diagnostics.diagnostic import Rejected, rejected
from nscc.examples import examples
from nscc.options import Options
from nscc.words.container import Container
from nscc.words.readout import converter_of
from nscc_runtime.effects import selected
from nscc_runtime.frame_file import FrameFile, meta
from nscc_runtime.looked_light import DEVIATION, LIGHT, OPEN, merged_image
from nscc_runtime.machine_code import working_s
from nscc_runtime.pieces import Taken, simulate_scene
from nscc_runtime.request import Request
from nscc_runtime.response import with_decode_arrays
from nscc_runtime.scenes import PlacedLight, Scene, laid_lights
from nscc_runtime.sensor import Sensor, load_sensor
from nscc_runtime.simulate import Listener
from nscc_training.command_settings import DemoSettings
from nscc_training.demo.subject import Subject
from nscc_training.design.bracket import bracket_slots, camera
from nscc_training.design.chip import Curve, DesignChip
from nscc_training.design.scene import best_stop
from nscc_training.run_files import RunCapture, run_capture

RUNS = {True: Path("hdr"), False: Path("clip")}
"""The shipped runs for stills (True) and clips (False), which define exposure and sensor."""
CLIPS = {1: "searched_bits", 2: "two_readouts", 3: "three_readouts", 4: "four_readouts"}
"""The example program for clips, by the number of readouts."""
BEST_READOUTS = 4
"""The number of readouts with the highest PSNR."""
LOOKING = "float_pixel"
"""The example whose pixels look at their light, with which a still is exposed as well."""
DARK_FRAMES, DARK_SEED = 16, 1 << 20
"""Number of dark frames, whose mean is subtracted, and the distance of their seed from the
scene's."""
_BRIGHTER = ("@99", "@100")
"""Percentiles tried for the exposure if the scene is dark at the run's percentile."""


class Looked(NamedTuple):
    """A still as pixels that look measured it: `light` in electrons over the frame (rows, cols,
    [3]), the open time `open_us` of each pixel (rows, cols), in colours the mean of the three
    exposures, and the seconds of the simulation."""

    light: Floats
    open_us: Floats
    seconds: float


class FrameAndDark(NamedTuple):
    """A frame (`taken`), the dark frames of the same program, and the seconds of the frame's
    simulation."""

    taken: Taken
    dark: Taken
    seconds: float


@dataclass(frozen=True, eq=False)
class Exposed:
    """The exposures of a demo's scene.

    `run` is the run whose program exposed it; None for the example program for clips. `container`
    is the compiled `program` and `sensor` the chip's. `laid` contains the placed light of each
    colour: one, or red, green, blue. `coded` is the coded frame and `usual` a frame with always
    open pixels. `looked` is a still exposed by pixels that look; None for a clip. `fair` is a frame
    of an ordinary camera at its best: a still with the best single stop, or a clip in a burst of as
    many frames as `program` has readouts; None for a clip in one readout. `bracket` is a still in
    three readouts of one exposure, one after the other; None for a clip, or if the chip has too few
    registers."""

    run: Path | None
    program: Path
    scene: Scene
    laid: tuple[PlacedLight, ...]
    container: Container
    sensor: Sensor
    coded: FrameAndDark
    usual: FrameAndDark
    looked: Looked | None
    fair: FrameAndDark | None
    bracket: FrameAndDark | None

    @property
    def still(self) -> bool:
        """Whether the scene is a still."""
        return self.laid[0].light.kind == "still"

    def truth(self) -> Array:
        """Return the true light in electrons: over the frame (rows, cols), or per slot (T, rows,
        cols). Colours are the last axis. Parts of the array that the scene does not cover are cut
        off."""
        cut = [
            placed.placement.cut(placed.light.total_e() if self.still else placed.light.dense())
            for placed in self.laid
        ]
        return cut[0] if len(cut) == 1 else np.stack(cut, axis=-1)

    def white_e(self) -> float:
        """Return the electrons of a pixel of white, the display's brightest light: over the frame,
        or per slot for clips."""
        light = self.laid[0].light
        return float(light.weight.sum()) / (1 if self.still else light.slots)

    @property
    def readouts(self) -> int:
        """The number of readouts of the coded frame."""
        return len(self.container.table.shutters[0])

    def codes(self, capture: Taken, readout: int = 0) -> Bytes:
        """Return the converter codes of readout number `readout` (0 is the first) of a capture,
        (rows, cols) or with colours (rows, cols, 3). Raises IndexError for a readout that the
        capture does not have."""
        codes = capture.simulated.frame.frame[..., readout, :, :]
        return codes if len(self.laid) == 1 else np.moveaxis(codes, 0, -1)

    def files(self) -> tuple[FrameFile, FrameFile]:
        """Return the frame files of the coded frame, which contains the truth if it is grey, and of
        its dark frames."""
        keep = ("truth",) if len(self.laid) == 1 else ()
        return _frame_file(self.coded.taken, keep), _frame_file(self.coded.dark)


def exposed(subject: Subject, settings: DemoSettings, listener: Listener) -> Exposed:
    """Expose a still with the program of the run in `settings` (None: the shipped run for stills),
    and a clip with that of its run or the example program for its number of readouts. Also expose
    it with the ordinary cameras that the demo compares.

    Uses the sensor of the run, for shipped runs the default one, and the effects that `auto`
    selects. `listener` receives progress and warnings. Raises Rejected for a scene that is dark, or
    cannot be read, or is not of the run's kind, and for readouts of a still (NS0821)."""
    run = settings.run or (RUNS[True] if subject.still else None)
    like = run_capture(run or RUNS[False])
    if like.still != subject.still or like.classifies:
        kinds = {True: "a still", False: "a clip"}
        made = "names classes" if like.classifies else f"reconstructs {kinds[like.still]}"
        raise rejected(
            "NS0821",
            f"'{subject.scene.name}' is {kinds[subject.still]}, but the run '{run}' {made}",
            helps=("name another scene, or leave --run out",),
        )
    if subject.still and settings.readouts:
        raise rejected(
            "NS0821",
            f"'{subject.scene.name}' is a still, and a still is read out once",
            helps=("name a clip, or leave --readouts out",),
        )
    program = _program_of(settings) if run is None else like.program
    target = None if like.target is None else str(like.target)
    compiled = compile_file(program, Options(target=target)).built
    sensor = load_sensor(converter_of(compiled), like.sensor)
    laid, scene = _laid(subject, like, compiled, settings, listener)
    request = Request(selected("auto"), seed=settings.seed)

    def shot(container: Container) -> FrameAndDark:
        """Expose the scene, and a dark one with noise that is independent of the scene's, with the
        program `container`."""
        begin = working_s()
        taken = simulate_scene(container, laid, sensor, request, listener)
        seconds = working_s() - begin
        night = laid_lights(Scene("builtin:dark"), container.slot_us, container.target)
        quiet = replace(request, seed=settings.seed + DARK_SEED, repeat=DARK_FRAMES)
        return FrameAndDark(
            taken, simulate_scene(container, night, sensor, quiet, listener), seconds
        )

    coded, usual = shot(compiled), shot(camera(like.slots, like.slot_us, target))
    looked = _looked(scene, sensor, request, listener) if subject.still else None
    count, stop = len(compiled.table.shutters[0]), like.slots
    if subject.still:
        light_e = np.mean([placed.placement.cut(placed.light.total_e()) for placed in laid], axis=0)
        # The errors that the sheet shows: of display light, or mu-law for light of a high dynamic
        # range.
        curve: Curve = "linear" if subject.transfer == "srgb" else "mu"
        chip = DesignChip.of(compiled.target, sensor)
        stop = best_stop(chip, light_e, compiled.slots, curve)
    fair = bracket = None
    if subject.still or count > 1:
        fair = shot(camera(like.slots, like.slot_us, target, count, stop))
    if subject.still:
        # A chip with too few registers for three readouts gives no bracket.
        with suppress(Rejected):
            lengths = bracket_slots(like.slots)
            bracket = shot(camera(like.slots, like.slot_us, target, lengths=lengths))
    return Exposed(run, program, scene, laid, compiled, sensor, coded, usual, looked, fair, bracket)


def _looked(scene: Scene, sensor: Sensor, request: Request, listener: Listener) -> Looked:
    """Expose a still with the example program whose pixels look at their light. Return the light
    that they measured, without a decoder.

    `request` chooses effects and seed; `listener` receives progress. `scene` has the exposure with
    which the coded frame was exposed."""
    container = compile_file(examples()[LOOKING], Options()).built
    begin = working_s()
    laid = laid_lights(scene, container.slot_us, container.target, progress=listener.progress)
    frame_arrays = simulate_scene(container, laid, sensor, request, listener).simulated.frame.told
    # The bucket axis is the third from the end; colours add an axis in front.
    look_arrays = (
        frame_arrays[key].reshape(-1, *frame_arrays[key].shape[-3:])
        for key in (LIGHT, DEVIATION, OPEN)
    )
    images = [
        (merged_image(light, deviation) * container.slot_s.sum(), slots[0])
        for light, deviation, slots in zip(*look_arrays, strict=True)
    ]
    light = np.stack([image for image, _ in images], axis=-1)
    open_us = np.mean([np.cumsum([0, *container.slot_us])[n] for _, n in images], axis=0)
    seconds = working_s() - begin
    return Looked(light[..., 0] if len(images) == 1 else light, open_us, seconds)


def _laid(
    subject: Subject,
    like: RunCapture,
    container: Container,
    settings: DemoSettings,
    listener: Listener,
) -> tuple[tuple[PlacedLight, ...], Scene]:
    """Return the light of the scene on the array, for each colour, and the scene with the exposure
    that was used.

    Without an exposure in `settings` it is that of the run `like`, a text "ELECTRONS@PERCENTILE";
    if the scene is dark at this percentile (NS0738), the percentiles of `_BRIGHTER` are tried. A
    scene in electrons has no exposure to choose. `container` gives the slots and the array. Raises
    the last Rejected if every exposure is dark, and other errors of reading the scene at once."""
    scene = replace(subject.scene, fit=settings.fit, color=settings.color)
    electrons, _, _ = like.exposure.partition("@")
    exposures = (
        (settings.exposure,)
        if settings.exposure
        else (like.exposure, *(electrons + brighter for brighter in _BRIGHTER))
    )
    for exposure in exposures:
        exposed = scene if subject.in_electrons else replace(scene, exposure=exposure)
        try:
            laid = laid_lights(
                exposed, container.slot_us, container.target, listener.warn, listener.progress
            )
        except Rejected as rejected:
            if exposure == exposures[-1] or rejected.diagnostics[0].code != "NS0738":
                raise
            continue
        return laid, exposed
    raise AssertionError("there is an exposure to ask for")


def _program_of(settings: DemoSettings) -> Path:
    """Return the path of the example program for clips: with the number of readouts in `settings`
    (default `BEST_READOUTS`) for the network, and with one readout for other methods, which cannot
    join several."""
    return examples()[CLIPS[(settings.readouts or BEST_READOUTS) if settings.learned else 1]]


def _frame_file(capture: Taken, keep: Sequence[str] = ()) -> FrameFile:
    """Return the frame file of a capture, with the arrays that `keep` names (such as "truth") and
    the decode table, so that it can be reconstructed without the program."""
    simulated, light = capture.simulated, capture.light
    about = meta(capture.container, light, simulated.frame, simulated.origin) | capture.meta_entries
    file = FrameFile.of(capture.container, light, simulated.frame, about, keep)
    return with_decode_arrays(file, capture.container)
