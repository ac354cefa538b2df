"""Measurement of PSNR against readout time: clips in one to four readouts, and in bursts."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.chips.load import load_target
from nscc.compiler import compile_file
from nscc.diagnostics.diagnostic import Rejected
from nscc.examples import examples
from nscc.experiment_store import Rows
from nscc.options import Options
from nscc.tradeoff.points import Point, Refused
from nscc.words.container import Container
from nscc_runtime.light import Light
from nscc_runtime.request import Request
from nscc_training.any_code.decode import decoded_clip
from nscc_training.any_code.frames import exposed_frame
from nscc_training.demo.expose import CLIPS, camera
from nscc_training.measures import number
from nscc_training.metrics import finite_mean
from nscc_training.tradeoff.sensor import SensorBench, SensorStudySettings, points_of

SLOTS, SLOT_US = 16, 125.0
"""Number and length in microseconds of the slots of the shipped programs."""
Progress = Callable[[Sequence[tuple[str, int]]], Iterable[tuple[str, int]]]


def measure_readouts(
    settings: SensorStudySettings,
    counts: Sequence[int],
    progress: Progress = iter,
    rows: Rows | None = None,
) -> tuple[tuple[Point, ...], tuple[Refused, ...]]:
    """Return the points of coded readouts and of bursts, and the settings that do not fit the
    target.

    `counts` are numbers of readouts, and of ordinary frames in a burst. The time of a point is the
    time of its readouts. Coded readouts are decoded by the decoder for any code; every frame of a
    burst is shown for as long as it was open."""
    target = load_target(settings.target, Path())
    bench = SensorBench.of("clips", target, replace(settings, slots=(SLOTS,), frames=None))
    measures = (
        (f"readouts, {method}, {count}", partial(_measured, method, count, bench))
        for method, count in progress([(m, k) for k in counts for m in ("burst", "coded")])
    )
    return points_of(measures, rows)


def _measured(method: str, count: int, bench: SensorBench) -> Point | Refused:
    settings = bench.settings
    try:
        if method == "burst":
            container = camera(SLOTS, SLOT_US, settings.target, count)
        else:
            options = Options(level=settings.level, target=settings.target)
            coded = compile_file(examples()[CLIPS[count]], options).container
            assert coded is not None  # programs that do not fit are rejected
            container = coded
    except Rejected as error:
        first = error.diagnostics[0]
        return Refused("readouts", method, str(count), first.code, first.message)
    psnr_db = finite_mean(
        number(scene.scores(_clip(method, container, scene.light_e, bench, k))["psnr_db"])
        for k, scene in enumerate(bench.scenes)
    )
    time_ms = count * bench.target.readout_us / 1e3
    setting = f"{count} x {bench.target.readout_us / 1e3:g} ms"
    return Point("readouts", method, setting, psnr_db, "psnr_db", (time_ms,), more_is_better=True)


def _clip(
    method: str, container: Container, light_e: NDArray[Any], bench: SensorBench, scene_number: int
) -> NDArray[np.float64]:
    """Return the reconstruction of a scene's light, in electrons in each of its frames."""
    light = Light.of_clip(light_e.astype(np.float32))
    seed = bench.settings.seed
    request = Request.of(
        effects=bench.settings.effects, seed=1000 * seed + scene_number, device_seed=seed
    )
    coded = exposed_frame(container, light, bench.sensor, request)
    if method == "coded":
        return np.asarray(decoded_clip(coded.clip().tensors())[0].numpy(), np.float64)
    # Each frame of a burst is shown for as long as it was open.
    slots = coded.opened[0].sum(axis=-1)
    shown = coded.value_e / slots[:, None, None]
    return np.repeat(np.asarray(shown, np.float64), slots, axis=0)
