"""Compiled loops: the annotated signature of a function declares the arguments of its machine code.

    @record
    class Sizes:
        pixels: int
        factor: float

    @loop
    def scaled(sizes: Sizes, lanes: Annotated[Ints, "pixels"], out: Written[Floats]) -> None:
        for p in range(sizes.pixels):
            out[p] = sizes.factor * lanes[p]

    scaled(sizes=Sizes(pixels=9, factor=0.5), lanes=lanes, out=out)

Several arrays can be one parameter: a NamedTuple whose fields are annotated like arrays.

numba takes the types from this declaration. Every call takes the order of arguments from it, and
checks each array: its type, that it is contiguous, that it may be modified if it is `Written`, and
its shape if the declaration names its axes. Loops are called with keyword arguments only.

In a loop an array is a bare pointer, flat for any shape and without bounds. A loop allocates no
memory, raises no exceptions, and calls only functions that are `compiled` or `inlined`. Importing a
module of loops does not import numba; compiling does (see `nscc_runtime.machine_code`)."""

from __future__ import annotations

import ctypes
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping
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

from nscc.lazy import named_extra
from nscc_runtime import machine_code
from nscc_runtime.loop_given import (
    WRITTEN,
    ArrayGroup,
    LoopParameter,
    checks_of,
    parameter_of,
)

_P = ParamSpec("_P")
_T = TypeVar("_T")
_F = TypeVar("_F", bound=Callable[..., object])

Words = NDArray[np.uint64]

Written = Annotated[_T, WRITTEN]
"""An array that the loop modifies."""

_FIELDS: dict[type, Any] = {
    int: ctypes.c_int64,
    float: ctypes.c_double,
    np.uint64: ctypes.c_uint64,
}


@dataclass_transform(kw_only_default=True)
def record(cls: type[_T]) -> type[_T]:
    """Turn a class of annotated fields (int, float or np.uint64) into a record that a loop reads.

    It is constructed with keyword arguments for all its fields; missing or other names raise
    TypeError. In a loop the fields are int64, float64 and uint64. An array of records has the dtype
    np.dtype(cls), and `Annotated[NDArray[Any], cls]` in a loop's signature."""
    fields = {name: _FIELDS[kind] for name, kind in get_type_hints(cls).items()}

    def init(self: Any, **values: Any) -> None:
        """Set all fields from `values` by name; raise TypeError for missing or unknown names, or
        values that are not numbers."""
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
    """Mark a function that compiled loops may call. Called from Python, it compiles itself first,
    which takes a moment and needs numba."""
    return cast(_F, _LoopFunction(cast(FunctionType, function), _jitted))


def inlined(function: _F) -> _F:
    """Mark a function that is inlined into loops, because LLVM vectorises only inlined calls. It
    may also be called from Python, where it compiles itself first."""
    return cast(_F, _LoopFunction(cast(FunctionType, function), partial(_jitted, forceinline=True)))


def table(make: Callable[[], _T]) -> _T:
    """Declare an array of constants for loops: `make` returns it. It is called when a loop that
    names the array is compiled, so its values become part of the machine code."""
    return cast(_T, _LoopFunction(cast(FunctionType, make), lambda function: function()))


def loop(function: Callable[_P, None]) -> Loop[_P]:
    """Declare a compiled loop, which becomes part of the object file of its module. `function` must
    fulfil the conditions of this module's docstring; they are checked when the loop is compiled."""
    return Loop(cast(FunctionType, function))


class Loop(Generic[_P]):
    """A loop as machine code, read from its module's object file or compiled on first use. It is
    called like the function, with keyword arguments."""

    def __init__(self, function: FunctionType) -> None:
        """Add `function` to the loops of its module, which are compiled together."""
        self.function, self.__doc__ = function, function.__doc__
        self.name, self.file = function.__name__, object_file(function.__module__)
        self.file.loops.append(self)

    def __call__(self, *args: _P.args, **values: _P.kwargs) -> None:
        """Run the loop without the GIL, with all arguments by name. Raises TypeError for
        positional, missing or unknown arguments, and for arrays of another type or shape than
        declared."""
        if args:
            raise TypeError(f"{self.name} takes what it is given by name")
        if values.keys() != self.parameters.keys():
            raise TypeError(f"{self.name}: {_unlike(self.parameters, values)}")
        if machine_code.IN_WEB:
            values.update({n: p.widened(values[n]) for n, p in self.parameters.items()})
        self.entry(*self.checks(values))

    def is_compiled(self) -> bool:
        """Return whether the machine code exists; otherwise the first use takes some seconds."""
        return "linked" in vars(self.file) or self.is_kept()

    def is_kept(self) -> bool:
        """Return whether a file with the machine code exists, which other runs can use."""
        if machine_code.IN_WEB:
            return True
        return machine_code.read_object_file(self.file.name, self.file.folders) is not None

    def compiling(self, subject: str) -> str:
        """Return a message, without a final stop, that `subject` is compiled once, or, if no cache
        folder can be written, that loops are compiled in every run."""
        if machine_code.can_keep(self.file.folders):
            return f"compiling {subject} for this processor: once, some seconds"
        return (
            "compiling loops: some seconds in every run, because no cache folder can be "
            "written; XDG_CACHE_HOME names one"
        )

    def load(self) -> None:
        """Load the machine code of all loops of the module, compiling it if necessary, so that the
        first call does not have to wait."""
        self.file.linked  # noqa: B018  # computes the cached property

    @cached_property
    def parameters(self) -> dict[str, LoopParameter | ArrayGroup]:
        """The declared parameters by name, in the order of the function's arguments."""
        hints = get_type_hints(self.function, include_extras=True)
        return {name: parameter_of(name, hints[name]) for name in hints if name != "return"}

    @cached_property
    def checks(self) -> Callable[[Mapping[str, Any]], list[int]]:
        """The function that checks arguments and returns their addresses (`checks_of`)."""
        return checks_of(self.parameters)

    @cached_property
    def entry(self) -> Callable[..., None]:
        """The machine code as a function of the addresses of all arrays and records, in the order
        of `parameters`; it checks nothing."""
        return self.file.linked[self.name]


@dataclass(frozen=True)
class ObjectFile:
    """The machine code of a module's loops.

    It is stored in `__pycache__` beside the module or, if that is not writable, in the user's cache
    folder. Its name contains a digest of everything that it depends on."""

    module: str
    loops: list[Loop[Any]] = field(default_factory=list)

    def code(self) -> bytes:
        """Return the object code, read from a file or, if no folder has an intact one, compiled and
        stored."""
        return machine_code.object_code(self.name, self.folders, self.build)

    def build(self, for_web: bool = False) -> bytes:
        """Compile the loops to object code for this processor, or with `for_web` for WebAssembly,
        and return it. Raises RuntimeError if a loop calls a function that is neither compiled nor
        inlined."""
        from nscc_runtime.loop_types import signature

        loops = (
            (_for_numba(module_loop.function), signature(module_loop.parameters.values()))
            for module_loop in self.loops
        )
        return machine_code.build(loops, for_web)

    @cached_property
    def linked(self) -> dict[str, Callable[..., None]]:
        """The compiled loops as functions of this process, by name; computed at the first use. They
        take addresses and check nothing."""
        takes = {e.name: sum(len(p.arrays) for p in e.parameters.values()) for e in self.loops}
        if machine_code.IN_WEB:
            return machine_code.load_in_web(takes)
        with named_extra("the emulator"):
            return machine_code.load(self.code(), takes)

    @cached_property
    def name(self) -> str:
        """The name of the object file, which contains a digest of everything that its code
        depends on."""
        known: dict[FunctionType, str] = {}
        for module_loop in self.loops:
            _depend(module_loop.function, known)
        parameter_texts = [
            f"{module_loop.name} {[*module_loop.parameters.values()]}" for module_loop in self.loops
        ]
        stem = "-".join(self.module.split(".")[-2:])
        return machine_code.name(stem, [*known.values(), *parameter_texts])

    @property
    def folders(self) -> tuple[Path, ...]:
        """The folders in which the file may be, in order of preference; they need not exist."""
        return machine_code.folders(cast(str, sys.modules[self.module].__file__))


_FILES: dict[str, ObjectFile] = {}


def object_file(module: str) -> ObjectFile:
    """Return the object file of the module with the full name `module`, the same for each call. It
    has the loops that the module has declared so far."""
    return _FILES.setdefault(module, ObjectFile(module))


@dataclass(frozen=True, eq=False)
class _LoopFunction:
    """A function or a table for loops. `for_loops` makes its form for numba from `function`, when
    it is first needed."""

    function: FunctionType
    for_loops: Callable[[FunctionType], Any]

    @cached_property
    def for_numba(self) -> Any:
        """The form of the function, or the array, that numba's code uses; made once."""
        return self.for_loops(self.function)

    def __call__(self, *values: Any) -> Any:
        """Call the function from Python, compiled; a table cannot be called."""
        return self.for_numba(*values)


def _jitted(function: FunctionType, **options: Any) -> Any:
    """Return `function` as one that numba compiles when it is called first, without the GIL and
    with numpy's rules for division by 0. `options` are numba's."""
    import numba

    return numba.njit(nogil=True, error_model="numpy", **options)(_for_numba(function))


def _for_numba(function: FunctionType) -> FunctionType:
    """Return a copy of `function` in which those globals that are `compiled`, `inlined` or a
    `table` are replaced by their forms for numba."""
    names, code = function.__globals__, function.__code__
    loop_globals = {
        name: value.for_numba
        for name in code.co_names
        if isinstance(value := names.get(name), _LoopFunction)
    }
    return FunctionType(code, {**names, **loop_globals}, function.__name__)


def _depend(function: FunctionType, known: dict[FunctionType, str]) -> None:
    """Add to `known`, by function, a text of all code and constants on which the machine code of
    `function` depends, and the same for all functions that it calls. Those in `known` are
    skipped."""
    if function in known:
        return
    known[function] = ""  # a mark, so that functions that call each other end
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
    """Yield the code object `code` and all those nested in it, such as that of an expression with
    `for`."""
    yield code
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield from _codes(constant)


def _unlike(names_expected: Iterable[str], names_given: Iterable[str]) -> str:
    """Return the difference of expected and given names as text, such as "lacks a, b; does not take
    c"; "" if they agree."""
    names_by_problem = {
        "lacks": {*names_expected} - {*names_given},
        "does not take": {*names_given} - {*names_expected},
    }
    return "; ".join(
        f"{word} {', '.join(sorted(names))}" for word, names in names_by_problem.items() if names
    )
