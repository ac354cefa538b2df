"""The decision on each effect, with its measured error and the reason."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field

from nscc_runtime.effects import Effect, everything, registered
from nscc_runtime.effects.parts import CodeErrors, Codes
from nscc_runtime.effects.selection import Selection
from nscc_runtime.execution.frames import word_reasons
from nscc_runtime.planning import plan as plans
from nscc_runtime.planning.plan import Decision, Plan
from nscc_runtime.planning.plan_request import Names, PlanRequest
from nscc_runtime.planning.planned_scene import SAMPLED, PlannedScene
from nscc_runtime.planning.prices import Work
from nscc_runtime.planning.sample import SampledErrors
from nscc_runtime.planning.tolerance import Tolerance

MARGIN = 0.9
"""Effects are dropped while the measured error is at most this fraction of the tolerance."""
_BOUND_ERRORS = 3.0
"""Number of standard errors that are added to the predicted error to get its bound."""
FROM_EARLIER_PLAN = "taken from an earlier plan"
"""The reason shown for decisions of a plan that was made for another scene."""


@dataclass(frozen=True, eq=False)
class EffectChoice:
    """The choice of effects for a scene.

    `absent`: effects that change nothing. `allowed`: the tolerance; None if it is unknown.
    `dropped`: effects that the planner drops. `together`: the error of dropping these and the
    effects that the user forced off; None if nothing was measured. `alone`: the errors of dropping
    single effects."""

    work: Work
    request: PlanRequest
    absent: Names
    allowed: Tolerance | None
    dropped: Names = frozenset()
    together: SampledErrors | None = None
    alone: Mapping[Names, SampledErrors] = field(default_factory=dict)


def reasons_for_words(scene: PlannedScene, effects: Selection) -> tuple[str, ...]:
    """Return why the words of some pixels run one by one under `effects`; empty if sums suffice for
    all."""
    reasons = scene.needs_reference(effects)
    if reasons:
        return reasons
    if scene.looks:
        return ("pixels look at the light: each runs through the words that act in it",)
    chip = scene.container, scene.sensor, [scene.light]
    return word_reasons(*chip, effects, scene.device_seed)


def decided_plan(choice: EffectChoice) -> Plan:
    """Return the plan (the effects that are simulated) that `choice` makes: its errors, a decision
    on every effect with its reason, and its predicted time. Errors are None if nothing was
    measured."""
    work, request, allowed, together = choice.work, choice.request, choice.allowed, choice.together
    effects, scene = request.requested.without(*choice.dropped), choice.work.scene
    reasons = reasons_for_words(scene, effects)
    return Plan(
        tolerance=str(request.tolerance) if allowed is None else allowed.text,
        tolerance_e=None if allowed is None else allowed.electrons,
        predicted_e=together.rms_e if together else None,
        bound_e=math.sqrt(together.square_e2(_BOUND_ERRORS)) if together else None,
        worst_e=together.worst_e if together else None,
        slot_loop=bool(reasons),
        slot_loop_reasons=reasons,
        sampled_fraction=len(together.weight) / scene.pixels if together else 0.0,
        total_ms=work.milliseconds(effects),
        all_ms=work.milliseconds(request.requested),
        planning_ms=work.trials_ms(3 + len(choice.alone), SAMPLED) if together else 0.0,
        decisions=tuple(_decision(effect, choice) for effect in registered()),
        signal_e=None if allowed is None else allowed.signal_e,
        noise_e=None if allowed is None else allowed.noise_e,
        other_states=together.other_states if together and scene.looks else None,
    )


def _decision(effect: Effect, choice: EffectChoice) -> Decision:
    """Return whether one effect is kept, dropped or absent, with its errors, the time that it
    costs, and the reason.

    In the code, `alone` is the error of dropping only this effect, None if it was not measured.
    `together` is the error of all that is dropped. `then` is the error of the plan (the effects
    that are simulated) without this effect: `together` if it is dropped already, else the sum of
    both."""
    name, request, work = effect.name, choice.request, choice.work
    if effect.kind == "after":
        return _after_exposure(effect, choice)
    forced, off = name in request.forced, name in choice.dropped | request.forced_off
    alone, together = choice.alone.get(frozenset({name})), choice.together
    is_zero = alone is not None and not alone.size_e.any() and alone.compared.all()
    decision: plans.Choice = "dropped" if off else "kept"
    if not off and (name in choice.absent or is_zero):
        decision = "absent"
    saved_ms = 0.0
    if decision != "absent" and together is not None:
        all_effects = everything()
        saved_ms = work.milliseconds(all_effects) - work.milliseconds(all_effects.without(name))
    then = together
    if not off:
        then = None if alone is None or together is None else together.plus(alone)
    reason = effect.absent if decision == "absent" else "named in --effects"
    if decision != "absent" and not forced:
        reason = _reason(choice, off, saved_ms, alone, then)
    # `alone` is the exposure without the effect minus that with it, so the effect's own bias has
    # the opposite sign; 0.0 - x is never -0.
    return Decision(
        name,
        effect.kind,
        decision,
        forced,
        reason,
        None if alone is None else alone.rms_e,
        None if alone is None else 0.0 - alone.bias_e,
        None if then is None else then.rms_e,
        max(saved_ms, 0.0),
        alone.other_states if alone is not None and work.scene.looks else None,
    )


def _reason(
    choice: EffectChoice,
    off: bool,
    saved_ms: float,
    alone: SampledErrors | None,
    then: SampledErrors | None,
) -> str:
    """Return, as text, the reason why the planner simulates an effect or drops it (`off`).

    `saved_ms`: milliseconds saved by dropping it. `alone`: the error of dropping it alone. `then`:
    the error of the plan (the effects that are simulated) without the effect. Both are None if they
    were not measured."""
    if off:
        return ("" if alone is None else f"{alone.rms_e:.3g} e ") + "fits into the tolerance"
    if choice.together is None:
        return "choosing effects would take longer than it saves"
    if saved_ms <= 0 or alone is None or then is None:
        return "costs nothing" if saved_ms <= 0 else "saves too little time to be measured"
    if choice.allowed is not None and then.rms_e > MARGIN * choice.allowed.electrons:
        return f"left out, the error would be {then.rms_e:.3g} e"
    if alone.other_states > 0:
        return f"left out, {alone.other_states:.2%} would end in other states"
    return f"left out, the error could be {math.sqrt(then.square_e2(2.0)):.3g} e: few pixels tell"


def _after_exposure(effect: Effect, choice: EffectChoice) -> Decision:
    """Return the decision on an effect of the readout. It is simulated if the user selects it, or
    with automatic effects unless the user turns it off. The tolerance does not include its error,
    which is None for effects that have no size of their own."""
    request, sensor = choice.request, choice.work.scene.sensor
    forced = not effect.always and effect.name in request.forced
    code_e = everything().require_part(Codes).electrons(sensor)
    rms_e = code_e / math.sqrt(12.0) if effect.parts_of_kind(Codes) else None
    for errors in effect.parts_of_kind(CodeErrors):
        rms_e = errors.sigma_lsb(sensor) * code_e
    is_on = effect in request.effects or (request.effects.auto and not forced)
    reason = "named in --effects" if forced else "always applied, after the exposure"
    decision: plans.Choice = "kept" if is_on else "dropped"
    return Decision(effect.name, effect.kind, decision, forced, reason, rms_e, 0.0)
