"""Hints for syntax of other languages and for common units: what the user probably meant."""

from __future__ import annotations

import re
from collections.abc import Iterator
from fractions import Fraction

from nscc.diagnostics.diagnostic import Fix
from nscc.diagnostics.suggest import closest, did_you_mean
from nscc.source import Span
from nscc.syntax.lexer import Stuck, Tokens

_UNITS = {
    **dict.fromkeys(("ns", "nsec", "nsecs", "nanosecond", "nanoseconds"), "ns"),
    **dict.fromkeys(("us", "\u00b5s", "\u03bcs", "usec", "usecs", "\u00b5sec", "\u03bcsec"), "us"),
    **dict.fromkeys(("mus", "microsecond", "microseconds"), "us"),
    **dict.fromkeys(("ms", "msec", "msecs", "millisecond", "milliseconds"), "ms"),
    **dict.fromkeys(("s", "sec", "secs", "second", "seconds"), "s"),
}
"""Common spellings of time units, in lower case, with the language's unit.

The micro sign and the Greek letter mu are different characters."""
_NUMBER_AND_UNIT = re.compile(r"([0-9]+(?:\.[0-9]+)?)([^\W\d_]+)")
_MOST_PARTS = 1000
"""Largest denominator of a fraction that replaces a decimal number."""
_CHOICE = "a choice is written `A if CONDITION else B`"
_COMPARISONS = {"<>": "!=", "=<": "<=", "=>": ">="}


def fixes(tokens: Tokens, last: int, stuck: Stuck) -> Iterator[Fix]:
    """Yield safe fixes for the token at which the parser stopped; the statement ends at token
    `last`."""
    at = stuck.token
    text, span, after = tokens.text(at), tokens.span(at), _text(tokens, at + 1, last)
    if "TIME" in stuck.expected and (time := _time(text, "")) is not None:
        yield Fix(f"units are ns, us, ms and s: `{time}`", span, time)
    elif "TIME" in stuck.expected and (time := _time(text, after)) is not None:
        yield Fix(f"no blank before the unit: `{time}`", span.to(tokens.span(at + 1)), time)
    elif text == "[" and "tile" in stuck.expected and after == "[":
        yield Fix("write `tile` before the rows", Span(span.start, span.start), "tile ")
    for begin in (at - 1, at):
        pair = _text(tokens, begin, last) + _text(tokens, begin + 1, last)
        if pair in _COMPARISONS and tokens.span(begin).end == tokens.span(begin + 1).start:
            right = _COMPARISONS[pair]
            pair_span = tokens.span(begin).to(tokens.span(begin + 1))
            yield Fix(f"it is written `{right}`", pair_span, right)


def hints(tokens: Tokens, first: int, last: int, stuck: Stuck) -> Iterator[str]:
    """Yield hints for the statement of tokens `first` to `last` in which the parser stopped."""
    at, statement = stuck.token, tokens.kinds[first]
    if statement == "code" and ".." in stuck.expected:
        code_kind, follows = _text(tokens, first + 3, at), _text(tokens, first + 4, at)
        nearest = closest(code_kind, ("bit", "row")) if follows in ("[", "of") else None
        if nearest is not None and code_kind != nearest:
            yield did_you_mean(nearest)
        else:
            yield "a range is two values with two dots between them, both included: `1..8`"
    if at >= last:
        return
    kind, text, before = tokens.kinds[at], tokens.text(at), tokens.text(at - 1)
    if kind == "INTEGER" and "TIME" in stuck.expected:
        if _time(text, _text(tokens, at + 1, last)) is None:
            yield f"every time has a unit: {text[:20]}us, {text[:20]}ms"
    elif kind == "if" and "INTEGER" in stuck.expected:
        yield _CHOICE
    elif kind == "row" and "INTEGER" in stuck.expected:
        yield "`y` is a pixel's row, `x` its column"
    elif before + text == ">>":
        yield (
            "the language has no `>>`: `A / (1 << n)` shifts; bit i of a field `code NAME : "
            "bit[K]` is NAME[i]"
        )  # fmt: skip
    elif kind == "[" and before == "]":
        yield "one index is enough: `book[id]` is the digit of slot n in row id"
    elif kind == "[" and statement == "code":
        yield "a range is written LO..HI: `1..8`"
    elif kind == "[" and "tile" in stuck.expected:
        yield "rows of values are a tile, which is repeated over the array: `tile [[4, 3], [2, 1]]`"
    elif stuck.expected == {"["} and statement == "pixels":
        yield "a tile is a list of rows: `tile [[4, 3], [2, 1]]`, a single row `tile [[4, 3]]`"
    elif kind == "from" and statement == "pixels":
        yield (
            '`pixels from "codes.npz"` sets every field without its own `pixels` statement, by name'
        )
    elif kind == "(" and before.lower().startswith(("rand", "rnd")):
        yield 'random codes are data: save them with numpy.savez, and `pixels from "codes.npz"`'


def number_hints(tokens: Tokens, at: int) -> Iterator[str]:
    """Yield hints for token `at`, which starts like a number but is invalid."""
    text = tokens.text(at)
    if re.fullmatch(r"[0-9]{1,9}\.[0-9]{1,9}", text):
        yield "numbers are integers; only times have decimals, with a unit: 1.6ms"
        yield from _quotient(tokens, at)
    elif "." in text:
        yield "only times have decimals, with the unit ns, us, ms or s: 1.6ms"
    elif re.fullmatch("0[xX][0-9a-fA-F]{1,15}|0[bB][01]{1,60}|0[oO][0-7]{1,20}", text):
        yield f"numbers are decimal: {int(text, 0)}"
    elif "_" in text:
        yield "only the rows of `shutters` have digits in groups: 1111_0000"
    elif _time(text, "") is None:
        yield "numbers are digits, names begin with a letter, times end in ns, us, ms or s"


def file_hint(tokens: Tokens, at: int) -> str | None:
    """Return a hint for a dot at token `at` inside a file name, or None."""
    beside = tokens.text(at - 1) if at else "", _text(tokens, at + 1, len(tokens.kinds))
    touching = at and tokens.span(at - 1).end == tokens.span(at).start
    if touching and beside[1] in ("npz", "npy", "toml", "mat"):
        return f'write the file name in quotes: "{beside[0]}.{beside[1]}"'
    return None


def _text(tokens: Tokens, at: int, last: int) -> str:
    return tokens.text(at) if 0 <= at < last else ""


def _quotient(tokens: Tokens, at: int) -> Iterator[str]:
    """Yield a hint for multiplying or dividing by a decimal number in integer arithmetic."""
    kinds, number = tokens.kinds, tokens.text(at)
    before, after = kinds[at - 1], kinds[at + 1 : at + 2]
    fraction = Fraction(number)
    if not fraction or fraction.denominator > _MOST_PARTS or fraction.numerator > _MOST_PARTS:
        return
    factor_place = at - 2
    if before == "/":
        fraction = 1 / fraction
    elif before != "*":
        if after != ["*"]:
            return
        before, factor_place = "*", at + 2
    name = tokens.text(factor_place) if kinds[factor_place : factor_place + 1] == ["NAME"] else "A"
    times = f"* {fraction.numerator}" if fraction.numerator > 1 or fraction.denominator == 1 else ""
    over = f"/ {fraction.denominator}" if fraction.denominator > 1 else ""
    expression = " ".join(filter(None, (name, times, over)))
    yield f"`{name} {before} {number}` is written `{expression}`; `/` rounds down"


def _time(number: str, unit: str) -> str | None:
    """Return a time in the language's form, from a number and a common unit; None for other
    units."""
    match = _NUMBER_AND_UNIT.fullmatch(number + unit)
    meant = _UNITS.get(match[2].lower()) if match else None
    return f"{match[1]}{meant}" if match and meant else None
