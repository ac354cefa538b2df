"""The tradeoff of an image: the time of its words against the noise that they add."""

from __future__ import annotations

from pathlib import Path

from nscc.neighbours.programs import UNIT, exact_taps, noise_gain
from nscc.neighbours.synthesis import STEPS_OF_LEVEL, Synthesis
from nscc.neighbours.table import WordForms
from nscc.options import Options
from nscc.pipeline import run_passes
from nscc.syntax.parse import read_source
from nscc.tradeoff.points import Point
from nscc.words.pictures import Filtered, subexpressions


def image_points(path: Path, level: int) -> list[Point]:
    """Return a point for each program that `level` of optimisation finds for a file's kernels.

    A point is the standard deviation of the result's error, as a multiple of the error of one word,
    and the time of the words in milliseconds. Raises Rejected if the file does not compile."""
    container = run_passes(read_source(path), path.parent, Options(level=level)).container
    assert container is not None
    pictures, target = container.pictures, container.target
    synthesis = Synthesis(STEPS_OF_LEVEL[level], WordForms.choices(target)[0])
    points: dict[Point, None] = {}
    for item in pictures.items:
        for node in subexpressions(item.node):
            if not isinstance(node, Filtered):
                continue
            taps = exact_taps(pictures.weights_by_name[node.kernel].taps)
            for ranged in synthesis.variants(taps):
                words = len(ranged.program)
                setting = f"{words} words, peak gain {ranged.peak / UNIT:g}"
                noise = round(noise_gain(ranged.program), 6)
                ms = words * target.analog_word_us / 1000
                points[Point(item.name, node.kernel, setting, noise, "words", (ms,))] = None
    return list(points)
