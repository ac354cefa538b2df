"""The list of long tests names functions that exist."""

from __future__ import annotations

import re

from checkout import ROOT


def test_every_listed_long_test_is_a_function_of_its_file() -> None:
    """A function that was renamed or deleted would stay in the list, and its tests would run with
    `make test` again."""
    missing = []
    for line in (ROOT / "tests/data/long_tests.txt").read_text(encoding="utf-8").split():
        file, *_, function = line.split("::")
        defined = rf"^ *def {re.escape(function)}\("
        path = ROOT / file
        if not path.is_file() or not re.search(defined, path.read_text(encoding="utf-8"), re.M):
            missing.append(line)
    assert missing == []
