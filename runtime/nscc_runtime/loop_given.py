"""The parameters of compiled loops, and the checks of their arguments (see `nscc_runtime.loop`)."""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Annotated, Any, get_args, get_origin, get_type_hints

import numpy as np

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
    equal lengths, in all arrays, and equal the field of that name in a record. `lengths`: the
    fields of the record that are lengths of axes."""

    name: str
    kind: np.dtype[Any]
    record: type[ctypes.Structure] | None = None
    written: bool = False
    axes: tuple[tuple[str, int], ...] | None = None
    lengths: tuple[str, ...] = ()

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

    def sized(self, axes: set[str]) -> LoopParameter:
        """Return the parameter with `lengths`: those fields of its record that `axes`, the names of
        axes of all arrays of the loop, contains."""
        return replace(self, lengths=tuple(n for n in self.kind.names or () if n in axes))

    def addresses(self, value: Any, axes: dict[str, int]) -> tuple[int]:
        """Return the address of the argument `value`, as the only member of a tuple.

        `axes`: the lengths of axes known so far, by name; those of this argument are added. Raises
        TypeError for another type, an array that is not contiguous or may not be written but is to
        be, and for other numbers or lengths of axes."""
        if self.record is not None:
            if type(value) is not self.record:
                raise TypeError(f"{self.name} is {_kind(value)}, not {self.record.__name__}")
            for name in self.lengths:
                length = getattr(value, name)
                if axes.setdefault(name, length) != length:
                    raise self._unequal(name, length, axes)
            return (ctypes.addressof(value),)
        if not isinstance(value, np.ndarray) or value.dtype != self.kind:
            raise TypeError(f"{self.name} is {_kind(value)}, not an array of {self.kind}")
        flags = value.flags
        if not (flags.c_contiguous and flags.aligned):
            raise TypeError(f"{self.name} does not lie in one piece, row after row")
        if self.written and not flags.writeable:
            raise TypeError(f"{self.name} is to be written, and is read-only")
        if self.axes is not None:
            shape = value.shape
            if len(shape) != len(self.axes):
                raise TypeError(f"{self.name} has {len(shape)} axes, not {len(self.axes)}")
            for length, (axis, extra) in zip(shape, self.axes):  # noqa: B905  # as long: checked
                if axes.setdefault(axis, length - extra) != length - extra:
                    raise self._unequal(axis, length - extra, axes)
        return (ctypes.c_void_p.from_address(id(value) + _DATA).value or 0,)

    def widened(self, value: Any) -> Any:
        """Return the argument `value`; an array of numpy's indices as int64 if the parameter is of
        this type, because they have 32 bits in WebAssembly. An array that the loop modifies is not
        copied, so `addresses` refuses it."""
        is_index = isinstance(value, np.ndarray) and value.dtype == np.intp
        wide = is_index and self.kind == np.int64 and not self.written
        return value.astype(np.int64, copy=False) if wide else value

    def _unequal(self, axis: str, length: int, axes: dict[str, int]) -> TypeError:
        """Return the error, for the caller to raise, for an argument whose `axis` has the `length`,
        but another one, axes[axis], in an earlier argument."""
        return TypeError(f"{self.name} has {length} {axis}, others have {axes[axis]}")


@dataclass(frozen=True)
class ArrayGroup:
    """Several arrays that are one argument of a loop: `kind` is the class of the NamedTuple,
    `arrays` describes its fields in order. Machine code receives the address of each array."""

    name: str
    kind: type[tuple[Any, ...]]
    arrays: tuple[LoopParameter, ...]

    def sized(self, _axes: set[str]) -> ArrayGroup:
        """Return the group unchanged: only records contain lengths of axes."""
        return self

    def widened(self, value: Any) -> Any:
        """Return the NamedTuple `value` with arrays of numpy's indices as int64 where the loop
        takes these, because they have 32 bits in WebAssembly."""
        arrays = zip(self.arrays, value, strict=True)
        return self.kind(*(parameter.widened(array) for parameter, array in arrays))

    def addresses(self, value: Any, axes: dict[str, int]) -> list[int]:
        """Return the addresses of all arrays of the NamedTuple `value`, in order.

        `axes`: the lengths of axes known so far, by name; those of these arrays are added. Raises
        TypeError for an object of another class, or an array that does not match."""
        if type(value) is not self.kind:
            raise TypeError(f"{self.name} is {_kind(value)}, not {self.kind.__name__}")
        return [
            address
            for parameter, array in zip(self.arrays, value, strict=True)
            for address in parameter.addresses(array, axes)
        ]


def parameter_of(name: str, hint: Any) -> LoopParameter | ArrayGroup:
    """Return the parameter `name` that the annotation `hint` declares: an array or a record, or a
    group of arrays if it is a NamedTuple's class."""
    if not (isinstance(hint, type) and issubclass(hint, tuple)):
        return LoopParameter.of(name, hint)
    fields = get_type_hints(hint, include_extras=True).items()
    return ArrayGroup(
        name, hint, tuple(LoopParameter.of(f"{name}.{n}", field_hint) for n, field_hint in fields)
    )


def quick_addresses(
    parameters: Mapping[str, LoopParameter | ArrayGroup],
) -> Callable[[Mapping[str, Any]], list[int] | None]:
    """Return a function of the arguments by name that returns the addresses of all `parameters`, as
    their `addresses` do, or None if an argument has to be looked at more closely.

    A loop has up to 50 arrays, so the checks are one function made for it, without calls."""
    lines, addresses, known = ["def addresses(values):"], list[str](), set[str]()
    names: dict[str, Any] = {"Array": np.ndarray, "at": ctypes.c_void_p.from_address}
    names["of"] = ctypes.addressof

    def check(wrong: str) -> None:
        lines.append(f"    if {wrong}: return None")

    def axis(name: str, length: str) -> None:
        if name in known:
            check(f"x{name} != {length}")
        known.add(name)
        lines.append(f"    x{name} = {length}")

    for number, (name, parameter) in enumerate(parameters.items()):
        value = f"v{number}"
        arrays = [f"{value}_{k}" for k in range(len(parameter.arrays))]
        lines.append(f"    {value} = values[{name!r}]")
        group = parameter.kind if isinstance(parameter, ArrayGroup) else parameter.record
        names[f"T{number}"] = group or np.ndarray
        check(f"type({value}) is not T{number}")
        if isinstance(parameter, LoopParameter) and parameter.record is not None:
            for length in parameter.lengths:
                axis(length, f"{value}.{length}")
            addresses.append(f"of({value})")
            continue
        lines.append(f"    {', '.join(arrays)}, = {value if group else value + ','}")
        for array, of_array in zip(arrays, parameter.arrays, strict=True):
            names[f"K{array}"] = of_array.kind
            flags = _IN_ROWS | _WRITEABLE if of_array.written else _IN_ROWS
            check(f"type({array}) is not Array")
            # Equal types are usually one object.
            check(f"{array}.dtype is not K{array} and {array}.dtype != K{array}")
            check(f"{array}.flags.num & {flags} != {flags}")
            if of_array.axes is not None:
                check(f"{array}.ndim != {len(of_array.axes)}")
            for index, (axis_name, extra) in enumerate(of_array.axes or ()):
                axis(axis_name, f"{array}.shape[{index}] - {extra}")
            addresses.append(f"at(id({array}) + {_DATA}).value or 0")
    lines.append(f"    return [{', '.join(addresses)}]")
    exec("\n".join(lines), names)  # the text is made here
    made: Callable[[Mapping[str, Any]], list[int] | None] = names["addresses"]
    return made


def _axis(text: str) -> tuple[str, int]:
    """Parse an axis, such as `slots` or `slots+1`, to its name and surplus (0 without one). Raises
    ValueError if the surplus is no number."""
    name, _, extra = text.partition("+")
    return name, int(extra or 0)


def _kind(value: Any) -> str:
    """Return the type of a value as text, of an array that of its elements."""
    return f"an array of {value.dtype}" if isinstance(value, np.ndarray) else type(value).__name__
