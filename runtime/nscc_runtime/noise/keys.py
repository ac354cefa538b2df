"""Keys of random streams: seed, effect, source, frame and group.

A random number depends only on its key and pixel index, so dropping one effect changes no draw of
another. Uniform numbers follow from a key and a counter by a hash, without state (Philox4x32-10,
which passes BigCrush). Those functions are scalar; loops (`nscc_runtime.loop`) call them, and LLVM
vectorises the loops. `philox` is the same function for Python."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from nscc_runtime.loop import inlined

_HALF = np.uint64(32)
_MASK = np.uint64(0xFFFF_FFFF)
_MULTIPLIER_0 = np.uint64(0xD251_1F53)
_MULTIPLIER_1 = np.uint64(0xCD9E_8D57)
_WEYL_0 = np.uint64(0x9E37_79B9)
_WEYL_1 = np.uint64(0xBB67_AE85)

_SHIFT_52 = np.uint64(12)
_ONE_TO_TWO = np.uint64(0x3FF0_0000_0000_0000)


@inlined
def both_bits(
    key: np.uint64, pixel: int | np.uint64, lane: np.uint64
) -> tuple[np.uint64, np.uint64]:
    """Return two independent numbers of 64 random bits that depend on `key`, the place `pixel` (at
    least 0) and `lane` only. `lane`: 0, 1, .. for several independent results at one pixel; not a
    lane of codes."""
    place = np.uint64(pixel)
    a, b = place & _MASK, place >> _HALF
    c, d = lane & _MASK, lane >> _HALF
    k, m = key & _MASK, key >> _HALF
    for _ in range(10):
        x, y = a * _MULTIPLIER_0, c * _MULTIPLIER_1
        a, b, c, d = (y >> _HALF) ^ b ^ k, y & _MASK, (x >> _HALF) ^ d ^ m, x & _MASK
        k, m = (k + _WEYL_0) & _MASK, (m + _WEYL_1) & _MASK
    return a | (b << _HALF), c | (d << _HALF)


@inlined
def bits(key: np.uint64, pixel: int | np.uint64, lane: np.uint64) -> np.uint64:
    """Return the first number of `both_bits`."""
    return both_bits(key, pixel, lane)[0]


@inlined
def unit(random: np.uint64) -> float:
    """Return the odd multiple of 2**-53 inside (0, 1) given by the upper 52 bits of `random`. The
    numbers are symmetric about 1/2, and 1 - u is exact."""
    # The bits become the fraction of a number in [1, 2): no conversion of integers, which not
    # every processor has for vectors.
    fraction = np.uint64((random >> _SHIFT_52) | _ONE_TO_TWO).view(np.float64) - 1.0
    return fraction + 2.0**-53


_MASK_32 = 0xFFFF_FFFF
_ROUNDS = 10
_MULTIPLIERS = 0xD251_1F53, 0xCD9E_8D57
_WEYL = 0x9E37_79B9, 0xBB67_AE85
_LIMITS = {"seed": 64, "effect": 32, "source": 32, "frame": 64, "group": 64}

START = np.uint64(0x85A3_08D3_243F_6A88)
"""The key with which keys are mixed: fractional digits of pi."""


@lru_cache(maxsize=1024)
def key(seed: int, effect: int, source: int = 0, frame: int = 0, group: int = 0) -> np.uint64:
    """Return the 64-bit key of a stream.

    `seed`, `frame` and `group` lie in 0 .. 2**64 - 1, `effect` and `source` in 0 .. 2**32 - 1;
    other values raise ValueError. Among m different streams, two share a key with a probability of
    about m**2 / 2**65."""
    values = {"seed": seed, "effect": effect, "source": source, "frame": frame, "group": group}
    for name, value in values.items():
        if not 0 <= value < 1 << _LIMITS[name]:
            raise ValueError(f"{name} {value} is outside 0 .. 2**{_LIMITS[name]} - 1")
    first = base(seed, effect, source)
    last = philox((*_halves(frame), *_halves(group)), _halves(int(first)))
    return np.uint64(last[0] | last[1] << 32)


def stream_of(effect: int, source: int) -> int:
    """Return the numbers of an effect's stream and of a source as one number."""
    return effect | source << 32


@lru_cache(maxsize=1024)
def base(seed: int, effect: int, source: int = 0) -> np.uint64:
    """Return the first half of `key`, which does not depend on frame and group: `key` is
    `nscc_runtime.noise.keys.bits(base, frame, group)`."""
    first = philox((*_halves(seed), effect, source), _halves(int(START)))
    return np.uint64(first[0] | first[1] << 32)


def philox(counter: tuple[int, int, int, int], key: tuple[int, int]) -> tuple[int, int, int, int]:
    """Return four random 32-bit numbers from a counter (four 32-bit numbers) and a key (two), by
    Philox4x32-10. Reference: Salmon, Moraes, Dror and Shaw, "Parallel random numbers: as easy as 1,
    2, 3", SC 2011."""
    a, b, c, d = counter
    k, m = key
    for _ in range(_ROUNDS):
        x, y = a * _MULTIPLIERS[0], c * _MULTIPLIERS[1]
        a, b, c, d = y >> 32 ^ b ^ k, y & _MASK_32, x >> 32 ^ d ^ m, x & _MASK_32
        k, m = k + _WEYL[0] & _MASK_32, m + _WEYL[1] & _MASK_32
    return a, b, c, d


def _halves(value: int) -> tuple[int, int]:
    """Return the low and the high 32 bits of `value`, which lies in 0 .. 2**64 - 1."""
    return value & _MASK_32, value >> 32
