"""The records of a plan: decisions on effects, approximations, and the time of a frame."""

from __future__ import annotations

from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Literal

Choice = Literal["kept", "dropped", "absent"]
Loop = Literal["none", "some", "all", "reference"]
"""Which pixels run through their words one by one; "reference": the reference simulates all."""

MOST_OTHER_STATES = 0.005
"""Largest fraction of pixels that may end in other states than with all effects."""

LATER = MappingProxyType({"later": True})
"""Field metadata: older plan files may lack the field."""


@dataclass(frozen=True)
class Decision:
    """The decision on one effect.

    `kind`: when the effect acts. `decision`: whether it is simulated. `forced`: whether the user
    decided. `predicted_rms_e`, `predicted_bias_e`: root mean square and mean, over pixels and
    buckets, of the change of exposures by the effect, in electrons. `predicted_if_dropped_e`: RMS
    error of the plan without this effect. `cost_ms_model`: milliseconds per frame saved by dropping
    it, from the shipped prices. `other_states`: fraction of pixels that end in other states because
    of the effect, for programs that look. Figures that were not measured are None."""

    name: str
    kind: str
    decision: Choice
    forced: bool
    reason: str
    predicted_rms_e: float | None = None
    predicted_bias_e: float | None = None
    predicted_if_dropped_e: float | None = None
    cost_ms_model: float = 0.0
    other_states: float | None = None


@dataclass(frozen=True)
class Approximation:
    """An approximation of sums, by name, and its RMS error in electrons (None: not measured)."""

    name: str
    error_e: float | None


_LITTLE = 0.005
"""A smaller fraction is shown as 0 %."""


@dataclass(frozen=True)
class Cost:
    """The predicted time of a frame including planning, in milliseconds of one core, from the
    shipped prices.

    `saturating_ms`: part of `total_ms` for running the words of pixels near saturation. `all_ms`:
    time of the same frame with every effect, including `all_planning_ms` of planning (None in older
    plan files)."""

    total_ms: float
    saturating_ms: float
    planning_ms: float
    all_ms: float
    all_planning_ms: float | None = field(default=None, metadata=LATER)

    def rows(self, effects_ms: float, lack: tuple[str, ...]) -> list[tuple[str, str, float]]:
        """Return the times that belong to no single effect, as (name, description, milliseconds).

        Together with `effects_ms`, the time of the kept effects, they add up to the total. The
        remainder may be negative if all pixels run through their words, because several effects
        share photon counts. `lack`: effects that are not simulated for pixels near saturation."""
        rest_ms = self.total_ms - effects_ms - self.saturating_ms - self.planning_ms
        words = "their words one by one" + (f", without {', '.join(lack)}" if lack else "")
        saturating_rows = (
            [("(saturating)", words, self.saturating_ms)] if self.saturating_ms > 0 else []
        )
        description = "light, words and readout"
        if rest_ms < 0:
            description += ", less what each of several effects would save"
        planning = "(planning)", "once for all frames of a scene", self.planning_ms
        return [*saturating_rows, planning, ("(the rest)", description, rest_ms)]

    @property
    def summary(self) -> str:
        """A sentence that compares the times of the plan and of simulating every effect."""
        text = _saved(self.total_ms, self.all_ms)
        if self.all_planning_ms is not None:
            next_ms, all_ms = self.total_ms - self.planning_ms, self.all_ms - self.all_planning_ms
            text += f"; next frames: {_saved(next_ms, all_ms)}"
        return f"{text}, by shipped prices"


def _saved(some_ms: float, all_ms: float) -> str:
    saved_fraction = 1.0 - some_ms / all_ms if all_ms > 0 else 0.0
    text = f"saves {abs(saved_fraction):.0%} of all"
    if saved_fraction < -_LITTLE:
        text = f"takes {-saved_fraction:.0%} more than all"
    return f"{text}: {some_ms:.2f} ms of a core instead of {all_ms:.2f}"
