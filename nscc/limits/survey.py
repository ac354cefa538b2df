"""The survey of a chip's limits: every family, compiled at the sizes that the search chooses.

First come powers of two and the last sizes before another bit is needed, then bisection between
fitting and failing sizes. The search counts compilations instead of time, so that it ends at the
same sizes on every machine. A survey is shown as a text table or as JSON values."""

from __future__ import annotations

from collections.abc import Callable, Generator, Mapping
from dataclasses import dataclass, field, replace
from itertools import groupby
from pathlib import Path
from typing import Any

from nscc.chips.target import Target
from nscc.columns import columns
from nscc.diagnostics.diagnostic import Rejected, Severity
from nscc.limits.families import Family, families
from nscc.lower.resources import time_text
from nscc.mappings import JsonObject
from nscc.options import Options
from nscc.pipeline import run_passes
from nscc.program.limits import MOST_SLOTS, Count, bits_needed, impossible_from, largest_with
from nscc.record import Record
from nscc.source import Source
from nscc.words.legality import refuse_planes

BUDGET = 40
"""Most compilations for one family and slot length."""


class Limit(Record):
    """The limit of a family of programs on a target, for slots of length `slot`.

    `trials` are ascending. `built` is the largest trial that fits; None if none does. Sizes from
    `impossible` on are proved to be impossible, for `impossible_reason`; None if nothing is proved.
    `unknown_reason` says why sizes in between are unknown; "" if there are none."""

    family: Family
    slot: str
    trials: tuple[SizeTrial, ...]
    built: SizeTrial | None
    impossible: int | None
    impossible_reason: str
    unknown_reason: str

    @property
    def unknown_from(self) -> int:
        """The smallest size above the largest size that was built."""
        return self.built.size + 1 if self.built else self.family.least

    @property
    def gaps(self) -> tuple[SizeTrial, ...]:
        """The trials below the largest built size that did not fit."""
        built = self.built.size if self.built else 0
        return tuple(trial for trial in self.trials if trial.size < built and not trial.fits)


def survey(
    target: Target, options: Options, slots: tuple[str, ...]
) -> Generator[SizeTrial, None, list[Limit]]:
    """Yield each trial as it ends; return the limit of every slot length and family.

    `slots` are slot lengths as written in a program, such as "125us". Raises Rejected (NS0510) for
    a chip without logic, on which every shutter fits."""
    refuse_planes(
        target,
        "--limits does not apply to this chip",
        f"any shutter fits slots of {time_text(target.plane_load_us)}: only the loading "
        "time limits it",
    )
    limits = []
    for slot in slots:
        for family in families():
            limits.append((yield from limit_of(family, target, options, slot)))
    return limits


def limit_of(
    family: Family, target: Target, options: Options, slot: str
) -> Generator[SizeTrial, None, Limit]:
    """Find the limit of one family for slots of length `slot`, with all legal codes.

    Yield each trial as it ends; return the limit, with the largest size that fits and the smallest
    that is proved to be impossible. `options` are those of the compilations; their target and codes
    are replaced. `slot` is written as in a program, such as "125us"."""
    options = replace(options, target=target, codes="open")
    capacity = impossible_from(family.shutters, target)
    most = family.ceiling if capacity is None else min(family.ceiling, capacity - 1)
    sizes = candidates(family.shutters, family.least, most)
    trials = yield from explore(sizes, lambda size: _attempt(family, size, slot, options), BUDGET)
    certain = [size for size, trial in trials.items() if trial.proved]
    following = max(set(trials) - set(certain), default=0) + 1
    if family.nested and certain and following not in trials:
        # It is often the smallest size that is proved to be impossible.
        trials[following] = _attempt(family, following, slot, options)
        yield trials[following]
    ordered_trials = tuple(trials[size] for size in sorted(trials))
    built = next((trial for trial in reversed(ordered_trials) if trial.fits), None)
    # Only if a program includes all smaller ones, a proof holds for all larger sizes.
    proved = [t for t in ordered_trials if t.proved] if family.nested else []
    impossible, reason = capacity, ""
    if capacity is not None:
        shutters = family.shutters(capacity)
        reason = (
            f"{family.counted_as}: {shutters} shutters need {bits_needed(shutters)} digital "
            f"registers whatever the encoding, {target.name} has {len(target.digital_registers)}"
        )
    if proved:
        impossible, reason = proved[0].size, proved[0].reason
        if proved[0].code == "NS0412":
            reason += "; at some boundary one of the digital registers is 0 in nearly all shutters"
    limit = Limit(
        family,
        slot,
        trials=ordered_trials,
        built=built,
        impossible=impossible,
        impossible_reason=reason,
        unknown_reason="",
    )
    return replace(limit, unknown_reason=_unknown(limit))


def _attempt(family: Family, size: int, slot: str, options: Options) -> SizeTrial:
    """Compile the family's program of one size; return its costs, or the error that prevents it.

    `slot` is the text of the slot length. If there are several errors, one that no compiler can
    avoid (`proved` in its data) is returned before others. Warnings do not count."""
    try:
        source = Source("limits.nsl", family.text(size, slot))
        compiled = run_passes(source, Path(), options)
    except Rejected as rejected:
        # Of several errors, a proved one counts: then no search can make the program fit.
        errors = [d for d in rejected.diagnostics if d.severity is Severity.ERROR]
        worst = next((d for d in errors if d.data.get("proved")), errors[0])
        proved = worst.data.get("proved") is True
        return SizeTrial(
            size, fits=False, figures={}, code=worst.code, reason=worst.message, proved=proved
        )
    lowered, proof = compiled.lowered, compiled.proof
    assert lowered is not None
    assert proof is not None
    assert proof.holds
    schedule, slots = lowered.schedule, len(lowered.program.frame.slot_us)
    figures = {
        "lowering": lowered.plan.lowering,
        "encoding": lowered.solution.encoding,
        "registers": len(schedule.allocation.holders),
        "words_total": schedule.words_total,
        "words_a_slot": round(schedule.words_total / slots, 6),
        "largest_slot_words": max(lowered.words_per_boundary),
        "words_stored": schedule.words_stored,
        "shortest_slot_us": round(lowered.shortest_slot_us, 6),
    }
    return SizeTrial(size, fits=True, figures=figures)


def _unknown(limit: Limit) -> str:
    """Return why the sizes between the largest built and the smallest impossible one are unknown,
    as text for people.

    Return "" if there are no such sizes. The reasons are the nearest trial that failed and the
    largest size that is tried."""
    family, first = limit.family, limit.unknown_from
    # No frame has more slots, so larger sizes of this family are no programs.
    if first > MOST_SLOTS or (limit.impossible is not None and first >= limit.impossible):
        return ""
    reasons = []
    nearest = next((trial for trial in limit.trials if trial.size >= first), None)
    if nearest is not None and (limit.impossible is None or nearest.size < limit.impossible):
        proves = (
            "certain, but only for these rows"
            if nearest.proved
            else "but a longer search may succeed"
        )
        reasons.append(f"{nearest.size} was tried: {nearest.reason} [{nearest.code}], {proves}")
    if limit.impossible is None or family.ceiling < limit.impossible - 1:
        reasons.append(f"above {family.ceiling}: {family.ceiling_reason}")
    return "; ".join(reasons)


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
    """Return the survey as text: a table for each slot length, followed by the reasons.

    `level` is the optimisation level of all trials."""
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
    """Return the row of a limit in the table, in the order of `_HEAD`. Without a size that fits,
    the costs are empty texts."""
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
    """Return the lines that explain a row: the sizes that were built, are impossible, and are
    unknown."""
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
    """Return the largest size of `limit` that fits, and the smaller sizes that did not fit with
    their errors, as text; "no tried size fits" if there is none."""
    if limit.built is None:
        return "no tried size fits"
    count = sum(trial.size <= limit.built.size for trial in limit.trials)
    # Gaps are smaller sizes that did not fit.
    if not limit.gaps:
        return f"{limit.built.size}; so did all {count} sizes tried up to it"
    gaps = "; ".join(f"{t.size} did not: {t.reason} [{t.code}]" for t in limit.gaps)
    return f"{limit.built.size}; of {count} sizes tried up to it {gaps}"


def limits_json(target: Target, level: int, limits: list[Limit]) -> JsonObject:
    """Return the survey as JSON values: the target's registers and store, and for each limit sizes,
    reasons and all trials; `level` is that of `-O`."""
    return {
        "target": target.name,
        "level": level,
        "digital_registers": len(target.digital_registers),
        "store_words": target.store_words,
        "limits": [_limit_values(limit) for limit in limits],
    }


def _limit_values(limit: Limit) -> JsonObject:
    """Return a limit as JSON values, with the sizes that were tried; values that are not known are
    None."""
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


def _trial_values(trial: SizeTrial) -> JsonObject:
    """Return a compiled size as JSON values: its figures if it fits, else the reason why not."""
    why = {"code": trial.code, "reason": trial.reason, "proved": trial.proved}
    return {"size": trial.size, "fits": trial.fits, **(trial.figures if trial.fits else why)}


GIVE_UP_AFTER = 2
"""Number of consecutive failing candidates after which larger candidates are skipped."""


_ALIKE = 1.02
"""A power of two is skipped if a larger candidate is within this factor."""


@dataclass(frozen=True)
class SizeTrial:
    """The result of compiling a program of one size.

    If it `fits`, its words were proved, and `figures` are its costs. Otherwise `code` and `reason`
    are those of the error, and `proved` means that no compiler can make the program fit."""

    size: int
    fits: bool
    figures: Mapping[str, Any] = field(default_factory=dict)
    code: str = ""
    reason: str = ""
    proved: bool = False


def candidates(count: Count, least: int, most: int) -> list[int]:
    """Return the sizes that a search compiles first, ascending and distinct, all within
    `least`..`most`.

    These are `least` and `most`, each last size before the codes need another bit, and powers of
    two that are not just below one of them. `count(size)` is the number of shutters, which must not
    decrease with the size."""
    steps = {least, most}
    bits = 0
    while (size := largest_with(count, 1 << bits, least, most)) < most:
        steps.add(size)
        bits += 1
    powers = [1 << k for k in range(most.bit_length())]
    # A power of two just below another size would tell little more.
    telling = [p for p in powers if not any(p < step < p * _ALIKE for step in steps)]
    return sorted(size for size in {*steps, *telling} if least <= size <= most)


def explore(
    sizes: list[int], attempt: Callable[[int], SizeTrial], budget: int
) -> Generator[SizeTrial, None, dict[int, SizeTrial]]:
    """Compile the ascending `sizes` with `attempt`, then search between the largest that fits and
    the next that does not.

    Yields at most `budget` trials as they end, and returns all trials by size. The search first
    tries the size after the largest that fits, because limits often lie where another bit is
    needed, then the middles. It skips larger sizes after `GIVE_UP_AFTER` failures in a row. If none
    of the `sizes` fits, nothing in between is tried."""
    trials: dict[int, SizeTrial] = {}

    def make(size: int) -> Generator[SizeTrial, None, bool]:
        """Compile a size, yield its result, keep it in `trials`, and return whether it fits."""
        trials[size] = attempt(size)
        yield trials[size]
        return trials[size].fits

    failures = 0
    for size in sizes:
        if len(trials) == budget or failures == GIVE_UP_AFTER:
            break
        failures = 0 if (yield from make(size)) else failures + 1
    largest_fit = max((t.size for t in trials.values() if t.fits), default=None)
    if largest_fit is None:
        return trials
    # If no larger size failed, there is nothing in between to try.
    smallest_misfit = min((size for size in trials if size > largest_fit), default=largest_fit + 1)
    probe = largest_fit + 1
    while smallest_misfit - largest_fit > 1 and len(trials) < budget:
        if (yield from make(probe)):
            largest_fit = probe
        else:
            smallest_misfit = probe
        probe = (largest_fit + smallest_misfit) // 2
    return trials
