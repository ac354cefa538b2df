"""Choosing a plan: which effects a tolerance lets go, and which it does not."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Literal

import numpy as np

from nscc_runtime.effects import (
    AfterExposure,
    CannotHave,
    Effect,
    Selection,
    everything,
    registered,
    selected,
)
from nscc_runtime.effects.registry import always_on, optional
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.light import Light
from nscc_runtime.planner.lacking import Lacking
from nscc_runtime.planner.plan import Approximation, Choice, Decision, Loop, Plan
from nscc_runtime.planner.predict import Forecast
from nscc_runtime.planner.prices import SHIPPED
from nscc_runtime.planner.program import Program
from nscc_runtime.remembered import remembered

DEFAULT_TOLERANCE_E = 5.0

MARGIN = 0.9
"""Effects are left out while the prediction stays below this part of the tolerance."""
_SHORT_CUTS = 0.6
"""Short cuts may take this part of the tolerance; beyond it, all pixels run through their words."""

_NOTHING = np.zeros(1)


def plan_for(
    program: Program,
    light: Light,
    tolerance_e: float = DEFAULT_TOLERANCE_E,
    effects: Selection | None = None,
    device_seed: int = 0,
    threads: int = 1,
) -> Plan:
    """The cheapest plan whose predicted error is within the tolerance, by the fewest effects.

    `effects`, by default `auto`, decides on what it names; without `auto` on everything. Errors are
    against the reference with all effects, those that were forced off included.
    """
    wanted = effects or selected("auto")
    return Chooser(program, light, tolerance_e, device_seed, threads, wanted).plan()


def predicted_for(
    program: Program, light: Light, plan: Plan, device_seed: int = 0, threads: int = 1
) -> Plan:
    """The same decisions for another scene: what they make wrong there."""
    on = {each.name for each in plan.decisions if each.decision == "kept"}
    chosen = Selection(always_on() | on, frozenset(optional()))
    chooser = Chooser(program, light, plan.tolerance_e, device_seed, threads, chosen)
    lacking = frozenset(plan.saturating_lack)
    made = chooser.made(chooser.forced_off, lacking, "taken from the plan given")
    forced = {each.name: each.forced for each in plan.decisions}
    decisions = tuple(replace(each, forced=forced[each.name]) for each in made.decisions)
    return replace(made, decisions=decisions, tolerance=plan.tolerance, signal_e=plan.signal_e)


@dataclass(frozen=True, eq=False)
class Chooser(Forecast):
    """One search; see `plan_for`."""

    effects: Selection

    @cached_property
    def forced_off(self) -> frozenset[str]:
        """Of the exposure, what the user wants off."""
        return frozenset(
            effect.name for effect in registered()
            if effect.kind != "after" and self._forced(effect) and effect not in self.effects
        )  # fmt: skip

    def plan(self, forced_reason: str = "named in --effects") -> Plan:
        """The plan."""
        dropped = self.forced_off
        limit = (MARGIN * self.tolerance_e) ** 2
        forced = self._square(dropped)
        if forced > limit:
            # What the user forced off has broken the promise: the rest keeps to it by itself.
            limit += forced
        while True:
            now = self._square(dropped)
            fits = []
            for names in self._moves(dropped):
                then = self._square(dropped | names)
                if then <= max(limit, now):
                    saved = self._saved_ns(names, dropped)
                    if saved > 0:
                        fits.append((saved / max(then - now, 1e-12), sorted(names)))
            if not fits:
                break
            dropped |= set(max(fits)[1])
        lacking: frozenset[str] = frozenset()
        if self._path(dropped) == "sums" and self.state(dropped) == "words":
            free = dropped - self.forced_off - self.saturation - self.slow
            lacking = self._lacking.chosen(free, limit - self._square(dropped))
        return self.made(dropped, lacking, forced_reason)

    @cached_property
    def _lacking(self) -> Lacking:
        return Lacking(
            self.program, self.light, self.near, self.fields, self.forced_off, self.device_seed,
            self.threads,
        )  # fmt: skip

    def _moves(self, dropped: frozenset[str]) -> Iterable[frozenset[str]]:
        """What may be left out next: an effect, saturation, or all that only the reference has."""
        free = {
            effect.name for effect in self.present
            if effect.name not in dropped and not self._forced(effect)
        }  # fmt: skip
        yield from (frozenset({name}) for name in sorted(free))
        if free >= self.saturation:
            yield self.saturation
        slow = frozenset(free & self.slow)
        if len(slow) > 1:
            yield slow

    def _square(self, dropped: frozenset[str]) -> float:
        """The predicted mean square error of the worst bucket, in square electrons."""
        return self.square(dropped, self._path(dropped) != "sums")

    @remembered
    def _path(self, dropped: frozenset[str]) -> Literal["sums", "words", "reference"]:
        """What has all effects that are left: sums over slots, the loop over the words of single
        pixels for all of them, or the reference alone.
        """
        left = [effect for effect in self.present if effect.name not in dropped]
        summed = not (self._everywhere or any(isinstance(e.sums, CannotHave) for e in left))
        if summed and self.state(dropped) != "words":
            return "sums"
        if any(effect.name in self.slow for effect in left):
            return "reference"
        if summed:
            return "sums"
        cheaper = self._all_words_ns(dropped) < self._reference_ns
        return "words" if cheaper else "reference"

    @cached_property
    def _everywhere(self) -> bool:
        """Whether short cuts would cost too much, so that all pixels run through their words."""
        cuts = self.short_cuts(self.forced_off)
        total = sum((square for _, square in cuts), _NOTHING)
        return math.sqrt(float(np.max(total))) > _SHORT_CUTS * self.tolerance_e

    def _forced(self, effect: Effect) -> bool:
        return not self.effects.auto or effect.name in self.effects.forced

    @property
    def _reference_ns(self) -> float:
        return self.program.work.reference_ns(SHIPPED)

    def _all_words_ns(self, dropped: frozenset[str]) -> float:
        """Nanoseconds a pixel of all pixels running through their words."""
        kept = everything().without(*dropped)
        return self.program.work.words_ns(kept, SHIPPED, alone=False)

    def _near_ns(self, lacking: frozenset[str]) -> float:
        """Nanoseconds of one pixel near saturation that runs through its words."""
        kept = everything().without(*lacking)
        return self.program.work.words_ns(kept, SHIPPED, alone=True)

    def _path_ns(self, dropped: frozenset[str]) -> float:
        """Nanoseconds a pixel that the way of simulating what is left costs."""
        path = self._path(dropped)
        if path == "reference":
            return self._reference_ns
        if path == "words":
            return self._all_words_ns(dropped)
        if self.state(dropped) != "words":
            return 0.0
        return self._near_ns(self.forced_off) * len(self.near) / len(self.program.lanes)

    def _saved_ns(self, names: frozenset[str], dropped: frozenset[str]) -> float:
        """Nanoseconds a pixel that leaving effects out saves, beside those in `dropped`."""
        saved = self._path_ns(dropped - names) - self._path_ns(dropped | names)
        if self._path(dropped) != "sums":
            return saved
        return saved + sum(effect.cost_ns for effect in self.present if effect.name in names)

    def made(self, dropped: frozenset[str], lacking: frozenset[str], forced_reason: str) -> Plan:
        """The plan that leaves these effects out; pixels near saturation have those of them that
        are not `lacking` there and not forced off."""
        path = self._path(dropped)
        square, most = self.squares(dropped, path != "sums")
        added = self._lacking.square(lacking) if lacking else _NOTHING
        taken = self.short_cuts(dropped) if path == "sums" else ()
        cuts = [Approximation(name, math.sqrt(float(np.max(part)))) for name, part in taken]
        reasons = [*self._reasons(dropped)]
        loop: Loop = "some" if reasons else "none"
        if path != "sums":
            loop = "all" if path == "words" else "reference"
        return Plan(
            self.tolerance_e,
            math.sqrt(float(np.max(square + added))),
            math.sqrt(float(np.max(most + added))),
            loop,
            tuple(reasons),
            len(self.fields.sample.places) / len(self.program.lanes),
            tuple(cut for cut in cuts if cut.error_e > 0),
            tuple(
                self._decision(each, dropped, float(np.max(added)), forced_reason)
                for each in registered()
            ),
            self.leak_nodes,
            self.closed,
            saturating_lack=tuple(sorted(lacking)),
        )

    def _reasons(self, dropped: frozenset[str]) -> Iterable[str]:
        """Why pixels run through their words one by one, or why the reference runs."""
        path = self._path(dropped)
        for effect in self.present:
            if effect.name in dropped:
                continue
            if path == "reference" and isinstance(effect.words, CannotHave):
                yield f"{effect.name}: only the reference has it ({effect.words.reason})"
            elif path == "words" and isinstance(effect.sums, CannotHave):
                yield f"{effect.name}: sums over the slots cannot have it ({effect.sums.reason})"
        if path != "sums" and self._everywhere:
            yield (
                "counts would have to be spread over the slots of most pixels: the weights of a "
                "code's slots differ too much for this tolerance"
            )
        if path == "reference":
            return
        if self.state(dropped) == "words":
            yield f"{len(self.near)} pixels may saturate"

    def _decision(
        self, effect: Effect, dropped: frozenset[str], added: float, forced_reason: str
    ) -> Decision:
        forced = self._forced(effect)
        if effect.kind == "after":
            return after_exposure(effect, self.effects, self.program.sensor, forced_reason)
        rms, bias = self.contribution(effect)
        then = math.sqrt(self._square(dropped | {effect.name}) + added)
        cost = self._saved_ns(frozenset({effect.name}), dropped)
        choice: Choice = "kept"
        if effect not in self.present:
            choice, reason, cost = "absent", effect.absent, 0.0
        elif effect.name in dropped:
            choice, reason = "dropped", f"{rms:.3g} e fits into the tolerance"
        elif then > MARGIN * self.tolerance_e:
            reason = f"left out, the error would be {then:.3g} e"
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
