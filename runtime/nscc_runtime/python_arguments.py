"""Convert arguments of Python users for the emulator, or raise an error that explains them.

This package does not know `nscc.ShutterProgram`: any object with a `container` is a program."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from functools import wraps
from pathlib import Path
from typing import ParamSpec, Protocol, TypeVar

import numpy as np

from nscc.arrays import Array
from nscc.chips.target import Target
from nscc.diagnostics.arguments import (
    as_array,
    shown,
    wrong_argument,
)
from nscc.diagnostics.diagnostic import Diagnostic
from nscc.toml.arguments import argument
from nscc.toml.kinds import ANY_NUMBER, Instance
from nscc.words.container import Container
from nscc_runtime.caches import remembered
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.light import Light
from nscc_runtime.scene_settings import Scene
from nscc_runtime.scenes.errors import refuse_no_light
from nscc_runtime.scenes.load import PlacedLight, laid_lights, light_of_array
from nscc_runtime.scenes.placement import Placement
from nscc_runtime.sensor.file import default_sensor, load_sensor

P = ParamSpec("P")
R = TypeVar("R")


_FLOAT = Instance((float,), "a number")


class HasWords(Protocol):
    """A compiled program of any class."""

    @property
    def container(self) -> Container:
        """The words of the program."""
        ...


ProgramLike = HasWords | Container
LightLike = Light | Scene | Array | str | os.PathLike[str]
SensorLike = Sensor | Mapping[str, float] | str | os.PathLike[str] | None


def container_of(call: str, program: object) -> Container:
    """Return the container (a compiled program) of `program`: itself, or its attribute `container`.
    Raises WrongArgument for any other object, also for the path of a program. `call` names the
    function in errors."""
    container = _container(program)
    if container is not None:
        return container
    if isinstance(program, str | os.PathLike):
        path = os.fspath(program)
        load = "load" if str(path).lower().endswith(".icw") else "compile"
        raise wrong_argument(
            f"{call} takes a compiled program, not {shown(path)}",
            helps=(f"nscc.{load}({str(path)[:60]!r}) returns one",),
        )
    raise wrong_argument(
        f"{call} takes a compiled program first, not {shown(program)}",
        notes=(f"the order is {call}(program, light)",),
        helps=("nscc.compile and nscc.load return programs",),
    )


def laid_of(
    call: str, light: object, container: Container, warn: Callable[[Diagnostic], None]
) -> tuple[PlacedLight, ...]:
    """Return light in the program's slots, on the array or placed like a scene.

    `light`: a `Light`, a scene or its name, or an array of electrons per slot (N, rows, cols) or
    per second (rows, cols). `warn` is called with notes on changes of the scene. Raises
    WrongArgument for other objects, and the errors of scenes (NS0730 .. NS0740)."""
    target, slot_us = container.target, container.slot_us
    array = (target.rows, target.cols)
    if isinstance(light, str | os.PathLike):
        light = Scene(str(os.fspath(light)))
    if isinstance(light, Scene):
        return laid_lights(light, slot_us, target, warn)
    if isinstance(light, Light):
        light = light.current()
        _check_values(light)
    elif _container(light) is not None:
        raise wrong_argument(
            f"{call}: the light is {shown(light)}, which is a program",
            helps=(f"the order is {call}(program, light)",),
        )
    else:
        values = _array(call, light)
        light = light_of_array(
            values, slot_us=slot_us, rows=target.rows, cols=target.cols, name="the array"
        )
    return (PlacedLight(light, Placement("crop", array, array, array)),)


@remembered
def _check_values(light: Light) -> None:
    """Raise Rejected (NS0736) for negative light, also -inf; remembered for each light. Light that
    is NaN or +inf is allowed: frames mark such pixels as invalid, but +inf saturates if effects are
    simulated."""
    for _, _, strip in light.strips():
        frames = np.asarray(strip.frames)
        if (frames < 0).any():
            refuse_no_light(np.nan_to_num(frames, posinf=0.0, neginf=-np.inf), "the light")


def sensor_of(call: str, sensor: SensorLike, target: Target) -> Sensor:
    """Return `sensor` itself, the one of a sensor file (a path), or the one of `target` with other
    values by name; None is the default of `target`.

    Raises WrongArgument for other objects, and Rejected for a file or values that are invalid
    (NS0751 to NS0754). `call` names the function in errors."""
    if isinstance(sensor, Sensor):
        return sensor
    if sensor is None:
        return default_sensor(target)
    if isinstance(sensor, str | os.PathLike):
        return load_sensor(target, path=Path(sensor))
    if isinstance(sensor, Mapping):
        return load_sensor(target, path=None, changes=changes_of(call, sensor))
    raise wrong_argument(
        f"{call}: sensor must be a Sensor, a sensor file, or numbers by name, not {shown(sensor)}",
        helps=("for instance sensor={'full_well_e': 20000}; `nscc effects` lists the parameters",),
    )


def changes_of(call: str, values: Mapping[str, float]) -> dict[str, float]:
    """Return `values` by name of a parameter as floats; names and ranges are not checked here.
    Raises WrongArgument for values that are no numbers; `call` names the function in it."""
    changes = {}
    for name, value in values.items():
        # The sensor's own error names the range, also for NaN and infinity.
        kind = _FLOAT if isinstance(value, float) else ANY_NUMBER
        changes[str(name)] = float(argument(call, str(name), kind, value))
    return changes


def _container(value: object) -> Container | None:
    """Return `value` if it is a container, or its attribute `container` if that is one; None for
    anything else."""
    container = value if isinstance(value, Container) else getattr(value, "container", None)
    return container if isinstance(container, Container) else None


def _array(call: str, light: object) -> Array:
    """Return `light` as an array, from an array, list or CPU tensor; masked values become NaN.
    Raises WrongArgument for other objects; `call` names the caller in it."""
    if isinstance(light, np.ndarray) or hasattr(light, "__array__") or isinstance(light, Sequence):
        # Masked values are rejected like NaN.
        mask = np.ma.getmask(light)
        return np.where(mask, np.nan, light) if mask.any() else as_array(call, "the light", light)
    raise wrong_argument(
        f"{call}: light must be an array, a scene or the name of a scene, not {shown(light)}",
        notes=("arrays are electrons per slot (N, rows, cols), or per second (rows, cols)",),
        helps=("nscc_runtime.scene('photo.exr', exposure='30000@70') loads your own scene",),
    )


_REMOVED = {
    "tolerance_max": "use tolerance, which limits the RMS error; the plan shows its worst pixel",
    "torch_device": "leave torch_device out: frames are exposed on the processor, by `threads`",
}
"""What to do instead of each argument that earlier versions had."""


def refuse_removed(function: Callable[P, R]) -> Callable[P, R]:
    """Return a function that calls `function`, and raises WrongArgument first if a keyword argument
    is given that only earlier versions had (`_REMOVED`)."""

    @wraps(function)
    def call(*arguments: P.args, **named: P.kwargs) -> R:
        """Raise WrongArgument if a removed argument is given by name; otherwise call the function
        and return its result."""
        for name, instead in _REMOVED.items():
            if name in named:
                raise wrong_argument(
                    f"nscc_runtime.{function.__name__} no longer has the argument {name}",
                    helps=(instead,),
                )
        return function(*arguments, **named)

    return call
