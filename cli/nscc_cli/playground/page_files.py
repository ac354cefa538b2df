"""The files of the playground page."""

from __future__ import annotations

from pathlib import Path

PAGE = Path(__file__).with_name("page")
TYPES = {
    ".html": "text/html; charset=utf-8",
    ".js": "text/javascript; charset=utf-8",
    ".css": "text/css; charset=utf-8",
    ".json": "application/json",
}
"""The content types of files, by ending."""
SERVER = {"engine": "server"}
"""`config.json` of a page that `nscc play` serves."""


def page_file(name: str) -> bytes | None:
    """Return a file of the page; None for any other name."""
    files = {path.name: path for path in PAGE.iterdir() if path.suffix in TYPES}
    return files[name].read_bytes() if name in files else None
