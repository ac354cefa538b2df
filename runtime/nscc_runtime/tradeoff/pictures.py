"""The emulator's studies as pictures."""

from __future__ import annotations

from collections.abc import Sequence

from nscc.tradeoff.points import Point, dominated
from nscc_runtime.diagram import Mark
from nscc_runtime.tradeoff.precision_diagram import Cell, Column, Curve, precision_png
from nscc_runtime.tradeoff.promise_diagram import Bar, Budget, Promise, budget_png, calibration_png
from nscc_runtime.tradeoff.study import (
    DRAWN,
    ELECTRONS,
    LSB,
    PLANNED,
    REFERENCE,
    SUMMED,
    WITH_PLANNING,
    Study,
)  # fmt: skip
from nscc_runtime.tradeoff.tables import SLACK

_NAMES = {
    SUMMED: "f32 sum",
    DRAWN: "per-slot Poisson",
    PLANNED: "planned (numbers: tolerance in e)",
    WITH_PLANNING: "with planning",
}
_UNITS = ("RMS error, electrons", "RMS error after the ADC, LSB")


def precision(studies: Sequence[Study], repeats: int, device: str) -> bytes:
    """The work-precision diagram."""
    columns = [
        Column(
            study.scene,
            (
                _cell(study, ELECTRONS, study.resolution_e),
                _cell(study, LSB, study.resolution_lsb),
            ),
        )
        for study in studies
    ]
    times = "one run" if repeats == 1 else f"median and range of {repeats} runs"
    subtitle = (
        "against the reference with all effects, same draws (hollow: dominated); "
        f"{times} on {device}"
    )
    return precision_png(columns, _UNITS, subtitle)


def _cell(study: Study, unit: str, resolution: float) -> Cell:
    beaten = dict(zip(map(id, study.points), dominated(study.points), strict=True))
    points: dict[str, list[Point]] = {}
    for point in study.points:
        if point.error_unit == unit:
            points.setdefault(point.method, []).append(point)
    curves = tuple(
        Curve(name, tuple(_mark(p, beaten[id(p)]) for p in points[method]), method == WITH_PLANNING)
        for method, name in _NAMES.items()
        if method in points
    )
    return Cell(curves, _mark(points[REFERENCE][0], False), resolution, study.floor_ms / 1e3)


def _mark(point: Point, beaten: bool) -> Mark:
    text = point.setting.removesuffix("e") if point.method == PLANNED else ""
    return Mark(
        point.time_ms / 1e3, min(point.times_ms) / 1e3, max(point.times_ms) / 1e3, point.error,
        text, beaten,
    )  # fmt: skip


def calibration(studies: Sequence[Study]) -> bytes:
    """Tolerance asked against error measured."""
    return calibration_png(
        [
            Promise(study.scene, each.tolerance_e, each.plan.predicted_e, each.measured_e)
            for study in studies
            for each in study.asked
        ],
        SLACK,
    )


def budgets(studies: Sequence[Study]) -> bytes:
    """What each effect does, scene by scene; the readout's belong to no budget."""
    return budget_png(
        [
            Budget(
                study.scene,
                study.budget.tolerance_e,
                study.budget.predicted_e,
                tuple(
                    Bar(each.name, each.decision, each.predicted_rms_e, each.cost_ms_model)
                    for each in study.budget.decisions
                    if each.kind != "after"
                ),
            )
            for study in studies
        ]
    )
