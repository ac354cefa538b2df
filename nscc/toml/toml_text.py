"""TOML as text: parsing, the places of keys, and the spelling of values."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping
from typing import Any

from nscc.mappings import JsonObject
from nscc.source import Span

LARGEST_FILE = 64 * 1024
"""Largest TOML file that is read, in bytes."""
_LONGEST_LINE = 1000
"""Most characters of a line."""


class NotToml(Exception):
    """Raised for bytes that are not a TOML file; the text is the reason, as half a sentence."""


def parsed(data: bytes) -> tuple[str, JsonObject]:
    """Return the text and the values of a TOML file, of which `data` are the bytes. A byte order
    mark is dropped, and line ends become LF.

    Raises NotToml if it is too large, has an overlong line, is not UTF-8, or is not TOML."""
    try:
        if len(data) > LARGEST_FILE:
            raise NotToml(f"it is larger than {LARGEST_FILE // 1024} KiB")
        text = data.decode("utf-8-sig").replace("\r\n", "\n")
        longest = max(map(len, text.split("\n")))
        if longest > _LONGEST_LINE:
            raise NotToml(
                f"a line has {longest} characters, but at most {_LONGEST_LINE} are allowed"
            )
        return text, tomllib.loads(text)
    except UnicodeDecodeError as error:
        raise NotToml(f"byte {error.start} is not UTF-8 text") from error
    except RecursionError as error:
        raise NotToml("it is nested too deeply") from error
    except ValueError as error:
        raise NotToml(str(error).replace("\n", " ")[:200]) from error


def span_of(text: str, section: str, name: str) -> Span:
    """Return the place of the key `name` of the table `section` in a TOML text.

    With the section "", `name` may also be a table. Names of keys and tables are without quotes. Of
    equal keys, the first counts. If the key is missing, the place is its table's header, or else
    the first line."""
    # `current` is the table of a line, `offset` the start of the line.
    current, offset, header = "", 0, Span(0, len(text.partition("\n")[0]))
    for line in text.split("\n"):
        stripped = line.strip()
        opened = re.match(r"\[+\s*([^\]\s]+)\s*\]", stripped)
        begin = offset + len(line) - len(line.lstrip())
        if opened:
            current = opened[1].strip("\"'")
            if current in (section, name):
                header = Span(begin, begin + len(opened[0]))
            if current == name and not section:
                return header
        elif current == section and stripped.split("=")[0].strip().strip("\"'") == name:
            return Span(begin, begin + len(stripped.partition("#")[0].rstrip()))
        offset += len(line) + 1
    return header


def shown(value: Any) -> str:
    """Describe any value in a message: at most 60 characters, on one line. Texts, numbers and
    booleans are as TOML writes them; lists only have their length."""
    if isinstance(value, Mapping):
        return "a table"
    if isinstance(value, list | tuple):
        return "an empty list" if not value else f"a list of {len(value)}"
    if isinstance(value, bool):
        return "true" if value else "false"
    # Its digits would not fit the message, and Python writes at most 4300.
    if isinstance(value, int) and abs(value) > 10**20:
        return "a huge number"
    text = ascii(value) if isinstance(value, str) else str(value)
    return text if len(text) <= 60 else text[:57] + "..."


def spelled_value(text: str) -> Any:
    """Return the value that a text spells in TOML, or the text itself if it is not a TOML value."""
    try:
        document = tomllib.loads(f"value = {text}")
    except (ValueError, RecursionError):
        return text
    # A line break in the text could begin further keys.
    return document["value"] if document.keys() == {"value"} else text


def written(value: Any) -> str:
    """Return the TOML spelling of `value`: a text, number, boolean, or list or tuple of these.
    Other values are not checked."""
    if isinstance(value, str):
        return '"' + "".join(map(_character, value)) + '"'
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, list | tuple):
        return "[" + ", ".join(map(written, value)) + "]"
    return repr(value)


def _character(c: str) -> str:
    """Return the character `c` as a TOML string contains it, with escapes for quotes and
    unprintable ones."""
    if c in '"\\':
        return "\\" + c
    return c if c.isprintable() else f"\\u{ord(c):04x}" if ord(c) < 1 << 16 else f"\\U{ord(c):08x}"
