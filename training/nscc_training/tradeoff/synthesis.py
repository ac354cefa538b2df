"""Compile-time tradeoffs: words per frame against time, and words of kernels against noise."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from itertools import groupby, product
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from nscc.limits.families import bits_rule, book_rule, bump_rule, program_text, start_rule
from nscc.lower.exposure_plan import Lowering
from nscc.neighbours.programs import UNIT, exact_taps, noise_gain
from nscc.neighbours.synthesis import STEPS_OF_LEVEL, Synthesis
from nscc.neighbours.table import WordForms
from nscc.options import Options
from nscc.pipeline import KINDS, LEVELS, Compiled, run_passes
from nscc.program.program import Codes
from nscc.source import Source
from nscc.syntax.parse import read_source
from nscc.words.pictures import Filtered, subexpressions
from nscc_runtime.pictures.precision import Panel, PointReading, precision_diagram
from nscc_training.command_settings import Count, SynthesisStudySettings
from nscc_training.experiments.engine import Figures
from nscc_training.experiments.study import Study, StudyPoint, StudyResult
from nscc_training.experiments.study_table import refusals_text, table_text

if TYPE_CHECKING:
    from matplotlib.figure import Figure

UNITS: dict[Count, str] = {"all": "words_per_frame", "logic": "logic_words_per_frame"}
_WORDS: dict[Count, str] = {"all": "words a frame", "logic": "logic words a frame"}


class StudiedProgram(NamedTuple):
    """A program to compile, called `name` in the table. Paths in the text `source` are relative to
    `base`. `codes` says whether it must work for the codes in use ("fixed") or for all legal ones
    ("open")."""

    name: str
    source: Source
    base: Path
    codes: Codes

    def compiled(self, lowering: Lowering, level: int) -> Compiled:
        """Compile the program from text to proof with this lowering (a way to compute the exposure)
        and level, without the cache. Raise Rejected if it does not fit."""
        options = Options(level=level, codes=self.codes, lowering=lowering, cache=False)
        return run_passes(self.source, self.base, options)


def builtin_programs() -> tuple[StudiedProgram, ...]:
    """Return the programs that are compiled if the user names none: classes b to e and a random
    codebook, in sizes for a chip with 13 registers."""
    rows = np.random.default_rng(1).integers(0, 2, (64, 16))
    rules = {
        **{f"b {n}": (n, f"code stop : 0..{n - 1}\nopen when n < stop") for n in (16, 64, 256)},
        **{f"c (64, {length})": (64, start_rule(length)) for length in (8, 13)},
        **{f"d {n}": (n, bump_rule()) for n in (16, 32)},
        "e 12": (12, bits_rule()),
        "codebook 64 x 16": (16, book_rule(["".join(map(str, row)) for row in rows])),
    }
    return tuple(
        StudiedProgram(
            name, Source(f"{name}.nsl", program_text(slots, "1ms", rule)), Path(), "open"
        )
        for name, (slots, rule) in rules.items()
    )


def programs_of(files: Sequence[Path]) -> tuple[StudiedProgram, ...]:
    """Return the programs in these files, in order and each once, named after the files without
    their endings, or if these are equal, after their paths."""
    paths = list(dict.fromkeys(files))
    short = len({path.stem for path in paths}) == len(paths)
    return tuple(
        StudiedProgram(
            path.stem if short else path.as_posix(), read_source(path), path.parent, "fixed"
        )
        for path in paths
    )


def synthesis_study(programs: Sequence[StudiedProgram], settings: SynthesisStudySettings) -> Study:
    """Return the study of each combination of program, lowering and level, with the words that
    `settings.count` names as its error. A lowering is a way to compute the exposure."""
    count = settings.count
    words = _WORDS[count]
    points = [
        StudyPoint(
            program.name,
            lowering,
            f"-O{level}",
            partial(program.compiled, lowering, level),
            partial(word_figures, count),
            partial(program.compiled, lowering, min(LEVELS)),
        )
        for program, lowering, level in product(programs, settings.lowerings, settings.levels)
    ]

    def text(measured: StudyResult) -> str:
        """Return the table of words and times, and the programs that do not fit."""
        table = table_text(measured.points, ("lowering", "level", words))
        return "\n".join([table, *refusals_text(measured.refused)])

    return Study(points, text, {"png": partial(synthesis_diagram, words)}, settings.repeats)


def word_figures(count: Count, compiled: Compiled) -> Figures:
    """Return the number of words of a compiled program, those that `count` names, and a lower bound
    of it (None if unknown).

    The bound is that of the logic, plus the analog words of the plan if all words count."""
    lowered = compiled.lowered
    assert lowered is not None
    logic = KINDS.of(compiled.program).report(compiled)["logic"]
    words, bound = logic["words"], logic["bound"]
    if count == "all":
        words = lowered.schedule.words_total
        if bound is not None:
            bound += sum(len(step.words) for step in lowered.plan.steps)
    return {UNITS[count]: words, "bound": bound}


def synthesis_diagram(words: str, measured: StudyResult, device: str) -> Figure:
    """Draw words against compile time: a panel for each program, a line for each lowering (a way to
    compute the exposure). `words` says which words are counted, and `device` is named in the note.
    """
    points = measured.points
    panels = [
        Panel(case, words, list(group)) for case, group in groupby(points, key=lambda p: p.case)
    ]
    levels = " ".join(sorted({point.setting for point in points}))
    times = measured.times.replace("run", "compilation")
    return precision_diagram(
        panels,
        "What compile time buys",
        f"{words} at {levels} (numbers; hollow: dominated) against {times}, from text to proof, "
        f"on {device}",
        PointReading("time, s", 1e-3, text=lambda point: point.setting.removeprefix("-O")),
    )


def images_study(path: Path, level: int) -> Study:
    """Return the study of the words for the kernels of the images of the program in file `path`:
    several programs of words for each kernel, as this `level` of optimisation finds them.

    The error is the standard deviation of the result's error, as a multiple of the error of one
    word. Raises Rejected if the file does not compile."""
    container = run_passes(read_source(path), path.parent, Options(level=level)).built
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
