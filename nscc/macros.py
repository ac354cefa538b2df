"""Assembly mnemonics and their expansion to operations.

Mnemonics are the names of whole words in the table of operations, the macros of the public SCAMP-5
library, and the in-place forms (`NOT d`, `OR d, x`, `NOR d, x`, `REFRESH d`), which are pairs of
half-words. `OR` and `NOR` are in place if they have a single source, or if the destination is one
of several sources.

Operands are register names, destinations first."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cache, partial
from itertools import groupby

from nscc.operations import (
    ANALOG_SOURCES,
    ANALOG_WRITE,
    BY_NAME,
    DIGITAL_SOURCES,
    DIGITAL_WRITE,
    OPERATIONS,
    READ_LINES,
    Op,
    Operation,
    Phase,
    make_op,
    pair,
)
from nscc.record import Record

SCRATCH, GUARD, GUARDED = "NEWS", "R0", "R12"
"""Registers that macros overwrite: the analog scratch, the write mask and the masked register."""


class OperandError(Exception):
    """Raised for operands that a mnemonic does not accept.

    `index` is the number of the invalid operand, from 0, None if no single operand is invalid."""

    def __init__(self, message: str, index: int | None = None) -> None:
        """Store what is wrong with operand number `index`; None if no single operand is invalid."""
        super().__init__(message)
        self.message = message
        self.index = index


Ops = tuple[Op, ...]


class Mnemonic(Record):
    """The name at the start of an assembly instruction, with what it stands for.

    `usage` shows its forms. `write` returns its words for operands (names of registers), of which
    it takes `least` to `most` (None: any number). It overwrites the registers `scratch`, which
    cannot be operands."""

    name: str
    usage: str
    write: Callable[[Sequence[str]], Ops]
    least: int
    most: int | None
    scratch: tuple[str, ...] = ()


def expand(name: str, operands: Sequence[str], own_words: tuple[Operation, ...] = ()) -> Ops:
    """Return the words of an assembly instruction: mnemonic `name` with names of registers as
    `operands`, destinations first.

    `own_words` are operations that only the target has. Raises KeyError for an unknown mnemonic and
    OperandError for invalid operands."""
    mnemonic = mnemonics(own_words)[name]
    count = len(operands)
    for index, register in enumerate(operands):
        if register not in READ_LINES:
            raise OperandError(f"unknown register {register!r}", index)
    if count < mnemonic.least or (mnemonic.most is not None and count > mnemonic.most):
        takes = f"{name} takes {_count(mnemonic)}, not {count}"
        raise OperandError(f"{takes}: write `{mnemonic.usage}`")
    for index, register in enumerate(operands):
        if register in mnemonic.scratch:
            why = f"{name} overwrites {' and '.join(mnemonic.scratch)}"
            raise OperandError(f"{why}, so {register} cannot be its operand", index)
    try:
        return mnemonic.write(operands)
    except OperandError as error:
        if error.index is not None:
            raise
        raise OperandError(f"{name} cannot take these operands: {error}") from None


def _count(mnemonic: Mnemonic) -> str:
    """Return how many operands a mnemonic takes, as text such as "2 to 4 operands"."""
    low, high = mnemonic.least, mnemonic.most
    if high is None:
        return f"{low} or more operands"
    if low == high:
        return ("no operands", "1 operand")[low] if low < 2 else f"{low} operands"
    return f"{low} to {high} operands"


def _word(row: Operation, destinations: Sequence[str], sources: Sequence[str]) -> Op:
    """Return the word of the operation `row` that writes `destinations` and reads `sources`.

    Raises OperandError with the index of the first invalid operand, counted over destinations and
    then sources."""
    analog = row.analog
    writable = ANALOG_WRITE if analog else DIGITAL_WRITE
    readable = ANALOG_SOURCES if analog else DIGITAL_SOURCES
    kind = "analog" if analog else "digital"
    for index, register in enumerate(destinations):
        if register not in writable:
            register_of = f"a{'n' if analog else ''} {kind} register ({_listed(writable)})"
            raise OperandError(f"{row.name} writes {register_of}, not {register}", index)
        if register in destinations[:index]:
            raise OperandError(
                f"{row.name} names {register} twice as a destination: name different ones", index
            )
    for index, register in enumerate(sources, start=len(destinations)):
        if register not in readable:
            reads = f"{row.name} reads {kind} sources ({_listed(readable)})"
            raise OperandError(f"{reads}, not {register}", index)
        if register in sources[: index - len(destinations)]:
            message = f"{row.name} names {register} twice: a word reads a register once"
            raise OperandError(message, index)
        if register in destinations:
            message = f"{row.name} cannot write {register} and read it in the same word"
            raise OperandError(message, index)
    return make_op(row, destinations, sources)


def _listed(names: Sequence[str] | dict[str, int]) -> str:
    """Return the names of registers as text; all digital ones together are "R0, R1, ..", which
    comes first."""
    listed = [name for name in names if not (name[:1] == "R" and name[1:].isdecimal())]
    digital = len(listed) < len(tuple(names))
    return ", ".join((["R0, R1, .."] if digital else []) + listed)


def _native(row: Operation) -> Mnemonic:
    """Return the mnemonic of `row`, a single operation.

    Its operands are the destinations, then the sources. Either number may vary, but not both."""
    least_destinations, most_destinations = row.destinations  # a most of None is any number
    least_sources, most_sources = row.sources
    # SET, CLR and WHERE have one kind of operand, so this split is unambiguous.
    split = None if most_destinations is None else least_destinations

    def write(operands: Sequence[str]) -> Ops:
        """Return the one word of an instruction that the chip has."""
        split_at = len(operands) if split is None else split
        return (_word(row, operands[:split_at], operands[split_at:]),)

    most = None
    if most_destinations is not None and most_sources is not None:
        most = most_destinations + most_sources
    several = (
        ", ".join(f"d{i}" for i in range(least_destinations)) if least_destinations > 1 else "d"
    )
    dest = "d0, d1, .." if most_destinations is None else several
    src = "" if most_sources == 0 else "x" if row.sources == (1, 1) else "x0, x1, .."
    operands = filter(None, (dest if least_destinations else "", src))
    usage = f"{row.name} {', '.join(operands)}".strip()
    least = least_destinations + least_sources
    return Mnemonic(row.name, usage, write, least, most)


# In-place forms, and mnemonics of the same names.
def _in_place(kind: str, operands: Sequence[str]) -> Ops:
    """Return the pair of words that writes the OR, NOR or REFRESH (`kind`) of all operands to the
    first one.

    Raises OperandError for a register that is not digital."""
    for index, register in enumerate(operands):
        allowed = DIGITAL_SOURCES if index else DIGITAL_WRITE
        if register not in allowed:
            takes = f"{kind} in place takes digital registers ({_listed(allowed)})"
            raise OperandError(f"{takes}, not {register}", index)
    return pair(kind, operands[0], operands)


def _not(x: Sequence[str]) -> Ops:
    """Return the words that write the inverse of the second of the operands `x` to the first, or
    invert a single one in place. Raises OperandError for invalid operands."""
    return _in_place("NOR", x) if len(x) == 1 else (_word(BY_NAME["NOT"], x[:1], x[1:]),)


def _or_nor(kind: str, x: Sequence[str]) -> Ops:
    """Return the words of OR or NOR (`kind`): one word, or a pair if it works in place.

    The operands `x` are the destination and the sources. It is in place if the destination is also
    a source, or if there is only one source. Raises OperandError if a source occurs twice."""
    destination, sources = x[0], x[1:]
    if len(sources) > 1 and destination not in sources:
        return (_word(BY_NAME[kind], x[:1], sources),)
    for index, register in enumerate(sources, start=1):
        if register in sources[: index - 1]:
            raise OperandError(f"{kind} names {register} twice as a source: name it once", index)
    other_sources = [register for register in sources if register != destination]
    return _in_place(kind, (destination, *other_sources))


_WORDS = {row.name: _native(row) for row in OPERATIONS}


# One form a line. NEWS carries analog values; since each word inverts, two preserve the sign.
# Digital macros that combine two terms end in NOR or OR of R0 and R12 (or b).
_MACROS = """
res a: bus NEWS; bus a, NEWS
res a, b: bus NEWS; bus a, NEWS; bus b, NEWS
mov y, x: bus NEWS, x; bus y, NEWS
add y, x0, x1[, x2]: bus NEWS, x0, x1[, x2]; bus y, NEWS
sub y, x0, x1: bus NEWS, x0; bus y, NEWS, x1
neg y, x: bus NEWS; bus y, NEWS, x
abs y, x: bus NEWS; bus y, NEWS, x; bus NEWS, x; where x; bus y, NEWS; all
div y0, y1, y2, x: bus2 y0, y1, x; bus NEWS, x, y1; bus y2, NEWS, y0; bus2 y0, y1, y2; bus y0, y1
diva y0, y1, y2: bus2 y1, y2, y0; bus NEWS, y1, y0; bus y0, NEWS, y2; bus2 y1, y2, y0; bus y0, y1
respix: rpix; rpix; nop
respix y: rpix; rpix; nop; bus NEWS, PIX; bus y, NEWS
get_image y: bus NEWS, PIX; rpix; rpix; nop; bus y, NEWS, PIX
get_image y, h: bus NEWS, PIX; bus h, PIX; rpix; rpix; nop; bus y, h, NEWS, PIX
getpix y, r: bus NEWS, PIX; bus y, NEWS, r
getpix y, h, r: bus h, PIX; bus NEWS, PIX; bus y, h, NEWS, r
AND a, x, y: SET R0; NOT R12, x; NOT R0, y; NOR a, R0, R12
NAND a, x, y: SET R0; NOT R12, x; NOT R0, y; OR a, R0, R12
ANDX a, b, x: NOT R0, b; NOT b, x; NOR a, R0, b
NANDX a, b, x: NOT R0, b; NOT b, x; OR a, R0, b
IMP l, x, y: NOT R0, y; OR l, x, R0
NIMP l, x, y: NOT R0, y; NOR l, x, R0
CLR_IF l, x: NOT R0, l; NOR l, R0, x
XORX l, x, y: NOT R0, y; NOR l, x, R0; NOT R0, x; NOR x, y, R0; OR.read l, x; OR.write l
MUX l, x, y, z: SET R0; MOV R12, z; MOV R0, x; MOV R12, y; MOV l, R12
"""

_DISTINCT = {
    "div y0, y1, y2, x": "its three registers and its source must be four",
    "diva y0, y1, y2": "its registers must be three",
    "getpix y, h, r": "y, h and r must be three registers",
    "CLR_IF l, x": "the register and its condition must differ",
    "XORX l, x, y": "l, x and y must be three registers",
}
"""Forms whose operands must all be different, with the reason."""


class _Form:
    """One form of a macro: a number of operands, and the words that it stands for."""

    def __init__(self, line: str) -> None:
        """Read a line of `_MACROS` such as `mov y, x: bus NEWS, x; bus y, NEWS`: the operands, then
        the words."""
        self.head, _, words = line.partition(": ")
        self.name, *self.operands = self.head.replace(",", "").split()
        split = [word.replace(",", "").split() for word in words.split("; ")]
        self.words = [(_WORDS[name], operands) for name, *operands in split]

    def write(self, arguments: Sequence[str]) -> Ops:
        """Return the words of this form for these operands, as many as the form has; raise
        OperandError for invalid ones."""
        for index, register in enumerate(arguments if self.head in _DISTINCT else ()):
            if register in arguments[:index]:
                why = _DISTINCT[self.head]
                raise OperandError(f"{self.name} names {register} twice: {why}", index)
        meant = dict(zip(self.operands, arguments, strict=True))
        try:
            written = [word.write([meant.get(n, n) for n in names]) for word, names in self.words]
        except OperandError as error:  # reported for the whole macro
            raise OperandError(f"one of its words is invalid: {error}") from None
        return tuple(op for words in written for op in words)


def _macros() -> Iterator[Mnemonic]:
    """Yield the mnemonics of all macros; registers that their words name themselves are scratch
    registers."""
    for name, lines in groupby(_MACROS.strip().split("\n"), lambda line: re.split("[ :]", line)[0]):
        shown, forms = [], {}
        for line in lines:
            shown.append(line.partition(":")[0])
            # Parts in brackets are optional: a form without them, and one with them.
            for text in (re.sub(r"\[.*?\]", "", line), re.sub(r"[\[\]]", "", line)):
                forms[len(_Form(text).operands)] = _Form(text)
        scratch = {r for form in forms.values() for _, operands in form.words for r in operands[:1]}
        passed = tuple(r for r in (SCRATCH, GUARD, GUARDED) if r in scratch)
        usage, write = "` or `".join(shown), partial(_written, forms)
        yield Mnemonic(name, usage, write, min(forms), max(forms), passed)


def _written(forms: Mapping[int, _Form], arguments: Sequence[str]) -> Ops:
    """Return the words for the operands `arguments`. `forms` has the forms of a macro by their
    number of operands, among which this number is."""
    return forms[len(arguments)].write(arguments)


_IN_PLACE = (
    Mnemonic("REFRESH", "REFRESH d", lambda x: _in_place("REFRESH", x), 1, 1),
    Mnemonic("NOT", "NOT d, x` or, in place, `NOT d", _not, 1, 2),
    Mnemonic("OR", "OR d, x0, x1, ..` or, in place, `OR d, x", partial(_or_nor, "OR"), 2, None),
    Mnemonic("NOR", "NOR d, x0, x1, ..` or, in place, `NOR d, x", partial(_or_nor, "NOR"), 2, None),
)

MNEMONICS: dict[str, Mnemonic] = {
    **{row.name: _WORDS[row.name] for row in OPERATIONS if row.phase is Phase.WHOLE},
    **{macro.name: macro for macro in (*_macros(), *_IN_PLACE)},
}
"""Mnemonics by name; names are case sensitive (`where` is analog, `WHERE` digital)."""


@cache
def mnemonics(own_words: tuple[Operation, ...] = ()) -> dict[str, Mnemonic]:
    """Return all mnemonics by name, including those of a target's own words, which replace others
    of the same name."""
    return MNEMONICS | {row.name: _native(row) for row in own_words}
