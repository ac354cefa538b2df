"""Stages that change the words (compile levels, lowerings, slots), and that of the emulation."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from pathlib import Path
from time import perf_counter
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.containers import with_pixels
from nscc.diagnostics.diagnostic import Diagnostic, Rejected
from nscc.lower.exposure_plan import LOWERINGS
from nscc.pipeline import Compiled, run_passes
from nscc.source import Source
from nscc.tradeoff.points import Point, Refused
from nscc.tradeoff.slots import NotJoined, in_fewer, with_slot_us
from nscc.tradeoff.synthesis import DOES_NOT_FIT
from nscc.words.container import Container
from nscc_runtime.effects import everything, selected
from nscc_runtime.effects.parameters import MOST_E
from nscc_runtime.planless import refuse_planless
from nscc_runtime.planning.audit import audit
from nscc_runtime.planning.make import make_plan
from nscc_runtime.planning.plan import Plan
from nscc_runtime.planning.plan_request import PlanRequest
from nscc_runtime.planning.planned_scene import planning_of
from nscc_runtime.planning.tolerance import LEAST_E
from nscc_runtime.reference.capture import Reference, scene_of
from nscc_runtime.tradeoff.study import unknown
from nscc_training.tradeoff.bench import (
    PERCENT,
    Bench,
    StageResult,
    misfit,
    scaled,
    scaled_text,
    whole_ticks,
)

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
    if bench.container.machine.stages or bench.container.target.streamed:
        chip_kind = "pixels that look" if bench.container.machine.stages else "a chip without logic"
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


Values = NDArray[np.float64]

PARTS = (0.1, 0.3, 1.0, 3.0)
"""Tolerances of plans, as fractions of the target error."""
COMPARED = 1 << 20
"""Most slots times pixels that the reference simulates."""


def effects(bench: Bench) -> StageResult:
    """Measure plans of several tolerances, all effects, and the reference: seconds to emulate a
    frame.

    Errors are those of the audit: differences from all effects with the same random numbers. Raises
    Rejected (NS0750) for a program without plans, whose simulation has no approximations."""
    container, request = bench.container, bench.request
    refuse_planless(container, "comparing tolerances")
    tolerances, notes = _tolerances(bench)
    ways = [("auto", tolerance) for tolerance in tolerances]
    ways.append(("all", scaled_text(request.target_error, 1.0)))

    def measured(chosen: str, tolerance: str) -> dict[str, Any]:
        def emulated() -> tuple[Plan, float]:
            """Return a plan and the milliseconds of making it, and expose a frame."""
            # A scene without stored sums: computing them is part of the frame's time.
            begin, light = perf_counter(), unknown(bench.light)
            planning = planning_of(container, bench.sensor, light, request.device_seed)
            plan = make_plan(planning, PlanRequest(selected(chosen), tolerance))
            plan_ms = (perf_counter() - begin) * 1e3
            next(iter(planning.frames(plan.kept, request.seed, 1)))
            return plan, plan_ms

        first_ms, next_ms = [], []
        for _ in range(request.repeats):
            (plan, plan_ms), taken_ms = bench.watch.ms(f"effects {chosen}", tolerance, emulated)
            first_ms.append(taken_ms)
            next_ms.append(taken_ms - plan_ms)
        percent = 100.0 * audit(scene, plan).measured_rms_e / bench.signal_e()
        return {"error": percent, "first": first_ms, "next": next_ms}

    scene = planning_of(container, bench.sensor, bench.light, request.device_seed)
    scene.ready()
    measurements = {" ".join(way): partial(measured, *way) for way in ways}
    values = {way: bench.once(f"effects {way}", measure) for way, measure in measurements.items()}
    points = [
        Point("effects", line, way, timing["error"], PERCENT, tuple(timing[key]))
        for line, key in (("with planning", "first"), ("planned", "next"))
        for way, timing in values.items()
    ]
    height, cols = bench.light.shape
    rows = range(min(height, max(1, COMPARED // (container.slots * cols))))
    took_ms = bench.once("effects reference", lambda: _reference_ms(bench, rows))
    points.append(Point("effects", "reference", "all", 0.0, PERCENT, (took_ms,)))
    if len(rows) < height:
        notes.insert(0, f"the reference ran {len(rows)} of {height} rows: its time is theirs "
                        "scaled to all")  # fmt: skip
    return StageResult(tuple(points), notes=tuple(notes))


def _tolerances(bench: Bench) -> tuple[list[str], list[str]]:
    """Return PARTS of the target error within the allowed range, and notes on limits."""
    target = bench.target
    tolerances, notes = dict[str, None](), list[str]()
    for share in PARTS:
        tolerance = scaled_text(bench.request.target_error, share)
        electrons = share * target.electrons
        nearest = min(max(electrons, LEAST_E), MOST_E)
        if nearest != electrons:
            notes.append(f"no plan is made for {tolerance}: {nearest:g}e stands for it")
            tolerance = f"{nearest:g}e"
        tolerances[tolerance] = None
    return [*tolerances], notes


def _reference_ms(bench: Bench, rows: range) -> float:
    """Return the milliseconds of a frame of the reference, from the time of some rows."""
    reference = Reference.of(bench.container, bench.sensor, everything())
    scene, planes = scene_of(bench.container, bench.light), bench.container.planes()
    seeds = bench.request.seed, bench.request.device_seed
    run = partial(reference.execute, scene, planes, seeds, 0, rows)
    _, took_ms = bench.watch.ms("reference", "all", run, first=run)
    return took_ms * bench.light.shape[0] / len(rows)
