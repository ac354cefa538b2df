"""What a tradeoff has measured, kept as it is measured: killed and started again, it goes on."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from types import TracebackType
from typing import Any, Self

from nscc.diagnostics.rejection import rejected
from nscc.lines import Lines


class Rows:
    """Measurements by name. Without a file they are made, and kept nowhere.

    `file` has a line for each, JSON, on the disk as soon as it is measured. Its first line is `of`,
    the digest of all that decides them: what was measured of anything else is dropped. One process
    at a time has the file, to the end of a `with`; who interrupts it is told of the file. Raises
    Rejected: NS0825 where another process has it, NS0784 where it cannot be written.
    """

    def __init__(self, file: Path | None = None, of: str = "") -> None:
        self._path, self._known = file, dict[str, Any]()
        self._lines: Lines | None = None
        if file is None:
            return
        try:
            self._lines = Lines(file)
        except BlockingIOError:
            raise rejected(
                "NS0825",
                f"another measurement is writing '{file}'",
                helps=("wait for it, end it, or give -o another name",),
            ) from None
        except OSError as error:
            raise rejected(
                "NS0784",
                f"cannot write '{file}': {error.strerror or error}",
                helps=("give -o a name in a folder that you may write to",),
            ) from error
        head, *rows = self._lines.lines or [""]
        if head == of:
            self._known = dict(filter(None, map(_row, rows)))
        else:
            self._lines.clear()
            self._lines.add(of + "\n")

    def once(self, name: str, measure: Callable[[], Any]) -> Any:
        """What `measure` gives, as JSON has it (tuples are lists); made only where it is not known
        by that name."""
        if self._lines is None:
            return measure()
        if name not in self._known:
            line = json.dumps([name, measure()])
            self._lines.add(line + "\n", sync=True)
            self._known[name] = json.loads(line)[1]
        return self._known[name]

    def done(self) -> None:
        """Removes the file: the products hold what it held, and who measures again wants new
        times."""
        if self._path is not None:
            self._path.unlink(missing_ok=True)

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, _type: type[BaseException] | None, value: BaseException | None,
        _trace: TracebackType | None,
    ) -> None:  # fmt: skip
        if self._lines is None:
            return
        self._lines.close()
        if isinstance(value, KeyboardInterrupt) and self._known:
            raise KeyboardInterrupt(
                f"what was measured is kept in '{self._path}', and the same command goes on"
            ) from value


def _row(line: str) -> tuple[str, Any] | None:
    """Name and value of a line; None for one that is none: that is measured again."""
    try:
        name, value = json.loads(line)
    except (ValueError, TypeError, RecursionError):
        return None
    return (name, value) if isinstance(name, str) else None
