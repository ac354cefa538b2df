"""`nscc doctor`: what this installation has, and what it would need for the rest."""

from __future__ import annotations

import platform
from collections.abc import Iterator
from importlib import metadata
from importlib.util import find_spec

import click

from nscc import __version__
from nscc_cli.support import CommonCommand

NEEDED = (
    ("click", "the command line"),
    ("llvmlite", "the emulator"),
    ("matplotlib", "nscc view"),
    ("numba", "the emulator"),
    ("numpy", "everything"),
    ("opencv-python-headless", "pictures and films"),
    ("OpenEXR", ".exr"),
    ("pillow", "pictures"),
    ("scipy", ".mat"),
)
OPTIONAL = (
    ("safetensors", "nscc train"),
    ("torch", "nscc train, reconstruct, evaluate"),
    ("pyserial", "devices at a serial port"),
)

GOOD, ABSENT, WRONG = "ok", "absent", "WRONG"
Finding = tuple[str, str]
"""GOOD, ABSENT (and not needed) or WRONG, and what was looked at."""


@click.command("doctor", cls=CommonCommand)
def command() -> int:
    """Report versions, readers, the cache, compiled loops and serial ports.

    Exits with status 3 if something that nscc needs is missing or broken.
    """
    status = 0
    for state, text in findings():
        click.echo(f"{state:8}{text}")
        status = 3 if state == WRONG else status
    return status


def findings() -> Iterator[Finding]:
    """Everything that is looked at, one after the other: the last ones take a moment."""
    yield GOOD, f"nscc {__version__}"
    yield GOOD, f"Python {platform.python_version()} on {platform.system()} {platform.machine()}"
    for name, purpose in NEEDED:
        try:
            yield GOOD, f"{name} {metadata.version(name)}"
        except metadata.PackageNotFoundError:
            yield WRONG, f"{name} ({purpose}): install it with `pip install {name}`"
    for name, purpose in OPTIONAL:
        try:
            yield GOOD, f"{name} {metadata.version(name)} ({purpose})"
        except metadata.PackageNotFoundError:
            yield ABSENT, f"{name} ({purpose})"
    yield _grammar()
    yield _targets()
    yield _cache()
    yield _loops()
    yield _ports()
    yield _compiler()


def _grammar() -> Finding:
    from nscc.source import Source
    from nscc.syntax.parse import parse

    _tree, wrong = parse(Source("doctor.nsl", "nsl 1\nframe 2 slots of 1ms\nopen when n < 1\n"))
    return (WRONG, "the grammar's tables do not work") if wrong else (GOOD, "grammar")


def _targets() -> Finding:
    from pathlib import Path

    from nscc.diagnostics.diagnostic import Rejected
    from nscc.target.load import builtin_names, load_target

    try:
        names = [load_target(name, Path()).name for name in builtin_names()]
    except Rejected as rejected:
        return WRONG, f"targets: {rejected}"
    return GOOD, f"targets: {', '.join(names)}"


def _cache() -> Finding:
    from nscc.cache.store import MOST_BYTES, Store, cache_folder

    folder = cache_folder()
    if folder is None:
        return ABSENT, "cache of search results: off (NSCC_CACHE=off, or no home folder)"
    store = Store(folder)
    if not store.writable():
        return ABSENT, f"cache of search results: {folder} cannot be written, so nothing is kept"
    held = f"{store.entries()} results, {store.bytes_used() / 1e6:.1f} of {MOST_BYTES / 1e6:.0f} MB"
    return GOOD, f"cache of search results: {folder} ({held}; remove the folder to clear it)"


def _loops() -> Finding:
    from nscc_runtime.emulator.loops import expose_block

    try:
        expose_block.load()
    except (ImportError, OSError, RuntimeError) as error:
        return WRONG, f"the emulator's loops do not compile: {error}"
    return GOOD, "the emulator's loops are compiled for this processor"


def _ports() -> Finding:
    if find_spec("serial") is None:
        return ABSENT, "serial ports: pyserial lists them"
    from nscc_runtime.device.port import list_ports

    ports = [name + described(text) for name, text in list_ports()]
    return GOOD, f"serial ports: {', '.join(ports) or 'none'}"


def described(text: str) -> str:
    """A port's description behind its name, where the system has one."""
    return f" ({text})" if text not in ("", "n/a") else ""


def _compiler() -> Finding:
    from nscc_runtime.device.firmware import compiler

    found = compiler()
    if found is None:
        return ABSENT, "C++ compiler: `nscc device serve` stands in with the firmware's twin"
    return GOOD, f"C++ compiler: {found} (nscc device serve runs the firmware)"
