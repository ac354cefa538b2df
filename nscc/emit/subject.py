"""The part of reports that describes the program, independent of the chip."""

from __future__ import annotations

from typing import Any

from nscc.program.program import Program


def subject(program: Program) -> dict[str, Any]:
    """Return class, slots, codes, fields and buckets of a program as JSON values."""
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
