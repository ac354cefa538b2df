"""The build report (`--emit report`): program, cost and proof."""

from __future__ import annotations

import hashlib
import json
from collections import Counter

from nscc.logic.bound import ASSUMES, level_bound
from nscc.lower.lowered import Choice, Lowered
from nscc.mappings import JsonObject
from nscc.operations import Op, Phase, WordEffect
from nscc.program.program import Program
from nscc.prove.proof import Proof
from nscc.words.cost import refresh_count


def subject(program: Program) -> JsonObject:
    """Return class, slots, codes, fields and buckets of a program as JSON values, with the keys of
    the build report. Slot times are in microseconds; a field is a list of its lowest and highest
    value."""
    table = program.table
    return {
        "class": program.class_name,
        "class_reason": program.class_reason,
        "slots": len(program.frame.slot_us),
        "slot_time_us": list(program.frame.slot_us),
        "codes": {
            "mode": program.mode,
            "count": len(table.codes),
            "shutters": len(table.shutters),
        },
        "fields": {field.name: [field.low, field.high] for field in program.fields},
        "buckets": [bucket.name for bucket in program.buckets],
    }


def report(choice: Choice, proof: Proof) -> JsonObject:
    """Return the build report of the best lowering (way to compute the exposure) as JSON values, as
    `--emit report` writes them.

    Times are in microseconds, and `headroom_e` in electrons. Other lowerings are listed under
    `alternatives`."""
    lowered = choice.best
    program, schedule = lowered.program, lowered.schedule
    slots = len(program.frame.slot_us)
    launches = Counter(kernel for _, kernel in schedule.launches)
    misfits = [
        {"lowering": name, "fits": False, "reason": misfit.reason}
        for name, misfit in choice.misfits.items()
    ]
    return {
        **subject(program),
        "digital_registers": schedule.allocation.holders,
        "analog_registers": lowered.plan.registers,
        "lowering": lowered.plan.lowering,
        "logic": _logic(lowered),
        "kernels": [
            {"words": len(kernel), "launches": launches[i]}
            for i, kernel in enumerate(schedule.kernels)
        ],
        "words_total": schedule.words_total,
        "words_stored": schedule.words_stored,
        "words_per_slot": {
            "mean": schedule.words_total / slots,
            "max": max(lowered.words_per_boundary),
        },
        "shortest_slot_us": round(lowered.shortest_slot_us, 6),
        "launches": {
            "frame": len(schedule.launches),
            "shortest_slot": lowered.shortest_slot_launches,
            "us_each": program.target.launch_us,
        },
        "frame_us": round(lowered.frame_us, 6),
        "refreshed": list(schedule.refreshed),
        "analog_writes": _range(lowered),
        "headroom_e": lowered.headroom_e,
        "alternatives": [*map(_lowering_values, choice.lowerings[1:]), *misfits],
        "failed_generators": list(choice.failed_generators),
        "proof": {
            "codes": proof.codes,
            "slots": proof.slots,
            "frames": proof.frames,
            "holds": proof.holds,
        },
        "target": program.target.name,
        "source_sha256": hashlib.sha256(program.source.text.encode()).hexdigest(),
    }


def report_bytes(values: JsonObject) -> bytes:
    """Return the report as the bytes of a file."""
    return (json.dumps(values, indent=2) + "\n").encode()


def _range(lowered: Lowered) -> dict[str, int]:
    """Return the fewest and the most analog words that a pixel executes, as {"min": .., "max":
    ..}."""
    least, most = lowered.plan.analog_writes
    return {"min": least, "max": most}


def _lowering_values(lowered: Lowered) -> JsonObject:
    """Return the cost of one lowering (way to compute the exposure) as JSON values: words, shortest
    slot in microseconds, analog writes, headroom in electrons."""
    return {
        "lowering": lowered.plan.lowering,
        "fits": lowered.fits,
        "words_total": lowered.schedule.words_total,
        "words_stored": lowered.schedule.words_stored,
        "words_per_slot_max": max(lowered.words_per_boundary),
        "shortest_slot_us": round(lowered.shortest_slot_us, 6),
        "analog_writes": _range(lowered),
        "headroom_e": lowered.headroom_e,
    }


def _logic(lowered: Lowered) -> JsonObject:
    """Return the cost of decoding codes in a frame as JSON values: words, without those that only
    refresh registers, and operations, where the two words of a pair count as one.

    `bound` is a lower bound on the operations, None if none is known."""
    schedule, program = lowered.schedule, lowered.program
    per_kernel = [_digital(kernel) for kernel in schedule.kernels]
    slots = len(program.frame.slot_us)
    words_at = [0] * (slots + 1)
    pairs = sum(per_kernel[kernel][1] for _, kernel in schedule.launches)
    for boundary, kernel in schedule.launches:
        words_at[boundary] += per_kernel[kernel][0]
    words = sum(words_at)
    bound = None
    # The bound holds for this lowering, and for all shutters of a class.
    if lowered.plan.lowering == "accumulate" and len(program.table.codes) == program.legal_codes:
        shutters, registers = len(program.table.shutters), len(program.target.digital_registers)
        bound = level_bound(program.class_name, shutters, slots, registers)
    return {
        "ops": words - pairs,
        "words": words,
        "in_place": pairs,
        "max_slot_words": max(words_at),
        "registers": len(schedule.allocation.holders),
        "bound": bound,
        "bound_assumes": ASSUMES if bound is not None else None,
        "encoding": lowered.solution.encoding,
    }


def _digital(kernel: tuple[Op, ...]) -> tuple[int, int]:
    """Return (words, pairs) of a kernel (list of words): the number of words that decode codes, and
    of pairs among them. Refreshes count in neither."""
    rows = [word.operation for word in kernel]
    digital = [row for row in rows if row.effect in (WordEffect.DIGITAL, WordEffect.FLAG_DIGITAL)]
    pairs = sum(row.phase is Phase.READ and not row.name.startswith("REFRESH") for row in digital)
    return len(digital) - refresh_count(kernel), pairs
