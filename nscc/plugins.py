"""Plugins: entry points of other distributions, loaded on first use.

A distribution declares a plugin in its metadata, for example

    [project.entry-points."nscc.effects"]
    columns = "my_package.columns:COLUMNS"

nscc checks the object like a built-in one of the same kind and uses it, or refuses it in a message
that names it."""

from __future__ import annotations

from collections.abc import Collection
from functools import cache
from typing import Any, Literal

from nscc.diagnostics.diagnostic import Rejected, rejected
from nscc.mappings import NamedValues

Group = Literal[
    "nscc.commands",
    "nscc.decoders",
    "nscc.effects",
    "nscc.encodings",
    "nscc.measurements",
    "nscc.targets",
]


def added(group: Group, reserved: Collection[str] = frozenset()) -> NamedValues:
    """Return the objects that other packages add to the entry-point group, by name and sorted by
    it.

    Raises Rejected (NS0905) if an object cannot be imported, and for a name that is `reserved` or
    used twice."""
    loaded = _loaded(group)
    for name in loaded:
        if name in reserved:
            raise unusable(group, name, "nscc has an object of that name")
    return {name: value for name, (value, _) in loaded.items()}


def sources(group: Group) -> dict[str, str]:
    """Return the modules that define the objects which other packages add to the group, by name of
    the object.

    Raises Rejected (NS0905) if an object cannot be imported, or two have one name."""
    return {name: module for name, (_, module) in _loaded(group).items()}


@cache
def _loaded(group: Group) -> dict[str, tuple[Any, str]]:
    """Return the objects of an entry-point group by name, each with the module that it comes from.

    They are loaded once. Raises Rejected (NS0905) if one cannot be imported, or two have one name.
    """
    # Importing takes 20 ms, which commands without plugins should not spend.
    from importlib.metadata import entry_points

    objects: dict[str, tuple[Any, str]] = {}
    for entry in sorted(entry_points(group=group), key=lambda point: (point.name, point.value)):
        if entry.name in objects:
            raise unusable(group, entry.name, "another package provides an object of that name")
        try:
            objects[entry.name] = entry.load(), entry.module
        except Exception as error:  # any exception of another package
            reason = " ".join(str(error).split())[:200]
            raise unusable(group, entry.name, f"{type(error).__name__}: {reason}") from error
    return objects


def unusable(group: Group, name: str, reason: str) -> Rejected:
    """Return the exception (NS0905) that an object of an installed package cannot be used, for
    `reason`, which becomes a note.

    `name` and `group` are those of its entry point."""
    kind = group.removeprefix("nscc.").removesuffix("s")
    return rejected(
        "NS0905",
        f"the {kind} {name[:60]!a} of an installed package cannot be used",
        notes=(reason, f"it is an entry point of the group {group}"),
        helps=("repair or uninstall the package that provides it",),
    )
