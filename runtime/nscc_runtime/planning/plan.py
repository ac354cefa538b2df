"""Step 5 of planning: a plan says what a run simulates of a sensor's effects, how, and what that
was measured to change."""

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
    Cost,
    Decision,
    Loop,
)
from nscc_runtime.planning.tolerance import LEAST_E, Given, Tolerance

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
    """What a run needs to know beside program, scene and sensor.

    Errors are root mean squares over pixels and buckets of the difference from the reference with
    every effect, in electrons before the ADC. Figures that were not measured are None. As text a
    plan is the table that `nscc run` prints.

    Attributes
    ----------
    tolerance_e : float or None
        The tolerance in electrons; None where it is a part of a noise that was not measured.
    predicted_e, bound_e : float or None
        The error measured on a sample of the scene, and the same with three standard errors.
    slot_loop : {"none", "some", "all", "reference"}
        Which pixels run through their words one by one; "reference": the reference simulates all.
    slot_loop_reasons : tuple of str
        Why they do.
    sampled_fraction : float
        The part of the pixels that was measured.
    approximations : tuple of Approximation
        How sums differ from the reference with the same effects.
    decisions : tuple of Decision
        What becomes of each effect.
    other_states : float or None
        Of a program that looks, the part of the pixels that end in other states than with every
        effect; errors are those of the other pixels.
    tolerance, tolerance_max : str
        What was asked of the root mean square and of the largest error; "" where nothing was.
    signal_e, noise_e : float or None
        The mean signal or the frame's own noise that the tolerance is a part of.
    predicted_p999_e, predicted_max_e : float or None
        Estimates of the error that one pixel in a thousand passes, and of the largest.
    tolerance_max_e : float or None
        What was asked of the largest error, in electrons.
    noise_ratio : float or None
        Estimate of the standard deviation of exposures over frames by that with every effect.
    saturating_lack : tuple of str
        The dropped effects that pixels near saturation lack as well; they have the others.
    cost : Cost or None
        What frames take, by shipped prices.
    reused : bool
        Whether the plan was made for an earlier scene with light of this kind and no weaker, whose
        figures these are.
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

    def __repr__(self) -> str:
        kept = [each.name for each in self.decisions if each.decision == "kept"]
        error = "no error measured"
        if self.predicted_e is not None and self.tolerance_e is not None:
            error = f"{self.predicted_e:.3g} e of {self.tolerance_e:.4g} e"
        return (
            f"<nscc plan: {error}, {len(kept)} of {len(self.decisions)} effects: {', '.join(kept)}>"
        )

    def __str__(self) -> str:
        return _table(self)

    def _repr_html_(self) -> str:
        said = "no error measured"
        if self.predicted_e is not None:
            said = f"predicted error {self.predicted_e:.3g} e, tolerance {self.allowed}"
        return html.card("plan", said, html.plain(str(self)))

    @property
    def line(self) -> str:
        """The plan in one line: the effects that are simulated, and the predicted error."""
        names = {choice: [each.name for each in self.decisions if each.decision == choice]
                 for choice in ("kept", "dropped")}  # fmt: skip
        if not names["dropped"]:
            return f"every effect simulated: {len(names['kept'])} that this run can have"
        error = "no error measured"
        if self.predicted_e is not None:
            error = f"predicted error {self.predicted_e:.3g} e, tolerance {self.allowed}"
        kept, dropped = names["kept"], names["dropped"]
        listed = f"without {', '.join(dropped)}"
        if len(kept) < len(dropped):
            listed = ", ".join(kept)
        return f"{error}; {len(kept)} of {len(kept) + len(dropped)} effects simulated: {listed}"

    @property
    def measured(self) -> bool:
        """Whether the error was measured on a sample of the scene."""
        return self.predicted_e is not None

    @property
    def allowed(self) -> Tolerance | None:
        """The tolerance on the scene that the plan was made for; None where it is a part of a noise
        that was not measured."""
        return self._on_its_scene(self.tolerance, self.tolerance_e)

    @property
    def allowed_max(self) -> Tolerance | None:
        """The tolerance of the worst pixel, where there is one."""
        return self._on_its_scene(self.tolerance_max, self.tolerance_max_e)

    def _on_its_scene(self, text: str, electrons: float | None) -> Tolerance | None:
        if electrons is None:
            return None
        signal_e = self.signal_e if text.endswith("%") else None
        return Tolerance(
            text, electrons, signal_e, self.noise_e if text.endswith("noise") else None
        )

    @property
    def asked(self) -> tuple[Given, Given | None]:
        """The tolerances as those of any scene."""
        allowed, most = self.allowed, self.allowed_max
        return (
            self.tolerance if allowed is None or allowed.follows else allowed,
            most.text if most is not None and most.follows else most,
        )

    @property
    def breach(self) -> str | None:
        """All of the promise that is predicted to break, in words."""
        found = []
        if (self.predicted_e or 0.0) > (self.tolerance_e or 0.0):
            found.append(
                f"the predicted error is {self.predicted_e:.3g} e, "
                f"the tolerance {self.tolerance_e:.4g} e"
            )
        if self.tolerance_max_e is not None and (self.predicted_max_e or 0) > self.tolerance_max_e:
            found.append(
                f"the predicted error of the worst pixel is {self.predicted_max_e:.3g} e, "
                f"its tolerance {self.tolerance_max_e:.4g} e"
            )
        if self.other_states is not None and self.other_states > MOST_OTHER_STATES:
            found.append(
                f"{self.other_states:.2%} of the pixels are predicted to end in other states, "
                f"{MOST_OTHER_STATES:.1%} may"
            )
        return "; ".join(found) or None

    @cached_property
    def kept(self) -> Selection:
        """The effects that are simulated."""
        on = {each.name for each in self.decisions if each.decision == "kept"}
        forced = {each.name for each in self.decisions if each.forced}
        return Selection(always_on() | on, frozenset(forced))

    @cached_property
    def wanted(self) -> Selection:
        """All effects but those that the user forced off."""
        off = {each.name for each in self.decisions if each.forced and each.decision == "dropped"}
        kept = self.kept
        return Selection(frozenset(e.name for e in registered()) - off, kept.forced)

    @cached_property
    def drops_saturation(self) -> bool:
        """Whether an effect of what saturates is left out because the tolerance has room for it."""
        names = everything().names(Saturates)
        return any(e.decision == "dropped" and e.name in names for e in self.decisions)

    @cached_property
    def execution(self) -> Execution:
        """How frames are exposed under this plan, of a program with fixed shutters."""
        wanted, kept = self.wanted, self.kept
        slow = {e.name for e in wanted.effects if isinstance(e.words, CannotHave)}
        unsaturated = wanted.names(Saturates) - kept.names(Saturates)
        near = wanted.without(*slow, *unsaturated, *self.saturating_lack)
        exact = self.tolerance_max_e is not None
        return Execution(_PATHS[self.slot_loop], kept, near, wanted, exact)

    @property
    def costs(self) -> list[tuple[str, str, float]]:
        """What takes time and is no effect's own: its name, what it is, and milliseconds."""
        if self.cost is None:
            return []
        kept_ms = sum(each.cost_ms_model for each in self.decisions if each.decision == "kept")
        return self.cost.rows(kept_ms, self.saturating_lack)

    def as_json(self) -> dict[str, Any]:
        """The plan as a frame file's `meta` has it."""
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
            "approximations": [_as_json(each) for each in self.approximations],
            "leak_nodes": 2 if self.kept.part(Leak) is not None else 1,
            "closed_slots_counted": False,
            "saturating_lack": list(self.saturating_lack),
            "cost": None if self.cost is None else _as_json(self.cost),
            "other_states": self.other_states,
            "reused": self.reused,
            "effects": [_as_json(each) for each in self.decisions],
        }

    @classmethod
    def from_json(cls, values: Mapping[str, Any]) -> Plan:
        """The plan that `as_json` wrote; KeyError, TypeError or ValueError for anything else."""
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
            asked = plan.tolerance.endswith(unit) or plan.tolerance_max.endswith(unit)
            if asked != (part_of_e is not None):
                raise ValueError(f"{name} is {part_of_e}")
        kept = {each.name for each in plan.decisions if each.decision == "kept"}
        if not kept.isdisjoint(plan.saturating_lack):
            raise ValueError(f"saturating_lack is {', '.join(plan.saturating_lack)[:60]}")
        return plan


def _table(plan: Plan) -> str:
    """A row for each effect, then what the plan comes to."""
    looks = plan.other_states is not None
    head = ("effect", "rms e", "bias e", "choice", "why", "saves ms")
    rows: list[tuple[str, ...]] = [(*head, "other states") if looks else head]
    for each in plan.decisions:
        rms = "" if each.predicted_rms_e is None else f"{each.predicted_rms_e:.3g}"
        bias = "" if not each.predicted_bias_e else f"{each.predicted_bias_e:+.3g}"
        choice = each.decision + (", forced" if each.forced else "")
        cost = "" if each.cost_ms_model <= 0 else f"{each.cost_ms_model:.2f}"
        other = (f"{each.other_states:.2%}" if each.other_states else "",) if looks else ()
        rows.append((each.name, rms, bias, choice, each.reason, cost, *other))
    rows += [
        (name, "", "", "", what, f"{cost_ms:.2f}", *(("",) if looks else ()))
        for name, what, cost_ms in plan.costs
    ]
    lines = [columns(rows, left_aligned=(0, 3, 4)), *_errors(plan), *approximation_lines(plan)]
    lines.append(
        ": ".join(filter(None, (_LOOPS[plan.slot_loop], "; ".join(plan.slot_loop_reasons))))
    )
    if plan.cost is not None:
        lines.append(plan.cost.said)
    if plan.reused:
        lines.append("made for an earlier scene, whose light was of this kind and no weaker")
    return "\n".join(lines)


def _errors(plan: Plan) -> list[str]:
    """The errors that were measured, and what was asked."""
    asked = plan.allowed if plan.tolerance_e is not None else plan.tolerance
    if plan.predicted_e is None:
        return [f"no error was measured; tolerance {asked}"]
    lines = [
        f"predicted error {plan.predicted_e:.3g} e (at most {plan.bound_e or 0.0:.3g}), tolerance "
        f"{asked}, measured on {plan.sampled_fraction:.1%} of the pixels"
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
    """How sums differ from the reference, and by how much."""
    return [
        f"approximation: {name}" + ("" if error_e is None else f": {error_e:.2g} e")
        for name, error_e in ((each.name, each.error_e) for each in plan.approximations)
    ]


def _as_json(flat: Decision | Approximation | Cost) -> dict[str, Any]:
    """A record of numbers and text by its fields; `dataclasses.asdict` takes a millisecond for a
    plan's, as it looks into each of them."""
    return dict(vars(flat))


def _of_this_version(found: tuple[Decision, ...]) -> tuple[Decision, ...]:
    """Decisions on all effects that there are, in their order; those that an older file does not
    know are simulated. ValueError for others."""
    named = {(each.name, each.kind): each for each in found}
    known = [(effect.name, effect.kind) for effect in registered()]
    if len(named) < len(found) or not named.keys() <= {*known}:
        raise ValueError("its effects are not those of this version")
    reason = "the plan's file does not know it"
    return tuple(
        named.get((name, kind))
        or Decision(name, kind, "kept", False, reason, None, None, None, 0.0)
        for name, kind in known
    )


def _read(kind: Any, value: Any) -> Any:
    """A value of JSON as what an annotation names. Numbers are finite: JSON's own have no end."""
    origin, parts = get_origin(kind), get_args(kind)
    if isinstance(kind, type) and is_dataclass(kind):
        hints = get_type_hints(kind)
        known = [e for e in fields(kind) if e.name in value or not e.metadata]
        return kind(**{each.name: _read(hints[each.name], value[each.name]) for each in known})
    if origin is tuple and isinstance(value, list):
        return tuple(_read(parts[0], each) for each in value)
    if origin is UnionType:
        return None if value is None else _read(parts[0], value)
    if kind is float and type(value) in (int, float) and abs(value) < 1e300:
        return float(value)
    if (origin is Literal and value in parts) or (kind in (int, str, bool) and type(value) is kind):
        return value
    # A whole number may have too many digits to be written out.
    shown = type(value).__name__ if isinstance(value, int) else f"{value!r:.40}"
    raise ValueError(f"{shown} is not a {getattr(kind, '__name__', kind)}")
