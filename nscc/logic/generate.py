"""The generators of encodings: what each serves, in which order, and at which level of effort."""

from __future__ import annotations

import traceback
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from math import inf
from typing import Literal

from nscc.diagnostics.diagnostic import Diagnostic, Rejected, Severity
from nscc.logic import (
    encodings,
    events,
    halved_bumps,
    nested,
    paired_bumps,
    states,
    windows,
)
from nscc.logic.cascade import cascade
from nscc.logic.cubes import Budget, Encoding, emit
from nscc.logic.problem import GaveUp, Machine, Problem, Solution
from nscc.logic.replay import fault
from nscc.plugins import Group, added, unusable

# Search steps of one generator at each level; a step is one cofactor of a truth vector
# of up to 512 shutters.
SEARCH_STEPS = {0: 50_000, 1: 400_000, 2: 500_000, 3: 4_000_000}

# Where all of them gave up, they are tried again with this many: seconds instead of none at all.
PATIENT_STEPS = 4_000_000

# Covers of more shutters than this are tried only where nothing else works: they would not win.
MOST_COVERED = 512

# A family's member of at most so many times the words that every solution needs ends the search.
_CLOSE = 1.1

# Cascades take seconds to search. They are tried where every other solution takes so many times the
# words that are needed, and at -O2 for no more demands than these: they would not win.
_WORTH_CASCADES = {2: 3.0, 3: 1.1}
_MOST_CASCADED = {2: 32, 3: 1 << 20}
# They get all steps where every other solution takes so many times the words, fewer where one is
# nearer.
_ALL_STEPS = 15.0

Kind = Literal["direct", "family", "equality", "cascade", "cover", "last"]

FROM_LEVEL: dict[Kind, int] = {
    "direct": 0, "family": 2, "equality": 0, "cascade": 2, "cover": 0, "last": 0
}  # fmt: skip
"""The level of effort from which on generators of a kind are tried.

direct    One word a demand: nothing can be cheaper, so nothing else is tried after one of these.
family    One with parameters (radices, polarities), all of whose members are worth a price.
equality  A few words a demand, at any number of shutters and slots.
cascade   Arbitrary shutters, by search over several levels of gates.
cover     Any predicates at all, at a price that grows with them.
last      The dearest: every shutter of every predicate by itself. Few kernels serve all of them.
"""


@dataclass(frozen=True)
class Generator:
    """An encoding: which predicate sets it serves, as a kind, and how it is made.

    `solve` (problem, machine, steps) gives its solutions, at least one, with no more search steps
    than that each, and raises GaveUp where it does not serve the problem. `from_level` is the level
    of effort from which on it is tried, None for its kind's.
    """

    kind: Kind
    solve: Callable[[Problem, Machine, int], Iterable[Solution]]
    from_level: int | None = None


def _one(kind: Kind, solve: Callable[[Problem, Machine, Budget], Solution]) -> Generator:
    def solved(problem: Problem, machine: Machine, steps: int) -> tuple[Solution]:
        return (solve(problem, machine, Budget(steps)),)

    return Generator(kind, solved)


def _emitted(kind: Kind, encode: Callable[[Problem, Machine, Budget], Encoding]) -> Generator:
    return _one(kind, lambda problem, machine, budget: emit(
        problem, machine, encode(problem, machine, budget)
    ))  # fmt: skip


GENERATORS: dict[str, Generator] = {
    "stored_predicates": _emitted("direct", encodings.stored_predicates),
    "one_hot": _emitted("direct", encodings.one_hot),
    "digits": Generator("family", nested.digits),
    "counted": Generator("family", nested.counted),
    "windows": Generator("family", windows.windows),
    "toggled_windows": Generator("family", windows.toggled_windows),
    "paired_bumps": Generator("family", paired_bumps.paired_bumps, from_level=1),
    "halved_bumps": Generator("family", halved_bumps.halved_bumps, from_level=1),
    "equalities": Generator("family", events.equalities),
    "gray_times": _emitted("equality", encodings.gray_times),
    "gray_index": _emitted("equality", encodings.gray_index),
    "state_register": _one("equality", states.state_register),
    "state_in_flag": _one("equality", states.state_in_flag),
    "cascade": _one("cascade", cascade),
    "covered_fields": _emitted("cover", encodings.covered_fields),
    "covered_levels": _emitted("cover", encodings.covered_levels),
    "covered_both_polarities": _emitted("cover", encodings.covered_both_polarities),
    "covered_gray_index": _emitted("cover", encodings.covered_gray_index),
    "gray_index_wide": _emitted("last", encodings.gray_index_wide),
}
"""All of nscc's own, in the order in which those of one kind are tried.

Other distributions add theirs, each a Generator, as entry points of the group nscc.encodings. They
follow, and are asked from LEAST_ADDED on: below it nobody waits for other people's code.
"""

LEAST_ADDED = 2
_GROUP: Group = "nscc.encodings"


def added_generators() -> dict[str, Generator]:
    """The generators that other distributions add, each whole.

    Raises Rejected (NS0905) for one that is none, or whose declaration is not as it must be.
    """
    found: dict[str, Generator] = added(_GROUP, GENERATORS)
    for name, each in found.items():
        if not isinstance(each, Generator):
            raise unusable(_GROUP, name, f"it is no Generator but {type(each).__name__}")
        if each.kind not in FROM_LEVEL:
            raise unusable(_GROUP, name, f"its kind is none of {', '.join(FROM_LEVEL)}")
        if not callable(each.solve):
            raise unusable(_GROUP, name, "its `solve` cannot be called")
        if each.from_level is not None and each.from_level not in range(LEAST_ADDED, 4):
            raise unusable(_GROUP, name, f"its `from_level` is none of {LEAST_ADDED} to 3")
    return found


@dataclass(frozen=True)
class GeneratorFault:
    """An exception of a generator, which its author did not expect."""

    generator: str
    level: int
    error: str
    traceback: str

    def diagnostic(self) -> Diagnostic:
        """NS0504, with the traceback in its data."""
        return Diagnostic(
            "NS0504",
            f"the generator {self.generator[:60]!a} of gates failed at -O{self.level} and was left "
            f"out: {self.error}",
            severity=Severity.WARNING,
            notes=("the program was compiled with the other generators; its words are proved",),
            data={"generator": self.generator, "traceback": self.traceback},
        )


def note_fault(
    error: Exception, name: str, level: int, faults: list[GeneratorFault] | None
) -> None:
    """Adds an exception of `name` to `faults`; raises it again where nobody lists faults, and
    where it is a diagnostic or a lack of memory."""
    if faults is None or isinstance(error, (Rejected, MemoryError)):
        raise error
    said = " ".join(f"{type(error).__name__}: {error}".split())[:200]
    faults.append(GeneratorFault(name, level, said, "".join(traceback.format_exception(error))))


def solutions(
    problem: Problem, machine: Machine, level: int, faults: list[GeneratorFault] | None = None
) -> Iterator[Solution]:
    """Solutions of a problem, each from another generator; none where every one gives up.

    They are made as they are asked for, those first that tend to be cheapest. The caller prices
    them: what a solution costs depends on the words around it. A generator that raises an
    unexpected exception is left out, and `faults` gets the exception; without `faults`, it is
    raised.
    """
    if not problem.demands:
        yield Solution("no code is needed", (), (), 0, 0, (), (), ())
        return
    generators = _asked(level)
    steps = SEARCH_STEPS[level]

    def made(*kinds: Kind, allowed: int = steps) -> Iterator[Solution]:
        """Solutions of generators of these kinds."""
        for kind in kinds:
            for name, each in generators.items():
                if each.kind == kind:
                    try:
                        yield from _tried(name, each, problem, machine, allowed)
                    except Exception as error:
                        note_fault(error, name, level, faults)

    direct = list(made("direct"))
    if direct:
        yield min(direct, key=lambda s: len(s.planes))
        return
    fewest = inf

    def counted(found: Iterable[Solution]) -> Iterator[Solution]:
        """Solutions, the words of the best one noted."""
        nonlocal fewest
        for solution in found:
            fewest = min(fewest, sum(gate.words for s in solution.segments() for gate in s))
            yield solution

    least = _fewest_words(problem, machine)
    yield from counted(made("family"))
    close = fewest <= _CLOSE * least
    yield from counted(made("equality"))
    if fewest == inf or not (close or problem.shutters > MOST_COVERED):
        yield from counted(made("cover"))
    worth = fewest >= _WORTH_CASCADES.get(level, inf) * least
    if worth and len(problem.demands) <= _MOST_CASCADED.get(level, 0):
        share = min(1.0, fewest / (_ALL_STEPS * least))
        yield from counted(made("cascade", allowed=int(share * steps)))
    if fewest == inf:
        yield from made("cover", "last", allowed=PATIENT_STEPS)


def _asked(level: int) -> dict[str, Generator]:
    """The generators, by name, that are worth trying at a level of effort."""
    known = GENERATORS if level < LEAST_ADDED else {**GENERATORS, **added_generators()}
    return {
        name: each
        for name, each in known.items()
        if level >= (FROM_LEVEL[each.kind] if each.from_level is None else each.from_level)
    }


def _fewest_words(problem: Problem, machine: Machine) -> int:
    """Words that every solution needs: one a demand, two for what cannot be stored as well."""
    asked = [d.predicate for i, d in enumerate(problem.demands) if not problem.answered(i)]
    return len(asked) + max(0, len(set(asked)) - machine.registers)


def _tried(
    name: str, generator: Generator, problem: Problem, machine: Machine, steps: int
) -> Iterator[Solution]:
    """A generator's solutions, until it gives up. Raises NS0905 where one from outside is wrong."""
    own = name in GENERATORS
    try:
        for solution in generator.solve(problem, machine, steps):
            wrong = None if own else _wrong(problem, machine, solution)
            if wrong is not None:
                raise unusable(_GROUP, name, f"its solution does not meet its demands: {wrong}")
            yield solution
    except GaveUp:
        return


def _wrong(problem: Problem, machine: Machine, solution: object) -> str | None:
    """What is wrong with a solution of somebody else's."""
    if not isinstance(solution, Solution):
        return f"it is no Solution but {type(solution).__name__}"
    hash(solution)  # raises where anything in it is not frozen: solutions are keys
    if not all(isinstance(text, str) for text in (solution.encoding, *solution.holders)):
        return "its name or a holder is no text"
    return fault(problem, machine, solution)
