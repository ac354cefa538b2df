"""From a frame file to a picture or a clip, by a run's decoder."""

from __future__ import annotations

from collections.abc import Iterator
from hashlib import sha256
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from nscc.compiler import compile_source
from nscc.diagnostics.diagnostic import Diagnostic, Rejected, Severity
from nscc.pipeline import LEVELS, Options
from nscc.program.problems import counted
from nscc.source import Source
from nscc.words.file import to_bytes
from nscc_runtime.effects import selected
from nscc_runtime.machine_code import working_s
from nscc_runtime.sensor import sensor_sha256
from nscc_training.dark import of_pixels, read_dark, undarkened
from nscc_training.encoders.looks import LOOKS
from nscc_training.frame_reading import FrameRead, no_frame, read_frame
from nscc_training.loop.decoding import decoded_frame, shutters_at
from nscc_training.programs import TARGET_FILE
from nscc_training.reconstruction import Reconstruction, overexposed
from nscc_training.run_folder import RunFolder, load_run

_OF_MODEL = ("shot", "full_well", "adc_noise", "spreading", "adc")
"""Effects that training has without `[sensor] effects`."""
_DARK_HELPS = ("`--dark FRAME` takes away what words and dark current add",)


def reconstruct(
    run: Path, frame: Path, *, force: bool, dark: Path | None = None, trust_code: bool = False
) -> Reconstruction:
    """What a run's decoder makes of a frame file, with warnings.

    `dark` is a frame file of the same program without light, of many repeats: their mean, which
    offsets of words and charge without light have left, is taken from the frame. A run that was
    trained under effects knows the mean of each place of its tile: only what pixels differ from
    that is taken.

    Raises Rejected: what `load_run` raises for the run, NS0819 for a file that is no frame, or one
    of another program or sensor (with `force` that is a warning, unless its size differs), and for
    a dark one that is of another program or has seen light (the same).
    """
    folder = load_run(run, trust_code=trust_code)
    read, begin = read_frame(frame), working_s()
    offset: NDArray[np.float64] | None = None
    doubts: tuple[Diagnostic, ...] = ()
    if dark is not None:
        found = read_dark(dark, folder.parts.buckets)
        size = (folder.parts.target.rows, folder.parts.target.cols)
        offset, doubts = found.offset, found.checked(read.meta, size, force=force)
    light, messages = reconstructed(folder, read, str(frame), force=force, offset=offset)
    messages, seconds = (*messages, *doubts), working_s() - begin
    return Reconstruction(light, folder.parts.still, len(read.frame) > 1, messages, seconds)


def reconstructed(
    folder: RunFolder, read: FrameRead, name: str, *, force: bool,
    offset: NDArray[np.float64] | None = None,
) -> tuple[NDArray[np.float32], tuple[Diagnostic, ...]]:  # fmt: skip
    """The picture or clip of a frame, colours last, and warnings; `name` is what they call the
    frame, `offset` (rows, cols) what the array reads without light.

    Raises Rejected (NS0819) as `reconstruct`.
    """
    doubts = [*_program_doubts(folder, read), *_sensor_doubts(folder, read)]
    messages = tuple(_doubt(name, text, warning=force) for text in doubts)
    if messages and not force:
        raise Rejected(messages, status=2)
    messages += (*_unlearned(folder, read, name), *overexposed(name, read.saturated))
    size = (folder.parts.target.rows, folder.parts.target.cols)
    found = read.frame.shape[-2:]
    if found != size and "laid" not in read.meta:
        raise no_frame(name, f"it is of {found} pixels, the run's chip has {size}")
    if read.buckets != folder.parts.buckets:
        have = f"it has {counted(read.buckets, 'bucket')}"
        raise no_frame(name, f"{have}, the run's program {folder.parts.buckets}")
    if offset is not None and offset.shape[-2:] != size:
        raise no_frame(name, f"without light it is of {offset.shape} pixels, not {size}")
    if offset is not None and folder.parts.settings.sensor.effects:
        offset = of_pixels(offset, folder.parts.encoder.spec.tile)
    shares: list[NDArray[np.float32] | None] = [None] * len(read.frame)
    if folder.parts.encoder.spec.kind == LOOKS:
        if read.opened is None or read.opened.shape != read.frame.shape:
            raise no_frame(name, "it does not say how long its pixels were open")
        shares = list((read.opened / folder.parts.slots).astype(np.float32))
    made = [
        decoded_frame(
            folder.parts, codes if offset is None else undarkened(codes, offset), saturated, share
        )
        for codes, saturated, share in zip(read.frame, read.saturated, shares, strict=True)
    ]
    return np.stack(made, axis=-1) if len(made) > 1 else made[0], messages


def _program_doubts(folder: RunFolder, read: FrameRead) -> Iterator[str]:
    """Reasons to think that the frame was exposed with other shutters."""
    if read.shutter is not None:
        hard = shutters_at(folder.parts, read.frame.shape[-2:]).numpy().astype(bool)
        if read.shutter.shape != hard.shape or not np.array_equal(read.shutter, hard):
            yield "it was exposed with other shutters than the run's"
    elif not _is_program(folder, read.meta.get("program_sha256")):
        chip = "" if folder.parts.chip.file is None else f" with --target {TARGET_FILE}"
        yield f"its program is not the run's shutter.nsl, compiled{chip} at any level"


def _is_program(folder: RunFolder, digest: object) -> bool:
    """Whether that is the digest of the run's program at some level; the likely ones first."""
    source = Source("shutter.nsl", folder.program)
    for level in sorted(LEVELS, key=lambda level: abs(level - 2)):
        options = Options(level=level, target=folder.parts.chip.file)
        found = compile_source(source, folder.path, options)
        if found.container and sha256(to_bytes(found.container)).hexdigest() == digest:
            return True
    return False


def _sensor_doubts(folder: RunFolder, read: FrameRead) -> Iterator[str]:
    """Reasons to think that the frame came from another sensor."""
    model, own = folder.parts.model, folder.parts.sensor
    if read.meta.get("sensor_sha256") == sensor_sha256(own):
        return
    held = read.meta.get("sensor")
    if isinstance(held, dict) and held and all(own.values.get(k) == v for k, v in held.items()):
        return  # a frame of an older version: it does not know what has been added since
    figures = (("electrons_per_lsb", model.electrons_per_lsb), ("adc_offset", model.adc_offset_lsb))
    for name, wanted in figures:
        have = read.meta.get(name)
        if not isinstance(have, int | float) or abs(have - wanted) > 1e-6 * max(1, abs(wanted)):
            yield f"its sensor has {name} = {have}, the run's {wanted:g}"
            return
    yield "its sensor has other values than the run's"


def _unlearned(folder: RunFolder, read: FrameRead, name: str) -> Iterator[Diagnostic]:
    """NS0842, a warning, where a frame has effects that the decoder was not trained under."""
    learned = folder.parts.settings.sensor.effects
    known = {each.name for each in selected(learned).effects} if learned else set(_OF_MODEL)
    plan = read.meta.get("plan") or {}
    kept = [each["name"] for each in plan.get("effects", ()) if each["decision"] == "kept"]
    others = [each for each in kept if each not in known]
    if others:
        yield Diagnostic(
            "NS0842",
            f"the run was not trained under effects that '{name}' has: {', '.join(others)}",
            severity=Severity.WARNING,
            notes=("what these do to codes, the decoder takes for light",),
            helps=('train with `[sensor] effects = "all"`', *_DARK_HELPS),
        )


def _doubt(path: Path | str, reason: str, *, warning: bool) -> Diagnostic:
    return Diagnostic(
        "NS0819",
        f"'{path}' is no frame for this run: {reason}",
        severity=Severity.WARNING if warning else Severity.ERROR,
        notes=("a decoder knows the shutters and the sensor that it was trained with",),
        helps=("expose the scene with the run's program: `nscc run RUN/shutter.nsl --scene ..`",)
        + (() if warning else ("--force reconstructs it all the same",)),
    )
