"""Recipe: an encoding of another distribution's, from source text to a proof, at each level."""

from __future__ import annotations

import json
import zipfile
from pathlib import Path

import pytest
from added_package import add_package, nscc_with
from marks import slow

SOURCE = '''
from itertools import combinations_with_replacement

import numpy as np
from nscc.logic.generate import Generator
from nscc.logic.problem import Gate, GaveUp, Solution
from nscc.truth import vector


def sums(problem, machine, steps, flipped=0):
    """A register for each field; every predicate is one of them, or two of them together."""
    names = sorted(problem.values)
    planes = tuple(vector(np.flatnonzero(problem.values[name])) for name in names)
    pairs = {
        planes[i] | planes[j]: (f"p{i}", f"p{j}")
        for i, j in combinations_with_replacement(range(len(planes)), 2)
    }
    if any(demand.predicate not in pairs for demand in problem.demands):
        raise GaveUp("a predicate of another form")
    answers = [((Gate("WHERE", "FLAG", pairs[d.predicate]),),) for d in problem.demands]
    held = tuple(plane ^ flipped for plane in planes)
    yield Solution("sums of two", held, tuple(names), 0, 0, (), tuple(answers), ())


GOOD, EARLY = Generator("family", sums), Generator("family", sums, from_level=1)
WRONG = Generator("family", lambda *asked: sums(*asked, flipped=1))
BROKEN, FOREIGN = Generator("family", lambda *asked: 1 / 0), Generator("thermometer", sums)
'''
PROGRAM = "nsl 1 frame 15 slots of 1ms code b : bit[5] open when b[n % 5] or b[(n + n / 5) % 5]\n"
BUILD = ("build", "p.nsl", "--lowering", "accumulate", "--emit", "report=-", "-O")


@pytest.mark.parametrize("level", [0, 1, 2, slow(3)])
def test_an_encoding_of_another_package_is_used_and_proved(tmp_path: Path, level: int) -> None:
    add_package(tmp_path, SOURCE, "nscc.encodings", "sums", "GOOD")
    (tmp_path / "p.nsl").write_text(PROGRAM)
    report = json.loads(nscc_with(tmp_path, *BUILD, level).stdout)
    assert report["proof"]["holds"]
    assert (report["logic"]["encoding"] == "sums of two") == (level >= 2)
    assert nscc_with(tmp_path, "check", "p.nsl", "-O", level).returncode == 0


@pytest.mark.parametrize("value", ["WRONG", "EARLY", "FOREIGN", "sums"])
def test_a_wrong_encoding_of_another_package_is_refused_by_name(tmp_path: Path, value: str) -> None:
    add_package(tmp_path, SOURCE, "nscc.encodings", "odd", value)
    (tmp_path / "p.nsl").write_text(PROGRAM)
    assert nscc_with(tmp_path, "check", "p.nsl").returncode == 0
    done = nscc_with(tmp_path, *BUILD, 2)
    assert (done.returncode, "[NS0905]: the encoding 'odd'" in done.stderr) == (2, True)


def test_an_encoding_that_raises_is_left_out_and_named(tmp_path: Path) -> None:
    add_package(tmp_path, SOURCE, "nscc.encodings", "odd", "BROKEN")
    (tmp_path / "p.nsl").write_text(PROGRAM)
    done = nscc_with(tmp_path, *BUILD, 2)
    assert done.returncode == 0
    assert "[NS0504]: the gate generator 'odd'" in done.stderr
    assert "ZeroDivisionError" in done.stderr
    report = json.loads(done.stdout)
    assert report["proof"]["holds"]
    assert report["failed_generators"] == ["odd"]
    (saved,) = tmp_path.glob("nscc-fault-*.zip")
    with zipfile.ZipFile(saved) as reproducer:
        assert "inputs/0-p.nsl" in reproducer.namelist()
        assert b"ZeroDivisionError" in reproducer.read("traceback.txt")
        assert reproducer.read("command.txt").decode().split() == ["nscc", *BUILD, "2"]
