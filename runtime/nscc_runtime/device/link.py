"""Run a host's tasks over a real port, in real time: the link of `nscc run --on PORT`."""

from __future__ import annotations

import select
from collections.abc import Callable, Iterator
from contextlib import suppress
from random import SystemRandom
from time import monotonic
from typing import Any, Self, TypeVar

from nscc_runtime.device.device_errors import explained, port_lost, port_trouble
from nscc_runtime.device.host import Host, Task
from nscc_runtime.device.link_settings import LinkSettings
from nscc_runtime.device.port import Port, PortGone, PortTrouble, open_port

Result = TypeVar("Result")

_FIRST_REOPEN_S = 0.02
_LONGEST_REOPEN_S = 0.25
"""First and longest pause before a lost port is opened again."""
_GOODBYE_S = 0.5
"""Longest time to stop a device after an exception."""
_LONGEST_SLEEP_S = 0.25
"""Longest wait for bytes, after which the clock is looked at again."""
_WINDOW_BITS = 16384 * 10
"""Bits on the line of the largest window of a loader: a byte takes 10, with start and stop bit."""


class SerialLink:
    """An open port with its host. Methods raise Rejected (status 3) if the device fails. A lost
    port is reopened for at most `patience_s` seconds, and the task continues."""

    def __init__(
        self,
        path: str,
        *,
        baud: int = LinkSettings.baud,
        patience_s: float = LinkSettings.patience_s,
    ) -> None:
        """Open the port at `path` with `baud` bits per second; raise Rejected (NS0760, NS0761) if
        this fails.

        `patience_s` is the longest wait in seconds for an answer, and for a lost port to return."""
        self.path, self.baud, self.patience_s = path, baud, patience_s
        source = SystemRandom()
        self.host = Host(
            lambda: source.randrange(1, 1 << 32), patience_s=patience_s, line_s=_WINDOW_BITS / baud
        )
        self._waiting = b""
        try:
            self._port: Port | None = open_port(path, baud)
        except PortTrouble as trouble:
            raise port_trouble(path, trouble) from None

    def __enter__(self) -> Self:
        """Return the link, which is closed at the end of the `with` block."""
        return self

    def __exit__(self, kind: type[BaseException] | None, *_: object) -> None:
        """Close the port. If an exception ends the block (`kind` is its type, None without one),
        first stop the device, for at most `_GOODBYE_S`. The exception is raised again."""
        if self._port is not None and kind is not None and self.host.info is not None:
            with suppress(Exception):
                until = monotonic() + _GOODBYE_S
                self.host.start(self.host.cancel(), monotonic())
                while self.host.running and self._port is not None and monotonic() < until:
                    self._turn()
        if self._port is not None:
            self._port.close()

    def run(self, work: Callable[[], Task[Result]]) -> Result:
        """Run the task that `work` returns to its end, and return its result. After a lost line
        `work` is called again. Raises Rejected (status 3) if the device fails."""
        for _ in self.steps(work, lambda: 0):
            pass
        return self.host.result  # type: ignore[return-value]

    def steps(self, work: Callable[[], Task[Any]], reached: Callable[[], int]) -> Iterator[int]:
        """Run the task that `work` returns like `run`, and yield a count once for each unit by
        which `reached()`, the progress of the task, has grown. The result is then in
        `host.result`."""
        with explained(self.path, self.patience_s):
            self.host.start(self.host.lasting(work), monotonic())
            before = reached()
            while self.host.running:
                self._turn()
                while before < reached():
                    before += 1
                    yield before

    def _turn(self) -> None:
        """Send pending bytes, and wait for bytes or for the deadline; a lost port is closed and
        later reopened."""
        try:
            if self._port is None:
                self._reopen()
            self._exchange()
        except PortGone:
            if self._port is not None:
                self._port.close()
            self._port = None
            self._waiting = b""

    def _exchange(self) -> None:
        """Write what the host sends and pass on what arrives, waiting at most until its deadline,
        or for `_LONGEST_SLEEP_S`. Raises PortGone if the port is lost, and the exceptions of the
        task."""
        port = self._port
        assert port is not None
        self._waiting += self.host.poll(monotonic())
        if self._waiting:
            self._waiting = self._waiting[port.write(self._waiting) :]
        if not self.host.running:
            return
        wait_s = min(max(self.host.deadline - monotonic(), 0.0), _LONGEST_SLEEP_S)
        if select.select([port], [port] if self._waiting else [], [], wait_s)[0]:
            self.host.receive(port.read(), monotonic())

    def _reopen(self) -> None:
        """Open the port again, at growing intervals, and tell the host. Raises Rejected (NS0766) if
        it did not return within `patience_s`."""
        until, pause = monotonic() + self.patience_s, _FIRST_REOPEN_S
        while True:
            select.select([], [], [], pause)
            try:
                self._port = open_port(self.path, self.baud)
                break
            except PortTrouble:
                pause = min(2 * pause, _LONGEST_REOPEN_S)
            if monotonic() > until:
                raise port_lost(self.path, self.patience_s)
        self.host.line_restored(monotonic())
