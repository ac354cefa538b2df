"""The audit: what it measures, on which rows, and when it says that the promise is broken."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from plan_cases import case, exposed_under, measured_plan, moving_light, plan_of
from promise import full_frames
from reference_programs import sensor_of

from nscc.words.container import Container
from nscc_runtime.light import Light
from nscc_runtime.planning import audit as module
from nscc_runtime.planning.plan import Plan
from nscc_runtime.planning.scenes import planning_of
from nscc_runtime.sensor import Sensor

ROWS, COLS = 64, 80


@pytest.fixture(scope="module")
def mid() -> tuple[Container, Light, Sensor]:
    container = case("b edges", 8, rows=ROWS, cols=COLS)
    return container, moving_light((8, ROWS, COLS), 400.0), sensor_of(container)


def audited(setting: tuple[Container, Light, Sensor], plan: Plan, frames: int = 1) -> module.Audit:
    container, light, sensor = setting
    return planning_of(container, sensor, light, 5).audit(plan, 3, frames)


def test_it_measures_what_an_independent_comparison_measures(
    mid: tuple[Container, Light, Sensor], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(module, "_POOLED", ROWS * COLS)
    container, light, sensor = mid
    plan = plan_of("all,-shot,-lag", tolerance_e=5.0)
    found = audited(mid, plan, 4)
    full = full_frames(container, light, sensor, 4, 3, 5)
    scene = exposed_under(plan, container, light, sensor)
    mine = np.stack([scene.expose(3, frame).exposure_e for frame in range(4)])
    error = mine - full
    assert found.measured_rms_e == pytest.approx(np.sqrt((error**2).mean(axis=(1, 2, 3))).max())
    assert found.bias_e == pytest.approx(error.mean())
    stds = [np.sqrt(values.var(axis=0, ddof=1).mean()) for values in (mine, full)]
    assert found.std_ratio == pytest.approx(stds[0] / stds[1])
    assert (found.samples, found.frames) == (4 * ROWS * COLS, 4)
    assert not found.holds
    assert 0 < found.mc_error_e < 0.1 * found.measured_rms_e


def test_a_kept_promise_holds_and_the_slack_is_a_tenth(
    mid: tuple[Container, Light, Sensor],
) -> None:
    container, light, sensor = mid
    plan = measured_plan(container, light, sensor, 5.0)
    found = audited(mid, plan)
    assert found.holds
    assert found.measured_rms_e == pytest.approx(plan.predicted_e, rel=0.15)
    for part, holds in ((1.09, True), (1.11, False)):
        asked = replace(plan, tolerance_e=found.measured_rms_e / part)
        assert audited(mid, asked).holds is holds


def test_estimates_of_worst_pixels_are_shown_and_no_promise(
    mid: tuple[Container, Light, Sensor],
) -> None:
    container, light, sensor = mid
    plan = measured_plan(container, light, sensor, 5.0)
    found = audited(mid, replace(plan, predicted_max_e=1.0, predicted_p999_e=0.5))
    assert found.holds
    assert f"worst {found.measured_max_e:.3g} e" in str(found)
    assert found.measured_p999_e < found.measured_max_e
    asked = replace(plan, tolerance_max="1e", tolerance_max_e=0.8 * found.measured_max_e)
    said = found.breach(asked)
    assert said is not None
    assert "--tolerance-max" in said


def test_the_reference_beside_itself_is_no_error(mid: tuple[Container, Light, Sensor]) -> None:
    container, _, sensor = mid
    light = Light.of_clip(mid[1].frames[:, :8, :8])
    small = case("b edges", 8, rows=8, cols=8)
    found = audited((small, light, sensor), plan_of("all", loop="all"))
    assert found.measured_rms_e < 1e-9
    assert found.holds
    assert found.std_ratio == pytest.approx(1.0, abs=1e-9)
    assert container is not small


def test_small_frames_are_pooled_until_there_are_enough_samples() -> None:
    container = case("b edges", 8, rows=32, cols=64)
    light, sensor = moving_light((8, 32, 64), 400.0), sensor_of(container)
    found = audited((container, light, sensor), plan_of("all"))
    assert found.samples >= 2 * 65536
    assert found.frames == 64


def test_without_noise_there_is_no_ratio() -> None:
    container = case("b edges", 8, rows=8, cols=8)
    quiet = sensor_of(container, dark_current_e_per_s=0.0, read_noise_e=0.0, reset_noise_e=0.0,
                      analog_noise_lsb=0.0)  # fmt: skip
    found = audited((container, moving_light((8, 8, 8), 0.0), quiet), plan_of("all"))
    assert found.std_ratio is None
    assert found.std_ratio_mc_error is None


def test_bands_of_rows_see_the_brightest_pixel_and_their_neighbours(
    mid: tuple[Container, Light, Sensor], monkeypatch: pytest.MonkeyPatch
) -> None:
    """A lamp whose crosstalk is left out, in an array too large to compare whole."""
    container, _, sensor = mid
    frames = np.full((8, ROWS, COLS), 10.0, np.float32)
    frames[:, 37, 50] = 60000.0
    light = Light.of_clip(frames)
    plan = plan_of("all,-crosstalk")
    whole = audited((container, light, sensor), plan)
    monkeypatch.setattr(module, "_MOST_CELLS", 8 * COLS * 16)
    bands = audited((container, light, sensor), plan)
    assert whole.samples == whole.frames * ROWS * COLS
    assert 16 <= bands.samples / (bands.frames * COLS) <= 24
    assert not bands.holds
    # The lamp's band stands for more rows than it has; it is not overlooked.
    assert bands.measured_rms_e >= 0.9 * whole.measured_rms_e
    full = full_frames(container, light, sensor, 1, 3, 5)[0, 0]
    made = exposed_under(plan, container, light, sensor).expose(3, 0)
    here = np.abs(made.exposure_e[0] - full)
    assert np.unravel_index(here.argmax(), here.shape)[0] in (36, 37, 38)


@pytest.mark.parametrize("cells", [1, 5_000, 20_000, 10**9])
@pytest.mark.parametrize("height", [1, 3, 4, 61, 64])
def test_every_row_is_stood_for_once(
    height: int, cells: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(module, "_MOST_CELLS", cells)
    total = np.zeros((height, COLS))
    total[height // 2, 3] = 1.0
    rows = module.compared_rows(8, total)
    assert height // 2 in rows
    assert rows.tolist() == sorted(set(rows.tolist()))
    weights = module.row_weights(rows, height)
    assert weights.sum() == pytest.approx(1.0)
    assert (weights > 0).all()
    runs = [row for band in module.bands(rows) for row in band]
    assert runs == rows.tolist()
