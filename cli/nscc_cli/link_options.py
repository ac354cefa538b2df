"""The options of every command that opens a port."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

import click

from nscc_cli.support import NumberRange

Command = TypeVar("Command", bound=Callable[..., Any])

DEFAULT_BAUD = 3_000_000
DEFAULT_PATIENCE_S = 10.0


def link_options(function: Command) -> Command:
    """Adds --baud and --patience."""
    for option in (
        click.option(
            "--patience",
            type=NumberRange(0.1, 3600),
            default=DEFAULT_PATIENCE_S,
            show_default=True,
            help="Seconds of silence after which a device is given up.",
        ),
        click.option(
            "--baud",
            type=click.IntRange(1200, 12_000_000),
            default=DEFAULT_BAUD,
            show_default=True,
            help="Speed of the device's port.",
        ),
    ):
        function = option(function)
    return function
