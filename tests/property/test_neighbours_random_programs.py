"""Random programs of version 3: every image and plane is what SciPy makes of the text."""

from __future__ import annotations

import numpy as np
import pytest
from marks import slow
from neighbours_oracle import Program, random_program
from proved_programs import proved_or_refused

from nscc.words.container import Container
from nscc.words.file import from_bytes, to_bytes
from nscc_runtime.effects import selected
from nscc_runtime.light import Light
from nscc_runtime.neighbours.pictured_program import PicturedProgram
from nscc_runtime.sensor import default_sensor

PROGRAMS, CHUNKS = 1000, 20
ROWS, COLS = 40, 36
ALLOWED = {"NS0533", "NS0535", "NS0540", "NS0541"}
"""What such a program may be refused for: it compares values that are always equal (NS0533), or is
too large for the chip."""
MOST_REFUSED, MOST_UNDECIDED = 0.25, 0.06


def agree(program: Program, container: Container, seed: int) -> bool:
    """The emulator's frame of random light is what the oracle says; whether it says most of it. A
    value that is compared with itself is undecided everywhere."""
    rng = np.random.default_rng(seed)
    light = (rng.integers(0, 1 << 20, (2, ROWS, COLS)) / 128).astype(np.float32)
    sensor = default_sensor(container.target)
    runner = PicturedProgram(container, sensor, selected("none"), threads=1)
    (frame,) = runner.film([Light.of_clip(light)], 0, seed)
    slots = light.astype(np.float64)
    exposures = {"exposure": slots.sum(axis=0), "early": slots[0], "late": slots[1]}
    known = program.evaluate(exposures)
    margin = frame.told["margin"]
    assert not margin[ROWS // 2, COLS // 2]
    is_decided = True
    for name in program.reads:
        value = known[name]
        key = f"image_{name}" if f"image_{name}" in frame.told else f"plane_{name}"
        sure = ~margin & ~value.unknown
        is_decided = is_decided and sure[10:-10, 10:-10].mean() > 0.9
        np.testing.assert_allclose(
            frame.told[key][sure].astype(float), value.values[sure].astype(float), atol=1e-6
        )
    if program.reported is not None:
        bits = known[program.reported]
        found = frame.told[f"report_events_{program.reported}"]
        for x, y in found[found[:, 0] >= 0]:
            assert bits.values[y, x] or bits.unknown[y, x] or margin[y, x]
    return is_decided


@pytest.mark.parametrize("chunk", [slow(c) if c >= 4 else c for c in range(CHUNKS)])
def test_words_of_random_version_3_programs_equal_scipy(chunk: int) -> None:
    size = PROGRAMS // CHUNKS
    refused = undecided = 0
    for seed in range(chunk * size, (chunk + 1) * size):
        program = random_program(seed)
        container = proved_or_refused(program.text, 1, (ROWS, COLS), ALLOWED)
        # The program does not fit the chip.
        if container is None:
            refused += 1
            continue
        assert to_bytes(from_bytes(to_bytes(container), "random.icw")) == to_bytes(container)
        undecided += not agree(program, container, seed)
    assert undecided <= MOST_UNDECIDED * size
    assert refused <= MOST_REFUSED * size
