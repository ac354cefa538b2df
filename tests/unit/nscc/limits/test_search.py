"""Searches for a largest size: against counting through all sizes, within their budgets."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from marks import slow

from nscc.chips.load import load_target
from nscc.compiler import compile_source
from nscc.limits.families import families, random_rows
from nscc.limits.survey import GIVE_UP_AFTER, SizeTrial, candidates, explore
from nscc.pipeline import Options
from nscc.program.limits import bits_needed, impossible_from, largest, largest_with
from nscc.source import Source


def explored(sizes, fits, budget=100):
    """The sizes that a search compiled, in order, and what it returned."""
    search = explore(sizes, lambda size: SizeTrial(size, fits(size)), budget)
    made = []
    while True:
        try:
            made.append(next(search))
        except StopIteration as end:
            return made, end.value


@given(st.integers(1, 300), st.integers(0, 300), st.integers(1, 40))
def test_largest_is_exact_where_the_budget_lasts(most, threshold, budget):
    calls = []

    def fits(size):
        calls.append(size)
        return size <= threshold

    found = largest(1, most, fits, budget)
    assert len(calls) <= budget
    assert all(1 <= size <= most for size in calls)
    assert found is None or (found in calls and found <= threshold)
    if budget > 10:
        assert found == (min(most, threshold) or None)


@given(st.integers(1, 2000), st.integers(0, 2500))
def test_exploring_ends_between_a_size_that_fits_and_one_that_does_not(most, threshold):
    """If sizes up to a threshold fit, the search finds the threshold and has tried the next
    size."""
    made, tried = explored(candidates(lambda n: n, 1, most), lambda size: size <= threshold)
    assert {trial.size: trial for trial in made} == tried
    best = max((size for size in tried if tried[size].fits), default=0)
    assert best == min(most, threshold)
    if best < most:
        assert not tried[best + 1].fits


def test_exploring_records_smaller_sizes_that_do_not_fit():
    """Size 4 does not fit, but 8 and 9 do: the largest found is 9, and 4 stays recorded."""
    _, tried = explored([1, 2, 4, 8, 16], lambda size: size != 4 and size <= 9)
    assert not tried[4].fits
    assert [size for size in sorted(tried) if tried[size].fits][-1] == 9


def test_exploring_gives_up_and_keeps_its_budget():
    """If nothing fits it ends after GIVE_UP_AFTER sizes. With a budget of 5 it makes five
    trials."""
    made, _ = explored([1, 2, 4, 8, 16], lambda size: False)
    assert [trial.size for trial in made] == [1, 2, 4, 8, 16][:GIVE_UP_AFTER]
    made, _ = explored([1, 1000], lambda size: size < 777, budget=5)
    assert len(made) == 5


def test_candidates_hold_every_size_where_one_more_bit_is_needed():
    """The sizes tried are in order and hold each size below which one bit fewer was enough."""
    sizes = candidates(lambda n: n * (n + 1) // 2, 1, 127)
    needs = [bits_needed(n * (n + 1) // 2) for n in range(1, 129)]
    steps = [n for n in range(1, 128) if needs[n] > needs[n - 1]]
    assert set(steps) <= set(sizes)
    assert sizes == sorted(set(sizes))


@pytest.mark.parametrize("shutters", [1, 2, 3, 4, 5, 8191, 8192, 8193])
def test_bits_needed_is_the_least_that_numbers_all_shutters(shutters):
    """One shutter needs 0 bits. At 8192 and 8193 the number rises from 13 to 14."""
    bits = bits_needed(shutters)
    assert 2**bits >= shutters
    assert bits == 0 or 2 ** (bits - 1) < shutters


@given(st.integers(0, 100), st.integers(0, 50))
def test_largest_with_equals_counting(most, ceiling):
    counted = [n for n in range(1, ceiling + 1) if n * n <= most]
    assert largest_with(lambda n: n * n, most, 1, ceiling) == max(counted, default=0)


@pytest.mark.parametrize("size", [3, slow(4), slow(5), slow(6)])
def test_families_count_their_shutters(size):
    """The expected counts come from the decode table of the compiled program."""
    for family in families():
        at = size + family.least - 1
        source = Source("family.nsl", family.text(at, "1ms"))
        program = compile_source(source, Path(), Options(codes="open")).program
        assert len(program.table.shutters) == family.shutters(at), family.name
        assert len(program.frame.slot_us) == family.slots(at), family.name


def test_too_few_registers_make_sizes_impossible():
    target = load_target("scamp5", Path())
    few = replace(target, digital_registers=target.digital_registers[:4])
    found = {family.name: impossible_from(family.shutters, few) for family in families()}
    assert found["a"] is None
    # 4 registers have 16 states: 16 stops fit, or 15 and one for a shutter that never opens.
    assert (found["b 1..N"], found["b 0..N"]) == (17, 16)
    assert found["c len 4"] == 20  # 17 starts, 0..16
    assert found["d"] == 6  # 21 bumps; at 5 slots there are 15
    assert found["e"] == 5
    assert found["codebook, 64 rows"] == 1
    assert found["codebook, 16 slots"] == 17


def test_rows_are_distinct_and_of_their_length():
    """Forty random rows of 70 bits are distinct. Asked for 64 rows of 3 bits, it gives all eight
    that there are."""
    rows = random_rows(40, 70)
    assert len(set(rows)) == 40
    assert {len(row) for row in rows} == {70}
    assert sorted(random_rows(64, 3)) == [f"{n:03b}" for n in range(8)]
