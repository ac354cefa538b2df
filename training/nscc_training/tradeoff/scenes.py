"""The scenes of a tradeoff: made ones, or the first of a folder, exposed as a protocol says."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import islice
from pathlib import Path
from typing import Any, Literal

import numpy as np

from nscc.diagnostics.rejection import rejected
from nscc_training import made_scenes
from nscc_training.evaluation import hdr, video
from nscc_training.evaluation.results import Unusable
from nscc_training.protocols import Protocol, load_protocol
from nscc_training.scene_files import CLIPS

Kind = Literal["clips", "stills"]
KINDS: tuple[Kind, ...] = ("clips", "stills")
Scene = video.Window | hdr.Crop

_MADE = 3
"""Apart from the made scenes that runs learn from (1) and are chosen by (2)."""


def protocol_of(kind: Kind, size: int, frames: int, full_well_e: float | None = None) -> Protocol:
    """video-v1 or hdr-v1 with another size of scenes, clips of another length, another full well.

    The digest is the file's, and numbers of such a protocol are not the protocol's.
    """
    if kind == "clips":
        known = load_protocol("video-v1")
        changed: dict[str, Any] = {"size": size, "frames": frames}
    else:
        known = load_protocol("hdr-v1")
        middle = sum(known["crop_rows"]) // 2
        changed = {
            "crop_size": size, "crop_rows": [middle - size // 2, middle - size // 2 + size]
        }  # fmt: skip
    if full_well_e is not None:
        changed["full_well_e"] = full_well_e
    return Protocol(known.name, known.sha256, {**known.values, **changed})


def files_of(kind: Kind, data: Path) -> list[Path]:
    """The scenes' files in a folder; Rejected (NS0811) where there are none."""
    return video.clips_of(data) if kind == "clips" else hdr.panoramas(data)


def kinds_in(data: Path) -> list[Kind]:
    """What kinds of scenes a folder holds; Rejected (NS0811) where there are none."""
    found = {p.suffix.lower() for p in data.iterdir()} if data.is_dir() else set()
    endings: dict[Kind, Sequence[str]] = {"clips": CLIPS, "stills": hdr.ENDINGS}
    kinds = [kind for kind in KINDS if found & set(endings[kind])]
    if not kinds:
        every = ", ".join(ending for kind in KINDS for ending in endings[kind])
        raise rejected(
            "NS0811",
            f"'{data}' holds no scenes",
            notes=(f"clips and panoramas end in {every}",),
            helps=("name a folder of such files, or leave --data out: scenes are made then",),
        )
    return kinds


def scenes(
    kind: Kind, protocol: Protocol, data: Path | None, count: int, seed: int = 0
) -> list[Scene]:
    """At most `count` scenes, as many of one file as of another; made ones without `data`.

    Rejected (NS0811) where none can be exposed as the protocol says.
    """
    if data is None:
        found = list(_made(kind, protocol, count, seed))
    else:
        files = files_of(kind, data)
        each = -(-count // len(files))
        found = [
            scene for path in files[:count] for scene in islice(_of_file(path, protocol), each)
        ][:count]
    if not found:
        size = protocol["size" if kind == "clips" else "crop_size"]
        raise rejected(
            "NS0811",
            f"none of the {kind} {f'in {str(data)!r} ' if data else ''}can be exposed",
            notes=(
                f"clips need {size} x {size} pixels and {protocol['frames']} frames"
                if kind == "clips"
                else f"panoramas are 512 x 1024, and {protocol['saturated_fraction']:.0%} of a "
                "crop must saturate",
            ),
            helps=("name other files, or ask for smaller scenes",),
        )
    return found


def _of_file(path: Path, protocol: Protocol) -> Iterator[Scene]:
    cut = video.windows if protocol.name == "video-v1" else hdr.crops
    return (scene for scene in cut([path], protocol) if not isinstance(scene, Unusable))


def _made(kind: Kind, protocol: Protocol, count: int, seed: int) -> Iterator[Scene]:
    for index in range(count):
        generator = np.random.default_rng([seed, _MADE, index])
        name = Path(f"made-{index}")
        scene: Scene | Unusable
        if kind == "clips":
            clip = made_scenes.clip(generator, protocol["frames"], protocol["size"])
            scene = video.exposed_window(name, 0, clip.astype(np.float64), False, protocol)
        else:
            still = made_scenes.still(generator, protocol["crop_size"])
            scene = hdr.exposed_crop(name, (0, 0), still.astype(np.float64), protocol)
        if not isinstance(scene, Unusable):
            yield scene
