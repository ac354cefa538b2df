"""Make a plan for a scene.

1. List the sets of effects that may be dropped, those that save most time first (`_moves`).
2. Draw a sample of the pixels (`sample`), and expose it with every effect.
3. Drop one set after the other. Measure the error of all dropped effects on the sample, with the
   same random numbers; keep the set if the error, or the error plus two standard errors, is too
   near to the tolerance (`fits`).

Effects are only measured if that is predicted to save more time than it takes, or if the user
requests the table. Otherwise every effect is simulated."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from nscc_runtime.effects import everything
from nscc_runtime.effects.parts import Counted, CountedLight, Moving, Saturates
from nscc_runtime.effects.parts import Errors as SmallErrors
from nscc_runtime.execution.program import analysed
from nscc_runtime.planning.decisions import (
    FROM_EARLIER_PLAN,
    MARGIN,
    EffectChoice,
    decided_plan,
    reasons_for_words,
)
from nscc_runtime.planning.plan import MOST_OTHER_STATES, Plan
from nscc_runtime.planning.plan_request import Names, PlanRequest, effects_of_exposure
from nscc_runtime.planning.planned_scene import (
    SAMPLED,
    PlannedScene,
    trial_of,
    unseen_square_e2,
)
from nscc_runtime.planning.prices import Work
from nscc_runtime.planning.sample import SampledErrors
from nscc_runtime.planning.tolerance import (
    Tolerance,
    ToleranceInput,
    check_tolerance,
    tolerance_of,
    unit_of,
)

_WORTH = 2.0
"""Effects are measured if that is predicted to save this multiple of the time that it takes."""
_SURE = 0.97
"""Effects are dropped while the measured error plus two standard errors is at most this fraction of
the tolerance."""
_OTHER_STATES = 0.5 * MOST_OTHER_STATES
"""Largest measured fraction of pixels in other states when a plan is made."""
_BOUND, _SERVED_OTHER_STATES = 1.05, 0.7 * MOST_OTHER_STATES
"""A plan is reused while its bound on the new scene is at most `_BOUND` times the tolerance, and
the measured fraction of pixels in other states at most `_SERVED_OTHER_STATES`."""
_QUICK = SAMPLED // 4
"""Number of pixels that are measured if no figures are requested."""


def make_plan(scene: PlannedScene, request: PlanRequest) -> Plan:
    """Return the fastest plan found whose error, measured on a sample of the scene, is within the
    tolerance of `request`.

    If measuring would take longer than it saves, the plan simulates every requested effect. The
    errors of effects that the user turned off do not restrict the choice of others; `Plan.breach`
    tells if they exceed the tolerance. Raises Rejected (NS0746) for an invalid tolerance."""
    check_tolerance(request.tolerance, scene.sensor)
    work, absent = Work.of(scene), absent_effects(scene)
    moves = _moves(work, request, absent)
    trial_ms = 0.0 if request.figures else _WORTH * work.trials_ms(1, _QUICK)
    is_checked = request.effects.auto and bool(request.forced_off - absent)
    if not (request.figures or is_checked or sum(moves.values()) > 3.0 * trial_ms):
        return _unmeasured(work, request, absent)
    measuring = _Measuring(scene, request)
    alone = measuring.drop_each(absent) if request.figures else {}
    hopeless = Names() if request.figures else _too_large(scene, measuring.allowed)
    dropped = Names()
    together, _ = measuring.drop_together(dropped)
    for names, saved_ms in moves.items():
        if names & hopeless or names <= dropped or saved_ms <= trial_ms:
            continue
        if names not in alone or measuring.fits(alone[names]):
            candidate, by_choice = measuring.drop_together(dropped | names)
            if measuring.fits(by_choice):
                dropped, together = dropped | names, candidate
    choice = EffectChoice(work, request, absent, measuring.allowed, dropped, together, alone)
    return decided_plan(choice)


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
    work, absent = Work.of(scene), absent_effects(scene)
    allowed = plan.tolerance if tolerance is None else tolerance
    request = PlanRequest(plan.requested_effects, allowed, figures=figures)
    dropped = frozenset(plan.names("dropped"))
    if not (dropped or figures):
        return replace(_unmeasured(work, request, absent), reused=True)
    measuring = _Measuring(scene, request)
    dropped -= request.forced_off
    together, _ = measuring.drop_together(dropped)
    alone = measuring.drop_each(absent) if figures else {}
    made = decided_plan(
        EffectChoice(work, request, absent, measuring.allowed, dropped, together, alone)
    )
    decisions = (
        decision if decision.kind == "after" else replace(decision, reason=FROM_EARLIER_PLAN)
        for decision in made.decisions
    )
    return replace(made, decisions=tuple(decisions), reused=True)


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


def _unmeasured(work: Work, request: PlanRequest, absent: Names) -> Plan:
    """Return the plan that simulates every requested effect, without measured errors. `absent`:
    effects that change nothing here. A tolerance that is a fraction of the noise is not converted
    to electrons, because that takes as long as measuring."""
    scene = work.scene
    allowed = None
    if unit_of(request.tolerance) != "noise":
        allowed = tolerance_of(request.tolerance, scene.sensor, scene)
    choice = EffectChoice(work, request, absent, allowed)
    if scene.looks:
        return decided_plan(choice)
    # Nothing else of the scene and the chip is in the plan.
    reasons = reasons_for_words(scene, request.requested)
    key = Plan, request, absent, allowed, work.near, len(scene.light.frames), reasons
    recent = analysed(scene.container, scene.sensor).recent
    return recent.of(key, lambda: decided_plan(choice))


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


def _moves(work: Work, request: PlanRequest, absent: Names) -> dict[Names, float]:
    """Return the sets of effects that may be dropped together, and the milliseconds that each saves
    of all requested frames; those that save most first, and none that saves nothing.

    These are single effects and the groups whose effects share work. Effects that the user decided
    on and `absent` ones are not in them. Without figures, effects that are certainly too large are
    left out."""
    all_effects = everything()
    # Noise may drive any pixel near saturation beyond a limit, in few frames: too rare to measure.
    free = frozenset(e.name for e in effects_of_exposure()) - all_effects.names(Saturates)
    free -= request.forced | absent
    if free and not request.figures and unit_of(request.tolerance) != "noise":
        free -= _too_large(
            work.scene, tolerance_of(request.tolerance, work.scene.sensor, work.scene)
        )
    groups = [all_effects.names(kind) - absent for kind in (Counted, SmallErrors)]
    sets = {names for names in groups if names and names <= free}
    sets |= {frozenset({name}) for name in free}
    if not sets:
        return {}
    requested = request.requested
    all_ms = work.milliseconds(requested, request.frames)
    saved_ms = {
        names: all_ms - work.milliseconds(requested.without(*names), request.frames)
        for names in sets
    }
    ordered = sorted(sets, key=lambda names: (-saved_ms[names], sorted(names)))
    return {names: saved_ms[names] for names in ordered if saved_ms[names] > 0}


def _too_large(scene: PlannedScene, allowed: Tolerance) -> Names:
    """Return the names of the effects whose noise alone certainly exceeds the tolerance `allowed`,
    so that dropping them need not be measured."""
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
        least_e |= dict.fromkeys(all_effects.names(CountedLight), 0.5 * light_e.mean() ** 0.5)
    return frozenset(name for name, error_e in least_e.items() if error_e > allowed.electrons)


class _Measuring:
    """Measurements on a sample of a scene, for one request.

    `allowed`: the tolerance in electrons. `base`: the exposures with every effect that the user did
    not force off: the planner's own choice has to keep the tolerance relative to these."""

    def __init__(self, scene: PlannedScene, request: PlanRequest) -> None:
        """Expose a sample of `scene` with every effect and, if the user turned some off, also
        without these, and convert the tolerance to electrons. With figures the sample is larger."""
        self.requested = request.requested
        self.trial = trial_of(scene, SAMPLED if request.figures else _QUICK)
        self.base = self.trial.truth
        if request.forced_off:
            self.base = self.trial.exposures(self.requested)
        self.allowed = tolerance_of(request.tolerance, scene.sensor, self.trial)

    def drop_each(self, absent: Names) -> dict[Names, SampledErrors]:
        """Return the error of dropping each effect of the exposure that is not in `absent`, by a
        set with its name alone, while every other requested effect is simulated. For an effect that
        the user turned off, it is the error of not having it."""
        errors = {}
        for name in (e.name for e in effects_of_exposure() if e.name not in absent):
            if name in self.requested.on:
                true, effects = self.base, self.requested.without(name)
                errors[frozenset({name})] = self.trial.between(self.trial.exposures(effects), true)
            else:
                true = self.trial.exposures(self.requested.including(name))
                errors[frozenset({name})] = self.trial.between(self.base, true)
        return errors

    def fits(self, errors: SampledErrors) -> bool:
        """Return whether `errors`, also with two standard errors added, and the fraction of pixels
        in other states are within their limits, with a margin (`MARGIN`, `_SURE`)."""
        tolerance_e = self.allowed.electrons
        return (
            errors.square_e2() <= (MARGIN * tolerance_e) ** 2
            and errors.square_e2(2.0) <= (_SURE * tolerance_e) ** 2
            and errors.other_states <= _OTHER_STATES
        )

    def drop_together(self, dropped: Names) -> tuple[SampledErrors, SampledErrors]:
        """Return the errors of dropping the effects `dropped` at once, besides those that the user
        turned off: relative to all effects, and relative to those that the user did not turn
        off."""
        effects = self.requested.without(*dropped)
        exposed = self.trial.exposures(effects) if dropped else self.base
        together = self.trial.between(exposed, self.trial.truth)
        by_choice = self.trial.between(exposed, self.base)
        # If the error is too large already, what the sample may not contain does not matter.
        if by_choice.square_e2(2.0) <= (_BOUND * self.allowed.electrons) ** 2:
            unseen_e2 = unseen_square_e2(self.trial, effects)
            together = replace(together, unseen_e2=unseen_e2)
            by_choice = replace(by_choice, unseen_e2=unseen_e2)
        return together, by_choice
