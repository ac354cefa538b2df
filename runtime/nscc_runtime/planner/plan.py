"""A plan: what a run simulates of a sensor's effects, how, and how wrong that makes it."""

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
from nscc_runtime.effects.parts import Saturates
from nscc_runtime.effects.registry import always_on
from nscc_runtime.planner import leak_nodes
from nscc_runtime.planner.plan_parts import LATER, Approximation, Cost, Decision
from nscc_runtime.planner.tolerance import LEAST_E, Given, Tolerance
from nscc_runtime.remembered import remembered

Loop = Literal["none", "some", "all", "reference"]

MOST_OTHER_STATES = 0.005
"""Of the pixels of a program that looks, what part may end in other states than with all effects.
"""

_LOOPS: Mapping[Loop, str] = {
    "none": "no pixel runs through the words one by one",
    "some": "some pixels run through the words one by one",
    "all": "all pixels run through the words one by one",
    "reference": "the reference runs, slot by slot",
}


@dataclass(frozen=True, repr=False)
class Plan:
    """All that a run needs to know beside program, scene and sensor.

    Errors are root mean squares over pixels and buckets of the difference from the reference with
    every effect, in electrons before the ADC. `slot_loop`: "none", "some" pixels or "all" go
    through all their words one by one; "reference": the reference does it all. `leak_nodes`: at how
    many rates of leakage the sums over slots are made. `closed`: whether the charge of closed slots
    is counted. `other_states`: of a program that looks, the part of the pixels that end in other
    states than with every effect, at most MOST_OTHER_STATES; errors are those of the other pixels.
    `tolerance`: what was asked, as text, empty where that is not known; `signal_e`, `noise_e`: the
    mean signal or the frame's own noise that it is a part of, or None. `predicted_p999_e`,
    `predicted_max_e`: the error that one pixel in a thousand passes, and the largest of a frame;
    `tolerance_max`, `tolerance_max_e`: what was asked of the largest, empty and None where nothing
    was. `noise_ratio`: the standard deviation of exposures over frames by that with every effect;
    None where it is not promised. `saturating_lack`: the dropped effects that pixels near
    saturation lack as well, whose words run with all others. `cost`: None where there are no prices
    for it. `reused`: it was made for an earlier scene, with light of this kind and no weaker, whose
    predictions these are. As text a plan is the table that `nscc run` prints.
    """

    tolerance_e: float
    predicted_e: float
    bound_e: float
    slot_loop: Loop
    slot_loop_reasons: tuple[str, ...]
    sampled_fraction: float
    approximations: tuple[Approximation, ...]
    decisions: tuple[Decision, ...]
    leak_nodes: int = 1
    closed: bool = False
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
        return (
            f"<nscc plan: {self.predicted_e:.3g} e of {self.tolerance_e:.4g} e, "
            f"{len(kept)} of {len(self.decisions)} effects: {', '.join(kept)}>"
        )

    def __str__(self) -> str:
        looks = self.other_states is not None
        head = ("effect", "rms e", "bias e", "choice", "why", "saves ms")
        rows: list[tuple[str, ...]] = [(*head, "other states") if looks else head]
        for each in self.decisions:
            rms = "" if each.predicted_rms_e is None else f"{each.predicted_rms_e:.3g}"
            bias = "" if not each.predicted_bias_e else f"{each.predicted_bias_e:+.3g}"
            choice = each.decision + (", forced" if each.forced else "")
            cost = "" if each.cost_ms_model <= 0 else f"{each.cost_ms_model:.2f}"
            other = (f"{each.other_states:.2%}" if each.other_states else "",) if looks else ()
            rows.append((each.name, rms, bias, choice, each.reason, cost, *other))
        rows += [
            (name, "", "", "", what, f"{cost_ms:.2f}", *(("",) if looks else ()))
            for name, what, cost_ms in self.costs
        ]
        lines = [
            columns(rows, left=(0, 3, 4)),
            f"predicted error {self.predicted_e:.3g} e (at most {self.bound_e:.3g}), "
            f"tolerance {self.allowed}, from {self.sampled_fraction:.1%} of the pixels",
        ]
        if self.predicted_max_e is not None and self.predicted_p999_e is not None:
            lines.append(
                f"predicted of 99.9 % of the pixels: within {self.predicted_p999_e:.3g} e; of the "
                f"worst: {self.predicted_max_e:.3g} e"
                + ("" if self.allowed_max is None else f", tolerance {self.allowed_max}")
                + ("" if self.noise_ratio is None else f"; noise x {self.noise_ratio:.4f}")
            )
        if self.other_states is not None:
            lines.append(
                f"predicted to end in other states: {self.other_states:.2%} of the pixels, at most "
                f"{MOST_OTHER_STATES:.1%}"
            )
        lines += [f"short cut: {each.name}, {each.error_e:.2g} e" for each in self.approximations]
        loop = _LOOPS[self.slot_loop]
        lines.append(": ".join(filter(None, (loop, "; ".join(self.slot_loop_reasons)))))
        if self.cost is not None:
            lines.append(self.cost.said)
        if self.reused:
            lines.append("made for an earlier scene, whose light was of this kind and no weaker")
        return "\n".join(lines)

    @property
    def costs(self) -> list[tuple[str, str, float]]:
        """What takes time and is no effect's own: its name, what it is, and milliseconds."""
        if self.cost is None:
            return []
        kept_ms = sum(each.cost_ms_model for each in self.decisions if each.decision == "kept")
        lack = ", ".join(self.saturating_lack)
        saturating = "their words one by one" + (f", without {lack}" if lack else "")
        return self.cost.rows(kept_ms, saturating)

    def _repr_html_(self) -> str:
        said = f"predicted error {self.predicted_e:.3g} e, tolerance {self.allowed}"
        return html.card("plan", said, html.plain(str(self)))

    @property
    def allowed(self) -> Tolerance:
        """The tolerance on the scene that the plan was made for."""
        signal_e = self.signal_e if self.tolerance.endswith("%") else None
        noise_e = self.noise_e if self.tolerance.endswith("noise") else None
        return Tolerance(self.tolerance, self.tolerance_e, signal_e, noise_e)

    @property
    def asked(self) -> Given:
        """The tolerance as one for any scene."""
        return self.tolerance if self.allowed.follows else self.allowed

    @property
    def allowed_max(self) -> Tolerance | None:
        """The tolerance of the worst pixel, where there is one."""
        if self.tolerance_max_e is None:
            return None
        signal_e = self.signal_e if self.tolerance_max.endswith("%") else None
        noise_e = self.noise_e if self.tolerance_max.endswith("noise") else None
        return Tolerance(self.tolerance_max, self.tolerance_max_e, signal_e, noise_e)

    @property
    def asked_max(self) -> Given | None:
        """The same as one for any scene."""
        most = self.allowed_max
        return most.text if most is not None and most.follows else most

    def told(self, allowed: Tolerance, most: Tolerance | None = None) -> Plan:
        """The same plan, with the words in which its tolerances were asked."""
        beside = most or allowed
        return replace(
            self,
            tolerance=allowed.text,
            signal_e=beside.signal_e if allowed.signal_e is None else allowed.signal_e,
            noise_e=beside.noise_e if allowed.noise_e is None else allowed.noise_e,
            tolerance_max="" if most is None else most.text,
            tolerance_max_e=None if most is None else most.electrons,
        )

    @property
    def breach(self) -> str | None:
        """All of the promise that is predicted to break, in words."""
        found = []
        if self.predicted_e > self.tolerance_e:
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
    def kept_in_words(self) -> Selection:
        """The effects on pixels that run through all their words because they may saturate: all but
        those that they lack by the plan, saturation itself if it is dropped, what the user forced
        off, and what the loop over words cannot have.
        """
        return self.in_words(frozenset(self.saturating_lack))

    @remembered
    def in_words(self, lacking: frozenset[str]) -> Selection:
        """The same for pixels that lack these effects."""
        wanted, kept = self.wanted, self.kept
        lost = {e.name for e in wanted.effects if e.parts(Saturates) and e not in kept}
        lost |= {e.name for e in wanted.effects if isinstance(e.words, CannotHave)}
        return wanted.without(*lost, *lacking)

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
            "leak_nodes": self.leak_nodes,
            "closed_slots_counted": self.closed,
            "saturating_lack": list(self.saturating_lack),
            "cost": None if self.cost is None else _as_json(self.cost),
            "other_states": self.other_states,
            "reused": self.reused,
            "effects": [_as_json(each) for each in self.decisions],
        }

    @classmethod
    def of_nothing(cls) -> Plan:
        """The plan that simulates no effect."""
        decisions = tuple(
            Decision(effect.name, effect.kind, "dropped", True, "", None, None, None, 0.0)
            for effect in registered()
        )
        return cls(0.0, 0.0, 0.0, "none", (), 0.0, (), decisions)

    @classmethod
    def from_json(cls, values: Mapping[str, Any]) -> Plan:
        """The plan that `as_json` wrote; KeyError, TypeError or ValueError for anything else."""
        names = {"slot_loop": "slot_loop_pixels", "closed": "closed_slots_counted"}
        names |= {"decisions": "effects"}
        plan: Plan = _read(cls, {**values, **{ours: values[its] for ours, its in names.items()}})
        plan = replace(plan, decisions=_of_this_version(plan.decisions))
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
        if not 1 <= plan.leak_nodes <= leak_nodes.MOST:
            raise ValueError(f"leak_nodes is {plan.leak_nodes}")
        return plan


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
    raise ValueError(f"{shown} is no {getattr(kind, '__name__', kind)}")
