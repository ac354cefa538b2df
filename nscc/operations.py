"""The table of operations: the name, control lines and effect of each instruction word (ICW).

Assembler, proof, emulator, C++ output and firmware use this table; no other code defines the
meaning of words. Line numbers are those of the 160-bit SCAMP-5d word; `nscc.words.encoding` has
their places in words.

A word is either whole or one half of a pair. The first word of a pair (`Phase.READ`) leaves its
result on the pixel's bus. The second (`Phase.WRITE`) stores it and must follow immediately, because
any other word in between destroys the result. Pairs exist because a register cannot be read and
written in the same word."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from enum import Enum, auto
from functools import lru_cache
from typing import Annotated

from nscc.codec import Within

Bits32 = Annotated[int, Within(0, (1 << 32) - 1)]
Word = tuple[Bits32, Bits32, Bits32, Bits32, Bits32]
"""One instruction word (ICW): five 32-bit integers in the chip's format."""


class WordEffect(Enum):
    """The effect of a word on the state of a pixel.

    `total` is the sum of the analog sources, `some` the OR of the digital sources."""

    NONE = auto()
    """No effect."""
    RESET_PIX = auto()
    """PIX := reset level, in every pixel or where FLAG = 1 (`Target.reset_honours_flag`)."""
    BUS = auto()
    """Where FLAG = 1, each destination := -total / divisor."""
    FLAG_ALL = auto()
    """FLAG := 1."""
    FLAG_ANALOG = auto()
    """FLAG := total > 0."""
    FLAG_DIGITAL = auto()
    """FLAG := some."""
    DIGITAL = auto()
    """Each destination := some, or NOT some if inverted; without sources, some is 0."""
    DIGITAL_NEIGHBOURS = auto()
    """The destination := the OR of the source in the neighbours chosen by the `STEERING` registers.

    Outside the array the source counts as 0, or as 1 if inverted."""
    PROPAGATION = auto()
    """The destination, R12, := 1 also in the pixels that are connected with a 1 through pixels in
    which the mask register R0 is 1, in the directions of the `STEERING` registers.

    The distance is limited (`Target.propagation_pixels`). Outside the array R12 counts as 0."""


class Phase(Enum):
    """The part of a pair that a word is: the reading half, the writing half, or none (a whole
    word)."""

    WHOLE = auto()
    READ = auto()
    WRITE = auto()


@dataclass(frozen=True, slots=True)
class Operation:
    """A row of the table of operations: what words of this name do, and their bits.

    `effect` says what a word does, with its `divisor` (of a sum) or `inverted`; `phase` is its part
    of a pair. `lines` are the control lines that the word sets in addition to those of its
    operands. `destinations` and `sources` are the fewest and most operands that the chip accepts;
    None means no limit, because the digital bus is a wired OR. A target may allow fewer. `clock` is
    the clock class in bits 19-21 of word 0. `us` is the word's duration if the clock does not
    determine it."""

    name: str
    effect: WordEffect
    clock: int
    lines: tuple[int, ...]
    destinations: tuple[int, int | None]
    sources: tuple[int, int | None]
    inverted: bool = False
    divisor: int = 1
    phase: Phase = Phase.WHOLE
    us: float | None = None

    @property
    def analog(self) -> bool:
        """Whether words of this operation run at the analog clock, which is slower."""
        return self.clock == 0


_ANALOG, _DIGITAL, _NEIGHBOURS, _PROPAGATION = 0, 1, 2, 3

# Control lines by name: the columns of the word's layout.
SELPIX, RSTPIX, S_IN, RANA, RID = 1, 2, 5, 6, 11
WRF, SETF, NBIT, PLWB, PLRB, BIT, BITMODE, WR = 20, 28, 58, 60, 61, 62, 63, 64
SELX, PUPD, FBUS, RR12, NB = 10, 30, 31, 43, 59

# Lines 80 and up do not exist on SCAMP-5d: they are this project's own stand-in for the registers
# R13, R14, .. of chips whose word is not public, and lie in bits that SCAMP-5d leaves unused.

FIRST_EXTRA_LINE, EXTRA_LINES = 80, 52

_GROUPS = (
    (0, "selsq selpix rstpix seldiffe seldiffs s_in rana sels"),
    (9, "sele selx rid seln"),
    (13, "W1 W2 W3 W4 W5 W6 W7 wrf SEL1 SEL2 SEL3 SEL4 SEL5 SEL6 SEL7 setf selw pupd fbus"),
    (32, " ".join(f"RR{i}" for i in range(1, 13))),
    (44, " ".join(f"LR{i}" for i in range(1, 13))),
    (56, "lfl rfl nbit nb plwb plrb bit bitmode"),
    (64, "wr ana dig8 g_start g_stop col_out dir row_out s0_left s1_left rst_start rst_stop"),
    (76, "s0_bot s1_bot pgdb pgdbobus"),
    (80, " ".join(f"RR{13 + i} LR{13 + i}" for i in range(EXTRA_LINES // 2))),
)
LINE_NAMES: dict[int, str] = {
    first + i: name for first, names in _GROUPS for i, name in enumerate(names.split())
}
"""The names of the control lines; line 8 has no name."""

# An operand's own lines, as a source and as a destination. NEWS also needs selx to be read.
READ_LINES: dict[str, tuple[int, ...]] = {
    "A": (21,), "B": (22,), "C": (23,), "NEWS": (24, SELX), "D": (25,), "E": (26,), "F": (27,),
    "PIX": (SELPIX,), "IN": (S_IN,),
    "R0": (57,), **{f"R{i}": (31 + i,) for i in range(1, 13)},
    **{f"R{i}": (80 + 2 * (i - 13),) for i in range(13, 39)},
    "FLAG": (RANA,), "SELECT": (WR,),
}  # fmt: skip
ANALOG_WRITE = {"A": 13, "B": 14, "C": 15, "NEWS": 16, "D": 17, "E": 18, "F": 19}
NEIGHBOURS = {"XN": (24, 7), "XE": (24, 9), "XS": (24, 12), "XW": (24, 29)}
"""The control lines that connect a pixel's bus with NEWS of a neighbour.

As a source, the pixel reads NEWS of the neighbour to the north, east, south or west. As a
destination, NEWS receives the value on the bus of the opposite neighbour."""
STEPS = {"XN": (0, -1), "XE": (1, 0), "XS": (0, 1), "XW": (-1, 0)}
"""The offset (columns to the right, rows down) from a pixel to the neighbour that it reads."""
STEERING = {"R1": (0, 1), "R2": (-1, 0), "R3": (0, -1), "R4": (1, 0)}
"""The registers with which a pixel chooses the neighbours that digital words read.

The values are the offsets (columns to the right, rows down) of these neighbours."""
DIGITAL_WRITE = {
    "R0": 56,
    **{f"R{i}": 43 + i for i in range(1, 13)},
    **{f"R{i}": 81 + 2 * (i - 13) for i in range(13, 39)},
}

ANALOG_SOURCES = (*ANALOG_WRITE, "PIX", "IN")
DIGITAL_SOURCES = (*DIGITAL_WRITE, "FLAG", "SELECT")

_ANY = (1, None)
_ONE = (1, 1)
"""Exactly one register."""
_NO = (0, 0)
"""No register."""
_READ, _WRITE = Phase.READ, Phase.WRITE

_SET = (S_IN, PLWB)
_COPY = (S_IN, PLRB, BIT, BITMODE)
_INVERT = (S_IN, PLWB, PLRB, NBIT, BITMODE)
_SEEN = (S_IN, RID, FBUS, NB, PLRB, BIT)

OPERATIONS: tuple[Operation, ...] = (
    Operation("nop", WordEffect.NONE, _ANALOG, (), _NO, _NO),
    Operation("rpix", WordEffect.RESET_PIX, _ANALOG, (RSTPIX, SELPIX), _NO, _NO),
    Operation("all", WordEffect.FLAG_ALL, _ANALOG, (SETF, PLRB, RID), _NO, _NO),
    Operation("bus", WordEffect.BUS, _ANALOG, (), _ONE, (0, 4)),
    Operation("bus2", WordEffect.BUS, _ANALOG, (), (2, 2), (0, 2), divisor=2),
    Operation("bus3", WordEffect.BUS, _ANALOG, (), (3, 3), _ONE, divisor=3),
    Operation("where", WordEffect.FLAG_ANALOG, _ANALOG, (WRF,), _NO, (1, 3)),
    Operation("WHERE", WordEffect.FLAG_DIGITAL, _DIGITAL, (WRF, PLRB, RID), _NO, _ANY),
    Operation("SET", WordEffect.DIGITAL, _DIGITAL, _SET, _ANY, _NO, inverted=True),
    Operation("CLR", WordEffect.DIGITAL, _DIGITAL, _COPY, _ANY, _NO),
    Operation("MOV", WordEffect.DIGITAL, _DIGITAL, _COPY, _ONE, _ONE),
    Operation("OR", WordEffect.DIGITAL, _DIGITAL, _COPY, _ONE, (2, None)),
    Operation("NOT", WordEffect.DIGITAL, _DIGITAL, _INVERT, _ONE, _ONE, inverted=True),
    Operation("NOR", WordEffect.DIGITAL, _DIGITAL, _INVERT, _ONE, (2, None), inverted=True),
    Operation("DNEWS0", WordEffect.DIGITAL_NEIGHBOURS, _NEIGHBOURS, _SEEN, _ONE, _ONE),
    Operation(
        "DNEWS1",
        WordEffect.DIGITAL_NEIGHBOURS,
        _NEIGHBOURS,
        (*_SEEN, PUPD),
        _ONE,
        _ONE,
        inverted=True,
    ),
    # PROP.read raises the line of R12 itself, because it has the clock of analog words.
    Operation(
        "PROP.read",
        WordEffect.NONE,
        _ANALOG,
        (S_IN, RR12, PLRB, BIT, BITMODE),
        _NO,
        _NO,
        phase=_READ,
    ),
    Operation(
        "PROP.write",
        WordEffect.PROPAGATION,
        _PROPAGATION,
        (S_IN, RID, FBUS, NB),
        _ONE,
        _ONE,
        phase=_WRITE,
    ),
    Operation("REFRESH.read", WordEffect.DIGITAL, _DIGITAL, _COPY, _NO, _ONE, phase=_READ),
    Operation(
        "REFRESH.write", WordEffect.DIGITAL, _DIGITAL, (S_IN, BIT, BITMODE), _ONE, _NO, phase=_WRITE
    ),
    Operation(
        "OR.read", WordEffect.DIGITAL, _DIGITAL, (PLRB, BIT, BITMODE), _NO, _ANY, phase=_READ
    ),
    Operation("OR.write", WordEffect.DIGITAL, _DIGITAL, (BIT, BITMODE), _ONE, _NO, phase=_WRITE),
    Operation(
        "NOR.read",
        WordEffect.DIGITAL,
        _DIGITAL,
        (PLRB, NBIT),
        _NO,
        _ANY,
        inverted=True,
        phase=_READ,
    ),
    Operation(
        "NOR.write", WordEffect.DIGITAL, _DIGITAL, (NBIT,), _ONE, _NO, inverted=True, phase=_WRITE
    ),
)

BY_NAME: dict[str, Operation] = {row.name: row for row in OPERATIONS}


@dataclass(frozen=True, slots=True)
class Op:
    """One instruction word: the operation `name` with names of registers as operands, destinations
    first.

    Sources are a set; they are kept in the order of `READ_LINES`, so that equal words are equal
    values. A pair consists of two such values. `target_operation` is the operation of a word that
    only some targets have."""

    name: str
    destinations: tuple[str, ...] = ()
    sources: tuple[str, ...] = ()
    target_operation: Operation | None = None

    @property
    def operation(self) -> Operation:
        """The operation of the word."""
        return self.target_operation or BY_NAME[self.name]

    @property
    def analog(self) -> bool:
        """Whether the word runs at the analog clock, which is slower."""
        return self.operation.analog

    def __str__(self) -> str:
        """Return the word as text: name, destinations, sources."""
        return " ".join((self.name, ", ".join(self.destinations + self.sources))).strip()


_ORDER = {name: i for i, name in enumerate((*READ_LINES, *NEIGHBOURS))}


def op(name: str, destinations: Iterable[str] = (), sources: Iterable[str] = ()) -> Op:
    """Return a word of the operation `name` of the table, with names of registers as operands.
    Their order does not matter.

    Raises ValueError for an unknown name or invalid operands."""
    return _op(name, tuple(destinations), tuple(sources))


@lru_cache(maxsize=1 << 12)
def _op(name: str, destinations: tuple[str, ...], sources: tuple[str, ...]) -> Op:
    """Return the word of the operation `name` with these operands. Results are memoized, because
    programs repeat words. Raises ValueError for an unknown name or invalid operands."""
    row = BY_NAME.get(name)
    if row is None:
        raise ValueError(f"no operation {name!r}")
    return make_op(row, destinations, sources)


def make_op(row: Operation, destinations: Iterable[str] = (), sources: Iterable[str] = ()) -> Op:
    """Return a word of the operation `row`, with its operands in a fixed order and each once, so
    that equal words are equal values.

    Raises ValueError for invalid operands; callers check user input before."""
    name = row.name
    dests = tuple(sorted(set(destinations), key=_ORDER.__getitem__))
    srcs = tuple(sorted(set(sources), key=_ORDER.__getitem__))
    for operands, (low, high), word in (
        (dests, row.destinations, "destinations"),
        (srcs, row.sources, "sources"),
    ):
        if len(operands) < low or (high is not None and len(operands) > high):
            raise ValueError(f"{name} cannot take {len(operands)} {word}")
    analog = row.analog
    directions = NEIGHBOURS if row.effect is WordEffect.BUS else ()
    for register in dests:
        if (
            register not in (ANALOG_WRITE if analog else DIGITAL_WRITE)
            and register not in directions
        ):
            raise ValueError(f"{name} cannot write {register}")
    for register in srcs:
        if (
            register not in (ANALOG_SOURCES if analog else DIGITAL_SOURCES)
            and register not in directions
        ):
            raise ValueError(f"{name} cannot read {register}")
    # Operands that are neighbours: a word can reach one of them only.
    directed = [register for register in (*dests, *srcs) if register in directions]
    if directed and (len(directed) > 1 or "NEWS" in (*dests, *srcs)):
        raise ValueError(f"{name} joins NEWS to one bus")
    # The destinations of a word would be in different pixels.
    if directed and len(dests) > 1 and directed[0] in dests:
        raise ValueError(f"{name} cannot write {directed[0]} beside another register")
    if row.phase is Phase.WHOLE and set(dests) & set(srcs):
        raise ValueError(f"{name} cannot write a register that it reads")
    # Rows of targets are stored with the word; those of all chips are found by name.
    return Op(name, dests, srcs, None if BY_NAME.get(name) is row else row)


def pair(kind: str, destination: str, sources: Iterable[str]) -> tuple[Op, Op]:
    """Return the two words that write the OR, NOR or REFRESH (`kind`) of `sources` to a register
    that may be one of them. The first of the two words must directly precede the second."""
    return op(f"{kind}.read", (), sources), op(f"{kind}.write", (destination,))
