"""Digital words on registers that may be unknown, and that lose what is not written again."""

from __future__ import annotations

from math import inf

import numpy as np
from emulator_programs import target_of

from nscc.operations import op
from nscc_runtime.reference.digital import UNKNOWN, Digital

TARGET = target_of((1, 1))
MASK, MASKED = TARGET.mask_register, TARGET.masked_register


def digital(pixels: int, retention_us: float = inf, **bits: list[int]) -> Digital:
    unknown = np.full(pixels, UNKNOWN)
    start = {**dict.fromkeys((*TARGET.digital_registers, "FLAG"), unknown)}
    return Digital(TARGET, {**start, **{k: np.array(v) for k, v in bits.items()}}, retention_us)


def test_an_or_is_known_where_one_source_is_1() -> None:
    found = digital(3, R1=[0, 1, 0], R2=[0, UNKNOWN, UNKNOWN])
    found.run(op("OR", ["R3"], ["R1", "R2"]))
    assert found.read("R3").tolist() == [0, 1, UNKNOWN]
    found.run(op("NOT", ["R4"], ["R3"]))
    assert found.read("R4").tolist() == [1, 0, UNKNOWN]


def test_the_mask_decides_where_the_masked_register_is_written() -> None:
    assert MASK is not None
    assert MASKED is not None
    found = digital(4, **{MASK: [0, 1, UNKNOWN, UNKNOWN], MASKED: [0, 0, 0, 1], "R1": [1] * 4})
    found.run(op("MOV", [MASKED], ["R1"]))
    assert found.read(MASKED).tolist() == [0, 1, UNKNOWN, 1]


def test_pixels_outside_the_mask_keep_their_age() -> None:
    assert MASK is not None
    assert MASKED is not None
    found = digital(2, 100.0, **{MASK: [0, 1], MASKED: [1, 1], "R1": [1, 1]})
    found.now_us = 60.0
    found.run(op("MOV", [MASKED], ["R1"]))
    assert found.read(MASKED).tolist() == [1, 1]
    found.now_us = 120.0
    assert found.read(MASKED).tolist() == [0, 1]
    assert found.read("R1").tolist() == [0, 0]


def test_pixels_that_differ_in_when_they_were_written_stay_apart() -> None:
    assert MASK is not None
    assert MASKED is not None
    found = digital(3, 100.0, **{MASK: [0, 1, 1], MASKED: [1, 1, 1], "R1": [1, 1, 1]})
    for name in TARGET.digital_registers:
        if name not in (MASK, MASKED, "R1"):
            found.write(name, np.zeros(3))
    found.write("FLAG", np.ones(3))
    found.now_us = 60.0
    found.run(op("MOV", [MASKED], ["R1"]))
    found.write(MASK, np.zeros(3))
    assert found.merge().tolist() == [0, 1, 1]
    found.now_us = 120.0
    assert found.read(MASKED).tolist() == [0, 1]
