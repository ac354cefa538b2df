"""What the fields of effects on a sample are made of, for every lane of a program: nothing of it is
light, so all scenes have it in common."""

from __future__ import annotations

from collections.abc import Hashable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.light import Light
from nscc_runtime.planner.sums import MOST_KEPT, frame_tables
from nscc_runtime.planner.tables import Model, Tables
from nscc_runtime.remembered import remembered

Values = NDArray[np.float64]

LEAK_STEP = 0.1
"""By what part leakage is faster where it is asked what rates of leakage do."""


@dataclass(frozen=True, eq=False)
class ByLane:
    """A program's words with every effect (`full`), and with every effect but one, by its name;
    `moving` are those of which the counts are asked that they move."""

    tables: Tables
    slot_s: Values
    full: Model
    less: Mapping[str, Model]
    moving: tuple[str, ...]

    @cached_property
    def faster(self) -> Model:
        """With leakage that is faster by `LEAK_STEP`."""
        return replace(self.full, leak_per_s=self.full.leak_per_s * (1 + LEAK_STEP))

    @cached_property
    def _known(self) -> list[Model]:
        """Every model of the words that an effect may ask for, each once, the full one first."""
        models = [self.full, self.faster, *self.less.values()]
        return list(dict.fromkeys(self.tables.same(model) for model in models))

    @cached_property
    def row(self) -> dict[str, int]:
        """Which of these is without an effect, by its name."""
        return {name: self._row(model) for name, model in self.less.items()}

    @cached_property
    def faster_row(self) -> int:
        """Which of these has faster leakage."""
        return self._row(self.faster)

    def _row(self, model: Model) -> int:
        return self._known.index(self.tables.same(model))

    @property
    def squared_row(self) -> int:
        """Which row has the squared weights of the full model."""
        return len(self._known)

    def moved_row(self, name: str) -> int:
        """Which row has the squares of what one of those that are `moving` changes."""
        return len(self._known) + 1 + self.moving.index(name)

    def weights(self, used: NDArray[np.int64] | None = None) -> Iterator[Values]:
        """The weights (buckets, N, lanes) of slots by every such model; then the squared ones of
        the full model, and the squares of what effects change of them. Of the lanes that are
        `used`, or of all. Made when they are come to: of long frames all are hundreds of MB."""
        yield from (self._slots(model, used) for model in self._known)
        full = self._slots(self.full, used)
        yield full**2
        for name in self.moving:
            yield (full - self._slots(self.less[name], used)) ** 2

    def _slots(self, model: Model, used: NDArray[np.int64] | None) -> Values:
        found = np.moveaxis(self.tables.weights(model).slots, 2, 0)
        return found if used is None else found.take(used, axis=2)

    def on_frames(self, light: Light) -> Values | None:
        """The same weights (rows, T, lanes) of a light's frames, kept for all of one timing; None:
        too large to be kept."""
        if self.seconds[:, :, :1].size * len(light.frames) * self.seconds.shape[2] > MOST_KEPT:
            return None
        found = self._on_frames.get(light.timing)
        if found is None:
            found = np.concatenate([frame_tables(light, [*some]) for some in self.weights()])
            self._on_frames.clear()
            self._on_frames[light.timing] = found
        return found

    @cached_property
    def _on_frames(self) -> dict[Hashable, Values]:
        return {}

    @cached_property
    def full_weights(self) -> Values:
        """The weights (buckets, N, lanes) of slots by the full model."""
        return np.ascontiguousarray(self._slots(self.full, None))

    @cached_property
    def seconds(self) -> Values:
        """The seconds (rows, buckets, lanes) of all of these weights."""
        return np.array([[self.slot_s @ each for each in some] for some in self.weights()])

    @cached_property
    def count_e(self) -> Values:
        """What one count makes of an exposure (buckets, lanes), by the square of that: the third
        moment of counts by their variance."""
        square = self.seconds[self.squared_row]
        cube = np.array([self.slot_s @ each**3 for each in self.full_weights])
        return np.asarray(np.divide(cube, square, out=np.zeros_like(square), where=square > 0))

    @cached_property
    def most(self) -> Values:
        """The largest weight (buckets, lanes) of a slot."""
        return np.ascontiguousarray(self.tables.weights(self.full).slots.max(axis=0).T)

    @remembered
    def errors(self, at: str) -> tuple[Values, Values, Values]:
        """Of unit errors at `at`, (buckets, lanes) each: their variance at the mean leakage; twice
        their product with what faster leakage changes, and the square of that."""
        mean, product, square = np.zeros((3, *self.seconds.shape[1:]))
        for weight, faster in self._numbered(at, self.full, self.faster):
            by_rate = faster - weight
            mean += weight**2
            product += 2.0 * weight * by_rate
            square += by_rate**2
        return mean, product, square

    def _numbered(self, at: str, *models: Model) -> Iterator[list[Values]]:
        """The coefficients (buckets, lanes) of each numbered error under models of the words; a
        word whose error cancels under one of them has none there."""
        found = [self.tables.numbered(at, model) for model in models]
        none = np.zeros(self.seconds.shape[:0:-1])
        for number in sorted(set().union(*found)):
            yield [each.get(number, none).T for each in found]

    @remembered
    def errors_cut(self, at: str) -> tuple[Values, Values, Values]:
        """The same of what is left out where they are drawn as at the mean leakage."""
        mean, product, square = self.errors(at)
        drawn = self.tables.noise(at, self.full)[0]
        by_rate = self.tables.noise(at, self.faster)[0] - drawn
        mean = mean - (drawn**2).sum(axis=2).T
        return mean, product - (2.0 * drawn * by_rate).sum(axis=2).T, square

    @remembered
    def reweighed(self, at: str, name: str) -> tuple[Values, Values, Values, Values]:
        """Of unit errors, (buckets, lanes) each: the variance of what they change by without an
        effect, at the mean leakage; twice its product with what faster leakage changes, and the
        square of that; and by how much their own variance is larger with the effect."""
        less = self.less[name]
        leaks = less.leak_per_s != self.full.leak_per_s
        faster = self.faster if leaks else self.full
        found = np.zeros((4, *self.seconds.shape[1:]))
        for weight, without, rate in self._numbered(at, self.full, less, faster):
            lost, by_rate = weight - without, rate - weight
            found += np.stack([lost**2, 2.0 * lost * by_rate, by_rate**2, weight**2 - without**2])
        mean, product, square, more = found
        return mean, product, square, more
