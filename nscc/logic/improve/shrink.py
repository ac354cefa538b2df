"""Sweeps that drop one operation, or two nearby, and repair what read them.

From the last one to the first: what an early operation is read for may fall away with later ones.
"""

from __future__ import annotations

from nscc.logic.improve.code import Op
from nscc.logic.improve.rewrite import rewrite
from nscc.logic.improve.run import Run


def drop_singles(run: Run) -> int:
    """Tries to do without each operation; returns the words gained."""
    gained = 0
    k = len(run.items) - 1
    while k >= 0:
        if k < len(run.items) and isinstance(run.items[k], Op):
            done = rewrite(run, k, (), (k,), least=1, deepen=True)
            if done is not None:
                run.splice(done.start, done.end, done.items)
                gained += done.gain
        k -= 1
    return gained


def drop_pairs(run: Run, span: int) -> int:
    """Tries to do without two operations at most `span` apart; returns the words gained."""
    gained = 0
    k = len(run.items) - 2
    while k >= 0:
        for j in range(k + 1, k + 1 + span):
            if j >= len(run.items) or not isinstance(run.items[k], Op):
                break
            if not isinstance(run.items[j], Op):
                continue
            done = rewrite(run, k, (), (k, j), least=1, deepen=True)
            if done is not None:
                run.splice(done.start, done.end, done.items)
                gained += done.gain
                # What was beyond reach may be within it now.
                k = min(k + span, len(run.items) - 1)
                break
        k -= 1
    return gained
