"""Words for messages about wrong input of the trainer."""

from __future__ import annotations

from collections.abc import Sequence


def listed(names: Sequence[str], most: int = 12) -> str:
    """`a, b, c and 4 more`, or `nothing`."""
    shown = ", ".join(name[:40] for name in names[:most]) or "nothing"
    return shown + (f" and {len(names) - most} more" if len(names) > most else "")
