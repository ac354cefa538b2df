"""Protocol scenes without files: procedural scenes, and light in arrays."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import zip_longest
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc_training import made_scenes
from nscc_training.protocol_scenes.deblur import exposed_moment
from nscc_training.protocol_scenes.hdr import crops_of, exposed_crop
from nscc_training.protocol_scenes.protocol_scene import ProtocolScene, Unusable
from nscc_training.protocol_scenes.video import exposed_window, windows_of
from nscc_training.protocols import Protocol

_MADE = 3
"""Random-stream index of these scenes; training has 1 and validation 2."""


def made_scene(index: int, protocol: Protocol, seed: int) -> ProtocolScene | Unusable:
    """Return a procedural still or clip, exposed as hdr-v1 or video-v1 defines."""
    generator, name = np.random.default_rng([seed, _MADE, index]), Path(f"made-{index}")
    if protocol.still:
        still = made_scenes.still(generator, protocol["crop_size"]).astype(np.float64)
        return exposed_crop(name, (0, 0), still, protocol)
    clip = made_scenes.clip(generator, protocol["frames"], protocol["size"])
    return exposed_window(name, 0, clip.astype(np.float64), False, protocol)


def exposed_arrays(
    lights: Iterable[tuple[str, NDArray[Any]]], srgb: bool, protocol: Protocol, count: int
) -> list[ProtocolScene]:
    """Return at most `count` scenes of arrays of light in turn; `srgb` measures errors of clips in
    display encoding."""
    scenes_by_array = [_of_array(Path(name), light, srgb, protocol) for name, light in lights]
    turns = (scene for turn in zip_longest(*scenes_by_array) for scene in turn)
    scenes: list[ProtocolScene] = []
    for scene in turns:
        if isinstance(scene, ProtocolScene):
            scenes.append(scene)
        if len(scenes) == count:
            break
    return scenes


def _of_array(
    name: Path, light: NDArray[Any], srgb: bool, protocol: Protocol
) -> Iterator[ProtocolScene | Unusable]:
    """Yield the scenes of one array, at most as large as the array."""
    if light.ndim == 2:
        yield from crops_of(name, light.astype(np.float64), protocol)
        return
    side = min(int(protocol["size"]), *light.shape[1:])
    fitted = protocol.changed(size=side)
    if protocol.mid_grey_e is None:
        yield from windows_of(name, light, srgb, fitted)
        return
    slots = int(protocol["frames"])
    for first in range(0, len(light) - slots + 1, slots):
        clip = light[first : first + slots, :side, :side].astype(np.float64)
        yield exposed_moment(name, first, clip, fitted)
