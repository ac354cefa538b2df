"""The study of `nscc tradeoff emulator`: its points, tables, diagrams and promises."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from nscc.columns import columns
from nscc.mappings import NamedValues
from nscc_runtime.execution.program import AnalysedProgram
from nscc_runtime.pictures import sheet
from nscc_runtime.pictures.labels import ChartLabel, halo, place_labels
from nscc_runtime.pictures.precision import (
    Guide,
    Panel,
    Point,
    PointReading,
    dominated,
    precision_diagram,
)
from nscc_runtime.pictures.sheet import theme
from nscc_runtime.planning.audit import SLACK
from nscc_runtime.planning.plan import Decision, Plan
from nscc_training.command_settings import EmulatorStudySettings
from nscc_training.experiments.study import Study, StudyResult
from nscc_training.experiments.study_table import three_digits
from nscc_training.tradeoff.emulator import (
    DRAWN,
    ELECTRONS,
    LSB,
    PLANNED,
    REFERENCE,
    SUMMED,
    WITH_PLANNING,
    EmulatorBench,
    EmulatorStudy,
    MeasuredPlan,
    NamedLight,
    copy_gb_per_s,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


class EmulatorBenches(NamedTuple):
    """The methods on all scenes of a study, one of `benches` for each scene, and the speed of
    memory copies in GB/s."""

    benches: tuple[EmulatorBench, ...]
    gb_per_s: float

    @classmethod
    def of(
        cls, program: AnalysedProgram, scenes: Sequence[NamedLight], settings: EmulatorStudySettings
    ) -> EmulatorBenches:
        """Prepare the study of a program on scenes, whose names must differ, and measure the speed
        of memory.

        The time of analysing the program is not included in times. There is at least one scene.
        Raises ValueError for less than 2 frames or less than 1 repeat."""
        if settings.frames < 2 or settings.repeats < 1:
            raise ValueError(f"{settings.frames} frames, {settings.repeats} repeats")
        benches = tuple(EmulatorBench(program, scene, settings) for scene in scenes)
        return cls(benches, copy_gb_per_s())

    def study(self) -> Study:
        """Return the study: its points, tables and diagrams. Raise Rejected (NS0746) for an invalid
        tolerance."""
        return Study(
            [point for bench in self.benches for point in bench.points()],
            lambda measured: studies_text(self.results(measured), self.gb_per_s),
            {
                "png": lambda measured, device: study_diagram(
                    self.results(measured), measured.times, device
                ),
                "calibration": lambda measured, _device: promise_diagram(self.results(measured)),
                "budget": lambda measured, _device: budget_diagram(self.results(measured)),
            },
            self.benches[0].settings.repeats,
            csv_of=self._in_order,
        )

    def results(self, measured: StudyResult) -> tuple[EmulatorStudy, ...]:
        """Return the results of each scene among all that were measured, in the order of the
        scenes."""
        return tuple(bench.result(measured, self.gb_per_s) for bench in self.benches)

    def keep_promises(self, measured: StudyResult) -> bool:
        """Return whether no plan (the effects that are simulated) has a measured error above its
        tolerance, with the slack of `keeps_promise`."""
        results = self.results(measured)
        return all(plan.keeps_promise for scene in results for plan in scene.measured_plans)

    def _in_order(self, points: Sequence[Point]) -> list[Point]:
        """Return the points scene by scene, for the CSV file."""
        results = self.results(StudyResult(tuple(points)))
        return [point for scene in results for point in scene.points]


_HEAD = ("method", "setting", "predicted e", "error e", "error LSB", "ms", "spread", "")
_BUDGET_HEAD = ("effect", "", "RMS e", "bias e", "left out e", "saves ms", "why")


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
    if measured_plan.in_electrons:
        return measured_plan.setting
    return f"{measured_plan.setting}, {measured_plan.tolerance_e:.3g}e"


def _remark(point: Point, measured_plan: MeasuredPlan | None, beaten: bool) -> str:
    """Return the remark on a point: that its plan broke its promise (the measured error is too
    large), or that another point is better in error and time; else "".

    `beaten` says whether another point is better. `measured_plan` is None for methods without a
    plan (the effects that are simulated)."""
    if measured_plan is not None and not measured_plan.keeps_promise:
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


_LOWEST = 30.0
"""Errors below the smallest tolerance over this factor are drawn at the edge, with number."""
_SIDE = 6.2
"""Width and height of the diagram of promises in inches."""
_BAR = 0.2
"""Inches between bars."""
_COLUMNS = 3
"""Most panels beside each other."""

_NAMES = {
    SUMMED: "f32 sum",
    DRAWN: "per-slot Poisson",
    PLANNED: "planned",
    WITH_PLANNING: "with planning",
}
_ERRORS = {ELECTRONS: "RMS error, e", LSB: "RMS error after the ADC, LSB"}


def study_diagram(studies: Sequence[EmulatorStudy], times: str, device: str) -> Figure:
    """Draw error against time: for each of `studies` one panel with the error in electrons and one
    in LSB. `times` and `device` are named in its note."""
    panels = []
    for study in studies:
        for unit, error in _ERRORS.items():
            points = [point for point in study.points if point.error_unit == unit]
            [truth] = [point for point in points if point.method == REFERENCE]
            guides = (
                Guide("reference (no error)", "-", time_ms=truth.time_ms),
                Guide("two references, other draws", "--", error=study.resolution(unit)),
                Guide("reading the scene", ":", time_ms=study.floor_ms),
            )
            panels.append(Panel(study.scene, error, points, guides))
    # If all tolerances are in electrons, the unit is named once, in the note.
    plain = all(
        measured_plan.in_electrons for study in studies for measured_plan in study.measured_plans
    )
    unit = " in e" if plain else ""
    return precision_diagram(
        panels,
        "What the emulator's time buys",
        "against the reference with all effects, same draws (hollow: dominated; beside the marks: "
        f"tolerance{unit}); {times} on {device}",
        PointReading(
            "time of one frame, ms",
            line=lambda point: _NAMES.get(point.method, ""),
            text=lambda p: (
                p.setting.removesuffix("e" if unit else "") if p.method == PLANNED else ""
            ),
        ),
    )


def promise_diagram(studies: Sequence[EmulatorStudy]) -> Figure:
    """Draw the predicted and measured errors of all plans in `studies` against their tolerance, all
    in RMS electrons on logarithmic axes.

    Each scene has a colour. A line joins the two errors of a plan: a large hollow mark is the
    prediction, a small full mark the measurement. Errors too small for the axis are drawn at its
    lower end, with the measured value as text. Raise ValueError without plans (choices of the
    effects that are simulated)."""
    from matplotlib.lines import Line2D

    plans = [
        (
            study.scene,
            measured_plan.tolerance_e,
            measured_plan.predicted_e,
            measured_plan.measured_e,
        )
        for study in studies
        for measured_plan in study.measured_plans
    ]
    if not plans:
        raise ValueError("there are no plans to draw: no study measured one")
    tolerances_e = np.array([tolerance_e for _, tolerance_e, _, _ in plans])
    errors = np.array([rms_errors for _, _, *rms_errors in plans])
    least, most = tolerances_e.min() / 1.5, tolerances_e.max() * 1.5
    # The axis ends below the smallest error that is worth showing, and above the largest finite
    # one.
    low = errors[errors > least / _LOWEST].min(initial=least) / 1.5
    high = 1.2 * errors[errors < math.inf].max(initial=most)
    figure, [axes] = sheet.panels(1, (_SIDE, _SIDE), 1)
    axes.set(xscale="log", yscale="log", xlim=(least, most), ylim=(low, high))
    axes.set(xlabel="tolerance asked, e", ylabel="error, e")
    line, above = [least, most], [SLACK * least, SLACK * most]
    # Shaded: the plan broke its promise, since its error exceeds the tolerance with its slack.
    axes.fill_between(line, above, high, color=theme().closed)
    axes.plot(line, line, color=theme().ink)
    axes.plot(line, above, color=theme().ink, linestyle="--")
    scenes = list(dict.fromkeys(scene for scene, *_ in plans))
    labels = []
    for (scene, *_, measured), x, ends in zip(
        plans, tolerances_e, errors.clip(low, high), strict=True
    ):
        number = scenes.index(scene)
        # Shift scenes sideways, so that marks do not overlap.
        x *= 1.05 ** (number - (len(scenes) - 1) / 2)
        style = theme().of(number)
        axes.plot([x, x], ends, color=style["color"], linewidth=1)
        axes.plot(x, ends[0], markersize=9, fillstyle="none", clip_on=False, **style)
        axes.plot(x, ends[1], markersize=4, clip_on=False, **style)
        if measured < low:
            labels.append(ChartLabel(f"{measured:.1g}", x, ends[1], style["color"]))
    sheet.round_ticks(axes.xaxis)
    sheet.round_ticks(axes.yaxis)
    dot: NamedValues = {"color": theme().faint, "linestyle": "", "marker": "o"}
    sheet.head(
        figure,
        "What was asked, what came of it",
        "RMS electrons before the ADC, worst bucket",
        [
            Line2D([], [], color=theme().ink, label="y = x"),
            Line2D([], [], color=theme().ink, ls="--", label=f"y = {SLACK:g} x: the promise"),
            Line2D([], [], markersize=4, label="measured", **dot),
            Line2D([], [], markersize=9, fillstyle="none", label="predicted", **dot),
            *(Line2D([], [], ls="", label=s, **theme().of(i)) for i, s in enumerate(scenes)),
        ],
    )
    place_labels(axes, labels)
    return figure


def budget_diagram(studies: Sequence[EmulatorStudy]) -> Figure:
    """Draw, for each scene, the size of its effects, and the time that leaving each one out saves.

    Effects of the readout are excluded. Raises ValueError without scenes."""
    from matplotlib.lines import Line2D
    from matplotlib.patches import Patch

    if not studies:
        raise ValueError("there are no budgets to draw: the list of studies is empty")
    kept_colour, dropped_colour, *_ = theme().series
    budgets = [study.budget for study in studies]
    values = [decision.predicted_rms_e for plan in budgets for decision in plan.decisions]
    known = [e for e in (*values, *(plan.tolerance_e for plan in budgets)) if e]
    # All panels share one range of errors, at most six decades.
    span = (max(min(known), max(known) * 1e-6) / 2, max(known) * 2)
    bars = max(len(_decisions(plan)) for plan in budgets)
    figure, grid = sheet.panels(len(studies), (sheet.WIDTH / _COLUMNS, _BAR * bars + 0.8), _COLUMNS)
    for axes, study in zip(grid, studies, strict=True):
        _draw_budget(axes, study.budget, span)
        axes.set_title(study.scene)
    sheet.head(
        figure,
        "Error budgets: what each effect does, and what is left out",
        "RMS electrons of each effect; at the right, ms a frame that leaving it out saves (model)",
        [
            Patch(facecolor=kept_colour, edgecolor=kept_colour, label="simulated"),
            Patch(facecolor=theme().paper, edgecolor=dropped_colour, label="left out"),
            Line2D([], [], color=theme().ink, label="tolerance asked"),
            Line2D([], [], color=theme().ink, linestyle="--", label="predicted error"),
        ],
    )
    return figure


def _decisions(plan: Plan) -> list[Decision]:
    """Return the decisions of a plan on effects during the exposure. Effects of the readout
    ("after") are always simulated."""
    return [decision for decision in plan.decisions if decision.kind != "after"]


def _draw_budget(axes: Axes, plan: Plan, span: tuple[float, float]) -> None:
    """Draw into `axes` the error of each effect as a bar, filled if it is simulated, with tolerance
    and predicted error as lines.

    `span` is the range of the axis in electrons. Effects that change nothing in this scene are
    marked as absent."""
    decisions = _decisions(plan)
    kept_colour, dropped_colour, *_ = theme().series
    colours = {"kept": kept_colour, "dropped": dropped_colour, "absent": theme().faint}
    axes.set(xscale="log", xlim=span, ylim=(len(decisions) - 0.4, -0.6))
    tolerance_e, predicted_e = plan.tolerance_e or 0.0, plan.predicted_e or 0.0
    axes.set_xlabel(f"RMS, e; {tolerance_e:g} asked, {predicted_e:.3g} predicted")
    axes.grid(False, axis="y")
    sheet.round_ticks(axes.xaxis, most=4)
    costs = axes.secondary_yaxis("right")
    costs.spines[:].set_visible(False)
    for i, decision in enumerate(decisions):
        rms_e, colour = decision.predicted_rms_e, colours[decision.decision]
        if decision.decision == "absent":
            axes.text(
                span[0],
                i,
                " absent",
                size=7.5,
                color=colour,
                va="center",
                style="italic",
                path_effects=halo(),
            )
        # Effects that are left out have hollow bars.
        elif rms_e is not None and rms_e > span[0]:
            face = colour if decision.decision == "kept" else theme().paper
            axes.barh(i, rms_e - span[0], 0.62, span[0], facecolor=face, edgecolor=colour)
    axes.axvline(tolerance_e, color=theme().ink)
    axes.axvline(predicted_e, color=theme().ink, linestyle="--")
    axes.set_yticks(range(len(decisions)), [decision.name for decision in decisions])
    costs.set_yticks(range(len(decisions)), [_saves(decision) for decision in decisions])
    for side in (axes, costs):
        side.tick_params(axis="y", length=0)
        for label, decision in zip(side.get_yticklabels(), decisions, strict=True):
            drawn = side is axes and decision.decision != "absent"
            label.set_color(theme().ink if drawn else colours[decision.decision])


def _saves(decision: Decision) -> str:
    """Return the time that leaving an effect out saves, as text in ms; "free" if it saves none, ""
    for an effect that is absent."""
    if decision.decision == "absent":
        return ""
    return f"{float(f'{decision.cost_ms_model:.2g}'):g} ms" if decision.cost_ms_model else "free"
