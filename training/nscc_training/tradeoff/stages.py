"""The result of a stage of the joint tradeoff."""

from __future__ import annotations

from dataclasses import dataclass

from nscc.diagnostics.diagnostic import Diagnostic, Rejected
from nscc.requirements import line_for
from nscc.tradeoff.points import Point, Refused

PERCENT = "percent"
"""The unit of all errors: percent of the mean signal."""


def misfit(stage: str, setting: str, why: Diagnostic | Rejected | ModuleNotFoundError) -> Refused:
    """Return the refusal of a setting, or of a whole stage (setting ""), with the message's
    reason."""
    if isinstance(why, ModuleNotFoundError):
        name = why.name or "a package"
        return Refused(stage, "", setting, "NS0904", f"{name} is missing: {line_for(name)}")
    diagnostic = why.diagnostics[0] if isinstance(why, Rejected) else why
    return Refused(stage, "", setting, diagnostic.code, diagnostic.message)


@dataclass(frozen=True)
class StageResult:
    """A stage's points, the settings that could not be measured, and notes on its numbers."""

    points: tuple[Point, ...]
    misfits: tuple[Refused, ...] = ()
    notes: tuple[str, ...] = ()
