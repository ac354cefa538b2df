"""Steps 3 and 4 of planning: choose the sets of effects that save most time, and measure them."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.planning.differences import Difference
from nscc_runtime.planning.measured_effects import MeasuredEffects
from nscc_runtime.planning.tail import Worst
from nscc_runtime.planning.tolerance import Tolerance
from nscc_runtime.planning.trial import NONE, Move, Names, Setting, Trial

Values = NDArray[np.float64]

MARGIN = 0.9
"""Effects are dropped only while the measured error is at most this fraction of the tolerance."""
_SURE = 0.97
"""Effects are dropped only while the measured error plus two standard errors is at most this
fraction of the tolerance."""
_MOST_MOVES = 10
"""All subsets of this number of moves, those that save most time, are compared."""
_TRIED, _FEW = 8, 2
"""Largest number of sets to measure: `_TRIED` with measurements near saturation, `_FEW` without."""


@dataclass(frozen=True)
class Limits:
    """Upper limits for the errors of a plan.

    `square_e2`: mean square error in square electrons. `sure_e2`: mean square error plus two
    standard errors. `other_states`: fraction of pixels in other states. `max_e`: largest error of a
    pixel, in electrons; infinite without a `--tolerance-max`."""

    square_e2: float
    sure_e2: float
    other_states: float
    max_e: float

    @classmethod
    def of(
        cls,
        allowed: Tolerance,
        most: Tolerance | None,
        other_states: float,
        measured: MeasuredEffects,
    ) -> Limits:
        """Compute the limits from the tolerances (`most`: of the largest error, or None) and the
        largest fraction of pixels in other states.

        Errors of effects that the user forced off are added to the limits: the effects that the
        planner drops have to keep the tolerance by themselves."""
        forced, tolerance_e = measured.forced, allowed.electrons
        square_e2, sure_e2 = (MARGIN * tolerance_e) ** 2, (_SURE * tolerance_e) ** 2
        if forced.likely_e2(0.0) > square_e2:
            square_e2, sure_e2 = square_e2 + forced.likely_e2(0.0), sure_e2 + forced.likely_e2(2.0)
        sure_e2 = max(sure_e2, forced.likely_e2(2.0))
        if forced.other_states > other_states:
            other_states += forced.other_states
        max_e = math.inf if most is None else max(MARGIN * most.electrons, forced.worst.max_e)
        return cls(square_e2, sure_e2, other_states, max_e)

    def allow(self, together: Together) -> bool:
        """Return whether all measured errors of a setting are within the limits."""
        return (
            together.square_e2 <= self.square_e2
            and together.likely_e2(2.0) <= self.sure_e2
            and together.difference.other_states <= self.other_states
            and together.worst.max_e <= self.max_e
        )


@dataclass(frozen=True)
class Together:
    """The measured errors of a setting.

    `difference`: error relative to the simulation with all effects. `approximations`: independent
    error of the approximations of sums, or None. `unseen_e2`: allowance for rare pixels that the
    sample does not contain, in square electrons."""

    setting: Setting
    difference: Difference
    approximations: Difference | None
    unseen_e2: float

    @property
    def square_e2(self) -> float:
        """The mean square error of the worst output, in square electrons."""
        return self.likely_e2(0.0)

    def likely_e2(self, errors: float) -> float:
        """Return the worst output's mean square error plus `errors` times its standard error."""
        differences = [self.difference, *filter(None, [self.approximations])]
        return sum(difference.likely_e2(errors) for difference in differences) + self.unseen_e2

    @property
    def worst(self) -> Worst:
        """The 99.9 % quantile and the maximum of the error, including approximations of sums."""
        if self.approximations is None:
            return self.difference.worst
        measured, approximated = self.difference.worst, self.approximations.worst
        return Worst(
            math.hypot(measured.p999_e, approximated.p999_e),
            math.hypot(measured.max_e, approximated.max_e),
        )


def choose_cheapest(
    trial: Trial, measured: MeasuredEffects, moves: Sequence[Move], limits: Limits
) -> list[Names]:
    """Return the sets of effects that save most time and whose added-up errors are within `limits`.

    The result is sorted by saved time, largest first. It contains at most `_TRIED` sets, or `_FEW`
    without measurements near saturation; it is empty if no set fits."""
    fitting = [move for move in moves if _alone_e2(trial, measured, move) <= limits.square_e2]
    fitting = sorted(fitting, key=lambda move: -move.saved_ns)[:_MOST_MOVES]
    squares, unsure, saved_ns, other_states = _sums_of_subsets(trial, measured, fitting)
    approximations = measured.approximations
    square_e2, sure_e2 = (
        0.0 if approximations is None else approximations.likely_e2(errors) for errors in (0.0, 2.0)
    )
    fits = (squares.max(axis=0) <= limits.square_e2 - square_e2) & (
        other_states <= limits.other_states
    )
    sure = fits & ((squares + 2.0 * unsure).max(axis=0) <= limits.sure_e2 - sure_e2)
    fits[0] = sure[0] = False
    order, most = np.argsort(-saved_ns, kind="stable"), _TRIED if measured.near_saturation else _FEW
    # The sum of standard errors of single effects exceeds the standard error of the set.
    first = order[fits[order]][: most // 2].tolist()
    best = [*dict.fromkeys(first + order[sure[order]].tolist())][:most]
    return [
        frozenset().union(*(move.names for bit, move in enumerate(fitting) if subset >> bit & 1))
        for subset in best
    ]


def _alone_e2(trial: Trial, measured: MeasuredEffects, move: Move) -> float:
    """Return the mean square error of a single move; infinite if it was not measured."""
    if move.field is None:
        return trial.square_e2(move.names)
    alone = measured.alone.get(move.field)
    return math.inf if alone is None else alone.rms_e**2


def _sums_of_subsets(
    trial: Trial, measured: MeasuredEffects, moves: Sequence[Move]
) -> tuple[Values, Values, Values, Values]:
    """Return errors and savings of every subset of the moves; bit i of the subset number stands for
    move i.

    Returns the mean square error and the sum of its standard errors, both of shape (outputs,
    subsets), then the saved nanoseconds and the fraction of pixels in other states, both of shape
    (subsets,)."""
    products = measured.products_e2
    squares, cross = products[:, :1, 0], products[:, :1, :]
    unsure, saved_ns, other_states = np.zeros((len(products), 1)), np.zeros(1), np.zeros(1)
    for move in moves:
        errors: Values | float = 0.0
        added_e2, row, changed = np.zeros((len(products), 1)), np.zeros((len(products), 1, 1)), 0.0
        if move.field is None:
            added_e2 += trial.square_e2(move.names)
        else:
            index = measured.index(move.field)
            added_e2 = 2.0 * cross[:, :, index] + products[:, index, index, None]
            row = products[:, index, None, :]
            alone = measured.alone[move.field]
            errors, changed = alone.unsure_e2[:, None], alone.other_states
        if measured.near_saturation:
            added_e2 = added_e2 + trial.unseen_e2(trial.settings(move.names)[0])
        squares = np.concatenate([squares, squares + added_e2], axis=1)
        cross = np.concatenate([cross, cross + row], axis=1)
        unsure = np.concatenate([unsure, unsure + errors], axis=1)
        saved_ns = np.concatenate([saved_ns, saved_ns + move.saved_ns])
        other_states = np.concatenate([other_states, other_states + changed])
    return squares, unsure, saved_ns, other_states


def measure_together(
    trial: Trial, measured: MeasuredEffects, candidates: Iterable[Names], limits: Limits
) -> Together:
    """Measure each candidate set with all its effects dropped at once. Return the first result
    within the limits, or else the result of dropping no effect."""
    # A sample of the pixels near saturation says little about the worst of these pixels.
    full_setting = Setting(NONE, exact=not math.isinf(limits.max_e))
    every_ns, _ = trial.frame_ns(full_setting)
    for dropped in candidates:
        exact = [Setting(dropped, exact=True)]
        for setting in exact if full_setting.exact else trial.settings(dropped):
            if trial.frame_ns(setting)[0] >= every_ns:
                continue
            measured_setting = tried_together(trial, setting, measured.approximations)
            if limits.allow(measured_setting):
                return measured_setting
    return tried_together(trial, full_setting, measured.approximations)


def tried_together(trial: Trial, setting: Setting, approximations: Difference | None) -> Together:
    """Measure the errors of one setting; `approximations` is the error of sums, or None."""
    difference = Difference(trial.together(setting), trial.sample)
    return Together(setting, difference, approximations, trial.unseen_e2(setting))
