"""Stages that change the words: compile levels, lowerings, slots."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from nscc.containers import with_pixels
from nscc.diagnostics.diagnostic import Diagnostic, Rejected
from nscc.lower.exposure_plan import LOWERINGS
from nscc.pipeline import Compiled, run_passes
from nscc.source import Source
from nscc.tradeoff.points import Point, Refused
from nscc.tradeoff.slots import NotJoined, in_fewer, with_slot_us
from nscc.tradeoff.synthesis import DOES_NOT_FIT
from nscc.words.container import Container
from nscc_training.tradeoff.bench import PERCENT, Bench, StageResult, misfit, scaled, whole_ticks

JOINED = {1: "all", 2: "halves", 4: "quarters"}
"""Names of programs in which this many neighbouring slots are joined into one."""
LENGTHS = (0.25, 0.5, 1.0, 2.0)
"""Frame lengths relative to the program's own."""
_COMPILED = "the program is compiled already: give its text, FILE.nsl, to compare these"


def compiling(bench: Bench) -> StageResult:
    """Measure the levels of -O: seconds to compile, from text to proof and without the cache."""
    if bench.source is None:
        return StageResult((), (Refused("compile", "", "", "NS0743", _COMPILED),))
    points, misfits = [], []
    for level in bench.request.levels:
        setting = f"-O{level}"
        compiled = _compiled(bench, bench.source, level=level)
        if isinstance(compiled, Diagnostic):
            misfits.append(misfit("compile", setting, compiled))
            continue
        container = _laid(bench, compiled)

        bench.watch.ran("compile", level)
        again = partial(_compiled, bench, bench.source, level=level)
        timed = partial(bench.watch.times_ms, bench.request.repeats, "compile", level, again)
        took = bench.once(f"compile {level}", timed)
        words = f"{setting} ({container.words_per_frame} words)"
        way, error = container.notes.get("lowering", ""), bench.error_percent(container)
        points.append(Point("compile", way, words, error, PERCENT, tuple(took)))
    return StageResult(tuple(points), tuple(misfits))


def lowering(bench: Bench) -> StageResult:
    """Measure the lowerings: the shortest frame that their words allow."""
    if bench.source is None:
        return StageResult((), (Refused("lowering", "", "", "NS0743", _COMPILED),))
    if bench.container.machine is not None or bench.container.target.streamed:
        chip_kind = (
            "pixels that look" if bench.container.machine is not None else "a chip without logic"
        )
        reason = f"there is one way for {chip_kind}"
        return StageResult((), (Refused("lowering", "", "", "", reason),))
    points, misfits = [], []
    for name in LOWERINGS:
        compiled = _compiled(bench, bench.source, lowering=name)
        if isinstance(compiled, Diagnostic):
            misfits.append(misfit("lowering", name, compiled))
            continue
        container = _laid(bench, compiled)
        frame_ms = compiled.shortest_slot_us * container.slots / 1e3
        setting = f"{container.words_per_frame} words"
        error = bench.error_percent(container)
        points.append(Point("lowering", name, setting, error, PERCENT, (frame_ms,)))
    return StageResult(tuple(points), tuple(misfits))


def slots(bench: Bench) -> StageResult:
    """Measure fewer slots, and other frame lengths, down to the shortest that the words allow.

    The scene has the same brightness in all cases, so that a shorter frame receives less light. A
    program with fewer slots opens a pixel in a joined slot if the original is open for at least
    half of it. Its error is measured from the ideal frame of the original with the same frame
    length."""
    if bench.source is None:
        return StageResult((), (Refused("slots", "", "", "NS0743", _COMPILED),))
    points, misfits, measured_settings = [], [], set[tuple[int, float]]()
    frame_us = sum(bench.container.slot_us)
    for join in JOINED:
        source, codes, original = bench.source, None, bench.container
        try:
            if join > 1:
                text, ids = in_fewer(original, join)
                source, codes = Source(bench.source.name, text), {"id": ids}
        except NotJoined as why:
            misfits.append(Refused("slots", "", JOINED[join], "", str(why)))
            continue
        count = original.slots // join
        shortest = _compiled(bench, source)
        if isinstance(shortest, Diagnostic):
            misfits.append(misfit("slots", f"{count} slots", shortest))
            continue
        least_us = whole_ticks(shortest.shortest_slot_us) * count
        for whole_us in (least_us, *(frame_us * length for length in LENGTHS)):
            if whole_us < least_us or (count, whole_us) in measured_settings:
                continue
            measured_settings.add((count, whole_us))
            timed = replace(original, slot_us=scaled(original, whole_us))
            slot_us = np.array(timed.slot_us).reshape(-1, join).sum(axis=1).tolist()
            compiled = _compiled(bench, with_slot_us(source, slot_us))
            uneven = not np.allclose(slot_us, slot_us[0])
            setting = f"{whole_us / count:.5g} us" + " in the mean" * uneven
            if isinstance(compiled, Diagnostic):
                misfits.append(misfit("slots", f"{count} x {setting}", compiled))
                continue
            container = _laid(bench, compiled, codes)
            error = bench.error_percent(container, timed)
            method, frame_ms = f"{count} slots", whole_us / 1e3
            points.append(Point("slots", method, setting, error, PERCENT, (frame_ms,)))
    return StageResult(tuple(points), tuple(misfits))


def _compiled(bench: Bench, source: Source, **changes: Any) -> Compiled | Diagnostic:
    """Compile the program without the cache; return the message if it does not fit."""
    options = replace(bench.request.options, cache=False, **changes)
    if options.target is None:
        options = replace(options, target=bench.container.target)
    try:
        return run_passes(source, bench.request.program.parent, options)
    except Rejected as rejected:
        last = rejected.diagnostics[-1]
        if not last.code.startswith(DOES_NOT_FIT):
            raise
        return last


def _laid(bench: Bench, compiled: Compiled, codes: Any = None) -> Container:
    """Return the container of a compiled program, with codes for its pixels."""
    assert compiled.container is not None
    pixels = bench.request.pixels if codes is None else codes
    return with_pixels(compiled.container, Path(bench.request.program), pixels)
