"""What `nscc demo` takes a scene for: a still or a clip, and by which curve its files are read."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
import pytest
from scipy.io import savemat

from nscc_runtime.scene_settings import Scene
from nscc_training.demo.subject import subject


def scene_of(path: Path, **values: object) -> Scene:
    return Scene(str(path), **values)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("ending", "asked", "taken"),
    [
        (".png", None, "srgb"),
        (".png", "linear", "linear"),
        (".hdr", None, "linear"),
        (".hdr", "srgb", "srgb"),
    ],
)
def test_a_given_transfer_curve_replaces_the_default(
    tmp_path: Path, ending: str, asked: str | None, taken: str
) -> None:
    path = tmp_path / f"a{ending}"
    cv2.imwrite(str(path), np.full((8, 8, 3), 9, np.float32 if ending == ".hdr" else np.uint8))
    found = subject(scene_of(path, transfer=asked), 8, 0.1)
    assert found.still
    assert found.transfer == taken
    assert not found.in_electrons


@pytest.mark.parametrize(("shape", "still"), [((6, 8), True), ((4, 6, 8), False)])
@pytest.mark.parametrize("ending", [".npz", ".npy", ".mat"])
def test_arrays_are_light_in_electrons(
    tmp_path: Path, shape: tuple[int, ...], still: bool, ending: str
) -> None:
    path, light = tmp_path / f"a{ending}", np.ones(shape, np.float32)
    if ending == ".npz":
        np.savez(path, light=light)
    elif ending == ".npy":
        np.save(path, light)
    else:
        savemat(path, {"light": light})
    found = subject(scene_of(path), 8, 0.1)
    assert found.in_electrons
    assert found.still == still
    assert found.transfer == "linear"


def test_clips_of_the_benchmark_have_no_unit(tmp_path: Path) -> None:
    savemat(tmp_path / "a.mat", {"orig": np.ones((6, 8, 4), np.uint8)})
    found = subject(scene_of(tmp_path / "a.mat"), 8, 0.1)
    assert not found.still
    assert not found.in_electrons
    assert found.transfer == "linear"
    asked = subject(scene_of(tmp_path / "a.mat", transfer="srgb"), 8, 0.1)
    assert asked.transfer == "srgb"
