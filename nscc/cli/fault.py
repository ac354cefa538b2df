"""What happens when nscc itself fails: a diagnostic, and a reproducer that can be sent to us."""

from __future__ import annotations

import io
import platform
import sys
import traceback
import zipfile
from collections.abc import Sequence
from hashlib import sha256
from pathlib import Path

from nscc import __version__
from nscc.diagnostics.model import Diagnostic, Rejected

FAULT = 70
FAILED = 3
_MOST_BYTES = 4 << 20


def explain_exception(error: BaseException, arguments: Sequence[str]) -> tuple[Diagnostic, int]:
    """The diagnostic and exit status of an exception that no command expects.

    NS0902 (status 3) where the machine ran out of memory or disk, else NS0901 (status 70) with a
    reproducer: the command line, versions, the traceback and the input files under 4 MiB.
    """
    if isinstance(error, MemoryError):
        return Diagnostic(
            "NS0902",
            "there is not enough memory for this",
            helps=("use fewer slots or codes, a smaller array, or a machine with more memory",),
        ), FAILED
    text = "".join(traceback.format_exception(error))
    saved = _save(text, arguments)
    where = f"saved as '{saved}'" if saved else "could not be saved in this folder"
    return Diagnostic(
        "NS0901",
        f"nscc itself failed: {type(error).__name__}: {str(error)[:200]}",
        notes=(f"this is a fault of nscc, not of your input; a reproducer {where}",),
        helps=("please report it with the reproducer (it holds the input files)",),
    ), FAULT


def _save(text: str, arguments: Sequence[str]) -> str | None:
    """Writes the reproducer into the current folder; its name, or None where that fails."""
    from nscc.cli.support import write_whole

    name = f"nscc-fault-{sha256(text.encode()).hexdigest()[:12]}.zip"
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w") as archive:
        archive.writestr("command.txt", "nscc " + " ".join(arguments) + "\n")
        archive.writestr("traceback.txt", text)
        versions = f"nscc {__version__}\nPython {sys.version}\n{platform.platform()}\n"
        archive.writestr("versions.txt", versions)
        for index, argument in enumerate(arguments):
            path = Path(argument)
            try:
                if path.is_file() and path.stat().st_size <= _MOST_BYTES:
                    archive.writestr(f"input{index}-{path.name}", path.read_bytes())
            except (OSError, ValueError):
                continue
    try:
        write_whole(Path(name), buffer.getvalue())
    except Rejected:
        return None
    return name
