"""Noise beside numpy's generators, one thread, side by side in one run.

    python tests/benchmarks/bench_noise.py [--pixels 65536] [--rounds 15]

Per row: nanoseconds a sample, the best of several rounds, the two taken in turn; then their ratio.
numpy's generators are sequential: they give other numbers for other tiles, and other numbers for
slightly other rates.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable
from time import perf_counter

import numpy as np

from nscc_runtime.noise import key, normals, poisson, uniforms

_RATES = (0.001, 0.1, 1.0, 5.0, 9.9, 12.0, 20.0, 100.0, 1e4, 1e6)


def seconds(function: Callable[[], object]) -> float:
    begin = perf_counter()
    function()
    return perf_counter() - begin


def compare(
    name: str, own: Callable[[], object], other: Callable[[], object], samples: int, rounds: int
) -> None:
    """Print one line."""
    times = [(seconds(own), seconds(other)) for _ in range(rounds)]
    ours, theirs = (min(column) / samples * 1e9 for column in zip(*times, strict=True))
    print(f"  {name:<28} {ours:8.2f} ns   numpy {theirs:8.2f} ns   x{theirs / ours:6.2f}")


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--pixels", type=int, default=65536)
    parser.add_argument("--rounds", type=int, default=15)
    arguments = parser.parse_args()
    n, rounds = arguments.pixels, arguments.rounds
    pixels, stream, rng = np.arange(n), key(1, 2), np.random.default_rng(1)

    print(f"{n} pixels")
    compare("uniform", lambda: uniforms(stream, pixels), lambda: rng.random(n), n, rounds)
    compare("normal", lambda: normals(stream, pixels), lambda: rng.standard_normal(n), n, rounds)
    for rate in _RATES:
        rates = np.full(n, rate)
        compare(
            f"Poisson {rate:g}",
            lambda rates=rates: poisson(stream, pixels, rates),
            lambda rates=rates: rng.poisson(rates),
            n,
            rounds,
        )
    mixed = 10.0 ** rng.uniform(-2, 5, n)
    compare(
        "Poisson 0.01 to 1e5",
        lambda: poisson(stream, pixels, mixed),
        lambda: rng.poisson(mixed),
        n,
        rounds,
    )


if __name__ == "__main__":
    main()
