"""The joint tradeoff: for one program on one scene, the setting of each stage for a given error."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from nscc.columns import columns
from nscc.diagnostics.diagnostic import Diagnostic, Rejected
from nscc.lower.resources import time_text
from nscc_runtime.pictures.precision import Guide, Panel, Point, PointReading, precision_diagram
from nscc_training.command_settings import JointRequest
from nscc_training.experiments.study import NotMeasured, Study, StudyPoint, StudyResult
from nscc_training.experiments.study_table import refusals_text, table_text
from nscc_training.tradeoff.joint_bench import Bench
from nscc_training.tradeoff.joint_stages import (
    compiling,
    decoding,
    effects,
    lowering,
    refused,
    slots,
)

if TYPE_CHECKING:
    from matplotlib.figure import Figure

NEAR = 1.05
"""If no setting reaches the target, settings within this factor of the least error are
candidates."""

_STAGES: dict[str, tuple[str, str, Callable[[Bench], Iterator[StudyPoint]]]] = {
    "compile": ("to compile", "the chip's frame", compiling),
    "lowering": ("shortest frame of the chip", "the chip's frame", lowering),
    "slots": ("a frame of the chip", "the chip's frame", slots),
    "effects": ("to emulate a frame", "from the reference, same draws", effects),
    "decoder": ("to decode a frame", "from the scene's light", decoding),
}
"""Stages by name: what their time measures, what their error measures, and their points."""


class Joint(NamedTuple):
    """A request, and figures of its program and scene that texts and diagrams need.

    Errors are root mean squares in percent of the mean signal `signal_e`, as `target_percent`, the
    requested error, and `shot_percent`, the light's own shot noise. `largest` are the effects with
    the largest errors in the chip's frame. `notes` are remarks on the numbers of stages."""

    request: JointRequest
    target_percent: float
    shot_percent: float
    signal_e: float
    largest: tuple[tuple[str, float], ...] = ()
    notes: tuple[str, ...] = ()

    def advice(self, points: Sequence[Point]) -> dict[str, tuple[Point | None, bool]]:
        """Return the recommendation for each stage of nscc (compile, lowering, slots, effects,
        decoder) by name: the recommended one of `points`, None if the stage has no point, and
        whether its error reaches the target. A lowering is a way to compute the exposure."""
        return {
            stage: advised([p for p in points if p.case == stage], self.target_percent)
            for stage in self.request.stages
        }


def joint_study(
    request: JointRequest, warn: Callable[[Diagnostic], None] = lambda _: None
) -> Study:
    """Return the study of time against error of the stages that `request` names: compile, lowering
    (a way to compute the exposure), slots, effects, decoder. Messages about program and scene are
    passed to `warn`.

    Raises Rejected for an invalid program, scene or target. A setting or stage that cannot be
    measured is recorded with its reason."""
    bench = Bench(request, warn)
    target_percent = 100 * bench.target.electrons / bench.signal_e()
    points = [point for name in request.stages for point in _points(name, bench)]
    joint = Joint(
        request,
        target_percent,
        bench.shot_percent,
        bench.signal_e(),
        bench.largest,
        tuple(bench.notes),
    )
    text, diagram = partial(joint_text, joint), partial(joint_diagram, joint)
    return Study(points, text, {"png": diagram}, request.repeats, refuses=("NS",))


def _points(stage: str, bench: Bench) -> list[StudyPoint]:
    """Return the points of one stage. If the stage cannot be measured, return one point that is
    refused with the reason."""
    try:
        return list(_STAGES[stage][2](bench))
    except (Rejected, NotMeasured, ModuleNotFoundError) as why:
        return [refused(stage, "", why)]


def advised(points: Sequence[Point], target_percent: float) -> tuple[Point | None, bool]:
    """Return the recommended point, and whether it reaches the target; None and False without
    points.

    It is the fastest point whose error is at most `target_percent`. If there is none, it is the
    fastest of those whose error is at most `NEAR` times the least. Of equal times, the smaller
    error counts."""
    if not points:
        return None, False
    within = [point for point in points if point.error <= target_percent]
    least = min(point.error for point in points)
    candidates = within or [point for point in points if point.error <= NEAR * least]
    return min(candidates, key=lambda point: (point.time_ms, point.error)), bool(within)


def joint_text(joint: Joint, measured: StudyResult) -> str:
    """Return the recommendations as text, then all measured points of all stages, what was refused,
    and notes."""
    request = joint.request
    head = (
        f"{request.program.name} on {request.scene.name}: {request.target_error} is "
        f"{joint.target_percent:.3g} % of the "
        f"mean signal, {joint.signal_e:.4g} e; the light's own noise is {joint.shot_percent:.3g} %"
    )
    rows = [("stage", "setting", "time", "error %", "time of", "error of", "")]
    for stage, (point, reached) in joint.advice(measured.points).items():
        time_of, error_of, _ = _STAGES[stage]
        if point is None:
            rows.append((stage, "none", "", "", time_of, error_of, "not measured: see below"))
            continue
        setting = ", ".join(filter(None, (point.method, point.setting)))
        remark = "" if reached else "above the target: the best there is"
        figures = si_seconds(point.time_ms), f"{point.error:.3g}"
        rows.append((stage, setting, *figures, time_of, error_of, remark))
    if joint.largest:
        named = ", ".join(f"{name} {percent:.3g} %" for name, percent in joint.largest)
        head += f"\nthe largest errors of the chip's frame: {named} (`nscc effects NAME` says more)"
    misfits = refusals_text(measured.refused)
    points = table_text(measured.points, ("method", "setting", "error %"))
    sections = [head, columns(rows, left_aligned=(0, 1, 4, 5, 6)), points]
    return "\n\n".join(
        [*sections, *("\n".join(lines) for lines in (misfits, joint.notes) if lines)]
    )


def si_seconds(time_ms: float) -> str:
    """Return a time in milliseconds (0 or more) as text with three digits in a suitable unit: 2.5
    us, 31 ms, 1.2 s. Times below 1 us are in ns."""
    return time_text(float(f"{1e3 * time_ms:.3g}"))


def joint_diagram(joint: Joint, measured: StudyResult, device: str) -> Figure:
    """Draw error against time for the points of all stages, a line for each stage, and mark the
    recommended points. `device` is named in the note."""
    advice = {
        stage: point
        for stage, (point, _) in joint.advice(measured.points).items()
        if point is not None
    }
    names = {
        stage: f"{stage}: {', '.join(filter(None, (point.method, point.setting)))}"
        for stage, point in advice.items()
    }
    request = joint.request
    guides = (
        Guide(f"target, {request.target_error}", "--", error=joint.target_percent),
        Guide("the light's own noise", ":", error=joint.shot_percent),
    )
    stages = request.stages
    points = sorted(measured.points, key=lambda point: (stages.index(point.case), point.time_ms))
    times = measured.times.replace("median and range", "medians")
    return precision_diagram(
        [Panel("", "RMS error, % of the mean signal", points, guides)],
        f"{request.program.name} on {Path(request.scene.name).name}: what each stage's time buys",
        "compile, lowering, slots: the chip's frame against the light that fell; effects: against "
        "the reference; decoder: against the scene's light (names: the advised setting; hollow: "
        f"dominated within its stage; pointing down: no error); {times} on {device}",
        PointReading(
            "time, s",
            1e-3,
            lambda point: names[point.case],
            lambda point: "advised" if point is advice.get(point.case) else "",
        ),
    )
