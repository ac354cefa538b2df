"""Conversion of a lowered program to a container: encoded words, schedule, encoding, codes."""

from __future__ import annotations

from itertools import zip_longest

import numpy as np

from nscc.lower.lowered import Lowered
from nscc.truth import rows
from nscc.words.container import Container, Launch, Readout, StoredKernel
from nscc.words.encoding import encode


def assemble(lowered: Lowered, level: int) -> Container:
    """Return the complete container of a lowered program."""
    program, plan, schedule = lowered.program, lowered.plan, lowered.schedule
    target, planes = program.target, lowered.solution.planes
    shutters = len(program.table.shutters)
    encoding = np.zeros((shutters, len(target.digital_registers)), dtype=np.bool_)
    places = schedule.allocation.places
    code_columns = [target.digital_registers.index(places[f"p{i}"]) for i in range(len(planes))]
    encoding[:, code_columns] = rows(list(planes), shutters)
    return Container(
        target=target,
        slot_us=program.frame.slot_us,
        buckets=tuple(bucket.name for bucket in program.buckets),
        table=program.table,
        kernels=tuple(
            StoredKernel(f"k{i}", tuple(encode(word) for word in kernel))
            for i, kernel in enumerate(schedule.kernels)
        ),
        launches=tuple(
            Launch(boundary, kernel, level)
            for (boundary, kernel), level in zip_longest(schedule.launches, schedule.levels)
        ),
        code_registers=schedule.allocation.code_registers,
        encoding=encoding,
        pixel_codes=program.pixel_codes,
        readouts=tuple(
            Readout(register, bucket.name)
            for register, bucket in zip(plan.bucket_registers, program.buckets, strict=True)
        ),
        source_lines=tuple(program.source.text.splitlines()),
        notes={
            "class": program.class_name,
            "codes": program.mode,
            "level": str(level),
            "lowering": plan.lowering,
        },
    )
