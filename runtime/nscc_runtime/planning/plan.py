"""The request for a plan, and the plan of a run: the effects that are simulated, and the measured
errors."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Annotated, Literal

from nscc import html
from nscc.codec import KeyName, Within, to_plain
from nscc.columns import columns
from nscc.mappings import JsonObject
from nscc_runtime.effects import Effect, Selection, everything, registered
from nscc_runtime.effects.effect import MOST_E
from nscc_runtime.effects.selection import selection_of
from nscc_runtime.planning.tolerance import DEFAULT, LEAST_E, Tolerance, ToleranceInput

Choice = Literal["kept", "dropped", "absent"]

MOST_OTHER_STATES = 0.005
"""Largest fraction of pixels that may end in other states than with all effects."""


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

    @property
    def forced(self) -> Names:
        """Names of the effects that the user switched on or off, on which a plan does not decide;
        all effects unless the selection is automatic."""
        return self.effects.forced if self.effects.auto else everything().on

    @cached_property
    def forced_off(self) -> Names:
        """Names of the effects of the exposure that the user switched off."""
        return frozenset(e.name for e in effects_of_exposure() if e not in self.effects)

    @property
    def requested(self) -> Selection:
        """Every effect except those of the exposure that the user switched off."""
        return everything().without(*self.forced_off)


@dataclass(frozen=True)
class Decision:
    """The decision on one effect.

    `kind`: when the effect acts. `decision`: "kept", "dropped", or "absent" if the effect changes
    nothing on this scene; absent effects stay on. `forced`: whether the user decided.
    `predicted_rms_e`, `predicted_bias_e`: root mean square and mean, over pixels, of the change of
    exposures by the effect in the worst bucket, in electrons. `predicted_if_dropped_e`: RMS error
    with which dropping it was tried, together with others. `cost_ms_model`: milliseconds per frame
    saved by dropping it, from the shipped prices. `other_states`: fraction of pixels that end in
    other states because of the effect, for programs that look. Figures that were not measured are
    None."""

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


@dataclass(frozen=True, repr=False)
class Plan:
    """The plan of a run.

    Errors are root mean squares over pixels, in the worst bucket, of the difference between
    simulations with the kept effects and with every effect, with the same random numbers, in
    electrons before the ADC. Figures that were not measured are None. Converting a plan to text
    returns the table that `nscc run --verbose` prints.

    Attributes
    ----------
    tolerance : str
        The requested tolerance as text.
    tolerance_e : float or None
        The tolerance in electrons; None if it is a fraction of a noise that was not measured.
    slot_loop : bool
        Whether pixels run through their words one by one.
    slot_loop_reasons : tuple of str
        Why pixels run through their words, or why the reference simulates them.
    total_ms, all_ms : float
        Predicted times of a frame under the plan and with every effect, in milliseconds of one
        core, from the shipped prices.
    decisions : tuple of Decision
        The decision on each effect.
    sampled_fraction : float
        The fraction of the pixels that was measured.
    predicted_e, bound_e : float or None
        The error measured on a sample of the scene, and this error plus three standard errors.
    worst_e : float or None
        The largest error of a pixel of the sample.
    other_states : float or None
        For a program that looks, the fraction of pixels that end in other states than with every
        effect. Errors are those of the other pixels.
    reused : bool
        Whether the plan was made for an earlier scene. Its error was measured on this scene, unless
        it drops nothing.
    """

    tolerance: str
    tolerance_e: Annotated[float, Within(LEAST_E, MOST_E)] | None
    slot_loop: bool
    slot_loop_reasons: tuple[str, ...]
    total_ms: float
    all_ms: float
    decisions: Annotated[tuple[Decision, ...], KeyName("effects")]
    sampled_fraction: float = 0.0
    predicted_e: float | None = None
    bound_e: float | None = None
    worst_e: float | None = None
    other_states: float | None = None
    reused: bool = False

    def names(self, choice: Choice) -> list[str]:
        """Return the names of the effects with this decision.

        Parameters
        ----------
        choice : {"kept", "dropped", "absent"}
            The decision, see `Decision`.

        Returns
        -------
        list of str
            In the order of the plan; empty if there is none.
        """
        return [decision.name for decision in self.decisions if decision.decision == choice]

    @cached_property
    def kept(self) -> Selection:
        """The effects that are simulated: all but the dropped ones; those that change nothing here
        ("absent") are on, too."""
        forced = frozenset(decision.name for decision in self.decisions if decision.forced)
        return selection_of(everything().on.difference(self.names("dropped")), forced)

    @property
    def requested_effects(self) -> Selection:
        """All effects except those that the user turned off, as a selection of which a planner
        decides the rest."""
        forced = self.kept.forced
        return Selection(everything().on - forced.intersection(self.names("dropped")), forced, True)

    @property
    def allowed(self) -> str:
        """The tolerance as text, with its electrons on the scene that the plan (the effects that
        are simulated) was made for unless they were not measured."""
        if self.tolerance_e is None:
            return self.tolerance
        return str(Tolerance(self.tolerance, self.tolerance_e))

    @property
    def breach(self) -> str | None:
        """A text that lists the predicted errors above their limits, in electrons and of states,
        separated by semicolons; None if there are none or nothing was measured."""
        broken_parts = []
        if self.predicted_e is not None and self.predicted_e > (self.tolerance_e or 0.0):
            broken_parts.append(
                f"the predicted error is {self.predicted_e:.3g} e, "
                f"the tolerance {self.tolerance_e:.4g} e"
            )
        if self.other_states is not None and self.other_states > MOST_OTHER_STATES:
            broken_parts.append(
                f"{self.other_states:.2%} of the pixels are predicted to end in other states, "
                f"{MOST_OTHER_STATES:.1%} may"
            )
        return "; ".join(broken_parts) or None

    def __repr__(self) -> str:
        """Return the plan (the effects that are simulated) as one line."""
        return f"<nscc plan: {self.line}>"

    def __str__(self) -> str:
        """Return the plan (the effects that are simulated) as a table with a row for each effect,
        then the errors, why words run one by one, and the times. Figures that were not measured are
        empty."""
        looks = self.other_states is not None
        head = ("effect", "rms e", "bias e", "choice", "why", "saves ms", "other states")
        rows: list[tuple[str, ...]] = [head]
        for each in self.decisions:
            row = (
                each.name,
                _shown(each.predicted_rms_e, ".3g"),
                _shown(each.predicted_bias_e or None, "+.3g"),
                each.decision + (", forced" if each.forced else ""),
                each.reason,
                _shown(each.cost_ms_model or None, ".2f"),
                _shown(each.other_states or None, ".2%"),
            )
            rows.append(row)
        lines = [columns([row if looks else row[:-1] for row in rows], left_aligned=(0, 3, 4))]
        if self.predicted_e is None:
            lines.append(f"no error was measured; tolerance {self.allowed}")
        else:
            lines.append(
                f"predicted error {self.predicted_e:.3g} e (at most {self.bound_e or 0.0:.3g}), "
                f"tolerance {self.allowed}, worst pixel {self.worst_e or 0.0:.3g} e, measured on "
                f"{self.sampled_fraction:.1%} of the pixels"
            )
        if looks:
            lines.append(
                f"predicted to end in other states: {self.other_states:.2%} of the pixels, at most "
                f"{MOST_OTHER_STATES:.1%}"
            )
        reasons = "; ".join(self.slot_loop_reasons) if self.slot_loop else "of no pixel"
        lines += [f"words run one by one: {reasons}", self.time_summary]
        return "\n".join([*lines, *["made for an earlier scene"] * self.reused])

    def _repr_html_(self) -> str:
        """Return the card that a notebook shows."""
        return html.card("plan", self._error, html.plain(str(self)))

    @property
    def line(self) -> str:
        """The plan in one line: the effects that are simulated, and the predicted error."""
        kept_names, dropped_names = self.names("kept"), self.names("dropped")
        if not dropped_names:
            return f"every effect simulated: {len(kept_names)} that this run can have"
        listed = f"without {', '.join(dropped_names)}"
        if len(kept_names) < len(dropped_names):
            listed = ", ".join(kept_names)
        count = len(kept_names) + len(dropped_names)
        return f"{self._error}; {len(kept_names)} of {count} effects simulated: {listed}"

    @property
    def _error(self) -> str:
        """The predicted error and the tolerance as text; "no error measured" without one."""
        if self.predicted_e is None:
            return "no error measured"
        return f"predicted error {self.predicted_e:.3g} e, tolerance {self.allowed}"

    @property
    def time_summary(self) -> str:
        """A sentence that compares the times of the plan (the effects that are simulated) and of
        simulating every effect."""
        saved = 1.0 - self.total_ms / self.all_ms if self.all_ms > 0 else 0.0
        return (
            f"a frame takes {self.total_ms:.2f} ms of a core instead of {self.all_ms:.2f} with all "
            f"effects: saves {saved:.0%}, by shipped prices"
        )

    def as_json(self) -> JsonObject:
        """Return the plan (the effects that are simulated) as JSON values, as in a frame file's
        `meta`."""
        plain: JsonObject = to_plain(self)
        return plain


def _shown(value: float | None, form: str) -> str:
    """Return a figure as text in a format; empty without one."""
    return "" if value is None else format(value, form)
