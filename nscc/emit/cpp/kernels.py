"""Kernels as C++: calls of the devkit's library that record exactly the words, else constant
tables.

A call is used only if `nscc.macros` expands it to exactly these words and the library accepts the
number of operands. If any word of a kernel has no call, the whole kernel becomes a constant table.
If the layout of tables is unknown, as in the devkit's simulator, several equivalent calls replace
such a word (`nscc.emit.cpp.narrow`)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cache, lru_cache
from itertools import product

from nscc.emit.cpp.cpp_text import Call, call_text, remarked
from nscc.macros import MNEMONICS, OperandError, expand
from nscc.operations import Op, Phase, WordEffect
from nscc.words.container import Word
from nscc.words.encoding import encode, word_text

MOST_SOURCES = {"OR": 4, "NOR": 4, "WHERE": 3}
"""Most sources that the library's calls accept; the chip itself accepts any number."""

TOO_WIDE = "a word has more sources than a call: set or_sources = 4, where_sources = 3 in a target"
"""The error message for a program with words that have no call."""

MOST_DESTINATIONS = 4
"""Most registers in one call of SET or CLR."""

# If two macros expand to the same words, the more readable one comes first: getpix is sub of PIX.
_MACROS = (
    "respix", "get_image", "res", "getpix", "neg", "mov", "add", "sub", "abs", "div", "diva",
    "AND", "NAND", "ANDX", "NANDX", "IMP", "NIMP", "CLR_IF", "XORX", "MUX",
    "REFRESH", "NOT", "OR", "NOR",
)  # fmt: skip
_MOST_OPERANDS = 4


def calls(ops: Sequence[Op]) -> list[tuple[Call, tuple[Op, ...]]] | None:
    """Return the library calls that record exactly `ops`, each with its words; None if a word has
    no call."""
    recorded: list[tuple[Call, tuple[Op, ...]]] = []
    at = 0
    while at < len(ops):
        for length in _lengths():
            window = tuple(ops[at : at + length])
            call = _macro(window) if len(window) == length > 1 else None
            if length == 1:
                call = _single(ops[at])
            if call is not None:
                recorded.append((call, window))
                at += length
                break
        else:
            return None
    return recorded


def calls_words(recorded: Sequence[Call]) -> int:
    """Return the number of words that the calls record."""
    return sum(len(expand(name, operands)) for name, operands in recorded)


def kernel_lines(
    name: str, ops: Sequence[Op], narrow: Sequence[Op] | None, *, tables: bool
) -> Iterator[str]:
    """Yield the C++ function `name`, which launches a kernel of the words `ops`.

    `narrow` are equivalent words that all have calls, or None. They replace words without a call in
    the simulator, and on chips without public `tables`."""
    recorded = calls(ops)
    if recorded is not None:
        yield from _recorded(name, recorded)
        return
    if tables:
        yield "#ifdef __LPC43XX__"
        rows = [(f"    {{{_integers(encode(word))}}},", str(word)) for word in ops]
        yield f"const uint32_t {name}_words[][5] = {{"
        yield from remarked(rows)
        yield "};"
        yield f"void {name}() {{ scamp5_kernel({name}_words, {len(ops)}), Run(); }}"
        yield "#else"
    recorded = None if narrow is None else calls(narrow)
    if recorded is None:
        yield f'#error "{TOO_WIDE}"'
    else:
        yield from _recorded(name, recorded)
    if tables:
        yield "#endif"


def _recorded(name: str, recorded: Sequence[tuple[Call, tuple[Op, ...]]]) -> Iterator[str]:
    body = [
        (f"        {call_text(call)}", "; ".join(map(str, window))) for call, window in recorded
    ]
    yield f"void {name}() {{"
    yield "    scamp5_kernel_begin();"
    if any(word.analog for _, window in recorded for word in window):
        yield "        SLOW_CLOCK"
    yield from remarked(body)
    yield "    scamp5_kernel_end();"
    yield "}"


def _integers(word: Word) -> str:
    return word_text(word).replace(" ", ", ")


@cache
def _lengths() -> tuple[int, ...]:
    """Return the possible numbers of words of a macro, in descending order."""
    return tuple(sorted({1, *map(len, _shapes())}, reverse=True))


@cache
def _shapes() -> dict[tuple[str, ...], list[tuple[str, int]]]:
    """Return macros and their numbers of operands, by the operation names of their expansion."""
    shapes: dict[tuple[str, ...], list[tuple[str, int]]] = {}
    for name in _MACROS:
        least, most = MNEMONICS[name].least, MNEMONICS[name].most or 2
        for count in range(least, min(most, _MOST_OPERANDS) + 1):
            for registers in (("A", "B", "C", "D"), ("R1", "R2", "R3", "R4")):
                try:
                    ops = expand(name, registers[:count])
                except OperandError:
                    continue
                shape = tuple(operation.name for operation in ops)
                if len(shape) > 1 and (name, count) not in shapes.setdefault(shape, []):
                    shapes[shape].append((name, count))
    return shapes


@lru_cache(maxsize=1 << 14)
def _macro(window: tuple[Op, ...]) -> Call | None:
    """Return the macro call that expands to exactly `window`, or None."""
    registers = list(dict.fromkeys(r for o in window for r in (*o.destinations, *o.sources)))
    for name, count in _shapes().get(tuple(operation.name for operation in window), []):
        usable = [r for r in registers if r not in MNEMONICS[name].scratch]
        for operands in product(usable, repeat=count):
            try:
                if expand(name, operands) == window:
                    return name, operands
            except OperandError:
                continue
    return None


def _single(operation: Op) -> Call | None:
    """Return the library call for one word, or None if the library has none for its operands."""
    if operation.operation.phase is not Phase.WHOLE:
        return None
    if len(operation.sources) > MOST_SOURCES.get(operation.name, len(operation.sources)):
        return None
    if operation.operation.effect is WordEffect.DIGITAL and (
        len(operation.destinations) > MOST_DESTINATIONS
    ):
        return None
    return operation.name, (*operation.destinations, *operation.sources)
