"""What other distributions add to nscc: entry points, read only when somebody asks for them.

A distribution adds by its metadata alone, for example

    [project.entry-points."nscc.effects"]
    columns = "my_package.columns:COLUMNS"

and the table that holds nscc's own things of that kind takes what it finds as it takes its own:
whole, or refused by name.
"""

from __future__ import annotations

from collections.abc import Collection
from functools import cache
from typing import Any, Literal

from nscc.diagnostics.diagnostic import Rejected
from nscc.diagnostics.rejection import rejected

Group = Literal["nscc.commands", "nscc.decoders", "nscc.effects", "nscc.encodings", "nscc.targets"]


def added(group: Group, taken: Collection[str] = frozenset()) -> dict[str, Any]:
    """The objects that other distributions add to `group`, by name, in the order of their names.

    Raises Rejected (NS0905) where one cannot be imported, two have one name, or one has a name of
    `taken`, nscc's own.
    """
    found = _loaded(group)
    for name in found:
        if name in taken:
            raise unusable(group, name, "nscc has an object of that name")
    return {name: value for name, (value, _) in found.items()}


def sources(group: Group) -> dict[str, str]:
    """The names of the modules that those objects come from. Raises as `added` does."""
    return {name: module for name, (_, module) in _loaded(group).items()}


@cache
def _loaded(group: Group) -> dict[str, tuple[Any, str]]:
    """The objects by name, each with its module, loaded once."""
    # A fiftieth of a second, which commands that need no more than nscc's own do not spend.
    from importlib.metadata import entry_points

    found: dict[str, tuple[Any, str]] = {}
    for entry in sorted(entry_points(group=group), key=lambda each: (each.name, each.value)):
        if entry.name in found:
            raise unusable(group, entry.name, "another package provides an object of that name")
        try:
            found[entry.name] = entry.load(), entry.module
        except Exception as error:  # whatever a module of somebody else's raises
            reason = " ".join(str(error).split())[:200]
            raise unusable(group, entry.name, f"{type(error).__name__}: {reason}") from error
    return found


def unusable(group: Group, name: str, reason: str) -> Rejected:
    """NS0905: what a distribution adds under that name is not what nscc can take."""
    kind = group.removeprefix("nscc.").removesuffix("s")
    return rejected(
        "NS0905",
        f"the {kind} {name[:60]!a} of an installed package cannot be used",
        notes=(reason, f"it is an entry point of the group {group}"),
        helps=("repair or uninstall the package that provides it",),
    )
