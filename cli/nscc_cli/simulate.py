"""The emulator's side of `nscc run`: which effects, by plan or by reference, and what is said."""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass
from hashlib import sha256
from pathlib import Path
from typing import TYPE_CHECKING, Any

from nscc.diagnostics.diagnostic import Diagnostic, Rejected, Severity
from nscc_cli.support import done, progress, say

if TYPE_CHECKING:
    from nscc.words.container import Container
    from nscc_cli.run import Timings
    from nscc_runtime.effects import Selection
    from nscc_runtime.frame_file import Frame, Provenance
    from nscc_runtime.light import Light
    from nscc_runtime.plan.audit import Audit
    from nscc_runtime.plan.plan import Plan
    from nscc_runtime.plan.program import Program
    from nscc_runtime.sensor import Sensor

PLAN_SCHEMA = "nscc-plan-1"


@dataclass(frozen=True)
class Wanted:
    """What the command line says about effects. `planned`: a plan is made, used or both."""

    effects: Selection
    planned: bool
    tolerance: str
    audit: bool
    plan: Path | None
    seed: int
    device_seed: int
    repeat: int | None

    @classmethod
    def of(cls, options: dict[str, Any]) -> Wanted:
        """From the options of `nscc run`; NS0739 (status 2) where they contradict each other."""
        from nscc_runtime.effects import selected

        text, plan = options["effects"], options["plan"]
        asked = [n for n in ("tolerance", "audit", "plan") if options[n] not in (None, False)]
        effects = selected(text if text is not None else "auto" if asked else "none")
        reference = options["fidelity"] == "reference"
        if reference and (asked or effects.auto):
            named = ", ".join(f"--{name}" for name in asked) or "--effects auto"
            raise _contradiction(
                f"{named} with --fidelity reference",
                "the reference simulates what it is told to, without a plan",
                f"leave {named} out, or --fidelity reference",
            )
        if plan is not None and plan.exists() and (text is not None or "tolerance" in asked):
            named = "--effects" if text is not None else "--tolerance"
            raise _contradiction(
                f"{named} with the plan '{plan}'",
                "a plan that is used has decided on effects and tolerance",
                f"leave {named} out, or name a file that does not exist to write a new plan",
            )
        return cls(
            effects,
            not reference and (bool(asked) or not effects.noiseless),
            "5e" if options["tolerance"] is None else options["tolerance"],
            bool(options["audit"]),
            plan,
            options["seed"],
            options["device_seed"],
            options["repeat"],
        )


@dataclass(frozen=True, eq=False)
class Simulated:
    """What became of it: the frame(s), where they come from, and what there is to say."""

    frame: Frame
    origin: Provenance
    table: str = ""
    plan_file: str | None = None
    broken: Rejected | None = None


def simulated(
    container: Container, light: Light, sensor: Sensor, wanted: Wanted, timings: Timings
) -> Simulated:
    """Expose the scene. The plan's file is given back to be written with the frame."""
    if wanted.planned:
        return _planned(container, light, sensor, wanted, timings)
    with timings.part("expose_s"):
        frame = _exact(container, light, sensor, wanted)
    from nscc.words.file import to_bytes
    from nscc_runtime.frame_file import Provenance, decisions

    fidelity = "planned" if wanted.effects.noiseless else "reference"
    origin = Provenance(
        to_bytes(container), wanted.seed, wanted.device_seed, fidelity, sensor,
        decisions(wanted.effects, light.motion is not None),
    )  # fmt: skip
    return Simulated(frame, origin)


def _exact(container: Container, light: Light, sensor: Sensor, wanted: Wanted) -> Frame:
    """Words slot by slot: without effects, or by the reference."""
    from nscc_runtime import frame_file

    repeat = wanted.repeat
    if wanted.effects.noiseless:
        from nscc_runtime.emulator import expose
        from nscc_runtime.emulator.loops import expose_block

        _say_compiling(expose_block.is_compiled(), "emulator")
        exact = expose(container, light, device_seed=wanted.device_seed)
        frame = frame_file.read_out(exact, container.target, sensor)
        return frame_file.repeated(frame, repeat) if repeat else frame
    from nscc_runtime.noise.loops import fill_normals
    from nscc_runtime.reference import frames

    _say_compiling(fill_normals.is_compiled(), "noise")
    made = frames(
        container, light, sensor, wanted.effects,
        seed=wanted.seed, device_seed=wanted.device_seed, count=repeat or 1,
    )  # fmt: skip
    found = list(progress(made, "exposing", repeat or 1))
    return frame_file.stacked(found) if repeat else found[0]


def _planned(
    container: Container, light: Light, sensor: Sensor, wanted: Wanted, timings: Timings
) -> Simulated:
    """By a plan: made here, or read from its file."""
    from nscc.words.file import to_bytes
    from nscc_runtime import frame_file
    from nscc_runtime.capture import made_ready, planned_frames
    from nscc_runtime.emulator.capture import check
    from nscc_runtime.plan.choose import plan_for, predicted_for
    from nscc_runtime.plan.fused_loop import fused
    from nscc_runtime.plan.pixel_loop import run_pixels
    from nscc_runtime.plan.tolerance import tolerance_e

    tolerance = tolerance_e(wanted.tolerance, sensor)
    _say_compiling(fused.is_compiled() and run_pixels.is_compiled(), "planner")
    check(container, light)
    program_bytes = to_bytes(container)
    digest = sha256(program_bytes).hexdigest()
    with timings.part("analyse_s"):
        program = made_ready(container, sensor)
    given = wanted.plan is not None and wanted.plan.exists()
    with timings.part("plan_s"):
        if given:
            assert wanted.plan is not None
            plan = read_plan(wanted.plan, digest, sensor)
            plan = predicted_for(program, light, plan, wanted.device_seed)
        else:
            plan = plan_for(program, light, tolerance, wanted.effects, wanted.device_seed)
    if plan.predicted_e > plan.tolerance_e and (wanted.effects.auto or given):
        say([_over(plan, given)])
    count = wanted.repeat or 1
    with timings.part("expose_s"):
        made = planned_frames(program, light, plan, wanted.seed, wanted.device_seed, count)
        found = list(progress(made, "exposing", count))
    frame = frame_file.stacked(found) if wanted.repeat else found[0]
    report, broken = None, None
    if wanted.audit:
        with timings.part("audit_s"):
            report = _audited(program, light, plan, wanted)
        broken = None if report.holds else _broken(plan, report)
    origin = frame_file.Provenance(
        program_bytes, wanted.seed, wanted.device_seed, "planned", sensor, (), plan.as_json(),
        None if report is None else asdict(report),
    )  # fmt: skip
    text = None
    if wanted.plan is not None and not given:
        text = plan_text(plan, digest, sensor)
    return Simulated(frame, origin, table(plan, report), text, broken)


def _audited(program: Program, light: Light, plan: Plan, wanted: Wanted) -> Audit:
    from nscc_runtime.plan.audit import audit
    from nscc_runtime.plan.capture import prepared

    planned = prepared(program, light, plan, device_seed=wanted.device_seed)
    return audit(planned, wanted.seed, wanted.repeat or 1)


def plan_text(plan: Plan, program_sha256: str, sensor: Sensor) -> str:
    """A plan's file."""
    from nscc_runtime.sensor import sensor_sha256

    values = {
        "schema": PLAN_SCHEMA,
        "program_sha256": program_sha256,
        "sensor_sha256": sensor_sha256(sensor),
        "plan": plan.as_json(),
    }
    return json.dumps(values, indent=2) + "\n"


def read_plan(path: Path, program_sha256: str, sensor: Sensor) -> Plan:
    """A plan from its file; NS0747 where it is none, NS0748 where it was made for something else
    (status 2).
    """
    from nscc_runtime.plan.plan import Plan
    from nscc_runtime.sensor import sensor_sha256

    try:
        values = json.loads(path.read_bytes())
        if values["schema"] != PLAN_SCHEMA:
            raise ValueError(f"its schema is {str(values['schema'])[:40]!r}")
        plan = Plan.from_json(values["plan"])
        made_for = str(values["program_sha256"]), str(values["sensor_sha256"])
    except (OSError, ValueError, KeyError, TypeError, AttributeError, RecursionError) as error:
        words = " ".join(str(error).split())[:120]
        raise Rejected(
            Diagnostic(
                "NS0747",
                f"'{path}' is no plan of this version",
                notes=(f"{type(error).__name__}: {words}",),
                helps=("give --plan a name that does not exist: the plan made is written there",),
            ),
            status=2,
        ) from error
    for found, here, what in zip(
        made_for, (program_sha256, sensor_sha256(sensor)), ("program", "sensor"), strict=True
    ):
        if found != here:
            raise Rejected(
                Diagnostic(
                    "NS0748",
                    f"the plan '{path}' was made for another {what}",
                    notes=(f"its {what}_sha256 is {found[:12]}.., here it is {here[:12]}..",),
                    helps=("make a new plan: give --plan a name that does not exist",),
                ),
                status=2,
            )
    return plan


def table(plan: Plan, report: Audit | None) -> str:
    """The plan as a person reads it."""
    head = ("effect", "rms e", "bias e", "choice", "why", "saves ms")
    rows = [head]
    for each in plan.decisions:
        rms = "" if each.predicted_rms_e is None else f"{each.predicted_rms_e:.3g}"
        bias = "" if not each.predicted_bias_e else f"{each.predicted_bias_e:+.3g}"
        choice = each.decision + (", forced" if each.forced else "")
        cost = "" if each.cost_ms_model <= 0 else f"{each.cost_ms_model:.2f}"
        rows.append((each.name, rms, bias, choice, each.reason, cost))
    widths = [max(len(row[i]) for row in rows) for i in range(len(head))]
    right = (False, True, True, False, False, True)
    lines = [
        "  ".join(
            text.rjust(width) if end else text.ljust(width)
            for text, width, end in zip(row, widths, right, strict=True)
        ).rstrip()
        for row in rows
    ]
    lines.append(
        f"predicted error {plan.predicted_e:.3g} e (at most {plan.bound_e:.3g}), "
        f"tolerance {plan.tolerance_e:.4g} e, from {plan.sampled_fraction:.1%} of the pixels"
    )
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


def _over(plan: Plan, given: bool) -> Diagnostic:
    """The warning that what the user forced off, or the plan given, costs more than allowed."""
    forced = [each.name for each in plan.decisions if each.forced and each.decision == "dropped"]
    why = "the plan was made for another scene" if given else f"forced off: {', '.join(forced)}"
    return Diagnostic(
        "NS0749",
        f"the predicted error is {plan.predicted_e:.3g} e, the tolerance {plan.tolerance_e:.4g} e",
        severity=Severity.WARNING,
        notes=(why,),
        helps=("make a new plan for this scene" if given else "let the planner decide on them",),
        data={"predicted_e": plan.predicted_e, "tolerance_e": plan.tolerance_e},
    )


def _broken(plan: Plan, report: Audit) -> Rejected:
    """The promise did not hold (status 1)."""
    return Rejected(
        Diagnostic(
            "NS0749",
            f"the audit measured an error of {report.measured_rms_e:.3g} e, more than 1.1 times "
            f"the tolerance of {plan.tolerance_e:.4g} e",
            notes=(f"predicted were {plan.predicted_e:.3g} e",),
            helps=(
                "use --fidelity reference for this scene; a plan in which nothing was forced "
                "should not come to this: please report it",
            ),
            data={"measured_rms_e": report.measured_rms_e, "tolerance_e": plan.tolerance_e},
        ),
        status=1,
    )


def _contradiction(what: str, note: str, help_text: str) -> Rejected:
    message = f"{what}: these exclude each other"
    return Rejected(Diagnostic("NS0739", message, notes=(note,), helps=(help_text,)), status=2)


def _say_compiling(ready: bool, what: str) -> None:
    if not ready:
        done(f"compiling the {what}'s loops for this processor: once, some seconds")
