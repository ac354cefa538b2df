"""A point of a grid, what kinds there are of them, and what comes of one."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from nscc.toml.schema import Key

Values = Mapping[str, Any]
"""A point's values by the names of its kind's keys; what has no value and no default is absent."""

OF_RUN = "run:"
"""Begins a value that names the run of another point of the grid."""

Figures = dict[str, Any]
"""What was found, by names: text, numbers, true, false or None."""


@dataclass(frozen=True)
class PointFault:
    """What is wrong with values that are right one by one: at which key, why, what to do."""

    key: str
    message: str
    help: str


@dataclass(frozen=True)
class Place:
    """Where a point is computed: files that it leaves begin with the path `files`.

    `threads` are what it may use.
    """

    files: Path
    threads: int


@dataclass(frozen=True)
class PointKind:
    """What a point can be.

    `takes()` are the keys of a part of a grid, in no section. `fault` looks at one point's values
    together, and at which of their keys the grid names. `reads` names the files and folders whose
    content decides the result; `packages` and `distributions` compute it. `compute` gives the
    figures; Rejected says why there are none. Of the figures `drawn` a table's first is, unless a
    grid asks for others. `leaves` is the ending of what a point leaves in `Place.files`, None where
    that is nothing.
    """

    name: str
    summary: str
    takes: Callable[[], tuple[Key, ...]]
    compute: Callable[[Values, Place], Figures]
    drawn: tuple[str, ...]
    reads: Callable[[Values], Sequence[Path]]
    fault: Callable[[Values, Collection[str]], PointFault | None] = lambda _values, _named: None
    packages: tuple[str, ...] = ("nscc",)
    distributions: tuple[str, ...] = ("lark", "networkx")
    leaves: str | None = None


@dataclass(frozen=True)
class GridPoint:
    """One combination of a part's values.

    `name` tells it apart from the others of its grid. `after` are the points whose runs its values
    name: `run:NAME` stands for a run's folder.
    """

    grid_part: str
    kind: str
    name: str
    values: Values = field(hash=False)
    after: tuple[GridPoint, ...] = ()


@dataclass(frozen=True)
class PointRow:
    """What came of a point: `figures`, or the `code` and text of the message that says why not."""

    key: str
    figures: Figures = field(default_factory=dict, hash=False)
    code: str = ""
    error: str = ""
