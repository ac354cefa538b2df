"""The parameters of compiled loops, and the checks of their arguments (see `nscc_runtime.loop`)."""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Annotated, Any, get_args, get_origin, get_type_hints

import numpy as np

from nscc.mappings import NamedValues
from nscc.words.stored_arrays import number_type

WRITTEN = object()
"""The annotation of an array that a loop modifies."""

_DATA = object.__basicsize__
"""Offset of the data address in an array object: in numpy's C interface it is the first field after
the object header. Other ways to get the address take four times as long."""
_IN_ROWS, _WRITEABLE = 0x101, 0x400
"""Flags of an array that is contiguous row after row and aligned, and of one that may be written.
"""


@dataclass(frozen=True)
class LoopParameter:
    """A parameter of a loop: a record, or an array of numbers or of records.

    `axes`: name and surplus of each axis, None to accept any shape. All axes of one name must have
    equal lengths, in all arrays, and equal the field of that name in a record."""

    name: str
    kind: np.dtype[Any]
    record: type[ctypes.Structure] | None = None
    written: bool = False
    axes: tuple[tuple[str, int], ...] | None = None

    @classmethod
    def of(cls, name: str, hint: Any) -> LoopParameter:
        """Return the parameter called `name` that the annotation `hint` declares: a record's class;
        or an array's type, alone or `Annotated` with a record's class, WRITTEN, and a text with the
        names of its axes such as "buckets pixels+1"."""
        hint, *notes = get_args(hint) if get_origin(hint) is Annotated else (hint,)
        if not get_origin(hint):
            return cls(name, np.dtype(hint), hint)
        records = [note for note in notes if isinstance(note, type)]
        axes = [tuple(map(_axis, note.split())) for note in notes if isinstance(note, str)]
        return cls(
            name,
            np.dtype(records[0] if records else number_type(hint)),
            written=WRITTEN in notes,
            axes=axes[0] if axes else None,
        )

    @property
    def arrays(self) -> tuple[LoopParameter, ...]:
        """The parameters that are passed as separate addresses: only this one."""
        return (self,)

    def widened(self, value: Any) -> Any:
        """Return the argument `value`; an array of numpy's indices as int64 if the parameter is of
        this type, because they have 32 bits in WebAssembly. An array that the loop modifies is not
        copied, so `checks_of` refuses it."""
        is_index = isinstance(value, np.ndarray) and value.dtype == np.intp
        wide = is_index and self.kind == np.int64 and not self.written
        return value.astype(np.int64, copy=False) if wide else value


@dataclass(frozen=True)
class ArrayGroup:
    """Several arrays that are one argument of a loop: `kind` is the class of the NamedTuple,
    `arrays` describes its fields in order. Machine code receives the address of each array."""

    name: str
    kind: type[tuple[Any, ...]]
    arrays: tuple[LoopParameter, ...]

    def widened(self, value: Any) -> Any:
        """Return the NamedTuple `value` with arrays of numpy's indices as int64 where the loop
        takes these, because they have 32 bits in WebAssembly."""
        arrays = zip(self.arrays, value, strict=True)
        return self.kind(*(parameter.widened(array) for parameter, array in arrays))


def parameter_of(name: str, hint: Any) -> LoopParameter | ArrayGroup:
    """Return the parameter `name` that the annotation `hint` declares: an array or a record, or a
    group of arrays if it is a NamedTuple's class."""
    if not (isinstance(hint, type) and issubclass(hint, tuple)):
        return LoopParameter.of(name, hint)
    fields = get_type_hints(hint, include_extras=True).items()
    return ArrayGroup(
        name, hint, tuple(LoopParameter.of(f"{name}.{n}", field_hint) for n, field_hint in fields)
    )


def checks_of(
    parameters: Mapping[str, LoopParameter | ArrayGroup],
) -> Callable[[Mapping[str, Any]], list[int]]:
    """Return a function that checks the arguments of `parameters`, both by name, and returns the
    addresses of all arrays and records in order.

    It raises TypeError for another type, an array that is not contiguous or may not be written but
    is to be, and for other numbers or lengths of axes. A loop has up to 50 arrays, so the checks
    are one function without calls, made for the loop."""
    lines, addresses, known = ["def addresses(values):"], list[str](), set[str]()
    arrays_taken = [array for parameter in parameters.values() for array in parameter.arrays]
    axis_names = {axis for array in arrays_taken for axis, _ in array.axes or ()}
    names: NamedValues = {
        "Array": np.ndarray,
        "at": ctypes.c_void_p.from_address,
        "of": ctypes.addressof,
        "kind": _kind,
    }

    def refuse(wrong: str, message: str) -> None:
        """Add a check that raises a TypeError with `message`, the inside of an f-string, if the
        condition `wrong` is true."""
        lines.append(f'    if {wrong}: raise TypeError(f"{message}")')

    def have_length(name: str, axis: str, length: str) -> None:
        """Add a check that the expression `length` equals other lengths of `axis`."""
        lines.append(f"    length = {length}")
        if axis in known:
            unequal = f"{name} has {{length}} {axis}, others have {{x{axis}}}"
            refuse(f"x{axis} != length", unequal)
        else:
            known.add(axis)
            lines.append(f"    x{axis} = length")

    def have_type(name: str, value: str, kind: type) -> None:
        """Add a check that the variable `value` is exactly of the type `kind`."""
        names[f"T{value}"] = kind
        refuse(
            f"type({value}) is not T{value}", f"{name} is {{kind({value})}}, not {kind.__name__}"
        )

    def lie_in_memory(array: LoopParameter, value: str) -> None:
        """Add the checks of the variable `value` as an array, and its address."""
        name, names[f"K{value}"] = array.name, array.kind
        # Equal types are usually one object.
        other = f"{value}.dtype is not K{value} and {value}.dtype != K{value}"
        unlike = f"{name} is {{kind({value})}}, not an array of {{K{value}}}"
        refuse(f"not isinstance({value}, Array) or ({other})", unlike)
        lines.append(f"    flags = {value}.flags.num")
        refuse(
            f"flags & {_IN_ROWS} != {_IN_ROWS}", f"{name} does not lie in one piece, row after row"
        )
        if array.written:
            refuse(f"not flags & {_WRITEABLE}", f"{name} is to be written, and is read-only")
        if array.axes is not None:
            axes = len(array.axes)
            refuse(f"{value}.ndim != {axes}", f"{name} has {{{value}.ndim}} axes, not {axes}")
        for index, (axis, extra) in enumerate(array.axes or ()):
            have_length(name, axis, f"{value}.shape[{index}] - {extra}")
        addresses.append(f"at(id({value}) + {_DATA}).value or 0")

    for number, (name, parameter) in enumerate(parameters.items()):
        value = f"v{number}"
        lines.append(f"    {value} = values[{name!r}]")
        if isinstance(parameter, ArrayGroup):
            have_type(name, value, parameter.kind)
            arrays = [f"{value}_{index}" for index in range(len(parameter.arrays))]
            lines.append(f"    {', '.join(arrays)}, = {value}")
            for array, variable in zip(parameter.arrays, arrays, strict=True):
                lie_in_memory(array, variable)
        elif parameter.record is None:
            lie_in_memory(parameter, value)
        else:
            have_type(name, value, parameter.record)
            for axis in parameter.kind.names or ():
                if axis in axis_names:
                    have_length(name, axis, f"{value}.{axis}")
            addresses.append(f"of({value})")
    lines.append(f"    return [{', '.join(addresses)}]")
    exec("\n".join(lines), names)
    checks: Callable[[Mapping[str, Any]], list[int]] = names["addresses"]
    return checks


def _axis(text: str) -> tuple[str, int]:
    """Parse an axis, such as `slots` or `slots+1`, to its name and surplus (0 without one). Raises
    ValueError if the surplus is no number."""
    name, _, extra = text.partition("+")
    return name, int(extra or 0)


def _kind(value: Any) -> str:
    """Return the type of a value as text, of an array that of its elements."""
    return f"an array of {value.dtype}" if isinstance(value, np.ndarray) else type(value).__name__
