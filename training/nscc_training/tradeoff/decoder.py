"""Measurement of PSNR and SSIM against decoding time, for all decoders on the same captures."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from copy import copy
from functools import partial
from itertools import groupby
from typing import TYPE_CHECKING, Any

import numpy as np
import torch

from nscc.diagnostics.diagnostic import rejected
from nscc_runtime.pictures.precision import Panel, PointReading, precision_diagram
from nscc_training.command_settings import DecoderStudySettings
from nscc_training.decoders.blocks import BlockNet
from nscc_training.decoders.declared import DECODERS
from nscc_training.encoders import ShutterSpec, make_encoder
from nscc_training.evaluation.methods import CLIPS, STILLS, CapturedScene, Light, captured
from nscc_training.evaluation.runs import check_unseen
from nscc_training.experiments.engine import Figures
from nscc_training.experiments.study import Study, StudyPoint, StudyResult
from nscc_training.experiments.study_table import table_text
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

if TYPE_CHECKING:
    from matplotlib.figure import Figure

TITLES = {"psnr_db": "PSNR, dB", "ssim": "SSIM"}
"""Axis titles of the units of a decoder's points."""
_FORMATS = ("f32", "bf16")
_WARM = 32
"""Side in pixels of the part of a capture that each method first decodes untimed."""
_FRAMES = 16
"""Slots of a frame for clips without a run."""
_STOPS = 256
"""Slots of a frame for stills without a run."""
_OVERLAPS = {1: (False, False), 2: (True, False), 4: (True, True)}
"""Directions in which FC-net's blocks overlap, by the number of blocks that contain a pixel."""


Decoder = tuple[str, str, Callable[[CapturedScene], Light], str]
"""A method, its setting, its function, and the device if it is not the processor."""


def decoder_study(runs: Sequence[RunFolder], settings: DecoderStudySettings) -> Study:
    """Return the study of the decoders of `runs` and of those without training; with the scenes of
    `settings`. Raises Rejected for a folder without scenes (NS0811), and for runs that have seen a
    scene (NS0820) or have two buckets (NS0821)."""

    def text(measured: StudyResult) -> str:
        """Return a table for each unit of error, and a line on networks without a run."""
        tables = (
            table_text(
                [p for p in measured.points if p.error_unit == unit], ("decoder", "setting", title)
            )
            for unit, title in TITLES.items()
        )
        return "\n".join(["\n\n".join(tables), *not_measured(runs)])

    points = decoder_points(runs, settings)
    return Study(points, text, {"png": decoder_diagram}, settings.repeats, settings.budget_s)


def decoder_points(runs: Sequence[RunFolder], settings: DecoderStudySettings) -> list[StudyPoint]:
    """Return a point for each decoder of each code. Runs with the same code are compared together.

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
        return [point for kind in kinds for point in _fixed(kind, settings)]
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
        point
        for together, name in zip(by_code.values(), names, strict=True)
        for point in _learned(together, name, settings)
    ]


def _points(
    case: str, captures: Sequence[CapturedScene], decoders: Sequence[Decoder]
) -> list[StudyPoint]:
    """Return a point for each of `decoders` on the captures of several scenes with one code. `case`
    names the code."""
    corner = captures[0].corner(_WARM)

    def decode_all(decode: Callable[[CapturedScene], Light]) -> list[Light]:
        """Return the light of each capture."""
        return [decode(frames) for frames in captures]

    return [
        StudyPoint(
            case,
            method,
            setting,
            partial(decode_all, decode),
            partial(score_figures, captures),
            partial(decode, corner),
            loads=setting if setting.endswith(_FORMATS) else "",
            device=device,
            count=len(captures),
        )
        for method, setting, decode, device in decoders
    ]


def score_figures(captures: Sequence[CapturedScene], lights: Sequence[Light]) -> Figures:
    """Return the mean `psnr_db` and `ssim` of `lights`, the reconstructions of `captures` in this
    order, in electrons. Infinite PSNR is left out unless all scenes have it."""
    pairs = zip(captures, lights, strict=True)
    scene_scores = [frames.scene.scores(light) for frames, light in pairs]
    psnr_db = finite_mean(number(scores["psnr_db"]) for scores in scene_scores)
    return {"psnr_db": psnr_db, "ssim": float(np.mean([scores["ssim"] for scores in scene_scores]))}


def untrained(kind: Kind) -> list[Decoder]:
    """Return the decoders without training for clips or stills, each with several settings."""
    return [
        (name, setting, partial(method.decode, **options), "")
        for name, method in (CLIPS if kind == "clips" else STILLS).items()
        for setting, options in (method.settings or {}).items()
    ]


def networks(folder: RunFolder, name: str) -> list[Decoder]:
    """Return the decoder of a run in both number formats; FC-net also with fewer overlapping
    blocks.

    `name` is added to the method's name to tell runs apart; "" adds nothing."""
    setup = folder.setup
    method = f"{setup.settings.decoder.name} {setup.settings.decoder.sized}{name}"
    device = torch.cuda.get_device_name(setup.device) if setup.device.type == "cuda" else ""
    decoders: list[Decoder] = []
    for dtype in _FORMATS:
        if not isinstance(setup.decoder, BlockNet):
            decoders.append((method, dtype, _network(folder, setup.decoder, dtype), device))
            continue
        for blocks, overlapping in _OVERLAPS.items():
            # A shallow copy, which shares the weights: only its overlap differs.
            net = copy(setup.decoder)
            net.overlapping = overlapping
            setting = f"x{blocks} {dtype}"
            decoders.append((method, setting, _network(folder, net, dtype), device))
    return decoders


def _network(
    folder: RunFolder, net: torch.nn.Module, dtype: str
) -> Callable[[CapturedScene], Light]:
    """Return a function that decodes a capture with the network `net` of a run. `dtype` is "bf16"
    (bfloat16) or "f32" (float32)."""
    setup = folder.setup

    @torch.no_grad()
    def run(frames: CapturedScene) -> Light:
        """Return the light, in electrons, that the network decodes from the first frame of a
        capture."""
        frame = setup.model.relative(torch.from_numpy(frames.codes))
        shutters = torch.from_numpy(np.ascontiguousarray(frames.masks[0]))
        with torch.autocast(setup.device.type, torch.bfloat16, enabled=dtype == "bf16"):
            light = net(frame.to(setup.device), shutters.to(setup.device))
        return np.asarray(light[0].float().cpu().numpy().astype(np.float64) * setup.unit_e)

    return run


def _fixed(kind: Kind, settings: DecoderStudySettings) -> list[StudyPoint]:
    """Return the points of decoders without training for clips or stills with a fixed code: random
    bits for clips, the 2 x 2 pattern of stops for stills."""
    protocol = protocol_of(kind, settings.size, _FRAMES)
    if kind == "clips":
        name, spec, start = "clips, random bits", ShutterSpec("e", _FRAMES, (8, 8)), "random"
    else:
        name, spec, start = "stills, 2 x 2 stops", ShutterSpec("b", _STOPS, (2, 2)), "quad"
    tile = make_encoder(spec, start, settings.seed).hard()
    frames = _captures(protocol, tile, SensorModel.of_protocol(protocol), settings)
    return _points(name, frames, untrained(kind))


def _learned(
    runs: Sequence[RunFolder], name: str, settings: DecoderStudySettings
) -> list[StudyPoint]:
    """Return the points of decoders without training, and of `runs`, all on the code that the runs
    learned. `name` is that of the code.

    Raises Rejected (NS0820) if a run was trained on a file of the data."""
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
    trained = [way for run, tail in zip(runs, apart, strict=True) for way in networks(run, tail)]
    return _points(f"{kind}, code of {name}", frames, [*untrained(kind), *trained])


def _captures(
    protocol: Protocol, tile: torch.Tensor, model: SensorModel, settings: DecoderStudySettings
) -> tuple[CapturedScene, ...]:
    """Capture the scenes of a protocol with a `tile` of shutters (N, r, c) and the noise of
    `model`. The noise of each scene has its own seed."""
    scenes = some_scenes(protocol, settings.data, settings.count, settings.seed)
    return tuple(
        captured(scene, tile, model, 1000 * settings.seed + k) for k, scene in enumerate(scenes)
    )


def not_measured(folders: Sequence[RunFolder]) -> list[str]:
    """Return a line that lists the networks of which no run is among `folders`; no line if all
    networks are."""
    have = {folder.setup.settings.decoder.name for folder in folders}
    names = [name for name in DECODERS if name not in have and not DECODERS[name].fixed_channels]
    if not names:
        return []
    return [
        f"not measured: {', '.join(names)}; an untrained network decodes nothing, so name a "
        "run of nscc train with --run"
    ]


def decoder_diagram(measured: StudyResult, device: str) -> Figure:
    """Draw PSNR and SSIM against the time of a scene: a panel for each code and unit, a line for
    each decoder. Points of one code follow each other in `measured`. `device` is named in the note.
    """
    panels = [
        Panel(case, title, [point for point in case_points if point.error_unit == unit])
        for case, group in groupby(measured.points, key=lambda point: point.case)
        for case_points in [list(group)]
        for unit, title in TITLES.items()
    ]
    return precision_diagram(
        panels,
        "What decoding time buys",
        f"more is better; hollow: dominated; time of one scene, {measured.times}, on {device}",
        PointReading("time of one scene, ms", linear=True),
    )
