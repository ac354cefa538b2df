"""Make a plan for a scene.

1. List the sets of effects that may be dropped, those that save most time first (`_moves`).
2. Draw a sample of the pixels (`sample`), and expose it with every effect.
3. Drop one set after the other. Measure the error of all dropped effects on the sample, with the
   same random numbers, and keep the set if the error plus two standard errors exceeds the tolerance.

Effects are only measured if that is predicted to save more time than it takes, or if the user
requests the table. Otherwise every effect is simulated."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace

import numpy as np

from nscc_runtime.effects import Effect, Selection, everything, registered
from nscc_runtime.effects.parts import Codes, Converter, Counted, CountedLight, Moving, Saturates
from nscc_runtime.effects.parts import Errors as SmallErrors
from nscc_runtime.execution.program import analysed
from nscc_runtime.planning.plan import MOST_OTHER_STATES, Choice, Decision, Plan
from nscc_runtime.planning.planned_scene import (
    SAMPLED,
    PlannedScene,
    Trial,
    trial_of,
    unseen_square_e2,
)
from nscc_runtime.planning.prices import Work
from nscc_runtime.planning.sample import SampledErrors
from nscc_runtime.planning.tolerance import (
    DEFAULT,
    ToleranceInput,
    check_tolerance,
    is_noise,
    tolerance_of,
)

Names = frozenset[str]

MANY = 1000
"""Default number of frames that share a plan."""
_WORTH = 1.5
"""Effects are measured if that is predicted to save this multiple of the time that it takes."""
_MARGIN, _SURE = 0.9, 0.97
"""Effects are dropped while the measured error is at most `_MARGIN` times the tolerance, and the
error plus two standard errors at most `_SURE` times the tolerance."""
_OTHER_STATES = 0.5 * MOST_OTHER_STATES
"""Largest measured fraction of pixels in other states when a plan is made."""
_BOUND_ERRORS = 3.0
"""Number of standard errors that are added to the predicted error to get its bound."""
_BOUND, _SERVED_OTHER_STATES = 1.05, 0.7 * MOST_OTHER_STATES
"""A plan is reused while its bound on the new scene is at most `_BOUND` times the tolerance, and
the measured fraction of pixels in other states at most `_SERVED_OTHER_STATES`."""
FROM_EARLIER_PLAN = "taken from an earlier plan"
"""The reason shown for decisions of a plan that was made for another scene."""
NAMED = "named in --effects"
NOT_WORTH = "choosing effects would take longer than it saves"


@dataclass(frozen=True)
class PlanRequest:
    """The request for a plan.

    `effects`: the requested effects. `tolerance`: the largest RMS error. `frames`: number of frames
    that share the plan; it decides whether measuring saves time. `figures`: measure every figure of
    the table, even if that saves no time."""

    effects: Selection
    tolerance: ToleranceInput = DEFAULT
    frames: int = MANY
    figures: bool = False

    @property
    def forced(self) -> Names:
        """Names of the effects that the user switched on or off."""
        effects = self.effects
        return frozenset(
            e.name for e in registered() if not effects.auto or e.name in effects.forced
        )

    @property
    def forced_off(self) -> Names:
        """Names of the effects of the exposure that the user switched off."""
        return frozenset(
            e.name for e in _of_exposure() if e.name in self.forced and e not in self.effects
        )


def make_plan(scene: PlannedScene, request: PlanRequest) -> Plan:
    """Return the fastest plan whose error, measured on a sample of the scene, is within tolerance.

    If measuring would take longer than it saves, the plan simulates every requested effect instead.
    Raises Rejected (NS0746) for an invalid tolerance."""
    check_tolerance(request.tolerance, scene.sensor)
    work, absent = Work.of(scene), absent_effects(scene)
    moves = _moves(work, request, absent)
    trial_ms = 0.0 if request.figures else _WORTH * work.trials_ms(1, SAMPLED)
    is_checked = request.effects.auto and bool(request.forced_off - absent)
    if not request.figures and not is_checked and sum(moves.values()) < 3.0 * trial_ms:
        return _unmeasured(work, request, absent)
    measuring = _Measuring(trial_of(scene), request)
    alone = measuring.drop_each(
        [frozenset({e.name}) for e in _of_exposure() if request.figures and e.name not in absent]
    )
    dropped = Names()
    together, _ = measuring.drop_together(dropped)
    for names, saved_ms in moves.items():
        if saved_ms > trial_ms and (names not in alone or measuring.fits(alone[names])):
            candidate, by_choice = measuring.drop_together(dropped | names)
            if measuring.fits(by_choice):
                dropped, together = dropped | names, candidate
    return _planned(measuring, work, alone, dropped, together, absent)


def measured_again(scene: PlannedScene, plan: Plan, *, figures: bool = False) -> Plan:
    """Return a plan that was made for another scene, with its error and its relative tolerance
    measured on this scene. `figures`: also measure each effect alone."""
    work, absent = Work.of(scene), absent_effects(scene)
    request = PlanRequest(plan.requested_effects, plan.tolerance_input, figures=figures)
    if not plan.names("dropped") and not figures:
        return replace(_unmeasured(work, request, absent), reused=True)
    measuring = _Measuring(trial_of(scene), request)
    names = [e.name for e in _of_exposure() if figures and e.name not in absent]
    alone = measuring.drop_each([frozenset({name}) for name in names])
    dropped = frozenset(plan.names("dropped")) - request.forced_off
    together, _ = measuring.drop_together(dropped)
    made = _planned(measuring, work, alone, dropped, together, absent)
    decisions = (
        decision if decision.kind == "after" else replace(decision, reason=FROM_EARLIER_PLAN)
        for decision in made.decisions
    )
    return replace(made, decisions=tuple(decisions), reused=True)


def served_plan(scene: PlannedScene, plan: Plan) -> Plan | None:
    """Return a plan of an earlier scene with its error on this scene; None if the error is too
    large here."""
    plan = measured_again(scene, plan)
    tolerance_e = plan.tolerance_e or 0.0
    fits = not plan.measured or (
        (plan.predicted_e or 0.0) <= _SURE * tolerance_e
        and (plan.bound_e or 0.0) <= _BOUND * tolerance_e
        and (plan.other_states or 0.0) <= _SERVED_OTHER_STATES
    )
    return plan if fits else None


def absent_effects(scene: PlannedScene) -> Names:
    """Return the names of the effects of the exposure that certainly change nothing on a scene."""
    all_effects, names = everything(), frozenset[str]()
    if scene.light.motion is None:
        names |= all_effects.names(Moving)
    if not scene.looks:
        names |= {e.name for e in _of_exposure() if e.reference.keys() == {"compare"}}
        if not len(scene.near_pixels(all_effects).places):
            names |= all_effects.names(Saturates)
    return names


def _of_exposure() -> list[Effect]:
    """Return the effects that act before the readout."""
    return [effect for effect in registered() if effect.kind != "after"]


def _moves(work: Work, request: PlanRequest, absent: Names) -> dict[Names, float]:
    """Return the sets of effects that may be dropped together, and the milliseconds that each saves
    of all requested frames; those that save most first.

    These are single effects and the groups whose effects share work. Without figures, effects that
    are certainly too large are left out."""
    free = frozenset(e.name for e in _of_exposure()) - request.forced - absent
    if not request.figures:
        free -= _too_large(work, request)
    all_effects = everything()
    groups = [all_effects.names(kind) - absent for kind in (Counted, SmallErrors, Saturates)]
    sets = {names for names in groups if names and names <= free}
    sets |= {frozenset({name}) for name in free}
    requested = all_effects.without(*request.forced_off)
    all_ms = work.milliseconds(requested, request.frames)
    saved_ms = {
        names: all_ms - work.milliseconds(requested.without(*names), request.frames)
        for names in sets
    }
    ordered = sorted(sets, key=lambda names: (-saved_ms[names], sorted(names)))
    return {names: saved_ms[names] for names in ordered if saved_ms[names] > 0}


def _too_large(work: Work, request: PlanRequest) -> Names:
    """Return effects whose error certainly exceeds a tolerance in electrons: noise of counts and of
    words, and losses near saturation."""
    scene = work.scene
    if is_noise(request.tolerance):
        return Names()
    tolerance_e = tolerance_of(request.tolerance, scene.sensor, scene).electrons
    all_effects, full_e = everything(), scene.sensor.full_well_e
    least_e = {
        effect.name: part.sigma_e(scene.sensor)
        for effect, part in all_effects.errors()
        if part.at != "resets"  # double sampling subtracts these
    }
    if not scene.looks:
        program = analysed(scene.container, scene.sensor)
        open_share = program.opened.mean(axis=0).max(axis=1)[program.lanes]
        light_e = np.minimum(scene.light.sum_e.reshape(-1) * open_share, full_e)
        lost_e = np.maximum(scene.near_pixels(all_effects).own_e / 1.5 - full_e, 0.0)
        least_e |= dict.fromkeys(all_effects.names(CountedLight), 0.5 * light_e.mean() ** 0.5)
        lost_rms_e = math.sqrt(float((lost_e**2).sum()) / scene.pixels)
        least_e |= dict.fromkeys(all_effects.names(Saturates), lost_rms_e)
    return frozenset(name for name, error_e in least_e.items() if error_e > tolerance_e)


class _Measuring:
    """Measurements on a trial, for one request.

    `allowed`: the tolerance in electrons. `base`: the exposures with every effect that the user did
    not force off: the planner's own choice has to keep the tolerance relative to these."""

    def __init__(self, trial: Trial, request: PlanRequest) -> None:
        self.trial, self.request = trial, request
        self.requested = everything().without(*request.forced_off)
        self.base = trial.exposures(self.requested) if request.forced_off else trial.truth
        self.allowed = tolerance_of(request.tolerance, trial.scene.sensor, trial)

    def drop_each(self, sets: Iterable[Names]) -> dict[Names, SampledErrors]:
        """Return the errors of dropping each set while every other requested effect is simulated;
        of effects that the user forced off, the errors of dropping them as well as the others."""
        errors = {}
        for names in sets:
            if names & self.request.forced_off:
                on = self.requested.on | names
                with_names = self.trial.exposures(Selection(on, self.requested.forced))
                errors[names] = self.trial.between(self.base, with_names)
            else:
                errors[names] = self.trial.errors(self.requested.without(*names), self.base)
        return errors

    def fits(self, errors: SampledErrors) -> bool:
        """Return whether errors are within the tolerance, with a margin for sampling errors."""
        tolerance_e = self.allowed.electrons
        return (
            errors.square_e2() <= (_MARGIN * tolerance_e) ** 2
            and errors.square_e2(2.0) <= (_SURE * tolerance_e) ** 2
            and errors.other_states <= _OTHER_STATES
        )

    def drop_together(self, dropped: Names) -> tuple[SampledErrors, SampledErrors]:
        """Return the errors of dropping effects at once: relative to every effect, and relative to
        every effect that the user did not force off."""
        effects = self.requested.without(*dropped)
        exposed = self.base if effects.on == self.requested.on else self.trial.exposures(effects)
        unseen_e2 = unseen_square_e2(self.trial, effects)
        by_choice = self.trial.between(exposed, self.base).with_unseen(unseen_e2)
        return self.trial.between(exposed, self.trial.truth).with_unseen(unseen_e2), by_choice


def _planned(
    measuring: _Measuring, work: Work, alone: Mapping[Names, SampledErrors], dropped: Names,
    together: SampledErrors, absent: Names,
) -> Plan:  # fmt: skip
    """Return the plan that drops the effects `dropped`, with the measured error `together`."""
    trial, request, allowed = measuring.trial, measuring.request, measuring.allowed
    decisions = tuple(
        _decision(effect, measuring, work, alone.get(frozenset({effect.name})), dropped, together)
        if effect.kind != "after" and effect.name not in absent - request.forced_off
        else _unmeasured_decision(effect, work, request, absent)
        for effect in registered()
    )
    effects = measuring.requested.without(*dropped)
    return Plan(
        allowed.text, allowed.electrons, together.rms_e,
        math.sqrt(together.square_e2(_BOUND_ERRORS)), together.worst_e, *_slot_loop(work, effects),
        len(trial.sample.places) / trial.scene.pixels, work.milliseconds(effects),
        work.milliseconds(measuring.requested), work.trials_ms(3 + len(alone), SAMPLED), decisions,
        allowed.signal_e, allowed.noise_e, together.other_states if trial.scene.looks else None,
    )  # fmt: skip


def _unmeasured(work: Work, request: PlanRequest, absent: Names) -> Plan:
    """Return a plan without measured errors that simulates every effect except those forced off."""
    scene, requested = work.scene, everything().without(*request.forced_off)
    is_unknown = is_noise(request.tolerance)
    allowed = None if is_unknown else tolerance_of(request.tolerance, scene.sensor, scene)
    frame_ms = work.milliseconds(requested)
    return Plan(
        str(request.tolerance) if allowed is None else allowed.text,
        None if allowed is None else allowed.electrons, None, None, None,
        *_slot_loop(work, requested), 0.0, frame_ms, frame_ms, 0.0,
        tuple(_unmeasured_decision(effect, work, request, absent) for effect in registered()),
        None if allowed is None else allowed.signal_e,
    )  # fmt: skip


def _slot_loop(work: Work, effects: Selection) -> tuple[bool, tuple[str, ...]]:
    """Return whether pixels run through their words one by one, and why."""
    scene = work.scene
    reasons = scene.needs_reference(effects)
    if not reasons and scene.looks:
        reasons = ("pixels look at the light: each runs through the words that act in it",)
    elif not reasons and work.near and effects.names(Saturates):
        reasons = (f"{work.near} pixels may saturate",)
    return bool(reasons), reasons


def _decision(
    effect: Effect, measuring: _Measuring, work: Work, alone: SampledErrors | None, dropped: Names,
    together: SampledErrors,
) -> Decision:  # fmt: skip
    """Return the decision on an effect that may change this scene."""
    name, request = effect.name, measuring.request
    forced, off = name in request.forced, name in dropped | request.forced_off
    saved_ms = work.milliseconds(everything()) - work.milliseconds(everything().without(name))
    choice: Choice = "dropped" if off else "kept"
    rms_e = None if alone is None else alone.rms_e
    then = together if off else None if alone is None else together.plus(alone)
    if (
        alone is not None
        and not off
        and not rms_e
        and not alone.other_states
        and not (work.near and name in everything().names(Saturates))
    ):
        choice = "absent"
    if forced:
        reason = NAMED
    elif choice == "absent":
        reason = effect.absent
    elif off:
        error = "" if rms_e is None else f"{rms_e:.3g} e "
        reason = f"{error}fits into the tolerance"
    else:
        reason = _why_kept(measuring, saved_ms, alone, then)
    return Decision(
        name, effect.kind, choice, forced, reason, rms_e,
        None if alone is None else 0.0 - alone.bias_e, None if then is None else then.rms_e,
        max(saved_ms, 0.0),
        alone.other_states if alone is not None and work.scene.looks else None,
    )  # fmt: skip


def _why_kept(
    measuring: _Measuring, saved_ms: float, alone: SampledErrors | None, then: SampledErrors | None
) -> str:
    """Return the reason why an effect is simulated. `then`: the errors without it."""
    if saved_ms <= 0 or alone is None or then is None:
        return "costs nothing"
    if then.rms_e > _MARGIN * measuring.allowed.electrons:
        return f"left out, the error would be {then.rms_e:.3g} e"
    if alone.other_states > 0:
        return f"left out, {alone.other_states:.2%} would end in other states"
    could_e = math.sqrt(then.square_e2(2.0))
    return f"left out, the error could be {could_e:.3g} e: few pixels tell"


def _unmeasured_decision(
    effect: Effect, work: Work, request: PlanRequest, absent: Names
) -> Decision:
    """Return the decision on an effect that is not measured: it is simulated unless the user forced
    it off."""
    name, forced = effect.name, effect.name in request.forced and not effect.always
    on = name not in request.forced_off and (effect in request.effects or request.effects.auto)
    if effect.kind == "after":
        code_e = everything().require_part(Codes).electrons(work.scene.sensor)
        rms_e = code_e / math.sqrt(12.0) if effect.parts_of_kind(Codes) else None
        for converter in effect.parts_of_kind(Converter):
            rms_e = converter.sigma_lsb(work.scene.sensor) * code_e
        reason = NAMED if forced else "always applied, after the exposure"
        return Decision(name, effect.kind, "kept" if on else "dropped", forced, reason, rms_e, 0.0)
    if name in absent and on:
        return Decision(name, effect.kind, "absent", forced, effect.absent)
    reason = NAMED if forced else NOT_WORTH
    return Decision(name, effect.kind, "kept" if on else "dropped", forced, reason)
