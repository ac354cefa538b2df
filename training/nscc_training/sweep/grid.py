"""Grids: TOML files whose lists are axes, as the points that they stand for.

    kind = "compile"

    [classes]
    class = ["b", "d"]
    slots = [8, 16]

Every table is a part: its points are all combinations of its keys' values. Parts of a kind of
their own say so with `kind`; a table `[plot]` says what is drawn.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import MISSING, dataclass, replace
from itertools import product
from math import prod
from pathlib import Path
from typing import Any

from nscc.diagnostics.diagnostic import Diagnostic, Rejected
from nscc.diagnostics.rejection import rejected
from nscc.diagnostics.suggest import meant
from nscc.source import Source
from nscc.toml.files import file_bytes, file_table, file_text
from nscc.toml.kinds import Axis, Several, Text
from nscc.toml.schema import Codes, Key, Schema
from nscc_training.sweep.evaluating import RUN
from nscc_training.sweep.kinds import KINDS
from nscc_training.sweep.point import OF_RUN, Fault, Point, Values

MOST_POINTS = 100_000

_CODES = Codes("NS0830", "NS0830", unknown="NS0831", wrong="NS0832", missing="NS0832")
_START = "`nscc sweep --schema KIND` prints a complete part to start from"
_KIND = Key(
    "", "kind", Text(tuple(KINDS)), "; ".join(f"{k.name}: {k.what}" for k in KINDS.values()), ""
)
_NAME, _NAME_SAID = r"[A-Za-z0-9_-]{1,60}", "take letters, digits, `-` and `_`"
_VALUE = re.compile(r"\{([^{}]+)\}")
_PLOT = "plot"
_CALLED = Key(
    "", "name", Text(
        pattern=r"(?!(.*/)?\.{0,2}(/|$))([A-Za-z0-9_.+/-]|\{[^{}]+\})+",
        said='a name, "{KEY}" in it for a value',
    ), "what its points are called, instead of part and axes", "",
)  # fmt: skip
_LIKE = Key("", "like", Text(), "a part above whose keys it takes where it has none", "")
_OF_PART = (_KIND.name, _CALLED.name, _LIKE.name)
"""Keys of every part that are no axes."""
_PLOT_KEYS = (
    Key(_PLOT, "x", Text(), "the axis drawn across; by default the first of numbers", ""),
    Key(_PLOT, "y", Several(Text(), said="a list of figures"), "the figures drawn upwards", ()),
    Key(_PLOT, "line", Several(Text(), said="a list of axes"), "those whose values have lines", ()),
    Key(_PLOT, "panel", Text(), "the axis of which each value has a panel", ""),
)


@dataclass(frozen=True)
class Plot:
    """What is drawn; "" and none: what suits the grid."""

    x: str = ""
    y: tuple[str, ...] = ()
    line: tuple[str, ...] = ()
    panel: str = ""


@dataclass(frozen=True)
class Grid:
    """A grid read from a file of that `name` in a `folder`.

    `columns` are the keys that any part names, in the order of the file; `axes` those with several
    values somewhere. `text` is the file's.
    """

    name: str
    folder: Path
    points: tuple[Point, ...]
    columns: tuple[str, ...]
    axes: tuple[str, ...]
    plot: Plot
    text: str


def read_grid(path: Path) -> Grid:
    """The grid in a file.

    Raises Rejected, status 2: NS0830 for a file that cannot be read or is no TOML, NS0831 for keys
    that are none, NS0832 for wrong values; all that is wrong at once.
    """
    head = _schema({})
    tables, source = file_table(head, file_bytes(head, path), str(path))
    parts: dict[str, dict[str, Any]] = {}
    wrong = []
    for name, value in tables.items():
        if not _is_part(name, value):
            continue
        own = _flat(value)
        like = own.get(_LIKE.name)
        if like is not None and like not in parts:
            message = f"[{name}]: there is no part {str(like)[:60]!a} above"
            wrong.append(head.problem(_CODES.wrong, message, name, _LIKE.name, source, _START))
        parts[name] = {**parts.get(str(like), {}), **own}
    if wrong:
        raise Rejected(wrong, status=2)
    kinds = _kinds(tables, parts, source)
    schema = _schema(kinds)
    found, problems = schema.read({**tables, **parts}, source)
    if not (parts or problems):
        message = "a grid has a table for each of its parts, and here is none"
        problems.append(schema.problem(_CODES.missing, message, "", "", source, _START))
    if problems:
        raise Rejected(problems, status=2)
    given = {part: {name: found[f"{part}.{name}"] for name in keys if name not in _OF_PART}
             for part, keys in parts.items()}  # fmt: skip
    called = {part: found.get(f"{part}.{_CALLED.name}", "") for part in parts}
    points = _points(given, kinds, called, schema, source)
    columns = tuple(dict.fromkeys(name for keys in given.values() for name in keys))
    axes = tuple(n for n in columns if any(len(keys.get(n, ())) > 1 for keys in given.values()))
    plot = Plot(**{key.name: found[key.path] for key in _PLOT_KEYS if key.path in found})
    return Grid(path.stem, path.parent, points, columns, axes, plot, source.text)


def of_parts(grid: Grid, parts: Sequence[str]) -> Grid:
    """Return the grid with the points of these parts alone, by default all, and with the runs that
    they name. Rejected (NS0832) for a part that the grid does not have."""
    every = tuple(dict.fromkeys(point.part for point in grid.points))
    for part in parts:
        if part not in every:
            hint = meant(part, every, f"the parts are {', '.join(every)}")
            raise rejected("NS0832", f"the grid has no part '{part[:60]}'", helps=hint)
    points: dict[Point, None] = {}

    def take(point: Point) -> None:
        for run in point.after:
            take(run)
        points[point] = None

    for point in grid.points:
        if not parts or point.part in parts:
            take(point)
    return replace(grid, points=tuple(points))


def part_text(kind: str) -> str:
    """A complete part of that kind, every key with its default or as a remark."""
    keys = [replace(key, section=kind, heading=kind) for key in KINDS[kind].takes()]
    known = [key for key in keys if key.default is not MISSING]
    schema = Schema("grid", (replace(_KIND, default=kind), *known), {"": "", kind: ""}, _CODES, "")

    def remark(key: Key) -> str:
        axis = key.kind
        return f"{key.meaning} ({axis.each.allowed})" if isinstance(axis, Axis) else ""

    head = (
        f"A part of a grid for `nscc sweep`, of kind {kind}: {KINDS[kind].what}.",
        "Every key has its default here. A list of values makes a point of each, in every",
        "combination with those of the other keys. Keys without a default:",
        *(f"  {key.name}: {remark(key)}" for key in keys if key.default is MISSING),
    )

    text = file_text(schema, {key.path: key.default for key in schema.keys}, remark, head)
    return text if known else f"{text}\n[{kind}]\n"


def _is_part(name: str, value: Any) -> bool:
    return isinstance(value, Mapping) and name != _PLOT


def _flat(table: Mapping[str, Any], begin: str = "") -> dict[str, Any]:
    """A table whose keys may be dotted: `sensor.adc_noise_lsb = 1` is one key."""
    found: dict[str, Any] = {}
    for name, value in table.items():
        if isinstance(value, Mapping) and value:
            found |= _flat(value, f"{begin}{name}.")
        else:
            found[f"{begin}{name}"] = value
    return found


def _kinds(
    tables: Mapping[str, Any], parts: Mapping[str, Mapping[str, Any]], source: Source
) -> dict[str, str]:
    """The kind of each part; Rejected (NS0832) where one has none."""
    wrong: list[Diagnostic] = []
    head = _schema({})
    common = tables.get(_KIND.name)
    found = {}
    for part, keys in parts.items():
        kind = keys.get(_KIND.name, common)
        if not re.fullmatch(_NAME, part):
            message = f"a part cannot be called {part[:60]!a}: files are named after it"
            wrong.append(head.problem(_CODES.wrong, message, part, "", source, _NAME_SAID))
            continue
        if isinstance(kind, str) and kind in KINDS:
            found[part] = kind
            continue
        section = part if _KIND.name in keys else ""
        said = "is missing" if kind is None else f"is not {str(kind)[:60]!a}"
        message = f"the kind of [{part}] {said}: it is {_KIND.kind.allowed}"
        help_text = 'write kind = "compile" above all parts, or in this one'
        wrong.append(head.problem(_CODES.wrong, message, section, _KIND.name, source, help_text))
    if wrong:
        raise Rejected(wrong, status=2)
    return found


def _schema(kinds: Mapping[str, str]) -> Schema[Key]:
    """The keys of a grid whose parts have these kinds."""
    keys = [
        replace(key, section=part, heading=part)
        for part, kind in kinds.items()
        for key in (_KIND, _CALLED, _LIKE, *KINDS[kind].takes())
    ]
    headings = dict.fromkeys(("", _PLOT, *kinds), "")
    return Schema("grid", (_KIND, *_PLOT_KEYS, *keys), headings, _CODES, _START)


def _points(
    given: Mapping[str, Mapping[str, tuple[Any, ...]]], kinds: Mapping[str, str],
    called: Mapping[str, str], schema: Schema[Key], source: Source,
) -> tuple[Point, ...]:  # fmt: skip
    """All combinations of all parts, runs before what needs them."""
    count = sum(prod(map(len, keys.values())) for keys in given.values())
    if count > MOST_POINTS:
        message = f"the grid has {count} points, {MOST_POINTS} are the most"
        help_text = "split it into several files"
        raise Rejected(schema.problem(_CODES.wrong, message, "", "", source, help_text), status=2)
    wrong: dict[tuple[str, str, str], Diagnostic] = {}
    made: dict[str, list[Point]] = {}
    for part in sorted(given, key=lambda part: RUN in given[part]):
        made[part] = []
        for point in _of_part(part, kinds[part], given[part], called[part]):
            fault = KINDS[point.kind].fault(point.values, given[part]) or _name_fault(
                called[part], point
            )
            if fault is not None:
                wrong.setdefault(
                    (part, fault.key, fault.message),
                    schema.problem(_CODES.wrong, f"[{part}]: {fault.message}", part, fault.key,
                                   source, fault.help),
                )  # fmt: skip
                continue
            if RUN not in point.values:
                made[part].append(point)
                continue
            runs = made.get(point.values[RUN], [])
            if not runs or runs[0].kind != "train":
                message = f"[{part}]: there is no part [{point.values[RUN][:60]}] of kind train"
                trains = [name for name, kind in kinds.items() if kind == "train"]
                help_text = f"such parts are {', '.join(trains)}" if trains else "add such a part"
                wrong[part, RUN, message] = schema.problem(
                    _CODES.wrong, message, part, RUN, source, help_text
                )
            made[part] += (_about(point, run, given[part], called[part]) for run in runs)
    if wrong:
        raise Rejected([*wrong.values()], status=2)
    every = [point for part in given for point in made[part]]
    return _linked(every, schema, source)


def _linked(points: Sequence[Point], schema: Schema[Key], source: Source) -> tuple[Point, ...]:
    """Return the points, each knowing those whose runs its values name: `run:NAME`.

    Rejected (NS0832) unless one point of kind train has the name, and for points that name each
    other in a circle.
    """
    trained = [point for point in points if point.kind == "train"]
    runs = {point.name: point for point in trained}
    count = Counter(point.name for point in trained)
    linked: dict[int, Point] = {}

    def problem(point: Point, message: str, key: str) -> Rejected:
        help_text = "name a point of kind train, with what stands in its `name`"
        return Rejected(
            schema.problem(_CODES.wrong, message, point.part, key, source, help_text), status=2
        )

    def link(point: Point, above: tuple[str, ...] = ()) -> Point:
        if id(point) in linked:
            return linked[id(point)]
        after = list(point.after)
        for key, value in point.values.items():
            if not (isinstance(value, str) and value.startswith(OF_RUN)):
                continue
            name = value.removeprefix(OF_RUN)
            if count[name] != 1:
                found = f"{count[name] or 'no'} run{'s' if count[name] else ''}"
                raise problem(point, f"[{point.part}]: {found} called '{name[:80]}'", key)
            circle = (*above, point.name) if point.kind == "train" else above
            if name in circle:
                raise problem(point, f"[{point.part}]: run '{name[:80]}' depends on itself", key)
            after.append(link(runs[name], circle))
        linked[id(point)] = replace(point, after=tuple(after))
        return linked[id(point)]

    return tuple(link(point) for point in points)


def _of_part(
    part: str, kind: str, given: Mapping[str, tuple[Any, ...]], called: str
) -> Iterator[Point]:
    """A part's combinations, the key that is named first changing last."""
    defaults = {
        key.name: key.default[0] for key in KINDS[kind].takes() if key.default is not MISSING
    }
    several = [name for name, values in given.items() if len(values) > 1]
    for values in product(*given.values()):
        chosen = {**defaults, **dict(zip(given, values, strict=True))}
        name = "_".join([part, *(_spelled(chosen[axis]) for axis in several)])
        yield Point(part, kind, _called(called, chosen) or name, chosen)


def _called(called: str, values: Values) -> str:
    """A name with values in the place of their keys; of a path the folders that it goes down."""

    def spelled(value: Any) -> str:
        if not isinstance(value, str):
            return _spelled(value)
        parts = (_spelled(part) for part in value.split("/") if part not in ("", ".", ".."))
        return "/".join(parts)

    return _VALUE.sub(lambda found: spelled(values.get(found[1])), called)


def _name_fault(called: str, point: Point) -> Fault | None:
    """What is wrong with the name that a part gives its points."""
    wrong = next((key for key in _VALUE.findall(called) if key not in point.values), None)
    if wrong is None:
        return None
    near = meant(wrong, point.values, "name a key of this part")
    return Fault(_CALLED.name, f"a point has no value of {wrong[:60]!a} to be called by", near[0])


def _about(point: Point, run: Point, given: Mapping[str, tuple[Any, ...]], called: str) -> Point:
    """The evaluation of a run: known by its run's name, and by its own axes."""
    own = [name for name, values in given.items() if len(values) > 1 and name != RUN]
    name = "_".join([run.name, *(_spelled(point.values[axis]) for axis in own)])
    values = {**point.values, "subject": f"{OF_RUN}{run.name}"}
    return replace(point, name=f"{called}/{run.name}" if called else name, values=values)


def _spelled(value: Any) -> str:
    """A value as a part of a file's name."""
    parts: Sequence[Any] = value if isinstance(value, tuple) else (value,)
    text = "x".join(f"{part:g}" if isinstance(part, float) else str(part) for part in parts)
    text = text.lower() if isinstance(value, bool) else text
    text = Path(text).stem if text.endswith((".nsl", ".toml")) else text
    return "".join(c if c.isalnum() or c in "+-._" else "-" for c in text)[:40]
