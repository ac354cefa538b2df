"""Colours that files state: ICC profiles, numbers of H.273 and gamma give the light they mean."""

from __future__ import annotations

import struct
import zlib
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import tifffile
from one_scene import load_scene
from PIL import Image, ImageCms

from nscc.diagnostics.diagnostic import Diagnostic
from nscc_runtime.scenes import ExposureLevel
from nscc_runtime.scenes.bracket import merged_bracket
from nscc_runtime.scenes.picture_files import open_pages

ROWS, COLS = 8, 9
ADOBE_Y = (0.31111, 0.62567, 0.06322)
"""Luminances of the primaries of Adobe RGB (1998), adapted to D50."""


def profile(curve: bytes, luminances: tuple[float, ...] = ADOBE_Y, grey: bool = False) -> bytes:
    """An ICC profile of version 2 or 4 with one curve for all colours."""

    def xyz(y: float) -> bytes:
        return b"XYZ \0\0\0\0" + struct.pack(">3i", *(round(v * 65536) for v in (y, y, y)))

    text = b"test curve"
    description = b"desc\0\0\0\0" + struct.pack(">I", len(text) + 1) + text + bytes(80)
    tags = {
        b"desc": description,
        b"wtpt": b"XYZ \0\0\0\0" + struct.pack(">3i", 63190, 65536, 54061),
    }
    if grey:
        tags[b"kTRC"] = curve
    else:
        for name, y in zip("rgb", luminances, strict=True):
            tags[f"{name}XYZ".encode()] = xyz(y)
            tags[f"{name}TRC".encode()] = curve
    body, entries = b"", b""
    start = 132 + 12 * len(tags)
    for name, data in tags.items():
        entries += name + struct.pack(">II", start + len(body), len(data))
        body += data + bytes(-len(data) % 4)
    space = b"GRAY" if grey else b"RGB "
    head = struct.pack(
        ">I4sI4s4s4s", start + len(body), b"\0" * 4, 0x02400000, b"mntr", space, b"XYZ "
    )
    head += bytes(12) + b"acsp" + bytes(28) + struct.pack(">3i", 63190, 65536, 54061) + bytes(48)
    return head + struct.pack(">I", len(tags)) + entries + body


def power(gamma: float) -> bytes:
    return b"curv\0\0\0\0" + struct.pack(">IH", 1, round(gamma * 256))


FALLING = b"curv\0\0\0\0" + struct.pack(">I3H", 3, 65535, 9, 0)
LINEAR = b"curv\0\0\0\0" + struct.pack(">I", 0)


def luminance(path: Path, **options: Any) -> tuple[np.ndarray, list[Diagnostic]]:
    """The light of a still, in units of one electron of full exposure at white 1."""
    said: list[Diagnostic] = []
    light = load_scene(
        str(path),
        slot_us=(10.0,),
        rows=ROWS,
        cols=COLS,
        warn=said.append,
        **{"exposure": ExposureLevel(1.0, 100.0), **options},
    )
    return np.asarray(light.dense()[0]), said


def colours_and_white(dtype: Any) -> np.ndarray:
    """Columns of red, green, blue, and of white."""
    picture = np.zeros((ROWS, COLS, 3), dtype)
    top = np.iinfo(dtype).max
    for k in range(3):
        picture[:, k, k] = top
    picture[:, 3:] = top
    return picture


WRITERS: dict[str, Any] = {
    "tif": {"compression": "raw"},
    "jpg": {"quality": 100, "subsampling": 0},
    "png": {},
    "webp": {"lossless": True},
    "avif": {"quality": 100, "subsampling": "4:4:4"},
}


@pytest.mark.parametrize("ending", [*WRITERS, "heic"])
def test_adobe_rgb_gives_its_luminances(tmp_path: Path, ending: str) -> None:
    path = tmp_path / f"a.{ending}"
    big = np.repeat(np.repeat(colours_and_white(np.uint8)[:1], 64, 0), 8, 1)
    image = Image.fromarray(big)
    if ending == "heic":
        heif = pytest.importorskip("pillow_heif")
        file = heif.from_pillow(image)
        file.save(path, quality=-1, chroma=444, icc_profile=profile(power(2.2)))
    else:
        image.save(path, icc_profile=profile(power(2.2)), **WRITERS[ending])
    light, said = load_scene_with_notes(path, big.shape[:2])
    red, green, blue = (float(light[32, 8 * k + 4]) for k in range(3))
    assert green / red == pytest.approx(ADOBE_Y[1] / ADOBE_Y[0], rel=0.05)
    assert blue / green == pytest.approx(ADOBE_Y[2] / ADOBE_Y[1], rel=0.1)
    assert any("test curve" in note.message for note in said)


def load_scene_with_notes(path: Path, size: tuple[int, int]) -> tuple[np.ndarray, list[Diagnostic]]:
    said: list[Diagnostic] = []
    light = load_scene(
        str(path),
        slot_us=(10.0,),
        rows=size[0],
        cols=size[1],
        warn=said.append,
        exposure=ExposureLevel(1.0, 100.0),
    )
    return np.asarray(light.dense()[0]), said


SAMPLES = (0, 4096, 16384, 36864, 65535)
PARAMETERS = tuple(round(p * 65536) for p in (3.0, 1 / 1.055, 0.055 / 1.055, 1 / 12.92, 0.04045))
CURVES = {
    "linear": (LINEAR, lambda v: v),
    "power": (power(1.8), lambda v: v ** (round(1.8 * 256) / 256)),
    "table": (
        b"curv\0\0\0\0" + struct.pack(">I5H", 5, *SAMPLES),
        lambda v: np.interp(v, np.linspace(0, 1, 5), np.array(SAMPLES) / 65535),
    ),
    "parametric": (
        b"para\0\0\0\0" + struct.pack(">HH5i", 3, 0, *PARAMETERS),
        lambda v: np.where(v >= 0.04045, ((v + 0.055) / 1.055) ** 3.0, v / 12.92),
    ),
}  # fmt: skip


@pytest.mark.parametrize("curve", CURVES)
@pytest.mark.parametrize("ending", ["tif", "png"])
@pytest.mark.parametrize("grey", [False, True])
def test_curves_of_profiles_are_applied_in_16_bits(
    tmp_path: Path, curve: str, ending: str, grey: bool
) -> None:
    data, expected = CURVES[curve]
    values = np.linspace(0, 65535, COLS).round().astype(np.uint16)
    picture = np.tile(values, (ROWS, 1))
    if not grey:
        picture = np.repeat(picture[..., None], 3, axis=-1)
    path, icc = tmp_path / f"a.{ending}", profile(data, grey=grey)
    if ending == "tif":
        photometric = "minisblack" if grey else "rgb"
        tifffile.imwrite(path, picture, photometric=photometric, iccprofile=icc)
    else:
        write_png(path, picture, {b"iCCP": b"icc\0\0" + zlib.compress(icc)})
    light, _ = luminance(path)
    np.testing.assert_allclose(light[0], expected(values / 65535.0), atol=2e-5)
    assert light[0, 4] == pytest.approx(float(expected(values[4] / 65535.0)), rel=1e-3)
    chosen, said = luminance(path, transfer="srgb")
    # Half of white on the sRGB curve is 0.2140 of its light.
    assert chosen[0, 4] == pytest.approx(0.2140, rel=1e-3)
    assert not any("profile" in note.message for note in said)


def write_png(path: Path, picture: np.ndarray, chunks: dict[bytes, bytes]) -> None:
    import cv2

    _, encoded = cv2.imencode(".png", picture)
    data = encoded.tobytes()
    for name, content in chunks.items():
        crc = struct.pack(">I", zlib.crc32(name + content))
        data = data[:33] + struct.pack(">I", len(content)) + name + content + crc + data[33:]
    path.write_bytes(data)


def test_cicp_numbers_precede_the_icc_profile_and_gamma(tmp_path: Path) -> None:
    picture = np.full((ROWS, COLS), 32768, np.uint16)
    picture[0, 0] = 65535
    icc = {b"iCCP": b"icc\0\0" + zlib.compress(profile(LINEAR, grey=True))}
    gamma = {b"gAMA": struct.pack(">I", 55556)}
    numbers = {b"cICP": bytes([1, 13, 0, 1])}
    # Light of half of white: sRGB, linear, the power 1 / 0.55556 = 1.8, and sRGB by default.
    for chunks, half in (
        (gamma | icc | numbers, 0.214),
        (gamma | icc, 0.5),
        (gamma, 0.5**1.8),
        ({}, 0.214),
    ):
        write_png(tmp_path / "a.png", picture, chunks)
        assert luminance(tmp_path / "a.png")[0][1, 1] == pytest.approx(half, rel=1e-3)


@pytest.mark.parametrize("icc", [b"nothing", profile(LINEAR)[:200], profile(FALLING)])
def test_a_damaged_profile_is_named_and_not_used(tmp_path: Path, icc: bytes) -> None:
    """A profile that is no profile, is cut off or falls is named in a note. The picture is read as
    sRGB."""
    picture = np.full((ROWS, COLS, 3), 32768, np.uint16)
    picture[0, 0] = 65535
    tifffile.imwrite(tmp_path / "a.tif", picture, photometric="rgb", iccprofile=icc)
    light, said = luminance(tmp_path / "a.tif")
    # Half of white on the sRGB curve, as without a profile.
    assert light[1, 1] == pytest.approx(0.214, rel=1e-3)
    assert ["damaged colour profile" in note.message for note in said] == [True]


def test_srgb_is_not_noted(tmp_path: Path) -> None:
    icc = ImageCms.ImageCmsProfile(ImageCms.createProfile("sRGB")).tobytes()
    Image.fromarray(colours_and_white(np.uint8)).save(tmp_path / "a.png", icc_profile=icc)
    pages = open_pages(tmp_path / "a.png")
    assert (pages.colours.transfer, pages.stated.notes) == ("srgb", ())


@pytest.mark.parametrize("as_bracket", [False, True])
def test_folders_and_brackets_use_profiles(tmp_path: Path, as_bracket: bool) -> None:
    for number, value in enumerate((16384, 32768)):
        picture = np.full((ROWS, COLS, 3), value, np.uint16)
        path = tmp_path / f"{number}.tif"
        tifffile.imwrite(path, picture, photometric="rgb", iccprofile=profile(LINEAR))
    if as_bracket:
        files = sorted(tmp_path.iterdir())
        light, colours = merged_bracket(files, (1.0, 2.0))
        np.testing.assert_allclose(light, 0.25, rtol=1e-4)
        np.testing.assert_allclose(colours.weights, ADOBE_Y, atol=1e-3)
        return
    settings: dict[str, Any] = {"rows": ROWS, "cols": COLS, "exposure": ExposureLevel(1.0)}
    said: list[Diagnostic] = []
    light = load_scene(str(tmp_path), slot_us=(10.0, 10.0), warn=said.append, **settings).dense()
    assert light[1, 0, 0] / light[0, 0, 0] == pytest.approx(2, rel=1e-4)
    assert len([note for note in said if "test curve" in note.message]) == 1


def test_heic_and_avif_with_the_pq_curve_are_linearised(tmp_path: Path) -> None:
    """White of PQ at 0.5081 is 1 % of its peak."""
    heif = pytest.importorskip("pillow_heif")
    picture = np.full((64, 64, 3), 255, np.uint8)
    picture[:, 32:] = round(0.508078 * 255)
    file = heif.from_pillow(Image.fromarray(picture))
    file.save(
        tmp_path / "a.heic",
        quality=-1,
        chroma=444,
        color_primaries=9,
        transfer_characteristics=16,
        matrix_coefficients=9,
        full_range_flag=1,
    )
    light, said = load_scene_with_notes(tmp_path / "a.heic", (64, 64))
    assert light[32, 48] / light[32, 16] == pytest.approx(0.01, rel=0.05)
    assert any("primaries" in note.message for note in said)


def test_an_avif_without_a_profile_is_linearised_by_its_numbers(tmp_path: Path) -> None:
    """The file's numbers say the PQ curve (16): a code of 0.508 is 1 % of the peak."""
    picture = np.full((64, 64, 3), 255, np.uint8)
    picture[:, 32:] = round(0.508078 * 255)
    Image.fromarray(picture).save(tmp_path / "a.avif", quality=100, subsampling="4:4:4")
    data = bytearray((tmp_path / "a.avif").read_bytes())
    at = data.index(b"colrnclx") + 8
    data[at : at + 4] = struct.pack(">HH", 1, 16)
    (tmp_path / "a.avif").write_bytes(data)
    light, _ = load_scene_with_notes(tmp_path / "a.avif", (64, 64))
    # 0.508 on the PQ curve is 1 % of its peak; lossy coding leaves a few percent.
    assert light[32, 48] / light[32, 16] == pytest.approx(0.01, rel=0.05)


def test_adobe_rgb_is_recognised_by_exif_data(tmp_path: Path) -> None:
    """A JPEG whose Exif data says R03 has the colour weights of Adobe RGB, and a note names it."""

    def directory(tag: int, kind: int, count: int, value: bytes) -> bytes:
        return struct.pack("<HHHI", 1, tag, kind, count) + value + bytes(4)

    exif = b"Exif\0\0II*\0" + struct.pack("<I", 8)
    exif += directory(0x8769, 4, 1, struct.pack("<I", 26))
    exif += directory(0xA005, 4, 1, struct.pack("<I", 44)) + directory(1, 2, 4, b"R03\0")
    image = Image.fromarray(np.repeat(np.repeat(colours_and_white(np.uint8)[:1], 64, 0), 8, 1))
    image.save(tmp_path / "a.jpg", exif=exif, quality=100, subsampling=0)
    light, said = load_scene_with_notes(tmp_path / "a.jpg", (64, 72))
    assert light[32, 12] / light[32, 4] == pytest.approx(ADOBE_Y[1] / ADOBE_Y[0], rel=0.05)
    assert "Adobe RGB" in said[0].message
