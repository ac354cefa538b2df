"""Cached results of the search for gates.

The key covers the whole problem (demands, plan, times, target, level) and the compiler with its
added generators (`nscc.cache.digest.version_digest`). A change of any of them changes the key."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from nscc.cache.digest import digest, version_digest
from nscc.cache.folder import cache_folder
from nscc.cache.store import Store
from nscc.codec import from_json, to_json
from nscc.logic.generate import solution_fault
from nscc.logic.problem import Machine, Problem, Solution

LEAST_LEVEL = 2
"""Lowest level whose results are cached; below it, a search is faster than reading its result."""


@dataclass
class Results:
    """The solutions of gate searches of one compilation, in a folder that outlives it.

    Results are read from `store` only while `trusted` is true, but always written to it. `read`
    counts the solutions that came from the store."""

    store: Store
    trusted: bool = field(default=True, init=False)
    read: int = field(default=0, init=False)

    def distrust(self) -> None:
        """Stop reading from the store: from now on every search runs, and its result replaces the
        stored one."""
        self.trusted, self.read = False, 0

    def entry(self, key: str) -> bytes | None:
        """Return the bytes stored under a key of `find`; None if there are none or the store is not
        trusted."""
        return self.store.read(key) if self.trusted else None

    def find(
        self, problem: Problem, machine: Machine, level: int, *context: Any
    ) -> tuple[str, Solution | None]:
        """Return the key of a problem's solution, and the solution; None if it is not stored, is
        damaged or does not solve the problem.

        `problem` lists what the gates must compute, `level` is that of `-O`, and `context` contains
        everything else that affects the best solution. The key is "" for levels below `LEAST_LEVEL`
        and if the sources cannot be read: such results are not cached."""
        version = version_digest() if level >= LEAST_LEVEL else None
        if version is None:
            return "", None
        key = digest((version, problem, machine, level, context))
        known = _solution(self.entry(key), problem, machine)
        self.read += known is not None
        return key, known

    def keep(self, key: str, best: Solution) -> None:
        """Store the best solution of a search under the key that `find` returned; do nothing if it
        is ""."""
        if key:
            self.store.write(key, to_json(best).encode())


def results_of_user() -> Results | None:
    """Return the cached search results in the user's cache folder; None if the cache is off or not
    safe."""
    folder = cache_folder()
    return None if folder is None else Results(Store(folder))


def _solution(data: bytes | None, problem: Problem, machine: Machine) -> Solution | None:
    """Return the solution that the bytes of a cache entry encode.

    Return None if the entry is missing or damaged, or if the solution does not solve the problem
    with the registers of this machine."""
    if data is None:
        return None
    try:
        solution = from_json(Solution, data)
        is_valid = solution_fault(problem, machine, solution) is None
    except (ValueError, LookupError):
        return None
    return solution if is_valid else None
