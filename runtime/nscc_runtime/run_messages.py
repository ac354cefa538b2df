"""Texts about a run: summaries of frames, warnings of black suns and of broken plans."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from nscc.arrays import Bytes
from nscc.diagnostics.diagnostic import Diagnostic, Rejected, Severity, rejected
from nscc.words.container import Container
from nscc.words.pictures import Pictures
from nscc_runtime.effects import marks
from nscc_runtime.frame_file import Frame

if TYPE_CHECKING:
    from nscc_runtime.planning.audit import Audit
    from nscc_runtime.planning.plan import Plan


def eaten(frame: Frame) -> Diagnostic | None:
    """Return the warning NS0793, for the caller to show, that light lowered reset levels (black
    suns) in pixels of `frame`; None without such pixels. A pixel counts once, whatever its buckets
    and repeats."""
    bit, marked = marks()["level"].bit, frame.saturated_by
    pixels = np.bitwise_or.reduce(marked, axis=tuple(range(marked.ndim - 2))) & bit
    count = int(np.count_nonzero(pixels))
    if not count:
        return None
    affected = "pixel reads less than it" if count == 1 else "pixels read less than they"
    return Diagnostic(
        "NS0793",
        f"{count} {affected} received, possibly 0: light had filled PIX before the reset level "
        "was read",
        severity=Severity.WARNING,
        notes=(f"black suns are {count / pixels.size:.2%} of the pixels",),
        helps=("saturated_by has bit 16 there; less light reduces their number",),
        data={"pixels": count},
    )


def over(plan: Plan, breach: str, plan_given: bool) -> Diagnostic:
    """Return the warning NS0749, for the caller to show, that a plan exceeds the tolerance.

    `breach`: a sentence that says by how much. The cause is a plan that the user gave
    (`plan_given`), or effects that the user turned off."""
    forced = [name for name in plan.names("dropped") if name in plan.kept.forced]
    why = (
        "the plan was made for another scene" if plan_given else f"turned off: {', '.join(forced)}"
    )
    return Diagnostic(
        "NS0749",
        breach,
        severity=Severity.WARNING,
        notes=(why,),
        helps=(_instead(plan_given),),
        data={
            "predicted_e": plan.predicted_e,
            "tolerance_e": plan.tolerance_e,
            "other_states": plan.other_states,
        },
    )


def _instead(plan_given: bool) -> str:
    """Return what helps, as text, if a plan leaves out too many effects: one that the user gave
    (`plan_given`), or one that was made here."""
    if plan_given:
        return "make a new plan for this scene"
    return "let the planner decide on these effects"


def broken(plan: Plan, report: Audit, plan_given: bool) -> Rejected:
    """Return the error NS0749 (status 1), for the caller to raise, for an audit `report` whose
    error exceeds what `plan` promised, with what to do. `plan_given`: whether the user gave the
    plan (the effects that are simulated)."""
    if plan.breach is not None:
        advice = f"use --fidelity reference for this scene, or {_instead(plan_given)}"
    else:
        advice = (
            "use --fidelity reference for this scene; a plan that predicts an error within "
            "the tolerance should not fail: please report it"
        )
    return rejected(
        "NS0749",
        report.breach(plan) or "the promise is broken",
        notes=(
            "its error was not measured before"
            if plan.predicted_e is None
            else f"predicted were {plan.predicted_e:.3g} e",
        ),
        helps=(advice,),
        data={
            "measured_rms_e": report.measured_rms_e,
            "tolerance_e": plan.tolerance_e,
            "other_states": report.other_states,
        },
        status=1,
    )


def frame_lines(container: Container, frame: Frame) -> list[str]:
    """Return a summary of a frame, or of the first of several frames: one line for each bucket that
    is read, then those of images, planes and reports."""
    width = max((len(name) for name in container.buckets_read), default=0)
    lines, first = [], frame.first
    for bucket, name in enumerate(container.buckets_read):
        values = first.exposure_e[bucket][first.valid[bucket]]
        invalid = first.valid[bucket].size - values.size
        text = f"{name:<{width}}  {saturation_text(first.saturated_by[bucket])}"
        if values.size:
            text += f", electrons {values.min():.6g} to {values.max():.6g}"
            text += f", mean {values.mean():.6g}"
        lines.append(text + (f", {invalid} invalid" if invalid else ""))
    return [*lines, *picture_lines(container.pictures, first)]


def picture_lines(pictures: Pictures, frame: Frame) -> list[str]:
    """Return a summary of the images, planes, reports and the margin of a single frame, one line
    each; empty for programs without them."""
    told_arrays, lines = frame.told, []
    for name in pictures.reads:
        if f"image_{name}" in told_arrays:
            values, causes = told_arrays[f"image_{name}"], told_arrays[f"image_saturated_by_{name}"]
            text = f"electrons {values.min():.6g} to {values.max():.6g}, mean {values.mean():.6g}"
            lines.append(
                f"image {name}  {np.count_nonzero(causes)} of {causes.size} pixels marked, {text}"
            )
        elif f"plane_{name}" in told_arrays:
            bits = told_arrays[f"plane_{name}"]
            lines.append(f"plane {name}  {np.count_nonzero(bits)} of {bits.size} pixels are 1")
    for report in pictures.reports:
        if report.kind == "flood":
            is_complete = told_arrays[report.key]
            lines.append(f"flood {report.subject}  {'complete' if is_complete else 'not complete'}")
            continue
        key = report.key
        value = told_arrays[key]
        if report.kind == "any":
            text = "yes" if value else "no"
        elif report.kind == "box":
            least_x, top, right, bottom = value.tolist()
            text = "empty" if least_x < 0 else f"x {least_x} to {right}, y {top} to {bottom}"
        elif report.kind in ("count", "sum"):
            text = f"{value:.10g}" + (" electrons" if report.kind == "sum" else "")
        else:
            overflow_note = ", and there are more" if told_arrays[f"{key}_overflow"] else ""
            text = f"{told_arrays[f'{key}_count']} coordinates{overflow_note}"
        lines.append(f"report {report.kind} {report.plane}  {text}")
    if "margin" in told_arrays:
        margin = np.count_nonzero(told_arrays["margin"])
        lines.append(f"margin  {margin} pixels depend on what is beyond the array")
    return lines


def saturation_text(saturated_by: Bytes) -> str:
    """Return how many pixels of `saturated_by` (any shape) are saturated, and by what, as text such
    as "3 of 64 pixels saturated (well 2, converter 3)". A pixel may have several causes."""
    text = f"{np.count_nonzero(saturated_by)} of {saturated_by.size} pixels saturated"
    counts = {m.name: np.count_nonzero(saturated_by & m.bit) for m in marks().values()}
    named = ", ".join(f"{name} {count}" for name, count in counts.items() if count)
    return f"{text} ({named})" if named else text
