"""Choosing a plan: which effects a tolerance lets go, and which it does not."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Literal

import numpy as np

from nscc_runtime.effects import EFFECTS, Effect, Selection, selected
from nscc_runtime.effects.crosstalk import CROSSTALK
from nscc_runtime.effects.dark import DARK
from nscc_runtime.effects.effect import Statistics
from nscc_runtime.effects.photodiode import FULL_WELL, READ, RESET
from nscc_runtime.effects.photons import PRNU, SHOT
from nscc_runtime.effects.readout import ADC_NOISE
from nscc_runtime.effects.registers import ANALOG, LEAKAGE, REGISTER
from nscc_runtime.effects.timing import DEAD_TIME, DECAY, LAG, MOTION
from nscc_runtime.light import Light
from nscc_runtime.plan.plan import Approximation, Choice, Decision, Plan
from nscc_runtime.plan.predict import SATURATION, Forecast
from nscc_runtime.plan.program import Program

DEFAULT_TOLERANCE_E = 5.0

MARGIN = 0.9
"""Effects are left out while the prediction stays below this part of the tolerance."""
_SHORT_CUTS = 0.6
"""Short cuts may take this part of the tolerance; beyond it, all pixels run through their words."""

_COST_NS = {
    SHOT.name: 6.0, PRNU.name: 6.0, DARK.name: 14.0, LAG.name: 0.0, DECAY.name: 0.0,
    RESET.name: 7.0, READ.name: 7.0, ANALOG.name: 14.0, LEAKAGE.name: 8.0, DEAD_TIME.name: 0.0,
    CROSSTALK.name: 60.0, MOTION.name: 0.5,
}  # fmt: skip
"""Nanoseconds a pixel that leaving an effect out saves; measured, to a factor of about two."""
_NOTHING = np.zeros(1)
_WORD_NS, _SLOT_NS = 300.0, 60.0
"""Of one pixel through its words, neighbours' counts included: nanoseconds a word, and a slot."""


def plan_for(
    program: Program,
    light: Light,
    tolerance_e: float = DEFAULT_TOLERANCE_E,
    effects: Selection | None = None,
    device_seed: int = 0,
) -> Plan:
    """The cheapest plan whose predicted error is within the tolerance, by the fewest effects.

    `effects`, by default `auto`, decides on what it names; without `auto` on everything. Errors are
    against the reference with all effects, those that were forced off included.
    """
    return Chooser(program, light, tolerance_e, effects or selected("auto"), device_seed).plan()


def predicted_for(program: Program, light: Light, plan: Plan, device_seed: int = 0) -> Plan:
    """The same decisions for another scene: what they make wrong there."""
    on = {each.name for each in plan.decisions if each.decision == "kept"}
    always = {effect.name for effect in EFFECTS if effect.always}
    names = frozenset(effect.name for effect in EFFECTS) - always
    chooser = Chooser(
        program, light, plan.tolerance_e, Selection(frozenset(on) | always, names), device_seed
    )
    made = chooser.plan("taken from the plan given")
    forced = {each.name: each.forced for each in plan.decisions}
    decisions = tuple(replace(each, forced=forced[each.name]) for each in made.decisions)
    return replace(made, decisions=decisions)


@dataclass(frozen=True, eq=False)
class Chooser:
    """One search; see `plan_for`."""

    program: Program
    light: Light
    tolerance_e: float
    effects: Selection
    device_seed: int

    @cached_property
    def forecast(self) -> Forecast:
        """What the scene makes of the effects."""
        off = frozenset(self._forced_off())
        return Forecast(self.program, self.light, self.tolerance_e, self.device_seed, off)

    def plan(self, forced_reason: str = "named in --effects") -> Plan:
        """The plan."""
        dropped = frozenset(self._forced_off())
        everywhere = self._everywhere(dropped)
        limit = (MARGIN * self.tolerance_e) ** 2
        forced = self.forecast.square(dropped, everywhere)
        if forced > limit:
            # What the user forced off has broken the promise: the rest keeps to it by itself.
            limit += forced
        while True:
            now = self.forecast.square(dropped, everywhere)
            fits = []
            for names in self._moves(dropped):
                then = self.forecast.square(dropped | names, everywhere)
                if then <= max(limit, now):
                    saved = self._saved_ns(names, dropped, everywhere)
                    if saved > 0:
                        fits.append((saved / max(then - now, 1e-12), sorted(names)))
            if not fits:
                return self._made(dropped, everywhere, forced_reason)
            dropped |= set(max(fits)[1])

    def _moves(self, dropped: frozenset[str]) -> Iterable[frozenset[str]]:
        """What may be left out next: an effect, or saturation as a whole."""
        free = {
            effect.name for effect in self.forecast.present
            if effect.name not in dropped and not self._forced(effect)
        }  # fmt: skip
        yield from (frozenset({name}) for name in sorted(free))
        if free >= SATURATION:
            yield SATURATION

    def _everywhere(self, dropped: frozenset[str]) -> bool:
        """Whether short cuts would cost too much, so that all pixels run through their words."""
        total = sum((square for _, square in self.forecast.short_cuts(dropped)), _NOTHING)
        return math.sqrt(float(np.max(total))) > _SHORT_CUTS * self.tolerance_e

    def _forced(self, effect: Effect) -> bool:
        return not self.effects.auto or effect.name in self.effects.forced

    def _forced_off(self) -> Iterable[str]:
        for effect in EFFECTS:
            if effect.kind != "after" and self._forced(effect) and effect not in self.effects:
                yield effect.name

    def _loop_cost(self, dropped: frozenset[str]) -> float:
        """Nanoseconds that pixels running through their words cost, shared over all pixels."""
        if self.forecast.state(dropped) != "words":
            return 0.0
        program = self.program
        words = len(program.pixels.entries) / len(program.container.encoding)
        each = _WORD_NS * words + _SLOT_NS * program.container.slots
        return each * len(self.forecast.near) / len(program.lanes)

    def _saved_ns(self, names: frozenset[str], dropped: frozenset[str], everywhere: bool) -> float:
        """Nanoseconds a pixel that leaving effects out saves, beside those in `dropped`."""
        if everywhere:
            # The words are run in any case; neighbours multiply what has to be counted.
            return _COST_NS[CROSSTALK.name] if CROSSTALK.name in names else 0.0
        saved = self._loop_cost(dropped - names) - self._loop_cost(dropped | names)
        return saved + sum(_COST_NS.get(name, 0.0) for name in names)

    def _made(self, dropped: frozenset[str], everywhere: bool, forced_reason: str) -> Plan:
        """The plan of these decisions."""
        fields = self.forecast.fields
        square, most = self.forecast.squares(dropped, everywhere)
        cuts: list[Approximation] = []
        if not everywhere:
            for name, part in self.forecast.short_cuts(dropped):
                error = math.sqrt(float(np.max(part)))
                if error > 0:
                    cuts.append(Approximation(name, error))
        reasons = []
        if everywhere:
            reasons.append(
                "counts would have to be spread over the slots of most pixels: the weights of a "
                "code's slots differ too much for this tolerance"
            )
        if self.forecast.state(dropped) == "words":
            reasons.append(f"{len(self.forecast.near)} pixels may saturate")
        loop: Literal["none", "some", "all"] = "some" if reasons else "none"
        return Plan(
            self.tolerance_e,
            math.sqrt(float(np.max(square))),
            math.sqrt(float(np.max(most))),
            "all" if everywhere else loop,
            tuple(reasons),
            len(fields.sample.places) / len(self.program.lanes),
            tuple(cuts),
            tuple(self._decision(each, dropped, everywhere, forced_reason) for each in EFFECTS),
            self.forecast.leak_nodes,
            self.forecast.closed,
        )

    def _decision(
        self, effect: Effect, dropped: frozenset[str], everywhere: bool, forced_reason: str
    ) -> Decision:
        forced = self._forced(effect)
        if effect.kind == "after":
            return self._after(effect, forced_reason)
        rms, bias = self.forecast.contribution(effect)
        then = math.sqrt(self.forecast.square(dropped | {effect.name}, everywhere))
        cost = self._saved_ns(frozenset({effect.name}), dropped, everywhere)
        choice: Choice = "kept"
        if effect not in self.forecast.present:
            choice, reason, cost = "absent", self._why_absent(effect), 0.0
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

    def _after(self, effect: Effect, forced_reason: str) -> Decision:
        """The readout's: no part of the promise, on unless the user wants it off."""
        contribution = effect.predict(Statistics(), self.program.sensor)
        on = effect.always or self.effects.auto or effect in self.effects
        if effect is ADC_NOISE and self.effects.auto and effect.name in self.effects.forced:
            on = effect in self.effects
        named = effect is ADC_NOISE and self._forced(effect)
        reason = forced_reason if named else "always applied, after the exposure"
        return Decision(
            effect.name, effect.kind, "kept" if on else "dropped", named, reason,
            contribution.rms_e, contribution.bias_e, None, 0.0,
        )  # fmt: skip

    def _why_absent(self, effect: Effect) -> str:
        if effect is MOTION:
            return "the scene's frames are the slots' integrals"
        if effect is DECAY:
            return "every register is written again in time"
        if effect in (FULL_WELL, REGISTER):
            return "no pixel comes near it"
        if effect in (LEAKAGE, DEAD_TIME, SHOT, LAG, PRNU, CROSSTALK):
            return "exactly nothing with this sensor, scene and program"
        return "this sensor has none"
