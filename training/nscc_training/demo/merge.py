"""Reconstruction without a network: merged neighbours for stills, total variation for clips."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects import everything
from nscc_runtime.pieces import Taken
from nscc_runtime.sensor import Sensor
from nscc_training.baselines.hdr import merged
from nscc_training.baselines.sci import gap_tv


def dark_codes(dark: Taken) -> NDArray[np.float64]:
    """Return the mean dark value of each pixel (rows, cols), in converter codes, for one bucket."""
    return np.asarray(dark.simulated.frame.frame[:, 0].mean(axis=0))


def laid_like(offset: NDArray[np.float64], codes: NDArray[np.uint8]) -> NDArray[np.float64]:
    """Return the array's offsets, repeated over `codes` (rows, cols[, colours])."""
    size = codes.shape[:2]
    times = [-(-side // most) for side, most in zip(size, offset.shape, strict=True)]
    tiled = np.tile(offset, times)[: size[0], : size[1]]
    return tiled if codes.ndim == 2 else tiled[..., None]


def merged_light(
    capture: Taken, offset: NDArray[np.float64], sensor: Sensor
) -> tuple[NDArray[np.float32], str]:
    """Return the light of a frame with one bucket, and the name of the method.

    The light is in electrons over the frame (rows, cols) for a still, or per slot (T, rows, cols)
    for a clip; colours are the last axis. `offset` is the dark value of the array in converter
    codes."""
    frame, container = capture.simulated.frame, capture.container
    assert container.pixel_codes is not None  # the frame has been exposed
    lanes = container.table.shutter_of_code[container.pixel_codes]
    codes, saturated = (values[..., 0, :, :] for values in (frame.frame, frame.saturated))
    lsb_e, size = sensor.electrons_per_lsb, codes.shape[-2:]
    shutters = container.table.shutters[:, 0]

    def of_colour(codes: NDArray[Any], full: NDArray[Any]) -> NDArray[np.floating]:
        seen_lsb = codes - laid_like(offset, codes)
        if capture.light.kind == "still":
            share = shutters @ (np.array(container.slot_us) / sum(container.slot_us))
            noise_e = everything().converter_lsb(sensor) * lsb_e
            return merged(seen_lsb, share[lanes].astype(np.float64), lsb_e, full, noise_e)
        white_e = sensor.full_well_e / container.slots
        mask = np.moveaxis(shutters.astype(np.float32)[lanes], -1, 0)
        relative_light = np.maximum(seen_lsb, 0.0) * (lsb_e / white_e)
        clip = gap_tv(relative_light.astype(np.float32), np.ascontiguousarray(mask))
        return np.maximum(clip, 0) * np.float32(white_e)

    colour_lights = [of_colour(*colour_arrays) for colour_arrays in zip(codes.reshape(-1, *size),
            saturated.reshape(-1, *size), strict=True)]  # fmt: skip
    light = colour_lights[0] if codes.ndim == 2 else np.stack(colour_lights, axis=-1)
    how = "neighbours merged" if capture.light.kind == "still" else "total variation (GAP-TV)"
    return np.asarray(light, np.float32), how
