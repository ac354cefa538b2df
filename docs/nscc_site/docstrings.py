"""Convert docstrings, in which names have backticks and code is indented, to reStructuredText."""

from __future__ import annotations

import re
from typing import Any

_CODE = "    "


def as_rst(_app: Any, _what: str, _name: str, _obj: Any, _options: Any, lines: list[str]) -> None:
    """Convert the lines of a docstring in place."""
    shown: list[str] = []
    in_code = False
    for line in lines:
        if line.strip() and not line.startswith(_CODE):
            in_code = False
        elif line.startswith(_CODE) and not in_code and not (shown and shown[-1].strip()):
            shown += ["::", ""]
            in_code = True
        shown.append(line if in_code else _escaped(line))
    lines[:] = shown


def _escaped(line: str) -> str:
    """Return a line with special characters of reStructuredText escaped outside backticks."""
    parts = re.split(r"(`[^`]*`)", line)
    return "".join(part if part[:1] == "`" else re.sub(r"([*|])", r"\\\1", part) for part in parts)
