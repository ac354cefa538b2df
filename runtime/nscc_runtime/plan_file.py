"""Plans outside the program: the file of `--plan`, and the table that a person reads."""

from __future__ import annotations

import json
from pathlib import Path

from nscc.columns import columns
from nscc.diagnostics.rejection import rejected
from nscc_runtime.planner.audit import Audit
from nscc_runtime.planner.plan import Plan
from nscc_runtime.sensor import Sensor, sensor_sha256

PLAN_SCHEMA = "nscc-plan-1"


def plan_text(plan: Plan, program_sha256: str, sensor: Sensor) -> str:
    """A plan's file, which says what it was made for."""
    made_for = {"program_sha256": program_sha256, "sensor_sha256": sensor_sha256(sensor)}
    values = {"schema": PLAN_SCHEMA, **made_for, "plan": plan.as_json()}
    return json.dumps(values, indent=2) + "\n"


def read_plan(path: Path, program_sha256: str, sensor: Sensor) -> Plan:
    """A plan from its file; NS0747 where it is none, NS0748 where it was made for something else
    (status 2).
    """
    try:
        values = json.loads(path.read_bytes())
        if values["schema"] != PLAN_SCHEMA:
            raise ValueError(f"its schema is {str(values['schema'])[:40]!r}")
        plan = Plan.from_json(values["plan"])
        made_for = str(values["program_sha256"]), str(values["sensor_sha256"])
    except (OSError, ValueError, KeyError, TypeError, AttributeError, RecursionError) as error:
        words = " ".join(str(error).split())[:120]
        raise rejected(
            "NS0747",
            f"'{path}' is no plan of this version",
            notes=(f"{type(error).__name__}: {words}",),
            helps=("give --plan a name that does not exist: the plan made is written there",),
        ) from error
    is_for = program_sha256, sensor_sha256(sensor)
    for found, here, what in zip(made_for, is_for, ("program", "sensor"), strict=True):
        if found != here:
            raise rejected(
                "NS0748",
                f"the plan '{path}' was made for another {what}",
                notes=(f"its {what}_sha256 is {found[:12]}.., here it is {here[:12]}..",),
                helps=("make a new plan: give --plan a name that does not exist",),
            )
    return plan


def plan_table(plan: Plan, report: Audit | None = None) -> str:
    """The plan as a person reads it, and what an audit measured."""
    rows: list[tuple[str, ...]] = [("effect", "rms e", "bias e", "choice", "why", "saves ms")]
    for each in plan.decisions:
        rms = "" if each.predicted_rms_e is None else f"{each.predicted_rms_e:.3g}"
        bias = "" if not each.predicted_bias_e else f"{each.predicted_bias_e:+.3g}"
        choice = each.decision + (", forced" if each.forced else "")
        cost = "" if each.cost_ms_model <= 0 else f"{each.cost_ms_model:.2f}"
        rows.append((each.name, rms, bias, choice, each.reason, cost))
    lines = [
        columns(rows, left=(0, 3, 4)),
        f"predicted error {plan.predicted_e:.3g} e (at most {plan.bound_e:.3g}), "
        f"tolerance {plan.tolerance_e:.4g} e, from {plan.sampled_fraction:.1%} of the pixels",
    ]
    lines += [f"short cut: {each.name}, {each.error_e:.2g} e" for each in plan.approximations]
    loop = {
        "none": "no pixel runs through the words one by one",
        "some": "some pixels run through the words one by one",
        "all": "all pixels run through the words one by one",
        "reference": "the reference runs, slot by slot",
    }
    lines.append(": ".join(filter(None, (loop[plan.slot_loop], "; ".join(plan.slot_loop_reasons)))))
    if report is not None:
        verdict = "the promise holds" if report.holds else "THE PROMISE IS BROKEN"
        ratio = "" if report.std_ratio is None else (
            f", std ratio {report.std_ratio:.4f} +- {report.std_ratio_mc_error:.4f}"
        )  # fmt: skip
        lines.append(
            f"audit: measured {report.measured_rms_e:.3g} +- {report.mc_error_e:.2g} e, bias "
            f"{report.bias_e:+.2g} +- {report.bias_mc_error_e:.2g} e{ratio}; {report.samples} "
            f"samples in {report.frames} frames: {verdict}"
        )
    return "\n".join(lines)
