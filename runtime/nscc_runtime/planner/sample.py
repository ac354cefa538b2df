"""A sample of the pixels of a scene, on which a plan's predictions are made.

Errors grow with light and with its differences between neighbours, and a few lamps may carry most
of them: pixels are drawn in proportion to both, half of the sample, and evenly, the other half.
Pixels that may saturate are a stratum of their own, and those of them that see most another: a few
suns may lose what no other pixel does. What a pixel stands for makes up for how likely it was to be
drawn, so that means over the sample are those of the array.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.planner.sample_loop import Array, Drawing, draw, scores

_MOST_PIXELS = 1024
_FEWEST_PIXELS = 512
_MOST_SAMPLES = 1 << 16
"""Frames x pixels, above the fewest pixels."""
_MOST_NEAR = 512
"""Pixels near saturation: running them through their words is dear."""
_BRIGHTEST = 20
"""Of them, how many are the brightest, which stand for themselves alone."""
_GOLDEN = 0.6180339887498949


@dataclass(frozen=True, eq=False)
class Sample:
    """Places row * cols + col, how many pixels each stands for, and which may saturate."""

    places: NDArray[np.int64]
    weight: NDArray[np.float64]
    near: NDArray[np.bool_]

    def mean(self, values: NDArray[np.float64]) -> NDArray[np.float64]:
        """The mean over the whole array of values (.., pixels) at the places."""
        return np.asarray(values @ self.weight / self._pixels)

    def error(self, values: NDArray[np.float64]) -> NDArray[np.float64]:
        """The standard error of such a mean: a sample is not the scene."""
        away = (values - self.mean(values)[..., None]) * self._by_chance
        return np.asarray(np.sqrt((away**2).sum(axis=-1)) / self._pixels)

    def spread(self, sigma: NDArray[np.float64]) -> NDArray[np.float64]:
        """The standard deviation over frames of the mean over the array, where the pixels have
        these (.., pixels), each by itself."""
        return np.asarray(np.sqrt(sigma**2 @ self.weight) / self._pixels)

    @cached_property
    def _pixels(self) -> float:
        """How many pixels the sample stands for."""
        return float(self.weight.sum())

    @cached_property
    def _by_chance(self) -> NDArray[np.float64]:
        """What pixels stand for as far as chance has a part in that: one that was sure to be drawn
        stands for itself alone."""
        return self.weight * np.sqrt(1.0 - 1.0 / np.maximum(self.weight, 1.0))


def sample_of(
    total_e: NDArray[np.float64],
    frames: int,
    near: NDArray[np.int64],
    spilt: NDArray[np.int64] | None = None,
    seen_e: NDArray[np.float64] | None = None,
    surely: NDArray[np.int64] | None = None,
) -> Sample:
    """A sample of a scene of that many frames; the same on every call.

    `total_e` (rows, cols): all the light of each pixel. `near`: the places of pixels that may
    saturate, in order; `spilt`, in order: those among them that neighbours' light brings there. A
    few of these may lose more than all others, so they are a stratum beside the rest of `near`, and
    so are those of `near` that see most: `seen_e`, by default all their light. Of the other pixels
    those at `surely` stand for themselves.
    """
    pixels = total_e.size
    wanted = min(max(_MOST_SAMPLES // frames, _FEWEST_PIXELS), _MOST_PIXELS, pixels)
    alone = np.empty(0, np.int64) if surely is None else surely
    never = np.append(near, alone)
    chance = chances(total_e, never).reshape(-1)
    if wanted < pixels and len(never) < pixels:
        places, weight = weighed(chance, wanted, pixels - len(never))
    else:
        places = np.delete(np.arange(pixels), never)
        weight = np.ones(len(places))
    places, weight = np.append(places, alone), np.append(weight, np.ones(len(alone)))
    far = len(places)
    if not len(near):
        return Sample(places, weight, np.zeros(far, np.bool_))
    strata = np.zeros(len(near), np.int8)
    if spilt is not None:
        strata[np.searchsorted(near, spilt)] = 1
    strata[brightest(total_e.reshape(-1)[near] if seen_e is None else seen_e)] = -1
    for stratum in (near[strata == number] for number in (-1, 0, 1)):
        some = stratum
        if len(some) > _MOST_NEAR - _BRIGHTEST:
            some = drawn_evenly(some, _MOST_NEAR - _BRIGHTEST)
        weight = np.append(weight, np.full(len(some), len(stratum) / max(1, len(some))))
        places = np.append(places, some)
    return Sample(places.astype(np.int64), weight, np.arange(len(places)) >= far)


def brightest(light_e: NDArray[np.float64]) -> NDArray[np.intp]:
    """Where there is most light, in order: `_BRIGHTEST` of these pixels (pixels,), or all."""
    if len(light_e) <= _BRIGHTEST:
        return np.arange(len(light_e))
    # By their values, as places of equal ones are partitioned otherwise on another processor.
    least = np.partition(light_e, -_BRIGHTEST)[-_BRIGHTEST]
    above, equal = np.flatnonzero(light_e > least), np.flatnonzero(light_e == least)
    return np.sort(np.append(above, equal[: _BRIGHTEST - len(above)]))


def drawn_by(chance: NDArray[np.float64], wanted: int) -> NDArray[np.intp]:
    """So many places, in order, as likely as `chance` (flat) has it; the same on every call."""
    found = np.empty(wanted, np.int64)
    draw(
        drawing=Drawing(pixels=len(chance), wanted=wanted), chance=chance, points=_points(wanted),
        drawn=found,
    )  # fmt: skip
    return found


def weighed(
    chance: NDArray[np.float64], wanted: int, pixels: int
) -> tuple[NDArray[np.intp], NDArray[np.float64]]:
    """About so many places, each once, in order, and how many of the `pixels` each stands for: the
    likelier it was, the fewer."""
    drawn = drawn_by(chance, wanted)
    first = np.flatnonzero(np.diff(drawn, prepend=-1))
    places, count = drawn[first], np.diff(first, append=len(drawn))
    weight = count / chance[places]
    return places, weight * (pixels / max(weight.sum(), 1e-300))


def drawn_evenly(places: NDArray[np.int64], wanted: int) -> NDArray[np.int64]:
    """About so many of these places, each at most once, in order; the same on every call."""
    drawn = drawn_by(np.ones(len(places)), wanted)
    return places[drawn[np.diff(drawn, prepend=-1) > 0]]


def among(places: NDArray[np.int64], some: NDArray[np.int64], pixels: int) -> NDArray[np.bool_]:
    """Which of these places of an array are among some of them."""
    found = np.zeros(pixels, np.bool_)
    found[some] = True
    return found[places]


@lru_cache(64)
def _points(wanted: int) -> NDArray[np.float64]:
    """One in each of so many equal strata, by an additive recurrence: in step with no tile of
    codes."""
    return np.arange(wanted) + (np.arange(wanted) * _GOLDEN) % 1.0


def chances(
    total_e: NDArray[np.float64], never: NDArray[np.int64] | None = None
) -> NDArray[np.float64]:
    """How likely each pixel (rows, cols) is to be drawn, up to a factor; those of the places
    `never` are not, and the light of suns among them does not make the others all alike."""
    rows, cols = total_e.shape
    score = np.empty((rows, cols))
    scores(array=Array(rows=rows, cols=cols), light=total_e, score=score)
    flat, count = score.reshape(-1), total_e.size
    if never is not None:
        flat[never] = 0.0
        count -= len(never)
    mean = flat.sum() / max(count, 1)
    flat += mean if mean > 0 else 1.0
    if never is not None:
        flat[never] = 0.0
    return score
