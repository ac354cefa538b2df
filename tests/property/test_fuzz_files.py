"""Mutated files of every kind: commands work or refuse them in words, and never end in status 70.

`python tests/property/test_fuzz_files.py SEED COUNT` prints what is wrong with other mutations.
"""

from __future__ import annotations

import sys
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest
from file_fuzz import QUICK, READERS, fault_of, faults, make_files, run_command, run_in_process
from nscc_command import Outcome

pytestmark = pytest.mark.filterwarnings("error::RuntimeWarning")
SEED = 42
EVERY = tuple(READERS)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """One file of every kind that needs no training."""
    path = tmp_path_factory.mktemp("fuzz")
    make_files(path, with_run=False)
    return path


def test_whole_files_are_read(folder: Path) -> None:
    for name in QUICK:
        if name in ("f.npz", "scene.npz", "scene.mat", "look.npz"):
            continue  # some of their readers want other arrays
        for line in READERS[name]:
            outcome = run_in_process(folder, line)
            assert outcome.status == 0, (line, outcome.err)
            for path in folder.glob("out*"):
                path.unlink()


@pytest.mark.parametrize("part", range(4))
def test_mutated_files_never_crash_a_command(folder: Path, part: int) -> None:
    assert faults(folder, QUICK, SEED + part, 100) == []


def test_the_fuzzer_notices_partial_files_and_exceptions(folder: Path) -> None:
    def left(where: Path, line: str) -> Outcome:
        (where / "out.npz").write_bytes(b"")
        return Outcome(2, "", "error[NS0801]: refused\n")

    def elsewhere(where: Path, line: str) -> Outcome:
        (where / "other.npz").write_bytes(b"")
        return Outcome(0, "", "")

    def fails(where: Path, line: str) -> Outcome:
        raise ZeroDivisionError

    for run, what in (
        (left, "left ['out.npz']"),
        (elsewhere, "wrote ['other.npz']"),
        (fails, "ZeroDivision"),
        (lambda *_: Outcome(70, "", ""), "status 70"),
        (lambda *_: Outcome(2, "", ""), "without"),
    ):
        fault = fault_of(folder, "check p.nsl", run)
        assert fault is not None
        assert what in fault


@pytest.fixture(scope="module")
def folder_with_run(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """One file of every kind, and a finished run."""
    path = tmp_path_factory.mktemp("fuzz_run")
    make_files(path, with_run=True)
    return path


@pytest.mark.slow
@pytest.mark.parametrize("part", range(20))
def test_ten_thousand_mutated_files_are_read_or_refused(folder_with_run: Path, part: int) -> None:
    assert faults(folder_with_run, EVERY, SEED + 100 + part, 500) == []


@pytest.mark.slow
def test_processes_read_or_refuse_two_hundred_mutated_files(folder_with_run: Path) -> None:
    assert faults(folder_with_run, EVERY, SEED + 200, 200, run_command) == []


if __name__ == "__main__":
    import warnings

    warnings.simplefilter("error", RuntimeWarning)
    with TemporaryDirectory() as name:
        make_files(Path(name), with_run="--run" in sys.argv)
        names = EVERY if "--run" in sys.argv else QUICK
        found = faults(Path(name), names, int(sys.argv[1]), int(sys.argv[2]))
        print(*found, f"{len(found)} faults", sep="\n" + "-" * 80 + "\n")
