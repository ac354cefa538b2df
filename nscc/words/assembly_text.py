"""Elements of assembly text (names, numbers, times, ranges): writing and reading.

Each `read_*` function reads exactly what its `*_text` partner writes, and returns None for
malformed text."""

from __future__ import annotations

import json
import re
from base64 import b64encode
from collections.abc import Sequence
from math import isfinite

import numpy as np

from nscc.arrays import Bools

_PLAIN = re.compile(r"[A-Za-z_][A-Za-z0-9_.+-]*")
_INTEGER = re.compile(r"-?[0-9]{1,19}")
_RANGE = re.compile(r"([0-9]{1,9})(?:\.\.([0-9]{1,9})(?:/([0-9]{1,9}))?)?")
_FEW_TURNS = 8
"""With at most this many openings and closings in all, the form as ranges is always used."""
_BASE64_WIDTH = 96
"""Most characters of base64 in a line."""
_POWER = {"ns": -3, "us": 0, "ms": 3, "s": 6}


def name_text(name: str) -> str:
    """Return a name as one token of assembly text: a JSON string, unless it begins with a letter or
    `_` and has only letters, digits and `_.+-`."""
    return name if _PLAIN.fullmatch(name) else json.dumps(name)


def number_text(value: float) -> str:
    """Return the shortest decimal number that reads back as `value`, which is finite; without a
    point if it is an integer below 1e16."""
    return repr(float(value)).removesuffix(".0")


def read_integer(text: str) -> int | None:
    """Return the integer of a text such as `-12`; None if it is not one, or does not fit 64 bits.

    A sign + and leading or trailing blanks are not allowed."""
    if not _INTEGER.fullmatch(text):
        return None
    value = int(text)
    return value if -(1 << 63) <= value < 1 << 63 else None


def read_number(text: str) -> float | None:
    """Return the number of a text such as `-0.5`; None if it is too large to be finite.

    The grammar has checked that it is a number; float raises ValueError for any other text."""
    value = float(text)
    return value if isfinite(value) else None


def read_time_us(text: str) -> float | None:
    """Return a time such as `125us` in microseconds; None unless it is finite and above 0.

    The grammar has checked that it is a number with the unit ns, us, ms or s."""
    from decimal import Decimal

    # The units consist of these letters, and numbers have none of them.
    number = text.rstrip("nums")
    # Decimal moves the point exactly; a product of floats would round twice.
    value = float(Decimal(number).scaleb(_POWER[text[len(number) :]]))
    return value if isfinite(value) and value > 0 else None


def ranges_text(values: Sequence[int]) -> str:
    """Return ascending integers as ranges joined by commas: `0..15`, `4`, or `1..63/2` (every
    second); "" if there are none.

    Both ends of a range are included."""
    texts: list[str] = []
    begin = 0
    while begin < len(values):
        step = values[begin + 1] - values[begin] if begin + 1 < len(values) else 1
        end = begin
        while end + 1 < len(values) and values[end + 1] - values[end] == step:
            end += 1
        if end - begin < 2 and step > 1:  # two values with a gap are shorter one by one
            end = begin
        if end == begin:
            texts.append(str(values[begin]))
        else:
            texts.append(f"{values[begin]}..{values[end]}" + (f"/{step}" if step > 1 else ""))
        begin = end + 1
    return ",".join(texts)


def read_ranges(text: str, most: int) -> list[range] | None:
    """Return the ranges in a text of `ranges_text`, such as `0..15,20`, in its order.

    Return None if it is malformed, a range is empty, or a value is larger than `most`. Ranges may
    overlap."""
    ranges: list[range] = []
    for range_text in text.split(","):
        match = _RANGE.fullmatch(range_text)
        if match is None:
            return None
        first = int(match[1])
        last = int(match[2]) if match[2] else first
        step = int(match[3]) if match[3] else 1
        if not first <= last <= most or step < 1:
            return None
        ranges.append(range(first, last + 1, step))
    return ranges


def slots_text(slots: Bools) -> str:
    """Return the open slots of a shutter, bool (slots,), as text: ranges of slots, `never`, or `x`
    and hexadecimal digits.

    Ranges are as in `ranges_text`. The hexadecimal form is used for a shutter that opens and closes
    often, if it is shorter. It has two digits for each byte; slot 8 k + i is bit i of byte k."""
    if not slots.any():
        return "never"
    # The boundaries at which the shutter opens and closes, in turn.
    turns = np.flatnonzero(np.diff(slots, prepend=False, append=False)).tolist()
    hexadecimal = 1 + 2 * ((len(slots) + 7) // 8)  # characters: `x`, and two for each byte
    if len(turns) <= _FEW_TURNS:
        runs = zip(turns[::2], turns[1::2], strict=True)
        return ",".join(f"{a}..{b - 1}" if b - a > 1 else str(a) for a, b in runs)
    # A range takes at least two characters, which bounds the length without formatting.
    if len(turns) < 4 * hexadecimal:
        ranges = ranges_text(np.flatnonzero(slots).tolist())
        # Ranges are easier to read, so short ones are used even if they are longer.
        if len(ranges) <= max(hexadecimal, 20):
            return ranges
    return "x" + np.packbits(slots, bitorder="little").tobytes().hex()


def read_slots(text: str, slots: int) -> Bools | None:
    """Return the open slots, bool (slots,), in a text of `slots_text`; `slots` is their number.

    Return None if the text is malformed, or names a slot beyond the last."""
    opened = np.zeros(slots, dtype=np.bool_)
    if text == "never":
        return opened
    if text.startswith("x"):
        if len(text) != 1 + 2 * ((slots + 7) // 8) or not re.fullmatch("[0-9a-fA-F]+", text[1:]):
            return None
        packed = np.frombuffer(bytes.fromhex(text[1:]), dtype=np.uint8)
        bits = np.unpackbits(packed, bitorder="little").view(np.bool_)
        return None if bits[slots:].any() else bits[:slots]
    ranges = read_ranges(text, slots - 1)
    if ranges is None:
        return None
    for span in ranges:
        opened[span.start : span.stop : span.step] = True
    return opened


def block_text(lines: Sequence[str]) -> list[str]:
    """Return lines of free text for assembly text, each after a bar: `| text`, or `|` for an empty
    line.

    Lines that are unprintable or end in a blank are written as JSON strings after `|=`."""
    return [
        f"| {line}"
        if line.isprintable() and not line.endswith(" ") and line
        else "|"
        if not line
        else f"|= {json.dumps(line)}"
        for line in lines
    ]


def base64_lines(data: bytes) -> list[str]:
    """Return data as lines of base64 with at most `_BASE64_WIDTH` characters, each after a bar."""
    text = b64encode(data).decode("ascii")
    return [f"| {text[at : at + _BASE64_WIDTH]}" for at in range(0, len(text), _BASE64_WIDTH)]


def read_block_line(text: str) -> str | None:
    """Return the text of one line of `block_text`, which begins with its bar.

    Return None if no blank follows the bar, or if what follows `|=` is not a JSON string."""
    if text == "|":
        return ""
    if text.startswith("| "):
        return text[2:]
    if text.startswith("|= "):
        return read_string(text[3:])
    return None


def read_string(text: str) -> str | None:
    """Return the text that a JSON string in quotation marks describes; None if it is not a JSON
    string."""
    try:
        value = json.loads(text)
    except (ValueError, RecursionError):
        return None
    return value if isinstance(value, str) else None
