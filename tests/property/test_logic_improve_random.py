"""Any legal gates: improved, they answer the same demands in no more words."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st
from improve_oracle import chip, random_solution, words_of

from nscc.logic.cubes import Budget
from nscc.logic.improve import balance, improve
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


@given(chips(), st.integers(0, 2**32), st.sampled_from([0, 300, 4000]), st.integers(0, 6))
def test_balanced_gates_do_the_same(target, seed, steps, limit):
    """The largest boundary gets no larger, the words no more."""
    machine = Machine.of(target)
    problem, solution = random_solution(seed, machine)
    last = problem.demands[-1].boundary
    others = [seed >> n & 3 for n in range(last + 1)]
    before = words_of(solution, problem, target)
    found = balance(solution, problem, machine, Budget(steps), others, limit)
    assert words_of(found, problem, target, seed=1) <= before
    assert largest(found, problem, others) <= largest(solution, problem, others)


def largest(solution, problem, others):
    """Most words at a boundary; the masked register's are not counted."""
    words = list(others)
    parts = [(0, solution.opening), (len(others) - 1, solution.closing)]
    parts += zip((d.boundary for d in problem.demands), solution.answers, strict=True)
    for boundary, segments in parts:
        for segment in segments:
            for gate in segment:
                pair = gate.destination in gate.sources and gate.name != "WHERE"
                words[boundary] += 1 + pair
    return max(words)
