"""Frames beside those of Pyxel, the detector simulator of the European Space Agency.

Both simulate what both can: light counted in each slot (shot noise), a hard full well, the sum of
the slots, as words do under `accumulate`, and an ideal converter. Draws differ, so that means,
variances and shares of saturated pixels agree within their counting errors.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest

from nscc.chips.load import builtin_target, target_toml
from nscc.compiler import compile_source
from nscc.pipeline import Options
from nscc.source import Source
from nscc_runtime import capture, sensor_for

pytestmark = [
    pytest.mark.slow,
    pytest.mark.filterwarnings("ignore::DeprecationWarning"),  # of Pyxel's own classes
]
pytest.importorskip("pyxel", reason="Pyxel is not installed: pip install 'nscc[pyxel]'")

SIDE, SLOTS, REPEATS = 64, 16, 10
SENSOR = {"full_well_e": 600, "electrons_per_lsb": 40}
FULL_WELL_E = SENSOR["full_well_e"]
RATES_E = (80.0, 300.0, 520.0, 560.0, 580.0, 590.0, 600.0, 640.0)
"""Electrons a slot of eight bands of rows, from far below the well to above it."""
LIMIT = 4.5
"""Standard errors: beyond them is less than one number in 100,000."""


class Band(NamedTuple):
    """Of all pixels of a band and all repeats: exposures in electrons, which of them met the well,
    codes."""

    exposure_e: np.ndarray
    full: np.ndarray
    codes: np.ndarray


def light() -> np.ndarray:
    """Electrons a slot (SIDE, SIDE)."""
    return np.repeat(RATES_E, SIDE // len(RATES_E))[:, None] * np.ones(SIDE)


def banded(*arrays: np.ndarray) -> list[Band]:
    """Arrays (REPEATS, SIDE, SIDE), band by band."""
    parts = [np.split(each, len(RATES_E), axis=1) for each in arrays]
    return [Band(*(part.ravel() for part in each)) for each in zip(*parts, strict=True)]


@pytest.fixture(scope="module")
def container(tmp_path_factory: pytest.TempPathFactory) -> Any:
    folder: Path = tmp_path_factory.mktemp("pyxel")
    text = target_toml(builtin_target("scamp5"))
    small = text.replace("rows = 256", f"rows = {SIDE}").replace("cols = 256", f"cols = {SIDE}")
    (folder / "small.toml").write_text(small)
    program = f'nsl 1\ntarget "small.toml"\nframe {SLOTS} slots of 1ms\nopen when true\n'
    options = Options(lowering="accumulate")
    return compile_source(Source("p.nsl", program), folder, options).container


@pytest.fixture(scope="module", params=["reference", "planned"])
def ours(request: pytest.FixtureRequest, container: Any) -> list[Band]:
    scene = np.repeat(light()[None], SLOTS, axis=0).astype(np.float32)
    more = {"tolerance": "0.5e"} if request.param == "planned" else {"fidelity": "reference"}
    taken = capture(
        container,
        scene,
        sensor=SENSOR,
        effects="shot,full_well",
        repeat=REPEATS,
        **more,
    )
    return banded(taken.exposure_e[:, 0], taken.saturated[:, 0], taken.frame[:, 0])


@pytest.fixture(scope="module")
def theirs(container: Any) -> list[Band]:
    from pyxel.detectors import CMOS, Characteristics, CMOSGeometry, Environment
    from pyxel.models import charge_collection, charge_generation, charge_measurement
    from pyxel.models.photon_collection import shot_noise
    from pyxel.models.readout_electronics.simple_adc import apply_simple_adc

    sensor = sensor_for(container, **SENSOR)
    step_e, offset = sensor.electrons_per_lsb, sensor.adc_offset_lsb
    # Pyxel's converter cuts off where a chip's rounds: its range begins half a code lower.
    least_e = -(offset + 0.5) * step_e
    found = []
    for repeat in range(REPEATS):
        sums, full = np.zeros((SIDE, SIDE)), np.zeros((SIDE, SIDE), np.bool_)
        for slot in range(SLOTS):
            detector = CMOS(CMOSGeometry(row=SIDE, col=SIDE), Environment(), Characteristics())
            detector.photon.array = light()
            shot_noise(detector, seed=repeat * SLOTS + slot)
            charge_generation.simple_conversion(
                detector, quantum_efficiency=1.0, binomial_sampling=False
            )
            charge_collection.simple_collection(detector)
            full |= np.asarray(detector.pixel.array) > FULL_WELL_E
            charge_collection.simple_full_well(detector, fwc=FULL_WELL_E)
            charge_measurement.simple_measurement(detector, gain=1.0)
            sums += np.asarray(detector.signal.array)
        codes = apply_simple_adc(sums, 8, least_e, least_e + 255 * step_e, np.uint8)
        found.append((sums, full, codes))
    return banded(*(np.array(each) for each in zip(*found, strict=True)))


def of_mean(values: np.ndarray) -> tuple[float, float]:
    """The mean and its standard error."""
    values = values.astype(np.float64)
    return float(values.mean()), float(values.std() / np.sqrt(values.size))


def of_variance(values: np.ndarray) -> tuple[float, float]:
    """The variance and its standard error."""
    return of_mean((values.astype(np.float64) - values.mean()) ** 2)


def agree(ours: tuple[float, float], theirs: tuple[float, float]) -> bool:
    return abs(ours[0] - theirs[0]) <= LIMIT * np.hypot(ours[1], theirs[1]) + 1e-9


@pytest.mark.parametrize("band", range(len(RATES_E)))
def test_means_variances_and_saturated_fractions_agree_with_pyxel(
    ours: list[Band], theirs: list[Band], band: int
) -> None:
    mine, other = ours[band], theirs[band]
    measured = {
        "mean, e": (of_mean(mine.exposure_e), of_mean(other.exposure_e)),
        "variance, e2": (of_variance(mine.exposure_e), of_variance(other.exposure_e)),
        "saturated": (of_mean(mine.full), of_mean(other.full)),
        "mean, codes": (of_mean(mine.codes), of_mean(other.codes)),
        "variance, codes": (of_variance(mine.codes), of_variance(other.codes)),
    }
    for name, pair in measured.items():
        print(f"{RATES_E[band]:g} e a slot, {name}: {pair[0][0]:.6g} and {pair[1][0]:.6g}")
    wrong = {name: pair for name, pair in measured.items() if not agree(*pair)}
    assert not wrong
