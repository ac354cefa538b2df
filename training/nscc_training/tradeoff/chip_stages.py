"""Stages that change the words (compile levels, lowerings, slots), and that of the emulation."""

from __future__ import annotations

from dataclasses import replace
from functools import cached_property, partial
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
from nscc_runtime.frame_file import Frame
from nscc_runtime.looked_light import OPEN
from nscc_runtime.planless import refuse_planless
from nscc_runtime.planning.audit import bands, compared_rows
from nscc_runtime.planning.make import make_plan
from nscc_runtime.planning.plan_request import PlanRequest
from nscc_runtime.planning.planned_scene import planning_of
from nscc_runtime.planning.tolerance import LEAST_E
from nscc_runtime.reference.capture import Reference, scene_of
from nscc_runtime.simulate import Request, simulate
from nscc_runtime.tradeoff.study import unknown
from nscc_training.tradeoff.bench import (
    PERCENT,
    Bench,
    StageResult,
    misfit,
    rms_percent,
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
"""Most slots times pixels that the reference simulates, in bands of rows."""


def effects(bench: Bench) -> StageResult:
    """Measure plans of several tolerances, all effects, and the reference: seconds to emulate a
    frame.

    Errors are differences from the reference with the same random numbers. Raises Rejected (NS0750)
    for a program without plans, whose simulation has no approximations."""
    container, request = bench.container, bench.request
    refuse_planless(container, "comparing tolerances")
    truth = _Truth(bench)
    tolerances, notes = _tolerances(bench)
    ways = [("auto", tolerance) for tolerance in tolerances]
    ways.append(("all", scaled_text(request.target_error, 1.0)))

    def measured(chosen: str, tolerance: str) -> dict[str, Any]:
        def emulated() -> tuple[Frame, float]:
            """Return a frame, and the milliseconds of its plan."""
            # A scene without stored sums: computing them is part of the frame's time.
            begin, light = perf_counter(), unknown(bench.light)
            planning = planning_of(container, bench.sensor, light, request.device_seed)
            plan = make_plan(planning, PlanRequest(selected(chosen), tolerance))
            plan_ms = (perf_counter() - begin) * 1e3
            return next(iter(planning.frames(plan, request.seed, 1))), plan_ms

        first_ms, next_ms = [], []
        for _ in range(request.repeats):
            (frame, plan_ms), taken_ms = bench.watch.ms(f"effects {chosen}", tolerance, emulated)
            first_ms.append(taken_ms)
            next_ms.append(taken_ms - plan_ms)
        return {"error": truth.percent(frame), "first": first_ms, "next": next_ms}

    planning_of(container, bench.sensor, bench.light, request.device_seed).ready()
    measurements = {" ".join(way): partial(measured, *way) for way in ways}
    values = {way: bench.once(f"effects {way}", measure) for way, measure in measurements.items()}
    points = [
        Point("effects", line, way, timing["error"], PERCENT, tuple(timing[key]))
        for line, key in (("with planning", "first"), ("planned", "next"))
        for way, timing in values.items()
    ]
    height = bench.light.shape[0]
    took_ms = bench.once("effects reference", lambda: truth.frame[1] * height / len(truth.rows))
    points.append(Point("effects", "reference", "all", 0.0, PERCENT, (took_ms,)))
    if len(truth.rows) < height:
        notes.insert(0, f"the reference ran {len(truth.rows)} of {height} rows, spread evenly: "
                        "errors are theirs, and its time is theirs scaled to all")  # fmt: skip
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


class _Truth:
    """A frame of the reference, or bands of its rows; computed when first needed."""

    def __init__(self, bench: Bench) -> None:
        self._bench = bench
        self.rows: NDArray[np.intp] = np.arange(bench.light.shape[0])
        if not bench.container.machine.stages:
            self.rows = compared_rows(bench.container.slots, bench.light.total_e(), COMPARED)

    def percent(self, frame: Frame) -> float:
        """Return the error of a frame, over pixels that end in the same states in both."""
        (exposure_e, valid, opened), _ = self.frame
        counted = valid & frame.valid[:, self.rows]
        if opened is not None:
            counted = counted & (opened == frame.told[OPEN])
        seen_e = frame.exposure_e[:, self.rows]
        return rms_percent(seen_e, exposure_e, counted, self._bench.signal_e())

    @cached_property
    def frame(self) -> tuple[tuple[Values, NDArray[np.bool_], Any], float]:
        """Exposure, validity and final states, and the time in milliseconds."""
        looks = self._bench.container.machine.stages > 0
        return self._bench.watch.ms(
            "reference", "all", self._looked if looks else partial(self._summed, self.rows),
            first=(lambda: None) if looks else partial(self._summed, self.rows[:1]),
        )  # fmt: skip

    def _summed(self, rows: NDArray[np.intp]) -> tuple[Values, NDArray[np.bool_], Any]:
        bench = self._bench
        reference = Reference.of(bench.container, bench.sensor, everything())
        scene = scene_of(bench.container, bench.light)
        seeds = bench.request.seed, bench.request.device_seed
        exposures = [reference.expose_rows(scene, band, *seeds) for band in bands(rows)]
        exposure_e = np.concatenate([exposure.exposure_e for exposure in exposures], axis=1)
        return exposure_e, np.concatenate([exposure.valid for exposure in exposures], axis=1), None

    def _looked(self) -> tuple[Values, NDArray[np.bool_], Any]:
        bench = self._bench
        request = Request.of(
            effects="all", fidelity="reference", seed=bench.request.seed,
            device_seed=bench.request.device_seed,
        )  # fmt: skip
        frame = simulate(bench.container, bench.light, bench.sensor, request).frame
        return frame.exposure_e, frame.valid, frame.told[OPEN]
