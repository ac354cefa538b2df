"""Which effects pixels near saturation can do without while they run through their words.

What an effect does to them is guessed from its field, where no well cuts it off, and what all that
is left out does together is measured: some of these pixels run with it and without.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cached_property, partial

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects import Selection, everything
from nscc_runtime.effects.parts import Counted, Exchange, LitLevel, SlowWords, Soft
from nscc_runtime.light import Light
from nscc_runtime.planner.accounts import Account, Errors
from nscc_runtime.planner.chip import Chip, all_by_words, whole_chip
from nscc_runtime.planner.effect_fields import BOTH, Fields
from nscc_runtime.planner.near import Charges, reached
from nscc_runtime.planner.pixels import Running
from nscc_runtime.planner.prices import SHIPPED, Beside
from nscc_runtime.planner.program import Program
from nscc_runtime.planner.sample import Sample, among, brightest, weighed
from nscc_runtime.planner.worst import Worst, largest, worst_measured, worst_of
from nscc_runtime.remembered import remembered

Values = NDArray[np.float64]

_FEWEST, _MOST = 48, 512
"""Pixels on which it is measured, beside those for sure."""
_CUT_E = 1.0
"""Lost to what saturates: of more than that a pixel hardly changes."""
_PART = 8
"""Of this many pixels near saturation one is measured."""
_APART_NS = 1e6
"""What two kinds of pixels take more than one."""
_FRAMES = 3
"""Frames of a scene after which measuring has to have paid."""
_SIGMAS = 2.0
"""Standard errors of a measurement that has to fit as well."""
_NONE_OF = 3.0
"""Of so many of any number of pixels none is drawn in one sample of twenty."""
_LEFT = 3.0
"""Standard deviations of an error that is left at one of a few pixels."""
_EVEN = 0.25
"""The part of the sample that is drawn evenly, see `_chances`."""


@dataclass(frozen=True, eq=False)
class Lacking:
    """Pixels that run through their words; they lack `forced_off` in any case.

    `seen` is what they see. Those at `spilt`, which neighbours' light brings there, never lack that
    by choice: without it they are nothing.
    `fields` are predictions on a sample of the scene, `running`: which of it are such pixels.
    Threads change no bit.
    """

    program: Program
    light: Light
    seen: Charges
    spilt: NDArray[np.int64]
    fields: Fields
    running: NDArray[np.bool_]
    forced_off: frozenset[str]
    device_seed: int
    threads: int

    @property
    def near(self) -> NDArray[np.int64]:
        """Their places, in order."""
        return self.seen.places

    def chosen(self, dropped: frozenset[str], room: float) -> frozenset[str]:
        """Of the effects in `dropped`, which a plan leaves out elsewhere, those that these pixels
        lack as well: what saves most, as long as it adds at most `room` square electrons to the
        mean over the array.
        """
        if len(self.near) < 2 * _FEWEST:
            return frozenset()
        # Words that take no time would leave nothing of black suns, which are told of.
        dropped -= everything().names(SlowWords) | everything().names(LitLevel)
        found: list[str] = []
        price = partial(self._frame_ns, dropped)
        guessed = guesses(self.fields, self.running, dropped)
        while True:
            left = [
                (price(frozenset([*found, name])), name)
                for name in sorted(dropped.difference(found))
                if guessed.square([*found, name], [*found, name]).max() <= room
            ]
            if not left or min(left)[0] >= price(frozenset(found)):
                break
            found.append(min(left)[1])
        every = frozenset(found)
        apart = len(self.spilt) > 0 and price(by_spilt(every)) - price(every) < _APART_NS
        # Measuring takes time: it is all of them, all whose guess does not hang on a few bright
        # neighbours, or the one that saves most.
        for names in (by_spilt(every) if apart else every, by_spilt(every), frozenset(found[:1])):
            saved_ns = price(frozenset()) - price(names)
            if saved_ns * _FRAMES > self._measuring_ns(names) and self._fits(dropped, names, room):
                return names
        return frozenset()

    def _frame_ns(self, dropped: frozenset[str], lacking: frozenset[str]) -> float:
        """Nanoseconds of all these pixels in a frame whose sums lack what is `dropped`."""
        words = self._every.without(*self.forced_off, *lacking)
        beside: Beside = "sums" if self._alike(dropped, lacking) else "nothing"
        return self.program.work.words_ns(words, SHIPPED, beside) * len(self.near)

    def _measuring_ns(self, lacking: frozenset[str]) -> float:
        """Nanoseconds of finding what leaving effects out does."""
        each_ns = self._words_ns(frozenset()) + self._words_ns(lacking)
        return each_ns * len(self._sample.places)

    @property
    def tried_ns(self) -> float:
        """Nanoseconds that measuring has taken."""
        return sum(self._words_ns(lacking) * len(self._sample.places) for lacking in self._tried)

    @cached_property
    def _tried(self) -> list[frozenset[str]]:
        """What the measured pixels have lacked so far, each once."""
        return []

    def square(self, dropped: frozenset[str], lacking: frozenset[str]) -> Values:
        """What leaving effects out adds to the mean square error over the array, (buckets,), where
        sums lack what is `dropped`."""
        mean, _ = self._measured(lacking)
        return mean + self._evened(dropped, lacking)

    def square_error(self, lacking: frozenset[str]) -> Values:
        """The standard error (buckets,) of that: some of these pixels were measured, not all."""
        return self._measured(lacking)[1]

    def _alike(self, dropped: frozenset[str], lacking: frozenset[str]) -> bool:
        """Whether words count what sums do, so that these have counts for their neighbours."""
        counted = self._every.names(Counted)
        return counted & dropped == counted & (lacking | self.forced_off)

    def _evened(self, dropped: frozenset[str], lacking: frozenset[str]) -> Values:
        """What it adds that neighbours' counts are those of sums now, taken as even over their
        slots; where they are without it, or where sums have crosstalk, that is one of the plan's
        short cuts."""
        beside = everything().names(Exchange)
        before, now = (
            bool(beside & dropped) and not beside & (lost | self.forced_off)
            and self._alike(dropped, lost)
            for lost in (frozenset[str](), lacking)
        )  # fmt: skip
        return self._even_neighbours * (int(now) - int(before))

    @cached_property
    def _even_neighbours(self) -> Values:
        """The mean square (buckets,) over the array of taking neighbours' counts as even here."""
        fields = self.fields
        return fields.sample.mean(fields.neighbours[False] * self.running * fields.unfilled)

    def worst(self, lacking: frozenset[str]) -> Worst:
        """What these pixels lack, forced or not, at the worst of them."""
        if not len(self.near):
            return Worst(0.0, 0.0)
        error = np.abs(self._held(self.forced_off | lacking) - self._held(frozenset()))
        sure, pixels = len(self._surely), len(self.program.lanes)
        # All others of the array lack nothing.
        sizes = np.append(error.max(axis=0), 0.0)
        found = largest(sizes, np.append(self._sample.weight, pixels - len(self.near)))
        stands_for = self._sample.weight / pixels
        tails = [
            worst_measured(error[:, which], stands_for[which], pixels)
            for which in (slice(sure), slice(sure, None))
        ]
        max_e = max(each.max_e for each in (found, *tails))
        # Noise may have nothing cut off in another frame than the one that was measured.
        uncut = worst_of(self._just_full(lacking), self.fields.sample.weight, pixels)
        max_e = max(max_e, min(uncut.max_e, self._chip.full_e))
        return replace(found, max_e=max(max_e, self._left_e(self.forced_off | lacking)))

    def _left_e(self, lost: frozenset[str]) -> float:
        """What small errors come to, most of which cancel, at a pixel where what saturates has one
        of them left: there may be few of a kind that has."""
        sensor = self.program.sensor
        left = (part.sigma_e(sensor) for each, part in self._every.errors() if each.name in lost)
        return _LEFT * math.hypot(*left)

    @remembered
    def _just_full(self, lacking: frozenset[str]) -> Errors:
        """What they would lack if nothing cut it off, of no more light than fills PIX."""
        fields, near = self.fields, np.flatnonzero(self.running)
        nowhere = np.zeros(fields.expected.shape, np.bool_)
        seen_e = reached(self.seen.at(fields.sample.places[near]).most_e)
        part = np.zeros(len(fields.sample.places))
        part[near] = np.minimum(1.0, self._chip.full_e / np.maximum(seen_e, 1e-300))
        mean, variance, third = guesses(fields, self.running, lacking, nowhere).errors(
            lacking, lacking
        )
        return Errors(mean * part, variance * part, third * part)

    def _fits(self, dropped: frozenset[str], lacking: frozenset[str], room: float) -> bool:
        """Whether what leaving effects out adds is at most so much, for almost all samples."""
        unseen = self._unseen(lacking)
        if unseen.max() > room:  # told without measuring
            return False
        mean, error = self._measured(lacking)
        most = mean + _SIGMAS * error + unseen + self._evened(dropped, lacking)
        return bool(most.max() <= room)

    def _unseen(self, lacking: frozenset[str]) -> Values:
        """What it may add (buckets,) that no measured pixel is of a kind of which few lose much:
        as `_NONE_OF` of those that were drawn evenly, each losing what a pixel would whose PIX is
        just full."""
        even = self._evenly
        if not even:
            return np.zeros(len(self.fields.expected))
        mean, variance, _ = self._just_full(lacking)
        square = self.fields.sample.mean(mean**2 + variance)
        return np.asarray(square * min(1.0, _NONE_OF / even))

    @cached_property
    def _evenly(self) -> float:
        """How many of the measured pixels stand for all of these, drawn evenly; 0: all of these are
        measured."""
        if len(self._sample.places) >= len(self.near):
            return 0.0
        return _EVEN * (len(self._sample.places) - len(self._surely))

    @remembered
    def _measured(self, lacking: frozenset[str]) -> tuple[Values, Values]:
        """What leaving effects out adds to the mean square, and its standard error."""
        if not lacking or not len(self.near):  # a plan of a brighter scene may lack some
            none = np.zeros(len(self.fields.expected))
            return none, none
        full = self._held(frozenset())
        before = (full - self._held(self.forced_off)) ** 2 if self.forced_off else 0.0
        added = (full - self._held(self.forced_off | lacking)) ** 2 - before
        part = len(self.near) / len(self.program.lanes)
        square, error = self._sample.mean(added), self._sample.error(added)
        return np.maximum(square, 0.0) * part, error * part

    @cached_property
    def _sample(self) -> Sample:
        """The pixels that are measured: those for sure, then some of the rest."""
        rest = self.seen.at(self.near[~among(self.near, self._surely, len(self.program.lanes))])
        wanted = min(max(len(self.near) // _PART, _FEWEST), _MOST, len(rest.places))
        places, weight = self._surely, np.ones(len(self._surely))
        if wanted:
            drawn, each = weighed(self._chances(rest), wanted, len(rest.places))
            places, weight = np.append(places, rest.places[drawn]), np.append(weight, each)
        return Sample(places, weight, np.ones(len(places), np.bool_))

    @cached_property
    def _chip(self) -> Chip:
        """The chip with every effect."""
        return whole_chip(self.program, self.device_seed)

    @cached_property
    def _surely(self) -> NDArray[np.int64]:
        """Those of these pixels that are measured in any case, as few of them may have most of what
        is lost: the brightest, suns and what is beside them; the darkest, which may be the only
        ones that are not full; and those that take PIX, or registers, nearest to the most that they
        hold, where a little decides on all the rest."""
        seen_e, held_e = reached(self.seen.most_e), reached(self.seen.own[1:])
        well_e = np.abs(seen_e - self._chip.full_e)
        room_e = np.abs(held_e - everything().the(Soft).linear_e(self.program.sensor))
        sure = [brightest(each) for each in (seen_e, -seen_e, -well_e, *-room_e)]
        return np.asarray(self.near[np.unique(np.concatenate(sure))])

    def _chances(self, seen: Charges) -> Values:
        """How likely each is to be drawn: a quarter evenly, a quarter of those that are not full, a
        quarter of those that may lack their neighbours, a quarter by what these change there."""
        own_e, most_e, full_e = reached(seen.own_e), np.inf, self._chip.full_e
        not_full = own_e < full_e
        if self.program.all_single:
            # A full pixel changes no more; one that is read many times may be full now and then.
            own_e, most_e = np.minimum(own_e, full_e), full_e
        alone = ~among(seen.places, self.spilt, len(self.program.lanes))
        changed_e = np.abs(np.minimum(own_e + seen.gained_e, most_e) - own_e)
        scores = not_full, alone, np.where(alone, changed_e, 0.0)
        return np.asarray(1.0 + sum(each / max(each.mean(), 1e-300) for each in scores))

    @cached_property
    def _every(self) -> Selection:
        return all_by_words()

    @remembered
    def _held(self, lacking: frozenset[str]) -> Values:
        """Exposures (buckets, places) by the words, all drawn alike."""
        self._tried.append(lacking)
        by_choice = by_spilt(lacking) | lacking & self.forced_off
        if by_choice == lacking or not self._beside.any():
            return self._exposed(self._sample.places, lacking)
        found = np.empty((len(self.fields.expected), len(self._sample.places)))
        for some, lost in ((~self._beside, lacking), (self._beside, by_choice)):
            found[:, some] = self._exposed(self._sample.places[some], lost)
        return found

    @cached_property
    def _beside(self) -> NDArray[np.bool_]:
        """Which of them neighbours' light brings near saturation."""
        return among(self._sample.places, self.spilt, len(self.program.lanes))

    def _exposed(self, places: NDArray[np.int64], lacking: frozenset[str]) -> Values:
        wired = self._chip.wired(self._every.without(*lacking))
        found, _ = Running(wired, self.light, places, self.threads).expose(0, 0)
        return found

    def _words_ns(self, lacking: frozenset[str]) -> float:
        """Nanoseconds of a pixel that is measured: nobody has counts for its neighbours."""
        kept = self._every.without(*self.forced_off, *lacking)
        return self.program.work.words_ns(kept, SHIPPED, "nothing")


def by_spilt(lacking: frozenset[str]) -> frozenset[str]:
    """What pixels lack as well that neighbours' light brings near saturation."""
    return lacking - everything().names(Exchange)


def guesses(
    fields: Fields,
    running: NDArray[np.bool_],
    lacking: frozenset[str],
    cut: NDArray[np.bool_] | None = None,
) -> Account:
    """What pixels of a sample lack that run through their words without some effects, or any of
    them; nothing where it is `cut` off (buckets, pixels), by default by what saturates."""
    fixed: dict[str, Values] = {}
    random: dict[str, Values] = {}
    if cut is None:
        # Absent where nothing saturates.
        cut = np.abs(fields.fixed.get(BOTH, np.zeros(fields.expected.shape))) > _CUT_E
    for name in sorted(lacking):
        behind = fields.after.get(name)
        runs = running if name in by_spilt(lacking) else running & ~fields.spilt
        if name in fields.fixed:
            kept = np.where(cut, 0.0 if behind is None else behind, fields.fixed[name])
            fixed[name] = np.where(runs, kept, 0.0)
        if name in fields.variance:
            here = fields.variance[name]
            random[name] = np.where(runs & ~cut if behind is None else runs, here, 0.0)
    skewed = fields.skewed(random)
    return Account(fields.sample, len(fields.expected), fixed, random, skewed)
