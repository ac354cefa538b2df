"""What nscc tells its user: one type for every error, warning and note."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from typing import Any

from nscc.source import Source, Span


class Severity(StrEnum):
    """How much a diagnostic weighs: an error rejects, a warning and a note do not."""

    ERROR = "error"
    WARNING = "warning"
    NOTE = "note"


@dataclass(frozen=True, slots=True)
class Label:
    """A place in the source with a few words about it."""

    span: Span
    text: str = ""


@dataclass(frozen=True, slots=True)
class Fix:
    """A change that would resolve the diagnostic: replace `span` by `replacement`.

    Not `sure`: only its author knows whether it is what was meant.
    """

    title: str
    span: Span
    replacement: str
    sure: bool = True


@dataclass(frozen=True)
class Diagnostic:
    """One message.

    `code` is NSxxxx and has a page of that name in `nscc/diagnostics/pages` (`nscc explain`).
    `message` is one line. `label` is the place the user can change; `related` are further
    places (where a limit comes from). `notes` are printed after `=`, `helps` after `help:`;
    `ways_out` describe nearby programs that were compiled and fit, and are printed as a list.
    `data` is for programs (JSON values only); a resource error's holds `resource`, `required`,
    `available` and `proved`. `source` is None for messages about no text.
    """

    code: str
    message: str
    severity: Severity = Severity.ERROR
    source: Source | None = None
    label: Label | None = None
    related: tuple[Label, ...] = ()
    notes: tuple[str, ...] = ()
    helps: tuple[str, ...] = ()
    ways_out: tuple[str, ...] = ()
    fixes: tuple[Fix, ...] = ()
    data: Mapping[str, Any] = field(default_factory=dict)
