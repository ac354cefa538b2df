"""Who holds which registers, in few words: one entry for all that differ in a number only."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

_LAST_NUMBER = re.compile(r"^(.*?)(\d+)(\D*)$", re.DOTALL)


def ledger(holders: Mapping[str, str]) -> str:
    """`R1-R4 fall at boundary 4, 16, 64, 256; R0 scratch` of {register: what it holds}."""
    groups: dict[tuple[str, str], list[tuple[str, int | None]]] = {}
    for register, what in holders.items():
        found = _LAST_NUMBER.match(what)
        key = (found[1], found[3]) if found else (what, "")
        groups.setdefault(key, []).append((register, int(found[2]) if found else None))
    entries = []
    for (before, after), members in groups.items():
        registers = _registers([register for register, _ in members])
        numbers = _numbers([number for _, number in members if number is not None])
        entries.append(f"{registers} {before}{numbers}{after}")
    return "; ".join(entries)


def _numbers(values: Sequence[int]) -> str:
    """`4, 16, 64`, and `0-5` for runs of three and more."""
    runs: list[list[int]] = []
    for value in values:
        if runs and value == runs[-1][-1] + 1:
            runs[-1].append(value)
        else:
            runs.append([value])
    return _shortened([[str(value) for value in run] for run in runs])


def _registers(names: Sequence[str]) -> str:
    """`R0-R3, R7`: registers with runs of three and more shortened."""
    runs: list[list[str]] = []
    for name in names:
        if runs and _follows(runs[-1][-1], name):
            runs[-1].append(name)
        else:
            runs.append([name])
    return _shortened(runs)


def _shortened(runs: Sequence[Sequence[str]]) -> str:
    return ", ".join(f"{run[0]}-{run[-1]}" if len(run) > 2 else ", ".join(run) for run in runs)


def _follows(one: str, other: str) -> bool:
    a, b = _LAST_NUMBER.match(one), _LAST_NUMBER.match(other)
    if a is None or b is None or a[3] or b[3]:
        return False
    return a[1] == b[1] and int(b[2]) == int(a[2]) + 1
