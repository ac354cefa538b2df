"""Diagnostics for slots that are too short, too full, or longer than the retention time."""

from __future__ import annotations

from nscc.chips.target import Target
from nscc.diagnostics.diagnostic import Diagnostic, Label
from nscc.lower.lowered import Choice, Lowered
from nscc.lower.resources import at_least, chip_label, chip_note, resource, time_text
from nscc.program.problems import counted


def retention_fault(lowered: Lowered) -> Diagnostic:
    """Return the error (NS0602) that a slot or the readout exceeds the retention time, which is
    proved. It names the longest slot, and asks for a shorter readout if that is too long."""
    program = lowered.program
    longest = max(range(len(program.frame.slot_us)), key=program.frame.slot_us.__getitem__)
    slot_us = program.frame.slot_us[longest]
    keep_us, readout_us = lowered.time.keep_us, lowered.time.between_us
    label = "registers are refreshed between slots, not within a slot"
    help_text = "split the slot into several slots; the rule can open the shutter in all of them"
    if readout_us > keep_us:
        label = "registers are not refreshed during the readout"
        help_text = "read out fewer buckets, or use a chip with a shorter `readout_us`"
    return Diagnostic(
        "NS0602",
        f"digital registers lose their bits within this frame: slot {longest} lasts "
        f"{time_text(slot_us)}, and the readout {time_text(readout_us)}; "
        f"{program.target.name} keeps a bit for "
        f"{time_text(program.target.digital_retention_us)}",
        source=program.source,
        label=Label(program.frame.span, label),
        notes=(
            f"every bit must be refreshed within {time_text(keep_us)}, which includes a "
            "margin of 10 %",
        ),
        helps=(help_text,),
        data=resource("retention_us", max(slot_us, readout_us), keep_us, proved=True),
    )


def late_fault(choice: Choice, level: int) -> Diagnostic:
    """Return the error (NS0601) that words take longer than the slot at whose start they run.

    `level` is the optimisation level; the best lowering (a way to compute the exposure) must have
    late slots. The error is proved if in every lowering the analog words and one launch take too
    long. It then names the slot that lacks most for these, else the slot that lacks most for all
    its words. A launch is the start of a kernel, a list of words."""
    lowered = choice.best
    program, target = lowered.program, lowered.program.target
    slots_us = program.frame.slot_us
    # The error is certain if every possible lowering lacks time for its analog words alone.
    certain = _nothing_untried(choice) and all(
        _too_short(candidate) for candidate in choice.lowerings
    )
    if certain:
        worst = _too_short(lowered)[0]
        needed_us = _least_us(lowered, worst)
        why = f"its analog words, one launch and the loop take {time_text(needed_us)}"
    else:
        worst = max(lowered.late, key=lambda n: lowered.busy_us[n] - slots_us[n])
        needed_us = lowered.busy_us[worst]
        words = lowered.words_per_boundary[worst]
        why = f"its {words} words take {time_text(needed_us)} at -O{level}"
    return Diagnostic(
        "NS0601",
        f"slot {worst} is shorter than its instructions: it lasts "
        f"{time_text(slots_us[worst])}, and {why}",
        source=program.source,
        label=Label(program.frame.span, f"{len(lowered.late)} of {len(slots_us)} slots too short"),
        related=chip_label(program, _times(target)),
        notes=(
            *chip_note(program, _times(target)),
            "certain: every program must read the light and launch a kernel in each slot"
            if certain
            else "not proved: a longer search may find fewer words",
        ),
        helps=(
            f"slots of {at_least(lowered.shortest_slot_us)} or longer have enough time for the "
            "words found",
        ),
        data=resource("slot_us", needed_us, slots_us[worst], proved=certain),
    )


def overfull_fault(choice: Choice, level: int) -> Diagnostic:
    """Return the error (NS0603) for more words at a boundary than `--max-words-per-slot` allows.

    `level` is the optimisation level; the best lowering (a way to compute the exposure) must have
    overfull boundaries. The error names the fullest of them. It is proved if in every lowering the
    analog words of a boundary exceed the limit."""
    lowered = choice.best
    program, allowed = lowered.program, lowered.most_words
    assert allowed is not None
    words = lowered.words_per_boundary
    # Of equally full boundaries the first.
    worst = max(lowered.overfull, key=lambda n: (words[n], -n))
    certain = _nothing_untried(choice) and all(
        any(_analog_words(candidate, n) > allowed for n in candidate.overfull)
        for candidate in choice.lowerings
    )
    slots = len(program.frame.slot_us)
    over = counted(len(lowered.overfull), "boundary", "boundaries")
    place = f"slot {worst}" if worst < slots else "the end of the last slot"
    return Diagnostic(
        "NS0603",
        f"{place} executes {words[worst]} words at -O{level}, but --max-words-per-slot "
        f"allows {allowed}: {words[worst] - allowed} too many",
        source=program.source,
        label=Label(program.frame.span, f"{over} of {slots + 1} over the limit"),
        notes=(
            f"{words[worst]} words: {_where_they_go(lowered, worst)}",
            f"lowered as {lowered.plan.lowering}, encoding: {lowered.solution.encoding}",
            "certain: the words that read the light alone exceed the limit"
            if certain
            else "not proved: a longer search may find fewer words",
        ),
        helps=(f"--max-words-per-slot {words[worst]} accepts the words found",),
        data={**resource("words_per_slot", words[worst], allowed, proved=certain), "slot": worst},
    )


def _where_they_go(lowered: Lowered, boundary: int) -> str:
    """Return the words of a boundary by purpose, and the time of launches (starts of kernels), as
    text. Purposes without words are left out. A kernel is a list of words."""
    kernels, launch_us = lowered.schedule.kernels, lowered.program.target.launch_us
    launched = [kernels[kernel] for n, kernel in lowered.schedule.launches if n == boundary]
    words = [word for kernel in launched for word in kernel]
    analog = sum(word.analog for word in words)
    refresh = sum(word.operation.name.startswith("REFRESH") for word in words)
    light = _analog_words(lowered, boundary)
    shares = (
        (len(words) - analog - refresh, "to decode"),
        (light, "to read the light"),
        (analog - light, "to set up and reset"),
        (refresh, "to refresh registers"),
    )
    purposes = ", ".join(f"{count} {purpose}" for count, purpose in shares if count)
    launches = counted(len(launched), "kernel")
    return f"{purposes}; launching {launches} takes {time_text(len(launched) * launch_us)} more"


def _times(target: Target) -> str:
    """Return a text without a full stop on how long words, launches and the loop at a boundary take
    on the target, in microseconds. A launch is the start of a kernel, a list of words."""
    return (
        f"a digital word takes {target.digital_word_us:g} us, an analog word "
        f"{target.analog_word_us:g} us, a launch {target.launch_us:g} us, and the loop at a "
        f"boundary {target.wait_us:g} us"
    )


def _nothing_untried(choice: Choice) -> bool:
    """Return whether every lowering (a way to compute the exposure) was laid out or is impossible.
    False if the search found no gates for one, because that proves nothing."""
    return not any(misfit.searched for misfit in choice.misfits.values())


def _too_short(lowered: Lowered) -> list[int]:
    """Return the slots that are too short for their analog words alone, with one launch and the
    loop, the one that lacks most first; empty if none is. A launch is the start of a kernel, a list
    of words."""
    slots_us = lowered.program.frame.slot_us
    lacking = {n: _least_us(lowered, n) - slots_us[n] for n in lowered.late}
    return sorted((n for n in lacking if lacking[n] > 0), key=lambda n: (-lacking[n], n))


def _least_us(lowered: Lowered, boundary: int) -> float:
    """Return the minimum time in microseconds at a boundary: its analog words, one launch (the
    start of a kernel), and the loop (not at boundary 0). 0 without analog words, because nothing
    need run there. A kernel is a list of words."""
    target = lowered.program.target
    analog = _analog_words(lowered, boundary)
    loop_us = target.launch_us + (target.wait_us if boundary else 0.0)
    return loop_us + analog * target.analog_word_us if analog else 0.0


def _analog_words(lowered: Lowered, boundary: int) -> int:
    """Return the number of words that move a boundary's light, independent of gates."""
    steps = [s for s in lowered.plan.steps if s.boundary == boundary and s.bucket >= 0]
    return sum(len(step.words) for step in steps)
