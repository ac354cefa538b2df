"""The pages that people read: every program in them compiles, every command in them works."""

from __future__ import annotations

import ast
import re
import shlex
import shutil
from pathlib import Path
from typing import Any

import pytest
from checkout import ROOT
from nscc_command import invoke

from nscc_runtime.effects import registered

pytestmark = pytest.mark.pages

PAGES = (
    "README.md",
    "ARCHITECTURE.md",
    "CONTRIBUTING.md",
    "CHANGELOG.md",
    "examples/README.md",
    *sorted(
        path.relative_to(ROOT).as_posix()
        for path in (ROOT / "docs").rglob("*.md")
        # docs/limits.md, whose commands take long, has tests of its own.
        if "generated" not in path.parts and path.name != "limits.md"
    ),
)
"""Every page but those that the site's build makes. Cells of notebooks are run by that build."""


def blocks(page: str, language: str) -> list[str]:
    """The fenced blocks of a language on a page."""
    return re.findall(rf"^```{language}\n(.*?)^```$", (ROOT / page).read_text(), re.M | re.S)


PROGRAMS = [
    pytest.param(text, id=f"{page}-{number}")
    for page in PAGES
    for number, text in enumerate(blocks(page, "nsl"))
]


@pytest.mark.parametrize("text", PROGRAMS)
def test_programs_on_pages_compile(text: str, tmp_path: Path) -> None:
    """Each program printed on a page passes `nscc check` without a warning."""
    (tmp_path / "page.nsl").write_text(text)
    outcome = invoke(["check", "page.nsl", "--deny-warnings"], tmp_path)
    assert outcome.status == 0, outcome.err


def test_programs_are_the_examples() -> None:
    shown = blocks("README.md", "nsl")
    for name, program in zip(("hdr_2x2",), shown, strict=True):
        assert (ROOT / "examples" / f"{name}.nsl").read_text().endswith(program)


def test_pages_show_the_output_of_check() -> None:
    [shown] = blocks("README.md", "text")
    assert invoke(["check", "examples/hdr_2x2.nsl"], ROOT).out == shown


@pytest.mark.parametrize("page", PAGES)
def test_commands_on_pages_work(page: str, tmp_path: Path) -> None:
    """Each `nscc` line ends with status 0 in a folder with the examples. Each `make` line names a
    target of the Makefile."""
    shutil.copytree(ROOT / "examples", tmp_path / "examples")
    (tmp_path / "build").mkdir()
    for line in "".join(blocks(page, "console")).splitlines():
        assert line.startswith("$ ")
        program, *arguments = shlex.split(line[2:], comments=True)
        # A target may take hours, so it is only looked up.
        if program == "make":
            assert f"\n{arguments[0]}:" in (ROOT / "Makefile").read_text()
        else:
            assert program == "nscc"
            outcome = invoke(arguments, tmp_path)
            assert outcome.status == 0, outcome.err


def test_the_python_code_on_the_home_page_of_the_site_works(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The code leaves a `frame` with a plan and an estimate of the light of 1 x 256 x 256
    values."""
    monkeypatch.chdir(tmp_path)
    [code] = blocks("docs/index.md", "python")
    names: dict[str, Any] = {}
    exec(code, names)
    assert names["frame"].plan is not None
    assert names["frame"].light_e_per_s().shape == (1, 256, 256)


def test_the_python_code_of_the_readme_works_after_its_commands(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The code reads the files that the commands wrote: a frame of 1 x 256 x 256 electrons."""
    test_commands_on_pages_work("README.md", tmp_path)
    monkeypatch.chdir(tmp_path)
    names: dict[str, object] = {}
    for text in blocks("README.md", "python"):
        exec(text, names)
    assert names["frame"]["exposure_e"].shape == (1, 256, 256)  # type: ignore[index]


def test_the_python_code_on_the_emulator_page_captures_with_the_plan_that_it_makes(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    shutil.copytree(ROOT / "examples", tmp_path / "examples")
    monkeypatch.chdir(tmp_path)
    names: dict[str, Any] = {}
    for text in blocks("docs/emulator.md", "python"):
        exec(text, names)
    taken, chosen, batch = names["taken"], names["chosen"], names["batch"]
    assert taken.exposure_e.shape == taken.frame.shape == (3, 1, 256, 256)
    assert taken.plan.names("dropped") == chosen.names("dropped")
    assert taken.plan.tolerance_e == chosen.tolerance_e
    assert 0 < chosen.predicted_e <= 4.5
    assert "shot" in names["kept"]
    assert [each.plan.tolerance_e for each in batch] == [2.0, 2.0, 2.0]


def test_the_table_of_a_plan_is_that_of_its_command(tmp_path: Path) -> None:
    """Effects and what becomes of them; figures may differ in their last digits."""
    shown, *_ = blocks("docs/emulator.md", "text")
    command = next(line for line in blocks("docs/emulator.md", "console") if "--audit" in line)
    shutil.copytree(ROOT / "examples", tmp_path / "examples")
    (tmp_path / "build").mkdir()
    outcome = invoke(shlex.split(command[2:])[1:], tmp_path)

    def rows(text: str) -> list[tuple[str, str]]:
        found = re.findall(r"^(\w+) .*?(kept|dropped|absent)\b", text, re.M)
        return [(name, choice) for name, choice in found if name != "effect"]

    assert len(rows(shown)) == len(registered())
    assert rows(outcome.err) == rows(shown)
    for figure in ("predicted error", "audit: measured"):
        values = [float(re.search(rf"{figure} ([\d.]+)", text)[1]) for text in (shown, outcome.err)]  # type: ignore[index]
        assert values[0] == pytest.approx(values[1], rel=0.1)


@pytest.mark.parametrize("page", PAGES)
def test_links_lead_to_existing_pages(page: str) -> None:
    """Links to generated pages are left out, because the build of the site checks them."""
    for link in re.findall(r"\]\(([^)#]+)\)", (ROOT / page).read_text()):
        assert (
            "://" in link
            or "generated" in Path(link).parts
            or ((ROOT / page).parent / link).exists()
        ), link


@pytest.mark.parametrize("page", ["ARCHITECTURE.md", "CONTRIBUTING.md", "docs/encodings.md"])
def test_files_that_a_page_names_are_there(page: str) -> None:
    """Each path in backquotes exists below the repository, `runtime` or the training package."""
    named = re.findall(r"`([\w.*-]+/[\w./*-]*)`", (ROOT / page).read_text())
    folders = (ROOT, ROOT / "runtime", ROOT / "training/nscc_training")
    assert named
    assert not [n for n in named if not any([*folder.glob(n.rstrip("/"))] for folder in folders)]


def defined(path: Path) -> set[str]:
    """The names that a module defines, those in its classes as CLASS.NAME."""
    names = set()
    for node in ast.parse(path.read_text()).body:
        inner = node.body if isinstance(node, ast.ClassDef) else []
        names |= {f"{node.name}.{each.name}" for each in inner if isinstance(each, ast.FunctionDef)}  # type: ignore[attr-defined]
        targets = [node.target] if isinstance(node, ast.AnnAssign) else getattr(node, "targets", [])
        names |= {getattr(each, "name", getattr(each, "id", "")) for each in (node, *targets)}
    return names


def test_functions_that_the_architecture_names_are_defined_where_it_says() -> None:
    """Each `NAME` (`PATH`) and `NAME` in `PATH` is defined in that file. The tables from light to a
    frame name a function in each row: without effects (N), with effects (E), with images (I)."""
    text = (ROOT / "ARCHITECTURE.md").read_text()
    named = re.findall(r"`([A-Za-z_.]+)`,?\s+(?:in |\()`([\w/]+\.py)`", text)
    assert len(named) > 40
    for name, path in named:
        (file,) = (root / path for root in (ROOT, ROOT / "runtime") if (root / path).exists())
        assert name in defined(file), f"{name} in {path}"
    rows = re.findall(r"^\| ([NEI]\d[a-d]?)\. [^|]+ \| `[\w.]+` \(`", text, re.M)
    steps = "N1 N2 N2a N2b N2c N3 N4 N5 N5a N5b N5c N5d N6 N7 N8 E4 E5 E6 E6a E7 E7a E7b E7c E7d"
    assert rows == f"{steps} E8 E8a E8b E8c E9 I4 I5 I6 I7 I8 I8a I8b I8c I8d".split()


def test_every_command_is_listed_by_its_task() -> None:
    """Each command of a group in `nscc --help` stands in the section of that title in
    `docs/commands.md`."""
    from nscc_cli.group import GROUPS

    text = (ROOT / "docs/commands.md").read_text()
    sections = dict(re.findall(r"^## ([^\n]*)\n(.*?)(?=^## |\Z)", text, re.M | re.S))
    for title, lines in GROUPS.items():
        assert [name for name in lines if f"`nscc {name}" not in sections[title]] == []


def test_the_python_code_on_the_training_page_works() -> None:
    """The code prints two things, the second of which is a program text."""
    pytest.importorskip("torch")
    [text] = blocks("docs/training.md", "python")
    printed: list[object] = []
    exec(text, {"print": printed.append})
    assert len(printed) == 2
    assert str(printed[1]).startswith("nsl 1")
