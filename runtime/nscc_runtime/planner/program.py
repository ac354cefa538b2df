"""A compiled program on a sensor, analysed once for any number of scenes, plans and chips."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from nscc.words.container import Container
from nscc_runtime.effects import Selection, everything
from nscc_runtime.effects.parts import Fading, Leak, LitLevel, SlowWords, Soft, WordGain
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.effects.views import Device
from nscc_runtime.emulator.capture import check_program
from nscc_runtime.planner import leak_nodes
from nscc_runtime.planner.by_lane import ByLane
from nscc_runtime.planner.masks import Masks
from nscc_runtime.planner.overlap import Overlap
from nscc_runtime.planner.pixels import Pixels
from nscc_runtime.planner.prices import Work
from nscc_runtime.planner.reach import Reach, reach_of
from nscc_runtime.planner.tables import Model, Tables
from nscc_runtime.reference.capture import Reference, readout_waits_s
from nscc_runtime.remembered import Recent, remembered

Values = NDArray[np.float64]

_RECENT = 6
"""Of what is kept for a chip: for planning, which pixels saturate, and three plans in turns."""
_EVEN = 1e-12
"""By what part weights may differ that are the same but for rounding."""


@dataclass(frozen=True, eq=False)
class Program:
    """A compiled program and a sensor, made ready once for any number of scenes and plans."""

    container: Container
    sensor: Sensor
    reference: Reference
    tables: Tables
    slot_s: Values

    @classmethod
    def of(cls, container: Container, sensor: Sensor) -> Program:
        """Raises Rejected where the words open no shutters (NS0442) or cannot run."""
        check_program(container)
        reference = Reference.of(container, sensor, everything())
        slot_s = np.array(container.slot_us, np.float64) * 1e-6
        return cls(container, sensor, reference, Tables.of(reference), slot_s)

    @cached_property
    def full(self) -> Model:
        """The weights with every effect on."""
        return self.model(everything())

    def model(self, kept: Selection) -> Model:
        """The weights under the effects of a plan, at the mean leakage."""
        gain, leak = kept.part(WordGain), kept.part(Leak)
        return Model(
            gain.gain(self.sensor) if gain else 1.0,
            1.0 / leak.tau_s(self.sensor) if leak else 0.0,
            kept.part(SlowWords) is not None,
            kept.part(Fading) is not None,
            kept.part(LitLevel) is not None,
        )

    @cached_property
    def less(self) -> dict[str, Model]:
        """The weights with every effect on but one, by its name."""
        names = (effect.name for effect in everything().effects)
        return {name: self.model(everything().without(name)) for name in names}

    @cached_property
    def by_lane(self) -> ByLane:
        """What the fields of effects are made of."""
        moving = everything().names(Leak) | everything().names(SlowWords)
        return ByLane(self.tables, self.slot_s, self.full, self.less, tuple(sorted(moving)))

    @cached_property
    def pixels(self) -> Pixels:
        """The words as they are, decayed."""
        return Pixels.of(self.reference)

    @cached_property
    def fresh_pixels(self) -> Pixels:
        """The words as they are meant."""
        return Pixels.of(replace(self.reference, words=self.tables.fresh))

    @cached_property
    def work(self) -> Work:
        """What a pixel has to do in the loop over words."""
        return Work.of(self.pixels, self.container.slots)

    def words(self, kept: Selection) -> Pixels:
        """The loop over the words of single pixels."""
        faded = self.model(kept).decay or not self.tables.decays
        return self.pixels if faded else self.fresh_pixels

    @cached_property
    def reach(self) -> Reach:
        """How far registers go with every effect on."""
        every = everything()
        return reach_of(self.tables, every, every.the(Soft).linear_e(self.sensor))

    @cached_property
    def lanes(self) -> NDArray[np.int32]:
        """The lane of every pixel, flat."""
        return self.reference.groups.lane.reshape(-1).astype(np.int32)

    @cached_property
    def places(self) -> NDArray[np.int64]:
        """Every pixel's place; not to be written to."""
        return np.arange(len(self.lanes), dtype=np.int64)

    @cached_property
    def open_part(self) -> NDArray[np.float32]:
        """The part (rows, cols) of the frame whose light each pixel sees."""
        part = self.slot_s @ self.tables.seen() / max(float(self.slot_s.sum()), 1e-300)
        return np.asarray(part[self.lanes].reshape(self.reference.groups.lane.shape), np.float32)

    @remembered
    def leak_error(self, count: int) -> Values:
        """The relative errors (buckets,) of sums at so many rates of leakage: values leak while
        they wait for their readout, too, which may take longer than the frame."""
        leak, ages_s = everything().the(Leak), self.slot_s.sum() + readout_waits_s(self.container)
        return np.array([leak_nodes.error(leak, self.sensor, count, age_s) for age_s in ages_s])

    @cached_property
    def all_single(self) -> bool:
        """Whether all charge reaches its bucket through one read: then sums can be clipped."""
        return not np.isnan(self.tables.single(self.full)).any()

    @cached_property
    def overlapping(self) -> bool:
        """Whether some slot is open in several buckets at once."""
        return any(group & (group - 1) for group in self.group_ids.tolist())

    @cached_property
    def group_ids(self) -> NDArray[np.int64]:
        """The groups of slots that occur."""
        return np.unique(self.reference.groups.of_slot)

    def device(self, device_seed: int) -> Device:
        """What is fixed on a chip; the last one asked for is kept."""
        if device_seed not in self._devices:
            self._devices.clear()
            self._devices[device_seed] = Device(
                sensor=self.sensor, device_seed=device_seed, places=self.places
            )
        return self._devices[device_seed]

    @cached_property
    def recent(self) -> Recent:
        """What was last worked out for some choice of effects."""
        return Recent(_RECENT)

    @cached_property
    def _devices(self) -> dict[int, Device]:
        return {}

    @remembered
    def overlap(self, model: Model, groups: tuple[int, ...]) -> Overlap:
        """How much of the neighbours' groups falls on a pixel's open slots; kept."""
        means = self.mean_weights(model)
        return Overlap.of(
            self.lanes.reshape(self.reference.groups.lane.shape),
            self.slot_s,
            self.tables.weights(model).slots,
            [(self.members(group), means[group]) for group in groups],
        )

    @remembered
    def masks(self, group: int) -> Masks | None:
        """Where each slot belongs to a group, pixel by pixel; kept. None: too large."""
        members = np.ascontiguousarray((self.reference.groups.of_slot == group).T)
        return Masks.of(members, self.lanes)

    def members(self, group: int) -> Values:
        """1 where a slot (N, lanes) belongs to a group."""
        return np.ascontiguousarray((self.reference.groups.of_slot == group).T, np.float64)

    @cached_property
    def read_part(self) -> float:
        """The largest part of a slot that has fallen on PIX when it is read there, as words take
        time."""
        entries = self.pixels.entries
        return min(1.0, float(entries["end"][entries["reads_pix"] > 0].max(initial=0.0)))

    @cached_property
    def read_parts(self) -> tuple[Values, Values]:
        """The sums (buckets, lanes) over reads of the squares of their coefficients times the part
        of a slot that has fallen since the slot began or PIX was reset: of reads of levels, which
        follow a reset between two slots, and of all others."""
        tables, entries = self.tables, self.pixels.entries
        reads = tables.weights(self.full).reads
        found = np.zeros((2, len(self.container.encoding), len(self.container.buckets)))
        reset_at, boundary = np.full(found.shape[1], np.nan), -1
        for word, entry in zip(tables.decayed, entries, strict=True):
            if word.boundary != boundary:
                reset_at[:], boundary = np.nan, word.boundary
            if word.resets:
                reset_at[word.lanes] = entry["end"]
            elif word.number in reads:
                level = ~np.isnan(reset_at)
                part = np.where(level, entry["end"] - reset_at, entry["end"])
                square = (reads[word.number] * np.minimum(part, 1.0)[:, None]) ** 2
                found[0] += square * level[:, None]
                found[1] += square * ~level[:, None]
        levels, others = found.swapaxes(1, 2)
        return levels, others

    @cached_property
    def level_part(self) -> Values:
        """The part (lanes,) of the frame whose charge PIX holds at some read though it is in no
        bucket: that of the levels that are subtracted."""
        seen = self.members(0) * self.tables.seen()
        return np.asarray(self.slot_s @ seen / max(float(self.slot_s.sum()), 1e-300))

    @cached_property
    def group_s(self) -> Values:
        """Of each group of slots the seconds (groups, 1 + 2 buckets, lanes): as they are, then by
        the weights of slots in the buckets, and by their squares."""
        weights = self.by_lane.full_weights
        parts = [np.ones_like(weights[0]), *weights, *(weights**2)]
        return np.array(
            [
                [self.slot_s @ (members * each) for each in parts]
                for members in map(self.members, self.group_ids.tolist())
            ]
        )

    @remembered
    def even_weights(self, model: Model) -> Values | None:
        """The weight (lanes, buckets) that all slots of a bucket have in a lane; None where some
        lane weighs them differently."""
        slots, found = self.tables.weights(model).slots, []
        for bucket in range(slots.shape[2]):
            members, weights = self.members(1 << bucket), slots[:, :, bucket]
            even = (members * weights).sum(axis=0) / np.maximum(members.sum(axis=0), 1.0)
            if (np.abs(weights - members * even) > _EVEN * np.abs(even)).any():
                return None
            found.append(even)
        return np.stack(found, axis=1)

    @remembered
    def mean_weights(self, model: Model) -> dict[int, Values]:
        """The mean weight (lanes, buckets) over the time of each group's slots; kept."""
        weights = self.tables.weights(model).slots
        found = {}
        for group in self.group_ids.tolist():
            time = self.members(group) * self.slot_s[:, None]
            total = time.sum(axis=0)[:, None]
            part = np.einsum("nl,nlb->lb", time, weights)
            found[group] = np.divide(part, total, out=np.zeros_like(part), where=total > 0)
        return found
