"""Recipe: a measurement of another distribution's, through a sweep, its table and its diagram."""

from __future__ import annotations

import csv
import io
import math
from pathlib import Path

from added_package import add_package, nscc_with
from PIL import Image

SOURCE = '''
import math

from nscc_training.sweep.point import PointKind
from nscc_training.sweep.point_programs import (
    compiled_of, program_fault, program_files, program_keys,
)


def measure(values, _task):
    """Return the dynamic range of a program: its longest over its shortest exposure."""
    container = compiled_of(values).container
    exposures_us = container.table.shutters @ container.slot_s * 1e6
    lit_us = exposures_us[exposures_us > 0]
    return {
        "range_db": 20 * math.log10(lit_us.max() / lit_us.min()),
        "longest_us": float(lit_us.max()),
        "words_per_frame": container.words_per_frame,
    }


RANGE = PointKind(
    "range", "dynamic range of a program: its longest over its shortest exposure",
    takes=program_keys, compute=measure, drawn=("range_db",), reads=program_files,
    fault=program_fault,
)
other = "no kind"
'''
GRID = """kind = "range"
[stops]
rule = \"\"\"
code stop : 1..N
open when n < stop\"\"\"
slots = [8, 16, 64]
codes = "open"
level = 0
[bits]
class = "e"
slots = 16
codes = "open"
level = 0
"""


def test_a_measurement_of_another_package_has_a_table_and_a_diagram(tmp_path: Path) -> None:
    add_package(tmp_path, SOURCE, "nscc.measurements", "range", "RANGE")
    (tmp_path / "grid.toml").write_text(GRID)
    done = nscc_with(tmp_path, "sweep", "grid.toml", "--out", "out", "--workers", "0")
    assert done.returncode == 0, done.stderr
    rows = [*csv.DictReader(io.StringIO((tmp_path / "out/table.csv").read_text()))]
    for row in rows[:3]:
        assert math.isclose(float(row["range_db"]), 20 * math.log10(int(row["slots"])))
        assert float(row["longest_us"]) == 1000 * int(row["slots"])
    assert rows[3]["code"] == "NS0412"  # 16 free bits do not fit
    Image.open(tmp_path / "out/diagram.png").verify()
    again = nscc_with(tmp_path, "sweep", "grid.toml", "--out", "out", "--workers", "0")
    assert "4 known, 0 to compute" in again.stderr


def test_invalid_measurements_are_refused(tmp_path: Path) -> None:
    add_package(tmp_path, SOURCE, "nscc.measurements", "range", "other")
    (tmp_path / "grid.toml").write_text(GRID)
    done = nscc_with(tmp_path, "sweep", "grid.toml", "--out", "out", "--workers", "0")
    assert done.returncode == 2
    assert "[NS0905]: the measurement 'range'" in done.stderr
