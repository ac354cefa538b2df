"""Reconstruction of pictures and clips from frame files with a run's decoder."""

from __future__ import annotations

import shlex
import tomllib
from collections.abc import Iterator, Sequence
from hashlib import sha256
from pathlib import Path

import numpy as np

from nscc.arrays import Floats32
from nscc.compiler import compile_source
from nscc.diagnostics.diagnostic import Diagnostic, Rejected, Severity, rejected
from nscc.options import Options
from nscc.pipeline import LEVELS
from nscc.program.problems import counted
from nscc.source import Source
from nscc.words.file import to_bytes
from nscc_runtime.effects import selected
from nscc_runtime.machine_code import working_s
from nscc_runtime.sensor import sensor_sha256
from nscc_training.code_choices import LOOKS
from nscc_training.frame_reading import (
    Dark,
    FrameRead,
    no_frame,
    of_pixels,
    read_dark,
    read_frame,
    undarkened,
)
from nscc_training.loop.decoding import decoded_frame, shutters_at
from nscc_training.programs import CAPTURE_FILE, TARGET_FILE
from nscc_training.reconstruct_any import Reconstruction, overexposed
from nscc_training.run_folder import RunFolder, load_run

_OF_MODEL = (
    "shot",
    "full_well",
    "adc_noise",
    "spreading",
    "column_noise",
    "readout_pattern",
    "readout_level",
    "adc",
)
"""Effects that training simulates if `[sensor] effects` is empty."""
_DARK_HELPS = ("`--dark FRAME` subtracts the charge that words and dark current add",)


def reconstruct(
    run: Path, frame: Path, *, force: bool, dark: Path | None = None, trust_code: bool = False
) -> Reconstruction:
    """Reconstruct the frame file `frame` with the decoder of `run`, a folder or the name of a
    shipped run.

    `dark` is a frame file of the same program without light, with many repeats. Its mean (offsets
    of words, and dark charge) is subtracted from the frame. A decoder that was trained with effects
    knows the mean of each pixel of its tile, so only the deviations from that mean are subtracted.
    `trust_code` allows a run that names Python code of its own.

    Raises Rejected: the errors of `load_run`; NS0821 for a run that names classes; NS0819 for a
    file that is not a frame, or has another number of pixels or buckets than the run's program,
    with or without `force`; for a frame of another program or sensor, and for a dark frame of
    another program or with light (with `force` these three are warnings)."""
    folder = load_run(run, trust_code=trust_code)
    if folder.setup.classes:
        raise rejected(
            "NS0821",
            f"'{run}' was trained to name classes, not to reconstruct light",
            notes=(f"its classes are {', '.join(folder.setup.classes)}",),
            helps=(f"use `{shlex.join(['nscc', 'classify', str(run), str(frame)])}`",),
        )
    return _decoded(folder, frame, force, dark)


def classify(
    run: Path, frame: Path, *, force: bool, dark: Path | None = None, trust_code: bool = False
) -> tuple[dict[str, float], tuple[Diagnostic, ...]]:
    """Return the likelihoods of a frame's classes by name, most likely first, and warnings.

    `run`, `frame`, `dark`, `force` and `trust_code` mean the same as for `reconstruct`: the run,
    the frame file, a dark frame to subtract, whether mismatches are only warnings, and whether code
    of the run may be executed. Raises Rejected: NS0821 for a run without classes, else the errors
    of `reconstruct` (`load_run`'s, and NS0819)."""
    folder = load_run(run, trust_code=trust_code)
    if not folder.setup.classes:
        raise rejected(
            "NS0821",
            f"'{run}' was trained to reconstruct light, not to name classes",
            helps=(
                f"use `{shlex.join(['nscc', 'reconstruct', str(run), str(frame)])} -o OUT`, or "
                "train with the protocol class-v1",
            ),
        )
    decoded = _decoded(folder, frame, force, dark)
    return likelihoods(folder.setup.classes, decoded.light), decoded.messages


def likelihoods(classes: Sequence[str], scores: Floats32) -> dict[str, float]:
    """Return the likelihoods of classes by name, most likely first, with a sum of 1: the softmax of
    `scores`.

    `scores` (classes,) or (classes, colours), in the order of `classes`, are logarithms of
    likelihoods up to a constant; the mean over colours is used. They must be finite. Of equal
    likelihoods, the class that is earlier in `classes` comes first."""
    scores = scores if scores.ndim == 1 else scores.mean(axis=-1)
    shares = np.exp(scores - scores.max(), dtype=np.float64)
    shares /= shares.sum()
    return {classes[k]: float(shares[k]) for k in np.argsort(-shares, kind="stable")}


def _decoded(folder: RunFolder, frame: Path, force: bool, dark: Path | None) -> Reconstruction:
    """Decode the frame file `frame` with the run in `folder`, and measure the time, without that of
    reading the files.

    `dark` is a dark frame file to subtract, or None; `force` makes mismatches warnings. Raises
    Rejected (NS0819) for files that are not frames, and for mismatches as `reconstructed` does.
    Whether the run names classes is not checked."""
    read = read_frame(frame)
    dark_frames = None if dark is None else read_dark(dark, folder.setup.buckets)
    begin = working_s()
    light, messages = reconstructed(folder, read, str(frame), dark_frames, force=force)
    seconds = working_s() - begin
    return Reconstruction(light, folder.setup.still, len(read.frame) > 1, messages, seconds)


def reconstructed(
    folder: RunFolder, read: FrameRead, name: str, dark: Dark | None, *, force: bool
) -> tuple[Floats32, tuple[Diagnostic, ...]]:
    """Return the decoder's output for a frame, and warnings. The output is (rows, cols) for a
    still, (N, rows, cols) for a clip, or (classes,); a frame in colours adds a last axis of
    colours.

    Messages call the frame `name`. `dark` is the dark frame to subtract, or None. Raises Rejected
    (NS0819) for another program or sensor than the run's (with `force` a warning), and always for
    another number of pixels or buckets, a dark frame of another size, or a run of pixels that look
    whose frame lacks their open times."""
    size = (folder.setup.target.rows, folder.setup.target.cols)
    dark_doubts = () if dark is None else dark.checked(read.meta, size, force=force)
    offset = None if dark is None else dark.offset
    doubts = [*_program_doubts(folder, read), *_sensor_doubts(folder, read)]
    messages = tuple(_doubt(name, text, warning=force) for text in doubts)
    if messages and not force:
        raise Rejected(messages, status=2)
    messages += (*_unlearned(folder, read, name), *overexposed(name, read.saturated))
    shape = read.frame.shape[-2:]
    if shape != size and "laid" not in read.meta:
        raise no_frame(name, f"it has {shape} pixels, but the run's chip has {size}")
    if read.buckets != folder.setup.buckets:
        have = f"it has {counted(read.buckets, 'bucket')}"
        raise no_frame(name, f"{have}, but the run's program has {folder.setup.buckets}")
    if offset is not None and offset.shape[-2:] != size:
        raise no_frame(name, f"the dark frame has {offset.shape} pixels, not {size}")
    # A decoder that was trained with effects has learned the mean of each place of its tile, so
    # only the deviations from that mean are subtracted.
    if offset is not None and folder.setup.settings.sensor.effects:
        offset = of_pixels(offset, folder.setup.encoder.spec.tile)
    shares: list[Floats32 | None] = [None] * len(read.frame)
    if folder.setup.encoder.spec.kind == LOOKS:
        if read.opened is None or read.opened.shape != read.frame.shape:
            raise no_frame(name, "it does not contain the open time of its pixels")
        shares = list((read.opened / folder.setup.slots).astype(np.float32))
    light = [
        decoded_frame(
            folder.setup, codes if offset is None else undarkened(codes, offset), saturated, share
        )
        for codes, saturated, share in zip(read.frame, read.saturated, shares, strict=True)
    ]
    messages += dark_doubts
    return np.stack(light, axis=-1) if len(light) > 1 else light[0], messages


def _program_doubts(folder: RunFolder, read: FrameRead) -> Iterator[str]:
    """Yield the reasons why the frame was exposed with other shutters than the run's.

    Its shutters are compared if it contains them, else the digest of its program in its metadata; a
    frame with neither counts as one of another program. Yields at most one reason."""
    if read.shutter is not None:
        hard = shutters_at(folder.setup, read.frame.shape[-2:]).numpy().astype(bool)
        if read.shutter.shape != hard.shape or not np.array_equal(read.shutter, hard):
            yield "it was exposed with other shutters than the run's"
    elif not _is_program(folder, read.meta.get("program_sha256")):
        chip = "" if folder.setup.chip.file is None else f" with --target {TARGET_FILE}"
        yield f"its program is not the run's shutter.nsl, compiled{chip} at any level"


def _is_program(folder: RunFolder, digest: object) -> bool:
    """Return whether `digest`, any value of a frame's metadata, is the SHA-256 of the run's
    program, compiled at any level; False if it is missing or the program does not compile. The
    usual level 2 is tried first, to save compilations."""
    source = Source("shutter.nsl", folder.program)
    for level in sorted(LEVELS, key=lambda level: abs(level - 2)):
        options = Options(level=level, target=folder.setup.chip.file)
        container = compile_source(source, folder.path, options).container
        if container and sha256(to_bytes(container)).hexdigest() == digest:
            return True
    return False


def _sensor_doubts(folder: RunFolder, read: FrameRead) -> Iterator[str]:
    """Yield one reason if the frame comes from another sensor than the run was trained for, else
    nothing.

    The digests of the sensors are compared. A frame of an older version, whose metadata lists a
    part of the run's values, passes. The reason names the first of electrons per LSB and ADC offset
    that differs or is missing, else it is general."""
    model, own_sensor = folder.setup.model, folder.setup.sensor
    # Defaults change between versions: a frame may be as old as the run.
    if read.meta.get("sensor_sha256") in (sensor_sha256(own_sensor), _trained_sensor(folder)):
        return
    frame_sensor = read.meta.get("sensor")
    if (
        isinstance(frame_sensor, dict)
        and frame_sensor
        and all(own_sensor.values.get(k) == v for k, v in frame_sensor.items())
    ):
        return  # a frame of an older version, without values that were added since
    figures = (("electrons_per_lsb", model.electrons_per_lsb), ("adc_offset", model.adc_offset_lsb))
    for name, expected in figures:
        have = read.meta.get(name)
        if not isinstance(have, int | float) or abs(have - expected) > 1e-6 * max(1, abs(expected)):
            yield f"its sensor has {name} = {have}, but the run's has {expected:g}"
            return
    yield "its sensor has other values than the run's"


def _trained_sensor(folder: RunFolder) -> str:
    """Return the SHA-256 of the sensor that the run was trained for, as its `capture.toml` names
    it. Return an empty text if the file is missing, damaged, or does not name it."""
    try:
        capture = tomllib.loads((folder.path / CAPTURE_FILE).read_text("utf-8"))
    except (OSError, ValueError):
        return ""
    return str(capture.get("sensor_sha256", ""))


def _unlearned(folder: RunFolder, read: FrameRead, name: str) -> Iterator[Diagnostic]:
    """Yield one warning (NS0842) if the frame `name` was simulated with effects that the decoder
    was not trained with; it lists them.

    The effects are those that the plan in the frame's metadata marks as "kept". A frame without a
    plan, as from a chip, gets no warning."""
    learned = folder.setup.settings.sensor.effects
    known = {effect.name for effect in selected(learned).effects} if learned else set(_OF_MODEL)
    plan = read.meta.get("plan") or {}
    simulated = [
        effect["name"] for effect in plan.get("effects", ()) if effect["decision"] == "kept"
    ]
    unlearned = [effect for effect in simulated if effect not in known]
    if unlearned:
        yield Diagnostic(
            "NS0842",
            f"the run was not trained with effects of '{name}': {', '.join(unlearned)}",
            severity=Severity.WARNING,
            notes=("the decoder mistakes the influence of these effects for light",),
            helps=('train with `[sensor] effects = "all"`', *_DARK_HELPS),
        )


def _doubt(path: Path | str, reason: str, *, warning: bool) -> Diagnostic:
    """Return the diagnostic (NS0819) that a frame does not match the run for this `reason`: a
    warning or an error."""
    return Diagnostic(
        "NS0819",
        f"'{path}' does not match this run: {reason}",
        severity=Severity.WARNING if warning else Severity.ERROR,
        notes=("a decoder works only with the shutters and the sensor that it was trained with",),
        helps=("expose the scene with the run's program: `nscc run RUN/shutter.nsl --scene ..`",)
        + (() if warning else ("--force reconstructs it anyway",)),
    )
