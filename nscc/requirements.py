"""Which packages nscc asks for, and in which of its extras: as its own metadata says."""

from __future__ import annotations

import re
from functools import cache

_MODULES = {"cv2": "opencv-python-headless", "PIL": "pillow", "pillow_heif": "pillow-heif",
            "serial": "pyserial", "OpenEXR": "openexr", "pyxel": "pyxel-sim"}  # fmt: skip
"""Modules that are not named after the distribution that brings them."""

_REQUIREMENT = re.compile(
    r"""(?P<name>[\w.-]+)\s*(?:\[[\w,\s-]*\])?[^;]*(?:;.*\bextra\s*==\s*['"](?P<extra>[\w-]+)['"])?"""
)


@cache
def extras() -> dict[str, str]:
    """The smallest extra that brings each distribution, "" for what every installation has.

    Empty where this nscc was not installed, but runs from its sources.
    """
    from importlib import metadata

    try:
        asked = metadata.requires("nscc") or []
    except metadata.PackageNotFoundError:
        return {}
    names: dict[str, list[str]] = {}
    for text in asked:
        match = _REQUIREMENT.match(text)
        if match is not None:
            names.setdefault(match["extra"] or "", []).append(_normal(match["name"]))
    by_size = sorted(names, key=lambda extra: (extra != "", len(names[extra])))
    return {name: extra for extra in reversed(by_size) for name in names[extra]}


def distribution_of(module: str) -> str:
    """The name under which a module, or one inside of it, is installed."""
    top = module.partition(".")[0]
    return next((name for known, name in _MODULES.items() if known.lower() == top.lower()), top)


def module_of(distribution: str) -> str:
    """The module that a distribution brings."""
    names = {name: module for module, name in _MODULES.items()}
    return names.get(distribution, distribution.replace("-", "_"))


def install_line(extra: str) -> str:
    """What to type to have an extra."""
    return f"pip install 'nscc[{extra}]'" if extra else "pip install nscc"


def line_for(module: str) -> str:
    """What to type where that module is missing."""
    return install_line(extras().get(_normal(distribution_of(module)), "all"))


def _normal(name: str) -> str:
    """A distribution's name as all spellings of it are compared."""
    return re.sub(r"[-_.]+", "-", name).lower()
