"""Reconstruction of measurements of other cameras, given their mask."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from nscc.diagnostics.rejection import rejected
from nscc.npy import InvalidArrays, npz_arrays
from nscc_runtime.machine_code import working_s
from nscc_training.array_files import Floats, array_names, read_mask, real_array, refused
from nscc_training.measured import Measured
from nscc_training.reconstruct_any import Method, Reconstruction, gap_tv_clip, method_for

_KEYS = frozenset(("mask", "meas"))


@dataclass(frozen=True)
class NoiseModel:
    """Noise of a measurement, in its unit: the readout's standard deviation, and the photon noise's
    variance over the value."""

    read_sd: float = 0.0
    gain: float = 0.0

    @classmethod
    def parse(cls, text: str) -> NoiseModel:
        """Parse `SD` or `SD,GAIN`; raise Rejected (NS0846) for another text."""
        try:
            numbers = [float(item) for item in text.split(",")]
        except ValueError:
            numbers = []
        if len(numbers) not in (1, 2) or not all(0 <= number < np.inf for number in numbers):
            raise rejected(
                "NS0846",
                f"invalid noise model '{text[:60]}'",
                notes=("--noise SD[,GAIN]: the standard deviation of the readout in the unit of "
                       "`meas`, and the amount that one photon adds to `meas`",),
                helps=("for instance --noise 2.5, or --noise 2.5,0.1",),
            )  # fmt: skip
        return cls(*numbers)

    def __str__(self) -> str:
        if not self.read_sd and not self.gain:
            return "none: the measurement is treated as exact; --noise SD[,GAIN] sets a noise model"
        photons = f", variance of photons {self.gain:g} times the measurement" if self.gain else ""
        return f"standard deviation of the readout {self.read_sd:g}{photons}"


@dataclass(frozen=True, eq=False)
class Measurement:
    """Measurements (K, rows, cols) with one mask (slots, rows, cols); `axes` says how read."""

    values: Floats
    mask: Floats
    axes: str


def is_measurement(path: Path, mask: Path | None) -> bool:
    """Return whether a file is a measurement: an array file with `meas`, or with a mask."""
    suffix = path.suffix.lower()
    if mask is not None or suffix in (".mat", ".npy"):
        return True
    if suffix != ".npz" or not path.is_file():
        return False
    try:
        _, names = npz_arrays(path, lambda _: False)
        return "meta" not in names and bool(_KEYS & set(names))
    except (InvalidArrays, OSError):  # the function that reads it as a frame reports the damage
        return False


def read_measurement(path: Path, mask_path: Path | None = None) -> Measurement:
    """Read `meas` of a file and `mask` of the same or another file.

    Parameters
    ----------
    path : Path
        A .mat (of any version), .npz or .npy file. `meas` is (rows, cols), (rows, cols, K) or
        (K, rows, cols).
    mask_path : Path, optional
        The file of the mask, (rows, cols, slots) or (slots, rows, cols).

    Raises
    ------
    Rejected
        NS0845 for arrays that are missing, do not fit each other, or hold other values.
    """
    if mask_path is None and (path.suffix.lower() == ".npy" or "mask" not in array_names(path)):
        raise refused(path, "the array `mask` is missing", "name the file of the mask: --mask MASK")
    mask, values = read_mask(mask_path or path), real_array(path, "meas")
    if values.ndim not in (2, 3) or 0 in values.shape:
        raise refused(path, f"`meas` has the shape {values.shape}")
    # If both axes are possible, time is the last one, as in MATLAB.
    for axis, name in ((2, "last"), (0, "first")):
        size = tuple(np.delete(mask.shape, axis))
        fits = [
            at for at in (2, 0) if values.ndim == 3 and tuple(np.delete(values.shape, at)) == size
        ]
        if values.shape == size or fits:
            turned = values[None] if values.ndim == 2 else np.moveaxis(values, fits[0], 0)
            text = (f"{size[0]} x {size[1]} pixels, {mask.shape[axis]} slots (the {name} axis of "
                    f"`mask`), {len(turned)} measurement{'s' * (len(turned) > 1)}")  # fmt: skip
            return Measurement(turned, np.moveaxis(mask, axis, 0), text)
    raise refused(
        path, f"`meas` is {values.shape}, but `mask` is {mask.shape}: rows and columns differ"
    )


def reconstruct_measurement(
    measurement: Measurement, noise: NoiseModel, method: Method | None = None
) -> Reconstruction:
    """Reconstruct the clip (K * slots, rows, cols), in the unit of the measurement per slot."""
    method, begin = method_for(still=False, method=method), working_s()
    opened = np.asarray(measurement.mask, np.float32)[None, None]
    clips: list[NDArray[np.float32]] = []
    for values in measurement.values:
        variance = noise.read_sd**2 + noise.gain * np.maximum(values, 0)
        value, spread = (np.asarray(array, np.float32)[None, None] for array in (values, variance))
        measured = Measured(value, opened, spread, np.zeros(value.shape, bool))
        if method == "gap-tv":
            clips.append(gap_tv_clip(measured))
            continue
        from nscc_training.any_code.decode import decoded_clip

        clips.append(decoded_clip(measured.tensors())[0].numpy())
    light = np.concatenate(clips)
    return Reconstruction(light, False, False, (), working_s() - begin, method)
