"""The playground page in Chromium, served by `nscc play`, as a student would use it."""

from __future__ import annotations

import io
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image
from play_session import play_session

from nscc.examples import examples

pytestmark = pytest.mark.site

PROGRAM = examples()["hdr_2x2"].read_text()
GREY = """([selector, k]) => {
  const canvas = document.querySelectorAll(selector)[k];
  const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
  return [canvas.height, canvas.width, Array.from(data).filter((_, k) => k % 4 == 0)];
}"""


def written(page: Any) -> str:
    text: str = page.evaluate("document.getElementById('text').editor.text")
    return text


def write(page: Any, text: str) -> None:
    """Replace the program as a user does who selects all of it and pastes another one."""
    page.click("#text .cm-content")
    page.keyboard.press("Control+A")
    page.keyboard.insert_text(text)
    assert written(page) == text


@pytest.fixture(scope="module")
def address(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    with play_session(tmp_path_factory.mktemp("play"), PROGRAM) as served:
        yield served


@pytest.fixture(params=[(1280, "light"), (360, "dark")], ids=["desktop", "phone"])
def page(browser: Any, request: pytest.FixtureRequest, address: str) -> Iterator[Any]:
    """The page after its first picture; no script failed when the test ends."""
    width, scheme = request.param
    context = browser.new_context(viewport={"width": width, "height": 900}, color_scheme=scheme)
    opened, errors = context.new_page(), []
    opened.on("pageerror", lambda error: errors.append(str(error)))
    opened.on("console", lambda told: errors.append(told.text) if told.type == "error" else None)
    opened.goto(address)
    opened.wait_for_selector("#pictures figure:nth-child(3)")
    yield opened
    context.close()
    assert not errors


def picture(page: Any, number: int) -> Any:
    rows, cols, levels = page.evaluate(GREY, ["#pictures canvas", number])
    return np.array(levels, np.uint8).reshape(rows, cols)


def wait_until(page: Any, condition: str) -> None:
    """As `wait_for_function`, which the page's own policy does not allow."""
    for _ in range(600):
        if page.evaluate(condition):
            return
        page.wait_for_timeout(50)
    raise AssertionError(condition)


def exposed_again(page: Any) -> None:
    wait_until(page, "!document.querySelector('#pictures .old')")


def mark_old(page: Any) -> None:
    page.evaluate("document.querySelector('#pictures figure').classList.add('old')")


def test_the_page_shows_report_shutters_and_pictures(page: Any) -> None:
    assert written(page) == PROGRAM
    assert "28 stored of 1024" in page.inner_text("#rows")
    assert "stop 256" in page.text_content("#chart svg")
    titles = page.locator("#pictures figcaption").all_inner_texts()
    assert titles == ["the light", "read out: frame", "merged: frame"]
    light, frame, merged = (picture(page, k).astype(int) for k in range(3))
    # The frame is saturated in places and dark in others, the merged picture is like the light.
    assert np.median(abs(merged - light)) < 12 < np.median(abs(frame - light))
    assert re.search("exposed in [0-9]+ ms", page.inner_text("#lines"))
    assert page.locator("#text .statement").all_inner_texts()[:2] == ["nsl", "frame"]


def test_the_page_does_not_scroll_sideways(page: Any) -> None:
    page.click("#follow")
    page.wait_for_selector("#registers td")
    write(page, PROGRAM.replace("n < stop", "n < stp"))
    page.wait_for_selector("#messages li.error")
    width = page.viewport_size["width"]
    assert page.evaluate("document.documentElement.scrollWidth") == width


def test_a_message_is_at_its_place_and_its_fix_mends_the_text(page: Any) -> None:
    write(page, PROGRAM.replace("n < stop", "n < stp"))
    page.wait_for_selector("#messages li.error")
    assert page.inner_text("#text .cm-lintRange-error") == "stp"
    page.click("#messages button:has-text('line 9')")
    assert page.evaluate("document.getSelection().toString()") == "stp"
    page.click("#messages button:has-text('Fix: write `stop`')")
    page.wait_for_selector("#messages li", state="detached")
    assert written(page) == PROGRAM


def test_effects_change_the_picture_and_a_plan_explains(page: Any) -> None:
    exact = picture(page, 1)
    mark_old(page)
    page.select_option("#effects", "all")
    exposed_again(page)
    assert not np.array_equal(picture(page, 1), exact)
    mark_old(page)
    page.select_option("#effects", "auto")
    exposed_again(page)
    page.click("#plan summary")
    assert "shot" in page.inner_text("#plan pre")


def test_words_run_step_by_step_in_the_pixel_that_is_clicked(page: Any) -> None:
    page.locator("#pictures canvas").nth(1).scroll_into_view_if_needed()
    page.locator("#pictures canvas").nth(1).click(position={"x": 1, "y": 1})
    page.wait_for_selector("#registers td")
    assert page.input_value("#row") in ("0", "1")
    count = page.locator("#listing li").count()
    assert count == 28
    page.locator("#listing li").nth(9).click()
    assert page.inner_text("#now").startswith("10 of 28: bus NEWS, A, PIX")
    page.locator("#listing li").nth(1).click()
    assert page.locator("#registers td.new").count() >= 1
    assert "Read out: frame: " in page.inner_text("#exposed")


def test_a_picture_from_disk_is_exposed(page: Any, tmp_path: Path) -> None:
    levels = np.zeros((300, 300), np.uint8)
    levels[:, 150:] = 200
    file = io.BytesIO()
    Image.fromarray(levels).save(file, "png")
    mark_old(page)
    with page.expect_file_chooser() as chooser:
        page.select_option("#scene", "file")
    chooser.value.set_files({"name": "p.png", "mimeType": "image/png", "buffer": file.getvalue()})
    exposed_again(page)
    light = picture(page, 0)
    assert light.shape == (256, 256)
    assert light[:, :120].max() == 0
    assert light[:, 140:].min() == 255  # the brightest percent


def test_a_photo_of_the_camera_is_exposed(page: Any) -> None:
    before = picture(page, 0)
    mark_old(page)
    page.select_option("#scene", "camera")
    page.click("#shoot")
    exposed_again(page)
    assert not np.array_equal(picture(page, 0), before)


def test_a_link_holds_the_program(page: Any, address: str) -> None:
    text = PROGRAM + "# mine: ü ✓\n"
    write(page, text)
    page.fill("#exposure", "123456")
    page.click("#link")
    wait_until(page, "location.hash.startsWith('#p=')")
    hash_part = page.evaluate("location.hash")
    page.goto("about:blank")
    page.goto(address + hash_part)
    page.wait_for_selector("#pictures figure:nth-child(3)")
    assert written(page) == text
    assert page.input_value("#exposure") == "123456"
    page.goto("about:blank")
    page.goto(f"{address}#example=spike")
    page.wait_for_selector("#pictures figure:nth-child(3)")
    assert written(page) == examples()["spike"].read_text()
    page.goto("about:blank")
    page.goto(f"{address}#p=nonsense")
    wait_until(page, "document.getElementById('status').textContent.includes('link')")


def test_an_example_by_task_is_opened(page: Any) -> None:
    tasks = page.eval_on_selector_all("#example optgroup", "all => all.map(e => e.label)")
    assert tasks[0] == "High dynamic range"
    mark_old(page)
    page.select_option("#example", "edges")
    exposed_again(page)
    assert page.locator("#pictures figcaption").all_inner_texts() == ["the light", "plane edge"]


def test_save_writes_the_file(page: Any) -> None:
    write(page, PROGRAM + "# saved\n")
    page.click("#save")
    wait_until(page, "document.getElementById('status').textContent.includes('saved')")
    write(page, PROGRAM)
    page.click("#save")
    wait_until(page, "!document.querySelector('#messages li')")
