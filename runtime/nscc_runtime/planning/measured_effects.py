"""Step 2 of planning: measure what leaving out each effect changes.

Every effect is left out alone, on the same pixels with the same draws. The mean products of these
differences say what leaving out any set of effects changes, as far as effects add up: the mean
square of a sum is the sum of all products.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects import registered
from nscc_runtime.planning.differences import Difference, Errors
from nscc_runtime.planning.trial import Names, Trial

Values = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class MeasuredEffects:
    """What leaving out effects changes on a scene.

    Attributes
    ----------
    alone : dict of Difference
        Of each measured effect, left out alone.
    products_e2 : float64, shape (outputs, 1 + effects, 1 + effects)
        Mean products of these differences over the scene; the first row and column are of what the
        user forced off.
    approximations : Difference or None
        How far exposures with every effect are from the truth; None where that is nothing, or was
        not measured.
    near_saturation : bool
        Whether effects were measured near saturation, too.
    forced : Difference
        What the user forced off changes.
    """

    alone: dict[str, Difference]
    products_e2: Values
    approximations: Difference | None
    near_saturation: bool
    forced: Difference

    @property
    def approximations_e(self) -> float:
        """Their root mean square."""
        return 0.0 if self.approximations is None else self.approximations.rms_e

    def index(self, name: str) -> int:
        """The row of an effect."""
        return 1 + [*self.alone].index(name)

    def squares_e2(self, names: Names) -> Values:
        """The mean square (outputs,) of leaving out some of the measured effects."""
        rows = [0, *(self.index(name) for name in self.alone if name in names)]
        return np.asarray(self.products_e2[:, rows][:, :, rows].sum(axis=(1, 2)))


def measure_effects(
    trial: Trial, effects: Names, *, approximations: bool = True, near_saturation: bool = False
) -> MeasuredEffects:
    """Measure some effects of a scene; those that are absent for sure are not. `near_saturation`:
    also what pixels near saturation lose that lack an effect, where that saves time."""
    errors: dict[str, Errors] = {}
    for effect in registered():
        if effect.name in effects and effect.name not in trial.absent and effect.kind != "after":
            errors[effect.name] = trial.alone(effect, near_saturation)
    forced = trial.forced()
    fields = np.stack([forced.size_e, *(effect_errors.size_e for effect_errors in errors.values())])
    return MeasuredEffects(
        {name: Difference(effect_errors, trial.sample) for name, effect_errors in errors.items()},
        _products(fields, trial.sample.weight),
        trial.approximated() if approximations else None,
        near_saturation,
        Difference(forced, trial.sample),
    )


def _products(fields: Values, weight: Values) -> Values:
    """Mean products (outputs, fields, fields) of fields (fields, outputs, pixels)."""
    weighed = fields * (weight / max(float(weight.sum()), 1e-300))
    # Not by a library for matrices: its sums may differ from machine to machine.
    return np.array(
        [(fields[:, None, b] * weighed[None, :, b]).sum(axis=2) for b in range(fields.shape[1])]
    )
