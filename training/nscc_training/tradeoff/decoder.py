"""Measurement of PSNR and SSIM against decoding time, for all decoders on the same captures."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from copy import copy
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from time import perf_counter
from typing import Any

import numpy as np
import torch

from nscc.diagnostics.rejection import rejected
from nscc.experiment_store import Rows
from nscc.tradeoff.points import Point
from nscc.tradeoff.stopwatch import Stopwatch
from nscc_training.decoders.blocks import BlockNet
from nscc_training.decoders.declared import DECODERS
from nscc_training.encoders import ShutterSpec, make_encoder
from nscc_training.evaluation.methods import CLIPS, STILLS, CapturedScene, Light, captured
from nscc_training.evaluation.runs import check_unseen
from nscc_training.measures import number
from nscc_training.metrics import finite_mean
from nscc_training.protocol_scenes.file_scenes import (
    KINDS,
    Kind,
    files_of,
    kinds_in,
    protocol_of,
    some_scenes,
)
from nscc_training.protocols import Protocol
from nscc_training.run_folder import RunFolder
from nscc_training.sensor_model import SensorModel

UNITS = ("psnr_db", "ssim")
_WARM = 32
"""Side in pixels of the part of a capture that each method first decodes untimed."""
_FRAMES = 16
_STOPS = 256
_OVERLAPS = {1: (False, False), 2: (True, False), 4: (True, True)}
"""Directions in which FC-net's blocks overlap, by the number of blocks that contain a pixel."""


@dataclass(frozen=True)
class DecoderStudySettings:
    """The settings of the measurement of decoders; no repeat starts after `budget_s` seconds."""

    data: Path | None
    count: int
    size: int
    repeats: int
    budget_s: float
    seed: int


@dataclass(frozen=True, eq=False)
class Way:
    """A decoder with its settings; `loads` distinguishes settings that load and compile different
    things."""

    method: str
    setting: str
    run: Callable[[CapturedScene], Light]
    device: str = ""
    loads: str = ""


@dataclass(frozen=True, eq=False)
class Case:
    """Captures with one code, and the decoders for them."""

    name: str
    captures: tuple[CapturedScene, ...]
    ways: tuple[Way, ...]


Turn = tuple[Case, Way]
Progress = Callable[[Sequence[Turn]], Iterable[Turn]]


def cases(runs: Sequence[RunFolder], settings: DecoderStudySettings) -> list[Case]:
    """Return the codes of the runs, with runs of the same code together.

    Without runs, the codes are random bits for clips and the 2 x 2 pattern for stills. Raises
    Rejected: NS0811 for a folder without scenes, NS0820 if a run has seen a scene, NS0821 for a run
    with two buckets, which other methods do not support."""
    for run in runs:
        if run.setup.buckets > 1:
            raise rejected(
                "NS0821",
                f"'{run.path}' was trained with two buckets, but the other methods use one",
                helps=("`nscc evaluate of RUN --protocol two-bucket-v1` scores it",),
            )
    if not runs:
        kinds = KINDS if settings.data is None else kinds_in(settings.data)
        return [_fixed(kind, settings) for kind in kinds]
    by_code: dict[Any, list[RunFolder]] = {}
    for run in runs:
        tile = run.setup.encoder.hard().cpu()
        key = (run.setup.still, run.setup.model, tuple(tile.shape), tile.numpy().tobytes())
        by_code.setdefault(key, []).append(run)
    # The shortest names that distinguish the folders.
    paths = [together[0].path for together in by_code.values()]
    names = [path.resolve().name for path in paths]
    if len(set(names)) < len(names):
        names = [path.as_posix() for path in paths]
    return [
        _learned(together, name, settings)
        for together, name in zip(by_code.values(), names, strict=True)
    ]


def measure(
    todo: Sequence[Case],
    settings: DecoderStudySettings,
    progress: Progress = iter,
    rows: Rows | None = None,
) -> tuple[list[Point], int]:
    """Return two points for each decoder of each case, and the number of repeats.

    The time of a point is for one scene, averaged over the scenes. Each repeat measures all
    decoders in turn. Measurements in `rows` are reused."""
    rows = rows or Rows()
    watch = Stopwatch()
    turns = [(case, way) for case in todo for way in case.ways]
    timed: list[list[dict[str, Any]]] = [[] for _ in turns]
    begin = perf_counter()
    for turn in range(settings.repeats):
        before = perf_counter()
        for index, (case, way) in enumerate(progress(turns)):
            name = f"{case.name}, {way.method}, {way.setting}, {turn}"
            timed[index].append(
                rows.once(name, partial(_timed, watch, case, way, scores=turn == 0))
            )
        now = perf_counter()
        if now - begin + (now - before) > settings.budget_s:
            break
    points = [
        Point(
            case.name, way.method, way.setting, score, unit, tuple(timing["ms"] for timing in runs),
            more_is_better=True, device=way.device,
        )
        for (case, way), runs in zip(turns, timed, strict=True)
        for unit, score in zip(UNITS, runs[0]["scores"], strict=True)
    ]  # fmt: skip
    return points, len(timed[0]) if turns else 0


def _timed(watch: Stopwatch, case: Case, way: Way, *, scores: bool) -> dict[str, Any]:
    """Return the time that a decoder needs for one scene and, with `scores`, its scores."""

    def decode_all() -> list[Light]:
        return [way.run(frames) for frames in case.captures]

    corner = partial(way.run, case.captures[0].corner(_WARM))
    lights, taken_ms = watch.ms((case.name, way.method, way.loads), way.setting, decode_all, corner)
    return {"ms": taken_ms / len(lights), "scores": scored(case, lights) if scores else None}


def scored(case: Case, lights: Sequence[Light]) -> tuple[float, float]:
    """Return mean PSNR and SSIM of scenes; infinite PSNR is left out unless all scenes have it."""
    pairs = zip(case.captures, lights, strict=True)
    scene_scores = [frames.scene.scores(light) for frames, light in pairs]
    psnr_db = finite_mean(number(scores["psnr_db"]) for scores in scene_scores)
    return psnr_db, float(np.mean([scores["ssim"] for scores in scene_scores]))


def ways_of(kind: Kind) -> list[Way]:
    """Return the decoders that need no training."""
    return [
        Way(name, setting, partial(method.decode, **options))
        for name, method in (CLIPS if kind == "clips" else STILLS).items()
        for setting, options in (method.settings or {}).items()
    ]


def networks(folder: RunFolder, name: str) -> list[Way]:
    """Return a run's decoder in both number formats, FC-net also with fewer blocks."""
    setup = folder.setup
    method = f"{setup.settings.decoder.name} {setup.settings.decoder.sized}{name}"
    device = torch.cuda.get_device_name(setup.device) if setup.device.type == "cuda" else ""
    ways = []
    for dtype in ("f32", "bf16"):
        if not isinstance(setup.decoder, BlockNet):
            run = _network(folder, setup.decoder, dtype)
            ways.append(Way(method, dtype, run, device, loads=dtype))
            continue
        for blocks, overlapping in _OVERLAPS.items():
            net = copy(setup.decoder)
            net.overlapping = overlapping
            setting = f"x{blocks} {dtype}"
            ways.append(Way(method, setting, _network(folder, net, dtype), device, loads=setting))
    return ways


def _network(
    folder: RunFolder, net: torch.nn.Module, dtype: str
) -> Callable[[CapturedScene], Light]:
    setup = folder.setup

    @torch.no_grad()
    def run(frames: CapturedScene) -> Light:
        frame = setup.model.relative(torch.from_numpy(frames.codes))
        shutters = torch.from_numpy(np.ascontiguousarray(frames.masks[0]))
        with torch.autocast(setup.device.type, torch.bfloat16, enabled=dtype == "bf16"):
            light = net(frame.to(setup.device), shutters.to(setup.device))
        return np.asarray(light[0].float().cpu().numpy().astype(np.float64) * setup.unit_e)

    return run


def _fixed(kind: Kind, settings: DecoderStudySettings) -> Case:
    protocol = protocol_of(kind, settings.size, _FRAMES)
    if kind == "clips":
        name, spec, start = "clips, random bits", ShutterSpec("e", _FRAMES, (8, 8)), "random"
    else:
        name, spec, start = "stills, 2 x 2 stops", ShutterSpec("b", _STOPS, (2, 2)), "quad"
    tile = make_encoder(spec, start, settings.seed).hard()
    frames = _captures(protocol, tile, SensorModel.of_protocol(protocol), settings)
    return Case(name, frames, tuple(ways_of(kind)))


def _learned(runs: Sequence[RunFolder], name: str, settings: DecoderStudySettings) -> Case:
    setup = runs[0].setup
    kind: Kind = "stills" if setup.still else "clips"
    protocol = protocol_of(kind, settings.size, setup.slots)
    if settings.data is not None:
        for run in runs:
            check_unseen(run, files_of(protocol, settings.data))
    frames = _captures(protocol, setup.encoder.hard().cpu(), setup.model, settings)
    kinds = [(f.setup.settings.decoder.name, f.setup.settings.decoder.sized) for f in runs]
    apart = [
        f" ({folder.path.resolve().name})" if kinds.count(kind) > 1 else ""
        for folder, kind in zip(runs, kinds, strict=True)
    ]
    ways = [way for run, tail in zip(runs, apart, strict=True) for way in networks(run, tail)]
    return Case(f"{kind}, code of {name}", frames, (*ways_of(kind), *ways))


def _captures(
    protocol: Protocol, tile: torch.Tensor, model: SensorModel, settings: DecoderStudySettings
) -> tuple[CapturedScene, ...]:
    """Capture the scenes with a tile of shutters (N, r, c) and the sensor's noise."""
    scenes = some_scenes(protocol, settings.data, settings.count, settings.seed)
    return tuple(
        captured(scene, tile, model, 1000 * settings.seed + k) for k, scene in enumerate(scenes)
    )


def not_measured(folders: Sequence[RunFolder]) -> list[str]:
    """Return a line that lists the networks for which no run was named."""
    have = {folder.setup.settings.decoder.name for folder in folders}
    names = [name for name in DECODERS if name not in have and not DECODERS[name].fixed_channels]
    if not names:
        return []
    return [f"not measured: {', '.join(names)}; an untrained network decodes nothing, so name a "
            "run of nscc train with --run"]  # fmt: skip
