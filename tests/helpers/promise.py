"""The promise of a plan, measured without the project's own audit.

Scenes of every kind, and the exposures of whole frames with a plan's effects and with every effect,
by the loop over words with the same random numbers, which are not those of planning."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from nscc.words.container import Container
from nscc_runtime.effects import Selection, everything, selected
from nscc_runtime.execution.block_scene import expose_pixels, prepare_pixels
from nscc_runtime.light import Light
from nscc_runtime.planning.make import make_plan
from nscc_runtime.planning.plan import Plan, PlanRequest
from nscc_runtime.planning.planned_scene import PlannedScene
from nscc_runtime.sensor import Sensor

POOLED = 65536
TOLERANCES = (0.5, 2.0, 5.0, 15.0, 50.0)

SceneMaker = Callable[[int, int, int, float], np.ndarray]
"""(slots, rows, cols, mean electrons of a frame) to light (slots, rows, cols)."""


@dataclass(frozen=True)
class Outcome:
    """A plan, and its RMS error in the worst bucket of whole frames, in electrons."""

    plan: Plan
    err: float

    @property
    def kept(self) -> bool:
        """Whether the error is within 1.1 times the tolerance; nothing may be dropped without
        measuring."""
        if self.plan.tolerance_e is None:
            return self.err == 0.0
        return self.err <= 1.1 * self.plan.tolerance_e

    @property
    def counts(self) -> bool:
        """Whether the error is large enough for its prediction to be judged."""
        measured = self.plan.predicted_e is not None
        return measured and self.err >= max(0.05, 0.1 * self.plan.tolerance_e)

    @property
    def foreseen(self) -> bool:
        """Whether the prediction is within 15 % of the error."""
        return abs(self.plan.predicted_e - self.err) <= 0.15 * self.err

    @property
    def needless(self) -> list[str]:
        """Effects that were kept at a cost though the tolerance could have spared them, for all
        that a sample tells."""
        return [
            each.name
            for each in self.plan.decisions
            if each.decision == "kept"
            and not each.forced
            and each.cost_ms_model > 0
            and each.predicted_if_dropped_e is not None
            and each.predicted_if_dropped_e <= 0.9 * self.plan.tolerance_e
            and "could be" not in each.reason
        ]


def loop_pixels(
    container: Container,
    light: Light,
    sensor: Sensor,
    effects: Selection,
    count: int,
    device_seed: int = 5,
) -> tuple[np.ndarray, np.ndarray]:
    """Exposures and saturation marks (count, buckets, pixels) of whole frames by the loop over
    words."""
    places = np.arange(light.shape[0] * light.shape[1])
    prepared = prepare_pixels(container, sensor, light, effects, places, device_seed)
    # The random numbers of the seed 3 are not those of planning.
    frames = [expose_pixels(prepared, 3, frame) for frame in range(count)]
    return np.stack([e.exposure_e for e in frames]), np.stack([e.saturated_by for e in frames])


def rms_of(errors: np.ndarray) -> float:
    """The RMS of errors (frames, buckets, pixels) in the worst bucket."""
    return float(np.sqrt((errors**2).mean(axis=(0, 2))).max())


def pool(light: Light) -> int:
    """How many frames make 65536 samples."""
    return math.ceil(POOLED / (light.shape[0] * light.shape[1]))


def error_of(
    made: Plan,
    full: np.ndarray,
    container: Container,
    light: Light,
    sensor: Sensor,
    device_seed: int = 5,
) -> float:
    """The RMS error of a plan's effects beside the frames `full` with every effect."""
    planned, _ = loop_pixels(container, light, sensor, made.kept, len(full), device_seed)
    return rms_of(planned - full)


def full_frames(
    container: Container, light: Light, sensor: Sensor, count: int, device_seed: int = 5
) -> np.ndarray:
    """Exposures (count, buckets, pixels) of whole frames with every effect."""
    return loop_pixels(container, light, sensor, everything(), count, device_seed)[0]


def difference_in_distribution(own: np.ndarray, true: np.ndarray, sigmas: float = 0.0) -> float:
    """The error of frames (frames, ..) beside frames of other noise, in electrons: its square is
    the mean squared difference of expected values and the difference of the mean variances, less
    `sigmas` standard errors of both."""
    own_e2, true_e2 = own.var(axis=0, ddof=1), true.var(axis=0, ddof=1)
    # The means of a few frames differ by their noise, too.
    mean_e2 = (own.mean(axis=0) - true.mean(axis=0)) ** 2 - own_e2 / len(own) - true_e2 / len(true)
    error_e2 = max(0.0, mean_e2.mean()) + abs((own_e2 - true_e2).mean())
    chance_e2 = math.hypot(mean_e2.std(), (own_e2 - true_e2).std()) / math.sqrt(mean_e2.size)
    return math.sqrt(max(0.0, error_e2 - sigmas * chance_e2))


def outcome(
    container: Container,
    light: Light,
    sensor: Sensor,
    tolerance: float | str,
    full: np.ndarray,
    device_seed: int = 5,
    effects: str = "auto",
    figures: bool = True,
) -> Outcome:
    """Plan, with the figures of the table or as quickly as for frames of a run, and measure the
    plan's error beside the frames `full`."""
    scene = PlannedScene(container, sensor, light, device_seed, threads=1)
    made = make_plan(scene, PlanRequest(selected(effects), tolerance, figures=figures))
    return Outcome(made, error_of(made, full, container, light, sensor, device_seed))


def _smooth(rng: np.random.Generator, rows: int, cols: int, waves: int = 6) -> np.ndarray:
    """A smooth picture around 1, as scenes have them."""
    y, x = np.mgrid[:rows, :cols] / 64.0
    found = np.zeros((rows, cols))
    for _ in range(waves):
        fy, fx, phase = rng.uniform((0.2, 0.2, 0.0), (2.5, 2.5, 6.28))
        found += rng.uniform(0.3, 1.0) * np.cos(6.28 * (fy * y + fx * x) + phase)
    return np.exp(0.8 * found / math.sqrt(waves))


def _even(slots: int, picture: np.ndarray, mean_e: float) -> np.ndarray:
    """A still whose mean over frame and pixels is `mean_e`."""
    one = picture * (mean_e / slots / picture.mean())
    return np.broadcast_to(one.astype(np.float32), (slots, *picture.shape)).copy()


def still(slots: int, rows: int, cols: int, mean_e: float) -> np.ndarray:
    return _even(slots, _smooth(np.random.default_rng(1), rows, cols), mean_e)


def flat(slots: int, rows: int, cols: int, mean_e: float) -> np.ndarray:
    return _even(slots, np.ones((rows, cols)), mean_e)


def hdr(slots: int, rows: int, cols: int, mean_e: float) -> np.ndarray:
    """Five decades: a dark room, a window, some lamps."""
    rng = np.random.default_rng(2)
    picture = 0.01 * _smooth(rng, rows, cols)
    picture[rows // 4 : rows // 2, cols // 3 : cols // 2] = 3.0
    for _ in range(max(1, rows * cols // 700)):
        picture[rng.integers(rows), rng.integers(cols)] = rng.uniform(10, 300)
    return _even(slots, picture, mean_e)


def fast(slots: int, rows: int, cols: int, mean_e: float) -> np.ndarray:
    """An edge and a texture that cross a third of the array in a frame."""
    rng = np.random.default_rng(3)
    wide = _smooth(rng, rows, 2 * cols) * np.where(np.arange(2 * cols) // 9 % 2, 1.0, 0.15)
    steps = [n * cols // (3 * slots) for n in range(slots)]
    found = np.stack([wide[:, step : step + cols] for step in steps])
    return (found * (mean_e / found.sum(axis=0).mean())).astype(np.float32)


def flicker(slots: int, rows: int, cols: int, mean_e: float) -> np.ndarray:
    """Lamps that flash in single slots."""
    rng = np.random.default_rng(4)
    found = 0.1 * np.ones((slots, rows, cols)) * _smooth(rng, rows, cols)
    lit = rng.random((rows, cols)) < 0.2
    when = rng.integers(0, slots, (rows, cols))
    found[when[lit], *np.nonzero(lit)] += 10.0
    return (found * (mean_e / found.sum(axis=0).mean())).astype(np.float32)


SCENES: Mapping[str, tuple[SceneMaker, float]] = {
    "dark": (flat, 0.0),
    "dim": (still, 30.0),
    "mid": (still, 3000.0),
    "bright": (still, 15000.0),
    "saturated": (still, 60000.0),
    "flat": (flat, 8000.0),
    "fast": (fast, 5000.0),
    "fast, bright": (fast, 25000.0),
    "hdr": (hdr, 4000.0),
    "hdr, bright": (hdr, 40000.0),
    "flicker": (flicker, 2000.0),
}


def scene(name: str, slots: int, rows: int, cols: int) -> Light:
    """The light of one of `SCENES`."""
    made, mean_e = SCENES[name]
    return Light.of_clip(made(slots, rows, cols, mean_e))
