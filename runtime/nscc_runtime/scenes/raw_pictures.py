"""Read raw files of cameras by LibRaw."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.scenes.pages import Note, Pages

_NOTE: Note = (
    "is a raw file: linear light, black and white level applied, colours as the camera has them",
    "convert it to .tiff or .exr if you need the colours of a standard",
)


def raw_pages(path: Path) -> Pages:
    """Open the picture of a raw file: uint16, 65535 at the camera's white level. No curve, no
    colour balance and no brightening are applied. Raises ImportError without rawpy."""
    import rawpy

    with rawpy.imread(str(path)) as raw:
        size = (int(raw.sizes.height), int(raw.sizes.width))
        stored = (int(raw.sizes.raw_height), int(raw.sizes.raw_width))

    def read() -> Iterator[NDArray[Any]]:
        with rawpy.imread(str(path)) as raw:
            picture = raw.postprocess(
                gamma=(1, 1), no_auto_bright=True, no_auto_scale=False, output_bps=16,
                user_wb=[1, 1, 1, 1], output_color=rawpy.ColorSpace.raw,
                highlight_mode=rawpy.HighlightMode.Clip,
            )  # fmt: skip
            yield np.asarray(picture)

    return Pages((size, stored), 1, read, notes=(_NOTE,))
