"""Step 2 of planning: measure the error of dropping each effect.

Each effect is dropped alone, on the same pixels with the same random numbers. If errors add up, the
mean square error of dropping a set of effects is the sum of the mean products of their single
errors."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects import registered
from nscc_runtime.planning.differences import Difference, ExposureErrors
from nscc_runtime.planning.trial import Names, Trial

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
