"""Bumps of random frames, limits and requirements: both generators answer every demand, on pixels
of a chip that hold every code, before improvement and after it."""

from __future__ import annotations

import numpy as np
from hypothesis import assume, given
from hypothesis import strategies as st
from improve_oracle import chip, words_of
from lowering_oracle import program_from

from nscc.logic.bumps import halved_bumps, paired_bumps
from nscc.logic.cubes import Budget
from nscc.logic.improve.search import improve
from nscc.logic.problem import GaveUp, Machine
from nscc.logic.replay import fault
from nscc.lower.decoding import problem_of
from nscc.lower.exposure_plan import levels, plan_exposure, timeline

CHIPS = st.builds(
    chip,
    registers=st.integers(11, 13),
    masked=st.booleans(),
    or_sources=st.sampled_from([None, 2, 4]),
    where_sources=st.sampled_from([None, 1, 2, 3]),
)


@st.composite
def problems(draw):
    """What the level lowering asks for bumps that some requirement lets pass."""
    slots = draw(st.integers(4, 34))
    shortest = draw(st.integers(1, 4))
    longest = draw(st.integers(shortest, slots))
    first = draw(st.integers(0, slots // 3))
    last = draw(st.integers(slots - slots // 3, slots))
    start_step, stop_step = draw(st.integers(1, 3)), draw(st.integers(1, 3))
    modulus = draw(st.integers(1, 4))
    ends = [
        (start, stop)
        for start in range(first, slots, start_step)
        for stop in range(start + shortest, min(last, start + longest) + 1, stop_step)
        if (7 * start + 5 * stop) % modulus == 0
    ]
    assume(ends)
    start, stop = np.array(ends)[:, :, None].transpose(1, 0, 2)
    table = (start <= np.arange(slots)) & (np.arange(slots) < stop)
    if draw(st.booleans()):
        table = np.concatenate([table, np.zeros((1, slots), bool)])
    assume(len(table) > 1)
    slot_us = draw(st.sampled_from([1e3, 1e5, 6e5]))
    program = program_from(table, [slot_us] * slots)
    opens = levels(program)
    plan = plan_exposure(program, "accumulate", opens)
    return problem_of(program, plan, timeline(program.frame.slot_us, 1, program.target), opens)[0]


@given(problems(), CHIPS, st.sampled_from([0, 500]))
def test_every_solution_answers_every_demand(problem, target, steps):
    machine = Machine.of(target)
    for generator in (paired_bumps, halved_bumps):
        try:
            found = list(generator(problem, machine, 500))
        except GaveUp:
            continue
        for solution in found:
            assert fault(problem, machine, solution) is None
            before = words_of(solution, problem, target)
            improved = improve(solution, problem, machine, Budget(steps))
            assert words_of(improved, problem, target, seed=1) <= before
