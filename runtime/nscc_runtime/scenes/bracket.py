"""Merge a bracket, photos of one scene with different exposures, to linear light of high dynamic
range."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from glob import glob
from pathlib import Path

import numpy as np

from nscc.arrays import Array, Floats32
from nscc.diagnostics.diagnostic import Rejected, rejected
from nscc.files import reads
from nscc_runtime.scene_settings import Transfer
from nscc_runtime.scenes.colour import Colours
from nscc_runtime.scenes.pages import Pages
from nscc_runtime.scenes.picture_folders import files_of, read_folder
from nscc_runtime.scenes.pillow_pictures import exif_of

_EXPOSURE_TIME, _F_NUMBER, _ISO = 0x829A, 0x829D, 0x8827
"""Numbers of EXIF tags."""


def parse_times(text: str | tuple[float, ...] | None) -> tuple[float, ...] | None:
    """Parse exposure times in seconds, separated by commas, each a decimal or a quotient:
    `1/250,1/60,0.066`. Raises NS0777 for other texts and for times that are not finite and above 0.

    Parsed times, or None, are returned unchanged."""
    if not isinstance(text, str):
        return text
    try:
        quotients = (item.partition("/") for item in text.split(","))
        times = tuple(
            # A divisor below 0 is refused like 0.
            float(top) / (max(float(bottom), 0.0) if slash else 1.0)
            for top, slash, bottom in quotients
        )
    except (ValueError, ZeroDivisionError):
        times = ()
    if not times or not all(0 < time < np.inf for time in times):
        raise _refused(
            f"invalid exposure times '{text[:60]}'", "for instance --times 1/250,1/60,1/15"
        )
    return times


def bracket_files(spec: str) -> list[Path]:
    """Return the photos of the folder `spec`, in natural order (2 before 10), or the files that
    match the pattern `spec`, such as `b/*.jpg`, in the order of their names. Raises Rejected
    (NS0777) for fewer than two photos."""
    path = Path(spec)
    files = files_of(path, skip=True) if path.is_dir() else [Path(p) for p in sorted(glob(spec))]
    if len(files) < 2:
        text = f"'{spec[:200]}' names too few photos, {len(files)}: a bracket needs at least two"
        raise _refused(text, "name a folder, or a pattern in quotes: --scene 'b/*.jpg' --bracket")
    return files


def merged_bracket(
    files: Sequence[Path],
    times: Sequence[float] | None,
    transfer: Transfer | None = None,
    tell: Callable[[Pages], object] = lambda _: None,
) -> tuple[Floats32, Colours]:
    """Merge photos to linear light by the method of Debevec and Malik (SIGGRAPH 1997).

    The camera response is known: the curve that the file states, or the curve of its format. Light
    is the exponential of a weighted mean of log light; samples near black and near white have the
    smallest weights. One photo is held in memory at a time.

    Parameters
    ----------
    files : sequence of Path
        Photos of one size with integer samples, 8 or 16 bits each.
    times : sequence of float, optional
        Exposure times in seconds. None for those of the photos' EXIF, each times its ISO speed over
        the square of its f-number.
    transfer : {"linear", "srgb", "pq", "hlg"}, optional
        The curve of all photos, instead of the curves that the files state.
    tell : callable, optional
        Called with the pages of the first photo, which have its notes.

    Returns
    -------
    tuple of array and Colours
        Linear light, (R, C) grey or (R, C, 3) red, green, blue; and its colours.

    Raises
    ------
    Rejected
        NS0777 for photos without exposure times, with samples of another type, or all of one time;
        and the errors of `read_folder`.
    """
    reads(*files)
    exposures = [*times] if times is not None else _exif_exposures(files)
    log_exposures = [float(np.float32(np.log(exposure))) for exposure in exposures]
    if len(exposures) != len(files):
        text = f"{len(files)} photos do not match {len(exposures)} exposure times"
        raise _refused(text, "give one time per photo, in the order of their names")
    if len(set(exposures)) == 1:
        raise _refused(
            "all photos have the same exposure", "a bracket needs several exposures; see --times"
        )
    # Sums over the photos; `shortest` and `longest` are the log light that the photos with the
    # shortest and the longest exposure show.
    weights = weighted = shortest = longest = np.zeros((), np.float32)
    light = Colours.of("linear")
    photos = zip(files, read_folder([*files]), log_exposures, strict=True)
    for path, (photo, pages), log_exposure in photos:
        if photo.dtype not in (np.uint8, np.uint16):
            text = (
                f"'{path.name}' has {photo.dtype} samples, but only integer samples can be merged"
            )
            raise _refused(text, "convert the photos to .tiff, .png or .jpg with 8 or 16 bits")
        if path == files[0]:
            tell(pages)
        channels = photo if photo.ndim == 3 else photo[..., None]
        colours = Colours.of(transfer or pages.colours)
        light = Colours.of("linear", colours.weights)
        weight, logarithm = _weights(channels), _log_light(channels, colours) - log_exposure
        weights, weighted = weights + weight, weighted + weight * logarithm
        shortest = logarithm if log_exposure == min(log_exposures) else shortest
        longest = logarithm if log_exposure == max(log_exposures) else longest
    # If all samples are black or white, the light is at least white in the shortest exposure, or at
    # most black in the longest exposure.
    bound = np.where(shortest >= -min(log_exposures), shortest, longest)
    # The maximum avoids a division by 0 where `bound` is taken.
    merged = np.exp(np.where(weights > 0, weighted / np.maximum(weights, 1e-9), bound))
    return merged if merged.shape[-1] == 3 else merged[..., 0], light


def _weights(photo: Array) -> Floats32:
    """Return the weight (R, C, 1) of each pixel of a `photo` (R, C, channels) of uint8 or uint16: 0
    for samples at black and white, and largest half-way between. Weights of channels are
    averaged."""
    samples = np.arange(np.iinfo(photo.dtype).max + 1)
    triangle = (np.minimum(samples, samples[::-1]) / len(samples)).astype(np.float32)
    return np.asarray(triangle[photo].mean(axis=-1, keepdims=True))


def _log_light(photo: Array, colours: Colours) -> Floats32:
    """Return the logarithm of the linear light of a `photo` (R, C, channels) of uint8 or uint16, in
    the same shape: 0 for white. `colours` gives the curve of each channel.

    Samples without light count as half the least light of a sample, so that the logarithm is
    finite."""
    fractions = np.linspace(0, 1, np.iinfo(photo.dtype).max + 1)
    logarithms = []
    for channel in range(photo.shape[-1]):
        light = colours.curve_of(channel)(fractions)
        light = np.where(light > 0, light, light[light > 0].min() / 2)
        logarithms.append(np.log(light).astype(np.float32)[photo[..., channel]])
    return np.stack(logarithms, axis=-1)


def _exif_exposures(files: Sequence[Path]) -> list[float]:
    """Return the exposure of each of `files` by its EXIF data: time x ISO speed / squared f-number.

    An f-number or ISO speed that no photo states counts 1. Raises Rejected (NS0777) if only some
    photos state it, if a photo states no time, or if an exposure is not finite and above 0."""
    stated = [_exif_factors(path) for path in files]
    for factor, name in ((1, "f-number"), (2, "ISO speed")):
        lacking = [path for path, of in zip(files, stated, strict=True) if of[factor] is None]
        if 0 < len(lacking) < len(files):
            text = f"the {name} of '{lacking[0]}' is missing, but other photos state theirs"
            raise _refused(text, "give the exposures of all photos: --times 1/250,1/60")
    exposures = [time_s * (iso or 1) / (f or 1) ** 2 for time_s, f, iso in stated]
    for path, exposure in zip(files, exposures, strict=True):
        if not 0 < exposure < np.inf:
            raise _refused(
                f"the exposure of '{path}' is {exposure:g}", "give the times: --times 1/250,.."
            )
    return exposures


def _exif_factors(path: Path) -> tuple[float, float | None, float | None]:
    """Return exposure time (s), f-number and ISO speed of the photo `path`. The last two are None
    if missing or 0; of several ISO speeds the first counts.

    Raises Rejected (NS0777) if the photo or its exposure time cannot be read."""
    try:
        tags = exif_of(path)
        f_number, iso = tags.get(_F_NUMBER), tags.get(_ISO)
        iso = iso[0] if isinstance(iso, tuple) else iso
        return float(tags[_EXPOSURE_TIME]), float(f_number or 0) or None, float(iso or 0) or None
    except Exception as error:  # Pillow's plugins raise what they like
        raise _refused(
            f"the exposure time of '{path}' is missing",
            "give the times in seconds: --times 1/250,1/60",
        ) from error


def _refused(message: str, help_text: str) -> Rejected:
    """Return the error (NS0777) `message` for photos that `--bracket` cannot merge, with
    `help_text`."""
    return rejected(
        "NS0777",
        message,
        notes=("--bracket merges photos of one scene that differ in exposure to linear light",),
        helps=(help_text,),
    )
