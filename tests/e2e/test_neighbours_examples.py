"""The examples of version 3 on the command line, against SciPy."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from checkout import ROOT
from nscc_command import invoke
from scipy.ndimage import binary_erosion, correlate

EXAMPLES = ROOT / "examples"
STEP_E = 30000.0 / 127
CROSS = np.array([[0, 1, 0], [1, 1, 1], [0, 1, 0]], bool)
SOBEL = np.array([[1, 0, -1], [2, 0, -2], [1, 0, -1]]) / 8
GAUSS = np.array([[1, 2, 1], [2, 4, 2], [1, 2, 1]]) / 16
Array = np.ndarray[tuple[int, ...], np.dtype[np.float64]]
Arrays = dict[str, Array]


def frame_of(name: str, scene: str, folder: Path) -> Arrays:
    """The frame of an example and the light that it saw."""
    arguments = ["run", EXAMPLES / f"{name}.nsl", "--scene", scene, "-o", "f.npz"]
    outcome = invoke([*arguments, "--keep", "light"], folder)
    assert outcome.status == 0, outcome.err
    with np.load(folder / "f.npz") as data:
        return {key: data[key] for key in data if key != "meta"}


def exposure(
    frame: Arrays, slots: slice = slice(None)
) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
    return frame["light"][slots].astype(np.float64).sum(axis=0)


def test_the_example_edges_marks_strong_gradients(tmp_path: Path) -> None:
    frame = frame_of("edges", "builtin:hdr", tmp_path)
    light = exposure(frame)
    strength = abs(correlate(light, SOBEL)) + abs(correlate(light, SOBEL.T))
    sure = ~frame["margin"] & (abs(strength - 8 * STEP_E) > 1e-3)
    assert np.array_equal(frame["plane_edge"][sure], (strength > 8 * STEP_E)[sure])


def test_the_example_bright_spots_reports_their_places(tmp_path: Path) -> None:
    frame = frame_of("bright_spots", "builtin:hdr", tmp_path)
    core = binary_erosion(exposure(frame) > 51 * STEP_E, CROSS, border_value=0)
    rows, cols = np.nonzero(core)
    found = frame["report_events_core"]
    assert found.shape == (1000, 2)
    assert frame["report_events_core_overflow"] == (len(rows) > 1000)
    count = int(frame["report_events_core_count"])
    assert np.array_equal(found[:count], np.stack([cols, rows], axis=1)[:count])


def test_motion_in_a_frame_marks_pixels_that_changed(tmp_path: Path) -> None:
    frame = frame_of("motion_in_a_frame", "builtin:motion", tmp_path)
    change = correlate(exposure(frame, slice(4, 8)) - exposure(frame, slice(0, 4)), GAUSS)
    inside = ~frame["margin"]
    np.testing.assert_allclose(frame["image_change"][inside], change[inside], atol=1e-2)
    moved = (change > 5 * STEP_E) | (change < -5 * STEP_E)
    sure = inside & (abs(abs(change) - 5 * STEP_E) > 0.1)
    assert np.array_equal(frame["plane_moved"][sure], moved[sure])
    assert frame["report_any_sure"]


def test_the_example_local_contrast_divides_by_the_mean(tmp_path: Path) -> None:
    frame = frame_of("local_contrast", "builtin:hdr", tmp_path)
    short, long = exposure(frame, slice(0, 16)), exposure(frame)
    full = long > 114 * STEP_E
    hdr = np.where(full, short, long / 4)
    contrast = hdr - correlate(hdr, GAUSS)
    undecided = correlate((abs(long - 114 * STEP_E) < 0.1).astype(float), np.ones((3, 3))) > 0.5
    sure = ~frame["margin"] & ~undecided
    assert np.array_equal(frame["plane_full"][sure], full[sure])
    np.testing.assert_allclose(frame["image_contrast"][sure], contrast[sure], atol=1e-2)


@pytest.mark.parametrize("name", ["edges", "local_contrast"])
def test_a_picture_is_drawn(name: str, tmp_path: Path) -> None:
    arguments = ["run", EXAMPLES / f"{name}.nsl", "--scene", "builtin:hdr", "-o", "f.npz"]
    outcome = invoke([*arguments, "--effects", "all", "--png", "f.png"], tmp_path)
    assert outcome.status == 0, outcome.err
    assert (tmp_path / "f.png").read_bytes()[:4] == b"\x89PNG"
