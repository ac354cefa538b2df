"""The kinds of programs, and the objects that do in each package what a kind needs.

The shutters of a program depend on the code of a pixel only, unless it is of a kind that changes
this. Each package has a table with a class for each kind, and a base class for fixed shutters. The
tables allow combinations of kinds, but the compiler refuses all of them so far (NS0510, NS0538,
NS0539). Few other files ask of which kind a program is."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache
from importlib import import_module
from typing import TYPE_CHECKING, Generic, Protocol, TypeVar

if TYPE_CHECKING:
    from nscc.chips.target import Target
    from nscc.words.machine import StateMachine
    from nscc.words.pictures import Pictures


class HasKind(Protocol):
    """What has a kind: a program, or its container (a compiled program)."""

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
}
"""For each kind, whether a program is of this kind; a kind comes before those that it changes."""

Base = TypeVar("Base")


class KindTable(Generic[Base]):
    """The classes with which one package treats each kind of program (`images`, `looks`, `stream`).

    `base` is for fixed shutters; the others are given by kind as "module:class" and imported on
    first use. A kind that this package does not treat differently is left out."""

    def __init__(self, base: type[Base], **classes: str) -> None:
        """Store the class for fixed shutters, and for each kind the place of its class,
        "module:class"."""
        self._base, self._classes = base, classes
        self._combined = cache(self._combine)

    def of(self, program: HasKind) -> Base:
        """Return the object that treats a program, or a container (a compiled program), of any
        combination of kinds. Programs of the same combination share the object."""
        kinds = (kind for kind, belongs in _BELONGS.items() if belongs(program))
        return self._combined(*(self._classes[kind] for kind in kinds if kind in self._classes))

    def _combine(self, *class_paths: str) -> Base:
        """Return an instance of a new class that inherits from the classes `class_paths`,
        "module:class", and the base.

        The first class comes first when methods are looked up."""
        split = (class_path.split(":") for class_path in class_paths)
        classes = [getattr(import_module(module), name) for module, name in split]
        combined: type[Base] = type("Combined", (*classes, self._base), {})
        return combined()
