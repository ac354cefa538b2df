"""Frames under slots: exact overlaps, against a fine sampling of time and known sums."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from one_scene import load_scene

from nscc.diagnostics.diagnostic import Rejected
from nscc_runtime.scenes import ExposureLevel, timing


def dense(found: timing.Overlaps, frames: int) -> np.ndarray:
    matrix = np.zeros((len(found.row_start) - 1, frames))
    for n in range(len(matrix)):
        for k in range(found.row_start[n], found.row_start[n + 1]):
            matrix[n, found.frame_index[k]] += found.seconds[k]
    return matrix


def test_overlaps_agree_with_intervals() -> None:
    """For four slots and five frames, each weight is the time in which slot and frame overlap."""
    slot_us = (1000.0, 2500.0, 300.0, 7000.0)
    fps = Fraction(400)
    edges = np.concatenate(([0], np.cumsum(slot_us))) * 1e-6
    frames = 5
    matrix = dense(timing.overlaps(slot_us, fps), frames)
    for n in range(4):
        for k in range(frames):
            inside = min(edges[n + 1], (k + 1) / 400) - max(edges[n], k / 400)
            assert matrix[n, k] == pytest.approx(max(inside, 0.0), abs=1e-15)


def test_a_slot_as_long_as_a_frame_contains_exactly_one_frame() -> None:
    for fps, length_us in ((1000, 1000.0), (10000, 100.0), (30, 1e6 / 30)):
        found = timing.overlaps((length_us,) * 300, timing.check_fps(float(fps)))
        big = found.seconds > 1e-9
        np.testing.assert_array_equal(found.frame_index[big], np.arange(300))


def test_every_slot_keeps_its_length() -> None:
    slot_us = tuple(float(v) for v in np.random.default_rng(0).integers(1, 9000, 200))
    found = timing.overlaps(slot_us, timing.check_fps(29.97))
    lengths = np.add.reduceat(found.seconds, found.row_start[:-1])
    np.testing.assert_allclose(lengths, np.array(slot_us) * 1e-6, rtol=1e-12)


def test_rates_outside_reason_are_refused() -> None:
    """0, -1, NaN, infinity and 1e12 frames a second are refused."""
    for fps in (0.0, -1.0, float("nan"), float("inf"), 1e12):
        with pytest.raises(Rejected):
            timing.check_fps(fps)


def test_a_clip_in_real_time_is_divided_among_the_slots(tmp_path: Path) -> None:
    from PIL import Image

    for k, value in enumerate((50, 100, 200)):
        Image.fromarray(np.full((4, 4), value, np.uint8)).save(tmp_path / f"{k}.png")
    light = load_scene(
        str(tmp_path),
        slot_us=(5000.0, 10000.0, 15000.0),
        rows=4,
        cols=4,
        exposure=ExposureLevel(3000.0),
        transfer="linear",
        fps=100.0,
    )
    parts = np.array([5 * 50, 5 * 50 + 5 * 100, 5 * 100 + 10 * 200])
    np.testing.assert_allclose(light.dense()[:, 0, 0], 3000.0 * parts / parts.sum(), rtol=1e-6)
    with pytest.raises(Rejected) as caught:
        load_scene(
            str(tmp_path),
            slot_us=(40000.0,),
            rows=4,
            cols=4,
            exposure=ExposureLevel(1.0),
            fps=100.0,
        )
    (found,) = caught.value.diagnostics
    assert found.code == "NS0735"
    assert "3 frames, but 4 are needed" in found.message


def test_thousands_of_slots_are_laid_out_quickly() -> None:
    """4096 slots of 12.5 us at 5000 frames a second reach frame 255."""
    found = timing.overlaps((12.5,) * 4096, Fraction(5000))
    assert len(found.row_start) == 4097
    assert found.frame_index.max() == 255
