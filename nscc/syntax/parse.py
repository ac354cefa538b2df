"""The parser: converts text to a tree, and finds all errors of a file at once.

The tokens are split at the keywords that begin statements, and each statement is parsed separately.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from itertools import pairwise
from pathlib import Path

from nscc.diagnostics.diagnostic import Diagnostic, Fix, Label, Rejected, rejected
from nscc.diagnostics.message import MOST_ERRORS, more_errors
from nscc.diagnostics.suggest import did_you_mean
from nscc.source import Source, Span
from nscc.syntax import tree
from nscc.syntax.build import Builder
from nscc.syntax.lexer import Tokens, lex, read
from nscc.syntax.mistakes import misspelt_statement, mistake, unknown_statement
from nscc.syntax.words import statement_words

__all__ = ["MOST_BYTES", "MOST_ERRORS", "declared_at", "parse", "read_source"]

VERSIONS = (1, 2, 3, 4)
"""The versions of the language that this compiler reads."""

_OTHER_LANGUAGE = re.compile(
    r"""\s*(?:\#[^\n]*\n\s*)*              # its directives look like our comments
        (?: //|/\*
          | (?:module|declare|struct|component|package|library|entity|import)\b )""",
    re.VERBOSE,
)
_BEFORE_A_NAME = (
    "let",
    "code",
    "pixels",
    "shutters",
    "bucket",
    "state",
    "next",
    "kernel",
    "image",
    "plane",
    "param",
)
_AFTER_A_NAME = ("=", ":", "[", "from", "open")
_BEFORE_A_KIND = (":", "WITH", "input")
"""The tokens before `image` and `plane` where these words begin no statement."""


def parse(source: Source) -> tuple[tree.File, tuple[Diagnostic, ...]]:
    """Return the tree of the valid statements of a program, and every error in the order of the
    text.

    If a statement has an error, the part before the error is kept if it is a valid statement. After
    MOST_ERRORS errors, NS0190 counts the others. If the text is too large or of another language or
    version, that is the only error. Never raises for invalid text."""
    span = Span(0, len(source.text))
    # The first test spares the encoding of a huge text.
    if len(source.text) > MOST_BYTES or len(source.text.encode("utf-8", "replace")) > MOST_BYTES:
        return tree.File(span, ()), (too_large(source.name),)
    tokens = lex(source)
    starts = statement_starts(tokens)
    errors = _Errors(source)
    if tokens.kinds[:1] != ["nsl"]:
        if "nsl" not in tokens.kinds and _OTHER_LANGUAGE.match(source.text):
            other_language = Diagnostic(
                "NS0105",
                "this looks like a hardware description, not like a shutter program",
                source=source,
                label=Label(tokens.span(0)),
                notes=("files of the hardware description language NSL also end in .nsl",),
                helps=("name a shutter program; its first statement is `nsl 1`",),
            )
            return tree.File(span, ()), (other_language,)
        errors.add(lambda: _no_language_line(tokens, starts))
    statements = tuple(_statements(tokens, starts, errors))
    versions = [s for s in statements if isinstance(s, tree.Version)]
    for version in versions:
        number = version.number
        if number.value not in VERSIONS:
            first, last = VERSIONS[0], VERSIONS[-1]
            unknown_version = Diagnostic(
                "NS0106",
                f"this program uses version {number.value} of the language; this nscc reads "
                f"versions {first} to {last}",
                source=source,
                label=Label(number.span),
                helps=(f"write `nsl {first}`, or use the nscc that the program was written for",),
            )
            return tree.File(span, statements), (unknown_version,)
    if len(versions) > 1 and tokens.kinds[0] == "nsl":
        errors.add(lambda: _said_twice(source, versions))
    return tree.File(span, statements), errors.in_order()


def declared_at(source: Source, name: str) -> Span:
    """Return the place of the statement that declares `name`, an image, plane or input plane, or
    changes the state `name`.

    Of several, it is the first in the text. Without one, return the place of the first statement;
    the text has at least one."""
    statements = parse(source)[0].statements
    kinds = tree.Image | tree.Plane | tree.Next | tree.Input
    for statement in statements:
        if isinstance(statement, tree.Repeat):
            names = [item.name.text for item in statement.items]
        else:
            names = [statement.name.text] if isinstance(statement, kinds) else []
        if name in names:
            return statement.span
    return statements[0].span


class _Errors:
    """Collects the errors of a text: keeps the first MOST_ERRORS, and counts the others."""

    def __init__(self, source: Source) -> None:
        """Begin without errors; `source` is the text that their places refer to."""
        self._source = source
        self._first: list[Diagnostic] = []
        self._more = 0

    @property
    def are_many(self) -> bool:
        """Whether further errors are only counted."""
        return len(self._first) >= MOST_ERRORS

    def add(self, make: Callable[[], Diagnostic]) -> None:
        """Add the diagnostic that `make` returns; beyond MOST_ERRORS it is only counted, and `make`
        not called."""
        if self.are_many:
            self._more += 1
        else:
            self._first.append(make())

    def in_order(self) -> tuple[Diagnostic, ...]:
        """Return the diagnostics in the order of the text; a last one (NS0190) tells how many were
        only counted, if any."""
        diagnostics = sorted(self._first, key=lambda d: d.label.span.start if d.label else 0)
        if self._more:
            diagnostics.append(more_errors(self._more, self._source))
        return tuple(diagnostics)


def statement_starts(tokens: Tokens) -> list[int]:
    """Return the numbers of the tokens that begin statements, ascending; none for a text without
    keywords.

    `open` belongs to the `bucket` before it, and a keyword at the place of a name (`let open = 1`)
    belongs to its statement."""
    words = frozenset(statement_words(tokens.version))
    kinds = tokens.kinds
    starts: list[int] = []
    awaits_open = False
    for index, kind in enumerate(kinds):
        if kind not in words:
            continue
        if (
            starts
            and starts[-1] == index - 1
            and kinds[index - 1] in _BEFORE_A_NAME
            # Slices instead of items, because the text may end here.
            and kinds[index + 1 : index + 2] in [[after] for after in _AFTER_A_NAME]
            and kinds[index : index + 2] != ["pixels", "from"]
        ):
            continue
        # `state NAME : image`, `with plane NAME` and `input plane NAME`.
        if kind in ("image", "plane") and starts and kinds[index - 1] in _BEFORE_A_KIND:
            continue
        if kind == "open" and awaits_open:
            awaits_open = False
            continue
        awaits_open = kind == "bucket"
        starts.append(index)
    return starts


def _statements(tokens: Tokens, starts: list[int], errors: _Errors) -> Iterator[tree.Statement]:
    """Yield the valid statements; add the errors of the invalid ones to `errors`.

    `starts` are the numbers of the tokens that begin statements. A statement with an error is
    yielded up to the error if that is a valid statement. After a misspelt keyword, parsing
    continues as if it were spelt correctly."""
    builder = Builder()
    for begin, last in pairwise([*starts, len(tokens.kinds)]):
        first: int | None = begin
        while first is not None:
            start, first = first, None
            try:
                parsed, stuck = read(tokens, start, last)
                misspelt = None
                if stuck is not None and not errors.are_many:
                    misspelt = misspelt_statement(tokens, start, last, stuck)
                if misspelt is not None:  # parsing continues at the misspelt keyword
                    first, word = misspelt
                    errors.add(partial(unknown_statement, tokens, first))
                    tokens.read_as(first, word)
                    parsed, stuck = read(tokens, start, first)
                statement = builder.build(parsed) if parsed is not None else None
            except Rejected as wrong:
                errors.add(partial(replace, wrong.diagnostics[0], source=tokens.source))
            else:
                if stuck is not None:
                    errors.add(partial(mistake, tokens, start, first or last, stuck))
                if statement is not None:
                    yield statement


def _no_language_line(tokens: Tokens, starts: list[int]) -> Diagnostic:
    """Return the error (NS0104) that a text does not begin with its language version, such as `nsl
    1`.

    An empty file gives this error, too. `starts` are the numbers of the tokens that begin
    statements."""
    source = tokens.source
    if not tokens.kinds:
        message = "this file is empty; a shutter program begins with `nsl 1`"
        return Diagnostic("NS0104", message, source=source, label=Label(Span(0, 0)))
    span = tokens.span(0)
    word = tokens.text(0)
    # A version line further below is moved up, rather than added a second time.
    later = next((index for index in starts if tokens.kinds[index] == "nsl"), None)
    helps: tuple[str, ...] = ()
    fixes: tuple[Fix, ...] = ()
    if later is not None:
        helps = ("move it to the start; only comments may come before it",)
        if source.text.startswith(("//", "/*"), span.start):
            helps = ("comments begin with `#`",)
    elif word.isalpha() and sorted(word.lower()) == sorted("nsl"):
        fixes = (Fix(did_you_mean("nsl"), span, "nsl", sure=False),)
    else:
        fixes = (Fix("begin with `nsl 1`", Span(span.start, span.start), "nsl 1\n"),)
    return Diagnostic(
        "NS0104",
        "a shutter program begins with `nsl 1`: the language and its version",
        source=source,
        label=Label(span, "this comes first"),
        related=() if later is None else (Label(tokens.span(later), "too late"),),
        helps=helps,
        fixes=fixes,
    )


def _said_twice(source: Source, versions: list[tree.Version]) -> Diagnostic:
    """Return the error (NS0104) for the second of `versions`, the version statements of `source`,
    with a fix that removes it. There are at least two."""
    return Diagnostic(
        "NS0104",
        f"`nsl {versions[0].number.value}` must appear once, at the start",
        source=source,
        label=Label(versions[1].span, "said again"),
        related=(Label(versions[0].span, "said here"),),
        fixes=(Fix("remove it", versions[1].span, ""),),
    )


MOST_BYTES = 256 * 1024
"""Largest program text in bytes, as UTF-8."""


def read_source(path: Path) -> Source:
    """Return the text of a program file, without a byte order mark.

    At most one byte more than MOST_BYTES is read. Raises Rejected: NS0101 (status 2) if the file
    cannot be read, and status 1: NS0103 if it exceeds 256 KiB, NS0102 if it is not UTF-8."""
    name = path.as_posix()
    try:
        with open(path, "rb") as file:
            data = file.read(MOST_BYTES + 1)
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        help_text = "name a shutter program, a text file that ends in .nsl"
        raise rejected("NS0101", f"cannot read '{name}': {reason}", helps=(help_text,)) from None
    return source_of(path, data)


def source_of(path: Path, data: bytes) -> Source:
    """Return the text in `data`, the bytes of a program file, without a byte order mark.

    `path` names the file in messages. Raises Rejected (status 1): NS0103 if it exceeds 256 KiB,
    NS0102 if it is not UTF-8 or contains a zero byte. The diagnostic has the file's name but no
    text."""
    name = path.as_posix()
    if len(data) > MOST_BYTES:
        raise (
            _not_text(path, f"byte {data.index(0)} is zero")
            if 0 in data
            else Rejected(too_large(name))
        )
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        position = f"byte {error.start} (0x{data[error.start]:02x})"
        raise _not_text(path, f"{position} is not UTF-8") from None
    if "\0" in text:
        raise _not_text(path, f"byte {data.index(0)} is zero")
    return Source(name, text)


def too_large(name: str) -> Diagnostic:
    """Return the error (NS0103) that the text of the program `name` exceeds the size limit."""
    return Diagnostic(
        "NS0103",
        f"this program is larger than {MOST_BYTES // 1024} KiB, the largest size of a program",
        helps=('store data in a separate file: `pixels from "codes.npz"`',),
        source=Source(name, ""),
    )


def _not_text(path: Path, reason: str) -> Rejected:
    """Return the exception (NS0102, status 1) that the file `path` is not UTF-8 text, for `reason`,
    which ends the message.

    The help depends on the ending of its name."""
    ending = path.suffix.lower()
    message = f"this file is not UTF-8 text: {reason}"
    helps = ("save the program as UTF-8 text; a compiled program ends in .icw",)
    if ending == ".icw":
        helps = (
            "it is compiled already: `nscc run`, `view`, `prove`, `shutters` and `disasm` "
            "accept it; this command needs the .nsl file",
        )
    elif ending != ".nsl":
        helps = (
            "name a shutter program, a text file that ends in .nsl; `nscc run PROGRAM.nsl "
            "--scene SCENE` accepts pictures and clips",
        )
    return rejected("NS0102", message, helps=helps, status=1, source=Source(path.as_posix(), ""))
