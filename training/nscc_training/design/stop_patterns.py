"""Search for the best fixed pattern of exposure times (stops) for stills.

Searches that change codes in small steps never change the number of exposure levels. This search
tries every pattern of 1 to 8 geometric levels and compares them by merging neighbours, which
favours no pattern. Pixels of class b do not depend on each other's shutters. The frame of a pattern
is therefore composed of emulated frames in which all pixels have the same stop."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from typing import TypeVar

import numpy as np

from nscc.arrays import Bools, Floats, Floats32, Ints
from nscc.words.container import Container
from nscc_runtime.effects import everything
from nscc_runtime.light import Light
from nscc_runtime.request import Request
from nscc_runtime.response import response_of
from nscc_runtime.simulate import simulate
from nscc_training.baselines.merge_loop import merged
from nscc_training.code_choices import RANKS, over_array
from nscc_training.design.chip import DesignChip
from nscc_training.design.make import Design, Frame, Scenes
from nscc_training.design.scene import peak_of, stops_tried
from nscc_training.design.text import tile_text
from nscc_training.metrics import mu_psnr, psnr

Progress = Callable[[Sequence[int]], Iterable[int]]
"""A function that passes on the numbers of tasks, and may show a bar."""
Candidate = TypeVar("Candidate")
TRIALS = 24
"""Number of changes of the best candidate that a search tries at the end."""

_HALF_STOPS = (2, 3, 4, 5, 6, 7, 8)
"""Ratios between neighbouring levels in half stops: factors of 2 to 16."""
_FINALISTS = 8
"""Number of patterns with the highest PSNR whose words are counted."""
_DB_PER_WORD = 0.005
"""Cost of a word in the objective, in dB; the 28 words of a 2 x 2 tile cost 0.14 dB."""


@dataclass(frozen=True, eq=False)
class Pattern:
    """A tile of exposure times `stops` in slots (rows, cols), called after its shape (`name`), and
    its mean PSNR over scenes in dB, linear and on the mu-law curve; both are 0 until measured."""

    name: str
    stops: Ints
    linear_db: float = 0.0
    mu_db: float = 0.0

    @property
    def mean_db(self) -> float:
        """The mean of linear and mu-law PSNR, so that a pattern must be good in both."""
        return (self.linear_db + self.mu_db) / 2

    @property
    def psnr_text(self) -> str:
        """The two mean PSNR, linear and mu-law, as text."""
        return f"{self.linear_db:.1f} dB PSNR linear, {self.mu_db:.1f} dB PSNR mu-law"

    def stops_text(self, slots: int) -> str:
        """Return the name and the different exposure times, the longest first, as text. `slots` is
        the length of the frame."""
        stops = sorted({int(stop) for stop in self.stops.flat}, reverse=True)
        return f"{self.name}, {', '.join(map(str, stops))} of {slots} slots"

    def text(self, frame: Frame, remark: str = "") -> str:
        """Return the program for the chip and slots of `frame`, with `remark` as the comment at its
        head."""
        stops = self.stops.tolist()
        return tile_text(stops, frame.slots, frame.slot_us, frame.named, remark)

    def container(self, frame: Frame) -> Container:
        """Compile the program. Raise Rejected if it does not fit."""
        return frame.container("pattern.nsl", self.text(frame))


@dataclass(frozen=True, eq=False)
class PatternDesign(Design):
    """A design that gives every pixel of a tile an exposure time: `pattern` is the best tile of
    stops (times in slots), `ranked` all tiles that were compared, the best first."""

    pattern: Pattern
    ranked: tuple[Pattern, ...]


def shapes() -> dict[str, Ints]:
    """Return the shapes of patterns by name: for every pixel of a tile the number of its exposure
    level. Level 0 is the longest exposure."""
    levels_of_shape = {
        "uniform": np.array([[0]]),
        "checkerboard": np.array([[0, 1], [1, 0]]),
        "L-shaped": np.array([[0, 1], [1, 2]]),
        "2 x 2": np.array([[0, 1], [2, 3]]),
        "1 x 4": np.array([[0, 2, 1, 3]]),
        "diagonal 3 x 3": np.add.outer(np.arange(3), np.arange(3)) % 3,
        "ordered 4 x 4": RANKS // 2,
    }
    for levels in (2, 3, 4, 8):
        # The 64 pixels of an 8 x 8 tile in random order, about as many at each level.
        level_of_pixel = np.random.default_rng(levels).permutation(64) * levels // 64
        levels_of_shape[f"stochastic, {levels} levels"] = level_of_pixel.reshape(8, 8)
    return levels_of_shape


def patterns(slots: int) -> list[Pattern]:
    """Return all patterns of exposure times in a frame of `slots` slots: each shape with each ratio
    of neighbouring levels and each longest time, if its shortest time is at least one slot."""
    stops = np.array(stops_tried(slots))
    candidates = [Pattern("uniform", stops[k : k + 1, None]) for k in range(len(stops))]
    for name, levels in shapes().items():
        deepest = int(levels.max())
        for step in _HALF_STOPS:
            for longest in range(len(stops) - 1, -1, -1):
                # A shape of one level is the uniform one, which is listed already.
                if deepest and longest >= step * deepest:
                    candidates.append(Pattern(name, stops[longest - step * levels]))
    return candidates


def design_pattern(
    scenes: Scenes, frame: Frame | None = None, progress: Progress = iter, trials: int = TRIALS
) -> PatternDesign:
    """Design the pattern of stops with the highest PSNR after merging, minus a cost for its words.

    The PSNR is simulated with all effects. The best of `patterns` is improved by `trials` random
    changes of one stop, each of which is kept if it measures better. `scenes` are stills (rows,
    cols) in electrons over the frame; `frame` None takes the defaults of `Frame`. Raises Rejected:
    NS0824 for a scene without light, and the compiler's errors. `progress` receives the numbers of
    the scenes, the patterns and the changes."""
    frame = frame or Frame()
    slots = frame.slots
    measured = _judge(scenes, frame, progress)
    candidates = patterns(slots)
    scored = [measured(candidates[k]) for k in progress(range(len(candidates)))]
    ranked = sorted(scored, key=lambda pattern: -pattern.mean_db)

    best, gain_db = tuned(
        ranked,
        progress(range(trials)),
        lambda pattern, generator: measured(changed(pattern, slots, generator)),
        lambda pattern: less_words(pattern.mean_db, pattern.container(frame)),
    )
    best_of_shape = {pattern.name: pattern for pattern in reversed(ranked)}
    # Frames of few slots have no 2 x 2 tile of four stops.
    others = [best_of_shape[name] for name in ("uniform", "2 x 2") if name in best_of_shape]
    remark = f"The pattern of stops that merging is best behind, of {len(ranked)}: {best.name}."
    text = best.text(frame, remark)
    lines = (
        ("pattern", best.stops_text(slots)),
        ("tried", f"{len(ranked)} patterns, by merging under every effect"),
        ("tuned", f"{trials} changes of the best tried: {gain_db:+.2f} dB"),
        ("reached", best.psnr_text),
        *((other.name, f"{other.stops_text(slots)}: {other.psnr_text}") for other in others),
    )
    return PatternDesign(text, frame.compiled("pattern.nsl", text), lines, best, tuple(ranked))


def _judge(scenes: Scenes, frame: Frame, progress: Progress) -> Callable[[Pattern], Pattern]:
    """Expose the scenes under all effects. Return a function that gives a pattern its mean PSNR
    over them after merging.

    `scenes` are stills (rows, cols) in electrons over the frame. `progress` receives their numbers.
    Raises Rejected (NS0824) for a scene without light."""
    chip, exposed = frame.chip(), []
    for number in progress(range(len(scenes))):
        light_e = np.asarray(scenes[number], np.float64)
        peak = peak_of(light_e.reshape(-1), number)
        frames = _frames(chip, light_e, frame, number)
        exposed.append((np.clip(light_e / peak, 0, 1), peak, frames))

    def measured(pattern: Pattern) -> Pattern:
        """Return `pattern` with its mean PSNR."""
        scores = []
        for truth, peak, frames in exposed:
            light = np.clip(_merged(chip, frames, pattern, frame.slots) / peak, 0, 1)
            scores.append((psnr(truth, light, 1.0), mu_psnr(truth, light, 1.0)))
        linear_db, mu_db = np.mean(scores, axis=0)
        return replace(pattern, linear_db=float(linear_db), mu_db=float(mu_db))

    return measured


def changed(pattern: Pattern, slots: int, generator: np.random.Generator) -> Pattern:
    """Return `pattern` with one of its exposure times, chosen at random, longer or shorter by one
    or two half stops, in a frame of `slots` slots."""
    stops = stops_tried(slots)
    old = generator.choice(np.unique(pattern.stops))
    place = stops.index(old) + generator.choice((-2, -1, 1, 2))
    new = stops[int(np.clip(place, 0, len(stops) - 1))]
    return replace(pattern, stops=np.where(pattern.stops == old, new, pattern.stops))


def tuned(
    ranked: Sequence[Candidate],
    trials: Iterable[int],
    change: Callable[[Candidate, np.random.Generator], Candidate],
    worth_db: Callable[[Candidate], float],
) -> tuple[Candidate, float]:
    """Return the best of `ranked` after those of random changes that improve it, and their gain in
    dB.

    `ranked` has at least one candidate, with falling PSNR. The best is the first of `_FINALISTS`
    with the highest `worth_db`, the PSNR minus a cost for words (`less_words`). `change` returns a
    changed and measured candidate for each of `trials`."""
    generator = np.random.default_rng(0)
    worth, best = max(
        ((worth_db(candidate), candidate) for candidate in ranked[:_FINALISTS]),
        key=lambda pair: pair[0],
    )
    first = worth
    for _ in trials:
        candidate = change(best, generator)
        if (found := worth_db(candidate)) > worth:
            best, worth = candidate, found
    return best, worth - first


def less_words(mean_db: float, container: Container) -> float:
    """Return a PSNR in dB minus the cost of the words of a frame."""
    return mean_db - _DB_PER_WORD * container.words_per_frame


def _frames(
    chip: DesignChip, light_e: Floats, frame: Frame, number: int
) -> dict[int, tuple[Floats32, Bools]]:
    """Return the frames of a still whose pixels all have the same exposure time, by this time in
    slots: electrons (rows, cols) and which pixels are saturated.

    `light_e` (rows, cols) is in electrons over the frame, at most as large as the array. `number`
    is that of the scene, and seeds the noise."""
    seconds = np.full(frame.slots, frame.slot_us * 1e-6)
    target, sensor = chip.target, chip.sensor
    rows, cols = light_e.shape
    margins = ((0, target.rows - rows), (0, target.cols - cols))
    padded = np.pad(light_e / seconds.sum(), margins, mode="edge").astype(np.float32)
    light = Light.of_still(padded, seconds)
    frame_by_stop = {}
    for stop in stops_tried(frame.slots):
        container = Pattern("uniform", np.array([[stop]])).container(frame)
        request = Request.of(effects="all", seed=1000 * number + stop)
        taken = simulate(container, light, sensor, request).frame
        electrons = response_of(container, sensor, everything()).electrons(taken.frame)[0]
        # All scenes stay in memory, in half the bytes of a float64.
        electrons = electrons[:rows, :cols].astype(np.float32)
        frame_by_stop[stop] = (electrons, taken.saturated[0, :rows, :cols])
    return frame_by_stop


def _merged(
    chip: DesignChip,
    frames: dict[int, tuple[Floats32, Bools]],
    pattern: Pattern,
    slots: int,
) -> Floats:
    """Return the light over the frame in electrons (rows, cols) that merging reconstructs from a
    pattern of stops.

    `frames` are the results of `_frames`, from which each pixel takes the frame with its own stop.
    `slots` is the number of slots of the frame."""
    rows, cols = next(iter(frames.values()))[0].shape
    stops = over_array(pattern.stops, rows, cols)
    exposed, saturated = np.zeros((rows, cols)), np.zeros((rows, cols), bool)
    for stop in np.unique(pattern.stops):
        has_stop = stops == stop
        exposed[has_stop], saturated[has_stop] = (values[has_stop] for values in frames[int(stop)])
    noise_e = float(chip.exposed_sd_e(np.zeros(1))[0])
    lsb_e = chip.code_e
    return merged(np.maximum(exposed, 0) / lsb_e, stops / slots, lsb_e, saturated, noise_e)
