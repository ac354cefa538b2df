"""Which pixels are found to be near saturation, beside sums over slots and neighbours in numpy."""

from __future__ import annotations

import numpy as np
import pytest
from plan_cases import case, moving_light
from reference_programs import sensor_of

from nscc_runtime import capture
from nscc_runtime.effects import everything
from nscc_runtime.effects.dark import current_e_per_s
from nscc_runtime.effects.prnu import response
from nscc_runtime.execution.near_saturation import near_saturation
from nscc_runtime.execution.program import AnalysedProgram
from nscc_runtime.light import Light

NOISE = "shot", "dark", "read", "reset", "analog", "crosstalk"
"""Effects that draw random numbers, or move charge of other pixels."""

SLOTS, DEVICE, SIGMAS = 8, 5, 6.0


def beside(values: np.ndarray) -> np.ndarray:
    """The sum of the four neighbours, nothing beyond the border."""
    framed = np.pad(values, 1)
    return framed[:-2, 1:-1] + framed[2:, 1:-1] + framed[1:-1, :-2] + framed[1:-1, 2:]


def reach(mean: np.ndarray) -> np.ndarray:
    return mean + SIGMAS * np.sqrt(mean)


@pytest.mark.parametrize("shape", [(1, 1), (1, 6), (5, 1), (2, 2), (7, 19)])
@pytest.mark.parametrize("name", ["a", "b edges", "codebook"])
def test_neighbours_give_a_part_and_the_border_gets_less(name: str, shape: tuple[int, int]) -> None:
    """Charge that PIX sees, as the shutter is open, with all that neighbours give in a frame."""
    container = case(name, SLOTS, "500us", *shape)
    sensor = sensor_of(
        container,
        full_well_e=2500.0,
        crosstalk_fraction=0.05,
        lag_fraction=0.1,
        prnu_fraction=0.2,
        dark_current_e_per_s=2e4,
        register_max_e=1e9,
        register_min_e=-1e9,
    )
    light = moving_light((SLOTS, *shape), 300.0)
    program = AnalysedProgram.of(container, sensor)
    # Words take no time, so that only slots whose shutter is open count.
    near = near_saturation(program, light, DEVICE, everything().without("dead_time", "black_sun"))
    places = np.arange(shape[0] * shape[1])
    scale = 1.1 * response(sensor, DEVICE, places).reshape(shape)
    current = current_e_per_s(sensor, DEVICE, places).reshape(shape)
    seen = program.seen_slots(True)[:, program.lanes].reshape(SLOTS, *shape)
    own = (seen * light.dense()).sum(axis=0) * scale
    charge = light.sum_e * scale + current * 0.5e-3 * SLOTS
    given, taken = 0.05 * beside(charge), 0.05 * beside(np.ones(shape))
    dark = current * 0.5e-3 * seen.sum(axis=0)
    most = reach(np.maximum(own, (1.0 - taken) * own + given) + dark)
    # All that neighbours give in the frame, and all of its dark current, bound what a pixel sees.
    wanted = np.flatnonzero(most >= 2500.0)
    assert near.places.tolist() == wanted.tolist()
    np.testing.assert_allclose(near.most_e, most.reshape(-1)[wanted], rtol=1e-6)


def test_a_pixel_beside_a_hot_one_saturates_as_in_the_reference() -> None:
    """A pixel whose dark charge is hundreds of full wells fills its neighbours by crosstalk."""
    container = case("b edges", SLOTS, rows=40, cols=40)
    sensor = sensor_of(container, dark_current_e_per_s=1e9, dark_spread_fraction=10.0)
    light = Light.of_clip(np.full((SLOTS, 40, 40), 50.0, np.float32))
    effects = "all,-black_sun"  # a black sun reads nothing: any noise decides
    exposed = [
        capture(container, light, sensor=sensor, effects=effects, fidelity=fidelity).exposure_e
        for fidelity in ("planned", "reference")
    ]
    noise_e = exposed[1][exposed[1] < 1e4].std()
    assert np.abs(exposed[0] - exposed[1]).max() < 10.0 * max(noise_e, 500.0)


def test_no_pixel_is_near_saturation_without_saturating_effects() -> None:
    """In light of a million electrons all 36 pixels are near saturation; without the saturating
    effects none is."""
    container = case("a", SLOTS, rows=6, cols=6)
    program = AnalysedProgram.of(container, sensor_of(container))
    light = Light.of_clip(np.full((SLOTS, 6, 6), 1e6, np.float32))
    wanted = everything().without("full_well", "register")
    assert not len(near_saturation(program, light, DEVICE, wanted).places)
    assert len(near_saturation(program, light, DEVICE, everything()).places) == 36


@pytest.mark.filterwarnings("ignore:.*NS0793")
@pytest.mark.parametrize("name", ["b accumulate", "b edges", "c accumulate", "two buckets"])
def test_light_that_flashes_after_the_last_read_saturates_as_in_the_reference(name: str) -> None:
    """Pixels flash with 10 million electrons in each slot. Words that run at the end of an exposure
    collect a part of the next slot's light, which fills PIX in some pixels; frames without draws
    of random numbers are those of the reference."""
    container = case(name, 4, "100us", 16, 16)
    sensor, effects = sensor_of(container), everything().without(*NOISE)
    clip = np.full((4, 16, 16), 200.0, np.float32)
    clip[np.arange(256) % 4, np.arange(256) // 16, np.arange(256) % 16] = 1e7
    light = Light.of_clip(clip)
    chip = {"sensor": sensor, "device_seed": 5, "effects": effects}
    own, true = (
        capture(container, light, fidelity=fidelity, **chip)
        for fidelity in ("planned", "reference")
    )
    np.testing.assert_allclose(own.exposure_e, true.exposure_e, rtol=1e-4, atol=0.1)
