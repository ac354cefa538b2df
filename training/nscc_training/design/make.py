"""Programs for scenes: design, compile, prove."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations_with_replacement
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from nscc.arrays import Floats, Floats32
from nscc.chips.load import load_target
from nscc.compiler import compile_source
from nscc.options import Options
from nscc.pipeline import Compiled
from nscc.source import Source
from nscc.words.container import Container
from nscc_runtime.sensor import Sensor, default_sensor
from nscc_training.design.chip import CURVES, Curve, DesignChip, on_curve
from nscc_training.design.looking import Expected, LookModel, LookSchedule
from nscc_training.design.scene import histogram, peak_of, stops_tried
from nscc_training.design.text import level_text, looking_text, tile_text
from nscc_training.metrics import psnr_of_mse

_PLACES = 4
"""Pixels of a 2 x 2 tile."""
_MOST_TILES = 2048
"""Most tiles of a scene that are evaluated, evenly spaced over the scene."""


class Tile(NamedTuple):
    """A 2 x 2 tile of stops, row by row from the top left. Its `risk` is the mean square error, on
    the scale of a `Curve`, that an ideal decoder cannot remove."""

    stops: tuple[int, int, int, int]
    risk: float


def best_tile(
    chip: DesignChip, scenes: Sequence[NDArray[np.floating]], slots: int, curve: Curve
) -> tuple[Tile, int]:
    """Return the 2 x 2 tile with the smallest mean risk over the scenes, and the number of tiles
    that were tried.

    The criterion is that of spatially varying exposures (Qu, Chi and Chan, "Spatially Varying
    Exposure with 2-by-2 Multiplexing: Optimality and Universality", 2023, SVE-Risk). An ideal
    decoder uses for each pixel the best measurement in its tile, and knows which one is best. The
    remaining error is the risk. It includes the measurement's noise and clipping, and the
    difference between the light of the two pixels.

    Scenes are in electrons over the frame (rows, cols). Raises Rejected (NS0824) for a scene
    without light."""
    stops = stops_tried(slots)
    tiles = list(combinations_with_replacement(range(len(stops)), _PLACES))
    risks = np.zeros(len(tiles))
    for number, scene in enumerate(scenes):
        stop_errors, apart = _tables(
            chip, np.asarray(scene, np.float64), number, stops, slots, curve
        )
        for k, tile in enumerate(tiles):
            # The error of pixel p of each tile if estimated from pixel q: the error of q's own
            # measurement, and the difference between the light of q and p.
            by = np.stack([stop_errors[:, q, stop] for q, stop in enumerate(_laid(tile))], axis=1)
            risks[k] += (by[:, None, :] + apart).min(axis=2).mean() / len(scenes)
    best = int(risks.argmin())
    a, b, c, d = (stops[k] for k in _laid(tiles[best]))
    return Tile((a, b, c, d), float(risks[best])), len(tiles)


def _laid(tile: tuple[int, ...]) -> tuple[int, ...]:
    """Return the four stops (or indices) of a tile, given from short to long, in the order of its
    pixels row by row: from long to short."""
    return tuple(reversed(tile))


def _tables(
    chip: DesignChip, scene: Floats, number: int, stops: Sequence[int], slots: int, curve: Curve
) -> tuple[Floats32, Floats32]:
    """Return two tables from which the risk of every 2 x 2 tile of stops is computed, for squares
    of 2 x 2 pixels of a scene.

    The first is the error of each pixel's own measurement for each of `stops`, (squares, pixels,
    stops). The second is the squared difference between the light of two pixels, (squares, pixels,
    pixels). Both are on `curve`. `slots` is the number of slots of the frame, and `number` that of
    the scene (0 is the first), for messages."""
    peak = peak_of(scene.reshape(-1), number)
    # A scene of one row or column has no tiles: it is repeated.
    scene = np.tile(scene, [2 if side == 1 else 1 for side in scene.shape])
    rows, cols = (side // 2 * 2 for side in scene.shape)
    squares = scene[:rows, :cols].reshape(rows // 2, 2, cols // 2, 2).swapaxes(1, 2)
    tiles = squares.reshape(-1, _PLACES)
    tiles = tiles[:: -(-len(tiles) // _MOST_TILES)]
    light, peaks = tiles.reshape(-1), np.full(tiles.size, peak)
    stop_errors = chip.errors(light, peaks, np.array(stops) / slots, curve)
    on = on_curve(tiles, np.array(peak), curve, chip.code_e)
    apart = (on[:, :, None] - on[:, None, :]) ** 2
    shape = (*tiles.shape, len(stops))
    return stop_errors.reshape(shape).astype(np.float32), apart.astype(np.float32)


Scenes = Sequence[NDArray[np.floating]]


@dataclass(frozen=True)
class Frame:
    """The frame of a design: `slots` slots of `slot_us` microseconds on a chip.

    `target` is the chip's name or file. `sensor` is its sensor, None for the default one. `level`
    is the optimisation level of the compiler."""

    slots: int = 256
    slot_us: float = 125.0
    target: str = "scamp5"
    sensor: Sensor | None = None
    level: int = 2

    def chip(self) -> DesignChip:
        """Return the target with its sensor and all effects. Raise Rejected for an invalid
        target."""
        target = load_target(self.target, Path())
        return DesignChip.of(target, self.sensor or default_sensor(target))

    def compiled(self, name: str, text: str) -> Compiled:
        """Compile and prove the program `text` for this chip. Messages call it `name`. Raise
        Rejected with the compiler's errors."""
        file = self.target if self._from_file else None
        return compile_source(Source(name, text), Path(), Options(level=self.level, target=file))

    def container(self, name: str, text: str) -> Container:
        """Return the container of a program; raise Rejected if the program does not fit."""
        return self.compiled(name, text).built

    @property
    def named(self) -> str | None:
        """The target's name for the program text; None for a file, whose path is an option, not
        relative to the program."""
        return None if self._from_file else self.target

    @property
    def _from_file(self) -> bool:
        """Whether the chip is a target file."""
        return self.target.endswith(".toml")


@dataclass(frozen=True, eq=False)
class Design:
    """A program for scenes: its `text`, `compiled`, the compiler's result, and `lines`, pairs of a
    label and a text that describe the design."""

    text: str
    compiled: Compiled
    lines: tuple[tuple[str, str], ...]


@dataclass(frozen=True, eq=False)
class LookingDesign(Design):
    """A design whose pixels compare their light with a level at several times, and close when it is
    above. `schedule` contains times and levels, `expected` the expected errors."""

    schedule: LookSchedule
    expected: Expected


@dataclass(frozen=True, eq=False)
class TileDesign(Design):
    """A design that repeats a `tile` of 2 x 2 exposure times over the sensor."""

    tile: Tile


def design_looks(
    scenes: Scenes, exposures: int, frame: Frame | None = None, curve: Curve = "mu"
) -> LookingDesign:
    """Design the program of looks with the smallest expected error, without a decoder.

    `curve` is the scale on which errors are measured (`nscc_training.design.chip`). Each pixel has
    one of `exposures` exposure times; the last ends with the frame. `scenes` are (rows, cols), in
    electrons of an always open pixel over the frame, and have equal weight. `frame` None takes the
    defaults of `Frame`. Raises Rejected: NS0824 for a scene without light, and the compiler's
    errors."""
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
    """Design the 2 x 2 tile of exposure times with the smallest risk (see `best_tile`).

    `curve` is the scale on which errors are measured (`nscc_training.design.chip`). `scenes` are
    stills (rows, cols) in electrons over the frame; `frame` None takes the defaults of `Frame`.
    Raises Rejected: NS0824 for a scene without light, and the compiler's errors."""
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


_CALLED: dict[Curve, str] = {"mu": "mu-law", "linear": "linear", "log": "logarithm"}


def expected_text(errors: dict[Curve, float]) -> str:
    """Return mean square errors by curve as text: as PSNR in dB for a peak of 1, or for the
    logarithm as root mean square in percent. The order is that of `CURVES`."""
    texts = []
    for curve in CURVES:
        if curve not in errors:
            continue
        if curve == "log":
            texts.append(f"{100 * math.sqrt(errors[curve]):.2g} % rms of the light")
        else:
            texts.append(f"{psnr_of_mse(errors[curve], 1.0):.1f} dB PSNR {_CALLED[curve]}")
    return ", ".join(texts)
