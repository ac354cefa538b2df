"""Completion of words, names and files in a program's text, and of assembly text in an editor with
the errors of `nscc asm`."""

from __future__ import annotations

import os
import re
from collections.abc import Collection, Iterator
from functools import cached_property
from hashlib import sha256
from pathlib import Path
from typing import Literal

from nscc.chips.load import DEFAULT_NAME, builtin_target, load_target, target_names
from nscc.chips.target import Target
from nscc.diagnostics.diagnostic import Rejected
from nscc.editing.document import CheckResult, Document
from nscc.macros import mnemonics
from nscc.program.constants import (
    at_scope,
    constants_scope,
    next_scope,
    pixels_scope,
    require_scope,
    rule_scope,
)
from nscc.program.names import PREDEFINED
from nscc.record import Record
from nscc.source import Source, Span
from nscc.syntax.lexer import Stuck, Tokens, lex, read
from nscc.syntax.parse import statement_starts
from nscc.syntax.tree import Bucket
from nscc.syntax.words import END, FORMS, reserved, statement_words
from nscc.words.assembly import assemble
from nscc.words.directives import DIRECTIVES

_MOST_FILES = 200
"""Most files of a folder that are offered."""
_MOST_HASHED_BYTES = 64 << 20
"""Largest file whose hash is offered: the user waits while it is read."""
_WORD = re.compile(r"[\w-]*\Z")
_ENDINGS = {"target": ".toml", "shutters": ".npz", "pixels": ".npz", "kernel": ".npz"}
"""File name endings for the statements that name files."""

_OF_PICTURES = ("image", "plane", "next")
"""Statements whose expressions read images and planes."""
_ONCE = ("nsl", "target", "frame", "reset")


class Offer(Record):
    """A completion: its text, its kind and a one-line description (`detail`), which may be empty. A
    "digest" is the SHA-256 of a file."""

    text: str
    kind: Literal["word", "name", "target", "file", "digest"]
    detail: str = ""


def complete(document: Document, offset: int) -> tuple[Span, list[Offer]]:
    """Return the span that a completion replaces, and the completions at `offset` (characters) in a
    program, valid or not.

    Completions are words of the grammar, visible names, targets, files and the digest of a named
    file. Files are offered inside quotes only. In a comment there are none."""
    before = document.text[:offset]
    tokens = lex(Source(document.name, before))
    end = tokens.span(len(tokens.kinds) - 1).end if tokens.kinds else 0
    if "#" in re.split(r"[\r\n]", before[end:])[-1]:  # in a comment
        return Span(offset, offset), []
    starts = statement_starts(tokens)
    # Inside an unclosed quotation mark, a digest or a path is completed.
    if tokens.kinds[-1:] == ["UNCLOSED"]:
        opening = len(tokens.kinds) - 1
        span = Span(tokens.span(opening).start + 1, offset)
        begin = starts[-1] if starts else 0
        statement, before = tokens.kinds[begin], tokens.kinds[opening - 1] if opening else ""
        if before == "sha256":
            named = [
                tokens.text(k)[1:-1] for k in range(begin, opening) if tokens.kinds[k] == "TEXT"
            ]
            try:
                path = document.folder / named[0]
                if path.stat().st_size <= _MOST_HASHED_BYTES:
                    digest = sha256(path.read_bytes()).hexdigest()
                    return span, [Offer(digest, "digest", f"of {named[0]}")]
            except (OSError, ValueError, IndexError):
                pass
            return span, []
        ending = _ENDINGS.get(statement)
        if ending is None:
            return span, []
        return span, list(_files(document, document.text[span.start : offset], ending))
    # Elsewhere, the part of a word before the cursor is replaced.
    match = _WORD.search(before)
    typed = match.group() if match else ""
    span = Span(offset - len(typed), offset)
    tokens = lex(Source(document.name, before[: span.start]))
    return span, list(_Place(document, tokens, statement_starts(tokens)).offers())


class _Place(Record):
    """The part of a text before the cursor: its tokens, and the indices (`starts`) of tokens that
    start statements. `document` is the whole text, whose declarations are offered."""

    document: Document
    tokens: Tokens
    starts: list[int]

    def offers(self) -> Iterator[Offer]:
        """Yield all words and names that may stand at the cursor.

        The grammar decides which tokens are possible after the statement's tokens before the
        cursor. Without a statement before the cursor, only `nsl 1` to `nsl 4` are offered. If the
        tokens have an error, a name or the end of the statement counts as possible."""
        kinds = self.tokens.kinds
        if not self.starts:
            yield from (Offer(form, "word", "language and version") for form in FORMS["nsl"])
            return
        begin = self.starts[-1]
        statement = kinds[begin]
        # The tokens of the statement before the cursor; `stuck` is where they are invalid.
        _, stuck = read(self.tokens, begin, len(kinds))
        if stuck is not None and stuck.token < len(kinds):
            expected = frozenset({"NAME", END})  # an earlier error: every token may follow
        else:
            expected = Stuck(len(kinds), tuple(self.tokens.lark_tokens[begin:])).expected
        if "NAME" in expected:
            kinds, declared = self.tokens.kinds[begin:], self.document.declared
            last, first = kinds[-1], len(kinds) == 1
            if last == "exposure":
                buckets = (rule.name.text for rule in declared.rules if isinstance(rule, Bucket))
                yield from (Offer(name, "name", "a bucket") for name in buckets)
            elif statement == "code" and last == "of":
                yield from (Offer(name, "name", "a codebook") for name in declared.books)
            elif first and statement == "pixels":
                yield from (Offer(name, "name", "a field") for name in declared.codes)
            elif statement == "read" or (first and statement == "next"):
                yield from (Offer(name, "name", "a state") for name in declared.states)
            elif not first and last not in ("key", "kept"):
                yield from self._known(statement, kinds)
        if "TARGET_NAME" in expected:
            yield from (Offer(name, "target", "a chip") for name in target_names())
        words = reserved(self.tokens.version).difference(FORMS)
        yield from (Offer(word, "word") for word in sorted(words & expected) if word.isalpha())
        if statement == "bucket" and "open" in expected:
            yield Offer("open", "word")
        if END in expected:
            for word in statement_words(self.tokens.version):
                if word not in _ONCE or word not in self.document.tokens.kinds:
                    yield Offer(word, "word", FORMS[word][0])

    def _known(self, statement: str, kinds: Collection[str]) -> Iterator[Offer]:
        """Yield the names that expressions of a statement may use, with their meanings.

        `statement` is its first word, `kinds` are its tokens before the cursor: after `at`, a
        `sense` uses other names. Names that are declared but not allowed here are left out."""
        declared, constants = self.document.declared, self.document.constants
        match statement:
            case "open" | "bucket":
                scope = rule_scope(declared, constants)
            case "next" | "reset":
                scope = next_scope(declared, constants)
            case "require":
                scope = require_scope(declared, constants)
            case "sense" if "at" in kinds:
                scope = at_scope(declared, constants)
            case "sense":
                scope = require_scope(declared, constants)
            case "pixels" if "tile" not in kinds:
                scope = pixels_scope(declared, constants)
            case _:
                scope = constants_scope(declared, constants)
        descriptions = dict(declared.declared())
        if statement in _OF_PICTURES and self.tokens.version > 2:
            for name, what in descriptions.items():
                if what in ("a kernel", "an image", "a plane") or (
                    declared.keeps_planes and what == "a state"
                ):
                    yield Offer(name, "name", what)
        for name, meaning in scope.items():
            if meaning.kind != "misplaced":
                value = f" = {meaning.value}" if meaning.kind == "constant" else ""
                description = descriptions.get(name, PREDEFINED.get(name, ""))
                yield Offer(name, "name", f"{description}{value}".strip())


def _files(document: Document, typed: str, ending: str) -> Iterator[Offer]:
    """Yield the files that end in `ending`, and the folders, in the folder of the typed path.

    `typed` is the path before the cursor, relative to the document's folder. Hidden files are left
    out, and at most `_MOST_FILES` entries are looked at. A folder that cannot be read yields
    nothing."""
    inside = typed[: typed.rfind("/") + 1]
    try:
        entries = sorted(os.scandir(document.folder / inside), key=lambda entry: entry.name)
    except (OSError, ValueError):
        return
    shown = [e for e in entries if e.is_dir() or e.name.lower().endswith(ending)]
    for entry in shown[:_MOST_FILES]:
        if not entry.name.startswith(".") and '"' not in entry.name:
            yield Offer(inside + entry.name + "/" * entry.is_dir(), "file")


_TYPED = re.compile(r"[.\w-]*\Z")
_TARGET = re.compile(r"^[ \t]*\.target[ \t]+\"?([^\s\"]+)", re.MULTILINE)
_KERNEL = re.compile(r"^[ \t]*\.kernel[ \t]+(\w+)", re.MULTILINE)


class Listing(Record):
    """Assembly text in an editor, possibly unsaved or invalid.

    Messages call it `name`; paths in it are relative to `folder`."""

    name: str
    text: str
    folder: Path

    @cached_property
    def checked(self) -> CheckResult:
        """The errors of the assembly text, as `nscc asm` finds them; `compiled` is always None."""
        try:
            assemble(Source(self.name, self.text), self.folder)
        except Rejected as rejected:
            return CheckResult(rejected.diagnostics, compiled=None)
        return CheckResult(diagnostics=(), compiled=None)

    @cached_property
    def target(self) -> Target:
        """The chip that the text names; scamp5 if it names no chip or an unknown one."""
        named = _TARGET.search(self.text)
        try:
            return load_target(named[1] if named else DEFAULT_NAME, self.folder)
        except Rejected:
            return builtin_target(DEFAULT_NAME)


Text = Document | Listing
"""A text in which words are completed: a program or an assembly text."""


def complete_listing(listing: Listing, offset: int) -> tuple[Span, list[Offer]]:
    """Return the span that a completion replaces, and the completions at `offset` (characters) of
    assembly text.

    At the start of a line, completions are directives and instructions; later they are targets,
    kernels (lists of words) or registers. After `;`, `#` or `|` there are none."""
    line = listing.text[:offset].rpartition("\n")[2]
    typed = match.group() if (match := _TYPED.search(line)) else ""
    before = line[: len(line) - len(typed)]
    offers = [] if re.search(r"[;#|]", before) else [*_offers(listing, before.split())]
    return Span(offset - len(typed), offset), offers


def _offers(listing: Listing, before: list[str]) -> Iterator[Offer]:
    """Yield the completions of a line of the assembly text `listing` after the words `before`.

    The first word of a line is a directive or a mnemonic. Later words are a chip after `.target`, a
    kernel (list of words) after `.slot`, and else registers. Other directives without operands of
    these kinds have no completions."""
    if not before:
        yield from (Offer(name, "word", "a directive") for name in DIRECTIVES)
        known = mnemonics(listing.target.words)
        yield from (Offer(name, "word", mnemonic.usage) for name, mnemonic in known.items())
    elif before[0] == ".target":
        yield from (Offer(name, "target", "a chip") for name in target_names())
    elif before[0] == ".slot":
        yield from (Offer(name, "name", "a kernel") for name in _KERNEL.findall(listing.text))
    elif not before[0].startswith(".") or before[0] in (".load", ".plane", ".readout"):
        target = listing.target
        yield from (Offer(name, "name", "a digital register") for name in target.digital_registers)
        yield from (Offer(name, "name", "an analog register") for name in target.analog_registers)
        yield from (Offer(name, "name") for name in ("FLAG", "PIX"))
