"""A program text in an editor, with analyses that are computed when first needed: its outline, and
the fixes of its messages."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from nscc.chips.target import Target
from nscc.compiler import CHECK, compile_source
from nscc.diagnostics.diagnostic import Diagnostic, Fix, Rejected
from nscc.diagnostics.message import with_safe_fixes
from nscc.pipeline import Compiled
from nscc.program.analyse import target_of
from nscc.program.constants import constants_scope, resolve_constants
from nscc.program.expressions import Meaning
from nscc.program.fields import Digits, make_books, make_fields
from nscc.program.looking import Looking, make_looking
from nscc.program.names import Declarations, gather
from nscc.program.problems import Problems
from nscc.program.program import Field
from nscc.record import Record
from nscc.source import Source, Span
from nscc.syntax import tree
from nscc.syntax.lexer import Tokens, lex
from nscc.syntax.parse import parse, source_of
from nscc.syntax.tree import File


class CheckResult(Record):
    """The result of `nscc check`.

    `compiled` is None if the program has errors, and for assembly text."""

    diagnostics: tuple[Diagnostic, ...]
    compiled: Compiled | None


@dataclass(frozen=True)
class Document:
    """A program text in an editor, possibly unsaved or invalid, with analyses that are computed
    once when first used.

    Messages call it `name`; paths in it are relative to `folder`."""

    name: str
    text: str
    folder: Path

    @cached_property
    def source(self) -> Source:
        """The text with its name, as the compiler reads it."""
        return Source(self.name, self.text)

    @cached_property
    def checked(self) -> CheckResult:
        """The result of `nscc check`, the slowest of the analyses."""
        try:
            # Checked as the bytes of a file, which reports too large texts and invalid characters.
            source = source_of(Path(self.name), self.text.encode(errors="surrogatepass"))
            compiled = compile_source(source, self.folder, CHECK)
        except Rejected as rejected:
            return CheckResult(rejected.diagnostics, compiled=None)
        return CheckResult(compiled.diagnostics, compiled)

    @cached_property
    def tokens(self) -> Tokens:
        """The tokens of the text, which every analysis of an incomplete statement uses."""
        return lex(self.source)

    @cached_property
    def parsed(self) -> tuple[File, tuple[Diagnostic, ...]]:
        """The syntax tree of the valid statements, and the errors of the invalid ones."""
        return parse(self.source)

    @cached_property
    def declared(self) -> Declarations:
        """The declarations of the valid statements, each name once; the errors are in `checked`."""
        return gather(self.parsed[0], self._unheard)

    @cached_property
    def target(self) -> Target | None:
        """The chip that the program names; None if it cannot be loaded."""
        return target_of(self.declared, self.folder, self._unheard)

    @cached_property
    def constants(self) -> Mapping[str, Meaning]:
        """The meaning of N, rows, cols and every `let`, by name."""
        return resolve_constants(self.declared, self.target, self._unheard)

    @cached_property
    def books(self) -> Mapping[str, Digits | None]:
        """The digits of every codebook by name, bool (rows, N), True for open; None for an invalid
        one."""
        return make_books(self.declared.books, self.constants["N"], self.folder, self._unheard)

    @cached_property
    def fields(self) -> Mapping[str, Field | None]:
        """Every field of the code by name; None for an invalid one."""
        scope = constants_scope(self.declared, self.constants)
        return make_fields(self.declared, scope, self.books, self._unheard)

    @cached_property
    def looking(self) -> Looking | None:
        """The checked senses and states; None if there are none or if they are invalid."""
        return make_looking(self.declared, self.constants, self.target, self._unheard)

    @property
    def _unheard(self) -> Problems:
        """A new collector of errors that nobody reads, because `checked` reports them."""
        return Problems(self.source)


def fixes_at(document: Document, span: Span) -> Iterator[tuple[Diagnostic, Fix]]:
    """Yield the fixes at `span`, safe or not, each with its diagnostic, in the order of
    diagnostics.

    A fix is at `span` if the text that it changes, or the place that its diagnostic marks, overlaps
    or touches it."""
    for diagnostic in document.checked.diagnostics:
        if diagnostic.source is None or diagnostic.source.text != document.text:
            continue
        for fix in diagnostic.fixes:
            marks = [fix.span] if diagnostic.label is None else [fix.span, diagnostic.label.span]
            if any(marked.start <= span.end and span.start <= marked.end for marked in marks):
                yield diagnostic, fix


def text_with_safe_fixes(document: Document) -> str | None:
    """Return the text after all safe fixes were applied once, as `nscc check --fix` does; None if
    there are no safe fixes. Of overlapping fixes, the last in the text is applied."""
    better, count = with_safe_fixes(document.source, document.checked.diagnostics)
    return better.text if count else None


_IN_OUTLINE = (
    tree.EqualSlots, tree.ListedSlots, tree.Let, tree.CodeRange, tree.CodeBits, tree.CodeRow,
    tree.BookInline, tree.BookFromFile, tree.Open, tree.Bucket, tree.Sense, tree.StateRange,
    tree.StateBit,
)  # fmt: skip

_LONGEST = 60
"""Most characters of an outline entry's detail."""


class OutlineEntry(Record):
    """A statement in the outline.

    `kind` is its first word, which is also its `name` if it declares no name. `detail` is a short
    form of the rest of the statement. `span` is the place of the statement, and `at` that of the
    name."""

    name: str
    detail: str
    kind: str
    span: Span
    at: Span


def outline(document: Document) -> list[OutlineEntry]:
    """Return the named statements of `document`, its frame and its rules, in the order of the
    text."""
    entries = []
    for statement in document.parsed[0].statements:
        if not isinstance(statement, _IN_OUTLINE):
            continue
        span, name = statement.span, getattr(statement, "name", None)
        kind = document.text[span.start : span.end].split(None, 1)[0]
        name_span = Span(span.start, span.start + len(kind)) if name is None else name.span
        detail = " ".join(document.text[name_span.end : span.end].split()).lstrip(" :=")
        if len(detail) > _LONGEST:
            detail = detail[: _LONGEST - 3] + "..."
        entries.append(
            OutlineEntry(kind if name is None else name.text, detail, kind, span, name_span)
        )
    return entries
