"""What is drawn for a block of pixels at a time: counts, and codes of the converter.

Parts of the loops over the pixels of a frame under a plan; `scratch`, `few` and `places` are rooms
that these loops lend.
"""

from __future__ import annotations

import numpy as np

from nscc_runtime.loop import Bytes, Floats, Ints, compiled, inlined
from nscc_runtime.noise.counter import bits, unit
from nscc_runtime.noise.gaussian_fast import normal_fast
from nscc_runtime.noise.poisson_law import SEARCH_BELOW, SETTLED_ABOVE, quantile

BLOCK = 1024
"""Pixels that go through all steps together."""

MOST_COUNTED = 80
_NOTHING = 1e-17

FIRST_LANE = np.uint64(0)


@inlined
def _exp_minus(x: float) -> float:
    """exp(-x) for x in [0, 16], to 2e-16: without branches, so that LLVM makes vectors."""
    n = np.floor(0.5 - x * 1.4426950408889634)
    r = -x - n * 0.6931471803691238 - n * 1.9082149292705877e-10
    p = 1.0 / 6227020800.0
    p = p * r + 1.0 / 479001600.0
    p = p * r + 1.0 / 39916800.0
    p = p * r + 1.0 / 3628800.0
    p = p * r + 1.0 / 362880.0
    p = p * r + 1.0 / 40320.0
    p = p * r + 1.0 / 5040.0
    p = p * r + 1.0 / 720.0
    p = p * r + 1.0 / 120.0
    p = p * r + 1.0 / 24.0
    p = p * r + 1.0 / 6.0
    p = p * r + 0.5
    p = p * r + 1.0
    p = p * r + 1.0
    power = np.int64((np.int64(n) + np.int64(1023)) << np.int64(52)).view(np.float64)
    found: float = p * power
    return found


@compiled
def _searched(count: int, rates: Floats, rest: int, room: int, scratch: Floats) -> None:
    """`nscc_runtime.noise.poisson_law.search`, step by step for many pixels at once.

    `scratch` holds uniform numbers from `rest` on, then masses and the counts found, each of
    `room`; `rates` are at most SEARCH_BELOW.
    """
    mass, found = rest + room, rest + 2 * room
    for i in range(count):
        start = _exp_minus(rates[i])
        scratch[mass + i] = start
        scratch[rest + i] -= start
        scratch[found + i] = 0.0
    for step in range(1, MOST_COUNTED):
        inverse, going = 1.0 / step, 0
        for i in range(count):
            next_mass = scratch[mass + i] * (rates[i] * inverse)
            left = scratch[rest + i]
            on = left > 0.0 and next_mass > _NOTHING
            scratch[mass + i] = next_mass
            scratch[rest + i] = left - next_mass
            scratch[found + i] += 1.0 if on else 0.0
            going += 1 if on else 0
        if going == 0:
            break


@compiled
def counted(
    stream: np.uint64, top: float, first: int, stop: int, values: Floats, scratch: Floats,
    few: Floats, places: Ints,
) -> None:  # fmt: skip
    """values[i] := a count of the rate values[i] at pixel first + i."""
    low, high = 0, 0
    for i in range(stop - first):
        rate = values[i] if values[i] > 0.0 else 0.0
        values[i] = rate if rate < top else top
    for i in range(stop - first):
        scratch[i] = unit(bits(stream, first + i, FIRST_LANE))
    for i in range(stop - first):
        if values[i] < SETTLED_ABOVE:
            places[low] = i
            few[low] = values[i] if values[i] < SEARCH_BELOW else SEARCH_BELOW
            low += 1
    for i in range(stop - first):
        high += 1 if values[i] >= SEARCH_BELOW else 0
    for j in range(low):
        scratch[BLOCK + j] = scratch[places[j]]
    for i in range(stop - first if high else 0):
        z = float(normal_fast(scratch[i]))
        x = np.floor(quantile(z, values[i] if values[i] > SEARCH_BELOW else SEARCH_BELOW))
        scratch[i] = x if x > 0.0 else 0.0
    if low:
        _searched(low, few, BLOCK, BLOCK, scratch)
        for j in range(low):
            i, found = places[j], scratch[3 * BLOCK + j]
            # The formula's error at the crossover must not let a greater rate give a smaller count.
            formula = scratch[i] if values[i] >= SEARCH_BELOW else 0.0
            scratch[i] = found if found > formula else formula
    for i in range(stop - first):
        values[i] = scratch[i]


@inlined
def _code(value: float, noise: float, lsb: float, offset: float, top: float) -> float:
    """What the ADC makes of an exposure."""
    code = np.rint(value / lsb + noise) + offset
    code = code if code > 0.0 else 0.0
    return float(np.rint(code if code < top else top))


@inlined
def read_out(
    noisy: int, noise: float, stream: np.uint64, lsb: float, offset: float, top: float, first: int,
    count: int, values: Floats, at: int, scratch: Floats, codes: Bytes, out: int,
) -> None:  # fmt: skip
    """codes[out + i] := the code of values[at + i], the exposure of pixel first + i; 0 where that
    is no number."""
    if noisy:
        for i in range(count):
            scratch[i] = noise * float(normal_fast(unit(bits(stream, first + i, FIRST_LANE))))
    else:
        for i in range(count):
            scratch[i] = 0.0
    for i in range(count):
        codes[out + i] = np.uint8(np.int32(_code(values[at + i], scratch[i], lsb, offset, top)))
