"""The tradeoff of an image: the time of its words against the noise that they add."""

from __future__ import annotations

from functools import partial
from itertools import groupby
from pathlib import Path
from typing import TYPE_CHECKING, Any

from nscc.neighbours.programs import UNIT, exact_taps, noise_gain
from nscc.neighbours.synthesis import STEPS_OF_LEVEL, Synthesis
from nscc.neighbours.table import WordForms
from nscc.options import Options
from nscc.pipeline import run_passes
from nscc.syntax.parse import read_source
from nscc.words.pictures import Filtered, subexpressions
from nscc_runtime.pictures.precision import Panel, PointReading, precision_diagram
from nscc_training.experiments.study import Study, StudyPoint, StudyResult
from nscc_training.experiments.study_table import table_text

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def images_study(path: Path, level: int) -> Study:
    """Return the study of the words for the kernels of the images of the program in file `path`:
    several programs of words for each kernel, as this `level` of optimisation finds them.

    The error is the standard deviation of the result's error, as a multiple of the error of one
    word. Raises Rejected if the file does not compile."""
    container = run_passes(read_source(path), path.parent, Options(level=level)).container
    assert container is not None
    pictures, word_us = container.pictures, container.target.analog_word_us
    synthesis = Synthesis(STEPS_OF_LEVEL[level], WordForms.choices(container.target)[0])
    points: dict[tuple[Any, ...], StudyPoint] = {}
    for item in pictures.items:
        for node in subexpressions(item.node):
            if not isinstance(node, Filtered):
                continue
            taps = exact_taps(pictures.weights_by_name[node.kernel].taps)
            for ranged in synthesis.variants(taps):
                words = len(ranged.program)
                setting = f"{words} words, peak gain {ranged.peak / UNIT:g}"
                noise = round(noise_gain(ranged.program), 6)
                figures = {"words": noise, "ms": [words * word_us / 1000], "setting": setting}
                key = item.name, node.kernel, f"{setting}, {noise}"
                points[key] = StudyPoint(*key, partial(dict, figures))

    def text(measured: StudyResult) -> str:
        """Return the table of words, noise and time for each image."""
        return table_text(measured.points, ("kernel", "program", "noise"), ("us", 1000.0))

    return Study([*points.values()], text, {"png": images_diagram}, device="the chip's table")


def images_diagram(measured: StudyResult, _device: str) -> Figure:
    """Draw noise against time: a panel for each image, a line for each kernel. Points of one image
    follow each other. The device does not matter, because times are the chip's."""
    groups = groupby(measured.points, key=lambda point: point.case)
    panels = [Panel(case, "errors of one word", list(group)) for case, group in groups]
    return precision_diagram(
        panels,
        "Programs of words for kernels",
        "standard deviation of the error that the words add (numbers: words; hollow: dominated) "
        "against their time",
        PointReading("time, us", 1e3, text=lambda point: point.setting.partition(" ")[0]),
    )
