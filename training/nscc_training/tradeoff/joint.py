"""The joint tradeoff: for one program on one scene, the setting of each stage for a given error."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass

from nscc.columns import columns
from nscc.diagnostics.diagnostic import Diagnostic, Rejected
from nscc.experiment_store import Rows
from nscc.tradeoff.points import Point, Refused, table_text
from nscc_training.tradeoff.bench import Bench, JointRequest, StageResult, misfit
from nscc_training.tradeoff.chip_stages import compiling, effects, lowering, slots
from nscc_training.tradeoff.decoder_stage import decoding

NEAR = 1.05
"""If no setting reaches the target, settings within this factor of the least error are
candidates."""

STAGES: dict[str, tuple[str, str, Callable[[Bench], StageResult]]] = {
    "compile": ("to compile", "the chip's frame", compiling),
    "lowering": ("shortest frame of the chip", "the chip's frame", lowering),
    "slots": ("a frame of the chip", "the chip's frame", slots),
    "effects": ("to emulate a frame", "from the reference, same draws", effects),
    "decoder": ("to decode a frame", "from the scene's light", decoding),
}
"""Stages by name: what their time measures, what their error measures, and the function."""


@dataclass(frozen=True)
class Advice:
    """The fastest setting of a stage within the target, or near the least error; None if nothing
    was measured."""

    stage: str
    point: Point | None
    reached: bool


@dataclass(frozen=True)
class Joint:
    """The results of all stages: points, settings that could not be measured, and recommendations.

    Errors are root mean squares in percent of the mean signal. `target` is the requested error and
    `target_percent` its value in percent of the signal. `stages` were measured. `shot_percent` is
    the light's own shot noise. `largest` are the effects with the largest errors in the chip's
    frame."""

    program: str
    scene: str
    target: str
    stages: tuple[str, ...]
    target_percent: float
    shot_percent: float
    signal_e: float
    points: tuple[Point, ...]
    largest: tuple[tuple[str, float], ...]
    misfits: tuple[Refused, ...]
    notes: tuple[str, ...]

    @property
    def advice(self) -> tuple[Advice, ...]:
        """The recommended setting of each stage."""
        return tuple(
            advised(stage, [p for p in self.points if p.case == stage], self.target_percent)
            for stage in self.stages
        )


Progress = Callable[[Sequence[str]], Iterable[str]]
"""A function that yields the stages' names and may show progress."""


def measure(
    request: JointRequest,
    rows: Rows | None = None,
    warn: Callable[[Diagnostic], None] = lambda _: None,
    progress: Progress = iter,
) -> Joint:
    """Measure the requested stages.

    Raises Rejected for an invalid program, scene or target, before anything is timed. A setting or
    stage that cannot be measured is recorded with its reason."""
    bench = Bench(request, rows or Rows(), warn)
    target = bench.target
    points: list[Point] = []
    misfits: list[Refused] = []
    notes: list[str] = []
    for name in progress(request.stages):
        try:
            stage_result = STAGES[name][2](bench)
        except (Rejected, ModuleNotFoundError) as why:
            misfits.append(misfit(name, "", why))
            continue
        points += stage_result.points
        misfits += stage_result.misfits
        notes += [f"{name}: {note}" for note in stage_result.notes]
    return Joint(
        request.program.name, request.scene.name, request.target_error, request.stages,
        100 * target.electrons / bench.signal_e(), bench.shot_percent, bench.signal_e(),
        tuple(points), bench.largest, tuple(misfits), tuple(notes),
    )  # fmt: skip


def advised(stage: str, points: Sequence[Point], target_percent: float) -> Advice:
    """Return the recommended point of a stage."""
    if not points:
        return Advice(stage, None, reached=False)
    within = [point for point in points if point.error <= target_percent]
    least = min(point.error for point in points)
    candidates = within or [point for point in points if point.error <= NEAR * least]
    fastest = min(candidates, key=lambda point: (point.time_ms, point.error))
    return Advice(stage, fastest, reached=bool(within))


def joint_text(joint: Joint) -> str:
    """Return the recommendations as text, then all points of all stages."""
    head = (
        f"{joint.program} on {joint.scene}: {joint.target} is {joint.target_percent:.3g} % of the "
        f"mean signal, {joint.signal_e:.4g} e; the light's own noise is {joint.shot_percent:.3g} %"
    )
    rows = [("stage", "setting", "time", "error %", "time of", "error of", "")]
    for advice in joint.advice:
        time_of, error_of, _ = STAGES[advice.stage]
        if advice.point is None:
            rows.append(
                (advice.stage, "none", "", "", time_of, error_of, "not measured: see below")
            )
            continue
        point = advice.point
        setting = ", ".join(filter(None, (point.method, point.setting)))
        remark = "" if advice.reached else "above the target: the best there is"
        time_text, error = si_seconds(point.time_ms), f"{point.error:.3g}"
        rows.append((advice.stage, setting, time_text, error, time_of, error_of, remark))
    if joint.largest:
        named = ", ".join(f"{name} {percent:.3g} %" for name, percent in joint.largest)
        head += f"\nthe largest errors of the chip's frame: {named} (`nscc effects NAME` says more)"
    misfits = [
        f"{', '.join(filter(None, (refusal.case, refusal.setting)))}: {refusal.reason}"
        + (f" ({refusal.code})" if refusal.code else "")
        for refusal in joint.misfits
    ]
    points = table_text(joint.points, ("method", "setting", "error %"))
    sections = [head, columns(rows, left_aligned=(0, 1, 4, 5, 6)), points]
    return "\n\n".join(
        [*sections, *("\n".join(lines) for lines in (misfits, joint.notes) if lines)]
    )


def si_seconds(time_ms: float) -> str:
    """Return a time with three digits in a suitable unit: 2.5 us, 31 ms, 1.2 s."""
    time_ms = float(f"{time_ms:.3g}")
    steps = ((1e-3, "us", 1e3), (1.0, "ms", 1.0), (1e3, "s", 1e-3))
    unit, factor = next(
        ((unit, factor) for limit, unit, factor in reversed(steps) if time_ms >= limit), ("ns", 1e6)
    )
    return f"{time_ms * factor:.3g} {unit}"
