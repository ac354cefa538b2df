"""Points of a grid, their kinds, and their results."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import MISSING, dataclass, field
from pathlib import Path
from typing import Any, NamedTuple

from nscc.mappings import NamedValues
from nscc.toml.schema import Key
from nscc_training.experiments.engine import Figures

Values = Mapping[str, Any]
"""A point's values by key; keys with neither value nor default are absent."""

OF_RUN = "run:"
"""Prefix of a value that names the run of another point."""


class PointFault(NamedTuple):
    """An invalid combination of values: the `key` to change ("" for none in particular), the reason
    (`message`), and what to do (`help`)."""

    key: str
    message: str
    help: str


@dataclass(frozen=True)
class PointKind:
    """A kind of point.

    Attributes
    ----------
    name, summary : str
    takes : callable
        Returns the keys of a part of a grid.
    compute : callable
        Returns the results of a point, given its values and its task; raises Rejected with the
        reason if it has none.
    drawn : tuple of str
        Results for diagrams; the first of them in the table is drawn by default.
    reads : callable
        Returns the files and folders whose content the result depends on.
    fault : callable
        Returns the error in a combination of values, given the keys that the grid names.
    packages, distributions : tuple of str
        Packages of nscc and other distributions that compute the point.
    leaves : str or None
        The ending of the file or folder that a point writes at `PointTask.files`.
    folder : str
        The folder with named links to these files or folders.
    """

    name: str
    summary: str
    takes: Callable[[], tuple[Key, ...]]
    compute: Callable[[Values, PointTask], Figures]
    drawn: tuple[str, ...]
    reads: Callable[[Values], Sequence[Path]]
    fault: Callable[[Values, Collection[str]], PointFault | None] = lambda _values, _named: None
    packages: tuple[str, ...] = ("nscc",)
    distributions: tuple[str, ...] = ("lark", "networkx")
    leaves: str | None = None
    folder: str = ""

    def defaults(self) -> NamedValues:
        """Return the values of the keys that have a default."""
        return {k.name: k.default[0] for k in self.takes() if k.default is not MISSING}


@dataclass(frozen=True)
class GridPoint:
    """A point of a grid: one combination of a part's values, whose result is one row of the table.

    `grid_part` names the part, `kind` what is computed, and `name` is unique in the grid. `after`
    are the points whose runs the values name; `run:NAME` is replaced by the run's folder."""

    grid_part: str
    kind: str
    name: str
    values: Values = field(hash=False)
    after: tuple[GridPoint, ...] = ()


@dataclass(frozen=True)
class PointTask:
    """A point to compute.

    Its paths are relative to `folder`. It writes into the file or folder `files`. `runs` are the
    folders of the runs that its values name, by `run:NAME`. `key` is the digest under which its
    result is stored, and `threads` the number of threads to use."""

    point: GridPoint
    key: str
    folder: Path
    files: Path
    threads: int
    runs: Mapping[str, Path | None] = field(default_factory=dict)

    @property
    def label(self) -> str:
        """The name of the point."""
        return self.point.name
