"""A chip's own words, in addition to `nscc.operations`: the `[[words]]` of its target file.

    [[words]]
    name = "bus4"             # its mnemonic
    effect = "bus"            # or nothing, reset_pix, flag_all, flag_analog, flag_digital, digital
    destinations = 4          # number of written registers; 0 unless bus or digital
    sources = [0, 2]          # fewest and most registers that it reads
    divisor = 4               # of a bus word; default 1
    inverted = true           # of a digital word; default false
    lines = ["fbus"]          # control lines besides those of its operands; default none
    us = 0.2                  # its duration; default: that of the words of its clock

Reset, flag and bus words use the analog clock, flag_digital and digital words the digital clock.
The set of effects is fixed, because the proof and the emulator implement them. A target can define
words with other operands or durations, but no new effects."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from math import isfinite
from typing import Any

from nscc.macros import MNEMONICS
from nscc.mappings import JsonObject
from nscc.operations import (
    ANALOG_SOURCES,
    ANALOG_WRITE,
    BY_NAME,
    DIGITAL_SOURCES,
    DIGITAL_WRITE,
    LINE_NAMES,
    OPERATIONS,
    READ_LINES,
    Operation,
    WordEffect,
)
from nscc.toml.kinds import Kind
from nscc.toml.toml_text import written

EFFECTS = {
    "nothing": WordEffect.NONE,
    **{effect.name.lower(): effect for effect in WordEffect if effect is not WordEffect.NONE},
}
_DIGITAL = (WordEffect.FLAG_DIGITAL, WordEffect.DIGITAL)
_WRITES = (WordEffect.BUS, WordEffect.DIGITAL)
_READS = (WordEffect.BUS, WordEffect.FLAG_ANALOG, *_DIGITAL)
_NEEDED = ("name", "effect", "destinations", "sources")
_DEFAULTS: JsonObject = {"divisor": 1, "inverted": False, "lines": [], "us": None}
_LINES = {name: line for line, name in LINE_NAMES.items()}
_MOST = 32
"""Most words that a target file may define."""


class OwnWords(Kind):
    """The type of the key `[[words]]` of a target file: a list of operations."""

    @property
    def allowed(self) -> str:
        """Which values a target file may have here, for messages."""
        return f"a list of at most {_MOST} [[words]], each different from every other word"

    def read(self, value: Any) -> tuple[Operation, ...]:
        """Return the operations that the `[[words]]` tables of a target file declare.

        Raises ValueError if `value` is not a list of at most `_MOST` tables, if a table is invalid,
        if a name exists already, or if a word could have the same bits as another word."""
        if not isinstance(value, list) or len(value) > _MOST:
            raise ValueError
        operations: list[Operation] = []
        for number, table in enumerate(value, 1):
            row = _row(table, f"word {number}")
            for operation in (*OPERATIONS, *operations):
                if _may_have_same_bits(row, operation):
                    raise ValueError(
                        f"{row.name} and {operation.name} can have the same bits: change one"
                    )
            if row.name in (*MNEMONICS, *BY_NAME, *(operation.name for operation in operations)):
                raise ValueError(f"the word {row.name} exists already")
            operations.append(row)
        return tuple(operations)

    def plain(self, value: Any) -> Any:
        """Return operations as TOML values: one table for each word, as `read` takes them."""
        return [_plain(row) for row in value]


def words_toml(rows: Iterable[Operation]) -> list[str]:
    """Return the lines of a target file that define the operations `rows`, without line breaks."""
    lines = []
    for row in rows:
        lines += ["", "[[words]]", *(f"{key} = {written(v)}" for key, v in _plain(row).items())]
    return lines


def _plain(row: Operation) -> JsonObject:
    """Return the operation `row` as a `[[words]]` table of a target file.

    The table has the required keys, and of the optional ones those whose value differs from the
    default."""
    names = {effect: name for name, effect in EFFECTS.items()}
    values = {
        "name": row.name,
        "effect": names[row.effect],
        "destinations": row.destinations[0],
        "sources": list(row.sources),
        "divisor": row.divisor,
        "inverted": row.inverted,
        "lines": [LINE_NAMES[line] for line in row.lines],
        "us": row.us,
    }
    return {k: v for k, v in values.items() if k in _NEEDED or v != _DEFAULTS[k]}


def _row(values: Any, who: str) -> Operation:
    """Return the operation that `values`, one `[[words]]` table, defines.

    `who` names the table in messages until its own name is known. Raises ValueError with the reason
    if the table is invalid: the first fault that is found."""
    if not isinstance(values, Mapping):
        raise ValueError(f"{who} is not a table of keys")
    # From here on, messages name the word instead of its number.
    if isinstance(values.get("name"), str):
        who = ascii(values["name"][:40])
    for key in values:
        if key not in (*_NEEDED, *_DEFAULTS):
            known = ", ".join((*_NEEDED, *_DEFAULTS))
            raise ValueError(
                f"{who} has the unknown key {key[:40]!a}: the keys of a word are {known}"
            )
    for key in _NEEDED:
        if key not in values:
            raise ValueError(f"{who} lacks the key {key}")
    keys = {**_DEFAULTS, **values}
    name, effect, us = keys["name"], EFFECTS.get(str(keys["effect"])), keys["us"]
    if not isinstance(name, str) or not re.fullmatch(r"[A-Za-z][A-Za-z0-9_]{0,31}", name):
        raise ValueError(
            f"{who} is not a valid name: use letters and digits, starting with a letter"
        )
    if effect is None:
        raise ValueError(
            f"{who} has the unknown effect {str(keys['effect'])[:40]!a}: the "
            f"effects are {', '.join(EFFECTS)}"
        )
    written_, read = _counts(who, effect, keys["destinations"], keys["sources"])
    divisor = keys["divisor"]
    if not _is_integer_within(divisor, low=1, high=64) or (
        divisor != 1 and effect is not WordEffect.BUS
    ):
        raise ValueError(
            f"{who} has an invalid divisor: only bus words have a divisor, from 1 to 64"
        )
    inverted = keys["inverted"]
    if not isinstance(inverted, bool) or (inverted and effect is not WordEffect.DIGITAL):
        raise ValueError(f"{who} is inverted, but only digital words can be inverted")
    # Python counts True and False as integers; they are not times.
    number = isinstance(us, int | float) and not isinstance(us, bool)
    if us is not None and not (number and isfinite(us) and 0 < us <= 1e6):
        raise ValueError(f"{who} takes a number of microseconds above 0 and up to 1000000 (us)")
    return Operation(
        name,
        effect,
        clock=int(effect in _DIGITAL),
        lines=_lines(who, effect, keys["lines"]),
        destinations=(written_, written_),  # the fewest and the most
        sources=read,
        inverted=inverted,
        divisor=divisor,
        us=None if us is None else float(us),
    )


def _counts(who: str, effect: WordEffect, written_: Any, read: Any) -> tuple[int, tuple[int, int]]:
    """Return how many registers a word writes, and the fewest and most that it reads.

    `written_` and `read` are the values of `destinations` (a number) and `sources` ([fewest, most])
    in the file, not yet checked. Raises ValueError, which calls the word `who`, if they do not suit
    the effect."""
    digital = effect in _DIGITAL
    most = len(DIGITAL_WRITE if digital else ANALOG_WRITE) if effect in _WRITES else 0
    # A word that writes has at least one destination, any other has none.
    if not _is_integer_within(written_, int(effect in _WRITES), most):
        raise ValueError(f"{who} writes {int(effect in _WRITES)} to {most} destinations")
    most = len(DIGITAL_SOURCES if digital else ANALOG_SOURCES) if effect in _READS else 0
    pair = isinstance(read, Sequence) and not isinstance(read, str) and len(read) == 2
    # A word that writes FLAG compares or copies at least one source.
    least = int(effect in (WordEffect.FLAG_ANALOG, WordEffect.FLAG_DIGITAL))
    if not pair or not (
        _is_integer_within(read[0], least, most) and _is_integer_within(read[1], read[0], most)
    ):
        raise ValueError(f"{who} reads [fewest, most] sources, {least} to {most}")
    return written_, (read[0], read[1])


def _lines(who: str, effect: WordEffect, names: Any) -> tuple[int, ...]:
    """Return the numbers of the control lines `names` that a word sets besides those of its
    operands, in ascending order and each once.

    The `effect` decides whether operands are digital or analog registers. Raises ValueError, which
    calls the word `who`, for unknown lines and for lines that select an operand."""
    if not isinstance(names, list) or not all(isinstance(name, str) for name in names):
        raise ValueError(f"{who} has invalid lines: a list of names is required")
    for name in names:
        if name not in _LINES:
            raise ValueError(f"{who} raises the unknown control line {name[:40]!a}")
        if _LINES[name] in _operand_lines(effect in _DIGITAL):
            raise ValueError(f"{who} raises {name}, which belongs to an operand")
    return tuple(sorted({_LINES[name] for name in names}))


def _operand_lines(digital: bool) -> frozenset[int]:
    """Return the numbers of all control lines that select a register that a word may read or write.

    `digital` chooses between digital and analog registers."""
    reads, writes = (DIGITAL_SOURCES, DIGITAL_WRITE) if digital else (ANALOG_SOURCES, ANALOG_WRITE)
    return frozenset({*(line for name in reads for line in READ_LINES[name]), *writes.values()})


def _may_have_same_bits(first: Operation, second: Operation) -> bool:
    """Return whether two operations can have the same bits in a word.

    They can if they have the same clock, equal control lines besides those that select operands,
    and numbers of destinations and sources that overlap."""
    if first.clock != second.clock:
        return False
    operands = _operand_lines(not first.analog)
    if {*first.lines} - operands != {*second.lines} - operands:
        return False
    return _ranges_overlap(first.destinations, second.destinations) and _ranges_overlap(
        first.sources, second.sources
    )


def _ranges_overlap(first: tuple[int, int | None], second: tuple[int, int | None]) -> bool:
    """Return whether two ranges (fewest, most) of operand counts overlap; both ends are included,
    and `most` None means no limit."""
    return (second[1] is None or first[0] <= second[1]) and (
        first[1] is None or second[0] <= first[1]
    )


def _is_integer_within(value: Any, low: int, high: int) -> bool:
    """Return whether a value is an integer from `low` to `high`, inclusive; True and False are
    not."""
    return isinstance(value, int) and not isinstance(value, bool) and low <= value <= high
