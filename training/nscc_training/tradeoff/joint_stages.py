"""Stages of the joint tradeoff: words (compile levels, lowerings, slots), and the emulation."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import cache, partial

import numpy as np

from nscc.arrays import Ints32
from nscc.diagnostics.diagnostic import Rejected
from nscc.lower.exposure_plan import LOWERINGS
from nscc.pipeline import KINDS, Compiled
from nscc.source import Source
from nscc.words.container import Container
from nscc_runtime.effects import everything, selected
from nscc_runtime.effects.effect import MOST_E
from nscc_runtime.planless import refuse_planless
from nscc_runtime.planning.audit import audit
from nscc_runtime.planning.make import make_plan
from nscc_runtime.planning.plan import Plan
from nscc_runtime.planning.plan_request import PlanRequest
from nscc_runtime.planning.planned_scene import PlannedScene, planning_of
from nscc_runtime.planning.tolerance import LEAST_E
from nscc_runtime.reference.capture import Reference, reference_scene
from nscc_training.experiments.engine import Figures
from nscc_training.experiments.stopwatch import timed_ms
from nscc_training.experiments.study import NotMeasured, StudyPoint
from nscc_training.sweep.point_programs import whole_ticks
from nscc_training.tradeoff.emulator import unknown
from nscc_training.tradeoff.joint_bench import PERCENT, Bench, scaled_text
from nscc_training.tradeoff.slots import in_fewer, with_slot_us

JOINED = {1: "all", 2: "halves", 4: "quarters"}
"""Names of programs in which this many neighbouring slots are joined into one."""
LENGTHS = (0.25, 0.5, 1.0, 2.0)
"""Frame lengths relative to the program's own."""
PARTS = (0.1, 0.3, 1.0, 3.0)
"""Tolerances of plans, as fractions of the target error."""
COMPARED = 1 << 20
"""Most slots times pixels that the reference simulates."""


def refused(stage: str, setting: str, why: Exception) -> StudyPoint:
    """Return a point that raises `why` instead of measuring, so that the table lists its reason. A
    `setting` of "" stands for the whole stage."""

    def refuse() -> Figures:
        """Raise the error that prevents the point."""
        raise why

    return StudyPoint(stage, "", setting, refuse)


def compiling(bench: Bench) -> Iterator[StudyPoint]:
    """Yield a point of the study for each optimisation level of the request. Its time is that of
    compiling, from text to proof and without the cache. Its error, in percent, is that of the
    compiled program's frame."""

    def figures(level: int, compiled: Compiled) -> Figures:
        """Return error, lowering (a way to compute the exposure) and number of words of the
        program, compiled at this level."""
        container = bench.with_codes(compiled)
        return {
            PERCENT: bench.error_percent(container),
            "method": container.notes.get("lowering", ""),
            "setting": f"-O{level} ({container.words_per_frame} words)",
        }

    for level in bench.request.levels:
        run = partial(bench.compiled, bench.source, level=level)
        yield StudyPoint("compile", "", f"-O{level}", run, partial(figures, level))


def lowering(bench: Bench) -> Iterator[StudyPoint]:
    """Yield a point for each lowering, the way in which the exposure is computed from photodiode
    values (accumulate, latch, edges). Its time is that of the shortest frame that the words allow.

    Raise NotMeasured if the program has only one lowering."""
    source, subject = bench.source, KINDS.of(bench.container).one_lowering_for
    if subject:
        raise NotMeasured(f"there is one way for {subject}")

    def measured(name: str) -> Figures:
        """Return the error, the time of the shortest frame in ms, and the number of words of the
        program with the lowering `name`. A lowering is a way to compute the exposure."""
        compiled = bench.compiled(source, lowering=name)
        container = bench.with_codes(compiled)
        return {
            PERCENT: bench.error_percent(container),
            "ms": [compiled.shortest_slot_us * container.slots / 1e3],
            "setting": f"{container.words_per_frame} words",
        }

    for name in LOWERINGS:
        yield StudyPoint("lowering", name, "", partial(measured, name))


def slots(bench: Bench) -> Iterator[StudyPoint]:
    """Yield a point for each frame length with the program's own slots, and with fewer slots. The
    shortest length is the one that the words allow.

    The scene has the same brightness in all cases, so that a shorter frame receives less light. A
    program with fewer slots opens a pixel in a joined slot if the original is open for at least
    half of it. Its error is measured from the ideal frame of the original with the same frame
    length."""
    text, original = bench.source, bench.container
    frame_us = sum(original.slot_us)
    for join, name in JOINED.items():
        count, setting = original.slots // join, name
        try:
            source, codes = in_fewer(original, join, text) if join > 1 else (text, None)
            setting = f"{count} slots"
            least_us = whole_ticks(bench.compiled(source).shortest_slot_us) * count
        except (NotMeasured, Rejected) as why:
            yield refused("slots", setting, why)
            continue
        lengths_us = (frame_us * length for length in LENGTHS if frame_us * length >= least_us)
        for whole_us in dict.fromkeys((least_us, *lengths_us)):
            timed = replace(
                original, slot_us=tuple(us / frame_us * whole_us for us in original.slot_us)
            )
            slot_us = np.array(timed.slot_us).reshape(-1, join).sum(axis=1).tolist()
            uneven = not np.allclose(slot_us, slot_us[0])
            setting = f"{whole_us / count:.5g} us" + " in the mean" * uneven
            run = partial(_joined, bench, with_slot_us(source, slot_us), codes, timed)
            yield StudyPoint("slots", f"{count} slots", setting, run)


def _joined(
    bench: Bench, source: Source, codes: dict[str, Ints32] | None, timed: Container
) -> Figures:
    """Return the error of the program `source` and the time of its frame in ms.

    `codes` are those of its pixels, None for the program's own. `timed` is the original with the
    same frame length, which gives the ideal frame."""
    container = bench.with_codes(bench.compiled(source), codes)
    return {PERCENT: bench.error_percent(container, timed), "ms": [sum(timed.slot_us) / 1e3]}


def effects(bench: Bench) -> Iterator[StudyPoint]:
    """Yield points for plans of several tolerances, for all effects, and for the reference. Their
    time is that of emulating a frame.

    Errors are those of the audit: differences from all effects with the same random numbers. Raises
    Rejected (NS0750) for a program without plans, whose simulation has no approximations."""
    container, request = bench.container, bench.request
    refuse_planless(container, "comparing tolerances")
    height, cols = bench.light.shape
    # The reference is slow, so it runs only as many rows as a fixed amount of work allows.
    rows = range(min(height, max(1, COMPARED // (container.slots * cols))))
    if len(rows) < height:
        bench.notes.append(
            f"effects: the reference ran {len(rows)} of {height} rows: its time is theirs scaled "
            "to all"
        )
    ways = [("auto", tolerance) for tolerance in _tolerances(bench)]
    ways.append(("all", scaled_text(request.target_error, 1.0)))

    def planning() -> PlannedScene:
        """Return the scene for a plan (the effects that are simulated). Its light has no stored
        sums, because computing them is part of the frame's time."""
        light = unknown(bench.light)
        return planning_of(container, bench.sensor, light, request.device_seed)

    def made_plan(scene: PlannedScene, chosen: str, tolerance: str) -> Plan:
        """Make the plan for `chosen` effects ("auto" or "all") and a tolerance."""
        return make_plan(scene, PlanRequest(selected(chosen), tolerance))

    plans = {way: cache(partial(made_plan, planning(), *way)) for way in ways}

    def planned(way: tuple[str, str]) -> None:
        """Expose a frame with a plan that exists before the time is measured. `way` is the choice
        of effects and the tolerance."""
        next(iter(planning().frames(plans[way]().kept, request.seed, 1)))

    def with_planning(way: tuple[str, str]) -> None:
        """Make a plan and expose a frame with it. `way` is the choice of effects and the
        tolerance."""
        scene = planning()
        next(iter(scene.frames(made_plan(scene, *way).kept, request.seed, 1)))

    scene = planning_of(container, bench.sensor, bench.light, request.device_seed)
    scene.ready()

    @cache
    def percent(way: tuple[str, str]) -> float:
        """Return the measured error of the plan for a choice of effects and a tolerance, in percent
        of the signal."""
        return 100.0 * audit(scene, plans[way]()).measured_rms_e / bench.signal_e()

    def figures(way: tuple[str, str], _exposed: None) -> Figures:
        """Return the error of the plan for a choice of effects and a tolerance, by name."""
        return {PERCENT: percent(way)}

    for method, run in (("with planning", with_planning), ("planned", planned)):
        for way in ways:
            measured = partial(figures, way)
            yield StudyPoint(
                "effects", method, " ".join(way), partial(run, way), measured, loads=way
            )
    yield StudyPoint("effects", "reference", "all", partial(_reference, bench, rows))


def _reference(bench: Bench, rows: range) -> Figures:
    """Return the figures of the reference: no error, and the time of a frame, estimated from the
    time of some `rows`."""
    reference = Reference.of(bench.container, bench.sensor, everything())
    scene, planes = reference_scene(bench.container, bench.light), bench.container.planes()
    seeds = bench.request.seed, bench.request.device_seed
    run = partial(reference.execute, scene, planes, seeds, 0, rows)
    run()
    ms = timed_ms(run)[1] * bench.light.shape[0] / len(rows)
    return {PERCENT: 0.0, "ms": [ms]}


def _tolerances(bench: Bench) -> list[str]:
    """Return the fractions `PARTS` of the target error as texts of tolerances. A tolerance outside
    the allowed range is replaced by the nearest limit, which a note of `bench` says."""
    target = bench.target
    tolerances = dict[str, None]()
    for share in PARTS:
        tolerance = scaled_text(bench.request.target_error, share)
        electrons = share * target.electrons
        nearest = min(max(electrons, LEAST_E), MOST_E)
        if nearest != electrons:
            text = f"effects: no plan is made for {tolerance}: {nearest:g}e stands for it"
            bench.notes.append(text)
            tolerance = f"{nearest:g}e"
        tolerances[tolerance] = None
    return [*tolerances]
