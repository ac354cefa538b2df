"""Protocol sci8: the first eight frames of benchmark clips, with the benchmark's masks."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from nscc.arrays import Array, Bytes, Floats, Floats32
from nscc.diagnostics.diagnostic import rejected
from nscc_runtime.scenes.light_arrays import mat_arrays
from nscc_training.measures import frame_scores
from nscc_training.metrics import WINDOW
from nscc_training.problems import one_line
from nscc_training.protocol_scenes.protocol_scene import Item, ProtocolScene
from nscc_training.protocols import Protocol


@dataclass(frozen=True, eq=False)
class SciClip(ProtocolScene):
    """A clip of the benchmark with light from 0 to 1 (8, rows, cols), its `mask` (8, rows, cols),
    and its `measurement` (rows, cols): the sum of mask times light."""

    mask: Floats32
    measurement: Floats32

    @property
    def peak_e(self) -> float:
        """The largest light, 1."""
        return 1.0

    @property
    def truth_e(self) -> Bytes:
        """The frames as the benchmark stores them, 0..255."""
        return np.asarray(np.rint(self.light_e * self.protocol["data_range"]), np.uint8)

    def result(self, clip: Array) -> Floats:
        """Return the reconstruction `clip`, on 0..1, as it is scored: clipped and scaled to 0..255,
        but as in the benchmark not rounded."""
        top = float(self.protocol["data_range"])
        return np.clip(clip.astype(np.float64), 0, 1) * top

    def scores(self, result_e: Array) -> Item:
        """Raise NotImplementedError: `items` scores frame by frame."""
        raise NotImplementedError("frames of this protocol are scored one by one")

    def items(self, result_e: Array) -> list[Item]:
        """Return the scores of each frame of the reconstruction `result_e` (8, rows, cols), on
        0..1, as JSON values, with file and number of the frame."""
        top = float(self.protocol["data_range"])
        pairs = enumerate(zip(self.truth_e, self.result(result_e), strict=True))
        return [
            {
                "file": self.file.as_posix(),
                "crop": None,
                "frame": k,
                **frame_scores(truth, frame, top),
            }
            for k, (truth, frame) in pairs
        ]


def read_sci_clip(path: Path, protocol: Protocol) -> SciClip:
    """Read the clip in the `.mat` file `path` of the sci8 benchmark: its first frames, as many as
    the protocol has, with mask and first measurement.

    Raises Rejected (NS0809) if arrays are missing or have other shapes or values, or if the
    measurement is not that of the clip."""
    try:
        arrays = mat_arrays(path, ["orig", "mask", "meas"])
    except FileNotFoundError:
        raise _unusable(path, "the file does not exist") from None
    except Exception as error:  # scipy.io and h5py raise a dozen types for damaged files
        raise _unusable(path, one_line(error)) from error
    frames = int(protocol["frames"])
    try:
        orig, mask, meas = (np.asarray(arrays[key]) for key in ("orig", "mask", "meas"))
    except KeyError as error:
        raise _unusable(path, f"the array {error} is missing") from None
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
        raise _unusable(
            path, f"{shape[0]} x {shape[1]} is too small: SSIM needs {WINDOW} x {WINDOW}"
        )
    if not np.array_equal(values[0], np.clip(np.rint(values[0]), 0, 255)):
        raise _unusable(path, "`orig` has other values than whole numbers 0..255")
    if values[1].min() < 0 or values[1].max() == 0:
        raise _unusable(path, "`mask` has negative values, or is 0 everywhere")
    # The measurement in the file shows whether mask and clip belong together.
    truth, opened, measured = values[0][:frames], values[1], values[2][0]
    if not np.allclose((truth * opened).sum(axis=0), measured, rtol=1e-4, atol=0.5):
        raise _unusable(path, "its first measurement is not sum(mask x orig) of its first frames")
    scale = float(protocol["data_range"])
    mask, measurement = opened.astype(np.float32), (measured / scale).astype(np.float32)
    return SciClip(
        path,
        crop=None,
        frame=None,
        light_e=truth / scale,
        protocol=protocol,
        mask=mask,
        measurement=measurement,
    )


def _unusable(path: Path, reason: str) -> Exception:
    """Return the error (NS0809) that the file `path` is not a clip of the benchmark, because of
    `reason`."""
    return rejected(
        "NS0809",
        f"'{path}' is not a clip of the sci8 benchmark",
        notes=(reason,),
        helps=(
            "such a .mat file holds `orig` (rows, cols, T >= 8) of 0..255, `mask` (rows, cols, 8) "
            "and `meas` (rows, cols, n), where meas = sum(mask x orig)",
        ),
    )
