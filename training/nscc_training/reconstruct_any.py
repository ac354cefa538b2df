"""Reconstruction of frames of any program, and of measurements of others; choice of the method."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator
from importlib.util import find_spec
from pathlib import Path
from typing import NamedTuple

import numpy as np

from nscc.arrays import Array, Bools, Floats, Floats32
from nscc.diagnostics.diagnostic import Diagnostic, Severity, rejected
from nscc.npy import InvalidArrays, npz_arrays
from nscc.program.problems import counted
from nscc_runtime.formats import Content
from nscc_runtime.machine_code import working_s
from nscc_runtime.progress import Progress, unseen
from nscc_training.any_code.frames import read_coded_frames
from nscc_training.array_files import (
    MOST,
    ambiguous_axes,
    array_names,
    is_square_tile,
    read_mask,
    real_array,
    refused,
)
from nscc_training.baselines.gap_tv import gap_tv_of
from nscc_training.baselines.merge_loop import merge_neighbours
from nscc_training.command_settings import Axis, Method, ResultKind
from nscc_training.measured import Measured
from nscc_training.problems import listed

_OVEREXPOSED = 0.25
"""Fraction of saturated pixels above which a warning is given."""


class Reconstruction(NamedTuple):
    """A reconstructed picture or clip.

    `light` is float32, a picture (rows, cols) in electrons over the frame, or a clip (T, rows,
    cols) in electrons per slot; with `colour` the last axis is red, green, blue. `still` says
    which. `messages` are warnings about the frame. `decode_s` is the decoding time in seconds.
    `method` names the method of the decoder for any code, else it is empty. `unit` is "e", or ""
    for own measurements. `reason` says why GAP-TV was chosen instead of the network."""

    light: Floats32
    still: bool
    colour: bool
    messages: tuple[Diagnostic, ...]
    decode_s: float
    method: str = ""
    unit: str = "e"
    reason: str = ""

    @property
    def content(self) -> Content:
        """The reconstruction in the form that all output formats accept: the array "image" (a
        still) or "video" (a clip). Files for MATLAB have time as the last axis of clips."""
        arrays = {"image" if self.still else "video": self.light}
        if self.method:
            arrays["method"] = np.array(self.method)
        # Time is the last axis of clips in MATLAB.
        turned = arrays if self.still else arrays | {"video": np.moveaxis(self.light, 0, -1)}
        return Content(
            arrays,
            self.light,
            not self.still,
            self.colour,
            benchmark=lambda: turned,
            usual="log" if self.still else "srgb",
            unit=self.unit,
        )


def overexposed(name: str, saturated: Bools) -> Iterator[Diagnostic]:
    """Yield a warning (NS0844) if more than `_OVEREXPOSED` of the values of `saturated`, of any
    shape, are true. The message calls the frame `name`. Nothing is yielded for an empty array."""
    share = float(saturated.mean()) if saturated.size else 0.0
    if share > _OVEREXPOSED:
        yield Diagnostic(
            "NS0844",
            f"{100 * share:.3g} % of the pixels of '{name}' are saturated",
            severity=Severity.WARNING,
            notes=("a saturated pixel gives the decoder only a lower limit of the light",),
            helps=("expose the scene with less light, or use shutters that close early",),
        )


_ITERATIONS = 40
"""Iterations of GAP-TV."""
_WHITE = 0.995
"""The quantile of light that counts as white."""
_CHANCE = 1.5
"""GAP-TV is chosen if its predictions are better by this number of standard errors. On 288 frames
of 9 codes and 8 clips, without noise and under every effect, the choices lost 0.09 dB in the mean
beside always choosing the better method."""


def method_for(still: bool, method: Method | None = None) -> Method:
    """Return `method` if it is not None, also if torch is missing. Otherwise return the network, or
    if torch is not installed, merging for stills and GAP-TV for clips."""
    if method is None and find_spec("torch") is None:
        return "merge" if still else "gap-tv"
    return method or "network"


def gap_tv_clip(
    measured: Measured[Array], iterations: int = _ITERATIONS, weight: float | None = None
) -> Floats32:
    """Return the clip (N, rows, cols) that `iterations` of GAP-TV reconstruct from a batch of one,
    in the unit of the measurement, at least 0.

    `weight` is that of total variation. None tries several weights, and takes the one that best
    predicts pixels that are left out."""
    relative, white = _relative(measured)
    weight = best_weight(relative, iterations)[0] if weight is None else weight
    clip = with_weight(weight, iterations)(relative)
    return np.asarray(clip[0].clip(min=0) * white, np.float32)


def _relative(measured: Measured[Array]) -> tuple[Measured[Array], float]:
    """Return the measurement, a batch of one, divided by white, and white: the 99.5 % quantile of
    the mean light of pixels that open, at least 1e-6; 1 if none does."""
    opened = np.broadcast_to(measured.mask.sum(axis=(1, 2)) > 0, measured.mean().shape)
    light = measured.mean()[opened]
    white = float(np.quantile(light, _WHITE).clip(min=1e-6)) if light.size else 1.0
    return measured.over(np.array([white], np.float32)), white


def chosen_for_clip(measured: Measured[Array]) -> tuple[Method, str, float]:
    """Return the method for a clip from `measured`, a batch of one in any unit: GAP-TV if it
    predicts pixels that are left out of the measurement better than the network, by more than
    chance, else the network.

    The second result is a sentence that says why it is not the network, and is empty if it is. The
    third is the weight of total variation with which GAP-TV predicts best."""
    from nscc_training.any_code.decode import decoded_clip

    relative, _ = _relative(measured)
    weight, gap_tv = best_weight(relative, _ITERATIONS)
    network = prediction_errors(
        relative, lambda without: np.asarray(decoded_clip(without.tensors()).numpy())
    )
    # The network takes pixels without a value for slightly dark. Whole frames have none, so a
    # common error does not count. Noise of the values is common to both squares.
    lead = (network - network.mean()) ** 2 - (gap_tv - gap_tv.mean()) ** 2
    if lead.mean() <= _CHANCE * lead.std() / math.sqrt(lead.size):
        return "network", "", weight
    reason = (
        "GAP-TV predicts pixels that are left out better than the network (standard deviation of "
        f"the error {100 * gap_tv.std():.4g} % of white instead of {100 * network.std():.4g} %), "
        "so GAP-TV found the clip; --method network uses the network"
    )
    return "gap-tv", reason, weight


def merged_still(measured: Measured[Array]) -> Floats32:
    """Return the light (rows, cols) over the frame of a batch of one still, in the unit of the
    measurement: each pixel is the mean of its neighbourhood, weighted by precision. Saturated
    values have weight 0, but their pixel has at least the light that saturates it. Pixels that
    never open have their neighbours' light. The masks have one slot."""
    value, mask = measured.value[0].astype(np.float64), measured.mask[0, :, 0]
    opened, full = mask > 0, measured.saturated[0]
    light = np.where(opened, value / np.where(opened, mask, 1), 0)
    variance = measured.variance[0].clip(min=1e-12).astype(np.float64)
    precision = np.where(opened & ~full, mask**2 / variance, 0)
    total = precision.sum(axis=0)
    mean = (precision * light).sum(axis=0) / np.where(total > 0, total, 1)
    least = np.where(opened & full, light, 0).max(axis=0)
    return merge_neighbours(mean, total, least).astype(np.float32)


_KINDS: dict[str, ResultKind] = {"merge": "image", "gap-tv": "video"}
"""The kind of result of each method that does not use the network."""


def reconstruct_any(
    frame: Path,
    program: Path | None = None,
    kind: ResultKind | None = None,
    dark: Path | None = None,
    method: Method | None = None,
    progress: Progress = unseen,
) -> Reconstruction:
    """Reconstruct a frame of any program with the decoder for any code, or without a network.

    `program` exposed the frame; it is needed if the file does not contain its shutters. `dark` is a
    dark frame file of the program, with many repeats. Without `kind` the result is an image if all
    shutters open at the start of the frame (class b), else a clip. `method` "merge" is for images,
    "gap-tv" for clips. None takes the network if torch is installed, but for clips GAP-TV if that
    predicts left-out pixels of the first colour better; without torch it takes "merge" or "gap-tv".
    `progress` receives the network's stages. Each colour is decoded separately. Raises Rejected as
    `read_coded_frames` does."""
    kind = kind or _KINDS.get(method or "network")
    doubts: list[Diagnostic] = []
    coded_frames = read_coded_frames(frame, program, dark, doubts.append)
    still = (kind or ("image" if coded_frames[0].is_still else "video")) == "image"
    begin = working_s()
    if still:
        method, reason = method_for(still, method), ""
        lights = [_still(coded.still(), method) for coded in coded_frames]
    else:
        clips, method, reason = _clips((coded.clip() for coded in coded_frames), method, progress)
        # Decoders return light per slot of mean length.
        lights = [
            clip * (coded.slot_us / coded.slot_us.mean()).astype(np.float32)[:, None, None]
            for clip, coded in zip(clips, coded_frames, strict=True)
        ]
    light = np.stack(lights, axis=-1) if len(lights) > 1 else lights[0]
    full = np.stack([coded.saturated for coded in coded_frames])
    messages = (*doubts, *overexposed(str(frame), full))
    decode_s = working_s() - begin
    return Reconstruction(
        light,
        still=still,
        colour=len(lights) > 1,
        messages=messages,
        decode_s=decode_s,
        method=method,
        reason=reason,
    )


def _still(measured: Measured[Array], method: Method) -> Floats32:
    """Return the light (rows, cols) over the frame of a batch of one still, by merging neighbours
    if `method` is "merge", else by the network, in the unit of the measurement."""
    if method == "merge":
        return merged_still(measured)
    from nscc_training.any_code.decode import decoded_still

    return np.asarray(decoded_still(measured.tensors())[0].numpy())


def _clips(
    measurements: Iterable[Measured[Array]], method: Method | None, progress: Progress
) -> tuple[list[Floats32], Method, str]:
    """Return the clip (N, rows, cols) of each of the `measurements`, batches of one, in their unit
    per slot, the method that found the clips, and why it is not the network ("" if it is).

    `method` None takes the network if torch is installed, unless GAP-TV predicts left-out pixels of
    the first measurement better. `progress` receives the network's stages."""
    clips: list[Floats32] = []
    chosen, reason, weight = method_for(still=False, method=method), "", None
    for measured in measurements:
        if method is None and chosen == "network" and not clips:
            chosen, reason, weight = chosen_for_clip(measured)
        if chosen == "network":
            from nscc_training.any_code.decode import decoded_clip

            clip = decoded_clip(measured.tensors(), progress=progress)[0].numpy()
        else:
            clip, weight = gap_tv_clip(measured, weight=weight), None
        clips.append(clip)
    return clips, chosen, reason


_KEYS = frozenset(("mask", "meas"))


class NoiseModel(NamedTuple):
    """Noise of a measurement in its own unit.

    `read_sd` is the standard deviation of the readout. `gain` is what one photon adds to the
    measurement: the variance of photon noise is `gain` times the value."""

    read_sd: float = 0.0
    gain: float = 0.0

    @classmethod
    def parse(cls, text: str) -> NoiseModel:
        """Return the noise that a text `SD` or `SD,GAIN` describes: two numbers from 0 to `MOST`,
        as in "2.5,0.1". A missing gain is 0. Raise Rejected (NS0846) for another text."""
        try:
            numbers = [float(item) for item in text.split(",")]
        except ValueError:
            numbers = []
        if len(numbers) not in (1, 2) or not all(0 <= number <= MOST for number in numbers):
            raise rejected(
                "NS0846",
                f"invalid noise model '{text[:60]}'",
                notes=(
                    "--noise SD[,GAIN]: the standard deviation of the readout in the unit of "
                    "`meas`, and the amount that one photon adds to `meas`, each from 0 to "
                    f"{MOST:g}",
                ),
                helps=("for instance --noise 2.5, or --noise 2.5,0.1",),
            )
        return cls(*numbers)

    def __str__(self) -> str:
        """Return a sentence on the noise, for the terminal."""
        if not self.read_sd and not self.gain:
            return "none: the measurement is treated as exact; --noise SD[,GAIN] sets a noise model"
        photons = f", variance of photons {self.gain:g} times the measurement" if self.gain else ""
        return f"standard deviation of the readout {self.read_sd:g}{photons}"


class Measurement(NamedTuple):
    """K measurements `values` (K, rows, cols) that were taken with one `mask` (slots, rows, cols).
    `axes` says in words how the axes of the file were read."""

    values: Floats
    mask: Floats
    axes: str


def is_measurement(path: Path, mask: Path | None) -> bool:
    """Return whether the file `path` is a measurement of another camera instead of a frame file of
    nscc.

    It is one if a file of the `mask` is given, if it is .mat or .npy, or if it is an .npz with
    `meas` or `mask` but without `meta`. A file that cannot be read is none."""
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


def read_measurement(
    path: Path, mask_path: Path | None = None, slots_axis: Axis | None = None
) -> Measurement:
    """Read `meas` of a file and `mask` of the same or another file. Of several ways to read the
    axes, slots last is preferred for a square tile.

    Parameters
    ----------
    path : Path
        A .mat (of any version), .npz or .npy file. `meas` is (rows, cols), (rows, cols, K) or
        (K, rows, cols).
    mask_path : Path, optional
        The file of the mask, (rows, cols, slots) or (slots, rows, cols).
    slots_axis : {"first", "last"}, optional
        The axis of slots; needed if the measurement fits both.

    Raises
    ------
    Rejected
        NS0845 for arrays that are missing, do not fit each other, are ambiguous, or hold other
        values.
    """
    names = [] if path.suffix.lower() == ".npy" else array_names(path)
    if mask_path is None and "mask" not in names:
        held = f"it holds {listed(sorted(names)) or 'no array'}; " if names else ""
        note = f"{held}--mask MASK names the file of the mask"
        raise refused(path, "the array `mask` is missing", note)
    mask, values = read_mask(mask_path or path), real_array(path, "meas")
    if values.ndim not in (2, 3) or 0 in values.shape:
        raise refused(path, f"`meas` has the shape {values.shape}")
    if np.abs(values).max() > MOST * mask.max():
        raise refused(path, f"`meas` is more than {MOST:g} times the largest value of `mask`")
    readings: list[Measurement] = []
    for axis, name in ((2, "last"), (0, "first")):
        size = tuple(np.delete(mask.shape, axis))
        # If both axes count measurements, the last one does, as in MATLAB.
        fits = [
            at for at in (2, 0) if values.ndim == 3 and tuple(np.delete(values.shape, at)) == size
        ]
        if slots_axis in (None, name) and (values.shape == size or fits):
            turned = values[None] if values.ndim == 2 else np.moveaxis(values, fits[0], 0)
            text = (
                f"{size[0]} x {size[1]} pixels, {counted(mask.shape[axis], 'slot')} (the "
                f"{name} axis of `mask`), {counted(len(turned), 'measurement')}"
            )
            readings.append(Measurement(turned, np.moveaxis(mask, axis, 0), text))
    if not readings:
        raise refused(
            path, f"`meas` is {values.shape}, but `mask` is {mask.shape}: rows and columns differ"
        )
    if len(readings) > 1 and not is_square_tile(mask.shape):
        raise ambiguous_axes(mask_path or path, mask.shape)
    return readings[0]


def reconstruct_measurement(
    measurement: Measurement,
    noise: NoiseModel,
    method: Method | None = None,
    progress: Progress = unseen,
) -> Reconstruction:
    """Reconstruct the clips of all K measurements, one after the other: (K * slots, rows, cols), in
    the unit of the measurement per slot.

    `noise` is in the unit of the measurement. `method` None takes the network if torch is
    installed, unless GAP-TV predicts left-out pixels of the first measurement better."""
    begin = working_s()
    # The decoders are made for masks up to 1.
    most = measurement.mask.max()
    opened = np.asarray(measurement.mask / most, np.float32)[None, None]

    def measured(values: Floats) -> Measured[Array]:
        """Return one measurement (rows, cols) in the unit of the largest value of the mask."""
        variance = noise.read_sd**2 + noise.gain * np.maximum(values, 0)
        scaled = (values / most, np.minimum(variance / most**2, MOST**2))
        value, spread = (np.asarray(array, np.float32)[None, None] for array in scaled)
        return Measured(value, opened, spread, np.zeros(value.shape, bool))

    clips, method, reason = _clips(map(measured, measurement.values), method, progress)
    light = np.concatenate(clips)
    return Reconstruction(
        light,
        still=False,
        colour=False,
        messages=(),
        decode_s=working_s() - begin,
        method=method,
        unit="",
        reason=reason,
    )


Decoder = Callable[[Measured[Array]], Floats32]
"""A function of a measurement whose white is 1, for its clip (1, N, rows, cols)."""

_WEIGHTS = (0.05, 0.1, 0.2, 0.5, 1.0)
"""Weights of total variation to choose from: noise and motion decide which is best."""
_SIDE = 128
"""Rows and columns of the middle of the frame, where methods are compared."""
_BLOCK = 4
"""One pixel of each square of this side is left out."""


def with_weight(weight: float, iterations: int) -> Decoder:
    """Return the decoder that applies `iterations` of GAP-TV with this `weight` of total
    variation."""
    return lambda measured: np.asarray(gap_tv_of(measured, iterations, weight=weight)[0])


def best_weight(measured: Measured[Array], iterations: int) -> tuple[float, Floats]:
    """Return the weight of total variation, one of `_WEIGHTS`, with which GAP-TV predicts left-out
    pixels with the least mean square error; of equal errors, the smallest weight. Return also the
    errors (values,) of the predictions with this weight, in units of white.

    `measured` must be divided by white. Each prediction runs `iterations` iterations."""
    errors = [prediction_errors(measured, with_weight(w, iterations)) for w in _WEIGHTS]
    best = int(np.argmin([(gaps**2).mean() for gaps in errors]))
    return _WEIGHTS[best], errors[best]


def prediction_errors(measured: Measured[Array], decoder: Decoder) -> Floats:
    """Return what a decoder's prediction lacks of each value that is left out.

    Parameters
    ----------
    measured : Measured
        A measurement whose white is 1.
    decoder : callable
        It gets the measurement with the masks and values of some pixels set to 0.

    Returns
    -------
    ndarray of float64, shape (values,)
        In units of white, one for each bucket of each pixel that is left out, for every decoder the
        same pixels, from the middle of the frame. A frame without such pixels gives one 0. The
        noise of the value is part of it.
    """
    sides = measured.value.shape[-2:]
    firsts = (max(0, (side - _SIDE) // 2) for side in sides)
    part = measured.crop(*(slice(first, first + _SIDE) for first in firsts))
    rows, cols = part.value.shape[-2:]
    generator = np.random.default_rng(0)
    # One random pixel of each block of `_BLOCK` x `_BLOCK` pixels is left out.
    chosen = generator.integers(_BLOCK, size=(2, -(-rows // _BLOCK), -(-cols // _BLOCK)))
    left_out = np.indices(chosen.shape[1:]) * _BLOCK + chosen
    down, across = left_out[:, (left_out[0] < rows) & (left_out[1] < cols)]
    kept = np.ones((rows, cols), np.float32)
    kept[down, across] = 0
    without = Measured(part.value * kept, part.mask * kept, part.variance, part.saturated)
    gap = part.missing(part.of(decoder(without)), part.value)[..., down, across]
    # Tiny frames may have no pixel to leave out.
    return gap.astype(np.float64).ravel() if gap.size else np.zeros(1)
