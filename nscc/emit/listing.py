"""Plain-text listings of pass outputs, for `--print-after` and `--emit`."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from nscc.lower.decoding import Decoding
from nscc.lower.exposure_plan import ExposurePlan, Lowering, Misfit, Planned
from nscc.lower.gates import Gated
from nscc.lower.lowered import Choice, Lowered
from nscc.lower.schedule import allocate
from nscc.program.problems import counted
from nscc.program.program import Field, Program, SlotGrid
from nscc.prove.proof import Proof
from nscc.source import Source
from nscc.syntax.tree import File, Node

_MOST_SHUTTERS = 64
"""Most shutters that a listing shows."""
_MOST_SLOTS = 256
"""Most slots of a shutter that a listing shows."""


def program_text(program: Program) -> str:
    """Return fields, frame, class and decode table of a program as text, one line each.

    Shutters are rows of 0 and 1, slot 0 first, with the number of their codes; long tables and rows
    are shortened."""
    table = program.table
    data = "no data"
    if program.pixel_codes is not None:
        rows, cols = program.pixel_codes.shape
        data = f"data for {rows} x {cols} pixels"
    lines = [
        f"target   {program.target.name}",
        f"frame    {_frame_text(program.frame)}",
        *(f"field    {_field_text(field)}" for field in program.fields),
        *(f"bucket   {bucket.name}" for bucket in program.buckets),
        f"class    {program.class_name}: {program.class_reason}",
        f"codes    {counted(len(table.codes), 'code')} compiled ({program.mode}), "
        f"{program.legal_codes if program.legal_codes is not None else 'too many to count'} "
        f"allowed, {data}",
        f"shutters {len(table.shutters)} distinct",
        *_shutter_lines(program),
    ]
    return "\n".join(lines) + "\n"


def _frame_text(frame: SlotGrid) -> str:
    """Return the number and the lengths of a frame's slots as text; at most 16 lengths are
    listed."""
    total = f"{sum(frame.slot_us):g} us in all"
    slots = counted(len(frame.slot_us), "slot")
    if frame.equal:
        return f"{slots} of {frame.slot_us[0]:g} us, {total}"
    shown = ", ".join(f"{us:g}" for us in frame.slot_us[:16])
    ellipsis = ", ..." if len(frame.slot_us) > 16 else ""
    return f"{slots} of {shown}{ellipsis} us, {total}"


def _field_text(field: Field) -> str:
    """Return a field's name, its range, and its kind if it is not a plain range: the number of free
    bits, or the codebook of a row."""
    text = f"{field.name} : {field.low}..{field.high}"
    if field.kind == "bits":
        return f"{text} ({counted(field.bits or 0, 'free bit')})"
    if field.kind == "row":
        return f"{text} (row of {field.book})"
    return text


def _shutter_lines(program: Program) -> list[str]:
    """Return a line for each shutter: its digits for each bucket, slot 0 first and 1 for open, and
    how many codes have it.

    At most `_MOST_SHUTTERS` and `_MOST_SLOTS` are shown, with the number of the others."""
    table = program.table
    users = [0] * len(table.shutters)
    for shutter in table.shutter_of_code.tolist():
        users[shutter] += 1
    slots = len(program.frame.slot_us)
    cut = f" ... ({slots - _MOST_SLOTS} slots more)" if slots > _MOST_SLOTS else ""
    lines = []
    for number, shutter in enumerate(table.shutters[:_MOST_SHUTTERS]):
        rows = [
            "".join("1" if is_open else "0" for is_open in row[:_MOST_SLOTS].tolist()) + cut
            for row in shutter
        ]
        lines.append(f"{number:6}  {' | '.join(rows)}  {counted(users[number], 'code')}")
    if len(table.shutters) > _MOST_SHUTTERS:
        lines.append(f"        ... {len(table.shutters) - _MOST_SHUTTERS} shutters more")
    return lines


_LONGEST = 20
"""Most nodes shown of a list in a syntax tree."""


def print_tree(file: File, source: Source) -> str:
    """Return the syntax tree as text: every node with its place (row:column), indented below its
    parent.

    Of long lists, the first `_LONGEST` nodes are shown."""
    lines: list[str] = []
    for statement in file.statements:
        _print(statement, source, "", lines)
    return "\n".join(lines) + "\n"


def _print(node: Node, source: Source, indent: str, lines: list[str]) -> None:
    """Append the text of a node and its children to `lines`, a line each; the node's line begins
    with `indent`, and those of its children with two spaces more.

    `source` gives the row and column of each node."""
    row, column = source.row_column(node.span.start)
    plain: list[str] = []
    inner: list[Node] = []
    cut = 0
    # The first field is the place, which stands before the others.
    for name in node.field_names[1:]:
        value = getattr(node, name)
        items = value if isinstance(value, tuple) else (value,)
        nodes = [item for item in items if isinstance(item, Node)]
        if nodes:
            inner += nodes[:_LONGEST]
            cut += max(0, len(nodes) - _LONGEST)
        elif value is not None and value != ():
            plain.append(f"{name}={value}")
    lines.append(f"{indent}{type(node).__name__} {row}:{column} {' '.join(plain)}".rstrip())
    for child in inner:
        _print(child, source, indent + "  ", lines)
    if cut:
        lines.append(f"{indent}  .. and {cut} more")


def plan_text(plan: ExposurePlan) -> str:
    """Return an exposure plan as text: registers, then a line for each step with its boundary,
    role, bucket, number of shutters and analog words."""
    lines = [f"lowering {plan.lowering}, {plan.slots} slots, {plan.shutters} shutters"]
    lines += [f"  {register:<5} {holder}" for register, holder in plan.registers.items()]
    for step in plan.steps:
        predicate = step.predicate
        pixels_text = "every pixel" if predicate is None else f"{predicate.bit_count()} shutters"
        bucket = "" if step.bucket < 0 else f" bucket {step.bucket}"
        words = "; ".join(str(word) for word in step.words)
        lines.append(f"boundary {step.boundary:>4} {step.role:<5}{bucket} [{pixels_text}]  {words}")
    return "\n".join(lines) + "\n"


def gates_text(decoding: Decoding, program: Program) -> str:
    """Return the gates that compute FLAG (the bit that lets a pixel act) at every boundary as text.

    They are on virtual registers (p: code, s: state, t: scratch); the text begins with the chip's
    register of each."""
    solution = decoding.solution
    chip_registers = allocate(solution, program.target, program.spared_registers).chip_registers
    lines = [f"encoding: {solution.encoding}"]
    for i, holder in enumerate(solution.holders):
        lines.append(f"  p{i} in {chip_registers[f'p{i}']}: {holder}")
    lines += [f"  {v} in {r}: scratch or state" for v, r in chip_registers.items() if v[0] in "ts"]
    steps = [step for step in decoding.plan.steps if step.predicate is not None]
    segment_lines(lines, "opening", solution.opening)
    for step, answer in zip(steps, solution.answers, strict=True):
        title = f"boundary {step.boundary} {step.role} of bucket {step.bucket}"
        segment_lines(lines, title, answer)
    segment_lines(lines, "closing", solution.closing)
    return "\n".join(lines) + "\n"


def segment_lines(lines: list[str], title: str, segments: Sequence[Sequence[object]]) -> None:
    """Append a title and, indented, a line for each segment to `lines`; nothing without segments.
    The operations of a segment are separated by semicolons."""
    if segments:
        lines.append(title)
        lines += ["  " + "; ".join(map(str, segment)) for segment in segments]


def schedule_text(lowered: Lowered) -> str:
    """Return the kernels (lists of words) of a lowered program, and the boundaries that start them,
    as text. Boundaries without a kernel are left out."""
    schedule = lowered.schedule
    lines = [
        f"{schedule.words_stored} words stored in {len(schedule.kernels)} kernels, "
        f"{schedule.words_total} executed a frame"
    ]
    for i, kernel in enumerate(schedule.kernels):
        lines.append(f"k{i}: " + "; ".join(str(word) for word in kernel))
    names_at: dict[int, list[str]] = {}
    for boundary, number in schedule.launches:
        names_at.setdefault(boundary, []).append(f"k{number}")
    lines += [f"boundary {boundary:>4}: {' '.join(names)}" for boundary, names in names_at.items()]
    return "\n".join(lines) + "\n"


def choice_text(choice: Choice) -> str:
    """Return all lowerings (ways to compute the exposure) with their costs, best first, the reasons
    of those without gates, and the best one's kernels (lists of words), as lines of text."""
    lines = []
    for lowered in choice.lowerings:
        least, most = lowered.plan.analog_writes
        lines.append(
            f"{lowered.plan.lowering:<11}{'fits' if lowered.fits else 'does not fit':<13}"
            f"{lowered.schedule.words_total:>7} words a frame, "
            f"{lowered.schedule.words_stored} stored, "
            f"largest boundary {max(lowered.words_per_boundary)}, analog writes {least}..{most}\n"
        )
    return "".join(lines) + _misfits_text(choice.misfits) + schedule_text(choice.best)


def _misfits_text(misfits: Mapping[Lowering, Misfit]) -> str:
    """Return a line for each lowering (way to compute the exposure) that cannot implement the
    program, with the reason."""
    return "".join(f"{name:<11}{misfit.reason}\n" for name, misfit in misfits.items())


def parsed_text(parsed: Any) -> str:
    """Return the syntax tree that the pass `parse` made as text."""
    return print_tree(parsed.tree, parsed.source)


def plans_text(planned: Planned) -> str:
    """Return the exposure plans of all lowerings (ways to compute the exposure) as text, and why
    other lowerings have none."""
    return "".join(map(plan_text, planned.plans)) + _misfits_text(planned.misfits)


def all_gates_text(gated: Gated) -> str:
    """Return the gates of every lowering (way to compute the exposure) as text, and why other
    lowerings have none."""
    texts = [
        f"lowering {decoding.plan.lowering}\n{gates_text(decoding, gated.program)}"
        for decoding in gated.decodings
    ]
    return "".join(texts) + _misfits_text(gated.misfits)


def proof_text(proof: Proof) -> str:
    """Return the result of a proof as text."""
    verdict = "holds" if proof.holds else f"fails: {proof.failure}"
    return f"proof {verdict}: {proof.codes} codes, {proof.slots} slots\n"
