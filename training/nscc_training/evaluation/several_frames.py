"""Protocols two-bucket-v1 and staggered-v1: clips from several coded frames at once.

Both are solved by the decoder for any code, without training: it takes all frames of a window, with
the slots that each of them has seen.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from time import perf_counter
from typing import Any

import numpy as np
import torch
from numpy.typing import NDArray

from nscc_training.any_code.decode import decoded_clip
from nscc_training.any_code.measured import Measured
from nscc_training.evaluation.results import Scene, Subject, Unusable, scored, with_arrays
from nscc_training.evaluation.video import Window, clips_of, windows
from nscc_training.protocols import Protocol, load_protocol
from nscc_training.sensor_model import SensorModel, frame_of, laid

Masks = NDArray[np.float32]
"""(frames, slots, rows, cols) of a tile: the slots that every frame has seen."""

Groups = list[list[int]]
"""Which frames are decoded together."""


def two_bucket_masks(name: str, protocol: Protocol, seed: int) -> tuple[Masks, Groups]:
    """`flutter`: the same random bits in all pixels; `pixel-wise`: bits of each pixel of a tile;
    `two-bucket`: these, and what they leave out in a second frame."""
    tile = (1, 1) if name == "flutter" else tuple(protocol["tile"])
    drawn = np.random.default_rng(seed).random((int(protocol["frames"]), *tile)) < 0.5
    kept = [drawn, ~drawn] if name == "two-bucket" else [drawn]
    return np.stack(kept).astype(np.float32), [[*range(len(kept))]]


def staggered_masks(name: str, protocol: Protocol, _seed: int) -> tuple[Masks, Groups]:
    """A film of frames, every pixel open for `length` slots of a frame's.

    `aligned`: shutters that open and close within a frame. `staggered`: evenly spread phases, past
    the frame's end into the next one. `staggered-alone`: these, each frame decoded by itself.
    """
    film, length = int(protocol["film"]), int(protocol["length"])
    slots = int(protocol["frames"]) // film
    rows, cols = protocol["tile"]
    phases = np.arange(rows * cols).reshape(rows, cols) * 5 % slots
    n = np.arange(slots).reshape(-1, 1, 1)
    if name == "aligned":
        start = phases % (slots - length + 1)
        opened = (start <= n) & (n < start + length)
    else:
        opened = (n - phases) % slots < length
    masks = np.zeros((film, film * slots, rows, cols), np.float32)
    for frame in range(film):
        masks[frame, frame * slots : (frame + 1) * slots] = opened
    every = [*range(film)]
    return masks, [[frame] for frame in every] if name == "staggered-alone" else [every]


ROWS: dict[str, dict[str, Callable[[str, Protocol, int], tuple[Masks, Groups]]]] = {
    "two-bucket-v1": dict.fromkeys(("flutter", "pixel-wise", "two-bucket"), two_bucket_masks),
    "staggered-v1": dict.fromkeys(("aligned", "staggered", "staggered-alone"), staggered_masks),
}
"""The rows of each protocol, and what makes their masks."""


def evaluate_several(
    protocol_name: str, name: str, folder: Path, seed: int = 0
) -> tuple[dict[str, Any], dict[str, NDArray[Any]]]:
    """The result of a row on a folder of clips, and its clips: arrays by name."""
    protocol = load_protocol(protocol_name)
    files, sensor = clips_of(folder), SensorModel.of_protocol(protocol)
    masks, groups = ROWS[protocol_name][name](name, protocol, seed)

    def decode(scene: Scene, index: int) -> tuple[NDArray[np.float64], float]:
        begin = perf_counter()
        measured = [
            _read(scene.light_e, mask, sensor, (seed * 1000 + index) * len(masks) + frame)
            for frame, mask in enumerate(masks)
        ]
        return _decoded(measured, masks, groups, scene.light_e.shape), perf_counter() - begin

    left_out: list[dict[str, Any]] = []
    every = list(scored(_scenes(files, protocol), decode, left_out))
    spent = 1e3 * sum(each.seconds for each in every) / max(1, len(every))
    settings: dict[str, Any] = {"seed": seed, "frames": len(masks), "tile": [*masks.shape[2:]]}
    published = protocol.values.get("published_db", {}).get(name)
    if published is not None:
        settings["published_db"] = published
    subject = Subject(name, settings, decoder_ms=spent)
    return with_arrays(protocol, subject, files, every, left_out)


def _scenes(files: list[Path], protocol: Protocol) -> Iterator[Window | Unusable]:
    """The windows, as bright as the protocol says: of a film, a frame on average fills a well."""
    film = int(protocol.values.get("film", 1))
    for window in windows(files, protocol):
        if isinstance(window, Unusable) or film == 1:
            yield window
        else:
            brighter = window.light_e * film
            yield replace(window, light_e=brighter, scale_e=window.scale_e * film)


def _read(light_e: NDArray[np.float64], mask: Masks, sensor: SensorModel, seed: int) -> Measured:
    """One frame, with noise of its own, and the slots that it has seen."""
    frame = frame_of(light_e, torch.from_numpy(mask), sensor, seed).numpy()
    opened = laid(torch.from_numpy(mask), *light_e.shape[1:]).numpy()
    return Measured.read(frame, opened, sensor)


def _decoded(
    measured: list[Measured], masks: Masks, groups: Groups, shape: tuple[int, ...]
) -> NDArray[np.float64]:
    """Electrons a slot (slots, rows, cols), of frames decoded together as `groups` say."""
    made = np.zeros(shape)
    for group in groups:
        # A frame by itself tells nothing of slots that it has not seen: they are not its own.
        own = np.flatnonzero(masks[group].any(axis=(0, 2, 3)))
        slots = slice(own[0], own[-1] + 1) if len(group) == 1 and len(groups) > 1 else slice(None)
        parts = [measured[frame] for frame in group]
        joined = Measured(
            torch.cat([part.value for part in parts], dim=1),
            torch.cat([part.mask[:, :, slots] for part in parts], dim=1),
            torch.cat([part.variance for part in parts], dim=1),
            torch.cat([part.saturated for part in parts], dim=1),
        )
        made[slots] = decoded_clip(joined)[0].double().numpy()
    return made
