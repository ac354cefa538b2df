"""What Python users give to the emulator, as what it takes; or a sentence that says what is wrong.
Programs are `nscc.ShutterProgram`, which this floor does not know: anything with a `container` of
words is one."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from nscc.chips.target import Target
from nscc.diagnostics.arguments import shown, wrong_argument
from nscc.diagnostics.diagnostic import Diagnostic
from nscc.words.container import Container
from nscc_runtime.effects import Selection
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.light import Light
from nscc_runtime.scenes.load import PlacedLight, light_of_array
from nscc_runtime.scenes.placement import Placement
from nscc_runtime.scenes.scene import Scene
from nscc_runtime.sensor.file import default_sensor, load_sensor


class HasWords(Protocol):
    """A compiled program, however it was made."""

    @property
    def container(self) -> Container:
        """Its words."""
        ...


ProgramLike = HasWords | Container
LightLike = Light | Scene | NDArray[Any] | str | os.PathLike[str]
SensorLike = Sensor | Mapping[str, float] | str | os.PathLike[str] | None


def container_of(call: str, program: object) -> Container:
    """The words of a program; WrongArgument for anything else."""
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
    """Light in the program's slots, on the array or as a scene is laid on it.

    Of a `Light`, a scene or its name, or an array: electrons a slot (N, rows, cols), or electrons a
    second of a still (rows, cols). Raises WrongArgument for other things, and what the loaders of
    scenes raise (NS0730 .. NS0740); `warn` is handed what was changed in the scene.
    """
    target, slot_us = container.target, container.slot_us
    array = (target.rows, target.cols)
    if isinstance(light, Light):
        return (PlacedLight(light, Placement("crop", array, array, array)),)
    if isinstance(light, str | os.PathLike):
        light = Scene(str(os.fspath(light)))
    if isinstance(light, Scene):
        return light.laid(slot_us, target, warn)
    if _container(light) is not None:
        raise wrong_argument(
            f"{call}: the light is {shown(light)}, which is a program",
            helps=(f"the order is {call}(program, light)",),
        )
    values = _array(call, light)
    placed_light = light_of_array(
        values, slot_us=slot_us, rows=target.rows, cols=target.cols, name="the array"
    )
    return (PlacedLight(placed_light, Placement("crop", array, array, array)),)


def sensor_of(call: str, sensor: SensorLike, target: Target) -> Sensor:
    """A sensor; of its file, or of some of its numbers by name, where others have their defaults.
    Raises WrongArgument, and Rejected as `load_sensor`."""
    if isinstance(sensor, Sensor):
        return sensor
    if sensor is None:
        return default_sensor(target)
    if isinstance(sensor, str | os.PathLike):
        return load_sensor(target, Path(sensor))
    if isinstance(sensor, Mapping):
        return load_sensor(target, None, changes_of(call, sensor))
    raise wrong_argument(
        f"{call}: sensor must be a Sensor, a sensor file, or numbers by name, not {shown(sensor)}",
        helps=("for instance sensor={'full_well_e': 20000}; `nscc effects` lists the parameters",),
    )


def changes_of(call: str, values: Mapping[str, float]) -> list[str]:
    """Numbers of a sensor by name, as `--sensor-set` takes them; WrongArgument for others."""
    return [f"{name} = {number(call, str(name), value)!r}" for name, value in values.items()]


def number(call: str, name: str, value: object) -> float:
    """The number that a call's argument is; WrongArgument for what is none."""
    if isinstance(value, int | float | np.number) and not isinstance(value, bool):
        return float(value)
    raise wrong_argument(f"{call}: {name} is a number, not {shown(value)}")


def _container(value: object) -> Container | None:
    container = value if isinstance(value, Container) else getattr(value, "container", None)
    return container if isinstance(container, Container) else None


def _array(call: str, light: object) -> NDArray[Any]:
    """An array of what has numbers: numpy's, lists of them, tensors on the processor."""
    if isinstance(light, np.ndarray) or hasattr(light, "__array__") or isinstance(light, Sequence):
        try:
            return np.asarray(light)
        except (RuntimeError, TypeError, ValueError) as error:
            reason = " ".join(str(error).split())[:150]
            raise wrong_argument(
                f"{call}: cannot convert the light to an array: {shown(light)}",
                notes=(reason,),
                helps=(
                    "for a torch tensor use light.detach().cpu().numpy(); gradients flow "
                    "through nscc_training.differentiable_capture",
                ),
            ) from error
    raise wrong_argument(
        f"{call}: light must be an array, a scene or the name of a scene, not {shown(light)}",
        notes=("arrays are electrons per slot (N, rows, cols), or per second (rows, cols)",),
        helps=("nscc_runtime.scene('photo.exr', exposure='30000@70') loads your own scene",),
    )


def effects_of(call: str, effects: object) -> str | Selection | None:
    """Effects, or their text; WrongArgument for anything else."""
    if effects is None or isinstance(effects, str | Selection):
        return effects
    raise wrong_argument(
        f"{call}: effects is text, not {shown(effects)}",
        helps=("for instance effects='auto', 'all', 'none' or 'shot,read'",),
    )
