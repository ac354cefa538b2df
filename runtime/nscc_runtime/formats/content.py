"""The content of an output file: a picture or a clip of light, and the arrays of the result."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from nscc.arrays import Array, Bools, Bytes, Floats
from nscc.diagnostics.diagnostic import Rejected, rejected
from nscc.words.container import Container
from nscc_runtime.frame_file import Frame, FrameFile
from nscc_runtime.light import Light
from nscc_runtime.pictures.tone import Tone, fitted

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Arrays = Mapping[str, Array]


@dataclass(frozen=True, eq=False)
class Content:
    """The content of an output file, in the form that every file format accepts.

    Attributes
    ----------
    arrays : mapping of str to array
        The arrays of an .npz file. An .npy file contains `main()`, or the first array if None.
    light : array, optional
        A picture (rows, cols) or a clip (T, rows, cols) in `unit`, with a last axis of red, green,
        blue if `colour`. None if the content is neither picture nor clip.
    moving, colour : bool
        Whether `light` is a clip, and whether it has colours.
    codes : array, optional
        Converter codes, uint8, with the shape of `light`. They are shown unless `tone` is set.
    write_npz : callable, optional
        Writes the .npz file if it contains more than `arrays`.
    benchmark : callable, optional
        Returns the arrays of a .mat file.
    tone, usual : str
        The requested tone curve (None if not requested), and the default tone curve.
    white : float, optional
        The light shown as white; None for a percentile.
    picture : callable
        Turns `light` or `codes` of other shapes into a picture. It is called for one frame of a
        clip at a time, because a clip may be larger than memory.
    """

    arrays: Arrays
    light: Array | None = None
    moving: bool = False
    colour: bool = False
    codes: Bytes | None = None
    write_npz: Callable[[Any], object] | None = None
    main: Callable[[], Array] | None = None
    benchmark: Callable[[], Arrays] | None = None
    tone: str | None = None
    usual: str = "log"
    white: float | None = None
    unit: str = "e"
    picture: Callable[[Array], Array] = np.asarray

    @cached_property
    def shown_by(self) -> Tone | None:
        """The tone curve with which `shown` displays the light; None if converter codes are shown,
        or if there is no light."""
        if self.light is None or (self.codes is not None and self.tone is None):
            return None
        # One curve for all frames: with a curve each, a clip would flicker.
        light = np.stack([*self.pictures]) if self.moving else self.picture(self.light)
        return fitted(self.tone or self.usual, light, self.white)

    @property
    def pictures(self) -> Iterator[Array]:
        """The light as an iterator of pictures: the frames of a clip, or one picture."""
        return self._pictures(self.light)

    @property
    def shown(self) -> Iterator[Bytes]:
        """The pictures for display (uint8) as an iterator, after the tone curve."""
        tone = self.shown_by
        return self._pictures(self.codes) if tone is None else map(tone, self.pictures)

    def _pictures(self, values: Array | None) -> Iterator[Array]:
        """Yield the pictures of a clip `values`, or the one of a still. `values` must not be
        None."""
        assert values is not None  # `lacks` refuses content without light
        return map(self.picture, values if self.moving else [values])

    @property
    def tone_text(self) -> str:
        """The tone curve and its white level as text."""
        tone = self.shown_by
        if tone is None:
            return "codes as read out"
        return f"{tone.name}, white {tone.white:.4g}{f' {self.unit}' if self.unit else ''}"

    def lacks(self, kinds: str) -> str | None:
        """Return the reason why a format that holds `kinds` cannot hold the content; None if it
        can. `kinds` is a text of "picture", "clip" or "arrays", or of several separated by
        commas."""
        if "arrays" in kinds:
            return None
        if self.light is None:
            return "this is neither a picture nor a clip"
        if self.moving and "clip" not in kinds:
            return "this is a clip"
        if not self.moving and "picture" not in kinds:
            return "this is a single picture"
        return None


_TOP = 255.0
"""White level in the clips of the benchmark of snapshot compressive imaging."""
_WHOLE = 1e-3
"""Tolerance for values that were whole numbers before conversion to electrons."""


def frame_content(
    file: FrameFile,
    container: Container,
    light: Light | None,
    shutters: Callable[[], Bools],
    tone: str | None = None,
) -> Content:
    """Return the content of the frame file `file` of the program `container`.

    Pictures of linear light contain electrons, other pictures the converter codes. Buckets are side
    by side, or the images, planes and buckets that the program reads. Frames of --repeat make a
    clip, three colours a colour picture. `light`: the scene of a .mat file, None if unknown.
    `shutters` returns the distinct shutters bool (shutters, buckets, N) of the container (a
    compiled program). `tone`: the requested tone curve, None for the converter codes as read out.
    """
    frame, colour = file.frame, "colours" in file.meta
    codes, electrons = _read_out(frame, container)
    return Content(
        {"frame": codes},
        electrons,
        moving=frame.frame.ndim == 4 and not colour,
        colour=colour,
        codes=codes,
        write_npz=file.write,
        benchmark=lambda: benchmark_arrays(container, shutters(), frame.exposure_e, light, colour),
        tone=tone,
        usual="linear",
        picture=_picture,
    )


def _read_out(frame: Frame, container: Container) -> tuple[Bytes, Floats | None]:
    """Return converter codes and electrons, (.., reads, rows, cols) each, of everything that the
    program `container` reads out in `frame`. There are no electrons if only reports are read.

    The first axis, of repeated frames or colours, may be missing. A 1 of a plane is the code 255
    and one electron."""
    if container.reads == container.buckets:
        return frame.frame, frame.exposure_e
    if not container.reads:
        return frame.frame, None
    codes, electrons = [], []
    for name in container.reads:
        if name in container.buckets_read:
            index = container.buckets_read.index(name)
            codes.append(frame.frame[..., index, :, :])
            electrons.append(frame.exposure_e[..., index, :, :])
        elif name in container.pictures.planes:
            bits = frame.told[f"plane_{name}"]
            codes.append(bits * np.uint8(255))
            electrons.append(bits.astype(np.float64))
        else:
            codes.append(frame.told[f"image_codes_{name}"])
            electrons.append(frame.told[f"image_{name}"])
    return np.stack(codes, axis=-3), np.stack(electrons, axis=-3)


def _picture(values: Array) -> Array:
    """Return `values` (buckets, rows, cols) as a picture (rows, buckets * cols), with 0 for values
    that are not finite. A leading axis of three colours becomes the last axis."""
    side = np.concatenate(np.moveaxis(values, -3, 0), axis=-1)
    np.copyto(side, 0, where=~np.isfinite(side))
    return np.moveaxis(side, 0, -1) if side.ndim == 3 else side


def benchmark_arrays(
    container: Container,
    shutters: Bools,
    exposure_e: Floats,
    light: Light | None,
    colour: bool = False,
) -> Arrays:
    """Return the arrays of a .mat file: `mask` (H, W, T), `meas` (H, W, K) and, for a known scene,
    `orig` (H, W, T * K).

    K is the number of frames. `shutters` bool (shutters, buckets, N) are the distinct shutters of
    `container`, `exposure_e` (K, buckets, rows, cols), or without K, the electrons of the frames,
    and `light` is the scene, None if unknown. `colour`: whether the first axis is colours. As in
    the benchmark 255 is white, and without effects meas = sum(mask * orig). `white_e` (1, 1):
    electrons per slot of white. For a clip it is the clip's white level, or its brightest value if
    larger; for an unknown scene it is the full well divided by T. Raises Rejected (NS0786) for
    several buckets or colours, which the benchmark does not support."""
    exposures = exposure_e if exposure_e.ndim == 4 else exposure_e[None]
    if colour or exposures.shape[1] != 1:
        raise _one_bucket()
    clip = None if light is None else light.dense()
    assert container.pixel_codes is not None  # only such programs are exposed
    lanes = container.table.shutter_of_code[container.pixel_codes]
    if light is None or clip is None:
        white_e = container.target.full_well_e / container.slots
    else:
        white_e = float(clip.max()) or 1.0
        if light.kind == "clip" and white_e <= light.exposure_scale_e:
            white_e = light.exposure_scale_e
    arrays: dict[str, Array] = {
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
    """Return the content of `nscc shutters`. `arrays` are those of its .npz file, with the packed
    bits `shutter` and their shape. A .mat file contains `mask` (rows, cols, T), an .npy file
    (buckets, rows, cols, T), both of 0 and 1. Writing a .mat of several buckets raises Rejected
    (NS0786)."""

    def mask() -> Arrays:
        """Return the array `mask` (rows, cols, T) for formats with one bucket. Raises Rejected
        (NS0786) for several."""
        if len(arrays["shutter"]) > 1:
            raise _one_bucket()
        return {"mask": _opened(arrays)[0]}

    return Content(arrays, benchmark=mask, main=lambda: _opened(arrays))


def mask_content(arrays: Arrays, bucket: int | None) -> Content:
    """Return the content of `nscc export-mask`: the shutters of one bucket, uint8 (rows, cols,
    slots) of 0 and 1, or of all (buckets, rows, cols, slots).

    `bucket` is the number of the bucket; None for the only one, or for all if there are several.
    `arrays` are those of `nscc shutters`, with the packed bits `shutter` and their shape."""
    opened = _opened(arrays)
    if bucket is None and len(opened) == 1:
        bucket = 0
    return Content({"mask": opened if bucket is None else opened[bucket]})


def _opened(arrays: Arrays) -> Bytes:
    """Return the shutters of all pixels, (buckets, rows, cols, slots) of 0 and 1. `arrays` has them
    as packed bits in `shutter`, the first in the lowest bit, and their shape in `shutter_shape`."""
    count = int(arrays["shutter_shape"][3])
    return np.unpackbits(arrays["shutter"], axis=-1, count=count, bitorder="little")


def _one_bucket() -> Rejected:
    """Return the error (NS0786) that a .mat file holds only one bucket of one colour."""
    return rejected(
        "NS0786",
        "a .mat of snapshot compressive imaging contains one bucket of one colour",
        notes=("mask is (H, W, T), meas (H, W, K), orig (H, W, T * K)",),
        helps=("write an .npz: it contains all data",),
    )


_COLUMNS, _MOST = 4, 16
"""Number of frames side by side on a sheet, and of all frames."""


def content_sheet(content: Content, title: str) -> Figure:
    """Return a sheet of the picture of `content`, or of up to sixteen frames of its clip at even
    distances, under `title`. A note at the first one names the tone curve."""
    from nscc_runtime.pictures.images import Image, image_sheet

    shown = [*content.shown]
    numbers = np.unique(np.linspace(0, len(shown) - 1, min(_MOST, len(shown))).round().astype(int))
    images = [
        Image(shown[k], f"frame {k}" if content.moving else "", content.tone_text if k == 0 else "")
        for k in numbers
    ]
    rows = [images[k : k + _COLUMNS] for k in range(0, len(images), _COLUMNS)]
    return image_sheet(rows, title)
