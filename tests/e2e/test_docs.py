"""The pages that people read: every program in them compiles, every command in them works."""

from __future__ import annotations

import re
import shlex
import shutil
from pathlib import Path

import pytest
from nscc_command import invoke

ROOT = Path(__file__).resolve().parents[2]
PAGES = (
    "README.md",
    "docs/language.md",
    "docs/levels.md",
    "docs/encodings.md",
    "docs/cpp.md",
    "docs/calibrate.md",
    "docs/tradeoff.md",
    "docs/device.md",
    "docs/training.md",
    "docs/tradeoff_training.md",
    "examples/README.md",
)


def blocks(page: str, language: str) -> list[str]:
    """The fenced blocks of a language on a page."""
    return re.findall(rf"^```{language}\n(.*?)^```$", (ROOT / page).read_text(), re.M | re.S)


PROGRAMS = [
    pytest.param(text, id=f"{page}-{number}")
    for page in PAGES
    for number, text in enumerate(blocks(page, "nsl"))
]


@pytest.mark.parametrize("text", PROGRAMS)
def test_programs_compile(text: str, tmp_path: Path) -> None:
    (tmp_path / "page.nsl").write_text(text)
    outcome = invoke(["check", "page.nsl", "--deny-warnings"], tmp_path)
    assert outcome.status == 0, outcome.err


def test_first_program_is_the_example() -> None:
    [shown] = blocks("README.md", "nsl")
    assert (ROOT / "examples" / "hdr_2x2.nsl").read_text().endswith(shown)


def test_what_check_says_is_shown() -> None:
    [shown] = blocks("README.md", "text")
    assert invoke(["check", "examples/hdr_2x2.nsl"], ROOT).out == shown


@pytest.mark.parametrize("page", PAGES)
def test_commands_work(page: str, tmp_path: Path) -> None:
    shutil.copytree(ROOT / "examples", tmp_path / "examples")
    (tmp_path / "build").mkdir()
    for line in "".join(blocks(page, "console")).splitlines():
        assert line.startswith("$ ")
        program, *arguments = shlex.split(line[2:], comments=True)
        if program == "make":
            assert f"\n{arguments[0]}:" in (ROOT / "Makefile").read_text()
        else:
            assert program == "nscc"
            outcome = invoke(arguments, tmp_path)
            assert outcome.status == 0, outcome.err


def test_python_works_after_the_commands(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    test_commands_work("README.md", tmp_path)
    monkeypatch.chdir(tmp_path)
    names: dict[str, object] = {}
    for text in blocks("README.md", "python"):
        exec(text, names)
    assert names["frame"]["exposure_e"].shape == (1, 256, 256)  # type: ignore[index]


@pytest.mark.parametrize("page", PAGES)
def test_links_lead_somewhere(page: str) -> None:
    for link in re.findall(r"\]\(([^)#]+)\)", (ROOT / page).read_text()):
        assert "://" in link or ((ROOT / page).parent / link).exists(), link


def test_every_command_is_in_the_readme() -> None:
    from nscc.cli.table import COMMANDS

    text = (ROOT / "README.md").read_text()
    assert [entry.name for entry in COMMANDS if f"`nscc {entry.name}" not in text] == []


def test_the_python_of_training_works() -> None:
    pytest.importorskip("torch")
    [text] = blocks("docs/training.md", "python")
    printed: list[object] = []
    exec(text, {"print": printed.append})
    assert len(printed) == 2
    assert str(printed[1]).startswith("nsl 1")
