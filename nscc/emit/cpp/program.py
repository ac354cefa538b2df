"""A compiled program as one C++ file for the SCAMP-5d devkit.

What runs is taken from the container, so from the words that were proved; the program and its
lowering only supply the comments.
"""

from __future__ import annotations

import hashlib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import PurePath

from nscc.diagnostics.diagnostic import Diagnostic, Label, Rejected
from nscc.emit.cpp.bitmap import bitmap
from nscc.emit.cpp.codes import Loading, loading_lines, loading_of, loading_rate
from nscc.emit.cpp.frame import (
    Schedule,
    exact,
    frame_rate,
    kernel_name,
    kernel_us,
    schedule_lines,
    schedule_of,
)
from nscc.emit.cpp.kernels import DEVKIT_ANALOG, DEVKIT_DIGITAL, calls, kernel_lines
from nscc.emit.cpp.patterns import ADDRESS_BITS
from nscc.emit.cpp.text import Call, comment, entry, literal, part, safe, section
from nscc.lower.lowered import Lowered
from nscc.program.program import Program
from nscc.source import Span
from nscc.syntax.tree import Bucket, File, Open, PixelsExpr, PixelsFromFile, PixelsTile
from nscc.target.target import Target
from nscc.words.container import Container
from nscc.words.encoding import decode
from nscc.words.text import number_text, ranges_text

_SIDE = 1 << ADDRESS_BITS
_DISPLAYS_A_ROW = 2
_READOUT: list[Call] = [("all", ())]


@dataclass(frozen=True)
class DevkitProgram:
    """The C++ text, and the pictures (name, bytes) that the devkit's host must have at hand."""

    text: str
    images: Mapping[str, bytes]


def devkit_program(tree: File, lowered: Lowered, container: Container, stem: str) -> DevkitProgram:
    """The program for the devkit; images are named after `stem`.

    Raises Rejected (NS0520) where the devkit cannot run it: another chip's registers or array, no
    pixel data, pixels that look at the light, no room for the kernels that load the codes.
    """
    program = lowered.program
    fault = target_fault(container.target)
    if fault is not None:
        raise Rejected(_no_cpp(program, f"{container.target.name} {fault}", _OTHER_CHIP))
    if container.machine is not None:
        reason = "its pixels compare light with IN, which no call of the devkit known to nscc sets"
        raise Rejected(_no_cpp(program, reason, "build the .icw container: it holds the words"))
    if container.pixel_codes is None:
        raise Rejected(_no_cpp(program, "without `pixels` no pixel has a code to load", _DATA))
    planes = container.planes()
    loading = loading_of(planes, container.target, stem)
    _check_store(program, container, loading)
    schedule = schedule_of(container)
    lines = [
        *_header(lowered, container, schedule, loading),
        "",
        "#include <scamp5.hpp>",
        "",
        "#include <cstdint>",
        "",
        "using namespace SCAMP5_PE;",
        "",
        "namespace {",
        "",
        *_kernels(tree, program, container),
        _statement(program, program.frame.span),
        *schedule_lines(schedule, container),
        "",
    ]
    if loading.loads:
        lines += [*_pixel_statements(tree, program), *loading_lines(loading), ""]
    lines += ["}  // namespace", "", *_main(container, schedule, loading)]
    images = {load.file: bitmap(planes[load.register]) for load in loading.images}
    return DevkitProgram("\n".join(lines) + "\n", images)


_OTHER_CHIP = "choose a target with the devkit's registers, such as `--target scamp5`"
_DATA = "add `pixels FIELD = ...` for every field"


def target_fault(target: Target) -> str | None:
    """Why the devkit's chip cannot stand in for `target`, as half a sentence; None if it can."""
    known = DEVKIT_ANALOG | DEVKIT_DIGITAL
    extra = [r for r in (*target.analog_registers, *target.digital_registers) if r not in known]
    if extra:
        shown = ", ".join(extra) if len(extra) < 4 else f"{extra[0]} to {extra[-1]}"
        return f"has registers that the SCAMP-5d devkit does not: {shown}"
    if "R12" in target.digital_registers and (
        (target.mask_register, target.masked_register) != ("R0", "R12")
    ):
        return "writes R12 in all pixels, and the SCAMP-5d devkit only where R0 is 1"
    if target.words:
        names = ", ".join(row.name for row in target.words[:4])
        return f"has words that the SCAMP-5d devkit does not: {names}"
    if target.rows > _SIDE or target.cols > _SIDE:
        return (
            f"has {target.rows} x {target.cols} pixels, and the SCAMP-5d devkit {_SIDE} x {_SIDE}"
        )
    return None


def _no_cpp(program: Program, reason: str, way_out: str) -> Diagnostic:
    span = program.target_span
    return Diagnostic(
        "NS0520",
        f"C++ for the SCAMP-5d devkit cannot be written: {reason}",
        source=program.source if span else None,
        label=Label(span, "the chip is chosen here") if span else None,
        helps=(way_out,),
        data={"target": program.target.name},
    )


def _check_store(program: Program, container: Container, loading: Loading) -> None:
    """Refuses what the frame's kernels leave no room to load."""
    target = container.target
    frame = sum(
        len(kernel.words)
        for kernel in container.kernels
        if target.tables_count_against_store or calls(kernel.words) is not None
    )
    needed = frame + loading.words + len(_READOUT)
    if needed > target.store_words:
        reason = (
            f"its kernels need {needed} words ({frame} of the frame, {loading.words} that load "
            f"the codes, {len(_READOUT)} before readout), and {target.name} stores "
            f"{target.store_words}"
        )
        raise Rejected(_no_cpp(program, reason, "use fewer slots, or fewer different kernels"))


def _header(
    lowered: Lowered, container: Container, schedule: Schedule, loading: Loading
) -> Iterator[str]:
    program, allocation = lowered.program, lowered.schedule.allocation
    target = container.target
    stored = sum(len(kernel.words) for kernel in container.kernels)
    executed = sum(len(container.kernels[launch.kernel].words) for launch in container.launches)
    yield from comment(
        f"{_name(program)}: per-pixel shutters for the SCAMP-5d devkit. Written by nscc from the "
        "words of the compiled program, each launched kernel word for word as it was proved."
    )
    yield "//"
    yield from entry("class", f"{program.class_name}: {program.class_reason}")
    yield from entry("slots", _slots_text(container))
    yield from entry("lowering", f"{lowered.plan.lowering}; encoding: {lowered.solution.encoding}")
    for title, holders in (
        ("digital", allocation.holders),
        ("analog", lowered.plan.registers),
    ):
        held = "; ".join(f"{register} {holder}" for register, holder in holders.items())
        if held:
            yield from entry(title, held)
    yield from entry(
        "words",
        f"{stored} stored in {len(container.kernels)} kernels, {executed} a frame; "
        f"{loading.words + len(_READOUT)} more load the codes and prepare readout",
    )
    yield from entry("time", _time_text(container, schedule))
    yield from entry("array", _array_text(target))
    for load in loading.images:
        data = hashlib.sha256(bitmap(container.planes()[load.register])).hexdigest()
        yield from entry(
            "image",
            f"{load.file}, in the host application's folder: the code in {load.register}, "
            f"SHA-256 {data}",
        )
    yield from entry(
        "source", f"SHA-256 {hashlib.sha256(program.source.text.encode()).hexdigest()}"
    )


def _name(program: Program) -> str:
    return PurePath(program.source.name).name


def _slots_text(container: Container) -> str:
    total = number_text(float(sum(map(exact, container.slot_us))))
    lengths = sorted(set(container.slot_us))
    each = f"of {number_text(lengths[0])} us"
    if len(lengths) > 1:
        each = f"of {number_text(lengths[0])} to {number_text(lengths[-1])} us"
    return f"{container.slots} {each}, {total} us in all"


def _time_text(container: Container, schedule: Schedule) -> str:
    target = container.target
    return (
        "waits fill the slots after the words, at "
        f"{number_text(target.analog_word_us)} us an analog word, "
        f"{number_text(target.digital_word_us)} us a digital one and "
        f"{number_text(target.launch_us)} us a launch; they are whole microseconds, rounded up so "
        "that no slot is too short, which makes a frame "
        f"{number_text(float(schedule.excess_us))} us longer"
    )


def _array_text(target: Target) -> str:
    text = f"{target.rows} x {target.cols} pixels; the devkit's (0, 0) is the top right one"
    if (target.rows, target.cols) != (_SIDE, _SIDE):
        text += f", and so is the corner of the {_SIDE} x {_SIDE} that is used"
    return text


def _statement(program: Program, span: Span, what: str = "") -> str:
    """The line of the source that a span begins on, as a comment."""
    row, _ = program.source.row_column(span.start)
    return f"// {safe(f'{what}{_name(program)}:{row}: {program.source.line(row).strip()}')}"


def _pixel_statements(tree: File, program: Program) -> Iterator[str]:
    for statement in tree.statements:
        if isinstance(statement, PixelsExpr | PixelsTile | PixelsFromFile):
            yield _statement(program, statement.span)


def _kernels(tree: File, program: Program, container: Container) -> Iterator[str]:
    if any(calls(kernel.words) is None for kernel in container.kernels):
        yield from [*part("run"), ""]
    launched: dict[int, list[int]] = {}
    for launch in container.launches:
        launched.setdefault(launch.kernel, []).append(launch.instant)
    rules = {
        (rule.name.text if isinstance(rule, Bucket) else "frame"): rule.span
        for rule in tree.statements
        if isinstance(rule, Open | Bucket)
    }
    bucket_of = {readout.register: readout.bucket for readout in container.readouts}
    for number, kernel in enumerate(container.kernels):
        instants = ranges_text(sorted(set(launched.get(number, []))))
        us = number_text(float(kernel_us(kernel, container.target)))
        count = len(kernel.words)
        yield from comment(
            f"{count} word{'s' * (count != 1)}, {us} us; launched at boundary {instants or '-'}"
        )
        written = {r for word in kernel.words for r in decode(word).destinations}
        for register, bucket in bucket_of.items():
            if register in written and bucket in rules:
                yield _statement(program, rules[bucket], f"writes {register}: ")
        yield from kernel_lines(kernel_name(number), kernel.words)
        yield ""


def _main(container: Container, schedule: Schedule, loading: Loading) -> Iterator[str]:
    target = container.target
    period_us = schedule.frame_us + schedule.excess_us
    period_us += len(container.readouts) * exact(target.readout_us)
    yield "int main() {"
    yield "    vs_init();"
    for number, readout in enumerate(container.readouts):
        row, col = divmod(number, _DISPLAYS_A_ROW)
        yield (
            f"    const auto display_{number} = "
            f"vs_gui_add_display({literal(readout.bucket)}, {2 * row}, {2 * col}, 2);"
        )
    yield ""
    yield from part("record")
    if loading.images:
        yield from ["", *part("awaiting", rate=loading_rate(target))]
    if loading.loads:
        yield "    load_codes();"
    prepare = "\n".join(section(_READOUT, " " * 8))
    yield from ["", *part("frames", rate=frame_rate(period_us), prepare=prepare)]
    for number, readout in enumerate(container.readouts):
        remark = "" if readout.gain == 1 else f"  // times {number_text(readout.gain)}"
        yield f"        scamp5_output_image({readout.register}, display_{number});{remark}"
    yield "    }"
    yield "}"
