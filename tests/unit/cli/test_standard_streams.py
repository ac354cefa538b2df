"""Standard streams that are closed or full: the work is done; only a lost product is an error."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

TEXT = "nsl 1\nframe 2 slots of 1ms\nopen when true\n"


def run(folder: Path, line: str, redirections: str) -> tuple[int, str]:
    """Exit status and printed text of a command, in a shell with redirections."""
    (folder / "p.nsl").write_text(TEXT)
    nscc = f"'{sys.executable}' -m nscc_cli"
    done = subprocess.run(
        ["sh", "-c", f"exec {nscc} {line} {redirections}"],
        cwd=folder,
        capture_output=True,
        text=True,
        check=False,
        env={**os.environ, "NSCC_CACHE": "off"},
    )
    return done.returncode, done.stdout + done.stderr


@pytest.mark.parametrize(
    "closed", [">&-", "2>&-", ">&- 2>&-", "<&- >&- 2>&-", ">/dev/full", "2>/dev/full"]
)
def test_products_are_written_although_standard_streams_are_closed_or_full(
    tmp_path: Path, closed: str
) -> None:
    """With stdin, stdout or stderr closed or full, files are written with the same bytes and status
    0."""
    assert run(tmp_path, "build p.nsl -o p.icw", closed)[0] == 0
    whole = (tmp_path / "p.icw").read_bytes()
    (tmp_path / "p.icw").unlink()
    assert run(tmp_path, "build p.nsl -o p.icw", "")[0] == 0
    assert (tmp_path / "p.icw").read_bytes() == whole
    assert run(tmp_path, "disasm p.icw -o p.asm", closed)[0] == 0
    assert run(tmp_path, "fmt p.nsl", closed)[0] == 0


@pytest.mark.parametrize("closed", [">&-", ">/dev/full"])
@pytest.mark.parametrize("line", ["disasm p.icw", "explain NS0101", "build p.nsl -o /dev/stdout"])
def test_a_product_that_cannot_be_printed_is_an_error(
    tmp_path: Path, line: str, closed: str
) -> None:
    """If the product itself goes to a closed or full stdout, the status is 2 with NS0784."""
    assert run(tmp_path, "build p.nsl -o p.icw", "")[0] == 0
    status, said = run(tmp_path, line, closed)
    assert (status, "NS0784" in said) == (2, True), said


def test_a_rejected_program_keeps_its_status(tmp_path: Path) -> None:
    """With a closed or full stream a wrong program has status 1, and a wrong command 2."""
    (tmp_path / "q.nsl").write_text("nsl 1\nopen when true\n")
    for closed in (">&-", "2>&-", "2>/dev/full"):
        assert run(tmp_path, "check q.nsl", closed)[0] == 1
        assert run(tmp_path, "nothing", closed)[0] == 2
