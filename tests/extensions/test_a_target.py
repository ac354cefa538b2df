"""Recipe: a chip of another distribution's, by name, through checks, builds and every emulator."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from added_package import add_package, nscc_with

SOURCE = '''
from dataclasses import replace
from pathlib import Path
from nscc.chips.load import builtin_target
TABLE = """
name = "tiny"
[array]
rows = 8
cols = 12
[registers]
analog = ["A", "B", "C", "D", "NEWS"]
analog_scratch = "NEWS"
digital = ["R1", "R2", "R3", "R4", "R5", "R6", "R7"]
"""
FILE = Path(__file__).with_name("tiny.toml")
VALUE = replace(builtin_target("scamp7"), name="tiny", rows=8, cols=12)
WRONG = TABLE.replace("rows = 8", "rows = 0")
'''
RULE = "nsl 1\ntarget tiny\nframe 8 slots of 1ms\ncode stop : 1..N\nopen when n < stop\n"


def test_programs_compile_and_run_for_a_target_of_another_package(tmp_path: Path) -> None:
    add_package(tmp_path, SOURCE, "nscc.targets", "tiny", "TABLE")
    (tmp_path / "p.nsl").write_text(RULE + "pixels stop = tile [[1, 3], [5, 8]]\n")
    assert "tiny               8 x 12" in nscc_with(tmp_path, "targets").stdout
    commands = ["check p.nsl", *(f"build p.nsl -O{level} -o p{level}.icw" for level in range(3))]
    commands += [f"prove p{level}.icw" for level in range(3)]
    run = "run p2.icw --scene builtin:flat:9000 --effects"
    commands += [f"{run} none -o ideal.npz", f"{run} all --fidelity reference -o r.npz"]
    commands += [f"{run} auto --audit -o auto.npz", f"{run} all -o all.npz"]
    for command in commands:
        done = nscc_with(tmp_path, *command.split())
        assert done.returncode == 0, done.stderr
    ideal, *others = (np.load(tmp_path / f"{n}.npz") for n in ("ideal", "r", "auto", "all"))
    assert ideal["exposure_e"][0] == pytest.approx(9000 / 8 * np.tile([[1, 3], [5, 8]], (4, 6)))
    assert all(abs(f["exposure_e"] - ideal["exposure_e"]).mean() < 500 for f in others)


@pytest.mark.parametrize(
    ("name", "value", "status"),
    [("tiny", "FILE", 0), ("tiny", "VALUE", 0), ("tiny", "WRONG", 2), ("scamp7", "TABLE", 2)],
)
def test_targets_come_from_files_or_values_and_others_are_refused(
    tmp_path: Path, name: str, value: str, status: int
) -> None:
    add_package(tmp_path, SOURCE, "nscc.targets", name, value)
    (tmp_path / "tiny.toml").write_text(SOURCE.split('"""')[1])
    done = nscc_with(tmp_path, "targets", "tiny")
    assert (done.returncode, "tiny" in done.stdout) == (status, status == 0)
    assert (f"[NS0905]: the target '{name}'" in done.stderr) == (status == 2)
