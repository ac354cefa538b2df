"""Any legal gates: improved, they answer the same demands in no more words."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st
from improve_oracle import chip, random_solution, words_of

from nscc.logic.cubes import Budget
from nscc.logic.improve import improve
from nscc.logic.problem import Machine


@st.composite
def chips(draw):
    """A chip of few or many registers, with any limits."""
    return chip(
        draw(st.integers(4, 13)),
        draw(st.booleans()),
        draw(st.sampled_from([None, 2, 4])),
        draw(st.sampled_from([None, 1, 2])),
        draw(st.booleans()),
    )


@given(chips(), st.integers(0, 2**32), st.sampled_from([0, 30, 500, 4000]), st.booleans())
def test_improved_gates_do_the_same(target, seed, steps, keep_kernels):
    machine = Machine.of(target)
    problem, solution = random_solution(seed, machine)
    before = words_of(solution, problem, target)
    improved = improve(solution, problem, machine, Budget(steps), keep_kernels=keep_kernels)
    after = words_of(improved, problem, target, seed=1)
    assert after <= before
    assert improved.planes == solution.planes
    if keep_kernels:
        assert len(set(improved.segments())) <= len(set(solution.segments()))
