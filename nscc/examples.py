"""The example programs of nscc, tutorials as Jupyter notebooks, and a template for new programs."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from pathlib import Path

from nscc.diagnostics.diagnostic import rejected
from nscc.diagnostics.suggest import meant
from nscc.mappings import JsonObject
from nscc.record import Record

_CELL = re.compile(r"^```\{code-cell\}[^\n]*\n(.*?)^```$", re.MULTILINE | re.DOTALL)
_TAGS = re.compile(r"^:tags: *\[(.*)\]\n+")
_HEAD = re.compile(r"\A---\n.*?\n---\n", re.DOTALL)
_LOCAL_LINK = re.compile(r"\[([^\]]+)\]\((?!https?:)[^)]*\)")


def notebook(page: str) -> bytes:
    """Return a Markdown page, whose code is in blocks `{code-cell}`, as the bytes of a Jupyter
    notebook, whose code cells have no outputs.

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


def _cell(kind: str, text: str) -> JsonObject:
    """Return a notebook cell as JSON values; `kind` is "code" or "markdown".

    The first line of code may give tags, such as `:tags: [hide-input]`, which become metadata.
    Links to local files become plain text in Markdown."""
    if kind == "markdown":
        return {"cell_type": kind, "metadata": {}, "source": _LOCAL_LINK.sub(r"\1", text.strip())}
    tags = _TAGS.match(text)
    metadata = {} if tags is None else {"tags": [tag.strip(" \"'") for tag in tags[1].split(",")]}
    source = _TAGS.sub("", text).strip("\n")
    return {
        "cell_type": kind,
        "execution_count": None,
        "metadata": metadata,
        "outputs": [],
        "source": source,
    }


_ENDINGS = (".nsl", ".toml")

START = """\
# Describe here what the program is for.
nsl 1

frame 64 slots of 500us             # the frame has 64 time slots, 32 ms in all

# The code of a pixel has one or more fields. The rule below defines what they mean.
code start : 0..N - 1               # N is the number of slots, 64
code stop  : 1..N
require start < stop                # other codes are an error

# In slot n, the shutter of a pixel is open if this condition is true.
open when start <= n < stop

# The codes of the pixels, here a tile that is repeated over the array. Codes can also be computed
# from x and y, or read from a file: pixels from "codes.npz".
pixels start = tile [[0, 16],
                     [0, 48]]
pixels stop  = tile [[64, 32],
                     [16, 64]]

# nscc check FILE     reports whether the program fits the chip, and how many words it needs
# nscc view FILE      draws when each pixel is open
# nscc run FILE --scene builtin:motion --png frame.png
# nscc examples       lists further programs
"""
"""A commented program of class d, for `nscc new`."""


def examples() -> Mapping[str, Path]:
    """Return the paths of example programs, configurations and tutorials by name; names of programs
    have no `.nsl`.

    The name of a tutorial is that of its notebook; its path is the page from which `contents` makes
    the notebook."""
    files = sorted(
        path for path in _folder("example_files", "examples").iterdir() if path.suffix in _ENDINGS
    )
    known = {path.stem if path.suffix == ".nsl" else path.name: path for path in files}
    tutorials = sorted(_folder("tutorial_files", "docs/tutorials").glob("*.md"))
    return known | {f"{path.stem}.ipynb": path for path in tutorials if path.stem != "index"}


def _folder(installed: str, of_sources: str) -> Path:
    """Return the folder `installed` beside this file or, in a checkout of the sources, the folder
    `of_sources` relative to its top."""
    folder = Path(__file__).with_name(installed)
    return folder if folder.is_dir() else Path(__file__).resolve().parents[1] / of_sources


class ExampleScene(Record):
    """The scene that shows what an example program does.

    `scene` is its name, `exposure` the electrons over the frame in a bright pixel (`nscc demo
    --exposure`), and `reconstruct` the arguments of `nscc reconstruct`; None for images and planes,
    which need no reconstruction."""

    scene: str
    exposure: int
    reconstruct: str | None


def tasks() -> dict[str, dict[str, ExampleScene]]:
    """Return the scenes with which example programs are shown: {task: {name of the program:
    scene}}, both in the order in which they are shown."""
    path = _folder("example_files", "examples") / "tasks.json"
    return {
        task: {name: ExampleScene(**shown) for name, shown in programs.items()}
        for task, programs in json.loads(path.read_text(encoding="utf-8")).items()
    }


def contents(path: Path) -> tuple[str, bytes]:
    """Return the name and the bytes of the file that a user gets for the example at `path`: a
    notebook for a page (.md), else the file itself."""
    if path.suffix != ".md":
        return path.name, path.read_bytes()
    return f"{path.stem}.ipynb", notebook(path.read_text(encoding="utf-8"))


def example(name: str) -> Path:
    """Return the path of the example `name`, with or without `.nsl`; raise Rejected (NS0787) for an
    unknown name."""
    known = examples()
    path = known.get(name.removesuffix(".nsl"))
    if path is None:
        raise rejected(
            "NS0787",
            f"unknown example '{name[:60]}'",
            helps=(
                *meant(name, known, written="nscc examples {}"),
                "`nscc examples` lists them",
            ),
        )
    return path


def about(path: Path) -> str:
    """Return the description of an example: a tutorial's title, or the first sentence of a file's
    first comment without its full stop. It is "" for a file that begins without a comment."""
    lines = path.read_text(encoding="utf-8").splitlines()
    if path.suffix == ".md":
        title = next((line for line in lines if line.startswith("# ")), "")
        return f"Tutorial: {title.lstrip('# ')}"
    words: list[str] = []
    for line in lines:
        if not line.startswith("#"):
            break
        words += line.lstrip("# ").split()
    for index, word in enumerate(words):
        if word.endswith((".", ":")):
            return " ".join(words[: index + 1]).rstrip(".:")
    return " ".join(words)
