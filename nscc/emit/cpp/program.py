"""A compiled program as one C++ file for the SCAMP-5d or SCAMP-7 devkit.

The executed words come from the container, so they are the proved words; the program and its
lowering only supply comments."""

from __future__ import annotations

import hashlib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from math import ceil
from pathlib import PurePath

from nscc.diagnostics.diagnostic import Diagnostic, Label, Rejected
from nscc.emit.cpp.codes import (
    ADDRESS_BITS,
    CodeLoading,
    bitmap,
    loading_lines,
    loading_of,
    loading_rate,
)
from nscc.emit.cpp.cpp_text import comment, entry, literal, safe, section, template_lines
from nscc.emit.cpp.devkit import Devkit, devkit_fault, devkit_of
from nscc.emit.cpp.frame import (
    LaunchSchedule,
    exact,
    kernel_name,
    kernel_us,
    schedule_lines,
    schedule_of,
)
from nscc.emit.cpp.kernels import MOST_SOURCES, TOO_WIDE, calls, kernel_lines, narrowed
from nscc.emit.cpp.reports import Margins, margins_of, report_lines, reporting_lines
from nscc.lower.lowered import Lowered
from nscc.operations import Op
from nscc.pipeline import KINDS
from nscc.program.problems import counted
from nscc.program.program import Program
from nscc.source import Span
from nscc.syntax.tree import Bucket, File, Open, PixelsExpr, PixelsFromFile, PixelsTile
from nscc.words.assembly_text import number_text, ranges_text
from nscc.words.container import (
    Container,
    StoredKernel,
    state_registers,
    steered_launches,
    with_picture_words,
)
from nscc.words.encoding import decode
from nscc.words.readout import converter_of, preparation_of

MARGINS_GROW = (
    "the states carry what is beyond the border one step further with every frame, so that reports "
    "soon cover no pixel"
)


_SIDE = 1 << ADDRESS_BITS
"""Rows and columns of SCAMP-5d's array, for which the devkit's library is written."""
_WORDS = {
    True: "each launched kernel word for word as it was proved",
    False: "or of others that its library has calls for, proved like them",
}
_DISPLAYS_A_ROW = 2
"""Displays side by side in the window of the host."""


@dataclass(frozen=True)
class DevkitProgram:
    """The C++ text, and the images (by file name) that the devkit's host needs."""

    text: str
    images: Mapping[str, bytes]


def devkit_program(tree: File, lowered: Lowered, container: Container, stem: str) -> DevkitProgram:
    """Return the program for the devkit that has the target's registers.

    `tree` gives the source lines for comments; images are named after `stem`. Raises Rejected:
    NS0520 if the devkit's chip cannot run the program, because of its registers or array size,
    missing pixel data, or no room for the kernels (lists of words) that load codes; NS0521 for
    words that the devkit's library lacks."""
    exposure, container = container, with_picture_words(container)
    program, target = lowered.program, container.target
    devkit = devkit_of(target)
    fault = devkit_fault(container, devkit)
    if fault is not None:
        raise Rejected(_no_cpp(program, devkit, f"{target.name} {fault}", _OTHER_CHIP))
    margins = margins_of(exposure) if exposure.pictures.reports else Margins([], [])
    if margins is None:
        way_out = "read the plane instead of reporting it"
        raise Rejected(_no_cpp(program, devkit, MARGINS_GROW, way_out))
    if container.pixel_codes is None:
        reason = "without `pixels`, the pixels have no codes to load"
        raise Rejected(_no_cpp(program, devkit, reason, _DATA))
    planes = container.planes()
    registers = exposure.pictures.registers
    opened = [plane.name for plane in exposure.pictures.inputs if plane.is_open]
    loading = loading_of(planes, target, stem, {registers[name]: name for name in opened})
    _check_store(program, container, loading, devkit)
    schedule = schedule_of(container, steered_launches(exposure))
    lines = [
        *_header(lowered, container, schedule, loading, devkit),
        "",
        "#include <scamp5.hpp>",
        "",
        "#include <cstdint>",
        "",
        "using namespace SCAMP5_PE;",
        "",
        *template_lines("clock"),
        "",
        "namespace {",
        "",
        *_kernels(tree, program, container, exposure, devkit),
        _statement(program, program.frame.span),
        *schedule_lines(schedule, container),
        "",
    ]
    if loading.loads:
        kinds = PixelsExpr | PixelsTile | PixelsFromFile
        statements = [node.span for node in tree.statements if isinstance(node, kinds)]
        lines += [*(_statement(program, span) for span in statements), *loading_lines(loading), ""]
    lines += report_lines(exposure, margins) if margins.cases else []
    lines += ["}  // namespace", "", *_main(container, loading, margins)]
    images = {load.file: bitmap(planes[load.register]) for load in loading.images}
    return DevkitProgram("".join(f"{devkit.named(line)}\n" for line in lines), images)


_OTHER_CHIP = "choose a target with a devkit's registers, such as `--target scamp5`"
_DATA = "add `pixels FIELD = ...` for every field"


def _no_cpp(
    program: Program, devkit: Devkit, reason: str, way_out: str, code: str = "NS0520"
) -> Diagnostic:
    """Return the error `code` that C++ cannot be written, for `reason` (the end of a sentence);
    `way_out` is its help. It points to the statement that chooses the chip, if there is one."""
    span = program.target_span
    return Diagnostic(
        code,
        f"C++ for the {devkit.name} devkit cannot be written: {reason}",
        source=program.source if span else None,
        label=Label(span, "this statement chooses the chip") if span else None,
        helps=(way_out,),
        data={"target": program.target.name},
    )


def _check_store(
    program: Program, container: Container, loading: CodeLoading, devkit: Devkit
) -> None:
    """Check that the words of the frame, of loading the codes and of the readout fit the store
    together; return nothing if they do.

    Raises Rejected (NS0520) if they do not."""
    target = container.target
    frame = sum(
        len(kernel.words)
        for kernel in container.kernels
        # Kernels without calls become constant tables, which need not count.
        if target.tables_count_against_store or calls(ops_of(kernel)) is not None
    )
    preparing = len(preparation_of(container).words)
    needed = frame + loading.words + preparing
    if needed > target.store_words:
        reason = (
            f"its kernels need {needed} words ({frame} for the frame, {loading.words} to "
            f"load the codes, {preparing} before the readout), but {target.name} stores "
            f"{target.store_words}"
        )
        way_out = "use fewer slots, or fewer different kernels"
        raise Rejected(_no_cpp(program, devkit, reason, way_out))


def ops_of(kernel: StoredKernel) -> list[Op]:
    """Return the decoded words of a kernel (list of words)."""
    return [decode(word) for word in kernel.words]


def _header(
    lowered: Lowered,
    container: Container,
    schedule: LaunchSchedule,
    loading: CodeLoading,
    devkit: Devkit,
) -> Iterator[str]:
    """Yield the lines of the comment above the C++ program: class, slots, registers, words, times,
    readout, digests. Titles without a text are left out."""
    program, allocation = lowered.program, lowered.schedule.allocation
    target = container.target
    stored = sum(len(kernel.words) for kernel in container.kernels)
    executed = sum(len(container.kernels[launch.kernel].words) for launch in container.launches)
    loading_and_readout_words = loading.words + len(preparation_of(container).words)
    yield from comment(
        f"{_name(program)}: per-pixel shutters for the {devkit.name} devkit. Written by nscc from "
        f"the words of the compiled program, {_WORDS[devkit.tables]}."
    )
    yield "//"
    yield from entry("class", f"{program.class_name}: {program.class_reason}")
    lengths = [number_text(us) for us in sorted({min(container.slot_us), max(container.slot_us)})]
    total = number_text(float(sum(map(exact, container.slot_us))))
    slots = f"{container.slots} of {' to '.join(lengths)} us, {total} us in all"
    yield from entry("slots", slots)
    yield from entry("lowering", f"{lowered.plan.lowering}; encoding: {lowered.solution.encoding}")
    for title, holders in (
        ("digital", allocation.holders),
        ("analog", lowered.plan.registers),
    ):
        contents = "; ".join(f"{register} {holder}" for register, holder in holders.items())
        if contents:
            yield from entry(title, contents)
    yield from entry(
        "words",
        f"{stored} stored in {len(container.kernels)} kernels, {executed} a frame; "
        f"{loading_and_readout_words} more load the codes and prepare readout",
    )
    yield from entry("time", _time_text(container, schedule))
    yield from entry("readout", _readout_text(container))
    for text in _state_texts(container):
        yield from entry("state", text)
    if container.pictures.registers:
        held = ", ".join(f"{name} in {r}" for name, r in container.pictures.registers.items())
        yield from entry("images", f"{held}; codes of images are signed, 128 is 0")
    array = f"{target.rows} x {target.cols} pixels; the devkit's (0, 0) is the top right one"
    if (target.rows, target.cols) != (_SIDE, _SIDE):
        array += f", and so is the corner of the {_SIDE} x {_SIDE} that is used"
    yield from entry("array", array)
    for load in loading.images:
        data = hashlib.sha256(bitmap(container.planes()[load.register])).hexdigest()
        yield from entry(
            "image",
            f"{load.file}, in the host application's folder: "
            f"{load.input_plane or 'the code'} in {load.register}, SHA-256 {data}",
        )
    yield from entry(
        "source", f"SHA-256 {hashlib.sha256(program.source.text.encode()).hexdigest()}"
    )


def _name(program: Program) -> str:
    """Return the file name of the program without its folder."""
    return PurePath(program.source.name).name


def _time_text(container: Container, schedule: LaunchSchedule) -> str:
    """Return the header's sentence on when the exposure begins and ends, and how long words
    take."""
    target = container.target
    return (
        f"the exposure begins {schedule.begin_us} us after the frame's first word and ends "
        f"{number_text(float(schedule.end))} us after it; a launch waits for its moment on a clock "
        "that runs on, so that no error adds up; words take, by the target's figures, "
        f"{number_text(target.analog_word_us)} us (analog) and "
        f"{number_text(target.digital_word_us)} us (digital), a launch "
        f"{number_text(target.launch_us)} us"
    )


def _readout_text(container: Container) -> str:
    """Return the header's sentence on how converter codes map to electrons; "images and planes" if
    no bucket is read."""
    target = container.target
    if not container.buckets_read:
        return "images and planes"
    if preparation_of(container).level is not None:
        return (
            f"2 x exposure - full well: all codes for 0 to {number_text(target.full_well_e)} e, "
            f"{number_text(round(target.electrons_per_lsb, 3))} e each"
        )
    step_e = converter_of(container).electrons_per_lsb
    return (
        "exposures as they are, in the upper half of a symmetric converter's codes, "
        f"{number_text(round(step_e, 3))} e each"
    )


_MOST_VALUES = 64
"""Most values of a state that a comment lists."""


def _state_texts(container: Container) -> Iterator[str]:
    """Yield for each state that is read out a text: its registers, and the bits of its values, in
    the order of the registers. At most _MOST_VALUES values are listed."""
    machine = container.machine
    for state in machine.states:
        if state.read:
            planes = container.state_planes[state.name]
            text = f"{state.name} in {' '.join(planes.registers) or 'no register'}"
            rows = zip(planes.values, planes.bits.astype(int), strict=True)
            listed = [f"{value} is {''.join(map(str, bits))}" for value, bits in rows]
            omitted = f", and {len(listed) - _MOST_VALUES} more" * (len(listed) > _MOST_VALUES)
            yield f"{text}: {', '.join(listed[:_MOST_VALUES])}{omitted}"


def _statement(program: Program, span: Span, prefix: str = "") -> str:
    """Return a comment with the place and the first line of a statement of the program; `prefix`
    stands before it."""
    row, _ = program.source.row_column(span.start)
    return f"// {safe(f'{prefix}{_name(program)}:{row}: {program.source.line(row).strip()}')}"


def _kernels(
    tree: File, program: Program, container: Container, exposure: Container, devkit: Devkit
) -> Iterator[str]:
    """Yield the C++ functions of all kernels (lists of words), with comments on their times and
    rules.

    `exposure` is the container (a compiled program) without the words of images and planes, whose
    kernels come first in `container`. Words without a library call are replaced by words with fewer
    operands, which are proved again, or become tables if the devkit allows that. Raises Rejected
    (NS0521) if neither is possible."""
    kernels = [ops_of(kernel) for kernel in container.kernels]
    narrow: list[list[Op]] | None = kernels
    if any(calls(ops) is None for ops in kernels):
        narrow = narrowed(replace(exposure, code_registers=container.code_registers))
        if narrow is None and not devkit.tables:
            most = MOST_SOURCES["WHERE"]
            widest = max(len(op.sources) for ops in kernels for op in ops if op.name == "WHERE")
            registers = counted(len(program.target.digital_registers), "digital register")
            reason = (
                f"a WHERE has {widest} sources, but a call of its library takes at most {most}, "
                f"and none of {registers} is free to divide it"
            )
            raise Rejected(_no_cpp(program, devkit, reason, TOO_WIDE, "NS0521"))
        if narrow is not None:
            proof = KINDS.of(exposure).prove(exposure, narrow)
            if not proof.holds:
                raise ValueError(
                    f"calls with few sources do not implement the program: {proof.failure}"
                )
            # The kernels of images and planes follow, and stay as they are.
            narrow += kernels[len(narrow) :]
        if devkit.tables:
            yield from ["#ifdef __LPC43XX__", *template_lines("run"), "#endif", ""]
    launched: dict[int, list[int]] = {}
    for launch in container.launches:
        launched.setdefault(launch.kernel, []).append(launch.instant)
    rules = {
        (rule.name.text if isinstance(rule, Bucket) else "frame"): rule.span
        for rule in tree.statements
        if isinstance(rule, Open | Bucket)
    }
    bucket_of = {readout.register: readout.bucket for readout in exposure.readouts}
    for number, (kernel, ops) in enumerate(zip(container.kernels, kernels, strict=True)):
        instants = ranges_text(sorted(set(launched.get(number, []))))
        us = number_text(float(kernel_us(kernel, container.target)))
        yield from comment(
            f"{len(ops)} word{'s' * (len(ops) != 1)}, {us} us; launched at boundary "
            f"{instants or '-'}"
        )
        written = {register for op in ops for register in op.destinations}
        for register, bucket in bucket_of.items():
            if register in written and bucket in rules and number < len(exposure.kernels):
                yield _statement(program, rules[bucket], f"writes {register}: ")
        narrow_ops = None if narrow is None else narrow[number]
        yield from kernel_lines(kernel_name(number), ops, narrow_ops, tables=devkit.tables)
        yield ""


def _main(container: Container, loading: CodeLoading, margins: Margins) -> Iterator[str]:
    """Yield the lines of the function `main`: displays, loading of codes, frames, readout and
    reports of planes, which leave out `margins`. What the program does not have is left out."""
    shown = [(readout.register, readout.bucket) for readout in container.readouts]
    pictures = container.pictures
    names = {register: name for name, register in pictures.registers.items()}
    shown += [(register, names.get(register, register)) for register in state_registers(container)]
    yield "int main() {"
    yield "    vs_init();"
    # One display for each readout and each state, in rows of `_DISPLAYS_A_ROW`.
    for number, (_, name) in enumerate(shown):
        row, col = divmod(number, _DISPLAYS_A_ROW)
        yield (
            f"    const auto display_{number} = "
            f"vs_gui_add_display({literal(name)}, {2 * row}, {2 * col}, 2);"
        )
    for number, param in enumerate(pictures.params):
        step_e = number_text(round(container.target.electrons_per_step, 3))
        name = f"{param.name} (steps of {step_e} e)" if param.kind == "level" else param.name
        values = f"{param.low}, {param.high}, {param.start}"
        yield f"    vs_gui_add_slider({literal(name)}, {values}, &param_{number});"
    for number, load in enumerate(loading.inputs):
        yield f"    int wanted_{number} = 0, loaded_{number} = 0;"
        title = literal(f"load {load.input_plane} again")
        yield f"    vs_gui_add_slider({title}, 0, 1, 0, &wanted_{number});"
    yield ""
    yield from template_lines("record")
    if loading.images:
        yield from ["", *template_lines("awaiting", rate=loading_rate(container.target))]
    if loading.loads:
        yield "    load_codes();"
    preparing = preparation_of(container)
    # Before each frame, IN settles and the words that prepare the readout run.
    prepare = []
    if preparing.level is not None:
        settle = ceil(exact(container.target.in_settle_us))
        prepare = template_lines("spread", level=preparing.level, settle=settle)
    readout_calls = calls(preparing.words)
    assert readout_calls is not None, "every bus of at most four registers has a call"
    prepare += section((call for call, _ in readout_calls), " " * 8)
    yield from ["", "    while (true) {"]
    for number, load in enumerate(loading.inputs):
        rate, register = loading_rate(container.target), load.register.lower()
        yield from template_lines("input", number=number, rate=rate, register=register)
    yield from template_lines("frames", prepare="\n".join(prepare))
    gains = {readout.register: readout.gain for readout in container.readouts}
    for number, (register, _) in enumerate(shown):
        gain = gains.get(register, 1.0)
        remark = "" if gain == 1 else f"  // times {number_text(gain)}"
        yield f"        scamp5_output_image({register}, display_{number});{remark}"
    if pictures.reports:
        yield from reporting_lines(container, margins)
    yield "    }"
    yield "}"
