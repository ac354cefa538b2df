"""Pictures of strangers: TIFF with planes, stacks and channels, raw files, animations, misnamed
files. Each gives the value that its file states, or a reason."""

from __future__ import annotations

import struct
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import tifffile
from one_scene import load_scene
from PIL import Image
from raw_files import write_dng

from nscc.diagnostics.diagnostic import Diagnostic, Rejected
from nscc_runtime.scenes import ExposureLevel
from nscc_runtime.scenes.picture_files import open_pages, read_frames, read_picture

RNG = np.random.default_rng(3)
ROWS, COLS = 32, 48


@pytest.mark.parametrize("dtype", [np.uint8, np.uint16, np.float32])
@pytest.mark.parametrize("compression", [None, "zlib"])
@pytest.mark.parametrize("tile", [None, (16, 16)])
@pytest.mark.parametrize("big", [False, True])
@pytest.mark.parametrize("order", ["<", ">"])
def test_tiff_files_with_separate_planes_are_read(
    tmp_path: Path, dtype: Any, compression: Any, tile: Any, big: bool, order: Any
) -> None:
    picture = (RNG.random((3, ROWS, COLS)) * (1 if dtype == np.float32 else 200)).astype(dtype)
    path = tmp_path / "a.tif"
    tifffile.imwrite(
        path,
        picture,
        planarconfig="separate",
        photometric="rgb",
        compression=compression,
        tile=tile,
        bigtiff=big,
        byteorder=order,
        rowsperstrip=None if tile else 5,
    )
    if big and order == ">":
        with pytest.raises(Rejected, match="big-endian"):
            read_picture(path)
        return
    np.testing.assert_array_equal(read_picture(path), np.moveaxis(picture, 0, -1))


@pytest.mark.parametrize("dtype", [np.uint8, np.uint16, np.float32])
def test_a_stack_of_imagej_is_read_as_frames(tmp_path: Path, dtype: Any) -> None:
    """ImageJ writes five frames after a single page header. All five are read."""
    stack = (RNG.random((5, ROWS, COLS)) * 200).astype(dtype)
    path = tmp_path / "a.tif"
    tifffile.imwrite(path, stack, imagej=True, truncate=True, metadata={"axes": "TYX"})
    with tifffile.TiffFile(path) as file:
        assert len(file.pages) == 1
    pages = open_pages(path)
    assert (pages.count, pages.notes) == (5, ())
    np.testing.assert_array_equal([*pages.read()], stack)


@pytest.mark.parametrize("kind", ["imagej", "ome"])
@pytest.mark.parametrize("axes", ["TCYX", "CTYX", "TZYX", "TZCYX"])
def test_one_channel_of_several_is_exposed(tmp_path: Path, kind: str, axes: str) -> None:
    """ImageJ stores channels next to each other, OME in any order."""
    if kind == "imagej" and axes == "CTYX":
        pytest.skip("not an order of ImageJ")
    sizes = {"T": 4, "C": 2, "Z": 3}
    shape = [sizes[axis] for axis in axes[:-2]]
    stack = RNG.integers(0, 65536, (*shape, ROWS, COLS), np.uint16)
    path = tmp_path / ("a.tif" if kind == "imagej" else "a.ome.tif")
    tifffile.imwrite(path, stack, **{kind: True}, metadata={"axes": axes}, photometric="minisblack")
    pages = open_pages(path)
    known = stack
    for axis in "CZ":
        if axis in axes:
            known = np.take(known, 0, axes.index(axis) if axis == "C" or "C" not in axes else 1)
    np.testing.assert_array_equal([*pages.read()], known)
    named = [
        f"{name} 1 of {sizes[a]}" for a, name in (("C", "channel"), ("Z", "slice")) if a in axes
    ]
    assert all(text in pages.notes[0][0] for text in named)


def test_colours_that_are_not_decoded_are_refused(tmp_path: Path) -> None:
    """L*a*b* and CMYK of 16 bits are refused by their name."""
    Image.fromarray(np.full((ROWS, COLS, 3), 99, np.uint8)).convert("LAB").save(tmp_path / "a.tif")
    tifffile.imwrite(
        tmp_path / "b.tif", np.zeros((ROWS, COLS, 4), np.uint16), photometric="separated"
    )
    for name, text in (("a.tif", "L*a*b*"), ("b.tif", "CMYK of 16 bits")):
        with pytest.raises(Rejected) as caught:
            read_picture(tmp_path / name)
        assert text in caught.value.diagnostics[0].message


def test_a_file_is_recognised_by_its_first_bytes(tmp_path: Path) -> None:
    """A TIFF named `.png`, `.jpg`, `.exr` or `.mp4`, and a HEIC named `.jpg`, are read as what they
    are."""
    picture = RNG.integers(0, 65536, (ROWS, COLS, 3), np.uint16)
    tifffile.imwrite(tmp_path / "a.tif", picture, photometric="rgb")
    for name in ("a.png", "a.jpg", "a.exr", "a.mp4"):
        (tmp_path / name).write_bytes((tmp_path / "a.tif").read_bytes())
        np.testing.assert_array_equal(read_picture(tmp_path / name), picture)
    heif = pytest.importorskip("pillow_heif")
    flat = Image.fromarray(np.full((64, 64, 3), 99, np.uint8))
    heif.from_pillow(flat).save(tmp_path / "b.heic", quality=100)
    (tmp_path / "b.jpg").write_bytes((tmp_path / "b.heic").read_bytes())
    np.testing.assert_allclose(read_picture(tmp_path / "b.jpg"), 99, atol=3)


def test_raw_is_scaled_by_what_the_file_states_only(tmp_path: Path) -> None:
    """A ramp up to 80 % of white, its half and its quarter."""
    pytest.importorskip("rawpy")
    ramp = np.tile(np.linspace(0, 0.8 * 4095, 80), (64, 1))
    means = []
    for factor in (1, 2, 4):
        write_dng(tmp_path / "a.dng", (ramp * factor / 4).round().astype(np.uint16))
        means.append(read_picture(tmp_path / "a.dng")[8:-8, 8:-8].mean(axis=(0, 1)))
    np.testing.assert_allclose(means[1] / means[0], 2, rtol=2e-3)
    np.testing.assert_allclose(means[2] / means[0], 4, rtol=2e-3)


def test_black_levels_of_the_four_pixels_are_subtracted(tmp_path: Path) -> None:
    pytest.importorskip("rawpy")
    rows, cols = np.mgrid[:64, :80] % 2
    levels = (100, 200, 300, 400)
    black = np.choose(2 * rows + cols, levels)
    mosaic = np.rint(black + 0.5 * (4095 - black)).astype(np.uint16)
    write_dng(
        tmp_path / "a.dng", mosaic, repeat=(50713, "H", 2, (2, 2)), black=(50714, "H", 4, levels)
    )
    np.testing.assert_allclose(read_picture(tmp_path / "a.dng")[8:-8, 8:-8], 32768, atol=20)


@pytest.mark.parametrize("kind", ["linear", "mosaic"])
def test_raw_files_without_colour_filters_are_light(tmp_path: Path, kind: str) -> None:
    """A sensor without colour filters: values from black 200 to white 4095 are light."""
    pytest.importorskip("rawpy")
    values = np.tile(np.linspace(200, 4095, 80).round(), (64, 1)).astype(np.uint16)
    changes: dict[str, Any] = {"black": (50714, "H", 1, 200), "neutral": None, "matrix": None}
    if kind == "linear":
        changes |= {"photometric": 1, "pattern": None, "pattern_size": None}
    else:
        changes |= {"pattern": (33422, "B", 4, (0, 0, 0, 0))}
    write_dng(tmp_path / "a.dng", values, **changes)
    if kind == "linear":  # tifffile writes LinearRaw with three colours only
        data = bytearray((tmp_path / "a.dng").read_bytes())
        at = data.index(struct.pack("<HHI", 262, 3, 1)) + 8
        data[at : at + 2] = struct.pack("<H", 34892)
        (tmp_path / "a.dng").write_bytes(data)
    known = (values.astype(float) - 200) / (4095 - 200) * 65535
    np.testing.assert_allclose(read_picture(tmp_path / "a.dng"), known, atol=1)


def test_raw_files_of_three_colours_at_each_pixel_are_light(tmp_path: Path) -> None:
    pytest.importorskip("rawpy")
    values = RNG.integers(300, 4096, (64, 80, 3), np.uint16)
    levels = (100, 200, 300)
    write_dng(
        tmp_path / "a.dng",
        values,
        photometric=34892,
        pattern=None,
        pattern_size=None,
        black=(50714, "H", 3, levels),
        white=(50717, "H", 3, (4095,) * 3),
    )
    known = (values - np.array(levels)) / (4095 - np.array(levels)) * 65535
    np.testing.assert_allclose(read_picture(tmp_path / "a.dng"), known, atol=1)


def notes_of(path: Path, slots: int, **options: Any) -> tuple[np.ndarray, list[Diagnostic]]:
    said: list[Diagnostic] = []
    settings: dict[str, Any] = {"exposure": ExposureLevel(1.0, 100.0), "transfer": "linear"}
    light = load_scene(
        str(path), slot_us=(1e5,) * slots, rows=8, cols=10, warn=said.append, **settings | options
    )
    dense = np.asarray(light.dense())
    return dense[:, 0, 0] / dense.max() * 200, said


def animation(path: Path, durations: list[int], **options: Any) -> list[int]:
    values = [40 * k + 40 for k in range(len(durations))]
    frames = [Image.fromarray(np.full((8, 10, 3), v, np.uint8)) for v in values]
    settings = {"lossless": True} if path.suffix == ".webp" else {}
    frames[0].save(
        path, save_all=True, append_images=frames[1:], duration=durations, **settings | options
    )
    return values


@pytest.mark.parametrize("ending", ["gif", "webp", "png"])
def test_frames_of_animations_last_as_stated(tmp_path: Path, ending: str) -> None:
    path = tmp_path / f"a.{ending}"
    values = animation(path, [100, 200, 100, 300])
    shown = [values[k] for k in (0, 1, 1, 2, 3, 3, 3)]
    light, said = notes_of(path, 7)
    np.testing.assert_allclose(light, np.array(shown) / 160 * 200, rtol=1e-5)
    assert "in steps of 100 ms" in " ".join(note.message for note in said)
    # With --fps 10 a step lasts 100 ms, a slot; with 20 a slot covers two steps.
    light, _ = notes_of(path, 7, fps=10)
    np.testing.assert_allclose(light, np.array(shown) / 160 * 200, rtol=1e-5)
    light, _ = notes_of(path, 3, fps=20)
    pairs = np.array([values[0] + values[1], values[1] + values[2], 2 * values[3]]) / 2
    np.testing.assert_allclose(light, pairs / pairs.max() * 200, rtol=1e-5)
    animation(path, [100, 100, 100, 100])
    light, said = notes_of(path, 4)
    assert not [note for note in said if "steps" in note.message]


def test_times_between_steps_are_placed_exactly_with_fps(tmp_path: Path) -> None:
    values = animation(tmp_path / "a.gif", [100, 250, 100])
    light, _ = notes_of(tmp_path / "a.gif", 4, fps=10)
    exact = np.array([values[0], values[1], values[1], (values[1] + values[2]) / 2])
    np.testing.assert_allclose(light, exact / exact.max() * 200, rtol=1e-5)


@pytest.mark.parametrize("ending", ["gif", "webp", "png"])
def test_frames_of_no_time_are_left_out_and_long_ones_repeated(tmp_path: Path, ending: str) -> None:
    """Frames of 100, 0, 100 and many ms fill six slots as frames 0, 2, 3, 3, 3 and 3. A note counts
    the one of 0 ms."""
    path = tmp_path / f"a.{ending}"
    long_ms = 600_000 if ending == "gif" else 65_000 if ending == "png" else 8_640_000
    values = animation(path, [100, 0, 100, long_ms])
    light, said = notes_of(path, 6)
    shown = np.array([values[k] for k in (0, 2, 3, 3, 3, 3)])
    np.testing.assert_allclose(light, shown / 160 * 200, rtol=1e-5)
    assert "1 frame of 0 ms" in " ".join(note.message for note in said)


def test_the_title_picture_of_an_apng_is_not_a_frame(tmp_path: Path) -> None:
    """An animated PNG with a white title and frames of 50 and 100 has two frames."""
    title = Image.fromarray(np.full((8, 10, 3), 255, np.uint8))
    frames = [Image.fromarray(np.full((8, 10, 3), v, np.uint8)) for v in (50, 100)]
    title.save(
        tmp_path / "a.png", save_all=True, default_image=True, append_images=frames, duration=100
    )
    assert [int(frame[0, 0, 0]) for frame in read_frames(tmp_path / "a.png")] == [50, 100]


def test_a_gain_map_is_noted(tmp_path: Path) -> None:
    """A JPEG whose meta data has a gain map gets a note, as the map is not used. A second, smaller
    picture in the file is left out."""
    picture = Image.fromarray(np.full((ROWS, COLS, 3), 99, np.uint8))
    xmp = b'<x:xmpmeta xmlns:x="adobe:ns:meta/"><rdf:RDF hdrgm:Version="1.0"/></x:xmpmeta>'
    picture.save(tmp_path / "a.jpg", xmp=xmp)
    (note,) = open_pages(tmp_path / "a.jpg").notes
    assert "gain map" in note[0]
    smaller = picture.resize((16, 16))
    picture.save(tmp_path / "b.jpg", format="MPO", save_all=True, append_images=[smaller])
    assert read_picture(tmp_path / "b.jpg").shape == (ROWS, COLS, 3)
