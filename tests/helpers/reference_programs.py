"""Small programs for tests of the reference emulator, and many frames of them."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from pathlib import Path

import numpy as np
from emulator_programs import target_of

from nscc.compiler import compile_source
from nscc.pipeline import Options
from nscc.source import Source
from nscc.words.container import Container
from nscc_runtime.effects import selected
from nscc_runtime.light import Light
from nscc_runtime.reference import frames
from nscc_runtime.sensor import Sensor, default_sensor

ROWS, COLS = 40, 50
SLOTS = 4
SLOT_S = 1e-3
LOWERINGS = ("accumulate", "latch", "edges")

STOPS = """nsl 1
frame 4 slots of 1ms
code stop : 0..4
open when n < stop
pixels stop = x % 5
"""
"""Pixels of column x are open in slots 0 .. x % 5 - 1."""

BUMPS = """nsl 1
frame 4 slots of 1ms
code start : 0..3
code stop : 1..4
require start < stop
open when start <= n < stop
pixels start = x % 2
pixels stop = 3
"""

BUCKETS = """nsl 1
frame 4 slots of 1ms
code split : 0..4
bucket early open when n < split
bucket late open when n >= split
pixels split = x % 5
"""


@cache
def program(
    text: str = STOPS, lowering: str = "auto", rows: int = ROWS, cols: int = COLS
) -> Container:
    """The compiled program on a small SCAMP-5."""
    options = Options(level=1, lowering=lowering, target=target_of((rows, cols)))  # type: ignore[arg-type]
    return compile_source(Source("p.nsl", text), Path(), options).container


def sensor_of(container: Container, **values: float) -> Sensor:
    """The container's default sensor with some values of our own."""
    return default_sensor(container.target).changed(**values)


def flat(electrons: float, rows: int = ROWS, cols: int = COLS) -> Light:
    """So many electrons in every slot of every pixel."""
    return Light.of_clip(np.full((SLOTS, rows, cols), electrons, np.float32))


def exposures(
    container: Container,
    light: Light,
    sensor: Sensor,
    effects: str,
    count: int = 1,
    seed: int = 3,
    device_seed: int = 5,
) -> np.ndarray:
    """(count, buckets, rows, cols) of electrons."""
    made = frames(
        container,
        light,
        sensor,
        selected(effects),
        seed=seed,
        device_seed=device_seed,
        count=count,
    )
    return np.stack([frame.exposure_e for frame in made])


def columns(values: np.ndarray, stop: int) -> np.ndarray:
    """The pixels of STOPS that are open for `stop` slots, in the first bucket: (count, pixels)."""
    return values[:, 0, :, stop::5].reshape(len(values), -1)


Moments = tuple[float, float, float]
"""Mean, temporal variance, variance over the pixels of what does not change."""


def moments(values: np.ndarray) -> Moments:
    """Of (count, pixels): the fixed part's variance is freed of what the noise adds to it."""
    if len(values) == 1:
        return float(values.mean()), 0.0, float(values.var())
    temporal = float(values.var(axis=0, ddof=1).mean())
    return float(values.mean()), temporal, float(values.mean(axis=0).var()) - temporal / len(values)


Oracle = Callable[[int], Moments]
