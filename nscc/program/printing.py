"""A checked program as plain text, for `--emit ir` and `--print-after program`."""

from __future__ import annotations

from nscc.program.problems import counted
from nscc.program.program import Field, Program, SlotGrid

_MOST_SHUTTERS = 64
_MOST_SLOTS = 256


def print_program(program: Program) -> str:
    """Return fields, frame, class and decode table of `program` as text.

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
    total = f"{sum(frame.slot_us):g} us in all"
    slots = counted(len(frame.slot_us), "slot")
    if frame.equal:
        return f"{slots} of {frame.slot_us[0]:g} us, {total}"
    shown = ", ".join(f"{us:g}" for us in frame.slot_us[:16])
    ellipsis = ", ..." if len(frame.slot_us) > 16 else ""
    return f"{slots} of {shown}{ellipsis} us, {total}"


def _field_text(field: Field) -> str:
    text = f"{field.name} : {field.low}..{field.high}"
    if field.kind == "bits":
        return f"{text} ({counted(field.bits or 0, 'free bit')})"
    if field.kind == "row":
        return f"{text} (row of {field.book})"
    return text


def _shutter_lines(program: Program) -> list[str]:
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
