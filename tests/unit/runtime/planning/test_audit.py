"""The audit: what it measures, and when it says that the promise is broken."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from plan_cases import case, measured_plan, moving_light, plan_of
from promise import error_of, full_frames
from reference_programs import sensor_of

from nscc.words.container import Container
from nscc_runtime.light import Light
from nscc_runtime.planning.audit import SLACK, Audit, audit, in_distribution
from nscc_runtime.planning.plan import Plan
from nscc_runtime.planning.planned_scene import PlannedScene
from nscc_runtime.sensor import Sensor

ROWS, COLS = 64, 80
Setting = tuple[Container, Light, Sensor]


@pytest.fixture(scope="module")
def mid() -> Setting:
    container = case("b edges", 8, rows=ROWS, cols=COLS)
    return container, moving_light((8, ROWS, COLS), 400.0), sensor_of(container)


def audited(setting: Setting, plan: Plan) -> Audit:
    container, light, sensor = setting
    return audit(PlannedScene(container, sensor, light, 5), plan)


def test_the_audit_equals_an_independent_comparison(mid: Setting) -> None:
    """A plan without shot noise and lag breaks its tolerance of 5 electrons. The error found is
    that of frames compared in the test, within 2 %."""
    container, light, sensor = mid
    plan = plan_of("all,-shot,-lag", tolerance_e=5.0)
    found = audited(mid, plan)
    full = full_frames(container, light, sensor, 13)
    error = error_of(plan, full, container, light, sensor)
    assert found.measured_rms_e == pytest.approx(error, rel=0.02)
    assert found.samples == 13 * ROWS * COLS
    assert not found.holds
    assert 0 < found.mc_error_e < 0.1 * found.measured_rms_e
    assert "more than 1.1 times the tolerance of 5 e" in str(found.breach(plan))


def test_the_audit_compares_expected_values_without_noise(mid: Setting) -> None:
    """Of means over frames, the difference would have the noise of these frames."""
    found = audited(mid, plan_of("all", tolerance_e=5.0))
    assert abs(found.bias_e) < 0.01


@pytest.mark.parametrize("shape", [(1, 1), (1, 3)])
def test_an_audit_of_few_pixels_takes_chance_from_its_frames(shape: tuple[int, int]) -> None:
    """With all effects nothing is left out: for each of 12 chips, the audit of a few pixels holds,
    though a variance of a few frames is far from the true one."""
    container = case("b edges", 8, rows=shape[0], cols=shape[1])
    sensor, light = sensor_of(container), Light.of_clip(np.full((8, *shape), 200.0, np.float32))
    plan = plan_of("all", tolerance_e=5.0)
    found = [audit(PlannedScene(container, sensor, light, seed), plan) for seed in range(12)]
    assert all(each.holds for each in found)


def test_an_audit_holds_up_to_an_error_a_tenth_above_the_tolerance(mid: Setting) -> None:
    """The plan for 30 electrons drops effects and holds. Measured against tolerances just inside
    and beyond the slack, the audit holds and breaks."""
    container, light, sensor = mid
    plan = measured_plan(container, light, sensor, 30.0)
    found = audited(mid, plan)
    assert plan.names("dropped")
    assert found.holds
    assert found.measured_rms_e == pytest.approx(plan.predicted_e, rel=0.15)
    for part, holds in ((SLACK - 0.01, True), (SLACK + 0.05, False)):
        asked = replace(plan, tolerance_e=found.measured_rms_e / part)
        assert (replace(found, path_e=0.0).breach(asked) is None) is holds


def test_all_effects_agree_with_the_loop(mid: Setting) -> None:
    """A plan that drops nothing has an error of exactly 0 and the noise of the loop."""
    found = audited(mid, plan_of("all"))
    assert found.measured_rms_e == 0.0
    assert found.std_ratio == pytest.approx(1.0, abs=0.01)
    assert found.holds


def means(*frames_e: np.ndarray) -> tuple[np.ndarray, ...]:
    """The means of frames (buckets, frames, pixels) over frames and pixels."""
    return tuple(np.broadcast_to(each.mean(), each[:, 0].shape) for each in frames_e)


def test_an_audit_reports_frames_whose_mean_or_noise_differs_from_the_loop(mid: Setting) -> None:
    plan = plan_of("all", tolerance_e=5.0)
    rng = np.random.default_rng(3)
    loop, own = rng.normal(100.0, 20.0, (2, 1, 8, 20_000))
    report = Audit(0.0, 0.0, 0.0, 1, 0.0)
    alike = in_distribution(report, own, loop, means(own, loop))
    assert alike.breach(plan) is None
    shifted = in_distribution(report, own + 7.0, loop, means(own + 7.0, loop))
    assert shifted.path_e == pytest.approx(7.0, rel=0.15)
    assert shifted.bias_e == pytest.approx(7.0, rel=0.05)
    noisier = in_distribution(report, 100 + (own - 100) * 1.1, loop, means(own, loop))
    # Noise 1.1 times as large: its square, 400, grows by 0.21 times.
    assert noisier.path_e == pytest.approx((0.21 * 400) ** 0.5, rel=0.15)
    assert noisier.std_ratio == pytest.approx(1.1, rel=0.01)
    for found in (shifted, noisier):
        assert "the frames differ from the loop" in str(found.breach(plan))


def test_without_noise_there_is_no_ratio() -> None:
    """Without any noise the ratio of deviations is None, and 64 frames of 64 pixels are
    compared."""
    container = case("b edges", 8, rows=8, cols=8)
    quiet = sensor_of(
        container,
        dark_current_e_per_s=0.0,
        read_noise_e=0.0,
        reset_noise_e=0.0,
        analog_noise_lsb=0.0,
    )
    found = audited((container, moving_light((8, 8, 8), 0.0), quiet), plan_of("all"))
    assert found.std_ratio is None
    assert found.samples == 64 * 64
