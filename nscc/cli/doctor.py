"""`nscc doctor`: what this installation has, and what it would need for the rest."""

from __future__ import annotations

import platform
from collections.abc import Iterator
from importlib import metadata
from importlib.util import find_spec

import click

from nscc import __version__
from nscc.cli.support import CommonCommand

NEEDED = (
    "click", "lark", "llvmlite", "matplotlib", "numba", "numpy", "opencv-python-headless",
    "OpenEXR", "pillow", "scipy",
)  # fmt: skip
OPTIONAL = (
    ("torch", "torch", "training, which is not in this version"),
    ("pyserial", "serial", "the device link, which is not in this version"),
)


@click.command("doctor", cls=CommonCommand)
def command() -> int:
    """Report versions, compiled loops and serial ports. Exit status 3 if something is missing."""
    lines = list(_lines())
    for good, text in lines:
        click.echo(f"{'ok     ' if good else 'MISSING'} {text}")
    return 0 if all(good for good, _ in lines) else 3


def _lines() -> Iterator[tuple[bool, str]]:
    """(Whether all is well, what was looked at)."""
    yield True, f"nscc {__version__}, Python {platform.python_version()}, {platform.system()}"
    for name in NEEDED:
        try:
            yield True, f"{name} {metadata.version(name)}"
        except metadata.PackageNotFoundError:
            yield False, f"{name}: install it with `pip install {name}`"
    for package, module, purpose in OPTIONAL:
        present = find_spec(module) is not None
        yield True, f"{package} {'is there' if present else 'is not installed'} (for {purpose})"
    yield _loops()
    yield True, _ports()


def _loops() -> tuple[bool, str]:
    from nscc_runtime.emulator import compiled

    try:
        compiled.entry_point()
    except (ImportError, OSError, RuntimeError) as error:
        return False, f"the emulator's loops do not compile: {error}"
    return True, "the emulator's loops are compiled for this processor"


def _ports() -> str:
    if find_spec("serial") is None:
        return "serial ports: pyserial is needed to list them"
    from serial.tools.list_ports import comports  # type: ignore[import-untyped,unused-ignore]

    names = sorted(port.device for port in comports())
    return "serial ports: " + (", ".join(names) or "none")
