"""Make a plan for a scene.

1. List the sets of effects that may be left out, those that save most time first, without those
   whose estimated error is too large (`_promising`).
2. Expose a sample of the pixels with every effect (`trial_of`).
3. Leave out all sets at once whose estimated errors fit together, else one after the other. Measure
   the error of everything that is left out on the sample, with the same random numbers; a set stays
   on if the error is too near to the tolerance (`_choice`).
4. Say of each effect what was decided, and why (`_decision`).

Effects are only measured if that is predicted to save more time than it takes, or if the user
requests the table. Otherwise every effect is simulated."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace

import numpy as np

from nscc.arrays import Array
from nscc_runtime.effects import Effect, everything, registered
from nscc_runtime.effects.parts import (
    Counted,
    CountedLight,
    Exchange,
    Moving,
    Saturates,
)
from nscc_runtime.effects.parts import Errors as SmallErrors
from nscc_runtime.execution.frames import word_reasons
from nscc_runtime.execution.program import analysed
from nscc_runtime.planning.plan import (
    MOST_OTHER_STATES,
    Choice,
    Decision,
    Names,
    Plan,
    PlanRequest,
    effects_of_exposure,
)
from nscc_runtime.planning.planned_scene import SAMPLED, PlannedScene, Trial, trial_of
from nscc_runtime.planning.prices import Work
from nscc_runtime.planning.sample import SampledErrors
from nscc_runtime.planning.tolerance import (
    Tolerance,
    ToleranceInput,
    check_tolerance,
    tolerance_of,
    unit_of,
)

_WORTH, _EACH_WORTH = 6.0, 2.0
"""Effects are measured if leaving them out is predicted to save `_WORTH` times the time of a trial;
of these, a set of effects by itself if it saves `_EACH_WORTH` times that."""
_MARGIN, _SURE = 0.9, 0.97
"""Effects are left out while the measured error is at most the fraction `_MARGIN` of the tolerance,
and the error plus two standard errors at most the fraction `_SURE`."""
_OTHER_STATES = 0.5 * MOST_OTHER_STATES
"""Largest measured fraction of pixels in other states when a plan is made."""
_BOUND, _SERVED_OTHER_STATES = 1.05, 0.7 * MOST_OTHER_STATES
"""A plan is reused while its bound on the new scene is at most `_BOUND` times the tolerance, and
the measured fraction of pixels in other states at most `_SERVED_OTHER_STATES`."""
_BOUND_ERRORS = 3.0
"""Number of standard errors that are added to the predicted error to get its bound."""
_QUICK = 3 * SAMPLED // 10
"""Number of pixels that are measured if no figures are requested."""


@dataclass(frozen=True, eq=False)
class _Case:
    """A scene to be planned, and what is known so far: the work of its frames, the request, the
    effects that certainly change nothing here (`absent`), and the tolerance (`allowed`), None for a
    fraction of the noise before a trial. `reused`: whether the plan was made for an earlier scene.

    With a `trial`: the effects that the planner leaves out (`dropped`), and the errors with which
    effects were tried (`tried`), by name."""

    work: Work
    request: PlanRequest
    absent: Names
    allowed: Tolerance | None
    dropped: Names
    tried: Mapping[str, SampledErrors]
    trial: Trial | None = None
    reused: bool = False


def make_plan(scene: PlannedScene, request: PlanRequest) -> Plan:
    """Return the fastest plan found whose error, measured on a sample of the scene, is within the
    tolerance of `request`.

    If measuring would take longer than it saves, the plan simulates every requested effect. The
    errors of effects that the user turned off do not restrict the choice of others; `Plan.breach`
    tells if they exceed the tolerance. Raises Rejected (NS0746) for an invalid tolerance."""
    case = _case(scene, request)
    sets, saved_ms = _promising(case), 0.0
    if sets:
        saved_ms = case.work.saved_ms(request.requested, sets[0], request.frames)
    turns_off = request.effects.auto and bool(request.forced_off - case.absent)
    if not (request.figures or turns_off or saved_ms > _WORTH * case.work.trial_ms(_QUICK)):
        return _plan(case)
    measured = _with_trial(case)
    return _plan(_choice(measured, sets if case.allowed else _promising(measured)))


def measured_again(
    scene: PlannedScene,
    plan: Plan,
    *,
    figures: bool = False,
    tolerance: ToleranceInput | None = None,
) -> Plan:
    """Return `plan`, which was made for another scene, with its error measured on this scene, and
    its tolerance converted to electrons of this scene and sensor unless it is in electrons. Its
    choice of effects stays, even if the error is too large here.

    `figures`: also measure each effect alone, on more pixels. `tolerance`: replaces the plan's, for
    instance the electrons that a percentage has over several scenes; None keeps it. If the plan
    drops nothing and no figures are wanted, nothing is measured."""
    asked = plan.tolerance if tolerance is None else tolerance
    request = PlanRequest(plan.requested_effects, asked, figures=figures)
    case, dropped = replace(_case(scene, request), reused=True), frozenset(plan.names("dropped"))
    if dropped or figures:
        case = replace(_with_trial(case), dropped=dropped - request.forced_off)
    return _plan(case)


def served_plan(scene: PlannedScene, plan: Plan, tolerance: ToleranceInput) -> Plan | None:
    """Return `plan`, made for an earlier scene, with its error measured on this scene; None if the
    error, its bound or the fraction of pixels in other states is too large here for `tolerance`. A
    plan (the effects that are simulated) that drops nothing always fits."""
    plan = measured_again(scene, plan, tolerance=tolerance)
    tolerance_e = plan.tolerance_e or 0.0
    # What was not measured counts as 0.
    fits = (
        (plan.predicted_e or 0.0) <= _SURE * tolerance_e
        and (plan.bound_e or 0.0) <= _BOUND * tolerance_e
        and (plan.other_states or 0.0) <= _SERVED_OTHER_STATES
    )
    return plan if fits else None


def absent_effects(scene: PlannedScene) -> Names:
    """Return the names of the effects of the exposure that certainly change nothing on `scene`:
    motion of still light, comparators if no pixel compares, saturation if no pixel comes near
    it."""
    all_effects, names = everything(), Names()
    if scene.light.motion is None:
        names |= all_effects.names(Moving)
    if not scene.looks:
        names |= {e.name for e in effects_of_exposure() if e.reference.keys() == {"compare"}}
        if not len(scene.near_pixels(all_effects).places):
            names |= all_effects.names(Saturates)
    return names


def _case(scene: PlannedScene, request: PlanRequest) -> _Case:
    """Return what is known without a trial. Raises Rejected (NS0746) for an invalid tolerance."""
    asked, sensor = request.tolerance, scene.sensor
    allowed = None if unit_of(asked) == "noise" else tolerance_of(asked, sensor, scene.signal_e)
    if allowed is None:
        check_tolerance(asked, sensor)
    return _Case(Work.of(scene), request, absent_effects(scene), allowed, Names(), {})


def _with_trial(case: _Case) -> _Case:
    """Expose a sample of the scene with every effect, with figures a larger one. Also measure the
    tolerance if it is not known."""
    scene, request = case.work.scene, case.request
    trial = trial_of(scene, SAMPLED if request.figures else _QUICK)
    allowed = case.allowed or tolerance_of(request.tolerance, scene.sensor, noise_e=trial.noise_e)
    return replace(case, trial=trial, allowed=allowed)


def _promising(case: _Case) -> list[Names]:
    """Return the sets of effects that may be left out together, those that save most first. They
    are single effects, and groups of effects that share work; effects that the user decided on and
    absent ones are not in them.

    Without figures, sets must save enough to be measured, their estimated error must be within
    the tolerance if that is known, and before them comes the union of as many as fit together."""
    work, request, all_effects = case.work, case.request, everything()
    # Noise may drive any pixel near saturation beyond a limit, in few frames: too rare to measure.
    free = frozenset(e.name for e in effects_of_exposure()) - all_effects.names(Saturates)
    free -= request.forced | case.absent
    limit_e2, size_e2, least_ms = math.inf, dict[str, float](), 0.0
    if not request.figures:
        least_ms = _EACH_WORTH * work.trial_ms(_QUICK)
        if case.allowed:
            limit_e2 = (_MARGIN * case.allowed.electrons) ** 2
            # A quarter of the rows tells which errors are far too large.
            for step in (4, 1):
                size_e2 = _estimated_e2(work.scene, free, step)
                free = frozenset(n for n in free if size_e2.get(n, 0.0) <= step * limit_e2)

    def fits(names: Names) -> bool:
        """Return whether the estimated error of leaving out `names` leaves the margin."""
        return sum(size_e2.get(name, 0.0) for name in names) <= limit_e2

    groups = [all_effects.names(kind) for kind in (Counted, SmallErrors)]
    sets = {frozenset({name}) for name in free} | {names for names in groups if names <= free}
    saved_ms = {
        names: work.saved_ms(request.requested, names, request.frames)
        for names in sets
        if names and fits(names)
    }
    ordered = sorted(saved_ms, key=lambda names: (-saved_ms[names], sorted(names)))
    ordered = [names for names in ordered if saved_ms[names] > least_ms]
    union = Names()
    for names in ordered if not request.figures else ():
        union |= names if fits(union | names) else Names()
    return [union, *ordered] if union else ordered


def _estimated_e2(scene: PlannedScene, names: Names, step: int) -> dict[str, float]:
    """Return rough mean square errors of leaving out those effects of `names` whose size follows
    from the light and the sensor, by name: noise of counts and of words, and crosstalk. Only each
    `step`-th strip of rows is looked at."""
    all_effects, sensor = everything(), scene.sensor
    square_e2 = {
        effect.name: part.sigma_e(sensor) ** 2
        for effect, part in all_effects.errors()
        if part.at != "resets"  # double sampling subtracts these
    }
    counted, exchange = all_effects.names(CountedLight), all_effects.having(Exchange)
    if scene.looks or not names & (counted | {effect.name for effect, _ in exchange}):
        return square_e2
    program = analysed(scene.container, sensor)

    def strips(values: Array) -> Array:
        """Return the rows of `values` (rows, cols) that are looked at, (.., rows, cols)."""
        if step == 1 or len(values) < 8 * step:
            return values
        return values[: len(values) // 8 * 8].reshape(-1, 8, values.shape[1])[::step]

    def open_share() -> Array:
        """Return the fraction of the slots in which each pixel is open."""
        return strips(program.opened.mean(axis=0, dtype=np.float32).max(axis=1)[program.lane])

    light_e = strips(scene.light.sum_e)
    share = program.recent.of((_estimated_e2, step), open_share)

    def exposed_e(light_e: Array) -> Array:
        """Return the exposures in `light_e`, about; light that is NaN or infinite fills a pixel."""
        return np.asarray(np.fmin(light_e * share, np.float32(sensor.full_well_e)))

    alone_e = exposed_e(light_e)
    square_e2 |= dict.fromkeys(counted, float(alone_e.mean()))
    for effect, part in exchange:
        moved_e = exposed_e(part.smeared(light_e, part.fraction(sensor))) - alone_e
        square_e2[effect.name] = float((moved_e**2).mean())
    return square_e2


def _choice(case: _Case, sets: Iterable[Names]) -> _Case:
    """Return the case with the effects that are left out: those of each of the `sets` in turn, if
    the error of all together is within the tolerance. The error is that of what the planner leaves
    out, from the exposures without the effects that the user turned off."""
    request, trial, allowed = case.request, case.trial, case.allowed
    assert trial
    assert allowed
    dropped, tried = Names(), dict[str, SampledErrors]()

    def fits(names: Names) -> bool:
        """Return whether the error of leaving out `names`, also with two standard errors added,
        and the fraction of pixels in other states are within their limits."""
        effects = request.requested.without(*names)
        errors = trial.errors(effects, request.requested)
        tried.update(dict.fromkeys(names, errors))
        sure_e2, limit_e2 = errors.square_e2(2.0), (_SURE * allowed.electrons) ** 2
        return (
            errors.other_states <= _OTHER_STATES
            and errors.square_e2() <= (_MARGIN * allowed.electrons) ** 2
            and sure_e2 <= limit_e2
            and sure_e2 + trial.unseen_e2(effects) <= limit_e2
        )

    for names in sets:
        # With figures every effect is measured alone anyway.
        if not names <= dropped and (not request.figures or fits(names)) and fits(dropped | names):
            dropped |= names
    return replace(case, dropped=dropped, tried=tried)


def _plan(case: _Case) -> Plan:
    """Return the plan (the effects that are simulated) of a choice: its errors, a decision on every
    effect with its reason, and its predicted time. Without a trial every requested effect is
    simulated."""
    work, request, scene = case.work, case.request, case.work.scene
    effects, trial, allowed = request.requested.without(*case.dropped), case.trial, case.allowed
    reasons = scene.needs_reference(effects)
    if not reasons and scene.looks:
        reasons = ("pixels look at the light: each runs through the words that act in it",)
    elif not reasons:
        chip = scene.container, scene.sensor, [scene.light]
        reasons = word_reasons(*chip, effects, scene.device_seed)

    errors: dict[str, float | None] = {}
    if trial:
        sampled = trial.errors(effects, everything())
        bound_e2 = sampled.square_e2(_BOUND_ERRORS) + trial.unseen_e2(effects)
        errors = {
            "sampled_fraction": len(trial.sample.places) / scene.pixels,
            "predicted_e": sampled.rms_e,
            "bound_e": math.sqrt(bound_e2),
            "worst_e": sampled.worst_e,
            "other_states": sampled.other_states if scene.looks else None,
        }
    return Plan(
        tolerance=allowed.text if allowed else str(request.tolerance),
        tolerance_e=allowed.electrons if allowed else None,
        slot_loop=bool(reasons),
        slot_loop_reasons=reasons,
        total_ms=work.milliseconds(effects),
        all_ms=work.milliseconds(request.requested),
        decisions=tuple(_decision(each, case) for each in registered()),
        reused=case.reused,
        **errors,  # type: ignore[arg-type]
    )


def _decision(effect: Effect, case: _Case) -> Decision:
    """Return whether one effect is kept, dropped or absent, with its errors, the time that it
    costs, and the reason. In the code, `alone` is the error of dropping only this effect."""
    name, request, scene = effect.name, case.request, case.work.scene
    is_off = effect not in request.effects or name in case.dropped
    decision: Choice = "dropped" if is_off else "kept"
    is_forced = name in request.forced and not effect.always
    if effect.kind == "after":
        reason = "named in --effects" if is_forced else "always applied, after the exposure"
        error_lsb, lsb_e = effect.code_error_lsb(scene.sensor), scene.sensor.electrons_per_lsb
        rms_e = None if error_lsb is None else error_lsb * lsb_e
        return Decision(name, effect.kind, decision, is_forced, reason, rms_e, 0.0)
    full, alone, saved_ms, tried = everything(), None, 0.0, case.tried.get(name)
    if case.trial and request.figures and name not in case.absent:
        alone = case.trial.errors(full.without(name), full)
    if not is_off and (
        name in case.absent or (alone and max(alone.worst_e, alone.other_states) == 0.0)
    ):
        decision = "absent"
    elif case.trial:
        saved_ms = max(0.0, case.work.saved_ms(full, frozenset({name})))
    if case.reused and case.trial:
        reason = "taken from an earlier plan"
    elif decision == "absent":
        reason = effect.absent
    elif is_forced:
        reason = "named in --effects"
    elif case.trial is None:
        reason = "choosing effects would take longer than it saves"
    elif is_off:
        reason = ("" if alone is None else f"{alone.rms_e:.3g} e ") + "fits into the tolerance"
    elif saved_ms <= 0:
        reason = "costs nothing"
    elif tried is None or case.allowed is None:
        reason = "saves too little, or is too large, to be tried"
    elif tried.rms_e > _MARGIN * case.allowed.electrons:
        reason = f"left out, the error would be {tried.rms_e:.3g} e"
    elif tried.other_states > _OTHER_STATES:
        reason = f"left out, {tried.other_states:.2%} would end in other states"
    else:
        reason = "left out, the error could be too large: few pixels tell"
    # `alone` is the exposure without the effect minus that with it, so the effect's own bias has
    # the opposite sign; 0.0 - x is never -0.
    return Decision(
        name,
        effect.kind,
        decision,
        is_forced,
        reason,
        alone.rms_e if alone else None,
        0.0 - alone.bias_e if alone else None,
        tried.rms_e if tried else None,
        saved_ms,
        alone.other_states if alone and scene.looks else None,
    )
