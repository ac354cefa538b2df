"""How much light takes registers out of their linear range, beside an oracle that runs words."""

from __future__ import annotations

from itertools import takewhile

import numpy as np
import pytest
from plan_cases import CASES, case
from reference_programs import program as compiled
from reference_programs import sensor_of
from saturation_oracle import lost_e

from nscc.words.container import Container
from nscc_runtime import capture
from nscc_runtime.effects.parts import Soft
from nscc_runtime.effects.selection import Selection, everything
from nscc_runtime.execution.block_scene import expose_pixels, prepare_pixels
from nscc_runtime.execution.near_saturation import near_saturation
from nscc_runtime.execution.program import AnalysedProgram
from nscc_runtime.execution.register_reach import reach_of
from nscc_runtime.light import Light

SHAPE, DEVICE = (6, 8), 5


QUIET = {"reset_noise_e": 0.0, "read_noise_e": 0.0, "analog_noise_lsb": 0.0}


def program_of(name: str, **values: float) -> AnalysedProgram:
    container = case(name, rows=SHAPE[0], cols=SHAPE[1])
    offsets = {"analog_bias_lsb": 0.0, "analog_pattern_lsb": 0.0, "analog_gain": 1.0}
    return AnalysedProgram.of(container, sensor_of(container, **{**QUIET, **offsets, **values}))


@pytest.mark.parametrize("name", CASES)
def test_registers_are_linear_up_to_the_light_that_is_said(name: str) -> None:
    program = program_of(name)
    linear_e = everything().require_part(Soft).linear_e(program.sensor)
    light = np.random.default_rng(4).lognormal(0.0, 1.5, (program.container.slots, *SHAPE))
    assert reach_of(program, everything()).charge_weights is not None
    weights = (
        reach_of(program, everything())
        .charge_weights[:, :, program.lanes]
        .reshape(-1, len(light), *SHAPE)
    )
    least_e = reach_of(program, everything()).least_e[:, program.lanes].reshape(-1, *SHAPE)
    part = ((weights * light).sum(axis=1) / least_e).max(axis=0)
    whole = light / np.where(part > 0, part, 1.0)
    limits = {"most_e": linear_e / 0.999, "knee": 0.999}
    assert lost_e(program.container, 0.999 * whole, **limits).max() < 1e-6 * linear_e
    opened = part > 0
    assert opened.mean() > 0.5
    # As a rule the light that is said is no more than it takes.
    assert (lost_e(program.container, 1.3 * whole, **limits).max(axis=0) > 0)[opened].mean() > 0.5


def test_noise_leaves_less_room() -> None:
    """With noise a register saturates at less light, for the same lanes as without."""
    quiet, noisy = program_of("codebook"), program_of("codebook", analog_noise_lsb=2.0)
    finite = np.isfinite(reach_of(quiet, everything()).least_e)
    assert finite.any()
    assert np.array_equal(finite, np.isfinite(reach_of(noisy, everything()).least_e))
    assert (reach_of(noisy, everything()).least_e < reach_of(quiet, everything()).least_e)[
        finite
    ].all()


def test_noise_alone_can_saturate_a_register() -> None:
    """Reset noise of 100 000 electrons exceeds the register, so the least light that saturates is
    0."""
    program = program_of("codebook", reset_noise_e=1e5)
    assert (reach_of(program, everything()).least_e[0] == 0).all()


@pytest.mark.parametrize("bias_lsb", [-1000.0, 1000.0])
def test_a_fixed_error_of_either_sign_can_saturate_a_register(bias_lsb: float) -> None:
    """A bias of 1000 codes, up or down, exceeds the register, so the least light that saturates is
    0."""
    program = program_of("codebook", analog_bias_lsb=bias_lsb)
    assert (reach_of(program, everything()).least_e[0] == 0).all()


@pytest.mark.parametrize("name", ["a", "codebook", "two buckets"])
def test_registers_of_pixels_that_sums_expose_lose_nothing_to_noise(name: str) -> None:
    """In the brightest light without pixels near saturation, registers that clip without a bend
    lose at most 0.2 % of the noise; in twice this light they lose more."""
    container = case(name, rows=SHAPE[0], cols=SHAPE[1])
    values = {"analog_noise_lsb": 6.0, "register_knee_fraction": 1.0, "full_well_e": 1e6}
    program = AnalysedProgram.of(container, sensor_of(container, **values))
    flat = Light.of_still(np.ones(SHAPE, np.float32), container.slot_s)

    def frames(light: Light, effects: Selection) -> np.ndarray:
        """200 frames by the loop over words, in electrons (frames, buckets, pixels)."""
        places = np.arange(SHAPE[0] * SHAPE[1])
        scene = prepare_pixels(container, program.sensor, light, effects, places, DEVICE)
        return np.array([expose_pixels(scene, 3, number).exposure_e for number in range(200)])

    def lost(light: Light) -> float:
        """What registers lose, with the same random numbers, as a fraction of the noise."""
        linear = frames(light, everything().without("register"))
        loss = frames(light, everything()) - linear
        return float(np.sqrt((loss**2).mean() / linear.var(axis=0).mean()))

    def is_by_sums(light: Light) -> bool:
        return not len(near_saturation(program, light, DEVICE, everything()).places)

    *_, brightest = takewhile(is_by_sums, map(flat.scaled, np.geomspace(1e5, 1e8, 300)))
    assert lost(brightest) <= 0.002
    assert lost(brightest.scaled(2.0)) > 0.002


def marked(container: Container, frames: np.ndarray, effects: str, **values: float) -> int:
    """Compare frames without noise with the reference, and return how many pixels saturate."""
    shot = np.ascontiguousarray(frames, np.float32)
    sensor = sensor_of(container, **{**QUIET, "dark_current_e_per_s": 0.0, **values})
    frame, expected = (
        capture(
            container,
            Light.of_clip(shot),
            sensor=sensor,
            effects=f"{effects},-shot",
            fidelity=fidelity,
        )
        for fidelity in ("planned", "reference")
    )
    np.testing.assert_allclose(frame.exposure_e, expected.exposure_e, atol=0.05)
    assert np.array_equal(frame.saturated_by, expected.saturated_by)
    return int(np.count_nonzero(expected.saturated_by))


@pytest.mark.parametrize("effects", ["all", "all,-decay", "all,-full_well,-decay"])
def test_registers_of_words_that_run_without_decay_saturate(effects: str) -> None:
    """With decay the last words do not run, so registers keep less."""
    text = "nsl 1\nframe 4 slots of 11ms\nopen when true"
    frames = np.full((4, 16, 16), 10000.0 if "full_well" in effects else 6000.0)
    limits = {"register_max_e": 15000.0, "register_min_e": -15000.0}
    container = compiled(text, "auto", 16, 16)
    values = {"digital_retention_us": 30000.0, **limits}
    assert bool(marked(container, frames, effects, **values)) == ("-decay" in effects)


@pytest.mark.parametrize(
    "values",
    [
        {"leakage_tau_s": 0.05, "leakage_spread_fraction": 0.0},
        {"leakage_tau_s": 0.05, "leakage_spread_fraction": 0.02},
        {"analog_gain": 1.3, "leakage_tau_s": 1e9},
    ],
    ids=["leakage", "uneven leakage", "gain"],
)
def test_light_that_is_not_wholly_subtracted_saturates(values: dict[str, float]) -> None:
    """Leakage and gains leave light from before the shutter opened in a register."""
    text = (
        "nsl 1\nframe 8 slots of 11ms\ncode start : 0..7\ncode stop : 1..8\n"
        "require start < stop\nopen when start <= n < stop\npixels start = 3\npixels stop = 8"
    )
    frames = np.full((8, 16, 16), 4000.0)
    frames[:3] = 6000.0
    frames *= np.linspace(0.5, 1.5, 16)
    container = compiled(text, "edges", 16, 16)
    assert 0 < marked(container, frames, "all", full_well_e=90000.0, **values) < 256


def test_words_that_accumulate_are_near_saturation_only_in_bright_light() -> None:
    """Each word loses a part of the noise and the errors of the words before it."""
    text = (
        "nsl 1\nframe 256 slots of 500us\ncode start : 0..7\ncode stop : 9..16\n"
        "open when 16 * start <= n < 16 * stop\n"
        "pixels start = (x + y) % 8\npixels stop = 9 + (x + 3 * y) % 8"
    )
    container = compiled(text, "accumulate", 16, 16)
    made = AnalysedProgram.of(container, sensor_of(container))
    dim, bright = (Light.of_clip(np.full((256, 16, 16), e, np.float32)) for e in (24.0, 480.0))
    near = [len(near_saturation(made, x, DEVICE, everything()).places) for x in (dim, bright)]
    assert near == [0, 256]
