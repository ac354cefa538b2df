"""What a key of a TOML file may hold: one small frozen value a kind.

A kind reads the value of a file, says in words what it allows, and gives back what a file says.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import partial
from math import isfinite
from typing import Any, Protocol

from nscc.toml.text import shown

LEAST = 1e-9
"""The least that "above 0" takes. Quotients and squares of what is next to 0 leave the range of
floats, and no time, charge or current that nscc knows is as small."""


class Kind(Protocol):
    """A set of values."""

    @property
    def allowed(self) -> str:
        """What ends the sentence "the key must be .."."""

    def read(self, value: Any) -> Any:
        """The value as Python keeps it; ValueError for one that is not allowed."""

    def plain(self, value: Any) -> Any:
        """The value as a file says it: what `read` takes."""
        return value


@dataclass(frozen=True, slots=True)
class Number(Kind):
    """A finite number within `low`..`high`; the bounds themselves may be excluded.

    A float, or an int where it is `whole`. None is "any" of `unlimited` ones, "auto" of `automatic`
    ones. Where 0 is an excluded bound, the range ends at LEAST instead.
    """

    low: float
    high: float
    unit: str = ""
    low_excluded: bool = False
    high_excluded: bool = False
    whole: bool = False
    unlimited: bool = False
    automatic: bool = False

    @property
    def _word(self) -> str:
        """What stands for None, if anything."""
        return "any" if self.unlimited else "auto" if self.automatic else ""

    def __post_init__(self) -> None:
        for end, excluded, least in (
            ("low", "low_excluded", LEAST), ("high", "high_excluded", -LEAST)
        ):  # fmt: skip
            if getattr(self, end) == 0 and getattr(self, excluded):
                object.__setattr__(self, end, least)
                object.__setattr__(self, excluded, False)

    @property
    def range(self) -> str:
        """The range in words."""
        left = "above" if self.low_excluded else "from"
        right = "below" if self.high_excluded else "to"
        return f"{left} {self.low:g} {right} {self.high:g}"

    @property
    def allowed(self) -> str:
        number = "a whole number" if self.whole else "a number"
        unit = f" ({self.unit})" if self.unit else ""
        return (f'"{self._word}" or ' if self._word else "") + f"{number} {self.range}{unit}"

    def read(self, value: Any) -> float | None:
        if self._word and value == self._word:
            return None
        if isinstance(value, bool) or not isinstance(value, int if self.whole else (int, float)):
            raise ValueError
        above = self.low < value if self.low_excluded else self.low <= value
        below = value < self.high if self.high_excluded else value <= self.high
        if not (above and below and isfinite(value)):
            raise ValueError
        # Adding 0.0 makes -0.0 plain 0.0: one value, one spelling.
        return value if self.whole else float(value) + 0.0

    def plain(self, value: Any) -> Any:
        return self._word if value is None else value


Integer = partial(Number, whole=True)


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
    """A text: one of `choices` where there are some, all of it a `pattern`, `said` in words.

    `optional` ones may be "none", which is None.
    """

    choices: tuple[str, ...] = ()
    pattern: str = ""
    said: str = "a text"
    optional: bool = False

    @property
    def allowed(self) -> str:
        if self.choices:
            return "one of " + ", ".join(f'"{choice}"' for choice in self.choices)
        return self.said

    def read(self, value: Any) -> str | None:
        # Bytes of the command line that are no UTF-8 arrive as halves of characters.
        if not isinstance(value, str) or any("\ud800" <= c <= "\udfff" for c in value):
            raise ValueError
        if self.choices and value not in self.choices:
            raise ValueError
        if self.pattern and not (value.isprintable() and re.fullmatch(self.pattern, value)):
            raise ValueError
        return None if self.optional and value == "none" else value

    def plain(self, value: Any) -> Any:
        return "none" if value is None else value


@dataclass(frozen=True, slots=True)
class Several(Kind):
    """A list of values of one kind, `count` of them where that is given, `said` in words."""

    each: Kind
    count: int | None = None
    said: str = ""

    @property
    def allowed(self) -> str:
        return self.said or f"a list of {self.count}, each {self.each.allowed}"

    def read(self, value: Any) -> tuple[Any, ...]:
        if not isinstance(value, list | tuple) or self.count not in (None, len(value)):
            raise ValueError
        return tuple(self.each.read(part) for part in value)

    def plain(self, value: Any) -> Any:
        return [self.each.plain(part) for part in value]


@dataclass(frozen=True, slots=True)
class Axis(Kind):
    """A value of one kind, or a list of different ones: as Python keeps it always a tuple.

    Of a kind whose values are lists themselves, a list of lists is several values.
    """

    each: Kind

    @property
    def allowed(self) -> str:
        return f"{self.each.allowed}, or a list of such values"

    def read(self, value: Any) -> tuple[Any, ...]:
        many = isinstance(value, list | tuple)
        if many and isinstance(self.each, Several):
            many = not value or isinstance(value[0], list | tuple)
        if many and not value:
            raise ValueError("an empty list gives no points: name a value, or leave the key out")
        if not many:
            return (self.each.read(value),)
        found = tuple(map(self._read_one, value))
        if len(set(found)) < len(found):
            raise ValueError("a list contains a value twice")
        return found

    def _read_one(self, value: Any) -> Any:
        try:
            return self.each.read(value)
        except ValueError as reason:
            raise ValueError(str(reason) or f"{shown(value)} is not allowed") from None

    def plain(self, value: Any) -> Any:
        found = [self.each.plain(part) for part in value]
        return found[0] if len(found) == 1 else found


NAME = Text(
    pattern=r"[A-Za-z][A-Za-z0-9_.+-]{0,63}",
    said="a name of letters, digits, `-`, `_`, `.` (at most 64, starting with a letter)",
)
LINE = Text(pattern=".{0,400}", said="one line of text with at most 400 characters")
