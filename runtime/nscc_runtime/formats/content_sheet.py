"""Draw the content of an output file: one image, or the frames of a clip side by side."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from nscc_runtime.formats.content import Content
from nscc_runtime.pictures.images import Image, image_sheet

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_COLUMNS, _MOST = 4, 16


def content_sheet(content: Content, title: str) -> Figure:
    """Draw a picture, or up to sixteen frames of a clip, with a note that names the tone curve."""
    shown = [*content.shown]
    numbers = np.unique(np.linspace(0, len(shown) - 1, min(_MOST, len(shown))).round().astype(int))
    images = [
        Image(shown[k], f"frame {k}" if content.moving else "", content.tone_text if k == 0 else "")
        for k in numbers
    ]
    rows = [images[k : k + _COLUMNS] for k in range(0, len(images), _COLUMNS)]
    return image_sheet(rows, title)
