"""Level 2, with few steps: the words gather the light of the open slots and keep the code."""

from __future__ import annotations

import importlib
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from lowering_oracle import container_of, does_as_told, lowered_as, program_from

from nscc.chips.load import load_target
from nscc.lower.exposure_plan import LOWERINGS, Misfit
from nscc.prove.proof import prove
from nscc.words.legality import decoded


@pytest.fixture(autouse=True)
def few_steps(monkeypatch):
    """Enough steps for a few sweeps."""
    module = importlib.import_module("nscc.lower.refinery")
    monkeypatch.setitem(module.ROUNDS, 2, ((6, 800), (1, 400), (1, 400)))


@st.composite
def tables(draw):
    """Shutters bool (codes, buckets, slots): bumps, and free bits."""
    slots = draw(st.sampled_from([2, 5, 8, 13, 33]))
    buckets = draw(st.sampled_from([1, 1, 2]))
    codes = draw(st.integers(2, 30))
    random = np.random.default_rng(draw(st.integers(0, 2**32)))
    if draw(st.booleans()):
        return random.random((codes, buckets, slots)) < draw(st.sampled_from([0.1, 0.5]))
    ends = np.sort(random.integers(0, slots + 1, (2, codes, buckets, 1)), axis=0)
    n = np.arange(slots)
    return (ends[0] <= n) & (n < ends[1])


@pytest.mark.slow
@given(
    tables(),
    st.sampled_from(LOWERINGS),
    st.sampled_from([13, 9, 6]),
    st.sampled_from([1024, 120]),
    st.sampled_from([1e3, 3e5]),
    st.booleans(),
)
def test_words_of_level_2_are_proved_and_cost_no_more_than_level_1(
    table, lowering, registers, store, slot_us, resets
):
    target = load_target("scamp5-algorithm1" if resets else "scamp5", Path())
    names = target.digital_registers
    names = (*names[: registers - 1], "R12")
    target = replace(target, digital_registers=names, store_words=store)
    program = program_from(table, [slot_us] * table.shape[2], target)
    found = lowered_as(program, lowering, 2)
    # The table does not fit the chip: there are no words to compare.
    if isinstance(found, Misfit):
        return
    plain = lowered_as(program, lowering, 1)
    assert found.price <= plain.price
    container = container_of(found, 2)
    # Without a refresh in time a code fades, and no proof can hold.
    if found.retained:
        assert prove(container, decoded(container)).holds
        assert does_as_told(container, seed=len(table))
