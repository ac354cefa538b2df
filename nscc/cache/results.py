"""Cached results of the search for gates.

The key covers the whole problem: demands, plan, times, target, level, and the compiler itself with
its added generators (`nscc.cache.digest.version_digest`). A change of any of them changes the key.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any

from nscc.cache.digest import digest, version_digest
from nscc.cache.store import Store, cache_folder
from nscc.cache.values import from_json, to_json
from nscc.logic.problem import Machine, Problem, Solution
from nscc.logic.replay import fault

LEAST_LEVEL = 2
"""Below this level a search is faster than reading its result."""


@dataclass
class Results:
    """Search results of one compilation, read from the store while `trusted` and written to it.
    `read` counts the results that came from the store."""

    store: Store
    trusted: bool = field(default=True, init=False)
    read: int = field(default=0, init=False)

    def distrust(self) -> None:
        """Stop reading: from now on every search runs and its result replaces the stored one."""
        self.trusted, self.read = False, 0

    def find(self, problem: Problem, machine: Machine, level: int, *context: Any) -> Result:
        """Look up the solution of a problem; `context` is everything else that the best solution
        depends on."""
        version = version_digest() if level >= LEAST_LEVEL else None
        if version is None:
            return Result()
        key = digest((version, problem, machine, level, context))
        known = _solution(self.store.read(key), problem, machine) if self.trusted else None
        self.read += known is not None
        return Result(known, self.store, key)


@dataclass(frozen=True)
class Result:
    """The best solution of a problem if it is known, else the key under which to store it."""

    known: Solution | None = None
    store: Store | None = None
    key: str = ""

    def or_else(self, solutions: Iterable[Solution]) -> Iterable[Solution]:
        """The known solution alone, or else `solutions`, which are only generated in this case."""
        return solutions if self.known is None else (self.known,)

    def keep(self, best: Solution) -> None:
        """Store the best solution of a search."""
        if self.store is not None and self.known is None:
            self.store.write(self.key, to_json(best))


def results_of_user() -> Results | None:
    """The results in the user's cache folder; None if the cache is off."""
    folder = cache_folder()
    return None if folder is None else Results(Store(folder))


def _solution(data: bytes | None, problem: Problem, machine: Machine) -> Solution | None:
    """Decode the solution in an entry; None unless it solves the problem."""
    if data is None:
        return None
    try:
        solution = from_json(Solution, data)
    except ValueError:
        return None
    return solution if fault(problem, machine, solution) is None else None
