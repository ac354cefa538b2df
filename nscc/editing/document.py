"""A text as an editor has it, and what can be told of it: all of it lazily, each once."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from nscc.chips.target import Target
from nscc.compiler import CHECK, compile_source
from nscc.diagnostics.diagnostic import Diagnostic, Rejected
from nscc.pipeline import Compiled
from nscc.program.analyse import target_of
from nscc.program.books import Digits, make_books
from nscc.program.constants import resolve_constants
from nscc.program.expressions import Meaning
from nscc.program.fields import make_fields
from nscc.program.looking import Looking, make_looking
from nscc.program.names import Declarations, gather
from nscc.program.problems import Problems
from nscc.program.program import Field
from nscc.program.scopes import constants_scope
from nscc.source import Source
from nscc.syntax.lexer import Tokens, lex
from nscc.syntax.parse import parse
from nscc.syntax.reading import source_of
from nscc.syntax.tree import File


@dataclass(frozen=True)
class CheckResult:
    """What `nscc check` says of a text. `compiled` is None where it is rejected."""

    diagnostics: tuple[Diagnostic, ...]
    compiled: Compiled | None


@dataclass(frozen=True)
class Document:
    """A program's text, which need not be saved or right.

    `name` is what messages call it; paths in it are relative to `folder`.
    """

    name: str
    text: str
    folder: Path

    @cached_property
    def source(self) -> Source:
        """The text with its name."""
        return Source(self.name, self.text)

    @cached_property
    def checked(self) -> CheckResult:
        """What `nscc check` says: the one part of a document that takes long."""
        try:
            # As bytes in a file: a text too large, or with what no file may hold, is told so.
            source = source_of(Path(self.name), self.text.encode(errors="surrogatepass"))
            compiled = compile_source(source, self.folder, CHECK)
        except Rejected as rejected:
            return CheckResult(rejected.diagnostics, None)
        return CheckResult(compiled.diagnostics, compiled)

    @cached_property
    def tokens(self) -> Tokens:
        """The tokens of the text."""
        return lex(self.source)

    @cached_property
    def parsed(self) -> tuple[File, tuple[Diagnostic, ...]]:
        """The tree of the statements that could be read, and the errors of the others."""
        return parse(self.source)

    @cached_property
    def declared(self) -> Declarations:
        """What those statements declare."""
        return gather(self.parsed[0], self._unheard)

    @cached_property
    def target(self) -> Target | None:
        """The chip; None where the text names one that cannot be had."""
        return target_of(self.declared, self.folder, self._unheard)

    @cached_property
    def constants(self) -> Mapping[str, Meaning]:
        """The meaning of N, rows, cols and every let."""
        return resolve_constants(self.declared, self.target, self._unheard)

    @cached_property
    def books(self) -> Mapping[str, Digits | None]:
        """The digits (K, N) of every codebook, None where they cannot be told."""
        return make_books(self.declared.books, self.constants["N"], self.folder, self._unheard)

    @cached_property
    def fields(self) -> Mapping[str, Field | None]:
        """Every field of the code, None where its range cannot be told."""
        scope = constants_scope(self.declared, self.constants)
        return make_fields(self.declared, scope, self.books, self._unheard)

    @cached_property
    def looking(self) -> Looking | None:
        """What pixels sense and remember; None where they do not, or it cannot be told."""
        return make_looking(self.declared, self.constants, self.target, self._unheard)

    @property
    def _unheard(self) -> Problems:
        """A collector that nobody reads: what is wrong is said by `checked`."""
        return Problems(self.source)
