"""The request for a plan."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from nscc_runtime.effects import Effect, Selection, everything, registered
from nscc_runtime.planning.tolerance import DEFAULT, ToleranceInput

Names = frozenset[str]

MANY = 1000
"""Default number of frames that share a plan."""


def effects_of_exposure() -> list[Effect]:
    """Return the effects that act before the readout, in the order of registration; only on these a
    plan decides."""
    return [effect for effect in registered() if effect.kind != "after"]


@dataclass(frozen=True)
class PlanRequest:
    """The request for a plan.

    `effects`: the requested effects. `tolerance`: the largest RMS error. `frames`: number of frames
    that share the plan; it decides whether measuring saves time. `figures`: measure every figure of
    the table, even if that saves no time."""

    effects: Selection
    tolerance: ToleranceInput = DEFAULT
    frames: int = MANY
    figures: bool = False

    @cached_property
    def forced(self) -> Names:
        """Names of the effects that the user switched on or off, on which a plan does not decide;
        all effects unless the selection is automatic."""
        effects = self.effects
        return frozenset(
            e.name for e in registered() if not effects.auto or e.name in effects.forced
        )

    @cached_property
    def forced_off(self) -> Names:
        """Names of the effects of the exposure that the user switched off."""
        return frozenset(
            e.name for e in effects_of_exposure() if e.name in self.forced and e not in self.effects
        )

    @property
    def requested(self) -> Selection:
        """Every effect except those of the exposure that the user switched off."""
        return everything().without(*self.forced_off)
