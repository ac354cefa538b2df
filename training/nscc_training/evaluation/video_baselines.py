"""The rows of video-v1 that need no training."""

from __future__ import annotations

from pathlib import Path
from time import perf_counter
from typing import Any

import numpy as np
import torch
from numpy.typing import NDArray

from nscc_training.baselines.sci import (
    adjoint,
    admm_tv,
    bilinear,
    from_dictionary,
    gap_tv,
    thin_out,
)
from nscc_training.encoders import ShutterSpec, make_encoder
from nscc_training.evaluation.results import Item, Subject, result
from nscc_training.evaluation.video import Passed, Window, clips_of, scores, windows
from nscc_training.protocols import Protocol, load_protocol
from nscc_training.scene_files import labels
from nscc_training.sensor_model import SensorModel, capture, laid

BASELINES = ("gap-tv", "admm-tv", "dictionary", "adjoint", "bilinear", "thin-out")
_TRUTH = ("bilinear", "thin-out")
_TILE = (8, 8)


def evaluate_video_baseline(
    name: str, folder: Path, sensor: SensorModel, seed: int = 0
) -> tuple[dict[str, Any], dict[str, NDArray[Any]]]:
    """The result of a baseline on a folder of clips, and its clips: arrays by name.

    Captures are coded with random bits (class e) on an 8 x 8 tile, one draw a seed, on the
    protocol's sensor; the yardsticks bilinear and thin-out see the truth instead, both a sixteenth
    of it: one slot of every pixel, and all slots of every sixteenth pixel. The dictionary is
    learned first, from made scenes.
    """
    protocol = load_protocol("video-v1")
    files = clips_of(folder)
    slots = int(protocol["frames"])
    spec = ShutterSpec("e", slots, _TILE)
    if name == "bilinear":
        spec = ShutterSpec("c", slots, _TILE, length=1)
    encoder = make_encoder(spec, "random", seed)
    items, arrays, spent = [], {}, 0.0
    left_out: list[dict[str, Any]] = []
    called = labels(files)
    for index, window in enumerate(windows(files, protocol)):
        if isinstance(window, Passed):
            left_out.append(vars(window))
            continue
        begin = perf_counter()
        made = _made(name, window, encoder.hard(), sensor, protocol, 1000 * seed + index)
        spent += perf_counter() - begin
        items.append(Item(window.file.name, None, window.first, scores(window, made)))
        label = f"{called[window.file.name]}_{window.first}"
        arrays[f"{label}_video"] = made.astype(np.float32)
        arrays[f"{label}_truth"] = window.light_e.astype(np.float32)
    settings: dict[str, Any] = {}
    if name != "thin-out":
        settings = {key: codes.tolist() for key, codes in encoder.codes().items()} | {"seed": seed}
    subject = Subject(
        name, settings, stage="hard", sees="truth" if name in _TRUTH else "capture",
        decoder_ms=1e3 * spent / max(1, len(items)),
    )  # fmt: skip
    return result(protocol, subject, files, items, left_out), arrays


def _made(
    name: str, window: Window, tile: torch.Tensor, sensor: SensorModel, protocol: Protocol,
    seed: int,
) -> NDArray[np.float64]:  # fmt: skip
    """Electrons a slot (16, rows, cols), as a baseline sees them."""
    light = torch.as_tensor(window.light_e, dtype=torch.float32)
    shutters = laid(tile, *light.shape[-2:])
    mask = shutters.numpy().astype(np.float32)
    if name == "bilinear":
        return bilinear(window.light_e.astype(np.float32), mask).astype(np.float64)
    if name == "thin-out":
        return thin_out(window.light_e.astype(np.float32)).astype(np.float64)
    generator = torch.Generator().manual_seed(seed)
    frame = capture(light[None], shutters, sensor, generator=generator).frame[0].numpy()
    # In units of the source's white a slot, for which the weight of TV is meant.
    measurement = (frame * sensor.electrons_per_lsb / window.scale_e).astype(np.float32)
    run = {
        "gap-tv": gap_tv, "admm-tv": admm_tv, "dictionary": from_dictionary, "adjoint": adjoint
    }[name]  # fmt: skip
    return run(measurement, mask).astype(np.float64) * window.scale_e
