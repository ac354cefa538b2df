"""What loading a scene says of it: frames that are missing, white levels, places of bad pixels."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from one_scene import load_scene
from PIL import Image

from nscc.diagnostics.diagnostic import Diagnostic, Rejected, Severity
from nscc_runtime.scenes import ExposureLevel
from nscc_runtime.scenes.picture_folders import missing_frames

ROWS, COLS = 8, 10


def light_of(path: Path, slots: int = 1, **options: Any) -> tuple[np.ndarray, list[Diagnostic]]:
    said: list[Diagnostic] = []
    light = load_scene(
        str(path),
        slot_us=(10.0,) * slots,
        rows=ROWS,
        cols=COLS,
        warn=said.append,
        **{"exposure": ExposureLevel(1.0, 100.0), **options},
    )
    return np.asarray(light.dense()), said


def refusal(path: Path, slots: int = 1, **options: Any) -> Diagnostic:
    with pytest.raises(Rejected) as caught:
        light_of(path, slots, **options)
    (diagnostic,) = caught.value.diagnostics
    return diagnostic


@pytest.mark.parametrize(
    ("pictures", "others", "count"),
    [
        (["1.png", "2.png", "3.png"], ["notes.txt", "Thumbs.db", ".4.png"], 0),
        (["8.png", "9.png", "10.png"], [], 0),
        (["0.png", "10.png", "20.png"], [], 0),
        (["1.png", "2.png", "4.png"], [], 1),
        (["1.png", "3.png", "4.png"], [], 1),
        (["10.png", "20.png", "40.png"], [], 1),
        (["1.png", "2.png", "4.png"], ["3.heic"], 1),
        (["1.png", "2.png"], ["3.heic"], 1),
        (["1.png", "2.png"], ["3.xyz"], 1),
        (["a1.png", "a2.png"], ["b3.xyz", "a1.json", "a2.json", "a.txt"], 0),
        (["1.png", "2.png", "9.png"], ["3.xyz"], 2),
        (["cam1_0001.png", "cam1_0002.png", "cam1_0004.png"], [], 1),
        (["1700000001.23.png", "1700000002.11.png", "1700000004.97.png"], [], 0),
        (["103.png", "207.png", "333.png", "409.png"], [], 0),
        (["beach.png", "forest.png"], [], 0),
        (["beach.png", "forest.png"], ["city.psd"], 1),
        (["1.png", "2.png", "3.png", f"{10**17}.png"], [], 1),
    ],
)
def test_missing_numbers_of_a_folder_are_counted(
    pictures: list[str], others: list[str], count: int
) -> None:
    assert len(missing_frames(pictures, [*pictures, *others])) == count


@pytest.mark.parametrize("fault", ["gap", "heic", "damaged"])
def test_missing_frames_are_refused_or_skipped(tmp_path: Path, fault: str) -> None:
    values = {1: 50, 2: 100, 4: 200} if fault == "gap" else {1: 50, 2: 100, 3: 200}
    for number, value in values.items():
        Image.fromarray(np.full((ROWS, COLS), value, np.uint8)).save(tmp_path / f"{number:03}.png")
    if fault != "gap":
        (tmp_path / f"004.{'heiq' if fault == 'heic' else 'png'}").write_bytes(b"no picture")
    found = refusal(tmp_path, 4 if fault == "damaged" else 3)
    assert found.code == ("NS0732" if fault == "damaged" else "NS0776")
    if fault != "damaged":
        assert "--skip" in found.helps[0]
        light, said = light_of(tmp_path, 3, skip=True, transfer="linear")
        np.testing.assert_allclose(light[:, 0, 0], [0.25 / 1.75, 0.5 / 1.75, 1 / 1.75], rtol=1e-6)
        assert [(d.code, d.severity) for d in said] == [("NS0776", Severity.WARNING)]
        return
    (tmp_path / "000.png").write_bytes(b"no picture")
    light, said = light_of(tmp_path, 3, skip=True, transfer="linear")
    np.testing.assert_allclose(light[:, 0, 0], [0.25 / 1.75, 0.5 / 1.75, 1 / 1.75], rtol=1e-6)
    assert [d.code for d in said] == ["NS0776"]
    assert "000.png" in said[0].notes[0]


@pytest.mark.parametrize("transfer", ["linear", "srgb"])
def test_a_clip_of_any_type_is_the_same_light(tmp_path: Path, transfer: Any) -> None:
    """uint8, whole floats of 0..255 and fractions of white."""
    from scipy.io import savemat

    clip = np.random.default_rng(0).integers(0, 256, (ROWS, COLS, 3)).astype(np.uint8)
    clip[0, 0, 0] = 200
    lights = []
    for number, orig in enumerate((clip, clip.astype(np.float64), clip / 255.0)):
        savemat(tmp_path / f"{number}.mat", {"orig": orig})
        lights.append(light_of(tmp_path / f"{number}.mat", 3, transfer=transfer)[0])
    np.testing.assert_allclose(lights[1], lights[0], rtol=1e-5)
    np.testing.assert_allclose(lights[2], lights[0], rtol=1e-5)


def test_twelve_bits_in_sixteen_give_a_message(tmp_path: Path) -> None:
    import cv2

    stored = np.random.default_rng(0).integers(0, 4096, (ROWS, COLS)).astype(np.uint16)
    stored[0, 0] = 4095
    cv2.imwrite(str(tmp_path / "p.png"), stored)
    _, said = light_of(tmp_path / "p.png")
    assert len(said) == 1
    assert "the sRGB curve and white at 65535; the largest is 4095" in said[0].message
    light, said = light_of(tmp_path / "p.png", white=4095.0)
    assert not said
    fraction = stored / 4095.0
    curve = np.where(fraction <= 0.04045, fraction / 12.92, ((fraction + 0.055) / 1.055) ** 2.4)
    np.testing.assert_allclose(light[0], curve, rtol=1e-5)
    for white in (0.0, -1.0, np.nan, np.inf):
        assert refusal(tmp_path / "p.png", white=white).code == "NS0739"
    np.savez(tmp_path / "a.npz", light=np.ones((1, ROWS, COLS)))
    assert refusal(tmp_path / "a.npz", white=255.0).code == "NS0739"


@pytest.mark.parametrize("options", [{}, {"crop": (4, 1)}, {"fit": "scale"}, {"fit": "tiles"}])
def test_bad_pixels_are_named_by_their_place_in_the_file(
    tmp_path: Path, options: dict[str, Any]
) -> None:
    """The NaN at row 8, column 9 is named by these, whatever crop or fit was asked for."""
    import cv2

    picture = np.ones((20, 24), np.float32)
    picture[8, 9] = np.nan
    cv2.imwrite(str(tmp_path / "p.pfm"), picture)
    found = refusal(tmp_path / "p.pfm", **options)
    assert found.code == "NS0736"
    assert "[row, column] = [8, 9]" in found.notes[0]
    assert found.data["first"] == [8, 9]


def test_frames_are_counted_from_the_clips_first(tmp_path: Path) -> None:
    from nscc_runtime.formats.content import Content
    from nscc_runtime.formats.format_table import tiff

    clip = np.ones((5, ROWS, COLS), np.float32)
    clip[3, 2, 1] = -1
    (tmp_path / "c.tiff").write_bytes(tiff(Content({"video": clip}, clip, True)))
    found = refusal(tmp_path / "c.tiff", 3, first=2, transfer="linear")
    assert "frame 3" in found.message
