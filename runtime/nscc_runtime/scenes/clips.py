"""Read clips: .gif by Pillow, other formats by PyAV."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import partial
from itertools import count
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.diagnostics.diagnostic import Rejected
from nscc_runtime.scenes import picture_size
from nscc_runtime.scenes.errors import damaged
from nscc_runtime.scenes.pages import Note, Pages
from nscc_runtime.scenes.picture_files import quiet, same_size
from nscc_runtime.scenes.picture_size import TRANSFERS, refuse_size

_WEIGHTS = {1: (0.2126, 0.0722), 9: (0.2627, 0.0593), 10: (0.2627, 0.0593)}
"""Weights of red and blue in luma, by the number of the matrix in ITU-T H.273: BT.709, BT.2020."""
_BT_601 = (0.299, 0.114)
_BT_2020_PRIMARIES = 9
_UNSPECIFIED = 2
_HIGH_DEFINITION = 720
"""From this number of rows on, the default matrix is that of BT.709."""
_FULL_RANGE = 2
_UNEVEN = 0.4
"""A time between frames that deviates from the median by more than this fraction is not jitter."""


@dataclass(frozen=True)
class _Timing:
    """Timing of a video's packets. `times`: times of frames in order, in units of `unit_s`.
    `declared`: number of frames in the header (0: none)."""

    times: NDArray[np.int64]
    unit_s: float
    declared: int

    @property
    def step(self) -> float:
        """The median time between frames, in units of `unit_s`; 0 for a single frame."""
        return float(np.median(np.diff(self.times))) if len(self.times) > 1 else 0.0

    @property
    def is_variable(self) -> bool:
        steps = np.diff(self.times)
        return self.step > 0 and bool((np.abs(steps - self.step) > _UNEVEN * self.step).any())


def video_pages(path: Path) -> Pages:
    """Open the frames of a video, uint8 or uint16 (R, C, 3), at equal times.

    Frames of unequal duration are repeated or skipped. A truncated file yields the frames before
    its end. Raises ValueError without frames, and Rejected (NS0734) for large frames."""
    timing = _timing_of(path)
    with _opened(path) as container:
        context = container.streams.video[0].codec_context
        refuse_size(path, context.height, context.width)
        if not context.height * context.width:
            most = picture_size.MOST_PIXELS
            raise ValueError(f"its frames have no size, or more than {most:,} pixels")
        trc, primaries = int(context.color_trc), int(context.color_primaries)
    count, notes = len(timing.times), _notes(timing, primaries)
    if not count:
        raise ValueError("no frame can be decoded")
    if timing.is_variable:
        count = round((timing.times[-1] - timing.times[0]) / timing.step) + 1
    transfer = TRANSFERS.get(trc)
    return Pages(count, partial(_frames, path, timing), transfer, notes)


@contextmanager
def _opened(path: Path) -> Iterator[Any]:
    import av

    # Open a file object, because FFmpeg looks for a protocol in names; files that a playlist
    # names are not opened.
    protocol_options = {"protocol_whitelist": "none"}
    with open(path, "rb") as file, av.open(
        file, container_options=protocol_options, options=_bound()
    ) as container:  # fmt: skip
        yield container


def _bound() -> dict[str, str]:
    """Return the option that makes FFmpeg refuse large frames before allocating memory."""
    return {"max_pixels": str(picture_size.MOST_PIXELS)}


def _timing_of(path: Path) -> _Timing:
    import av

    times: list[int] = []
    with _opened(path) as container:
        if not container.streams.video:
            raise ValueError("it has no video")
        stream = container.streams.video[0]
        unit_s, declared = float(stream.time_base or 1), int(stream.frames)
        try:
            for number, packet in enumerate(container.demux(stream)):
                if packet.size:
                    times.append(number if packet.pts is None else int(packet.pts))
        except av.FFmpegError:
            pass  # keep the packets before the damage
    return _Timing(np.unique(np.array(times, np.int64)), unit_s, declared)


def _notes(timing: _Timing, primaries: int) -> tuple[Note, ...]:
    notes: list[Note] = []
    have = len(timing.times)
    if have < timing.declared:
        notes.append((
            f"is incomplete: it contains {have} of the {timing.declared} frames that its "
                "header declares",
            "copy the file again if you need the other frames",
        ))  # fmt: skip
    if timing.is_variable:
        steps_ms = np.diff(timing.times) * timing.unit_s * 1e3
        rate = 1 / (timing.step * timing.unit_s)
        notes.append((
            f"has a variable frame rate, {steps_ms.min():.4g} to {steps_ms.max():.4g} ms "
            f"per frame: frames are repeated or dropped to get {rate:.4g} per second",
            "record with a constant frame rate if motion matters",
        ))  # fmt: skip
    if primaries == _BT_2020_PRIMARIES:
        text = "names primaries of BT.2020; its luminance is weighted as of Rec. 709"
        notes.append((text, "convert its colours to Rec. 709 primaries if the weights matter"))
    return tuple(notes)


def _frames(path: Path, timing: _Timing) -> Iterator[NDArray[Any]]:
    """Yield the frames at equal times from the first on."""
    if not timing.is_variable:
        yield from (picture for _, picture in _decoded(path))
        return
    at, pending_picture = float(timing.times[0]), None
    for time, picture in _decoded(path):
        # A frame is shown from the grid time nearest to its own time.
        while pending_picture is not None and at + timing.step / 2 <= time:
            yield pending_picture
            at += timing.step
        pending_picture = picture
    if pending_picture is not None:
        yield pending_picture


def _decoded(path: Path) -> Iterator[tuple[int, NDArray[Any]]]:
    """Yield times and pictures until decoding fails. Raises ValueError if there is no picture."""
    import av

    count = 0
    with _opened(path) as container:
        stream = container.streams.video[0]
        stream.thread_type = "AUTO"
        stream.codec_context.options = _bound()
        try:
            for frame in container.decode(stream):
                count += 1
                # The rotation is counter-clockwise.
                upright = np.rot90(picture_of(frame), round(frame.rotation / 90))
                yield int(frame.pts or 0), np.ascontiguousarray(upright)
        except av.FFmpegError as error:
            if not count:
                raise ValueError(str(error)) from error


def picture_of(frame: Any) -> NDArray[Any]:
    """Return red, green and blue (R, C, 3) of a decoded frame, by the matrix and the range that the
    frame names. Values are 0..255 (uint8), or 0..65535 (uint16) for more than 8 bits."""
    bits = frame.format.components[0].bits
    if frame.format.is_rgb or frame.format.name.startswith("pal"):
        return np.asarray(frame.to_ndarray(format="rgb24" if bits <= 8 else "rgb48le"))
    planes = _planes(frame, bits)
    full = int(frame.color_range) == _FULL_RANGE or frame.format.name.startswith("yuvj")
    luma, *chroma = _as_fractions(planes, bits, full)
    if chroma:
        rgb = _red_green_blue(luma, chroma, int(frame.colorspace))
    else:
        rgb = np.repeat(luma[..., None], 3, axis=-1)
    kind = np.uint8 if bits <= 8 else np.uint16
    return np.asarray(np.rint(np.clip(rgb, 0, 1) * np.float32(np.iinfo(kind).max)).astype(kind))


def _planes(frame: Any, bits: int) -> list[NDArray[Any]]:
    """Return luma and, unless the frame is grey, both chromas as stored, each of its own size."""
    grey = frame.format.name.startswith("gray")
    plane_count = 1 if grey else 3
    if len(frame.planes) < plane_count or frame.format.name.endswith("be"):
        full = frame.format.name.startswith("yuvj")
        planar = ("yuvj444p" if full else "yuv444p") if bits <= 8 else f"yuv444p{bits}le"
        frame = frame.reformat(format=planar)
    kind = np.dtype(np.uint8 if bits <= 8 else "<u2")
    return [
        np.frombuffer(plane, kind).reshape(plane.height, -1)[:, : plane.width]
        for plane in frame.planes[:plane_count]
    ]


def _as_fractions(
    planes: Sequence[NDArray[Any]], bits: int, full: bool
) -> list[NDArray[np.float32]]:
    """Return luma 0..1 and chroma -0.5..0.5, from full or limited range."""
    step = 1 << (bits - 8)
    most = (1 << bits) - 1
    luma_black, luma_span = (0, most) if full else (16 * step, 219 * step)
    chroma_span = most if full else 224 * step
    luma, *chroma = (plane.astype(np.float32) for plane in planes)
    middle, scale = np.float32(128 * step), np.float32(chroma_span)
    return [
        (luma - np.float32(luma_black)) / np.float32(luma_span),
        *((chroma_plane - middle) / scale for chroma_plane in chroma),
    ]


def _red_green_blue(
    luma: NDArray[np.float32], chroma: Sequence[NDArray[np.float32]], matrix: int
) -> NDArray[np.float32]:
    import cv2

    size = luma.shape[1], luma.shape[0]
    blue_chroma, red_chroma = (
        chroma_plane if chroma_plane.shape == luma.shape
        else np.asarray(cv2.resize(chroma_plane, size, interpolation=cv2.INTER_LINEAR), np.float32)
        for chroma_plane in chroma
    )  # fmt: skip
    if matrix == _UNSPECIFIED:
        matrix = 1 if len(luma) >= _HIGH_DEFINITION else 0
    red_weight, blue_weight = _WEIGHTS.get(matrix, _BT_601)
    red = luma + 2 * (1 - red_weight) * red_chroma
    blue = luma + 2 * (1 - blue_weight) * blue_chroma
    green = (luma - red_weight * red - blue_weight * blue) / (1 - red_weight - blue_weight)
    return np.stack([red, green, blue], axis=-1)


CLIPS = (".avi", ".gif", ".m4v", ".mkv", ".mov", ".mp4", ".webm")


def open_clip(path: Path) -> Pages:
    """Open the frames of a clip, (R, C, 3) red, green, blue.

    A truncated file yields the frames before its end, with a note. The number of frames of a .gif
    is unknown and given as 0. Raises Rejected (NS0732) if no frame can be decoded."""
    if path.suffix.lower() == ".gif":
        return Pages(0, lambda: _read_gif(path))
    try:
        with quiet():
            pages = video_pages(path)
    except (Rejected, ImportError):
        raise
    except Exception as error:  # PyAV has an exception for each number of FFmpeg
        raise damaged(path, error) from error
    return replace(pages, read=lambda: same_size(_named(path, pages)))


def read_clip(path: Path) -> Iterator[NDArray[Any]]:
    """Yield the frames (R, C, 3) of a clip. Raises Rejected like `open_clip`."""
    return open_clip(path).read()


def _named(path: Path, pages: Pages) -> Iterator[tuple[str, NDArray[Any]]]:
    frames = pages.read()
    for number in count():
        try:
            with quiet():
                frame = next(frames)
        except StopIteration:
            return
        except Exception as error:
            raise damaged(path, error) from error
        yield f"{path}, frame {number}", frame


def _read_gif(path: Path) -> Iterator[NDArray[Any]]:
    """Yield each frame composed with the frames before it."""
    from PIL import Image

    try:
        image = Image.open(path)
    except Exception as error:  # Pillow's plugins raise what they like
        raise damaged(path, error) from error
    with image:
        refuse_size(path, image.height, image.width)
        for number in count():
            try:
                image.seek(number)
                frame = np.asarray(image.convert("RGB"))
            except EOFError:
                return
            except Exception as error:
                raise damaged(path, f"frame {number}: {error}") from error
            yield frame
