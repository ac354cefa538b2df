"""Cascades for any book and any machine: every demand answered in two frames, the code kept."""

from __future__ import annotations

import numpy as np
from gates_oracle import asked_of, words_if_right
from hypothesis import given
from hypothesis import strategies as st

from nscc.logic.cascade import cascade
from nscc.logic.problem import GaveUp, Machine

machines = st.builds(
    Machine,
    registers=st.integers(3, 13),
    masked=st.booleans(),
    or_sources=st.sampled_from([None, 2, 3, 4]),
    where_sources=st.sampled_from([None, 1, 2, 3]),
    where_reads_flag=st.booleans(),
)


@st.composite
def books(draw):
    """Random rows of any density, (shutters,[ buckets,] slots); some slots may repeat others."""
    random = np.random.default_rng(draw(st.integers(0, 2**32)))
    shape = (draw(st.integers(2, 90)), *draw(st.sampled_from([(), (2,)])), draw(st.integers(1, 20)))
    table = random.random(shape) < draw(st.sampled_from([0.05, 0.3, 0.5, 0.9]))
    if draw(st.booleans()):
        table = table[..., random.integers(0, shape[-1], shape[-1])]
    return table


@given(books(), machines, st.sampled_from(["accumulate", "edges"]), st.sampled_from([3000, 20_000]))
def test_cascades_answer_every_demand(table, machine, lowering, steps):
    asked = asked_of(table, lowering)
    # All shutters are alike, so nothing is asked.
    if not asked.demands:
        return
    try:
        solution = next(cascade(asked, machine, steps))
    except GaveUp:
        return
    words_if_right(asked, machine, solution)
