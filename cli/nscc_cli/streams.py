"""The standard streams of a process: what cannot be printed is dropped, and does not end the work.

A stream may be closed when the process starts (`>&-`). Then its descriptor is occupied, because the
next file that is opened would get its number, and libraries would print into that file."""

from __future__ import annotations

import io
import os
import sys
from typing import Any

_ROOT = "/"
"""A folder that exists on every system."""


class _Dropping(io.RawIOBase):
    """A file object that writes to a descriptor. The first error is remembered as `failure`, and
    data that cannot be written is dropped."""

    def __init__(self, descriptor: int) -> None:
        """Write to the file descriptor `descriptor`, a number such as 1 for standard output, and
        remember the first failure."""
        self.descriptor = descriptor
        self.failure: OSError | None = None

    def writable(self) -> bool:
        """Return True."""
        return True

    def fileno(self) -> int:
        """Return the descriptor."""
        return self.descriptor

    def isatty(self) -> bool:
        """Return whether the descriptor is a terminal."""
        return os.isatty(self.descriptor)

    def write(self, data: Any) -> int | None:
        """Write as much of `data` as the descriptor takes, and return the number of bytes; None if
        the descriptor does not block and can take nothing now.

        After an error, the data counts as written. Raises BrokenPipeError if the reader of standard
        output is gone, which ends a command early."""
        try:
            return os.write(self.descriptor, data)
        except BlockingIOError:
            return None
        except OSError as error:
            if isinstance(error, BrokenPipeError) and self.descriptor == 1:
                raise
            reason = error.strerror or str(error)
            self.failure = self.failure or OSError(error.errno, reason, "standard output")
            return len(data)


def open_streams() -> None:
    """Replace the standard streams of this process by streams that drop what cannot be printed.

    The descriptor of a stream that was closed when the process started is occupied, so that no
    other file gets its number."""
    for number, name in enumerate(("stdin", "stdout", "stderr")):
        stream: Any = getattr(sys, name)
        if stream is None:
            # A folder in the place of standard output makes `-o /dev/stdout` fail.
            taken = os.open(_ROOT if number == 1 else os.devnull, os.O_RDONLY)
            if taken != number:
                os.dup2(taken, number)
                os.close(taken)
        if number == 0:
            sys.stdin = stream or open(0, encoding="utf-8")  # noqa: SIM115  # of the process
            continue
        setattr(
            sys,
            name,
            io.TextIOWrapper(
                io.BufferedWriter(_Dropping(number)),
                encoding=getattr(stream, "encoding", "utf-8"),
                errors=getattr(stream, "errors", "surrogateescape"),
                line_buffering=getattr(stream, "line_buffering", False) or number == 2,
            ),
        )


def output_failure() -> OSError | None:
    """Return the first error of standard output, if something could not be printed; else None.
    Before `open_streams` it is None."""
    raw = getattr(getattr(sys.stdout, "buffer", None), "raw", None)
    return raw.failure if isinstance(raw, _Dropping) else None
