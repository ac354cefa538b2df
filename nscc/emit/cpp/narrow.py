"""Splitting of words that have more sources than a library call accepts.

Partial results accumulate in the destination register, which the native words do not read. FLAG
cannot accumulate, so a WHERE with many sources needs a register that the program does not use."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from nscc.emit.cpp.kernels import MOST_DESTINATIONS, MOST_SOURCES
from nscc.operations import Op, Phase, op, pair
from nscc.words.container import Container
from nscc.words.encoding import decode


def narrowed(container: Container) -> list[list[Op]] | None:
    """Return the kernels in words that all have calls; None if a WHERE needs a free register."""
    kernels = [[decode(word) for word in kernel.words] for kernel in container.kernels]
    scratch = _unused(container, kernels)
    try:
        return [list(_kernel(kernel, scratch)) for kernel in kernels]
    except _NoRegister:
        return None


class _NoRegister(Exception):
    """Raised if no register is free."""


def _unused(container: Container, kernels: Sequence[Sequence[Op]]) -> str | None:
    target = container.target
    used = {r for kernel in kernels for word in kernel for r in (*word.destinations, *word.sources)}
    used_registers = (
        *used,
        *container.code_registers,
        target.mask_register,
        target.masked_register,
    )
    return next((r for r in target.digital_registers if r not in used_registers), None)


def _kernel(kernel: Sequence[Op], scratch: str | None) -> Iterator[Op]:
    read: Op | None = None
    for word in kernel:
        if word.operation.phase is Phase.READ:
            read = word
        elif word.operation.phase is Phase.WRITE:
            assert read is not None
            yield from _in_place(read, word)
        elif word.name == "WHERE" and len(word.sources) > MOST_SOURCES["WHERE"]:
            if scratch is None:
                raise _NoRegister
            yield from _gathered("OR", scratch, word.sources)
            yield op("WHERE", (), (scratch,))
        elif word.name in ("OR", "NOR") and len(word.sources) > MOST_SOURCES[word.name]:
            yield from _gathered(word.name, word.destinations[0], word.sources)
        elif word.name in ("SET", "CLR") and len(word.destinations) > MOST_DESTINATIONS:
            for at in range(0, len(word.destinations), MOST_DESTINATIONS):
                yield op(word.name, word.destinations[at : at + MOST_DESTINATIONS])
        else:
            yield word


def _gathered(kind: str, register: str, sources: Sequence[str]) -> Iterator[Op]:
    """Yield words that write `kind` (OR or NOR) of `sources`, which do not include `register`, to
    it."""
    most = MOST_SOURCES["OR"]
    if len(sources) <= most:
        yield op(kind, (register,), sources)
    else:
        yield op("OR", (register,), sources[:most])
        yield from _accumulate_sources(kind, register, sources[most:])


def _in_place(read: Op, write: Op) -> Iterator[Op]:
    """Yield a read-write pair of words, split if the library has no call for it."""
    (register,) = write.destinations
    other_sources = tuple(name for name in read.sources if name != register)
    if len(other_sources) < 2 or register not in read.sources:
        yield from (read, write)
    else:
        yield from _accumulate_sources(read.name.partition(".")[0], register, other_sources)


def _accumulate_sources(kind: str, register: str, sources: Sequence[str]) -> Iterator[Op]:
    """Yield words that write `kind` of `register` and `sources` to `register`, one source at a
    time."""
    for source in sources[:-1]:
        yield from pair("OR", register, (register, source))
    yield from pair(kind, register, (register, sources[-1]))
