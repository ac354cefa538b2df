"""Reconstruction without a decoder: exposures of neighbours merged, clips by total variation."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.words.container import Container
from nscc_runtime.effects import everything
from nscc_runtime.pieces import Taken
from nscc_runtime.sensor import Sensor
from nscc_training.baselines.hdr import merged
from nscc_training.baselines.sci import gap_tv


def dark_codes(dark: Taken) -> NDArray[np.float64]:
    """What the array (rows, cols) reads without light, from repeated frames of one bucket."""
    return np.asarray(dark.simulated.frame.frame[:, 0].mean(axis=0))


def laid_like(offset: NDArray[np.float64], codes: NDArray[np.uint8]) -> NDArray[np.float64]:
    """The array's offsets (rows, cols) under codes (rows, cols) or (rows, cols, colours) of arrays
    side by side."""
    size = codes.shape[:2]
    times = [-(-side // most) for side, most in zip(size, offset.shape, strict=True)]
    found = np.tile(offset, times)[: size[0], : size[1]]
    return found if codes.ndim == 2 else found[..., None]


def merged_light(
    taken: Taken, offset: NDArray[np.float64], sensor: Sensor
) -> tuple[NDArray[np.float32], str]:
    """The light of a frame of one bucket: electrons over the frame (rows, cols) of a still, a slot
    (T, rows, cols) of a clip, with colours last; and by what it was found.

    `offset` is what the array reads without light, in codes.
    """
    still, frame = taken.light.kind == "still", taken.simulated.frame
    codes, saturated = (values[..., 0, :, :] for values in (frame.frame, frame.saturated))
    share = _open_share(taken.container)
    made = []
    for each, full in zip(*(_by_colour(values) for values in (codes, saturated)), strict=True):
        seen_lsb = each - laid_like(offset, each)
        made.append(
            _still(seen_lsb, full, share, sensor) if still else _clip(seen_lsb, taken, sensor)
        )
    light = made[0] if codes.ndim == 2 else np.stack(made, axis=-1)
    how = "neighbours merged" if still else "total variation (GAP-TV)"
    return np.asarray(light, np.float32), how


def _by_colour(values: NDArray[Any]) -> NDArray[Any]:
    return values.reshape(-1, *values.shape[-2:])


def _still(
    seen_lsb: NDArray[np.float64], saturated: NDArray[np.bool_], share: NDArray[np.float64],
    sensor: Sensor,
) -> NDArray[np.float64]:  # fmt: skip
    lsb_e = sensor.electrons_per_lsb
    return merged(seen_lsb, share, lsb_e, saturated, everything().converter_lsb(sensor) * lsb_e)


def _clip(seen_lsb: NDArray[np.float64], taken: Taken, sensor: Sensor) -> NDArray[np.float32]:
    container = taken.container
    white_e = sensor.full_well_e / container.slots
    mask = container.table.shutters[:, 0].astype(np.float32)[_lanes(container)]
    seen = np.maximum(seen_lsb, 0.0) * (sensor.electrons_per_lsb / white_e)
    found = gap_tv(seen.astype(np.float32), np.ascontiguousarray(np.moveaxis(mask, -1, 0)))
    return np.maximum(found, 0) * np.float32(white_e)


def _open_share(container: Container) -> NDArray[np.float64]:
    """The part of the frame (rows, cols) that each pixel is open for."""
    slots = np.array(container.slot_us) / sum(container.slot_us)
    share = np.asarray(container.table.shutters[:, 0] @ slots, np.float64)
    return np.asarray(share[_lanes(container)])


def _lanes(container: Container) -> NDArray[np.signedinteger]:
    assert container.pixel_codes is not None  # it has been exposed
    return container.table.shutter_of_code[container.pixel_codes]
