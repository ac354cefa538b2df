"""What commands share: progress and messages."""

from __future__ import annotations

import io
import os
import sys
from pathlib import Path
from time import sleep

import pytest

from nscc_cli.support import bar_line, progress, waiting


class Terminal(io.StringIO):
    """A terminal that remembers what was drawn on it."""

    def isatty(self) -> bool:
        return True


def test_progress_yields_its_items_unchanged(monkeypatch: pytest.MonkeyPatch) -> None:
    """Five items pass in order. Nothing is drawn, as they take less than a second."""
    for stream in (io.StringIO(), Terminal()):
        monkeypatch.setattr(sys, "stderr", stream)
        assert list(progress(range(5), "counting")) == [0, 1, 2, 3, 4]
        assert stream.getvalue() == ""  # far less than a second


def test_the_bar_shows_share_and_time_left() -> None:
    """At 25 of 100 after 3 s, 9 s are left. Without a total the count is shown, and beyond the
    total 100 %."""
    assert bar_line("light", 25, 100, 3.0) == f"light [{'#' * 8}{'.' * 22}]  25%, 9 s left"
    assert bar_line("light", 7, None, 2.0) == "light: 7, 2 s"
    assert "100%" in bar_line("light", 300, 100, 1.0)


def test_waiting_is_shown_on_a_terminal_and_erased_afterwards(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("nscc_cli.support._BAR_DELAY_S", 0.0)
    monkeypatch.setenv("COLUMNS", "30")
    terminal = Terminal()
    monkeypatch.setattr(sys, "stderr", terminal)
    with waiting("compiling " + "x" * 50):
        for _ in range(10_000):
            if "compiling" in terminal.getvalue():
                break
            sleep(0.001)
    first, *_, last = terminal.getvalue().split("\r\x1b[2K")[1:]
    assert first == ("compiling " + "x" * 50)[:29]
    assert last == ""


def test_nothing_is_drawn_in_a_pipe_or_within_a_second(monkeypatch: pytest.MonkeyPatch) -> None:
    """A pipe shows nothing at once, and a terminal nothing before the delay is over."""
    for stream, delay_s in ((io.StringIO(), 0.0), (Terminal(), 60.0)):
        monkeypatch.setattr("nscc_cli.support._BAR_DELAY_S", delay_s)
        monkeypatch.setattr(sys, "stderr", stream)
        with waiting("compiling"):
            sleep(0.01)
        assert stream.getvalue() == ""


def test_a_build_that_takes_long_says_so(tmp_path: Path) -> None:
    """`nscc build` runs in a process with a terminal of its own."""
    import pty
    import subprocess

    text = "nsl 1\nframe 4 slots of 1ms\ncode stop : 1..4\nopen when n < stop\n"
    (tmp_path / "p.nsl").write_text(text)
    slow = (
        "import sys, nscc_cli.support as s, nscc.compiler as c, time\n"
        "s._BAR_DELAY_S, made = 0.0, c.compile_file\n"
        "c.compile_file = lambda *a: (time.sleep(0.2), made(*a))[1]\n"
        "from nscc_cli.main import main\n"
        "sys.exit(main(['build', 'p.nsl']))\n"
    )
    ours, theirs = pty.openpty()
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    done = subprocess.run(
        [sys.executable, "-c", slow], cwd=tmp_path, env=environment, stderr=theirs, timeout=60
    )
    os.close(theirs)
    drawn = os.read(ours, 1 << 16).decode()
    os.close(ours)
    assert done.returncode == 0
    assert "\r\x1b[2Kcompiling p.nsl at -O2: 0 s" in drawn
    assert drawn.rindex("\r\x1b[2Kwrote p.icw") > drawn.rindex("compiling")
