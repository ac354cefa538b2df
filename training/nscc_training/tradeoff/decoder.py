"""PSNR and SSIM against milliseconds: every decoder on the same captures."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from time import perf_counter
from typing import Any

import numpy as np
import torch

from nscc.diagnostics.rejection import rejected
from nscc.tradeoff.points import Point
from nscc.tradeoff.rows import Rows
from nscc.tradeoff.stopwatch import Stopwatch
from nscc_training.decoders.declared import DECODERS
from nscc_training.encoders import ShutterSpec, make_encoder
from nscc_training.evaluation.runs import check_unseen
from nscc_training.measures import number
from nscc_training.metrics import finite_mean
from nscc_training.protocols import Protocol
from nscc_training.run_folder import RunFolder
from nscc_training.sensor_model import SensorModel, frame_of, laid
from nscc_training.tradeoff.scenes import KINDS, Kind, files_of, kinds_in, protocol_of, scenes
from nscc_training.tradeoff.ways import Light, Taken, Way, baselines, names_of, networks

UNITS = ("psnr_db", "ssim")
_WARM = 32
"""Pixels a side of the part of a capture that every method is run on once, untimed."""
_FRAMES = 16
_STOPS = 256


@dataclass(frozen=True)
class Settings:
    """`data`: a folder of scenes, made ones without; `size`: rows and cols of a scene;
    `budget_s`: repeats end when it is spent, but everything is measured once."""

    data: Path | None
    count: int
    size: int
    repeats: int
    budget_s: float
    seed: int


@dataclass(frozen=True, eq=False)
class Case:
    """Captures with one code, and the decoders that they are for."""

    name: str
    taken: tuple[Taken, ...]
    ways: tuple[Way, ...]


Turn = tuple[Case, Way]
Progress = Callable[[Sequence[Turn]], Iterable[Turn]]


def cases(runs: Sequence[RunFolder], settings: Settings) -> list[Case]:
    """The codes of the runs, those with the same code together; without runs random bits for
    clips and the 2 x 2 pattern for stills.

    Raises Rejected: NS0811 for a folder without scenes, NS0820 where a run has seen one, NS0821 for
    a run with two buckets: the methods beside it take one.
    """
    for run in runs:
        if run.parts.buckets > 1:
            raise rejected(
                "NS0821",
                f"'{run.path}' was trained with two buckets, and methods beside it take one",
                helps=("`nscc evaluate of RUN --protocol two-bucket-v1` scores it",),
            )
    if not runs:
        kinds = KINDS if settings.data is None else kinds_in(settings.data)
        return [_fixed(kind, settings) for kind in kinds]
    found: dict[Any, list[RunFolder]] = {}
    for run in runs:
        tile = run.parts.encoder.hard().cpu()
        key = (run.parts.still, run.parts.model, tuple(tile.shape), tile.numpy().tobytes())
        found.setdefault(key, []).append(run)
    # The shortest names that tell folders apart.
    paths = [together[0].path for together in found.values()]
    names = [path.resolve().name for path in paths]
    if len(set(names)) < len(names):
        names = [path.as_posix() for path in paths]
    return [
        _learned(together, name, settings)
        for together, name in zip(found.values(), names, strict=True)
    ]


def measure(
    todo: Sequence[Case], settings: Settings, progress: Progress = iter, rows: Rows | None = None
) -> tuple[list[Point], int]:
    """Two points for each decoder of each case, and how often everything was timed.

    A time is that of one scene, the mean over the scenes; the repeats go round all decoders. What
    `rows` knows is not decoded again.
    """
    rows = rows or Rows()
    watch = Stopwatch()
    turns = [(case, way) for case in todo for way in case.ways]
    found: list[list[dict[str, Any]]] = [[] for _ in turns]
    begin = perf_counter()
    for turn in range(settings.repeats):
        before = perf_counter()
        for index, (case, way) in enumerate(progress(turns)):
            name = f"{case.name}, {way.method}, {way.setting}, {turn}"
            found[index].append(
                rows.once(name, partial(_timed, watch, case, way, scores=turn == 0))
            )
        now = perf_counter()
        if now - begin + (now - before) > settings.budget_s:
            break
    points = []
    for (case, way), timed in zip(turns, found, strict=True):
        times_ms = tuple(each["ms"] for each in timed)
        for unit, score in zip(UNITS, timed[0]["scores"], strict=True):
            points.append(Point(
                case.name, way.method, way.setting, score, unit, times_ms,
                more_is_better=True, device=way.device,
            ))  # fmt: skip
    return points, len(found[0]) if turns else 0


def _timed(watch: Stopwatch, case: Case, way: Way, *, scores: bool) -> dict[str, Any]:
    """How long a decoder takes for one scene, and where they are asked for its scores."""

    def every() -> list[Light]:
        return [way.run(taken) for taken in case.taken]

    corner = partial(way.run, case.taken[0].corner(_WARM))
    lights, taken_ms = watch.ms((case.name, way.method, way.loads), way.setting, every, corner)
    return {"ms": taken_ms / len(lights), "scores": scored(case, lights) if scores else None}


def scored(case: Case, lights: Sequence[Light]) -> tuple[float, float]:
    """PSNR in dB and SSIM, their means over the scenes, as the protocol counts them.

    Scenes without any error count for SSIM alone, unless there are no others.
    """
    found = [taken.scene.scores(made) for taken, made in zip(case.taken, lights, strict=True)]
    psnr_db = finite_mean(number(scores["psnr_db"]) for scores in found)
    return psnr_db, float(np.mean([scores["ssim"] for scores in found]))


def _fixed(kind: Kind, settings: Settings) -> Case:
    protocol = protocol_of(kind, settings.size, _FRAMES)
    if kind == "clips":
        name = "clips, random bits"
        encoder = make_encoder(ShutterSpec("e", _FRAMES, (8, 8)), "random", settings.seed)
    else:
        name = "stills, 2 x 2 stops"
        encoder = make_encoder(ShutterSpec("b", _STOPS, (2, 2)), "quad", settings.seed)
    taken = _captured(kind, protocol, encoder.hard(), SensorModel.of_protocol(protocol), settings)
    return Case(name, taken, tuple(baselines(kind)))


def _learned(runs: Sequence[RunFolder], name: str, settings: Settings) -> Case:
    parts = runs[0].parts
    kind: Kind = "stills" if parts.still else "clips"
    protocol = protocol_of(kind, settings.size, parts.slots)
    if settings.data is not None:
        for run in runs:
            check_unseen(run, files_of(kind, settings.data))
    taken = _captured(kind, protocol, parts.encoder.hard().cpu(), parts.model, settings)
    apart = names_of(runs)
    ways = [way for run, tail in zip(runs, apart, strict=True) for way in networks(run, tail)]
    return Case(f"{kind}, code of {name}", taken, (*baselines(kind), *ways))


def _captured(
    kind: Kind, protocol: Protocol, tile: torch.Tensor, model: SensorModel, settings: Settings
) -> tuple[Taken, ...]:
    """The scenes behind a tile of shutters (N, r, c), with the noise of the sensor."""
    found = []
    chosen = scenes(kind, protocol, settings.data, settings.count, settings.seed)
    for index, scene in enumerate(chosen):
        frame = frame_of(scene.light_e, tile, model, 1000 * settings.seed + index).numpy()
        mask = laid(tile, *frame.shape).numpy().astype(np.float32)
        found.append(Taken(scene, frame, frame >= model.full_code, mask, model))
    return tuple(found)


def not_measured(folders: Sequence[RunFolder]) -> list[str]:
    """Networks that no run was given of: without training their pictures mean nothing."""
    have = {folder.parts.settings.decoder.name for folder in folders}
    names = [name for name in DECODERS if name not in have and not DECODERS[name].given]
    if not names:
        return []
    return [f"not measured: {', '.join(names)}; an untrained network decodes nothing, so name a "
            "run of nscc train with --run"]  # fmt: skip
