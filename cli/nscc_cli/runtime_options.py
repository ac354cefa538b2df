"""Options of scenes, captures and serial ports, as `nscc_runtime` declares them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

import click

from nscc_cli.options import (
    DEVICE,
    SCENE,
    build_options,
    declared,
    pixels_option,
    section,
    sensor_options,
    together,
    values_given,
)
from nscc_cli.support import progress
from nscc_runtime.device.link_settings import LinkSettings
from nscc_runtime.request import Request
from nscc_runtime.scene_settings import Scene

if TYPE_CHECKING:
    from nscc_runtime.device.device_chip import DeviceChip
    from nscc_runtime.sensor import Sensor

scene_option = section(SCENE, declared(Scene, "name"))

placing_options = section(
    SCENE,
    declared(
        Scene,
        "exposure",
        "transfer",
        "white",
        "skip",
        "bracket",
        "times",
        "fps",
        "crop",
        "frames_are",
    ),
)
"""Options that place a scene on the array."""

fit_option = section(SCENE, declared(Scene, "fit", show=True))


def named_values(
    _context: click.Context, option: click.Parameter, values: tuple[str, ...]
) -> dict[str, str] | None:
    """Return the values of a repeatable option NAME=VALUE by name; None if the option was not
    given. Of equal names the last counts, and blanks around both parts are dropped. Raise
    BadParameter for a value without name or `=`."""
    split = [value.partition("=") for value in values]
    if not all(name and sign for name, sign, _ in split):
        raise click.BadParameter(f"write {option.opts[0]} {option.make_metavar(_context)}")
    return {name.strip(): value.strip() for name, _, value in split} or None


host_value_options = section(
    SCENE,
    click.option(
        "--param",
        "params",
        multiple=True,
        metavar="NAME=VALUE",
        callback=named_values,
        help="Values of parameters, set before the frame, for instance t=4% or m=8.",
    ),
    click.option(
        "--input",
        "inputs",
        multiple=True,
        metavar="NAME=FILE",
        callback=named_values,
        help="Bits of input planes, loaded before the frame: .npy, .npz or a picture.",
    ),
)
"""Options for what the host sets before a frame."""

link_options = section(DEVICE, declared(LinkSettings, show=True))
"""Options of commands that open a serial port."""


@contextmanager
def chip_at(
    port: str, options: Mapping[str, Any], sensor: Sensor | None = None
) -> Iterator[DeviceChip]:
    """Yield the chip at a serial port, which is opened with the `options` of `link_options`, and
    closed at the end of the `with` block. `sensor` models the chip; uploads show their progress."""
    from nscc_runtime.device.device_chip import DeviceChip
    from nscc_runtime.device.link import SerialLink

    with SerialLink(port, **values_given(LinkSettings, options)) as link:
        yield DeviceChip(link, sensor, progress)


measured_options = together(
    declared(Request, "seed", "device_seed", show=True),
    pixels_option,
    placing_options,
    sensor_options,
    build_options,
)
"""Options of tradeoffs that measure frames of a program."""
