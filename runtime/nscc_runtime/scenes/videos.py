"""Read videos by PyAV."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from fractions import Fraction
from itertools import islice
from pathlib import Path
from typing import Any

import numpy as np

from nscc.arrays import Array, Floats, Floats32, Ints
from nscc_runtime.scenes import pages as limits
from nscc_runtime.scenes.file_colours import of_numbers
from nscc_runtime.scenes.pages import Note, Pages

_WEIGHTS = {1: (0.2126, 0.0722), 9: (0.2627, 0.0593), 10: (0.2627, 0.0593)}
"""Weights of red and blue in luma, by the number of the matrix in ITU-T H.273: BT.709, BT.2020."""
_BT_601 = (0.299, 0.114)
"""Weights of red and blue in luma for all other numbers."""
_UNSPECIFIED = 2
_HIGH_DEFINITION = 720
"""From this number of rows on, the default matrix is that of BT.709."""
_STATED_RANGE, _FULL_RANGE = (1, 2), 2
"""FFmpeg's numbers of ranges: 1 limited, 2 full; 0 is unspecified."""


@dataclass(frozen=True)
class _Timing:
    """Timing of a video's packets.

    `times`: start times of frames in ascending order, in units of `unit_s` seconds. `last`: the
    duration of the last frame in these units, 0 if the file does not state it. `declared`: number
    of frames in the header (0: none)."""

    times: Ints
    last: int
    unit_s: float
    declared: int

    def durations_s(self) -> Floats:
        """Return how long each frame is shown (s).

        The last duration is replaced by the median of the others unless it lies between the
        shortest and the longest of them. An only frame lasts one unit."""
        steps = np.diff(self.times)
        usual = int(np.median(steps)) if len(steps) else 1
        # Many files state a last duration that ends with the sound.
        last = self.last if len(steps) and steps.min() <= self.last <= steps.max() else usual
        return np.append(steps, last) * self.unit_s


def video_pages(path: Path) -> Pages:
    """Open the frames of the video `path`, uint8 or uint16 (R, C, 3), with their times.

    Of several video streams in the file, the stream marked as the default is opened. A cover (an
    attached picture) is never opened. A truncated file yields the frames before its end. Raises
    ValueError without frames, or for frames of more than MOST_PIXELS, which FFmpeg does not decode;
    ImportError without PyAV; FFmpeg's errors for other files."""
    import av

    # The times of all frames are read first, without decoding pictures.
    timing = _timing_of(path)
    if not len(timing.times):
        raise ValueError("no frame can be decoded")
    with _opened(path) as (container, stream):
        context = stream.codec_context
        if not context.height * context.width:
            most = limits.MOST_PIXELS
            raise ValueError(f"its frames have no size, or more than {most:,} pixels")
        stated = of_numbers(int(context.color_primaries), int(context.color_trc))
        pixel = Fraction(stream.sample_aspect_ratio or 1)
        interlaced = False
        with suppress(av.FFmpegError):  # frames after a damaged first one may be intact
            context.options = _bound()
            interlaced = any(f.interlaced_frame for f in islice(container.decode(stream), 1))
        notes = _notes(timing, interlaced, pixel)
        size = (context.height, _square_cols(context.width, pixel))
    return Pages(
        (size,),
        len(timing.times),
        lambda: _frames(path, pixel),
        stated,
        notes,
        durations_s=timing.durations_s,
        is_clip=True,
    )


@contextmanager
def _opened(path: Path) -> Iterator[tuple[Any, Any]]:
    """Open the video `path` for a with block, and yield PyAV's container and the video stream to
    read: the stream marked as the default, else the first that is not a cover (an attached
    picture).

    Files that the video names are never opened. Raises ValueError without such a stream, and
    FFmpeg's errors."""
    import av

    # Open a file object, because FFmpeg looks for a protocol in names; files that a playlist
    # names are not opened.
    protocol_options = {"protocol_whitelist": "none"}
    with (
        open(path, "rb") as file,
        av.open(file, container_options=protocol_options, options=_bound()) as container,
    ):
        marks = av.stream.Disposition
        films = [s for s in container.streams.video if not s.disposition & marks.attached_pic]
        usual = [stream for stream in films if stream.disposition & marks.default]
        if not films:
            raise ValueError("it has no video")
        yield container, (usual or films)[0]


def _bound() -> dict[str, str]:
    """Return the option that makes FFmpeg refuse large frames before allocating memory."""
    return {"max_pixels": str(limits.MOST_PIXELS)}


def _timing_of(path: Path) -> _Timing:
    """Return the times of all frames of the video `path` from its packets, without decoding.
    Packets after damage do not count; `times` may be empty."""
    import av

    packets: dict[int, int] = {}
    with _opened(path) as (container, stream):
        unit_s, declared = float(stream.time_base or 1), int(stream.frames)
        try:
            for number, packet in enumerate(container.demux(stream)):
                if packet.size:
                    # Without a time, frames are numbered.
                    time = number if packet.pts is None else int(packet.pts)
                    packets[time] = int(packet.duration or 0)
        except av.FFmpegError:
            pass  # keep the packets before the damage
    times = np.array(sorted(packets), np.int64)
    return _Timing(times, packets[int(times[-1])] if len(times) else 0, unit_s, declared)


def _square_cols(cols: int, pixel: Fraction) -> int:
    """Return the number of columns, 1 or more, of a frame of `cols` columns after its pixels were
    made square. `pixel` is their width over their height."""
    return max(1, round(cols * pixel))


def _notes(timing: _Timing, interlaced: bool, pixel: Fraction) -> tuple[Note, ...]:
    """Return notes on what is unusual about a video, () if nothing is. `timing` shows missing
    frames, `interlaced` says that rows come from two moments, and `pixel` is the width of a pixel
    over its height."""
    have = len(timing.times)
    notes = (
        (
            have < timing.declared,
            f"is incomplete: it contains {have} of the {timing.declared} frames that its header "
            "declares",
            "copy the file again if you need the other frames",
        ),
        (
            interlaced,
            "is interlaced: even and odd rows of a frame come from two moments",
            "convert it to progressive frames, for instance with FFmpeg's filter bwdif",
        ),
        (
            pixel != 1,
            f"has pixels of width to height {pixel.numerator}:{pixel.denominator}: its columns are "
            "resampled to square pixels",
            "convert it to square pixels if you want another filter",
        ),
    )
    return tuple((text, remedy) for applies, text, remedy in notes if applies)


def _frames(path: Path, pixel: Fraction) -> Iterator[Array]:
    """Yield the pictures (R, C, 3) of the video `path` until decoding fails, rotated as it says.

    `pixel` is the width of a pixel over its height; columns are resampled to square pixels. Raises
    ValueError if not even the first picture can be decoded."""
    import av
    import cv2

    count = 0
    with _opened(path) as (container, stream):
        stream.thread_type = "AUTO"
        stream.codec_context.options = _bound()
        try:
            for frame in container.decode(stream):
                count += 1
                picture = picture_of(frame)
                if pixel != 1:
                    size = (_square_cols(frame.width, pixel), frame.height)
                    filter_ = cv2.INTER_LINEAR if pixel > 1 else cv2.INTER_AREA
                    picture = np.asarray(cv2.resize(picture, size, interpolation=filter_))
                # The rotation is counter-clockwise.
                yield np.ascontiguousarray(np.rot90(picture, round(frame.rotation / 90)))
        except av.FFmpegError as error:
            if not count:
                raise ValueError(str(error)) from error


def picture_of(frame: Any) -> Array:
    """Return red, green and blue (R, C, 3) of `frame`, a decoded frame of PyAV.

    The frame names the matrix that converts luma and chroma to colours, and the range of its
    samples. Values are 0..255 (uint8), or 0..65535 (uint16) for more than 8 bits."""
    bits = frame.format.components[0].bits
    if frame.format.is_rgb or frame.format.name.startswith("pal"):
        return np.asarray(frame.to_ndarray(format="rgb24" if bits <= 8 else "rgb48le"))
    planes = _planes(frame, bits)
    full = int(frame.color_range) == _FULL_RANGE or frame.format.name.startswith("yuvj")
    # Grey video comes from cameras and tools that use the full range, unless it states another.
    full |= len(planes) == 1 and int(frame.color_range) not in _STATED_RANGE
    luma, *chroma = _as_fractions(planes, bits, full)
    if chroma:
        rgb = _red_green_blue(luma, chroma, int(frame.colorspace))
    else:
        rgb = np.repeat(luma[..., None], 3, axis=-1)
    kind = np.uint8 if bits <= 8 else np.uint16
    return np.rint(np.clip(rgb, 0, 1) * np.iinfo(kind).max).astype(kind)


def _planes(frame: Any, bits: int) -> list[Array]:
    """Return luma and, unless the frame is grey, both chromas (blue, red), each (rows, cols).
    FFmpeg enlarges chroma of lower resolution, and separates interleaved samples; their range
    stays. `bits` is the number of bits of a sample."""
    grey = frame.format.name.startswith("gray")
    # FFmpeg marks the full range of 8 bits by the letter j.
    full = "j" * frame.format.name.startswith("yuvj")
    form = "gray" if grey else f"yuv{full}444p"
    planar = frame.reformat(format=form if bits <= 8 else f"{form}{bits}le")
    kind = np.dtype(np.uint8 if bits <= 8 else "<u2")
    return [
        np.frombuffer(plane, kind).reshape(plane.height, -1)[:, : plane.width]
        for plane in planar.planes[: 1 if grey else 3]
    ]


def _as_fractions(planes: Sequence[Array], bits: int, full: bool) -> list[Array]:
    """Return luma 0..1 and chroma -0.5..0.5 of `planes`, as float32: luma, then no or two chromas,
    each (rows, cols). `bits` is the number of bits of a sample. `full`: whether samples use the
    full range, not the limited one of television."""
    # The limited range is 16 to 235 for luma and 16 to 240 for chroma in 8 bits, and these numbers
    # times `step` in more.
    step = 1 << (bits - 8)
    most = (1 << bits) - 1
    luma_black, luma_span = (0, most) if full else (16 * step, 219 * step)
    chroma_span = most if full else 224 * step
    luma, *chroma = (plane.astype(np.float32) for plane in planes)
    return [
        (luma - luma_black) / luma_span,
        *((chroma_plane - 128 * step) / chroma_span for chroma_plane in chroma),
    ]


def _red_green_blue(luma: Floats32, chroma: Sequence[Floats32], matrix: int) -> Floats32:
    """Return red, green and blue (rows, cols, 3) of `luma` (rows, cols), 0..1, and `chroma`, blue
    and red, each (rows, cols), -0.5..0.5.

    `matrix` is the number of the colour matrix (ITU-T H.273). If it is unspecified, that of BT.709
    is used from 720 rows on, else that of BT.601."""
    blue_chroma, red_chroma = chroma
    if matrix == _UNSPECIFIED:
        matrix = 1 if len(luma) >= _HIGH_DEFINITION else 0
    red_weight, blue_weight = _WEIGHTS.get(matrix, _BT_601)
    red = luma + 2 * (1 - red_weight) * red_chroma
    blue = luma + 2 * (1 - blue_weight) * blue_chroma
    green = (luma - red_weight * red - blue_weight * blue) / (1 - red_weight - blue_weight)
    return np.stack([red, green, blue], axis=-1)
