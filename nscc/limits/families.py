"""The shutter classes as families of programs: one program text for each size.

A size is a number of slots, or of codebook rows. A codebook's data are fixed pseudo-random rows,
which gates cannot share."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from decimal import Decimal
from typing import Literal

from nscc.arrays import Bools
from nscc.program.limits import MOST_SLOTS, PROOF_LIMIT, largest_with
from nscc.record import Record

MOST_DIGITS = 1 << 14
"""Most rows x slots of a codebook that is compiled for a limit; larger codebooks take long."""

BUMP_LENGTHS = (4, 8, 16)
"""The lengths in slots of the open intervals for which a table of limits is computed."""
BOOK_ROWS = (16, 64, 256)
"""The numbers of codebook rows for which the most slots are searched."""
BOOK_SLOTS = 16
"""The number of slots for which the most codebook rows are searched."""

_WORD = 1 << 64
"""Pseudo-random numbers are computed modulo this number, as 64-bit words."""


class Family(Record):
    """A class of shutters as programs of every size.

    `text(size, slot)` returns a program without pixel codes; `slot` is the slot length as written
    in a program. `shutters(size)` returns its number of different shutters, `slots(size)` its
    number of slots. `nested` means that the program for one size includes all smaller sizes, so
    that all sizes above an impossible size are impossible. `counted_as` describes the count of
    shutters. `least` and `ceiling` are the smallest and largest size to compile, the latter for the
    reason `ceiling_reason`."""

    name: str
    description: str
    unit: Literal["slots", "rows"]
    text: Callable[[int, str], str]
    shutters: Callable[[int], int]
    counted_as: str
    slots: Callable[[int], int]
    nested: bool
    least: int
    ceiling: int
    ceiling_reason: str


def families() -> list[Family]:
    """Return the families: classes a to e (class b with and without the shutter that never opens,
    class c with the lengths BUMP_LENGTHS), and codebooks."""
    return [
        _by_slots("a", "always open", "open when true", lambda _slots: 1, "1 shutter"),
        _by_slots("b 1..N", "open from slot 0 to a stop", stop_rule("1"), lambda n: n, "N stops"),
        _by_slots(
            "b 0..N", "the same, or never open", stop_rule("0"), lambda n: n + 1, "N + 1 stops"
        ),
        *map(_fixed_bump, BUMP_LENGTHS),
        _by_slots(
            "d",
            "one bump, any start and stop",
            bump_rule(),
            lambda n: n * (n + 1) // 2,
            "N (N + 1) / 2 bumps",
        ),
        _by_slots("e", "every pattern of N bits", bits_rule(), lambda n: 1 << n, "2^N patterns"),
        *map(_book_by_slots, BOOK_ROWS),
        _book_by_rows(BOOK_SLOTS),
    ]


def stop_rule(first: str) -> str:
    """Return the statements of class b, one a line: open from slot 0 to a stop of `first`..N.
    `first` is "1", or "0" to include a code that never opens."""
    return f"code stop : {first}..N\nopen when n < stop"


def start_rule(length: int) -> str:
    """Return the statements of class c: a bump of `length` slots anywhere in the frame."""
    return f"code start : 0..N - {length}\nopen when start <= n < start + {length}"


def bump_rule() -> str:
    """Return the statements of class d: a bump with any start and stop."""
    return (
        "code start : 0..N - 1\ncode stop : 1..N\nrequire start < stop\nopen when start <= n < stop"
    )


def bits_rule() -> str:
    """Return the statements of class e: every pattern of N bits."""
    return "code bits : bit[N]\nopen when bits[n]"


def book_rule(rows: list[str]) -> str:
    """Return the statements of a codebook whose rows are texts of digits 0 and 1, slot 0 first, one
    row for each shutter and all of equal length."""
    return f"shutters book [{', '.join(rows)}]\ncode id : row of book\nopen when book[id]"


def book_text(slot_us: Sequence[float], buckets: Sequence[str], shutters: Bools) -> str:
    """Return a program whose code `id` is an index into `shutters`, bool (rows, buckets, slots).

    It has a codebook for each bucket, named in `buckets`, and slots of `slot_us` microseconds. A
    single bucket gets no name in the program."""
    # Decimal writes 1e-05 without an exponent, which the language does not have.
    times = ", ".join(f"{Decimal(repr(us)):f}us" for us in slot_us)
    lines, rules = ["nsl 1", f"frame slots [{times}]"], []
    for number, name in enumerate(buckets):
        rows = ("".join("1" if is_open else "0" for is_open in row) for row in shutters[:, number])
        lines.append(f"shutters book{number} [{', '.join(rows)}]")
        rules.append((f"bucket {name} open", f"book{number}[id]"))
    if len(rules) == 1:
        rules = [("open", rules[0][1])]
    lines.append("code id : row of book0")
    lines += [f"{head} when {rule}" for head, rule in rules]
    return "\n".join(lines) + "\n"


def program_text(slots: int, slot: str, rule: str) -> str:
    """Return a program of version 1 with equal slots and the statements `rule`; `slots` is their
    number, `slot` their length as written, such as "125us"."""
    return f"nsl 1\nframe {slots} slots of {slot}\n{rule}\n"


def random_rows(count: int, slots: int) -> list[str]:
    """Return `count` distinct pseudo-random rows of `slots` digits 0 and 1, the same on every
    machine, as texts.

    If there are fewer than `count` different rows of `slots` digits, return all of them. The rows
    for a smaller count are the first of those for a larger one."""
    rows: dict[str, None] = {}
    words = -(-slots // 64)
    number = 0
    while len(rows) < min(count, 1 << slots):
        digits = "".join(f"{_mixed(number + word):064b}" for word in range(words))
        rows.setdefault(digits[:slots])
        number += words
    return list(rows)


def _mixed(number: int) -> int:
    """Return 64 pseudo-random bits from a counter, by the mixer of SplitMix64 (Steele et al.,
    2014)."""
    bits = number * 0x9E3779B97F4A7C15 % _WORD
    bits = (bits ^ bits >> 30) * 0xBF58476D1CE4E5B9 % _WORD
    bits = (bits ^ bits >> 27) * 0x94D049BB133111EB % _WORD
    return bits ^ bits >> 31


def _by_slots(
    name: str,
    description: str,
    rule: str,
    shutters: Callable[[int], int],
    counted_as: str,
    least: int = 1,
) -> Family:
    """Return the family of programs with the statements `rule`, whose size is the number of slots.
    A program includes those of fewer slots.

    `shutters` gives the number of shutters for a size, and `counted_as` the same as text. `least`
    is the smallest size. The largest size follows from the limit on codes x slots that nscc proves,
    or from the longest frame."""
    ceiling = largest_with(
        lambda slots: shutters(slots) * slots, PROOF_LIMIT, least=1, ceiling=MOST_SLOTS
    )
    reason = f"nscc proves at most {PROOF_LIMIT} codes x slots (NS0450)"
    if ceiling == MOST_SLOTS:
        reason = f"a frame has at most {MOST_SLOTS} slots (NS0308)"
    return Family(
        name,
        description,
        unit="slots",
        text=lambda size, slot: program_text(size, slot, rule),
        shutters=shutters,
        counted_as=counted_as,
        slots=lambda size: size,
        nested=True,
        least=least,
        ceiling=ceiling,
        ceiling_reason=reason,
    )


def _fixed_bump(length: int) -> Family:
    """Return the family of class c: bumps of `length` slots, one shutter for each start. The
    smallest frame has `length` slots."""
    return _by_slots(
        f"c len {length}",
        f"a bump of {length} slots, any start 0..N - {length}",
        start_rule(length),
        lambda slots: max(1, slots - length + 1),
        f"N - {length - 1} starts",
        least=length,
    )


def _book_by_slots(rows: int) -> Family:
    """Return the family of codebooks with `rows` pseudo-random rows; its sizes are numbers of
    slots, from the fewest that have so many different rows."""
    return Family(
        name=f"codebook, {rows} rows",
        description="pseudo-random rows of N slots",
        unit="slots",
        text=lambda size, slot: program_text(size, slot, book_rule(random_rows(rows, size))),
        shutters=lambda _size: rows,
        counted_as=f"{rows} rows",
        slots=lambda size: size,
        nested=False,
        # Fewer slots have fewer than `rows` different rows.
        least=(rows - 1).bit_length(),
        ceiling=MOST_DIGITS // rows,
        ceiling_reason=f"codebooks of more than {MOST_DIGITS} digits take long and are not tried",
    )


def _book_by_rows(slots: int) -> Family:
    """Return the family of codebooks of `slots` slots; its sizes are numbers of pseudo-random rows,
    at most as many as there are different rows."""
    return Family(
        name=f"codebook, {slots} slots",
        description="K pseudo-random rows",
        unit="rows",
        text=lambda size, slot: program_text(slots, slot, book_rule(random_rows(size, slots))),
        shutters=lambda size: size,
        counted_as="K rows",
        slots=lambda _size: slots,
        nested=False,
        least=1,
        ceiling=min(MOST_DIGITS // slots, 1 << slots),
        ceiling_reason=f"codebooks of more than {MOST_DIGITS} digits take long and are not tried",
    )
