"""A plan: what a run simulates of a sensor's effects, how, and how wrong that makes it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass
from functools import cached_property
from typing import Any, Literal, get_args

from nscc_runtime.effects import CannotHave, Selection, registered
from nscc_runtime.effects.parts import Saturates
from nscc_runtime.effects.registry import always_on
from nscc_runtime.plan import leak_nodes

Choice = Literal["kept", "dropped", "absent"]
Loop = Literal["none", "some", "all", "reference"]


@dataclass(frozen=True)
class Decision:
    """What becomes of one effect.

    `predicted_rms_e` and `predicted_bias_e`: what the effect does to the exposure, its root mean
    square over pixels and buckets, and its mean. `predicted_if_dropped_e`: the error of the plan
    if this effect were left out as well. None where a prediction has no meaning (the readout).
    `forced`: the user decided. `cost_ms_model`: what leaving it out saves, by a model of costs.
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


@dataclass(frozen=True)
class Approximation:
    """A short cut that a plan takes with a kept effect, and the RMS error that it costs."""

    name: str
    error_e: float


@dataclass(frozen=True)
class Plan:
    """All that a run needs to know beside program, scene and sensor.

    Errors are root mean squares over pixels and buckets of the difference from the reference with
    every effect, in electrons before the ADC. `slot_loop`: "none", "some" pixels or "all" go
    through all their words one by one; "reference": the reference does it all. `leak_nodes`: at how
    many rates of leakage the sums over slots are made. `closed`: whether the charge of closed slots
    is counted.
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
        """The effects on pixels that run through all their words because they may saturate: there
        the others no longer add up, so only saturation itself and what the user forced is left out,
        and what the loop over words cannot have.
        """
        wanted, kept = self.wanted, self.kept
        lost = {e.name for e in wanted.effects if e.parts(Saturates) and e not in kept}
        lost |= {e.name for e in wanted.effects if isinstance(e.words, CannotHave)}
        return wanted.without(*lost)

    def as_json(self) -> dict[str, Any]:
        """The plan as a frame file's `meta` has it."""
        return {
            "tolerance_e": self.tolerance_e,
            "predicted_e": self.predicted_e,
            "bound_e": self.bound_e,
            "slot_loop": self.slot_loop != "none",
            "slot_loop_pixels": self.slot_loop,
            "slot_loop_reasons": list(self.slot_loop_reasons),
            "sampled_fraction": self.sampled_fraction,
            "approximations": [asdict(each) for each in self.approximations],
            "leak_nodes": self.leak_nodes,
            "closed_slots_counted": self.closed,
            "effects": [asdict(each) for each in self.decisions],
        }

    @classmethod
    def from_json(cls, values: Mapping[str, Any]) -> Plan:
        """The plan that `as_json` wrote; KeyError, TypeError or ValueError for anything else."""
        loop = values["slot_loop_pixels"]
        if loop not in get_args(Loop):
            raise ValueError(f"slot_loop_pixels is {loop!r:.40}")
        decisions = tuple(map(_decision, _list(values["effects"])))
        if [(each.name, each.kind) for each in decisions] != [
            (e.name, e.kind) for e in registered()
        ]:
            raise ValueError("its effects are not those of this version")
        tolerance, nodes = _number(values["tolerance_e"]), values["leak_nodes"]
        if not tolerance > 0:
            raise ValueError(f"tolerance_e is {tolerance}")
        if type(nodes) is not int or not 1 <= nodes <= leak_nodes.MOST:
            raise ValueError(f"leak_nodes is {nodes!r:.40}")
        return cls(
            tolerance,
            _number(values["predicted_e"]),
            _number(values["bound_e"]),
            loop,
            tuple(map(_text, _list(values["slot_loop_reasons"]))),
            _number(values["sampled_fraction"]),
            tuple(
                Approximation(_text(each["name"]), _number(each["error_e"]))
                for each in _list(values["approximations"])
            ),
            decisions,
            nodes,
            _flag(values["closed_slots_counted"]),
        )


def _decision(values: Mapping[str, Any]) -> Decision:
    """One of `effects` as a plan's JSON has it."""
    choice = values["decision"]
    if choice not in ("kept", "dropped", "absent"):
        raise ValueError(f"a decision is {choice!r:.40}")
    rms, bias, then = (
        None if values[name] is None else _number(values[name])
        for name in ("predicted_rms_e", "predicted_bias_e", "predicted_if_dropped_e")
    )
    return Decision(
        values["name"], values["kind"], choice, _flag(values["forced"]), _text(values["reason"]),
        rms, bias, then, _number(values["cost_ms_model"]),
    )  # fmt: skip


def _number(value: object) -> float:
    """A finite number; JSON's whole numbers have no end."""
    if isinstance(value, bool) or not isinstance(value, int | float) or not abs(value) < 1e300:
        # A whole number may have too many digits to be written out.
        shown = type(value).__name__ if isinstance(value, int) else f"{value!r:.40}"
        raise ValueError(f"no number: {shown}")
    return float(value)


def _text(value: object) -> str:
    if not isinstance(value, str):
        raise TypeError(f"no text: {value!r:.40}")
    return value


def _flag(value: object) -> bool:
    if not isinstance(value, bool):
        raise TypeError(f"neither true nor false: {value!r:.40}")
    return value


def _list(value: object) -> list[Any]:
    if not isinstance(value, list):
        raise TypeError(f"no list: {value!r:.40}")
    return value
