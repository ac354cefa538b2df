"""Read `--sensor FILE.toml` and `--sensor-set NAME=VALUE`, and write a complete sensor file.

A missing parameter has its default; an unknown key is an error."""

from __future__ import annotations

import textwrap
from collections.abc import Mapping, Sequence
from pathlib import Path

from nscc.chips.target import Target
from nscc.diagnostics.diagnostic import Rejected
from nscc.toml.schema import WIDTH, FileCodes, Schema, file_bytes, file_text, file_values
from nscc_runtime.effects.effect import HEADINGS, Parameter
from nscc_runtime.effects.registry import of_registered, parameters
from nscc_runtime.effects.sensor import Sensor


@of_registered
def schema() -> Schema[Parameter]:
    """Return the schema of the sensor file: the parameters of all registered effects."""
    return Schema(
        "sensor",
        parameters(),
        HEADINGS,
        FileCodes("NS0751", "NS0752", unknown="NS0753", wrong_value="NS0754", change="NS0755"),
        "`nscc effects --toml > sensor.toml` writes a complete file to start from",
        noun="parameter",
        option="--sensor-set",
        example="read_noise_e=5",
    )


Changes = Sequence[str] | Mapping[str, float]
"""Changes of parameters: texts NAME=VALUE, as the command line takes them, or values by name."""


def load_sensor(target: Target, path: Path | None = None, changes: Changes = ()) -> Sensor:
    """Read the sensor file `path` (None: all defaults), apply `changes`, and complete it with the
    defaults of `target`.

    Raises Rejected (status 2) with all errors at once: NS0752 if the file is not TOML, NS0753 for
    unknown names, NS0754 for wrong values, NS0755 for a change that is not NAME=VALUE. A file that
    cannot be read raises NS0751."""
    data = b"" if path is None else read_sensor(path)
    return parse_sensor(target, data, str(path), changes)


def read_sensor(path: Path) -> bytes:
    """Return the bytes of a sensor file. Raises Rejected (NS0751) if it cannot be read."""
    return file_bytes(schema(), path)


def parse_sensor(target: Target, data: bytes, name: str, changes: Changes = ()) -> Sensor:
    """Return the sensor of the file content `data` with `changes`, completed with the defaults of
    `target`; `name` is the file in messages. Raises Rejected like `load_sensor`."""
    file_sensor_values, problems, _ = file_values(schema(), data, name)
    if isinstance(changes, Mapping):
        changed, wrong_too = schema().read(changes)
    else:
        changed, wrong_too = schema().changed(changes)
    if problems or wrong_too:
        raise Rejected([*problems, *wrong_too], status=2)
    return completed({**file_sensor_values, **changed}, target)


@of_registered
def default_sensor(target: Target) -> Sensor:
    """Return the sensor of a target with every parameter at its default."""
    return completed({}, target)


def completed(given_values: Mapping[str, float], target: Target) -> Sensor:
    """Return the sensor with the checked `given_values`, by parameter name; other parameters have
    the defaults of `target`, which may follow from parameters before them. The default of
    `electrons_per_lsb` maps the full well to the top code."""
    values: dict[str, float] = {}
    for row in schema().keys:
        # `values` has the parameters before this one, on which its default may depend.
        known = row.name in given_values
        values[row.name] = given_values[row.name] if known else row.default_for(target, values)
    return Sensor(values)


def sensor_toml(
    sensor: Sensor, sources: Mapping[str, str] | None = None, heading: Sequence[str] = ()
) -> str:
    """Return a complete, commented sensor file that `load_sensor` reads back as this sensor.

    `sources` gives the origin of each value that is not the default, by parameter name. `heading`
    contains the lines at the beginning."""
    origin = "the value" if sources else "the default"

    def remark(row: Parameter) -> str:
        """Return the comment on the parameter `row`: meaning, unit, range and source."""
        source = (sources or {}).get(row.name, row.source)
        return f"{row.meaning} [{row.kind.unit}, {row.kind.range}] ({source})"

    return file_text(
        schema(),
        sensor.values,
        remark,
        (
            "A sensor of nscc: every number that the sensor effects depend on.",
            *(line for text in heading for line in textwrap.wrap(text, WIDTH - 2)),
            "`nscc run --sensor FILE.toml` reads it; a line that is left out has its default.",
            f"Each line is preceded by: meaning [unit, range] (where {origin} comes from).",
        ),
    )
