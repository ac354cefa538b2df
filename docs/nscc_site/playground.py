"""The playground of the site: static files with a wheel of compiler and emulator, and links to it.

Python for the page is Pyodide: from its network address, or from the folder `NSCC_PYODIDE`."""

from __future__ import annotations

import io
import json
import os
import shutil
import zlib
from base64 import urlsafe_b64encode
from pathlib import Path
from typing import TYPE_CHECKING
from zipfile import ZIP_DEFLATED, ZipFile, ZipInfo

import lark
from docutils import nodes

from nscc.examples import examples
from nscc.version import __version__
from nscc_cli.playground import PAGE

if TYPE_CHECKING:
    from sphinx.application import Sphinx

REPOSITORY = Path(__file__).resolve().parents[2]
LOOPS = REPOSITORY / "build" / "loops.wasm"
PYODIDE = "https://cdn.jsdelivr.net/pyodide/v314.0.7/full/"
_PYODIDE_FILES = (
    "pyodide.mjs",
    "pyodide.asm.*",
    "python_stdlib.zip",
    "pyodide-lock.json",
    "numpy-*",
)
_EPOCH = (1980, 1, 1, 0, 0, 0)
_LEFT_OUT = ("device/", "pictures/", "calibrate/")
"""Folders of the emulator that no request of the page needs, but for the tone curves."""


def wheel() -> bytes:
    """Return the archive that the page unpacks: the compiler, the emulator with its loops, lark,
    and the answers to the page's requests. Same sources, same bytes."""
    files: dict[str, Path] = {"nscc/syntax/nsl.lark": REPOSITORY / "grammars" / "nsl.lark"}
    lark_folder = Path(lark.__file__).parent
    for name, folder, kinds in (
        ("nscc", REPOSITORY / "nscc", (".py", ".toml", ".md")),
        ("nscc/example_files", REPOSITORY / "examples", (".nsl", ".json")),
        ("nscc_runtime", REPOSITORY / "runtime" / "nscc_runtime", (".py", ".toml", ".csv")),
        ("nscc_cli/playground", PAGE.parent, (".py",)),
        ("lark", lark_folder, (".py", ".lark")),
    ):
        for path in sorted(folder.rglob("*")):
            inside = path.relative_to(folder).as_posix()
            is_needed = inside == "pictures/tone.py" or not inside.startswith(_LEFT_OUT)
            if path.suffix in kinds and path.is_file() and is_needed:
                files[f"{name}/{inside}"] = path
    files["nscc_cli/__init__.py"] = PAGE.parents[1] / "__init__.py"
    files["nscc_runtime/pictures/__init__.py"] = (
        REPOSITORY / "runtime/nscc_runtime/pictures/__init__.py"
    )
    files["nscc_runtime/loops.wasm"] = LOOPS
    files["LICENSE"] = REPOSITORY / "LICENSE"
    out = io.BytesIO()
    with ZipFile(out, "w", ZIP_DEFLATED, compresslevel=9) as archive:
        for name in sorted(files):
            archive.writestr(ZipInfo(name, _EPOCH), files[name].read_bytes(), ZIP_DEFLATED, 9)
    return out.getvalue()


def write_playground(app: Sphinx, exception: Exception | None) -> None:
    """Write the folder `play` of the site. Raise FileNotFoundError without the compiled loops."""
    if exception is not None or app.builder.name != "html":
        return
    if not LOOPS.is_file():
        raise FileNotFoundError(f"{LOOPS.name} is missing: `make docs` compiles it first")
    folder = Path(app.outdir) / "play"
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(PAGE, folder)
    name, python = f"nscc-{__version__}-web.zip", PYODIDE
    (folder / name).write_bytes(wheel())
    if local := os.environ.get("NSCC_PYODIDE"):
        python = "pyodide/"
        (folder / "pyodide").mkdir()
        for pattern in _PYODIDE_FILES:
            for path in Path(local).glob(pattern):
                shutil.copy(path, folder / "pyodide")
    docs = "../docs/language.html"
    config = {"engine": "worker", "python": python, "wheel": name, "docs": docs}
    (folder / "config.json").write_text(json.dumps(config))


def link_of(program: str) -> str:
    """Return the part of the playground's address that opens a program: `#..` (`page/link.js`)."""
    for name, path in examples().items():
        if path.suffix == ".nsl" and path.read_text(encoding="utf-8").strip() == program.strip():
            return f"#example={name}"
    packer = zlib.compressobj(9, zlib.DEFLATED, -15)
    data = packer.compress(json.dumps({"program": program}).encode()) + packer.flush()
    return f"#p={urlsafe_b64encode(data).decode().rstrip('=')}"


def offer_playground(app: Sphinx, doctree: nodes.document, docname: str) -> None:
    """Add a link below each program of a page that opens the program in the playground."""
    for block in [*doctree.findall(nodes.literal_block)]:
        text = block.astext()
        if block.get("language") == "nsl" and "\nframe" in text and "nsl " in text:
            address = f"{'../' * docname.count('/')}play/index.html{link_of(text)}"
            html = f'<p class="try"><a href="{address}">Open in the playground</a></p>'
            link = nodes.raw("", html, format="html")
            block.parent.insert(block.parent.index(block) + 1, link)
