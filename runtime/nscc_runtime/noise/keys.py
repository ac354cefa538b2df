"""Keys of random streams: seed, effect, source, frame and group.

A random number depends only on its key and pixel index, so dropping one effect changes no draw of
another."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

_MASK_32 = 0xFFFF_FFFF
_ROUNDS = 10
_MULTIPLIERS = 0xD251_1F53, 0xCD9E_8D57
_WEYL = 0x9E37_79B9, 0xBB67_AE85
_LIMITS = {"seed": 64, "effect": 32, "source": 32, "frame": 64, "group": 64}

# The fractional digits of pi: the key with which keys are mixed.
_START = 0x243F_6A88, 0x85A3_08D3


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


@lru_cache(maxsize=1024)
def base(seed: int, effect: int, source: int = 0) -> np.uint64:
    """Return the first half of `key`, which does not depend on frame and group: `key` is
    `nscc_runtime.noise.counter.bits(base, frame, group)`."""
    first = philox((*_halves(seed), effect, source), _START)
    return np.uint64(first[0] | first[1] << 32)


def philox(counter: tuple[int, int, int, int], key: tuple[int, int]) -> tuple[int, int, int, int]:
    """Return four 32-bit words from a counter and a key, by Philox4x32-10. Reference: Salmon,
    Moraes, Dror and Shaw, "Parallel random numbers: as easy as 1, 2, 3", SC 2011."""
    a, b, c, d = counter
    k, m = key
    for _ in range(_ROUNDS):
        x, y = a * _MULTIPLIERS[0], c * _MULTIPLIERS[1]
        a, b, c, d = y >> 32 ^ b ^ k, y & _MASK_32, x >> 32 ^ d ^ m, x & _MASK_32
        k, m = k + _WEYL[0] & _MASK_32, m + _WEYL[1] & _MASK_32
    return a, b, c, d


def _halves(value: int) -> tuple[int, int]:
    return value & _MASK_32, value >> 32
