"""Search for the times and levels of looks with the smallest expected error.

A pixel closes at the first look that finds its light above the look's level. For constant light x
and each of several comparator offsets o, the model follows the fraction S of pixels that are still
open. Look k at time t closes the fraction p = P(x t + o + noise > level) of them. Their light is
then estimated from the exposure of length t, with the error e(x, t). The expected error is the
mean over the scene's light of the sum over k of S p e(x, t)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import islice
from typing import NamedTuple

import numpy as np
from scipy.special import ndtr

from nscc.arrays import Floats, Floats32
from nscc_training.design.chip import CURVES, Curve, DesignChip
from nscc_training.design.scene import Histogram

_OFFSETS = 5
"""Number of comparator offsets in the sum over pixels."""
_MOST_TRIED = 12
"""Most times tried for one look in a round; the next round tries times between them."""
_ROUNDS = 12
"""Most rounds of the search; it ends earlier if a round gains less than 0.01 %."""
_WEIGHINGS = 2
"""Number of searches with weighted scenes, each with the errors of the result before it."""
_MOST_KEPT = 128
"""Most cached tables of closing fractions, each a third of a megabyte."""


class LookSchedule(NamedTuple):
    """When pixels look at their light, and at which level they close.

    `at` are the boundaries between slots at which pixels look, in increasing order: k is the end of
    the k-th slot. `steps`, as long, are the levels of these looks in steps of IN, the value that
    the controller sends to all pixels."""

    at: tuple[int, ...]
    steps: tuple[int, ...]


class Expected(NamedTuple):
    """The expected result of a schedule: `errors`, the mean square error on each curve, and
    `closing`, the fractions of the pixels that close at each look and, as the last, at the end of
    the frame; their sum is 1."""

    errors: dict[Curve, float]
    closing: tuple[float, ...]


class LookModel:
    """Computes the expected error of schedules of looks for a chip, a frame and the light of
    scenes. The module's docstring has the formula."""

    def __init__(self, chip: DesignChip, scene: Histogram, slot_us: Sequence[float]) -> None:
        """Prepare the model. `chip` gives noise and levels, `scene` is the histogram of the scenes'
        light, and `slot_us` are the slot lengths in microseconds, which are above 0."""
        self.chip, self.scene, self._slot_us = chip, scene, slot_us
        ends = np.cumsum([0.0, *slot_us])
        self.share = ends / ends[-1]
        self.slots = len(slot_us)
        deviations, weights = np.polynomial.hermite_e.hermegauss(_OFFSETS)
        self._offset_e = deviations * chip.offset_e
        self._start = scene.weight[:, None] * (weights / weights.sum())
        self._exposure_errors: dict[Curve, Floats] = {}
        self._closed: dict[int, Floats32] = {}

    def exposure_errors(self, curve: Curve) -> Floats:
        """Return the mean square errors, on the scale `curve`, of exposures that end at each
        boundary, (groups, slots + 1): row g for pixels of the histogram's group g of equal light,
        column k for the boundary after k slots.

        Column 0 is infinite, because nothing has been exposed. Results are kept for later calls."""
        if curve not in self._exposure_errors:
            light, peak = self.scene.light_e, self.scene.peak_e
            errors = np.full((len(light), self.slots + 1), np.inf)
            errors[:, 1:] = self.chip.errors(light, peak, self.share[1:], curve)
            self._exposure_errors[curve] = errors
        return self._exposure_errors[curve]

    def closed(self, at: int) -> Floats32:
        """Return the fraction of open pixels that a look at boundary `at` closes: float32 (levels,
        groups, offsets), for each level that is tried, each group of pixels with equal light, and
        each offset of a pixel's comparator.

        Charge counts up to a full well at most. The results for `_MOST_KEPT` boundaries are kept
        for later calls."""
        if at not in self._closed:
            if len(self._closed) == _MOST_KEPT:
                self._closed.clear()
            exposed = np.minimum(self.scene.light_e * self.share[at], self.chip.sensor.full_well_e)
            level = self.chip.levels * self.chip.target.electrons_per_step
            above = exposed[:, None] + self._offset_e - level[:, None, None]
            closing_share = ndtr(above / self.chip.compared_sd_e(exposed)[:, None])
            self._closed[at] = closing_share.astype(np.float32)
        return self._closed[at]

    def expected(self, schedule: LookSchedule) -> Expected:
        """Return the expected error of a schedule on each curve, and the fractions of the pixels
        that close at each look and at the end. The nearest level that the chip has replaces each
        level of the schedule."""
        closing = []
        errors = dict.fromkeys(CURVES, 0.0)
        for at, pixels in self._closing(schedule.at, self._rows(schedule)):
            closing.append(float(pixels.sum()))
            for curve in CURVES:
                errors[curve] += float(pixels.sum(axis=1) @ self.exposure_errors(curve)[:, at])
        return Expected(errors, tuple(closing))

    def _closing(self, at: Sequence[int], rows: Sequence[int]) -> Iterator[tuple[int, Floats]]:
        """Yield the boundary of each look and the weights (groups, offsets) of the pixels that it
        closes; last, the frame's end with the pixels that stay open. The sum of all weights is 1.

        `at` are the boundaries of the looks, in increasing order. `rows`, as long, are the indices
        of their levels among the levels that the chip has."""
        open_ = self._start
        for moment, row in zip(at, rows, strict=True):
            closing_pixels = open_ * self.closed(moment)[row]
            yield moment, closing_pixels
            open_ = open_ - closing_pixels
        yield self.slots, open_

    def best(self, looks: int, curve: Curve) -> LookSchedule:
        """Return the schedule of `looks` looks with the smallest expected error, on the scale
        `curve`, that a local search finds. `looks` is at least 1 and smaller than the number of
        slots.

        The search begins with several geometric schedules. It moves one look after the other and
        gives it the best level, with the other looks fixed, until no move reduces the error. The
        best result is returned; the same input gives the same schedule. With several scenes and
        another curve than "log", the search is repeated with each scene's error divided by its
        error in the result before, so that no scene dominates."""
        worth, schedule = min(
            (self._descended(start, curve) for start in self._starts(looks)),
            key=lambda outcome: outcome[0],
        )
        scenes = int(self.scene.scene.max()) + 1
        if scenes == 1 or curve == "log":
            return schedule
        for _ in range(_WEIGHINGS):
            rows = self._rows(schedule)
            after = self._after(list(schedule.at), rows, -1, curve)
            group_errors = (self._start * after).sum(axis=1)
            scene_errors, weights = (
                np.bincount(self.scene.scene, values)
                for values in (group_errors, self.scene.weight)
            )
            # The limit is for scenes without error, whose weight would be infinite.
            by = 1 / np.maximum(scene_errors / weights, 1e-12 * worth)
            weighed = LookModel(self.chip, self.scene.weighed(by), self._slot_us)
            weighed._exposure_errors, weighed._closed = self._exposure_errors, self._closed
            _, schedule = weighed._descended(schedule, curve)
        return schedule

    def _descended(self, schedule: LookSchedule, curve: Curve) -> tuple[float, LookSchedule]:
        """Improve a schedule in rounds until its error, on the scale `curve`, falls by less than
        0.01 %, for `_ROUNDS` rounds at most. Return the expected error and the schedule."""
        worth = np.inf
        for _ in range(_ROUNDS):
            schedule, now = self._round(schedule, curve)
            # A round that improves the error by less than 0.01 % is the last.
            if now >= worth * (1 - 1e-4):
                break
            worth = now
        return worth, schedule

    def _rows(self, schedule: LookSchedule) -> list[int]:
        """Return the indices, among the levels that are tried, of the levels nearest to a
        schedule's; of two that are equally near, the first."""
        return [int(np.abs(self.chip.levels - steps).argmin()) for steps in schedule.steps]

    def _starts(self, looks: int) -> list[LookSchedule]:
        """Return initial schedules of `looks` looks: geometric boundaries from several first ones,
        with equal levels.

        First boundaries are 1, 4, 16 and so on, up to a quarter of the frame; the later ones grow
        by equal ratios towards its end. The level lets the exposure at the next look nearly fill
        the well."""
        starts: dict[tuple[int, ...], LookSchedule] = {}
        first = 1
        while first == 1 or first * 4 <= self.slots:
            ratio = (self.slots / first) ** (1 / looks)
            boundaries = _spread(first * ratio ** np.arange(looks), self.slots)
            full = self.chip.full_e / self.chip.target.electrons_per_step
            level = int(np.clip(round(0.9 * full / max(ratio, 2.0)), 1, self.chip.levels[-1]))
            starts.setdefault(boundaries, LookSchedule(boundaries, (level,) * looks))
            first *= 4
        return list(starts.values())

    def _round(self, schedule: LookSchedule, curve: Curve) -> tuple[LookSchedule, float]:
        """Replace the boundary and the level of each look in turn, the last first, by those with
        the smallest error while the other looks stay. Return the new schedule and its expected
        error, on the scale `curve`."""
        boundaries, rows = list(schedule.at), self._rows(schedule)
        worth = np.inf
        for k in reversed(range(len(boundaries))):
            open_ = self._start
            for before in range(k):
                open_ = open_ * (1 - self.closed(boundaries[before])[rows[before]])
            after = self._after(boundaries, rows, k, curve)
            open_error = float((open_ * after).sum())
            # The pixels that earlier looks close keep their error: `islice` leaves out look k and
            # later ones.
            earlier = sum(
                float(pixels.sum(axis=1) @ self.exposure_errors(curve)[:, moment])
                for moment, pixels in islice(self._closing(boundaries, rows), k)
            )
            best = (np.inf, boundaries[k], rows[k])
            for moment in self._moments(boundaries, k):
                gained = open_ * (self.exposure_errors(curve)[:, moment, None] - after)
                costs = self.closed(moment).reshape(len(self.chip.levels), -1) @ gained.reshape(-1)
                row = int(costs.argmin())
                best = min(best, (open_error + float(costs[row]), moment, row))
            worth, boundaries[k], rows[k] = best[0] + earlier, best[1], best[2]
        steps = tuple(int(self.chip.levels[row]) for row in rows)
        return LookSchedule(tuple(boundaries), steps), worth

    def _after(self, at: list[int], rows: list[int], k: int, curve: Curve) -> Floats:
        """Return the expected error (groups, offsets), on the scale `curve`, of a pixel that is
        still open after look number `k`; -1 means before the first look.

        `at` has the boundaries of the looks and `rows` the indices of their levels: row rows[j] of
        `closed(at[j])` is the fraction of the pixels that look j closes."""
        exposure_errors = self.exposure_errors(curve)
        error = np.repeat(exposure_errors[:, -1:], _OFFSETS, axis=1)
        for number in range(len(at) - 1, k, -1):
            closed = self.closed(at[number])[rows[number]]
            error = closed * exposure_errors[:, at[number], None] + (1 - closed) * error
        return error

    def _moments(self, at: list[int], k: int) -> list[int]:
        """Return the boundaries to try for look number `k`, in increasing order, between those of
        its neighbours: all if they are at most `_MOST_TRIED`, else a geometric selection with the
        present boundary and the two next to it. `at` are the present boundaries of all looks."""
        low = at[k - 1] + 1 if k else 1
        high = at[k + 1] - 1 if k + 1 < len(at) else self.slots - 1
        if high - low < _MOST_TRIED:
            return list(range(low, high + 1))
        # Three of the tries are the present boundary and its neighbours.
        moments = np.geomspace(low, high, _MOST_TRIED - 3).round().astype(int).tolist()
        return sorted({*moments, *(m for m in range(at[k] - 1, at[k] + 2) if low <= m <= high)})


def _spread(moments: Floats, slots: int) -> tuple[int, ...]:
    """Return different whole boundaries from 1 to `slots` - 1, increasing, one for each of the
    increasing numbers `moments` and close to it. The caller ensures fewer moments than slots. Each
    boundary leaves room for the later ones."""
    count, spread_moments = len(moments), [0]
    for k, moment in enumerate(moments.round().astype(int).tolist()):
        spread_moments.append(min(max(moment, spread_moments[-1] + 1), slots - count + k))
    return tuple(spread_moments[1:])
