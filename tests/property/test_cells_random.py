"""Random recurrent cells: every count, plane and state of every frame is what SciPy makes of it."""

from __future__ import annotations

import numpy as np
import pytest
from cells_oracle import Cell, random_cell
from marks import slow
from proved_programs import proved_or_refused

from nscc.words.container import Container
from nscc.words.file import from_bytes, to_bytes
from nscc_runtime.effects import selected
from nscc_runtime.frame_file import image_unit
from nscc_runtime.light import Light
from nscc_runtime.neighbours.pictured_program import PicturedProgram
from nscc_runtime.sensor import default_sensor

ROWS, COLS, FRAMES = 40, 44, 4
SEEDS = [
    *(range(n, n + 10) for n in range(0, 40, 10)),
    *(range(n, n + 95) for n in range(40, 420, 95)),
]
"""Of quick tests, then of slow ones."""
ALLOWED = {"NS0533", "NS0535", "NS0540", "NS0541"}
"""What a cell may be refused for: a comparison that is always true, or too little room."""
MOST_REFUSED = 0.3


def check_film(cell: Cell, container: Container, seed: int) -> None:
    """The emulator's film of random light is what the oracle says, frame by frame."""
    rng = np.random.default_rng(seed)
    lights = rng.integers(0, 30000, (FRAMES, 1, ROWS, COLS)).astype(np.float32)
    runner = PicturedProgram(
        container, default_sensor(container.target), selected("none"), threads=1
    )
    frames = runner.film((Light.of_clip(light) for light in lights), seed, seed)
    states = {name: np.full((ROWS, COLS), start) for name, start in cell.start.items()}
    units = image_unit(container)
    for light, frame in zip(lights, frames, strict=True):
        known, states = cell.step(light[0].astype(np.float64), states)
        assert not frame.told["margin"].any()
        for name, bits in states.items():
            assert np.array_equal(frame.told[f"plane_{name}"], bits)
        for name, unit_e in units.items():
            np.testing.assert_allclose(frame.told[f"image_{name}"] / unit_e, known[name], atol=1e-9)


@pytest.mark.parametrize("seeds", [slow(s) if s.start >= 40 else s for s in SEEDS], ids=str)
def test_words_of_random_cells_equal_scipy(seeds: range) -> None:
    refused = 0
    for seed in seeds:
        cell = random_cell(seed, most_side=5 if seed < 40 else 7)
        container = proved_or_refused(cell.text, 0, (ROWS, COLS), ALLOWED)
        # The cell does not fit the chip; only a few of them may not.
        if container is None:
            refused += 1
            continue
        assert to_bytes(from_bytes(to_bytes(container), "cell.icw")) == to_bytes(container)
        check_film(cell, container, seed)
    assert refused <= MOST_REFUSED * len(seeds)
