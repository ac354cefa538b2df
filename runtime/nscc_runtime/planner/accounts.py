"""What may be wrong with a sample of a scene's pixels, by name, and what any of it makes together.

It is laid out once, so that each of many choices is a product of small matrices.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.planner.sample import Sample

Values = NDArray[np.float64]


class Errors(NamedTuple):
    """What is wrong with each of a sample's pixels, (buckets, pixels) each: its mean, its variance,
    and the third moment about the mean, in electrons and their squares and cubes."""

    mean: Values
    variance: Values
    third: Values


@dataclass(frozen=True, eq=False)
class Account:
    """Errors of a sample's pixels, (buckets, pixels) each, in electrons: of the `fixed` ones fields
    that add up with their signs, of the `random` ones variances, and of those of these that are
    `skewed` third moments.
    """

    sample: Sample
    buckets: int
    fixed: Mapping[str, Values]
    random: Mapping[str, Values]
    skewed: Mapping[str, Values] = field(default_factory=dict)

    def square(self, fixed: Collection[str], random: Collection[str]) -> Values:
        """The mean square (buckets,) over the array of some of them."""
        inside = _inside(self.fixed, fixed)
        # Rounding takes what cancels below 0.
        squares = np.maximum(self._products @ inside @ inside, 0.0)
        return np.asarray(squares + self.variance(random))

    def most(self, fixed: Collection[str], random: Collection[str]) -> Values:
        """The most that it can be: where all fixed errors add up."""
        squares = np.maximum(np.diagonal(self._products, axis1=1, axis2=2), 0.0)
        sizes = np.sqrt(squares) @ _inside(self.fixed, fixed)
        return np.asarray(sizes**2 + self.variance(random))

    def variance(self, random: Collection[str]) -> Values:
        """The mean variance (buckets,) over the array of some of them."""
        return np.asarray(_inside(self.random, random) @ self._variances)

    def errors(self, fixed: Collection[str], random: Collection[str]) -> Errors:
        """Some of them together, pixel by pixel."""
        mean = self._fixed[[at for at, name in enumerate(self.fixed) if name in fixed]]
        variance = self._random[[at for at, name in enumerate(self.random) if name in random]]
        third = np.zeros(mean.shape[1:])
        for name in self.skewed.keys() & {*random}:
            third += self.skewed[name]
        return Errors(np.asarray(mean.sum(axis=0)), np.asarray(variance.sum(axis=0)), third)

    def own(self, name: str) -> tuple[Values, Values]:
        """The mean square (buckets,) over the array of one effect's errors, and their mean."""
        square, bias = np.zeros((2, self.buckets))
        if name in self.fixed:
            at = [*self.fixed].index(name)
            square, bias = self._products[:, at, at], self._means[at]
        return square + self.variance((name,)), bias

    @cached_property
    def _fixed(self) -> Values:
        return self._laid_out(self.fixed)

    @cached_property
    def _random(self) -> Values:
        return self._laid_out(self.random)

    @cached_property
    def _means(self) -> Values:
        """Of the fixed errors, (fixed, buckets)."""
        return self.sample.mean(self._fixed)

    @cached_property
    def _products(self) -> Values:
        """The means (buckets, fixed, fixed) of the products of any two."""
        weight = self.sample.weight
        weighed = self._fixed * (weight / weight.sum())
        return np.asarray(weighed.transpose(1, 0, 2) @ self._fixed.transpose(1, 2, 0))

    @cached_property
    def _variances(self) -> Values:
        """(random, buckets)."""
        return self.sample.mean(self._random)

    def _laid_out(self, errors: Mapping[str, Values]) -> Values:
        """(errors, buckets, pixels)."""
        shape = len(errors), self.buckets, len(self.sample.places)
        return np.array([*errors.values()]).reshape(shape)


def _inside(names: Collection[str], some: Collection[str]) -> Values:
    """1 for those of the names that are among these, else 0."""
    return np.array([name in some for name in names], np.float64)
