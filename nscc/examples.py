"""The example programs of nscc, and a template for new programs."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from nscc.diagnostics.rejection import rejected
from nscc.diagnostics.suggest import meant
from nscc.notebooks import notebook

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
    """Return the paths of example programs, configurations and tutorials by name, without `.nsl`.

    The name of a tutorial is that of its notebook; its path is the page from which `contents` makes
    the notebook."""
    files = sorted(path for path in _folder("example_files", "examples").iterdir()
                   if path.suffix in _ENDINGS)  # fmt: skip
    known = {path.stem if path.suffix == ".nsl" else path.name: path for path in files}
    tutorials = sorted(_folder("tutorial_files", "docs/tutorials").glob("*.md"))
    return known | {f"{path.stem}.ipynb": path for path in tutorials if path.stem != "index"}


def _folder(installed: str, of_sources: str) -> Path:
    folder = Path(__file__).with_name(installed)
    return folder if folder.is_dir() else Path(__file__).resolve().parents[1] / of_sources


def contents(path: Path) -> tuple[str, bytes]:
    """Return the name and the bytes of the file that a user receives for an example."""
    if path.suffix != ".md":
        return path.name, path.read_bytes()
    return f"{path.stem}.ipynb", notebook(path.read_text(encoding="utf-8"))


def example(name: str) -> Path:
    """Return the path of an example; raise Rejected (NS0787) for an unknown name."""
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
    """Return the description of an example.

    It is a tutorial's title, or the first sentence of the comment at the start of a file."""
    lines = path.read_text(encoding="utf-8").splitlines()
    if path.suffix == ".md":
        title = next((line for line in lines if line.startswith("# ")), "")
        return f"Tutorial: {title.lstrip('# ')}"
    words: list[str] = []
    for line in lines:
        if not line.startswith("#"):
            break
        words += line.lstrip("# ").split()
    for place, word in enumerate(words):
        if word.endswith((".", ":")):
            return " ".join(words[: place + 1]).rstrip(".:")
    return " ".join(words)
