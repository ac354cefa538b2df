"""Make a plan for a scene.

1. List the sets of effects that may be left out, those that save most time first (`_moves`).
2. Expose a sample of the pixels with every effect (`trial_of`).
3. Leave out all sets at once whose estimated errors fit into the tolerance, else one after the
   other. Measure the error of everything that is left out on the sample, with the same random
   numbers; a set stays on if the error is too near to the tolerance (`_fits`).
4. Say of each effect what was decided, and why (`_decision`).

Effects are only measured if that is predicted to save more time than it takes, or if the user
requests the table. Otherwise every effect is simulated."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import numpy as np

from nscc.arrays import Array
from nscc_runtime.effects import Effect, Selection, everything, registered
from nscc_runtime.effects.parts import (
    CodeErrors,
    Codes,
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
    """A scene to be planned: the work of its frames, and the request. `absent`: effects that
    certainly change nothing here. `reused`: whether the plan was made for an earlier scene."""

    work: Work
    request: PlanRequest
    absent: Names
    reused: bool = False


@dataclass(frozen=True, eq=False)
class _Measured:
    """What was measured: the `trial`, the effects that the planner leaves out (`dropped`), and the
    errors with which others were tried and kept (`tried`), by the name of the effect."""

    trial: Trial
    dropped: Names
    tried: Mapping[str, SampledErrors]


def make_plan(scene: PlannedScene, request: PlanRequest) -> Plan:
    """Return the fastest plan found whose error, measured on a sample of the scene, is within the
    tolerance of `request`.

    If measuring would take longer than it saves, the plan simulates every requested effect. The
    errors of effects that the user turned off do not restrict the choice of others; `Plan.breach`
    tells if they exceed the tolerance. Raises Rejected (NS0746) for an invalid tolerance."""
    check_tolerance(request.tolerance, scene.sensor)
    case = _Case(Work.of(scene), request, absent_effects(scene))
    allowed, moves = _known_tolerance(scene, request), _moves(case)
    sizes_e = {} if request.figures or not moves else _estimated_e(scene)
    sets = _promising(moves, sizes_e, allowed)
    is_checked = request.effects.auto and bool(request.forced_off - case.absent)
    saved_ms = case.work.saved_ms(request.requested, sets[0], request.frames) if sets else 0.0
    is_worth = saved_ms > _WORTH * case.work.trials_ms(1, _QUICK)
    if not (request.figures or is_checked or is_worth):
        return _plan(case, allowed)
    trial, allowed = _trial(case, allowed)
    sets = _promising(moves, sizes_e, allowed)
    return _plan(case, allowed, _dropped(case, trial, allowed, sets))


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
    case = _Case(Work.of(scene), request, absent_effects(scene), reused=True)
    dropped, allowed = frozenset(plan.names("dropped")), _known_tolerance(scene, request)
    if not (dropped or figures):
        return _plan(case, allowed)
    trial, allowed = _trial(case, allowed)
    return _plan(case, allowed, _Measured(trial, dropped - request.forced_off, {}))


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
    all_effects, names = everything(), frozenset[str]()
    if scene.light.motion is None:
        names |= all_effects.names(Moving)
    if not scene.looks:
        names |= {e.name for e in effects_of_exposure() if e.reference.keys() == {"compare"}}
        if not len(scene.near_pixels(all_effects).places):
            names |= all_effects.names(Saturates)
    return names


def _known_tolerance(scene: PlannedScene, request: PlanRequest) -> Tolerance | None:
    """Return the tolerance; None for a fraction of the noise, which only a trial measures."""
    is_known = unit_of(request.tolerance) != "noise"
    return tolerance_of(request.tolerance, scene.sensor, scene) if is_known else None


def _trial(case: _Case, allowed: Tolerance | None) -> tuple[Trial, Tolerance]:
    """Expose a sample of the scene with every effect, with figures a larger one; return the trial,
    and the tolerance, measured if it is not known (None)."""
    scene, request = case.work.scene, case.request
    trial = trial_of(scene, SAMPLED if request.figures else _QUICK)
    return trial, allowed or tolerance_of(request.tolerance, scene.sensor, trial)


def _moves(case: _Case) -> dict[Names, float]:
    """Return the sets of effects that may be left out together, and the milliseconds that each
    saves of all requested frames; those that save most first. Without figures, they are those that
    save enough to be measured, else all that save anything.

    These are single effects and the groups whose effects share work. Effects that the user decided
    on and absent ones are not in them."""
    work, request, all_effects = case.work, case.request, everything()
    # Noise may drive any pixel near saturation beyond a limit, in few frames: too rare to measure.
    free = frozenset(e.name for e in effects_of_exposure()) - all_effects.names(Saturates)
    free -= request.forced | case.absent
    if not free:
        return {}
    groups = [all_effects.names(kind) - case.absent for kind in (Counted, SmallErrors)]
    sets = {names for names in groups if names and names <= free}
    sets |= {frozenset({name}) for name in free}
    saved_ms = {names: work.saved_ms(request.requested, names, request.frames) for names in sets}
    least_ms = 0.0 if request.figures else _EACH_WORTH * work.trials_ms(1, _QUICK)
    ordered = sorted(sets, key=lambda names: (-saved_ms[names], sorted(names)))
    return {names: saved_ms[names] for names in ordered if saved_ms[names] > least_ms}


def _estimated_e(scene: PlannedScene) -> dict[str, float]:
    """Return rough errors of leaving out effects whose size follows from the light and the sensor,
    in electrons, by name: noise of counts and of words, and crosstalk."""
    all_effects, sensor = everything(), scene.sensor
    sizes_e = {
        effect.name: part.sigma_e(sensor)
        for effect, part in all_effects.errors()
        if part.at != "resets"  # double sampling subtracts these
    }
    if scene.looks:
        return sizes_e
    program, light_e = analysed(scene.container, sensor), scene.light.sum_e
    open_share = program.opened.mean(axis=0, dtype=np.float32).max(axis=1)[program.lane]

    def exposed_e(light_e: Array) -> Array:
        """Return the exposures in `light_e`, about; light that is NaN or infinite fills a pixel."""
        most_e = np.fmin(light_e * open_share, np.float32(sensor.full_well_e))
        return np.asarray(np.maximum(most_e, 0.0))

    alone_e = exposed_e(light_e)
    sizes_e |= dict.fromkeys(all_effects.names(CountedLight), float(alone_e.mean()) ** 0.5)
    for effect, part in all_effects.having(Exchange):
        moved_e = (
            exposed_e(part.smeared(light_e.astype(np.float64), part.fraction(sensor))) - alone_e
        )
        sizes_e[effect.name] = float((moved_e**2).mean()) ** 0.5
    return sizes_e


def _promising(
    moves: Mapping[Names, float], sizes_e: Mapping[str, float], allowed: Tolerance | None
) -> list[Names]:
    """Return the sets of `moves` whose estimated error is within the tolerance `allowed` (None if
    it is not known), and before them, with estimates, the union of as many as fit together."""
    limit_e2 = math.inf if allowed is None else (_MARGIN * allowed.electrons) ** 2

    def fits(names: Names) -> bool:
        """Return whether the estimated error of leaving out `names` leaves the margin."""
        return sum(sizes_e.get(name, 0.0) ** 2 for name in names) <= limit_e2

    sets, union = [names for names in moves if fits(names)], Names()
    for names in sets if sizes_e else ():
        if fits(union | names):
            union |= names
    return [*dict.fromkeys([union] if union else []), *sets]


def _dropped(case: _Case, trial: Trial, allowed: Tolerance, sets: Iterable[Names]) -> _Measured:
    """Return the effects that are left out: those of each of the `sets` in turn, if the error of
    all together is within the tolerance. The error is that of what the planner leaves out, from
    the exposures without the effects that the user turned off."""
    requested, tolerance_e = case.request.requested, allowed.electrons
    dropped, tried = Names(), dict[str, SampledErrors]()

    def fits(names: Names) -> bool:
        """Return whether the error of leaving out `names`, also with two standard errors added,
        and the fraction of pixels in other states are within their limits."""
        effects = requested.without(*names)
        errors = trial.errors(effects, requested)
        tried.update(dict.fromkeys(names, errors))
        sure_e2, limit_e2 = errors.square_e2(2.0), (_SURE * tolerance_e) ** 2
        return (
            errors.other_states <= _OTHER_STATES
            and errors.square_e2() <= (_MARGIN * tolerance_e) ** 2
            and sure_e2 <= limit_e2
            and sure_e2 + trial.unseen_e2(effects) <= limit_e2
        )

    for names in sets:
        # With figures every effect is measured alone anyway.
        if names <= dropped or (case.request.figures and not fits(names)):
            continue
        if fits(dropped | names):
            dropped |= names
    return _Measured(trial, dropped, tried)


def _plan(case: _Case, allowed: Tolerance | None, measured: _Measured | None = None) -> Plan:
    """Return the plan (the effects that are simulated) of a choice: its errors, a decision on every
    effect with its reason, and its predicted time. `allowed`: the tolerance, None if it is unknown.

    `measured`: None if nothing was measured. Then every requested effect is simulated."""
    work, request, scene = case.work, case.request, case.work.scene
    effects = request.requested.without(*measured.dropped) if measured else request.requested
    reasons = _reasons_for_words(scene, effects)

    def make() -> Plan:
        """Return the plan."""
        errors, bound_e = None, None
        if measured:
            errors = measured.trial.errors(effects, everything())
            bound_e2 = errors.square_e2(_BOUND_ERRORS) + measured.trial.unseen_e2(effects)
            bound_e = math.sqrt(bound_e2)
        return Plan(
            tolerance=str(request.tolerance) if allowed is None else allowed.text,
            tolerance_e=None if allowed is None else allowed.electrons,
            predicted_e=errors.rms_e if errors else None,
            bound_e=bound_e,
            worst_e=errors.worst_e if errors else None,
            slot_loop=bool(reasons),
            slot_loop_reasons=reasons,
            sampled_fraction=len(errors.weight) / scene.pixels if errors else 0.0,
            total_ms=work.milliseconds(effects),
            all_ms=work.milliseconds(request.requested),
            decisions=tuple(_decision(each, case, allowed, measured) for each in registered()),
            signal_e=None if allowed is None else allowed.signal_e,
            noise_e=None if allowed is None else allowed.noise_e,
            other_states=errors.other_states if errors and scene.looks else None,
            reused=case.reused,
        )

    if measured or scene.looks:
        return make()
    # Nothing else of the scene and the chip is in a plan without a measurement.
    key = Plan, request, case.absent, case.reused, allowed, work.near, reasons
    recent = analysed(scene.container, scene.sensor).recent
    return recent.of((*key, len(scene.light.frames)), make)


def _reasons_for_words(scene: PlannedScene, effects: Selection) -> tuple[str, ...]:
    """Return why the words of some pixels run one by one under `effects`; empty if sums suffice for
    all."""
    reasons = scene.needs_reference(effects)
    if reasons:
        return reasons
    if scene.looks:
        return ("pixels look at the light: each runs through the words that act in it",)
    chip = scene.container, scene.sensor, [scene.light]
    return word_reasons(*chip, effects, scene.device_seed)


def _decision(
    effect: Effect, case: _Case, allowed: Tolerance | None, measured: _Measured | None
) -> Decision:
    """Return whether one effect is kept, dropped or absent, with its errors, the time that it
    costs, and the reason. In the code, `alone` is the error of dropping only this effect."""
    if effect.kind == "after":
        return _after_exposure(effect, case)
    name, request, full, alone = effect.name, case.request, everything(), None
    tried = measured.tried.get(name) if measured else None
    if measured and request.figures and name not in case.absent:
        alone = measured.trial.errors(full.without(name), full)
    is_off = name in request.forced_off or (measured is not None and name in measured.dropped)
    is_absent = not is_off and (name in case.absent or (alone is not None and alone.is_zero))
    saved_ms = 0.0
    if measured and not is_absent:
        saved_ms = max(0.0, case.work.saved_ms(full, frozenset({name})))
    if case.reused and measured:
        reason = "taken from an earlier plan"
    elif is_absent:
        reason = effect.absent
    elif name in request.forced:
        reason = "named in --effects"
    elif measured is None:
        reason = "choosing effects would take longer than it saves"
    elif is_off:
        reason = ("" if alone is None else f"{alone.rms_e:.3g} e ") + "fits into the tolerance"
    else:
        reason = _why_kept(tried, saved_ms, allowed)
    # `alone` is the exposure without the effect minus that with it, so the effect's own bias has
    # the opposite sign; 0.0 - x is never -0.
    return Decision(
        name,
        effect.kind,
        "absent" if is_absent else "dropped" if is_off else "kept",
        name in request.forced,
        reason,
        alone.rms_e if alone else None,
        0.0 - alone.bias_e if alone else None,
        tried.rms_e if tried else None,
        saved_ms,
        alone.other_states if alone and case.work.scene.looks else None,
    )


def _why_kept(errors: SampledErrors | None, saved_ms: float, allowed: Tolerance | None) -> str:
    """Return, as text, the reason why the planner simulates an effect. `errors`: those with which
    dropping it was tried. `saved_ms`: the milliseconds that this would save."""
    if saved_ms <= 0:
        return "costs nothing"
    if errors is None or allowed is None:
        return "saves too little, or is too large, to be tried"
    if errors.rms_e > _MARGIN * allowed.electrons:
        return f"left out, the error would be {errors.rms_e:.3g} e"
    if errors.other_states > _OTHER_STATES:
        return f"left out, {errors.other_states:.2%} would end in other states"
    return "left out, the error could be too large: few pixels tell"


def _after_exposure(effect: Effect, case: _Case) -> Decision:
    """Return the decision on an effect of the readout. It is simulated if the user selects it, or
    with automatic effects unless the user turns it off. The tolerance does not include its error,
    which is None for effects that have no size of their own."""
    request, sensor = case.request, case.work.scene.sensor
    forced = not effect.always and effect.name in request.forced
    code_e = everything().require_part(Codes).electrons(sensor)
    rms_e = code_e / math.sqrt(12.0) if effect.parts_of_kind(Codes) else None
    for errors in effect.parts_of_kind(CodeErrors):
        rms_e = errors.sigma_lsb(sensor) * code_e
    is_on = effect in request.effects or (request.effects.auto and not forced)
    reason = "named in --effects" if forced else "always applied, after the exposure"
    decision: Choice = "kept" if is_on else "dropped"
    return Decision(effect.name, effect.kind, decision, forced, reason, rms_e, 0.0)
