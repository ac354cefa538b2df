"""What a plan is made of: decisions on effects, short cuts, and what it all takes."""

from __future__ import annotations

from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Literal

Choice = Literal["kept", "dropped", "absent"]
Loop = Literal["none", "some", "all", "reference"]
"""Which pixels run through their words one by one; "reference": it simulates all."""

MOST_OTHER_STATES = 0.005
"""Of the pixels of a program that looks, the part that may end in other states than with all
effects."""

LATER = MappingProxyType({"later": True})
"""Of what files of plans did not have at first: one without it is a plan, too."""


@dataclass(frozen=True)
class Decision:
    """What becomes of one effect.

    `predicted_rms_e` and `predicted_bias_e`: what the effect does to the exposure, its root mean
    square over pixels and buckets, and its mean. `predicted_if_dropped_e`: the error of the plan
    if this effect were left out as well. None where that was not measured.
    `forced`: the user decided. `cost_ms_model`: what leaving it out saves, by a model of costs.
    `other_states`: of a program that looks, the part of the pixels that the effect takes to other
    states; errors are those of the other pixels.
    """

    name: str
    kind: str
    decision: Choice
    forced: bool
    reason: str
    predicted_rms_e: float | None
    predicted_bias_e: float | None
    predicted_if_dropped_e: float | None
    cost_ms_model: float
    other_states: float | None = None


@dataclass(frozen=True)
class Approximation:
    """An approximation of sums, and the root mean square error that it was measured to make; None
    where that was not measured."""

    name: str
    error_e: float | None


_LITTLE = 0.005
"""A part that is nothing in whole percents."""


@dataclass(frozen=True)
class Cost:
    """What a frame takes, planning included: milliseconds of one core by the prices that plans are
    chosen by. `saturating_ms`: the words of pixels near saturation; `all_ms`: the same frame with
    every effect, `all_planning_ms` of it for its plan, None where a plan's file does not say.
    """

    total_ms: float
    saturating_ms: float
    planning_ms: float
    all_ms: float
    all_planning_ms: float | None = field(default=None, metadata=LATER)

    def rows(self, effects_ms: float, lack: tuple[str, ...]) -> list[tuple[str, str, float]]:
        """What is not an effect's own: its name, what it is, and milliseconds; with `effects_ms`
        for the effects that are kept, the total. These may be more than it where all pixels run
        through their words: leaving out any of several effects saves the same counts. `lack`: what
        pixels near saturation do without."""
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
        """What it saves of all, in words."""
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
