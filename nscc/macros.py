"""Mnemonics: what an assembly line may say, written out as operations of the table.

Every name of the table that is a whole word is a mnemonic. Besides there are the macros of the
public SCAMP-5 library under their own names, and the in-place forms (`NOT d`, `OR d, x`,
`NOR d, x`, `REFRESH d`), which are pairs of half-words. `OR` and `NOR` with one source are always
in place; with more they are where the destination is also written among the sources.

Operands are register names, destinations first.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache

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
    made,
    op,
    pair,
)

SCRATCH, GUARD, GUARDED = "NEWS", "R0", "R12"
"""What macros pass through: the analog scratch, the write mask and the register it masks."""


class OperandError(Exception):
    """Operands that a mnemonic does not take; `index` is the operand at fault, None for all."""

    def __init__(self, message: str, index: int | None = None) -> None:
        super().__init__(message)
        self.message = message
        self.index = index


Ops = tuple[Op, ...]


@dataclass(frozen=True)
class Mnemonic:
    """A name that an assembly line may begin with.

    `usage` shows the forms; `counts` are the numbers of operands it takes (None: `least` or
    more). `scratch` are registers that it overwrites on its way, so they cannot be operands.
    """

    name: str
    usage: str
    write: Callable[[Sequence[str]], Ops]
    least: int
    most: int | None
    scratch: tuple[str, ...] = ()


def expand(name: str, operands: Sequence[str], own: tuple[Operation, ...] = ()) -> Ops:
    """The operations that a line `name operands` stands for; `own` are a target's own words.

    Raises KeyError for a name that is no mnemonic and OperandError for operands it does not take.
    """
    mnemonic = mnemonics(own)[name]
    count = len(operands)
    for index, register in enumerate(operands):
        if register not in READ_LINES:
            raise OperandError(f"{register!r} is no register", index)
    if count < mnemonic.least or (mnemonic.most is not None and count > mnemonic.most):
        raise OperandError(
            f"{name} takes {_count(mnemonic)}, not {count}: write `{mnemonic.usage}`"
        )
    for index, register in enumerate(operands):
        if register in mnemonic.scratch:
            raise OperandError(
                f"{name} overwrites {' and '.join(mnemonic.scratch)} on its way, so {register} "
                "cannot be its operand",
                index,
            )
    try:
        return mnemonic.write(operands)
    except OperandError as error:
        if error.index is not None:
            raise
        raise OperandError(f"{name} cannot take these operands: {error}") from None


def _count(mnemonic: Mnemonic) -> str:
    low, high = mnemonic.least, mnemonic.most
    if high is None:
        return f"{low} or more operands"
    if low == high:
        return ("no operands", "1 operand")[low] if low < 2 else f"{low} operands"
    return f"{low} to {high} operands"


def _word(row: Operation, destinations: Sequence[str], sources: Sequence[str]) -> Op:
    """A whole word, with its operands checked in the user's terms."""
    analog = row.analog
    writable = ANALOG_WRITE if analog else DIGITAL_WRITE
    readable = ANALOG_SOURCES if analog else DIGITAL_SOURCES
    kind = "analog" if analog else "digital"
    for index, register in enumerate(destinations):
        if register not in writable:
            raise OperandError(
                f"{row.name} writes a{'n' if analog else ''} {kind} register "
                f"({_listed(writable)}), and {register} is none",
                index,
            )
        if register in destinations[:index]:
            raise OperandError(f"{row.name} names {register} twice as a destination", index)
    for index, register in enumerate(sources, start=len(destinations)):
        if register not in readable:
            raise OperandError(
                f"{row.name} reads {kind} sources ({_listed(readable)}), and {register} is none",
                index,
            )
        if register in sources[: index - len(destinations)]:
            raise OperandError(
                f"{row.name} names {register} twice: a word reads a register once", index
            )
        if register in destinations:
            raise OperandError(
                f"{row.name} cannot write {register} and read it in the same word", index
            )
    return made(row, destinations, sources)


def _listed(names: Sequence[str] | dict[str, int]) -> str:
    listed = [name for name in names if not (name[:1] == "R" and name[1:].isdecimal())]
    digital = len(listed) < len(tuple(names))
    return ", ".join((["R0, R1, .."] if digital else []) + listed)


def _native(row: Operation) -> Mnemonic:
    low, high = row.destinations
    first, last = row.sources
    # SET, CLR and WHERE take any number of one kind of operand, so this split is never ambiguous.
    split = None if high is None else low

    def write(operands: Sequence[str]) -> Ops:
        at = len(operands) if split is None else split
        return (_word(row, operands[:at], operands[at:]),)

    most = None if high is None or last is None else high + last
    several = ", ".join(f"d{i}" for i in range(low)) if low > 1 else "d"
    dest = "d0, d1, .." if high is None else several
    src = "" if last == 0 else "x" if (first, last) == (1, 1) else "x0, x1, .."
    usage = f"{row.name} {', '.join(part for part in (dest if low else '', src) if part)}".strip()
    return Mnemonic(row.name, usage, write, low + first, most)


def _part(name: str, destinations: Sequence[str], sources: Sequence[str]) -> Op:
    """A word of a macro: what is wrong with it is said of the macro as a whole."""
    try:
        return _word(BY_NAME[name], destinations, sources)
    except OperandError as error:
        raise OperandError(f"one of the words that it stands for is wrong: {error}") from None


def _bus(destination: str, *sources: str) -> Op:
    return _part("bus", (destination,), sources)


def _bus2(first: str, second: str, *sources: str) -> Op:
    return _part("bus2", (first, second), sources)


def _bit(name: str, destination: str, *sources: str) -> Op:
    return _part(name, (destination,), sources)


def _distinct(name: str, operands: Sequence[str], why: str) -> None:
    for index, register in enumerate(operands):
        if register in operands[:index]:
            raise OperandError(f"{name} names {register} twice: {why}", index)


# Analog macros. NEWS passes every value on; as each word inverts, two keep the sign.
_RESET: Ops = (op("rpix"), op("rpix"), op("nop"))


def _res(x: Sequence[str]) -> Ops:
    return (_bus(SCRATCH), *(_bus(register, SCRATCH) for register in x))


def _mov(x: Sequence[str]) -> Ops:
    return (_bus(SCRATCH, x[1]), _bus(x[0], SCRATCH))


def _add(x: Sequence[str]) -> Ops:
    return (_bus(SCRATCH, *x[1:]), _bus(x[0], SCRATCH))


def _sub(x: Sequence[str]) -> Ops:
    return (_bus(SCRATCH, x[1]), _bus(x[0], SCRATCH, x[2]))


def _neg(x: Sequence[str]) -> Ops:
    return (_bus(SCRATCH), _bus(x[0], SCRATCH, x[1]))


def _abs(x: Sequence[str]) -> Ops:
    where = _part("where", (), (x[1],))
    return (*_neg(x), _bus(SCRATCH, x[1]), where, _bus(x[0], SCRATCH), op("all"))


def _div(x: Sequence[str]) -> Ops:
    y0, y1, y2, source = x
    _distinct("div", x, "its three registers and its source must be four")
    return (
        _bus2(y0, y1, source),
        _bus(SCRATCH, source, y1),
        _bus(y2, SCRATCH, y0),
        _bus2(y0, y1, y2),
        _bus(y0, y1),
    )


def _diva(x: Sequence[str]) -> Ops:
    y0, y1, y2 = x
    _distinct("diva", x, "its registers must be three")
    return (
        _bus2(y1, y2, y0),
        _bus(SCRATCH, y1, y0),
        _bus(y0, SCRATCH, y2),
        _bus2(y1, y2, y0),
        _bus(y0, y1),
    )


def _respix(x: Sequence[str]) -> Ops:
    return _RESET if not x else (*_RESET, _bus(SCRATCH, "PIX"), _bus(x[0], SCRATCH))


def _get_image(x: Sequence[str]) -> Ops:
    if len(x) == 1:
        return (_bus(SCRATCH, "PIX"), *_RESET, _bus(x[0], SCRATCH, "PIX"))
    return (_bus(SCRATCH, "PIX"), _bus(x[1], "PIX"), *_RESET, _bus(x[0], x[1], SCRATCH, "PIX"))


def _getpix(x: Sequence[str]) -> Ops:
    if len(x) == 2:
        return (_bus(SCRATCH, "PIX"), _bus(x[0], SCRATCH, x[1]))
    _distinct("getpix", x, "y, h and r must be three registers")
    return (_bus(x[1], "PIX"), _bus(SCRATCH, "PIX"), _bus(x[0], x[1], SCRATCH, x[2]))


# Digital macros. Those that join two terms end in NOR or OR of what R0 and R12 (or b) then hold.
def _both(last: str) -> Callable[[Sequence[str]], Ops]:
    def write(x: Sequence[str]) -> Ops:
        return (
            _bit("SET", GUARD),
            _bit("NOT", GUARDED, x[1]),
            _bit("NOT", GUARD, x[2]),
            _bit(last, x[0], GUARD, GUARDED),
        )

    return write


def _both_in(last: str) -> Callable[[Sequence[str]], Ops]:
    def write(x: Sequence[str]) -> Ops:
        return (_bit("NOT", GUARD, x[1]), _bit("NOT", x[1], x[2]), _bit(last, x[0], GUARD, x[1]))

    return write


def _implies(last: str) -> Callable[[Sequence[str]], Ops]:
    def write(x: Sequence[str]) -> Ops:
        return (_bit("NOT", GUARD, x[2]), _bit(last, x[0], x[1], GUARD))

    return write


def _clear_if(x: Sequence[str]) -> Ops:
    _distinct("CLR_IF", x, "the register and its condition must differ")
    return (_bit("NOT", GUARD, x[0]), _bit("NOR", x[0], GUARD, x[1]))


def _xor(x: Sequence[str]) -> Ops:
    l, a, b = x  # noqa: E741
    _distinct("XORX", x, "l, x and y must be three registers")
    return (
        _bit("NOT", GUARD, b),
        _bit("NOR", l, a, GUARD),
        _bit("NOT", GUARD, a),
        _bit("NOR", a, b, GUARD),
        *_in_place("OR", (l, a)),
    )


def _mux(x: Sequence[str]) -> Ops:
    return (
        _bit("SET", GUARD),
        _bit("MOV", GUARDED, x[3]),
        _bit("MOV", GUARD, x[1]),
        _bit("MOV", GUARDED, x[2]),
        _bit("MOV", x[0], GUARDED),
    )


# In-place forms and the mnemonics that share a name with them.
def _in_place(kind: str, operands: Sequence[str]) -> Ops:
    """The pair that stores OR, NOR or REFRESH of all operands in the first one."""
    for index, register in enumerate(operands):
        allowed = DIGITAL_SOURCES if index else DIGITAL_WRITE
        if register not in allowed:
            raise OperandError(
                f"{kind} in place takes digital registers ({_listed(allowed)}), and "
                f"{register} is none",
                index,
            )
    return pair(kind, operands[0], operands)


def _refresh(x: Sequence[str]) -> Ops:
    return _in_place("REFRESH", x)


def _not(x: Sequence[str]) -> Ops:
    return _in_place("NOR", x) if len(x) == 1 else (_word(BY_NAME["NOT"], x[:1], x[1:]),)


def _or_nor(kind: str) -> Callable[[Sequence[str]], Ops]:
    def write(x: Sequence[str]) -> Ops:
        destination, sources = x[0], x[1:]
        if len(sources) > 1 and destination not in sources:
            return (_word(BY_NAME[kind], x[:1], sources),)
        for index, register in enumerate(sources, start=1):
            if register in sources[: index - 1]:
                raise OperandError(f"{kind} names {register} twice as a source", index)
        rest = [register for register in sources if register != destination]
        return _in_place(kind, (destination, *rest))

    return write


_N, _R, _RR = (SCRATCH,), (GUARD,), (GUARD, GUARDED)

_MACROS = (
    Mnemonic("res", "res a` or `res a, b", _res, 1, 2, _N),
    Mnemonic("mov", "mov y, x", _mov, 2, 2, _N),
    Mnemonic("add", "add y, x0, x1[, x2]", _add, 3, 4, _N),
    Mnemonic("sub", "sub y, x0, x1", _sub, 3, 3, _N),
    Mnemonic("neg", "neg y, x", _neg, 2, 2, _N),
    Mnemonic("abs", "abs y, x", _abs, 2, 2, _N),
    Mnemonic("div", "div y0, y1, y2, x", _div, 4, 4, _N),
    Mnemonic("diva", "diva y0, y1, y2", _diva, 3, 3, _N),
    Mnemonic("respix", "respix` or `respix y", _respix, 0, 1, _N),
    Mnemonic("get_image", "get_image y` or `get_image y, h", _get_image, 1, 2, _N),
    Mnemonic("getpix", "getpix y, r` or `getpix y, h, r", _getpix, 2, 3, _N),
    Mnemonic("AND", "AND a, x, y", _both("NOR"), 3, 3, _RR),
    Mnemonic("NAND", "NAND a, x, y", _both("OR"), 3, 3, _RR),
    Mnemonic("ANDX", "ANDX a, b, x", _both_in("NOR"), 3, 3, _R),
    Mnemonic("NANDX", "NANDX a, b, x", _both_in("OR"), 3, 3, _R),
    Mnemonic("IMP", "IMP l, x, y", _implies("OR"), 3, 3, _R),
    Mnemonic("NIMP", "NIMP l, x, y", _implies("NOR"), 3, 3, _R),
    Mnemonic("CLR_IF", "CLR_IF l, x", _clear_if, 2, 2, _R),
    Mnemonic("XORX", "XORX l, x, y", _xor, 3, 3, _R),
    Mnemonic("MUX", "MUX l, x, y, z", _mux, 4, 4, _RR),
    Mnemonic("REFRESH", "REFRESH d", _refresh, 1, 1),
    Mnemonic("NOT", "NOT d, x` or, in place, `NOT d", _not, 1, 2),
    Mnemonic("OR", "OR d, x0, x1, ..` or, in place, `OR d, x", _or_nor("OR"), 2, None),
    Mnemonic("NOR", "NOR d, x0, x1, ..` or, in place, `NOR d, x", _or_nor("NOR"), 2, None),
)

MNEMONICS: dict[str, Mnemonic] = {
    **{row.name: _native(row) for row in OPERATIONS if row.phase is Phase.WHOLE},
    **{macro.name: macro for macro in _MACROS},
}
"""Every mnemonic by name; names are case sensitive (`where` is analog, `WHERE` digital)."""


@cache
def mnemonics(own: tuple[Operation, ...] = ()) -> dict[str, Mnemonic]:
    """Every mnemonic by name on a target that has words of its own."""
    return MNEMONICS | {row.name: _native(row) for row in own}
