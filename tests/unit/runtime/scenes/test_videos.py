"""Videos: bits, ranges, matrices, curves, rotation, times and truncation, against known values."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from one_scene import load_scene

from nscc.diagnostics.diagnostic import Diagnostic, Rejected
from nscc_runtime.scenes import ExposureLevel
from nscc_runtime.scenes.picture_files import open_pages, read_frames
from nscc_runtime.scenes.timing import timed

av = pytest.importorskip("av")
ROWS, COLS = 32, 64
NUMBERS = {"601": 5, "709": 1, "2020": 9}
WEIGHTS = {"601": (0.299, 0.114), "709": (0.2126, 0.0722), "2020": (0.2627, 0.0593)}


def write(
    path: Path,
    planes: list[list[np.ndarray]],
    form: str = "yuv444p",
    matrix: int = 2,
    limited: bool = True,
    curve: int = 2,
    times: list[int] | None = None,
    codec: str = "ffv1",
) -> None:
    """A lossless video of frames given as planes; `times` are in milliseconds."""
    with av.open(str(path), "w") as container:
        stream = container.add_stream(codec, rate=25)
        stream.width, stream.height, stream.pix_fmt = COLS, ROWS, form
        context = stream.codec_context
        context.time_base = Fraction(1, 1000)
        context.colorspace, context.color_trc = matrix, curve
        context.color_range = 1 if limited else 2
        for number, parts in enumerate(planes):
            frame = av.VideoFrame(COLS, ROWS, form)
            frame.colorspace, frame.color_range = matrix, 1 if limited else 2
            for plane, values in zip(frame.planes, parts, strict=True):
                item = values.dtype.itemsize
                lines = np.zeros((plane.height, plane.line_size // item), values.dtype)
                lines[:, : plane.width] = values
                plane.update(lines.tobytes())
            frame.pts = 40 * number if times is None else times[number]
            frame.time_base = Fraction(1, 1000)
            for packet in stream.encode(frame):
                container.mux(packet)
        for packet in stream.encode():
            container.mux(packet)


def grey(value: int, dtype: Any = np.uint8, middle: int = 128) -> list[np.ndarray]:
    chroma = np.full((ROWS, COLS), middle, dtype)
    return [np.full((ROWS, COLS), value, dtype), chroma, chroma]


def frames_of(path: Path) -> list[np.ndarray]:
    return [*open_pages(path).read()]


@pytest.mark.parametrize("matrix", NUMBERS)
@pytest.mark.parametrize("limited", [True, False])
@pytest.mark.parametrize("bits", [8, 10, 12])
def test_videos_of_every_matrix_range_and_depth_are_decoded(
    tmp_path: Path, matrix: str, limited: bool, bits: int
) -> None:
    """The colours are coded with the formulas of the recommendations; decoding returns them."""
    rgb = np.random.default_rng(0).random((ROWS, COLS, 3))
    red, blue = WEIGHTS[matrix]
    luma = red * rgb[..., 0] + (1 - red - blue) * rgb[..., 1] + blue * rgb[..., 2]
    chroma = [
        (rgb[..., 2] - luma) / (2 * (1 - blue)),
        (rgb[..., 0] - luma) / (2 * (1 - red)),
    ]
    step, most = 1 << (bits - 8), (1 << bits) - 1
    black, luma_span, chroma_span = (
        (16 * step, 219 * step, 224 * step) if limited else (0, most, most)
    )
    dtype = np.uint8 if bits == 8 else np.dtype("<u2")
    planes = [
        np.clip(np.rint(values), 0, most).astype(dtype)
        for values in (luma * luma_span + black, *(c * chroma_span + 128 * step for c in chroma))
    ]
    form = "yuv444p" if bits == 8 else f"yuv444p{bits}le"
    write(tmp_path / "v.mkv", [planes], form, NUMBERS[matrix], limited)
    (found,) = frames_of(tmp_path / "v.mkv")
    assert found.dtype == (np.uint8 if bits == 8 else np.uint16)
    white = np.iinfo(found.dtype).max
    np.testing.assert_allclose(found / white, rgb, atol=2.5 / most + 0.5 / white)


def test_subsampled_chroma_gives_one_colour_in_a_flat_frame(tmp_path: Path) -> None:
    small = np.full((ROWS // 2, COLS // 2), 90, np.uint8)
    planes = [np.full((ROWS, COLS), 120, np.uint8), small, small]
    write(tmp_path / "v.mkv", [planes], "yuv420p", 1)
    (found,) = frames_of(tmp_path / "v.mkv")
    y, c = (120 - 16) / 219, (90 - 128) / 224
    red, blue = y + 2 * (1 - 0.2126) * c, y + 2 * (1 - 0.0722) * c
    green = (y - 0.2126 * red - 0.0722 * blue) / 0.7152
    expected = np.clip([red, green, blue], 0, 1) * 255
    np.testing.assert_allclose(found[5, 7], expected, atol=0.51)
    assert (found == found[0, 0]).all()


@pytest.mark.parametrize(("curve", "name"), [(18, "hlg"), (16, "pq"), (8, "linear"), (1, "srgb")])
def test_light_of_a_ramp_in_10_bits_increases_up_to_its_end_for_every_curve(
    tmp_path: Path, curve: int, name: str
) -> None:
    """The ramp goes from black to white. The light increases from each column to the next."""
    codes = np.linspace(64, 940, COLS).round().astype("<u2")
    luma = np.tile(codes, (ROWS, 1))
    middle = np.full((ROWS, COLS), 512, "<u2")
    write(tmp_path / "v.mkv", [[luma, middle, middle]], "yuv444p10le", 9, True, curve)
    assert open_pages(tmp_path / "v.mkv").colours.transfer == name
    light = load_scene(
        str(tmp_path / "v.mkv"),
        slot_us=(10.0,),
        rows=ROWS,
        cols=COLS,
        exposure=ExposureLevel(1.0, 100.0),
    ).dense()[0, 0]
    assert (np.diff(light) > 0).all()
    assert light[0] == 0
    assert light[-1] == pytest.approx(1)
    half = (codes[COLS // 2] - 64) / 876
    inverse = {
        "hlg": (np.exp((half - 0.55991073) / 0.17883277) + 0.28466892) / 12,
        "srgb": ((half + 0.055) / 1.055) ** 2.4,
        "linear": half,
    }
    if name in inverse:
        assert light[COLS // 2] == pytest.approx(inverse[name], rel=1e-3)


@pytest.mark.parametrize("quarters", [1, 2, 3])
def test_videos_are_turned_as_their_file_states(tmp_path: Path, quarters: int) -> None:
    """The matrix of an .mp4's track states the number of quarter turns with the clock, as
    telephones write it. OpenCV gives the expected frame."""
    import cv2

    luma = np.random.default_rng(0).integers(16, 235, (ROWS, COLS)).astype(np.uint8)
    luma[: ROWS // 2, : COLS // 2] = 235
    half = np.full((ROWS // 2, COLS // 2), 128, np.uint8)
    path = tmp_path / "v.mp4"
    write(path, [[luma, half, half]] * 3, "yuv420p", 1, codec="mpeg4")
    plain = frames_of(path)[0]
    data = bytearray(path.read_bytes())
    at = data.index(b"tkhd") + 4 + 40
    one = 0x10000
    a, b = {1: (0, one), 2: (-one, 0), 3: (0, -one)}[quarters]
    matrix = (a, b, 0, -b, a, 0, 0, 0, 0x40000000)
    data[at : at + 36] = b"".join(v.to_bytes(4, "big", signed=v < 0) for v in matrix)
    path.write_bytes(bytes(data))
    found = frames_of(path)[0]
    np.testing.assert_array_equal(found, np.rot90(plain, -quarters))
    video = cv2.VideoCapture(str(path), cv2.CAP_FFMPEG)
    good, witness = video.read()
    video.release()
    assert good
    assert witness.shape == found.shape
    assert np.abs(witness[..., ::-1].astype(float) - found).mean() < 3


def test_frames_of_unequal_length_are_repeated(tmp_path: Path) -> None:
    """Frames begin at 0, 40, 80, 200 and 240 ms, so the one at 80 ms lasts for three steps."""
    values = (20, 60, 100, 140, 180)
    write(tmp_path / "v.mkv", [grey(v) for v in values], times=[0, 40, 80, 200, 240])
    (note,) = timed(open_pages(tmp_path / "v.mkv")).notes
    assert "frames of 40 to 120 ms" in note[0]
    assert "steps of 40 ms" in note[0]
    found = [int(frame[0, 0, 0]) for frame in read_frames(tmp_path / "v.mkv")]
    known = [round((v - 16) / 219 * 255) for v in (20, 60, 100, 100, 100, 140, 180)]
    assert found == known
    write(tmp_path / "e.mkv", [grey(v) for v in values], times=[0, 33, 67, 100, 133])
    assert not timed(open_pages(tmp_path / "e.mkv")).notes


def test_unequal_frames_are_repeated_in_steps_of_the_shortest(tmp_path: Path) -> None:
    """Frames of 20 ms are shown once, those of 40 ms twice. In steps of the median duration, frames
    would be lost."""
    values = (20, 60, 100, 140, 180)
    path = tmp_path / "v.mkv"
    write(path, [grey(v) for v in values], times=[0, 40, 60, 80, 120])
    stored = [int(frame[0, 0, 0]) for frame in open_pages(path).read()]
    shown = [int(frame[0, 0, 0]) for frame in read_frames(path)]
    assert shown == [stored[k] for k in (0, 0, 1, 2, 3, 3, 4, 4)]


def test_a_video_that_breaks_off_says_how_many_frames_it_has(tmp_path: Path) -> None:
    import cv2

    path = tmp_path / "v.mp4"
    half = np.full((ROWS // 2, COLS // 2), 128, np.uint8)
    noise = np.random.default_rng(0)
    planes = [[noise.integers(16, 235, (ROWS, COLS)).astype(np.uint8), half, half]] * 20
    with av.open(str(path), "w", options={"movflags": "faststart"}) as container:
        stream = container.add_stream("mpeg4", rate=25)
        stream.width, stream.height, stream.pix_fmt = COLS, ROWS, "yuv420p"
        stream.gop_size = 1
        for parts in planes:
            picture = cv2.cvtColor(parts[0], cv2.COLOR_GRAY2RGB)
            for packet in stream.encode(av.VideoFrame.from_ndarray(picture, format="rgb24")):
                container.mux(packet)
        for packet in stream.encode():
            container.mux(packet)
    whole = open_pages(path)
    assert (whole.count, whole.notes) == (20, ())
    data = path.read_bytes()
    path.write_bytes(data[: len(data) * 6 // 10])
    said: list[Diagnostic] = []
    settings: dict[str, Any] = {"rows": ROWS, "cols": COLS, "exposure": ExposureLevel(1.0)}
    load_scene(str(path), slot_us=(10.0,) * 5, warn=said.append, **settings)
    notes = [diagnostic.message for diagnostic in said if "is incomplete" in diagnostic.message]
    assert len(notes) == 1
    count = int(notes[0].split("contains ")[1].split()[0])
    assert 8 <= count <= 14
    assert "of the 20 frames" in notes[0]
    assert count - 1 <= len(frames_of(path)) <= count


@pytest.mark.parametrize("data", [b"", b"nothing", b"#EXTM3U\n#EXTINF:1,\nhttp://localhost/a.ts\n"])
def test_files_that_are_not_videos_are_refused(tmp_path: Path, data: bytes) -> None:
    (tmp_path / "v.mp4").write_bytes(data)
    with pytest.raises(Rejected, match="NS0732"):
        open_pages(tmp_path / "v.mp4")


def test_a_video_without_a_frame_that_decodes_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "v.mov"
    half = np.full((ROWS // 2, COLS // 2), 128, np.uint8)
    luma = np.full((ROWS, COLS), 90, np.uint8)
    write(path, [[luma, half, half]] * 3, codec="mpeg4", form="yuv420p")
    data = path.read_bytes()
    index, samples = data.index(b"moov"), data.index(b"mdat") + 4
    assert samples < index
    path.write_bytes(data[:samples] + bytes(index - 4 - samples) + data[index - 4 :])
    with pytest.raises(Rejected, match="NS0732"):
        frames_of(path)


@pytest.mark.parametrize("form", ["gray", "gray16le"])
@pytest.mark.parametrize("stated", [None, "limited", "full"])
def test_grey_without_a_stated_range_is_full(tmp_path: Path, form: str, stated: Any) -> None:
    bits = 8 if form == "gray" else 16
    values = np.linspace(0, 2**bits - 1, COLS).round().astype(np.uint8 if bits == 8 else "<u2")
    path = tmp_path / "v.mkv"
    with av.open(str(path), "w") as container:
        stream = container.add_stream("ffv1", rate=25)
        stream.width, stream.height, stream.pix_fmt = COLS, ROWS, form
        number = {None: 0, "limited": 1, "full": 2}[stated]
        stream.codec_context.color_range = number
        frame = av.VideoFrame(COLS, ROWS, form)
        frame.color_range = number
        lines = np.zeros((ROWS, frame.planes[0].line_size // values.itemsize), values.dtype)
        lines[:, :COLS] = values
        frame.planes[0].update(lines.tobytes())
        frame.pts = 0
        container.mux(stream.encode(frame))
        container.mux(stream.encode())
    (found,) = frames_of(path)
    fractions = values / (2**bits - 1)
    if stated == "limited":
        step = 2 ** (bits - 8)
        fractions = np.clip((values.astype(float) - 16 * step) / (219 * step), 0, 1)
    white = np.iinfo(found.dtype).max
    np.testing.assert_allclose(found[0, :, 0] / white, fractions, atol=1.1 / white)


def streams_in(path: Path, values: tuple[int, ...], sizes: tuple[int, ...], default: int) -> None:
    """Writes a file of several video streams; number `default` is marked as the default."""
    with av.open(str(path), "w") as container:
        streams = []
        for size in sizes:
            stream = container.add_stream("ffv1", rate=25)
            stream.width, stream.height, stream.pix_fmt = size, ROWS, "yuv420p"
            streams.append(stream)
        for number, stream in enumerate(streams):
            marks = av.stream.Disposition
            stream.disposition = marks.default if number == default else marks(0)
        for stream, value, size in zip(streams, values, sizes, strict=True):
            for _ in range(3):
                picture = np.full((ROWS, size, 3), value, np.uint8)
                frame = av.VideoFrame.from_ndarray(picture, format="rgb24")
                container.mux(stream.encode(frame))
            container.mux(stream.encode())


@pytest.mark.parametrize("default", [0, 1])
def test_of_two_video_streams_the_default_one_is_read(tmp_path: Path, default: int) -> None:
    streams_in(tmp_path / "v.mkv", (50, 150), (COLS, 2 * COLS), default)
    found = frames_of(tmp_path / "v.mkv")
    assert [frame.shape[1] for frame in found] == [(1 + default) * COLS] * 3
    assert abs(int(found[0][0, 0, 0]) - (50, 150)[default]) <= 2


def test_a_cover_is_not_read_as_the_video(tmp_path: Path) -> None:
    """The first stream is a picture that is attached to the file."""
    path = tmp_path / "v.mp4"
    with av.open(str(path), "w") as container:
        cover = container.add_stream("mjpeg", rate=25)
        cover.width, cover.height, cover.pix_fmt = 16, 16, "yuvj420p"
        film = container.add_stream("mpeg4", rate=25)
        film.width, film.height, film.pix_fmt = COLS, ROWS, "yuv420p"
        cover.disposition = av.stream.Disposition.attached_pic
        small = av.VideoFrame.from_ndarray(np.zeros((16, 16, 3), np.uint8), format="rgb24")
        container.mux(cover.encode(small))
        container.mux(cover.encode())
        for _ in range(3):
            picture = np.full((ROWS, COLS, 3), 99, np.uint8)
            container.mux(film.encode(av.VideoFrame.from_ndarray(picture, format="rgb24")))
        container.mux(film.encode())
    with av.open(str(path)) as container:
        assert {stream.width for stream in container.streams.video} == {16, COLS}
    assert [frame.shape for frame in frames_of(path)] == [(ROWS, COLS, 3)] * 3


def test_pixels_that_are_not_square_become_square(tmp_path: Path) -> None:
    path = tmp_path / "v.mkv"
    with av.open(str(path), "w") as container:
        stream = container.add_stream("mpeg4", rate=25)
        stream.width, stream.height, stream.pix_fmt = COLS, ROWS, "yuv420p"
        stream.codec_context.sample_aspect_ratio = Fraction(3, 2)
        picture = np.full((ROWS, COLS, 3), 99, np.uint8)
        container.mux(stream.encode(av.VideoFrame.from_ndarray(picture, format="rgb24")))
        container.mux(stream.encode())
    pages = open_pages(path)
    assert pages.sizes == ((ROWS, COLS * 3 // 2),)
    assert next(pages.read()).shape == (ROWS, COLS * 3 // 2, 3)
    assert "3:2" in pages.notes[0][0]


def test_interlaced_frames_are_noted(tmp_path: Path) -> None:
    path = tmp_path / "v.mkv"
    with av.open(str(path), "w") as container:
        stream = container.add_stream("mpeg2video", rate=25)
        stream.width, stream.height, stream.pix_fmt = COLS, ROWS, "yuv420p"
        stream.codec_context.options = {"flags": "+ildct+ilme"}
        for _ in range(3):
            frame = av.VideoFrame.from_ndarray(
                np.full((ROWS, COLS, 3), 99, np.uint8), format="rgb24"
            )
            container.mux(stream.encode(frame))
        container.mux(stream.encode())
    assert "interlaced" in open_pages(path).notes[0][0]
