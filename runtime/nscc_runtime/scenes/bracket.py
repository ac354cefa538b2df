"""A bracket of photos, each of another exposure, merged to linear light of a high range."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from glob import glob
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.diagnostics.diagnostic import Rejected
from nscc.diagnostics.rejection import rejected
from nscc.files import reads
from nscc_runtime.scenes.colour import srgb_to_linear
from nscc_runtime.scenes.picture_files import files_of, read_folder

_EXIF_IFD, _EXPOSURE_TIME, _F_NUMBER, _ISO = 0x8769, 0x829A, 0x829D, 0x8827


def parse_times(text: str) -> tuple[float, ...]:
    """Exposure times in seconds, `1/250,1/60,0.066`; NS0777 for anything else."""
    try:
        times = tuple(float(Fraction(part.strip())) for part in text.split(","))
    except (ValueError, ZeroDivisionError):
        times = ()
    if not times or not all(0 < time < np.inf for time in times):
        raise _refused(
            f"'{text[:60]}' are no exposure times", "for instance --times 1/250,1/60,1/15"
        )
    return times


def bracket_files(spec: str) -> list[Path]:
    """The photos of a folder, or those that a pattern such as `b/*.jpg` names, in order."""
    path = Path(spec)
    files = files_of(path, skip=True) if path.is_dir() else [Path(p) for p in sorted(glob(spec))]
    if len(files) < 2:
        text = f"'{spec[:200]}' names too few photos, {len(files)}: a bracket has two at least"
        raise _refused(text, "name a folder, or a pattern in quotes: --scene 'b/*.jpg' --bracket")
    return files


def merged_bracket(files: Sequence[Path], times: Sequence[float] | None) -> NDArray[np.float32]:
    """Merge photos to linear light (R, C, 3), by the method of Debevec and Malik in OpenCV with the
    sRGB curve as the camera's response.

    Parameters
    ----------
    files : sequence of Path
        Photos of 8 bits a sample, of one size.
    times : sequence of float, optional
        Exposure times in seconds; without them those of the photos' EXIF, each times its ISO speed
        over the square of its f-number.

    Raises
    ------
    Rejected
        NS0777 for photos without exposure times, of more bits, or all of one time; as
        `read_folder`.
    """
    import cv2

    reads(*files)
    exposures = [*times] if times is not None else [_exif_exposure(path) for path in files]
    if len(exposures) != len(files):
        text = f"{len(files)} photos and {len(exposures)} exposure times do not go together"
        raise _refused(text, "give one time a photo, in the order of their names")
    if len(set(exposures)) == 1:
        raise _refused("all photos have the same exposure", "a bracket has several; see --times")
    photos = [*read_folder([*files])]
    deep = [path.name for path, photo in zip(files, photos, strict=True) if photo.dtype != np.uint8]
    if deep:
        text = f"'{deep[0]}' has {photos[0].dtype} samples, and brackets of 8 bits are merged"
        raise _refused(text, "develop the photos to .jpg or .png of 8 bits, by one setting")
    response = srgb_to_linear(np.arange(256) / 255.0)
    response[0] = response[1] / 2  # its logarithm is taken
    curve = np.repeat(response.astype(np.float32)[:, None, None], 3, axis=2)
    merge = cv2.createMergeDebevec()
    pictures = [np.ascontiguousarray(_in_three(photo)) for photo in photos]
    seconds = np.array(exposures, np.float32)
    return np.asarray(merge.process(pictures, seconds, curve), np.float32)


def _in_three(photo: NDArray[Any]) -> NDArray[Any]:
    return photo if photo.ndim == 3 else np.repeat(photo[..., None], 3, axis=-1)


def _exif_exposure(path: Path) -> float:
    """Exposure time, times ISO speed over the square of the f-number where these are noted."""
    from PIL import Image

    try:
        with Image.open(path) as image:
            exif = image.getexif().get_ifd(_EXIF_IFD)
        time_s, iso = float(exif[_EXPOSURE_TIME]), float(exif.get(_ISO) or 100)
        exposure = time_s * iso / 100 / float(exif.get(_F_NUMBER) or 1) ** 2
    except Exception as error:  # Pillow's plugins raise what they like
        raise _refused(
            f"'{path}' does not say its exposure time",
            "give the times in seconds: --times 1/250,1/60",
        ) from error
    if not 0 < exposure < np.inf:
        raise _refused(
            f"the exposure of '{path}' is {exposure:g}", "give the times: --times 1/250,.."
        )
    return exposure


def _refused(message: str, help_text: str) -> Rejected:
    return rejected(
        "NS0777",
        message,
        notes=("--bracket merges photos of one scene that differ in exposure to linear light",),
        helps=(help_text,),
    )
