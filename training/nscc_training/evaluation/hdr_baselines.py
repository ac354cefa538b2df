"""The rows of hdr-v1 that need no training: fixed codes, decoded by merging neighbours."""

from __future__ import annotations

from pathlib import Path
from time import perf_counter
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc_training.any_code.decode import decoded_still
from nscc_training.any_code.measured import Measured
from nscc_training.baselines.hdr import merged
from nscc_training.baselines.sparse_coding import coded_still
from nscc_training.encoders import ShutterSpec, make_encoder
from nscc_training.evaluation.baseline_codes import codes_named
from nscc_training.evaluation.hdr import Crop, Picture, also_saturated, panoramas, parted
from nscc_training.evaluation.results import Item, Scene, Scored, Subject, scored, with_arrays
from nscc_training.measures import number
from nscc_training.metrics import finite_mean
from nscc_training.protocols import Protocol, load_protocol
from nscc_training.sensor_model import SensorModel, frame_of, laid

BASELINES = ("ldr", "best-uniform", "best-uniform-mu", "quad", "random", "sparse-coding", "any")
_TAKERS = ("sparse-coding", "any")
_HINDSIGHT = {"best-uniform": "psnr_db", "best-uniform-mu": "mu_psnr_db"}
"""What the best uniform stop is best in."""


def stops_of(name: str, protocol: Protocol, seed: int, codes: str = "") -> list[NDArray[np.int64]]:
    """The tiles of stops that a baseline chooses from: one, except for the best uniform."""
    if codes:
        spec, start = codes_named(codes, protocol, _TAKERS, name)
        return [make_encoder(spec, start, seed).codes()["stop"]]
    slots = int(protocol["slots"])
    if name == "ldr":
        return [np.full((1, 1), slots)]
    if name in _HINDSIGHT:
        return [np.full((1, 1), 1 << k) for k in range(slots.bit_length()) if 1 << k <= slots]
    start, tile = ("quad", (2, 2)) if name in ("quad", "any") else ("random", (8, 8))
    encoder = make_encoder(ShutterSpec("b", slots, tile), start, seed)
    return [encoder.codes()["stop"]]


def evaluate_hdr_baseline(
    name: str, folder: Path, seed: int = 0, codes: str = ""
) -> tuple[dict[str, Any], dict[str, NDArray[Any]]]:
    """The result of a baseline on a folder of panoramas, and its pictures: arrays by name.

    The best uniform stop is the best in hindsight, of the powers of two, over all crops, in linear
    or in mu-law PSNR: no single exposure of these scenes does better. `codes` as `codes_named`.
    """
    protocol = load_protocol("hdr-v1")
    files = panoramas(folder)
    usable, left_out = parted(files, protocol)
    begin = perf_counter()
    choices, metric = stops_of(name, protocol, seed, codes), _HINDSIGHT.get(name, "psnr_db")

    def worth(tried: tuple[NDArray[np.int64], list[Scored]]) -> float:
        scores = [number(each.item.metrics[metric]) for each in tried[1]]
        return finite_mean(scores) if scores else -np.inf

    tried = ((stops, _decoded(name, usable, stops, protocol, seed)) for stops in choices)
    stops, every = max(tried, key=worth)
    spent = 1e3 * (perf_counter() - begin) / max(1, len(usable) * len(choices))

    def items(others: list[Crop]) -> list[Item]:
        return [each.item for each in _decoded(name, others, stops, protocol, seed)]

    subject = Subject(
        name, {"stops": stops.tolist(), "seed": seed, "shutter": codes}, decoder_ms=spent
    )
    others = also_saturated(files, protocol, items)
    passed = [crop.as_json() for crop in left_out]
    return with_arrays(protocol, subject, files, every, passed, also_saturated=others)


def _decoded(
    method: str, usable: list[Crop], stops: NDArray[np.int64], protocol: Protocol, seed: int
) -> list[Scored]:
    sensor = SensorModel.of_protocol(protocol)
    slots = int(protocol["slots"])
    encoder = make_encoder(ShutterSpec("b", slots, (stops.shape[0], stops.shape[1])), "uniform")
    encoder.load_codes({"stop": stops})
    tile = encoder.hard()

    def decode(crop: Scene, index: int) -> tuple[Picture, float]:
        # A crop's noise is its own, whatever else is evaluated.
        frame = frame_of(crop.light_e, tile, sensor, 1000 * seed + index).numpy()
        if method == "any":
            mask = laid(tile.mean(dim=0, keepdim=True), *frame.shape).numpy()
            light = decoded_still(Measured.read(frame, mask, sensor))
            return light[0].double().numpy(), 0.0
        repeats = [-(-side // part) for side, part in zip(frame.shape, stops.shape, strict=True)]
        share = np.tile(stops / slots, repeats)[: frame.shape[0], : frame.shape[1]]
        # What saturates has to be told by the frame alone.
        saturated = frame >= sensor.full_code
        made = merged(
            frame, share, sensor.electrons_per_lsb, saturated,
            sensor.adc_noise_lsb * sensor.electrons_per_lsb,
        )  # fmt: skip
        if method == "sparse-coding":
            made = coded_still(
                frame, share, made, sensor.electrons_per_lsb, saturated, sensor.full_well_e
            )
        return made, 0.0

    return list(scored(usable, decode, []))
