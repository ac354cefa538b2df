"""What commands share: progress and messages."""

from __future__ import annotations

import io
import sys

import pytest

from nscc_cli.support import bar_line, progress


def test_progress_hands_on_what_it_gets(monkeypatch: pytest.MonkeyPatch) -> None:
    class Terminal(io.StringIO):
        def isatty(self) -> bool:
            return True

    for stream in (io.StringIO(), Terminal()):
        monkeypatch.setattr(sys, "stderr", stream)
        assert list(progress(range(5), "counting")) == [0, 1, 2, 3, 4]
        assert stream.getvalue() == ""  # far less than a second


def test_the_bar_shows_share_and_time_left() -> None:
    assert bar_line("light", 25, 100, 3.0) == f"light [{'#' * 8}{'.' * 22}]  25%, 9 s left"
    assert bar_line("light", 7, None, 2.0) == "light: 7, 2 s"
    assert "100%" in bar_line("light", 300, 100, 1.0)
