"""Diagnostics for programs that do not fit, or whose fit only a search can decide.

Proved and unproved facts are separate. A number that no encoding can reduce is always an error. If
the search finds no gates, this proves nothing, so `nscc check` reports it as a note."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import replace

from nscc.diagnostics.diagnostic import Diagnostic, Label, Severity
from nscc.lower.exposure_plan import LOWERINGS, Lowering, LoweringOption, Misfit
from nscc.lower.lowered import Choice, Lowered
from nscc.lower.resources import chip_label, chip_note, resource
from nscc.lower.slot_faults import late_fault, overfull_fault, retention_fault
from nscc.program.limits import bits_needed, capacity_note
from nscc.program.problems import counted
from nscc.program.program import Program
from nscc.source import Span

_LAST_NUMBER = re.compile(r"^(.*?)(\d+)(\D*)$", re.DOTALL)


def ledger(holders: Mapping[str, str]) -> str:
    """Return the contents of registers as text; registers with equal contents are joined: `R1-R4
    fall at boundary 4, 16, 64, 256; R0 scratch`.

    `holders` maps registers to their contents in words. Contents are equal if they differ in their
    last number only. Without registers the text is empty."""
    groups: dict[tuple[str, str], list[tuple[str, str | None]]] = {}
    for register, holder in holders.items():
        match = _LAST_NUMBER.match(holder)
        key = (match[1], match[3]) if match else (holder, "")
        groups.setdefault(key, []).append((register, match[2] if match else None))
    entries = []
    for (before, after), members in groups.items():
        registers = _with_runs([register for register, _ in members])
        numbers = _with_runs([number for _, number in members if number is not None])
        entries.append(f"{registers} {before}{numbers}{after}")
    return "; ".join(entries)


def _with_runs(names: Sequence[str]) -> str:
    """Join registers or numbers by commas, with three or more in sequence as a range: `R0-R3, R7`.

    A name whose last number is 1 more than that of the name before it, with the same beginning,
    follows in sequence; the order is not changed. Without names the text is empty."""
    runs: list[list[str]] = []
    following = ""
    for name in names:
        if name == following:
            runs[-1].append(name)
        else:
            runs.append([name])
        match = _LAST_NUMBER.match(name)
        following = f"{match[1]}{int(match[2]) + 1}" if match and not match[3] else ""
    return ", ".join(f"{run[0]}-{run[-1]}" if len(run) > 2 else ", ".join(run) for run in runs)


def capacity_fault(program: Program) -> Diagnostic | None:
    """Return the error (NS0412) if there are more shutters than a pixel's digital registers have
    states, else None.

    The error is proved: no encoding can distinguish the shutters."""
    shutters = len(program.table.shutters)
    required = bits_needed(shutters)
    if required <= len(program.target.digital_registers):
        return None
    return _capacity(program, required, [capacity_note(shutters)])


def _capacity(program: Program, required: int, reasons: Sequence[str]) -> Diagnostic:
    """Return the error (NS0412) that a program's codes need `required` digital registers, for
    `reasons` that hold for any encoding."""
    target = program.target
    shutters = len(program.table.shutters)
    available = len(target.digital_registers)
    # The text says how the number of shutters arises in the program.
    if program.mode == "fixed":
        shutters_text = f"{shutters} different shutters in use"
    elif program.class_name == "e":
        free = f"{len(program.frame.slot_us)} slots"
        if len(program.buckets) > 1:
            free += f" in {len(program.buckets)} buckets"
        shutters_text = f"{free}, each free: {shutters} shutters"
    else:
        shutters_text = f"{shutters} different shutters"
    registers = (
        f"{available} one-bit registers a pixel "
        f"({target.digital_registers[0]}-{target.digital_registers[-1]})"
    )
    ledger = [
        f"{field.name} {max(1, (field.high - field.low).bit_length())}" for field in program.fields
    ]
    return Diagnostic(
        "NS0412",
        f"this shutter does not fit {target.name}: its codes need {required} bits per "
        f"pixel, but the chip has {available}",
        source=program.source,
        label=Label(_field_span(program), shutters_text),
        related=chip_label(program, registers),
        notes=(
            *chip_note(program, registers),
            *reasons,
            f"bits by holder: {', '.join(ledger)}{'; scratch 0' * (len(ledger) > 1)}",
        ),
        data=resource("digital registers", required, available, proved=True),
    )


def plan_fault(
    program: Program, misfits: Mapping[Lowering, Misfit], lowering: LoweringOption
) -> Diagnostic:
    """Return the error that no exposure plan exists for the requested `lowering` (a way to compute
    the exposure); this is proved.

    `misfits` has the reason for each lowering that was tried, at least one. NS0412 is returned if
    all were tried and one lacks digital registers, NS0413 if all lack analog registers, else
    NS0414."""
    reasons = _reasons(misfits)
    crowded = [m.required for m in misfits.values() if m.resource == "digital registers"]
    if crowded and misfits.keys() >= set(LOWERINGS):
        certain = "holds with any encoding: no lowering can load FLAG at some boundary"
        return _capacity(program, min(crowded), [certain, *reasons])
    short = [m for m in misfits.values() if m.resource == "analog registers"]
    # Some lowering has enough registers, so its own condition is what the program does not meet.
    if len(short) < len(misfits):
        return Diagnostic(
            "NS0414",
            "the requested lowering cannot implement this program: " + "; ".join(reasons),
            source=program.source,
            label=Label(program.buckets[0].span),
            helps=(
                "leave --lowering at auto: it chooses only lowerings that can implement the "
                "program",
            ),
            data={"lowerings": list(misfits)},
        )
    least: Misfit = min(short, key=lambda m: m.required)
    registers = f"{least.available} analog registers that keep a value"
    buckets = len(program.buckets)
    most = least.available - (least.required - buckets)
    helps = [f"keep at most {most} buckets"]
    if lowering != "auto":
        helps.append("leave --lowering at auto: lowerings need different numbers of registers")
    return Diagnostic(
        "NS0413",
        f"{buckets} buckets do not fit {program.target.name}: they need {least.required} "
        f"{least.resource}, but the chip has {least.available}",
        source=program.source,
        label=Label(program.buckets[-1].span, f"bucket {buckets}"),
        related=chip_label(program, registers),
        notes=(
            "certain: every bucket needs its own register",
            *chip_note(program, registers),
            *reasons,
        ),
        helps=tuple(helps),
        data=resource("analog registers", least.required, least.available, proved=True),
    )


def gates_fault(program: Program, misfits: Mapping[Lowering, Misfit], *, level: int) -> Diagnostic:
    """Return the error (NS0502) that the search at this optimisation `level` found no gates for any
    exposure plan. Gates may exist nevertheless.

    `misfits` has the reason of each lowering (a way to compute the exposure) that was tried, at
    least one."""
    available = len(program.target.digital_registers)
    return Diagnostic(
        "NS0502",
        f"the search at -O{level} found no gates that decode "
        f"{len(program.table.shutters)} shutters with {available} digital registers",
        source=program.source,
        label=Label(_field_span(program)),
        notes=(*_reasons(misfits), "not proved: another encoding or a longer search may find some"),
        helps=(
            *(
                ["leave --lowering at auto: another lowering may need other gates"]
                * (len(misfits) == 1)
            ),
            _fewer_codes(program),
        ),
        # The search does not tell how many registers would do, so one more is named.
        data=resource("digital registers", available + 1, available, proved=False),
    )


def _reasons(misfits: Mapping[Lowering, Misfit]) -> list[str]:
    """Return why each lowering in `misfits` does not fit, with the lowering's name in front unless
    the reason begins with it. A lowering is a way to compute the exposure."""
    return [
        misfit.reason if misfit.reason.startswith(name) else f"{name}: {misfit.reason}"
        for name, misfit in misfits.items()
    ]


def faults(choice: Choice, *, level: int) -> list[Diagnostic]:
    """Return all errors of the best lowering (a way to compute the exposure) of `choice`, compiled
    at this `level`: retention, slots that are too short, too many words at a boundary, too many
    stored words. The list is empty if it fits."""
    lowered = choice.best
    diagnostics = []
    if not lowered.retained:
        diagnostics.append(retention_fault(lowered))
    if lowered.late:
        diagnostics.append(late_fault(choice, level))
    if lowered.overfull:
        diagnostics.append(overfull_fault(choice, level))
    if not lowered.stored_ok:
        diagnostics.append(_store(lowered, level))
    return diagnostics


def has_ways_out(diagnostic: Diagnostic) -> bool:
    """Return whether similar programs (fewer codes, rows or slots, a simpler class) may avoid this
    resource error. Other diagnostics have no way out.

    Too little time or too many words at a boundary can be avoided only if gates take part in it: if
    the error is proved, the words that read the light alone take too long."""
    short_of = diagnostic.data.get("resource")
    if short_of in ("slot_us", "words_per_slot"):
        return only_search_can_tell(diagnostic)
    return short_of in ("store_words", "words in the store", "digital registers", "proof")


def only_search_can_tell(diagnostic: Diagnostic) -> bool:
    """Return whether an error depends on this compiler's search, not on the chip."""
    return diagnostic.data.get("proved") is False


def as_note(diagnostic: Diagnostic) -> Diagnostic:
    """Return the note (NS0503) that `nscc check` shows instead of the unproved error `diagnostic`.

    It has a help of its own, and no second places."""
    return replace(
        diagnostic,
        code="NS0503",
        message=f"a short search found no way to fit this: {diagnostic.message}",
        severity=Severity.NOTE,
        related=(),
        helps=(
            "`nscc build` searches longer, decides whether this fits, and looks for the largest "
            "size that does",
        ),
    )


def _store(lowered: Lowered, level: int) -> Diagnostic:
    """Return the error (NS0501) that `lowered`, compiled at this `level`, needs more words than the
    controller stores."""
    program, target = lowered.program, lowered.program.target
    stored = lowered.schedule.words_stored
    store = f"all kernels together: {target.store_words} words"
    holders = lowered.schedule.allocation.holders
    return Diagnostic(
        "NS0501",
        f"this program needs {stored} stored words at -O{level}, but {target.name} stores "
        f"{target.store_words}",
        source=program.source,
        label=Label(_field_span(program), f"{len(program.table.shutters)} different shutters"),
        related=chip_label(program, store),
        notes=(
            *chip_note(program, store),
            f"{len(lowered.schedule.kernels)} kernels, lowered as {lowered.plan.lowering}, "
            f"encoding: {lowered.solution.encoding}",
            "registers: " + ledger(holders),
            "not proved: other gates or another encoding may be shorter",
        ),
        helps=("use fewer codes, fewer slots, or shutters with fewer edges",),
        data=resource("store_words", stored, target.store_words, proved=False),
    )


def _fewer_codes(program: Program) -> str:
    """Return the help to compile only the used codes of `program`. If only these are compiled
    already, the help is to use fewer codes.

    If the program declares no codes of pixels, these must be added first."""
    if program.mode == "fixed":
        return "use fewer different codes, or shutters with fewer edges"
    if program.pixel_codes is None:
        return "add the pixel values: then nscc compiles only the used codes"
    return "`--codes fixed` compiles only the codes that the pixels use"


def _field_span(program: Program) -> Span:
    """Return where the program declares its first field, or its first bucket if it has no field."""
    return program.fields[0].span if program.fields else program.buckets[0].span


def looking_fault(program: Program, reasons: list[str], *, level: int) -> Diagnostic:
    """Return the error (NS0502) that the search at this `level` found no encoding of codes and
    states, which is not proved.

    `reasons` are sentences on why searches failed; they become notes of the error."""
    available = len(program.target.digital_registers)
    states = ", ".join(state.name for state in program.machine.states)
    return Diagnostic(
        "NS0502",
        f"the search at -O{level} found no gates for the states of this program with "
        f"{available} digital registers",
        source=program.source,
        label=Label(_field_span(program)),
        notes=(
            f"registers must hold: {counted(len(program.table.shutters), 'code')}, states "
            f"{states or 'none'}",
            *reasons,
            "not proved: another encoding or a longer search may find some",
        ),
        helps=("use fewer states, smaller ranges, or fewer codes",),
        # The search does not tell how many registers would do, so one more is named.
        data=resource("digital registers", available + 1, available, proved=False),
    )
