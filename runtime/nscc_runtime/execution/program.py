"""A compiled program on a sensor, analysed once for any number of scenes and sets of effects."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from nscc.words.container import Container
from nscc_runtime.caches import OfContainer, Recent, remembered
from nscc_runtime.effects import Selection, everything
from nscc_runtime.effects.parts import Soft
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.emulator.capture import check_program
from nscc_runtime.execution.overlap import Overlap
from nscc_runtime.execution.pixel_array import PixelArray
from nscc_runtime.execution.pixels import LaneWords, Wired
from nscc_runtime.execution.register_reach import RegisterReach, Tables, reach_of
from nscc_runtime.execution.sum_loop import SlotWeights
from nscc_runtime.reference.capture import Reference
from nscc_runtime.reference.weights import WeightModel

Values = NDArray[np.float64]

_RECENT_MODELS, _RECENT_CHIPS = 40, 4
"""Number of cached results: planning compares a dozen models; chips are large."""
_MUCH = 1 << 20
"""If slots x lanes is above this number, fewer models are cached."""


@dataclass(frozen=True, eq=False)
class AnalysedProgram:
    """A compiled program on a sensor, analysed once for all scenes. `slot_s`: slot lengths (N,)."""

    container: Container
    sensor: Sensor
    reference: Reference
    tables: Tables
    slot_s: Values

    @classmethod
    def of(cls, container: Container, sensor: Sensor) -> AnalysedProgram:
        """Analyse a program. Raises Rejected (NS0442) if its words open no shutters."""
        check_program(container)
        reference = Reference.of(container, sensor, everything())
        return cls(container, sensor, reference, Tables.of(reference), container.slot_s)

    @cached_property
    def array(self) -> PixelArray:
        """All pixels of the chip."""
        return PixelArray.of_chip(self.reference.groups.lane)

    @property
    def lanes(self) -> NDArray[np.int32]:
        """The lane (code number) of each pixel, shape (pixels,)."""
        return self.array.flat_lanes

    @cached_property
    def full(self) -> WeightModel:
        """The weight model with every effect."""
        return self.model(everything())

    @remembered
    def model(self, kept_effects: Selection) -> WeightModel:
        """Return the weight model under some effects, at the mean leakage."""
        return WeightModel.of(kept_effects, self.sensor)

    @cached_property
    def pixels(self) -> LaneWords:
        """The words for the loop over single pixels, with decay of digital registers."""
        return LaneWords.of(self.reference)

    def wired(self, effects: Selection, device_seed: int) -> Wired:
        """Return the words of pixels on a chip under some effects, bound to the loop; cached."""
        return self.recent.of(
            (Wired, effects.on, device_seed),
            lambda: Wired(self.words(effects), effects, device_seed),
        )

    @cached_property
    def _fresh_pixels(self) -> LaneWords:
        return LaneWords.of(replace(self.reference, words=self.tables.fresh))

    def words(self, kept_effects: Selection) -> LaneWords:
        """Return the words for the loop over single pixels under some effects."""
        faded = self.model(kept_effects).decay or not self.tables.decays
        return self.pixels if faded else self._fresh_pixels

    @cached_property
    def reach(self) -> RegisterReach:
        """The charge up to which registers stay linear, with every effect."""
        all_effects = everything()
        return reach_of(
            self.tables, all_effects, all_effects.require_part(Soft).linear_e(self.sensor)
        )

    @cached_property
    def open_part(self) -> NDArray[np.float32]:
        """Fraction (rows, cols) of the frame in which light reaches each pixel's exposure."""
        open_fraction = (
            self.slot_s @ self.tables.seen_slots() / max(float(self.slot_s.sum()), 1e-300)
        )
        return np.asarray(open_fraction[self.array.lanes], np.float32)

    @cached_property
    def group_ids(self) -> NDArray[np.int64]:
        """Numbers (groups,) of the groups of slots that occur; group 0 contains closed slots."""
        return np.unique(self.reference.groups.of_slot)

    @cached_property
    def open_groups(self) -> tuple[int, ...]:
        """Numbers of the groups of slots that are open in some bucket."""
        return tuple(group for group in self.group_ids.tolist() if group)

    def members(self, group: int) -> Values:
        """Return a float64 mask (N, lanes): 1 where a slot belongs to the group, else 0."""
        return np.ascontiguousarray((self.reference.groups.of_slot == group).T, np.float64)

    @remembered
    def group_seconds(self, group: int) -> Values:
        """Return the total seconds (lanes,) of the slots of a group."""
        return np.asarray(self.slot_s @ self.members(group))

    @remembered
    def open_seconds(self, model: WeightModel) -> Values:
        """Return the open seconds (buckets, lanes), weighted by a model."""
        return np.asarray(np.einsum("n,nlb->bl", self.slot_s, self.tables.weights(model).slots))

    @remembered
    def mean_weights(self, model: WeightModel) -> dict[int, Values]:
        """Return for each group of slots its time-averaged weight (lanes, buckets)."""
        weights = self.tables.weights(model).slots
        means = {}
        for group in self.group_ids.tolist():
            seconds = self.members(group) * self.slot_s[:, None]
            total_s = seconds.sum(axis=0)[:, None]
            weighted = np.einsum("nl,nlb->lb", seconds, weights)
            means[group] = np.divide(
                weighted, total_s, out=np.zeros_like(weighted), where=total_s > 0
            )
        return means

    @remembered
    def uneven_seconds(self, model: WeightModel) -> tuple[Values, Values]:
        """Return time integrals (buckets, lanes) of squared weights: relative to the group means,
        and absolute.

        Multiplied by the light per second, the first is the variance of counts that one count per
        group neglects, and the second is the whole variance of counts."""
        weights, means = self.tables.weights(model).slots, self.mean_weights(model)
        uneven, square = np.zeros((2, weights.shape[2], weights.shape[1]))
        for group in self.open_groups:
            seconds = self.members(group) * self.slot_s[:, None]
            uneven += np.einsum("nl,nlb->bl", seconds, (weights - means[group]) ** 2)
            square += np.einsum("nl,nlb->bl", seconds, weights**2)
        return uneven, square

    def sum_weights(
        self, model: WeightModel, leak_rates: tuple[float, ...], groups: tuple[int, ...]
    ) -> SlotWeights:
        """Return the weights of slots for sums: a mask for each group, then for each bucket the
        weights at each leakage rate."""
        key = SlotWeights, model, leak_rates, groups

        def make() -> SlotWeights:
            slots = [
                self.tables.weights(replace(model, leak_per_s=rate)).slots for rate in leak_rates
            ]
            buckets = range(len(self.container.buckets))
            counted = [self.members(group) for group in groups]
            return SlotWeights(
                counted
                + [slot_weights[:, :, bucket] for bucket in buckets for slot_weights in slots]
            )

        return self.recent.of(key, make)

    def overlaps(self, model: WeightModel) -> list[Overlap]:
        """Return for each open group the weights of a neighbour's counts in a pixel's exposures."""

        def make() -> list[Overlap]:
            seconds = self.tables.weights(model).slots * self.slot_s[:, None, None]
            group_overlaps = []
            for group in self.open_groups:
                members, time_s = self.members(group), self.group_seconds(group)
                inverse_seconds = np.divide(
                    members, time_s, out=np.zeros_like(members), where=time_s > 0
                )
                group_overlaps.append(Overlap(seconds, inverse_seconds))
            return group_overlaps

        return self.recent.of((Overlap, model), make)

    @cached_property
    def recent(self) -> Recent:
        """Cache of weights for recent models."""
        is_large = self.container.slots * len(self.container.encoding) > _MUCH
        return Recent(_RECENT_CHIPS if is_large else _RECENT_MODELS)

    @cached_property
    def recent_chips(self) -> Recent:
        """Cache of arrays of all pixels for recent sets of effects."""
        return Recent(_RECENT_CHIPS)


analysed = OfContainer(AnalysedProgram.of)
"""Return the `AnalysedProgram` of a container on a sensor, cached for each pair."""
