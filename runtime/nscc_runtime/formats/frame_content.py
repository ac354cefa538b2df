"""The content of frames and shutters for file formats, including the arrays of snapshot compressive
imaging."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.diagnostics.diagnostic import Rejected
from nscc.diagnostics.rejection import rejected
from nscc.words.container import Container
from nscc_runtime.formats.content import Arrays, Content
from nscc_runtime.frame_file import Frame, FrameFile
from nscc_runtime.light import Light

_TOP = 255.0
"""White level in the benchmark's clips."""
_WHOLE = 1e-3
"""Tolerance for values that were whole numbers before conversion to electrons."""


def frame_content(
    file: FrameFile, container: Container, light: Light | None,
    shutters: Callable[[], NDArray[np.bool_]], tone: str | None = None,
) -> Content:  # fmt: skip
    """Return the content of a frame file.

    Pictures of linear light contain electrons, other pictures the codes. Buckets are side by side,
    or the images, planes and buckets that the program reads. Frames of --repeat make a clip, three
    colours a colour picture. `shutters` returns the distinct shutters bool (shutters, buckets, N)
    of the container."""
    frame, colour = file.frame, "colours" in file.meta
    codes, electrons = _read_out(frame, container)
    return Content(
        {"frame": codes}, electrons, moving=frame.frame.ndim == 4 and not colour,
        colour=colour, codes=codes, write_npz=file.write,
        benchmark=lambda: benchmark_arrays(container, shutters(), frame.exposure_e, light, colour),
        tone=tone, usual="linear", picture=_picture,
    )  # fmt: skip


def _read_out(
    frame: Frame, container: Container
) -> tuple[NDArray[np.uint8], NDArray[np.float64] | None]:
    """Return codes and electrons (.., reads, rows, cols); no electrons if only reports are read.

    A 1 of a plane is the code 255 and one electron."""
    pictures = container.pictures
    if pictures is None:
        return frame.frame, frame.exposure_e
    if not pictures.reads:
        return frame.frame, None
    codes, electrons = [], []
    for name in pictures.reads:
        if name in container.buckets_read:
            index = container.buckets_read.index(name)
            codes.append(frame.frame[..., index, :, :])
            electrons.append(frame.exposure_e[..., index, :, :])
        elif name in pictures.planes:
            bits = frame.told[f"plane_{name}"]
            codes.append(bits * np.uint8(255))
            electrons.append(bits.astype(np.float64))
        else:
            codes.append(frame.told[f"image_codes_{name}"])
            electrons.append(frame.told[f"image_{name}"])
    return np.stack(codes, axis=-3), np.stack(electrons, axis=-3)


def _picture(values: NDArray[Any]) -> NDArray[Any]:
    """Reshape (buckets, rows, cols) to (rows, buckets * cols), with 0 for values that are not
    finite. A leading axis of colours becomes the last axis."""
    side = np.concatenate(np.moveaxis(values, -3, 0), axis=-1)
    np.copyto(side, 0, where=~np.isfinite(side))
    return np.moveaxis(side, 0, -1) if side.ndim == 3 else side


def benchmark_arrays(
    container: Container, shutters: NDArray[np.bool_], exposure_e: NDArray[np.float64],
    light: Light | None, colour: bool = False,
) -> Arrays:  # fmt: skip
    """Return `mask` (H, W, T), `meas` (H, W, K) and, for a known scene, `orig` (H, W, T * K).

    K is the number of frames. As in the benchmark 255 is white, and without effects meas = sum(mask
    * orig). `white_e` (1, 1): electrons per slot of white. For a clip it is the clip's white level,
    or its brightest value if larger; for an unknown scene it is the full well divided by T. Raises
    Rejected (NS0786) for several buckets or colours, which the benchmark does not support."""
    exposures = exposure_e if exposure_e.ndim == 4 else exposure_e[None]
    if colour or exposures.shape[1] != 1:
        raise _one_bucket()
    clip = None if light is None else light.dense()
    assert container.pixel_codes is not None  # only such programs are exposed
    lanes = container.table.shutter_of_code[container.pixel_codes]
    white_e = _white_e(container, light, clip)
    arrays: dict[str, NDArray[Any]] = {
        "mask": np.asarray(shutters[:, 0][lanes], np.uint8),
        "meas": np.moveaxis(exposures[:, 0], 0, -1) * (_TOP / white_e),
        "white_e": np.array([[white_e]]),
    }
    if clip is not None:
        orig = np.moveaxis(clip, 0, -1) * (_TOP / white_e)
        rounded = np.rint(orig)
        integral = rounded.max() <= _TOP and bool((np.abs(orig - rounded) < _WHOLE).all())
        arrays["orig"] = np.tile(rounded.astype(np.uint8) if integral else orig, len(exposures))
    return arrays


def shutter_content(arrays: Arrays) -> Content:
    """Return the content of `nscc shutters`. A .mat file contains `mask` (rows, cols, T), an .npy
    file (buckets, rows, cols, T), both of 0 and 1."""
    count = int(arrays["shutter_shape"][3])

    def opened() -> NDArray[np.uint8]:
        return np.unpackbits(arrays["shutter"], axis=-1, count=count, bitorder="little")

    def mask() -> Arrays:
        if len(arrays["shutter"]) > 1:
            raise _one_bucket()
        return {"mask": opened()[0]}

    return Content(arrays, benchmark=mask, main=opened)


def _one_bucket() -> Rejected:
    return rejected(
        "NS0786",
        "a .mat of snapshot compressive imaging contains one bucket of one colour",
        notes=("mask is (H, W, T), meas (H, W, K), orig (H, W, T * K)",),
        helps=("write an .npz: it contains all data",),
    )


def _white_e(container: Container, light: Light | None, clip: NDArray[np.float32] | None) -> float:
    if light is None or clip is None:
        return container.target.full_well_e / container.slots
    top = float(clip.max()) or 1.0
    return light.exposure_scale_e if light.kind == "clip" and top <= light.exposure_scale_e else top
