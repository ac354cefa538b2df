"""Lazy imports: a module is imported when one of its names is first used."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from importlib import import_module
from typing import Any


class LazyFunctions:
    """Stands for the functions of a module, which is imported when one of them is first called.
    Arguments are passed on by position only."""

    def __init__(self, module: str) -> None:
        """Stand for the functions of a module that is not imported yet."""
        self._module = module

    def __getattr__(self, name: str) -> Any:
        """Return a function that, when called, imports the module and calls its function `name`."""
        return lambda *arguments: getattr(import_module(self._module), name)(*arguments)


def attribute(package: str, names: Mapping[str, Sequence[str]], name: str) -> Any:
    """Return the public attribute `name` of `package`, after importing its module.

    `names` has the public names by module. Raises AttributeError for an unknown name, and
    ModuleNotFoundError with an install command if a distribution is missing."""
    module = next((module for module, exported in names.items() if name in exported), None)
    if module is None:
        raise AttributeError(f"module '{package}' has no attribute '{name}'")
    with named_extra(f"{package}.{name}"):
        return getattr(import_module(f"{package}.{module}"), name)


@contextmanager
def named_extra(user: str) -> Iterator[None]:
    """Replace the error of a missing package, within a `with` block, by one with the command that
    installs it.

    The new ModuleNotFoundError says that `user` needs the package. The error of a missing module of
    nscc itself is raised as it is."""
    try:
        yield
    except ModuleNotFoundError as error:
        missing = error.name or ""
        if not missing or missing.startswith("nscc"):
            raise
        from nscc.requirements import distribution_of, line_for

        needed = f"{user} needs {distribution_of(missing)}: {line_for(missing)}"
        raise ModuleNotFoundError(needed, name=missing) from error
