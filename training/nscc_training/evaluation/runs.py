"""A run's decoder under a protocol: `nscc evaluate RUN --data DIR --protocol P`."""

from __future__ import annotations

from collections.abc import Iterator
from hashlib import sha256
from pathlib import Path
from time import perf_counter
from typing import Any

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor

from nscc.diagnostics.rejection import rejected
from nscc_training.decoders.declared import DECODERS
from nscc_training.decoders.make import flops, parameter_count
from nscc_training.evaluation import hdr, video
from nscc_training.evaluation.keys import key_of
from nscc_training.evaluation.results import Item, Subject, result
from nscc_training.evaluation.sci8 import read_sci_clip, sci_clips
from nscc_training.measures import decibels
from nscc_training.metrics import psnr, ssim
from nscc_training.protocols import Protocol
from nscc_training.run_folder import RunFolder
from nscc_training.scene_files import labels
from nscc_training.sensor_model import exposed, laid, read_out

Scored = tuple[Item, NDArray[Any], NDArray[Any], float]
"""An item, its reconstruction and truth, and the seconds that the decoder took."""


def evaluate_run(
    folder: RunFolder, data: Path, protocol: Protocol, seed: int
) -> tuple[dict[str, Any], dict[str, NDArray[Any]]]:
    """The result of a run, with its hard shutters, and the arrays it made, by name.

    Raises Rejected: NS0820 where the run has seen a file of `data`, NS0821 where it was trained
    for something else than the protocol exposes, NS0811 for a folder without data.
    """
    parts = folder.parts
    _check_kind(folder, protocol)
    if protocol.name == "hdr-v1":
        files = hdr.panoramas(data)
    elif protocol.name == "video-v1":
        files = video.clips_of(data)
    else:
        files = sci_clips(data)
    check_unseen(folder, files)
    left_out: list[dict[str, Any]] = []
    items: list[Item] = []
    arrays: dict[str, NDArray[Any]] = {}
    spent: list[float] = []
    called = labels(files)
    ways = {"hdr-v1": _stills, "video-v1": _clips, "sci8": _sci}
    for item, made, truth, seconds in ways[protocol.name](folder, files, protocol, seed, left_out):
        items.append(item)
        place = [item.frame] if item.crop is None else item.crop
        label = "_".join([called[item.file], *map(str, place)])
        arrays[f"{label}_image" if parts.still else f"{label}_video"] = made.astype(np.float32)
        arrays[f"{label}_truth"] = truth.astype(np.float32)
        spent.append(seconds)
    more: dict[str, Any] = {}
    if parts.still:

        def scored(crops: list[hdr.Crop]) -> list[Item]:
            return [item for item, *_ in _of_crops(folder, crops, protocol, seed)]

        more["also_saturated"] = hdr.also_saturated(files, protocol, scored)
    size, settings = (256, 256), parts.settings
    subject = Subject(
        f"{settings.decoder.name} ({settings.decoder.sized})",
        {
            "run": folder.path.name,
            "row": list(key_of(settings)),
            "size": settings.decoder.sized,
            "steps": settings.train.steps,
            "train_seed": settings.train.seed,
            "program_sha256": sha256(folder.program.encode()).hexdigest(),
            "config_sha256": folder.result.get("config_sha256"),
            "seed": seed,
        },
        stage="hard",
        decoder_ms=1e3 * float(np.median(spent)) if spent else None,
        device=parts.device.type,
        parameters=parameter_count(parts.decoder),
        flops=flops(parts.decoder, parts.slots, *size),
    )  # fmt: skip
    more["flops_size"] = list(size)
    return result(protocol, subject, files, items, left_out, **more), arrays


def _check_kind(folder: RunFolder, protocol: Protocol) -> None:
    parts = folder.parts
    kind = parts.encoder.spec.kind
    have = f"{'stills' if parts.still else 'clips'} of {parts.slots} slots, class {kind}"
    if protocol.name == "hdr-v1":
        want = f"stills of {protocol['slots']} slots, class {protocol['class']}"
        good = parts.still and parts.slots == protocol["slots"] and kind == protocol["class"]
    else:
        want = f"clips of {protocol['frames']} slots"
        good = not parts.still and parts.slots == protocol["frames"]
    if not good:
        raise rejected(
            "NS0821",
            f"'{folder.path}' was trained for {have}; protocol {protocol.name} takes {want}",
            helps=("train with [data] protocol and [shutter] slots of the protocol",),
        )
    name = parts.settings.decoder.name
    if protocol.name == "sci8" and name in DECODERS and not DECODERS[name].any_code:
        raise rejected(
            "NS0821",
            f"{name} knows the one code that it was trained with, and sci8 brings its own mask",
            helps=("take a decoder that sees the code, such as unet3d",),
        )


def check_unseen(folder: RunFolder, files: list[Path]) -> None:
    """Rejected (NS0820) where the run has seen one of these files."""
    shared = [p.name for p in files if sha256(p.read_bytes()).hexdigest() in folder.seen]
    if shared:
        raise rejected(
            "NS0820",
            f"'{folder.path}' was trained or validated on {len(shared)} of these files",
            notes=(f"they are {', '.join(shared[:8])}",),
            helps=("evaluate on other files: split.json in the run lists what it has seen",),
            data={"files": shared},
        )


@torch.no_grad()
def _decoded(folder: RunFolder, frame: Tensor, shutters: Tensor) -> tuple[NDArray[Any], float]:
    """What the decoder makes of codes over the top code (rows, cols), and its seconds."""
    parts = folder.parts
    begin = perf_counter()
    made = parts.decoder(frame[None].to(parts.device), shutters.to(parts.device))
    found = made[0].float().cpu().numpy().astype(np.float64)
    return found, perf_counter() - begin


def _captured(folder: RunFolder, light: NDArray[Any], seed: int) -> tuple[Tensor, Tensor]:
    """The frame's codes over the top code, with noise, and the shutters over it."""
    parts = folder.parts
    given = torch.as_tensor(light, dtype=torch.float32)
    shutters = laid(parts.encoder.hard().cpu(), *given.shape[-2:])
    generator = torch.Generator().manual_seed(seed)
    codes = read_out(exposed(given[None], shutters), parts.model, generator)
    return (codes[0] - parts.model.adc_offset_lsb) / parts.model.top_code, shutters


def _stills(
    folder: RunFolder, files: list[Path], protocol: Protocol, seed: int,
    left_out: list[dict[str, Any]],
) -> Iterator[Scored]:  # fmt: skip
    crops, unusable = hdr.parted(files, protocol)
    left_out += [crop.as_json() for crop in unusable]
    yield from _of_crops(folder, crops, protocol, seed)


def _of_crops(
    folder: RunFolder, crops: list[hdr.Crop], protocol: Protocol, seed: int
) -> Iterator[Scored]:
    for index, crop in enumerate(crops):
        frame, shutters = _captured(folder, crop.light_e, 1000 * seed + index)
        made, seconds = _decoded(folder, frame, shutters)
        made = made * folder.parts.model.full_well_e
        scores = hdr.scores(crop.light_e, made, protocol)
        yield Item(crop.file.name, list(crop.corner), None, scores), made, crop.light_e, seconds


def _clips(
    folder: RunFolder, files: list[Path], protocol: Protocol, seed: int,
    left_out: list[dict[str, Any]],
) -> Iterator[Scored]:  # fmt: skip
    parts = folder.parts
    for index, window in enumerate(video.windows(files, protocol)):
        if isinstance(window, video.Passed):
            left_out.append(vars(window))
            continue
        frame, shutters = _captured(folder, window.light_e, 1000 * seed + index)
        made, seconds = _decoded(folder, frame, shutters)
        made = made * (parts.model.full_well_e / parts.slots)
        item = Item(window.file.name, None, window.first, video.scores(window, made))
        yield item, made, window.light_e, seconds


def _sci(
    folder: RunFolder, files: list[Path], protocol: Protocol, seed: int,
    left_out: list[dict[str, Any]],
) -> Iterator[Scored]:  # fmt: skip
    """The mask of the file instead of the run's shutters; neither noise nor quantisation.

    As in training a full well is the 99th percentile of what an always open pixel would gather; of
    a measurement, the light of open slots scaled up to all of them.
    """
    del seed, left_out
    top = float(protocol["data_range"])
    for path in files:
        clip = read_sci_clip(path, protocol)
        mask = torch.from_numpy(clip.mask)
        share = clip.mask.mean(axis=0)
        gathered = clip.measurement[share > 0] / share[share > 0]
        level = max(float(np.percentile(gathered, 99)), 1e-6)
        frame = torch.from_numpy((clip.measurement / level).astype(np.float32))
        made, seconds = _decoded(folder, frame.clamp(max=1), mask)
        scaled = np.clip(made * (level / len(clip.mask)), 0, 1) * top
        for k, (frame_made, truth) in enumerate(zip(scaled, clip.orig, strict=True)):
            scores = {
                "psnr_db": decibels(psnr(truth, frame_made, top)),
                "ssim": ssim(truth, frame_made, top),
            }
            yield Item(path.name, None, k, scores), frame_made, truth, seconds
