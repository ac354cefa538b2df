"""Choosing a plan: which effects a tolerance lets go, and which it does not."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from nscc_runtime.effects import (
    AfterExposure,
    CannotHave,
    Effect,
    Selection,
    registered,
    selected,
)
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.light import Light
from nscc_runtime.planner.costs import BOUND_ERRORS, MARGIN, Costs
from nscc_runtime.planner.plan import Loop, Plan
from nscc_runtime.planner.plan_parts import Approximation, Choice, Decision
from nscc_runtime.planner.predict import WORDS
from nscc_runtime.planner.program import Program
from nscc_runtime.planner.tolerance import DEFAULT, Given, most_change
from nscc_runtime.planner.worst import Worst
from nscc_runtime.remembered import remembered

_NOTHING = np.zeros(1)
TAKEN = "taken from the plan given"
"""The reason of decisions that were made for another scene."""


def plan_for(
    program: Program,
    light: Light,
    tolerance: Given = DEFAULT,
    effects: Selection | None = None,
    device_seed: int = 0,
    tolerance_max: Given | None = None,
    threads: int = 1,
) -> Plan:
    """The cheapest plan whose predicted error is within the tolerance, by the fewest effects, and
    that of its worst pixel within `tolerance_max`.

    `effects`, by default `auto`, decides on what it names; without `auto` on everything. Errors are
    against the reference with all effects, those that were forced off included. Raises Rejected
    (NS0746) where the tolerance is none.
    """
    wanted = effects or selected("auto")
    return Chooser(program, light, device_seed, threads, tolerance, tolerance_max, wanted).plan()


def predicted_for(
    program: Program, light: Light, plan: Plan, device_seed: int = 0, threads: int = 1
) -> Plan:
    """The same decisions for another scene: what they make wrong there. A tolerance that is a part
    of the scene is one of this scene."""
    # What was left out by choice stays so: it is not forced off, as pixels that run through their
    # words have it.
    wanted = replace(plan.wanted, auto=True)
    dropped = frozenset(e.name for e in registered() if e.kind != "after" and e not in plan.kept)
    asked = plan.asked, plan.asked_max
    chooser = Chooser(program, light, device_seed, threads, *asked, wanted)
    made = chooser.made(dropped, frozenset(plan.saturating_lack), TAKEN)
    decisions = tuple(
        each if each.decision == "absent" or each.kind == "after" else replace(each, reason=TAKEN)
        for each in made.decisions
    )
    return replace(made, decisions=decisions)


@dataclass(frozen=True, eq=False)
class Chooser(Costs):
    """One search; see `plan_for`."""

    def plan(self, forced_reason: str = "named in --effects") -> Plan:
        """The plan."""
        dropped = self.forced_off
        limit = (MARGIN * self.tolerance_e) ** 2
        forced = self._square(dropped)
        if forced > limit:
            # What the user forced off has broken the promise: the rest keeps to it by itself.
            limit += forced
        fitting: list[frozenset[str]] = []
        while True:
            moves = [names for names in fitting if not names <= dropped]
            # What did not fit before seldom does with less room: it is tried again at the end.
            fitting = self._fitting(moves, dropped, limit) if moves else []
            if not fitting:
                fitting = self._fitting(self._moves(dropped), dropped, limit)
            found = next((n for n in fitting if self._sure(dropped | n, limit)), None)
            if found is None:
                break
            dropped |= found
        lacking: frozenset[str] = frozenset()
        if self.path(dropped) == "sums" and self.state(dropped).startswith(WORDS):
            free = dropped - self.forced_off - self.saturation - self.slow
            room = limit - self._square(dropped)
            lacking = self.lacking(self.state(dropped)).chosen(free, room)
            if not self._bounded(dropped, lacking):
                lacking = frozenset()
        return self.made(dropped, lacking, forced_reason)

    def _fitting(
        self, moves: Iterable[frozenset[str]], dropped: frozenset[str], limit: float
    ) -> list[frozenset[str]]:
        """Of some moves those whose mean square error stays below the limit and that save time,
        what saves most for its error first."""
        now = self._square(dropped)
        found: list[tuple[float, list[str], frozenset[str]]] = []
        for names in moves:
            saved = self.saved_ns(names, dropped)
            if saved > 0:
                then = self._square(dropped | names)
                if then <= max(limit, now):
                    found.append((saved / max(then - now, 1e-12), sorted(names), names))
        return [names for *_, names in sorted(found, reverse=True, key=lambda each: each[:2])]

    @cached_property
    def _chosen_on(self) -> frozenset[str]:
        """What may be left out."""
        return frozenset(effect.name for effect in self.present if not self.is_forced(effect))

    def _moves(self, dropped: frozenset[str]) -> Iterable[frozenset[str]]:
        """What may be left out next: an effect, saturation, or all that only the reference has."""
        free = self._chosen_on - dropped
        yield from (self.with_what_hangs_on_it(name, free, dropped) for name in sorted(free))
        if free >= self.saturation:
            yield self.saturation
        slow = free & self.slow
        if len(slow) > 1:
            yield slow

    @remembered
    def _square(self, dropped: frozenset[str]) -> float:
        """The predicted mean square error of the worst bucket, in square electrons."""
        return float(self.squares(dropped, self.path(dropped) != "sums").max())

    def _sure(self, dropped: frozenset[str], limit: float) -> bool:
        """Whether it fits with two standard errors of the sample, and keeps to its bounds."""
        most = max(limit / MARGIN**2, self._square(self.forced_off))
        return self._doubtful(dropped) <= most and self._bounded(dropped)

    def _doubtful(self, dropped: frozenset[str]) -> float:
        """The mean square error with two standard errors of the sample."""
        error = float(np.max(self.sampling_error(dropped, self.path(dropped) != "sums")))
        return self._square(dropped) + 2.0 * error

    def _bounded(self, dropped: frozenset[str], lacking: frozenset[str] = frozenset()) -> bool:
        """Whether the worst pixels and the noise keep to what was asked, or to what is forced."""
        forced, most, part = self.forced_off, self.allowed_max, self.allowed.noise_part
        if most is not None:
            limit_e = max(MARGIN * most.electrons, self._worst(forced).max_e)
            if self._worst(dropped, lacking).max_e > limit_e:
                return False
        if part is None:
            return True
        limit = max(most_change(part), self._noise_change(forced))
        return self._noise_change(dropped, lacking) <= limit

    def _unbounded(self, dropped: frozenset[str]) -> str:
        """What would become of that which `_bounded` finds too much."""
        worst_e, most = self._worst(dropped).max_e, self.allowed_max
        if most is not None and worst_e > MARGIN * most.electrons:
            return f"left out, the worst pixel would be {worst_e:.3g} e off"
        return f"left out, the noise would change by {self._noise_change(dropped):.1%}"

    def _worst(self, dropped: frozenset[str], lacking: frozenset[str] = frozenset()) -> Worst:
        found = self.worst(dropped, self.path(dropped) != "sums", lacking)
        if not lacking:
            return found
        near = self.lacking(self.state(dropped)).worst(lacking)
        return Worst(max(found.p999_e, near.p999_e), max(found.max_e, near.max_e))

    @remembered
    def _noise_change(
        self, dropped: frozenset[str], lacking: frozenset[str] = frozenset()
    ) -> float:
        """By what part the standard deviation of what is read out changes."""
        everywhere = self.path(dropped) != "sums"
        ratio = self.noise_ratio(dropped, everywhere, lacking, readout=True)
        return 0.0 if ratio is None else abs(ratio - 1.0)

    def made(self, dropped: frozenset[str], lacking: frozenset[str], forced_reason: str) -> Plan:
        """The plan that leaves these effects out; pixels near saturation have those of them that
        are not `lacking` there and not forced off."""
        path = self.path(dropped)
        square = self.squares(dropped, path != "sums")
        error = self.sampling_error(dropped, path != "sums")
        most = self.most(dropped, path != "sums") + BOUND_ERRORS * error
        added = unsure = _NOTHING
        if lacking:
            near = self.lacking(self.state(dropped))
            added, unsure = near.square(dropped, lacking), BOUND_ERRORS * near.square_error(lacking)
        worst = self._worst(dropped, lacking)
        taken = self.short_cuts(dropped) if path == "sums" else ()
        cuts = [Approximation(name, math.sqrt(float(np.max(part)))) for name, part in taken]
        reasons = [*self._reasons(dropped)]
        loop: Loop = "some" if reasons else "none"
        if path != "sums":
            loop = "all" if path == "words" else "reference"
        return Plan(
            self.tolerance_e,
            math.sqrt(max(float(np.max(square + added)), 0.0)),
            math.sqrt(max(float(np.max(most + added + unsure)), 0.0)),
            loop,
            tuple(reasons),
            len(self.fields.sample.places) / len(self.program.lanes),
            tuple(cut for cut in cuts if cut.error_e > 0),
            tuple(self._decision(each, dropped, lacking, forced_reason) for each in registered()),
            self.leak_nodes,
            self.closed,
            predicted_p999_e=worst.p999_e,
            predicted_max_e=worst.max_e,
            noise_ratio=self.noise_told(dropped, path != "sums", lacking),
            saturating_lack=tuple(sorted(lacking)),
            cost=self.cost(dropped, lacking),
        ).told(self.allowed, self.allowed_max)

    def _reasons(self, dropped: frozenset[str]) -> Iterable[str]:
        """Why pixels run through their words one by one, or why the reference runs."""
        path = self.path(dropped)
        for effect in self.present:
            if effect.name in dropped:
                continue
            if path == "reference" and isinstance(effect.words, CannotHave):
                yield f"{effect.name}: only the reference has it ({effect.words.reason})"
            elif path == "words" and isinstance(effect.sums, CannotHave):
                yield f"{effect.name}: sums over the slots cannot have it ({effect.sums.reason})"
        if path != "sums" and self.everywhere:
            yield (
                "counts would have to be spread over the slots of most pixels: the weights of a "
                "code's slots differ too much for this tolerance"
            )
        if path == "reference":
            return
        running = len(self.running(self.state(dropped)))
        if running:
            yield f"{running} pixels may saturate"

    def _decision(
        self, effect: Effect, dropped: frozenset[str], lacking: frozenset[str], forced_reason: str
    ) -> Decision:
        forced = self.is_forced(effect)
        if effect.kind == "after":
            return after_exposure(effect, self.effects, self.program.sensor, forced_reason)
        rms, bias = self.contribution(effect)
        without, added = dropped | {effect.name}, 0.0
        if lacking:
            near = self.lacking(self.state(dropped))
            added = float(np.max(near.square(without, lacking)))
        then = math.sqrt(max(self._square(without) + added, 0.0))
        cost = self.own_ns(effect.name, dropped)
        choice: Choice = "kept"
        if effect not in self.present:
            choice, reason, cost = "absent", effect.absent, 0.0
        elif effect.name in dropped:
            choice, reason = "dropped", f"{rms:.3g} e fits into the tolerance"
        elif then > MARGIN * self.tolerance_e:
            reason = f"left out, the error would be {then:.3g} e"
        elif cost > 0 and self._doubtful(without) > self.tolerance_e**2:
            could_e = math.sqrt(self._doubtful(without))
            reason = f"left out, the error could be {could_e:.3g} e: few pixels tell"
        elif cost > 0 and not self._bounded(without):
            reason = self._unbounded(without)
        else:
            reason = "costs nothing"
        if forced and choice != "absent":
            reason = forced_reason
        return Decision(
            effect.name, effect.kind, choice, forced, reason, rms, bias, then,
            cost * len(self.program.lanes) * 1e-6,
        )  # fmt: skip


def after_exposure(
    effect: Effect, effects: Selection, sensor: Sensor, forced_reason: str
) -> Decision:
    """The readout's: no part of the promise, on unless the user wants it off."""
    assert isinstance(effect.field, AfterExposure)
    forced = not effect.always and (not effects.auto or effect.name in effects.forced)
    on = effect in effects or (effects.auto and not forced)
    reason = forced_reason if forced else "always applied, after the exposure"
    return Decision(
        effect.name, effect.kind, "kept" if on else "dropped", forced, reason,
        effect.field.rms_e(sensor), 0.0, None, 0.0,
    )  # fmt: skip
