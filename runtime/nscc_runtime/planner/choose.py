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
    InLoop,
    Selection,
    registered,
    selected,
)
from nscc_runtime.effects.registry import always_on, optional
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.light import Light
from nscc_runtime.planner.plan import Approximation, Choice, Decision, Loop, Plan
from nscc_runtime.planner.predict import Forecast
from nscc_runtime.planner.program import Program
from nscc_runtime.remembered import remembered

DEFAULT_TOLERANCE_E = 5.0

MARGIN = 0.9
"""Effects are left out while the prediction stays below this part of the tolerance."""
_SHORT_CUTS = 0.6
"""Short cuts may take this part of the tolerance; beyond it, all pixels run through their words."""

_NOTHING = np.zeros(1)
_REFERENCE = 2.0
"""The reference, by the cost of the loop over words."""
_WORD_NS, _SLOT_NS = 300.0, 60.0
"""Of one pixel through its words, neighbours' counts included: nanoseconds a word, and a slot."""


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
    made = chooser.plan("taken from the plan given")
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
                return self._made(dropped, forced_reason)
            dropped |= set(max(fits)[1])

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
        return "sums" if summed else "words"

    @cached_property
    def _everywhere(self) -> bool:
        """Whether short cuts would cost too much, so that all pixels run through their words."""
        cuts = self.short_cuts(self.forced_off)
        total = sum((square for _, square in cuts), _NOTHING)
        return math.sqrt(float(np.max(total))) > _SHORT_CUTS * self.tolerance_e

    def _forced(self, effect: Effect) -> bool:
        return not self.effects.auto or effect.name in self.effects.forced

    def _words_ns(self, pixels: int) -> float:
        """Nanoseconds that so many pixels running through their words cost, shared over all."""
        program = self.program
        words = len(program.pixels.entries) / len(program.container.encoding)
        each = _WORD_NS * words + _SLOT_NS * program.container.slots
        return each * pixels / len(program.lanes)

    def _path_ns(self, dropped: frozenset[str]) -> float:
        """Nanoseconds a pixel that the way of simulating what is left costs."""
        path = self._path(dropped)
        if path == "sums":
            near = self.near if self.state(dropped) == "words" else ()
            return self._words_ns(len(near))
        return self._words_ns(len(self.program.lanes)) * (_REFERENCE if path == "reference" else 1)

    def _saved_ns(self, names: frozenset[str], dropped: frozenset[str]) -> float:
        """Nanoseconds a pixel that leaving effects out saves, beside those in `dropped`."""
        path = self._path(dropped)
        saved = self._path_ns(dropped - names) - self._path_ns(dropped | names)
        effects = [effect for effect in self.present if effect.name in names]
        if path == "sums":
            return saved + sum(effect.cost_ns for effect in effects)
        # The words are run in any case.
        loops = (effect.words for effect in effects if path == "words")
        return saved + sum(each.cost_ns for each in loops if isinstance(each, InLoop))

    def _made(self, dropped: frozenset[str], forced_reason: str) -> Plan:
        """The plan of these decisions."""
        path = self._path(dropped)
        square, most = self.squares(dropped, path != "sums")
        taken = self.short_cuts(dropped) if path == "sums" else ()
        cuts = [Approximation(name, math.sqrt(float(np.max(part)))) for name, part in taken]
        reasons = [*self._reasons(dropped)]
        loop: Loop = "some" if reasons else "none"
        if path != "sums":
            loop = "all" if path == "words" else "reference"
        return Plan(
            self.tolerance_e,
            math.sqrt(float(np.max(square))),
            math.sqrt(float(np.max(most))),
            loop,
            tuple(reasons),
            len(self.fields.sample.places) / len(self.program.lanes),
            tuple(cut for cut in cuts if cut.error_e > 0),
            tuple(self._decision(each, dropped, forced_reason) for each in registered()),
            self.leak_nodes,
            self.closed,
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
        if path == "reference":
            return
        if self._everywhere:
            yield (
                "counts would have to be spread over the slots of most pixels: the weights of a "
                "code's slots differ too much for this tolerance"
            )
        if self.state(dropped) == "words":
            yield f"{len(self.near)} pixels may saturate"

    def _decision(self, effect: Effect, dropped: frozenset[str], forced_reason: str) -> Decision:
        forced = self._forced(effect)
        if effect.kind == "after":
            return after_exposure(effect, self.effects, self.program.sensor, forced_reason)
        rms, bias = self.contribution(effect)
        then = math.sqrt(self._square(dropped | {effect.name}))
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
