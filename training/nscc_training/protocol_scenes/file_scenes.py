"""Scenes of a protocol, read from the files in a folder."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import islice
from pathlib import Path
from typing import Any, Literal

from nscc.diagnostics.rejection import rejected
from nscc_training.protocol_scenes.classes import class_folders
from nscc_training.protocol_scenes.deblur import moments
from nscc_training.protocol_scenes.given_scenes import made_scene
from nscc_training.protocol_scenes.hdr import ENDINGS, crops
from nscc_training.protocol_scenes.protocol_scene import ProtocolScene, Unusable
from nscc_training.protocol_scenes.sci import sci_scenes
from nscc_training.protocol_scenes.video import windows
from nscc_training.protocols import PROCEDURAL, Protocol, load_protocol
from nscc_training.scene_files import CLIPS, files_in, protocol_files

Kind = Literal["clips", "stills"]
KINDS: tuple[Kind, ...] = ("clips", "stills")
_PANORAMAS = (ENDINGS, "panoramas are files ending in", "linear panoramas, 512 x 1024")
_CLIPS = (CLIPS, "clips end in", "clips of at least 256 x 256")
_WANTED: dict[str, tuple[Sequence[str], str, str]] = {
    "hdr-v1": _PANORAMAS, "deblur-v1": _PANORAMAS, "video-v1": _CLIPS, "two-bucket-v1": _CLIPS,
    "staggered-v1": _CLIPS, "codes-v1": _CLIPS,
    "class-v1": (CLIPS, "clips end in", "folders of clips, named after classes, or `procedural`"),
    "sci8": ((".mat",), "clips end in", "the benchmark's clips, or one of them"),
}  # fmt: skip


def files_of(protocol: Protocol, folder: Path) -> list[Path]:
    """Return the files of a folder that a protocol uses, by name; raise Rejected (NS0811) if there
    are none.

    For sci8, `folder` may be a file; for class-v1 it holds a folder for each class, and
    `procedural` has no files."""
    if protocol.classifies:
        if str(folder) == PROCEDURAL:
            return []
        folder = class_folders(folder)
    if protocol.name == "sci8" and folder.is_file():
        return [folder]
    return protocol_files(folder, *_WANTED[protocol.name], protocol.name)


def scenes_in(
    files: Sequence[Path], protocol: Protocol, fraction: float | None = None
) -> Iterator[ProtocolScene | Unusable]:
    """Yield the scenes of files; `fraction` replaces the share of saturated pixels."""
    if protocol.name == "hdr-v1":
        return crops(files, protocol, fraction)
    if protocol.name == "deblur-v1":
        return moments(files, protocol)
    return sci_scenes(files, protocol) if protocol.name == "sci8" else windows(files, protocol)


def protocol_of(kind: Kind, size: int, frames: int, full_well_e: float | None = None) -> Protocol:
    """Return video-v1 or hdr-v1 with another scene size, clip length and full well.

    The digest stays that of the protocol's file, but scores are not comparable with the protocol's.
    """
    changed: dict[str, Any] = {} if full_well_e is None else {"full_well_e": full_well_e}
    if kind == "clips":
        return load_protocol("video-v1").changed(size=size, frames=frames, **changed)
    return load_protocol("hdr-v1").changed(crop_size=size, **changed)


def kinds_in(data: Path) -> list[Kind]:
    """Return which kinds of scenes a folder contains; raise Rejected (NS0811) if there are none."""
    endings: dict[Kind, Sequence[str]] = {"clips": CLIPS, "stills": ENDINGS}
    kinds = [kind for kind in KINDS if files_in(data, endings[kind])]
    if not kinds:
        all_endings = ", ".join(ending for kind in KINDS for ending in endings[kind])
        raise rejected(
            "NS0811",
            f"'{data}' contains no scenes",
            notes=(f"clips and panoramas end in {all_endings}",),
            helps=("name a folder of such files, or leave --data out to use synthetic scenes",),
        )
    return kinds


def some_scenes(
    protocol: Protocol, data: Path | None, count: int, seed: int = 0
) -> list[ProtocolScene]:
    """Return at most `count` scenes, of `data` or procedural; raise Rejected (NS0811)."""
    if data is None:
        candidates = [made_scene(index, protocol, seed) for index in range(count)]
    else:
        files = files_of(protocol, data)
        of_file = -(-count // len(files))
        candidates = [
            scene
            for path in files[:count]
            for scene in islice(
                (s for s in scenes_in([path], protocol) if isinstance(s, ProtocolScene)), of_file
            )
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
