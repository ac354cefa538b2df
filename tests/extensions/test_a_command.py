"""Recipe: a command of another distribution's, beside nscc's own."""

from __future__ import annotations

from pathlib import Path

import pytest
from added_package import add_package, nscc_with

SOURCE = '''
from pathlib import Path

import click

from nscc.containers import load_container
from nscc.files import write_whole
from nscc_cli.support import CommonCommand, say


@click.command("shine", cls=CommonCommand)
@click.argument("program", type=click.Path(path_type=Path))
@click.option("-o", "out", required=True, type=click.Path(path_type=Path))
def command(program, out):
    """Write how many words a program has."""
    container, messages = load_container(program)
    say(messages)
    write_whole(out, f"{sum(len(kernel.words) for kernel in container.kernels)}\\n".encode())


text = "no command"
'''
PROGRAM = "nsl 1 frame 4 slots of 1ms code stop : 1..4 open when n < stop"


def test_a_command_of_another_package_has_help_errors_and_suggestions(tmp_path: Path) -> None:
    add_package(tmp_path, SOURCE, "nscc.commands", "shine", "command")
    (tmp_path / "p.nsl").write_text(PROGRAM)
    assert "Write how many words" in nscc_with(tmp_path, "--help").stdout
    assert "-o" in nscc_with(tmp_path, "shine", "--help").stdout
    done = nscc_with(tmp_path, "shine", "p.nsl", "-o", "words.txt")
    assert done.returncode == 0, done.stderr
    assert int((tmp_path / "words.txt").read_text()) > 0
    for arguments, code in (("p.nsl", "NS0780"), ("no.nsl -o w.txt", "NS0101")):
        wrong = nscc_with(tmp_path, "shine", *arguments.split(), "--message-format", "short")
        assert wrong.returncode == 2
        assert code in wrong.stderr
    assert "nscc shine" in nscc_with(tmp_path, "shin").stderr


@pytest.mark.parametrize(("name", "value"), [("shine", "text"), ("check", "command")])
def test_invalid_commands_and_taken_names_are_refused(
    tmp_path: Path, name: str, value: str
) -> None:
    add_package(tmp_path, SOURCE, "nscc.commands", name, value)
    (tmp_path / "p.nsl").write_text(PROGRAM)
    done = nscc_with(tmp_path, "shine")
    assert (done.returncode, f"[NS0905]: the command '{name}'" in done.stderr) == (2, True)
    listed = nscc_with(tmp_path, "--help")
    assert (listed.returncode, "NS0905" in listed.stderr) == (0, True)
    assert nscc_with(tmp_path, "check", "p.nsl").returncode == 0
