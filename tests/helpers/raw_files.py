"""Raw files of cameras (DNG) for tests, with the tags that a test chooses."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import tifffile


def write_dng(path: Path, mosaic: np.ndarray, **changes: Any) -> None:
    """A DNG whose first directory is the mosaic; `changes` replace tags by their name."""
    identity = (1, 1, 0, 1, 0, 1, 0, 1, 1, 1, 0, 1, 0, 1, 0, 1, 1, 1)
    tags: dict[str, Any] = {
        "version": (50706, "B", 4, (1, 4, 0, 0)), "backward": (50707, "B", 4, (1, 1, 0, 0)),
        "model": (50708, "s", 0, "Test"), "pattern_size": (33421, "H", 2, (2, 2)),
        "pattern": (33422, "B", 4, (0, 1, 1, 2)), "black": (50714, "H", 1, 0),
        "white": (50717, "H", 1, 4095), "matrix": (50721, "2i", 9, identity),
        "neutral": (50728, "2I", 3, (1, 1, 1, 1, 1, 1)), "illuminant": (50778, "H", 1, 21),
        **changes,
    }  # fmt: skip
    photometric = tags.pop("photometric", 32803)
    tifffile.imwrite(
        path,
        mosaic,
        photometric=photometric,
        metadata=None,
        extratags=[(*tag, True) for tag in sorted(t for t in tags.values() if t is not None)],
    )
