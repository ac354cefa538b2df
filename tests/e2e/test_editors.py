"""The extension for VS Code, as far as a machine without a screen can try it."""

from __future__ import annotations

import json
import os
import re
import shutil
import socket
import subprocess
import sys
import zipfile
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import pytest
from checkout import ROOT
from textmate_colours import Token, colours

import nscc
from nscc.source import Source
from nscc.syntax.lexer import lex

EXTENSION = ROOT / "editors" / "vscode"
EXAMPLES = sorted((ROOT / "examples").glob("*.nsl"))
SOURCE = (EXTENSION / "src" / "extension.js").read_text()

SCOPES = {
    "TEXT": "string.", "INTEGER": "constant.numeric.", "TIME": "constant.numeric.time.",
    "GROUPED": "constant.numeric.digits.", "LEVEL": "constant.numeric.level.", "NAME": "variable.",
    "TARGET_NAME": "entity.name.type.", "COMPARISON": "keyword.operator.", "[": "punctuation.",
    "]": "punctuation.", "(": "punctuation.", ")": "punctuation.", ",": "punctuation.",
    "true": "constant.language.", "false": "constant.language.", "min": "support.function.",
    "max": "support.function.", "FUNCTION": "entity.name.function.", "PLACE": "punctuation.",
    "AMOUNT": "constant.numeric.level.",
}  # fmt: skip
"""What tokens of the compiler's lexer are coloured as; other words and signs are keywords."""


def package() -> Any:
    return json.loads((EXTENSION / "package.json").read_text())


def assert_coloured(text: str, found: Iterable[Token]) -> None:
    """Every token and comment of a program has the scope of its kind."""
    at = {(row, start): (end, scope) for row, start, end, scope in found}
    tokens = lex(Source("a.nsl", text))
    wanted = [(tokens.span(k), SCOPES.get(kind, "keyword.")) for k, kind in enumerate(tokens.kinds)]
    for span, scope in wanted:
        if text[span.start : span.end] == "exposure":  # a name in images, a word elsewhere
            scope = "keyword."
        row = text.count("\n", 0, span.start)
        start = span.start - (text.rfind("\n", 0, span.start) + 1)
        end, given = at[row, start]
        assert (text[span.start : span.end], end - start) == (
            text[span.start : span.end],
            span.end - span.start,
        )
        assert given.startswith(scope), (text[span.start : span.end], given)
    lines = text.split("\n")
    assert all(
        scope == "comment.line.number-sign.nsl" or "#" not in lines[row][start:end]
        for (row, start), (end, scope) in at.items()
    )


def test_the_committed_grammar_equals_the_generated_one() -> None:
    """`editors/textmate.py --check` makes the grammar anew and finds no difference."""
    made = subprocess.run([sys.executable, str(ROOT / "editors/textmate.py"), "--check"])
    assert made.returncode == 0


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_programs_have_the_recorded_colours(path: Path) -> None:
    """The grammar gives each token of an example the recorded colour."""
    grammar = json.loads((EXTENSION / "syntaxes/nsl.tmLanguage.json").read_text())
    text = path.read_text(encoding="utf-8")
    assert_coloured(text, colours(grammar, text))


def test_words_of_version_2_have_no_colour_in_version_1() -> None:
    grammar = json.loads((EXTENSION / "syntaxes/nsl.tmLanguage.json").read_text())
    for version, scope in ((1, "variable.other.nsl"), (2, "keyword.control.nsl")):
        found = colours(grammar, f"# nsl 2 and nsl 1\nnsl {version}\nlet a = 1 + sense")
        assert found[-1] == (2, 12, 17, scope)


def test_files_commands_and_settings_of_the_extension_exist() -> None:
    """Commands and settings in `package.json` are those that the source uses. Its files exist, and
    its version is nscc's."""
    about = package()
    assert about["version"] == nscc.__version__
    contributed = about["contributes"]
    files = [contributed["grammars"][0]["path"], contributed["languages"][0]["configuration"]]
    assert all(isinstance(json.loads((EXTENSION / name).read_text()), dict) for name in files)
    commands = {each["command"] for each in contributed["commands"]}
    assert commands == set(re.findall(r'"(nscc\.\w+)"', SOURCE))
    for menu in contributed["menus"].values():
        assert {item["command"] for item in menu} <= commands
    settings = {name.removeprefix("nscc.") for name in contributed["configuration"]["properties"]}
    assert settings == set(re.findall(r'\.get\("(\w+)"\)', SOURCE))
    assert "node_modules" not in {path.name for path in EXTENSION.iterdir()}


@pytest.mark.slow
def test_the_packed_extension_colours_programs_and_shows_answers_of_the_server(
    tmp_path: Path,
) -> None:
    """`make vsix` packs the extension. The colouring library of VS Code reads its grammar; Node
    runs the extension with `nscc lsp`, without a window."""
    if not shutil.which("npm"):
        pytest.skip("npm is not there")
    subprocess.run(["make", "vsix", f"OUT={tmp_path}"], cwd=ROOT, check=True, timeout=600)
    built = tmp_path / "vscode"
    for path in EXAMPLES:
        found = said_by("colours.js", built, path)
        assert_coloured(path.read_text(encoding="utf-8"), [tuple(each) for each in found])
    with zipfile.ZipFile(tmp_path / "nscc.vsix") as packed:
        packed.extractall(tmp_path / "packed")
    unpacked = tmp_path / "packed" / "extension"
    names = {path.relative_to(unpacked).as_posix() for path in unpacked.rglob("*.js*")}
    assert names == {
        "package.json",
        "language-configuration.json",
        "dist/extension.js",
        "syntaxes/nsl.tmLanguage.json",
    }
    program = tmp_path / "a.nsl"
    program.write_text("nsl 1\nframe 8 slots of 1ms\nopen when n <= 7\n")
    command = json.dumps([sys.executable, "-m", "nscc_cli"])
    seen = said_by("host.js", unpacked, program, command)
    assert seen["diagnostics"][0] == []
    assert seen["drawn"] == [True, True]
    assert seen["messages"] == ["built a.icw"]
    program.write_text("nsl 1\nframe 8 slots of 1ms\nopen when m < 7\n")
    failed = subprocess.run(
        ["node", str(ROOT / "tests/editors/host.js"), str(unpacked), str(program), command],
        capture_output=True,
        text=True,
    )
    assert '[["NS0214",2]]' in failed.stdout + failed.stderr


@pytest.mark.slow
def test_the_packed_extension_works_in_a_window_of_vs_code(tmp_path: Path) -> None:
    """A browser opens VS Code, which code-server serves, with the packed extension. NSCC_EDITOR
    names the folder in which `npm install code-server playwright-core` was run."""
    modules, browser = Path(os.environ.get("NSCC_EDITOR", "")) / "node_modules", which_browser()
    server = modules / "code-server/out/node/entry.js"
    if not (server.is_file() and browser):
        pytest.skip("NSCC_EDITOR names no folder with code-server, or chromium is not there")
    subprocess.run(["make", "vsix", f"OUT={tmp_path}"], cwd=ROOT, check=True, timeout=600)
    folder, port = tmp_path / "programs", free_port()
    folder.mkdir()
    program = Path(shutil.copy(ROOT / "examples/class_b.nsl", folder))
    settings = tmp_path / "data/User/settings.json"
    settings.parent.mkdir(parents=True)
    settings.write_text(
        json.dumps(
            {
                "nscc.command": [sys.executable, "-m", "nscc_cli"],
                "security.workspace.trust.enabled": False,
                "workbench.startupEditor": "none",
            }
        )
    )
    own = ["--extensions-dir", str(tmp_path / "ext"), "--user-data-dir", str(tmp_path / "data")]
    start = ["node", str(server), *own]
    subprocess.run([*start, "--install-extension", str(tmp_path / "nscc.vsix")], check=True)
    address = f"127.0.0.1:{port}"
    options = ["--auth", "none", "--bind-addr", address, "--disable-telemetry"]
    with subprocess.Popen([*start, *options], stdout=subprocess.PIPE, text=True) as serving:
        try:
            assert serving.stdout
            assert any("HTTP server listening" in line for line in serving.stdout)
            seen = said_by(
                "workbench.mjs", modules / "playwright-core", browser, f"http://{address}", program
            )
        finally:
            serving.terminate()
    assert re.search(r"\d+ words a frame, shortest slot", seen["remark"].replace("\xa0", " "))
    assert seen["language"] == "Shutter program"
    assert seen["tabs"][0].strip() == "class_b.nsl"
    assert len(seen["tabs"]) == 2
    assert any("NS0205" in each and "given twice" in each for each in seen["problems"])


def which_browser() -> str | None:
    return shutil.which("chromium") or shutil.which("google-chrome")


def free_port() -> int:
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        return int(taken.getsockname()[1])


def said_by(script: str, *arguments: object) -> Any:
    found = subprocess.run(
        ["node", str(ROOT / "tests/editors" / script), *map(str, arguments)],
        capture_output=True,
        text=True,
        timeout=300,
    )
    assert found.returncode == 0, found.stderr
    return json.loads(found.stdout)
