"""Grids: TOML files in which lists are axes.

    kind = "compile"

    [classes]
    class = ["b", "d"]
    slots = [8, 16]

Every table is a part of the grid. The points of a part are all combinations of its keys' values. A
part may have its own `kind`. The table `[plot]` describes the diagram."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import MISSING, dataclass, replace
from itertools import product
from math import prod
from pathlib import Path
from typing import Any, NamedTuple

from nscc.diagnostics.diagnostic import Diagnostic, Rejected, rejected
from nscc.diagnostics.suggest import meant
from nscc.mappings import NamedValues
from nscc.source import Source
from nscc.toml.kinds import Axis, Several, TextKind
from nscc.toml.schema import FileCodes, Key, Schema, file_bytes, file_table, file_text, key, keys_of
from nscc_training.sweep.evaluating import RUN
from nscc_training.sweep.kinds import KINDS
from nscc_training.sweep.point import OF_RUN, GridPoint, PointFault, Values

MOST_POINTS = 100_000
"""Most points of a grid."""

_CODES = FileCodes("NS0830", "NS0830", unknown="NS0831", wrong_value="NS0832", missing="NS0832")
_START = "`nscc sweep --schema KIND` prints a complete part to start from"
_KIND = Key(
    "",
    "kind",
    TextKind(tuple(KINDS)),
    "; ".join(f"{k.name}: {k.summary}" for k in KINDS.values()),
    "",
)
_NAME, _NAME_SAID = r"[A-Za-z0-9_-]{1,60}", "take letters, digits, `-` and `_`"
_VALUE = re.compile(r"\{([^{}]+)\}")
_PLOT = "plot"
_CALLED = Key(
    "",
    "name",
    TextKind(
        pattern=r"(?!(.*/)?\.{0,2}(/|$))([A-Za-z0-9_.+/-]|\{[^{}]+\})+",
        phrase='a name, in which "{KEY}" stands for a value',
    ),
    "the names of its points, instead of the part's name and the values of the axes",
    "",
)
_LIKE = Key("", "like", TextKind(), "an earlier part, whose keys this part copies", "")
_OF_PART = (_KIND.name, _CALLED.name, _LIKE.name)
"""Keys of every part that are not axes."""


@dataclass(frozen=True)
class Plot:
    """How the diagram of a grid is drawn: the table `[plot]` of the grid's file. `x` and the others
    are names of columns of the table. A value that is empty is replaced by a suitable default."""

    x: str = key(TextKind(), "the horizontal axis; by default the first numeric axis", "")
    y: tuple[str, ...] = key(
        Several(TextKind(), text="a list of results"), "the results on the vertical axis", ()
    )
    line: tuple[str, ...] = key(
        Several(TextKind(), text="a list of axes"), "the axes with one line per value", ()
    )
    panel: str = key(TextKind(), "the axis with one panel per value", "")


_PLOT_KEYS = keys_of(Plot, _PLOT)


class Grid(NamedTuple):
    """A grid that has been read.

    `name` and `folder` are those of its file, and `text` is its content. `points` are in the order
    of the file, each with the points that it needs as `after`. `columns` are the keys that occur in
    it, `axes` those with several values in a part. `plot` describes its diagram."""

    name: str
    folder: Path
    points: tuple[GridPoint, ...]
    columns: tuple[str, ...]
    axes: tuple[str, ...]
    plot: Plot
    text: str


def read_grid(path: Path) -> Grid:
    """Read a grid from a file, and check all its points.

    Raises Rejected (status 2) with all errors at once: NS0830 for a file that cannot be read or is
    not TOML, NS0831 for unknown keys, NS0832 for invalid values."""
    head = _schema({})
    tables, source = file_table(head, file_bytes(head, path), str(path))
    grid_parts: dict[str, NamedValues] = {}
    unknown_parts = []
    for name, value in tables.items():
        if not (isinstance(value, Mapping) and name != _PLOT):
            continue
        # A part may take the keys of an earlier part and change some of them.
        part_keys = _flat(value)
        like = part_keys.get(_LIKE.name)
        if like is not None and like not in grid_parts:
            message = f"[{name}]: there is no part {str(like)[:60]!a} above it"
            unknown_parts.append(_problem(message, name, _LIKE.name, source, _START))
        grid_parts[name] = {**grid_parts.get(str(like), {}), **part_keys}
    if unknown_parts:
        raise Rejected(unknown_parts, status=2)
    kinds = _kinds(tables.get(_KIND.name), grid_parts, source)
    schema = _schema(kinds)
    values, problems = schema.read({**tables, **grid_parts}, source)
    if not (grid_parts or problems):
        message = "a grid needs a table for each of its parts, but it has none"
        problems.append(schema.problem(_CODES.missing, message, "", "", source, _START))
    if problems:
        raise Rejected(problems, status=2)
    axes_by_part = {
        grid_part: {name: values[f"{grid_part}.{name}"] for name in keys if name not in _OF_PART}
        for grid_part, keys in grid_parts.items()
    }
    called = {grid_part: values.get(f"{grid_part}.{_CALLED.name}", "") for grid_part in grid_parts}
    points = _points(axes_by_part, kinds, called, source)
    columns = tuple(dict.fromkeys(name for keys in axes_by_part.values() for name in keys))
    axes = tuple(
        n for n in columns if any(len(keys.get(n, ())) > 1 for keys in axes_by_part.values())
    )
    plot = Plot(**{key.name: values[key.path] for key in _PLOT_KEYS if key.path in values})
    return Grid(path.stem, path.parent, points, columns, axes, plot, source.text)


def of_parts(grid: Grid, grid_parts: Sequence[str]) -> Grid:
    """Return the grid with only the points of the parts named in `grid_parts`, and the runs that
    they need; all points if none is named. A run stands before the points that need it.

    Raises Rejected (NS0832) for an unknown part."""
    known_parts = tuple(dict.fromkeys(point.grid_part for point in grid.points))
    for grid_part in grid_parts:
        if grid_part not in known_parts:
            hint = meant(grid_part, known_parts, f"the parts are {', '.join(known_parts)}")
            raise rejected("NS0832", f"unknown part '{grid_part[:60]}' of the grid", helps=hint)
    points: dict[GridPoint, None] = {}

    def take(point: GridPoint) -> None:
        """Add a point to `points`, after the runs that it needs."""
        for run in point.after:
            take(run)
        points[point] = None

    for point in grid.points:
        if not grid_parts or point.grid_part in grid_parts:
            take(point)
    return grid._replace(points=tuple(points))


def part_text(kind: str) -> str:
    """Return an example of a part of a grid, with points of this `kind`. Every key has its default;
    keys without one are listed in comments. Raises KeyError for an unknown kind."""
    keys = [replace(key, section=kind, heading=kind) for key in KINDS[kind].takes()]
    known = [key for key in keys if key.default is not MISSING]
    schema = Schema("grid", (replace(_KIND, default=kind), *known), {"": "", kind: ""}, _CODES, "")

    def remark(key: Key) -> str:
        """Return the comment on a key: its meaning and its allowed values; "" for a key that is not
        an axis."""
        axis = key.kind
        return f"{key.meaning} ({axis.element.allowed})" if isinstance(axis, Axis) else ""

    head = (
        f"A part of a grid for `nscc sweep`, of kind {kind}: {KINDS[kind].summary}.",
        "Every key has its default here. A list of values creates one point for each, in every",
        "combination with those of the other keys. Keys without a default:",
        *(f"  {key.name}: {remark(key)}" for key in keys if key.default is MISSING),
    )

    text = file_text(schema, {key.path: key.default for key in schema.keys}, remark, head)
    return text if known else f"{text}\n[{kind}]\n"


def _flat(table: Mapping[str, Any], begin: str = "") -> NamedValues:
    """Return a nested table with dotted keys, such as `sensor.adc_noise_lsb`. `begin` is put in
    front of each key. An empty table stays a value."""
    flat_keys: NamedValues = {}
    for name, value in table.items():
        if isinstance(value, Mapping) and value:
            flat_keys |= _flat(value, f"{begin}{name}.")
        else:
            flat_keys[f"{begin}{name}"] = value
    return flat_keys


def _problem(message: str, grid_part: str, key: str, source: Source, help_text: str) -> Diagnostic:
    """Return the error NS0832 with this `message`, at a `key` of a part in the text `source`.
    `help_text` says what to do."""
    return _schema({}).problem(_CODES.wrong_value, message, grid_part, key, source, help_text)


def _kinds(
    common: Any, grid_parts: Mapping[str, Mapping[str, Any]], source: Source
) -> dict[str, str]:
    """Return the kind of each part's points: its own, or `common`, the one that stands above all
    parts (None if there is none).

    Raises Rejected (NS0832) with all parts that lack a kind or have an invalid name."""
    problems: list[Diagnostic] = []
    kinds = {}
    for grid_part, keys in grid_parts.items():
        kind = keys.get(_KIND.name, common)
        if not re.fullmatch(_NAME, grid_part):
            message = f"a part cannot be called {grid_part[:60]!a}: files are named after it"
            problems.append(_problem(message, grid_part, "", source, _NAME_SAID))
            continue
        if isinstance(kind, str) and kind in KINDS:
            kinds[grid_part] = kind
            continue
        section = grid_part if _KIND.name in keys else ""
        fault_text = "is missing" if kind is None else f"is not {str(kind)[:60]!a}"
        message = f"the kind of [{grid_part}] {fault_text}: it must be {_KIND.kind.allowed}"
        help_text = 'write kind = "compile" above all parts, or in this one'
        problems.append(_problem(message, section, _KIND.name, source, help_text))
    if problems:
        raise Rejected(problems, status=2)
    return kinds


def _schema(kinds: Mapping[str, str]) -> Schema[Key]:
    """Return the keys that a grid may have whose parts have these kinds (part to kind)."""
    keys = [
        replace(key, section=grid_part, heading=grid_part)
        for grid_part, kind in kinds.items()
        for key in (_KIND, _CALLED, _LIKE, *KINDS[kind].takes())
    ]
    headings = dict.fromkeys(("", _PLOT, *kinds), "")
    return Schema("grid", (_KIND, *_PLOT_KEYS, *keys), headings, _CODES, _START)


def _points(
    axes_by_part: Mapping[str, Mapping[str, tuple[Any, ...]]],
    kinds: Mapping[str, str],
    called: Mapping[str, str],
    source: Source,
) -> tuple[GridPoint, ...]:
    """Return the points of all parts, with training runs before the points that need them.

    `axes_by_part` are the values of each part's keys. `called` are the templates for names of
    points, by part ("" for none). Raises Rejected (NS0832) for too many points, and with all errors
    of invalid points."""
    count = sum(prod(map(len, keys.values())) for keys in axes_by_part.values())
    if count > MOST_POINTS:
        message = f"the grid has {count} points, but at most {MOST_POINTS} are allowed"
        raise Rejected(_problem(message, "", "", source, "split it into several files"), status=2)
    problems: dict[tuple[str, str, str], Diagnostic] = {}
    points_by_part: dict[str, list[GridPoint]] = {}
    # Parts that evaluate runs come last, because they need the points of those runs.
    for grid_part in sorted(axes_by_part, key=lambda grid_part: RUN in axes_by_part[grid_part]):
        axes, name = axes_by_part[grid_part], called[grid_part]
        points_by_part[grid_part] = []
        for point in _of_part(grid_part, kinds[grid_part], axes, name):
            fault = KINDS[point.kind].fault(point.values, axes) or _name_fault(name, point)
            if fault is not None:
                message = f"[{grid_part}]: {fault.message}"
                problem = _problem(message, grid_part, fault.key, source, fault.help)
                problems.setdefault((grid_part, fault.key, message), problem)
                continue
            if RUN not in point.values:
                points_by_part[grid_part].append(point)
                continue
            runs = points_by_part.get(point.values[RUN], [])
            if not runs or runs[0].kind != "train":
                message = f"[{grid_part}]: unknown part [{point.values[RUN][:60]}] of kind train"
                trains = [train for train, kind in kinds.items() if kind == "train"]
                help_text = f"such parts are {', '.join(trains)}" if trains else "add such a part"
                problem = _problem(message, grid_part, RUN, source, help_text)
                problems[grid_part, RUN, message] = problem
            points_by_part[grid_part] += (_about(point, run, axes, name) for run in runs)
    if problems:
        raise Rejected([*problems.values()], status=2)
    points = [point for grid_part in axes_by_part for point in points_by_part[grid_part]]
    return _linked(points, source)


def _linked(points: Sequence[GridPoint], source: Source) -> tuple[GridPoint, ...]:
    """Return the points, each with the points whose runs its values name (`run:NAME`) as `after`.

    Raises Rejected (NS0832) unless exactly one point of kind train has the name, and for a run that
    depends on itself."""
    # A value `run:NAME` is a link to the point that trains this run.
    trained = [point for point in points if point.kind == "train"]
    runs = {point.name: point for point in trained}
    count = Counter(point.name for point in trained)
    linked: dict[int, GridPoint] = {}

    def problem(point: GridPoint, message: str, key: str) -> Rejected:
        """Return the error with this `message` for the value of `key` in a point, which names a run
        that is not possible."""
        help_text = "write the name of a point of kind train, as its `name` defines it"
        return Rejected(_problem(message, point.grid_part, key, source, help_text), status=2)

    def link(point: GridPoint, above: tuple[str, ...] = ()) -> GridPoint:
        """Return the point with the points of the runs that it names, each of which is linked, too.

        `above` are the names of the runs that need this point. Raises Rejected for an unknown name,
        and for a run that depends on itself."""
        if id(point) in linked:
            return linked[id(point)]
        after = list(point.after)
        for run_key, value in point.values.items():
            if not (isinstance(value, str) and value.startswith(OF_RUN)):
                continue
            name = value.removeprefix(OF_RUN)
            if count[name] != 1:
                run_count = f"{count[name] or 'no'} run{'s' if count[name] else ''}"
                message = f"[{point.grid_part}]: {run_count} called '{name[:80]}'"
                raise problem(point, message, run_key)
            circle = (*above, point.name) if point.kind == "train" else above
            if name in circle:
                message = f"[{point.grid_part}]: run '{name[:80]}' depends on itself"
                raise problem(point, message, run_key)
            after.append(link(runs[name], circle))
        linked[id(point)] = replace(point, after=tuple(after))
        return linked[id(point)]

    return tuple(link(point) for point in points)


def _of_part(
    grid_part: str, kind: str, axes: Mapping[str, tuple[Any, ...]], called: str
) -> Iterator[GridPoint]:
    """Yield the points of a part: every combination of its keys' values. The first key varies
    slowest. A part without keys has one point.

    `axes` are the values of the keys. `called` is the template for the points' names; "" names them
    after the part and the values of keys with several values. A value `run:NAME` is a template,
    too, so that a point names the run of its own seed."""
    defaults = KINDS[kind].defaults()
    several = [name for name, values in axes.items() if len(values) > 1]
    for values in product(*axes.values()):
        chosen = {**defaults, **dict(zip(axes, values, strict=True))}
        for axis, value in chosen.items():
            if isinstance(value, str) and value.startswith(OF_RUN):
                chosen[axis] = _called(value, chosen)
        name = "_".join([grid_part, *(_spelled(chosen[axis]) for axis in several)])
        yield GridPoint(grid_part, kind, _called(called, chosen) or name, chosen)


def _called(called: str, values: Values) -> str:
    """Return the name of a point: the template `called`, in which its values replace `{KEY}`. A "/"
    in a value makes folders; the value's other characters are simplified as by `_spelled`. A KEY
    without a value stays as text."""

    def spelled(value: Any) -> str:
        """Return a value as a part of a file name. The folders of a path stay, except `.` and
        `..`."""
        if not isinstance(value, str):
            return _spelled(value)
        folder_names = (
            _spelled(folder_name)
            for folder_name in value.split("/")
            if folder_name not in ("", ".", "..")
        )
        return "/".join(folder_names)

    return _VALUE.sub(lambda match: spelled(values.get(match[1], match[1])), called)


def _name_fault(called: str, point: GridPoint) -> PointFault | None:
    """Return the error in the template `called` for the name of a point, if it names a key that the
    point does not have; else None."""
    unknown_key = next((key for key in _VALUE.findall(called) if key not in point.values), None)
    if unknown_key is None:
        return None
    hints = meant(unknown_key, point.values, "name a key of this part")
    return PointFault(
        _CALLED.name, f"a point has no value of {unknown_key[:60]!a} to be called by", hints[0]
    )


def _about(
    point: GridPoint, run: GridPoint, axes: Mapping[str, tuple[Any, ...]], called: str
) -> GridPoint:
    """Return the point that evaluates one run: `point` with `run` as its subject.

    It is named after the run and the axes of its part, or if there is a template `called`, after
    that and the run."""
    own_axes = [name for name, values in axes.items() if len(values) > 1 and name != RUN]
    name = "_".join([run.name, *(_spelled(point.values[axis]) for axis in own_axes)])
    values = {**point.values, "subject": f"{OF_RUN}{run.name}"}
    return replace(point, name=f"{called}/{run.name}" if called else name, values=values)


def _spelled(value: Any) -> str:
    """Return a value as text for file names: at most 40 letters, digits and the signs `+-._`;
    others become `-`. Several numbers are joined by `x`. Of programs and TOML files the name
    without ending is used."""
    items: Sequence[Any] = value if isinstance(value, tuple) else (value,)
    text = "x".join(f"{item:g}" if isinstance(item, float) else str(item) for item in items)
    text = text.lower() if isinstance(value, bool) else text
    text = Path(text).stem if text.endswith((".nsl", ".toml")) else text
    return "".join(c if c.isalnum() or c in "+-._" else "-" for c in text)[:40]
