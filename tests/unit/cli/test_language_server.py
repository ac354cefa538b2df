"""What the language server publishes: the diagnostics of the newest text, and of no older one."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from threading import Event
from typing import Any

import pytest

pytest.importorskip("pygls")

from lsprotocol import types

from nscc_cli import language_server

URI = "file:///a.nsl"
GOOD = "nsl 1\nframe 4 slots of 1ms\nopen when n < 2\n"


class SlowChecks:
    """A server whose checks wait for `go_on`, and what it publishes."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.server = language_server.make_server()
        self.published: list[tuple[int | None, int]] = []
        self.is_checking, self.go_on = Event(), Event()
        checked = language_server._checked

        def publish(said: types.PublishDiagnosticsParams) -> None:
            self.published.append((said.version, len(said.diagnostics)))

        def slowly(document: Any) -> Any:
            self.is_checking.set()
            self.go_on.wait(60)
            return checked(document)

        monkeypatch.setattr(self.server, "text_document_publish_diagnostics", publish)
        monkeypatch.setattr(language_server, "_checked", slowly)

    def run(self, meanwhile: Callable[[], object]) -> list[tuple[int | None, int]]:
        """Versions and counts that are published if something happens during the first check."""

        async def session() -> None:
            self.server.take(URI, "open when m < 2\n", 1)
            await asyncio.to_thread(self.is_checking.wait, 60)
            meanwhile()
            self.go_on.set()
            await asyncio.get_running_loop().run_in_executor(self.server.worker, lambda: None)
            await asyncio.sleep(0)

        asyncio.run(asyncio.wait_for(session(), 60))
        self.server.worker.shutdown()
        return self.published


def test_diagnostics_of_an_older_text_are_not_published(monkeypatch: pytest.MonkeyPatch) -> None:
    """A text of version 2 arrives while version 1 is checked: only the diagnostics of version 2 are
    sent."""
    checks = SlowChecks(monkeypatch)
    assert checks.run(lambda: checks.server.take(URI, GOOD, 2)) == [(2, 0)]


@pytest.mark.parametrize("ending", [types.SHUTDOWN, types.EXIT])
def test_a_server_that_ends_publishes_no_more(monkeypatch: pytest.MonkeyPatch, ending: str) -> None:
    """The editor has closed what the server writes to."""
    checks = SlowChecks(monkeypatch)
    end = checks.server.protocol.fm.features[ending]
    assert checks.run(lambda: end(None)) == []
