"""Panoramas: pictures above the usual limit, reduced in bands."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from PIL import Image

from nscc.diagnostics.diagnostic import Rejected
from nscc_runtime.scene_settings import FITS
from nscc_runtime.scenes import Scene, laid_scene, pages
from nscc_runtime.scenes.exposure import BUILTIN
from nscc_runtime.scenes.picture_files import open_pages, read_picture
from nscc_runtime.scenes.picture_light import reduced

ROWS, COLS = 60, 90


@given(rows=st.integers(1, 40), cols=st.integers(1, 40), seed=st.integers(0, 99), data=st.data())
def test_large_pictures_are_reduced_by_means_over_areas(
    rows: int, cols: int, seed: int, data: Any
) -> None:
    size = data.draw(st.integers(1, rows)), data.draw(st.integers(1, cols))
    band_rows = data.draw(st.integers(1, rows))
    light = np.random.default_rng(seed).uniform(0, 9, (rows, cols))
    bands = (light[top : top + band_rows] for top in range(0, rows, band_rows))
    down, across = (_shares(*sides) for sides in zip((rows, cols), size, strict=True))
    np.testing.assert_allclose(reduced(bands, rows, size), down @ light @ across.T, rtol=1e-5)


def _shares(pixels: int, reduced_pixels: int) -> np.ndarray:
    """The share of each pixel in the mean of each new one, by exact fractions."""
    step = Fraction(pixels, reduced_pixels)
    overlaps = [
        [max(Fraction(0), min(step * (n + 1), p + 1) - max(step * n, p)) for p in range(pixels)]
        for n in range(reduced_pixels)
    ]
    return np.array([[float(overlap / step) for overlap in row] for row in overlaps])


@pytest.fixture
def limits(monkeypatch: pytest.MonkeyPatch) -> None:
    """The picture of the tests lies between the usual limit and that of large pictures."""
    monkeypatch.setattr(pages, "MOST_PIXELS", ROWS * COLS - 1)
    monkeypatch.setattr(pages, "MOST_LARGE_PIXELS", ROWS * COLS)


def write(path: Path, mode: str, **settings: Any) -> Path:
    colours = np.random.default_rng(1).integers(0, 256, (6, 9, 3), np.uint8)
    picture = Image.fromarray(colours.repeat(10, 0).repeat(10, 1)).convert(mode)
    picture.save(path, **settings)
    return path


def light(path: Path, fit: Any) -> np.ndarray:
    laid = laid_scene(
        Scene(str(path), exposure=BUILTIN, fit=fit), slot_us=(1000.0,), rows=16, cols=24
    )
    return np.asarray(laid.light.total_e())


FILES = [
    ("a.png", "RGB", {}),
    ("a.png", "L", {}),
    ("a.png", "P", {}),
    ("a.tiff", "CMYK", {}),
    ("a.jpg", "RGB", {}),
    ("a.webp", "RGB", {"lossless": True}),
    ("a.bmp", "RGB", {}),
]


@pytest.mark.parametrize(("name", "mode", "settings"), FILES)
def test_a_large_picture_is_the_light_of_a_small_one(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str, mode: str, settings: Any
) -> None:
    """The limit of pixels is lowered below the picture's size, so it is read in strips. The light
    stays equal to 1e-5."""
    path = write(tmp_path / name, mode, **settings)
    fits = [fit for fit in FITS if fit != "tiles"]
    usual = [light(path, fit) for fit in fits]
    monkeypatch.setattr(pages, "MOST_PIXELS", ROWS * COLS - 1)
    for fit, expected in zip(fits, usual, strict=True):
        np.testing.assert_allclose(light(path, fit), expected, rtol=1e-5)


def test_a_rotated_photo_is_read_upright(tmp_path: Path, limits: None) -> None:
    exif = Image.Exif()
    exif[274] = 6
    path = write(tmp_path / "a.png", "RGB", exif=exif)
    upright = next(open_pages(path, large=True).read())
    assert upright.shape == (COLS, ROWS, 3)


def test_large_pictures_that_are_not_reduced_are_refused(tmp_path: Path, limits: None) -> None:
    path = write(tmp_path / "a.png", "RGB")
    with pytest.raises(Rejected, match="NS0734"):  # readers of training and of folders
        read_picture(path)
    deep = tmp_path / "deep.png"
    Image.fromarray(np.zeros((ROWS, COLS), np.uint16)).save(deep)
    clip = tmp_path / "clip.webp"
    write(clip, "RGB", save_all=True, append_images=[Image.new("RGB", (COLS, ROWS), "red")])
    larger = tmp_path / "larger.png"
    Image.new("RGB", (COLS, ROWS + 1)).save(larger)
    for path, most in ((deep, pages.MOST_PIXELS), (clip, pages.MOST_PIXELS), (larger, ROWS * COLS)):
        with pytest.raises(Rejected, match="NS0734") as raised:
            light(path, "scale")
        assert f"at most {most:,} are allowed" in str(raised.value)
