"""The options of every command that lays a scene on the array, and those of its sensor."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar

import click

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
