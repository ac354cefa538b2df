"""Hard case 3, noise: any number of threads, any tile size, the same bits."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
from drawn_counts import by_plan, by_reference
from reference_programs import BUMPS, program

from nscc_runtime import capture
from nscc_runtime.noise import key, normals

ROWS, COLS = 96, 130
STREAM = key(123, 4, 1, 2, 3)
PIXELS = np.arange(ROWS * COLS).reshape(ROWS, COLS)
RATES = 10.0 ** np.random.default_rng(1).uniform(-6, 8, (ROWS, COLS))


def drawn(part):
    """Everything that is drawn for one tile: (rows, cols, values)."""
    pixels, rates = PIXELS[part], RATES[part]
    fast, exact = by_plan(STREAM, pixels, rates), by_reference(STREAM, pixels, rates)
    return np.stack([normals(STREAM, pixels), fast, exact], axis=-1)


@pytest.mark.parametrize("tile", [(96, 130), (1, 130), (96, 1), (7, 13), (64, 64)])
@pytest.mark.parametrize("threads", [1, 2, 3, 8])
def test_case_03_tiles_and_threads_change_no_bit(tile, threads):
    parts = [
        (slice(y, y + tile[0]), slice(x, x + tile[1]))
        for y in range(0, ROWS, tile[0])
        for x in range(0, COLS, tile[1])
    ]
    whole = drawn(np.s_[:, :])
    tiled = np.full_like(whole, np.nan)
    with ThreadPoolExecutor(threads) as pool:
        for part, values in zip(reversed(parts), pool.map(drawn, reversed(parts)), strict=True):
            tiled[part] = values
    assert np.array_equal(tiled.view(np.int64), whole.view(np.int64))


@pytest.mark.parametrize("effects", ["shot,read,full_well,adc_noise", "auto", "all"])
def test_case_03_threads_change_no_bit_of_a_capture(effects):
    """With 1, 2, 3 and 8 threads the electrons and codes are equal, though they are noisy."""
    container = program(BUMPS, "edges", 96, 130)
    light = np.random.default_rng(7).exponential(4000, (4, 96, 130)).astype(np.float32)
    first, *others = (
        capture(container, light, effects=effects, tolerance="0.5e", seed=3, threads=threads)
        for threads in (1, 2, 3, 8)
    )
    assert len(np.unique(first.exposure_e)) > 5000
    for other in others:
        assert np.array_equal(first.exposure_e, other.exposure_e)
        assert np.array_equal(first.frame, other.frame)
