"""The emulator's studies as text: errors and times, then the error budget of each scene."""

from __future__ import annotations

from collections.abc import Sequence

from nscc.columns import columns
from nscc_runtime.pictures.precision import Point, dominated
from nscc_runtime.planning.plan import Decision, Plan
from nscc_training.experiments.study_table import three_digits
from nscc_training.tradeoff.emulator import (
    ELECTRONS,
    LSB,
    PLANNED,
    REFERENCE,
    WITH_PLANNING,
    EmulatorStudy,
    MeasuredPlan,
)

SLACK = 1.1
"""Largest ratio of measured error to tolerance for which a plan keeps its promise."""

_HEAD = ("method", "setting", "predicted e", "error e", "error LSB", "ms", "spread", "")
_BUDGET_HEAD = ("effect", "", "RMS e", "bias e", "left out e", "saves ms", "why")


def keeps_promise(measured_plan: MeasuredPlan) -> bool:
    """Return whether the measured error is at most `SLACK` times the tolerance, both in electrons.
    NaN keeps no promise."""
    return measured_plan.measured_e <= SLACK * measured_plan.tolerance_e


def studies_text(studies: Sequence[EmulatorStudy], gb_per_s: float) -> str:
    """Return all tables as text: for each of `studies` the methods, then the plan (the effects that
    are simulated) for its error budget.

    `gb_per_s` is the speed of memory copies, which the first line says."""
    tables = [f"memory copies at {gb_per_s:.3g} GB/s, read and written"]
    for study in studies:
        tables += [_methods_text(study), _budget_text(study.budget)]
    return "\n\n".join(tables)


def _methods_text(study: EmulatorStudy) -> str:
    """Return the table of methods with predicted and measured errors (electrons, LSB) and times
    (ms), and a line for each method that could not be measured."""
    plans_by_setting = {
        measured_plan.setting: measured_plan for measured_plan in study.measured_plans
    }
    electrons = [p for p in study.points if p.error_unit == ELECTRONS]
    lsb = {(p.method, p.setting): p.error for p in study.points if p.error_unit != ELECTRONS}
    beaten = dict(zip(map(id, study.points), dominated(study.points), strict=True))
    rows = [_HEAD]
    # The name of a method stands in the first of its rows only.
    before = ""
    for point in electrons:
        mine = plans_by_setting.get(point.setting) if point.method == PLANNED else None
        rows.append(
            (
                point.method if point.method != before else "",
                point.setting if mine is None else _setting(mine),
                "" if mine is None else f"{mine.predicted_e:.3g}",
                f"{point.error:.3g}",
                f"{lsb[point.method, point.setting]:.3g}",
                three_digits(point.time_ms),
                three_digits(point.spread_ms),
                _remark(point, mine, beaten[id(point)]),
            )
        )
        before = point.method
    head = (
        f"{study.scene}: two frames of the reference with other draws are "
        f"{study.resolution(ELECTRONS):.3g} e, {study.resolution(LSB):.3g} LSB apart; to read the "
        f"scene once takes {three_digits(study.floor_ms)} ms"
    )
    missing = [f"no {refusal.method}: {refusal.reason}" for refusal in study.refused]
    return "\n".join([head, columns(rows, (0, 1, 7), "  "), *missing])


def _setting(measured_plan: MeasuredPlan) -> str:
    """Return the tolerance of a plan (the effects that are simulated) as text. If it is not in
    electrons (such as 1% or 0.1lsb), its value in electrons follows."""
    plain = measured_plan.plan.allowed is None or measured_plan.plan.allowed.in_electrons
    if plain:
        return measured_plan.setting
    return f"{measured_plan.setting}, {measured_plan.tolerance_e:.3g}e"


def _remark(point: Point, measured_plan: MeasuredPlan | None, beaten: bool) -> str:
    """Return the remark on a point: that its plan broke its promise (the measured error is too
    large), or that another point is better in error and time; else "".

    `beaten` says whether another point is better. `measured_plan` is None for methods without a
    plan (the effects that are simulated)."""
    if measured_plan is not None and not keeps_promise(measured_plan):
        return f"PROMISE BROKEN: {SLACK:g} x {measured_plan.tolerance_e:g} e"
    # Planning time is expected, so it is not marked.
    return "dominated" if beaten and point.method not in (REFERENCE, WITH_PLANNING) else ""


def _budget_text(plan: Plan) -> str:
    """Return the table of effects in a plan, with the decision on each and its reason."""
    rows = [_BUDGET_HEAD, *(_decision(decision) for decision in plan.decisions)]
    head = f"error budget of {plan.tolerance_e:g} e: {plan.predicted_e:.3g} e predicted"
    words = [f"words one by one: {reason}" for reason in plan.slot_loop_reasons]
    return "\n".join([head, columns(rows, (0, 1, 6), "  "), *words, plan.time_summary])


def _decision(decision: Decision) -> tuple[str, ...]:
    """Return the row of one effect in the table of an error budget."""

    def number(value: float | None) -> str:
        """Return a number as text; "" without a value, and for effects that are absent."""
        return "" if value is None or decision.decision == "absent" else f"{value:.3g}"

    saves = "" if decision.decision == "absent" else three_digits(decision.cost_ms_model)
    return (
        decision.name,
        decision.decision,
        number(decision.predicted_rms_e),
        number(decision.predicted_bias_e),
        number(decision.predicted_if_dropped_e),
        saves,
        decision.reason,
    )
