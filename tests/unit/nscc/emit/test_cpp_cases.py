"""Programs beside their C++ for the devkit: tests/cases/cpp.

`pytest tests/unit/nscc/emit/test_cpp_cases.py --update-cases` rewrites the files; read the
difference.
"""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from checkout import ROOT
from nscc_command import invoke

CASES = sorted((ROOT / "tests" / "cases" / "cpp").glob("*.nsl"))


@pytest.mark.parametrize("path", [pytest.param(path, id=path.stem) for path in CASES])
def test_cpp_of_a_case_is_the_recorded_text(path: Path, tmp_path: Path, update_cases: bool) -> None:
    """The C++ of each case is that of the file beside it, to the character."""
    shutil.copy(path, tmp_path)
    outcome = invoke(["build", path.name, "--emit", "cpp"], tmp_path)
    assert outcome.status == 0, outcome.err
    written = (tmp_path / path.name).with_suffix(".cpp").read_text()
    beside = path.with_suffix(".cpp")
    if update_cases:
        beside.write_text(written)
    assert beside.exists(), f"{path.name} has no C++ beside it: run with --update-cases"
    assert written == beside.read_text(), f"{path.name}: run with --update-cases if this is meant"


def test_there_are_cases_and_every_file_belongs_to_one() -> None:
    """The folder is not empty, and no recorded file is left without its program."""
    assert CASES
    files = {path.with_suffix("") for path in CASES[0].parent.iterdir()}
    assert files == {path.with_suffix("") for path in CASES}
