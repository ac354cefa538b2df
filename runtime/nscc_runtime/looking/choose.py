"""Choosing a plan for a program that looks: which effects a tolerance lets go.

As `nscc_runtime.planner.choose`, with predictions that are measured on a sample of the scene, and
with a second limit: of the pixels that end in other states, whose exposures are no error but
another measurement.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from nscc_runtime.effects import AfterExposure, Effect, Selection, everything, registered, selected
from nscc_runtime.effects.parts import Fading, Moving
from nscc_runtime.effects.registry import always_on, optional
from nscc_runtime.looking.sample import Difference, Sample
from nscc_runtime.planner.choose import TAKEN, after_exposure
from nscc_runtime.planner.costs import BOUND_ERRORS, MARGIN
from nscc_runtime.planner.plan import MOST_OTHER_STATES, Plan
from nscc_runtime.planner.plan_parts import Choice, Cost, Decision
from nscc_runtime.planner.prices import SHIPPED
from nscc_runtime.planner.tolerance import Tolerance

_LEFT_OUT = 0.5
"""Effects are left out while this part of the most other states is predicted: a sample shows few
of them."""
_KEPT = 0.7
"""The same of plans that serve another scene."""
_REFERENCE_NS = 1000.0
"""What a pixel costs more in the reference."""
LOOKS = "pixels look at the light: each runs through the words that act in it"


def plan_for(
    sample: Sample,
    tolerance: Tolerance,
    effects: Selection | None = None,
    tolerance_max: Tolerance | None = None,
) -> Plan:
    """As `nscc_runtime.planner.choose.plan_for`."""
    return Chooser(sample, tolerance, tolerance_max, effects or selected("auto")).plan()


def predicted_for(
    sample: Sample, plan: Plan, tolerance: Tolerance, tolerance_max: Tolerance | None = None
) -> Plan:
    """The same decisions for another scene: what they make wrong there, of the tolerances there."""
    on = {each.name for each in plan.decisions if each.decision == "kept"}
    chosen = Selection(always_on() | on, frozenset(optional()))
    made = Chooser(sample, tolerance, tolerance_max, chosen).plan(TAKEN)
    forced = {each.name: each.forced for each in plan.decisions}
    decisions = tuple(replace(each, forced=forced[each.name]) for each in made.decisions)
    return replace(made, decisions=decisions)


def serves(sample: Sample, plan: Plan) -> bool:
    """Whether a plan keeps its promise on another scene with light of the same kind, by what its
    effects in all change there: no effect is tried alone."""
    dropped = frozenset(
        e.name for e in plan.decisions if e.decision == "dropped" and e.kind != "after"
    )
    if not dropped:
        return True
    found, most = sample.tried(dropped), plan.tolerance_max_e
    return (
        found.likely_e <= MARGIN * plan.tolerance_e
        and found.other_states <= _KEPT * MOST_OTHER_STATES
        and (most is None or found.worst.max_e <= MARGIN * most)
    )


@dataclass(frozen=True, eq=False)
class Chooser:
    """One search."""

    sample: Sample
    allowed: Tolerance
    allowed_max: Tolerance | None
    effects: Selection

    @property
    def tolerance_e(self) -> float:
        """The tolerance in electrons."""
        return self.allowed.electrons

    @cached_property
    def alone(self) -> dict[str, Difference]:
        """What each effect of the exposure changes that is left out alone; without those that can
        change nothing at all. What changes no pixel of the sample may change others."""
        ways, light = self.sample.ways, self.sample.light
        steady = everything().names(Moving) if light.motion is None else frozenset()
        lasting = frozenset() if ways.fades else everything().names(Fading)
        return {
            e.name: self.sample.without(frozenset({e.name})) for e in registered()
            if e.kind != "after" and e.name not in steady | lasting
        }  # fmt: skip

    def plan(self, forced_reason: str = "named in --effects") -> Plan:
        """The plan."""
        forced = frozenset(
            e.name for e in registered()
            if e.kind != "after" and self._forced(e) and e not in self.effects
        )  # fmt: skip
        now = self.sample.without(forced)
        # What the user forced off has broken the promise: the rest keeps to it by itself.
        most_rms_e = MARGIN * self.tolerance_e
        if now.likely_e > most_rms_e:
            most_rms_e = math.hypot(most_rms_e, now.likely_e)
        most_other = _LEFT_OUT * MOST_OTHER_STATES
        most_other += now.other_states if now.other_states > most_other else 0.0
        most_e = math.inf
        if self.allowed_max is not None:
            most_e = max(MARGIN * self.allowed_max.electrons, now.worst.max_e)

        def fits(then: Difference) -> bool:
            return (
                then.likely_e <= most_rms_e
                and then.other_states <= most_other
                and then.worst.max_e <= most_e
            )

        chosen = list[str]()
        for name in self._free(forced):
            if self.alone[name].likely_e > most_rms_e:
                continue
            if fits(self.sample.without(forced.union(chosen, {name}))):
                chosen.append(name)
        while not fits(now := self.sample.tried(forced.union(chosen))) and chosen:
            chosen.pop()
        return self._made(forced.union(chosen), now, forced_reason)

    def _free(self, forced: frozenset[str]) -> list[str]:
        """What may be left out and saves something, what changes least first."""
        free = [
            e for e in registered()
            if e.name in self.alone and e.name not in forced and not self._forced(e)
            and self._saved_ns(e) > 0
        ]  # fmt: skip
        return [e.name for e in sorted(free, key=lambda e: self.alone[e.name].square.max())]

    def _forced(self, effect: Effect) -> bool:
        return not self.effects.auto or effect.name in self.effects.forced

    def _saved_ns(self, effect: Effect) -> float:
        """Nanoseconds a pixel that leaving an effect out saves."""
        slow = self.sample.ways.lacks(everything().without(effect.name))
        much = _REFERENCE_NS if self.sample.ways.lacks(everything()) and not slow else 0.0
        return effect.cost_ns + much

    def _made(self, dropped: frozenset[str], now: Difference, forced_reason: str) -> Plan:
        ways = self.sample.ways
        decisions = tuple(self._decision(e, dropped, now, forced_reason) for e in registered())
        most = sum((self.alone[n].error_e for n in dropped if n in self.alone), 0.0)
        plan = Plan(
            tolerance_e=self.tolerance_e,
            predicted_e=now.error_e,
            bound_e=math.sqrt(max(most, now.error_e) ** 2 + BOUND_ERRORS * float(now.unsure.max())),
            slot_loop="all",
            slot_loop_reasons=(LOOKS,),
            sampled_fraction=self.sample.fraction,
            approximations=(),
            decisions=decisions,
            other_states=now.other_states,
            predicted_p999_e=now.worst.p999_e,
            predicted_max_e=now.worst.max_e,
            cost=self._cost(dropped),
        ).told(self.allowed, self.allowed_max)
        lacking = ways.lacks(plan.kept)
        if lacking:
            return replace(plan, slot_loop="reference", slot_loop_reasons=lacking)
        return plan

    def _cost(self, dropped: frozenset[str]) -> Cost:
        """What the plan takes that leaves these effects out."""
        ms, present = self.sample.pixels * 1e-6, [e for e in registered() if e.name in self.alone]
        # Every frame of the sample is exposed with all effects, and without each; what is chosen
        # may be tried more often.
        exposures = len(present) + 1 + 2 * (self.sample.times - 1)
        exposed = exposures * self.sample.light.frames[0].size * self.sample.frames
        planning_ms = SHIPPED.looked * exposed * 1e-6
        frame_ms, every_ms = (
            ms * (SHIPPED.looked + sum(self._saved_ns(e) for e in present if e.name not in without))
            for without in (dropped, frozenset())
        )
        return Cost(
            frame_ms + planning_ms, 0.0, planning_ms, every_ms + planning_ms, planning_ms
        )  # fmt: skip

    def _decision(
        self, effect: Effect, dropped: frozenset[str], now: Difference, forced_reason: str
    ) -> Decision:
        forced = self._forced(effect)
        if isinstance(effect.field, AfterExposure):
            return after_exposure(effect, self.effects, self.sample.ways.sensor, forced_reason)
        found = self.alone.get(effect.name)
        if found is None:
            return Decision(
                effect.name, effect.kind, "absent", forced, effect.absent, 0.0, 0.0, now.error_e,
                0.0, 0.0,
            )  # fmt: skip
        choice: Choice = "dropped" if effect.name in dropped else "kept"
        then_e = now.error_e if choice == "dropped" else math.hypot(now.error_e, found.error_e)
        likely_e = math.hypot(now.likely_e, found.likely_e)
        saved_ns = self._saved_ns(effect)
        if forced:
            reason = forced_reason
        elif choice == "dropped":
            reason = f"{found.error_e:.3g} e fits into the tolerance"
        elif saved_ns <= 0:
            reason = "costs nothing"
        elif then_e > MARGIN * self.tolerance_e:
            reason = f"left out, the error would be {then_e:.3g} e"
        elif likely_e > MARGIN * self.tolerance_e:
            reason = f"left out, a few pixels' error might make it {likely_e:.3g} e"
        elif self.allowed_max and found.worst.max_e > MARGIN * self.allowed_max.electrons:
            reason = f"left out, the worst pixel would be {found.worst.max_e:.3g} e off"
        else:
            reason = f"left out, {found.other_states:.2%} would end in other states"
        bias = float(found.mean[int(np.argmax(found.square))])
        # What an effect does to exposures is the opposite of what they lose without it.
        return Decision(
            effect.name, effect.kind, choice, forced, reason, found.error_e, 0.0 - bias, then_e,
            saved_ns * self.sample.pixels * 1e-6, found.other_states,
        )  # fmt: skip
