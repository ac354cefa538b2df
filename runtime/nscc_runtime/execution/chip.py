"""Properties of a chip under a set of effects that do not depend on the scene."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.caches import remembered
from nscc_runtime.effects.parts import (
    Counted,
    CountedDark,
    CountedLight,
    Echo,
    Exchange,
    Leak,
    Response,
    Soft,
    Well,
    WordGain,
)
from nscc_runtime.effects.selection import Selection
from nscc_runtime.effects.views import LIGHT, WITHOUT_LIGHT, Device
from nscc_runtime.execution.overlap import weights_beside
from nscc_runtime.execution.pixel_array import PixelArray
from nscc_runtime.execution.program import AnalysedProgram

T = TypeVar("T")
Values = NDArray[np.float64]

_LEAK_SIGMAS = 4.0
"""Leakage rates within this number of standard deviations lie between the two nodes; one pixel in
ten thousand is outside."""


@dataclass(frozen=True, eq=False)
class SimulatedChip:
    """A program on the pixels `array` of one chip under the effects in `kept_effects`.
    `requested_effects` also contains the effects that the planner dropped: noise and patterns of
    words are weighted as under these effects, so that dropping an effect changes them least. Arrays
    are computed on demand and must not be modified."""

    program: AnalysedProgram
    array: PixelArray
    device_seed: int
    kept_effects: Selection
    requested_effects: Selection

    @property
    def device(self) -> Device:
        """The fixed patterns of the chip."""
        return self.array.device(self.program.sensor, self.device_seed)

    @property
    def factor(self) -> float:
        """Factor on all light due to lag, if the previous frame has the same light."""
        echo = self.kept_effects.find_part(Echo)
        return 1.0 + (0.0 if echo is None else echo.fraction(self.program.sensor))

    @cached_property
    def scale(self) -> Values:
        """Factor (pixels,) on the light of each pixel before photons are counted."""
        response = self.kept_effects.find_part(Response)
        if response is not None:
            return self.factor * self.device.fixed(response.factor)
        return np.full(self.array.lanes.size, self.factor)

    @cached_property
    def scale_32(self) -> NDArray[np.float32]:
        """`scale` in float32, for light with crosstalk."""
        return self.scale.astype(np.float32)

    @cached_property
    def exchanged(self) -> float:
        """Fraction of a pixel's charge that moves to each neighbour; 0 without crosstalk."""
        exchange = self.kept_effects.find_part(Exchange)
        return 0.0 if exchange is None else exchange.fraction(self.program.sensor)

    @cached_property
    def current(self) -> Values:
        """Dark current (pixels,) in electrons per second; 0 if the effect is not simulated."""
        dark_part = self.kept_effects.find_part(CountedDark)
        if dark_part is None:
            return np.zeros(self.array.lanes.size)
        return self.device.fixed(dark_part.per_s)

    @cached_property
    def counted(self) -> tuple[int, ...]:
        """Numbers of the groups of slots whose charge is drawn as counts; may be empty."""
        return () if self.kept_effects.find_part(Counted) is None else self.program.open_groups

    @cached_property
    def dark_rates(self) -> Values:
        """Mean dark charge (counted groups, pixels) in electrons."""
        seconds = map(self.program.group_seconds, self.counted)
        return np.array(
            [self.current * lane_seconds[self.array.flat_lanes] for lane_seconds in seconds]
        )

    @cached_property
    def leak_rates(self) -> tuple[float, ...]:
        """Leakage rates in 1/s for which sums are computed: (0,) without leakage.

        If the rate differs between pixels, there are two Chebyshev nodes, and sums are interpolated
        linearly between them. The error is the square of the spread of rate times age, a few parts
        in a million for the default sensor."""
        leak, sensor = self.kept_effects.find_part(Leak), self.program.sensor
        if leak is None:
            return (0.0,)
        mean, spread = 1.0 / leak.tau_s(sensor), leak.spread(sensor)
        if spread == 0.0:
            return (mean,)
        sigma = math.sqrt(math.log1p(spread**2))
        low, high = (
            mean * math.exp(side * _LEAK_SIGMAS * sigma - sigma**2 / 2) for side in (-1, 1)
        )
        away = (high - low) / 2 * math.sqrt(0.5)
        return (low + high) / 2 - away, (low + high) / 2 + away

    @cached_property
    def leak_weights(self) -> Values:
        """Weights (rates, pixels) that interpolate sums of `leak_rates` at each pixel's rate."""
        leak = self.kept_effects.find_part(Leak)
        if leak is None or len(self.leak_rates) == 1:
            return np.ones((1, 1))
        low, high = self.leak_rates
        upper = (self.device.fixed(leak.per_s) - low) / (high - low)
        return np.stack([1.0 - upper, upper])

    @cached_property
    def dark_e(self) -> Values | None:
        """Mean dark charge (buckets, pixels) without saturation; None without this effect."""
        if self.kept_effects.find_part(CountedDark) is None:
            return None
        exchange = self.kept_effects.find_part(Exchange)
        current = self.current
        if exchange is not None:
            by_row = current.reshape(self.array.shape)
            current = exchange.smeared(by_row, self.exchanged).reshape(-1)
        model = self.program.model(self.kept_effects)
        return np.asarray(current * self.program.open_seconds(model)[:, self.array.flat_lanes])

    @cached_property
    def patterns(self) -> Values:
        """Fixed errors (buckets, pixels) of the analog words in exposures, in electrons."""
        total: Values | float = 0.0
        for rate, weights in zip(self.leak_rates, self.leak_weights, strict=True):
            model = self.program.model(self.requested_effects)
            model = replace(model, leak_per_s=rate) if rate else model
            by_lane = self.program.tables.weights(model).error_sum.T
            total = total + by_lane[:, self.array.flat_lanes] * weights
        error_e = self.device.fixed(self.kept_effects.require_part(WordGain).error_e)
        return np.ascontiguousarray(total * error_e)

    @cached_property
    def own_weights(self) -> NDArray[np.float32]:
        """Mean weights (counted groups, buckets, pixels) of a pixel's counts in its exposures."""
        means = self.program.mean_weights(self.program.model(self.kept_effects))
        lanes, buckets = self.array.flat_lanes, len(self.program.container.buckets)
        weights = [means[group].T.astype(np.float32)[:, lanes] for group in self.counted]
        return np.array(weights, np.float32).reshape(-1, buckets, lanes.size)

    @cached_property
    def beside_weights(self) -> NDArray[np.float32]:
        """Weights (counted groups, 4, buckets, pixels) of neighbours' counts in a pixel's
        exposures. The neighbours are above, below, left and right."""
        program, model = self.program, self.program.model(self.kept_effects)
        buckets = len(program.container.buckets)
        return self.array.recent.of(
            ("beside", model),
            lambda: weights_beside(program.overlaps(model), buckets, self.array.lanes),
        )

    @cached_property
    def sources(self) -> list[tuple[int, int]]:
        """Sources of counts as pairs: random stream of the effect, source number."""
        lit = [(effect.stream, LIGHT) for effect, _ in self.kept_effects.having(CountedLight)]
        dark = [
            (effect.stream, WITHOUT_LIGHT) for effect, _ in self.kept_effects.having(CountedDark)
        ]
        return lit + dark

    @cached_property
    def noise(self) -> tuple[list[tuple[int, int]], Values]:
        """(stream, draw number) of small errors, and their standard deviations (draws, buckets,
        lanes)."""
        program, full_model = self.program, self.program.model(self.requested_effects)
        draws, sigmas = [], []
        for effect, error_part in self.kept_effects.errors():
            factor, _ = program.tables.noise(error_part.at, full_model)
            factor = error_part.sigma_e(program.sensor) * factor
            for draw in range(factor.shape[2]):
                if factor[:, :, draw].any():
                    draws.append((effect.stream, draw))
                    sigmas.append(factor[:, :, draw].T)
        shape = len(draws), len(program.container.buckets), len(program.container.encoding)
        return draws, np.ascontiguousarray(np.array(sigmas).reshape(shape))

    @cached_property
    def saturation_e(self) -> Values:
        """Smallest charge (kinds, lanes) in electrons with which a pixel may saturate; infinity
        where it cannot. The first kind is PIX; the others are kinds of register content
        (`execution.register_reach`)."""
        program, reach = self.program, self.program.reach
        well, soft = self.kept_effects.find_part(Well), self.kept_effects.find_part(Soft)
        kinds = 1 if reach.held_weights is None else 1 + len(reach.held_weights)
        least_e = np.full((kinds, len(program.container.encoding)), np.inf)
        if well is not None:
            least_e[0] = well.full_e(program.sensor)
        if soft is not None and reach.held_weights is None:
            np.minimum(least_e, reach.least_e, out=least_e)
        elif soft is not None:
            least_e[1:] = reach.least_e
        return least_e

    @remembered
    def compute_once(self, make: Callable[[SimulatedChip], T]) -> T:
        """Return `make(self)`, cached."""
        return make(self)


def chip_of(
    program: AnalysedProgram,
    device_seed: int,
    kept_effects: Selection,
    requested_effects: Selection,
) -> SimulatedChip:
    """Return the whole chip under these effects; it is cached with the program."""
    return program.recent_chips.of(
        (SimulatedChip, device_seed, kept_effects.on, requested_effects.on),
        lambda: SimulatedChip(program, program.array, device_seed, kept_effects, requested_effects),
    )
