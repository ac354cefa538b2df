"""Pictures of every kind, of little and of much: their bytes, and that nothing lies on anything."""

from __future__ import annotations

import io
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
from itertools import combinations
from pathlib import Path
from typing import Any

import matplotlib
import numpy as np
import pytest
from checkout import ROOT
from drawn_figures import compare_figure
from matplotlib.axes import Axes
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from matplotlib.text import Text
from one_scene import load_scene
from PIL import Image as PillowImage

import nscc
from nscc.chips.load import builtin_target
from nscc.compiler import compile_file
from nscc.pipeline import KINDS, Options
from nscc.words.container import Container, DecodeTable
from nscc_runtime.effects import selected
from nscc_runtime.merge import BucketReadout
from nscc_runtime.pictures import sheet
from nscc_runtime.pictures.gate_sheet import gate_sheet
from nscc_runtime.pictures.images import Image, frame_sheet, image_plane_sheet, image_sheet
from nscc_runtime.pictures.looking_chart import course_sheet
from nscc_runtime.pictures.precision import Guide, Panel, Point, PointReading, precision_diagram
from nscc_runtime.pictures.sheet import MARKERS, THEMES, Theme, contrast, theme, themed
from nscc_runtime.pictures.shutter_sheet import shutter_sheet
from nscc_runtime.planning.plan import Choice, Decision, Plan
from nscc_runtime.request import Request
from nscc_runtime.sensor import default_sensor
from nscc_runtime.simulate import simulate
from nscc_training.tradeoff.emulator import (
    DRAWN,
    ELECTRONS,
    LSB,
    OTHER_DRAWS,
    PLANNED,
    REFERENCE,
    SUMMED,
    WITH_PLANNING,
    EmulatorStudy,
    MeasuredPlan,
)
from nscc_training.tradeoff.emulator_study import budget_diagram, promise_diagram, study_diagram

RNG = np.random.default_rng(0)


def point(case: str, method: str, setting: str, error: float, time_ms: float, **more: Any) -> Point:
    times_ms = (time_ms / 2, time_ms, time_ms * 3)
    return Point(case, method, setting, error, "words_per_frame", times_ms, **more)


def problems(cases: int, methods: int, settings: int) -> list[Panel]:
    """Points that lie close to each other, and on each other."""
    times = RNG.lognormal(0, 1, (cases, methods, settings)).cumsum(axis=2)
    errors = RNG.lognormal(3, 1, (cases, methods, settings)).round()
    return [
        Panel(
            f"case {c}",
            "words a frame",
            [
                point(
                    f"case {c}",
                    f"method number {m}",
                    f"-O{s}",
                    errors[c, m, s],
                    times[c, m, s],
                    bound=7.0 + m if m % 3 == 0 else None,
                )
                for m in range(methods)
                for s in range(settings)
            ],
            (Guide("as fast as can be", ":", time_ms=0.05), Guide("chance", "--", error=1e3)),
        )
        for c in range(cases)
    ]


def diagram(cases: int, methods: int, settings: int, **reading: Any) -> Callable[[], Figure]:
    panels = problems(cases, methods, settings)
    note = "what was measured, on what, and what hollow marks mean; " * 3
    return partial(precision_diagram, panels, "A title", note, PointReading("time, ms", **reading))


def at_the_ends() -> Figure:
    """No error, no difference, one point, none at all, and what has no number."""
    points = [point("a", "one", "x", 0.0, 1.0), point("a", "one", "y", 1e-13, 1.0),
              point("a", "two", "z", 300.0, 9.0), point("a", "two", "no", np.inf, 9.0)]  # fmt: skip
    alike = [point("b", "one", "x", 5.0, 1.0), point("b", "two", "y", 5.0, 1.0)]
    panels = [Panel("a", "e", points), Panel("b", "e", alike), Panel("c", "e", [])]
    return precision_diagram(panels, "t", "n", PointReading("time, ms"))


def decision(name: str, choice: Choice, rms_e: float | None, cost_ms: float) -> Decision:
    return Decision(name, "random", choice, False, "why", rms_e, 0.0, rms_e, cost_ms)


def plan(tolerance_e: float, predicted_e: float, effects: int = 4) -> Plan:
    decisions = (
        decision("shot", "kept", 1e4, 1.25), decision("read", "dropped", 0.0, 0.0),
        decision("lag", "absent", None, 0.0), decision("decay", "kept", None, 123.0),
        *(decision(f"effect_{i}", "dropped", 0.1 * i, 0.1) for i in range(4, effects)),
    )  # fmt: skip
    text = f"{tolerance_e:g}e"
    return Plan(text, tolerance_e, False, (), 3.0, 4.0, decisions, 1.0, predicted_e, 9.0, 99.0)


def studies(scenes: int, tolerances: Sequence[float], effects: int = 4) -> list[EmulatorStudy]:
    def study(name: str) -> EmulatorStudy:
        methods = [
            (REFERENCE, "all", 0.0, 200.0),
            (OTHER_DRAWS, "all", 300.0, 200.0),
            (SUMMED, "none", 25e3, 2.0),
            (DRAWN, "shot", 24e3, 30.0),
        ]
        for number, t in enumerate(tolerances):
            methods.append((PLANNED, f"{t:g}e", 0.9 * t * (number > 0), 20 / t))
            methods.append((WITH_PLANNING, f"{t:g}e", 0.9 * t * (number > 0), 40 / t))
        points = tuple(
            replace(point(name, m, s, e / divisor, t), error_unit=unit)
            for unit, divisor in ((ELECTRONS, 1), (LSB, 120))
            for m, s, e, t in methods
        )
        asked = tuple(
            MeasuredPlan(f"{t:g}e", plan(t, 0.8 * t), 0.9 * t if number else 2e-12)
            for number, t in enumerate(tolerances)
        )
        return EmulatorStudy(name, points, asked, 5e-3, plan(5.0, 3.3, effects), ())

    return [study(f"builtin:scene number {i}") for i in range(scenes)]


def container(codes: int, buckets: int, slots: int, shape: tuple[int, int] | None) -> Container:
    """`codes` shutters at random, and the array's codes at random if it has pixels."""
    table = DecodeTable(
        ("start", "length"),
        np.array([[n, 2 * n] for n in range(codes)]),
        np.arange(codes, dtype=np.int32),
        RNG.random((codes, buckets, slots)) < 0.5,
    )
    return Container(
        target=builtin_target("scamp5"),
        slot_us=tuple(1.0 + n for n in range(slots)),
        buckets=tuple(f"bucket{b}" for b in range(buckets)),
        table=table,
        kernels=(),
        launches=(),
        code_registers=(),
        encoding=np.zeros((codes, 13), bool),
        pixel_codes=None if shape is None else RNG.integers(0, codes, shape, np.int32),
        readouts=(),
        notes={"class": "e", "lowering": "edges"},
    )


def example(name: str) -> Path:
    return ROOT / "examples" / f"{name}.nsl"


def looking_program(name: str) -> Container:
    return nscc.compile(example(name), level=0).container


def gates(name: str) -> Figure:
    compiled = compile_file(example(name), Options(level=0))
    assert compiled.lowered is not None
    return gate_sheet(KINDS.of(compiled.program).network(compiled.lowered), f"{name}.nsl")


def images_and_planes() -> Figure:
    """The results of programs that read their neighbours: a bucket, an image, a plane, events."""
    text = """nsl 3
frame 1 slots of 1ms
bucket lit open when true
outside 0
kernel around = [[1, 2, 1], [2, 4, 2], [1, 2, 1]] / 16
image smooth = around(lit)
plane bright = lit > 40%
read lit, smooth, bright
report events bright at most 2000
"""
    program = nscc.compile(text, target=replace(builtin_target("scamp5"), rows=24, cols=32))
    light = load_scene("builtin:hdr", slot_us=program.container.slot_us, rows=24, cols=32)
    sensor = default_sensor(program.container.target)
    made = simulate(program.container, light, sensor, Request(selected("none")))
    return image_plane_sheet(made.frame.first, program.container.buckets_read, "spots.nsl")


def readout(rows: int, cols: int, name: str = "frame") -> BucketReadout:
    frame = RNG.integers(0, 256, (rows, cols)).astype(np.uint8)
    light_e, open_s = 100.0 * frame, np.full((rows, cols), 1e-3)
    return BucketReadout(
        name, frame, frame == 255, light_e, np.full_like(light_e, 25500.0), open_s, (2, 2)
    )


TOLERANCES = (0.5, 1, 2, 5, 10, 20, 50)
CHARTS: dict[str, Callable[[], Figure]] = {
    "a point": diagram(1, 1, 1),
    "two lines": diagram(2, 2, 4),
    "many lines": diagram(3, 16, 4),
    "decibels": diagram(2, 9, 5, linear=True),
    "ends": at_the_ends,
    "a study": partial(study_diagram, studies(1, (5.0,)), "one run", "a card"),
    "studies": partial(
        study_diagram, studies(3, TOLERANCES), "median and range of 5 runs", "a card"
    ),
    "a promise": partial(promise_diagram, studies(1, (5.0,))),
    "promises": partial(promise_diagram, studies(8, TOLERANCES)),
    "a budget": partial(budget_diagram, studies(1, (5.0,))),
    "budgets": partial(budget_diagram, studies(4, (5.0,), effects=16)),
    "a shutter": partial(shutter_sheet, container(1, 1, 1, (1, 1)), "a.nsl"),
    "buckets": partial(shutter_sheet, container(5, 3, 16, (4, 4)), "a.nsl"),
    "many shutters": partial(shutter_sheet, container(200, 1, 64, (256, 256)), "a.nsl"),
    "many slots": partial(shutter_sheet, container(9, 2, 4096, (3, 200)), "a.nsl"),
    "no pixels": partial(shutter_sheet, container(2, 1, 7, None), "a.nsl"),
    "a pixel that looks": partial(course_sheet, looking_program("float_pixel"), "a.nsl"),
    "looks of kept states": partial(course_sheet, looking_program("auto_exposure"), "a.nsl"),
    "looks everywhere": partial(course_sheet, looking_program("first_light"), "a.nsl"),
    "gates": partial(gates, "class_b"),
    "gates of looks": partial(gates, "first_light"),
    "images and planes": images_and_planes,
    "a frame": partial(frame_sheet, [readout(256, 256)], "a.nsl"),
    "frames": partial(frame_sheet, [readout(2, 90, "b0"), readout(2, 90, "b1")], "a.nsl"),
    "images": partial(
        image_sheet,
        [[Image(np.zeros((64, 64)), f"the method number {i}", "a note") for i in range(6)]] * 2,
        "many images",
    ),
}


LONG = ("many lines", "studies")
"""Descriptions of these pictures are long, and show little that those of others do not."""


@pytest.mark.parametrize("name", CHARTS)
def test_charts_equal_the_recorded_ones_and_no_text_overlaps(name: str, update_cases: bool) -> None:
    """No text leaves the picture or overlaps another text. A chart that is drawn again has the same
    bytes, whatever the settings of matplotlib."""
    with sheet.style():
        figure = CHARTS[name]()
        figure.draw_without_rendering()
        boxes = [(t.get_text(), t.get_window_extent()) for t in written(figure)]
        whole = figure.get_tightbbox().transformed(figure.dpi_scale_trans)
    if name not in LONG:
        compare_figure(figure, name, update_cases)
    assert boxes
    for text, box in boxes:
        assert whole.x0 - 1 <= box.x0 <= box.x1 <= whole.x1 + 1, f"{text!r} leaves the picture"
        assert whole.y0 - 1 <= box.y0 <= box.y1 <= whole.y1 + 1, f"{text!r} leaves the picture"
    for (one, a), (other, b) in combinations(boxes, 2):
        # Letters do not fill their boxes: a dot more or less is nothing to see.
        assert not a.padded(-1).overlaps(b.padded(-1)), f"{one!r} lies on {other!r}"
    first = sheet.png_of(lambda: figure)
    with matplotlib.rc_context({"lines.linewidth": 9, "axes.facecolor": "red", "font.size": 20}):
        assert sheet.png_of(CHARTS[name]) == first
    image = PillowImage.open(io.BytesIO(first))
    image.load()
    assert 300 < image.size[0] < 1800
    assert "Software" not in image.info


def written(figure: Figure) -> list[Text]:
    """All that is to be read; ticks out of the axes' view are not drawn."""
    texts = [*figure.texts, *(text for legend in figure.legends for text in legend.get_texts())]
    for axes in figure.axes:
        for part in (axes, *axes.child_axes):
            texts += [part.title, part._left_title, part._right_title, *part.texts]  # type: ignore[attr-defined]
            for axis in (part.xaxis, part.yaxis):
                if axis.get_visible() and part.axison:
                    low, high = sorted(axis.get_view_interval())
                    texts.append(axis.label)
                    texts += [
                        t.label1 for t in axis.get_major_ticks() if low <= t.get_loc() <= high
                    ]
                    texts += [
                        t.label2 for t in axis.get_major_ticks() if low <= t.get_loc() <= high
                    ]
    return [text for text in texts if text.get_text().strip() and text.get_visible()]


@pytest.mark.parametrize(
    "draw",
    [
        partial(precision_diagram, [], "t", "n", PointReading("time, s")),
        partial(precision_diagram, [Panel("a", "e", [])], "t", "n", PointReading("time, s")),
        partial(promise_diagram, []),
        partial(budget_diagram, []),
    ],
)
def test_sheets_without_content_are_refused(draw: Callable[[], Figure]) -> None:
    with pytest.raises(ValueError, match="to draw"):
        sheet.png_of(draw)


def test_long_titles_do_not_widen_the_picture() -> None:
    with sheet.style():
        figure, [axes] = sheet.panels(1, (sheet.WIDTH, 3.0), 1)
        axes.plot([1, 2], [3, 4])
        sheet.head(figure, f"x.nsl on {'/a_folder' * 20}/scene.hdr: errors", "what was measured")
        figure.draw_without_rendering()
        assert figure.get_tightbbox().width < 1.05 * sheet.WIDTH
        text = "".join(text.get_text() for text in figure.texts)
        # The title is broken into lines, and nothing of it is lost.
        assert text.replace("\n", "").count("/a_folder") == 20


def test_each_line_has_its_name_beside_it_and_each_lone_mark_its_text() -> None:
    with sheet.style():
        figure = diagram(3, 2, 1)()
    [legend] = figure.legends
    assert [text.get_text() for text in legend.get_texts()] == [
        "proved bound",
        "as fast as can be",
        "chance",
    ]
    for axes in figure.axes:
        found = [text.get_text() for text in axes.texts]
        assert found.count("-O0") == 2
        assert {"method number 0", "method number 1"} <= {*found}


def test_dominated_marks_are_hollow() -> None:
    points = [
        point("a", "m", "good", 1, 1), point("a", "m", "bad", 2, 2), point("a", "", "n", 0.5, 1.5),
        point("a", "m", "beaten by one that is not drawn", 0.7, 1.7),
    ]  # fmt: skip
    with sheet.style():
        figure = precision_diagram([Panel("", "e", points)], "t", "n", PointReading("ms"))
    marks = [line for line in figure.axes[0].lines if line.get_marker() not in ("None", None)]
    assert [mark.get_markerfacecolor() == theme().paper for mark in marks] == [False, True, True]


@pytest.mark.parametrize("low", [0.013, 1.0, 97.0, 1777.0])
@pytest.mark.parametrize("ratio", [1.1, 1.5, 2.0, 4.0, 10.0, 70.0, 1e3, 1e9])
def test_ticks_are_few_and_round(low: float, ratio: float) -> None:
    figure = sheet.blank(4, 3)
    axes: Axes = figure.add_subplot()
    axes.set(xscale="log", xlim=(low, low * ratio))
    sheet.round_ticks(axes.xaxis)
    found = [at for at in axes.get_xticks() if low <= at <= low * ratio * (1 + 1e-9)]
    assert 2 <= len(found) <= 8
    assert all(len(f"{at:g}") <= 6 for at in found)


@pytest.mark.parametrize("bar", [0, 1])
def test_shares_of_open_time_keep_their_sum(bar: int) -> None:
    """Slots finer than the chart's columns: as dark as they are open."""
    program = container(2, 1, 4096, None)
    with sheet.style():
        figure = shutter_sheet(replace(program, slot_us=(1.0,) * 4096), "a.nsl")
    image = figure.axes[0].images[0].get_array()
    closed, own = image[2 * bar].max(axis=0), image[2 * bar].min(axis=0)
    assert 0.3 < (image[2 * bar].mean(axis=0) - closed)[0] / (own - closed)[0] < 0.7


# Machado, Oliveira and Fernandes 2009, severity 1.0, on linear RGB.
BLIND = {
    "protanopia": [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216],
                   [-0.003882, -0.048116, 1.051998]],
    "deuteranopia": [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413],
                     [-0.011820, 0.042940, 0.968881]],
    "tritanopia": [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602],
                   [0.004733, 0.691367, 0.303900]],
}  # fmt: skip
LAB = [
    [0.4122214708, 0.5363325363, 0.0514459929],
    [0.2119034982, 0.6806995451, 0.1073969566],
    [0.0883024619, 0.2817188376, 0.6299787005],
]
OKLAB = [
    [0.2104542553, 0.7936177850, -0.0040720468],
    [1.9779984951, -2.4285922050, 0.4505937099],
    [0.0259040371, 0.7827717662, -0.8086757660],
]


@pytest.mark.parametrize("kind", BLIND)
@pytest.mark.parametrize("chosen", THEMES.values(), ids=THEMES)
def test_the_colour_blind_tell_series_apart(chosen: Theme, kind: str) -> None:
    """Colours of two series differ by 0.07 in Oklab, three times the least visible difference."""
    rgb = np.array([to_rgb(colour) for colour in chosen.series])
    linear = np.where(rgb > 0.04045, ((rgb + 0.055) / 1.055) ** 2.4, rgb / 12.92)
    seen = np.clip(linear @ np.array(BLIND[kind]).T, 0, 1)
    lab = np.cbrt(seen @ np.array(LAB).T) @ np.array(OKLAB).T
    apart = [np.linalg.norm(a - b) for a, b in combinations(lab, 2)]
    assert min(apart) > 0.07


@pytest.mark.parametrize("chosen", THEMES.values(), ids=THEMES)
def test_text_has_enough_contrast_with_its_background(chosen: Theme) -> None:
    """WCAG 2.2 requires a contrast of 4.5 for small text, and of 3 for other marks. Letters inside
    coloured boxes have at least 4.0."""
    typed = [chosen.ink, chosen.faint, *map(chosen.type_in, chosen.series)]
    assert min(contrast(colour, chosen.paper) for colour in typed) >= 4.5
    assert min(contrast(chosen.on(colour), colour) for colour in chosen.series) >= 4.0
    assert contrast("#000000", "#ffffff") == pytest.approx(21)
    assert contrast("#777777", "#ffffff") == pytest.approx(4.478, abs=1e-3)


def test_looks_differ_in_colours_only() -> None:
    """The same letters at the same places on the same size, light and dark."""
    sizes, grounds = [], []
    for chosen in THEMES.values():
        with themed(chosen):
            image = PillowImage.open(io.BytesIO(sheet.png_of(CHARTS["two lines"]))).convert("RGB")
        sizes.append(image.size)
        grounds.append("#{:02x}{:02x}{:02x}".format(*image.getpixel((1, 1))))  # type: ignore[misc]
    assert sizes[0] == sizes[1]
    assert grounds == [chosen.paper for chosen in THEMES.values()]
    assert theme() is THEMES["light"]


@pytest.mark.parametrize("chosen", THEMES.values(), ids=THEMES)
def test_series_differ_in_colour_or_marker(chosen: Theme) -> None:
    # Seven colours and six markers: 42 pairs before one repeats.
    looks = [tuple(chosen.of(i).values()) for i in range(42)]
    assert len(set(looks)) == 42


@pytest.mark.parametrize("chosen", THEMES.values(), ids=THEMES)
def test_series_repeat_their_colours_and_markers(chosen: Theme) -> None:
    colours, markers = len(chosen.series), len(MARKERS)
    for number in range(3 * colours * markers):
        style = chosen.of(number)
        assert style["color"] == chosen.series[number % colours]
        assert style["marker"] == MARKERS[number % markers]
        assert style == chosen.of(number + colours * markers)


@pytest.mark.parametrize("chosen", THEMES.values(), ids=THEMES)
def test_small_type_keeps_as_much_of_its_colour_as_can_be_read(chosen: Theme) -> None:
    """A colour that can be read is not changed; the paper's own colour becomes one that can be."""
    for colour in (*chosen.series, chosen.paper):
        shade = chosen.type_in(colour)
        assert contrast(shade, chosen.paper) >= 4.5
        assert (shade == colour) == (contrast(colour, chosen.paper) >= 4.5)
