"""Read OpenEXR files: parts, layers, display windows, luminance with chroma, subsampled
channels."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from math import prod
from pathlib import Path
from typing import Any

import numpy as np

from nscc.arrays import Array
from nscc.diagnostics.diagnostic import rejected
from nscc_runtime.scenes import pages as limits
from nscc_runtime.scenes.colour import LUMINANCE, Weights
from nscc_runtime.scenes.file_colours import of_primaries
from nscc_runtime.scenes.pages import Note, Pages, UnsupportedPicture

_COLOURS = ("R", "G", "B")
_LAYERS_SHOWN = 6
"""Number of names that a message lists."""
_MOST_SAMPLES = 4
"""Largest number of samples of an OpenEXR file, in all parts and channels, per MOST_PIXELS: they
are decoded together."""


def exr_pages(path: Path) -> Pages:
    """Open the pictures of an OpenEXR file, one for each part with a picture.

    Raises
    ------
    UnsupportedPicture
        If no part contains colours or luminance, or if a part contains several layers with them.
    Rejected
        NS0734 for too many samples.
    """
    import OpenEXR

    with OpenEXR.File(str(path), header_only=True) as file:
        headers = [dict(file_part.header) for file_part in file.parts]  # emptied when closed
    part_names = [[channel.name for channel in header["channels"]] for header in headers]
    # Sizes are checked before any channel is decoded.
    samples = sum(
        prod(_size(header["dataWindow"])) * len(names)
        for header, names in zip(headers, part_names, strict=True)
    )
    if samples > _MOST_SAMPLES * limits.MOST_PIXELS:
        raise rejected(
            "NS0734",
            f"'{path}' has {samples:,} samples in its parts and channels, but at most "
            f"{_MOST_SAMPLES * limits.MOST_PIXELS:,} are allowed",
            helps=("save the required picture in a separate file",),
        )
    of_parts = [_picture_layer(names) for names in part_names]
    layers = {k: layer for k, layer in enumerate(of_parts) if layer is not None}
    if not layers:
        names = sorted({name for part in part_names for name in part})
        raise UnsupportedPicture(
            f"it has no channels R, G, B or Y, but {_listed(names)}",
            "save the picture as the channels R, G, B, or as Y",
        )
    # Colours and notes are those of the first part with a picture.
    stated = of_primaries(headers[next(iter(layers))].get("chromaticities"))
    weights = LUMINANCE if stated.colours is None else stated.colours.weights
    notes: list[Note] = []
    if len(layers) > 1:
        names = [str(headers[k].get("name", "")) or f"part {k}" for k in layers]
        text = f"contains {len(layers)} parts with a picture, used as frames of a clip"
        notes.append((f"{text}: {_listed(names)}", "--still --first K selects one of them"))

    def read() -> Iterator[Array]:
        """Yield the layers as pictures; raise ValueError if parts of the file are missing."""
        with OpenEXR.File(str(path), separate_channels=True) as file:
            if len(file.parts) < len(headers):  # the library leaves out parts that it cannot read
                missing = len(headers) - len(file.parts)
                raise ValueError(f"{missing} of {len(headers)} parts are incomplete")
            for k, layer in layers.items():
                channels, window = file.parts[k].channels, headers[k]["dataWindow"]
                picture = _layer_pixels(channels, layer, window, weights)
                yield _in_display_window(picture, headers[k])

    windows = [_size(headers[k][name]) for name in ("displayWindow", "dataWindow") for k in layers]
    return Pages(tuple(windows), len(layers), read, stated, tuple(notes))


def _size(corners: Any) -> tuple[int, int]:
    """Return the numbers of rows and columns of a window. `corners`: ((left, top), (right,
    bottom)), both included."""
    (x0, y0), (x1, y1) = corners
    return int(y1) - int(y0) + 1, int(x1) - int(x0) + 1


def _picture_layer(channels: Sequence[str]) -> str | None:
    """Return the prefix of the channels with the picture of a part: "" or "NAME.". Return None if
    there is no picture.

    `channels` are the names of the part's channels. A picture is the channels R, G, B or Y under
    one prefix; the one without a prefix has precedence. Raises UnsupportedPicture if several
    layers, but not that one, contain pictures."""
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
    channels: Mapping[str, Any],
    layer: str,
    window: tuple[Array, Array],
    weights: Weights,
) -> Array:
    """Return the picture of a layer on its data window, (rows, cols) of Y alone, else (rows, cols,
    3).

    `channels` are the channels of a part by name, `layer` the prefix of their names, "" or "NAME.".
    `window` is ((left, top), (right, bottom)). `weights` are the luminances of red, green and blue,
    by which green is computed from luminance and chroma."""

    def pixels(name: str) -> Array:
        """Return the channel `name` (without prefix) of the layer at every pixel, (rows, cols)."""
        return _at_every_pixel(channels[layer + name], window)

    if f"{layer}R" in channels:
        return np.stack([pixels(name) for name in _COLOURS], axis=-1)
    luminance = pixels("Y")
    if f"{layer}RY" not in channels or f"{layer}BY" not in channels:
        return luminance
    # Chroma is (red - Y) / Y and (blue - Y) / Y.
    luminance = luminance.astype(np.float32)
    red, blue = ((pixels(name) + 1) * luminance for name in ("RY", "BY"))
    weight_red, weight_green, weight_blue = weights
    green = (luminance - weight_red * red - weight_blue * blue) / weight_green
    return np.stack([red, green, blue], axis=-1).astype(np.float32)


def _at_every_pixel(channel: Any, window: tuple[Array, Array]) -> Array:
    """Return the samples of `channel` at all pixels of the data window `window`, ((left, top),
    (right, bottom)). A subsampled channel is interpolated linearly, to float32; beyond its last
    sample that sample is repeated."""
    values = np.asarray(channel.pixels)
    steps = int(channel.ySampling), int(channel.xSampling)
    if steps == (1, 1):
        return values
    from scipy.ndimage import map_coordinates

    # Samples lie at multiples of the step. `-(-first // step) * step` is the first multiple in the
    # window; positions count in samples from it.
    positions = [
        (np.arange(first, last + 1) + (-first // step) * step) / step
        for step, first, last in zip(steps, *(corner[::-1] for corner in window), strict=True)
    ]
    grid = np.meshgrid(*positions, indexing="ij")
    return np.asarray(map_coordinates(values.astype(np.float32), grid, order=1, mode="nearest"))


def _in_display_window(picture: Array, header: Mapping[str, Any]) -> Array:
    """Return a `picture` (rows, cols, ..) on its data window as it appears in the display window:
    padded with black, or cropped. `header` states both windows."""
    rows, cols = _size(header["displayWindow"])
    offsets = np.subtract(header["dataWindow"][0], header["displayWindow"][0])
    col, row = offsets.tolist()
    if (row, col) == (0, 0) and picture.shape[:2] == (rows, cols):
        return picture
    shown = np.zeros((rows, cols, *picture.shape[2:]), picture.dtype)
    # (row, col) is where the data begins in the display window; negative: outside it.
    visible = picture[max(-row, 0) : max(rows - row, 0), max(-col, 0) : max(cols - col, 0)]
    row, col = max(row, 0), max(col, 0)
    shown[row : row + visible.shape[0], col : col + visible.shape[1]] = visible
    return shown


def _listed(names: list[str]) -> str:
    """Return names as text: the first 6, each of at most 40 characters, and how many more."""
    shown = ", ".join(name[:40] for name in names[:_LAYERS_SHOWN])
    return shown + (f" and {len(names) - _LAYERS_SHOWN} more" * (len(names) > _LAYERS_SHOWN))
