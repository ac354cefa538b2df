"""The options of every command that lays a scene on the array, and those of its sensor."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import click

from nscc.diagnostics.rejection import rejected

if TYPE_CHECKING:
    from nscc.target.target import Target
    from nscc_runtime.scenes import Scene
    from nscc_runtime.sensor import Sensor

Command = TypeVar("Command", bound=Callable[..., Any])

_SCENE = (
    click.option(
        "--exposure", metavar="E[@P]", help="Electrons over the frame at percentile P (99)."
    ),
    click.option("--transfer", type=click.Choice(["linear", "srgb"]), help="The scene's curve."),
    click.option(
        "--fps", type=float, help="The clip's frames a second, seen in the slots' own time."
    ),
    click.option("--crop", metavar="R,C", help="Top left corner of the array in the scene."),
    click.option(
        "--frames-are",
        type=click.Choice(["integrals", "samples"]),
        default="integrals",
        help="Whether a clip's frames hold all the light of their time, or an instant of it.",
    ),
)
_SENSOR = (
    click.option(
        "--sensor",
        type=click.Path(path_type=Path),
        help="The sensor's numbers (nscc effects --toml).",
    ),
    click.option("--sensor-set", multiple=True, metavar="K=V", help="Change one of them."),
)


def scene_options(function: Command) -> Command:
    """Adds --exposure, --transfer, --fps, --crop and --frames-are."""
    for option in reversed(_SCENE):
        function = option(function)
    return function


def sensor_options(function: Command) -> Command:
    """Adds --sensor and --sensor-set."""
    for option in reversed(_SENSOR):
        function = option(function)
    return function


def scene_of(
    options: Mapping[str, Any], missing: str = "no scene to expose: --scene is missing"
) -> Scene:
    """The scene that a command's options describe; NS0744 with the text `missing` without one."""
    from nscc_runtime.scenes import Scene

    if not options["scene"]:
        raise rejected(
            "NS0744",
            missing,
            helps=("try --scene builtin:hdr, or name a file or a folder of pictures",),
        )
    return Scene(
        options["scene"], options["exposure"], options["transfer"], options["fps"],
        options["crop"], options["frames_are"],
    )  # fmt: skip


def sensor_of(target: Target, options: Mapping[str, Any]) -> Sensor:
    """The sensor that a command's options describe, on this chip."""
    from nscc_runtime.sensor import load_sensor

    return load_sensor(target, options["sensor"], options["sensor_set"])
