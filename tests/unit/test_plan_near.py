"""Which pixels are found to be near saturation, beside sums over neighbours in numpy."""

from __future__ import annotations

import numpy as np
import pytest

from nscc_runtime.planner.near_loop import TOGETHER, Asked, charges_at, may_saturate


@pytest.mark.parametrize("shape", [(1, 1), (1, 6), (5, 1), (2, 2), (7, 19)])
def test_neighbours_give_a_part_and_the_border_gets_less(shape: tuple[int, int]) -> None:
    rng = np.random.default_rng(sum(shape))
    frames = rng.uniform(0.0, 3.0, (3, *shape)).astype(np.float32)
    total, current = frames.sum(axis=0, dtype=np.float64), rng.uniform(0.0, 3.0, shape)
    scale, lanes = rng.uniform(0.5, 2.0, shape), rng.integers(0, 3, shape).astype(np.int32)
    weights, dark_s = rng.uniform(0.0, 1.0, (2, 3, 3)), rng.uniform(0.0, 1.0, (2, 3))
    part = np.array([1.0, 0.5, 0.7])
    limit, fraction, frame_s, sigmas = np.array([4.0, 3.0, np.inf]), 0.05, 0.5, 3.0
    sizes = {
        "rows": shape[0], "cols": shape[1], "count": 3, "lane_count": 3, "kinds": 2,
        "fraction": fraction, "frame_s": frame_s, "sigmas": sigmas,
    }  # fmt: skip
    arrays = {"total": total, "scale": scale, "current": current, "lanes": lanes}
    found, places = np.empty(1, np.int64), np.empty(total.size, np.int64)
    may_saturate(
        asked=Asked(places=0, **sizes), part=part, limit=limit, inflow=np.empty(shape[1]),
        found=found, places=places, **arrays,
    )  # fmt: skip
    places = places[: found[0]]
    gained, (most, own) = np.empty(len(places)), np.empty((2, 2, len(places)))
    charges_at(
        asked=Asked(places=len(places), **sizes), places=places, frames=frames, weights=weights,
        dark_s=dark_s, light=np.empty(TOGETHER), most=most, own=own, gained=gained, **arrays,
    )  # fmt: skip
    lit = total * scale
    framed = np.pad(lit, 1)
    beside = framed[:-2, 1:-1] + framed[2:, 1:-1] + framed[1:-1, :-2] + framed[1:-1, 2:]
    given = fraction * beside
    charge = part[lanes] * lit + given + current * frame_s
    near = np.flatnonzero(charge >= limit[lanes])
    assert places.tolist() == near.tolist()

    def reach(mean: np.ndarray) -> np.ndarray:
        return (mean + sigmas * np.sqrt(mean)).reshape(-1)[near]

    there = np.pad(np.ones(shape), 1)
    count = there[:-2, 1:-1] + there[2:, 1:-1] + there[1:-1, :-2] + there[1:-1, 2:]
    kept = 1.0 - fraction * count
    for kind in range(2):
        seen = (weights[kind][:, lanes] * frames).sum(axis=0) * scale
        dark = current * dark_s[kind][lanes]
        np.testing.assert_allclose(own[kind], reach(seen + dark), rtol=1e-12)
        np.testing.assert_allclose(
            most[kind], reach(np.maximum(seen, kept * seen + given) + dark), rtol=1e-12
        )
    np.testing.assert_allclose(
        gained, (given - fraction * count * lit).reshape(-1)[near], rtol=1e-9, atol=1e-12
    )
