"""Keys of scenes and sensors in grids, and the objects that they describe."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from nscc.chips.target import Target
from nscc.toml.kinds import TextKind
from nscc.toml.schema import Key
from nscc_training.sweep.point import Values
from nscc_training.sweep.point_programs import axis

if TYPE_CHECKING:
    from nscc_runtime.scenes import Scene
    from nscc_runtime.sensor import Sensor

_SENSOR, _FILE = "sensor.", "sensor.file"


def scene_keys() -> tuple[Key, ...]:
    return (
        axis("scene", TextKind(), "a scene, as nscc run takes it"),
        axis(
            "exposure",
            TextKind(),
            "electrons over the frame, as --exposure; empty: the scene's",
            "",
        ),
        axis(
            "transfer",
            TextKind(("", "linear", "srgb")),
            "the scene's curve; empty: by its file",
            "",
        ),
    )


def sensor_keys() -> tuple[Key, ...]:
    """Return the keys of sensors: the sensor file, and each value as `sensor.KEY`."""
    from nscc_runtime.sensor.file import schema

    numbers = (axis(_SENSOR + key.name, key.kind, key.meaning) for key in schema().keys)
    return (axis(_FILE, TextKind(), "a sensor file (nscc effects --toml)", ""), *numbers)


def light_files(values: Values) -> Sequence[Path]:
    """Return the files of a point's scene and sensor."""
    named = values[_FILE], values.get("scene", "")
    return [Path(name) for name in named if name and not name.startswith("builtin:")]


def scene_of(values: Values) -> Scene:
    from nscc_runtime.scenes import Scene

    return Scene(
        values["scene"], exposure=values["exposure"] or None, transfer=values["transfer"] or None
    )


def sensor_file(values: Values) -> Path | None:
    return Path(values[_FILE]) if values[_FILE] else None


def sensor_changes(values: Values) -> tuple[str, ...]:
    """Return the sensor values that a point changes, in the form of --sensor-set."""
    changed = [name for name in values if name.startswith(_SENSOR) and name != _FILE]
    return tuple(f"{name.removeprefix(_SENSOR)}={values[name]!r}" for name in changed)


def sensor_of(values: Values, target: Target) -> Sensor:
    """Return the sensor of a point on a chip."""
    from nscc_runtime.sensor import load_sensor

    return load_sensor(target, sensor_file(values), sensor_changes(values))
