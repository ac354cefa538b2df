"""Frozen values that are declared faster than dataclasses."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import Field, dataclass
from functools import cache
from typing import Any, ClassVar, dataclass_transform


class _Fields:
    """The attribute that `dataclasses.replace` and `fields` read; it is computed when they are
    called."""

    def __get__(self, _instance: object, cls: type[Record]) -> Mapping[str, Field[Any]]:
        """Return the fields of a record class, which `dataclasses.fields` reads."""
        return _fields(cls)  # type: ignore[arg-type]  # mypy mistakes a class for its instances


@cache
def _fields(cls: type[Record]) -> Mapping[str, Field[Any]]:
    """Return the fields of a record class as those of a dataclass."""
    alike: Any = dataclass(type("", (), {"__annotations__": dict.fromkeys(cls.field_names)}))
    fields: Mapping[str, Field[Any]] = alike.__dataclass_fields__
    return fields


@dataclass_transform(frozen_default=True)
class Record:
    """A base class whose subclasses behave like frozen dataclasses; with `eq=False` they compare by
    identity.

    A hundred real dataclasses would take a sixth of the time of `nscc check`."""

    field_names: ClassVar[tuple[str, ...]] = ()
    __dataclass_fields__: ClassVar[Any] = _Fields()

    def __init_subclass__(cls, *, eq: bool = True) -> None:
        """Take the annotated attributes of a subclass as its fields, after those of its base class;
        names are taken in the order of the text. With `eq` False, records compare by identity."""
        cls.field_names = (*cls.field_names, *vars(cls).get("__annotations__", ()))
        type.__setattr__(cls, "__match_args__", cls.field_names)
        if not eq:
            cls.__eq__, cls.__hash__ = object.__eq__, object.__hash__  # type: ignore[method-assign]

    def __init__(self, *values: Any, **named: Any) -> None:
        """Set the fields, by position or by name; those with a default may be missing.

        Types are not checked. Raises TypeError for missing, unknown or too many ones."""
        names, cls = self.field_names, type(self)
        if named or len(values) != len(names):
            later = names[len(values) :]
            missing = [name for name in later if name not in named and not hasattr(cls, name)]
            if missing or not named.keys() <= set(later) or len(values) > len(names):
                raise TypeError(f"{cls.__name__} takes {', '.join(names)}")
            values += tuple(named[name] if name in named else getattr(cls, name) for name in later)
        self.__dict__.update(zip(names, values, strict=True))

    def __setattr__(self, name: str, value: Any) -> None:
        """Raise AttributeError: records do not change."""
        raise AttributeError(f"{type(self).__name__}.{name} is frozen")

    def _values(self) -> tuple[Any, ...]:
        """Return the values of all fields in order."""
        return tuple([self.__dict__[name] for name in self.field_names])

    def __eq__(self, other: object) -> bool:
        """Return whether both are of one class with equal values."""
        return type(other) is type(self) and self._values() == other._values()

    def __hash__(self) -> int:
        """Return a hash of class and values."""
        return hash((type(self), *self._values()))

    def __repr__(self) -> str:
        """Return the class with all values by name."""
        values = ", ".join(f"{name}={self.__dict__[name]!r}" for name in self.field_names)
        return f"{type(self).__name__}({values})"
