"""Sphinx extension: generate reference pages, gallery and pictures, and highlight programs.

Pages are written to `docs/generated` before Sphinx reads its sources; they are not committed.
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import TYPE_CHECKING, Any

from nscc.examples import contents, examples
from nscc_site.digest import source_digest
from nscc_site.docstrings import as_rst
from nscc_site.gallery import gallery_pages
from nscc_site.home import home_pages
from nscc_site.lexer import NslLexer
from nscc_site.pictures import draw_pictures, pair_pictures
from nscc_site.playground import offer_playground, write_playground
from nscc_site.reference import reference_pages
from nscc_site.results import results_pages
from nscc_site.sharing import copy_preview, describe

if TYPE_CHECKING:
    from sphinx.application import Sphinx

REPOSITORY = Path(__file__).resolve().parents[2]
GENERATED = REPOSITORY / "docs" / "generated"


def setup(app: Sphinx) -> dict[str, Any]:
    """Connect the extension to Sphinx."""
    app.add_lexer("nsl", NslLexer)
    app.connect("builder-inited", generate)
    app.connect("builder-inited", write_notebooks)
    app.connect("source-read", offer_notebook)
    app.connect("doctree-read", pair_pictures)
    app.connect("doctree-resolved", offer_playground)
    app.connect("html-page-context", describe)
    app.connect("build-finished", write_playground)
    app.connect("build-finished", copy_preview)
    app.connect("autodoc-process-docstring", as_rst)
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def notebooks() -> dict[str, bytes]:
    """Return the notebook of each tutorial by file name."""
    return dict(contents(path) for path in examples().values() if path.suffix == ".md")


def offer_notebook(_app: Sphinx, docname: str, source: list[str]) -> None:
    """Insert a link to the notebook below a tutorial's title."""
    name = docname.removeprefix("docs/tutorials/")
    if name in (docname, "index"):
        return
    title = re.search(r"^# .*$", source[0], re.MULTILINE)
    assert title is not None
    file = f"<../generated/notebooks/{name}.ipynb>"
    text = f"{{download}}`This page as a notebook {file}`; `nscc examples {name}.ipynb` copies it."
    source[0] = f"{source[0][: title.end()]}\n\n{text}{source[0][title.end() :]}"


def write_notebooks(_app: Sphinx) -> None:
    """Write the notebook of each tutorial."""
    (GENERATED / "notebooks").mkdir(parents=True, exist_ok=True)
    for name, data in notebooks().items():
        (GENERATED / "notebooks" / name).write_bytes(data)


def generate(_app: Sphinx) -> None:
    """Write all generated pages and pictures, and remove other files of `docs/generated`.

    Do nothing if the digest of their sources has not changed.
    """
    made_of, stamp = source_digest(), GENERATED / "made_of"
    if stamp.is_file() and stamp.read_text() == made_of:
        return
    pages: dict[str, str | bytes] = {}
    pages |= reference_pages()
    pages |= gallery_pages(REPOSITORY / "examples")
    pages |= draw_pictures(REPOSITORY)
    pages |= home_pages()
    pages |= results_pages()
    for name, content in pages.items():
        path = GENERATED / name
        data = content.encode() if isinstance(content, str) else content
        if not path.is_file() or path.read_bytes() != data:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(data)
    pages["made_of"] = made_of
    for path in GENERATED.rglob("*"):
        name = path.relative_to(GENERATED).as_posix()
        if path.is_file() and name not in pages and not name.startswith("notebooks/"):
            path.unlink()
    stamp.write_text(made_of)
