"""From text to tree. All errors of a file are found in one go: a file is split at the words that
begin statements, and each statement is parsed by itself."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

from lark import Lark, Token
from lark.exceptions import UnexpectedToken

from nscc.diagnostics.model import Diagnostic, Label, Rejected
from nscc.source import Source, Span
from nscc.syntax import tree
from nscc.syntax.build import Builder, Refused, plain_tile, span_of
from nscc.syntax.words import FORMS, OTHER_WORDS, STATEMENT_WORDS, expected_words

MOST_BYTES = 256 * 1024
MOST_ERRORS = 20

_OTHER_LANGUAGE = re.compile(r"\s*(?:/[/*]|(?:module|declare|struct)\b[^\n]*\{)")


def read_source(path: Path) -> Source:
    """Reads a program's text.

    Raises Rejected: NS0101 (status 2) where the file cannot be read, NS0103 over 256 KiB, NS0102 where
    the bytes are not UTF-8 text.
    """
    name = path.as_posix()
    try:
        with open(path, "rb") as file:
            data = file.read(MOST_BYTES + 1)
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise Rejected(
            Diagnostic(
                "NS0101",
                f"cannot read '{name}': {reason}",
                helps=("name a shutter program, a text file that ends in .nsl",),
            ),
            status=2,
        ) from None
    if len(data) > MOST_BYTES:
        raise Rejected(_too_large(name))
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise Rejected(_no_text(name, f"byte {error.start} is not UTF-8")) from None
    if "\0" in text:
        raise Rejected(_no_text(name, f"character {text.index(chr(0))} is NUL"))
    return Source(name, text)


def _too_large(name: str) -> Diagnostic:
    return Diagnostic(
        "NS0103",
        f"'{name}' is larger than {MOST_BYTES // 1024} KiB",
        helps=('data belongs in a file of its own: `pixels from "codes.npz"`',),
    )


def _no_text(name: str, reason: str) -> Diagnostic:
    return Diagnostic(
        "NS0102",
        f"'{name}' is not a text in UTF-8: {reason}",
        helps=("save it as UTF-8 text",),
    )


def parse(source: Source) -> tuple[tree.File, tuple[Diagnostic, ...]]:
    """The tree of what could be read, and every error in the text, in its order."""
    if len(source.text) > MOST_BYTES:
        return tree.File(Span(0, 0), ()), (_too_large(source.name),)
    found: list[Diagnostic] = []
    statements: list[Any] = []
    for tokens in _split(source, found):
        statement = _statement(source, tokens, found)
        if statement is not None:
            statements.append(statement)
    whole = Span(0, len(source.text))
    if not found or not _is_other_language(source, statements):
        _check_version(source, statements, found)
    else:
        found = [_other_language(source)]
    found.sort(key=lambda d: d.label.span.start if d.label else 0)
    if len(found) > MOST_ERRORS:
        more = len(found) - MOST_ERRORS
        found = found[:MOST_ERRORS]
        found.append(
            Diagnostic("NS0190", f"and {more} more errors in the text", source=source)
        )
    return tree.File(whole, tuple(statements)), tuple(found)


@cache
def _parser() -> tuple[Lark, Builder]:
    from nscc.syntax.tables import DATA, MEMO

    builder = Builder()
    return Lark._load_from_dict(DATA, MEMO, transformer=builder), builder


def _split(source: Source, found: list[Diagnostic]) -> Iterator[list[Token]]:
    """Tokens by statement; what comes before the first statement's word is reported."""
    parser, _ = _parser()
    words = {word.upper() for word in STATEMENT_WORDS}
    current: list[Token] = []
    before: list[Token] = []
    for token in parser.lex(source.text):
        begins = token.type in words and not (
            token.type == "OPEN" and 0 < len(current) < 3 and current[0].type == "BUCKET"
        )
        if begins:
            if current:
                yield current
            current = [token]
        elif current:
            current.append(token)
        else:
            before.append(token)
    if current:
        yield current
    if before:
        span = span_of(before[0]).to(span_of(before[-1]))
        found.append(_unknown_statement(source, before[0], span))


def _statement(source: Source, tokens: list[Token], found: list[Diagnostic]) -> Any:
    """The node of one statement, or None with a diagnostic added."""
    if tokens[0].type == "TARGET":
        tokens = _join_name(source, tokens)
    parser, builder = _parser()
    builder.reset()
    if tokens[0].type == "PIXELS":
        tile = plain_tile(tokens)
        if tile is not None:
            return tile
    state = parser.parse_interactive(start="statement")
    try:
        for token in tokens:
            state.feed_token(token)
        node = state.feed_eof(tokens[-1])
    except UnexpectedToken as error:
        found.append(_unexpected(source, tokens, error))
        return None
    except Refused as refused:
        found.append(
            Diagnostic(
                refused.code, refused.message, source=source, label=Label(refused.span),
                helps=(refused.help_text,),
            )  # fmt: skip
        )
        return None
    span = span_of(tokens[0]).to(span_of(tokens[-1]))
    return type(node)(span, *(getattr(node, name) for name in node.fields[1:]))


def _join_name(source: Source, tokens: list[Token]) -> list[Token]:
    """A target's name may hold `-`: tokens that touch are one name."""
    joined = tokens[:1]
    rest = tokens[1:]
    if rest and rest[0].type == "NAME":
        end = rest[0].end_pos
        count = 1
        while count < len(rest) and rest[count].start_pos == end:
            end = rest[count].end_pos
            count += 1
        assert end is not None
        text = source.text[rest[0].start_pos : end]
        if re.fullmatch(r"[A-Za-z0-9_-]+", text):
            joined.append(Token("NAME", text, rest[0].start_pos, end_pos=end))
            rest = rest[count:]
    return joined + rest


def _unexpected(source: Source, tokens: list[Token], error: UnexpectedToken) -> Diagnostic:
    token = error.token
    word = str(tokens[0])
    forms = tuple(f"written as: {form}" for form in FORMS[word])
    if token.type == "$END":
        end = tokens[-1].end_pos or 0
        following = _next_word(source, end)
        place, seen = Span(max(end - 1, 0), end), f"the statement ends here{following}"
    else:
        place, seen = span_of(token), f"found `{_shown(str(token))}`"
    if token.type == "STRAY":
        return _stray(source, token)
    expected = expected_words(set(error.accepts or error.expected))
    notes: list[str] = []
    text = str(token)
    index = next((i for i, t in enumerate(tokens) if t is token), 0)
    if token.type == "DECIMAL":
        notes.append("decimals stand only in times, with a unit and no blank: 1.6ms")
    elif text in ("ns", "us", "ms", "s") and index and tokens[index - 1].type == "INT":
        notes.append(f"a time has no blank: {tokens[index - 1]}{text}")
    elif text in OTHER_WORDS and "NAME" in error.expected:
        notes.append(f"`{text}` is a reserved word and cannot be a name")
    elif text == "=" and "COMPARE" in error.expected:
        notes.append("equality is written `==`")
    return Diagnostic(
        "NS0107",
        f"in this `{word}` statement: expected {expected}, {seen}",
        source=source,
        label=Label(place, f"expected {expected}"),
        notes=tuple(notes),
        helps=forms,
    )


def _next_word(source: Source, end: int) -> str:
    rest = source.text[end:].split(None, 1)
    return f", before `{_shown(rest[0])}`" if rest else ", with the file"


_STRAY_HELPS = {
    ";": "statements need no semicolon",
    "&": "conjunction is written `and`",
    "|": "disjunction is written `or`",
    "!": "negation is written `not`",
    "^": "exclusive or is written `xor`",
    "'": 'paths stand in double quotes, "like this"',
    '"': "close the quotes on the same line",
    ".": "a range is written with two dots: 0..7",
}


def _stray(source: Source, token: Token) -> Diagnostic:
    first = str(token)[0]
    what = "these quotes are never closed" if first == '"' else f"`{_shown(first)}` means nothing here"
    hint = _STRAY_HELPS.get(first, "take it out; a comment begins with #")
    code = "NS0114" if first == '"' else "NS0108"
    return Diagnostic(code, what, source=source, label=Label(span_of(token)), helps=(hint,))


def _unknown_statement(source: Source, token: Token, span: Span) -> Diagnostic:
    if token.type == "STRAY":
        return _stray(source, token)
    from nscc.diagnostics.suggest import closest

    near = closest(str(token), STATEMENT_WORDS)
    helps = [f"did you mean `{near}`?"] if near else []
    return Diagnostic(
        "NS0109",
        f"no statement begins with `{_shown(str(token))}`",
        source=source,
        label=Label(span),
        notes=("statements begin with " + ", ".join(STATEMENT_WORDS),),
        helps=tuple(helps),
    )


def _check_version(source: Source, statements: list[Any], found: list[Diagnostic]) -> None:
    versions = [s for s in statements if isinstance(s, tree.Version)]
    for version in versions:
        if version.number.value != 1:
            found.append(
                Diagnostic(
                    "NS0106",
                    f"this file asks for version {version.number.value} of the language; "
                    "this nscc reads version 1",
                    source=source,
                    label=Label(version.number.span),
                    helps=("write `nsl 1`, or use a newer nscc",),
                )
            )
    first = re.match(r"(?:\s|#[^\n]*)*nsl\b", source.text)
    if first is None:
        found.insert(
            0,
            Diagnostic(
                "NS0104",
                "a shutter program begins with `nsl 1`",
                source=source,
                label=Label(Span(0, min(1, len(source.text)))),
                helps=("make `nsl 1` the first statement",),
            ),
        )
    elif len(versions) > 1:
        found.append(
            Diagnostic(
                "NS0104",
                "`nsl 1` is said once, at the start",
                source=source,
                label=Label(versions[1].span),
                helps=("take this one out",),
            )
        )


def _is_other_language(source: Source, statements: list[Any]) -> bool:
    if any(isinstance(s, tree.Version) for s in statements):
        return False
    return bool(_OTHER_LANGUAGE.match(source.text)) or bool(
        re.search(r"^\s*(?:module|declare)\s+\w+\s*(?:interface\s*)?\{", source.text, re.MULTILINE)
    )


def _other_language(source: Source) -> Diagnostic:
    return Diagnostic(
        "NS0105",
        "this looks like the hardware description language NSL, not like a shutter program",
        source=source,
        label=Label(Span(0, min(1, len(source.text)))),
        notes=("both kinds of file end in .nsl; a shutter program begins with `nsl 1`",),
        helps=("name a shutter program; the examples folder has some",),
    )


def _shown(text: str) -> str:
    cut = text if len(text) <= 40 else text[:37] + "..."
    return "".join(ch if ch.isprintable() else "?" for ch in cut)
