"""Read OpenEXR files: parts, layers, display windows, luminance with chroma, subsampled
channels."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.scenes.colour import LUMINANCE
from nscc_runtime.scenes.pages import Note, Pages, UnsupportedPicture

_COLOURS = ("R", "G", "B")
_REC_709 = (0.64, 0.33, 0.30, 0.60, 0.15, 0.06, 0.3127, 0.3290)
"""The default primaries: x and y of red, green, blue and white."""
_LAYERS_SHOWN = 6


def exr_pages(path: Path) -> Pages:
    """Open the pictures of an OpenEXR file, one for each part with a picture.

    Raises
    ------
    UnsupportedPicture
        If no part contains colours or luminance, or if a part contains several layers with them.
    """
    import OpenEXR

    pictures: list[NDArray[Any]] = []
    names: list[str] = []
    notes: list[Note] = []
    channel_names: set[str] = set()
    with OpenEXR.File(str(path), header_only=True) as file:
        count = len(file.parts)
    with OpenEXR.File(str(path), separate_channels=True) as file:
        if len(file.parts) < count:  # the library leaves out the parts that it cannot read
            raise ValueError(f"{count - len(file.parts)} of {count} parts are incomplete")
        for file_part in file.parts:
            channel_names.update(file_part.channels)
            layer = _picture_layer(file_part.channels)
            if layer is None:
                continue
            picture = _layer_pixels(file_part.channels, layer, file_part.header["dataWindow"])
            pictures.append(_in_display_window(picture, file_part.header))
            names.append(str(file_part.header.get("name", "")) or f"part {len(names)}")
            notes += _primaries_note(file_part.header)
    if not pictures:
        raise UnsupportedPicture(
            f"it has no channels R, G, B or Y, but {_listed(sorted(channel_names))}",
            "save the picture as the channels R, G, B, or as Y",
        )
    if len(pictures) > 1:
        text = f"contains {len(names)} parts with a picture, used as frames of a clip"
        notes.append((f"{text}: {_listed(names)}", "--still --first K selects one of them"))

    def read() -> Iterator[NDArray[Any]]:
        yield from pictures

    return Pages(len(pictures), read, notes=tuple(dict.fromkeys(notes)))


def _picture_layer(channels: Mapping[str, Any]) -> str | None:
    """Return the prefix of the channels with the picture of a part, '' or 'NAME.'; None if there is
    no picture. Raises UnsupportedPicture if several layers contain pictures."""
    prefixes = {name.rpartition(".")[0] for name in channels}
    layers = [f"{prefix}." if prefix else "" for prefix in sorted(prefixes)]
    usable = [
        layer
        for layer in layers
        if f"{layer}Y" in channels or all(f"{layer}{colour}" in channels for colour in _COLOURS)
    ]
    if "" in usable or not usable:
        return "" if usable else None
    if len(usable) > 1:
        raise UnsupportedPicture(
            f"it holds the pictures of {len(usable)} layers: "
            f"{_listed([layer.rstrip('.') for layer in usable])}",
            "save the required layer as the channels R, G, B of a file",
        )
    return usable[0]


def _layer_pixels(
    channels: Mapping[str, Any], layer: str, window: tuple[NDArray[Any], NDArray[Any]]
) -> NDArray[Any]:
    """Return the picture of a layer on its data window."""

    def pixels(name: str) -> NDArray[Any]:
        return _at_every_pixel(channels[layer + name], window)

    if f"{layer}R" in channels:
        return np.stack([pixels(name) for name in _COLOURS], axis=-1)
    luminance = pixels("Y")
    if f"{layer}RY" not in channels or f"{layer}BY" not in channels:
        return luminance
    # Chroma is (red - Y) / Y and (blue - Y) / Y.
    luminance = luminance.astype(np.float32)
    red, blue = ((pixels(name) + 1) * luminance for name in ("RY", "BY"))
    weight_red, weight_green, weight_blue = LUMINANCE
    green = (luminance - weight_red * red - weight_blue * blue) / weight_green
    return np.stack([red, green, blue], axis=-1).astype(np.float32)


def _at_every_pixel(channel: Any, window: tuple[NDArray[Any], NDArray[Any]]) -> NDArray[Any]:
    """Return the samples of a channel at all pixels, interpolated linearly if it is subsampled."""
    values = np.asarray(channel.pixels)
    (first_col, first_row), (last_col, last_row) = window
    for axis, step, first, last in (
        (0, channel.ySampling, int(first_row), int(last_row)),
        (1, channel.xSampling, int(first_col), int(last_col)),
    ):
        if step == 1:
            continue
        # Samples lie at multiples of the step.
        at = (np.arange(first, last + 1) - -(-first // step) * step) / step
        low = np.clip(np.floor(at).astype(int), 0, values.shape[axis] - 1)
        high = np.minimum(low + 1, values.shape[axis] - 1)
        share = np.clip(at - low, 0, 1).reshape((-1, 1) if axis == 0 else (1, -1))
        reals = values.astype(np.float32)
        values = reals.take(low, axis) * (1 - share) + reals.take(high, axis) * share
        values = values.astype(np.float32)
    return values


def _in_display_window(picture: NDArray[Any], header: Mapping[str, Any]) -> NDArray[Any]:
    """Return the picture in its display window: padded with black, or cropped."""
    (data_left, data_top), _ = header["dataWindow"]
    (shown_left, shown_top), (shown_right, shown_bottom) = header["displayWindow"]
    rows, cols = int(shown_bottom) - int(shown_top) + 1, int(shown_right) - int(shown_left) + 1
    row, col = int(data_top) - int(shown_top), int(data_left) - int(shown_left)
    if (row, col) == (0, 0) and picture.shape[:2] == (rows, cols):
        return picture
    shown = np.zeros((rows, cols, *picture.shape[2:]), picture.dtype)
    visible = picture[max(-row, 0) : max(rows - row, 0), max(-col, 0) : max(cols - col, 0)]
    row, col = max(row, 0), max(col, 0)
    shown[row : row + visible.shape[0], col : col + visible.shape[1]] = visible
    return shown


def _primaries_note(header: Mapping[str, Any]) -> list[Note]:
    named = header.get("chromaticities")
    if named is None or np.allclose(np.ravel(named), _REC_709, atol=2e-3):
        return []
    shown = ", ".join(f"{value:.4g}" for value in np.ravel(named))
    return [(
        f"names other primaries ({shown}); its luminance is weighted as of Rec. 709",
        "convert its colours to Rec. 709 (sRGB) primaries if the weights matter",
    )]  # fmt: skip


def _listed(names: list[str]) -> str:
    shown = ", ".join(name[:40] for name in names[:_LAYERS_SHOWN])
    return shown + (f" and {len(names) - _LAYERS_SHOWN} more" * (len(names) > _LAYERS_SHOWN))
