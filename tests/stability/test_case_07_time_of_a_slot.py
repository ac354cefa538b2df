"""Hard case 7: slot n of 4096 begins at n times the slot, to 1e-7."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from reference_exposure import expose
from reference_programs import program, sensor_of

from nscc_runtime.effects import selected
from nscc_runtime.emulator import expose as exactly
from nscc_runtime.frame_file import Provenance, meta, read_out
from nscc_runtime.light import Light
from nscc_runtime.scenes.timing import check_fps, overlaps, slot_edges_us
from nscc_runtime.sensor import default_sensor

SLOTS = 4096


@pytest.mark.parametrize("slot_us", [0.1, 100.0, 33.3, 1e-3, 16666.667])
def test_case_07_edges_are_exact(slot_us: float) -> None:
    edges = slot_edges_us([slot_us] * SLOTS)
    length = Fraction(str(slot_us))
    assert edges == [n * length for n in range(SLOTS + 1)]


def test_case_07_adding_slot_times_in_float32_would_fail() -> None:
    t = np.float32(0)
    for _ in range(SLOTS):
        t += np.float32(0.1)
    assert abs(float(t) / (SLOTS * 0.1) - 1) > 1e-6


@pytest.mark.parametrize("fps", [10_000.0, 30.0, 7.7])
def test_case_07_each_slot_has_the_light_of_its_own_time(fps: float) -> None:
    """Every slot is as long as it says, whatever of which frames it holds."""
    parts = overlaps([100.0] * SLOTS, check_fps(fps))
    for n in range(SLOTS):
        inside = slice(int(parts.row_start[n]), int(parts.row_start[n + 1]))
        assert parts.seconds[inside].sum() == pytest.approx(1e-4, rel=1e-12)
        begin = n * Fraction(1, 10_000) * Fraction(str(fps))
        assert abs(parts.frame_index[inside][0] - int(begin)) <= (n == SLOTS - 1)


@pytest.mark.parametrize("early", [True, False])
def test_case_07_a_register_fades_at_the_right_boundary(early: bool) -> None:
    """A code loaded at the start is read for the last time at boundary 4096, after 136.4 ms."""
    text = f"nsl 1\nframe {SLOTS} slots of 33.3us\ncode late : 0..1\n"
    text += "open when n >= 3000 and late == 1\npixels late = 1\n"
    container = program(text, "edges", 1, 2)
    light = Light.of_clip(np.ones((SLOTS, 1, 2), np.float32))
    limit_us = float(SLOTS * Fraction("33.3")) * (1 - 1e-7 if early else 1 + 1e-7)
    sensor = sensor_of(container, digital_retention_us=limit_us)
    found = expose(container, light, sensor, selected("decay")).exposure_e[0, 0]
    assert exactly(container, light).exposure_e[0, 0, 0] == pytest.approx(SLOTS - 3000)
    # Without the last word what was subtracted at boundary 3000 is left.
    np.testing.assert_allclose(found, -3000 if early else SLOTS - 3000)


def test_case_07_the_open_time_in_meta_is_exact() -> None:
    text = f"nsl 1\nframe {SLOTS} slots of 33.3us\nopen when n < 4095\n"
    container = program(text, "accumulate", 1, 2)
    light = Light.of_clip(np.ones((SLOTS, 1, 2), np.float32))
    frame = read_out(exactly(container, light), container.target)
    origin = Provenance("", default_sensor(container.target))
    (open_us,) = meta(container, light, frame, origin)["open_us"]
    assert open_us == pytest.approx(float(4095 * Fraction("33.3")), rel=1e-12)
