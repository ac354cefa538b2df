"""A plan: what a run simulates of a sensor's effects, how, and how wrong that makes it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass, is_dataclass, replace
from functools import cached_property
from types import UnionType
from typing import Any, Literal, get_args, get_origin, get_type_hints

from nscc import html
from nscc.columns import columns
from nscc_runtime.effects import CannotHave, Selection, registered
from nscc_runtime.effects.parameters import MOST_E
from nscc_runtime.effects.parts import Saturates
from nscc_runtime.effects.registry import always_on
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.planner import leak_nodes
from nscc_runtime.planner.tolerance import LEAST_E, Tolerance, tolerance_of

Choice = Literal["kept", "dropped", "absent"]
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


@dataclass(frozen=True)
class Decision:
    """What becomes of one effect.

    `predicted_rms_e` and `predicted_bias_e`: what the effect does to the exposure, its root mean
    square over pixels and buckets, and its mean. `predicted_if_dropped_e`: the error of the plan
    if this effect were left out as well. None where a prediction has no meaning (the readout).
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
    """A short cut that a plan takes with a kept effect, and the RMS error that it costs."""

    name: str
    error_e: float


@dataclass(frozen=True, repr=False)
class Plan:
    """All that a run needs to know beside program, scene and sensor.

    Errors are root mean squares over pixels and buckets of the difference from the reference with
    every effect, in electrons before the ADC. `slot_loop`: "none", "some" pixels or "all" go
    through all their words one by one; "reference": the reference does it all. `leak_nodes`: at how
    many rates of leakage the sums over slots are made. `closed`: whether the charge of closed slots
    is counted. `other_states`: of a program that looks, the part of the pixels that end in other
    states than with every effect, at most MOST_OTHER_STATES; errors are those of the other pixels.
    `tolerance`: what was asked, as text, empty where that is not known; `signal_e`: the mean signal
    that it is a part of, or None. `saturating_lack`: the dropped effects that pixels near
    saturation lack as well, whose words run with all others. As text a plan is the table that
    `nscc run` prints.
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
    saturating_lack: tuple[str, ...] = ()

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
        lines = [
            columns(rows, left=(0, 3, 4)),
            f"predicted error {self.predicted_e:.3g} e (at most {self.bound_e:.3g}), "
            f"tolerance {self._allowed}, from {self.sampled_fraction:.1%} of the pixels",
        ]
        if self.other_states is not None:
            lines.append(
                f"predicted to end in other states: {self.other_states:.2%} of the pixels, at most "
                f"{MOST_OTHER_STATES:.1%}"
            )
        lines += [f"short cut: {each.name}, {each.error_e:.2g} e" for each in self.approximations]
        loop = _LOOPS[self.slot_loop]
        lines.append(": ".join(filter(None, (loop, "; ".join(self.slot_loop_reasons)))))
        return "\n".join(lines)

    def _repr_html_(self) -> str:
        said = f"predicted error {self.predicted_e:.3g} e, tolerance {self._allowed}"
        return html.card("plan", said, html.plain(str(self)))

    @property
    def _allowed(self) -> str:
        """The tolerance in electrons, and what else it was asked as."""
        electrons = f"{self.tolerance_e:.4g} e"
        if self.signal_e is not None:
            return f"{electrons} ({self.tolerance} of the mean signal, {self.signal_e:.4g} e)"
        return f"{electrons} ({self.tolerance})" if self.tolerance.endswith("lsb") else electrons

    def asked(self, tolerance: Tolerance) -> Plan:
        """The same plan, with the words in which its tolerance was asked."""
        return replace(self, tolerance=tolerance.text, signal_e=tolerance.signal_e)

    def on(self, sensor: Sensor, signal_e: Callable[[], float]) -> Plan:
        """The plan for another scene, whose mean signal `signal_e` finds: its tolerance follows."""
        if self.signal_e is None:
            return self
        allowed = tolerance_of(self.tolerance, sensor, signal_e)
        return replace(self, tolerance_e=allowed.electrons).asked(allowed)

    @property
    def breach(self) -> str | None:
        """What of the promise is predicted to break, in words."""
        if self.predicted_e > self.tolerance_e:
            return (
                f"the predicted error is {self.predicted_e:.3g} e, "
                f"the tolerance {self.tolerance_e:.4g} e"
            )
        if self.other_states is not None and self.other_states > MOST_OTHER_STATES:
            return (
                f"{self.other_states:.2%} of the pixels are predicted to end in other states, "
                f"{MOST_OTHER_STATES:.1%} may"
            )
        return None

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
    def kept_in_words(self) -> Selection:
        """The effects on pixels that run through all their words because they may saturate: all but
        those that they lack by the plan, saturation itself if it is dropped, what the user forced
        off, and what the loop over words cannot have.
        """
        wanted, kept = self.wanted, self.kept
        lost = {e.name for e in wanted.effects if e.parts(Saturates) and e not in kept}
        lost |= {e.name for e in wanted.effects if isinstance(e.words, CannotHave)}
        return wanted.without(*lost, *self.saturating_lack)

    def as_json(self) -> dict[str, Any]:
        """The plan as a frame file's `meta` has it."""
        return {
            "tolerance": self.tolerance,
            "tolerance_e": self.tolerance_e,
            "signal_e": self.signal_e,
            "predicted_e": self.predicted_e,
            "bound_e": self.bound_e,
            "slot_loop": self.slot_loop != "none",
            "slot_loop_pixels": self.slot_loop,
            "slot_loop_reasons": list(self.slot_loop_reasons),
            "sampled_fraction": self.sampled_fraction,
            "approximations": [asdict(each) for each in self.approximations],
            "leak_nodes": self.leak_nodes,
            "closed_slots_counted": self.closed,
            "saturating_lack": list(self.saturating_lack),
            "other_states": self.other_states,
            "effects": [asdict(each) for each in self.decisions],
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
        named = [(each.name, each.kind) for each in plan.decisions]
        if named != [(effect.name, effect.kind) for effect in registered()]:
            raise ValueError("its effects are not those of this version")
        if not LEAST_E <= plan.tolerance_e <= MOST_E:
            raise ValueError(f"tolerance_e is {plan.tolerance_e}")
        if plan.tolerance.endswith("%") != (plan.signal_e is not None):
            raise ValueError(f"signal_e is {plan.signal_e}")
        if not set(plan.saturating_lack) <= {
            e.name for e in plan.decisions if e.decision == "dropped"
        }:
            raise ValueError(f"saturating_lack is {', '.join(plan.saturating_lack)[:60]}")
        if not 1 <= plan.leak_nodes <= leak_nodes.MOST:
            raise ValueError(f"leak_nodes is {plan.leak_nodes}")
        return plan


def _read(kind: Any, value: Any) -> Any:
    """A value of JSON as what an annotation names. Numbers are finite: JSON's own have no end."""
    origin, parts = get_origin(kind), get_args(kind)
    if isinstance(kind, type) and is_dataclass(kind):
        return kind(**{name: _read(of, value[name]) for name, of in get_type_hints(kind).items()})
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
