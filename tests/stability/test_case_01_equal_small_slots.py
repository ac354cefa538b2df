"""Hard case 1: 4096 equal slots of 0.1 electrons: every sum to 1e-6 of math.fsum."""

from __future__ import annotations

from math import fsum
from pathlib import Path

import numpy as np
import pytest
from one_scene import load_scene
from reference_exposure import expose as by_reference
from reference_programs import LOWERINGS, program, sensor_of

from nscc_runtime import capture
from nscc_runtime.effects import selected
from nscc_runtime.emulator import expose
from nscc_runtime.light import Light
from nscc_runtime.scenes.exposure import ExposureLevel

SLOTS = 4096
STOPS = (1, 7, 100, 1000, 2048, 3333, 4095, 4096)
TEXT = f"""nsl 1
frame {SLOTS} slots of 100us
code stop : 1..{SLOTS}
open when n < stop
pixels stop = tile [{list(STOPS)}]
"""
TENTH = np.float32(0.1)


def exact(count: int) -> float:
    return fsum([float(TENTH)] * count)


def lights() -> dict[str, Light]:
    """The same light as a clip, and as a still of so many electrons a second."""
    clip = Light.of_clip(np.full((SLOTS, 1, len(STOPS)), TENTH, np.float32))
    still = Light.of_still(np.full((1, len(STOPS)), TENTH, np.float32), np.ones(SLOTS))
    return {"clip": clip, "still": still}


def test_case_01_plain_float32_sums_would_fail() -> None:
    """A float32 sum in slot order is wrong by more than 1e-5, so the tests below would notice
    it."""
    naive = np.full((SLOTS, len(STOPS)), TENTH, np.float32).sum(axis=0)[0]
    assert abs(naive / exact(SLOTS) - 1) > 1e-5


@pytest.mark.parametrize("kind", ["clip", "still"])
@pytest.mark.parametrize("lowering", LOWERINGS)
def test_case_01_exposures_are_exact(lowering: str, kind: str) -> None:
    container = program(TEXT, lowering, 1, len(STOPS))
    found = expose(container, lights()[kind]).exposure_e[0, 0]
    for value, stop in zip(found, STOPS, strict=True):
        assert value == pytest.approx(exact(stop), rel=1e-6)


def test_case_01_the_reference_is_exact() -> None:
    container = program(TEXT, "edges", 1, len(STOPS))
    found = by_reference(container, lights()["clip"], sensor_of(container), selected("none"))
    for value, stop in zip(found.exposure_e[0, 0], STOPS, strict=True):
        assert value == pytest.approx(exact(stop), rel=1e-6)


@pytest.mark.parametrize("kind", ["clip", "still"])
def test_case_01_the_truth_of_a_scene_is_the_exact_sum(kind: str) -> None:
    np.testing.assert_allclose(lights()[kind].total_e(), exact(SLOTS), rtol=1e-9)


def test_case_01_a_clip_is_scaled_to_its_exposure_without_bias(tmp_path: Path) -> None:
    """The factor comes from the all-open sum; a wrong sum would be in every pixel."""
    np.savez(tmp_path / "clip.npz", light=np.full((SLOTS, 1, 3), TENTH))
    light = load_scene(
        str(tmp_path / "clip.npz"),
        slot_us=(100.0,) * SLOTS,
        rows=1,
        cols=3,
        exposure=ExposureLevel(5000.0),
    )
    assert light.exposure_scale_e == pytest.approx(5000 / exact(SLOTS), rel=1e-6)
    np.testing.assert_allclose(light.total_e(), 5000, rtol=1e-6)


@pytest.mark.parametrize("kind", ["clip", "still"])
@pytest.mark.parametrize("effects", ["none", "crosstalk"])
def test_case_01_planned_frames_are_exact(kind: str, effects: str) -> None:
    """Both paths are tested: the loop over pixels and weighted sums. Crosstalk does not change
    equal light."""
    container = program(TEXT, "edges", 1, len(STOPS))
    found = capture(container, lights()[kind], effects=effects).exposure_e[0, 0]
    for value, stop in zip(found, STOPS, strict=True):
        assert value == pytest.approx(exact(stop), rel=1e-6)
