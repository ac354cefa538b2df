"""Reuse of values that earlier programs have left in registers."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass

from nscc.neighbours.programs import Offset, Program, Taps, moved, values_of
from nscc.operations import NEIGHBOURS, STEPS

Contents = tuple[str, frozenset[tuple[Offset, int]]]
"""The name of a value, and the convolution kernel that was applied to the value."""


@dataclass(frozen=True)
class Reuse:
    """The words of a program that must run.

    `words`: their indices. `held`: registers that already hold values of the program, by the
    program's names. `contents`: what each word of the program writes, by name."""

    words: tuple[int, ...]
    held: Mapping[str, str]
    contents: tuple[dict[str, Contents], ...]


def contents_of(base: str, taps: Taps) -> Contents:
    return base, frozenset(taps.items())


def reuse(
    program: Program, base: str, contents: Mapping[str, Contents], free: Collection[str],
    news_keeps: bool,
) -> Reuse:  # fmt: skip
    """Return the words of a program that must run on the value `base`.

    `contents`: what registers hold. The result is reused only from a `free` register, because the
    caller owns it; NEWS is reused only with `news_keeps`."""
    written = []
    for word, taps in zip(program, values_of(program), strict=True):
        places = {
            name: moved(taps, *(-step for step in STEPS[name])) if name in NEIGHBOURS else taps
            for name in word.destinations
        }
        written.append({name: contents_of(base, place) for name, place in places.items()})
    where = {value: name for name, value in contents.items() if name != "NEWS"}
    where_free = {value: name for value, name in where.items() if name in free}
    needed, news = {program[-1].destinations[0]}, False
    numbers: list[int] = []
    held: dict[str, str] = {}
    last = len(program) - 1
    for number in reversed(range(len(program))):
        word, runs = program[number], False
        for name in word.destinations:
            if _is_news(name):
                runs = runs or news
            elif name in needed:
                register = (where_free if number == last else where).get(written[number][name])
                if register is None or register in held.values():  # two sources of one word
                    runs = True
                else:
                    held[name] = register
        if runs:
            numbers.append(number)
            news = (news and not any(map(_is_news, word.destinations))) or any(
                map(_is_news, word.sources)
            )
            needed |= {name for name in word.sources if not _is_news(name)}
    runs_in_order = tuple(numbers[::-1])
    if news_keeps:
        runs_in_order = _without_repeated_news(program, runs_in_order, written, contents)
    return Reuse(runs_in_order, held, tuple(written))


def _without_repeated_news(
    program: Program, numbers: tuple[int, ...], written: list[dict[str, Contents]],
    contents: Mapping[str, Contents],
) -> tuple[int, ...]:  # fmt: skip
    """Return `numbers` without the words that would write to NEWS what NEWS already holds."""
    news, left = contents.get("NEWS"), []
    for number in numbers:
        values = {v for name, v in written[number].items() if _is_news(name)}
        if len(program[number].destinations) == 1 and values == {news}:
            continue
        left.append(number)
        news = next(iter(values), news)
    return tuple(left)


def _is_news(name: str) -> bool:
    return name == "NEWS" or name in NEIGHBOURS
