"""Make a plan for a scene, in five steps.

1. `sample`: draw pixels of the scene, weighted by the number of pixels that each represents.
2. `choose`: drop each effect alone, on these pixels with the same random numbers.
3. `choose`: find the sets of effects that save most time, if their errors add up to less than the
   tolerance.
4. `choose`: drop all effects of a set at once and compare with the truth. If the error plus two
   standard errors exceeds the tolerance, try the next set.
5. `decisions`: enter for every effect whether it is simulated, its measured error and the reason.

Effects are only measured if that saves more time than it takes, or if the user requests the table.
Otherwise every effect is simulated."""

from __future__ import annotations

from dataclasses import dataclass

from nscc_runtime.effects import Selection, registered
from nscc_runtime.planning.choose import (
    MARGIN,
    Limits,
    choose_cheapest,
    measure_effects,
    measure_together,
    tried_together,
)
from nscc_runtime.planning.decisions import FROM_GIVEN_PLAN, Demands, planned, unmeasured
from nscc_runtime.planning.plan import Plan
from nscc_runtime.planning.plan_parts import MOST_OTHER_STATES
from nscc_runtime.planning.planned_scene import NONE, Names, PlannedScene, Setting, Trial
from nscc_runtime.planning.tolerance import (
    DEFAULT,
    OPTION_MAX,
    Tolerance,
    ToleranceInput,
    check_tolerance,
    noise_part,
    tolerance_of,
)

MANY = 1000
"""Default number of frames that share a plan."""
_APPROXIMATED = 0.6
"""If the approximations of sums have an error above this fraction of the tolerance, all pixels run
through their words instead."""
_NEGLIGIBLE = 0.05
"""Approximations of sums with errors below this fraction of the tolerance are not measured."""
_ONE_COUNT_E = 1.0
"""Error of sums in rare pixels, in electrons. With a smaller `tolerance_max`, all pixels run
through their words."""
_HOPED = 0.35
"""Typical time saved by a plan, as a fraction of the time saved by dropping all effects that the
user did not force."""
_OTHER_STATES, _SERVED_OTHER_STATES = 0.5, 0.7
"""Largest measured fraction of pixels in other states, relative to `MOST_OTHER_STATES`: when a plan
is made, and when it is reused for another scene."""


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


def make_plan(scene: PlannedScene, request: PlanRequest) -> Plan:
    """Return the fastest plan whose error, measured on a sample of the scene, is within tolerance.

    If measuring would take longer than it saves, the plan simulates every effect instead. Raises
    Rejected (NS0746) for an invalid tolerance."""
    effects = request.effects
    forced = frozenset(e.name for e in registered() if not effects.auto or e.name in effects.forced)
    forced_off = frozenset(
        e.name for e in registered() if e.name in forced and e not in effects and e.kind != "after"
    )
    trial = scene.trial(forced_off)
    reason = _not_worth(scene, trial, request, forced)
    if reason is not None:
        allowed = _known(scene, request.tolerance)
        path, why = scene.exact_path(allowed)
        demands = Demands(effects, forced, allowed, None, str(request.tolerance))
        return unmeasured(trial, demands, path, why, reason)
    demands = Demands(effects, forced, tolerance_of(request.tolerance, scene.sensor, scene), None)
    free = frozenset(e.name for e in registered() if e.kind != "after") - forced
    return _measured(scene, trial, demands, free, request.figures)


def measured_again(scene: PlannedScene, plan: Plan) -> Plan:
    """Return a plan with its errors and its relative tolerance measured on this scene."""
    off = frozenset(e.name for e in registered() if e.kind != "after" and e not in plan.kept)
    forced_off = frozenset(e.name for e in registered() if e not in plan.requested_effects) & off
    trial = scene.trial(forced_off)
    allowed, most = allowed_on(scene, *plan.tolerance_inputs)
    if plan.slot_loop in ("all", "reference"):
        trial = scene.slower_trial(trial, allowed.electrons) or trial
    forced = frozenset(decision.name for decision in plan.decisions if decision.forced)
    demands = Demands(plan.kept, forced, allowed, most, reason=FROM_GIVEN_PLAN)
    measured = measure_effects(trial, _names(trial), approximations=True, near_saturation=True)
    lacking = frozenset(plan.saturating_lack)
    setting = Setting(off - forced_off, lacking, plan.tolerance_max_e is not None)
    together = tried_together(trial, setting, measured.approximations)
    return planned(trial, demands, measured, together, figures=True)


def still_fits(trial: Trial, plan: Plan, dropped: Names) -> bool:
    """Return whether a plan keeps its tolerance on another scene with similar light, by measuring
    the error of dropping all effects of `dropped` there."""
    measured_setting, most = tried_together(trial, Setting(dropped), None), plan.tolerance_max_e
    return (
        measured_setting.likely_e2(1.0) <= (MARGIN * (plan.tolerance_e or 0.0)) ** 2
        and measured_setting.difference.other_states <= _SERVED_OTHER_STATES * MOST_OTHER_STATES
        and (most is None or measured_setting.worst.max_e <= MARGIN * most)
    )


def allowed_on(
    scene: PlannedScene, tolerance: ToleranceInput, tolerance_max: ToleranceInput | None
) -> tuple[Tolerance, Tolerance | None]:
    """Convert the tolerances of the RMS error and of the largest error to electrons on a scene; the
    second is None if it was not requested."""
    allowed = tolerance_of(tolerance, scene.sensor, scene)
    if tolerance_max is None:
        return allowed, None
    return allowed, tolerance_of(tolerance_max, scene.sensor, scene, OPTION_MAX)


def _measured(
    scene: PlannedScene, trial: Trial, demands: Demands, free: Names, figures: bool
) -> Plan:
    """Measure effects, choose and measure a set to drop, and return the plan. Uses a slower trial
    if sums are too inaccurate."""
    assert demands.allowed is not None
    too_large = trial.too_large(demands.allowed.electrons)
    moves = [move for move in trial.moves(free) if not move.names & too_large]
    effects_to_measure = (
        _names(trial) if figures else frozenset[str]().union(*(m.names for m in moves))
    )
    effects_to_measure |= trial.slow - trial.absent - trial.forced_off
    negligible = scene.approximates(_NEGLIGIBLE * demands.allowed.electrons, None)
    slower = scene.slower_trial(trial, demands.allowed.electrons)
    # Measurements near saturation are slow, so first try without, except on request.
    for near_saturation in (True,) if figures else (False, True):
        measured = measure_effects(
            trial,
            effects_to_measure,
            approximations=figures or not negligible,
            near_saturation=near_saturation,
        )
        limits = Limits.of(
            demands.allowed, demands.most, _OTHER_STATES * MOST_OTHER_STATES, measured
        )
        named = (trial.slow & demands.forced & {*measured.alone}) - trial.forced_off
        only_slow = (measured.alone[name] for name in named)
        too_rough = measured.approximations_e > _APPROXIMATED * demands.allowed.electrons
        single = demands.most is not None and demands.most.electrons < _ONE_COUNT_E
        if slower and (too_rough or single or any(difference.changes for difference in only_slow)):
            return _measured(scene, slower, demands, free, figures)
        candidates = choose_cheapest(trial, measured, moves, limits)
        together = measure_together(trial, measured, candidates, limits)
        if together.setting.dropped or not candidates:
            break
    if slower and not limits.allow(together):
        return _measured(scene, slower, demands, free, figures)
    return planned(trial, demands, measured, together, figures)


def _names(trial: Trial) -> Names:
    """Return the effects of the exposure that are not absent on the trial's scene."""
    return frozenset(e.name for e in registered() if e.kind != "after") - trial.absent


def _not_worth(
    scene: PlannedScene, trial: Trial, request: PlanRequest, forced: Names
) -> str | None:
    """Return the reason for not measuring effects; None if effects should be measured."""
    if request.figures or trial.slow - trial.absent - trial.forced_off:
        return None
    if not request.effects.auto:
        return "named in --effects"
    if trial.forced_off - trial.absent:
        return None  # the user must be told if these effects exceed the tolerance
    allowed = _known(scene, request.tolerance)
    tolerance_e = None if allowed is None else allowed.electrons
    noise_fraction = None if allowed is not None else noise_part(str(request.tolerance))
    if not scene.approximates(tolerance_e, noise_fraction):
        return None
    too_large = NONE if tolerance_e is None else trial.too_large(tolerance_e)
    moves = [m for m in trial.moves(_names(trial) - forced) if not m.names & too_large]
    free = frozenset[str]().union(*(move.names for move in moves))
    every_ns, _ = trial.frame_ns(Setting(NONE))
    least_ns, _ = trial.frame_ns(trial.settings(free)[0])
    saved_ms = _HOPED * (every_ns - least_ns) * trial.pixels * 1e-6
    if request.frames * saved_ms > trial.planning_ms():
        return None
    return "choosing effects would take longer than it saves"


def _known(scene: PlannedScene, tolerance: ToleranceInput) -> Tolerance | None:
    """Return a tolerance in electrons; None for a fraction of the noise, which must be measured."""
    if isinstance(tolerance, str) and noise_part(tolerance) is not None:
        check_tolerance(tolerance, scene.sensor)
        return None
    return tolerance_of(tolerance, scene.sensor, scene)
