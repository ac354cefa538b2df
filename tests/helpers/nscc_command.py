"""`nscc` as a function: the same front door as the process's, without starting one."""

from __future__ import annotations

import io
import os
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import NamedTuple


class Outcome(NamedTuple):
    """What a command left: its exit status and all it wrote."""

    status: int
    out: str
    err: str

    @property
    def codes(self) -> list[str]:
        """The codes of the messages in human form, in their order."""
        from re import MULTILINE, findall

        return findall(r"^(?:error|warning|note)\[(NS\d{4})\]", self.err, MULTILINE)


RunNscc = Callable[[Sequence[str], Path], Outcome]
"""`run_nscc(arguments, folder)`, the fixture: status, standard output, standard error."""


def invoke(arguments: Sequence[str], folder: Path, given: bytes = b"") -> Outcome:
    """Runs `nscc ARGUMENTS` in `folder`, with `given` on standard input."""
    from nscc_cli.main import main

    with _process(folder, given) as (out, err):
        status = main([str(argument) for argument in arguments])
    return Outcome(status, _text(out), _text(err))


@contextmanager
def _process(folder: Path, given: bytes) -> Iterator[tuple[io.TextIOWrapper, io.TextIOWrapper]]:
    """Another current folder and other standard streams, as a new process would have them."""
    before, streams = Path.cwd(), (sys.stdin, sys.stdout, sys.stderr)
    out, err = (io.TextIOWrapper(io.BytesIO(), "utf-8", newline="\n") for _ in range(2))
    os.chdir(folder)
    sys.stdin = io.TextIOWrapper(io.BytesIO(given), "utf-8")
    sys.stdout, sys.stderr = out, err
    try:
        yield out, err
    finally:
        sys.stdin, sys.stdout, sys.stderr = streams
        os.chdir(before)


def _text(stream: io.TextIOWrapper) -> str:
    stream.flush()
    buffer = stream.buffer
    assert isinstance(buffer, io.BytesIO)
    return buffer.getvalue().decode("utf-8", "replace")
