"""The lines of README that make a shell complete `nscc`."""

from __future__ import annotations

import os
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

SHELLS = ("bash", "zsh", "fish")


@pytest.fixture
def environment(tmp_path: Path) -> dict[str, str]:
    """One with `nscc` on its path."""
    script = tmp_path / "nscc"
    script.write_text(f'#!/bin/sh\nexec {shlex.quote(sys.executable)} -m nscc_cli "$@"\n')
    script.chmod(0o755)
    path = os.pathsep.join([str(tmp_path), os.environ["PATH"]])
    return {**os.environ, "PATH": path, "PYTHONPATH": os.pathsep.join(sys.path)}


def said_in(readme: str, shell: str) -> str:
    """The line for a shell; zsh's is bash's with another word."""
    (bash,) = re.findall(r'`(eval "\$\(_NSCC_COMPLETE=bash_source nscc\)")`', readme)
    (fish,) = re.findall(r"`(_NSCC_COMPLETE=fish_source nscc \| source)`", readme)
    assert "`zsh_source`" in readme
    return {"bash": bash, "zsh": bash.replace("bash_source", "zsh_source"), "fish": fish}[shell]


@pytest.mark.parametrize("shell", SHELLS)
def test_the_script_of_a_shell(shell: str, environment: dict[str, str], root: Path) -> None:
    line = said_in((root / "README.md").read_text(), shell)
    variable = line[line.index("_NSCC") :].split()[0]
    found = subprocess.run(
        [environment["PATH"].partition(os.pathsep)[0] + "/nscc"], capture_output=True, text=True,
        env={**environment, **dict([variable.split("=")])},
    )  # fmt: skip
    assert (found.returncode, found.stderr) == (0, "")
    assert f"_NSCC_COMPLETE={shell}_complete" in found.stdout
    if shutil.which(shell):
        checked = subprocess.run([shell, "-n"], input=found.stdout, text=True, capture_output=True)
        assert (checked.returncode, checked.stderr) == (0, "")


@pytest.mark.parametrize("shell", SHELLS)
@pytest.mark.parametrize(("typed", "last", "offered"), [
    ("nscc bu", "bu", "build"), ("nscc run p.nsl --tol", "--tol", "--tolerance"),
    ("nscc evaluate comp", "comp", "compare"),
])  # fmt: skip
def test_what_is_offered(
    shell: str, typed: str, last: str, offered: str, environment: dict[str, str]
) -> None:
    """As the scripts ask: fish hands over the last word, the others its number."""
    count = str(len(typed.split()) - 1)
    asked = {"_NSCC_COMPLETE": f"{shell}_complete", "COMP_WORDS": typed,
             "COMP_CWORD": last if shell == "fish" else count}  # fmt: skip
    found = subprocess.run(["nscc"], capture_output=True, text=True, env={**environment, **asked})
    assert found.returncode == 0
    assert offered in re.split(r"[,\s]", found.stdout)


def test_bash_itself_completes(environment: dict[str, str], root: Path) -> None:
    line = said_in((root / "README.md").read_text(), "bash")
    script = (
        f"{line}\nCOMP_WORDS=(nscc bui)\nCOMP_CWORD=1\n"
        "$(complete -p nscc | sed 's/.*-F \\([^ ]*\\).*/\\1/') nscc bui nscc\n"
        'echo "${COMPREPLY[@]}"'
    )
    found = subprocess.run(
        ["bash", "-c", script], capture_output=True, text=True, env=environment
    )  # fmt: skip
    assert (found.stdout.strip(), found.stderr) == ("build", "")
