"""Any legal gates: improved, they answer the same demands in no more words."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st
from improve_oracle import chip, random_solution, words_of

from nscc.logic.cubes import Budget
from nscc.logic.improve.search import balance, improve
from nscc.logic.problem import Machine
from nscc.lower.schedule import allocate, words


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


STEPS = st.sampled_from([0, 30, 500, 4000])


@given(chips(), st.integers(0, 2**32), STEPS)
def test_improved_gates_answer_their_demands_in_no_more_words(target, seed, steps):
    machine = Machine.of(target)
    problem, solution = random_solution(seed, machine)
    before = words_of(solution, problem, target)
    improved = improve(solution, problem, machine, Budget(steps))
    assert words_of(improved, problem, target, seed=1) <= before
    assert improved.planes == solution.planes


@given(chips(), st.integers(0, 2**32), st.sampled_from([0, 300, 4000]))
def test_balanced_gates_answer_their_demands_in_no_more_words(target, seed, steps):
    """The boundary with the most words gets no larger."""
    machine = Machine.of(target)
    problem, solution = random_solution(seed, machine)
    last = problem.demands[-1].boundary
    others = [seed >> n & 3 for n in range(last + 1)]
    before = words_of(solution, problem, target)
    found = balance(solution, problem, machine, Budget(steps), others)
    assert words_of(found, problem, target, seed=1) <= before
    assert largest(found, problem, others, target) <= largest(solution, problem, others, target)


def largest(solution, problem, others, target):
    """Most words at a boundary."""
    counts = list(others)
    allocation = allocate(solution, target)
    parts = [(0, solution.opening), (len(others) - 1, solution.closing)]
    parts += zip((d.boundary for d in problem.demands), solution.answers, strict=True)
    for boundary, segments in parts:
        counts[boundary] += sum(len(words(segment, allocation)) for segment in segments)
    return max(counts)
