"""Moments of frames without saturation: means, variances and covariances that the words cause.

Without saturation an exposure is a weighted sum of the charge of slots and of the errors of words,
so its mean and its covariance over buckets are weighted sums of light. `scene_moments` computes
them once for a scene; `nscc_runtime.execution.summed` draws frames from them."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from nscc.arrays import Floats, Floats32, Ints, Ints32
from nscc_runtime.effects import Selection
from nscc_runtime.effects.parts import (
    Counted,
    CountedDark,
    CountedLight,
    Echo,
    Exchange,
    Leak,
    Response,
    WordGain,
)
from nscc_runtime.effects.views import Device
from nscc_runtime.execution.moment_loop import Completing, complete_moments
from nscc_runtime.execution.overlap import MOST_EXCHANGED, NEIGHBOURS, weights_beside
from nscc_runtime.execution.program import AnalysedProgram, light_under
from nscc_runtime.execution.sum_loop import light_sums
from nscc_runtime.light import Light
from nscc_runtime.pool import in_parts
from nscc_runtime.reference.weights import WeightModel

_LEAK_SIGMAS = 4.0
"""Two nodes are placed for leakage rates within this number of standard deviations."""
_ALL_SIGMAS = 6.0
"""No pixel leaks at a rate farther than this number of standard deviations from the mean."""
_SMALL_LEAK = 2.5e-3
"""Two nodes are enough if the decay of a frame differs by at most this part between pixels."""
_MOST_LEAK = 0.03
"""A pixel whose decay in a frame differs by more than this part from the mean runs its words."""


@dataclass(frozen=True, eq=False)
class Moments:
    """The distribution of a scene's frames without saturation.

    A frame is the sum of `mean_e`, deviations of Poisson counts, deviations of neighbours, and
    normal errors. The deviations are those from the means `count_means`, times `own_weights`. There
    is one Poisson count and one normal number for each pixel and bucket.

    Attributes
    ----------
    mean_e : float64, shape (buckets, pixels)
        Mean exposures in electrons, with fixed errors of words.
    count_means : float64, shape (count_draws, pixels)
        Means of the Poisson counts of light and dark charge; one draw for each bucket, none if the
        effects count no electrons.
    own_weights : float32, shape (count_draws, buckets, pixels)
        Electrons in each bucket for one count of the pixel.
    neighbour_weights : float32, shape (count_draws, 4, buckets, pixels)
        Electrons that arrive for one count of the neighbour above, below, left or right, before
        the fraction `exchanged`; (1,) without crosstalk.
    exchanged : float
        Fraction of a pixel's charge that moves to each neighbour.
    error_e : float64, shape (error_draws, buckets, lanes)
        Errors of words in each bucket for one normal number.
    lane : int32, shape (rows, cols)
        The number of each pixel's lane (the pixels of one distinct shutter).
    """

    mean_e: Floats
    count_means: Floats
    own_weights: Floats32
    neighbour_weights: Floats32
    exchanged: float
    error_e: Floats
    lane: Ints32


def scene_moments(
    program: AnalysedProgram, light: Light, effects: Selection, device_seed: int, threads: int = 1
) -> Moments:
    """Return the moments of a scene's frames under some effects.

    Parameters
    ----------
    program : AnalysedProgram
    light : Light
        The light of the whole array.
    effects : Selection
    device_seed : int
        Seed of the fixed patterns.
    threads : int
        Results do not depend on it.

    Returns
    -------
    Moments
    """
    chip, exchanged = on_chip(program, effects, device_seed), exchanged_fraction(effects, program)
    lit, source = effects.find_part(CountedLight) is not None, light_under(effects, light)
    weights = program.slot_weights(program.model(effects), chip.leak_rates, lit)
    sums = light_sums(
        source,
        program.lanes,
        chip.factor,
        weights,
        weights.pairs if exchanged else len(weights.slots),
        exchanged,
        threads,
    )
    return _completed(chip, sums, source, weights.pairs, exchanged, threads)


@dataclass(frozen=True, eq=False)
class _ChipMoments:
    """The part of the moments that all scenes share on a chip under some effects.

    `leak_rates`: the leakage rates of sums. `rate_weights` (rates, pixels): weights that
    interpolate sums at each pixel's rate. `factor` (pixels,): factor on the light.
    `fixed_e` (buckets, pixels): dark charge and fixed errors of words in exposures. `dark_e2`
    (pairs, pixels): covariances of a pixel's dark counts; no pairs without. `dark_e` (pixels,):
    dark charge of a frame. `electron_weights` (buckets, pixels): a count of draw b weighs as much
    as an electron in bucket b, averaged over its open time, so exposures of dim light are multiples
    of it. `own_weights`: see `Moments`; None if it depends on the light. `unknown` (4, buckets,
    pixels): the variance for each electron of a neighbour in a frame that does not follow from the
    neighbour's draws.
    `neighbour_weights`, `error_e`, `lane`: see `Moments`. `uneven` (count,): places of the pixels
    that leak too unlike most for sums, ascending. `most_factor`, `most_dark_e`: the largest
    `factor` and `dark_e`."""

    leak_rates: tuple[float, ...]
    rate_weights: Floats32
    factor: Floats32
    fixed_e: Floats32
    dark_e2: Floats32
    dark_e: Floats32
    electron_weights: Floats32
    own_weights: Floats32 | None
    unknown: Floats32
    neighbour_weights: Floats32
    error_e: Floats
    lane: Ints32
    uneven: Ints
    most_factor: float
    most_dark_e: float


def on_chip(program: AnalysedProgram, effects: Selection, device_seed: int) -> _ChipMoments:
    """Return the moments that all scenes on a chip share, cached with the program by the effects
    that are on and the seed of the fixed patterns. Callers must not change the arrays."""

    def make() -> _ChipMoments:
        """Compute everything about the moments that depends on the chip and the effects but not on
        the light. `own_weights` is None if buckets overlap: then it depends on the light."""
        device, model = program.device(device_seed), program.model(effects)
        rates = leak_rates(program, effects)
        rate_weights = _rate_weights(effects, device, rates)
        factor, lanes = light_factor(effects, device).astype(np.float32), program.lanes
        electron_weights = _electron_weights(program, model).take(lanes, axis=1)
        buckets, exchanged = len(electron_weights), exchanged_fraction(effects, program)
        beside, unknown = np.zeros(1, np.float32), np.zeros((4, buckets, lanes.size))
        if exchanged and effects.names(Counted):
            beside, unknown = _neighbour_weights(program, model)
        # The weights of a pixel's own counts: none without counts, or fixed if buckets never
        # overlap.
        own_weights = None
        if not effects.names(Counted):
            own_weights = np.zeros((0, buckets, lanes.size), np.float32)
        elif not program.buckets_overlap(model):
            own_weights = np.zeros((buckets, buckets, lanes.size), np.float32)
            own_weights[range(buckets), range(buckets)] = electron_weights
        fixed_e = _fixed_e(program, effects, device, rates, rate_weights)
        dark_e = (dark_e_per_s(effects, device) * program.slot_s.sum()).astype(np.float32)
        return _ChipMoments(
            rates,
            rate_weights.astype(np.float32),
            factor,
            fixed_e.astype(np.float32),
            _dark_covariances(program, effects, device).astype(np.float32),
            dark_e,
            electron_weights.astype(np.float32),
            own_weights,
            (exchanged**2 * unknown).astype(np.float32),
            beside,
            _word_errors(program, effects),
            program.lane,
            _uneven_leakage(program, effects, device),
            float(factor.max()),
            float(dark_e.max()),
        )

    chip: _ChipMoments = program.recent.of((_ChipMoments, effects.on, device_seed), make)
    return chip


def _completed(
    chip: _ChipMoments,
    sums: Floats,
    light: Light,
    light_pairs: int,
    exchanged: float,
    threads: int,
) -> Moments:
    """Return the moments (means and covariances) of a scene's frames with `light`: those of `chip`,
    which all scenes share, completed by those that depend on the light.

    `sums` (sums, pixels): weighted sums of the light, from `light_sums`. The first `light_pairs` of
    them belong to pairs of buckets; 0 if light is not counted. The others belong to buckets and
    leakage rates. `exchanged`: fraction of its charge that a pixel gives to each neighbour. Results
    do not depend on the number of `threads`."""
    buckets, pixels = chip.fixed_e.shape
    # Without light or dark charge that is counted, nothing is drawn.
    draws = buckets if light_pairs or len(chip.dark_e2) else 0
    mean_e, count_means = np.empty((buckets, pixels)), np.empty((draws, pixels))
    own_weights = chip.own_weights
    if own_weights is None:
        own_weights = np.empty((draws, buckets, pixels), np.float32)

    def run(begin: int, end: int) -> None:
        """Complete the moments of the rows from `begin` up to before `end`, in place."""
        complete_moments(
            sizes=Completing(
                begin=begin,
                end=end,
                rows=light.shape[0],
                cols=light.shape[1],
                pixels=pixels,
                buckets=buckets,
                rates=len(chip.leak_rates),
                light_pairs=light_pairs,
                dark_pairs=len(chip.dark_e2),
                exchanges=exchanged > 0.0,
                overlaps=chip.own_weights is None,
            ),
            sums=sums,
            rate_weights=chip.rate_weights,
            fixed_e=chip.fixed_e,
            dark_e2=chip.dark_e2,
            sum_e=light.sum_e,
            factor=chip.factor,
            dark_e=chip.dark_e,
            unknown=chip.unknown,
            electron_weights=chip.electron_weights,
            covariance_e2=np.empty(buckets * (buckets + 1) // 2 * light.shape[1]),
            frame_e=np.empty(3 * light.shape[1]),
            mean_e=mean_e,
            count_means=count_means,
            own_weights=own_weights,
        )

    in_parts(run, light.shape[0], threads)
    of_chip = chip.neighbour_weights, exchanged, chip.error_e, chip.lane
    return Moments(mean_e, count_means, own_weights, *of_chip)


def exchanged_fraction(effects: Selection, program: AnalysedProgram) -> float:
    """Return the fraction of a pixel's charge that moves to each neighbour; 0 without crosstalk."""
    exchange = effects.find_part(Exchange)
    return 0.0 if exchange is None else exchange.fraction(program.sensor)


def exchanges_much(effects: Selection, program: AnalysedProgram) -> bool:
    """Return whether neighbours exchange so much counted charge under `effects` that sums would
    give wrong variances and covariances. All pixels then run through their words."""
    return bool(effects.names(Counted)) and exchanged_fraction(effects, program) > MOST_EXCHANGED


def light_factor(effects: Selection, device: Device) -> Floats:
    """Return the factor (pixels,) on the light of each pixel: 1 plus the lag of an equal previous
    frame, times the pixel's response; 1 if neither effect is on."""
    echo, response = effects.find_part(Echo), effects.find_part(Response)
    factor = 1.0 if echo is None else 1.0 + echo.fraction(device.sensor)
    if response is None:
        return np.full(len(device.places), factor)
    return factor * device.fixed(response.factor)


def dark_e_per_s(effects: Selection, device: Device) -> Floats:
    """Return the dark current of each pixel in electrons per second, (pixels,); 0 if the effect is
    not on."""
    dark = effects.find_part(CountedDark)
    return np.zeros(len(device.places)) if dark is None else device.fixed(dark.per_s)


def leak_rates(program: AnalysedProgram, effects: Selection) -> tuple[float, ...]:
    """Return leakage rates in 1/s, ascending, for which sums are computed: (0,) without leakage.

    If the rate differs between pixels, sums are interpolated between two or three Chebyshev nodes.
    The error is at most about 1e-6 of the charge (`_SMALL_LEAK`, `_MOST_LEAK`)."""
    leak = effects.find_part(Leak)
    if leak is None:
        return (0.0,)
    mean = 1.0 / leak.tau_s(program.sensor)
    sigma = math.sqrt(math.log1p(leak.spread(program.sensor) ** 2))
    low, high = (mean * math.exp(side * _LEAK_SIGMAS * sigma - sigma**2 / 2) for side in (-1, 1))
    if (high - low) / 2 * program.oldest_s > _SMALL_LEAK:
        away = _MOST_LEAK / program.oldest_s * math.sqrt(0.75)
        return mean - away, mean, mean + away
    away = (high - low) / 2 * math.sqrt(0.5)
    nodes = (low + high) / 2 - away, (low + high) / 2 + away
    # Without a spread, or with one that float64 cannot represent, both nodes are equal.
    return nodes if nodes[0] < nodes[1] else (mean,)


def even_leak_rates(program: AnalysedProgram, effects: Selection) -> tuple[float, ...]:
    """Return the lowest and the highest leakage rate in 1/s of pixels that sums expose; (0,)
    without leakage."""
    leak = effects.find_part(Leak)
    if leak is None:
        return (0.0,)
    mean, away = 1.0 / leak.tau_s(program.sensor), _MOST_LEAK / program.oldest_s
    sigma = math.sqrt(math.log1p(leak.spread(program.sensor) ** 2))
    low, high = (mean * math.exp(side * _ALL_SIGMAS * sigma - sigma**2 / 2) for side in (-1, 1))
    return max(low, mean - away), min(high, mean + away)


def _uneven_leakage(program: AnalysedProgram, effects: Selection, device: Device) -> Ints:
    """Return the places (count,) of the pixels whose leakage differs too much for sums, ascending.

    Sums take the noise at the mean rate, so it is wrong by up to `_MOST_LEAK` in other pixels."""
    leak = effects.find_part(Leak)
    if leak is None:
        return np.empty(0, np.int64)
    away = device.fixed(leak.per_s) - 1.0 / leak.tau_s(program.sensor)
    return np.flatnonzero(np.abs(away) * program.oldest_s > _MOST_LEAK)


def _rate_weights(effects: Selection, device: Device, rates: tuple[float, ...]) -> Floats:
    """Return weights (rates, pixels) with which sums at the `rates` of leakage (1/s, `leak_rates`)
    are added up to those at each pixel's own rate: Lagrange polynomials, which add up to 1."""
    leak = effects.find_part(Leak)
    weights = np.ones((len(rates), len(device.places)))
    own = weights[0] if leak is None else device.fixed(leak.per_s)
    for i, rate in enumerate(rates[1:], 1):
        for other in rates[:i] + rates[i + 1 :]:
            weights[i] *= (own - other) / (rate - other)
    weights[0] -= weights[1:].sum(axis=0)
    return weights


def _fixed_e(
    program: AnalysedProgram,
    effects: Selection,
    device: Device,
    rates: tuple[float, ...],
    rate_weights: Floats,
) -> Floats:
    """Return the part of mean exposures that does not depend on the light, in electrons (buckets,
    pixels): dark charge and fixed errors of words; 0 if neither effect is on.

    `device`: the fixed patterns of all pixels. `rates`: the rates of leakage (1/s) at which sums
    are computed. `rate_weights` (rates, pixels): weights that give the sum at each pixel's rate."""
    lanes, current = program.lanes, dark_e_per_s(effects, device)
    exchange, gain = effects.find_part(Exchange), effects.find_part(WordGain)
    if exchange is not None:
        by_row = current.reshape(program.lane.shape)
        current = exchange.smeared(by_row, exchange.fraction(program.sensor)).reshape(-1)
    errors, open_s = np.zeros((2, len(program.container.buckets), lanes.size))
    for rate, part in zip(rates, rate_weights, strict=True):
        weights = program.weights(replace(program.model(effects), leak_per_s=rate))
        errors += part * weights.error_sum.T[:, lanes]
        open_s += part * np.einsum("n,nlb->bl", program.slot_s, weights.slots)[:, lanes]
    return np.asarray(errors * (device.fixed(gain.error_e) if gain else 0.0) + current * open_s)


def _dark_covariances(program: AnalysedProgram, effects: Selection, device: Device) -> Floats:
    """Return the covariances that Poisson counts of dark charge cause, in square electrons, (pairs
    of buckets, pixels). Pairs are (0, 0), (0, 1), (1, 1), (0, 2) and so on; there are none, shape
    (0, pixels), without the effect."""
    if effects.find_part(CountedDark) is None:
        return np.zeros((0, program.lane.size))
    weights = program.weights(program.model(effects)).slots
    square_s = np.stack(
        [
            np.einsum("n,nl,nl->l", program.slot_s, weights[:, :, a], weights[:, :, b])
            for b in range(weights.shape[2])
            for a in range(b + 1)
        ]
    )
    return square_s.take(program.lanes, axis=1) * dark_e_per_s(effects, device)


def _at_neighbours(weights: Floats, values: Floats, shape: tuple[int, int]) -> Floats:
    """Return `weights` (4, buckets, pixels) times the `values` (pixels,) of the neighbour above,
    below, left and right of each pixel, as an array like `weights`. It is 0 where a pixel of the
    array of `shape` (rows, cols) has no such neighbour."""
    products = np.zeros((*weights.shape[:2], *shape))
    for product, of_side, (to, source) in zip(products, weights, NEIGHBOURS, strict=True):
        at = (slice(None), *to)
        product[at] = of_side.reshape(product.shape)[at] * values.reshape(shape)[source]
    return products.reshape(weights.shape)


def _electron_weights(program: AnalysedProgram, model: WeightModel) -> Floats:
    """Return how much an electron counts on average, (buckets, lanes), in the slots that a bucket
    sees; 1 for buckets that see none.

    A lane is the pixels of one distinct shutter."""
    weights = program.weights(model).slots
    square, plain = (
        np.einsum("n,nlb->bl", program.slot_s, power) for power in (weights**2, np.abs(weights))
    )
    return np.asarray(np.divide(square, plain, out=np.ones_like(square), where=square > 0))


def _neighbour_weights(program: AnalysedProgram, model: WeightModel) -> tuple[Floats32, Floats]:
    """Return the weights (draws, 4, buckets, pixels) of neighbours' Poisson counts. Return also the
    parts (4, buckets, pixels) of neighbours' charge in a frame whose counts do not follow from the
    neighbours' draws. Both are cached with the program and the `model` of weights.

    The counts of a neighbour in the slots that a pixel sees are estimated from its own draws, as if
    its light were steady."""

    def make() -> tuple[Floats32, Floats]:
        """Estimate the charge that a pixel gives to its neighbours from the pixel's Poisson counts.

        Return the weights of each draw, and for four directions and each bucket the variance, for a
        charge of 1 e in the frame, that the draws do not determine."""
        weights = program.weights(model).slots
        seconds = weights * program.slot_s[:, None, None]
        # The covariance of a lane's own exposures in steady light gives its draws.
        own_s = np.einsum("nla,nlb->abl", seconds, weights)
        lower, variance_s = lower_triangular(own_s)
        known = variance_s > 0
        inverse_s = np.divide(1.0, variance_s, out=np.zeros_like(variance_s), where=known)
        weight_e = _electron_weights(program, model)
        scale = np.einsum("cal,cl->acl", inverse_lower(lower), inverse_s * weight_e)
        estimated = np.einsum("nla,acl->nlc", weights, scale)
        beside = weights_beside(seconds, estimated, program.lane)
        unknown_s = np.repeat(np.einsum("bbl->bl", own_s)[None, :, program.lanes], 4, axis=0)
        counts_s = (variance_s / weight_e**2)[:, program.lanes]
        for draw_weights, draw_s in zip(beside, counts_s, strict=True):
            unknown_s -= _at_neighbours(draw_weights**2, draw_s, program.lane.shape)
        return beside, np.maximum(unknown_s / program.slot_s.sum(), 0.0)

    return program.recent.of((_neighbour_weights, model), make)


def _word_errors(program: AnalysedProgram, effects: Selection) -> Floats:
    """Return the errors of words under `effects` as factors of normal numbers, in electrons,
    (draws, buckets, lanes); cached in the `program`. Without such effects there are no draws. A
    lane is the pixels of one distinct shutter."""

    def make() -> Floats:
        """Return the standard deviations (e) of all word errors by draw, bucket and lane.

        A lane is the pixels of one distinct shutter. The errors of buckets are correlated, so a
        bucket may use several draws."""
        weights = program.weights(program.model(effects))
        lanes, buckets = weights.slots.shape[1:]
        covariance_e2 = np.zeros((buckets, buckets, lanes))
        for _, error_part in effects.errors():
            sigma_e = error_part.sigma_e(program.sensor)
            covariance_e2 += sigma_e**2 * weights.covariance(error_part.at)
        lower, variance_e2 = lower_triangular(covariance_e2)
        draws = lower.swapaxes(0, 1) * np.sqrt(variance_e2)[:, None]
        return np.ascontiguousarray(draws[draws.any(axis=(1, 2))])

    return program.recent.of((_word_errors, effects.on), make)


def lower_triangular(covariance: Floats) -> tuple[Floats, Floats]:
    """Return L, shape (n, n, ..), and d, shape (n, ..), with covariance = L diag(d) L^T for each of
    the symmetric matrices in the first two axes of `covariance` (n, n, ..).

    L is lower triangular with a unit diagonal. A row that depends on earlier rows up to rounding (1
    part in 10^9) has d = 0, and 0 below it in L."""
    size = len(covariance)
    lower, variance = np.zeros_like(covariance), np.zeros_like(covariance[0])
    for a in range(size):
        rest = covariance[:, a] - np.einsum(
            "bk..., k..., k... -> b...", lower[:, :a], lower[a, :a], variance[:a]
        )
        variance[a] = np.where(rest[a] > 1e-9 * np.abs(covariance[a, a]), rest[a], 0.0)
        np.divide(rest, variance[a], out=lower[:, a], where=variance[a] > 0)
        lower[:a, a], lower[a, a] = 0.0, 1.0
    return lower, variance


def inverse_lower(lower: Floats) -> Floats:
    """Return the inverses of the lower triangular matrices in the first two axes of `lower` (n, n,
    ..), whose diagonals are 1; the diagonal and what is above it are not read."""
    inverse = np.zeros_like(lower)
    for b in range(len(lower)):
        inverse[b, b] = 1.0
        for a in range(b):
            inverse[b, a] = -np.einsum("k..., k... -> ...", lower[b, a:b], inverse[a:b, a])
    return inverse
