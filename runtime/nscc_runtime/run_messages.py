"""Messages of a run: light that lowered reset levels, and plans that exceed their tolerance."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from nscc.diagnostics.diagnostic import Diagnostic, Rejected, Severity
from nscc.diagnostics.rejection import rejected
from nscc_runtime.effects import marks
from nscc_runtime.frame_file import Frame

if TYPE_CHECKING:
    from nscc_runtime.planning.audit import Audit
    from nscc_runtime.planning.plan import Plan


def eaten(frame: Frame) -> Diagnostic | None:
    """Return the warning that light lowered reset levels (black suns); None without such pixels."""
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
    """Return the warning that forced effects, or the given plan, exceed the tolerance."""
    forced = [
        decision.name
        for decision in plan.decisions
        if decision.forced and decision.decision == "dropped"
    ]
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
    return (
        "make a new plan for this scene"
        if plan_given
        else "let the planner decide on these effects"
    )


def broken(plan: Plan, report: Audit, plan_given: bool) -> Rejected:
    """Return the error (status 1) for an audit whose error exceeds the promise."""
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
