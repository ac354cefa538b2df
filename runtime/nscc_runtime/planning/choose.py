"""Steps 2 to 4 of planning: measure the error of dropping each effect, choose the sets of effects
that save most time, and measure them.

Each effect is dropped alone, on the same pixels with the same random numbers. If errors add up, the
mean square error of dropping a set of effects is the sum of the mean products of their single
errors."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects import registered
from nscc_runtime.planning.differences import Difference, ExposureErrors, Worst
from nscc_runtime.planning.planned_scene import NONE, Move, Names, Setting, Trial
from nscc_runtime.planning.tolerance import Tolerance

Values = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class MeasuredEffects:
    """The measured errors of dropping effects on a scene.

    Attributes
    ----------
    alone : dict of str to Difference
        The error of dropping each measured effect alone, by the name of the effect.
    products_e2 : float64, shape (outputs, 1 + effects, 1 + effects)
        Mean products of these errors over the scene, in square electrons. Row and column 0 belong
        to the effects that the user forced off.
    approximations : Difference or None
        The error of the approximations of sums with every effect; None if it is 0 or was not
        measured.
    near_saturation : bool
        Whether effects were also measured on pixels near saturation.
    forced : Difference
        The error of the effects that the user forced off.
    """

    alone: dict[str, Difference]
    products_e2: Values
    approximations: Difference | None
    near_saturation: bool
    forced: Difference

    @property
    def approximations_e(self) -> float:
        """RMS error of the approximations of sums in electrons; 0 if it was not measured."""
        return 0.0 if self.approximations is None else self.approximations.rms_e

    def index(self, name: str) -> int:
        """Return the row of the measured effect `name` in `products_e2`."""
        return 1 + [*self.alone].index(name)

    def squares_e2(self, names: Names) -> Values:
        """Return the mean square error (outputs,) of dropping the measured effects in `names`
        together with the effects that the user forced off."""
        rows = [0, *(self.index(name) for name in self.alone if name in names)]
        return np.asarray(self.products_e2[:, rows][:, :, rows].sum(axis=(1, 2)))


def measure_effects(
    trial: Trial, effects: Names, *, approximations: bool = True, near_saturation: bool = False
) -> MeasuredEffects:
    """Measure the error of dropping each of the `effects` that is not absent on the scene.

    `approximations`: also measure the error of sums. `near_saturation`: also measure on pixels near
    saturation, if dropping the effect there saves time."""
    errors: dict[str, ExposureErrors] = {}
    for effect in registered():
        if effect.name in effects and effect.name not in trial.absent and effect.kind != "after":
            errors[effect.name] = trial.alone(effect, near_saturation)
    forced = trial.forced()
    fields = np.stack([forced.size_e, *(effect_errors.size_e for effect_errors in errors.values())])
    weighed = fields * (trial.sample.weight / max(float(trial.sample.weight.sum()), 1e-300))
    # Sums of matrix libraries may differ between machines, so none is used.
    products_e2 = [
        (fields[:, None, b] * weighed[None, :, b]).sum(axis=2) for b in range(fields.shape[1])
    ]
    return MeasuredEffects(
        {name: Difference(effect_errors, trial.sample) for name, effect_errors in errors.items()},
        np.array(products_e2),
        trial.approximated() if approximations else None,
        near_saturation,
        Difference(forced, trial.sample),
    )


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
