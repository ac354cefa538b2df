"""The page on one's own pictures: its cells run in order, as the build of the site runs them."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import pytest
from checkout import ROOT
from nscc_command import invoke

pytest.importorskip("torch")
pytest.importorskip("IPython")

pytestmark = pytest.mark.pages

PAGE = ROOT / "docs/tutorials/own_pictures.md"
COMMANDS = {"train", "evaluate", "build", "run", "reconstruct", "demo"}


def test_the_cells_of_the_tutorial_run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    cells = re.findall(r"^```\{code-cell\} ipython3\n(.*?)^```$", PAGE.read_text(), re.M | re.S)
    monkeypatch.chdir(tmp_path)
    run, names = set(), {}
    for cell in cells:
        commands = [line[1:] for line in cell.splitlines() if line.startswith("!")]
        if not commands:
            exec(compile(cell, PAGE.name, "exec"), names)
        for line in commands:
            program, *arguments = shlex.split(line)
            if program == "cat":
                assert Path(arguments[0]).read_text()
                continue
            assert program == "nscc"
            outcome = invoke(arguments, tmp_path)
            assert outcome.status == 0, outcome.err
            run.add(arguments[0])
    assert run == COMMANDS
    assert Path("own.cpp").is_file()
