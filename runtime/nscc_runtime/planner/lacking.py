"""Which effects pixels near saturation can do without while they run through their words.

What an effect does to them is guessed from its field, where no well cuts it off, and what all that
is left out does together is measured: some of these pixels run with it and without.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property, partial

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects import CannotHave, Selection, everything
from nscc_runtime.effects.parts import Counted, Exchange, LitLevel, SlowWords, Soft
from nscc_runtime.light import Light
from nscc_runtime.planner.accounts import Account
from nscc_runtime.planner.chip import Chip, whole_chip
from nscc_runtime.planner.effect_fields import BOTH, Fields
from nscc_runtime.planner.near import reached
from nscc_runtime.planner.pixels import Running
from nscc_runtime.planner.prices import SHIPPED, Beside
from nscc_runtime.planner.program import Program
from nscc_runtime.planner.sample import among, brightest, drawn_evenly
from nscc_runtime.planner.worst import Worst, largest, worst_measured
from nscc_runtime.remembered import remembered

Values = NDArray[np.float64]

_FEWEST, _MOST = 48, 512
"""Pixels on which it is measured."""
_FEWEST_DRAWN = 24
"""Of them those that are not chosen for sure: of fewer one stands for many, whatever it happens to
lack."""
_CUT_E = 1.0
"""Lost to what saturates: of more than that a pixel hardly changes."""
_PART = 8
"""Of this many pixels near saturation one is measured."""
_APART_NS = 1e6
"""What two kinds of pixels take more than one."""
_SIGMAS = 2.0
"""Standard errors of a measurement that has to fit as well."""


@dataclass(frozen=True, eq=False)
class Lacking:
    """The pixels at `near`, which run through their words; they lack `forced_off` in any case.

    `seen_e` is the most charge that they see, what neighbours give them included. Those at `spilt`,
    which neighbours' light brings there, never lack that by choice: without it they are nothing.
    `fields` are predictions on a sample of the scene, `running`: which of it are such pixels.
    Threads change no bit.
    """

    program: Program
    light: Light
    near: NDArray[np.int64]
    seen_e: Values
    spilt: NDArray[np.int64]
    fields: Fields
    running: NDArray[np.bool_]
    forced_off: frozenset[str]
    device_seed: int
    threads: int

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
            if saved_ns > self._measuring_ns(names) and self._most(dropped, names) <= room:
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
        return each_ns * len(self._places)

    @property
    def tried_ns(self) -> float:
        """Nanoseconds that measuring has taken."""
        return sum(self._words_ns(lacking) * len(self._places) for lacking in self._tried)

    @cached_property
    def _tried(self) -> list[frozenset[str]]:
        """What the measured pixels have lacked so far, each once."""
        return []

    def square(self, dropped: frozenset[str], lacking: frozenset[str]) -> Values:
        """What leaving effects out adds to the mean square error over the array, (buckets,), where
        sums lack what is `dropped`."""
        mean, _ = self._measured(lacking)
        return mean + self._evened(dropped, lacking)

    def _alike(self, dropped: frozenset[str], lacking: frozenset[str]) -> bool:
        """Whether words count what sums do, so that these have counts for their neighbours."""
        counted = self._every.names(Counted)
        return counted & dropped == counted & lacking

    def _evened(self, dropped: frozenset[str], lacking: frozenset[str]) -> Values:
        """What it adds that neighbours' counts are those of sums now, taken as even over their
        slots; where sums have crosstalk, that is one of their short cuts."""
        beside = everything().names(Exchange)
        fields = self.fields
        if not beside & dropped or beside & lacking or not self._alike(dropped, lacking):
            return np.zeros(len(fields.expected))
        return fields.sample.mean(fields.neighbours[False] * (self.running & ~fields.clipped))

    def worst(self, lacking: frozenset[str]) -> Worst:
        """What these pixels lack, forced or not, at the worst of them."""
        if not len(self.near):
            return Worst(0.0, 0.0)
        error = np.abs(self._held(self.forced_off | lacking) - self._held(frozenset()))
        sure, pixels = len(self._surely), len(self.program.lanes)
        rest, drawn = len(self.near) - sure, error.shape[1] - sure
        weight = np.append(np.ones(sure), np.full(drawn, rest / max(drawn, 1)))
        # All others of the array lack nothing.
        sizes, weight = np.append(error.max(axis=0), 0.0), np.append(weight, pixels - weight.sum())
        found = largest(sizes, weight)
        tails = [worst_measured(error[:, :sure], sure / pixels, pixels)]
        if drawn:
            tails.append(worst_measured(error[:, sure:], rest / pixels, pixels))
        return replace(found, max_e=max(each.max_e for each in (found, *tails)))

    def _most(self, dropped: frozenset[str], lacking: frozenset[str]) -> float:
        mean, error = self._measured(lacking)
        return float(np.max(mean + _SIGMAS * error + self._evened(dropped, lacking)))

    @remembered
    def _measured(self, lacking: frozenset[str]) -> tuple[Values, Values]:
        """What leaving effects out adds to the mean square, and its standard error."""
        if not lacking or not len(self.near):  # a plan of a brighter scene may lack some
            none = np.zeros(len(self.fields.expected))
            return none, none
        full = self._held(frozenset())
        before = (full - self._held(self.forced_off)) ** 2 if self.forced_off else 0.0
        added = (full - self._held(self.forced_off | lacking)) ** 2 - before
        sure = len(self._surely)
        square, drawn = added[:, :sure].sum(axis=1), added[:, sure:]
        error = np.zeros_like(square)
        if drawn.size:
            square = square + drawn.mean(axis=1) * (len(self.near) - sure)
            error = drawn.std(axis=1) / np.sqrt(drawn.shape[1]) * (len(self.near) - sure)
        pixels = len(self.program.lanes)
        return np.maximum(square, 0.0) / pixels, error / pixels

    @cached_property
    def _chip(self) -> Chip:
        """The chip with every effect."""
        return whole_chip(self.program, self.device_seed)

    @cached_property
    def _surely(self) -> NDArray[np.int64]:
        """Those of these pixels that are measured in any case: the brightest, suns and what is
        beside them, and those that take PIX, or registers, nearest to the most that they hold,
        where a little decides on all the rest."""
        program, seen_e = self.program, reached(self.seen_e)
        held_e = seen_e * program.by_lane.in_registers[:, program.lanes[self.near]]
        room_e = np.abs(held_e - everything().the(Soft).linear_e(program.sensor)).min(axis=0)
        well_e = np.abs(seen_e - self._chip.full_e)
        sure = [brightest(each) for each in (self.seen_e, -well_e, -room_e)]
        return self.near[np.unique(np.concatenate(sure))]

    @cached_property
    def _places(self) -> NDArray[np.int64]:
        """The pixels that are measured: those for sure, and some of the rest."""
        rest = self.near[~among(self.near, self._surely, len(self.program.lanes))]
        if not len(rest):
            return self._surely
        wanted = min(max(len(self.near) // _PART, _FEWEST), _MOST) - len(self._surely)
        wanted = max(wanted, _FEWEST_DRAWN)
        # In step with no tile of codes.
        return np.append(self._surely, drawn_evenly(rest, wanted))

    @cached_property
    def _every(self) -> Selection:
        every = everything()
        return every.without(*(e.name for e in every.effects if isinstance(e.words, CannotHave)))

    @remembered
    def _held(self, lacking: frozenset[str]) -> Values:
        """Exposures (buckets, places) by the words, all drawn alike."""
        self._tried.append(lacking)
        by_choice = by_spilt(lacking) | lacking & self.forced_off
        if by_choice == lacking or not self._beside.any():
            return self._exposed(self._places, lacking)
        found = np.empty((len(self.fields.expected), len(self._places)))
        for some, lost in ((~self._beside, lacking), (self._beside, by_choice)):
            found[:, some] = self._exposed(self._places[some], lost)
        return found

    @cached_property
    def _beside(self) -> NDArray[np.bool_]:
        """Which of them neighbours' light brings near saturation."""
        return among(self._places, self.spilt, len(self.program.lanes))

    def _exposed(self, places: NDArray[np.int64], lacking: frozenset[str]) -> Values:
        wired = self._chip.wired(self._every.without(*lacking))
        found, _ = Running(wired, self.light, places, self.threads).expose(0, 0)
        return found

    def _words_ns(self, lacking: frozenset[str]) -> float:
        """Nanoseconds of a pixel."""
        kept = self._every.without(*self.forced_off, *lacking)
        return self.program.work.words_ns(kept, SHIPPED, "sums")


def by_spilt(lacking: frozenset[str]) -> frozenset[str]:
    """What pixels lack as well that neighbours' light brings near saturation."""
    return lacking - everything().names(Exchange)


def guesses(fields: Fields, running: NDArray[np.bool_], lacking: frozenset[str]) -> Account:
    """What pixels of a sample lack that run through their words without some effects, or any of
    them; nothing where saturation cuts it off."""
    fixed, random = {}, {}
    # Absent where nothing saturates.
    cut = np.abs(fields.fixed.get(BOTH, np.zeros(fields.expected.shape))) > _CUT_E
    for name in sorted(lacking):
        behind = fields.after.get(name)
        runs = running if name in by_spilt(lacking) else running & ~fields.spilt
        if name in fields.fixed:
            kept = np.where(cut, 0.0 if behind is None else behind, fields.fixed[name])
            fixed[name] = runs * kept
        if name in fields.variance:
            here = fields.variance[name]
            random[name] = runs * (np.where(cut, 0.0, here) if behind is None else here)
    return Account(fields.sample, len(fields.expected), fixed, random)
