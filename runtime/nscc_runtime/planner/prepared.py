"""What all frames of a scene under a plan have in common: sums over the slots, and what they mean.

Nothing is done for a slot that can be done for all of them: light is added up with the weights of
the pixel's code, and counts are drawn for groups of slots.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects.parts import Counted, CountedLight, Exchange, Moving
from nscc_runtime.effects.selection import Selection
from nscc_runtime.effects.views import Device
from nscc_runtime.light import Light
from nscc_runtime.planner.chip import Chip, chip_of
from nscc_runtime.planner.near import Near, charges
from nscc_runtime.planner.plan import Plan
from nscc_runtime.planner.program import Program
from nscc_runtime.planner.sums import Weights, scene_sums

Values = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Prepared:
    """A scene under a plan, on one chip; arrays are made when they are asked for."""

    program: Program
    light: Light
    plan: Plan
    device_seed: int
    threads: int

    @property
    def kept(self) -> Selection:
        """The effects that are simulated."""
        return self.plan.kept

    @cached_property
    def places(self) -> NDArray[np.int64]:
        """Every pixel's place."""
        return np.arange(len(self.program.lanes), dtype=np.int64)

    @cached_property
    def source(self) -> Light:
        """The scene's light, with or without motion inside its slots."""
        return (self.kept.part(Moving) and self.light.motion) or self.light

    @property
    def total(self) -> Values:
        """All the light of each pixel, to float32."""
        return self.source.sum_e.reshape(-1)

    @property
    def device(self) -> Device:
        """What is fixed on the chip."""
        return self.program.device(self.device_seed)

    @cached_property
    def chip(self) -> Chip:
        """What the chip does to any scene under this plan."""
        plan = self.plan
        return chip_of(self.program, self.device_seed, plan.kept, plan.wanted, plan.leak_nodes)

    @cached_property
    def counted(self) -> tuple[int, ...]:
        """The groups whose charge is counted."""
        if self.kept.part(Counted) is None:
            return ()
        return tuple(g for g in self.program.group_ids.tolist() if g or self.plan.closed)

    @cached_property
    def _sums(self) -> tuple[Values, Values]:
        """All sums over the scene in one go: the light (counted groups, pixels) of each group of
        slots that is counted, and the light (buckets, leak nodes, pixels) of each bucket.
        """
        exchange = self.kept.part(Exchange)
        lit = self.counted if self.kept.part(CountedLight) is not None else ()
        weights, nodes = self.chip.own(_weights, lit), len(self.chip.leaks[0])
        found = scene_sums(
            self.source, self.program.lanes, self.chip.scale, weights,
            len(weights.slots) if exchange is None else len(lit),
            0.0 if exchange is None else exchange.fraction(self.program.sensor), self.threads,
        )  # fmt: skip
        return found[: len(lit)], found[len(lit) :].reshape(-1, nodes, found.shape[1])

    @property
    def light_rates(self) -> Values:
        """The light (groups, pixels) of each counted group of slots."""
        return self._sums[0]

    @cached_property
    def expected(self) -> Values:
        """The exposures (buckets, pixels) of the mean charge, nothing saturated."""
        sums, dark_e = self._sums[1], self.chip.dark_e
        found = sums[:, 0]
        if sums.shape[1] > 1:
            np.multiply(sums, self.chip.leaks[1], out=sums)
            for node in range(1, sums.shape[1]):
                found += sums[:, node]
        if dark_e is not None:
            np.add(found, dark_e, out=found)
        return np.ascontiguousarray(found)

    @cached_property
    def near(self) -> Near:
        """The pixels that may saturate in a way that sums do not know."""
        # These pixels run with all effects, so all effects say which they are.
        wanted = self.plan.wanted
        found = charges(self.program, self.source, self.device_seed, wanted)
        return Near(self.chip, found)

    @cached_property
    def saturating(self) -> NDArray[np.int64]:
        """Their places, in order."""
        if np.isinf(self.chip.near_e).all():
            return np.empty(0, np.int64)
        return self.near.places


def _weights(chip: Chip, counted: tuple[int, ...]) -> Weights:
    """Which slots are of each group that is counted; then how much of each slot's light comes to
    each bucket, at each rate of leakage."""
    program = chip.program
    model = program.model(chip.kept)
    slots = [
        program.tables.weights(replace(model, leak_per_s=rate)).slots for rate in chip.leaks[0]
    ]
    buckets = range(len(program.container.buckets))
    groups = [program.members(group) for group in counted]
    return Weights(groups + [each[:, :, bucket] for bucket in buckets for each in slots])
