"""The rows of hdr-v1 that need no training: fixed codes, decoded by merging neighbours."""

from __future__ import annotations

from pathlib import Path
from time import perf_counter
from typing import Any

import numpy as np
import torch
from numpy.typing import NDArray

from nscc_training.baselines.hdr import merged
from nscc_training.baselines.sparse_coding import coded_still
from nscc_training.encoders import ShutterSpec, make_encoder
from nscc_training.evaluation.hdr import (
    Crop,
    also_saturated,
    panoramas,
    parted,
    scores,
)
from nscc_training.evaluation.results import Item, Subject, result
from nscc_training.measures import number
from nscc_training.protocols import Protocol, load_protocol
from nscc_training.scene_files import labels
from nscc_training.sensor_model import SensorModel, capture

BASELINES = ("ldr", "best-uniform", "best-uniform-mu", "quad", "random", "sparse-coding")
_HINDSIGHT = {"best-uniform": "psnr_db", "best-uniform-mu": "mu_psnr_db"}
"""What the best uniform stop is best in."""


def sensor_of(protocol: Protocol) -> SensorModel:
    """The sensor that a protocol fixes."""
    top = (1 << int(protocol["adc_bits"])) - 1
    return SensorModel(
        full_well_e=float(protocol["full_well_e"]),
        electrons_per_lsb=float(protocol["full_well_e"]) / top,
        adc_bits=int(protocol["adc_bits"]),
        adc_noise_lsb=float(protocol["read_noise_lsb"]),
        shot_noise=bool(protocol["shot_noise"]),
    )


def stops_of(name: str, protocol: Protocol, seed: int) -> list[NDArray[np.int64]]:
    """The tiles of stops that a baseline chooses from: one, except for the best uniform."""
    slots = int(protocol["slots"])
    if name == "ldr":
        return [np.full((1, 1), slots)]
    if name in _HINDSIGHT:
        return [np.full((1, 1), 1 << k) for k in range(slots.bit_length()) if 1 << k <= slots]
    tile = (2, 2) if name == "quad" else (8, 8)
    start = "quad" if name == "quad" else "random"
    encoder = make_encoder(ShutterSpec("b", slots, tile), start, seed)
    return [encoder.codes()["stop"]]


def evaluate_hdr_baseline(
    name: str, folder: Path, seed: int = 0
) -> tuple[dict[str, Any], dict[str, NDArray[Any]]]:
    """The result of a baseline on a folder of panoramas, and its pictures: arrays by name.

    The best uniform stop is the best in hindsight, of the powers of two, over all crops, in linear
    or in mu-law PSNR: no single exposure of these scenes does better.
    """
    protocol = load_protocol("hdr-v1")
    files = panoramas(folder)
    usable, left_out = parted(files, protocol)
    best: tuple[float, list[Item], dict[str, NDArray[Any]], NDArray[np.int64]] | None = None
    begin = perf_counter()
    choices = stops_of(name, protocol, seed)
    for choice in choices:
        items, arrays = _decoded(name, usable, choice, protocol, seed)
        values = [number(i.metrics[_HINDSIGHT.get(name, "psnr_db")]) for i in items]
        finite = [value for value in values if np.isfinite(value)]
        mean = float(np.mean(finite)) if finite else -np.inf
        if best is None or mean > best[0]:
            best = (mean, items, arrays, choice)
    assert best is not None
    stops = best[3]

    def scored(others: list[Crop]) -> list[Item]:
        return _decoded(name, others, stops, protocol, seed)[0]

    spent = 1e3 * (perf_counter() - begin) / max(1, len(usable) * len(choices))
    settings = {"stops": stops.tolist(), "seed": seed}
    subject = Subject(name, settings, stage="hard", decoder_ms=spent)
    others = also_saturated(files, protocol, scored)
    passed = [crop.as_json() for crop in left_out]
    return result(protocol, subject, files, best[1], passed, also_saturated=others), best[2]


def _decoded(
    method: str, usable: list[Crop], stops: NDArray[np.int64], protocol: Protocol, seed: int
) -> tuple[list[Item], dict[str, NDArray[Any]]]:
    sensor = sensor_of(protocol)
    slots = int(protocol["slots"])
    encoder = make_encoder(ShutterSpec("b", slots, (stops.shape[0], stops.shape[1])), "uniform")
    encoder.load_codes({"stop": stops})
    shutters = encoder.hard()
    items, arrays = [], {}
    called = labels({crop.file for crop in usable})
    for index, crop in enumerate(usable):
        # A crop's noise is its own, whatever else is evaluated.
        generator = torch.Generator().manual_seed(1000 * seed + index)
        light = torch.as_tensor(crop.light_e, dtype=torch.float32)[None]
        frame = capture(light, shutters, sensor, generator=generator).frame[0].numpy()
        repeats = [-(-side // part) for side, part in zip(frame.shape, stops.shape, strict=True)]
        share = np.tile(stops / slots, repeats)[: frame.shape[0], : frame.shape[1]]
        made = merged(
            frame, share, sensor.electrons_per_lsb, sensor.top_code,
            sensor.adc_noise_lsb * sensor.electrons_per_lsb,
        )  # fmt: skip
        if method == "sparse-coding":
            made = coded_still(
                frame, share, made, sensor.electrons_per_lsb, sensor.top_code, sensor.full_well_e
            )
        name = f"{called[crop.file.name]}_{crop.corner[0]}_{crop.corner[1]}"
        arrays[f"{name}_image"] = made.astype(np.float32)
        arrays[f"{name}_truth"] = crop.light_e.astype(np.float32)
        items.append(
            Item(crop.file.name, list(crop.corner), None, scores(crop.light_e, made, protocol))
        )
    return items, arrays
