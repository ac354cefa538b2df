"""How much light takes registers out of their linear range, beside an oracle that runs words."""

from __future__ import annotations

from itertools import takewhile

import numpy as np
import pytest
from plan_cases import CASES, case
from reference_programs import sensor_of
from saturation_oracle import lost_e

from nscc_runtime.effects.parts import Soft
from nscc_runtime.effects.selection import Selection, everything
from nscc_runtime.execution.block_scene import expose_pixels, prepare_pixels
from nscc_runtime.execution.near_saturation import near_saturation
from nscc_runtime.execution.program import AnalysedProgram
from nscc_runtime.execution.register_reach import reach_of
from nscc_runtime.light import Light

SHAPE, DEVICE = (6, 8), 5


def program_of(name: str, **values: float) -> AnalysedProgram:
    container = case(name, rows=SHAPE[0], cols=SHAPE[1])
    quiet = {"reset_noise_e": 0.0, "read_noise_e": 0.0, "analog_noise_lsb": 0.0}
    offsets = {"analog_bias_lsb": 0.0, "analog_pattern_lsb": 0.0, "analog_gain": 1.0}
    return AnalysedProgram.of(container, sensor_of(container, **{**quiet, **offsets, **values}))


@pytest.mark.parametrize("name", CASES)
def test_registers_are_linear_up_to_the_light_that_is_said(name: str) -> None:
    program = program_of(name)
    linear_e = everything().require_part(Soft).linear_e(program.sensor)
    light = np.random.default_rng(4).lognormal(0.0, 1.5, (program.container.slots, *SHAPE))
    assert reach_of(program).charge_weights is not None
    weights = reach_of(program).charge_weights[:, :, program.lanes].reshape(-1, len(light), *SHAPE)
    least_e = reach_of(program).least_e[:, program.lanes].reshape(-1, *SHAPE)
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
    finite = np.isfinite(reach_of(quiet).least_e)
    assert finite.any()
    assert np.array_equal(finite, np.isfinite(reach_of(noisy).least_e))
    assert (reach_of(noisy).least_e < reach_of(quiet).least_e)[finite].all()


def test_noise_alone_can_saturate_a_register() -> None:
    """Reset noise of 100 000 electrons exceeds the register, so the least light that saturates is
    0."""
    program = program_of("codebook", reset_noise_e=1e5)
    assert (reach_of(program).least_e[0] == 0).all()


@pytest.mark.parametrize("bias_lsb", [-1000.0, 1000.0])
def test_a_fixed_error_of_either_sign_can_saturate_a_register(bias_lsb: float) -> None:
    """A bias of 1000 codes, up or down, exceeds the register, so the least light that saturates is
    0."""
    program = program_of("codebook", analog_bias_lsb=bias_lsb)
    assert (reach_of(program).least_e[0] == 0).all()


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
