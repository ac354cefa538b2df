"""Short description of register usage: registers whose contents differ only in a number are
grouped."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

_LAST_NUMBER = re.compile(r"^(.*?)(\d+)(\D*)$", re.DOTALL)


def ledger(holders: Mapping[str, str]) -> str:
    """Format {register: content} as `R1-R4 fall at boundary 4, 16, 64, 256; R0 scratch`."""
    groups: dict[tuple[str, str], list[tuple[str, str | None]]] = {}
    for register, holder in holders.items():
        match = _LAST_NUMBER.match(holder)
        key = (match[1], match[3]) if match else (holder, "")
        groups.setdefault(key, []).append((register, match[2] if match else None))
    entries = []
    for (before, after), members in groups.items():
        registers = _shortened([register for register, _ in members])
        numbers = _shortened([number for _, number in members if number is not None])
        entries.append(f"{registers} {before}{numbers}{after}")
    return "; ".join(entries)


def _shortened(names: Sequence[str]) -> str:
    """Join registers or numbers, with runs of three and more as `R0-R3, R7`."""
    runs: list[list[str]] = []
    for name in names:
        if runs and _follows(runs[-1][-1], name):
            runs[-1].append(name)
        else:
            runs.append([name])
    return ", ".join(f"{run[0]}-{run[-1]}" if len(run) > 2 else ", ".join(run) for run in runs)


def _follows(first: str, second: str) -> bool:
    a, b = _LAST_NUMBER.match(first), _LAST_NUMBER.match(second)
    if a is None or b is None or a[3] or b[3]:
        return False
    return a[1] == b[1] and int(b[2]) == int(a[2]) + 1
