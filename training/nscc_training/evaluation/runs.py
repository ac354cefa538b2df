"""A run's decoder under a protocol: `nscc evaluate RUN --data DIR --protocol P`."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from hashlib import sha256
from pathlib import Path
from time import perf_counter
from typing import Any

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor

from nscc.diagnostics.rejection import rejected
from nscc.files import file_sha256
from nscc.program.problems import counted
from nscc.words.container import Container
from nscc_runtime.light import Light
from nscc_runtime.looked_light import OPEN
from nscc_runtime.simulate import Request, simulate
from nscc_training import programs
from nscc_training.decoders.declared import DECODERS
from nscc_training.decoders.make import flops, parameter_count
from nscc_training.emulated import captures_on
from nscc_training.encoders.looks import LOOKS
from nscc_training.evaluation import deblur, hdr, several_frames, video
from nscc_training.evaluation.results import Item, Scene, Scored, Subject, scored, with_arrays
from nscc_training.evaluation.sci8 import read_sci_clip, sci_clips
from nscc_training.looking_model import looked
from nscc_training.measures import frame_scores
from nscc_training.problems import listed
from nscc_training.protocols import Protocol
from nscc_training.reconstruct import decoded_frame
from nscc_training.run_folder import RunFolder
from nscc_training.sensor_model import frame_of, laid, shared_out
from nscc_training.settings import Settings

_SIZE = (256, 256)
"""Rows and columns of what protocols expose."""

Key = tuple[str, str, str]
"""What rows of tables know runs by: decoder, class, and what became of the codes: learned, words,
random, quad or fixed."""


def key_of(settings: Settings) -> Key:
    """The key of a run's settings."""
    shutter = settings.shutter
    codes = "learned"
    if not shutter.learn:
        codes = shutter.init if shutter.init in ("random", "quad") else "fixed"
    elif shutter.words_weight > 0:
        codes = "words"
    decoder = settings.decoder
    # Narrower decoders are none of the tables' rows.
    name = decoder.name if decoder.width == 1 else f"{decoder.name} x {decoder.width:g}"
    return name, shutter.kind, codes


def evaluate_run(
    folder: RunFolder,
    data: Path,
    protocol: Protocol,
    seed: int,
    *,
    skip_seen: bool = False,
    effects: str = "",
) -> tuple[dict[str, Any], dict[str, NDArray[Any]]]:
    """The result of a run, with its hard shutters, and the arrays it made, by name.

    With `skip_seen`, files that the run has seen are left out, and the result says so. With
    `effects`, as `nscc run --effects` takes them, scenes are exposed by the emulated chip, another
    one for each `seed`, instead of the sensor that the protocol fixes. Raises Rejected: NS0756 for
    effects that there are not, NS0841 under sci8, whose measurements no chip made, NS0820 where the
    run has seen a file of `data`, or with `skip_seen` all of them, NS0821 where it was trained for
    something else than the protocol exposes, NS0811 for a folder without data.
    """
    _check_kind(folder, protocol)
    find = {
        "hdr-v1": hdr.panoramas,
        "video-v1": video.clips_of,
        "sci8": sci_clips,
        "deblur-v1": deblur.panoramas,
        "two-bucket-v1": video.clips_of,
    }
    files = find[protocol.name](data)
    seen = seen_of(folder, files)
    if not (skip_seen and len(seen) < len(files)):
        check_unseen(folder, files)
    files = [path for path in files if path not in seen]
    left_out: list[dict[str, Any]] = [
        {"file": path.name, "reason": "the run has seen it"} for path in seen
    ]
    more: dict[str, Any] = {}
    decode = partial(_made, folder, seed)
    if effects:
        if protocol.name == "sci8":
            raise rejected(
                "NS0841", "sci8 brings its own measurements, which no chip has made",
                helps=("leave --effects out, or take video-v1",),
            )  # fmt: skip
        decode = partial(made_by_chip, folder, seed, container_of(folder), effects)
    if protocol.name == "hdr-v1":
        crops, unusable = hdr.parted(files, protocol)
        left_out += [crop.as_json() for crop in unusable]
        every = list(scored(crops, decode, left_out))
        more["also_saturated"] = hdr.also_saturated(
            files, protocol, lambda others: [each.item for each in scored(others, decode, [])]
        )
    elif protocol.name in ("video-v1", "two-bucket-v1"):
        every = list(scored(video.windows(files, protocol), decode, left_out))
    elif protocol.name == "deblur-v1":
        every = list(scored(deblur.moments(files, protocol), decode, left_out))
    else:
        every = list(_sci(folder, files, protocol))
    subject = _subject(folder, every, seed, effects)
    more["flops_size"] = [*_SIZE]
    return with_arrays(protocol, subject, files, every, left_out, **more)


def _subject(folder: RunFolder, every: Sequence[Scored], seed: int, effects: str) -> Subject:
    """What a result says of the run."""
    parts, settings = folder.parts, folder.parts.settings
    return Subject(
        f"{settings.decoder.name} ({settings.decoder.sized})",
        {
            "run": folder.path.name,
            "row": list(key_of(settings)),
            "buckets": parts.buckets,
            "size": settings.decoder.sized,
            "steps": settings.train.steps,
            "train_seed": settings.train.seed,
            "places": folder.result.get("codes", {}).get("places"),
            "moved": folder.result.get("codes", {}).get("moved"),
            "program_sha256": sha256(folder.program.encode()).hexdigest(),
            "config_sha256": folder.result.get("config_sha256"),
            "effects": effects,
            "trained_effects": settings.sensor.effects,
            "seed": seed,
        },
        decoder_ms=1e3 * float(np.median([each.seconds for each in every])) if every else None,
        device=parts.device.type,
        parameters=parameter_count(parts.decoder),
        flops=flops(parts.decoder, parts.slots, *_SIZE, parts.buckets),
    )  # fmt: skip


def _check_kind(folder: RunFolder, protocol: Protocol) -> None:
    parts = folder.parts
    if protocol.name == "staggered-v1":
        raise rejected(
            "NS0821",
            f"'{folder.path}' was trained for one exposure; protocol {protocol.name} has several",
            helps=(f"its rows are {', '.join(several_frames.ROWS[protocol.name])}",),
        )
    kind = parts.encoder.spec.kind
    have = f"{'stills' if parts.still else 'clips'} of {parts.slots} slots, class {kind}"
    if protocol.name == "hdr-v1":
        want = f"stills of {protocol['slots']} slots, class {protocol['class']}"
        known = kind in (protocol["class"], LOOKS)
        good = parts.still and parts.slots == protocol["slots"] and known
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
    if protocol.name == "sci8" and parts.buckets > 1:
        raise rejected(
            "NS0821", f"'{folder.path}' was trained with two buckets, and clips of sci8 have one",
            helps=("protocol two-bucket-v1 has two",),
        )  # fmt: skip
    if protocol.name == "sci8" and name in DECODERS and not DECODERS[name].any_code:
        raise rejected(
            "NS0821",
            f"{name} knows the one code that it was trained with, and sci8 brings its own mask",
            helps=("take a decoder that sees the code, such as unet3d",),
        )


def seen_of(folder: RunFolder, files: list[Path]) -> list[Path]:
    """Those of the files that the run learned from or was chosen by."""
    return [path for path in files if file_sha256(path) in folder.seen]


def check_unseen(folder: RunFolder, files: list[Path]) -> None:
    """Rejected (NS0820) where the run has seen one of these files."""
    shared = [path.name for path in seen_of(folder, files)]
    if shared:
        others = counted(len(files) - len(shared), "other file")
        skip = (f"`nscc evaluate RUN --skip-seen` scores it on the {others} of the folder",)
        raise rejected(
            "NS0820",
            f"'{folder.path}' was trained or validated on {len(shared)} of these "
            f"{counted(len(files), 'file')}",
            notes=(f"it has seen {listed(shared, 8)}",),
            helps=(
                *(skip if len(shared) < len(files) else ()),
                "evaluate on other files: split.json in the run lists what it has seen",
            ),
            data={"files": shared},
        )


@torch.no_grad()
def _decoded(folder: RunFolder, frame: Tensor, shutters: Tensor) -> tuple[NDArray[Any], float]:
    """What the decoder makes of a frame ([2,] rows, cols), 1 where saturated, and its seconds."""
    parts = folder.parts
    begin = perf_counter()
    made = parts.decoder(frame[None].to(parts.device), shutters.to(parts.device))
    found = made[0].float().cpu().numpy().astype(np.float64)
    return found, perf_counter() - begin


def _made(folder: RunFolder, seed: int, scene: Scene, index: int) -> tuple[NDArray[Any], float]:
    """Electrons over the frame, or a slot, of a scene's capture with noise; the seconds."""
    parts = folder.parts
    tile = parts.encoder.hard().cpu()
    if parts.encoder.spec.kind == LOOKS:
        return _looked(folder, scene, 1000 * seed + index)
    opened = shared_out(tile, parts.buckets)
    codes = frame_of(scene.light_e, opened, parts.model, 1000 * seed + index)
    made, seconds = _decoded(folder, parts.model.relative(codes), laid(tile, *codes.shape[-2:]))
    return made * (parts.model.full_e / (1 if parts.still else parts.slots)), seconds


def container_of(folder: RunFolder) -> Container:
    """A run's program, compiled."""
    """A run's program, compiled."""
    chip = folder.parts.chip
    found = programs.compiled(programs.program_of(folder.parts.encoder, chip), chip).container
    assert found is not None
    return found


def made_by_chip(
    folder: RunFolder, seed: int, container: Container, effects: str, scene: Scene, index: int
) -> tuple[NDArray[Any], float]:
    """The same from a frame of the emulated chip, as `nscc run` and `nscc reconstruct` make it."""
    size, array = scene.light_e.shape[-2:], (container.target.rows, container.target.cols)
    margins = [(0, 0)] * (scene.light_e.ndim - 2) + [
        (0, most - side) for most, side in zip(array, size, strict=True)
    ]
    light_e = np.pad(scene.light_e.astype(np.float32), margins, mode="edge")
    slots = folder.parts.slots
    still = folder.parts.still
    light = Light.of_still(light_e, np.full(slots, 1 / slots)) if still else Light.of_clip(light_e)
    chosen = Request.of(
        effects=effects, seed=1000 * seed + index, device_seed=seed,
        torch_device=captures_on(folder.parts.device),
    )  # fmt: skip
    frame = simulate(container, light, folder.parts.sensor, chosen).frame
    begin = perf_counter()
    opened = frame.told.get(OPEN)
    share = None if opened is None else (opened[0] / slots).astype(np.float32)
    one = 0 if folder.parts.buckets == 1 else ...
    made = decoded_frame(folder, frame.frame[one], frame.saturated[one], share)
    seconds = perf_counter() - begin
    return made[..., : size[0], : size[1]].astype(np.float64), seconds


def _looked(folder: RunFolder, scene: Scene, seed: int) -> tuple[NDArray[Any], float]:
    """The same of pixels that look."""
    parts, generator = folder.parts, torch.Generator().manual_seed(seed)
    light = torch.as_tensor(scene.light_e, dtype=torch.float32)[None]
    fields, step_e = parts.encoder.hard().cpu(), parts.target.electrons_per_step
    codes, share = looked(light, fields, parts.slots, step_e, parts.model, generator)
    frame = parts.model.relative(codes[0] - parts.model.adc_offset_lsb)
    made, seconds = _decoded(folder, frame, share)
    return made * parts.model.full_e, seconds


def _sci(folder: RunFolder, files: list[Path], protocol: Protocol) -> Iterator[Scored]:
    """The mask of the file instead of the run's shutters; neither noise nor quantisation.

    As in training a full well is the 99th percentile of what an always open pixel would gather; of
    a measurement, the light of open slots scaled up to all of them.
    """
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
            item = Item(path.name, None, k, frame_scores(truth, frame_made, top))
            yield Scored(item, frame_made.astype(np.float32), truth.astype(np.float32), seconds)
