"""Pictures of less usual kinds: each with the value that its format defines, or a reason."""

from __future__ import annotations

import struct
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import tifffile
from one_scene import load_scene
from PIL import Image

import nscc
from nscc.diagnostics.diagnostic import Diagnostic, Rejected
from nscc_runtime import capture
from nscc_runtime.scenes import ExposureLevel, Scene
from nscc_runtime.scenes.picture_files import open_pages, read_picture

RNG = np.random.default_rng(0)
ROWS, COLS = 8, 10


def clip_light(path: Path, slots: int, **options: Any) -> np.ndarray:
    """The light in slots of a clip, brightest 1."""
    settings: dict[str, Any] = {
        "exposure": ExposureLevel(1.0, 100.0),
        "transfer": "linear",
    } | options
    light = load_scene(str(path), slot_us=(10.0,) * slots, rows=ROWS, cols=COLS, **settings)
    dense = np.asarray(light.dense())
    return dense / dense.max()


def refusal(path: Path) -> Diagnostic:
    with pytest.raises(Rejected) as caught:
        read_picture(path)
    (diagnostic,) = caught.value.diagnostics
    assert diagnostic.code == "NS0732"
    assert "whole" not in " ".join(diagnostic.helps)
    return diagnostic


@pytest.mark.parametrize("big", [False, True])
def test_pages_of_a_tiff_are_a_clip(tmp_path: Path, big: bool) -> None:
    """Four pages are four frames, in TIFF and BigTIFF. One page can be taken as a still."""
    pages = RNG.integers(0, 65536, (4, ROWS, COLS), np.uint16)
    tifffile.imwrite(tmp_path / "c.tif", pages, photometric="minisblack", bigtiff=big)
    np.testing.assert_allclose(clip_light(tmp_path / "c.tif", 4), pages / pages.max(), rtol=1e-5)
    one = clip_light(tmp_path / "c.tif", 1, first=2, single=True)
    np.testing.assert_allclose(one[0], pages[2] / pages[2].max(), rtol=1e-5)


def test_clips_survive_tiff(tmp_path: Path) -> None:
    from nscc_runtime.formats.content import Content
    from nscc_runtime.formats.format_table import tiff

    clip = RNG.random((5, ROWS, COLS)).astype(np.float32)
    (tmp_path / "c.tiff").write_bytes(tiff(Content({"video": clip}, clip, True)))
    np.testing.assert_array_equal([*open_pages(tmp_path / "c.tiff").read()], clip)


def test_thumbnails_in_a_tiff_are_not_read_as_frames(tmp_path: Path) -> None:
    picture = RNG.integers(0, 256, (ROWS, COLS), np.uint8)
    with tifffile.TiffWriter(tmp_path / "t.tif") as writer:
        writer.write(picture, photometric="minisblack")
        writer.write(picture[::2, ::2], photometric="minisblack", subfiletype=1)
    np.testing.assert_array_equal(read_picture(tmp_path / "t.tif"), picture)


def test_pages_of_other_sizes_are_refused(tmp_path: Path) -> None:
    """Pages of 16 x 16 and 32 x 32 are no clip: NS0734."""
    with tifffile.TiffWriter(tmp_path / "t.tif") as writer:
        for side in (16, 32):
            writer.write(np.zeros((side, side), np.uint8), photometric="minisblack")
    with pytest.raises(Rejected) as caught:
        clip_light(tmp_path / "t.tif", 2)
    assert caught.value.diagnostics[0].code == "NS0734"


@pytest.mark.parametrize("dtype", [np.uint8, np.uint16])
@pytest.mark.parametrize("kind", ["unassalpha", "unspecified"])
def test_alpha_does_not_darken_a_tiff(tmp_path: Path, dtype: Any, kind: str) -> None:
    """A fourth channel, marked as alpha or as unknown, is left out, and the colours are read as
    stored."""
    picture = RNG.integers(0, np.iinfo(dtype).max + 1, (ROWS, COLS, 4), dtype)
    tifffile.imwrite(tmp_path / "a.tif", picture, photometric="rgb", extrasamples=[kind])
    np.testing.assert_array_equal(read_picture(tmp_path / "a.tif"), picture[..., :3])


@pytest.mark.parametrize("dtype", [np.uint8, np.uint16])
def test_tiffs_in_which_0_is_white_are_inverted(tmp_path: Path, dtype: Any) -> None:
    """A value v of `miniswhite` is read as the largest value minus v."""
    stored = RNG.integers(0, np.iinfo(dtype).max + 1, (ROWS, COLS), dtype)
    tifffile.imwrite(tmp_path / "w.tif", stored, photometric="miniswhite")
    np.testing.assert_array_equal(read_picture(tmp_path / "w.tif"), np.iinfo(dtype).max - stored)


def test_half_floats_in_tiff_are_refused_with_the_reason(tmp_path: Path) -> None:
    half = np.ones((ROWS, COLS), np.float16)
    tifffile.imwrite(tmp_path / "h.tif", half, photometric="minisblack")
    assert "floats of 16 bits" in refusal(tmp_path / "h.tif").message


@pytest.mark.parametrize("format", ["png", "webp", "gif"])
def test_animations_are_clips(tmp_path: Path, format: str) -> None:
    """Three frames of grey 10, 200 and 90 are a clip in these proportions, as the linear curve is
    asked for."""
    values = (10, 200, 90)
    images = [Image.fromarray(np.full((ROWS, COLS, 3), v, np.uint8)) for v in values]
    path = tmp_path / f"a.{format}"
    lossless = {"lossless": True} if format == "webp" else {}
    images[0].save(path, save_all=True, append_images=images[1:], **lossless)
    expected = np.array(values) / max(values)
    np.testing.assert_allclose(clip_light(path, 3)[:, 3, 4], expected, rtol=1e-5)


def write_exr(path: Path, channels: dict[str, np.ndarray], **header: Any) -> None:
    import OpenEXR

    settings = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage} | header
    made = {name: np.ascontiguousarray(values) for name, values in channels.items()}
    OpenEXR.File(settings, made).write(str(path))


def test_the_colour_part_of_an_exr_is_read(tmp_path: Path) -> None:
    import OpenEXR

    depth = RNG.random((ROWS, COLS)).astype(np.float32)
    beauty = RNG.random((2, ROWS, COLS, 3)).astype(np.float32)
    header = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}
    parts = [
        OpenEXR.Part(dict(header), channels, name=name)
        for name, channels in (
            ("depth", {"Z": depth}),
            ("beauty", {"RGB": beauty[0]}),
            ("left", {"RGB": beauty[1]}),
        )
    ]
    OpenEXR.File(parts[:2]).write(str(tmp_path / "one.exr"))
    np.testing.assert_array_equal(read_picture(tmp_path / "one.exr"), beauty[0])
    OpenEXR.File(parts).write(str(tmp_path / "two.exr"))
    pages = open_pages(tmp_path / "two.exr")
    np.testing.assert_array_equal([*pages.read()], beauty)
    assert "beauty, left" in pages.notes[0][0]
    OpenEXR.File(parts[:1]).write(str(tmp_path / "none.exr"))
    assert "but Z" in refusal(tmp_path / "none.exr").message
    (tmp_path / "cut.exr").write_bytes((tmp_path / "one.exr").read_bytes()[:-100])
    assert "cannot read" in refusal(tmp_path / "cut.exr").message


def test_the_only_colour_layer_of_an_exr_is_read(tmp_path: Path) -> None:
    """Beside a depth channel, the layer `beauty` is read. With a second layer of colours both are
    named and refused."""
    rgb = RNG.random((3, ROWS, COLS)).astype(np.float32)
    layer = {f"beauty.{name}": rgb[k] for k, name in enumerate("RGB")}
    write_exr(tmp_path / "l.exr", layer | {"depth.Z": rgb[0]})
    np.testing.assert_array_equal(read_picture(tmp_path / "l.exr"), np.moveaxis(rgb, 0, -1))
    write_exr(tmp_path / "m.exr", layer | {f"glare.{name}": rgb[0] for name in "RGB"})
    assert "beauty, glare" in refusal(tmp_path / "m.exr").message


@pytest.mark.parametrize(("corner", "size"), [((2, 1), (12, 14)), ((-2, -3), (5, 4))])
def test_exr_data_is_placed_in_its_display_window(
    tmp_path: Path, corner: tuple[int, int], size: tuple[int, int]
) -> None:
    """The data window begins at `corner` (row, column) of a display window of that size."""
    luminance = RNG.random((ROWS, COLS)).astype(np.float32)
    (row, col), (rows, cols) = corner, size
    window = (np.array([col, row], "i4"), np.array([col + COLS - 1, row + ROWS - 1], "i4"))
    shown = (np.zeros(2, "i4"), np.array([cols - 1, rows - 1], "i4"))
    write_exr(tmp_path / "w.exr", {"Y": luminance}, dataWindow=window, displayWindow=shown)
    wide = np.pad(luminance, 20)
    expected = wide[20 - row : 20 - row + rows, 20 - col : 20 - col + cols]
    np.testing.assert_array_equal(read_picture(tmp_path / "w.exr"), expected)


def test_primaries_of_an_exr_are_mentioned(tmp_path: Path) -> None:
    """The primaries of BT.2020 get a note and their weights of luminance. Without primaries there
    is no note."""
    wide = (0.708, 0.292, 0.17, 0.797, 0.131, 0.046, 0.3127, 0.329)
    rgb = {name: np.ones((ROWS, COLS), np.float32) for name in "RGB"}
    write_exr(tmp_path / "w.exr", rgb, chromaticities=wide)
    pages = open_pages(tmp_path / "w.exr")
    assert "primaries" in pages.stated.notes[0][0]
    # ITU-R BT.2020 gives these weights.
    np.testing.assert_allclose(pages.colours.weights, (0.2627, 0.678, 0.0593), atol=1e-4)
    write_exr(tmp_path / "n.exr", rgb)
    assert not open_pages(tmp_path / "n.exr").stated.notes


def raw_exr(channels: dict[str, tuple[np.ndarray, int]], rows: int, cols: int) -> bytes:
    """An uncompressed OpenEXR file of float channels, each with its sampling step."""

    def attribute(name: str, kind: str, data: bytes) -> bytes:
        return f"{name}\0{kind}\0".encode() + struct.pack("<i", len(data)) + data

    names = sorted(channels)
    listed = b"".join(
        name.encode() + b"\0" + struct.pack("<iBBBBii", 2, 0, 0, 0, 0, *[channels[name][1]] * 2)
        for name in names
    )
    window = struct.pack("<4i", 0, 0, cols - 1, rows - 1)
    head = (
        struct.pack("<ii", 20000630, 2)
        + b"".join(
            attribute(*entry)
            for entry in (
                ("channels", "chlist", listed + b"\0"),
                ("compression", "compression", b"\0"),
                ("dataWindow", "box2i", window),
                ("displayWindow", "box2i", window),
                ("lineOrder", "lineOrder", b"\0"),
                ("pixelAspectRatio", "float", struct.pack("<f", 1)),
                ("screenWindowCenter", "v2f", bytes(8)),
                ("screenWindowWidth", "float", struct.pack("<f", 1)),
            )
        )
        + b"\0"
    )
    lines = []
    for y in range(rows):
        steps = ((channels[name]) for name in names)
        data = b"".join(v[y // step].astype("<f4").tobytes() for v, step in steps if y % step == 0)
        lines.append(struct.pack("<ii", y, len(data)) + data)
    starts = np.cumsum([len(head) + 8 * rows, *map(len, lines)])[:-1]
    return head + b"".join(struct.pack("<Q", at) for at in starts) + b"".join(lines)


def test_luminance_with_subsampled_chroma_is_read_as_colour(tmp_path: Path) -> None:
    """Chroma that changes evenly is the same at every pixel as if it were not subsampled."""
    rows, cols = np.mgrid[:ROWS, :COLS]
    luminance = RNG.random((ROWS, COLS)) + 0.5
    red_chroma, blue_chroma = 0.02 * cols - 0.1, 0.03 * rows - 0.1
    chroma = {"RY": (red_chroma[::2, ::2], 2), "BY": (blue_chroma[::2, ::2], 2)}
    (tmp_path / "c.exr").write_bytes(raw_exr({"Y": (luminance, 1), **chroma}, ROWS, COLS))
    picture = read_picture(tmp_path / "c.exr")
    np.testing.assert_allclose(picture @ [0.2126, 0.7152, 0.0722], luminance, rtol=1e-5)
    red = luminance * (1 + red_chroma)
    blue = luminance * (1 + blue_chroma)
    np.testing.assert_allclose(picture[:, :-1, 0], red[:, :-1], rtol=1e-5)
    np.testing.assert_allclose(picture[:-1, :, 2], blue[:-1], rtol=1e-5)


@pytest.mark.parametrize("first", ["-Y", "+Y", "-X", "+X"])
@pytest.mark.parametrize("second", ["-", "+"])
def test_radiance_files_of_every_orientation_are_read_upright(
    tmp_path: Path, first: str, second: str
) -> None:
    """Samples are stored line by line: `-Y 8 +X 10` are 8 rows from the top, each from the left."""
    picture = RNG.integers(1, 256, (ROWS, COLS, 3), np.uint8)
    lies = picture if first[1] == "Y" else picture.swapaxes(0, 1)
    # Lines fall with -Y and grow with +X; within a line it is the other axis.
    if first in ("+Y", "-X"):
        lies = lies[::-1]
    if second == ("-" if first[1] == "Y" else "+"):
        lies = lies[:, ::-1]
    lines, count = lies.shape[:2]
    other = "X" if first[1] == "Y" else "Y"
    head = f"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n{first} {lines} {second}{other} {count}\n"
    samples = np.dstack([lies, np.full((lines, count), 128, np.uint8)])
    (tmp_path / "p.hdr").write_bytes(head.encode() + samples.tobytes())
    np.testing.assert_allclose(read_picture(tmp_path / "p.hdr"), picture / 256, atol=0.5 / 256)


def test_radiance_in_xyz_is_refused_with_the_reason(tmp_path: Path) -> None:
    """A file of the format `32-bit_rle_xyze` is refused, and the message names XYZ."""
    head = b"#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 8 +X 10\n"
    (tmp_path / "p.hdr").write_bytes(head + bytes(320))
    assert "XYZ" in refusal(tmp_path / "p.hdr").message


def png(chunks: dict[bytes, bytes], path: Path) -> None:
    """A picture of 16 bits with chunks of its own."""
    import zlib

    import cv2

    _, data = cv2.imencode(".png", RNG.integers(0, 65536, (ROWS, COLS), np.uint16))
    data = data.tobytes()
    for name, content in chunks.items():
        crc = struct.pack(">I", zlib.crc32(name + content))
        data = data[:33] + struct.pack(">I", len(content)) + name + content + crc + data[33:]
    path.write_bytes(data)


@pytest.mark.parametrize(
    ("chunks", "transfer", "noted"),
    [
        ({}, "srgb", False),
        ({b"gAMA": struct.pack(">I", 100000)}, "linear", False),
        ({b"gAMA": struct.pack(">I", 45455)}, "srgb", False),
        ({b"gAMA": struct.pack(">I", 55556)}, None, True),
        ({b"gAMA": struct.pack(">I", 100000), b"sRGB": b"\0"}, "srgb", False),
        ({b"cICP": bytes([1, 13, 0, 1])}, "srgb", False),
        ({b"cICP": bytes([1, 16, 0, 1])}, "pq", False),
        ({b"cICP": bytes([9, 18, 0, 1])}, "hlg", True),
        ({b"cICP": bytes([1, 8, 0, 1])}, "linear", False),
        ({b"cICP": bytes([1, 4, 0, 1])}, None, False),
        ({b"cICP": bytes([1, 17, 0, 1])}, "srgb", True),
    ],
)
def test_the_chunks_of_a_png_determine_its_transfer_curve(
    tmp_path: Path, chunks: dict[bytes, bytes], transfer: str | None, noted: bool
) -> None:
    png(chunks, tmp_path / "p.png")
    pages = open_pages(tmp_path / "p.png")
    assert (pages.colours.transfer, bool(pages.stated.notes)) == (transfer, noted)


def test_large_photographs_are_read(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Pillow's own limit is lowered below the picture's size. The picture is read, and the limit
    stays as it was."""
    monkeypatch.setattr(Image, "MAX_IMAGE_PIXELS", 20)
    picture = np.full((ROWS, COLS, 3), 128, np.uint8)
    Image.fromarray(picture).save(tmp_path / "p.jpg", quality=100)
    np.testing.assert_allclose(read_picture(tmp_path / "p.jpg"), picture, atol=2)
    assert Image.MAX_IMAGE_PIXELS == 20


def test_avif_and_heic_are_read(tmp_path: Path) -> None:
    heif = pytest.importorskip("pillow_heif")
    picture = np.full((64, 64, 3), (200, 100, 50), np.uint8)
    heif.from_pillow(Image.fromarray(picture)).save(tmp_path / "p.heic", quality=100)
    Image.fromarray(picture).save(tmp_path / "p.avif", quality=100)
    for name in ("p.heic", "p.avif"):
        np.testing.assert_allclose(read_picture(tmp_path / name), picture, atol=3)


def test_pq_and_hlg_curves_pass_their_published_points() -> None:
    """Points of ITU-R BT.2100: 100 cd/m2 is PQ 0.5081; HLG 0.5 is a twelfth of the scene's peak."""
    from nscc_runtime.scenes.colour import hlg_to_linear, pq_to_linear

    np.testing.assert_allclose(
        pq_to_linear(np.array([0, 0.508078, 0.751827, 1])), [0, 0.01, 0.1, 1], rtol=1e-4
    )
    np.testing.assert_allclose(
        hlg_to_linear(np.array([0, 0.25, 0.5, 1])), [0, 1 / 48, 1 / 12, 1], rtol=1e-6
    )
    ramp = np.linspace(0, 1, 1001)
    for curve in (pq_to_linear, hlg_to_linear):
        assert (np.diff(curve(ramp)) > 0).all()


def test_pages_are_a_clip_for_measures_and_demos(tmp_path: Path) -> None:
    """Twenty pages are a clip of 20 frames for the measures of two clips, and a subject that moves
    for the demo."""
    from nscc_runtime.scenes import Scene
    from nscc_training.array_files import read_picture_or_clip
    from nscc_training.demo.subject import subject

    pages = RNG.random((20, 32, 32)).astype(np.float32)
    tifffile.imwrite(tmp_path / "c.tif", pages, photometric="minisblack")
    np.testing.assert_array_equal(read_picture_or_clip(tmp_path / "c.tif"), pages)
    assert not subject(Scene(str(tmp_path / "c.tif")), 16, 0.002).still


@pytest.mark.parametrize("suffix", [".dng", ".nef"])
def test_raw_files_have_black_and_white_level_applied(tmp_path: Path, suffix: str) -> None:
    """A mosaic of 1000 red, 2000 green, 3000 blue above a black level of 200, white 4095."""
    pytest.importorskip("rawpy")
    rows, cols = np.mgrid[:64, :80] % 2
    mosaic = np.choose(rows + cols, (1000, 2000, 3000)).astype(np.uint16)
    identity = (1, 1, 0, 1, 0, 1, 0, 1, 1, 1, 0, 1, 0, 1, 0, 1, 1, 1)
    tags = [
        (50706, "B", 4, (1, 4, 0, 0), True), (50707, "B", 4, (1, 1, 0, 0), True),
        (50708, "s", 0, "Test", True), (33421, "H", 2, (2, 2), True),
        (33422, "B", 4, (0, 1, 1, 2), True), (50714, "H", 1, 200, True),
        (50717, "H", 1, 4095, True), (50721, "2i", 9, identity, True),
        (50728, "2I", 3, (1, 1, 1, 1, 1, 1), True), (50778, "H", 1, 21, True),
    ]  # fmt: skip
    path = tmp_path / f"p{suffix}"
    tifffile.imwrite(path, mosaic, photometric=32803, extratags=tags, metadata=None)
    pages = open_pages(path)
    (picture,) = pages.read()
    assert (picture.dtype, "colours as the camera has them" in pages.notes[0][0]) == ("u2", True)
    program = nscc.compile("nsl 1\nframe 1 slots of 1ms\nopen when true\n")
    meta = capture(program, Scene(str(path), exposure=1000, fit="scale")).meta
    assert "colours as the camera has them" in meta["scene_notes"][0]
    expected = (np.array([1000, 2000, 3000]) - 200) / (4095 - 200) * 65535
    np.testing.assert_allclose(
        picture[20:40, 20:40], np.broadcast_to(expected, (20, 20, 3)), atol=1
    )


def test_a_reader_that_is_missing_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Without the package rawpy, a raw photo gives NS0904, which names the package."""
    import sys

    from nscc_command import invoke

    monkeypatch.setitem(sys.modules, "rawpy", None)
    (tmp_path / "p.dng").write_bytes(b"raw")
    text = "nsl 1\nframe 1 slots of 1ms\nopen when true\n"
    (tmp_path / "p.nsl").write_text(text)
    line = ["run", "p.nsl", "--scene", "p.dng", "--exposure", "1", "-o", "f.npz"]
    refused = invoke(line, tmp_path)
    assert (refused.status, refused.codes) == (2, ["NS0904"])
    assert "rawpy" in refused.err
