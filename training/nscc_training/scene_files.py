"""Files of scenes in a folder."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterable
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.diagnostics.rejection import rejected
from nscc_runtime.scenes import clips
from nscc_runtime.scenes.arrays import MAT_CLIP_KEY, read_mat
from nscc_runtime.scenes.clips import read_clip
from nscc_runtime.scenes.colour import Transfer, grey

CLIPS = (*clips.CLIPS, ".mat")
"""How names of clips end: films, and the arrays of the benchmark."""


def files_in(folder: Path, endings: Collection[str]) -> list[Path]:
    """The files whose names end so, by name; none where there is no such folder."""
    if not folder.is_dir():
        return []
    return sorted(path for path in folder.iterdir() if path.suffix.lower() in endings)


def protocol_files(
    folder: Path, endings: Collection[str], protocol: str, what: str, wanted: str
) -> list[Path]:
    """The same; Rejected (NS0811) where there are none of `what` a protocol is about."""
    found = files_in(folder, endings)
    if not found:
        raise rejected(
            "NS0811",
            f"'{folder}' holds no data for protocol {protocol}",
            notes=(
                *(() if folder.is_dir() else ("there is no such folder",)),
                f"{what} {', '.join(endings)}",
            ),
            helps=(f"name a folder of {wanted}",),
        )
    return found


def light_in(stored: NDArray[Any], transfer: Transfer) -> NDArray[np.float64]:
    """The light of a stored picture or frame, (rows, cols), of colours their luminance."""
    return grey(stored, transfer, None)


def frames_in(path: Path) -> Iterable[NDArray[Any]]:
    """The frames of a clip as they are stored, one after the other."""
    if path.suffix.lower() != ".mat":
        return read_clip(path)
    key, found = read_mat(path, lambda _shape: None)
    return np.moveaxis(found, 2, 0) if key == MAT_CLIP_KEY else found


def labels(files: Iterable[Path]) -> dict[str, str]:
    """What products of each file are called, by its name: as it is but for the ending, if that is
    enough to tell them apart."""
    paths = list(files)
    alike = Counter(path.stem for path in paths)
    return {p.name: p.stem if alike[p.stem] == 1 else p.name.replace(".", "_") for p in paths}
