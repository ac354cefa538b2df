"""`nscc calibrate` on frames that an independent generator made with known values."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from calibration_frames import DARK_TIMES, FLAT_TIMES, LIGHT, TOP, Chip, taken, truth

from nscc.chips.load import builtin_target
from nscc_runtime.calibrate import Calibration, Chain, Stack, calibrated, messages, parameters

CHIPS = {
    "plain": Chip(),
    "quiet pixels": Chip(dsnu_lsb=0.3, prnu=0.004, dark_spread=0.1, crosstalk=0.0),
    "coarse codes": Chip(electrons_per_lsb=60.0, read_e=50.0, full_well_e=13_000.0),
    "fine codes": Chip(electrons_per_lsb=4.0, read_e=8.0, full_well_e=800.0, offset_lsb=20.0),
}
LIGHTS = {"coarse codes": 3 * LIGHT, "fine codes": LIGHT / 5}


def errors_of(found: Calibration, chip: Chip) -> dict[str, float]:
    """How many standard errors each figure is off."""
    off = {}
    for name, value in truth(chip).items():
        quantity = found.quantities[name]
        assert quantity.known == "measured", (name, quantity)
        off[name] = (quantity.value - value) / quantity.se
    return off


@pytest.mark.parametrize("name", CHIPS)
def test_measured_values_lie_within_four_standard_errors(name: str) -> None:
    """For each simulated chip, no value is further than 4 standard errors from the value set. The
    main standard errors are below 2 %."""
    chip = replace(CHIPS[name], shape=(160, 160))
    found = calibrated(*taken(chip, 1, light=LIGHTS.get(name, LIGHT)), TOP)
    off = errors_of(found, chip)
    assert max(map(abs, off.values())) < 4, off
    # Errors that say nothing would pass, too.
    for key in ("conversion_gain", "dark_noise_e", "dark_current", "full_well"):
        quantity = found.quantities[key]
        assert quantity.se < 0.02 * quantity.value
    assert messages(found) == []
    linear = found.quantities["linearity_error"]
    assert linear.value < 0.05
    assert found.defects == 0


def test_errors_over_many_chips_have_the_spread_of_their_standard_errors() -> None:
    """The errors, divided by their standard errors, have the mean and spread of normal numbers."""
    chip, count = Chip(shape=(64, 64)), 60
    off = [errors_of(calibrated(*taken(chip, 100 + s, 4, 6), TOP), chip) for s in range(count)]
    for name in off[0]:
        z = np.array([one[name] for one in off])
        # Each bound is passed by chance in one of some ten thousand.
        assert 0.64 < np.sqrt((z * z).mean()) < 1.36, name
        assert abs(z.mean()) < 4 / np.sqrt(count), name
        assert 0.44 < (np.abs(z) < 1).mean() < 0.9, name


def test_more_frames_give_smaller_errors() -> None:
    few, many = (calibrated(*taken(Chip(), 5, n, 2 * n), TOP) for n in (3, 12))
    for name in ("conversion_gain", "dark_noise_e", "prnu"):
        ratio = few.quantities[name].se / many.quantities[name].se
        # Four times the frames halve errors of noise, but not those of rounding and of the pixels.
        assert 1.3 < ratio < 3.5


def test_hot_and_dead_pixels_change_nothing() -> None:
    """With 20 stuck and 10 noisy pixels among 96 x 96, each value moves by less than its standard
    error."""
    flats, darks = taken(Chip(), 7)
    clean = calibrated(flats, darks, TOP)
    rng = np.random.default_rng(0)
    places = rng.choice(96 * 96, 30, replace=False)
    for stack in (*flats, *darks):
        flat = stack.codes.reshape(len(stack.codes), -1)
        flat[:, places[:20]] = 200  # stuck
        flat[:, places[20:]] = rng.integers(0, 256, (len(stack.codes), 10))  # noise of its own
    found = calibrated(flats, darks, TOP)
    assert found.defects == pytest.approx(30, abs=3)
    for name, quantity in clean.quantities.items():
        other = found.quantities[name]
        assert abs(other.value - quantity.value) < quantity.se, name
    assert max(map(abs, errors_of(found, Chip()).values())) < 4


def test_uneven_and_drifting_light_does_not_change_the_measured_values() -> None:
    """The light falls by a tenth from one side to the other, and changes by 2 % from frame to
    frame."""
    chip = Chip()
    camera = chip.made(np.random.default_rng(3))
    fall = np.linspace(0.95, 1.05, 96)[:, None] * np.linspace(0.98, 1.02, 96)
    flats = []
    for time in FLAT_TIMES:
        frames = [camera.codes(LIGHT * fall * s, time, 1)[0] for s in (0.99, 1.01, 1.0, 0.99)]
        good = np.ones(chip.shape, bool)
        flats.append(Stack("flat", np.stack(frames).astype(np.uint16), good, time))
    darks = [camera.stack(0.0, time, 12) for time in DARK_TIMES]
    off = errors_of(calibrated(flats, darks, TOP), chip)
    assert max(map(abs, off.values())) < 4, off


def test_darks_with_little_noise_give_an_upper_bound_of_the_noise() -> None:
    """Rounding hides a noise of less than half a code."""
    chip = Chip(read_e=4.0, dsnu_lsb=0.0, dark_e_per_s=0.0)
    found = calibrated(*taken(chip, 2), TOP)
    noise = found.quantities["dark_noise_e"]
    assert noise.known == "at most"
    # The square root of `QUIET`, in codes of 20 electrons.
    assert noise.value == pytest.approx(20 * 0.24**0.5, rel=0.1)
    assert "rounding" in noise.remark
    gain = found.quantities["conversion_gain"]
    assert abs(gain.value - 20) < 4 * gain.se
    chosen = parameters(found, builtin_target("scamp5"), Chain())["read_noise_e"]
    assert chosen.status == "bound"


@pytest.mark.parametrize("noise_lsb", [0.52, 0.6])
def test_rounding_is_part_of_the_errors(noise_lsb: float) -> None:
    """Hardly more noise than rounding hides, on pixels all alike: the worst case of rounding."""
    off = []
    for seed in range(24):
        chip = Chip(
            read_e=noise_lsb * 20,
            dsnu_lsb=0.0,
            prnu=0.0,
            dark_e_per_s=0.0,
            crosstalk=0.0,
            offset_lsb=14 + seed / 24,
        )
        found = calibrated(*taken(chip, seed, 3, 3), TOP, crosstalk=0.0).quantities
        for name in ("dark_noise_lsb", "conversion_gain", "offset", "saturation_lsb"):
            off.append((found[name].value - truth(chip)[name]) / found[name].se)
    z = np.array(off).reshape(24, -1)
    # Chance passes these bounds of 24 chips and four quantities seldom.
    assert np.abs(z).max() < 4.5
    assert np.all(np.sqrt((z * z).mean(axis=0)) < 1.6)


def test_known_crosstalk_makes_the_gain_more_certain() -> None:
    """A known crosstalk reduces the standard error of the gain. A crosstalk that is wrong by a
    hundredth changes the gain."""
    chip = Chip(crosstalk=0.01)
    stacks = taken(chip, 3)
    free, known, wrong = (calibrated(*stacks, TOP, crosstalk=c) for c in (None, 0.01, 0.0))
    gains = [found.quantities["conversion_gain"] for found in (free, known, wrong)]
    assert gains[1].se < 0.6 * gains[0].se
    assert abs(gains[0].value - 20) < 4 * gains[0].se
    assert abs(gains[1].value - 20) < 4 * gains[1].se
    # Crosstalk c leaves (1 - 4 c)^2 + 4 c^2 of the variance; here c = 0.01 is taken for 0.
    assert gains[2].value / gains[1].value == pytest.approx(1 / (0.96**2 + 4 * 0.01**2), rel=1e-6)
    assert known.quantities["crosstalk"].known == "given"
    chosen = parameters(known, builtin_target("scamp5"), Chain())["crosstalk_fraction"]
    assert (chosen.value, chosen.status, chosen.se) == (0.01, "given", None)


def test_darks_clipped_at_code_0_give_the_gain_but_no_offset_or_noise() -> None:
    """With an offset of 0 codes, half of the dark noise is cut off: the values that need darks are
    unknown. The note NS0791 names them."""
    chip = Chip(offset_lsb=0.0)
    found = calibrated(*taken(chip, 2), TOP)
    for name in ("dark_noise_e", "offset", "dark_current", "dark_spread", "full_well"):
        assert found.quantities[name].known == "unknown"
        assert found.quantities[name].value is None
    gain, prnu = found.quantities["conversion_gain"], found.quantities["prnu"]
    assert abs(gain.value - chip.electrons_per_lsb) < 4 * gain.se
    assert prnu.known == "at most"
    mixed = np.hypot(chip.prnu, chip.dark_spread * chip.dark_e_per_s / (LIGHT + chip.dark_e_per_s))
    assert prnu.value == pytest.approx(mixed, rel=0.05)
    (note,) = messages(found)
    assert note.code == "NS0791"
    assert "dark_noise_e" in note.data["open"]


def test_an_adc_that_ends_first_gives_a_bound_of_the_full_well() -> None:
    """The ADC ends at code 255, before the well of 6000 electrons: the full well is `at least` what
    that code means."""
    chip = Chip(full_well_e=6000.0)
    found = calibrated(*taken(chip, 2), TOP)
    well = found.quantities["full_well"]
    assert well.known == "at least"
    # From the offset of 14.3 to the last code, 20 electrons a code.
    assert well.value == pytest.approx((255 - 14.3) * 20, rel=0.02)
    target = builtin_target("scamp5")
    assert parameters(found, target, Chain())["full_well_e"].value == target.full_well_e
    small = replace(target, full_well_e=3000.0, register_max_e=3000.0)
    raised = parameters(found, small, Chain())
    assert raised["full_well_e"].status == raised["register_max_e"].status == "bound"
    assert raised["full_well_e"].value == pytest.approx(well.value, rel=1e-5)


def test_without_exposure_times_only_quantities_of_time_are_unknown() -> None:
    """Stacks without times leave the dark current, its spread and the linearity error unknown. The
    other values stay right."""
    flats, darks = taken(Chip(), 4)
    bare = [replace(stack, exposure_s=None) for stack in flats]
    one = [replace(darks[0], exposure_s=None)]
    found = calibrated(bare, one, TOP)
    unknown = {name for name, q in found.quantities.items() if q.known == "unknown"}
    assert unknown == {"dark_current", "dark_spread", "linearity_error"}
    assert found.quantities["prnu"].known == "at most"
    for name in ("conversion_gain", "full_well", "crosstalk"):
        quantity = found.quantities[name]
        assert abs(quantity.value - truth(Chip())[name]) < 4 * quantity.se


def test_a_bent_response_is_a_linearity_error() -> None:
    """One level that lies a tenth beside the line makes the linearity error exceed 1 and ten
    standard errors. Without it the error is below 0.05."""
    flats, darks = taken(Chip(), 4)
    plain = calibrated(flats, darks, TOP).quantities["linearity_error"]
    assert plain.value < 0.05
    # One level seems to have been exposed for a tenth longer.
    late = [
        replace(stack, exposure_s=stack.exposure_s * (1.1 if i == 3 else 1.0))
        for i, stack in enumerate(flats)
    ]
    found = calibrated(late, darks, TOP).quantities["linearity_error"]
    assert found.value > 1.0
    assert found.value > 10 * found.se


def test_the_linearity_error_is_unknown_if_the_light_was_not_constant() -> None:
    """If levels of equal exposure time differ in brightness, the light was not constant, and the
    remark says so."""
    flats, darks = taken(Chip(), 4)
    same = [replace(stack, exposure_s=FLAT_TIMES[i % 4]) for i, stack in enumerate(flats)]
    found = calibrated(same, darks, TOP).quantities["linearity_error"]
    assert found.known == "unknown"
    assert "not constant" in found.remark


def test_a_bent_curve_of_variances_gives_a_warning() -> None:
    """The test adds noise to the frames of every other level."""
    flats, darks = taken(Chip(), 4)
    plain = calibrated(flats, darks, TOP)
    rng = np.random.default_rng(0)
    for stack in flats[1:6:2]:
        shaken = stack.codes + rng.normal(0, 2.0, stack.codes.shape)
        stack.codes[:] = np.clip(np.rint(shaken), 0, TOP)
    found = calibrated(flats, darks, TOP)
    said = messages(found)
    assert [message.code for message in said] == ["NS0792"]
    assert said[0].severity == "warning"
    gain = found.quantities["conversion_gain"]
    assert gain.se > 5 * plain.quantities["conversion_gain"].se
    assert abs(gain.value - 20) < 4 * gain.se


def test_a_curve_that_is_hardly_bent_is_noted() -> None:
    """A dark of 2 % less noise than it should have, among many frames."""
    flats, darks = taken(Chip(), 4, 24, 60)
    quiet = Chip(read_e=29.7).made(np.random.default_rng(4))
    still = [*darks[:2], quiet.stack(0.0, DARK_TIMES[2], 60)]
    (said,) = messages(calibrated(flats, still, TOP))
    assert (said.code, said.severity) == ("NS0792", "note")


def test_a_program_divides_the_noise_over_its_reads() -> None:
    """A program of n reads has its read noise divided by the root of n. Its offsets sum to the
    measured offset."""
    found = calibrated(*taken(Chip(), 4), TOP)
    target = builtin_target("scamp5")
    alone = parameters(found, target, Chain())
    for chain, resets in ((Chain(2.0, 0.0, 0.0), 40.0), (Chain(20.0, 12.0, 2.0), 0.0)):
        chosen = parameters(found, target, chain)
        ratio = alone["read_noise_e"].value / chosen["read_noise_e"].value
        assert ratio == pytest.approx(chain.reads**0.5, rel=1e-4)
        assert chosen["reset_noise_e"].value == resets
        total = chosen["adc_offset_lsb"].value
        if chain.word_sum:
            total += chosen["analog_bias_lsb"].value * chain.word_sum
            assert chosen["adc_offset_lsb"].value == round(total)
        assert total == pytest.approx(found.quantities["offset"].value, abs=1e-4)
        assert chosen["analog_noise_lsb"].value == chosen["adc_noise_lsb"].value == 0
        assert chosen["analog_gain"].value == 1
