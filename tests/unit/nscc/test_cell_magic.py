"""`%%nsl` in a shell of IPython."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from IPython.core.interactiveshell import InteractiveShell
from notebook_page import checked

import nscc

CELL = "nsl 1\nframe 8 slots of 1ms\ncode stop : 1..8\nopen when n < stop\n"


@pytest.fixture
def shell(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[InteractiveShell]:
    monkeypatch.setenv("IPYTHONDIR", str(tmp_path))
    InteractiveShell.clear_instance()
    found = InteractiveShell.instance()
    found.run_line_magic("load_ext", "nscc")
    yield found
    found.history_manager.end_session()  # type: ignore[union-attr]
    InteractiveShell.clear_instance()


def test_a_cell_is_shown_and_named(shell: InteractiveShell) -> None:
    """`%%nsl stops` sets the variable `stops` to the program, with the options of the line. Without
    options the level is 2."""
    result = shell.run_cell(f"%%nsl stops -O 1 --target scamp7\n{CELL}", store_history=False)
    program = result.result
    assert isinstance(program, nscc.ShutterProgram)
    assert program.target.name == "scamp7"
    assert shell.user_ns["stops"] is program
    assert program.name == "stops"
    page = checked(program)
    assert {"class", "words", "stop 1", "stop 8"} <= {*page.words}
    assert shell.run_cell(f"%%nsl\n{CELL}").result.options.level == 2


def test_messages_of_cells_have_no_traceback(
    shell: InteractiveShell, capsys: pytest.CaptureFixture[str]
) -> None:
    """A misspelt name gives NS0214 with the number of the cell, line and column, and no
    traceback."""
    result = shell.run_cell(f"%%nsl\n{CELL.replace('n < stop', 'n < stp')}")
    assert isinstance(result.error_in_exec, nscc.Rejected)
    said = "".join(capsys.readouterr())
    assert "error[NS0214]" in said
    assert f"In [{shell.execution_count}]:4:15" in said
    assert "Traceback" not in said
    assert "cell_magic.py" not in said


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ("-O 9", "is not a whole number from 0 to 3"),
        ("--max-words-per-slot 0", "number from 1"),
        ("--colour red", "unrecognized"),
        ("7up", "not a valid variable name"),
        ("'a", "quotation"),
    ],
)
def test_invalid_arguments_of_the_magic_are_explained(
    line: str, said: str, shell: InteractiveShell, capsys: pytest.CaptureFixture[str]
) -> None:
    result = shell.run_cell(f"%%nsl {line}\n{CELL}")
    assert result.error_in_exec is not None
    assert said in "".join(capsys.readouterr())


def test_every_option_of_the_cell_magic_is_passed_to_the_compiler(shell: InteractiveShell) -> None:
    """Level, codes, lowering, target and limit of words in the line are those of the program's
    options."""
    line = "-O 0 --codes open --lowering edges --target scamp7 --max-words-per-slot 99"
    options = shell.run_cell(f"%%nsl {line}\n{CELL}").result.options
    assert options.level == 0
    assert options.codes == "open"
    assert options.lowering == "edges"
    assert options.target == "scamp7"
    assert options.max_words_per_slot == 99
