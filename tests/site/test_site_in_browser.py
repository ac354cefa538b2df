"""The built site in Chromium: nothing scrolls sideways or is cut, at eight widths."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from threading import Thread
from typing import Any

import pytest
from checkout import ROOT

SITE = ROOT / "build" / "site"
PAGES = (
    "docs/index.html", "docs/start.html", "docs/language.html", "docs/emulator.html",
    "docs/python.html", "docs/reference/python.html", "docs/generated/gallery.html",
    "docs/generated/gallery/hdr_2x2.html", "docs/generated/commands.html",
    "docs/generated/commands/run.html", "docs/generated/results.html",
    "docs/generated/effects.html", "docs/tutorials/hdr_photo.html", "docs/tutorials/train.html",
    "docs/tutorials/own_pictures.html", "README.html",
)  # fmt: skip
WIDTHS = (360, 390, 800, 1024, 1180, 1280, 1440, 1920)
SCHEMES = ("light", "dark")

pytestmark = [
    pytest.mark.site,
    pytest.mark.skipif(not SITE.is_dir(), reason="no site: `make docs` builds it"),
]

CUT = """() => {
  const scrolls = e => e.parentElement.closest('pre, .table-wrapper, .output');
  const box = e => e.getBoundingClientRect();
  const column = document.querySelector('.content');
  return [...document.querySelectorAll('article *')]
    .filter(e => e.getClientRects().length && !scrolls(e) && !e.closest('svg'))
    .filter(e => box(e).right > box(column).right + 1 || box(e).left < box(column).left - 1
              || getComputedStyle(e).overflowX == 'hidden' && e.scrollWidth > e.clientWidth + 1)
    .map(e => `${e.tagName} ${e.className} ${e.textContent.trim().slice(0, 40)}`);
}"""
CODE = """() => [...document.querySelectorAll('article .highlight')]
  .map(e => [e, e.parentElement.parentElement].map(each => each.getBoundingClientRect().right))
  .filter(([box, text]) => box > text + 1)"""
PICTURES = """() => [...document.querySelectorAll('article img')]
  .filter(e => e.getClientRects().length)
  .map(e => {
    const dark = e.closest('.only-dark') || e.classList.contains('only-dark');
    const light = e.closest('.only-light') || e.classList.contains('only-light');
    return [e.getAttribute('src'), e.complete && e.naturalWidth > 0, Boolean(dark), Boolean(light),
            getComputedStyle(e).backgroundColor];
  })"""


@pytest.fixture
def opened(browser: Any, request: pytest.FixtureRequest) -> Iterator[Any]:
    """A page of the browser with the width and the scheme that the test names."""
    width, scheme = request.param
    context = browser.new_context(viewport={"width": width, "height": 900}, color_scheme=scheme)
    yield context.new_page()
    context.close()


class _Quiet(SimpleHTTPRequestHandler):
    def log_message(self, *_arguments: Any) -> None:
        """Print nothing."""


@contextmanager
def http_server(folder: Path) -> Iterator[str]:
    """Serve a folder, since scripts of pages that are files may not load others."""
    handler = partial(_Quiet, directory=folder)
    with ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_port}"
        server.shutdown()


LOOKS = [pytest.param((w, s), id=f"{w}-{s}") for w in WIDTHS for s in SCHEMES]


@pytest.mark.parametrize("opened", LOOKS, indirect=True)
def test_nothing_scrolls_sideways_or_is_cut(opened: Any) -> None:
    width = opened.viewport_size["width"]
    wrong = []
    for name in PAGES:
        opened.goto((SITE / name).as_uri())
        whole = opened.evaluate("document.documentElement.scrollWidth")
        if whole > width:
            wrong.append(f"{name}: {whole} pixels")
        wrong += [f"{name}: {text}" for text in opened.evaluate(CUT)[:3]]
        wrong += [f"{name}: code to {box}, text to {text}" for box, text in opened.evaluate(CODE)]
    assert not wrong


@pytest.mark.parametrize("opened", [(1280, "light"), (1280, "dark")], indirect=True)
def test_pictures_are_loaded_and_match_the_colours_of_the_page(opened: Any) -> None:
    """On a dark page, a picture without a dark version has a white ground. Of two versions only the
    matching one is shown."""
    is_dark = opened.evaluate("matchMedia('(prefers-color-scheme: dark)').matches")
    count = 0
    for name in PAGES:
        opened.goto((SITE / name).as_uri())
        # Those further down are loaded when the reader comes near.
        opened.evaluate("document.querySelectorAll('img').forEach(e => { e.loading = 'eager'; })")
        opened.wait_for_function("[...document.images].every(e => e.complete)")
        for source, loaded, dark, light, ground in opened.evaluate(PICTURES):
            count += 1
            assert loaded, f"{name}: {source}"
            assert not (light if is_dark else dark), f"{name}: {source}"
            if is_dark and not dark:
                assert ground == "rgb(255, 255, 255)", f"{name}: {source}"
    assert count > 40


@pytest.mark.parametrize("opened", [(1280, "light")], indirect=True)
def test_the_copy_button_leaves_out_the_prompt(opened: Any) -> None:
    """The test clicks each button and reads what the clipboard gets."""
    opened.context.grant_permissions(["clipboard-read", "clipboard-write"])
    opened.goto((SITE / "docs/start.html").as_uri())
    opened.evaluate(
        "() => { window.copied = [];"
        "document.addEventListener('copy', () => copied.push(document.activeElement.value)); }"
    )
    buttons = opened.locator("button.copybtn")
    assert buttons.count() > 5
    for k in range(buttons.count()):
        buttons.nth(k).click(force=True)
    shown = opened.locator("div.highlight:has(button.copybtn) pre").all_inner_texts()
    assert any(text.startswith("$ ") for text in shown)
    copied = opened.evaluate("copied")
    assert len(copied) == len(shown)
    assert not any("$ " in text for text in copied)
    assert "nscc check examples/hdr_2x2.nsl" in [text.strip() for text in copied]


@pytest.mark.parametrize("opened", [(1280, "light")], indirect=True)
def test_the_home_page_has_its_logo_icon_and_links(opened: Any) -> None:
    opened.goto((SITE / "docs/index.html").as_uri())
    assert opened.evaluate("document.querySelector('.sidebar-logo').naturalWidth") > 0
    icon = opened.evaluate("document.querySelector('link[rel~=icon]').href")
    assert Path(icon.removeprefix("file://")).is_file()
    links = opened.evaluate("[...document.querySelectorAll('article .card a')].map(e => e.href)")
    assert len(links) >= 6
    for link in links:
        assert Path(link.removeprefix("file://").partition("#")[0]).is_file(), link
    assert "10.1109/TPAMI.2020.2986944" in opened.content()


@pytest.mark.parametrize("opened", [(1280, "light")], indirect=True)
def test_examples_have_pages_and_tutorials_have_notebooks(opened: Any) -> None:
    """No page is endless; each example has a page of its own, each tutorial a notebook."""
    examples = {path.stem for path in (SITE.parents[1] / "examples").glob("*.nsl")}
    pages = {path.stem for path in (SITE / "docs/generated/gallery").glob("*.html")}
    assert pages == examples
    opened.goto((SITE / "docs/generated/gallery.html").as_uri())
    assert opened.evaluate("document.documentElement.scrollHeight") < 8000
    for name in ("train", "hdr_photo", "own_pictures"):
        opened.goto((SITE / f"docs/tutorials/{name}.html").as_uri())
        [link] = opened.evaluate("[...document.querySelectorAll('a.download')].map(e => e.href)")
        assert link.endswith(f"{name}.ipynb")
        assert Path(link.removeprefix("file://")).is_file()


@pytest.mark.parametrize("opened", [(1280, "light"), (360, "dark")], indirect=True)
def test_the_home_page_shows_before_it_explains(opened: Any) -> None:
    """A pair of pictures of the full width with a slider comes before all other text."""
    opened.goto((SITE / "docs/index.html").as_uri())
    compare = opened.locator(".compare")
    box, column = compare.bounding_box(), opened.locator("article").bounding_box()
    assert box["width"] == pytest.approx(column["width"], abs=2)
    assert box["y"] < 500
    divider = "getComputedStyle(document.querySelector('.compare img + img')).clipPath"
    half = opened.evaluate(divider)
    compare.locator("input").fill("20")
    assert opened.evaluate(divider) != half
    text = opened.inner_text("article")
    assert re.search(r"\+[0-9.]+ dB", text)
    assert "nscc demo builtin:hdr" in text
    assert "nscc has never run on a real chip" in text
    links = opened.eval_on_selector_all(".actions a", "all => all.map(e => e.textContent)")
    assert links == ["Try it in this browser", "Install", "Results"]


@pytest.mark.parametrize("opened", [(1280, "light")], indirect=True)
def test_each_result_has_a_picture_before_the_tables(opened: Any) -> None:
    opened.goto((SITE / "docs/index.html").as_uri())
    first_level = opened.eval_on_selector_all(
        ".sidebar-tree > ul > li > a", "all => all.map(e => e.textContent)"
    )
    assert "Results" in first_level
    opened.goto((SITE / "docs/generated/results.html").as_uri())
    sections = opened.locator("article section section")
    titles = [title for title in sections.locator("h2").all_inner_texts() if "Tables" not in title]
    assert len(titles) >= 5
    for number in range(len(titles)):
        assert sections.nth(number).locator("img").count() >= 1
    assert opened.locator("article table").count() == 0


@pytest.mark.parametrize("opened", [(1280, "light")], indirect=True)
def test_search_results_list_pages_of_messages_last(opened: Any) -> None:
    """Each message has a page with many words: without an order of their own they come first."""
    with http_server(SITE) as address:
        opened.goto(f"{address}/search.html?q=exposure")
        opened.wait_for_selector("#search-results .search-summary:has-text('found')")
        opened.wait_for_function("document.querySelectorAll('#search-results li').length > 20")
        opened.wait_for_timeout(2000)
        links = opened.eval_on_selector_all(
            "#search-results li > a", "all => all.map(e => e.getAttribute('href'))"
        )
    is_message = ["/messages/" in link for link in links]
    assert any(is_message)
    assert is_message == sorted(is_message)


@pytest.mark.parametrize("opened", [(1280, "light")], indirect=True)
def test_pages_have_descriptions_sources_and_files(opened: Any) -> None:
    """Sharing a link shows a description; pages link to their sources, examples to files."""
    for name in ("docs/index.html", "docs/start.html", "docs/generated/gallery/edges.html"):
        opened.goto((SITE / name).as_uri())
        for tag in ("meta[name=description]", "meta[property='og:description']"):
            content = opened.get_attribute(tag, "content")
            assert 20 < len(content) <= 210, f"{name}: {content}"
        source = opened.evaluate("document.querySelector('a[href*=_sources]').href")
        assert Path(source.removeprefix("file://")).is_file()
    downloads = opened.eval_on_selector_all("a.download", "all => all.map(e => e.href)")
    endings = {Path(link).suffix for link in downloads}
    assert endings == {".nsl", ".ipynb", ".hdr"}
    for link in downloads:
        assert Path(link.removeprefix("file://")).is_file()
    assert "nscc run edges.nsl --scene photo.jpg" in opened.inner_text("article")


@pytest.mark.parametrize("opened", [(360, "light"), (1280, "dark")], indirect=True)
def test_the_static_playground_starts_python(opened: Any) -> None:
    """The page shows its picture if it can load numpy; otherwise it says what it could not load."""
    config = json.loads((SITE / "play/config.json").read_text())
    assert (SITE / "play" / config["wheel"]).stat().st_size < 2_500_000
    with http_server(SITE / "play") as address:
        opened.goto(f"{address}/index.html#example=spike")
        opened.wait_for_function(
            "/cannot start|runs in this page/.test(document.getElementById('status').textContent)",
            timeout=120_000,
        )
        told = opened.inner_text("#status")
        if "cannot start" not in told:
            opened.wait_for_selector("#pictures figure:nth-child(3)", timeout=120_000)
        else:
            assert "numpy cannot be loaded from" in told or config["python"] in told
        width = opened.viewport_size["width"]
        assert opened.evaluate("document.documentElement.scrollWidth") == width
        assert "language.html" in opened.get_attribute("#docs", "href")
