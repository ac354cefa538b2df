"""Assembly text in an editor: the errors of `nscc asm`, and completions."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from nscc.chips.load import DEFAULT_NAME, builtin_target, load_target, target_names
from nscc.chips.target import Target
from nscc.diagnostics.diagnostic import Rejected
from nscc.editing.complete import Offer
from nscc.editing.document import CheckResult, Document
from nscc.macros import mnemonics
from nscc.source import Source, Span
from nscc.words.assembly import assemble
from nscc.words.directives import DIRECTIVES

_TYPED = re.compile(r"[.\w-]*\Z")
_TARGET = re.compile(r"^[ \t]*\.target[ \t]+\"?([^\s\"]+)", re.MULTILINE)
_KERNEL = re.compile(r"^[ \t]*\.kernel[ \t]+(\w+)", re.MULTILINE)


@dataclass(frozen=True)
class Listing:
    """Assembly text, possibly unsaved or invalid; fields as in `Document`."""

    name: str
    text: str
    folder: Path

    @cached_property
    def checked(self) -> CheckResult:
        """The result of `nscc asm`."""
        try:
            assemble(Source(self.name, self.text), self.folder)
        except Rejected as rejected:
            return CheckResult(rejected.diagnostics, None)
        return CheckResult((), None)

    @cached_property
    def target(self) -> Target:
        """The chip that the text names; scamp5 if it names no chip or an unknown one."""
        named = _TARGET.search(self.text)
        try:
            return load_target(named[1] if named else DEFAULT_NAME, self.folder)
        except Rejected:
            return builtin_target(DEFAULT_NAME)


Text = Document | Listing


def complete_listing(listing: Listing, offset: int) -> tuple[Span, list[Offer]]:
    """Return the span that a completion replaces, and the completions at `offset`.

    At the start of a line, completions are directives and instructions; later they are targets,
    kernels or registers."""
    line = listing.text[:offset].rpartition("\n")[2]
    typed = match.group() if (match := _TYPED.search(line)) else ""
    before = line[: len(line) - len(typed)]
    offers = [] if re.search(r"[;#|]", before) else [*_offers(listing, before.split())]
    return Span(offset - len(typed), offset), offers


def _offers(listing: Listing, before: list[str]) -> Iterator[Offer]:
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
