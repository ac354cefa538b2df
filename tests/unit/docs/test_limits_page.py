"""The table in docs/limits.md is what the command prints.

`pytest tests/unit/docs/test_limits_page.py -m slow --update-cases` rewrites it; read the
difference.
"""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import pytest
from checkout import ROOT
from nscc_command import invoke

PAGE = ROOT / "docs" / "limits.md"


@pytest.mark.slow
def test_the_table_is_what_the_command_prints(tmp_path: Path, update_cases: bool) -> None:
    text = PAGE.read_text()
    [command] = re.findall(r"^\$ nscc (.*)$", text, re.M)
    printed = invoke(shlex.split(command), tmp_path)
    assert printed.status == 0, printed.err
    head, rest = text.split("```text\n", 1)
    shown, tail = rest.split("```\n", 1)
    if update_cases:
        PAGE.write_text(f"{head}```text\n{printed.out}```\n{tail}")
    else:
        assert shown == printed.out
