"""`--sensor FILE.toml` and `--sensor-set NAME=VALUE`, and a file to start from.

A parameter that is missing has its default; a key that is no parameter is an error.
"""

from __future__ import annotations

import textwrap
import tomllib
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from nscc.diagnostics.diagnostic import Diagnostic, Label, Rejected
from nscc.source import Source
from nscc.target.target import Target
from nscc.toml_text import LARGEST_FILE, NotToml, parsed, span_of
from nscc_runtime.sensor.schema import GROUPS, PARAMETERS
from nscc_runtime.sensor.sensor import Sensor
from nscc_runtime.sensor.values import Problem, checked, completed

_START = "`nscc effects --toml > sensor.toml` writes a complete file to start from"
_WIDTH = 100


def load_sensor(target: Target, path: Path | None = None, changes: Sequence[str] = ()) -> Sensor:
    """The sensor of a file (default: every default) with `changes`, each NAME=VALUE, on top.

    Raises Rejected, status 2: NS0751 for a file that cannot be read, NS0752 for one that is not
    TOML, NS0753 and NS0754 for unknown names and wrong values, NS0755 for a change that is not
    NAME=VALUE; all that is wrong at once.
    """
    values, found = ({}, []) if path is None else _values(read_sensor(path), str(path))
    for change in changes:
        changed, problems = _change(change)
        values.update(changed)
        found += problems
    if found:
        raise Rejected(found, status=2)
    return completed(values, target)


def read_sensor(path: Path) -> bytes:
    """What a sensor's file holds, for `parse_sensor`; Rejected (NS0751) if it cannot be read."""
    try:
        with open(path, "rb") as file:
            return file.read(LARGEST_FILE + 1)
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise Rejected(
            Diagnostic(
                "NS0751",
                f"the sensor file {str(path)[:200]!a} cannot be read: {reason}",
                helps=(_START,),
            ),
            status=2,
        ) from None


def parse_sensor(target: Target, data: bytes, name: str) -> Sensor:
    """The sensor of a file's bytes; `name` is the file's for messages. Raises as `load_sensor`."""
    values, found = _values(data, name)
    if found:
        raise Rejected(found, status=2)
    return completed(values, target)


def sensor_toml(
    sensor: Sensor, sources: Mapping[str, str] | None = None, heading: Sequence[str] = ()
) -> str:
    """A complete, commented file that `load_sensor` reads back as this sensor.

    `sources` say where values come from that are no defaults; `heading` are lines to begin with.
    """
    origin = "the value" if sources else "the default"
    lines = [
        "# A sensor of nscc: every number that the sensor effects depend on.",
        *(f"# {part}" for text in heading for part in textwrap.wrap(text, _WIDTH - 2)),
        "# `nscc run --sensor FILE.toml` reads it; a line that is left out has its default.",
        f"# Each line is preceded by: meaning [unit, range] (where {origin} comes from).",
    ]
    for group, remark in GROUPS.items():
        lines += ["", f"## {group}: {remark}"]
        for row in PARAMETERS:
            if row.group == group:
                source = (sources or {}).get(row.name, row.source)
                text = f"{row.meaning} [{row.unit}, {row.allowed}] ({source})"
                lines += [f"# {part}" for part in textwrap.wrap(text, _WIDTH - 2)]
                lines.append(f"{row.name} = {getattr(sensor, row.name)!r}")
    return "\n".join(lines) + "\n"


def _values(data: bytes, name: str) -> tuple[dict[str, float], list[Diagnostic]]:
    try:
        text, values = parsed(data)
    except NotToml as reason:
        raise Rejected(
            Diagnostic(
                "NS0752",
                f"the sensor file {name[:200]!a} is not a TOML table: {reason}",
                helps=(_START,),
            ),
            status=2,
        ) from None
    found, problems = checked(values)
    source = Source(name, text)
    return found, [_diagnostic(problem, source) for problem in problems]


def _change(text: str) -> tuple[dict[str, float], list[Diagnostic]]:
    """The one value of NAME=VALUE; VALUE is a number as TOML writes it."""
    name, equals, spelled = (part.strip() for part in text.partition("="))
    value: Any = spelled
    try:
        value = tomllib.loads(f"value = {spelled}")["value"]
    except (tomllib.TOMLDecodeError, RecursionError):
        equals = equals if spelled else ""
    if not equals or not name:
        return {}, [
            Diagnostic(
                "NS0755",
                f"--sensor-set takes NAME=VALUE, not {text[:60]!a}",
                helps=("for instance --sensor-set read_noise_e=5",),
            )
        ]
    found, problems = checked({name: value})
    return found, [_diagnostic(problem, None) for problem in problems]


def _diagnostic(problem: Problem, source: Source | None) -> Diagnostic:
    label = Label(span_of(source.text, "", problem.name)) if source else None
    return Diagnostic(
        problem.code,
        problem.message if source else f"--sensor-set: {problem.message}",
        source=source,
        label=label,
        helps=(problem.help,) if problem.help else (),
        data={"parameter": problem.name[:60]},
    )
