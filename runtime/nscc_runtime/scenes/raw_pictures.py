"""Read raw files of cameras by rawpy: linear light in the camera's colours."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.scenes.pages import Pages
from nscc_runtime.scenes.picture_size import refuse_size

RAW = (".arw", ".cr2", ".dng", ".nef")
"""Endings of raw files."""
_NOTE = (
    "is a raw file: linear light, black and white level applied, colours as the camera has them",
    "convert it to .tiff or .exr if you need the colours of a standard",
)


def raw_size(path: Path) -> tuple[int, int]:
    """Return rows and columns of the picture in a raw file, without decoding it."""
    import rawpy

    with rawpy.imread(str(path)) as raw:
        return int(raw.sizes.height), int(raw.sizes.width)


def raw_pages(path: Path) -> Pages:
    """Open the picture of a raw file: uint16, 65535 at the camera's white level. No curve, no
    colour balance and no brightening are applied. Raises ImportError without rawpy."""
    import rawpy

    def read() -> Iterator[NDArray[Any]]:
        with rawpy.imread(str(path)) as raw:
            refuse_size(path, raw.sizes.raw_height, raw.sizes.raw_width)
            picture = raw.postprocess(
                gamma=(1, 1), no_auto_bright=True, no_auto_scale=False, output_bps=16,
                user_wb=[1, 1, 1, 1], output_color=rawpy.ColorSpace.raw,
                highlight_mode=rawpy.HighlightMode.Clip,
            )  # fmt: skip
            yield np.asarray(picture)

    return Pages(1, read, notes=(_NOTE,))
