"""Choose training settings for a folder of pictures or clips, as the documentation advises."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

from nscc.diagnostics.diagnostic import rejected
from nscc.mappings import NamedValues
from nscc.program.problems import counted
from nscc_runtime.scenes.picture_files import DISPLAY, LINEAR, PICTURES
from nscc_training.scene_files import CLIPS, files_in, frame_size
from nscc_training.settings import RunSettings, settings_of

_PATCHES = (128, 96, 64, 48, 32)
"""Sides of patches in pixels. A network sees more of a scene in larger patches, but a step takes
longer."""
_STILLS: dict[str, NamedValues] = {
    "shutter": {
        "class": "b",
        "slots": 256,
        "tile": [4, 4],
        "init": "quad",
        "relaxation": "tried",
        "noise": 8.0,
    },
    "data": {"protocol": "hdr-v1", "together": 8, "val_items": 16, "saturated": [0.3, 0.6]},
    "loss": {"name": "psnr+psnr-mu"},
    "train": {"steps": 2500, "batch": 8, "validate_every": 250},
}
"""Settings that differ from the defaults for stills, by section of the configuration."""
_CLIPS: dict[str, NamedValues] = {
    "shutter": {
        "class": "d",
        "slots": 16,
        "slot_us": 1000.0,
        "tile": [8, 8],
        "init": "quad",
        "relaxation": "tried",
        "noise": 0.25,
        "tried_share": 0.3,
        "warm_up": 0.2,
        "settle": 0.4,
    },
    "data": {
        "protocol": "video-v1",
        "together": 4,
        "val_items": 16,
        "paths": 8,
        "brightness": [0.25, 1.0],
    },
    "loss": {"name": "psnr-display"},
    "train": {"steps": 4000, "batch": 4, "validate_every": 500, "code_rate": 2e-4},
}
"""Settings that differ from the defaults for clips, by section of the configuration."""


def folder_settings(
    folder: Path, changes: Sequence[str] = (), tell: Callable[[str], object] = lambda _text: None
) -> RunSettings:
    """Return the settings to train on a folder of pictures or clips, with `changes`, each
    SECTION.KEY=VALUE.

    Linear pictures are stills of high dynamic range; beside them, other files are left out. Films,
    and photographs in display encoding, become clips. Patches are as large as the smallest file
    allows, at most 128 x 128. `tell` is called with a text that describes the settings. Raises
    Rejected: NS0811 for a folder without pictures and clips, NS0814 and NS0815 for invalid changes.
    """
    stills = files_in(folder, LINEAR)
    files = stills or files_in(folder, (*CLIPS, *DISPLAY))
    if not files:
        raise rejected(
            "NS0811",
            f"the folder '{folder}' contains no pictures or clips to learn from",
            notes=(f"they end in {', '.join((*PICTURES, *CLIPS))}",),
            helps=("name a folder of such files, or a configuration, CONFIG.toml",),
        )
    least = min(min(frame_size(path)) for path in files)
    patch = next((side for side in _PATCHES if side <= least), _PATCHES[-1])
    advice = _STILLS if stills else _CLIPS
    values = {**advice, "data": {**advice["data"], "train": str(folder), "patch": patch}}
    settings = settings_of(values, changes)
    kind = "stills of high dynamic range" if stills else "clips"
    tell(
        f"{counted(len(files), 'file')} of '{folder}', as {kind} (protocol "
        f"{settings.data.protocol}): class {settings.shutter.kind}, codes "
        f"{'tried' if settings.shutter.learn else 'fixed'}, patches of {settings.data.patch} x "
        f"{settings.data.patch}, {settings.train.steps} steps"
    )
    return settings
