"""The lines of docs/commands.md that make a shell complete `nscc`, and what is offered then."""

from __future__ import annotations

import os
import re
import shlex
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import click
import pytest

from nscc_cli.completion import EFFECTS, SCENE, SETTING, TARGET
from nscc_cli.group import group
from nscc_cli.main import main

SHELLS = ("bash", "zsh", "fish")


@pytest.fixture
def environment(tmp_path: Path) -> dict[str, str]:
    """One with `nscc` on its path."""
    script = tmp_path / "nscc"
    script.write_text(f'#!/bin/sh\nexec {shlex.quote(sys.executable)} -m nscc_cli "$@"\n')
    script.chmod(0o755)
    path = os.pathsep.join([str(tmp_path), os.environ["PATH"]])
    return {**os.environ, "PATH": path, "PYTHONPATH": os.pathsep.join(sys.path)}


def said_in(page: str, shell: str) -> str:
    """The line for a shell; zsh's is bash's with another word."""
    (bash,) = re.findall(r'`(eval "\$\(_NSCC_COMPLETE=bash_source nscc\)")`', page)
    (fish,) = re.findall(r"`(_NSCC_COMPLETE=fish_source nscc \| source)`", page)
    assert "`zsh_source`" in page
    return {"bash": bash, "zsh": bash.replace("bash_source", "zsh_source"), "fish": fish}[shell]


@pytest.mark.parametrize("shell", SHELLS)
def test_the_documented_line_prints_the_script_of_a_shell(
    shell: str, environment: dict[str, str], root: Path
) -> None:
    line = said_in((root / "docs/commands.md").read_text(), shell)
    variable = line[line.index("_NSCC") :].split()[0]
    found = subprocess.run(
        [environment["PATH"].partition(os.pathsep)[0] + "/nscc"],
        capture_output=True,
        text=True,
        env={**environment, **dict([variable.split("=")])},
    )
    assert (found.returncode, found.stderr) == (0, "")
    assert f"_NSCC_COMPLETE={shell}_complete" in found.stdout
    if shutil.which(shell):
        checked = subprocess.run([shell, "-n"], input=found.stdout, text=True, capture_output=True)
        assert (checked.returncode, checked.stderr) == (0, "")


def offers(
    shell: str, typed: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> list[tuple[str, str]]:
    """Kind and text of what is offered for the last word, read as that shell's script does."""
    words = typed.split(" ")
    monkeypatch.setenv("_NSCC_COMPLETE", f"{shell}_complete")
    monkeypatch.setenv("COMP_WORDS", typed)
    monkeypatch.setenv("COMP_CWORD", words[-1] if shell == "fish" else str(len(words) - 1))
    assert main([]) == 0
    lines = capsys.readouterr().out.splitlines()
    if shell == "zsh":  # three lines each: kind, text, description
        return [*zip(lines[::3], lines[1::3], strict=True)]
    pairs = (line.partition(",") for line in lines)
    return [(kind, text.partition("\t")[0]) for kind, _, text in pairs]


@pytest.mark.parametrize("shell", SHELLS)
@pytest.mark.parametrize(
    ("typed", "offered"),
    [
        ("nscc bu", ["build"]),
        ("nscc run p.nsl --tol", ["--tolerance"]),
        ("nscc evaluate comp", ["compare"]),
        ("nscc check --lowering l", ["latch"]),
        ("nscc check --target scamp5-", ["file: scamp5-", "scamp5-algorithm1"]),
        ("nscc targets sc", ["file: sc", "scamp5", "scamp5-algorithm1", "scamp7"]),
        ("nscc targets --compare scamp7 dual", ["file: dual", "dual-tap"]),
        ("nscc check a", ["file: a"]),
        ("nscc run --scene builtin:f", ["file: builtin:f", "builtin:flat:"]),
        ("nscc run --effects al", ["all"]),
        ("nscc run --effects shot,+prn", ["shot,+prnu"]),
        ("nscc run --sensor-set dark_c", ["dark_current_e_per_s="]),
        ("nscc effects sho", ["shot"]),
        ("nscc explain NS0412", ["NS0412"]),
        ("nscc examples class_b", ["class_b", "class_b_4096"]),
        ("nscc build --emit icw,rep", ["icw,report"]),
        ("nscc run --keep tr", ["truth"]),
        ("nscc reconstruct a", ["dir: a", "any"]),
        ("nscc run --like my", ["dir: my", "my_run"]),
        ("nscc run --like deep/", ["dir: deep/", "deep/other"]),
        ("nscc evaluate of x --protocol sc", ["sci8"]),
    ],
)
def test_completion_offers_files_runs_and_names(
    shell: str,
    typed: str,
    offered: list[str],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    for run in ("my_run", "deep/other"):
        (tmp_path / run).mkdir(parents=True)
        (tmp_path / run / "config.resolved.toml").touch()
    (tmp_path / "my_other_folder").mkdir()
    monkeypatch.chdir(tmp_path)
    found = offers(shell, typed, monkeypatch, capsys)
    assert [text if kind == "plain" else f"{kind}: {text}" for kind, text in found] == offered


def commands(group: click.Group, context: click.Context) -> Iterator[click.Command]:
    """All commands below a group."""
    for name in group.list_commands(context):
        found = group.get_command(context, name)
        assert found is not None
        yield found
        if isinstance(found, click.Group):
            yield from commands(found, context)


def test_options_of_one_name_have_the_same_type_in_every_command() -> None:
    """The type determines what the shell offers."""
    known = {"--target": TARGET, "--scene": SCENE, "--effects": EFFECTS, "--sensor-set": SETTING}
    asked = [
        (option, command.name, parameter.type)
        for command in commands(group, click.Context(group))
        for parameter in command.params
        for option in known.keys() & {*parameter.opts}
    ]
    assert len(asked) > 10
    assert [each for each in asked if each[2] is not known[each[0]]] == []


def test_the_fish_script_keeps_values_with_commas_whole(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """The script splits a line of the completion at its first comma only."""
    monkeypatch.setenv("_NSCC_COMPLETE", "fish_source")
    assert main([]) == 0
    assert "(string split --max 1 , $completion)" in capsys.readouterr().out


def test_bash_runs_the_completion_script(environment: dict[str, str], root: Path) -> None:
    line = said_in((root / "docs/commands.md").read_text(), "bash")
    script = (
        f"{line}\nCOMP_WORDS=(nscc bui)\nCOMP_CWORD=1\n"
        "$(complete -p nscc | sed 's/.*-F \\([^ ]*\\).*/\\1/') nscc bui nscc\n"
        'echo "${COMPREPLY[@]}"'
    )
    found = subprocess.run(["bash", "-c", script], capture_output=True, text=True, env=environment)
    assert (found.stdout.strip(), found.stderr) == ("build", "")
