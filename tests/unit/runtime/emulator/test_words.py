"""Single rules of the array that a random program seldom meets, and what cannot run at all."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from emulator_programs import container_of, target_of

from nscc.diagnostics.diagnostic import Rejected
from nscc.operations import op, pair
from nscc.words.container import Readout, StoredKernel
from nscc_runtime.emulator import expose
from nscc_runtime.light import Light

SHAPE = (2, 35)
PLANES = {
    name: np.random.default_rng(k).random(SHAPE) < 0.5
    for k, name in enumerate(("R0", "R1", "R2", "R3", "R12"))
}
LIGHT = Light.of_clip(np.full((1, *SHAPE), 8.0, np.float32))
SHOW = [op("bus", ["NEWS"], ["PIX"]), op("bus", ["A"], ["NEWS"])]
CLEAR = [op("all"), op("bus", ["NEWS"]), op("bus", ["A"], ["NEWS"])]


def run(words, light=LIGHT, **behaviour):
    """A at the end of a frame that runs `words` at boundary 0, the pixels' bits being PLANES."""
    container = container_of(target_of(SHAPE, **behaviour), PLANES, [words], [(0, 0)], 1)
    return expose(container, light).exposure_e[0]


def shown(words, register="FLAG", **behaviour):
    """Where a digital register is 1 after `words`."""
    copy = [op("MOV", ["R5"], [register])]
    return run([*words, *copy, *CLEAR, op("WHERE", (), ["R5"]), *SHOW], **behaviour) != 0


def test_where_may_read_the_flag_it_writes():
    words = [op("WHERE", (), ["R1"]), op("WHERE", (), ["R2", "R3", "FLAG"])]
    expected = PLANES["R1"] | PLANES["R2"] | PLANES["R3"]
    np.testing.assert_array_equal(shown(words, where_reads_flag=True), expected)


def test_a_word_that_writes_mask_and_masked_uses_the_mask_as_it_was():
    found = shown([op("SET", ["R0", "R12"])], "R12")
    np.testing.assert_array_equal(found, PLANES["R12"] | PLANES["R0"])


def test_the_second_half_of_a_pair_is_masked_too():
    found = shown(pair("NOR", "R12", ["R12", "R1"]), "R12")
    written = ~(PLANES["R12"] | PLANES["R1"])
    np.testing.assert_array_equal(found, np.where(PLANES["R0"], written, PLANES["R12"]))


def test_a_chip_without_the_rule_writes_everywhere():
    """Where the chip has no mask register, SET reaches every pixel. Where it has one, only the
    pixels of its plane."""
    words = [op("CLR", ["R0"]), op("SET", ["R12"])]
    free = {"mask_register": None, "masked_register": None}
    assert shown(words, "R12", **free).all()
    np.testing.assert_array_equal(shown(words, "R12"), PLANES["R12"])


@pytest.mark.parametrize(("behaviour", "everywhere"), [("no", True), ("yes", False)])
def test_resets_obey_the_flag_only_where_the_chip_says_so(behaviour, everywhere):
    """After `WHERE R1`, `rpix` resets all pixels (`no`) or only those whose R1 is set (`yes`)."""
    level = run([*CLEAR, op("rpix"), *SHOW])
    words = [*CLEAR, op("WHERE", (), ["R1"]), op("rpix"), op("all"), *SHOW]
    found = run(words, reset_honours_flag=behaviour) == level
    np.testing.assert_array_equal(found, True if everywhere else PLANES["R1"])


def test_an_unknown_reset_is_taken_to_honour_the_flag():
    words = [*CLEAR, op("WHERE", (), ["R1"]), op("rpix"), op("all"), *SHOW]
    yes, unknown = (run(words, reset_honours_flag=value) for value in ("yes", "unknown"))
    np.testing.assert_array_equal(yes, unknown)


def test_digital_words_ignore_the_flag():
    found = shown([op("WHERE", (), ["R1"]), op("MOV", ["R2"], ["R3"])], "R2")
    np.testing.assert_array_equal(found, PLANES["R3"])


def test_select_and_in_read_zero():
    """The register SELECT and the analog input IN, to which nothing is connected, read as 0 in all
    pixels."""
    assert not shown([op("MOV", ["R2"], ["SELECT"])], "R2").any()
    assert not run([*CLEAR, op("bus", ["A"], ["IN"])]).any()


def test_the_initial_register_contents_depend_on_the_device_seed_alone():
    """Before its first write a register holds 2 to 6 electrons of either sign. The same device seed
    gives the same bytes, another seed others."""
    target = target_of(SHAPE)
    program = container_of(target, PLANES, [[]], [], 1, readouts=[Readout("C", "frame")])
    first, again, other = (expose(program, LIGHT, device_seed=seed) for seed in (1, 1, 2))
    assert first.exposure_e.tobytes() == again.exposure_e.tobytes()
    assert (first.exposure_e != other.exposure_e).mean() > 0.9
    assert first.exposure_e.any(axis=(1, 2)).all()
    size = abs(first.exposure_e)
    assert size.min() >= 2
    assert size.max() <= 6
    assert np.unique(size).size > 60
    assert (first.exposure_e < 0).any()
    assert (first.exposure_e > 0).any()


def test_seeds_of_any_size_are_accepted():
    program = container_of(target_of(SHAPE), PLANES, [SHOW], [(0, 0)], 1)
    for seed in (0, -1, 2**63, 2**64 - 1, 10**30):
        assert np.isfinite(expose(program, LIGHT, device_seed=seed).exposure_e).all()


def test_split_pair_and_unknown_word_are_refused():
    """A pair of words with another between, or half a pair, gives NS0703. Bits that are no word
    give NS0701."""
    read, write = pair("NOR", "R1", ["R1"])
    for words in ([read, op("nop"), write], [write], [read]):
        with pytest.raises(Rejected, match="NS0703"):
            run(words)
    container = container_of(target_of(SHAPE), PLANES, [SHOW], [(0, 0)], 1)
    bad = replace(container, kernels=(StoredKernel("bad", ((1, 2, 3, 4, 5),)),))
    with pytest.raises(Rejected, match="NS0701"):
        expose(bad, LIGHT)


def test_containers_without_codes_and_light_of_another_size_are_refused():
    """No pixel codes give NS0741, light of another size NS0734. A container without readouts is
    unsound (ValueError)."""
    container = container_of(target_of(SHAPE), PLANES, [SHOW], [(0, 0)], 1)
    with pytest.raises(Rejected, match="NS0741"):
        expose(replace(container, pixel_codes=None), LIGHT)
    for shape in ((1, 2, 34), (2, 2, 35), (1, 35, 2)):
        with pytest.raises(Rejected, match="NS0734"):
            expose(container, Light.of_clip(np.ones(shape, np.float32)))
    with pytest.raises(ValueError, match="unsound"):
        expose(replace(container, readouts=()), LIGHT)


def test_a_container_without_decode_table_entries_in_use_still_runs():
    container = container_of(target_of(SHAPE), PLANES, [[*CLEAR, *SHOW]], [(1, 0)], 1)
    assert expose(container, LIGHT).valid.all()


def test_light_too_bright_for_floats_is_invalid_not_an_error():
    bright = Light.of_still(np.full(SHAPE, 3e38, np.float32), np.array([1e3]))
    container = container_of(target_of(SHAPE), PLANES, [[*CLEAR, *SHOW]], [(1, 0)], 1)
    assert not expose(container, bright).valid.any()
