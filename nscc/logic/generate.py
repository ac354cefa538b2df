"""The generators of encodings, their order, and the optimisation levels that use them."""

from __future__ import annotations

import traceback
from collections.abc import Callable, Iterable, Iterator
from itertools import islice
from math import inf
from typing import TYPE_CHECKING, Literal

from nscc.diagnostics.diagnostic import Diagnostic, Rejected, Severity
from nscc.lazy import LazyFunctions
from nscc.logic.cubes import Budget, Encoding, emit
from nscc.logic.problem import GaveUp, Machine, Problem, Solution
from nscc.logic.replay import fault
from nscc.plugins import Group, added, unusable
from nscc.record import Record

if TYPE_CHECKING:
    from nscc.logic import cascade, composed, encodings, events, folded_times
else:  # `check` calls few of them
    cascade, composed, encodings, events, folded_times = (
        LazyFunctions(f"nscc.logic.{name}")
        for name in ("cascade", "composed", "encodings", "events", "folded_times")
    )

# Search steps of a generator at each level; a step is a cofactor of a truth vector of up to 512
# shutters.
SEARCH_STEPS = {0: 50_000, 1: 400_000, 2: 500_000, 3: 4_000_000}

# Steps of a second attempt after all generators gave up; it takes seconds.
PATIENT_STEPS = 4_000_000

# With more shutters, covers are too expensive and only tried if nothing else works.
MOST_COVERED = 512

# Solutions of a family below LEAST_ADDED, where a search must be short.
_FEW_OF_FAMILY = 2

# A family's solution within this factor of the minimum number of words ends the search.
_CLOSE = 1.1

# Cascades take seconds to search. They are tried only if every other solution takes this many times
# the words that are needed. For more than _MANY_DEMANDS at -O2, also only for levels (a frame has
# twice as many edges), and if it takes more than a word for this many shutters at each demand: a
# cascade rarely decides more with a word.
_WORTH_CASCADES = {2: 3.0, 3: 1.1}
_SHUTTERS_A_WORD = 4
_MANY_DEMANDS = 32
# At -O2, searches get steps in proportion to their demands: so many times the steps of a level for
# 64 demands, but never more, nor fewer than once.
_MOST_STEPS = 6
# They get all steps if every other solution takes this many times the words, and fewer if one is
# nearer.
_ALL_STEPS = 15.0

Kind = Literal["direct", "family", "equality", "cascade", "cover", "last"]

FROM_LEVEL: dict[Kind, int] = {
    "direct": 0,
    "family": 0,
    "equality": 0,
    "cascade": 2,
    "cover": 0,
    "last": 0,
}
"""The lowest optimisation level at which generators of each kind are tried.

* direct: one word per demand; nothing is cheaper, so no other kind is tried after a solution
* family: encodings with parameters (radices, polarities); below LEAST_ADDED only the first
  `_FEW_OF_FAMILY` solutions of a family are compared, from it on all
* equality: a few words per demand, for any number of shutters and slots
* cascade: arbitrary shutters, by search over several levels of gates
* cover: any predicates, at a cost that grows with them
* last: the most expensive solutions, tried if a second attempt of the covers found nothing either;
  nscc has none of its own"""


class Generator(Record):
    """A generator of solutions for one encoding.

    `solve(problem, machine, steps)` yields at least one solution, each with at most `steps` search
    steps, or raises GaveUp. `kind` determines when it is tried. `from_level` is the lowest
    optimisation level at which it is tried, None for its kind's default."""

    kind: Kind
    solve: Callable[[Problem, Machine, int], Iterable[Solution]]
    from_level: int | None = None

    @property
    def least_level(self) -> int:
        """The lowest optimisation level that uses this generator: its own `from_level`, or its
        kind's default. A generator is a method that finds gates."""
        return FROM_LEVEL[self.kind] if self.from_level is None else self.from_level


def _emitted(kind: Kind, encode: Callable[[Problem, Machine, Budget], Encoding]) -> Generator:
    """Return the generator (a method that finds gates) of a `kind` that chooses planes (contents of
    code registers) with `encode` and then emits their gates: one solution, or GaveUp from either.
    """

    def solve(problem: Problem, machine: Machine, steps: int) -> tuple[Solution]:
        """Return the one solution that follows from an encoding."""
        return (emit(problem, machine, encode(problem, machine, Budget(steps))),)

    return Generator(kind, solve)


GENERATORS: dict[str, Generator] = {
    "stored_predicates": _emitted("direct", encodings.stored_predicates),
    "one_hot": _emitted("direct", encodings.one_hot),
    "equalities": Generator("family", events.equalities),
    "composed": Generator("equality", composed.composed),
    "folded_times": _emitted("equality", folded_times.folded_times),
    "cascade": Generator("cascade", cascade.cascade),
    "covered_fields": _emitted("cover", encodings.covered_fields),
    "covered_levels": _emitted("cover", encodings.covered_levels),
    "covered_both_polarities": _emitted("cover", encodings.covered_both_polarities),
    "covered_gray_index": _emitted("cover", encodings.covered_gray_index),
}
"""nscc's generators, in the order in which those of one kind are tried.

Other distributions add generators as entry points of the group nscc.encodings. These follow nscc's
own, and are used from level LEAST_ADDED on, so that lower levels stay fast."""

LEAST_ADDED = 2
_GROUP: Group = "nscc.encodings"


def added_generators() -> dict[str, Generator]:
    """Return the generators (methods that find gates) that other distributions add, by name.

    Raises Rejected (NS0905) if one is not a Generator, has an unknown `kind`, a `solve` that cannot
    be called, or a `from_level` outside LEAST_ADDED..3, and for an invalid declaration."""
    generators: dict[str, Generator] = added(_GROUP, GENERATORS)
    for name, generator in generators.items():
        if not isinstance(generator, Generator):
            raise unusable(_GROUP, name, f"it is not a Generator, but {type(generator).__name__}")
        if generator.kind not in FROM_LEVEL:
            raise unusable(_GROUP, name, f"its kind is not one of {', '.join(FROM_LEVEL)}")
        if not callable(generator.solve):
            raise unusable(_GROUP, name, "its `solve` cannot be called")
        if generator.from_level is not None and generator.from_level not in range(LEAST_ADDED, 4):
            raise unusable(_GROUP, name, f"its `from_level` is not between {LEAST_ADDED} and 3")
    return generators


class GeneratorFault(Record):
    """An unexpected exception of a generator (a method that finds gates), or of the improvement of
    its solutions ("improve").

    `generator` is its name, `level` the optimisation level, `error` the exception's class and
    message in one line, and `traceback` the whole traceback as text."""

    generator: str
    level: int
    error: str
    traceback: str

    def diagnostic(self) -> Diagnostic:
        """Return the warning (NS0504) that an added generator raised an exception and was left out.
        The name is cut to 60 characters; the whole name and the traceback are in its data. A
        generator is a method that finds gates."""
        return Diagnostic(
            "NS0504",
            f"the gate generator {self.generator[:60]!a} failed at -O{self.level} and was "
            f"left out: {self.error}",
            severity=Severity.WARNING,
            notes=("the program was compiled with the other generators; its words are proved",),
            data={"generator": self.generator, "traceback": self.traceback},
        )


def note_fault(
    error: Exception, name: str, level: int, faults: list[GeneratorFault] | None
) -> None:
    """Add an exception of the generator `name`, at this optimisation level, to `faults`.

    The exception is raised again if `faults` is None, or if it is a diagnostic or a MemoryError.
    The message is cut to 200 characters. A generator is a method that finds gates."""
    if faults is None or isinstance(error, (Rejected, MemoryError)):
        raise error
    message = " ".join(f"{type(error).__name__}: {error}".split())[:200]
    faults.append(GeneratorFault(name, level, message, "".join(traceback.format_exception(error))))


def solutions(
    problem: Problem, machine: Machine, level: int, faults: list[GeneratorFault] | None = None
) -> Iterator[Solution]:
    """Yield solutions of a problem from different generators (methods that find gates); none if
    every generator gives up.

    `level` is the optimisation level, 0 to 3. Solutions are computed lazily, usually the cheapest
    first. The caller computes their costs, because these depend on the surrounding words. If a
    generator raises an unexpected exception, it is added to `faults` and the search continues;
    without `faults` it propagates, and diagnostics (Rejected) always do. A problem without demands
    (sets of shutters that FLAG must select at boundaries) has one solution, without planes and
    gates. If a generator of the kind "direct" succeeds, only the direct solution with the fewest
    planes is yielded."""
    if not problem.demands:
        yield Solution("no code is needed", (), (), 0, 0, (), (), ())
        return
    known = GENERATORS if level < LEAST_ADDED else {**GENERATORS, **added_generators()}
    steps = SEARCH_STEPS[level]

    def solve_kinds(*kinds: Kind, allowed: int = steps) -> Iterator[Solution]:
        """Yield the solutions of all generators (methods that find gates) of these kinds, each with
        at most `allowed` steps; faults are noted."""
        for kind in kinds:
            for name, generator in known.items():
                if generator.kind == kind and level >= generator.least_level:
                    found = _checked_solutions(name, generator, problem, machine, allowed)
                    few = kind == "family" and level < LEAST_ADDED
                    try:
                        yield from islice(found, _FEW_OF_FAMILY if few else None)
                    except Exception as error:
                        note_fault(error, name, level, faults)

    direct = list(solve_kinds("direct"))
    if direct:
        yield min(direct, key=lambda s: len(s.planes))
        return
    fewest = inf

    def counted(candidates: Iterable[Solution]) -> Iterator[Solution]:
        """Yield the solutions `candidates` unchanged, and record in `fewest` the words of the one
        with the fewest so far."""
        nonlocal fewest
        for solution in candidates:
            fewest = min(fewest, sum(gate.words for s in solution.segments() for gate in s))
            yield solution

    # A lower bound on the words of any solution: one word per demand, and two for each predicate
    # that cannot be stored.
    unanswered = [d.predicate for i, d in enumerate(problem.demands) if not problem.answered(i)]
    least = len(unanswered) + max(0, len(set(unanswered)) - machine.registers)
    yield from counted(solve_kinds("family"))
    close = fewest <= _CLOSE * least
    yield from counted(solve_kinds("equality"))
    # Covers are tried if nothing else worked, or if they may be better and are not too expensive.
    if fewest == inf or not (close or problem.shutters > MOST_COVERED):
        yield from counted(solve_kinds("cover"))
    count = len(problem.demands)
    # Shutters without structure: even the best solution takes more than a word for so many shutters
    # at each demand.
    random = fewest * _SHUTTERS_A_WORD > problem.shutters * count
    random &= all(demand.edge == "open" for demand in problem.demands)
    worth = fewest >= _WORTH_CASCADES.get(level, inf) * least
    if worth and (level > 2 or count <= _MANY_DEMANDS or random):
        share = min(1.0, fewest / (_ALL_STEPS * least))
        share *= max(1.0, _MOST_STEPS * min(1.0, count / 64)) if level == 2 else 1.0
        yield from counted(solve_kinds("cascade", allowed=int(share * steps)))
    if fewest == inf:
        yield from solve_kinds("cover", "last", allowed=PATIENT_STEPS)


def _checked_solutions(
    name: str, generator: Generator, problem: Problem, machine: Machine, steps: int
) -> Iterator[Solution]:
    """Yield the solutions of one generator (a method that finds gates) until it ends or gives up.

    `name` is the generator's name in the table; `steps` limits its search. Solutions of added
    generators are checked: raises Rejected (NS0905) for one that does not meet its demands (sets of
    shutters that FLAG must select at boundaries)."""
    built_in = name in GENERATORS
    try:
        for solution in generator.solve(problem, machine, steps):
            fault_text = None if built_in else solution_fault(problem, machine, solution)
            if fault_text is not None:
                raise unusable(
                    _GROUP, name, f"its solution does not meet its demands: {fault_text}"
                )
            yield solution
    except GaveUp:
        return


def solution_fault(problem: Problem, machine: Machine, solution: object) -> str | None:
    """Return why a `solution` of another package is invalid for `problem` and `machine`, in words;
    None if it is valid.

    Raises TypeError if a part of the solution is not hashable; other exceptions of malformed parts
    may also come through."""
    if not isinstance(solution, Solution):
        return f"it is not a Solution, but {type(solution).__name__}"
    hash(solution)  # raises an exception if a part is not hashable: solutions are used as keys
    if not all(isinstance(text, str) for text in (solution.encoding, *solution.holders)):
        return "its name or a holder is not text"
    return fault(problem, machine, solution)
