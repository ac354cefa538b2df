"""What the user hears when a program does not fit, or when only a search can tell.

Proved and not proved are kept apart: a count that no encoding can beat is an error wherever it is
seen; gates that this compiler did not find prove nothing, so `nscc check` only notes them.
"""

from __future__ import annotations

from math import ceil, floor, log10

from nscc.diagnostics.model import Diagnostic, Label, Severity
from nscc.lower.choose import Choice
from nscc.lower.ledger import ledger
from nscc.lower.lowered import Lowered
from nscc.lower.plan import Misfit
from nscc.program.model import Program
from nscc.source import Span
from nscc.target.model import Target


def capacity_fault(program: Program) -> Diagnostic | None:
    """NS0412: more shutters than the registers of a pixel have states. Certain."""
    target = program.target
    shutters = len(program.table.shutters)
    available = len(target.digital_registers)
    required = max(0, (shutters - 1).bit_length())
    if required <= available:
        return None
    if program.mode == "fixed":
        what = f"{shutters} different shutters in use"
    elif program.class_name == "e":
        free = f"{len(program.frame.slot_us)} slots"
        if len(program.buckets) > 1:
            free += f" in {len(program.buckets)} buckets"
        what = f"{free}, each free: {shutters} shutters"
    else:
        what = f"{shutters} different shutters"
    registers = (
        f"{available} one-bit registers a pixel "
        f"({target.digital_registers[0]}-{target.digital_registers[-1]})"
    )
    ledger = [
        f"{field.name} {max(1, (field.high - field.low).bit_length())}" for field in program.fields
    ]
    return Diagnostic(
        "NS0412",
        f"this shutter does not fit {target.name}: its codes need {required} bits a pixel, "
        f"the chip has {available}",
        source=program.source,
        label=Label(_field_span(program), what),
        related=_chip(program, registers),
        notes=(
            *_default_chip(program, registers),
            f"certain for codes held in digital registers: {shutters} shutters need {required} "
            "of them, whatever the encoding",
            f"bits by holder: {', '.join(ledger)}; scratch 0" if len(ledger) > 1 else
            f"bits by holder: {', '.join(ledger)}",
        ),
        data=_resource("digital registers", required, available, proved=True),
    )  # fmt: skip


def misfit_fault(program: Program, choice: Choice, *, level: int) -> Diagnostic:
    """Why no lowering at all could be laid out: NS0413, NS0414 (certain) or NS0502 (not)."""
    reasons = [
        misfit.reason if misfit.reason.startswith(name) else f"{name}: {misfit.reason}"
        for name, misfit in choice.misfits.items()
    ]
    short = [m for m in choice.misfits.values() if m.resource is not None]
    if len(short) == len(choice.misfits):
        least: Misfit = min(short, key=lambda m: m.required)
        registers = f"{least.available} analog registers that keep a value"
        buckets = len(program.buckets)
        most = least.available - (least.required - buckets)
        helps = [f"keep at most {most} buckets"]
        if len(choice.misfits) == 1:
            helps.append("leave --lowering at auto: lowerings differ in what they need")
        return Diagnostic(
            "NS0413",
            f"{buckets} buckets do not fit {program.target.name}: "
            f"they need {least.required} {least.resource}, the chip has {least.available}",
            source=program.source,
            label=Label(program.buckets[-1].span, f"bucket {buckets}"),
            related=_chip(program, registers),
            notes=(
                "certain: every bucket is a frame in a register of its own",
                *_default_chip(program, registers),
                *reasons,
            ),
            helps=tuple(helps),
            data=_resource("analog registers", least.required, least.available, proved=True),
        )
    if not any(misfit.searched for misfit in choice.misfits.values()):
        return Diagnostic(
            "NS0414",
            "this program cannot be lowered as asked: " + "; ".join(reasons),
            source=program.source,
            label=Label(program.buckets[0].span),
            helps=("leave --lowering at auto, or choose edges or accumulate",),
            data={"lowerings": list(choice.misfits)},
        )
    return Diagnostic(
        "NS0502",
        f"no gates were found at -O{level} that decode {len(program.table.shutters)} shutters in "
        f"{len(program.target.digital_registers)} digital registers",
        source=program.source,
        label=Label(_field_span(program)),
        notes=(*reasons, "not proved: another encoding or more search may find some"),
        helps=(*_another_lowering(choice), _fewer_codes(program)),
        data=_resource(
            "digital registers", len(program.target.digital_registers) + 1,
            len(program.target.digital_registers), proved=False,
        ),
    )  # fmt: skip


def faults(choice: Choice, lowered: Lowered, *, level: int) -> list[Diagnostic]:
    """Everything that keeps `lowered`, the best of `choice`, from fitting; empty if it fits."""
    found = []
    if not lowered.retained:
        found.append(_retention(lowered))
    if lowered.late:
        certain = all(_too_short(tried) for tried in choice.tried) and not any(
            misfit.searched for misfit in choice.misfits.values()
        )
        found.append(_late(lowered, level, certain=certain))
    if not lowered.stored_ok:
        found.append(_store(lowered, level))
    return found


def has_ways_out(diagnostic: Diagnostic) -> bool:
    """Whether nearby programs may have what this one lacks: store or registers."""
    return diagnostic.data.get("resource") in ("store_words", "digital registers")


def only_search_can_tell(diagnostic: Diagnostic) -> bool:
    """Whether a fault is this compiler's and not the chip's."""
    return diagnostic.data.get("proved") is False


def as_note(diagnostic: Diagnostic) -> Diagnostic:
    """What `nscc check` says instead of an unproved fault."""
    return Diagnostic(
        "NS0503",
        f"whether this fits is for `nscc build` to decide: {diagnostic.message}",
        severity=Severity.NOTE,
        source=diagnostic.source,
        label=diagnostic.label,
        notes=diagnostic.notes,
        data=diagnostic.data,
    )


def _retention(lowered: Lowered) -> Diagnostic:
    program = lowered.program
    longest = max(range(len(program.frame.slot_us)), key=program.frame.slot_us.__getitem__)
    slot_us = program.frame.slot_us[longest]
    keep_us = lowered.time.keep_us
    return Diagnostic(
        "NS0602",
        f"digital registers forget within this frame: slot {longest} lasts "
        f"{time_text(slot_us)}, and the readout {time_text(lowered.time.between_us)}; "
        f"{program.target.name} keeps a bit for {time_text(program.target.digital_retention_us)}",
        source=program.source,
        label=Label(program.frame.span, "registers are refreshed between slots, not inside them"),
        notes=(
            f"nothing is left untouched for more than {time_text(keep_us)}, with a margin of 10 %",
        ),
        helps=("split the slot into several: the rule may treat them alike",),
        data=_resource("retention_us", slot_us, keep_us, proved=True),
    )


def _late(lowered: Lowered, level: int, *, certain: bool) -> Diagnostic:
    program, target = lowered.program, lowered.program.target
    slots_us = program.frame.slot_us
    if certain:
        worst = _too_short(lowered)[0]
        needed_us = _least_us(lowered, worst)
        why = f"its analog words and one launch take {time_text(needed_us)}"
    else:
        worst = max(lowered.late, key=lambda n: lowered.busy_us[n] - slots_us[n])
        needed_us = lowered.busy_us[worst]
        words = lowered.words_per_boundary[worst]
        why = f"its {words} words take {time_text(needed_us)} at -O{level}"
    return Diagnostic(
        "NS0601",
        f"slot {worst} is shorter than its own instructions: it lasts "
        f"{time_text(slots_us[worst])}, and {why}",
        source=program.source,
        label=Label(program.frame.span, f"{len(lowered.late)} of {len(slots_us)} slots too short"),
        related=_chip(program, _times(target)),
        notes=(
            *_default_chip(program, _times(target)),
            "certain: the light must be read and a kernel launched"
            if certain
            else "not proved: fewer words may be found",
        ),
        helps=(f"slots of {_at_least(lowered.shortest_slot_us)} or longer fit the words found",),
        data=_resource("slot_us", needed_us, slots_us[worst], proved=certain),
    )


def _times(target: Target) -> str:
    return (
        f"{target.digital_word_us:g} us a digital word, {target.analog_word_us:g} us an analog "
        f"one, {target.launch_us:g} us a launch"
    )


def _too_short(lowered: Lowered) -> list[int]:
    """Slots in which no gates at all would leave time enough; the worst one first."""
    slots_us = lowered.program.frame.slot_us
    lacking = {n: _least_us(lowered, n) - slots_us[n] for n in lowered.late}
    return sorted((n for n in lacking if lacking[n] > 0), key=lambda n: (-lacking[n], n))


def _least_us(lowered: Lowered, boundary: int) -> float:
    """Time that no program can do without at a boundary: its analog words and one launch."""
    target = lowered.program.target
    steps = [s for s in lowered.plan.steps if s.boundary == boundary and s.bucket >= 0]
    analog = sum(len(step.words) for step in steps)
    return target.launch_us + analog * target.analog_word_us if analog else 0.0


def _store(lowered: Lowered, level: int) -> Diagnostic:
    program, target = lowered.program, lowered.program.target
    stored = lowered.schedule.words_stored
    store = f"all kernels together: {target.store_words} words"
    holders = lowered.schedule.allocation.holders
    return Diagnostic(
        "NS0501",
        f"this program needs {stored} stored words at -O{level}, {target.name} stores "
        f"{target.store_words}",
        source=program.source,
        label=Label(_field_span(program), f"{len(program.table.shutters)} different shutters"),
        related=_chip(program, store),
        notes=(
            *_default_chip(program, store),
            f"{len(lowered.schedule.kernels)} kernels, lowered as {lowered.plan.lowering}, "
            f"encoding: {lowered.solution.encoding}",
            "registers: " + ledger(holders),
            "not proved: other gates or another encoding may be shorter",
        ),
        helps=("use fewer codes, fewer slots, or shutters with fewer edges",),
        data=_resource("store_words", stored, target.store_words, proved=False),
    )


def _fewer_codes(program: Program) -> str:
    """How to have fewer codes: by compiling for those in use, where that is not so already."""
    if program.mode == "fixed":
        return "use fewer different codes, or shutters with fewer edges"
    if program.pixel_codes is None:
        return "give the pixels: then only the codes in use are compiled"
    return "`--codes fixed` compiles only the codes that the pixels use"


def _field_span(program: Program) -> Span:
    return program.fields[0].span if program.fields else program.buckets[0].span


def _another_lowering(choice: Choice) -> tuple[str, ...]:
    if len(choice.misfits) > 1:
        return ()
    return ("leave --lowering at auto: another one may need other gates",)


def _chip(program: Program, text: str) -> tuple[Label, ...]:
    """The second place of a resource error: where the program names its chip."""
    return (Label(program.target_span, text),) if program.target_span is not None else ()


def _default_chip(program: Program, text: str) -> tuple[str, ...]:
    """What `_chip` says, for a program that does not name its chip."""
    return () if program.target_span is not None else (f"{program.target.name}: {text}",)


def _resource(
    name: str, required: float, available: float, *, proved: bool
) -> dict[str, str | float | bool]:
    return {"resource": name, "required": required, "available": available, "proved": proved}


def _at_least(us: float) -> str:
    """A time rounded up, in words; never less than `us`."""
    digit_us = 10.0 ** (floor(log10(us)) - 2)
    return time_text(ceil(us / digit_us - 1e-9) * digit_us)


def time_text(us: float) -> str:
    """A time in the unit that suits it."""
    for unit, size in (("s", 1e6), ("ms", 1e3), ("us", 1.0)):
        if us >= size:
            return f"{us / size:.4g} {unit}"
    return f"{us * 1e3:.4g} ns"
