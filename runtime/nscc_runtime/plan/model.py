"""A plan: what a run simulates of a sensor's effects, how, and how wrong that makes it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass
from functools import cached_property
from typing import Any, Literal

from nscc_runtime.effects import EFFECTS, Selection
from nscc_runtime.effects.photodiode import FULL_WELL
from nscc_runtime.effects.registers import REGISTER

Choice = Literal["kept", "dropped", "absent"]


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
    through all their words one by one. `leak_nodes`: at how many rates of leakage the sums over
    slots are made. `closed`: whether the charge of closed slots is counted.
    """

    tolerance_e: float
    predicted_e: float
    bound_e: float
    slot_loop: Literal["none", "some", "all"]
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
        always = {effect.name for effect in EFFECTS if effect.always}
        forced = {each.name for each in self.decisions if each.forced}
        return Selection(frozenset(on | always), frozenset(forced))

    @cached_property
    def wanted(self) -> Selection:
        """All effects but those that the user forced off."""
        off = {each.name for each in self.decisions if each.forced and each.decision == "dropped"}
        kept = self.kept
        return Selection(frozenset(e.name for e in EFFECTS) - off, kept.forced)

    @cached_property
    def kept_in_words(self) -> Selection:
        """The effects on pixels that run through all their words because they may saturate: there
        the others no longer add up, so only saturation itself and what the user forced is left out.
        """
        kept, off = self.kept, {FULL_WELL.name, REGISTER.name} - self.kept.on
        return Selection(self.wanted.on - off, kept.forced)

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
        if loop not in ("none", "some", "all"):
            raise ValueError(f"slot_loop_pixels is {loop!r}")
        decisions = tuple(Decision(**each) for each in values["effects"])
        names = [effect.name for effect in EFFECTS]
        if [each.name for each in decisions] != names:
            raise ValueError("its effects are not those of this version")
        if any(each.decision not in ("kept", "dropped", "absent") for each in decisions):
            raise ValueError("a decision is neither kept nor dropped nor absent")
        return cls(
            float(values["tolerance_e"]),
            float(values["predicted_e"]),
            float(values["bound_e"]),
            loop,
            tuple(map(str, values["slot_loop_reasons"])),
            float(values["sampled_fraction"]),
            tuple(Approximation(**each) for each in values["approximations"]),
            decisions,
            int(values["leak_nodes"]),
            bool(values["closed_slots_counted"]),
        )
