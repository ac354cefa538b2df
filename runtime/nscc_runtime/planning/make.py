"""The way from a scene to a plan, in five steps.

1. `sample`: pixels of the scene are drawn, and weighed by how many others each stands for.
2. `measured_effects`: each effect is left out alone, on these pixels with the same draws.
3. `choose`: of all sets of effects whose differences add up to less than the tolerance, those that
   save most time.
4. `choose`: the best set is left out at once and compared with the truth; if it is not within the
   tolerance with two standard errors, the next one is tried.
5. `decisions`: the plan says what was left out, why the rest was not, and what that was measured to
   change.

Measuring takes time, so it is done where it saves more than that, or where somebody asks for the
table. Other frames are simulated with every effect.
"""

from __future__ import annotations

from dataclasses import dataclass

from nscc_runtime.effects import Selection, registered
from nscc_runtime.planning.choose import (
    MARGIN,
    Limits,
    choose_cheapest,
    measure_together,
    tried_together,
)
from nscc_runtime.planning.decisions import FROM_GIVEN_PLAN, Demands, planned, unmeasured
from nscc_runtime.planning.measured_effects import measure_effects
from nscc_runtime.planning.plan import Plan
from nscc_runtime.planning.plan_parts import MOST_OTHER_STATES
from nscc_runtime.planning.planned_scene import PlannedScene
from nscc_runtime.planning.tolerance import (
    DEFAULT,
    OPTION_MAX,
    Tolerance,
    ToleranceInput,
    check_tolerance,
    noise_part,
    tolerance_of,
)
from nscc_runtime.planning.trial import NONE, Names, Setting, Trial

MANY = 1000
"""Frames that a plan is for where nobody says how many."""
_APPROXIMATED = 0.6
"""Approximations of sums may make this part of the tolerance; beyond it, words run one by one."""
_NEGLIGIBLE = 0.05
"""Approximations that make no more than this part of it are not measured."""
_ONE_COUNT_E = 1.0
"""By so much sums may count wrong in a rare pixel: where no pixel may be, words run one by one."""
_HOPED = 0.35
"""Of what all effects that may be left out would save, the part that plans save as a rule."""
_OTHER_STATES, _SERVED_OTHER_STATES = 0.5, 0.7
"""Effects are left out while this part of the most other states is measured: a sample shows few of
them; a plan serves another scene while so much of them is."""


@dataclass(frozen=True)
class PlanRequest:
    """What is asked of a plan.

    `frames`: for how many frames it is made, by which measuring it has to pay; `figures`: every
    figure of the table is asked for, and measured whatever it saves.
    """

    effects: Selection
    tolerance: ToleranceInput = DEFAULT
    tolerance_max: ToleranceInput | None = None
    frames: int = MANY
    figures: bool = False


def make_plan(scene: PlannedScene, request: PlanRequest) -> Plan:
    """The cheapest plan whose error, measured on a sample of the scene, is within the tolerance.

    Raises Rejected (NS0746) where a tolerance is invalid.
    """
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
        demands = Demands(
            effects, forced, allowed, _known_max(scene, request), str(request.tolerance)
        )
        return unmeasured(trial, demands, path, why, reason)
    allowed, most = allowed_on(scene, request.tolerance, request.tolerance_max)
    demands = Demands(effects, forced, allowed, most)
    free = frozenset(e.name for e in registered() if e.kind != "after") - forced
    return _measured(scene, trial, demands, free, request.figures)


def measured_again(scene: PlannedScene, plan: Plan) -> Plan:
    """The decisions of a plan for another scene, measured on this one. A tolerance that is a part
    of the scene is one of this scene."""
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
    """Whether a plan keeps its promise on another scene with light of the same kind, by what all
    that it leaves out changes there."""
    measured_setting, most = tried_together(trial, Setting(dropped), None), plan.tolerance_max_e
    return (
        measured_setting.likely_e2(1.0) <= (MARGIN * (plan.tolerance_e or 0.0)) ** 2
        and measured_setting.difference.other_states <= _SERVED_OTHER_STATES * MOST_OTHER_STATES
        and (most is None or measured_setting.worst.max_e <= MARGIN * most)
    )


def allowed_on(
    scene: PlannedScene, tolerance: ToleranceInput, tolerance_max: ToleranceInput | None
) -> tuple[Tolerance, Tolerance | None]:
    """What tolerances mean on a scene."""
    allowed = tolerance_of(tolerance, scene.sensor, scene)
    if tolerance_max is None:
        return allowed, None
    return allowed, tolerance_of(tolerance_max, scene.sensor, scene, OPTION_MAX)


def _measured(
    scene: PlannedScene, trial: Trial, demands: Demands, free: Names, figures: bool
) -> Plan:
    """Steps 1 to 5; the sample is drawn when it is first asked for."""
    assert demands.allowed is not None
    too_large = trial.too_large(demands.allowed.electrons)
    moves = [move for move in trial.moves(free) if not move.names & too_large]
    effects_to_measure = (
        _names(trial) if figures else frozenset[str]().union(*(m.names for m in moves))
    )
    effects_to_measure |= trial.slow - trial.absent - trial.forced_off
    negligible = scene.approximates(_NEGLIGIBLE * demands.allowed.electrons, None)
    slower = scene.slower_trial(trial, demands.allowed.electrons)
    # What pixels near saturation would lack is measured where it is asked for, or decides.
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
    """All effects of the exposure that may change something."""
    return frozenset(e.name for e in registered() if e.kind != "after") - trial.absent


def _not_worth(
    scene: PlannedScene, trial: Trial, request: PlanRequest, forced: Names
) -> str | None:
    """Why measuring is not worth its time; None where it is."""
    if request.figures or trial.slow - trial.absent - trial.forced_off:
        return None
    if not request.effects.auto:
        return "named in --effects"
    if trial.forced_off - trial.absent:
        return None  # they may break the promise, which is to be said
    allowed = _known(scene, request.tolerance)
    tolerance_e = None if allowed is None else allowed.electrons
    noise_fraction = None if allowed is not None else noise_part(str(request.tolerance))
    if request.tolerance_max is not None or not scene.approximates(tolerance_e, noise_fraction):
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
    """A tolerance as far as it is known without measuring: not one that is a part of the noise."""
    if isinstance(tolerance, str) and noise_part(tolerance) is not None:
        check_tolerance(tolerance, scene.sensor)
        return None
    return tolerance_of(tolerance, scene.sensor, scene)


def _known_max(scene: PlannedScene, request: PlanRequest) -> Tolerance | None:
    most = request.tolerance_max
    return None if most is None else tolerance_of(most, scene.sensor, scene, OPTION_MAX)
