"""Draw a frame of images and planes, the results computed from every pixel's neighbours."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from nscc.words.pictures import Pictures
from nscc_runtime.frame_file import Frame
from nscc_runtime.pictures.images import Image, image_sheet

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_COLUMNS = 2


def image_plane_sheet(pictures: Pictures, frame: Frame, title: str) -> Figure:
    """Draw images (0.5th to 99.5th percentile), planes in black and white, and events."""
    arrays, shown = frame.told, []
    for name in pictures.reads:
        if f"plane_{name}" in arrays:
            bits = arrays[f"plane_{name}"]
            text = f"plane, {np.count_nonzero(bits) / bits.size:.1%} are 1"
            shown.append(Image((bits * 255).astype(np.uint8), name, text))
        elif f"image_{name}" in arrays:
            values = arrays[f"image_{name}"]
            low, high = (float(value) for value in np.percentile(values, (0.5, 99.5)))
            share = np.clip((values - low) / max(high - low, 1e-30), 0.0, 1.0)
            grey = np.rint(255 * share).astype(np.uint8)
            shown.append(Image(grey, name, f"image, {low:.4g} to {high:.4g} electrons"))
        else:
            index = [bucket for bucket in pictures.reads if bucket in pictures.limits_e].index(name)
            shown.append(Image(frame.frame[index], name, "bucket, as read out"))
    for report in pictures.reports:
        if report.kind == "events":
            points = arrays[f"report_events_{report.plane}"]
            points = points[points[:, 0] >= 0]
            grey = np.zeros(arrays["margin"].shape, np.uint8)
            grey[points[:, 1], points[:, 0]] = 255
            shown.append(Image(grey, report.plane, f"{len(points)} events reported"))
    rows = [shown[k : k + _COLUMNS] for k in range(0, len(shown), _COLUMNS)]
    return image_sheet(rows, title)
