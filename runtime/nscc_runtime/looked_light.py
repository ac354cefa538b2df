"""Light from a frame whose pixels looked: each pixel's exposure over the time that it was open.

No decoder and no neighbour has a part in it. The estimate is that of greatest likelihood for a
steady light: what saturates softly is bent back, gain, leakage and dark charge are taken away as
the sensor's figures have them in the mean, and the rest is divided by the time. Its standard
deviation adds what the same figures say of counts, reads, words, converter and unequal pixels; it
is infinite where a pixel was full, for there the light was at least so much.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.diagnostics.rejection import rejected
from nscc.words.container import Container
from nscc_runtime.effects import Selection
from nscc_runtime.effects.parts import (
    Converter,
    CountedDark,
    CountedLight,
    Leak,
    Response,
    Soft,
    Well,
    WordGain,
)
from nscc_runtime.effects.sensor import Sensor

Values = NDArray[np.float64]

LIGHT, DEVIATION = "light_e_per_s", "light_sd_e_per_s"
"""The keys of the frame file: (buckets, rows, cols), electrons a second."""

_READS, _WORDS = 2, 4
"""An exposure is PIX less its reset level: each is read once, and copied by two words."""
_PIXELS = np.arange(4096, dtype=np.int64)
"""Of a chip, for the mean and the spread of what differs from pixel to pixel."""
_NEAR_FULL = 0.995


def light_of(
    codes: NDArray[np.uint8],
    open_us: Values,
    container: Container,
    sensor: Sensor,
    effects: Selection,
) -> dict[str, Values]:
    """The light and its standard deviation, by key, each (buckets, rows, cols).

    `codes` uint8 of the converter and `open_us`, both (buckets, rows, cols): -1 where the states
    are those of no pixel. `effects` are those of the chip: all, or what an emulator had on. Of a
    pixel that never opened, or whose time is unknown, both are NaN.
    """
    frame_us = float(sum(container.slot_us))
    step_e, top = sensor.electrons_per_lsb, 2**container.target.adc_bits - 1
    read_e = (codes.astype(np.float64) - sensor.adc_offset_lsb) * step_e
    gain = _gain(container, sensor, effects, open_us, frame_us)
    held_e = _unbent(read_e, sensor, effects)
    open_s = np.where(open_us > 0, open_us, np.nan) * 1e-6
    dark_e = _dark_e_per_s(sensor, effects) * open_s
    electrons = held_e / gain
    light_e = electrons - dark_e
    full_e = effects.the(Well).full_e(sensor) if effects.part(Well) else np.inf
    full = (codes >= top) | (electrons >= _NEAR_FULL * full_e)
    variance = _variance_e2(np.maximum(electrons, 0.0), gain, sensor, effects)
    deviation = np.where(full, np.inf, np.sqrt(variance) / open_s)
    deviation[np.isnan(open_s)] = np.nan
    return {LIGHT: light_e / open_s, DEVIATION: deviation}


def _gain(
    container: Container, sensor: Sensor, effects: Selection, open_us: Values, frame_us: float
) -> Values:
    """What of the light is left in the exposure."""
    words, leak = effects.part(WordGain), effects.part(Leak)
    gain = np.full(open_us.shape, 1.0 if words is None else words.gain(sensor) ** 2)
    if leak is not None:
        # A copy is made when the shutter closes; a sum is half that old in the mean.
        closed_us = frame_us - np.maximum(open_us, 0.0)
        share = 1.0 if container.notes.get("lowering") == "latch" else 0.5
        readout_us = container.target.readout_us * np.arange(len(open_us))[:, None, None]
        gain *= np.exp(-(share * closed_us + readout_us) * 1e-6 / leak.tau_s(sensor))
    return gain


def _unbent(read_e: Values, sensor: Sensor, effects: Selection) -> Values:
    """What two registers were to hold, one after the other, that saturate softly."""
    soft = effects.part(Soft)
    if soft is None:
        return read_e
    meant = np.linspace(0.0, 2.0 * soft.linear_e(sensor), 4097)
    held = meant
    for _ in range(2):
        held = held - soft.lost_e(sensor, held)
    unbent = np.interp(read_e, held, meant)
    return np.where(read_e > soft.linear_e(sensor), unbent, read_e)


def _dark_e_per_s(sensor: Sensor, effects: Selection) -> float:
    dark = effects.part(CountedDark)
    return 0.0 if dark is None else float(dark.per_s(sensor, 0, _PIXELS).mean())


def _variance_e2(electrons: Values, gain: Values, sensor: Sensor, effects: Selection) -> Values:
    """Of the estimate, in square electrons on PIX."""
    found = np.full(electrons.shape, sensor.electrons_per_lsb**2 / 12.0)
    converter = effects.part(Converter)
    if converter is not None:
        found += (converter.sigma_lsb(sensor) * sensor.electrons_per_lsb) ** 2
    times = {"reads": _READS, "words": _WORDS, "resets": 0}
    for _, errors in effects.errors():
        found += times[errors.at] * errors.sigma_e(sensor) ** 2
    found /= gain**2
    if effects.part(CountedLight) is not None:
        found += electrons
    response = effects.part(Response)
    if response is not None:
        found += (float(response.factor(sensor, 0, _PIXELS).std()) * electrons) ** 2
    return found


def merged_image(light: Values, deviation: Values) -> Values:
    """One light (rows, cols) of all buckets, each weighted by what it knows; where every one was
    full, the greatest."""
    with np.errstate(divide="ignore", invalid="ignore"):
        weight = np.nan_to_num(1.0 / deviation**2, nan=0.0, posinf=0.0)
    known = weight.sum(axis=0)
    mean = (np.nan_to_num(light) * weight).sum(axis=0) / np.where(known > 0, known, 1.0)
    least = np.nan_to_num(np.fmax.reduce(light, axis=0))
    return np.asarray(np.where(known > 0, mean, least))


def image_of(frame: Path) -> NDArray[np.float32]:
    """What `nscc reconstruct FRAME` writes: electrons over the frame (rows, cols), from the light
    that the frame file has; of repeats, their mean.

    Raises Rejected (NS0819, status 2) for a file that is no frame whose pixels looked.
    """
    try:
        with np.load(frame, allow_pickle=False) as file:
            arrays: Mapping[str, Any] = {key: file[key] for key in (LIGHT, DEVIATION)}
            meta = json.loads(str(file["meta"]))
        frame_s = float(meta["frame_us"]) * 1e-6
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise rejected(
            "NS0819",
            f"'{frame.as_posix()}' says no light by itself: it is no frame file of a program whose "
            "pixels look at the light",
            notes=(f"{type(error).__name__}: {error}",),
            helps=("name the run that the frame was taken for: `nscc reconstruct RUN FRAME.npz`",),
        ) from None
    light, deviation = arrays[LIGHT], arrays[DEVIATION]
    if light.ndim == 3:
        light, deviation = light[None], deviation[None]
    images = [merged_image(*each) for each in zip(light, deviation, strict=True)]
    return np.asarray(np.mean(images, axis=0) * frame_s, np.float32)
