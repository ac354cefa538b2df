"""Forecasts: how wrong a scene's exposures get when effects are left out of it.

Dropped fixed effects are added up as signed fields on a sample of pixels, since they may cancel or
add; random ones, and the short cuts of running a plan, in quadrature.
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects import CannotHave, Effect, Selection, everything, registered
from nscc_runtime.effects.parts import (
    Counted,
    CountedLight,
    Errors,
    Exchange,
    Leak,
    LitLevel,
    Part,
    Saturates,
    SlowWords,
    Soft,
)
from nscc_runtime.light import Light
from nscc_runtime.planner import leak_nodes
from nscc_runtime.planner.accounts import Account
from nscc_runtime.planner.chip import Chip, whole_chip
from nscc_runtime.planner.effect_fields import BOTH, FORCED, Fields, SampledFields
from nscc_runtime.planner.near import Charges
from nscc_runtime.planner.plan import Plan
from nscc_runtime.planner.plan_parts import Decision
from nscc_runtime.planner.prepared import Prepared
from nscc_runtime.planner.program import Program
from nscc_runtime.planner.reweighed import off_for_good
from nscc_runtime.planner.sample import among, brightest, sample_of
from nscc_runtime.planner.short_cuts import (
    BESIDE_NEAR,
    FORMULA,
    FORMULA_E,
    LEAK,
    NEIGHBOURS,
    NOISE,
    PARTS,
    THINNING,
)
from nscc_runtime.remembered import remembered

Values = NDArray[np.float64]

CLIP = "clip"
"""Sums that are clipped know nothing of light that falls before the level of a reset is read; that
is about as much as all of the gates' switching does.
"""
_LEAK_PART = 0.05
_CLOSED_PART = 0.1
WORDS = "words"
"""The state where pixels run through their words; without some of saturation it begins so."""
_NOTHING = np.zeros(1)


@dataclass(frozen=True, eq=False)
class Forecast(ABC):
    """What a scene makes of a program's effects. The tolerance decides on short cuts, and on how
    well has to be known what saturation loses. Threads change no bit.
    """

    program: Program
    light: Light
    device_seed: int
    threads: int

    @property
    @abstractmethod
    def tolerance_e(self) -> float:
        """The tolerance in electrons."""

    @property
    @abstractmethod
    def bounded(self) -> bool:
        """Whether the worst pixel has a tolerance of its own."""

    @property
    @abstractmethod
    def forced_off(self) -> frozenset[str]:
        """Effects that not even pixels running through their words have."""

    @cached_property
    def fields(self) -> Fields:
        """What each effect does to a sample of the scene."""
        return self.sampled.for_tolerance(self.tolerance_e)

    @cached_property
    def sampled(self) -> SampledFields:
        """The fields on a sample, of which `fields` are those for the tolerance."""
        seen_e = self._everything.near.charges.at(self.near).most_e
        sample = sample_of(
            self.total_e, len(self.light.frames), self.near, self.spilt, seen_e,
            self._most_exposed if self.bounded else None,
        )  # fmt: skip
        lost = self.forced_off - self.saturation - self.slow
        return SampledFields(
            self.program, self.light, sample, self.spilt, self.device_seed, lost,
            self.forced_off & self.saturation, self.threads,
        )  # fmt: skip

    @property
    def _most_exposed(self) -> NDArray[np.int64]:
        """Of pixels that do not saturate those with the largest exposures: what few of them err, as
        lamps that flash in open slots do, is in no other pixel."""
        size = np.abs(self._everything.expected).max(axis=0)
        far = np.delete(self.program.places, self.near)
        return far[brightest(size[far])]

    @cached_property
    def total_e(self) -> Values:
        """All the charge (rows, cols) of each pixel; a few may have most of the dark one, as lamps
        have most of the light."""
        found = self._everything.total + self._everything.chip.frame_dark_e
        return np.asarray(found.reshape(self.light.shape))

    @cached_property
    def every(self) -> Selection:
        """All effects."""
        return everything()

    @cached_property
    def saturation(self) -> frozenset[str]:
        """Effects that need single pixels to run through their words."""
        return self.every.names(Saturates)

    @cached_property
    def slow(self) -> frozenset[str]:
        """Effects that the loop over words cannot have: only the reference has them."""
        return frozenset(e.name for e in registered() if isinstance(e.words, CannotHave))

    @cached_property
    def _having(self) -> dict[type[Part], frozenset[str]]:
        """The names of the effects that have a part of a kind that predictions hang on."""
        kinds = SlowWords, LitLevel, Soft, CountedLight
        return {kind: self.every.names(kind) for kind in kinds}

    @cached_property
    def near(self) -> NDArray[np.int64]:
        """The pixels that may saturate with every effect on."""
        return self._everything.saturating

    @cached_property
    def spilt(self) -> NDArray[np.int64]:
        """Those of them that neighbours' light brings there, as suns do to what is beside them."""
        return self._everything.near.spilt

    @cached_property
    def _everything(self) -> Prepared:
        """The scene with every effect kept."""
        return self._prepared(frozenset())

    @cached_property
    def _of_wanted(self) -> Prepared:
        """The scene with every effect but those forced off, which say which pixels run."""
        off = self.forced_off - self.saturation
        return self._prepared(off) if off else self._everything

    def _prepared(self, off: frozenset[str]) -> Prepared:
        decisions = tuple(
            Decision(
                effect.name, effect.kind, "dropped" if effect.name in off else "kept",
                effect.name in off, "", None, None, None, 0.0,
            )
            for effect in registered()
        )  # fmt: skip
        plan = Plan(0.0, 0.0, 0.0, "some", (), 0.0, (), decisions)
        return Prepared(self.program, self.light, plan, self.device_seed, self.threads)

    @cached_property
    def present(self) -> list[Effect]:
        """The effects that change the exposures of this scene at all."""
        fields = self.fields
        return [
            effect for effect in registered()
            if (effect.kind != "after"
            and any(
                effect.name in found and found[effect.name].any()
                for found in (fields.fixed, fields.variance)
            ))
            or (effect.name in self.saturation and len(self.near))
        ]  # fmt: skip

    @cached_property
    def here(self) -> frozenset[str]:
        """Their names."""
        return frozenset(effect.name for effect in self.present)

    def squares(self, dropped: frozenset[str], everywhere: bool) -> Values:
        """Predicted mean squares (buckets,), in square electrons; `everywhere`: all pixels run
        through their words."""
        wrong = self.wrong(dropped, everywhere)
        return self.account_of(dropped, everywhere).square(*wrong) + self._rounding(dropped)

    def most(self, dropped: frozenset[str], everywhere: bool) -> Values:
        """The most (buckets,) that they can be: fixed parts add up."""
        wrong = self.wrong(dropped, everywhere)
        return self.account_of(dropped, everywhere).most(*wrong) + self._rounding(dropped)

    def wrong(
        self, dropped: frozenset[str], everywhere: bool
    ) -> tuple[frozenset[str], frozenset[str]]:
        """The names of what is fixed, and of what is random, that a plan has wrong."""
        off = self.off_for_good(dropped, everywhere)
        return self.inside(dropped) | off, self.lost(dropped, everywhere) | off

    def off_for_good(self, dropped: frozenset[str], everywhere: bool) -> frozenset[str]:
        """The errors of words that not even sums take as with every effect."""
        off = dropped if everywhere else dropped & self.forced_off
        return off_for_good(off, dropped) if off else off

    def account_of(self, dropped: frozenset[str], everywhere: bool) -> Account:
        """The account that has all of that."""
        more = bool(self.off_for_good(dropped, everywhere))
        return self.account(self.state(dropped), more)

    @remembered
    def account(self, state: str, off_for_good: bool = False) -> Account:
        """What is wrong in a state of the pixels that may saturate, by effects and short cuts; and
        by errors that lack what weighs them."""
        fields = self.fields
        fixed = {name: self.left(name, state) for name in (*fields.fixed, CLIP)}
        random = self.random(state) | self._squares(state)
        if off_for_good:
            # These are behind the full well.
            where = self._where("sums" if state == "clip" else state)
            found = self.sampled.reweighed
            fixed |= {name: each * where for name, each in found.fixed.items()}
            random |= {name: each * where for name, each in found.variance.items()}
        skewed = fields.skewed(random)
        return Account(fields.sample, len(fields.expected), fixed, random, skewed)

    def lost(self, dropped: frozenset[str], everywhere: bool) -> frozenset[str]:
        """The names of all that is random and that a plan lacks."""
        return dropped if everywhere else dropped.union(self.taken(dropped))

    def inside(self, dropped: frozenset[str]) -> frozenset[str]:
        """The fixed fields that a plan lacks which leaves these effects out."""
        # Saturation is a field of its own: in `BOTH` where neither is simulated.
        lost = self.saturation & dropped
        found = dropped - self.saturation | (lost if lost != self.saturation else {BOTH})
        if self._having[SlowWords] <= dropped:
            found |= self._having[LitLevel]
        return found | {CLIP, FORCED}

    @remembered
    def state(self, dropped: frozenset[str]) -> str:
        """What becomes of pixels that may saturate: they run through their words with all effects,
        are clipped at the full well, or are taken as any others.
        """
        if not len(self.near) or dropped >= self.saturation:
            return "sums"
        if self._having[Soft] <= dropped and self.program.all_single:
            return "clip"
        # With less that saturates fewer pixels run through their words.
        return " without ".join((WORDS, *sorted(self.saturation & dropped)))

    @remembered
    def running(self, state: str) -> NDArray[np.int64]:
        """The places of pixels that run through their words because they may saturate."""
        if not state.startswith(WORDS):
            return np.empty(0, np.int64)
        near = self._of_wanted.near
        if state == WORDS:
            return near.places
        return replace(near, chip=near.chip.own(_without, *state.split(" without ")[1:])).places

    def charges(self, state: str) -> Charges:
        """What they see."""
        return self._of_wanted.near.charges.at(self.running(state))

    @remembered
    def runs(self, state: str) -> NDArray[np.bool_]:
        """Which pixels of the sample are among them."""
        return among(self.fields.sample.places, self.running(state), len(self.program.lanes))

    @remembered
    def _where(self, state: str) -> Values:
        """The part (buckets, pixels) of effects that a state leaves: 0 where it simulates them."""
        fields = self.fields
        if state == "sums":
            return np.ones(fields.expected.shape)
        if state == "clip":
            return np.where(fields.clipped, 0.0, 1.0)
        return np.broadcast_to(np.where(self.runs(state), 0.0, 1.0), fields.expected.shape)

    def left(self, name: str, state: str) -> Values:
        """The field (buckets, pixels) of a fixed effect as far as a state does not simulate it."""
        fixed, clipped = self.fields.fixed, self.fields.clipped
        if name == CLIP:
            field = np.zeros(clipped.shape)
            if state == "clip":
                for slow in sorted(self._having[SlowWords] | self._having[LitLevel]):
                    field += np.where(clipped, fixed[slow], 0.0)
            return field
        field = fixed[name]
        if name == FORCED:
            return np.where(self.runs(state), field, 0.0)
        if state == "sums" or name == BOTH or name in self.saturation:
            return field
        if state == "clip":
            return np.where(clipped, self.fields.after.get(name, 0.0), field)
        return field if name in self.slow else field * self._where(state)

    def random(self, state: str) -> dict[str, Values]:
        """The variances (buckets, pixels) of random effects as far as a state does not simulate
        them."""
        if state == "sums":
            return self.fields.variance
        whole = self.slow | self.saturation
        whole = whole.union(self.fields.after if state == "clip" else ())
        return {
            name: variance if name in whole else variance * self._where(state)
            for name, variance in self.fields.variance.items()
        }

    def _rounding(self, dropped: frozenset[str]) -> Values:
        """What whole counts add to a shift of their mean: f (1 - f), f its fraction."""
        return _NOTHING if self._having[CountedLight] <= dropped else self._rounded(dropped)[1]

    def rounding_of(self, dropped: frozenset[str]) -> Values:
        """The same of each pixel (buckets, pixels)."""
        uncounted = self._having[CountedLight] <= dropped
        return np.zeros(self.fields.expected.shape) if uncounted else self._rounded(dropped)[0]

    def _rounded(self, dropped: frozenset[str]) -> tuple[Values, Values]:
        return self._rounded_by(dropped & self._shifting)

    @cached_property
    def _shifting(self) -> frozenset[str]:
        return frozenset(self.fields.shifts)

    @remembered
    def _rounded_by(self, shifting: frozenset[str]) -> tuple[Values, Values]:
        """What these make of each pixel, and in the mean."""
        part = np.zeros(self.fields.expected.shape)
        for name in sorted(shifting):
            part += self.fields.shifts[name]
        part = np.abs(part)
        part -= np.floor(part)
        part *= 1.0 - part
        return part, self.fields.sample.mean(part)

    @cached_property
    def closed(self) -> bool:
        """Whether the charge of closed slots is worth counting."""
        sample, fields = self.fields.sample, self.fields
        more = fields.thinning[False] - fields.thinning[True]
        more = more + fields.neighbours[False] - fields.neighbours[True]
        more = more * self._where(WORDS) + self._levels(closed=False) - self._levels(closed=True)
        more = sample.mean(more)
        return bool(np.max(more) > (_CLOSED_PART * self.tolerance_e) ** 2)

    def _levels(self, closed: bool, state: str = WORDS) -> Values:
        """The variance (buckets, pixels) of neighbours' counts in levels that does not go again, as
        PIX is full at the end, as far as a state has it: with closed slots counted, of counts taken
        as even over their slots, at most a quarter."""
        found = self.fields.levels * (self.fields.clipped & self.runs(state))
        return found / 4.0 if closed else found

    @cached_property
    def _own(self) -> Values:
        """The variance (buckets, pixels) of pixels' own counts in slots of which words see a part,
        as they take time: where pixels run through their words they are taken as even. Where PIX is
        full in the end that matters in levels alone."""
        fields, program = self.fields, self.program
        kept = self.every.without(*self.forced_off)
        if kept.part(CountedLight) is None or kept.part(SlowWords) is None:
            return np.zeros(fields.expected.shape)
        places, lanes = fields.sample.places, program.lanes[fields.sample.places]
        slot_e = self.light.sum_e.reshape(-1)[places] / self.light.slots
        full_e = whole_chip(program, self.device_seed).full_e
        levels, others = (each[:, lanes] for each in program.read_parts)
        seen = np.where(fields.clipped, levels, levels + others) * slot_e
        reads = program.tables.squared_reads(program.full).T[:, lanes]
        most = reads * (full_e**2 / np.maximum(slot_e, 1.0))
        return np.minimum(seen, most)

    @cached_property
    def leak_nodes(self) -> int:
        """At how many rates of leakage sums are made."""
        sizes = np.sqrt(self.fields.sample.mean(self.fields.expected**2))
        most, error = _LEAK_PART * self.tolerance_e, self.program.leak_error
        enough = (n for n in range(1, leak_nodes.MOST) if np.max(error(n) * sizes) <= most)
        return next(enough, leak_nodes.MOST)

    def short_cuts(self, dropped: frozenset[str]) -> Iterable[tuple[str, Values]]:
        """The short cuts of a plan by sums, in words, with their mean squares (buckets,)."""
        account = self.account(self.state(dropped))
        for name in self.taken(dropped):
            rates = f"{self.leak_nodes} rate{'s' * (self.leak_nodes > 1)}"
            yield name.format(rates=rates), account.variance((name,))

    @remembered
    def taken(self, dropped: frozenset[str]) -> tuple[str, ...]:
        """Which short cuts these are."""
        counted, beside, errors, leak = self._needed
        found: tuple[str, ...] = ()
        if not counted <= dropped:
            found = (THINNING, FORMULA)
            if not beside <= dropped:
                found += (NEIGHBOURS, PARTS)
            elif beside - self.forced_off and counted & dropped <= self.forced_off:
                found += (BESIDE_NEAR, PARTS)
        if not errors <= dropped:
            found += (NOISE,)
        return found if leak <= dropped else (*found, LEAK)

    @cached_property
    def _needed(self) -> tuple[frozenset[str], ...]:
        """Effects without all of which short cuts are none: with counts, with neighbours' charge,
        with noise of words, with leakage."""
        names = self.every.names
        beside, leak = names(Exchange) & self.here, names(Leak) & self.here
        return names(Counted), beside, names(Errors), leak

    def _squares(self, state: str) -> dict[str, Values]:
        """The squares (buckets, pixels) that short cuts leave."""
        fields, where = self.fields, self._where(state)
        leaked = self.program.leak_error(self.leak_nodes)[:, None] * fields.expected
        after = np.ones(1) if state == "clip" else where
        # Pixels that run through their words spread their own counts over the slots, and have their
        # neighbours' from sums: of one that is full, these matter nothing.
        unfilled = self.runs(state) * fields.unfilled
        beside = fields.neighbours[self.closed]
        return {
            THINNING: fields.thinning[self.closed] * where,
            FORMULA: np.full(where.shape, FORMULA_E**2),
            NEIGHBOURS: beside * np.maximum(where, unfilled),
            BESIDE_NEAR: beside * unfilled,
            PARTS: self._own * self.runs(state) + self._levels(self.closed, state),
            NOISE: fields.noise_cut * after,
            LEAK: leaked**2 * after,
        }

    @remembered
    def contribution(self, effect: Effect) -> tuple[float, float]:
        """RMS and mean of what an effect does, in the bucket where it does most."""
        # What happens where pixels saturate is what black suns are about.
        all_of_it = effect.parts(LitLevel) or not len(self.near)
        square, bias = self.account("sums" if all_of_it else WORDS).own(effect.name)
        worst = int(square.argmax())
        return math.sqrt(float(square[worst])), float(bias[worst])


def _without(chip: Chip, *lost: str) -> Chip:
    """The same chip without some effects."""
    return replace(chip, kept=chip.kept.without(*lost))
