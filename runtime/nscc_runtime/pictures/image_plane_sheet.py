"""Draw a frame of images and planes, the results computed from every pixel's neighbours."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from nscc_runtime.frame_file import Frame
from nscc_runtime.pictures.images import Image, image_sheet

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_COLUMNS = 2


def image_plane_sheet(frame: Frame, buckets: Sequence[str], title: str) -> Figure:
    """Draw buckets, images (0.5th to 99.5th percentile), planes in black and white, and events.

    `buckets` are the names of the frame's buckets."""
    arrays = frame.told
    names = [*map(str, buckets), *(f"bucket {n}" for n in range(len(buckets), len(frame.frame)))]
    shown = [
        Image(codes, names[number], "bucket, as read out")
        for number, codes in enumerate(frame.frame)
    ]
    for key, values in arrays.items():
        kind, _, name = key.partition("_")
        if kind == "plane":
            text = f"plane, {np.count_nonzero(values) / values.size:.1%} are 1"
            shown.append(Image((values * 255).astype(np.uint8), name, text))
        elif kind == "image" and f"image_codes_{name}" in arrays:
            low, high = (float(value) for value in np.percentile(values, (0.5, 99.5)))
            share = np.clip((values - low) / max(high - low, 1e-30), 0.0, 1.0)
            grey = np.rint(255 * share).astype(np.uint8)
            shown.append(Image(grey, name, f"image, {low:.4g} to {high:.4g} electrons"))
        elif key.startswith("report_events_") and f"{key}_count" in arrays:
            points = values[values[:, 0] >= 0]
            grey = np.zeros(arrays["margin"].shape, np.uint8)
            grey[points[:, 1], points[:, 0]] = 255
            name = key.removeprefix("report_events_")
            shown.append(Image(grey, name, f"{len(points)} events reported"))
    rows = [shown[k : k + _COLUMNS] for k in range(0, len(shown), _COLUMNS)]
    return image_sheet(rows, title)
