"""The emulation stage: error against the reference for plans of several tolerances."""

from __future__ import annotations

from functools import cached_property, partial
from time import perf_counter
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.tradeoff.points import Point
from nscc_runtime.effects import everything, selected
from nscc_runtime.effects.parameters import MOST_E
from nscc_runtime.frame_file import Frame
from nscc_runtime.looked_light import OPEN
from nscc_runtime.planless import refuse_planless
from nscc_runtime.planning.audit import bands, compared_rows
from nscc_runtime.planning.make import PlanRequest, make_plan
from nscc_runtime.planning.scenes import planning_of
from nscc_runtime.planning.tolerance import LEAST_E
from nscc_runtime.reference.capture import Reference, scene_of
from nscc_runtime.simulate import Request, simulate
from nscc_runtime.tradeoff.study import unknown
from nscc_training.tradeoff.bench import PERCENT, Bench, StageResult, rms_percent, scaled_text

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
        if bench.container.machine is None:
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
        looks = self._bench.container.machine is not None
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
