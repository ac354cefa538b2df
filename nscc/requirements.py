"""The packages that nscc requires, by extra, from its metadata."""

from __future__ import annotations

import re
from functools import cache

_MODULES = {
    "cv2": "opencv-python-headless",
    "PIL": "pillow",
    "pillow_heif": "pillow-heif",
    "serial": "pyserial",
    "OpenEXR": "openexr",
    "pyxel": "pyxel-sim",
}
"""Distributions whose name differs from the name of their module, by module."""

_REQUIREMENT = re.compile(
    r"""(?P<name>[\w.-]+)\s*(?:\[[\w,\s-]*\])?[^;]*(?:;.*\bextra\s*==\s*['"](?P<extra>[\w-]+)['"])?"""
)


@cache
def extras() -> dict[str, str]:
    """Return for each distribution (package) the smallest extra of nscc that installs it, "" for
    required ones. Names are in normal form (PEP 503).

    The result is empty if nscc is not installed but runs from its sources."""
    from importlib import metadata

    try:
        lines = metadata.requires("nscc") or []
    except metadata.PackageNotFoundError:
        return {}
    names: dict[str, list[str]] = {}
    for text in lines:
        match = _REQUIREMENT.match(text)
        if match is not None:
            names.setdefault(match["extra"] or "", []).append(_normal(match["name"]))
    by_size = sorted(names, key=lambda extra: (extra != "", len(names[extra])))
    # Later entries replace earlier ones, so the smallest extra counts, and "" before all.
    return {name: extra for extra in reversed(by_size) for name in names[extra]}


def distribution_of(module: str) -> str:
    """Return the name of the distribution (package) that provides a module, which is often the
    module's own. A name with dots stands for its first part."""
    top = module.partition(".")[0]
    return next((name for known, name in _MODULES.items() if known.lower() == top.lower()), top)


def module_of(distribution: str) -> str:
    """Return the name of the module that a distribution (package) installs: a known exception, or
    its own name with _ for -."""
    names = {name: module for module, name in _MODULES.items()}
    return names.get(distribution, distribution.replace("-", "_"))


def install_line(extra: str) -> str:
    """Return the command that installs `extra`, a part of nscc with its packages; "" is nscc
    itself."""
    return f"pip install 'nscc[{extra}]'" if extra else "pip install nscc"


def installed_version(distribution: str) -> str:
    """Return the version of an installed distribution (package), "" if it is absent."""
    from importlib import metadata

    try:
        return metadata.version(distribution)
    except metadata.PackageNotFoundError:
        return ""


def line_for(module: str) -> str:
    """Return the command that installs the package of a module, with the extra of nscc that it
    belongs to, or `all` if it belongs to none."""
    return install_line(extras().get(_normal(distribution_of(module)), "all"))


def _normal(name: str) -> str:
    """Return a distribution's name in normal form (PEP 503), so that names can be compared."""
    return re.sub(r"[-_.]+", "-", name).lower()
