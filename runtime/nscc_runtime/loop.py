"""Compiled loops: a function's annotated signature says what its machine code is given.

    @record
    class Sizes:
        pixels: int
        factor: float

    @loop
    def scaled(sizes: Sizes, lanes: Annotated[Ints, "pixels"], out: Written[Floats]) -> None:
        for p in range(sizes.pixels):
            out[p] = sizes.factor * lanes[p]

    scaled(sizes=Sizes(pixels=9, factor=0.5), lanes=lanes, out=out)

Arrays that belong together are one parameter: a NamedTuple, whose fields are annotated as arrays
are.

From that one declaration numba learns the types, and every call its order and what to check: an
array's type, that it is contiguous, that it may be written where it is `Written`, and, where the
declaration names its axes, its shape. Loops are called by name only.

In a loop an array is a bare pointer: flat whatever its shape, and without bounds. A loop allocates
nothing and raises nothing, and calls only functions that are `compiled` or `inlined`. Importing a
module of loops does not import numba; compiling does (see `nscc_runtime.machine_code`).
"""

from __future__ import annotations

import ctypes
import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import cached_property, partial
from pathlib import Path
from types import CodeType, FunctionType, ModuleType
from typing import (
    Annotated,
    Any,
    Generic,
    ParamSpec,
    TypeVar,
    cast,
    dataclass_transform,
    get_type_hints,
)

import numpy as np
from numpy.typing import NDArray

from nscc_runtime import machine_code
from nscc_runtime.loop_given import WRITTEN, ArrayGroup, LoopParameter, numba_kinds, parameter_of

_P = ParamSpec("_P")
_T = TypeVar("_T")
_F = TypeVar("_F", bound=Callable[..., object])

Ints = NDArray[np.int64]
Ints32 = NDArray[np.int32]
Words = NDArray[np.uint64]
Floats = NDArray[np.float64]
Floats32 = NDArray[np.float32]
Bytes = NDArray[np.uint8]

Written = Annotated[_T, WRITTEN]
"""An array that the loop writes."""

_FIELDS: dict[type, Any] = {
    int: ctypes.c_int64,
    float: ctypes.c_double,
    np.uint64: ctypes.c_uint64,
}


@dataclass_transform(kw_only_default=True)
def record(cls: type[_T]) -> type[_T]:
    """A class of annotated fields (int, float or np.uint64) as a record that a loop reads.

    Made by the names of all its fields; in a loop they are int64, float64 and uint64. An array of
    records has the dtype np.dtype(cls): `Annotated[NDArray[Any], cls]` in a loop's signature.
    """
    fields = {name: _FIELDS[kind] for name, kind in get_type_hints(cls).items()}

    def init(self: Any, **values: Any) -> None:
        if values.keys() != fields.keys():
            raise TypeError(f"{cls.__name__}: {_unlike(fields, values)}")
        ctypes.Structure.__init__(self, **values)

    body = {
        "_fields_": [*fields.items()],
        "__init__": init,
        "__doc__": cls.__doc__,
        "__module__": cls.__module__,
    }
    return cast("type[_T]", type(cls.__name__, (ctypes.Structure,), body))


def compiled(function: _F) -> _F:
    """A function that compiled loops may call."""
    return cast(_F, _LoopFunction(cast(FunctionType, function), _jitted))


def inlined(function: _F) -> _F:
    """The same, made part of each loop that calls it: LLVM makes vectors of no other calls."""
    return cast(_F, _LoopFunction(cast(FunctionType, function), partial(_jitted, forceinline=True)))


def table(make: Callable[[], _T]) -> _T:
    """An array of constants that loops read by the global name it is given; made when compiled."""
    return cast(_T, _LoopFunction(cast(FunctionType, make), lambda function: function()))


def loop(function: Callable[_P, None]) -> Loop[_P]:
    """The loop that a function declares: one of the object file of its module."""
    return Loop(cast(FunctionType, function))


class Loop(Generic[_P]):
    """A loop as machine code: read from its module's object file, or compiled on first use."""

    def __init__(self, function: FunctionType) -> None:
        self.function, self.__doc__ = function, function.__doc__
        self.name, self.module = function.__name__, function.__module__
        object_file(self.module).loops.append(self)

    def __call__(self, *args: _P.args, **values: _P.kwargs) -> None:
        """Run it. Drops the GIL. Raises TypeError for what the declaration does not allow."""
        if args:
            raise TypeError(f"{self.name} takes what it is given by name")
        if values.keys() != self.parameters.keys():
            raise TypeError(f"{self.name}: {_unlike(self.parameters, values)}")
        axes: dict[str, int] = {}
        self.entry(*[a for n, p in self.parameters.items() for a in p.addresses(values[n], axes)])

    def bound(self, **values: Any) -> Bound:
        """The loop with some of its parameters checked and given."""
        return Bound(self, values)

    def is_compiled(self) -> bool:
        """Whether the machine code is there: if not, its first use takes some seconds."""
        return "linked" in vars(object_file(self.module)) or self.is_kept()

    def is_kept(self) -> bool:
        """Whether a file holds the machine code, for other runs too."""
        file = object_file(self.module)
        return machine_code.read_object_file(file.name, file.folders) is not None

    def compiling(self, subject: str) -> str:
        """Return a line which says that `subject` is compiled, and whether it is kept."""
        if machine_code.can_keep(object_file(self.module).folders):
            return f"compiling {subject} for this processor: once, some seconds"
        return ("compiling loops: some seconds in every run, because no cache folder can be "
                "written; XDG_CACHE_HOME names one")  # fmt: skip

    def load(self) -> None:
        """Have the machine code ready, compiled if need be."""
        object_file(self.module).linked  # noqa: B018  # made when it is asked for

    @cached_property
    def parameters(self) -> dict[str, LoopParameter | ArrayGroup]:
        """What it is given, in order."""
        hints = get_type_hints(self.function, include_extras=True)
        parameters = [parameter_of(name, hints[name]) for name in hints if name != "return"]
        axes = {
            name
            for parameter in parameters
            for array in parameter.arrays
            for name, _ in array.axes or ()
        }
        return {parameter.name: parameter.sized(axes) for parameter in parameters}

    @property
    def takes(self) -> int:
        """How many addresses its machine code takes."""
        return sum(len(parameter.arrays) for parameter in self.parameters.values())

    @cached_property
    def entry(self) -> Callable[..., None]:
        """The machine code, which checks nothing; takes addresses."""
        return object_file(self.module).linked[self.name]


class Bound:
    """A loop that has been given some of its parameters; see `Loop.bound`."""

    def __init__(self, bound_loop: Loop[Any], values: dict[str, Any]) -> None:
        self._loop = bound_loop
        self._values = values  # what is given lives as long as its address
        self._axes: dict[str, int] = {}
        self._open = {
            name: parameter
            for name, parameter in bound_loop.parameters.items()
            if name not in values
        }
        if len(values) + len(self._open) != len(bound_loop.parameters):
            raise TypeError(f"{bound_loop.name}: {_unlike(bound_loop.parameters, values)}")
        self._addresses: dict[str, Sequence[int]] = dict.fromkeys(bound_loop.parameters, ())
        for name, value in values.items():
            self._addresses[name] = bound_loop.parameters[name].addresses(value, self._axes)

    def __call__(self, **values: Any) -> None:
        """Run the loop with the rest of its parameters; see `Loop.__call__`."""
        if self._open.keys() != values.keys():
            raise TypeError(f"{self._loop.name}: {_unlike(self._open, values)}")
        addresses, axes = self._addresses.copy(), self._axes.copy()
        for name, parameter in self._open.items():
            addresses[name] = parameter.addresses(values[name], axes)
        self._loop.entry(
            *[
                address
                for parameter_addresses in addresses.values()
                for address in parameter_addresses
            ]
        )


@dataclass(frozen=True)
class ObjectFile:
    """The machine code of a module's loops.

    It lies in `__pycache__` beside the module or, where that cannot be written, in the user's cache
    folder, under a digest of all that it depends on.
    """

    module: str
    loops: list[Loop[Any]] = field(default_factory=list)

    def code(self) -> bytes:
        """The object code, read or compiled."""

        def build() -> bytes:
            from nscc_runtime.loop_types import signature

            return machine_code.build(
                (
                    _for_numba(module_loop.function),
                    signature(map(numba_kinds, module_loop.parameters.values())),
                )
                for module_loop in self.loops
            )

        return machine_code.object_code(self.name, self.folders, build)

    @cached_property
    def linked(self) -> dict[str, Callable[..., None]]:
        """The loops of this process, by name."""
        return machine_code.load(self.code(), {e.name: e.takes for e in self.loops})

    @cached_property
    def name(self) -> str:
        """The file's name."""
        known: dict[FunctionType, str] = {}
        for module_loop in self.loops:
            _depend(module_loop.function, known)
        parameter_texts = [repr([*module_loop.parameters.values()]) for module_loop in self.loops]
        stem = "-".join(self.module.split(".")[-2:])
        return machine_code.name(stem, [*known.values(), *parameter_texts])

    @property
    def folders(self) -> tuple[Path, ...]:
        """Where it may lie, best first."""
        return machine_code.folders(cast(str, sys.modules[self.module].__file__))


_FILES: dict[str, ObjectFile] = {}


def object_file(module: str) -> ObjectFile:
    """The object file of a module that has been imported."""
    return _FILES.setdefault(module, ObjectFile(module))


@dataclass(frozen=True, eq=False)
class _LoopFunction:
    """A function or a table for loops: what numba knows of it is made when it is needed."""

    function: FunctionType
    for_loops: Callable[[FunctionType], Any]

    @cached_property
    def for_numba(self) -> Any:
        return self.for_loops(self.function)

    def __call__(self, *values: Any) -> Any:
        return self.for_numba(*values)


def _jitted(function: FunctionType, **options: Any) -> Any:
    import numba

    return numba.njit(nogil=True, error_model="numpy", **options)(_for_numba(function))


def _for_numba(function: FunctionType) -> FunctionType:
    """A function whose globals are what numba knows."""
    names, code = function.__globals__, function.__code__
    loop_globals = {
        name: value.for_numba
        for name in code.co_names
        if isinstance(value := names.get(name), _LoopFunction)
    }
    return FunctionType(code, {**names, **loop_globals}, function.__name__)


def _depend(function: FunctionType, known: dict[FunctionType, str]) -> None:
    """Add to `known` what machine code of a function depends on: code, constants, functions."""
    if function in known:
        return
    known[function] = ""
    texts = []
    for code in _codes(function.__code__):
        plain = [value for value in code.co_consts if not isinstance(value, CodeType)]
        texts += [code.co_code.hex(), repr((plain, code.co_names, code.co_varnames))]
        for name in code.co_names:
            value = function.__globals__.get(name)
            if isinstance(value, _LoopFunction):
                value = value.function
            if isinstance(value, FunctionType):
                _depend(value, known)
            elif isinstance(value, np.ndarray):
                texts.append(value.tobytes().hex())
            elif not isinstance(value, ModuleType | type):
                texts.append(repr(value))
    known[function] = "\n".join(texts)


def _codes(code: CodeType) -> Iterator[CodeType]:
    yield code
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield from _codes(constant)


def _unlike(names_expected: Iterable[str], names_given: Iterable[str]) -> str:
    """Which names are missing, and which are not known."""
    names_by_problem = {
        "lacks": {*names_expected} - {*names_given},
        "does not take": {*names_given} - {*names_expected},
    }
    return "; ".join(
        f"{word} {', '.join(sorted(names))}" for word, names in names_by_problem.items() if names
    )
