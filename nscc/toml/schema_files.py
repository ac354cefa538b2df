"""Reading of files with a schema, with all errors at once, and writing of complete files."""

from __future__ import annotations

import textwrap
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

from nscc.diagnostics.diagnostic import Diagnostic
from nscc.diagnostics.rejection import rejected
from nscc.files import reads
from nscc.source import Source
from nscc.toml.schema import KeyValues, Row, Schema
from nscc.toml.toml_text import LARGEST_FILE, NotToml, parsed, written

WIDTH = 100
_REMARK_COLUMN = 42


def file_bytes(schema: Schema[Row], path: Path, name: str = "") -> bytes:
    """Read the bytes of a user's file; raise Rejected (status 2) if that fails.

    Messages call the file `name`, by default its path."""
    reads(path)
    try:
        with open(path, "rb") as file:
            return file.read(LARGEST_FILE + 1)
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise rejected(
            schema.codes.unreadable,
            f"the {schema.file_kind} file {(name or str(path))[:200]!a} cannot be read: {reason}",
            helps=(schema.start,),
        ) from None


def file_values(
    schema: Schema[Row], data: bytes, name: str, *, status: int = 2,
    choose: Callable[[Mapping[str, Any]], Schema[Row]] | None = None,
) -> tuple[KeyValues, list[Diagnostic], Source]:  # fmt: skip
    """Return the valid values in a file's bytes, the errors of the others, and the text.

    Messages call the file `name`. `choose` selects one of several schemas by the file's values.
    Raises Rejected (`status`) for text that is not TOML."""
    values, source = file_table(schema, data, name, status=status)
    chosen = schema if choose is None else choose(values)
    return *chosen.read(values, source), source


def file_table(
    schema: Schema[Row], data: bytes, name: str, *, status: int = 2
) -> tuple[dict[str, Any], Source]:
    """Return the unchecked TOML values of a file, and its text."""
    try:
        text, values = parsed(data)
    except NotToml as reason:
        raise rejected(
            schema.codes.not_toml,
            f"the {schema.file_kind} file {name[:200]!a} is not a TOML table: {reason}",
            helps=(schema.start,),
            status=status,
        ) from None
    return values, Source(name, text)


def file_text(
    schema: Schema[Row],
    values: Mapping[str, Any],
    remark: Callable[[Row], str],
    head: Sequence[str] = (),
    *,
    beside: bool = False,
) -> str:
    """Return a complete file with the given values, which are keyed by path.

    `head` are comments at the start. `remark` returns the comment of a key, which is written above
    its line, or with `beside` at its end."""
    lines = [f"# {line}" for line in head]
    for heading, heading_text in schema.headings.items():
        rows = [key for key in schema.keys if key.heading == heading]
        if heading and rows:
            lines += [""] if lines else []
            title = f"[{heading}]" if rows[0].section else f"## {heading}: {heading_text}"
            lines.append(_beside(title, heading_text if rows[0].section and beside else ""))
        for key in rows:
            line = f"{key.name} = {written(key.kind.plain(values[key.path]))}"
            text = remark(key)
            if beside and len(line) <= 60:
                lines.append(_beside(line, text))
            else:
                width = 1000 if beside else WIDTH - 2
                lines += [*(f"# {comment}" for comment in textwrap.wrap(text, width)), line]
    return "\n".join(lines) + "\n"


def _beside(line: str, remark: str) -> str:
    return f"{line:<{_REMARK_COLUMN}} # {remark}" if remark else line
