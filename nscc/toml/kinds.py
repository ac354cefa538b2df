"""Kinds of values: of keys in TOML files, of arguments in Python, of options of the command line.

A kind reads a value, describes the allowed values, and converts a value for writing."""

from __future__ import annotations

import os
import re
import sys
from dataclasses import dataclass
from functools import partial
from importlib import import_module
from math import inf
from pathlib import Path
from typing import Any, Protocol

from nscc.record import Record
from nscc.toml.toml_text import shown

LEAST = 1e-9
"""The smallest value if a kind requires a value above 0.

Quotients and squares of smaller values exceed the range of floats, and no time, charge or current
in nscc is as small."""


_LARGEST_FLOAT = sys.float_info.max
LARGEST_INTEGER = 2**63 - 1
"""The largest whole number of an option that has no limit of its own; messages leave it out."""


class Kind(Protocol):
    """The values that a key may have; subclasses say which, and how a file spells them."""

    helps: tuple[str, ...] = ()
    """What a message about an invalid argument recommends."""

    @property
    def allowed(self) -> str:
        """Return the end of the sentence "the key must be .."."""

    def read(self, value: Any) -> Any:
        """Convert a value from a file to a Python value; raise ValueError if it is not allowed."""

    def plain(self, value: Any) -> Any:
        """Convert a Python value to the value that a file contains, the inverse of `read`."""
        return value

    @property
    def in_python(self) -> str:
        """Return the end of the sentence "the argument is .."."""
        return self.allowed

    def argument(self, value: Any) -> Any:
        """Convert an argument of a Python call; raise ValueError if it is not allowed."""
        return self.read(value)


@dataclass(frozen=True, slots=True)
class Number(Kind):
    """A finite number in `low`..`high`; either bound may be excluded (`low_excluded`,
    `high_excluded`).

    It is an int if `is_whole`, else a float. None in Python is "any" in a file if `unlimited`, and
    "auto" if `automatic`; else it is not allowed. `unit` is that of messages. If 0 is an excluded
    bound, the values end at LEAST or -LEAST instead, which are included."""

    low: float
    high: float
    unit: str = ""
    low_excluded: bool = False
    high_excluded: bool = False
    is_whole: bool = False
    unlimited: bool = False
    automatic: bool = False
    helps: tuple[str, ...] = ()

    @property
    def _word(self) -> str:
        """The word for None in a file: "any", "auto", or "" if None is not allowed."""
        return "any" if self.unlimited else "auto" if self.automatic else ""

    def __post_init__(self) -> None:
        """Replace an excluded bound 0 by LEAST or -LEAST, which is included."""
        for end, excluded, least in (
            ("low", "low_excluded", LEAST),
            ("high", "high_excluded", -LEAST),
        ):
            if getattr(self, end) == 0 and getattr(self, excluded):
                object.__setattr__(self, end, least)
                object.__setattr__(self, excluded, False)

    @property
    def range(self) -> str:
        """The range as text, such as "above 0 to 1000"; bounds that no value can exceed are left
        out, so that it may be empty."""
        lower = "above" if self.low_excluded else "from"
        upper = "below" if self.high_excluded else "to"
        limits = []
        if self.low > -inf:
            limits.append(f"{lower} {self.low:g}")
        if self.high < (LARGEST_INTEGER if self.is_whole else inf):
            limits.append(f"{upper} {self.high:g}")
        return " ".join(limits)

    @property
    def allowed(self) -> str:
        """The allowed values, for messages."""
        return (f'"{self._word}" or ' if self._word else "") + self.in_python

    @property
    def in_python(self) -> str:
        """The allowed numbers as text, with the unit."""
        number = "a whole number" if self.is_whole else "a number"
        if -self.low == self.high == inf:
            return "a finite number"
        unit = f" ({self.unit})" if self.unit else ""
        return f"{number} {self.range}{unit}"

    def read(self, value: Any) -> float | None:
        """Return the number that a file gives; None for the word ("any" or "auto") that stands for
        it.

        Raises ValueError for any other value."""
        if value is None:
            raise ValueError
        return None if self._word and value == self._word else self.argument(value)

    def argument(self, value: Any) -> float | None:
        """Return a number within the bounds, as float unless it must be whole; None is allowed if a
        file has a word for it ("any" or "auto").

        Raises ValueError for any other value, also True and False."""
        if self._word and value is None:
            return None
        if isinstance(value, bool) or not isinstance(value, int if self.is_whole else (int, float)):
            raise ValueError
        above = self.low < value if self.low_excluded else self.low <= value
        below = value < self.high if self.high_excluded else value <= self.high
        largest = LARGEST_INTEGER if self.is_whole else _LARGEST_FLOAT
        if not (above and below and -largest <= value <= largest):
            raise ValueError
        # Adding 0.0 turns -0.0 into 0.0: one value, one spelling.
        return value if self.is_whole else float(value) + 0.0

    def plain(self, value: Any) -> Any:
        """Return the value that a file contains: the number, or the word that stands for None."""
        return self._word if value is None else value


Integer = partial(Number, is_whole=True)


class Flag(Kind, Record):
    """A boolean, true or false in a file; 0 and 1 are not allowed."""

    @property
    def allowed(self) -> str:
        """The allowed values in a file, for messages."""
        return "true or false"

    @property
    def in_python(self) -> str:
        """The allowed values in Python, for messages."""
        return "True or False"

    def read(self, value: Any) -> bool:
        """Return true or false; raise ValueError for other values."""
        if not isinstance(value, bool):
            raise ValueError
        return value


class TextKind(Kind, Record):
    """A text: one of `choices`, or a text that the regular expression `pattern` matches completely
    and `phrase` describes. With neither, any text is allowed.

    If `optional`, "none" in a file is None in Python."""

    choices: tuple[str, ...] = ()
    pattern: str = ""
    phrase: str = "a text"
    optional: bool = False

    @property
    def allowed(self) -> str:
        """The allowed values in a file, for messages."""
        if self.choices:
            return "one of " + ", ".join(f'"{choice}"' for choice in self.choices)
        return self.phrase

    @property
    def in_python(self) -> str:
        """The allowed values in Python, for messages."""
        return f"one of {', '.join(map(repr, self.choices))}" if self.choices else self.phrase

    def read(self, value: Any) -> str | None:
        """Return the text if it is one of the choices and matches the pattern; None for "none" if
        `optional`.

        Raises ValueError for any other value."""
        # Command-line bytes that are not UTF-8 arrive as surrogates.
        if not isinstance(value, str) or any("\ud800" <= c <= "\udfff" for c in value):
            raise ValueError
        if self.choices and value not in self.choices:
            raise ValueError
        if self.pattern and not (value.isprintable() and re.fullmatch(self.pattern, value)):
            raise ValueError
        return None if self.optional and value == "none" else value

    def plain(self, value: Any) -> Any:
        """Return the value for a file: "none" in place of None."""
        return "none" if value is None else value


class Several(Kind, Record):
    """A list of values of the kind `element`, with `count` values unless that is None.

    It is a tuple in Python. `text` describes the list in messages; by default that is the number
    and kind of its values."""

    element: Kind
    count: int | None = None
    text: str = ""

    @property
    def allowed(self) -> str:
        """The allowed values, for messages."""
        count = f" of {self.count}" if self.count else ""
        return self.text or f"a list{count}, each {self.element.allowed}"

    def read(self, value: Any) -> tuple[Any, ...]:
        """Return the list or tuple `value` as a tuple, each element read by `element`.

        Raises ValueError for an invalid element, another number of elements, or if it is not a
        list."""
        if not isinstance(value, list | tuple) or self.count not in (None, len(value)):
            raise ValueError
        return tuple(self.element.read(item) for item in value)

    def plain(self, value: Any) -> Any:
        """Return the values for a file."""
        return [self.element.plain(item) for item in value]


class Distinct(Kind, Record):
    """Distinct values of the kind `element`: in the order of its choices, or in ascending order.

    On the command line they are one text, separated by commas; the text "none" is no value, if that
    is allowed (`may_be_empty`)."""

    element: Kind
    may_be_empty: bool = False

    @property
    def allowed(self) -> str:
        """The allowed values, for messages."""
        return f"a list, each {self.element.allowed}"

    def read(self, value: Any) -> tuple[Any, ...]:
        """Return the values of a list, each once, in the order of the choices, or ascending if
        there are none. Raises ValueError for an invalid value, and for an empty list unless it is
        allowed."""
        if not isinstance(value, list | tuple) or not (value or self.may_be_empty):
            raise ValueError
        values = {self.element.read(item) for item in value}
        choices: tuple[Any, ...] = getattr(self.element, "choices", ())
        return tuple(sorted(values, key=choices.index if choices else None))

    def plain(self, value: Any) -> Any:
        """Return the values for a file."""
        return [self.element.plain(item) for item in value]


class Axis(Kind, Record):
    """One value of the kind `element`, or a list of distinct ones; in Python always a tuple.

    If the values themselves are lists, only a list of lists gives several values."""

    element: Kind

    @property
    def allowed(self) -> str:
        """The allowed values, for messages."""
        return f"{self.element.allowed}, or a list of such values"

    def read(self, value: Any) -> tuple[Any, ...]:
        """Return the values, each read by `element`, as a tuple in their order; a single value
        gives a tuple of one.

        Raises ValueError for an empty list, an invalid or a repeated value."""
        is_list = isinstance(value, list | tuple)
        if is_list and isinstance(self.element, Several):
            is_list = not value or isinstance(value[0], list | tuple)
        if is_list and not value:
            raise ValueError("an empty list gives no points: name a value, or leave the key out")
        if not is_list:
            return (self.element.read(value),)
        values = tuple(map(self._read_one, value))
        if len(set(values)) < len(values):
            raise ValueError("a list contains a value twice")
        return values

    def _read_one(self, value: Any) -> Any:
        """Return one value of a list, read by `element`; raise ValueError if it is not allowed,
        with a reason that quotes it."""
        try:
            return self.element.read(value)
        except ValueError as reason:
            raise ValueError(str(reason) or f"{shown(value)} is not allowed") from None

    def plain(self, value: Any) -> Any:
        """Return the values for a file: a list, or the value itself if there is only one."""
        values = [self.element.plain(item) for item in value]
        return values[0] if len(values) == 1 else values


class Instance(Kind, Record):
    """An object of one of `types`, which `phrase` describes; a path object becomes text.

    A type may be written as "MODULE:CLASS", which is imported when a value is checked. `helps` tell
    how to make such an object."""

    types: tuple[type | str, ...]
    phrase: str
    helps: tuple[str, ...] = ()

    @property
    def allowed(self) -> str:
        """The allowed values, for messages."""
        return self.phrase

    def read(self, value: Any) -> Any:
        """Return a value of one of the types; a path object becomes text. Raises ValueError for any
        other value, also for True and False."""
        if not _is_one(value, self.types) or isinstance(value, bool):
            raise ValueError
        return os.fspath(value) if isinstance(value, os.PathLike) else value


def _is_one(value: Any, types: tuple[type | str, ...]) -> bool:
    """Return whether a value has one of these types, of which those written "MODULE:CLASS" are
    imported. An import that fails raises its own error."""
    for kind in types:
        if isinstance(kind, str):
            module, _, name = kind.partition(":")
            kind = getattr(import_module(module), name)
        if isinstance(value, kind):
            return True
    return False


class FilePath(Kind, Record):
    """The path of a file or folder, or an object of one of `types`, which may be written
    "MODULE:CLASS".

    `phrase` describes the allowed values."""

    phrase: str = "a path"
    types: tuple[type | str, ...] = ()

    @property
    def allowed(self) -> str:
        """The allowed values, for messages."""
        return self.phrase

    def read(self, value: Any) -> Any:
        """Return a text or path object as a Path; return an object of one of `types` as it is.

        Raises ValueError for any other value, and for a path with a null character."""
        path = os.fspath(value) if isinstance(value, str | os.PathLike) else None
        if path is None and _is_one(value, self.types):
            return value
        if not isinstance(path, str) or "\0" in path:
            raise ValueError
        return Path(path)


class TextOrNumbers(Kind, Record):
    """A text, or numbers, which become text with commas: (1, 2.5) gives "1,2.5".

    There must be `count` numbers; None allows any number of them. A single number needs no list."""

    count: int | None

    @property
    def allowed(self) -> str:
        """The allowed values, for messages."""
        numbers = {None: "numbers", 1: "a number"}.get(self.count, f"{self.count} numbers")
        return f"text or {numbers}"

    def read(self, value: Any) -> Any:
        """Return a text as it is, and numbers as text with commas and up to 17 digits.

        Numbers may be a tuple, a list or a single number. Raises ValueError for a number that is
        not finite, and unless there are `count` numbers (None: at least one)."""
        if isinstance(value, str):
            return value
        values = value if isinstance(value, tuple | list) else [value]
        if len(values) != (self.count or len(values) or 1):
            raise ValueError
        return ",".join(f"{ANY_NUMBER.read(_plain(item)):.17g}" for item in values)


def _plain(value: Any) -> Any:
    """Return a number of numpy as one of Python; any other value as it is."""
    return value.item() if hasattr(value, "item") and not getattr(value, "shape", ()) else value


ANY_NUMBER = Number(-inf, inf)
SEED = Integer(0, LARGEST_INTEGER)
"""A seed of random numbers."""

NAME = TextKind(
    pattern=r"[A-Za-z][A-Za-z0-9_.+-]{0,63}",
    phrase="a name of letters, digits, `-`, `_`, `.` (at most 64, starting with a letter)",
)
LINE = TextKind(pattern=".{0,400}", phrase="one line of text with at most 400 characters")
