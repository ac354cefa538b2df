"""Brackets of photos: the light that made them is found again, by EXIF or by given times."""

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

from nscc.diagnostics.diagnostic import Rejected
from nscc_runtime.scenes import ExposureLevel, Scene
from nscc_runtime.scenes.bracket import bracket_files, merged_bracket, parse_times
from nscc_runtime.scenes.colour import srgb_to_linear

ROWS, COLS = 16, 24
TIMES = (1 / 256, 1 / 32, 1 / 4)


def light() -> np.ndarray:
    """From left to right; the brightest fits the shortest exposure."""
    return np.tile(np.geomspace(0.15, 60, COLS), (ROWS, 1))


def photos(folder: Path, exif: bool, iso: tuple[int, ...] = (100, 100, 100)) -> None:
    for number, (time, speed) in enumerate(zip(TIMES, iso, strict=True)):
        linear = np.clip(light() * time * speed / 100, 0, 1)
        shown = np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)
        image = Image.fromarray(np.rint(255 * shown).astype(np.uint8)).convert("RGB")
        about = Image.Exif()
        if exif:
            about[0x8769] = {0x829A: time, 0x8827: speed}
        image.save(folder / f"{number}.png", exif=about)


def found(spec: Path | str, **options: Any) -> np.ndarray:
    made = load_scene(
        str(spec),
        slot_us=(10.0,),
        rows=ROWS,
        cols=COLS,
        exposure=ExposureLevel(1.0, 100.0),
        bracket=True,
        **options,
    )
    assert made.kind == "still"
    return np.asarray(made.dense()[0])


@pytest.mark.parametrize("iso", [(100, 100, 100), (400, 100, 50)])
def test_a_merged_bracket_reproduces_the_light(tmp_path: Path, iso: tuple[int, ...]) -> None:
    """Photos of three exposure times, of equal and unequal ISO, give the light within 6 %, from a
    folder and a pattern."""
    photos(tmp_path, True, iso)
    expected = light() / light().max()
    for spec in (tmp_path, f"{tmp_path}/*.png"):
        np.testing.assert_allclose(found(spec), expected, rtol=0.06)


def test_given_exposure_times_replace_missing_ones(tmp_path: Path) -> None:
    """Photos without times are refused with NS0777. Times that are given merge them, but not equal
    ones or too few."""
    photos(tmp_path, False)
    with pytest.raises(Rejected, match="NS0777"):
        found(tmp_path)
    made = found(tmp_path, times=parse_times("1/256, 1/32,0.25"))
    np.testing.assert_allclose(made, light() / light().max(), rtol=0.06)
    assert Scene(str(tmp_path), bracket=True, times="1/256,1/32,1/4").times
    for times in ((1.0, 1.0, 1.0), (1.0, 2.0)):
        with pytest.raises(Rejected, match="NS0777"):
            found(tmp_path, times=times)


def test_invalid_brackets_are_refused(tmp_path: Path) -> None:
    import cv2

    for text in (
        "",
        "x",
        "1/0",
        "1/",
        "1/2/3",
        "-1,2",
        "-1/-2,1",
        "1,,2",
        "inf",
        "1e400",
        "1e999999999",
    ):
        with pytest.raises(Rejected, match="NS0777"):
            parse_times(text)
    with pytest.raises(Rejected, match="NS0777"):
        found(f"{tmp_path}/*.png")
    with pytest.raises(Rejected, match="NS0739"):
        load_scene("x.png", slot_us=(1.0,), rows=ROWS, cols=COLS, times=(1.0,))
    for number in range(2):
        cv2.imwrite(str(tmp_path / f"{number}.tiff"), np.ones((ROWS, COLS), np.float32))
    with pytest.raises(Rejected, match="NS0777"):
        found(tmp_path, times=(1.0, 2.0))


def test_the_merge_is_that_of_debevec(tmp_path: Path) -> None:
    """OpenCV's merge of 8 bits is the oracle; photos are colourful, grey, black and white."""
    import cv2

    pictures = np.random.default_rng(3).integers(0, 256, (4, ROWS, COLS, 3), np.uint8)
    pictures[1] = pictures[1, ..., :1]
    pictures[2], pictures[3] = 0, 255
    times = (0.5, 1 / 3, 2.0, 1e-3)
    for number, picture in enumerate(pictures):
        Image.fromarray(picture).convert("L" if number == 1 else "RGB").save(
            tmp_path / f"{number}.png"
        )
    curve = srgb_to_linear(np.arange(256) / 255.0)
    curve[0] = curve[1] / 2
    response = np.repeat(curve.astype(np.float32)[:, None, None], 3, axis=2)
    expected = cv2.createMergeDebevec().process([*pictures], np.float32(times), response)
    made, _ = merged_bracket(bracket_files(str(tmp_path)), times)
    told = (pictures % 255 > 0).any(axis=(0, -1))
    np.testing.assert_allclose(made[told], expected[told], rtol=1e-4)


def test_pixels_that_are_black_or_white_in_all_photos_get_finite_light(tmp_path: Path) -> None:
    for number, value in enumerate((0, 0, 255)):
        samples = np.array([[0, 255, value]], np.uint8)
        Image.fromarray(samples).save(tmp_path / f"{number}.png")
    made, _ = merged_bracket(bracket_files(str(tmp_path)), (0.25, 1.0, 4.0))
    black = srgb_to_linear(np.array([1 / 255]))[0] / 2
    np.testing.assert_allclose(made, [[black / 4, 4, 0.25]], rtol=1e-5)


@pytest.mark.parametrize("grey", [False, True])
def test_photos_of_16_bits_are_merged_more_exactly(tmp_path: Path, grey: bool) -> None:
    """The light is found with less error than in 8 bits: 6 % there."""
    for number, time in enumerate(TIMES):
        linear = np.clip(light() * time, 0, 1)
        shown = np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)
        samples = np.rint(65535 * shown).astype(np.uint16)
        colours = samples if grey else np.repeat(samples[..., None], 3, axis=-1)
        tifffile.imwrite(tmp_path / f"{number}.tif", colours)
    made, _ = merged_bracket(bracket_files(str(tmp_path)), TIMES)
    assert made.shape == ((ROWS, COLS) if grey else (ROWS, COLS, 3))
    np.testing.assert_allclose(made.reshape(ROWS, COLS, -1)[..., 0], light(), rtol=2e-3)


def test_exposure_times_of_raw_files_are_read(tmp_path: Path) -> None:
    """The first directory is the mosaic; the times are in the EXIF directory behind it."""
    pytest.importorskip("rawpy")
    for number, time in enumerate((1 / 64, 1 / 16)):
        mosaic = np.full((64, 80), round(0.6 * 4095 * 16 * time), np.uint16)
        path = tmp_path / f"{number}.dng"
        write_dng(path, mosaic, exif=(34664, "I", 1, 0))
        data = bytearray(path.read_bytes())
        at = data.index(struct.pack("<HHI", 34664, 4, 1))
        data[at : at + 12] = struct.pack("<HHII", 34665, 4, 1, len(data))
        entry = struct.pack("<HHIII", 0x829A, 5, 1, len(data) + 18, 0)
        data += (
            struct.pack("<H", 1) + entry[:12] + bytes(4) + struct.pack("<II", 1, round(1 / time))
        )
        path.write_bytes(data)
    made, _ = merged_bracket(bracket_files(str(tmp_path)), None)
    np.testing.assert_allclose(made[8:-8, 8:-8], 0.6 * 16, rtol=2e-3)


@pytest.mark.parametrize(("tag", "name"), [(0x829D, "f-number"), (0x8827, "ISO speed")])
def test_a_factor_that_only_some_photos_state_is_refused(
    tmp_path: Path, tag: int, name: str
) -> None:
    for number in range(3):
        exif = Image.Exif()
        stated = exif.get_ifd(0x8769)
        stated[0x829A] = 1 / 4**number
        if number != 1:
            stated[tag] = 8
        picture = Image.fromarray(np.full((ROWS, COLS), 200 >> number, np.uint8))
        picture.save(tmp_path / f"{number}.jpg", exif=exif)
    with pytest.raises(Rejected, match=f"the {name} of '.*1.jpg' is missing"):
        merged_bracket(bracket_files(str(tmp_path)), None)
