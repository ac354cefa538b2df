"""The promise of a plan, measured without the project's own audit.

Scenes of every kind, a plan's exposures beside those of the reference, and what of the promise does
not hold.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from nscc.words.container import Container
from nscc_runtime import capture, plan
from nscc_runtime.effects import selected
from nscc_runtime.light import Light
from nscc_runtime.planning.plan import Plan
from nscc_runtime.reference import frames
from nscc_runtime.sensor import Sensor

POOLED = 65536
TOLERANCES = (0.5, 2.0, 5.0, 15.0, 50.0)

SceneMaker = Callable[[int, int, int, float], np.ndarray]
"""(slots, rows, cols, mean electrons of a frame) to light (slots, rows, cols)."""


@dataclass(frozen=True)
class Outcome:
    """A run beside the reference: errors (pools, buckets) in electrons, and the plan.

    `p999_e`, `max_e`: what one pixel in a thousand passes, and the largest error; `noise_ratio`:
    the standard deviation over frames by that of the reference, None where that has none, with its
    standard error.
    """

    plan: Plan
    errors: np.ndarray
    p999_e: float
    max_e: float
    noise_ratio: float | None
    noise_ratio_error: float

    @property
    def err(self) -> float:
        """Of the worst frame (or pool of small frames) and bucket."""
        return float(self.errors.max())

    @property
    def kept(self) -> bool:
        """Whether the error is within 1.1 times the tolerance."""
        return self.err <= 1.1 * self.plan.tolerance_e

    @property
    def broken(self) -> list[str]:
        """Which of a plan's promises do not hold."""
        plan, found = self.plan, []
        if not self.kept:
            found.append(f"rms {self.err:.4g} e of {plan.tolerance_e:.4g} e")
        if plan.tolerance_max_e is not None and self.max_e > 1.1 * plan.tolerance_max_e:
            found.append(f"worst {self.max_e:.4g} e of {plan.tolerance_max_e:.4g} e")
        return found

    @property
    def missed(self) -> list[str]:
        """Which of its estimates were far off."""
        plan, found = self.plan, []
        for what, measured_e, said_e in (
            ("one in a thousand", self.p999_e, plan.predicted_p999_e),
            ("worst", self.max_e, plan.predicted_max_e),
        ):
            if measured_e > max(2.0 * said_e, plan.tolerance_e):
                found.append(f"{what} {measured_e:.4g} e, said {said_e:.4g}")
        if self.noise_ratio is not None and plan.noise_ratio is not None:
            room = 0.02 + 3 * self.noise_ratio_error
            if abs(self.noise_ratio - plan.noise_ratio) > room:
                found.append(f"noise x {self.noise_ratio:.4f}, said {plan.noise_ratio:.4f}")
        return found

    @property
    def counts(self) -> bool:
        """Whether the error is large enough for its prediction to be judged."""
        return self.err >= max(0.05, 0.1 * self.plan.tolerance_e)

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


def full_frames(
    container: Container, light: Light, sensor: Sensor, count: int, seed: int, device_seed: int,
    effects: str = "all",
) -> np.ndarray:  # fmt: skip
    """Exposures (count, buckets, rows, cols) of the reference with these effects."""
    made = frames(
        container, light, sensor, selected(effects), seed=seed, device_seed=device_seed,
        count=count,
    )  # fmt: skip
    return np.stack([frame.exposure_e for frame in made])


def pool(light: Light) -> int:
    """How many frames make 65536 samples."""
    return math.ceil(POOLED / (light.shape[0] * light.shape[1]))


def outcome(
    container: Container,
    light: Light,
    sensor: Sensor,
    tolerance: float | str,
    full: np.ndarray,
    seed: int = 3,
    device_seed: int = 5,
    effects: str = "auto",
) -> Outcome:
    """Plan and run as many frames as `full` has, and compare: all in one pool."""
    made = plan(
        container, light, sensor=sensor, effects=effects, tolerance=tolerance,
        device_seed=device_seed,
    )  # fmt: skip
    taken = capture(
        container, light, sensor=sensor, plan=made, seed=seed, device_seed=device_seed,
        repeat=len(full),
    )  # fmt: skip
    assert taken.valid.all()
    size = np.abs(taken.exposure_e - full)
    errors = np.sqrt((size**2).mean(axis=(0, 2, 3)))[None]
    p999_e = float(np.quantile(size, 0.999, axis=(0, 2, 3)).max())
    ratio = _noise_ratio(taken.exposure_e, full)
    return Outcome(taken.plan, errors, p999_e, float(size.max()), *ratio)


def _noise_ratio(mine: np.ndarray, full: np.ndarray) -> tuple[float | None, float]:
    """Of frames (frames, ..), by pixels whose draws are the same; its standard error."""
    if len(full) < 2:
        return None, 0.0
    a, b = (each.var(axis=0, ddof=1).reshape(-1) for each in (mine, full))
    if b.mean() < 1e-9:
        return None, 0.0
    ratio = math.sqrt(a.mean() / b.mean())
    error = (a - ratio**2 * b).std() / math.sqrt(len(a)) / b.mean()
    return ratio, float(error / (2 * max(ratio, 1e-9)))


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
