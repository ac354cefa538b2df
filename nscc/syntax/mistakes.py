"""Messages for syntax errors: what was expected, what was found, and what was probably meant, also
in the syntax of other languages and with common units."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Set
from fractions import Fraction
from itertools import accumulate
from unicodedata import normalize

from nscc.diagnostics.diagnostic import Diagnostic, Fix, Label
from nscc.diagnostics.suggest import closest, did_you_mean
from nscc.source import Span
from nscc.syntax.lexer import Stuck, Tokens
from nscc.syntax.words import (
    END,
    FORMS,
    expected_words,
    names_in,
    shown,
    spellings,
    statement_words,
)

_SIGNS = {
    ";": ("statements need no semicolon", ""),
    "&": ("`and` joins conditions; bit i of a field `code NAME : bit[K]` is NAME[i]", "and"),
    "&&": ("`and` joins conditions", "and"),
    "|": ("`or` joins conditions", "or"),
    "||": ("`or` joins conditions", "or"),
    "!": ("`not` negates a condition", "not "),
    "~": ("`not` negates a condition", "not "),
    "?": ("a choice is written `A if CONDITION else B`", None),
    "^": ("`xor` is the exclusive or; the language has no powers", None),
    "\u2264": ("it is written `<=`", "<="),
    "\u2265": ("it is written `>=`", ">="),
    "\u2260": ("it is written `!=`", "!="),
    "\u00d7": ("it is written `*`", "*"),
    **dict.fromkeys("\u2010\u2011\u2012\u2013\u2014\u2015\u2212", ("it is written `-`", "-")),
    "\u2227": ("`and` joins conditions", "and"),
    "\u2228": ("`or` joins conditions", "or"),
    "\u00ac": ("`not` negates a condition", "not "),
    "\u2026": ("it is written `..`", ".."),
    ".": ("a range has two dots, `0..7`; only times have decimals", None),
    "'": ('write paths in double quotes, "like this"', None),
    "\u201c": ('write paths in straight quotes, "like this"', '"'),
    "\u201d": ('write paths in straight quotes, "like this"', '"'),
    **dict.fromkeys("{}", ("the language has no braces; a list is written `[1, 2, 3]`", None)),
}
"""Signs of other languages: a hint, and the replacement if it is certain."""
_LOOPS = (
    "there are no loops: a rule holds for every slot `n` and every pixel `x`, `y`: "
    "`open when n < stop`; planes and images have `A repeat K EXPR` from `nsl 4` on"
)
_UNNAMED = "only a named exposure can be read: `bucket NAME open when ...`, `read NAME`"
_FUNCTIONS = "there are no functions: `let NAME = EXPR` names an expression"
_CHOICE = "a choice is written `A if CONDITION else B`"
_VALUES = "`let NAME = EXPR` names a value"
_ELSEWHERE = {
    **dict.fromkeys(("for", "foreach", "while", "loop", "repeat", "do"), _LOOPS),
    **dict.fromkeys(("def", "fn", "func", "function", "fun", "lambda", "macro"), _FUNCTIONS),
    **dict.fromkeys(("else", "elif", "then", "switch", "match", "case"), _CHOICE),
    **dict.fromkeys(("var", "const", "int", "float", "auto", "val", "define"), _VALUES),
    **dict.fromkeys(("import", "include", "use"),
                    'a program is one file; data comes by `pixels from "codes.npz"`'),
    **dict.fromkeys(("slots", "slot"), "`frame 64 slots of 125us` gives the number of slots"),
    "return": "the value of a rule is its expression: `open when EXPR`",
}  # fmt: skip
"""Words that begin statements in other languages: what to write instead."""


def mistake(tokens: Tokens, first: int, last: int, stuck: Stuck) -> Diagnostic:
    """Return the error for the statement of tokens number `first` to `last` - 1, in which the
    parser stopped at `stuck`.

    It is NS0114 for a missing quotation mark, NS0108 for a stray character, NS0109 for an unknown
    statement, NS0113 for a keyword as a name, and else NS0107."""
    if stuck.token < last:
        kind = tokens.kinds[stuck.token]
        if kind == "UNCLOSED":
            return Diagnostic(
                "NS0114",
                "the closing quotation mark is missing",
                source=tokens.source,
                label=Label(tokens.span(stuck.token)),
                helps=("close the quotes on the same line",),
            )
        if kind == "STRAY":
            return _stray(tokens, stuck.token, stuck.expected)
        if END in stuck.expected and (
            kind == "NAME" or (_is_word(kind) and _begins_line(tokens, stuck.token))
        ):
            return unknown_statement(tokens, stuck.token, filter(_is_word, stuck.expected))
        if _is_word(kind) and stuck.expected <= {"NAME", "TARGET_NAME", "TEXT", "from"}:
            word = tokens.text(stuck.token)
            return Diagnostic(
                "NS0113",
                f"`{word}` is a reserved word and cannot be a name",
                source=tokens.source,
                label=Label(tokens.span(stuck.token), "a name is required here"),
                notes=_forms(tokens.kinds[first]),
                helps=(
                    _UNNAMED
                    if (kind, tokens.kinds[first]) == ("exposure", "read")
                    else f"choose another name, `{word}_` for example",
                ),
            )
    statement = tokens.kinds[first]
    expected = expected_words(stuck.expected)
    if stuck.token < last:
        span, actual = tokens.span(stuck.token), shown(tokens.text(stuck.token))
    else:
        end = tokens.span(last - 1).end
        span, actual = Span(end, end), "the end of the file"
        if last < len(tokens.kinds):
            actual = f"the next statement, {shown(tokens.text(last))}"
    # The innermost open bracket where the parser stopped, if closing it would be valid.
    opened = _open_brackets(tokens, first, stuck) if stuck.expected & {"]", ")"} else []
    return Diagnostic(
        "NS0107",
        f"in this `{statement}` statement: expected {expected}, found {actual}",
        source=tokens.source,
        label=Label(span, f"expected {expected}"),
        related=tuple(Label(tokens.span(at), "opened here") for at in opened[-1:]),
        notes=_forms(statement),
        helps=(*_hints(tokens, first, last, stuck), *_habit_hints(tokens, first, last, stuck)),
        fixes=tuple(_fixes(tokens, first, last, stuck)),
    )


def misspelt_statement(
    tokens: Tokens, first: int, last: int, stuck: Stuck
) -> tuple[int, str] | None:
    """Return the number of the token that is probably a misspelt keyword of a new statement, and
    the correct keyword, or None.

    The parser stopped at `stuck` in the statement of tokens `first` to `last` - 1. The token is
    where a statement may begin, or first on its line; the parser may have read it as an operand and
    stopped at the next token."""
    for index in (stuck.token, stuck.token - 1):
        if not first < index < last or tokens.kinds[index] != "NAME":
            continue
        if _begins_line(tokens, index) or (index == stuck.token and END in stuck.expected):
            word = tokens.text(index)
            spelling = closest(word, statement_words(tokens.version))
            if spelling is not None and word.lower() not in _ELSEWHERE:
                return index, spelling
    return None


def unknown_statement(tokens: Tokens, token: int, others: Iterable[str] = ()) -> Diagnostic:
    """Return the error (NS0109) for an unknown word at the start of a statement.

    `token` is its number; the words `others` could also stand there and are suggested, too. The
    help says which version has the word, what replaces it, or the most similar word."""
    word = tokens.text(token)
    words = statement_words(tokens.version)
    span = tokens.span(token)
    later = min(
        (v for v in (2, 3, 4) if word in names_in(tokens.version) - names_in(v)), default=None
    )
    elsewhere = _ELSEWHERE.get(word.lower())
    spelling = None if later or elsewhere else closest(word, (*words, *others))
    return Diagnostic(
        "NS0109",
        f"unknown statement {shown(word)}",
        source=tokens.source,
        label=Label(span, "a statement must begin here, or the previous one continue"),
        notes=("statements begin with " + ", ".join(words),),
        helps=(f"`{word}` is a word of version {later}: begin the file with `nsl {later}`",)
        if later
        else (elsewhere,)
        if elsewhere
        else (),
        fixes=(Fix(did_you_mean(spelling), span, spelling, sure=False),) if spelling else (),
    )


def _begins_line(tokens: Tokens, index: int) -> bool:
    """Return whether token number `index`, other than the first, is the first of its line."""
    return "\n" in tokens.source.text[tokens.span(index - 1).end : tokens.span(index).start]


def _is_word(kind: str) -> bool:
    """Return whether a kind of token is a keyword, and not a sign."""
    return kind in spellings().values() and kind.isalnum()


def _stray(tokens: Tokens, token: int, expected: Set[str]) -> Diagnostic:
    """Return the error (NS0108) for a character that no token begins with.

    It has a fix if the meaning of the character is known. `token` is the number of its token.
    `expected` are the kinds of token that the grammar allows here."""
    text, span = tokens.text(token), tokens.span(token)
    # `&&` and `||` are two tokens, each a stray character.
    doubled = text + tokens.text(token + 1) if token + 1 < len(tokens.kinds) else ""
    if doubled in _SIGNS and tokens.span(token + 1).start == span.end:
        text, span = doubled, Span(span.start, span.end + 1)
    if text.isidentifier():
        return Diagnostic(
            "NS0108",
            f"{shown(text)} is not a valid name",
            source=tokens.source,
            label=Label(span),
            helps=("names consist of the letters a-z and A-Z, digits and `_`",),
        )
    usual = normalize("NFKC", text)  # the ordinary form of a full-width character
    hint, instead = _SIGNS.get(text, ("remove it; comments begin with `#`", None))
    if text not in _SIGNS and usual != text and usual.isascii() and usual.strip():
        hint, instead = f"this is a full-width character: write `{usual}`", usual
    elif instead == "-" and ".." in expected:
        hint, instead = "a range has two dots, both ends included: `1..8`", ".."
    file = _file_hint(tokens, token) if text == "." else None
    if text.isspace():
        hint, instead = "this is not an ordinary space", " "
    elif text == ";" and "]" in expected:
        hint, instead = "separate rows and values with commas", ","
    elif file is not None:
        hint = file
    return Diagnostic(
        "NS0108",
        f"unexpected character {shown(text)}",
        source=tokens.source,
        label=Label(span),
        helps=() if instead is not None else (hint,),
        fixes=() if instead is None else (Fix(hint, span, instead),),
    )


def _forms(statement: str) -> tuple[str, ...]:
    """Return how a statement, given by its first word (a key of `FORMS`), is written, as notes of
    an error."""
    return tuple(f"written as: {form}" for form in FORMS[statement])


def _open_brackets(tokens: Tokens, first: int, stuck: Stuck) -> list[int]:
    """Return the numbers of the tokens that open a bracket in the statement from token `first` on,
    and are not closed before parsing stopped. The innermost is the last."""
    opened: list[int] = []
    for index in range(first, stuck.token):
        if tokens.kinds[index] in ("[", "(", "PLACE"):
            opened.append(index)
        elif tokens.kinds[index] in "])" and opened:
            opened.pop()
    return opened


def _hints(tokens: Tokens, first: int, last: int, stuck: Stuck) -> Iterator[str]:
    """Yield hints about the token at which parsing stopped, in the statement of tokens `first` to
    `last` - 1. There are none if the statement ended too early."""
    if stuck.token >= last:
        return
    # Each branch recognises a habit from another language, or a common slip, by the stuck token.
    kind, text = tokens.kinds[stuck.token], tokens.text(stuck.token)
    if kind == "MALFORMED":
        yield from _number_hints(tokens, first, stuck.token)
    elif kind == "GROUPED":
        yield "only the rows of `shutters` have digits in groups"
    elif kind == "TIME" and tokens.kinds[first] != "frame":
        yield "only `frame` uses times; other numbers have no unit"
    elif kind == "not" and "(" in stuck.expected:
        yield "`not` has a lower precedence than comparisons and arithmetic: put brackets around it"
    elif kind in ("/", "*") and tokens.kinds[stuck.token - 1] in ("/", "*"):
        pair = tokens.text(stuck.token - 1) + text
        yield "the language has no powers" if pair == "**" else _SLASHES
    elif kind == "/" and _text(tokens, stuck.token + 1, last) == "/":
        yield _SLASHES
    elif kind == "(" and tokens.kinds[first] in ("image", "plane"):
        yield "a kernel is applied by its name: `k(exposure)`; the product with 2 is `2 * image`"
    elif kind == "(" and tokens.kinds[stuck.token - 1] == "NAME":
        name = tokens.text(stuck.token - 1)
        yield f"functions are `min` and `max`; a bit of a field, or a digit of a row, is {name}[..]"
    elif tokens.kinds[stuck.token - 1] == "in":
        yield "the values of `in` are a list: `n in [1, 2, 3]`"
    elif kind == ":" and "else" in stuck.expected:
        yield f"there are no blocks: write `open when CONDITION`; {_CHOICE}"
    elif kind == "INTEGER" and "]" in stuck.expected and tokens.kinds[first] == "shutters":
        yield "separate rows with commas; groups of digits are joined by `_`: 1111_0000"
    elif kind in ("]", ")") and not _open_brackets(tokens, first, stuck):
        yield f"the closing {shown(text)} has no opening bracket"


def _fixes(tokens: Tokens, first: int, last: int, stuck: Stuck) -> Iterator[Fix]:
    """Yield changes that correct the token at which parsing stopped, in the statement of tokens
    `first` to `last` - 1. There are none if the statement ended too early."""
    if stuck.token >= last:
        return
    kind, text, span = tokens.kinds[stuck.token], tokens.text(stuck.token), tokens.span(stuck.token)
    usual = list(_habit_fixes(tokens, last, stuck))
    if usual:
        yield from usual
    elif kind == "=" and {"COMPARISON", "or"} <= stuck.expected:
        yield Fix("equality is written `==`", span, "==")
    elif kind == "NAME":
        spelling = closest(text, (word for word in stuck.expected if _is_word(word)))
        if spelling is not None:
            yield Fix(did_you_mean(spelling), span, spelling, sure=False)


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
_SLASHES = "comments begin with `#`; `/` divides and rounds down"
_COMPARISONS = {"<>": "!=", "=<": "<=", "=>": ">="}


def _habit_fixes(tokens: Tokens, last: int, stuck: Stuck) -> Iterator[Fix]:
    """Yield safe fixes for what is usual elsewhere, at the token at which parsing stopped.

    These are spellings of units and comparisons, and a tile without its word. Parsing stopped at
    `stuck`, and the statement ends before token number `last`."""
    token = stuck.token
    text, span, after = tokens.text(token), tokens.span(token), _text(tokens, token + 1, last)
    if "TIME" in stuck.expected and (time := _time(text, "")) is not None:
        yield Fix(f"units are ns, us, ms and s: `{time}`", span, time)
    elif "TIME" in stuck.expected and (time := _time(text, after)) is not None:
        yield Fix(f"no blank before the unit: `{time}`", span.to(tokens.span(token + 1)), time)
    elif text == "[" and "tile" in stuck.expected and after == "[":
        yield Fix("write `tile` before the rows", Span(span.start, span.start), "tile ")
    # `=<` is read as two signs; the parser stops at the first or at the second.
    for begin in (token - 1, token):
        pair = _text(tokens, begin, last) + _text(tokens, begin + 1, last)
        if pair in _COMPARISONS and tokens.span(begin).end == tokens.span(begin + 1).start:
            right = _COMPARISONS[pair]
            pair_span = tokens.span(begin).to(tokens.span(begin + 1))
            yield Fix(f"it is written `{right}`", pair_span, right)


def _habit_hints(tokens: Tokens, first: int, last: int, stuck: Stuck) -> Iterator[str]:
    """Yield hints about what is usual in other languages, in the statement of tokens `first` to
    `last` - 1, at the token where parsing stopped (`stuck`)."""
    token, statement = stuck.token, tokens.kinds[first]
    if statement == "code" and ".." in stuck.expected:
        # The tokens are `code`, the name, `:` and then the kind.
        code_kind, follows = _text(tokens, first + 3, token), _text(tokens, first + 4, token)
        nearest = closest(code_kind, ("bit", "row")) if follows in ("[", "of") else None
        if nearest is not None and code_kind != nearest:
            yield did_you_mean(nearest)
        else:
            low, dash, high = (_text(tokens, first + k, last) for k in (3, 4, 5))
            example = f"{low}..{high}" if dash in ("-", "to", ":", ",") else "1..8"
            yield f"a range is two values with two dots between them, both included: `{example}`"
    if token >= last:
        return
    kind, text, before = tokens.kinds[token], tokens.text(token), tokens.text(token - 1)
    if kind == "INTEGER" and "TIME" in stuck.expected:
        if _time(text, _text(tokens, token + 1, last)) is None:
            yield f"every time has a unit: {text[:20]}us, {text[:20]}ms"
    elif kind == "if" and "INTEGER" in stuck.expected:
        yield _choice(tokens, token, last)
    elif text == "then":
        yield _CHOICE
    elif kind == "row" and "INTEGER" in stuck.expected:
        yield "`y` is a pixel's row, `x` its column"
    elif before + text == ">>":
        yield (
            "the language has no `>>`: `A / (1 << n)` shifts; bit i of a field `code NAME : "
            "bit[K]` is NAME[i]"
        )
    elif kind == "[" and before == "]":
        yield "one index is enough: `book[id]` is the digit of slot n in row id"
    elif kind == "[" and statement == "code":
        yield "a range is written LO..HI: `1..8`"
    elif kind == "[" and "tile" in stuck.expected:
        yield "rows of values are a tile, which is repeated over the array: `tile [[4, 3], [2, 1]]`"
    elif stuck.expected == {"["} and statement == "pixels":
        yield "a tile is a list of rows: `tile [[4, 3], [2, 1]]`, a single row `tile [[4, 3]]`"
    elif statement == "sense" and "%" in (before, text):
        yield "a level is one number with its unit, without a sign or a blank: `45%`"
    elif kind == "=" and stuck.expected == {"COMPARISON"}:
        yield "light is compared by `>` or `<`: a comparator cannot test whether charges are equal"
    elif kind == "]" and statement in ("plane", "next"):
        yield "the bit of a neighbour is PLANE[dx, dy]: dx columns to the right, dy rows down"
    elif kind == "exposure" and statement == "read":
        yield _UNNAMED
    elif kind == "from" and statement == "pixels":
        yield (
            '`pixels from "codes.npz"` sets every field without its own `pixels` statement, by name'
        )
    elif kind == "(" and before.lower().startswith(("rand", "rnd")):
        yield 'random codes are data: save them with numpy.savez, and `pixels from "codes.npz"`'


def _choice(tokens: Tokens, at: int, last: int) -> str:
    """Return the hint for a choice written as `if C then A else B`: how it is written, in the words
    of the program if it has `then` and `else`. At most 200 characters are returned.

    `at` is the number of the token `if`, and `last` the end of the statement."""
    texts = [tokens.text(k) for k in range(at, last)]
    if "then" not in texts or "else" not in texts[texts.index("then") :]:
        return _CHOICE
    then_at, else_at = at + texts.index("then"), at + texts.index("else")
    # The choice ends at the first bracket that closes one opened before it.
    depths = accumulate((t in ("(", "[")) - (t in (")", "]")) for t in texts)
    last = at + next((k for k, depth in enumerate(depths) if depth < 0), len(texts))
    parts = ((then_at + 1, else_at), (at + 1, then_at), (else_at + 1, last))
    chosen, condition, otherwise = (
        tokens.source.text[tokens.span(begin).start : tokens.span(end - 1).end]
        if begin < end
        else "..."
        for begin, end in parts
    )
    return f"{_CHOICE}: `{chosen} if {condition} else {otherwise}`"[:200]


def _number_hints(tokens: Tokens, first: int, at: int) -> Iterator[str]:
    """Yield hints about token number `at`, which starts like a number but is invalid (kind
    MALFORMED). There may be two or none.

    `first` is the number of the first token of its statement."""
    text = tokens.text(at)
    if re.fullmatch(r"[0-9]{1,9}\.[0-9]{1,9}", text):
        yield "numbers are integers; only times have decimals, with a unit: 1.6ms"
        yield from _quotient(tokens, first, at)
    elif "." in text:
        yield "only times have decimals, with the unit ns, us, ms or s: 1.6ms"
    elif re.fullmatch("0[xX][0-9a-fA-F]{1,15}|0[bB][01]{1,60}|0[oO][0-7]{1,20}", text):
        yield f"numbers are decimal: {int(text, 0)}"
    elif "_" in text:
        yield "only the rows of `shutters` have digits in groups: 1111_0000"
    elif _time(text, "") is None:
        yield "numbers are digits, names begin with a letter, times end in ns, us, ms or s"


def _file_hint(tokens: Tokens, at: int) -> str | None:
    """Return the hint that a file name needs quotes, if token number `at` is a dot before the
    ending .npz, .npy, .toml or .mat, else None."""
    beside = tokens.text(at - 1) if at else "", _text(tokens, at + 1, len(tokens.kinds))
    touching = at and tokens.span(at - 1).end == tokens.span(at).start
    if touching and beside[1] in ("npz", "npy", "toml", "mat"):
        return f'write the file name in quotes: "{beside[0]}.{beside[1]}"'
    return None


def _text(tokens: Tokens, at: int, last: int) -> str:
    """Return the text of token number `at`; "" before the first token and from `last` on."""
    return tokens.text(at) if 0 <= at < last else ""


def _quotient(tokens: Tokens, first: int, at: int) -> Iterator[str]:
    """Yield a hint on how to multiply or divide by the decimal number at token `at`, such as `A * 3
    / 2`.

    `first` is the first token of the statement. Yield nothing unless it is a factor or divisor
    other than 0, and a fraction of integers up to `_MOST_PARTS`."""
    kinds, number = tokens.kinds, tokens.text(at)
    before, after = kinds[at - 1], kinds[at + 1 : at + 2]
    fraction = Fraction(number)
    if not fraction or fraction.denominator > _MOST_PARTS or fraction.numerator > _MOST_PARTS:
        return
    factor_place = at - 2  # of `A * 1.5` or `A / 1.5`
    if before == "/":
        fraction = 1 / fraction
    elif before != "*":
        if after != ["*"]:
            return
        before, factor_place = "*", at + 2  # of `1.5 * A`
    name = tokens.text(factor_place) if kinds[factor_place : factor_place + 1] == ["NAME"] else "A"
    times = f"* {fraction.numerator}" if fraction.numerator > 1 or fraction.denominator == 1 else ""
    over = f"/ {fraction.denominator}" if fraction.denominator > 1 else ""
    expression = " ".join(filter(None, (name, times, over)))
    rounds = "" if kinds[first] == "image" else "; `/` rounds down"
    yield f"`{name} {before} {number}` is written `{expression}`{rounds}"


def _time(number: str, unit: str) -> str | None:
    """Return a time in the language's form, such as "5us", from the texts of a number and a common
    unit, such as "5" and "usec". Return None for other units, and if they are no number with a
    unit."""
    match = _NUMBER_AND_UNIT.fullmatch(number + unit)
    meant = _UNITS.get(match[2].lower()) if match else None
    return f"{match[1]}{meant}" if match and meant else None
