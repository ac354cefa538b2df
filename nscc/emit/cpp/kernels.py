"""Kernels as C++: calls of the devkit's library that record exactly the words, else constant
tables.

A call is used only if `nscc.macros` expands it to exactly these words and the library accepts the
number of operands. If any word of a kernel has no call, the whole kernel becomes a constant table.
If the layout of tables is unknown, as in the devkit's simulator, several equivalent calls replace
such a word (`nscc.emit.cpp.kernels`)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cache, lru_cache
from itertools import product

from nscc.emit.cpp.cpp_text import Call, call_text, remarked
from nscc.macros import MNEMONICS, OperandError, expand
from nscc.operations import Op, Phase, WordEffect, op, pair
from nscc.words.container import Container
from nscc.words.encoding import decode, encode, word_text


def narrowed(container: Container) -> list[list[Op]] | None:
    """Return the words of every kernel (list of words) as words that all have a call in the
    devkit's library.

    Words with too many operands become several. Return None if a WHERE has too many sources and no
    digital register is free to gather them."""
    kernels = [[decode(word) for word in kernel.words] for kernel in container.kernels]
    target = container.target
    used = {r for kernel in kernels for word in kernel for r in (*word.destinations, *word.sources)}
    used_registers = (
        *used,
        *container.code_registers,
        target.mask_register,
        target.masked_register,
    )
    scratch = next((r for r in target.digital_registers if r not in used_registers), None)
    try:
        return [list(_kernel(kernel, scratch)) for kernel in kernels]
    except _NoRegister:
        return None


class _NoRegister(Exception):
    """Raised if no register is free."""


def _kernel(kernel: Sequence[Op], scratch: str | None) -> Iterator[Op]:
    """Yield the words of a kernel (list of words) with operands divided among more words, as the
    devkit's calls need it.

    A pair that combines several registers becomes a chain of pairs. WHERE with many sources first
    gathers them in the register `scratch`; raises _NoRegister if that is None. OR, NOR, SET and CLR
    are divided."""
    read: Op | None = None
    for word in kernel:
        if word.operation.phase is Phase.READ:
            read = word
        elif word.operation.phase is Phase.WRITE:
            assert read is not None
            (register,) = word.destinations
            other_sources = tuple(name for name in read.sources if name != register)
            # The library's calls for a pair combine the register with one other register.
            if len(other_sources) < 2 or register not in read.sources:
                yield from (read, word)
            else:
                yield from _accumulate_sources(read.name.partition(".")[0], register, other_sources)
        elif word.name == "WHERE" and len(word.sources) > MOST_SOURCES["WHERE"]:
            if scratch is None:
                raise _NoRegister
            yield from _gathered("OR", scratch, word.sources)
            yield op("WHERE", (), (scratch,))
        elif word.name in ("OR", "NOR") and len(word.sources) > MOST_SOURCES[word.name]:
            yield from _gathered(word.name, word.destinations[0], word.sources)
        elif word.name in ("SET", "CLR") and len(word.destinations) > MOST_DESTINATIONS:
            for first in range(0, len(word.destinations), MOST_DESTINATIONS):
                yield op(word.name, word.destinations[first : first + MOST_DESTINATIONS])
        else:
            yield word


def _gathered(kind: str, register: str, sources: Sequence[str]) -> Iterator[Op]:
    """Yield words that write `kind` (OR or NOR) of `sources` to a register that is not one of them.

    At most MOST_SOURCES["OR"] sources take one word; each further one takes a pair of words."""
    most = MOST_SOURCES["OR"]
    if len(sources) <= most:
        yield op(kind, (register,), sources)
    else:
        yield op("OR", (register,), sources[:most])
        yield from _accumulate_sources(kind, register, sources[most:])


def _accumulate_sources(kind: str, register: str, sources: Sequence[str]) -> Iterator[Op]:
    """Yield words that write `kind` (OR or NOR) of a register and `sources` to the register, one
    source at a time. `sources` must not be empty; only the last pair is a NOR."""
    for source in sources[:-1]:
        yield from pair("OR", register, (register, source))
    yield from pair(kind, register, (register, sources[-1]))


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
"""Most operands with which a macro is expanded here: there are names for as many registers."""


def calls(ops: Sequence[Op]) -> list[tuple[Call, tuple[Op, ...]]] | None:
    """Return the library calls that record exactly these words, in order, each with its words; of
    several possible calls the longest.

    Return None if a word has no call. No words need no call."""
    recorded: list[tuple[Call, tuple[Op, ...]]] = []
    position = 0
    while position < len(ops):
        for length in _lengths():
            window = tuple(ops[position : position + length])
            call = _macro(window) if len(window) == length > 1 else None
            if length == 1:
                call = _single(ops[position])
            if call is not None:
                recorded.append((call, window))
                position += length
                break
        else:
            return None
    return recorded


def calls_words(recorded: Sequence[Call]) -> int:
    """Return the number of words that these library calls record."""
    return sum(len(expand(name, operands)) for name, operands in recorded)


def kernel_lines(
    name: str, ops: Sequence[Op], narrow: Sequence[Op] | None, *, tables: bool
) -> Iterator[str]:
    """Yield the C++ function `name`, which runs a kernel (a list of words) of the words `ops`.

    `narrow` are equivalent words that all have calls, or None. They replace words without a call in
    the simulator, and on chips whose devkit has no public `tables` of words. If there are none, the
    C++ has an `#error` in their place."""
    recorded = calls(ops)
    if recorded is not None:
        yield from _recorded(name, recorded)
        return
    if tables:
        yield "#ifdef __LPC43XX__"
        integers = [word_text(encode(word)).replace(" ", ", ") for word in ops]
        rows = [(f"    {{{k}}},", str(word)) for k, word in zip(integers, ops, strict=True)]
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
    """Yield the C++ function `name` of a kernel (list of words): its library calls, with their
    words as comments."""
    body = [
        (f"        {call_text(call)}", "; ".join(map(str, window))) for call, window in recorded
    ]
    yield f"void {name}() {{"
    yield "    scamp5_kernel_begin();"
    if any(word.analog for _, window in recorded for word in window):
        # Analog words run at the slower clock.
        yield "        SLOW_CLOCK"
    yield from remarked(body)
    yield "    scamp5_kernel_end();"
    yield "}"


@cache
def _lengths() -> tuple[int, ...]:
    """Return the possible numbers of words of a library call, in descending order: long calls are
    tried first."""
    return tuple(sorted({1, *map(len, _shapes())}, reverse=True))


@cache
def _shapes() -> dict[tuple[str, ...], list[tuple[str, int]]]:
    """Return the macros with their numbers of operands, as (name, count), by the names of the words
    that they expand to. Macros of one word are left out."""
    shapes: dict[tuple[str, ...], list[tuple[str, int]]] = {}
    for name in _MACROS:
        least, most = MNEMONICS[name].least, MNEMONICS[name].most or 2
        for count in range(least, min(most, _MOST_OPERANDS) + 1):
            # A macro takes either analog or digital registers; only the names of its words matter
            # here.
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
    """Return the library's macro call (name, operands) that expands to exactly the words `window`;
    None if there is none. Of several, the first in _MACROS is taken."""
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
    """Return the library call (name, operands) for one word. None if the library has none: for the
    words of a pair, for more sources than MOST_SOURCES, and for more than MOST_DESTINATIONS
    registers of a digital word."""
    if operation.operation.phase is not Phase.WHOLE:
        return None
    if len(operation.sources) > MOST_SOURCES.get(operation.name, len(operation.sources)):
        return None
    if operation.operation.effect is WordEffect.DIGITAL and (
        len(operation.destinations) > MOST_DESTINATIONS
    ):
        return None
    return operation.name, (*operation.destinations, *operation.sources)
