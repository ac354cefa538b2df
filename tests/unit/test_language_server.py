"""What the language server publishes: the diagnostics of the newest text, and of no older one."""

from __future__ import annotations

import asyncio
from threading import Event
from typing import Any

import pytest

pytest.importorskip("pygls")

from nscc_cli import language_server

URI = "file:///a.nsl"
GOOD = "nsl 1\nframe 4 slots of 1ms\nopen when n < 2\n"


def test_diagnostics_of_an_older_text_are_not_published(monkeypatch: pytest.MonkeyPatch) -> None:
    """A newer text comes while the older one is being checked."""
    server = language_server.Server()
    published: list[tuple[int | None, int]] = []
    monkeypatch.setattr(
        server, "text_document_publish_diagnostics",
        lambda said: published.append((said.version, len(said.diagnostics))),
    )  # fmt: skip
    is_checking, go_on = Event(), Event()
    checked = language_server._checked

    def slowly(document: Any) -> Any:
        is_checking.set()
        go_on.wait(60)
        return checked(document)

    monkeypatch.setattr(language_server, "_checked", slowly)

    async def session() -> None:
        server.take(URI, "open when m < 2\n", 1)
        await asyncio.to_thread(is_checking.wait, 60)
        server.take(URI, GOOD, 2)
        go_on.set()
        while not published:
            await asyncio.sleep(0.01)
        await asyncio.get_running_loop().run_in_executor(server.worker, lambda: None)
        await asyncio.sleep(0)

    asyncio.run(asyncio.wait_for(session(), 60))
    server.worker.shutdown()
    assert published == [(2, 0)]
