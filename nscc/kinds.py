"""The kinds of programs, and the objects that do in each package what a kind needs.

Every program has shutters. A program with nothing else is of the kind "fixed": its shutters depend
on the code of a pixel only. Other kinds change or add something, and they combine: a program can
have images and pixels that look. Each package has a table with a class for each kind. The class of
"fixed" is the base of the others. No other file asks of which kind a program is."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache
from importlib import import_module
from typing import TYPE_CHECKING, Any, Generic, Protocol, TypeVar, cast

if TYPE_CHECKING:
    from nscc.chips.target import Target
    from nscc.words.machine import StateMachine
    from nscc.words.pictures import Pictures


class HasKind(Protocol):
    """What has a kind: a program, or its container."""

    @property
    def target(self) -> Target: ...
    @property
    def machine(self) -> StateMachine: ...
    @property
    def pictures(self) -> Pictures: ...


_BELONGS: Mapping[str, Callable[[HasKind], bool]] = {
    "images": lambda program: bool(program.pictures.outputs),
    "looks": lambda program: program.machine.stages > 0,
    "stream": lambda program: program.target.kind == "stream",
    "fixed": lambda _program: True,
}
"""For each kind, whether a program is of this kind; a kind comes before those that it changes."""

Kind = TypeVar("Kind")


class KindTable(Generic[Kind]):
    """The classes of one package, by kind, as "module:class".

    A kind that this package does not treat differently is not in its table. Modules are imported on
    first use."""

    def __init__(self, **classes: str) -> None:
        self._classes = classes
        self._of_names = cache(self._combined)

    def of(self, program: HasKind) -> Kind:
        """Return the object for a program, or a container, of any combination of kinds."""
        names = (name for name in self._classes if _BELONGS[name](program))
        return self._of_names(tuple(sorted(names, key=list(_BELONGS).index)))

    def _combined(self, names: tuple[str, ...]) -> Kind:
        """Return an instance of a class whose methods are those of the first kind that has them."""
        places = (self._classes[name].partition(":") for name in names)
        classes = [getattr(import_module(module), name) for module, _, name in places]
        combined: Any = type("".join(each.__name__ for each in classes), tuple(classes), {})
        return cast(Kind, combined())
