"""Pages are filled with what commands print: the lines that they name, and nothing else."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import pytest
from checkout import ROOT

from figures import PRINTED, chosen, filled, printed

PAGE = """Before.

<!-- printed by: nscc this --that 'a b' | from ^effect | until ^$ -->

```text
effect  an old figure
```

```text
of another block
```
"""
OUTPUT = "warning: dark\neffect  shot\nadc  34 \n\nwrote x\n"


def test_a_block_is_what_its_command_prints() -> None:
    asked: list[str] = []

    def output_of(command: str) -> str:
        asked.append(command)
        return OUTPUT

    made = filled(PAGE, output_of)
    assert asked == ["nscc this --that 'a b'"]
    assert made == PAGE.replace("effect  an old figure", "effect  shot\nadc  34")
    assert filled(made, output_of) == made


def test_an_empty_block_is_filled_and_longer_fences_are_kept() -> None:
    page = "<!-- printed by: nscc x -->\n\n````text\n````\nAfter.\n"
    assert filled(page, lambda _: "```\nb\n") == page.replace("text\n", "text\n```\nb\n")


@pytest.mark.parametrize(
    ("clauses", "lines"),
    [
        ([], ["warning: dark", "effect  shot", "adc  34", "", "wrote x"]),
        (["from shot"], ["effect  shot", "adc  34", "", "wrote x"]),
        (["until ^$"], ["warning: dark", "effect  shot", "adc  34"]),
        (["only ^(adc|wrote)"], ["adc  34", "wrote x"]),
        (["from ^effect", "until ^wrote", "only [a-z]"], ["effect  shot", "adc  34"]),
        # A block that begins with the line at which it would end goes on to the next one.
        (["from ^adc", "until ^(adc|wrote)"], ["adc  34"]),
    ],
)
def test_clauses_choose_lines_of_an_output(clauses: list[str], lines: list[str]) -> None:
    assert chosen(OUTPUT, clauses) == lines


@pytest.mark.parametrize("clause", ["from ^photo", "only photo", "after ^effect"])
def test_a_clause_that_leaves_nothing_is_refused(clause: str) -> None:
    with pytest.raises(ValueError, match=r"photo|from, until, only"):
        chosen(OUTPUT, [clause])


def test_documented_commands_run_and_failures_show_their_output(tmp_path: Path) -> None:
    assert printed("nscc --help").startswith("Usage: nscc")
    wrong = tmp_path / "wrong.py"
    wrong.write_text("print('half')\nraise SystemExit(3)\n")
    with pytest.raises(RuntimeError, match="status 3\nhalf"):
        printed(f"python {wrong}")


def test_pages_name_commands_that_there_are() -> None:
    """And no page says by hand that a block is printed: the comment is right to the letter."""
    for page in [*ROOT.glob("docs/*.md"), ROOT / "README.md"]:
        text = page.read_text()
        found = [match[2] for match in PRINTED.finditer(text)]
        assert len(found) == text.count("<!-- printed by:"), page.name
        for named in found:
            command, *clauses = named.split(" | ")
            program, *arguments = shlex.split(command)
            assert program == "nscc" or (ROOT / arguments[0]).is_file()
            for clause in clauses:
                kind, pattern = clause.split(" ", 1)
                assert kind in ("from", "until", "only")
                re.compile(pattern)
