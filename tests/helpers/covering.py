"""A plugin of pytest that records which functions of the product each file of tests runs.

`pytest -p covering` with COVERING=FOLDER writes a JSON file of each process into that folder:
by file of tests the functions that it runs, as PATH:FIRST_LINE.
"""

from __future__ import annotations

import json
import os
import sys
import threading
from collections import defaultdict
from pathlib import Path
from types import CodeType, FrameType
from typing import Any

import pytest
from checkout import ROOT

PRODUCT = tuple(f"{ROOT / name}{os.sep}" for name in ("nscc", "runtime", "training", "cli"))

_run_by: dict[str, set[CodeType]] = defaultdict(set)
_now: set[CodeType] = set()


def _note(frame: FrameType, event: str, _argument: Any) -> None:
    if event == "call" and frame.f_code not in _now:
        _now.add(frame.f_code)


def pytest_runtest_protocol(item: pytest.Item) -> None:
    """Record what the next test runs under its file's name."""
    global _now
    _now = _run_by[item.path.relative_to(ROOT).as_posix()]
    sys.setprofile(_note)
    threading.setprofile(_note)


def pytest_sessionfinish() -> None:
    """Write what was recorded in this process."""
    sys.setprofile(None)
    threading.setprofile(None)
    found = {
        name: sorted(
            f"{Path(code.co_filename).relative_to(ROOT).as_posix()}:{code.co_firstlineno}"
            for code in codes
            if code.co_filename.startswith(PRODUCT)
        )
        for name, codes in _run_by.items()
    }
    if found:
        path = Path(os.environ["COVERING"]) / f"{os.getpid()}.json"
        path.write_text(json.dumps(found))
