"""Protocol sci8: a benchmark clip, its own mask and measurement, the first eight frames."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from time import perf_counter
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.diagnostics.rejection import rejected
from nscc_runtime.mat_file import mat_arrays
from nscc_training.baselines.dictionary import made_dictionary
from nscc_training.baselines.loops import denoise
from nscc_training.baselines.tv import Clip
from nscc_training.evaluation.methods import METHODS
from nscc_training.evaluation.results import Item, Subject, result
from nscc_training.measures import frame_scores
from nscc_training.metrics import WINDOW
from nscc_training.problems import said
from nscc_training.protocols import Protocol, load_protocol
from nscc_training.scene_files import labels, protocol_files


@dataclass(frozen=True, eq=False)
class SciClip:
    """A clip of the benchmark: `orig` uint8 (8, rows, cols), `mask` float32 of that shape, and
    `measurement` float32 (rows, cols) in units of the full scale 255 of one frame."""

    orig: NDArray[np.uint8]
    mask: Clip
    measurement: NDArray[np.float32]


def sci_clips(where: Path) -> list[Path]:
    """The clips of a folder by name, or the one that is named; Rejected (NS0811) without any."""
    if where.is_file():
        return [where]
    wanted = "the benchmark's clips, or one of them"
    return protocol_files(where, (".mat",), "sci8", "clips end in", wanted)


def read_sci_clip(path: Path, protocol: Protocol) -> SciClip:
    """The clip in a `.mat` file; Rejected (NS0809) where it is not one of the benchmark's kind."""
    try:
        found = mat_arrays(path, ["orig", "mask", "meas"])
    except FileNotFoundError:
        raise _unusable(path, "there is no such file") from None
    except Exception as error:  # scipy.io raises a dozen types for damaged files
        raise _unusable(path, said(error)) from error
    frames = int(protocol["frames"])
    try:
        orig, mask, meas = (np.asarray(found[key]) for key in ("orig", "mask", "meas"))
    except KeyError as error:
        raise _unusable(path, f"it has no array {error}") from None
    meas = meas[..., None] if meas.ndim == 2 else meas
    shape = orig.shape[:2]
    if orig.ndim != 3 or orig.shape[2] < frames or mask.shape != (*shape, frames):
        raise _unusable(path, f"`orig` is {orig.shape}, `mask` {mask.shape}")
    if meas.ndim != 3 or meas.shape[:2] != shape or meas.shape[2] < 1:
        raise _unusable(path, f"`meas` is {meas.shape}")
    if any(a.dtype.kind not in "uifb" for a in (orig, mask, meas)):
        raise _unusable(path, "its arrays are not real numbers")
    values = [np.moveaxis(a.astype(np.float64), 2, 0) for a in (orig, mask, meas)]
    if not all(np.isfinite(a).all() for a in values):
        raise _unusable(path, "its arrays are not finite")
    if min(shape) < WINDOW:
        raise _unusable(path, f"{shape[0]} x {shape[1]} is too small: SSIM needs {WINDOW} x "
                        f"{WINDOW}")  # fmt: skip
    if not np.array_equal(values[0], np.clip(np.rint(values[0]), 0, 255)):
        raise _unusable(path, "`orig` has other values than whole numbers 0..255")
    if values[1].min() < 0 or values[1].max() == 0:
        raise _unusable(path, "`mask` is negative somewhere, or 0 everywhere")
    truth, opened, measured = values[0][:frames], values[1], values[2][0]
    if not np.allclose((truth * opened).sum(axis=0), measured, rtol=1e-4, atol=0.5):
        raise _unusable(path, "its first measurement is not sum(mask x orig) of its first frames")
    scale = float(protocol["data_range"])
    return SciClip(
        truth.astype(np.uint8), opened.astype(np.float32), (measured / scale).astype(np.float32)
    )


def evaluate_sci8(
    paths: list[Path], method: str, iterations: int, weight: float
) -> tuple[dict[str, Any], dict[str, NDArray[Any]]]:
    """The result of a method on clips, and what it made of them: arrays by name.

    Raises Rejected: NS0809 for clips, NS0810 for a method that there is not.
    """
    protocol = load_protocol("sci8")
    chosen = METHODS.get(method)
    if chosen is None:
        raise rejected(
            "NS0810",
            f"there is no method '{method[:60]}' for sci8",
            notes=(f"the methods are {', '.join(METHODS)}",),
            helps=("a trained decoder is evaluated by the name of its run folder",),
        )
    if method in ("gap-tv", "admm-tv", "any"):
        denoise.load()  # compiled or loaded now: it is no part of a clip's time
    if method == "dictionary":
        made_dictionary(int(protocol["frames"]))  # learned now, for the same reason
    items: list[Item] = []
    arrays: dict[str, NDArray[Any]] = {}
    spent = 0.0
    top = float(protocol["data_range"])
    called = labels(paths)
    for path in paths:
        clip = read_sci_clip(path, protocol)
        truth = clip.orig.astype(np.float32) / np.float32(top)
        begin = perf_counter()
        made = chosen.run(clip.measurement, clip.mask, truth, iterations, weight)
        spent += perf_counter() - begin
        # Not rounded to whole numbers: the benchmark scores real values.
        scaled = np.clip(made.astype(np.float64), 0, 1) * top
        arrays[f"{called[path.name]}_video"] = scaled.astype(np.float32)
        arrays[f"{called[path.name]}_truth"] = clip.orig
        for k, (frame, wanted) in enumerate(zip(scaled, clip.orig, strict=True)):
            items.append(Item(path.name, None, k, frame_scores(wanted, frame, top)))
    settings = {"iterations": iterations, "weight": weight} if method.endswith("-tv") else {}
    subject = Subject(method, settings, sees=chosen.sees, decoder_ms=1e3 * spent / len(paths))
    return result(protocol, subject, paths, items), arrays


def _unusable(path: Path, reason: str) -> Exception:
    return rejected(
        "NS0809",
        f"'{path}' is no clip of the sci8 benchmark",
        notes=(reason,),
        helps=(
            "such a .mat file holds `orig` (rows, cols, T >= 8) of 0..255, `mask` (rows, cols, 8) "
            "and `meas` (rows, cols, n), where meas = sum(mask x orig)",
        ),
    )
