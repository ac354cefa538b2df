"""The plan of a run: the effects that are simulated, how they are simulated, and the measured
errors."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, fields, is_dataclass, replace
from functools import cached_property
from types import UnionType
from typing import Any, Literal, get_args, get_origin, get_type_hints

from nscc import html
from nscc.columns import columns
from nscc_runtime.effects import CannotHave, Selection, everything, registered
from nscc_runtime.effects.parameters import MOST_E
from nscc_runtime.effects.parts import Leak, Saturates
from nscc_runtime.effects.registry import always_on
from nscc_runtime.execution.frames import Execution, Path
from nscc_runtime.planning.plan_parts import (
    LATER,
    MOST_OTHER_STATES,
    Approximation,
    Choice,
    Cost,
    Decision,
    Loop,
)
from nscc_runtime.planning.tolerance import LEAST_E, Tolerance, ToleranceInput

_LOOPS: Mapping[Loop, str] = {
    "none": "no pixel runs through the words one by one",
    "some": "some pixels run through the words one by one",
    "all": "all pixels run through the words one by one",
    "reference": "the reference runs, slot by slot",
}
_PATHS: Mapping[Loop, Path] = {
    "none": "sums", "some": "sums", "all": "words", "reference": "reference"
}  # fmt: skip


@dataclass(frozen=True, repr=False)
class Plan:
    """The plan of a run.

    Errors are root mean squares over pixels and buckets of the difference from the reference with
    every effect, in electrons before the ADC. Figures that were not measured are None. Converting a
    plan to text returns the table that `nscc run` prints.

    Attributes
    ----------
    tolerance_e : float or None
        The tolerance in electrons; None if it is a fraction of a noise that was not measured.
    predicted_e, bound_e : float or None
        The error measured on a sample of the scene, and this error plus three standard errors.
    slot_loop : {"none", "some", "all", "reference"}
        Which pixels run through their words one by one. "reference": the reference simulates all
        pixels instead.
    slot_loop_reasons : tuple of str
        Why pixels run through their words, or why the reference is used.
    sampled_fraction : float
        The fraction of the pixels that was measured.
    approximations : tuple of Approximation
        Differences between sums and the reference with the same effects.
    decisions : tuple of Decision
        The decision on each effect.
    other_states : float or None
        For a program that looks, the fraction of pixels that end in other states than with every
        effect. Errors are those of the other pixels.
    tolerance, tolerance_max : str
        The requested tolerances of the RMS error and of the largest error, as text; "" if not
        requested.
    signal_e, noise_e : float or None
        The mean signal, or the frame's own noise, that a relative tolerance refers to.
    predicted_p999_e, predicted_max_e : float or None
        Estimates of the 99.9 % quantile of the error, and of the largest error.
    tolerance_max_e : float or None
        The requested tolerance of the largest error, in electrons.
    noise_ratio : float or None
        Estimate of the standard deviation of exposures over frames, divided by that with every
        effect.
    saturating_lack : tuple of str
        The dropped effects that are dropped for pixels near saturation, too.
    cost : Cost or None
        Predicted times of frames, by shipped prices.
    reused : bool
        Whether the plan was made for an earlier scene with similar light, at least as strong. The
        figures are those of that scene.
    """

    tolerance_e: float | None
    predicted_e: float | None
    bound_e: float | None
    slot_loop: Loop
    slot_loop_reasons: tuple[str, ...]
    sampled_fraction: float
    approximations: tuple[Approximation, ...]
    decisions: tuple[Decision, ...]
    other_states: float | None = None
    tolerance: str = ""
    signal_e: float | None = None
    noise_e: float | None = field(default=None, metadata=LATER)
    predicted_p999_e: float | None = field(default=None, metadata=LATER)
    predicted_max_e: float | None = field(default=None, metadata=LATER)
    tolerance_max: str = field(default="", metadata=LATER)
    tolerance_max_e: float | None = field(default=None, metadata=LATER)
    noise_ratio: float | None = field(default=None, metadata=LATER)
    saturating_lack: tuple[str, ...] = field(default=(), metadata=LATER)
    cost: Cost | None = field(default=None, metadata=LATER)
    reused: bool = field(default=False, metadata=LATER)

    def names(self, choice: Choice) -> list[str]:
        """Return the names of the effects with this decision.

        Parameters
        ----------
        choice : {"kept", "dropped", "absent"}

        Returns
        -------
        list of str
        """
        return [decision.name for decision in self.decisions if decision.decision == choice]

    def __repr__(self) -> str:
        kept_names = self.names("kept")
        error = "no error measured"
        if self.predicted_e is not None and self.tolerance_e is not None:
            error = f"{self.predicted_e:.3g} e of {self.tolerance_e:.4g} e"
        effects = f"{len(kept_names)} of {len(self.decisions)} effects: {', '.join(kept_names)}"
        return f"<nscc plan: {error}, {effects}>"

    def __str__(self) -> str:
        return _table(self)

    def _repr_html_(self) -> str:
        summary = "no error measured"
        if self.predicted_e is not None:
            summary = f"predicted error {self.predicted_e:.3g} e, tolerance {self.allowed}"
        return html.card("plan", summary, html.plain(str(self)))

    @property
    def line(self) -> str:
        """The plan in one line: the effects that are simulated, and the predicted error."""
        kept_names, dropped_names = self.names("kept"), self.names("dropped")
        if not dropped_names:
            return f"every effect simulated: {len(kept_names)} that this run can have"
        error = "no error measured"
        if self.predicted_e is not None:
            error = f"predicted error {self.predicted_e:.3g} e, tolerance {self.allowed}"
        listed = f"without {', '.join(dropped_names)}"
        if len(kept_names) < len(dropped_names):
            listed = ", ".join(kept_names)
        count = len(kept_names) + len(dropped_names)
        return f"{error}; {len(kept_names)} of {count} effects simulated: {listed}"

    @property
    def measured(self) -> bool:
        """Whether the error was measured on a sample of the scene."""
        return self.predicted_e is not None

    @property
    def allowed(self) -> Tolerance | None:
        """The tolerance on the scene that the plan was made for; None if it is a fraction of a
        noise that was not measured."""
        return self._on_its_scene(self.tolerance, self.tolerance_e)

    @property
    def allowed_max(self) -> Tolerance | None:
        """The tolerance of the largest error; None if it was not requested."""
        return self._on_its_scene(self.tolerance_max, self.tolerance_max_e)

    def _on_its_scene(self, text: str, electrons: float | None) -> Tolerance | None:
        if electrons is None:
            return None
        signal_e = self.signal_e if text.endswith("%") else None
        return Tolerance(
            text, electrons, signal_e, self.noise_e if text.endswith("noise") else None
        )

    @property
    def tolerance_inputs(self) -> tuple[ToleranceInput, ToleranceInput | None]:
        """The tolerances as entered by the user, relative ones as text; the second may be None."""
        allowed, most = self.allowed, self.allowed_max
        return (
            self.tolerance if allowed is None or allowed.follows else allowed,
            most.text if most is not None and most.follows else most,
        )

    @property
    def breach(self) -> str | None:
        """A text that lists predicted errors above their tolerances; None if there are none."""
        broken_parts = []
        if (self.predicted_e or 0.0) > (self.tolerance_e or 0.0):
            broken_parts.append(
                f"the predicted error is {self.predicted_e:.3g} e, "
                f"the tolerance {self.tolerance_e:.4g} e"
            )
        if self.tolerance_max_e is not None and (self.predicted_max_e or 0) > self.tolerance_max_e:
            broken_parts.append(
                f"the predicted error of the worst pixel is {self.predicted_max_e:.3g} e, "
                f"its tolerance {self.tolerance_max_e:.4g} e"
            )
        if self.other_states is not None and self.other_states > MOST_OTHER_STATES:
            broken_parts.append(
                f"{self.other_states:.2%} of the pixels are predicted to end in other states, "
                f"{MOST_OTHER_STATES:.1%} may"
            )
        return "; ".join(broken_parts) or None

    @cached_property
    def kept(self) -> Selection:
        """The effects that are simulated."""
        forced = frozenset(decision.name for decision in self.decisions if decision.forced)
        return Selection(always_on().union(self.names("kept")), forced)

    @cached_property
    def requested_effects(self) -> Selection:
        """All effects except those that the user forced off."""
        forced = self.kept.forced
        return Selection(everything().on - forced.intersection(self.names("dropped")), forced)

    @cached_property
    def drops_saturation(self) -> bool:
        """Whether an effect that saturates is dropped."""
        return not everything().names(Saturates).isdisjoint(self.names("dropped"))

    @cached_property
    def execution(self) -> Execution:
        """The execution of frames of a program with fixed shutters under this plan."""
        requested_effects, kept_effects = self.requested_effects, self.kept
        slow = {e.name for e in requested_effects.effects if isinstance(e.words, CannotHave)}
        unsaturated = requested_effects.names(Saturates) - kept_effects.names(Saturates)
        near_effects = requested_effects.without(*slow, *unsaturated, *self.saturating_lack)
        exact = self.tolerance_max_e is not None
        return Execution(
            _PATHS[self.slot_loop], kept_effects, near_effects, requested_effects, exact
        )

    @property
    def costs(self) -> list[tuple[str, str, float]]:
        """Times that belong to no single effect: (name, description, milliseconds)."""
        if self.cost is None:
            return []
        kept_ms = sum(
            decision.cost_ms_model for decision in self.decisions if decision.decision == "kept"
        )
        return self.cost.rows(kept_ms, self.saturating_lack)

    def as_json(self) -> dict[str, Any]:
        """Return the plan as JSON values, as in a frame file's `meta`."""
        return {
            "tolerance": self.tolerance,
            "tolerance_e": self.tolerance_e,
            "signal_e": self.signal_e,
            "noise_e": self.noise_e,
            "predicted_e": self.predicted_e,
            "bound_e": self.bound_e,
            "predicted_p999_e": self.predicted_p999_e,
            "predicted_max_e": self.predicted_max_e,
            "tolerance_max": self.tolerance_max,
            "tolerance_max_e": self.tolerance_max_e,
            "noise_ratio": self.noise_ratio,
            "slot_loop": self.slot_loop != "none",
            "slot_loop_pixels": self.slot_loop,
            "slot_loop_reasons": list(self.slot_loop_reasons),
            "sampled_fraction": self.sampled_fraction,
            "approximations": [_as_json(item) for item in self.approximations],
            "leak_nodes": 2 if self.kept.find_part(Leak) is not None else 1,
            "closed_slots_counted": False,
            "saturating_lack": list(self.saturating_lack),
            "cost": None if self.cost is None else _as_json(self.cost),
            "other_states": self.other_states,
            "reused": self.reused,
            "effects": [_as_json(item) for item in self.decisions],
        }

    @classmethod
    def from_json(cls, values: Mapping[str, Any]) -> Plan:
        """Return the plan of JSON values that `as_json` returned. Raises KeyError, TypeError or
        ValueError for any other value."""
        names = {"slot_loop": "slot_loop_pixels", "decisions": "effects"}
        plan: Plan = _read(cls, {**values, **{ours: values[its] for ours, its in names.items()}})
        plan = replace(plan, decisions=_of_this_version(plan.decisions))
        if plan.tolerance_e is None:
            return plan
        if not LEAST_E <= plan.tolerance_e <= MOST_E:
            raise ValueError(f"tolerance_e is {plan.tolerance_e}")
        for unit, name, part_of_e in (
            ("%", "signal_e", plan.signal_e), ("noise", "noise_e", plan.noise_e)
        ):  # fmt: skip
            follows_unit = plan.tolerance.endswith(unit) or plan.tolerance_max.endswith(unit)
            if follows_unit != (part_of_e is not None):
                raise ValueError(f"{name} is {part_of_e}")
        if not {*plan.names("kept")}.isdisjoint(plan.saturating_lack):
            raise ValueError(f"saturating_lack is {', '.join(plan.saturating_lack)[:60]}")
        return plan


def _table(plan: Plan) -> str:
    """Return the plan as text: a row for each effect, then the errors and times."""
    looks = plan.other_states is not None
    head = ("effect", "rms e", "bias e", "choice", "why", "saves ms")
    rows: list[tuple[str, ...]] = [(*head, "other states") if looks else head]
    for decision in plan.decisions:
        rms = "" if decision.predicted_rms_e is None else f"{decision.predicted_rms_e:.3g}"
        bias = "" if not decision.predicted_bias_e else f"{decision.predicted_bias_e:+.3g}"
        choice = decision.decision + (", forced" if decision.forced else "")
        cost = "" if decision.cost_ms_model <= 0 else f"{decision.cost_ms_model:.2f}"
        other_states = (
            (f"{decision.other_states:.2%}" if decision.other_states else "",) if looks else ()
        )
        rows.append((decision.name, rms, bias, choice, decision.reason, cost, *other_states))
    rows += [
        (name, "", "", "", description, f"{cost_ms:.2f}", *(("",) if looks else ()))
        for name, description, cost_ms in plan.costs
    ]
    lines = [columns(rows, left_aligned=(0, 3, 4)), *_errors(plan), *approximation_lines(plan)]
    lines.append(
        ": ".join(filter(None, (_LOOPS[plan.slot_loop], "; ".join(plan.slot_loop_reasons))))
    )
    if plan.cost is not None:
        lines.append(plan.cost.summary)
    if plan.reused:
        lines.append("made for an earlier scene, whose light was of this kind and no weaker")
    return "\n".join(lines)


def _errors(plan: Plan) -> list[str]:
    tolerance = plan.allowed if plan.tolerance_e is not None else plan.tolerance
    if plan.predicted_e is None:
        return [f"no error was measured; tolerance {tolerance}"]
    lines = [
        f"predicted error {plan.predicted_e:.3g} e (at most {plan.bound_e or 0.0:.3g}), tolerance "
        f"{tolerance}, measured on {plan.sampled_fraction:.1%} of the pixels"
    ]
    if plan.predicted_max_e is not None and plan.predicted_p999_e is not None:
        lines.append(
            f"estimates: 99.9 % of the pixels within {plan.predicted_p999_e:.3g} e, the worst "
            f"{plan.predicted_max_e:.3g} e off"
            + ("" if plan.allowed_max is None else f", tolerance {plan.allowed_max}")
            + ("" if plan.noise_ratio is None else f"; noise x {plan.noise_ratio:.4f}")
        )
    if plan.other_states is not None:
        lines.append(
            f"predicted to end in other states: {plan.other_states:.2%} of the pixels, at most "
            f"{MOST_OTHER_STATES:.1%}"
        )
    return lines


def approximation_lines(plan: Plan) -> list[str]:
    """Return a line for each approximation of the plan, with its error if measured."""
    return [
        f"approximation: {approximation.name}"
        + ("" if approximation.error_e is None else f": {approximation.error_e:.2g} e")
        for approximation in plan.approximations
    ]


def _as_json(flat: Decision | Approximation | Cost) -> dict[str, Any]:
    """Return the fields of a flat record. (`dataclasses.asdict` takes a millisecond per plan.)"""
    return dict(vars(flat))


def _of_this_version(decisions: tuple[Decision, ...]) -> tuple[Decision, ...]:
    """Return decisions on all effects of this version, in order. Effects that an older file does
    not contain are simulated. Raises ValueError for unknown effects."""
    named = {(decision.name, decision.kind): decision for decision in decisions}
    known = [(effect.name, effect.kind) for effect in registered()]
    if len(named) < len(decisions) or not named.keys() <= {*known}:
        raise ValueError("its effects are not those of this version")
    reason = "the plan's file does not know it"
    return tuple(
        named.get((name, kind)) or Decision(name, kind, "kept", False, reason)
        for name, kind in known
    )


def _read(kind: Any, value: Any) -> Any:
    """Convert a JSON value to the type `kind`. Raises ValueError for other types and infinity."""
    origin, type_arguments = get_origin(kind), get_args(kind)
    if isinstance(kind, type) and is_dataclass(kind):
        hints = get_type_hints(kind)
        known = [e for e in fields(kind) if e.name in value or not e.metadata]
        return kind(**{item.name: _read(hints[item.name], value[item.name]) for item in known})
    if origin is tuple and isinstance(value, list):
        return tuple(_read(type_arguments[0], item) for item in value)
    if origin is UnionType:
        return None if value is None else _read(type_arguments[0], value)
    if kind is float and type(value) in (int, float) and abs(value) < 1e300:
        return float(value)
    if (origin is Literal and value in type_arguments) or (
        kind in (int, str, bool) and type(value) is kind
    ):
        return value
    # An integer may have too many digits to be printed.
    shown = type(value).__name__ if isinstance(value, int) else f"{value!r:.40}"
    raise ValueError(f"{shown} is not a {getattr(kind, '__name__', kind)}")
