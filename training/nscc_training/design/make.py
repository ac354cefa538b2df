"""Programs for scenes: design, compile, prove."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal, get_args

import numpy as np
from numpy.typing import NDArray

from nscc.chips.load import load_target
from nscc.compiler import compile_source
from nscc.pipeline import Compiled, Options
from nscc.source import Source
from nscc.words.container import Container
from nscc_runtime.sensor import Sensor, default_sensor
from nscc_training.design.chip import CURVES, Curve, DesignChip
from nscc_training.design.looking import Expected, LookModel, LookSchedule
from nscc_training.design.scene import histogram
from nscc_training.design.stop_patterns import Pattern, Progress, cheapest, judged
from nscc_training.design.text import level_text, looking_text, tile_text
from nscc_training.design.tile import Tile, best_tile
from nscc_training.metrics import psnr_of_mse

Criterion = Literal["mu", "linear", "log", "sve-risk"]
CRITERIA: tuple[Criterion, ...] = get_args(Criterion)
SVE_RISK: Criterion = "sve-risk"
Scenes = Sequence[NDArray[np.floating]]


@dataclass(frozen=True)
class Frame:
    """The frame for which a program is designed.

    It has `slots` equal slots of `slot_us`. `target` is a chip's name or file, `sensor` its sensor
    (None: the default sensor), and `level` the compiler's optimisation level."""

    slots: int = 256
    slot_us: float = 125.0
    target: str = "scamp5"
    sensor: Sensor | None = None
    level: int = 2

    def chip(self) -> DesignChip:
        """Return the target with its sensor; raise Rejected for an invalid target."""
        target = load_target(self.target, Path())
        return DesignChip.of(target, self.sensor or default_sensor(target))

    def compiled(self, name: str, text: str) -> Compiled:
        """Compile and prove a program."""
        file = self.target if self._from_file else None
        return compile_source(Source(name, text), Path(), Options(level=self.level, target=file))

    def container(self, name: str, text: str) -> Container:
        """Return the container of a program; raise Rejected if the program does not fit."""
        container = self.compiled(name, text).container
        assert container is not None  # programs that do not fit are rejected
        return container

    @property
    def named(self) -> str | None:
        """The target's name for the program text; None for a file, which is a compiler option
        instead.

        A program would resolve the file's path relative to itself instead of the working folder."""
        return None if self._from_file else self.target

    @property
    def _from_file(self) -> bool:
        return self.target.endswith(".toml")


@dataclass(frozen=True, eq=False)
class Design:
    """A program: its `text`, the compiler's result, and `lines` that describe the design."""

    text: str
    compiled: Compiled
    lines: tuple[tuple[str, str], ...]


@dataclass(frozen=True, eq=False)
class LookingDesign(Design):
    """A design whose pixels look."""

    schedule: LookSchedule
    expected: Expected


@dataclass(frozen=True, eq=False)
class PatternDesign(Design):
    """A design with the best `pattern` of stops; `ranked` contains all patterns, the best first."""

    pattern: Pattern
    ranked: tuple[Pattern, ...]


@dataclass(frozen=True, eq=False)
class TileDesign(Design):
    """A design with a fixed 2 x 2 tile of stops."""

    tile: Tile


def design_looks(
    scenes: Scenes, exposures: int, frame: Frame | None = None, curve: Curve = "mu"
) -> LookingDesign:
    """Design the program of looks with the smallest expected error on a curve, without a decoder.

    Each pixel has one of `exposures` exposure times; the last ends with the frame. `scenes` are
    (rows, cols), in electrons of an always open pixel over the frame, and have equal weight. Raises
    Rejected: NS0824 for a scene without light, and the compiler's errors."""
    frame = frame or Frame()
    chip = frame.chip()
    slot_us = [frame.slot_us] * frame.slots
    model = LookModel(chip, histogram(scenes), slot_us)
    schedule = model.best(exposures - 1, curve)
    expected = model.expected(schedule)
    levels = [level_text(steps, chip.target) for steps in schedule.steps]
    remark = (
        f"A pixel closes at the first of {len(schedule.at)} looks that finds it above the level "
        f"there. Looks and\nlevels are those of the least error expected ({_CALLED[curve]})."
    )
    text = looking_text(schedule, frame.slots, frame.slot_us, chip.target, frame.named, remark)
    shares = ", ".join(f"{100 * share:.0f}%" for share in expected.closing)
    lines = (
        ("looks", f"after slots {', '.join(map(str, schedule.at))} of {frame.slots}"),
        ("above", ", ".join(levels)),
        ("close", f"{shares} of the pixels, the last at the end"),
        ("expected", expected_text(expected.errors)),
    )
    name = f"looks-{exposures}.nsl"
    return LookingDesign(text, frame.compiled(name, text), lines, schedule, expected)


def design_tile(scenes: Scenes, frame: Frame | None = None, curve: Curve = "mu") -> TileDesign:
    """Design the 2 x 2 tile of stops with the least risk on a curve, as `design_looks`."""
    frame = frame or Frame()
    chip = frame.chip()
    tile, tile_count = best_tile(chip, scenes, frame.slots, curve)
    remark = (
        f"The 2 x 2 tile of stops with the least risk ({_CALLED[curve]}) of {tile_count}: what "
        "the best pixel of a\ntile leaves open."
    )
    a, b, c, d = tile.stops
    text = tile_text([[a, b], [c, d]], frame.slots, frame.slot_us, frame.named, remark)
    lines = (
        ("stops", f"{', '.join(map(str, tile.stops))} of {frame.slots} slots"),
        ("tried", f"{tile_count} tiles of half stops"),
        ("risk", expected_text({curve: tile.risk}) + ", by an ideal decoder"),
    )
    return TileDesign(text, frame.compiled("sve-risk.nsl", text), lines, tile)


def design_pattern(
    scenes: Scenes, frame: Frame | None = None, progress: Progress = iter
) -> PatternDesign:
    """Design the pattern of stops with the highest PSNR after merging, minus a cost for its words.

    The PSNR is simulated with all effects. `nscc_training.design.stop_patterns` lists the patterns.
    `scenes` and errors are as for `design_looks`."""
    frame = frame or Frame()

    def text_of(stops: Sequence[Sequence[int]], remark: str = "") -> str:
        return tile_text(stops, frame.slots, frame.slot_us, frame.named, remark)

    def container_of(stops: Sequence[Sequence[int]]) -> Container:
        return frame.container("pattern.nsl", text_of(stops))

    ranked = judged(
        frame.chip(), [np.asarray(scene, np.float64) for scene in scenes], frame.slots,
        frame.slot_us, lambda stop: container_of([[stop]]), progress,
    )  # fmt: skip
    best = ranked[cheapest(
        [pattern.mean_db for pattern in ranked],
        lambda k: container_of(ranked[k].stops.tolist()).words_per_frame,
    )]  # fmt: skip
    uniform = next(pattern for pattern in ranked if pattern.name == "uniform")
    tile = next(pattern for pattern in ranked if pattern.name == "2 x 2")
    remark = f"The pattern of stops that merging is best behind, of {len(ranked)}: {best.name}."
    text = text_of(best.stops.tolist(), remark)
    lines = (
        ("pattern", _pattern_text(best, frame.slots)),
        ("tried", f"{len(ranked)} patterns, by merging under every effect"),
        ("reached", _reached_text(best)),
        ("uniform", f"{_pattern_text(uniform, frame.slots)}: {_reached_text(uniform)}"),
        ("2 x 2", f"{_pattern_text(tile, frame.slots)}: {_reached_text(tile)}"),
    )
    return PatternDesign(text, frame.compiled("pattern.nsl", text), lines, best, tuple(ranked))


def _pattern_text(pattern: Pattern, slots: int) -> str:
    stops = sorted({int(stop) for stop in pattern.stops.flat}, reverse=True)
    return f"{pattern.name}, {', '.join(map(str, stops))} of {slots} slots"


def _reached_text(pattern: Pattern) -> str:
    return f"{pattern.linear_db:.1f} dB PSNR linear, {pattern.mu_db:.1f} dB PSNR mu-law"


_CALLED: dict[Curve, str] = {"mu": "mu-law", "linear": "linear", "log": "logarithm"}


def expected_text(errors: dict[Curve, float]) -> str:
    """Return the mean square errors in a readable form: dB, or percent for the logarithm."""
    texts = []
    for curve in CURVES:
        if curve not in errors:
            continue
        if curve == "log":
            texts.append(f"{100 * math.sqrt(errors[curve]):.2g} % rms of the light")
        else:
            texts.append(f"{psnr_of_mse(errors[curve], 1.0):.1f} dB PSNR {_CALLED[curve]}")
    return ", ".join(texts)
