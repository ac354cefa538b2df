"""A compiled program on a sensor, analysed once for any number of scenes and sets of effects."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from nscc.words.container import Container
from nscc_runtime.effects import Selection, everything
from nscc_runtime.effects.parts import Soft
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.emulator.capture import check_program
from nscc_runtime.execution.overlap import Overlap
from nscc_runtime.execution.pixel_array import PixelArray
from nscc_runtime.execution.pixels import Pixels, Wired
from nscc_runtime.execution.reach import Reach, reach_of
from nscc_runtime.execution.sums import Weights
from nscc_runtime.execution.tables import Tables
from nscc_runtime.ready import OfContainer
from nscc_runtime.reference.capture import Reference
from nscc_runtime.reference.charge import Groups
from nscc_runtime.reference.weights import Model
from nscc_runtime.remembered import Recent, remembered

Values = NDArray[np.float64]

_RECENT_MODELS, _RECENT_CHIPS = 40, 4
"""Results that are kept for the last sets of effects: planning compares a dozen models, three of
each; chips hold arrays of all pixels."""
_MUCH = 1 << 20
"""Numbers of slots x lanes from which on fewer models are kept."""


@dataclass(frozen=True, eq=False)
class Program:
    """A compiled program and a sensor, made ready once for any number of scenes."""

    container: Container
    sensor: Sensor
    reference: Reference
    tables: Tables
    slot_s: Values

    @classmethod
    def of(cls, container: Container, sensor: Sensor) -> Program:
        """Analyse a program. Raises Rejected where its words open no shutters (NS0442)."""
        check_program(container)
        reference = Reference.of(container, sensor, everything())
        return cls(container, sensor, reference, Tables.of(reference), container.slot_s)

    @cached_property
    def array(self) -> PixelArray:
        """All pixels of the chip."""
        return PixelArray.whole(self.reference.groups.lane)

    @property
    def lanes(self) -> NDArray[np.int32]:
        """The lane of every pixel, flat."""
        return self.array.flat_lanes

    @cached_property
    def full(self) -> Model:
        """The weights with every effect on."""
        return self.model(everything())

    @remembered
    def model(self, kept: Selection) -> Model:
        """The weights under some effects, at the mean leakage."""
        return Model.of(kept, self.sensor)

    @cached_property
    def pixels(self) -> Pixels:
        """The words as they act, for the loop over single pixels, where digital registers decay."""
        return Pixels.of(self.reference)

    def reference_at(self, array: PixelArray, effects: Selection) -> Reference:
        """The reference for some pixels of the chip, under some effects."""
        whole = Reference.of(self.container, self.sensor, effects)
        lane = array.lanes.astype(np.intp)
        return replace(whole, groups=Groups(whole.groups.of_slot, lane, array.places))

    def wired(self, effects: Selection, device_seed: int) -> Wired:
        """The words of single pixels of a chip that have these effects, for the compiled loop."""
        return self.recent.of(
            (Wired, effects.on, device_seed),
            lambda: Wired(self.words(effects), effects, device_seed),
        )

    @cached_property
    def _fresh_pixels(self) -> Pixels:
        return Pixels.of(replace(self.reference, words=self.tables.fresh))

    def words(self, kept: Selection) -> Pixels:
        """The words for the loop over single pixels, under some effects."""
        faded = self.model(kept).decay or not self.tables.decays
        return self.pixels if faded else self._fresh_pixels

    @cached_property
    def reach(self) -> Reach:
        """How far registers go with every effect on."""
        every = everything()
        return reach_of(self.tables, every, every.the(Soft).linear_e(self.sensor))

    @cached_property
    def open_part(self) -> NDArray[np.float32]:
        """The part (rows, cols) of the frame whose light each pixel sees."""
        part = self.slot_s @ self.tables.seen() / max(float(self.slot_s.sum()), 1e-300)
        return np.asarray(part[self.array.lanes], np.float32)

    @cached_property
    def group_ids(self) -> NDArray[np.int64]:
        """The groups of slots that occur; group 0 are closed slots."""
        return np.unique(self.reference.groups.of_slot)

    @cached_property
    def open_groups(self) -> tuple[int, ...]:
        """The groups of slots that are open in some bucket."""
        return tuple(group for group in self.group_ids.tolist() if group)

    def members(self, group: int) -> Values:
        """1 where a slot (N, lanes) belongs to a group."""
        return np.ascontiguousarray((self.reference.groups.of_slot == group).T, np.float64)

    @remembered
    def group_seconds(self, group: int) -> Values:
        """How long (lanes,) the slots of a group are."""
        return np.asarray(self.slot_s @ self.members(group))

    @remembered
    def open_seconds(self, model: Model) -> Values:
        """How long (buckets, lanes) pixels are open for each bucket, by the weights of a model."""
        return np.asarray(np.einsum("n,nlb->bl", self.slot_s, self.tables.weights(model).slots))

    @remembered
    def mean_weights(self, model: Model) -> dict[int, Values]:
        """The mean weight (lanes, buckets) over the time of each group's slots."""
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
    def uneven_seconds(self, model: Model) -> tuple[Values, Values]:
        """Integrals (buckets, lanes) over the time of a group's slots of the square by which their
        weights differ from their mean, and of the square of the weights. Times the light a second
        these are the variance of counts that drawing one count for the whole group leaves out, and
        all of it."""
        weights, means = self.tables.weights(model).slots, self.mean_weights(model)
        uneven, square = np.zeros((2, weights.shape[2], weights.shape[1]))
        for group in self.open_groups:
            seconds = self.members(group) * self.slot_s[:, None]
            uneven += np.einsum("nl,nlb->bl", seconds, (weights - means[group]) ** 2)
            square += np.einsum("nl,nlb->bl", seconds, weights**2)
        return uneven, square

    def sum_weights(
        self, model: Model, leak_rates: tuple[float, ...], groups: tuple[int, ...]
    ) -> Weights:
        """Which slots belong to each of the groups, then how much of each slot's light comes to
        each bucket at each rate of leakage."""
        key = Weights, model, leak_rates, groups

        def make() -> Weights:
            slots = [
                self.tables.weights(replace(model, leak_per_s=rate)).slots for rate in leak_rates
            ]
            buckets = range(len(self.container.buckets))
            counted = [self.members(group) for group in groups]
            return Weights(counted + [each[:, :, bucket] for bucket in buckets for each in slots])

        return self.recent.of(key, make)

    def overlaps(self, model: Model) -> list[Overlap]:
        """How much of the counts of a neighbour's groups falls on a pixel's open slots."""

        def make() -> list[Overlap]:
            seconds = self.tables.weights(model).slots * self.slot_s[:, None, None]
            found = []
            for group in self.open_groups:
                members, time_s = self.members(group), self.group_seconds(group)
                parts = np.divide(members, time_s, out=np.zeros_like(members), where=time_s > 0)
                found.append(Overlap(seconds, parts))
            return found

        return self.recent.of((Overlap, model), make)

    @cached_property
    def recent(self) -> Recent:
        """Weights that were last computed for some models."""
        much = self.container.slots * len(self.container.encoding) > _MUCH
        return Recent(_RECENT_CHIPS if much else _RECENT_MODELS)

    @cached_property
    def recent_chips(self) -> Recent:
        """What was last computed for all pixels under some sets of effects."""
        return Recent(_RECENT_CHIPS)


analysed = OfContainer(Program.of)
"""The analysis of a container on a sensor, made once for each pair."""
