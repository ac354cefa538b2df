"""A survey of limits as a text table and as JSON values."""

from __future__ import annotations

from itertools import groupby
from typing import Any

from nscc.chips.target import Target
from nscc.columns import columns
from nscc.limits.search import SizeTrial
from nscc.limits.survey import Limit
from nscc.lower.resources import time_text

_HEAD = (
    "class",
    "built up to",
    "impossible from",
    "words a slot",
    "largest slot",
    "stored",
    "shortest slot",
)


def limits_text(target: Target, level: int, limits: list[Limit]) -> str:
    """Return a table of sizes for each slot length, followed by the reasons."""
    blocks = [
        f"{target.name} at -O{level}, every legal code compiled; built: compiled and proved; "
        f"the store has {target.store_words} words"
    ]
    for slot, group in groupby(limits, key=lambda limit: limit.slot):
        rows = list(group)
        table = columns([_HEAD, *map(_row, rows)], indent="  ")
        blocks.append(f"slots of {slot}\n{table}")
        blocks.append("\n".join(line for limit in rows for line in _reasons(limit)))
    return "\n\n".join(blocks)


def _row(limit: Limit) -> tuple[str, ...]:
    unit, built = limit.family.unit, limit.built
    impossible = "-" if limit.impossible is None else f"{limit.impossible} {unit}"
    if built is None:
        return (limit.family.name, "none", impossible, "", "", "", "")
    figures = built.figures
    return (
        limit.family.name,
        f"{built.size} {unit}",
        impossible,
        f"{figures['words_a_slot']:.3g}",
        f"{figures['largest_slot_words']} words",
        f"{figures['words_stored']} words",
        time_text(figures["shortest_slot_us"]) if figures["shortest_slot_us"] else "any",
    )


def _reasons(limit: Limit) -> list[str]:
    family = limit.family
    lines = [f"  {family.name}: {family.description}", f"    built       {_trials_text(limit)}"]
    if limit.impossible is not None:
        lines.append(f"    impossible  from {limit.impossible}: {limit.impossible_reason}")
    if limit.unknown_reason:
        first, end = limit.unknown_from, limit.impossible
        sizes = f"from {first} on" if end is None else f"{first}..{end - 1}"
        lines.append(f"    unknown     {sizes}: {limit.unknown_reason}")
    elif limit.impossible is None:
        lines.append(f"    no more     {family.ceiling_reason}")
    return lines


def _trials_text(limit: Limit) -> str:
    """Return the largest size that fits, and the smaller sizes that did not fit, as text."""
    if limit.built is None:
        return "no tried size fits"
    count = sum(trial.size <= limit.built.size for trial in limit.trials)
    if not limit.gaps:
        return f"{limit.built.size}; so did all {count} sizes tried up to it"
    gaps = "; ".join(f"{t.size} did not: {t.reason} [{t.code}]" for t in limit.gaps)
    return f"{limit.built.size}; of {count} sizes tried up to it {gaps}"


def limits_json(target: Target, level: int, limits: list[Limit]) -> dict[str, Any]:
    """Return the survey as JSON values: sizes, reasons and all trials."""
    return {
        "target": target.name,
        "level": level,
        "digital_registers": len(target.digital_registers),
        "store_words": target.store_words,
        "limits": [_limit_values(limit) for limit in limits],
    }


def _limit_values(limit: Limit) -> dict[str, Any]:
    unknown = None
    if limit.unknown_reason:
        last = None if limit.impossible is None else limit.impossible - 1
        unknown = {"from": limit.unknown_from, "to": last, "reason": limit.unknown_reason}
    return {
        "class": limit.family.name,
        "shutters": limit.family.description,
        "slot": limit.slot,
        "unit": limit.family.unit,
        "built_up_to": limit.built.size if limit.built else None,
        "impossible_from": limit.impossible,
        "impossible_reason": limit.impossible_reason or None,
        "unknown": unknown,
        "tried": [_trial_values(trial) for trial in limit.trials],
    }


def _trial_values(trial: SizeTrial) -> dict[str, Any]:
    why = {"code": trial.code, "reason": trial.reason, "proved": trial.proved}
    return {"size": trial.size, "fits": trial.fits, **(trial.figures if trial.fits else why)}
