"""Encoding of operations as 160-bit instruction words (ICW), and decoding; both are exact.

A word is five 32-bit integers. Bits 0-15 of each contain control lines (line k in word k // 16, bit
k % 16), bits 16-18 the integer's index 0..4, and bits 19-21 of the first the clock class. Lines 80
and up belong to registers R13.. of chips whose word format is not published: they are placed in the
bits 19..31 that the integers 1..4 leave unused, line 80 + k in integer 1 + k // 13, bit 19 + k %
13.

Inside this module a word is one 160-bit integer, with the first 32-bit integer lowest."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache, lru_cache
from struct import Struct
from typing import NamedTuple

from nscc.diagnostics.diagnostic import Diagnostic, Rejected
from nscc.operations import (
    ANALOG_SOURCES,
    ANALOG_WRITE,
    BIT,
    BITMODE,
    DIGITAL_SOURCES,
    DIGITAL_WRITE,
    EXTRA_LINES,
    FIRST_EXTRA_LINE,
    LINE_NAMES,
    NBIT,
    NEIGHBOURS,
    OPERATIONS,
    PLRB,
    PLWB,
    READ_LINES,
    RID,
    RSTPIX,
    S_IN,
    SETF,
    WRF,
    Op,
    Operation,
    Word,
    WordEffect,
    make_op,
)

_INTEGER = 0xFFFF_FFFF
"""The largest of the five integers that make up a word."""
_FIVE = Struct("<5I")
_CLOCK_SHIFT = 19
"""Position of the clock's three bits in the first integer of a word."""
_EXTRAS_A_WORD = 13
"""Control lines beyond SCAMP-5d's in each of the last four integers: their bits 19 to 31."""


def _bit(line: int) -> int:
    """Return the 160-bit word in which only the control line with the number `line` is 1."""
    if line < FIRST_EXTRA_LINE:
        return 1 << (32 * (line // 16) + line % 16)
    extra = line - FIRST_EXTRA_LINE
    return 1 << (32 * (1 + extra // _EXTRAS_A_WORD) + 19 + extra % _EXTRAS_A_WORD)


def _raised(lines: Iterable[int]) -> int:
    """Return the 160-bit word in which the control lines with these numbers are 1, and all other
    bits 0."""
    word = 0
    for line in lines:
        word |= _bit(line)
    return word


_INDEX = sum(index << (32 * index + 16) for index in range(5))
"""The indices of the five integers, which every word has in bits 16-18 of each."""
_CLOCK = 7 << _CLOCK_SHIFT
"""The bits of the clock."""
_READ = {name: _raised(lines) for name, lines in (READ_LINES | NEIGHBOURS).items()}
# The destination of an analog word is selected like a source, and written.
_WRITE = {name: _READ[name] | _bit(line) for name, line in ANALOG_WRITE.items()}
_WRITE |= {name: _bit(line) for name, line in DIGITAL_WRITE.items()}
_WRITE |= {name: _READ[name] | _bit(ANALOG_WRITE["NEWS"]) for name in NEIGHBOURS}
_ALL_LINES = {_bit(line): line for line in range(FIRST_EXTRA_LINE + EXTRA_LINES)}

# The lines that distinguish operations; all others only name operands. selpix and s_in do both, so
# an ambiguous analog word is decided by encoding each candidate again.
_KIND_ANALOG = _raised((RSTPIX, WRF, SETF, PLRB, RID))
_KIND_DIGITAL = _raised((S_IN, WRF, PLWB, PLRB, NBIT, BIT, BITMODE, RID))


@cache
def _fixed(row: Operation) -> int:
    """Return the bits that every word of the operation `row` has, as a 160-bit word: indices, clock
    class and its own control lines."""
    return _INDEX | row.clock << _CLOCK_SHIFT | _raised(row.lines)


_ANALOG_READS = tuple((name, _READ[name]) for name in (*ANALOG_SOURCES, *NEIGHBOURS))
_ANALOG_WRITES = tuple((name, _WRITE[name]) for name in (*ANALOG_WRITE, *NEIGHBOURS))
_DIGITAL_READS = tuple((name, _READ[name]) for name in DIGITAL_SOURCES)
_DIGITAL_WRITES = tuple((name, _WRITE[name]) for name in DIGITAL_WRITE)


def _split(word: int) -> Word:
    """Return a word of 160 bits as five integers of 32 bits, lowest first."""
    return _FIVE.unpack(word.to_bytes(_FIVE.size, "little"))


def _joined(word: Word) -> int:
    """Return five integers of 32 bits as one of 160 bits; the first is lowest."""
    return word[0] | word[1] << 32 | word[2] << 64 | word[3] << 96 | word[4] << 128


def _encoded(operation: Op) -> int:
    """Return the 160-bit word of an operation: its fixed bits and the control lines of its
    registers.

    Raises KeyError for a register that has no control line."""
    word = _fixed(operation.operation)
    for register in operation.destinations:
        word |= _WRITE[register]
    for register in operation.sources:
        word |= _READ[register]
    return word


@lru_cache(maxsize=1 << 14)
def encode(operation: Op) -> Word:
    """Return the word of an operation as five 32-bit integers.

    Raises KeyError for a register that has no control line."""
    return _split(_encoded(operation))


@lru_cache(maxsize=1 << 14)
def matching(word: Word, target_operations: tuple[Operation, ...] = ()) -> Op | None:
    """Return the operation whose word is exactly this one; None if there is none, or if `word` is
    not five integers of 32 bits.

    `target_operations` are operations that only the target has, in addition to those of all chips,
    which come first."""
    if len(word) != 5 or not all(0 <= integer <= _INTEGER for integer in word):
        return None
    bits = _joined(word)
    clock = (bits & _CLOCK) >> _CLOCK_SHIFT
    analog = clock == 0
    kind = _KIND_ANALOG if analog else _KIND_DIGITAL
    reads, writes = (_ANALOG_READS, _ANALOG_WRITES) if analog else (_DIGITAL_READS, _DIGITAL_WRITES)
    destinations = [name for name, mask in writes if bits & mask == mask]
    read = [name for name, mask in reads if bits & mask == mask]
    rows = [row for row in OPERATIONS if row.clock == clock and not (_fixed(row) ^ bits) & kind]
    for row in (*rows, *target_operations):
        sources = read
        if row.effect in (WordEffect.BUS, WordEffect.RESET_PIX, WordEffect.NONE):
            # Selecting a destination raises the same line as reading it.
            sources = [name for name in read if not _fixed(row) & _READ[name]]
            sources = [name for name in sources if name not in destinations]
        if not _fits(len(destinations), row.destinations) or not _fits(len(sources), row.sources):
            continue
        try:
            operation = make_op(row, destinations, sources)
        except ValueError:
            continue
        if _encoded(operation) == bits:
            return operation
    return None


def _fits(count: int, allowed: tuple[int, int | None]) -> bool:
    """Return whether a count is in the range `allowed` (fewest, most); None for the most is no
    limit."""
    low, high = allowed
    return count >= low and (high is None or count <= high)


def decode(word: Word, place: str = "") -> Op:
    """Return the operation, of those that all chips have, whose word this is.

    `place` tells where the word is, for the message. Raises Rejected (NS0701) if there is none."""
    operation = matching(word)
    if operation is None:
        raise Rejected(no_operation(word, place))
    return operation


def no_operation(word: Word, place: str = "") -> Diagnostic:
    """Return the error (NS0701) for a word that matches no operation.

    Its notes list the control lines that are 1 and wrong indices. `place` tells where the word is;
    "" if unknown."""
    notes = []
    bits = _joined(word)
    wrong_indices = [i for i in range(5) if word[i] >> 16 & 7 != i]  # bits 16-18 of integer i
    if wrong_indices:
        listed = ", ".join(f"{i} (0x{word[i]:05x})" for i in wrong_indices)
        notes.append(f"bits 16-18 of each integer must hold its index 0..4; wrong in {listed}")
    names = [LINE_NAMES.get(line, f"line {line}") for line in word_lines(word)]
    clock = (bits & _CLOCK) >> _CLOCK_SHIFT
    raised = ", ".join(names) if names else "none"
    notes.append(f"it raises these control lines: {raised} (clock class {clock})")
    return Diagnostic(
        "NS0701",
        f"{place + ': ' if place else ''}unknown word, which matches no operation: "
        f"{word_text(word)}",
        notes=tuple(notes),
        helps=("compile or assemble the program again; `nscc disasm` lists its words",),
        data={"word": list(word), "lines": names},
    )


def word_lines(word: Word) -> tuple[int, ...]:
    """Return the numbers of the control lines that a word raises, ascending."""
    bits = _joined(word)
    return tuple(line for mask, line in _ALL_LINES.items() if bits & mask)


def word_text(word: Word) -> str:
    """Return the five integers of a word in hexadecimal, such as `0x80020`, separated by blanks."""
    return " ".join(f"0x{integer:05x}" for integer in word)


class Masks(NamedTuple):
    """The layout of words as masks, by name of operation or register.

    `fixed` are the bits that every word of an operation has, `read` those that a source adds,
    `written` those that a destination adds. `kind_analog` and `kind_digital` are the control lines
    that distinguish operations of analog and of digital words."""

    fixed: dict[str, Word]
    read: dict[str, Word]
    written: dict[str, Word]
    kind_analog: Word
    kind_digital: Word


def masks() -> Masks:
    """Return the bits of all operations and registers of all chips, from which the firmware's
    decoder is generated."""
    return Masks(
        {row.name: _split(_fixed(row)) for row in OPERATIONS},
        {name: _split(word) for name, word in _READ.items()},
        {name: _split(word) for name, word in _WRITE.items()},
        _split(_KIND_ANALOG),
        _split(_KIND_DIGITAL),
    )
