"""What notebooks show: HTML that is whole, stands by itself, and says what there is."""

from __future__ import annotations

from base64 import b64decode
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from notebook_page import Page, checked

import nscc
import nscc_runtime
from nscc import html
from nscc.chips.load import builtin_target
from nscc.emit.notebook import shutter_chart

TARGET = replace(builtin_target("scamp5"), rows=6, cols=8)
TEXT = """nsl 1
frame slots [1ms, 1ms, 2ms, 4ms]
code split : 1..3
bucket early open when n < split
bucket late open when n >= split
pixels split = 1 + x % 2
"""


def program() -> nscc.ShutterProgram:
    return nscc.compile(TEXT, target=TARGET, level=1)


def test_a_program_shows_chart_and_costs(tmp_path: Path) -> None:
    """The page names splits, buckets and costs. A program that was saved and loaded shows the same
    splits."""
    p = program()
    page = checked(p)
    words = " ".join(page.words)
    assert {"split 1", "split 2", "early", "late", "8 ms", "words", "proved"} <= {*page.words}
    assert f"{len(p.words)} stored" in words
    loaded = checked(nscc.load(p.save(tmp_path / "a.icw")))
    assert {"split 1", "split 2", "lowering"} <= {*loaded.words}


def test_bars_are_where_shutters_are_open() -> None:
    """The open time of every lane is computed from the numbers of the drawn paths."""
    p = program()
    p_shutters = p.shutters()[:, :2].transpose(1, 0, 2)
    page = Page(shutter_chart(p_shutters, ["a", "b"], p.slot_us, p.buckets))
    width = float(next(a["width"] for t, a in page.tags if t == "rect"))  # type: ignore[arg-type]
    found = []
    for tag, attributes in page.tags:
        if tag == "path":
            pieces = str(attributes["d"]).strip("Mz").split("zM")
            spans = [(float(x.split()[0]), float(x.split("H")[1].split("v")[0])) for x in pieces]
            found.append(sum(right - left for left, right in spans) / width)
    slots = np.array(p.slot_us)
    wanted = [(lane * slots).sum() / slots.sum() for row in p_shutters for lane in row]
    np.testing.assert_allclose(found, wanted, atol=2e-3)


def test_many_shutters_and_slots_stay_small() -> None:
    """3000 shutters of 4000 slots make a chart below 400 kB, which says that it shows 24 of
    them."""
    rng = np.random.default_rng(1)
    rows = rng.random((3000, 1, 4000)) < 0.5
    text = shutter_chart(rows, [f"code {k}" for k in range(3000)], [1.0] * 4000, ("frame",))
    # All rows would be twelve million cells: some are left out, and slots are joined.
    assert len(text) < 400_000
    words = Page(text).words
    assert {"code 0", "code 2999", "24 of 3000 shutters"} <= {*words}


def test_a_capture_shows_its_picture_and_plan() -> None:
    light = np.random.default_rng(3).exponential(2e6, (6, 8))
    taken = nscc_runtime.capture(program(), light, effects="auto")
    page = checked(taken)
    images = [str(attributes["src"]) for tag, attributes in page.tags if tag == "img"]
    import cv2

    for image, shown in zip(taken.frame, images, strict=True):
        data = np.frombuffer(b64decode(shown.partition(",")[2]), np.uint8)
        np.testing.assert_array_equal(cv2.imdecode(data, cv2.IMREAD_UNCHANGED), image)
    assert any("shot" in words and "kept" in words for words in page.words)
    exact = nscc_runtime.capture(program(), light, repeat=2)
    assert not any("kept" in words for words in checked(exact).words)


def test_notebooks_show_plans_and_sensors() -> None:
    """The page of a plan holds its text, and that of a sensor its values."""
    plan = nscc_runtime.plan(program(), np.ones((6, 8)))
    assert str(plan) in checked(plan).words
    assert "full_well_e" in checked(nscc_runtime.sensor_for(program())).words


def test_names_are_text_and_never_tags() -> None:
    evil = "<script>alert(1)</script>'\""
    page = Page(
        html.card(
            evil,
            evil,
            html.table([(evil, evil)], [evil, evil]),
            html.plain(evil),
            html.folded(evil, html.legend([evil])),
            html.picture(b"", evil, 4),
            html.drawing(1, 1, [html.words(0, 0, evil)], evil),
        )
    )
    assert "script" not in {tag for tag, _ in page.tags}
    assert page.words.count(evil) == 12
    named = replace(program(), name=evil)
    assert evil in checked(named).words


@pytest.mark.parametrize("value", [None, 3, "a", "b'"])
def test_any_text_in_a_table_is_escaped(value: Any) -> None:
    """None, numbers and quotes come back from the parsed page as they were."""
    assert Page(html.table([("k", value)])).words == ["k", str(value)]
