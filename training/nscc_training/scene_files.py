"""Files of scenes in a folder."""

from __future__ import annotations

from collections.abc import Collection
from pathlib import Path

from nscc_runtime.scenes import clips

CLIPS = (*clips.CLIPS, ".mat")
"""How names of clips end: films, and the arrays of the benchmark."""


def files_in(folder: Path, endings: Collection[str]) -> list[Path]:
    """The files whose names end so, by name; none where there is no such folder."""
    if not folder.is_dir():
        return []
    return sorted(path for path in folder.iterdir() if path.suffix.lower() in endings)
