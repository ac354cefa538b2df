"""Recipe: words that a chip of one's own has, by its table, through assembler, proof, emulators."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from nscc_command import invoke

TABLE = """
name = "tiny"
array = { rows = 8, cols = 12 }
[registers]
analog = ["A", "B", "C", "D", "E", "F", "NEWS"]
analog_scratch = "NEWS"
digital = ["R1", "R2", "R3", "R4", "R5"]
[[words]]  # a fifth of what it reads goes into each of five registers
name = "bus5"
effect = "bus"
destinations = 5
sources = [1, 6]
divisor = 5
lines = ["fbus"]
us = 0.5
[[words]]
name = "sum"
effect = "bus"
destinations = 1
sources = [5, 7]
"""
RULE = "nsl 1\nframe 8 slots of 1ms\ncode stop : 1..N\nopen when n < stop\n"
OPTIONS = "p.nsl --target tiny.toml"
SAMPLE = "bus NEWS, A, PIX\n    bus A, B, NEWS\n"
BY_FIFTHS = "bus5 C, NEWS, D, E, F, A, PIX\n    sum A, B, C, NEWS, D, E, F\n"
RUNS = ("none", "all --fidelity reference", "auto --audit", "all")


def test_words_of_the_user_are_assembled_proved_and_run(tmp_path: Path) -> None:
    (tmp_path / "tiny.toml").write_text(TABLE)
    (tmp_path / "p.nsl").write_text(RULE + "pixels stop = tile [[1, 3], [5, 8]]\n")
    assert invoke(f"build {OPTIONS} -o p.icw".split(), tmp_path).status == 0
    text = invoke(["disasm", "p.icw"], tmp_path).out
    (tmp_path / "q.asm").write_text(text.replace(SAMPLE, BY_FIFTHS))
    run = "run q.icw --scene builtin:flat:9000 --effects"
    for command in ("asm q.asm", "prove q.icw", *(f"{run} {e} -o {e[-3:]}.npz" for e in RUNS)):
        assert invoke(command.split(), tmp_path).status == 0, command
    assert invoke(["disasm", "q.icw"], tmp_path).out.count(BY_FIFTHS) == 4
    ideal, *others = (np.load(tmp_path / f"{e[-3:]}.npz")["exposure_e"][0] for e in RUNS)
    assert ideal == pytest.approx(9000 / 8 * np.tile([[1, 3], [5, 8]], (4, 6)))
    for other in others:  # frames of different simulators have noise of their own
        error_e = other - others[0]
        assert error_e.std() < 2000
        assert abs(error_e.mean()) < 5 * error_e.std() / error_e.size**0.5 + 1
    refused = invoke(f"build {OPTIONS} --emit cpp -o p".split(), tmp_path)
    assert "has words that the SCAMP-5d devkit does not have: bus5, sum" in refused.err


@pytest.mark.parametrize("change", ['"bus"/"blend"', "[5,/[4,", '"sum"/"OR"', '"fbus"/"W1"'])
def test_invalid_words_are_refused(tmp_path: Path, change: str) -> None:
    (tmp_path / "tiny.toml").write_text(TABLE.replace(*change.split("/"), 1))
    (tmp_path / "p.nsl").write_text(RULE)
    assert invoke(["check", *OPTIONS.split()], tmp_path).codes == ["NS0235"]
