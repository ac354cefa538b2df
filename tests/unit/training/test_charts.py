"""Charts of runs, results, sensors and tradeoffs show what was recorded in tests/data/figures."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path

import pytest
from drawn_figures import compare_figure
from matplotlib.figure import Figure

pytest.importorskip("torch")


from nscc_runtime.pictures import sheet
from nscc_runtime.pictures.precision import Point
from nscc_runtime.pictures.sweeps import Lines, sweep_diagram
from nscc_runtime.scenes import Scene
from nscc_training.command_settings import STAGES, JointRequest
from nscc_training.experiments.study import StudyResult
from nscc_training.tradeoff.decoder import decoder_diagram
from nscc_training.tradeoff.joint import Joint, joint_diagram
from nscc_training.tradeoff.sensor import sensor_diagram
from nscc_training.tradeoff.synthesis import images_diagram, synthesis_diagram
from nscc_training.views import result_sheet, run_sheet, sensor_sheet

METRICS = """step,split,psnr_db,correct
0,train,11.5,0.1
0,val,10.25,
10,train,20.5,0.4
10,val,nan,0.375
20,train,24.0,0.6
20,val,22.5,0.5
"""
ROBUSTNESS = [
    {"change": "prnu_sigma=0.05", "psnr_db": 21.5, "correct": 0.25},
    {"change": "exposure 4", "psnr_db": "inf", "correct": 0.5},
    {"change": "full_well_e=9000", "psnr_db": 17.25, "correct": 0.75},
]


def run(path: Path, robustness: list[dict[str, object]] | None) -> Figure:
    (path / "metrics.csv").write_text(METRICS)
    result = {"robustness": robustness, "items": []}
    figure = run_sheet(path, result)
    figure.texts[-1].set_text("run")  # the folder's name differs in every test
    return figure


def items(metric: str, scenes: int) -> list[dict[str, object]]:
    """Scores of several items for each scene, without any order."""
    key = "class" if metric == "correct" else "file"
    return [
        {key: f"scene {n % scenes}", metric: 20 + 7 * math.sin(n)} for n in range(2 * scenes + 1)
    ]


def points(cases: tuple[str, ...], methods: tuple[str, ...], unit: str) -> list[Point]:
    return [
        Point(case, method, f"-O{n}", 30 + 3 * n + 5 * m + c, unit, (2.0**n + m, 3.0**n + m))
        for c, case in enumerate(cases)
        for m, method in enumerate(methods)
        for n in range(3)
    ]


def sensor(path: Path) -> Figure:
    (path / "chip.toml").write_text("full_well_e = 20000.0\n")
    return sensor_sheet(path / "chip.toml")


SCORED = {"protocol": "hdr-v1", "domain": "mu"}
KINDS: dict[str, Callable[[Path], Figure]] = {
    "a run": lambda path: run(path, None),
    "a run under changes": lambda path: run(path, [{**row} for row in ROBUSTNESS]),
    "a result": lambda _: result_sheet({**SCORED, "items": items("psnr_db", 5)}, "result"),
    "a result of classes": lambda _: result_sheet(
        {**SCORED, "items": items("correct", 30)}, "result"
    ),
    "a result under changes": lambda _: result_sheet({"robustness": ROBUSTNESS}, "result"),
    "a sensor": sensor,
    "a sweep": lambda _: sweep_diagram(
        [
            Lines("a", "slots", "words", {"one": [(1, 2.0), (100, 300.0)], "two": [(5, 9.0)]}),
            Lines("b", "slots", "words", {"two": [(7, 7.0), (8, 8.0)]}),
            Lines("c", "class", "psnr", {"one": [("b", 30.0), ("d", 31.0)]}),
            Lines("d", "slots", "share", {"three": [(2, 0.0), (3, 0.0)], "": []}),
        ],
        "a sweep",
        "a note",
    ),
    "a sweep of many lines": lambda _: sweep_diagram(
        [Lines("", "x", "y", {f"line {n}": [(1, n), (9, 2.0 * n)] for n in range(8)})], "t", ""
    ),
    "kernels": lambda _: images_diagram(
        StudyResult(tuple(points(("sobel", "mean"), ("sum", "tree"), "e"))), ""
    ),
    "synthesis": lambda _: synthesis_diagram(
        "words a frame",
        StudyResult(tuple(points(("class b", "class d"), ("edges", "latch"), "words")), repeats=3),
        "a card",
    ),
    "decoders": lambda _: decoder_diagram(
        StudyResult((
            *points(("hdr",), ("merge", "net"), "psnr_db"), *points(("hdr",), ("merge",), "ssim"),
        )),
        "a card",
    ),
    "shortest slots": lambda _: sensor_diagram(
        [
            *points(("stills",), ("b-8, edges", "float-3"), "psnr_db"),
            *points(("clips",), ("d-16, latch",), "psnr_db"),
        ],
        "scamp5", None,
    ),
    "stages": lambda _: joint_diagram(
        Joint(
            JointRequest(Path("p.nsl"), Scene("folder/s.hdr"), "1%", STAGES[:2]), 32.0, 1.2, 1e3
        ),
        StudyResult(tuple(points(STAGES[:2], ("short", "long"), "percent")), repeats=2),
        "a card",
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", KINDS)
def test_charts_show_the_recorded_figures(name: str, tmp_path: Path, update_cases: bool) -> None:
    """The words and points of each kind of chart are those of the recorded case."""
    with sheet.style():
        figure = KINDS[name](tmp_path)
        figure.draw_without_rendering()
    compare_figure(figure, name, update_cases)
