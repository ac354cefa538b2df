"""Conversion of tutorial pages with `code-cell` blocks to Jupyter notebooks."""

from __future__ import annotations

import json
import re
from typing import Any

_CELL = re.compile(r"^```\{code-cell\}[^\n]*\n(.*?)^```$", re.MULTILINE | re.DOTALL)
_TAGS = re.compile(r"^:tags: *\[(.*)\]\n+")
_HEAD = re.compile(r"\A---\n.*?\n---\n", re.DOTALL)
_LOCAL_LINK = re.compile(r"\[([^\]]+)\]\((?!https?:)[^)]*\)")


def notebook(page: str) -> bytes:
    """Return the notebook file of a Markdown page, with its text and its code cells without
    outputs.

    Links to other pages become plain text, because a notebook is read outside the site."""
    texts = _CELL.split(_HEAD.sub("", page))  # text and code alternate
    cells = [_cell("code" if k % 2 else "markdown", text) for k, text in enumerate(texts)]
    kernel = {"display_name": "Python 3", "language": "python", "name": "python3"}
    document = {
        "cells": [cell for cell in cells if cell["source"]],
        "metadata": {"kernelspec": kernel, "language_info": {"name": "python"}},
        "nbformat": 4,
        "nbformat_minor": 4,
    }
    return (json.dumps(document, indent=1, ensure_ascii=False) + "\n").encode()


def _cell(kind: str, text: str) -> dict[str, Any]:
    if kind == "markdown":
        return {"cell_type": kind, "metadata": {}, "source": _LOCAL_LINK.sub(r"\1", text.strip())}
    tags = _TAGS.match(text)
    metadata = {} if tags is None else {"tags": [tag.strip(" \"'") for tag in tags[1].split(",")]}
    source = _TAGS.sub("", text).strip("\n")
    return {"cell_type": kind, "execution_count": None, "metadata": metadata, "outputs": [],
            "source": source}  # fmt: skip
