"""Scenes and sensors of points."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from nscc.chips.target import Target
from nscc.toml.kinds import Text
from nscc.toml.schema import Key
from nscc_training.sweep.point import Values
from nscc_training.sweep.point_programs import axis

if TYPE_CHECKING:
    from nscc_runtime.scenes import Scene
    from nscc_runtime.sensor import Sensor

_SENSOR, _FILE = "sensor.", "sensor.file"


def scene_keys() -> tuple[Key, ...]:
    """What falls on the array."""
    return (
        axis("scene", Text(), "a scene, as nscc run takes it"),
        axis("exposure", Text(), "electrons over the frame, as --exposure; empty: the scene's", ""),
        axis("transfer", Text(("", "linear", "srgb")), "the scene's curve; empty: by its file", ""),
    )


def sensor_keys() -> tuple[Key, ...]:
    """The sensor's file, and each of its numbers as `sensor.KEY`."""
    from nscc_runtime.sensor.file import schema

    numbers = (axis(_SENSOR + key.name, key.kind, key.meaning) for key in schema().keys)
    return (axis(_FILE, Text(), "a sensor's numbers (nscc effects --toml)", ""), *numbers)


def light_files(values: Values) -> Sequence[Path]:
    """The files of the scene and of the sensor."""
    named = values[_FILE], values.get("scene", "")
    return [Path(name) for name in named if name and not name.startswith("builtin:")]


def scene_of(values: Values) -> Scene:
    """The scene that a point names."""
    from nscc_runtime.scenes import Scene

    return Scene(
        values["scene"], exposure=values["exposure"] or None, transfer=values["transfer"] or None
    )


def sensor_file(values: Values) -> Path | None:
    """The file of a point's sensor."""
    return Path(values[_FILE]) if values[_FILE] else None


def sensor_changes(values: Values) -> tuple[str, ...]:
    """The numbers of a sensor that a point changes, as --sensor-set takes them."""
    changed = [name for name in values if name.startswith(_SENSOR) and name != _FILE]
    return tuple(f"{name.removeprefix(_SENSOR)}={values[name]!r}" for name in changed)


def sensor_of(values: Values, target: Target) -> Sensor:
    """The sensor of a point, on this chip."""
    from nscc_runtime.sensor import load_sensor

    return load_sensor(target, sensor_file(values), sensor_changes(values))
