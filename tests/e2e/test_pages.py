"""The pages of `nscc explain`: what they call bad raises their code, what they call good passes.

A page's console lines run one after the other in a folder that holds `ok.nsl`.
"""

from __future__ import annotations

import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

import pytest
from checkout import ROOT
from nscc_command import Outcome, invoke

pytestmark = pytest.mark.pages

PAGES = sorted((ROOT / "nscc/diagnostics/pages").glob("*.md"))
SOURCES = sorted(
    path for part in ("cli", "nscc", "runtime", "training") for path in ROOT.glob(f"{part}/**/*.py")
)
HEADINGS = ["What it means", "Bad", "Good", "What to do"]

OK = """nsl 1
frame 4 slots of 1ms
code stop : 1..4
open when n < stop
pixels stop = tile [[4, 3], [2, 1]]
"""

_CODE = re.compile(r"NS\d{4}")
_BLOCK = re.compile(r"^```(\w+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
_SHELL = re.compile(r"[|&;<>()$`\\*?]")


@pytest.fixture(scope="session")
def tools(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder for PATH with `nscc` and `python`, both of this interpreter."""
    folder = tmp_path_factory.mktemp("tools")
    for name, arguments in (("python", ""), ("nscc", " -m nscc_cli")):
        script = folder / name
        script.write_text(f'#!/bin/sh\nexec {shlex.quote(sys.executable)}{arguments} "$@"\n')
        script.chmod(0o755)
    return folder


@pytest.mark.parametrize("path", [pytest.param(page, id=page.stem) for page in PAGES])
def test_programs_on_a_message_page_fail_and_pass_as_the_page_says(
    path: Path, tmp_path: Path, tools: Path
) -> None:
    text, code = path.read_text(), path.name[:6]
    title, *parts = re.split(r"^## (.+)$", text, flags=re.MULTILINE)
    assert re.fullmatch(rf"# {code}: \S.*\n\n", title), "the title is `# CODE: what it is`"
    assert parts[0::2] == HEADINGS
    sections = dict(zip(parts[0::2], parts[1::2], strict=True))
    bad, good = (_BLOCK.findall(sections[name]) for name in ("Bad", "Good"))
    assert bad
    assert good
    for index, (kind, block) in enumerate(bad + good):
        folder = tmp_path / str(index)
        folder.mkdir()
        (folder / "ok.nsl").write_text(OK)
        outcomes = _follow(kind, block, folder, tools)
        expected_to_work = outcomes if index >= len(bad) else outcomes[:-1]
        for outcome in expected_to_work:
            assert outcome.status == 0, outcome.err
        if index < len(bad):
            assert f"[{code}]" in outcomes[-1].err, outcomes[-1]
        else:
            assert f"[{code}]" not in "".join(outcome.err for outcome in outcomes)


def test_every_code_has_a_page_and_every_page_a_code() -> None:
    raised = {code for path in SOURCES for code in _CODE.findall(path.read_text())}
    assert raised == {path.name[:6] for path in PAGES}


def test_names_are_kebab_case_and_codes_have_one_page() -> None:
    assert len({path.name[:6] for path in PAGES}) == len(PAGES)
    assert all(re.fullmatch(r"NS\d{4}(-[a-z0-9]+)+\.md", path.name) for path in PAGES)


def _follow(kind: str, block: str, folder: Path, tools: Path) -> list[Outcome]:
    """What the lines of a block say, one after the other; a program is checked."""
    if kind == "nsl":
        (folder / "program.nsl").write_text(block)
        return [invoke(["check", "program.nsl"], folder)]
    assert kind == "console", f"a block of kind {kind!r}"
    lines = block.splitlines()
    assert all(line.startswith("$ ") for line in lines), "console lines begin with `$ `"
    return [_run(line[2:], folder, tools) for line in lines]


def _run(line: str, folder: Path, tools: Path) -> Outcome:
    """One line of a console: plain `nscc` commands in this process, the rest in a shell."""
    if line.startswith("nscc ") and not _SHELL.search(line):
        return invoke(shlex.split(line)[1:], folder)
    path = os.pathsep.join([str(tools), os.environ["PATH"]])
    python_path = os.pathsep.join(str(ROOT / part) for part in (".", "cli", "runtime", "training"))
    done = subprocess.run(
        ["/bin/sh", "-c", line],
        cwd=folder,
        env={**os.environ, "PATH": path, "PYTHONPATH": python_path},
        capture_output=True,
        text=True,
        timeout=100,
    )
    return Outcome(done.returncode, done.stdout, done.stderr)
