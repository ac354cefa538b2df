"""What the fields of effects on a sample are made of, for every lane of a program: nothing of it is
light, so all scenes have it in common."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

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

    @cached_property
    def weights(self) -> list[Values]:
        """The weights (N, lanes) of slots by every such model, bucket by bucket; then the squared
        ones of the full model, and the squares of what effects change of them."""
        models = [np.moveaxis(self.tables.weights(model).slots, 2, 0) for model in self._known]
        full = models[0]
        moved = [(full - models[self.row[name]]) ** 2 for name in self.moving]
        return [each for some in (*models, full**2, *moved) for each in some]

    @cached_property
    def seconds(self) -> Values:
        """The seconds (rows, buckets, lanes) of all of these weights."""
        found = np.array([self.slot_s @ each for each in self.weights])
        return found.reshape(self.squared_row + 1 + len(self.moving), -1, found.shape[1])

    @cached_property
    def count_e(self) -> Values:
        """What one count makes of an exposure (buckets, lanes), by the square of that: the third
        moment of counts by their variance."""
        square = self.seconds[self.squared_row]
        full = self.weights[: len(square)]
        cube = np.array([self.slot_s @ each**3 for each in full])
        return np.asarray(np.divide(cube, square, out=np.zeros_like(square), where=square > 0))

    @cached_property
    def most(self) -> Values:
        """The largest weight (buckets, lanes) of a slot."""
        return np.ascontiguousarray(self.tables.weights(self.full).slots.max(axis=0).T)

    @remembered
    def errors(self, at: str) -> tuple[Values, Values, Values]:
        """Of unit errors at `at`, (buckets, lanes) each: their variance at the mean leakage; twice
        their product with what faster leakage changes, and the square of that."""
        full, faster = (self.tables.numbered(at, each) for each in (self.full, self.faster))
        mean, product, square = np.zeros((3, *self.seconds.shape[1:]))
        for number, weight in full.items():
            by_rate = faster[number] - weight
            mean += (weight**2).T
            product += (2.0 * weight * by_rate).T
            square += (by_rate**2).T
        return mean, product, square

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
        full, less = (self.tables.numbered(at, each) for each in (self.full, self.less[name]))
        leaks = self.less[name].leak_per_s != self.full.leak_per_s
        faster = self.tables.numbered(at, self.faster) if leaks else full
        found = np.zeros((4, *self.seconds.shape[1:]))
        for number, weight in full.items():
            lost, by_rate = weight - less[number], faster[number] - weight
            more = weight**2 - less[number] ** 2
            found += np.stack([lost**2, 2.0 * lost * by_rate, by_rate**2, more]).swapaxes(1, 2)
        mean, product, square, more = found
        return mean, product, square, more
