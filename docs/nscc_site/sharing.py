"""What search engines and messengers show of a page: its description and a preview (Open Graph)."""

from __future__ import annotations

import re
import shutil
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any

from docutils import nodes

from nscc_site.home import PREVIEW

if TYPE_CHECKING:
    from sphinx.application import Sphinx

_MOST_LETTERS = 200
"""Length of a description, after which it is cut at the end of a sentence or of a word."""


def describe(
    app: Sphinx,
    _page: str,
    _template: str,
    context: dict[str, Any],
    doctree: nodes.document | None,
) -> None:
    """Add the description of a page to its head.

    The addresses of the page and of its picture must be absolute: they need `NSCC_SITE_URL`."""
    if doctree is None:
        return
    description = _description(doctree)
    properties = {
        "og:type": "website",
        "og:site_name": "nscc",
        "og:title": re.sub("<.*?>", "", context.get("title", "nscc")),
        "og:description": description,
    }
    if base := app.config.html_baseurl:
        properties["og:url"] = context["pageurl"]
        properties["og:image"] = f"{base.rstrip('/')}/{Path(PREVIEW).name}"
        properties["twitter:card"] = "summary_large_image"
    tags = [f'<meta name="description" content="{escape(description)}">'] * bool(description)
    tags += [f'<meta property="{k}" content="{escape(v)}">' for k, v in properties.items() if v]
    context["metatags"] = context.get("metatags", "") + "\n".join(tags)


def copy_preview(app: Sphinx, exception: Exception | None) -> None:
    """Copy the picture of previews to the top of the site."""
    if exception is None and app.builder.name == "html":
        shutil.copy(Path(app.confdir) / "generated" / PREVIEW, app.outdir)


def _description(doctree: nodes.document) -> str:
    """Return the first paragraph of a page, shortened; empty if the page has none."""
    paragraphs = (node for node in doctree.findall(nodes.paragraph) if _is_prose(node))
    text = " ".join(next((node.astext() for node in paragraphs), "").split())
    if len(text) <= _MOST_LETTERS:
        return text
    sentences, _, _ = text[:_MOST_LETTERS].rpartition(". ")
    return f"{sentences}." if sentences else text[:_MOST_LETTERS].rpartition(" ")[0] + " ..."


def _is_prose(paragraph: nodes.Element) -> bool:
    """Return whether a paragraph has text, and is part of the page's own text."""
    has_text = any(node.astext().strip() for node in paragraph.findall(nodes.Text))
    return has_text and isinstance(paragraph.parent, nodes.section)
