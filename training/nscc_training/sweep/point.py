"""Points of a grid, their kinds, and their results."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from nscc.toml.schema import Key

Values = Mapping[str, Any]
"""A point's values by key; keys without value and default are absent."""

OF_RUN = "run:"
"""Prefix of a value that names the run of another point of the grid."""

Figures = dict[str, Any]
"""Results by name: text, numbers, true, false or None."""


@dataclass(frozen=True)
class PointFault:
    """An invalid combination of values: the key, the reason, and the remedy."""

    key: str
    message: str
    help: str


@dataclass(frozen=True)
class Place:
    """Paths and resources of a point. Its files begin with the path `files`; it may use `threads`
    threads."""

    files: Path
    threads: int


@dataclass(frozen=True)
class PointKind:
    """A kind of point.

    Attributes
    ----------
    name, summary : str
    takes : callable
        Returns the keys of a part of a grid.
    compute : callable
        Returns the figures of a point; raises Rejected with the reason if it has none.
    drawn : tuple of str
        Figures for diagrams: the first one that a table has is drawn by default.
    reads : callable
        Returns the files and folders whose content the result depends on.
    fault : callable
        Returns the fault of a combination of values, given the keys that the grid names.
    packages, distributions : tuple of str
        Packages of nscc and other distributions that compute the point.
    leaves : str or None
        The ending of the file or folder that a point writes at `Place.files`.
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
    """One combination of a part's values. `name` is unique in the grid. `after` are the points
    whose runs the values name: `run:NAME` stands for the folder of a run."""

    grid_part: str
    kind: str
    name: str
    values: Values = field(hash=False)
    after: tuple[GridPoint, ...] = ()


@dataclass(frozen=True)
class PointRow:
    """The result of a point: `figures`, or `code` and text of the message instead of them."""

    key: str
    figures: Figures = field(default_factory=dict, hash=False)
    code: str = ""
    error: str = ""
