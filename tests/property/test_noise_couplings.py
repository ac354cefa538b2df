"""Noise under any rates, floats drawn by their bits: coupled, whole, and the same in any order."""

from __future__ import annotations

import math
import struct

import numpy as np
from drawn_counts import by_plan, by_reference
from hypothesis import given
from hypothesis import strategies as st

from nscc_runtime.noise import RATE_CAP, key, normals, poisson, uniforms
from nscc_runtime.noise.poisson_law import poisson_exact

STEP = 2.0**-53


def of_bits(bits: int) -> float:
    return struct.unpack("<d", struct.pack("<Q", bits))[0]


any_float = st.integers(0, 2**64 - 1).map(of_bits)
rates = st.integers(0, 0x7FEF_FFFF_FFFF_FFFF).map(of_bits)
drawable = rates.map(lambda rate: min(rate, RATE_CAP))
# Rates where something happens: uniform over the exponents from 2**-40 to 2**40.
common = st.integers((1023 - 40) << 52, (1023 + 40) << 52).map(of_bits)
units = st.integers(0, 2**52 - 1).map(lambda k: (2 * k + 1) * STEP)
tails = st.tuples(st.integers(1, 52), st.booleans()).map(
    lambda part: 1 - 2.0 ** -part[0] if part[1] else 2.0 ** -part[0]
)
any_unit = st.one_of(units, tails)


@given(any_unit, st.one_of(drawable, common), st.one_of(drawable, common))
def test_counts_never_decrease_in_the_rate(u, a, b):
    low, high = sorted((a, b))
    assert poisson_exact(u, low) <= poisson_exact(u, high)


@given(any_unit, common, st.integers(1, 40))
def test_counts_never_decrease_in_rates_that_are_neighbours(u, rate, steps):
    higher = rate + steps * math.ulp(rate)
    assert poisson_exact(u, rate) <= poisson_exact(u, higher)


@given(any_unit, any_unit, st.one_of(drawable, common))
def test_counts_never_decrease_in_the_uniform_number(a, b, rate):
    low, high = sorted((a, b))
    assert poisson_exact(low, rate) <= poisson_exact(high, rate)


@given(st.integers(0, 2**40), st.floats(9.0, 20.0), st.floats(9.0, 20.0))
def test_counts_of_plans_are_in_order_about_their_crossover(place, a, b):
    rates, places = np.array(sorted((a, b))), np.full(2, place)
    low, high = by_plan(key(1, 2), places, rates)
    assert low <= high
    assert abs(low - by_reference(key(1, 2), places, rates)[0]) <= 1


@given(st.lists(any_float, min_size=1, max_size=30), st.integers(0, 2**64 - 1))
def test_counts_of_any_rate_are_whole_numbers_or_marked_invalid(values, seed):
    rate = np.array(values)
    counts, valid = poisson(key(seed, 1), np.arange(len(values)), rate)
    assert np.array_equal(valid, ~np.isnan(rate))
    assert np.all(counts == np.floor(counts))
    assert np.all((counts >= 0) & (counts <= RATE_CAP + 10 * math.sqrt(RATE_CAP)))
    assert not counts[~valid].any()
    assert not counts[rate <= 0].any()


@given(st.data())
def test_draws_depend_on_neither_order_nor_pieces_of_the_pixels(data):
    n = data.draw(st.integers(1, 70))
    first = data.draw(st.integers(0, 2**40))
    order = np.array(data.draw(st.permutations(range(n))))
    cut = data.draw(st.integers(0, n))
    stream = key(data.draw(st.integers(0, 2**64 - 1)), 3)
    pixels = first + np.arange(n)
    rate = np.array(data.draw(st.lists(common, min_size=n, max_size=n)))
    whole = poisson(stream, pixels, rate)[0]
    assert np.array_equal(poisson(stream, pixels[order], rate[order])[0], whole[order])
    pieces = [
        poisson(stream, pixels[part], rate[part])[0] for part in (slice(cut), slice(cut, None))
    ]
    assert np.array_equal(np.concatenate(pieces), whole)
    for draw in (uniforms, normals):
        assert np.array_equal(draw(stream, pixels[order]), draw(stream, pixels)[order])
