"""Sweeps that drop one operation, or two nearby, and repair what read them.

From the last one to the first: what an early operation is read for may fall away with later ones.
"""

from __future__ import annotations

from nscc.logic.improve.code import GateOp
from nscc.logic.improve.rewrite import rewrite
from nscc.logic.improve.tracked_run import TrackedRun


def shrink(run: TrackedRun, span: int) -> None:
    """Tries to do without each operation, then without any two at most `span` apart."""
    for k in reversed(range(len(run.items))):
        if k < len(run.items):
            _drop(run, k)
    k = len(run.items) - 2
    while k >= 0:
        for j in range(k + 1, min(k + 1 + span, len(run.items))):
            if _drop(run, k, j):
                # What was beyond reach may be within it now.
                k = min(k + span, len(run.items) - 1)
                break
        k -= 1


def _drop(run: TrackedRun, *dropped: int) -> bool:
    """Does without items, the first of them first, if they are operations and words are gained."""
    if not all(isinstance(run.items[k], GateOp) for k in dropped):
        return False
    rewriting = rewrite(run, dropped[0], (), dropped, least=1, deepen=True)
    if rewriting is not None:
        run.splice(rewriting.start, rewriting.end, rewriting.items)
    return rewriting is not None
