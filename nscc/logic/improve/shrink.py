"""Sweeps that drop one operation, or two nearby ones, and repair their readers.

A sweep goes from back to front, because the readers of an early operation may be dropped first."""

from __future__ import annotations

from nscc.logic.improve.code import GateOp
from nscc.logic.improve.rewrite import rewrite
from nscc.logic.improve.tracked_run import TrackedRun


def shrink(run: TrackedRun, span: int) -> None:
    """Try to drop each operation, then each pair at most `span` apart."""
    for k in reversed(range(len(run.items))):
        if k < len(run.items):
            _drop(run, k)
    k = len(run.items) - 2
    while k >= 0:
        for j in range(k + 1, min(k + 1 + span, len(run.items))):
            if _drop(run, k, j):
                # A later change may make this one possible.
                k = min(k + span, len(run.items) - 1)
                break
        k -= 1


def _drop(run: TrackedRun, *dropped: int) -> bool:
    """Drop operations, starting repair at the first, if that saves words; return whether it
    does."""
    if not all(isinstance(run.items[k], GateOp) for k in dropped):
        return False
    rewriting = rewrite(run, dropped[0], (), dropped, least=1, deepen=True)
    if rewriting is not None:
        run.splice(rewriting.start, rewriting.end, rewriting.items)
    return rewriting is not None
