"""Any shutters, any chip: the words gather the light of the open slots and keep the code."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from lowering_oracle import (
    container_of,
    does_as_told,
    longest_memory_us,
    lowered_as,
    program_from,
)

from nscc.chips.load import load_target
from nscc.lower.exposure_plan import LOWERINGS, Misfit
from nscc.prove.proof import prove, shutters
from nscc.words.legality import decoded


@st.composite
def targets(draw):
    """A built-in chip, with some of its behaviour changed."""
    target = load_target(draw(st.sampled_from(["scamp5", "scamp5-algorithm1", "scamp7"])), Path())
    target = replace(
        target,
        reset_honours_flag=draw(st.sampled_from(["no", "yes", "unknown"])),
        where_reads_flag=draw(st.booleans()),
        where_obeys_flag=draw(st.booleans()),
        or_sources=draw(st.sampled_from([None, 2, 4])),
        where_sources=draw(st.sampled_from([None, 2, 3])),
        store_words=draw(st.sampled_from([100, 1024])),
    )
    registers = draw(st.integers(2, 13))
    if draw(st.booleans()):
        return target
    names = target.digital_registers
    if draw(st.booleans()):
        return replace(target, digital_registers=(*names[: registers - 1], "R12"))
    return replace(
        target, digital_registers=names[: registers - 1], mask_register=None, masked_register=None
    )


@st.composite
def tables(draw):
    """Shutters bool (codes, buckets, slots): bumps, and free bits of any density."""
    slots = draw(st.sampled_from([1, 2, 3, 5, 7, 8, 13, 17, 33, 65]))
    buckets = draw(st.sampled_from([1, 1, 1, 2, 3, 6]))
    codes = draw(st.integers(1, 40))
    random = np.random.default_rng(draw(st.integers(0, 2**32)))
    if draw(st.booleans()):
        return random.random((codes, buckets, slots)) < draw(st.sampled_from([0.1, 0.5, 0.9]))
    ends = np.sort(random.integers(0, slots + 1, (2, codes, buckets, 1)), axis=0)
    if draw(st.booleans()):
        ends[0] = 0
    n = np.arange(slots)
    return (ends[0] <= n) & (n < ends[1])


@st.composite
def slot_times(draw, slots):
    """Equal slots, short unequal ones, or ones that need refresh inside the frame."""
    low, high = draw(st.sampled_from([(1e3, 1e3), (100, 1e4), (1e5, 1e6)]))
    return tuple(draw(st.floats(low, high)) for _ in range(slots))


@given(st.data())
def test_words_open_the_shutters_of_random_tables(data):
    table = data.draw(tables())
    target = data.draw(targets())
    program = program_from(table, data.draw(slot_times(table.shape[2])), target)
    level = data.draw(st.sampled_from([0, 0, 1, 1, 1, 2]))
    lowered = lowered_as(program, data.draw(st.sampled_from(LOWERINGS)), level)
    # The table does not fit the chip: there are no words.
    if isinstance(lowered, Misfit):
        return
    container = container_of(lowered, level)
    kernels = decoded(container)
    assert kernels == lowered.schedule.kernels
    found = shutters(container, kernels)
    assert found is not None
    np.testing.assert_array_equal(found, program.table.shutters)
    if lowered.retained:
        assert does_as_told(container, seed=len(table))
        assert prove(container, kernels).holds
        assert longest_memory_us(container) <= target.digital_retention_us
