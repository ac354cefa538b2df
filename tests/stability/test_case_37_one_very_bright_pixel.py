"""Hard case 37: a pixel of 1e12 electrons among dark ones harms its neighbours, and nobody else."""

from __future__ import annotations

import numpy as np
import pytest
from reference_programs import LOWERINGS, SLOTS, program, sensor_of

from nscc_runtime import capture
from nscc_runtime.light import Light

ROWS, COLS = 20, 30
PLACE = (7, 11)
OPEN = "nsl 1\nframe 4 slots of 1ms\nopen when n < 4\n"


def light(bright: float) -> Light:
    values = np.full((SLOTS, ROWS, COLS), 5.0, np.float32)
    values[:, *PLACE] = bright
    return Light.of_clip(values)


@pytest.mark.filterwarnings("ignore:warning.NS0793")
@pytest.mark.parametrize("lowering", LOWERINGS)
@pytest.mark.parametrize("fidelity", ["planned", "reference"])
def test_a_very_bright_pixel_changes_only_its_neighbours(lowering: str, fidelity: str) -> None:
    container = program(OPEN, lowering, ROWS, COLS)
    sensor = sensor_of(container)
    tolerance = 5.0 if fidelity == "planned" else None
    both = [
        capture(
            container,
            light(e),
            sensor=sensor,
            effects="all",
            fidelity=fidelity,
            tolerance=tolerance,
        )
        for e in (5.0, 1e12)
    ]
    y, x = np.ogrid[:ROWS, :COLS]
    away = abs(y - PLACE[0]) + abs(x - PLACE[1])
    for found in both:
        assert found.valid.all()
        assert np.isfinite(found.exposure_e).all()
    same = away > 1
    if fidelity == "reference":
        assert np.array_equal(both[0].exposure_e[0][same], both[1].exposure_e[0][same])
    # A plan may be another one for another scene, within its promise of 5 electrons.
    error = (both[0].exposure_e - both[1].exposure_e)[0][same]
    assert np.sqrt(np.mean(error**2)) < 10
    assert both[1].saturated[0][away <= 1].all()
