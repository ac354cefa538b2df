"""Read raw files of cameras by LibRaw."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from nscc.arrays import Array
from nscc_runtime.scenes.pages import Note, Pages

_NOTE: Note = (
    "is a raw file: linear light, black and white level applied, colours as the camera has them",
    "convert it to .tiff or .exr if you need the colours of a standard",
)

_TOP = 65535
"""Sample of white in the pictures, the largest of uint16."""


def raw_pages(path: Path) -> Pages:
    """Open the picture of the raw file `path`: uint16, 65535 at the camera's white level, (R, C,
    3), or (R, C) of a grey sensor. No curve, no colour balance and no brightening are applied.

    Raises ImportError without rawpy, and the errors of LibRaw for a damaged file."""
    import rawpy

    with rawpy.imread(str(path)) as raw:
        size = (int(raw.sizes.height), int(raw.sizes.width))
        stored = (int(raw.sizes.raw_height), int(raw.sizes.raw_width))

    # The file is opened again when the picture is read, because decoding it takes much memory.
    def read() -> Iterator[Array]:
        """Yield the one picture of a camera raw file: linear, in the camera's colours, without
        corrections."""
        with rawpy.imread(str(path)) as raw:
            _scale(raw)
            picture = raw.postprocess(
                gamma=(1, 1),
                no_auto_bright=True,
                output_bps=16,
                user_wb=[1, 1, 1, 1],
                output_color=rawpy.ColorSpace.raw,
                highlight_mode=rawpy.HighlightMode.Clip,
                adjust_maximum_thr=0.0,
                user_black=0,
                user_cblack=[0] * 4,
                user_sat=_TOP,
            )
            yield picture[..., 0] if picture.shape[2] == 1 else picture

    return Pages((size, stored), count=1, read=read, notes=(_NOTE,))


def _scale(raw: Any) -> None:
    """Scale the stored samples of `raw`, an open file of rawpy, from black level..white level to
    0..65535, in place. Samples outside are clipped.

    LibRaw would stretch them to the brightest sample, and subtract one black level for all."""
    samples = raw.raw_image_visible
    black = np.array(raw.black_level_per_channel, np.float32)
    if samples.ndim == 2:
        # One black level for each pixel, by the index of its colour in the mosaic.
        black = black[raw.raw_colors_visible if raw.num_colors > 1 else 0]
    fractions = (samples - black) / (raw.white_level - black)
    samples[:] = np.rint(np.clip(fractions, 0, 1) * _TOP)
