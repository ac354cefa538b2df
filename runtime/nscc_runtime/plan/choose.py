"""Choosing a plan: which effects a tolerance lets go, and which it does not."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects import EFFECTS, Effect, Selection, selected
from nscc_runtime.effects.crosstalk import CROSSTALK
from nscc_runtime.effects.dark import DARK
from nscc_runtime.effects.model import Statistics
from nscc_runtime.effects.photodiode import FULL_WELL, READ, RESET
from nscc_runtime.effects.photons import PRNU, SHOT
from nscc_runtime.effects.readout import ADC_NOISE
from nscc_runtime.effects.registers import ANALOG, LEAKAGE, REGISTER
from nscc_runtime.effects.timing import DEAD_TIME, DECAY, LAG, MOTION
from nscc_runtime.light import Light
from nscc_runtime.plan import leak_nodes
from nscc_runtime.plan.capture import Planned, Program
from nscc_runtime.plan.fields import BOTH, Fields, fields_of
from nscc_runtime.plan.model import Approximation, Choice, Decision, Plan
from nscc_runtime.plan.sample import sample_of

DEFAULT_TOLERANCE_E = 5.0

MARGIN = 0.9
"""Effects are left out while the prediction stays below this part of the tolerance."""
_SHORT_CUTS = 0.6
"""Short cuts may take this part of the tolerance; beyond it, all pixels run through their words."""
_FORMULA_E = 0.015
"""RMS of counts by formula against exact ones: one electron in some five thousand pixels."""
_LEAK_PART = 0.05

_COST_NS = {
    SHOT.name: 6.0, PRNU.name: 6.0, DARK.name: 14.0, LAG.name: 0.0, DECAY.name: 0.0,
    RESET.name: 7.0, READ.name: 7.0, ANALOG.name: 14.0, LEAKAGE.name: 8.0, DEAD_TIME.name: 0.0,
    CROSSTALK.name: 60.0, MOTION.name: 0.5,
}  # fmt: skip
"""Nanoseconds a pixel that leaving an effect out saves; measured, to a factor of about two."""
_NOTHING = np.zeros(1)
_SATURATION = frozenset({FULL_WELL.name, REGISTER.name})
_WORD_NS, _SLOT_NS = 60.0, 30.0
"""Of one pixel through its words: nanoseconds a word, and a slot or cut between words."""


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

    def plan(self, forced_reason: str = "named in --effects") -> Plan:
        """The plan."""
        dropped = frozenset(self._forced_off())
        everywhere = self._everywhere(dropped)
        limit = (MARGIN * self.tolerance_e) ** 2
        while True:
            now = self.square(dropped, everywhere)
            fits = []
            for names in self._moves(dropped):
                then = self.square(dropped | names, everywhere)
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
            effect.name for effect in self.candidates
            if effect.name not in dropped and not self._forced(effect)
        }  # fmt: skip
        yield from (frozenset({name}) for name in sorted(free))
        if free >= _SATURATION:
            yield _SATURATION

    @cached_property
    def fields(self) -> Fields:
        """What each effect does to a sample of the scene."""
        total_e = self._everything.total.reshape(self.light.shape)
        sample = sample_of(total_e, len(self.light.frames), self.near)
        return fields_of(self.program, self.light, sample, self.device_seed)

    @cached_property
    def near(self) -> NDArray[np.int64]:
        """The pixels that may saturate with every effect on."""
        return self._everything.saturating

    @cached_property
    def _everything(self) -> Planned:
        """The scene with every effect kept."""
        decisions = tuple(
            Decision(effect.name, effect.kind, "kept", False, "", None, None, None, 0.0)
            for effect in EFFECTS
        )
        plan = Plan(0.0, 0.0, 0.0, "some", (), 0.0, (), decisions)
        return Planned(self.program, self.light, plan, self.device_seed, threads=1)

    @cached_property
    def candidates(self) -> list[Effect]:
        """The effects that change the exposures of this scene at all."""
        fields = self.fields
        return [
            effect for effect in EFFECTS
            if (effect.kind != "after"
            and any(
                np.any(found.get(effect.name, 0.0)) for found in (fields.fixed, fields.variance)
            ))
            or (effect.name in _SATURATION and len(self.near))
        ]  # fmt: skip

    def square(self, dropped: frozenset[str], everywhere: bool) -> float:
        """The predicted mean square error of the worst bucket, in square electrons.

        `everywhere`: all pixels run through their words.
        """
        return float(np.max(self._square(dropped, everywhere)[0]))

    def _square(
        self, dropped: frozenset[str], everywhere: bool
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Predicted mean squares (buckets,), and the most that they can be: fixed parts add up."""
        state = self._state(dropped)
        names, products = self._products(state)
        # Saturation is a field of its own: in `BOTH` where neither is simulated.
        lost = _SATURATION & dropped
        inside = dropped - _SATURATION | (lost if lost != _SATURATION else {BOTH})
        at = [i for i, name in enumerate(names) if name in inside]
        part = products[:, at][:, :, at]
        random = sum((self._variances(state)[name] for name in self._random & dropped), _NOTHING)
        random = random + self._rounding(dropped)
        if not everywhere:
            random = random + sum((square for _, square in self._short_cuts(dropped)), _NOTHING)
        sizes = np.sqrt(np.maximum(np.diagonal(part, axis1=1, axis2=2), 0.0)).sum(axis=1)
        return part.sum(axis=(1, 2)) + random, sizes**2 + random

    def _state(self, dropped: frozenset[str]) -> str:
        """What becomes of pixels that may saturate: they run through their words with all effects,
        are clipped at the full well, or are taken as any others.
        """
        if not len(self.near) or dropped >= _SATURATION:
            return "sums"
        return "clip" if REGISTER.name in dropped and self._all_single else "words"

    @cached_property
    def _all_single(self) -> bool:
        tables = self.program.tables
        return not np.isnan(tables.single(self.program.full)).any()

    def _where(self, state: str) -> NDArray[np.float64]:
        """The part (buckets, pixels) of an effect that a state leaves: 0 where it is simulated."""
        fields = self.fields
        if state == "sums":
            return np.ones(fields.expected.shape)
        if state == "clip":
            return np.where(fields.clipped, 0.0, 1.0)
        return np.broadcast_to(np.where(fields.sample.near, 0.0, 1.0), fields.expected.shape)

    def _products(self, state: str) -> tuple[list[str], NDArray[np.float64]]:
        """Names of the fixed fields, and the means (buckets, ., .) of their products."""
        found = self._kept_products.get(state)
        if found is None:
            names, where = list(self.fields.fixed), self._where(state)
            stack = np.stack(
                [
                    self.fields.fixed[name] * (1.0 if name in {*_SATURATION, BOTH} else where)
                    for name in names
                ],
                axis=1,
            )
            weight = self.fields.sample.weight
            products = (stack * (weight / weight.sum())) @ stack.transpose(0, 2, 1)
            found = self._kept_products[state] = names, products
        return found

    def _variances(self, state: str) -> dict[str, NDArray[np.float64]]:
        found = self._kept_variances.get(state)
        if found is None:
            where = self._where(state)
            found = self._kept_variances[state] = {
                name: self.fields.sample.mean(v * where) for name, v in self.fields.variance.items()
            }
        return found

    @cached_property
    def _random(self) -> frozenset[str]:
        return frozenset(self.fields.variance)

    @cached_property
    def _kept_products(self) -> dict[str, tuple[list[str], NDArray[np.float64]]]:
        return {}

    @cached_property
    def _kept_variances(self) -> dict[str, dict[str, NDArray[np.float64]]]:
        return {}

    def _rounding(self, dropped: frozenset[str]) -> NDArray[np.float64]:
        """What whole counts add to a shift of their mean: f (1 - f), f its fraction."""
        shifting = frozenset(dropped & set(self.fields.shifts))
        if not shifting or SHOT.name in dropped:
            return _NOTHING
        kept = self._rounded.get(shifting)
        if kept is None:
            shift = sum((self.fields.shifts[name] for name in shifting), _NOTHING)
            part = np.abs(shift) % 1.0
            kept = self._rounded[shifting] = self.fields.sample.mean(part * (1.0 - part))
        return kept

    @cached_property
    def _rounded(self) -> dict[frozenset[str], NDArray[np.float64]]:
        return {}

    @cached_property
    def closed(self) -> bool:
        """Whether the charge of closed slots is worth counting."""
        sample, fields = self.fields.sample, self.fields
        more = sample.mean(fields.thinning[False] - fields.thinning[True])
        more = more + sample.mean(fields.neighbours[False] - fields.neighbours[True])
        return bool(np.max(more) > (0.1 * self.tolerance_e) ** 2)

    @cached_property
    def leak_nodes(self) -> int:
        """At how many rates of leakage sums are made."""
        age_s = float(self.program.slot_s.sum())
        size = math.sqrt(float(np.max(self.fields.sample.mean(self.fields.expected**2))))
        for count in range(1, leak_nodes.MOST):
            error = leak_nodes.error(self.program.sensor, count, age_s) * size
            if error <= _LEAK_PART * self.tolerance_e:
                return count
        return leak_nodes.MOST

    def _short_cuts(self, dropped: frozenset[str]) -> Iterable[tuple[str, NDArray[np.float64]]]:
        """The short cuts of a plan by sums, with their mean squares."""
        fields = self.fields
        counted = not {SHOT.name, DARK.name} <= dropped
        if counted:
            yield (
                "counts are not spread over the slots of a group",
                fields.sample.mean(fields.thinning[self.closed]),
            )
            yield "counts from a rate of 10 on by formula", np.full(1, _FORMULA_E**2)
            if CROSSTALK.name not in dropped and self._has(CROSSTALK):
                yield (
                    "neighbours' counts are taken as even over their slots",
                    fields.sample.mean(fields.neighbours[self.closed]),
                )
        if not {READ.name, RESET.name, ANALOG.name} <= dropped:
            yield (
                "the noise of words as at the mean leakage",
                fields.sample.mean(fields.noise_cut),
            )
        if LEAKAGE.name not in dropped and self._has(LEAKAGE):
            age_s = float(self.program.slot_s.sum())
            relative = leak_nodes.error(self.program.sensor, self.leak_nodes, age_s)
            yield (
                f"leakage from sums at {self.leak_nodes} rate{'s' * (self.leak_nodes > 1)}",
                relative**2 * fields.sample.mean(fields.expected**2),
            )

    def _has(self, effect: Effect) -> bool:
        return any(each is effect for each in self.candidates)

    def _everywhere(self, dropped: frozenset[str]) -> bool:
        """Whether short cuts would cost too much, so that all pixels run through their words."""
        total = sum((square for _, square in self._short_cuts(dropped)), _NOTHING)
        return math.sqrt(float(np.max(total))) > _SHORT_CUTS * self.tolerance_e

    def _forced(self, effect: Effect) -> bool:
        return not self.effects.auto or effect.name in self.effects.forced

    def _forced_off(self) -> Iterable[str]:
        for effect in EFFECTS:
            if effect.kind != "after" and self._forced(effect) and effect not in self.effects:
                yield effect.name

    def _loop_cost(self, dropped: frozenset[str]) -> float:
        """Nanoseconds that pixels running through their words cost, shared over all pixels."""
        if self._state(dropped) != "words":
            return 0.0
        program = self.program
        words = len(program.pixels.entries) / len(program.container.encoding)
        each = _WORD_NS * words + _SLOT_NS * program.container.slots
        return each * len(self.near) / len(program.lanes)

    def _saved_ns(self, names: frozenset[str], dropped: frozenset[str], everywhere: bool) -> float:
        """Nanoseconds a pixel that leaving effects out saves, beside those in `dropped`."""
        if everywhere:
            # The words are run in any case; neighbours multiply what has to be counted.
            return _COST_NS[CROSSTALK.name] if CROSSTALK.name in names else 0.0
        saved = self._loop_cost(dropped - names) - self._loop_cost(dropped | names)
        return saved + sum(_COST_NS.get(name, 0.0) for name in names)

    def _made(self, dropped: frozenset[str], everywhere: bool, forced_reason: str) -> Plan:
        """The plan of these decisions."""
        fields = self.fields
        square, most = self._square(dropped, everywhere)
        cuts: list[Approximation] = []
        if not everywhere:
            for name, part in self._short_cuts(dropped):
                error = math.sqrt(float(np.max(part)))
                if error > 0:
                    cuts.append(Approximation(name, error))
        reasons = []
        if everywhere:
            reasons.append(
                "counts would have to be spread over the slots of most pixels: the weights of a "
                "code's slots differ too much for this tolerance"
            )
        if self._state(dropped) == "words":
            reasons.append(f"{len(self.near)} pixels may saturate")
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
            self.leak_nodes,
            self.closed,
        )

    def _decision(
        self, effect: Effect, dropped: frozenset[str], everywhere: bool, forced_reason: str
    ) -> Decision:
        forced = self._forced(effect)
        if effect.kind == "after":
            return self._after(effect, forced_reason)
        rms, bias = self._contribution(effect)
        then = math.sqrt(self.square(dropped | {effect.name}, everywhere))
        cost = self._saved_ns(frozenset({effect.name}), dropped, everywhere)
        choice: Choice = "kept"
        if not self._has(effect):
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

    def _contribution(self, effect: Effect) -> tuple[float, float]:
        """RMS and mean of what an effect does, in the bucket where it does most."""
        mean = self.fields.sample.mean
        field, variance = self.fields.fixed.get(effect.name), self.fields.variance.get(effect.name)
        where = self._where("words" if len(self.near) else "sums")
        if effect.name in _SATURATION:
            where = np.ones_like(where)
        square = _NOTHING if field is None else mean(field**2 * where)
        square = np.atleast_1d(square + (0.0 if variance is None else mean(variance * where)))
        worst = int(np.argmax(square))
        bias = 0.0 if field is None else float(mean(field * where)[worst])
        return math.sqrt(float(square[worst])), bias

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
