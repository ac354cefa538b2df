"""Whole frames: hand-made programs of every lowering against the sum of S[n] L[n]."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from emulator_programs import CLEAR, LEVEL, bumps, target_of

from nscc.words.container import StoredKernel
from nscc.words.encoding import encode
from nscc_runtime.emulator import chip_program, expose
from nscc_runtime.light import Light

SHAPES = ((1, 1), (3, 5), (1, 65), (5, 13), (7, 129))
LOWERINGS = ("accumulate", "latch", "edges")


def random_bumps(random, shape, slots, lowering):
    """Start (None: from slot 0 on) and stop of every pixel, never and always open included."""
    stop = random.integers(0, slots + 1, shape)
    if lowering == "latch":
        return None, stop
    start = random.integers(0, slots + 1, shape)
    beyond = 2 ** int(slots).bit_length() - 1
    never = start >= stop
    return np.where(never, beyond, start), np.where(never, beyond, stop)


def is_open(start, stop, slots):
    """S bool (slots, rows, cols)."""
    n = np.arange(slots)[:, None, None]
    return (n < stop) & (True if start is None else n >= start)


def check(container, light, shutter, **options):
    """The promise: within 1e-6 of the sum and 1e-9 of all the light; never open is +0."""
    found = expose(container, light, **options)
    dense = light.dense().astype(np.float64)
    truth = np.where(shutter, dense, 0.0).sum(axis=0)
    error = np.abs(found.exposure_e[0] - truth)
    assert (error <= 1e-6 * truth + 1e-9 * dense.sum(axis=0)).all()
    never = found.exposure_e[0][~shutter.any(axis=0)]
    assert not never.any()
    assert not np.signbit(never).any()
    assert found.valid.all()
    return found


def over_exponents(random, shape):
    """Light spread evenly over the exponents 1e-30 .. 1e30, and some darkness."""
    light = 10.0 ** random.uniform(-30, 30, shape)
    return np.where(random.random(shape) < 0.1, 0, light).astype(np.float32)


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("lowering", LOWERINGS)
def test_frames_are_the_sum_of_light_in_open_slots(shape, lowering):
    """For flat light, light of all magnitudes and none, each pixel holds the sum over the slots in
    which its shutter is open."""
    random = np.random.default_rng(len(lowering) + shape[1])
    slots = 24
    start, stop = random_bumps(random, shape, slots, lowering)
    target = target_of(shape, "scamp7")
    container = bumps(target, start, stop, slots, lowering)
    shutter = is_open(start, stop, slots)
    flat = Light.of_clip(np.full((slots, *shape), 100.0, np.float32))
    check(container, flat, shutter)
    for seed in range(3):
        wild = Light.of_clip(over_exponents(random, (slots, *shape)))
        check(container, wild, shutter, device_seed=seed)
    check(container, Light.of_clip(np.zeros((slots, *shape), np.float32)), shutter)


@pytest.mark.parametrize("lowering", LOWERINGS)
def test_stills_and_repeated_frames_give_the_light_of_open_slots(lowering):
    """Light given as one still with slot times, or as weighted stored pictures, is summed like a
    clip of one picture a slot."""
    shape, slots = (6, 33), 16
    random = np.random.default_rng(3)
    start, stop = random_bumps(random, shape, slots, lowering)
    container = bumps(target_of(shape, "scamp7"), start, stop, slots, lowering)
    shutter = is_open(start, stop, slots)
    picture = over_exponents(random, shape)
    check(container, Light.of_still(picture, np.full(slots, 1e-3)), shutter)
    check(container, Light.of_still(picture, 2.0 ** -np.arange(slots)), shutter)
    terms = random.integers(0, 4, slots)
    row_start = np.concatenate([[0], np.cumsum(terms)]).astype(np.int64)
    mixed = Light(
        frames=over_exponents(random, (3, *shape)),
        row_start=row_start,
        frame_index=random.integers(0, 3, row_start[-1]).astype(np.int32),
        weight=random.random(row_start[-1]),
        kind="clip",
    )
    check(container, mixed, shutter)


def test_a_shutter_that_is_always_open_sums_the_rounded_slots_in_their_order():
    """PIX is never reset in between."""
    shape, slots = (4, 31), 8
    random = np.random.default_rng(5)
    light = Light.of_still(random.random(shape, dtype=np.float32), np.repeat(random.random(4), 2))
    container = bumps(target_of(shape, "scamp7"), None, np.full(shape, slots), slots, "accumulate")
    found = expose(container, light).exposure_e[0]
    total = np.zeros(shape)
    for n in range(slots):
        total += light.slot(n)
    np.testing.assert_allclose(found, total, rtol=1e-14)


@pytest.mark.parametrize("lowering", LOWERINGS)
def test_blocks_change_no_bit(lowering, monkeypatch):
    """With blocks of 64 to 65 536 pixels, the electrons of a frame of 9 x 61 pixels have equal
    bytes."""
    shape, slots = (9, 61), 12
    random = np.random.default_rng(7)
    start, stop = random_bumps(random, shape, slots, lowering)
    container = bumps(target_of(shape, "scamp7"), start, stop, slots, lowering)
    light = Light.of_clip(over_exponents(random, (slots, *shape)))
    whole = expose(container, light, device_seed=9)
    for block in (64, 128, 192, 512, 65536):
        monkeypatch.setattr(chip_program, "EMULATED_BLOCK", block)
        part = expose(container, light, device_seed=9)
        assert part.exposure_e.tobytes() == whole.exposure_e.tobytes()


@pytest.mark.parametrize("light_e", [1e-30, 1.0, 1e30])
@pytest.mark.parametrize("forgotten", [CLEAR[-1], LEVEL[-1]])
def test_a_program_that_forgets_to_set_a_register_is_far_off(forgotten, light_e):
    """Without the word that clears or sets a register, over 85 % of pixels are wrong by more than
    10 %. With it, none is."""
    shape, slots = (8, 8), 4
    container = bumps(target_of(shape, "scamp7"), None, np.full(shape, slots), slots, "accumulate")
    light = Light.of_clip(np.full((slots, *shape), light_e, np.float32))
    first, *others = container.kernels
    words = tuple(word for word in first.words if word != encode(forgotten))
    assert len(words) == len(first.words) - 1
    broken = replace(container, kernels=(StoredKernel("k0", words), *others))
    truth = light.total_e()
    np.testing.assert_allclose(expose(container, light).exposure_e[0], truth, rtol=1e-12)
    far = np.abs(expose(broken, light).exposure_e[0] / truth - 1) > 0.1
    assert far.mean() > 0.85


def test_light_in_a_read_only_array_in_fortran_order_gives_the_same_exposure():
    shape, slots = (6, 10), 4
    random = np.random.default_rng(11)
    frames = random.random((slots, *shape), dtype=np.float32)
    container = bumps(target_of(shape, "scamp7"), None, np.full(shape, slots), slots, "latch")
    expected = expose(container, Light.of_clip(frames)).exposure_e
    odd = np.asfortranarray(frames)
    odd.flags.writeable = False
    assert expose(container, Light.of_clip(odd)).exposure_e.tobytes() == expected.tobytes()
