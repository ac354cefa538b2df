"""Scenes from files: every format against values computed here, and one clear error otherwise."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from one_scene import load_scene

from nscc.diagnostics.diagnostic import Diagnostic, Rejected
from nscc_runtime.light import Light
from nscc_runtime.scenes import ExposureLevel, parse_crop, parse_exposure
from nscc_runtime.scenes.picture_light import picture_light

ROWS, COLS = 16, 24
SLOT_US = (100.0, 200.0, 400.0)
WEIGHTS = np.array([0.2126, 0.7152, 0.0722])


def load(path: Path | str, **options: Any) -> Light:
    settings: dict[str, Any] = {"slot_us": SLOT_US, "rows": ROWS, "cols": COLS} | options
    return load_scene(str(path), **settings)


def rejection(path: Path | str, **options: Any) -> Diagnostic:
    with pytest.raises(Rejected) as caught:
        load(path, **options)
    assert caught.value.status == 2
    (diagnostic,) = caught.value.diagnostics
    return diagnostic


def srgb(values: np.ndarray) -> np.ndarray:
    """The curve of IEC 61966-2-1, sample by sample."""
    flat = [v / 12.92 if v <= 0.04045 else ((v + 0.055) / 1.055) ** 2.4 for v in values.flat]
    return np.reshape(flat, values.shape)


def exposed(luminance: np.ndarray, electrons: float, percentile: float = 99.0) -> np.ndarray:
    """Electrons of each pixel over the whole frame."""
    return luminance * electrons / np.percentile(luminance, percentile)


def colours(seed: int = 0, shape: tuple[int, int] = (ROWS, COLS)) -> np.ndarray:
    return np.random.default_rng(seed).random((*shape, 3)).astype(np.float32)


@pytest.mark.parametrize("dtype", [np.float32, np.float64, np.float16, np.uint16, np.int64])
@pytest.mark.parametrize("fortran", [False, True])
def test_light_clips_are_electrons_a_slot(tmp_path: Path, dtype: Any, fortran: bool) -> None:
    """An array of three axes is taken as it is, for each dtype and order in memory, from `.npz` and
    `.npy`."""
    clip = (np.random.default_rng(0).random((3, ROWS, COLS)) * 1000).astype(dtype)
    stored = np.asfortranarray(clip) if fortran else clip
    np.savez(tmp_path / "a.npz", light=stored)
    np.savez_compressed(tmp_path / "b.npz", other=1, light=stored)
    np.save(tmp_path / "c.npy", stored)
    for name in ("a.npz", "b.npz", "c.npy"):
        light = load(tmp_path / name)
        assert light.kind == "clip"
        assert light.exposure_scale_e == 1.0
        np.testing.assert_array_equal(light.dense(), clip.astype(np.float32))


def test_light_stills_are_electrons_a_second(tmp_path: Path) -> None:
    """An array of two axes, times the length of a slot in seconds, is the light of the slot."""
    still = np.random.default_rng(1).random((ROWS, COLS)) * 1e6
    np.savez(tmp_path / "s.npz", light=still)
    light = load(tmp_path / "s.npz")
    assert light.kind == "still"
    for n, us in enumerate(SLOT_US):
        np.testing.assert_allclose(light.slot(n), still * us * 1e-6, rtol=2e-7)


def test_mat_files_are_light_or_benchmark_clips(tmp_path: Path) -> None:
    """An array `light` is taken as it is. The benchmark's `orig` is a linear clip of 0 to 255,
    cropped and scaled to the exposure."""
    from scipy.io import savemat

    clip = np.random.default_rng(2).random((3, ROWS, COLS))
    savemat(tmp_path / "l.mat", {"light": clip})
    np.testing.assert_array_equal(load(tmp_path / "l.mat").dense(), clip.astype(np.float32))
    orig = np.random.default_rng(3).integers(0, 256, (ROWS + 2, COLS, 5)).astype(np.uint8)
    savemat(tmp_path / "o.mat", {"orig": orig, "mask": orig})
    light = load(tmp_path / "o.mat", exposure=ExposureLevel(900.0, 50.0))
    linear = orig[1:-1, :, :3].transpose(2, 0, 1) / 255.0
    scale = 900.0 / np.percentile(linear.sum(axis=0), 50.0)
    assert light.exposure_scale_e == pytest.approx(scale, rel=1e-6)
    np.testing.assert_allclose(light.dense(), linear * scale, rtol=1e-6)


@pytest.mark.parametrize("suffix", [".hdr", ".pfm", ".exr"])
def test_linear_pictures_give_light_in_proportion_to_their_values(
    tmp_path: Path, suffix: str
) -> None:
    """The light is the weighted sum of the colours, scaled to the exposure. A slot of twice the
    time has twice the light."""
    rgb = colours(4) * 100
    path = tmp_path / f"p{suffix}"
    write_float(path, rgb)
    light = load(path, exposure=ExposureLevel(30000.0))
    # Radiance cuts colours to 8 bits of the largest one
    tolerance = 0.05 if suffix == ".hdr" else 1e-6
    np.testing.assert_allclose(light.total_e(), exposed(rgb @ WEIGHTS, 30000.0), rtol=tolerance)
    assert light.kind == "still"
    np.testing.assert_allclose(light.slot(1), 2 * light.slot(0), rtol=1e-6)


def test_grey_portable_float_maps_are_as_they_lie(tmp_path: Path) -> None:
    """Rows from the bottom up, columns from left to right, as the format's description has it."""
    grey = colours(8)[..., 0]
    head = f"Pf\n{COLS} {ROWS}\n-1.0\n".encode()
    (tmp_path / "p.pfm").write_bytes(head + grey[::-1].astype("<f4").tobytes())
    light = load(tmp_path / "p.pfm", exposure=ExposureLevel(30000.0))
    np.testing.assert_allclose(light.total_e(), exposed(grey, 30000.0), rtol=1e-6)


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
@pytest.mark.parametrize("channels", [1, 3, 4])
def test_float_tiffs_of_any_number_of_channels_are_light(
    tmp_path: Path, dtype: Any, channels: int
) -> None:
    import cv2

    rgb = colours(9).astype(dtype)
    alpha = np.full((ROWS, COLS, 1), 0.5, dtype)
    stored = {1: rgb[..., :1], 3: rgb[..., ::-1], 4: np.dstack([rgb[..., ::-1], alpha])}[channels]
    assert cv2.imwrite(str(tmp_path / "p.tiff"), stored)
    said: list[Diagnostic] = []
    load(tmp_path / "p.tiff", exposure=ExposureLevel(500.0), warn=said.append)
    assert "--transfer linear" in said[-1].helps[0]
    said.clear()
    settings: dict[str, Any] = {"transfer": "linear", "warn": said.append}
    light = load(tmp_path / "p.tiff", exposure=ExposureLevel(500.0), **settings)
    assert not any("sRGB" in each.message for each in said)
    luminance = rgb[..., 0] if channels == 1 else rgb @ WEIGHTS
    np.testing.assert_allclose(light.total_e(), exposed(luminance, 500.0), rtol=1e-6)


def write_float(path: Path, rgb: np.ndarray) -> None:
    if path.suffix == ".exr":
        import OpenEXR

        header = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}
        OpenEXR.File(header, {"RGB": np.ascontiguousarray(rgb)}).write(str(path))
    else:
        import cv2

        assert cv2.imwrite(str(path), rgb[..., ::-1])


@pytest.mark.parametrize("transfer", [None, "srgb", "linear"])
def test_display_pictures_undo_their_curve(tmp_path: Path, transfer: Any) -> None:
    """PNG values are sRGB unless `linear` is asked for: the curve is undone before colours are
    summed."""
    from PIL import Image

    stored = (colours(5) * 255).astype(np.uint8)
    Image.fromarray(stored).save(tmp_path / "p.png")
    light = load(tmp_path / "p.png", exposure=ExposureLevel(500.0), transfer=transfer)
    values = stored / 255.0 if transfer == "linear" else srgb(stored / 255.0)
    np.testing.assert_allclose(light.total_e(), exposed(values @ WEIGHTS, 500.0), rtol=1e-6)


def test_pictures_of_16_bits_keep_their_precision(tmp_path: Path) -> None:
    """PNG and TIFF of 16 bits give light that is right to 1e-6, which 8 bits could not."""
    import cv2

    stored = (colours(6) * 65535).astype(np.uint16)
    for suffix in (".png", ".tif"):
        assert cv2.imwrite(str(tmp_path / f"p{suffix}"), stored[..., ::-1])
        light = load(tmp_path / f"p{suffix}", exposure=ExposureLevel(500.0))
        expected = exposed(srgb(stored / 65535.0) @ WEIGHTS, 500.0)
        np.testing.assert_allclose(light.total_e(), expected, rtol=1e-6)


def test_the_progress_function_gets_the_number_of_frames(tmp_path: Path) -> None:
    """A folder of three pictures calls it once, with the label and 3."""
    from PIL import Image

    seen: list[tuple[str, int | None]] = []

    def watch(items: Any, label: str, total: int | None) -> Any:
        seen.append((label, total))
        return items

    for k in range(3):
        Image.fromarray(np.full((ROWS, COLS), 50 + k, np.uint8)).save(tmp_path / f"{k}.png")
    load(tmp_path, exposure=ExposureLevel(1.0), progress=watch)
    assert seen == [("reading frames", 3)]


def test_animations_and_folders_of_pictures_are_clips(tmp_path: Path) -> None:
    from PIL import Image

    frames = [np.full((ROWS, COLS), v, np.uint8) for v in (10, 200, 90, 250)]
    for frame in frames:
        frame[0, 0] = 255  # keeps encoders from merging frames
    images = [Image.fromarray(frame) for frame in frames]
    images[0].save(tmp_path / "c.gif", save_all=True, append_images=images[1:])
    (tmp_path / "folder").mkdir()
    for k, image in enumerate(images):
        image.save(tmp_path / "folder" / f"f{k + 8}.png")  # f8 f9 f10 f11: natural order
    (tmp_path / "folder" / ".hidden.png").write_bytes(b"")
    (tmp_path / "folder" / "notes.txt").write_text("no picture")
    expected = srgb(np.array(frames[:3]) / 255.0)
    scale = 100.0 / np.percentile(expected.sum(axis=0), 99.0)
    for name in ("c.gif", "folder"):
        light = load(tmp_path / name, exposure=ExposureLevel(100.0))
        np.testing.assert_allclose(light.dense(), expected * scale, rtol=1e-5)


def test_videos_give_their_frames_to_the_slots(tmp_path: Path) -> None:
    import cv2

    writer = cv2.VideoWriter(
        str(tmp_path / "v.avi"), cv2.VideoWriter.fourcc(*"MJPG"), 25.0, (48, 32)
    )
    for value in (40, 120, 220):
        writer.write(np.full((32, 48, 3), value, np.uint8))
    writer.release()
    light = load(tmp_path / "v.avi", exposure=ExposureLevel(100.0))
    ratio = light.slot(2)[8, 12] / light.slot(0)[8, 12]
    known = srgb(np.array([220, 40]) / 255.0)
    # MJPG is lossy.
    assert ratio == pytest.approx(known[0] / known[1], rel=0.1)
    assert (
        rejection(tmp_path / "v.avi", exposure=ExposureLevel(1.0), slot_us=(1.0,) * 4).code
        == "NS0735"
    )


def test_pictures_are_cropped_to_the_array(tmp_path: Path) -> None:
    picture = colours(7, (ROWS + 5, COLS + 4))
    write_float(tmp_path / "p.pfm", picture)
    grey = picture @ WEIGHTS
    centre = load(tmp_path / "p.pfm", exposure=ExposureLevel(10.0)).total_e()
    np.testing.assert_allclose(centre, exposed(grey[2:-3, 2:-2], 10.0), rtol=1e-6)
    corner = load(tmp_path / "p.pfm", exposure=ExposureLevel(10.0), crop=(5, 0)).total_e()
    np.testing.assert_allclose(corner, exposed(grey[5:, :-4], 10.0), rtol=1e-6)
    outside = rejection(tmp_path / "p.pfm", exposure=ExposureLevel(10.0), crop=(6, 0))
    assert outside.code == "NS0734"
    assert "R may be 0 to 5" in outside.helps[0]
    small = rejection(tmp_path / "p.pfm", exposure=ExposureLevel(10.0), rows=100)
    assert small.code == "NS0734"
    assert "21 x 28" in small.message
    assert "100 x 24" in small.message


def test_tiny_negatives_are_counted_and_clamped(tmp_path: Path) -> None:
    """Three values of -1e-4 become 0 with the warning NS0740. A value of -0.5 is refused with
    NS0736."""
    picture = np.ones((ROWS, COLS, 3), np.float32)
    picture[0, :3] = -1e-4
    write_float(tmp_path / "p.pfm", picture)
    said: list[Diagnostic] = []
    light = load(tmp_path / "p.pfm", exposure=ExposureLevel(10.0), warn=said.append)
    assert [d.code for d in said] == ["NS0740"]
    assert said[0].data["count"] == 3
    assert light.total_e()[0, 0] == 0
    picture[0, 0] = -0.5
    write_float(tmp_path / "p.pfm", picture)
    assert rejection(tmp_path / "p.pfm", exposure=ExposureLevel(10.0)).code == "NS0736"


@pytest.mark.parametrize("white", [0.005, 1.0, 200.0])
def test_negatives_are_tolerated_as_fractions_of_white(tmp_path: Path, white: float) -> None:
    """At each white, -0.0001 of it becomes 0 and -0.1 of it is refused."""
    picture = np.full((ROWS, COLS, 3), white, np.float32)
    picture[0, 0] = -1e-4 * white
    light = picture_light(picture, "linear", "p", white=white)
    assert light[0, 0] == 0
    picture[0, 0] = -0.1 * white
    with pytest.raises(Rejected) as raised:
        picture_light(picture, "linear", "p", white=white)
    assert raised.value.diagnostics[0].code == "NS0736"


@pytest.mark.parametrize("outside", [np.inf, np.nan])
def test_values_outside_the_crop_do_not_hide_negative_light(tmp_path: Path, outside: float) -> None:
    """An infinite or NaN pixel outside of the crop is no fault. Inside, a tiny negative becomes 0
    and a large one is refused."""
    picture = np.ones((2 * ROWS, COLS, 3), np.float32)
    picture[0, 0], picture[ROWS, 3] = outside, -1e-5
    write_float(tmp_path / "p.exr", picture)
    light = load(tmp_path / "p.exr", exposure=ExposureLevel(10.0), crop=(ROWS // 2, 0))
    assert light.total_e()[ROWS // 2, 3] == 0
    picture[ROWS, 3] = -1000.0
    write_float(tmp_path / "p.exr", picture)
    found = rejection(tmp_path / "p.exr", exposure=ExposureLevel(10.0), crop=(ROWS // 2, 0))
    assert found.code == "NS0736"


@pytest.mark.parametrize(
    ("value", "word"), [(np.nan, "NaN"), (np.inf, "large"), (-1.0, "negative")]
)
def test_invalid_light_values_are_refused_with_their_count_and_place(
    tmp_path: Path, value: float, word: str
) -> None:
    clip = np.ones((3, ROWS, COLS))
    clip[1, 2, 3] = clip[2, 0, 0] = value
    np.savez(tmp_path / "a.npz", light=clip)
    found = rejection(tmp_path / "a.npz")
    assert found.code == "NS0736"
    assert "2 light values" in found.message
    assert word in found.message
    assert "[1, 2, 3]" in found.notes[0]


@pytest.mark.parametrize("dtype", [np.float16, np.float32, np.float64])
def test_infinite_light_of_any_width_is_counted(dtype: type, tmp_path: Path) -> None:
    """One infinity of each sign and one -1 are counted as `2 too large, 1 negative`."""
    still = np.ones((ROWS, COLS), dtype)
    still[1, 0], still[2, 1], still[0, 0] = np.inf, -np.inf, -1
    np.savez(tmp_path / "s.npz", light=still)
    with pytest.raises(Rejected) as caught:
        load(tmp_path / "s.npz")
    (diagnostic,) = caught.value.diagnostics
    assert diagnostic.code == "NS0736"
    assert "2 too large, 1 negative" in diagnostic.message


def test_float64_beyond_float32_is_too_large(tmp_path: Path) -> None:
    """1e39 electrons, and 3e38 a second for two seconds, do not fit float32: NS0736."""
    np.savez(tmp_path / "a.npz", light=np.full((3, ROWS, COLS), 1e39))
    assert rejection(tmp_path / "a.npz").code == "NS0736"
    # A still is in electrons a second: 2 s make 6e38, above float32's 3.4e38.
    np.savez(tmp_path / "b.npz", light=np.full((ROWS, COLS), 3e38))
    assert rejection(tmp_path / "b.npz", slot_us=(2e6,)).code == "NS0736"


@pytest.mark.parametrize(
    ("arrays", "code"),
    [
        ({"image": np.ones((3, ROWS, COLS))}, "NS0733"),
        ({"light": np.ones((3, ROWS, COLS), bool)}, "NS0733"),
        ({"light": np.ones((3, ROWS, COLS), complex)}, "NS0733"),
        ({"light": np.full((3, ROWS, COLS), "a")}, "NS0733"),
        ({"light": np.full((3, ROWS, COLS), None)}, "NS0733"),
        ({"light": np.float64(3.0)}, "NS0733"),
        ({"light": np.ones(5)}, "NS0733"),
        ({"light": np.ones((1, 3, ROWS, COLS))}, "NS0733"),
        ({"light": np.ones((ROWS, COLS + 1))}, "NS0734"),
        ({"light": np.ones((3, COLS, ROWS))}, "NS0734"),
        ({"light": np.ones((4, ROWS, COLS))}, "NS0735"),
        ({"light": np.ones((0, ROWS, COLS))}, "NS0735"),
    ],
)
def test_arrays_of_wrong_name_type_or_shape_are_refused_as_scenes(
    tmp_path: Path, arrays: dict[str, Any], code: str
) -> None:
    np.savez(tmp_path / "a.npz", **arrays)
    assert rejection(tmp_path / "a.npz").code == code


@pytest.mark.parametrize(
    ("spec", "options", "code"),
    [
        ("nothing.npz", {}, "NS0730"),
        ("builtin:moton", {}, "NS0731"),
        ("builtin:flat", {}, "NS0731"),
        ("builtin:flat:-1", {}, "NS0731"),
        ("builtin:flat:nan", {}, "NS0731"),
        ("builtin:dark:3", {}, "NS0731"),
        ("builtin:", {}, "NS0731"),
        ("builtin:hdr", {"fps": 3.0}, "NS0739"),
        ("builtin:hdr", {"crop": (0, 0)}, "NS0739"),
        ("builtin:dark", {"exposure": ExposureLevel(5.0)}, "NS0738"),
        ("builtin:hdr", {"exposure": ExposureLevel(1e38, 0.0)}, "NS0738"),
        ("a\0b", {}, "NS0730"),
        ("x" * 5000, {}, "NS0730"),
    ],
)
def test_wrong_scene_names_and_options_are_refused(
    spec: str, options: dict[str, Any], code: str
) -> None:
    assert rejection(spec, **options).code == code


def test_options_that_do_not_suit_the_kind_of_scene_are_refused(tmp_path: Path) -> None:
    write_float(tmp_path / "p.pfm", colours())
    np.savez(tmp_path / "a.npz", light=np.ones((ROWS, COLS)))
    assert rejection(tmp_path / "p.pfm").code == "NS0737"
    assert rejection(tmp_path / "p.pfm", exposure=ExposureLevel(1.0), fps=5.0).code == "NS0739"
    assert rejection(tmp_path / "a.npz", fps=5.0).code == "NS0739"
    assert rejection(tmp_path / "a.npz", transfer="srgb").code == "NS0739"
    assert rejection(tmp_path / "a.npz", first=1).code == "NS0739"
    assert rejection(tmp_path / "p.pfm", exposure=ExposureLevel(1.0), first=1).code == "NS0739"
    np.savez(tmp_path / "clip.npz", light=np.ones((3, ROWS, COLS)))
    for spec in (tmp_path / "clip.npz", "builtin:motion"):
        assert "--still" in rejection(spec, exposure=ExposureLevel(1.0), single=True).message
    assert load("builtin:hdr", exposure=ExposureLevel(1.0), single=True).kind == "still"
    (tmp_path / "a.xyz").write_text("")
    assert rejection(tmp_path / "a.xyz").code == "NS0731"
    (tmp_path / "empty").mkdir()
    assert rejection(tmp_path / "empty", exposure=ExposureLevel(1.0)).code == "NS0735"


def test_exposure_and_crop_are_parsed() -> None:
    """`3e4` means 30 000 electrons at the 99th percentile. Zero, NaN, percentiles outside 0 to 100
    and broken texts are refused."""
    assert parse_exposure("3e4") == ExposureLevel(30000.0, 99.0)
    assert parse_exposure("100@0") == ExposureLevel(100.0, 0.0)
    assert parse_crop("3,12") == (3, 12)
    for text in ("", "0", "-5", "nan", "inf", "1@", "1@101", "1@-1", "1@nan", "1@2@3", "x"):
        with pytest.raises(Rejected):
            parse_exposure(text)
    for text in ("", "3", "3,", "a,b", "-1,0", "1,2,3", "1e3,0"):
        with pytest.raises(Rejected):
            parse_crop(text)
