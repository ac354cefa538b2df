"""The public names of a package, each imported from its module when it is first asked for."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from importlib import import_module
from typing import Any


def attribute(package: str, names: Mapping[str, Sequence[str]], name: str) -> Any:
    """What a package's `__getattr__` gives: `names` are its public ones by their modules.

    AttributeError for a name that is none of them, ModuleNotFoundError with what to type where
    another distribution is missing.
    """
    module = next((module for module, exported in names.items() if name in exported), None)
    if module is None:
        raise AttributeError(f"module '{package}' has no attribute '{name}'")
    try:
        return getattr(import_module(f"{package}.{module}"), name)
    except ModuleNotFoundError as error:
        missing = error.name or ""
        if not missing or missing.startswith("nscc"):
            raise
        from nscc.requirements import distribution_of, line_for

        needed = f"{package}.{name} needs {distribution_of(missing)}: {line_for(missing)}"
        raise ModuleNotFoundError(needed, name=missing) from error
