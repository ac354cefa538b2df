"""What a key of a TOML file may hold: one small frozen value a kind.

A kind reads the value of a file, says in words what it allows, and gives back what a file says.
"""

from __future__ import annotations

import re
from abc import ABC, abstractmethod
from dataclasses import dataclass
from math import isfinite
from typing import Any


class Kind(ABC):
    """A set of values. `allowed` ends the sentence "the key must be .."."""

    __slots__ = ()

    @property
    @abstractmethod
    def allowed(self) -> str:
        """What values there are, in words."""

    @abstractmethod
    def read(self, value: Any) -> Any:
        """The value as Python keeps it; ValueError for one that is not allowed."""

    def plain(self, value: Any) -> Any:
        """The value as a file says it: what `read` takes."""
        return value


@dataclass(frozen=True, slots=True)
class Number(Kind):
    """A finite float within `low`..`high`; the bounds themselves may be excluded."""

    low: float
    high: float
    unit: str = ""
    low_excluded: bool = False
    high_excluded: bool = False

    @property
    def range(self) -> str:
        """The range in words."""
        left = "above" if self.low_excluded else "from"
        right = "below" if self.high_excluded else "to"
        return f"{left} {self.low:g} {right} {self.high:g}"

    @property
    def allowed(self) -> str:
        return f"a number {self.range}" + (f" ({self.unit})" if self.unit else "")

    def read(self, value: Any) -> float:
        if isinstance(value, bool) or not isinstance(value, int | float):
            raise ValueError
        above = self.low < value if self.low_excluded else self.low <= value
        below = value < self.high if self.high_excluded else value <= self.high
        if not (above and below and isfinite(value)):
            raise ValueError
        # Adding 0.0 makes -0.0 plain 0.0: one value, one spelling.
        return float(value) + 0.0


@dataclass(frozen=True, slots=True)
class Integer(Kind):
    """A whole number within `low`..`high`; `unlimited` ones may be "any", which is None."""

    low: int
    high: int
    unlimited: bool = False

    @property
    def allowed(self) -> str:
        any_too = '"any" or ' if self.unlimited else ""
        return f"{any_too}a whole number from {self.low:g} to {self.high:g}"

    def read(self, value: Any) -> int | None:
        if self.unlimited and value == "any":
            return None
        if isinstance(value, bool) or not isinstance(value, int):
            raise ValueError
        if not self.low <= value <= self.high:
            raise ValueError
        return value

    def plain(self, value: Any) -> Any:
        return "any" if value is None else value


@dataclass(frozen=True, slots=True)
class Flag(Kind):
    """True or false."""

    @property
    def allowed(self) -> str:
        return "true or false"

    def read(self, value: Any) -> bool:
        if not isinstance(value, bool):
            raise ValueError
        return value


@dataclass(frozen=True, slots=True)
class Text(Kind):
    """A text, one of `choices` where there are some; `longest` ones are a line of text."""

    choices: tuple[str, ...] = ()
    longest: int | None = None

    @property
    def allowed(self) -> str:
        if self.choices:
            return "one of " + ", ".join(f'"{choice}"' for choice in self.choices)
        if self.longest is not None:
            return f"one line of text, {self.longest} characters at most"
        return "a text"

    def read(self, value: Any) -> str:
        # Bytes of the command line that are no UTF-8 arrive as halves of characters.
        if not isinstance(value, str) or any("\ud800" <= c <= "\udfff" for c in value):
            raise ValueError
        if self.choices and value not in self.choices:
            raise ValueError
        if self.longest is not None and not (value.isprintable() and len(value) <= self.longest):
            raise ValueError
        return value


@dataclass(frozen=True, slots=True)
class Name(Kind):
    """A name that messages, reports and the command line can use."""

    @property
    def allowed(self) -> str:
        return "a name of letters, digits, `-`, `_`, `.` (64 at most, a letter first)"

    def read(self, value: Any) -> str:
        if not isinstance(value, str) or not re.fullmatch(r"[A-Za-z][A-Za-z0-9_.+-]{0,63}", value):
            raise ValueError
        return value


@dataclass(frozen=True, slots=True)
class Register(Kind):
    """The name of a register, or "none", which is None."""

    @property
    def allowed(self) -> str:
        return "the name of a register"

    def read(self, value: Any) -> str | None:
        if not isinstance(value, str):
            raise ValueError
        return None if value == "none" else value

    def plain(self, value: Any) -> Any:
        return "none" if value is None else value


@dataclass(frozen=True, slots=True)
class Registers(Kind):
    """A list of register names."""

    @property
    def allowed(self) -> str:
        return "a list of register names"

    def read(self, value: Any) -> tuple[str, ...]:
        if not isinstance(value, list | tuple) or not all(isinstance(name, str) for name in value):
            raise ValueError
        return tuple(value)

    def plain(self, value: Any) -> Any:
        return list(value)


@dataclass(frozen=True, slots=True)
class Several(Kind):
    """`count` values of one kind."""

    count: int
    each: Kind

    @property
    def allowed(self) -> str:
        return f"a list of {self.count}, each {self.each.allowed}"

    def read(self, value: Any) -> tuple[Any, ...]:
        if not isinstance(value, list | tuple) or len(value) != self.count:
            raise ValueError
        return tuple(self.each.read(part) for part in value)

    def plain(self, value: Any) -> Any:
        return [self.each.plain(part) for part in value]
