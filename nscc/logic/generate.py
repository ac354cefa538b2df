"""The generators, in the order in which they are tried, and what each level of effort allows."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from nscc.logic import encodings, events, field_digits, nested, spans, states, windows
from nscc.logic.cascade import cascade
from nscc.logic.cubes import Budget, Encoding, emit
from nscc.logic.problem import GaveUp, Machine, Problem, Solution

# Search steps of one generator at each level; a step is one cofactor of a truth vector
# of up to 512 shutters.
SEARCH_STEPS = {0: 50_000, 1: 400_000, 2: 500_000, 3: 4_000_000}

# Where all of them gave up, they are tried again with this many: seconds instead of none at all.
PATIENT_STEPS = 4_000_000

# Covers of more shutters than this are tried only where nothing else works: they would not win.
MOST_COVERED = 512

# A family's member of at most so many times the words that every solution needs ends the search.
_CLOSE = 1.1

# Cascades take seconds to search; they are tried where no family's member comes so near.
_WORTH_CASCADES = {2: 3.0, 3: 1.1}

Generator = Callable[[Problem, Machine, Budget], Solution]
Family = Callable[[Problem, Machine, int], Iterator[Solution]]


def _emitted(encode: Callable[[Problem, Machine, Budget], Encoding]) -> Generator:
    def generate(problem: Problem, machine: Machine, budget: Budget) -> Solution:
        return emit(problem, machine, encode(problem, machine, budget))

    return generate


# One word a demand: nothing can be cheaper, so nothing else is tried after one of these.
DIRECT: tuple[Generator, ...] = (
    _emitted(encodings.stored_predicates),
    _emitted(encodings.one_hot),
)
# Equalities: a few words a demand, at any number of shutters and slots.
EQUALITIES: tuple[Generator, ...] = (
    _emitted(encodings.gray_times),
    _emitted(encodings.gray_index),
    states.state_register,
    states.state_in_flag,
)
# Covers: any predicates at all, at a price that grows with them.
COVERS: tuple[Generator, ...] = (
    _emitted(encodings.covered_fields),
    _emitted(encodings.covered_levels),
    _emitted(encodings.covered_both_polarities),
    _emitted(encodings.covered_stored),
    _emitted(encodings.covered_gray_index),
)
# Arbitrary shutters, by search over several levels of gates: from -O2 on.
CASCADES: tuple[Generator, ...] = (cascade,)
# The dearest: every shutter of every predicate by itself. Few kernels serve all of them.
LAST: tuple[Generator, ...] = (_emitted(encodings.gray_index_wide),)
# Families with parameters (radices, polarities), all of whose members are worth a price; from -O2.
FAMILIES: tuple[Family, ...] = (
    nested.digits,
    nested.counted,
    windows.windows,
    windows.toggled_windows,
    spans.stored_spans,
    spans.counted_spans,
    events.equalities,
    field_digits.field_digits,
)


def solutions(problem: Problem, machine: Machine, level: int) -> Iterator[Solution]:
    """Solutions of a problem, each from another generator; none where every one gives up.

    They are made as they are asked for, those first that tend to be cheapest. The caller prices
    them: what a solution costs depends on the words around it.
    """
    if not problem.demands:
        yield Solution("no code is needed", (), (), 0, 0, (), (), ())
        return
    steps = SEARCH_STEPS[level]
    direct = list(_tries(DIRECT, problem, machine, steps))
    if direct:
        yield min(direct, key=lambda s: len(s.planes))
        return
    found, fewest = False, float("inf")
    if level >= 2:
        for solution in _members(problem, machine, steps):
            yield solution
            found = True
            fewest = min(fewest, sum(gate.words for s in solution.segments() for gate in s))
    least = _fewest_words(problem, machine)
    close = fewest <= _CLOSE * least
    for solution in _tries(EQUALITIES, problem, machine, steps):
        yield solution
        found = True
    if level >= 2 and fewest > _WORTH_CASCADES[level] * least:
        for solution in _tries(CASCADES, problem, machine, steps):
            yield solution
            found = True
    if found and (close or problem.shutters > MOST_COVERED):
        return
    for group, allowed in ((COVERS, steps), ((*COVERS, *LAST), PATIENT_STEPS)):
        for solution in _tries(group, problem, machine, allowed):
            yield solution
            found = True
        if found:
            return


def _fewest_words(problem: Problem, machine: Machine) -> int:
    """Words that every solution needs: one a demand, two for what cannot be stored as well."""
    asked = [d.predicate for i, d in enumerate(problem.demands) if not problem.answered(i)]
    return len(asked) + max(0, len(set(asked)) - machine.registers)


def _members(problem: Problem, machine: Machine, steps: int) -> Iterator[Solution]:
    for family in FAMILIES:
        try:
            yield from family(problem, machine, steps)
        except GaveUp:
            continue


def _tries(
    group: tuple[Generator, ...], problem: Problem, machine: Machine, steps: int
) -> Iterator[Solution]:
    for generate in group:
        try:
            yield generate(problem, machine, Budget(steps))
        except GaveUp:
            continue
