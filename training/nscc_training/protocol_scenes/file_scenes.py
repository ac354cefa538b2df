"""Scenes of a protocol: read from the files in a folder, procedural, or given as arrays."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import islice, zip_longest
from pathlib import Path
from typing import Literal

import numpy as np

from nscc.arrays import Array
from nscc.diagnostics.diagnostic import Rejected, rejected
from nscc.mappings import NamedValues
from nscc_training import made_scenes
from nscc_training.protocol_scenes.clips import exposed_window, windows, windows_of
from nscc_training.protocol_scenes.panoramas import (
    ENDINGS,
    crops,
    crops_of,
    exposed_crop,
    exposed_moment,
    moments,
)
from nscc_training.protocol_scenes.protocol_scene import ProtocolScene, Unusable, in_files
from nscc_training.protocol_scenes.sci import read_sci_clip
from nscc_training.protocols import PROCEDURAL, Protocol, load_protocol
from nscc_training.random_streams import DrawStream
from nscc_training.scene_files import CLIPS, data_files, files_in

Kind = Literal["clips", "stills"]
KINDS: tuple[Kind, ...] = ("clips", "stills")
_PANORAMAS = (ENDINGS, "panoramas are files ending in", "linear panoramas, 512 x 1024")
_CLIPS = (CLIPS, "clips end in", "clips of at least 256 x 256")
_WANTED: dict[str, tuple[Sequence[str], str, str]] = {
    "hdr-v1": _PANORAMAS,
    "deblur-v1": _PANORAMAS,
    "video-v1": _CLIPS,
    "two-bucket-v1": _CLIPS,
    "staggered-v1": _CLIPS,
    "codes-v1": _CLIPS,
    "class-v1": (CLIPS, "clips end in", "folders of clips, named after classes, or `procedural`"),
    "sci8": ((".mat",), "clips end in", "the benchmark's clips, or one of them"),
}
"""The endings of a protocol's files, and two texts for the error: what they end in, and what is
expected."""


def files_of(protocol: Protocol, folder: Path) -> list[Path]:
    """Return the files in a folder that a protocol uses, sorted by name. Raise Rejected (NS0811) if
    there are none.

    For sci8, `folder` may be a file. For class-v1 it holds a folder for each class; the name
    `procedural` stands for no files."""
    if protocol.classifies and str(folder) == PROCEDURAL:
        return []
    if protocol.name == "sci8" and folder.is_file():
        return [folder]
    endings, kind_text, expected = _WANTED[protocol.name]
    contents, by_class = f"data for protocol {protocol.name}", protocol.classifies
    return data_files(folder, endings, contents, kind_text, expected, by_class=by_class)


def scenes_in(
    files: Sequence[Path], protocol: Protocol, fraction: float | None = None
) -> Iterator[ProtocolScene | Unusable]:
    """Return the scenes of files, as the protocol defines them.

    `fraction` replaces the fraction of a crop that saturates (hdr-v1); None keeps the protocol's. A
    file that cannot be read is `Unusable`, with its error."""

    def scenes_of(path: Path, index: int) -> Iterable[ProtocolScene | Unusable]:
        """Return the scenes of the file `path`, as the protocol defines them. `index` is the number
        of the file, which seeds motion."""
        if protocol.name == "hdr-v1":
            return crops(path, protocol, fraction)
        if protocol.name == "deblur-v1":
            return moments(path, index, protocol)
        sci = protocol.name == "sci8"
        return [read_sci_clip(path, protocol)] if sci else windows(path, protocol)

    return in_files(files, scenes_of)


def readable(
    candidates: Iterable[ProtocolScene | Unusable],
) -> Iterator[ProtocolScene]:
    """Yield those of `candidates` that the protocol can expose, and skip the others. Raise Rejected
    (status 2) for a file that cannot be read."""
    for scene in candidates:
        if isinstance(scene, ProtocolScene):
            yield scene
        elif scene.damage is not None:
            raise Rejected(scene.damage, status=2)


def protocol_of(kind: Kind, size: int, frames: int, full_well_e: float | None = None) -> Protocol:
    """Return video-v1 for clips or hdr-v1 for stills, with another scene size in pixels, clip
    length in frames, and full well (None keeps it).

    The digest stays that of the protocol's file, but scores are not comparable with the protocol's.
    """
    changed: NamedValues = {} if full_well_e is None else {"full_well_e": full_well_e}
    if kind == "clips":
        return load_protocol("video-v1").changed(size=size, frames=frames, **changed)
    return load_protocol("hdr-v1").changed(crop_size=size, **changed)


def kinds_in(data: Path) -> list[Kind]:
    """Return which kinds of scenes, "clips" and "stills" in this order, the folder `data` contains,
    by the endings of its files. Raise Rejected (NS0811) if there are none."""
    endings: dict[Kind, Sequence[str]] = {"clips": CLIPS, "stills": ENDINGS}
    all_endings = [ending for kind in KINDS for ending in endings[kind]]
    expected = "such files, or leave --data out to use synthetic scenes"
    data_files(data, all_endings, "scenes", "clips and panoramas end in", expected)
    return [kind for kind in KINDS if files_in(data, endings[kind])]


def some_scenes(
    protocol: Protocol, data: Path | None, count: int, seed: int = 0
) -> list[ProtocolScene]:
    """Return at most `count` scenes (`count` is at least 1), as evenly as possible from the first
    files in `data`. With `data` None the scenes are procedural, and `seed` determines them.

    Raises Rejected (NS0811) if the protocol cannot expose any."""
    if data is None:
        candidates = [made_scene(index, protocol, seed) for index in range(count)]
    else:
        files = files_of(protocol, data)
        # Scenes that each file contributes, rounded up.
        of_file = -(-count // len(files))
        candidates = [
            scene
            for path in files[:count]
            for scene in islice(readable(scenes_in([path], protocol)), of_file)
        ]
    scenes = [scene for scene in candidates if isinstance(scene, ProtocolScene)][:count]
    if not scenes:
        kind = "stills" if protocol.still else "clips"
        size = protocol["crop_size" if protocol.still else "size"]
        raise rejected(
            "NS0811",
            f"none of the {kind} {f'in {str(data)!r} ' if data else ''}can be exposed",
            notes=(
                f"panoramas are 512 x 1024, and {protocol['saturated_fraction']:.0%} of a crop "
                "must saturate"
                if protocol.still
                else f"clips need {size} x {size} pixels and {protocol['frames']} frames",
            ),
            helps=("name other files, or ask for smaller scenes",),
        )
    return scenes


def made_scene(index: int, protocol: Protocol, seed: int) -> ProtocolScene | Unusable:
    """Return procedural scene number `index`, a still or a clip as the protocol needs, exposed as
    the protocol defines. `seed` and `index` determine it."""
    generator = np.random.default_rng([seed, DrawStream.EVALUATION_SCENES, index])
    name = Path(f"made-{index}")
    if protocol.still:
        still = made_scenes.still(generator, protocol["crop_size"]).astype(np.float64)
        return exposed_crop(name, corner=(0, 0), light=still, protocol=protocol)
    clip = made_scenes.clip(generator, protocol["frames"], protocol["size"])
    return exposed_window(
        name, first=0, light=clip.astype(np.float64), srgb=False, protocol=protocol
    )


def exposed_arrays(
    lights: Iterable[tuple[str, Array]], srgb: bool, protocol: Protocol, count: int
) -> list[ProtocolScene]:
    """Return at most `count` scenes of `lights`, pairs of name and light: the first scene of each
    array, then the second of each, and so on.

    Light is (rows, cols) or (T, rows, cols). `srgb` measures errors of clips in display encoding.
    Arrays that cannot be exposed are left out."""
    scenes_by_array = [_of_array(Path(name), light, srgb, protocol) for name, light in lights]
    turns = (scene for turn in zip_longest(*scenes_by_array) for scene in turn)
    return list(islice((scene for scene in turns if isinstance(scene, ProtocolScene)), count))


def _of_array(
    name: Path, light: Array, srgb: bool, protocol: Protocol
) -> Iterator[ProtocolScene | Unusable]:
    """Yield the scenes of one array of light: crops of a still (rows, cols), or windows of a clip
    (T, rows, cols).

    They are squares of the protocol's size, or of the array's smaller side. `name` is put in place
    of the file. `srgb` measures errors of clips in display encoding."""
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
