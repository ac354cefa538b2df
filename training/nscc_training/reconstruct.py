"""From a frame file to a picture or a clip, by a run's decoder or the one for any code."""

from __future__ import annotations

import io
import json
from collections.abc import Iterator
from dataclasses import dataclass
from hashlib import sha256
from pathlib import Path
from typing import Any, Literal

import numpy as np
import torch
from numpy.typing import NDArray

from nscc.compiler import compile_source
from nscc.diagnostics.diagnostic import Diagnostic, Rejected, Severity
from nscc.pipeline import LEVELS, Options
from nscc.source import Source
from nscc.words.file import to_bytes
from nscc_runtime.frame_file import SCHEMA
from nscc_runtime.sensor import sensor_sha256
from nscc_training.any_code.decode import decoded_clip, decoded_still
from nscc_training.any_code.frames import no_coded_frame, read_coded_frame
from nscc_training.programs import TARGET_FILE
from nscc_training.run_folder import RunFolder, load_run
from nscc_training.sensor_model import laid


@dataclass(frozen=True, eq=False)
class FrameRead:
    """What reconstruction needs of a frame file: codes (rows, cols), whether they are saturated,
    meta, shutters if kept."""

    frame: NDArray[np.uint8]
    saturated: NDArray[np.bool_]
    meta: dict[str, Any]
    shutter: NDArray[np.bool_] | None


def reconstruct(
    run: Path, frame: Path, *, force: bool, trust_code: bool = False
) -> tuple[bytes, tuple[Diagnostic, ...]]:
    """The .npz file of the reconstruction, and warnings.

    Raises Rejected: what `load_run` raises for the run, NS0819 for a file that is no frame, or one
    of another program or sensor (with `force` that is a warning, unless its size differs).
    """
    folder = load_run(run, trust_code=trust_code)
    read = read_frame(frame)
    doubts = [*_program_doubts(folder, read), *_sensor_doubts(folder, read)]
    messages = tuple(_doubt(frame, text, warning=force) for text in doubts)
    if messages and not force:
        raise Rejected(messages, status=2)
    size = (folder.parts.target.rows, folder.parts.target.cols)
    if read.frame.shape != size:
        raise _run_frame(frame, f"it is of {read.frame.shape} pixels, the run's chip has {size}")
    made = decoded_frame(folder, read.frame, read.saturated)
    return _product("image" if folder.parts.still else "video", made), messages


def reconstruct_any(
    frame: Path, program: Path | None = None, kind: Literal["image", "video"] | None = None
) -> bytes:
    """The .npz file of what the decoder for any code makes of a frame of any program.

    `program` is what exposed it, where the file does not hold its pixels' shutters. As an image or
    a clip; without `kind` an image where all shutters open with the frame (class b), else a clip.
    Raises Rejected as `read_coded_frame`.
    """
    coded = read_coded_frame(frame, program)
    if (kind or ("image" if coded.is_still else "video")) == "image":
        return _product("image", decoded_still(coded.still())[0].numpy())
    slots = (coded.slot_us / coded.slot_us.mean()).astype(np.float32)
    return _product("video", decoded_clip(coded.clip())[0].numpy() * slots[:, None, None])


def _product(key: str, made: NDArray[np.float32]) -> bytes:
    stream = io.BytesIO()
    # Savez stamps no times: its entries all have the same date.
    np.savez(stream, **{key: made})  # type: ignore[arg-type]  # numpy types keywords as one kind
    return stream.getvalue()


@torch.no_grad()
def decoded_frame(
    folder: RunFolder, frame: NDArray[np.uint8], saturated: NDArray[np.bool_]
) -> NDArray[np.float32]:
    """Electrons over the frame (rows, cols), or a slot (T, rows, cols), from a frame's codes."""
    parts = folder.parts
    shutters = laid(parts.encoder.hard(), *frame.shape).to(parts.device)
    codes = torch.from_numpy(frame.astype(np.float32)).to(parts.device)
    relative = parts.model.relative(codes - parts.model.adc_offset_lsb)
    # The knee of registers, and light that eats the reset level, make full pixels read less.
    full = torch.from_numpy(saturated).to(parts.device)
    relative = torch.where(full, relative.clamp(min=1), relative)
    found = parts.decoder(relative[None], shutters)[0].float().cpu().numpy()
    slots = 1 if parts.still else parts.slots
    return np.asarray(found * (parts.model.full_e / slots), np.float32)


def read_frame(path: Path) -> FrameRead:
    """A frame file of one bucket and one exposure; Rejected (NS0819) for anything else."""
    try:
        with open(path, "rb") as stream, np.load(stream, allow_pickle=False) as file:
            found, meta = file["frame"], json.loads(str(file["meta"]))
            named = "saturated" in file.files  # without, the codes that say so are
            saturated = file["saturated"] if named else np.zeros(found.shape, np.bool_)
            kept = None
            if "shutter" in file.files:
                count = int(file["shutter_shape"][3])
                kept = np.unpackbits(file["shutter"], axis=-1, count=count, bitorder="little")
    except Exception as error:  # numpy, zipfile and json raise a dozen types for damaged files
        reason = f"{type(error).__name__}: {' '.join(str(error).split())[:150]}"
        raise _run_frame(path, reason) from error
    if not isinstance(meta, dict) or meta.get("schema") != SCHEMA or found.dtype != np.uint8:
        raise _run_frame(path, f"its schema is not {SCHEMA}")
    if found.ndim != 3 or found.shape[0] != 1 or 0 in found.shape:
        raise _run_frame(path, f"its frame is {found.shape}, not one bucket of one exposure")
    if saturated.shape != found.shape or saturated.dtype != np.bool_:
        raise _run_frame(path, f"`saturated` is {saturated.dtype} {saturated.shape}, no bool of it")
    if kept is not None and kept.shape[:-1] != found.shape:
        raise _run_frame(path, f"its shutters are of {kept.shape[:-1]}, its frame {found.shape}")
    shutter = None if kept is None else np.asarray(kept[0].transpose(2, 0, 1), np.bool_)
    return FrameRead(found[0], saturated[0], meta, shutter)


def _program_doubts(folder: RunFolder, read: FrameRead) -> Iterator[str]:
    """Reasons to think that the frame was exposed with other shutters."""
    hard = laid(folder.parts.encoder.hard(), *read.frame.shape).numpy().astype(bool)
    if read.shutter is not None:
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
    model = folder.parts.model
    if read.meta.get("sensor_sha256") == sensor_sha256(folder.parts.sensor):
        return
    figures = (("electrons_per_lsb", model.electrons_per_lsb), ("adc_offset", model.adc_offset_lsb))
    for name, wanted in figures:
        have = read.meta.get(name)
        if not isinstance(have, int | float) or abs(have - wanted) > 1e-6 * max(1, abs(wanted)):
            yield f"its sensor has {name} = {have}, the run's {wanted:g}"
            return
    yield "its sensor has other values than the run's"


def _doubt(path: Path, reason: str, *, warning: bool) -> Diagnostic:
    return Diagnostic(
        "NS0819",
        f"'{path}' is no frame for this run: {reason}",
        severity=Severity.WARNING if warning else Severity.ERROR,
        notes=("a decoder knows the shutters and the sensor that it was trained with",),
        helps=("expose the scene with the run's program: `nscc run RUN/shutter.nsl --scene ..`",)
        + (() if warning else ("--force reconstructs it all the same",)),
    )


def _run_frame(path: Path, reason: str) -> Exception:
    return no_coded_frame(
        path, reason, "`nscc run RUN/shutter.nsl --scene .. -o FRAME.npz` writes one"
    )
