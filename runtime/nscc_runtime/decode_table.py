"""What a frame file says of its pixels' shutters: enough to get from a frame back to light.

An exposure is, as long as nothing saturates, bias + sum over slots of gain * shutter * light, and
noise. All three depend on a pixel by its shutter alone, and the words tell how.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.diagnostics.diagnostic import Rejected
from nscc.words.container import Container
from nscc_runtime.effects import Selection, everything
from nscc_runtime.effects.parts import (
    Converter,
    CountedDark,
    CountedLight,
    Errors,
    Leak,
    LitLevel,
    Part,
    SlowWords,
    WordGain,
)
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.frame_file import FrameFile
from nscc_runtime.reference.trace import analog_words
from nscc_runtime.reference.weights import Backward, Weights, backward

_KNOWN: tuple[type[Part], ...] = (
    Converter, CountedDark, CountedLight, Errors, Leak, LitLevel, SlowWords, WordGain,
)  # fmt: skip
"""What is told from the words, or is the reader's to know; of others the plan says how large."""
_PLACES = np.arange(1024, dtype=np.int64)


def with_table(file: FrameFile, container: Container) -> FrameFile:
    """The file with the arrays that decoders need, as its meta says that it was exposed."""
    arrays = decode_arrays(container, Sensor(file.meta["sensor"]), file.meta["plan"])
    return replace(file, kept={**file.kept, **arrays})


def decode_arrays(
    container: Container, sensor: Sensor, plan: Mapping[str, Any] | None
) -> dict[str, NDArray[Any]]:
    """The arrays by their keys in a frame file; none where pixels have no codes, or where words
    open no shutters that codes alone tell, as those of pixels that look.

    `decode_row` (rows, cols): which shutter a pixel has, a row of the others; `decode_shutter`
    uint8 (shutters, buckets, ceil(N / 8)), packed along N, the first slot in the lowest bit;
    `decode_slot_us` float64 (N,); `decode_gain`, `decode_bias_e` and `decode_variance_e2` float32
    (shutters, buckets): an exposure is bias + gain * (sum of the light of open slots), with that
    variance and the photons' own, of an exposure's size where they are counted.
    `plan` as in a frame's meta: None for frames of a chip, which has every effect.
    """
    if container.pixel_codes is None or container.machine is not None:
        return {}
    kept = everything() if plan is None else _kept(plan)
    try:
        shutters = container.table.shutters if container.has_table else _opened(container)
        response = _response(container, shutters, sensor, kept)
    except Rejected:
        return {}
    lanes = container.table.shutter_of_code[container.pixel_codes]
    used, row = np.unique(lanes, return_inverse=True)
    flat_e2 = _flat_e2(sensor, kept, plan)
    small = next(t for t in (np.uint8, np.uint16, np.uint32) if len(used) - 1 <= np.iinfo(t).max)
    # Beyond float32 a variance is infinite: such a code says nothing about the light.
    with np.errstate(over="ignore"):
        gain, bias_e, variance_e2 = (part[used].astype(np.float32) for part in response)
        variance_e2 += np.float32(flat_e2)
    return {
        "decode_row": row.reshape(lanes.shape).astype(small),
        "decode_shutter": np.packbits(shutters[used], axis=-1, bitorder="little"),
        "decode_slot_us": np.array(container.slot_us, np.float64),
        "decode_gain": gain,
        "decode_bias_e": bias_e,
        "decode_variance_e2": variance_e2,
    }


def _kept(plan: Mapping[str, Any]) -> Selection:
    """The effects that a plan kept."""
    names = frozenset(row["name"] for row in plan["effects"] if row["decision"] == "kept")
    return Selection(names & everything().on, frozenset())


def _opened(container: Container) -> NDArray[np.bool_]:
    """The shutters (shutters, buckets, N) of words without a table; NS0442 where they open none."""
    return backward(container, analog_words(container)).open().transpose(1, 2, 0)


def _response(
    container: Container, shutters: NDArray[np.bool_], sensor: Sensor, kept: Selection
) -> tuple[Weights, Weights, Weights]:
    """Mean gain over a shutter's open time, bias and variance, each (shutters, buckets)."""
    shape = shutters.shape[:2]
    if kept.noiseless:
        gains = np.array([readout.gain for readout in container.readouts])
        gains = gains if container.target.streamed else np.ones(shape[1])
        return np.broadcast_to(gains, shape), np.zeros(shape), np.zeros(shape)
    word, leak, dark = kept.part(WordGain), kept.part(Leak), kept.part(CountedDark)
    found = backward(
        container, analog_words(container), word.gain(sensor) if word else 1.0,
        1.0 / leak.tau_s(sensor) if leak else 0.0, kept.part(SlowWords) is not None,
        kept.part(LitLevel) is not None,
    )  # fmt: skip
    slot_s = np.array(container.slot_us, np.float64) * 1e-6
    open_s = shutters @ slot_s
    weighed_s = np.einsum("n,nlb->lb", slot_s, found.slots)
    gain = np.divide(weighed_s, open_s, out=np.ones(shape), where=open_s > 0)
    bias_e, variance_e2 = np.zeros(shape), np.zeros(shape)
    if dark:
        charge_e = weighed_s * float(dark.per_s(sensor, 0, _PLACES).mean())
        bias_e, variance_e2 = bias_e + charge_e, variance_e2 + charge_e
    if word:
        total = sum(found.errors.values(), np.zeros(shape))
        bias_e = bias_e + word.mean_e(sensor) * total
        variance_e2 = variance_e2 + (word.spread_e(sensor) * total) ** 2
    for _, errors in kept.errors():
        variance_e2 = variance_e2 + errors.sigma_e(sensor) ** 2 * _squares(found, errors.at, shape)
    return gain, bias_e, variance_e2


def _squares(found: Backward, at: str, shape: tuple[int, ...]) -> Weights:
    """The sum of the squared weights of independent errors at reads, resets or words."""
    parts = {"reads": found.reads, "resets": found.resets, "words": found.errors}[at]
    return sum((part**2 for part in parts.values()), np.zeros(shape))  # type: ignore[attr-defined]


def _flat_e2(sensor: Sensor, kept: Selection, plan: Mapping[str, Any] | None) -> float:
    """The variance that all shutters share: of the converter, and of what only the plan knows."""
    lsb2 = 1 / 12
    if not kept.noiseless:
        lsb2 += kept.converter_lsb(sensor) ** 2
    known = set().union(*(kept.names(kind) for kind in _KNOWN))
    others = [] if plan is None else plan["effects"]
    return lsb2 * sensor.electrons_per_lsb**2 + sum(
        (row["predicted_rms_e"] or 0.0) ** 2 for row in others
        if row["decision"] == "kept" and row["name"] not in known and row["kind"] != "after"
    )  # fmt: skip
