"""Reconstruction without a decoder: exposures of neighbours merged, clips by total variation."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nscc.words.container import Container
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
    still = taken.light.kind == "still"
    codes = taken.simulated.frame.frame[..., 0, :, :]
    recover = _still if still else _clip
    made = [
        recover(each, laid_like(offset, each), taken.container, sensor)
        for each in codes.reshape(-1, *codes.shape[-2:])
    ]
    light = made[0] if codes.ndim == 2 else np.stack(made, axis=-1)
    how = "neighbours merged" if still else "total variation (GAP-TV)"
    return np.asarray(light, np.float32), how


def _still(
    codes: NDArray[np.uint8], offset: NDArray[np.float64], container: Container, sensor: Sensor
) -> NDArray[np.float64]:
    slots = np.array(container.slot_us) / sum(container.slot_us)
    share = container.table.shutters[:, 0] @ slots
    top = 2**container.target.adc_bits - 1
    # Pixels at the top of the scale are known by their code: an offset must not hide them.
    seen = np.where(codes >= top, top, np.maximum(codes - offset, 0.0)).astype(np.float32)
    lsb_e = sensor.electrons_per_lsb
    noise_e = sensor.adc_noise_lsb * lsb_e
    return merged(seen, share[_lanes(container)], lsb_e, top, noise_e)


def _clip(
    codes: NDArray[np.uint8], offset: NDArray[np.float64], container: Container, sensor: Sensor
) -> NDArray[np.float32]:
    white_e = sensor.full_well_e / container.slots
    mask = container.table.shutters[:, 0].astype(np.float32)[_lanes(container)]
    seen = np.maximum(codes - offset, 0.0) * (sensor.electrons_per_lsb / white_e)
    found = gap_tv(seen.astype(np.float32), np.ascontiguousarray(np.moveaxis(mask, -1, 0)))
    return np.maximum(found, 0) * np.float32(white_e)


def _lanes(container: Container) -> NDArray[np.intp]:
    assert container.pixel_codes is not None  # it has been exposed
    return container.table.shutter_of_code[container.pixel_codes]
