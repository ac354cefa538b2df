"""Texts of the training package's error messages."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from nscc.diagnostics.diagnostic import Rejected, rejected

if TYPE_CHECKING:  # It needs numpy, whose absence is one of the problems.
    from nscc.npy import InvalidArrays


def listed(names: Sequence[str], most: int = 12) -> str:
    """Return at most `most` names as text, each cut to 40 characters: `a, b, c and 4 more`. Without
    names the text is `nothing`."""
    shown = ", ".join(name[:40] for name in names[:most]) or "nothing"
    return shown + (f" and {len(names) - most} more" if len(names) > most else "")


def one_line(error: object, most: int = 200) -> str:
    """Return the text of `error`, usually an exception, in one line: white space becomes single
    spaces, and the text is cut after `most` characters. It may be empty."""
    return " ".join(str(error).split())[:most]


def why_no_arrays(error: InvalidArrays | OSError) -> str:
    """Return why a file could not be read as an .npz of named arrays: the part of the message after
    the file's name. `error` is what its reader raised."""
    if isinstance(error, OSError):
        missing = isinstance(error, FileNotFoundError)
        return "the file does not exist" if missing else (error.strerror or str(error)).lower()
    return one_line(error)


def is_out_of_memory(error: Exception) -> bool:
    """Return whether an error says that memory is exhausted, on the GPU or on the host. Torch,
    which has its own types for this, is not imported."""
    return isinstance(error, MemoryError) or (
        isinstance(error, RuntimeError)
        and (type(error).__name__ == "OutOfMemoryError" or "DefaultCPUAllocator" in str(error))
    )


def unreadable(code: str, message: str, error: Exception, help_text: str) -> Rejected:
    """Return the refusal with `code` and `message` of a file that its reader could not read.

    The reader's `error` becomes a note, and `help_text` says what to do."""
    notes = (f"the reader says: {one_line(error)}",) if one_line(error) else ()
    return rejected(code, message, notes=notes, helps=(help_text,))


def invalid_setting(key: str, reason: object) -> Rejected:
    """Return the error (NS0815) that the value of `key` in a training configuration is invalid,
    because of `reason`."""
    return rejected(
        "NS0815",
        f"invalid setting {key}: {' '.join(str(reason).split())}",
        helps=("`nscc train --schema` prints the allowed values of every key",),
    )
