"""A page of HTML as a browser takes it: its tags, its words, and that it stands by itself."""

from __future__ import annotations

from html.parser import HTMLParser
from typing import Any

VOID = {"img", "rect", "path", "circle", "polyline"}


class Page(HTMLParser):
    """The tags of a page; AssertionError where one is not closed."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.tags: list[tuple[str, dict[str, str | None]]] = []
        self.words: list[str] = []
        self.open: list[str] = []
        self.feed(text)
        self.close()
        assert not self.open

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append((tag, dict(attrs)))
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append((tag, dict(attrs)))

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        self.words.append(data.strip())


def checked(value: Any) -> Page:
    """Nothing from elsewhere, no script, and no colour of the text or of the ground."""
    text = value._repr_html_()
    page = Page(text)
    assert not {tag for tag, _ in page.tags} & {"script", "link", "iframe", "style"}
    for tag, attributes in page.tags:
        for name, found in attributes.items():
            assert not name.startswith("on"), tag
            if name in ("src", "href"):
                assert str(found).startswith("data:image/png;base64,")
            assert "background:#" not in str(found)
    assert "url(" not in text
    return page
