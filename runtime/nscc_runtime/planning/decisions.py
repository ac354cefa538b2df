"""Step 5 of planning: decide on each effect, with its measured error and the reason."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from nscc_runtime.effects import Effect, Selection, everything, registered
from nscc_runtime.effects.parts import Codes, Converter
from nscc_runtime.execution.frames import Path
from nscc_runtime.planning.choose import MARGIN, MeasuredEffects, Together
from nscc_runtime.planning.plan import Plan
from nscc_runtime.planning.plan_parts import Approximation, Choice, Cost, Decision, Loop
from nscc_runtime.planning.planned_scene import NONE, Names, Setting, Trial
from nscc_runtime.planning.prices import SHIPPED
from nscc_runtime.planning.tolerance import Tolerance

FROM_GIVEN_PLAN = "taken from the plan given"
"""The reason shown for decisions that were read from a plan made for another scene."""
_BOUND_ERRORS = 3.0
"""Number of standard errors that are added to the predicted error to get its bound."""


@dataclass(frozen=True)
class Demands:
    """The user's request for a plan.

    `effects`: the selected effects. `forced`: names of the effects that the user switched on or
    off. `allowed`, `most`: tolerances of the RMS error and of the largest error, None if unknown or
    not requested. `tolerance_text`: text of the tolerance, used if `allowed` is None. `reason`:
    reason shown for forced decisions."""

    effects: Selection
    forced: Names
    allowed: Tolerance | None
    most: Tolerance | None
    tolerance_text: str = ""
    reason: str = "named in --effects"

    def on(self, plan: Plan) -> Plan:
        """Return a copy of the plan with these tolerances entered."""
        tolerances = [tolerance for tolerance in (self.allowed, self.most) if tolerance is not None]
        signal_e = next((t.signal_e for t in tolerances if t.signal_e is not None), None)
        noise_e = next((t.noise_e for t in tolerances if t.noise_e is not None), None)
        return replace(
            plan,
            tolerance=self.allowed.text if self.allowed else self.tolerance_text,
            signal_e=signal_e,
            noise_e=noise_e,
            tolerance_max=self.most.text if self.most else "",
            tolerance_max_e=self.most.electrons if self.most else None,
        )


def planned(
    trial: Trial, demands: Demands, measured: MeasuredEffects, together: Together, figures: bool
) -> Plan:
    """Return the plan for a measured setting; `figures`: measure the noise ratio, too."""
    assert demands.allowed is not None
    setting, worst = together.setting, together.worst
    approximations = [Approximation(name, None) for name in trial.approximations]
    if approximations and measured.approximations is not None:
        together_e = measured.approximations_e
        approximations.append(Approximation("all of these together", together_e))
    decisions = tuple(
        _decision(effect, trial, demands, measured, together) for effect in registered()
    )
    plan = Plan(
        demands.allowed.electrons,
        math.sqrt(together.square_e2 - together.unseen_e2),
        math.sqrt(together.likely_e2(_BOUND_ERRORS)),
        _loop(trial, setting),
        trial.reasons(setting),
        trial.sample.fraction,
        tuple(approximations),
        decisions,
        other_states=together.difference.other_states if trial.looks else None,
        predicted_p999_e=worst.p999_e,
        predicted_max_e=worst.max_e,
        noise_ratio=trial.noise_ratio(setting) if figures else None,
        saturating_lack=tuple(sorted(setting.near_dropped)),
        cost=_cost(trial, setting, trial.planning_ms()),
    )
    return demands.on(plan)


def unmeasured(trial: Trial, demands: Demands, path: Path, why: str, reason: str) -> Plan:
    """Return a plan without measured errors that simulates every effect except those forced off.

    `path`: how frames are executed, because of `why`. `reason`: reason shown for effects that the
    user did not force."""
    setting = Setting(NONE)
    decisions = []
    for effect in registered():
        forced = effect.name in demands.forced
        if effect.kind == "after":
            decisions.append(_after_exposure(effect, trial, demands))
        elif effect.name in trial.absent:
            decisions.append(Decision(effect.name, effect.kind, "absent", forced, effect.absent))
        else:
            choice: Choice = "kept" if effect in demands.effects else "dropped"
            why_so = demands.reason if forced else reason
            decisions.append(Decision(effect.name, effect.kind, choice, forced, why_so))
    sums = path == "sums"
    plan = Plan(
        None if demands.allowed is None else demands.allowed.electrons,
        None,
        None,
        _loop(trial, setting) if sums else "all" if path == "words" else "reference",
        trial.reasons(setting) if sums else (why,),
        0.0,
        tuple(Approximation(name, None) for name in trial.approximations) if sums else (),
        tuple(decisions),
        saturating_lack=(),
        cost=_cost(trial, setting, 0.0) if sums else None,
    )
    return demands.on(plan)


def _loop(trial: Trial, setting: Setting) -> Loop:
    path = trial.executes(setting)
    if path == "sums":
        return "some" if trial.reasons(setting) else "none"
    return "all" if path == "words" else "reference"


def _decision(
    effect: Effect, trial: Trial, demands: Demands, measured: MeasuredEffects, together: Together
) -> Decision:
    forced, name = effect.name in demands.forced, effect.name
    if effect.kind == "after":
        return _after_exposure(effect, trial, demands)
    alone = measured.alone.get(name)
    if name in trial.absent or (trial.alike and alone is not None and not alone.changes):
        return Decision(name, effect.kind, "absent", forced, effect.absent, 0.0, 0.0)
    dropped = name in together.setting.dropped or (forced and effect not in demands.effects)
    dropped |= name in trial.slow and trial.executes(together.setting) != "reference"
    saved_ns = trial.saved_ns(name)
    then_e = None if alone is None else _then_e(name, dropped, measured, together)
    if forced:
        reason = demands.reason
    elif demands.reason == FROM_GIVEN_PLAN:
        reason = FROM_GIVEN_PLAN
    elif dropped:
        reason = "" if alone is None else f"{alone.rms_e:.3g} e fits into the tolerance"
    else:
        reason = why_kept(name, demands, measured, together, saved_ns, then_e)
    return Decision(
        name, effect.kind, "dropped" if dropped else "kept", forced, reason,
        None if alone is None else alone.rms_e, None if alone is None else 0.0 - alone.bias_e,
        then_e, saved_ns * trial.pixels * 1e-6,
        alone.other_states if alone is not None and trial.looks else None,
    )  # fmt: skip


def _then_e(name: str, dropped: bool, measured: MeasuredEffects, together: Together) -> float:
    """Estimate the RMS error of the plan if one more effect, `name`, were dropped as well, in
    electrons.

    The estimate adds the mean products of the errors of single effects to the error of the setting.
    """
    dropped_effects, square_e2 = together.setting.dropped, together.difference.square_e2
    more_e2 = together.unseen_e2 + measured.approximations_e**2
    if not dropped:
        alone_e2 = measured.squares_e2(dropped_effects | {name}) - measured.squares_e2(
            dropped_effects
        )
        # Outputs are the buckets of one or of several frames.
        square_e2 = square_e2.reshape(-1, len(alone_e2)) + alone_e2
    return math.sqrt(max(float(square_e2.max(initial=0.0)) + more_e2, 0.0))


def why_kept(
    name: str,
    demands: Demands,
    measured: MeasuredEffects,
    together: Together,
    saved_ns: float,
    then_e: float | None,
) -> str:
    """Return the reason why an effect is simulated."""
    assert demands.allowed is not None
    if saved_ns <= 0:
        return "costs nothing"
    alone = measured.alone.get(name)
    if alone is None or then_e is None:
        return f"left out, the error would be above {demands.allowed.electrons:.3g} e"
    if then_e > MARGIN * demands.allowed.electrons:
        return f"left out, the error would be {then_e:.3g} e"
    if alone.other_states > 0:
        return f"left out, {alone.other_states:.2%} would end in other states"
    if demands.most is not None:
        worst_e = math.hypot(alone.worst.max_e, together.worst.max_e)
        return f"left out, the worst pixel could be {worst_e:.3g} e off"
    together_e2 = together.difference.unsure_e2.reshape(-1, len(alone.unsure_e2))
    unsure_e2 = 2.0 * float((alone.unsure_e2 + together_e2).max())
    could_e = math.sqrt(then_e**2 + unsure_e2)
    return f"left out, the error could be {could_e:.3g} e: few pixels tell"


def _after_exposure(effect: Effect, trial: Trial, demands: Demands) -> Decision:
    """Return the decision on an effect of the readout. It is simulated unless the user forces it
    off, and the tolerance does not include its error."""
    forced = not effect.always and effect.name in demands.forced
    on = effect in demands.effects or (demands.effects.auto and not forced)
    reason = demands.reason if forced else "always applied, after the exposure"
    code_e = everything().require_part(Codes).electrons(trial.sensor)
    rms_e = code_e / math.sqrt(12.0) if effect.parts_of_kind(Codes) else None
    for converter in effect.parts_of_kind(Converter):
        rms_e = converter.sigma_lsb(trial.sensor) * code_e
    choice: Choice = "kept" if on else "dropped"
    return Decision(effect.name, effect.kind, choice, forced, reason, rms_e, 0.0)


def _cost(trial: Trial, setting: Setting, planning_ms: float) -> Cost:
    """Return the predicted times of a frame under the plan and of a frame with every effect."""
    ms = trial.pixels * 1e-6
    total_ns, near_ns = trial.frame_ns(setting)
    every_ns, _ = trial.frame_ns(Setting(NONE))
    return Cost(
        total_ns * ms + SHIPPED.frame_ms + planning_ms, near_ns * ms, planning_ms,
        every_ns * ms + SHIPPED.frame_ms, 0.0,
    )  # fmt: skip
