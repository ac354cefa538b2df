"""Flat fields, one effect at a time: mean, temporal variance and fixed pattern, by formulas.

The expectations are worked out by hand from the words of the three lowerings:

setup        NEWS := 0; A := -NEWS; reset; NEWS := -PIX; B := -NEWS        (B: the reset level)
accumulate   for each open slot NEWS := -(A + PIX); A := -(NEWS + B); reset
latch        at the stop NEWS := -PIX; A := -(NEWS + B)
edges        at the stop NEWS := -(A + PIX); A := -(NEWS + B)              (open from slot 0)
"""

from __future__ import annotations

from dataclasses import dataclass, field
from math import exp, tanh

import numpy as np
import pytest
from reference_programs import (
    LOWERINGS,
    SLOT_S,
    SLOTS,
    Moments,
    columns,
    exposures,
    flat,
    moments,
    program,
    sensor_of,
)

E = 400.0
FRAMES = 300


def check(values: np.ndarray, expected: Moments, slack: float = 0.0) -> None:
    """Within five standard errors of the mean, and of the variances of normal-like numbers.

    `slack` is a further relative error allowed to the variances.
    """
    mean, temporal, fixed = moments(values)
    count, pixels = values.shape
    error = (expected[1] / (count * pixels) + expected[2] / pixels) ** 0.5
    assert mean == pytest.approx(expected[0], abs=5 * error + 1e-9 * max(1.0, abs(expected[0])))
    rel = 5 * (2 / max(count - 1, 1) / pixels) ** 0.5 + slack
    assert temporal == pytest.approx(expected[1], rel=rel, abs=1e-9)
    noise = 5 * (2 / pixels) ** 0.5 * (expected[2] + expected[1] / count)
    assert fixed == pytest.approx(expected[2], abs=noise + slack * expected[2] + 1e-9)


def run(
    lowering: str, effects: str, count: int = FRAMES, light: float = E, **values: float
) -> np.ndarray:
    container = program(lowering=lowering)
    return exposures(container, flat(light), sensor_of(container, **values), effects, count)


@pytest.mark.parametrize("lowering", LOWERINGS)
def test_shot_noise_has_the_variance_of_its_mean(lowering: str) -> None:
    found = run(lowering, "shot")
    for stop in range(SLOTS + 1):
        check(columns(found, stop), (stop * E, stop * E, 0.0))
    assert np.array_equal(found, np.rint(found))


@pytest.mark.parametrize("lowering", LOWERINGS)
def test_photo_response_spreads_pixels_in_proportion_to_light(lowering: str) -> None:
    found = run(lowering, "prnu", 2, prnu_fraction=0.03)
    np.testing.assert_allclose(found[0], found[1])
    for stop in range(SLOTS + 1):
        check(columns(found, stop), (stop * E, 0.0, (0.03 * stop * E) ** 2))


@pytest.mark.parametrize("lowering", LOWERINGS)
def test_dark_current_grows_with_the_open_time(lowering: str) -> None:
    current, spread = 50_000.0, 0.3
    found = run(lowering, "dark", dark_current_e_per_s=current, dark_spread_fraction=spread)
    for stop in range(SLOTS + 1):
        dark = current * stop * SLOT_S + stop * E
        mean = current * stop * SLOT_S
        # 400 pixels of lognormal spread: their own mean is the noise's variance.
        slack = 5 * spread / 400**0.5
        check(columns(found, stop), (dark, mean, (spread * mean) ** 2), 2 * slack)


@pytest.mark.parametrize("lowering", LOWERINGS)
def test_noise_of_reads_and_resets_adds_up_over_slots(lowering: str) -> None:
    read = run(lowering, "read", read_noise_e=7.0)
    reset = run(lowering, "reset", reset_noise_e=11.0)
    for stop in range(SLOTS + 1):
        reads = stop + stop**2 if lowering == "accumulate" else 2 * (stop > 0)
        later = max(stop - 1, 0)
        resets = later + later**2 if lowering == "accumulate" else 0
        check(columns(read, stop), (stop * E, reads * 49.0, 0.0))
        check(columns(reset, stop), (stop * E, resets * 121.0, 0.0))


@pytest.mark.parametrize("lowering", LOWERINGS)
def test_the_photodiode_saturates_at_its_full_well(lowering: str) -> None:
    found = run(lowering, "full_well", 1, full_well_e=2.5 * E)
    small = run(lowering, "full_well", 1, full_well_e=0.5 * E)
    for stop in range(SLOTS + 1):
        every_slot = lowering == "accumulate"
        held = stop * E if every_slot else min(stop, 2.5) * E
        check(columns(found, stop), (held, 0.0, 0.0))
        held = stop * 0.5 * E if every_slot else min(stop, 0.5) * E
        check(columns(small, stop), (held, 0.0, 0.0))


@pytest.mark.parametrize("lowering", LOWERINGS)
def test_registers_saturate_softly_above_their_knee(lowering: str) -> None:
    limit, knee = 3 * E, 0.8
    found = run(
        lowering,
        "register",
        1,
        register_max_e=limit,
        register_min_e=-limit,
        register_knee_fraction=knee,
    )

    def soft(value: float) -> float:
        x = value / limit
        return value if x <= knee else limit * (knee + (1 - knee) * tanh((x - knee) / (1 - knee)))

    for stop in range(SLOTS + 1):
        value = 0.0
        for added in [E] * stop if lowering == "accumulate" else [stop * E]:
            value = soft(soft(value + added))
        check(columns(found, stop), (value, 0.0, 0.0))


@dataclass
class Affine:
    """A value as mean and coefficients of independent errors, each with the mean of a bias.

    `moves`: those of moves, which have no bias."""

    mean: float = 0.0
    errors: dict[int, float] = field(default_factory=dict)
    moves: dict[int, float] = field(default_factory=dict)

    def word(self, sign: float, gain: float, fresh: list[int], adds: bool = False) -> Affine:
        """-gain times this, plus a new error with that sign."""
        fresh[0] += 1
        errors = {name: -gain * c for name, c in self.errors.items()}
        moves = {name: -gain * c for name, c in self.moves.items()}
        (errors if adds else moves)[fresh[0]] = sign
        return Affine(-gain * self.mean, errors, moves)

    def plus(self, other: Affine) -> Affine:
        pairs = (self.errors, other.errors), (self.moves, other.moves)
        errors, moves = (
            {name: a.get(name, 0) + b.get(name, 0) for name in {*a, *b}} for a, b in pairs
        )
        return Affine(self.mean + other.mean, errors, moves)


@pytest.mark.parametrize("lowering", LOWERINGS)
def test_errors_of_analog_words_have_their_mean_and_variance(lowering: str) -> None:
    gain, lsb, noise, pattern, bias = 0.98, 10.0, 0.5, 0.2, 0.3
    move_gain, move_noise = 0.995, 0.4
    found = run(
        lowering,
        "analog",
        analog_gain=gain,
        analog_lsb_e=lsb,
        analog_noise_lsb=noise,
        analog_pattern_lsb=pattern,
        analog_bias_lsb=bias,
        analog_move_loss=0.25,
        analog_move_noise=move_noise,
    )
    for stop in range(SLOTS + 1):
        fresh = [0]
        a = Affine().word(-1, move_gain, fresh).word(1, move_gain, fresh)
        b = Affine().word(-1, move_gain, fresh).word(1, move_gain, fresh)
        for added in [E] * stop if lowering == "accumulate" else [stop * E][: stop > 0]:
            before = a if lowering != "latch" else Affine()
            adds = lowering != "latch"
            first_gain = gain if adds else move_gain
            scratch = before.plus(Affine(added)).word(-1, first_gain, fresh, adds)
            a = scratch.plus(b).word(1, gain, fresh, adds=True)
        total = sum(a.errors.values())
        squares = sum(c * c for c in a.errors.values())
        squares += move_noise**2 * sum(c * c for c in a.moves.values())
        check(
            columns(found, stop),
            (
                a.mean + bias * lsb * total,
                squares * (noise * lsb) ** 2,
                (total * pattern * lsb) ** 2,
            ),
        )


@pytest.mark.parametrize("lowering", LOWERINGS)
def test_leakage_has_its_mean_noise_and_pattern(lowering: str) -> None:
    """For each stop, charge falls by exp(-t / tau) from its write to the end of the frame. The
    spread of tau makes the pattern's."""
    tau = 5 * SLOT_S
    values = {"leakage_tau_s": tau, "leakage_spread_fraction": 0.0}
    found = run(lowering, "leakage", 1, **values)
    noisy = run(lowering, "leakage,shot", **values)
    spread = run(lowering, "leakage", 1, leakage_tau_s=tau, leakage_spread_fraction=0.02)
    for stop in range(SLOTS + 1):
        # Of each slot's charge: from the boundary where it is written to the end of the frame.
        written = [n + 1 if lowering == "accumulate" else stop for n in range(stop)]
        weights = [exp(-(SLOTS - at) * SLOT_S / tau) for at in written]
        mean = E * sum(weights)
        check(columns(found, stop), (mean, 0.0, 0.0))
        check(columns(noisy, stop), (mean, E * sum(w * w for w in weights), 0.0))
        slope = sum((SLOTS - at) * SLOT_S / tau * w for at, w in zip(written, weights, strict=True))
        fixed = columns(spread, stop).std()
        assert fixed == pytest.approx(0.02 * E * slope, rel=0.2, abs=1e-9)


def test_the_second_bucket_ages_while_the_first_is_read() -> None:
    from reference_programs import BUCKETS

    container = program(BUCKETS, "accumulate")
    sensor = sensor_of(container, leakage_tau_s=0.1, leakage_spread_fraction=0.0)
    found = exposures(container, flat(E), sensor, "leakage")[0]
    # Column 4 never opens `late`, column 0 opens it in all slots, and `early` the other way round.
    wait = exp(-container.target.readout_us * 1e-6 / 0.1)
    np.testing.assert_allclose(found[1, :, 0::5], found[0, :, 4::5] * wait, rtol=1e-12)


def test_dead_time_follows_the_words() -> None:
    # Launch 1 us, analog 0.2 us, digital 0.1 us; E electrons in 1000 us.
    rate = E / 1000.0
    accumulate, latch = (run(way, "dead_time,black_sun", 1) for way in ("accumulate", "latch"))
    # all, bus, bus, rpix, rpix; then the level is read two words later.
    reset_at, level_at = 1.0 + 5 * 0.2, 1.0 + 7 * 0.2
    # WHERE, then PIX is read by the next word; in a later slot two more words and rpix twice.
    read_at, again_at = 1.0 + 0.1 + 0.2, 1.0 + 0.1 + 4 * 0.2
    level = level_at - reset_at
    for stop in range(1, SLOTS + 1):
        first = 1000.0 - reset_at + read_at - level
        later = 1000.0 - again_at + read_at - level
        check(columns(accumulate, stop), (rate * (first + (stop - 1) * later), 0.0, 0.0))
        whole = stop * 1000.0 - reset_at + read_at - level
        check(columns(latch, stop), (rate * whole, 0.0, 0.0))


def test_lag_repeats_the_previous_frame() -> None:
    from nscc_runtime.effects import selected
    from nscc_runtime.reference import Reference, Scene

    container = program(lowering="accumulate")
    sensor = sensor_of(container, lag_fraction=0.05)
    same = exposures(container, flat(E), sensor, "lag")
    scene = Scene(flat(E), flat(1000.0), container.slot_s)
    other = Reference.of(container, sensor, selected("lag")).expose(scene).exposure_e
    for stop in range(SLOTS + 1):
        check(columns(same, stop), (1.05 * stop * E, 0.0, 0.0))
        check(columns(other[None], stop), (stop * (E + 50.0), 0.0, 0.0))


@pytest.mark.parametrize("lowering", ["accumulate", "latch"])
def test_registers_that_fade_read_zero(lowering: str) -> None:
    found = run(lowering, "decay", 1, digital_retention_us=2500.0)
    kept = run(lowering, "decay", 1, digital_retention_us=4000.0)
    for stop in range(1, SLOTS + 1):
        assert np.allclose(columns(kept, stop), stop * E)
    # Code bits are loaded before slot 0 and read at the ends of slots, at 1, 2, 3 and 4 ms; in
    # both lowerings an open pixel writes its register at each of them.
    assert np.allclose(columns(found, 1), E)
    for stop in (2, 3, 4):
        assert np.allclose(columns(found, stop), 2 * E)


@pytest.mark.parametrize("lowering", LOWERINGS)
def test_crosstalk_smears_light_and_noise(lowering: str) -> None:
    text = "nsl 1\nframe 4 slots of 1ms\nopen when n < 3\n"
    container = program(text, lowering)
    sensor = sensor_of(container, crosstalk_fraction=0.1)
    point = flat(0.0)
    point.frames[:, 10, 20] = 100.0
    found = exposures(container, point, sensor, "crosstalk")[0, 0]
    assert found[10, 20] == pytest.approx(180.0)
    assert found[[9, 11, 10, 10], [20, 20, 19, 21]] == pytest.approx([30.0] * 4)
    assert found.sum() == pytest.approx(300.0)
    noisy = exposures(container, flat(E), sensor, "crosstalk,shot", FRAMES)[:, 0, 1:-1, 1:-1]
    share = 0.6**2 + 4 * 0.1**2
    inner = noisy.reshape(FRAMES, -1)
    assert inner.mean() == pytest.approx(3 * E, rel=1e-3)
    assert inner.var(axis=0, ddof=1).mean() == pytest.approx(3 * E * share, rel=0.02)


def test_motion_is_the_integral_between_samples() -> None:
    from nscc_runtime.light import Light
    from nscc_runtime.scenes.timing import with_motion

    container = program(lowering="accumulate")
    samples = np.array([100.0, 300.0, 200.0, 600.0], np.float32)
    light = Light.of_clip(np.broadcast_to(samples[:, None, None], (4, 40, 50)).copy())
    moving = with_motion(light)
    sensor = sensor_of(container)
    found = exposures(container, moving, sensor, "motion")
    still = exposures(container, moving, sensor, "none")
    unmoved = exposures(container, light, sensor, "motion")
    for stop in range(SLOTS + 1):
        integrals = [200.0, 250.0, 400.0, 600.0]
        assert np.allclose(columns(found, stop), sum(integrals[:stop]))
        assert np.allclose(columns(still, stop), samples[:stop].sum())
    assert np.array_equal(unmoved, still)


def test_readout_noise_is_in_the_codes_only() -> None:
    from nscc_runtime.effects import selected
    from nscc_runtime.reference import frames

    container = program(lowering="accumulate")
    sensor = sensor_of(container, electrons_per_lsb=10.0, adc_noise_lsb=2.0, adc_offset_lsb=7.0)
    made = list(frames(container, flat(E), sensor, selected("adc_noise"), count=FRAMES))
    codes = np.stack([frame.frame for frame in made]).astype(np.float64)
    for stop in (1, 2, 3, 4):
        values = columns(codes, stop)
        # Rounding adds 1/12 to the variance.
        check(values, (stop * E / 10 + 7, 4.0 + 1 / 12, 0.0))
    assert all(np.array_equal(frame.exposure_e, made[0].exposure_e) for frame in made)
