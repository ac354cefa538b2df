"""The arrays of a frame file that describe the shutters of its pixels, for computing light from a
frame.

Without saturation, an exposure is bias + sum over slots of gain * shutter * light, and noise. All
three depend only on the pixel's shutter and follow from the words (`nscc_runtime.response`)."""

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
from nscc_runtime.response import converter_e2, open_shutters, shutter_response

_KNOWN: tuple[type[Part], ...] = (
    Converter, CountedDark, CountedLight, Errors, Leak, LitLevel, SlowWords, WordGain,
)  # fmt: skip
"""Kinds of effects whose variance follows from the words, or is known to the reader. The plan
states the size of other effects."""


def with_table(file: FrameFile, container: Container) -> FrameFile:
    """Return the file with the arrays that decoders need."""
    arrays = decode_arrays(container, Sensor(file.meta["sensor"]), file.meta["plan"])
    return replace(file, kept_arrays={**file.kept_arrays, **arrays})


def decode_arrays(
    container: Container, sensor: Sensor, plan: Mapping[str, Any] | None
) -> dict[str, NDArray[Any]]:
    """Return the arrays that decoders need, by their keys in a frame file.

    They are empty if pixels have no codes, if pixels look, or if the words open no shutters.
    `decode_row` (rows, cols): the shutter of each pixel, as a row of the other arrays.
    `decode_shutter` uint8 (shutters, buckets, ceil(N / 8)): packed along N, the first slot in the
    lowest bit. `decode_slot_us` float64 (N,): slot lengths. `decode_gain`, `decode_bias_e`,
    `decode_variance_e2` float32 (shutters, buckets): an exposure is bias + gain * (sum of the light
    of open slots), with this variance plus the variance of photon counts. `plan`: the plan in a
    frame's meta; None for frames of a chip, which has every effect."""
    if container.pixel_codes is None or container.machine is not None:
        return {}
    kept_effects = everything() if plan is None else _kept_selection(plan)
    try:
        shutters = open_shutters(container)
        response = shutter_response(container, sensor, kept_effects)
    except Rejected:
        return {}
    lanes = container.table.shutter_of_code[container.pixel_codes]
    used, row = np.unique(lanes, return_inverse=True)
    small = next(t for t in (np.uint8, np.uint16, np.uint32) if len(used) - 1 <= np.iinfo(t).max)
    gain = response.gain(shutters @ container.slot_s)
    variance_e2 = (
        response.variance_e2 + converter_e2(sensor, kept_effects) + _planned_e2(kept_effects, plan)
    )
    # Beyond float32 a variance is infinite: such a code says nothing about the light.
    with np.errstate(over="ignore"):
        tables = [
            values[used].astype(np.float32) for values in (gain, response.bias_e, variance_e2)
        ]
    return {
        "decode_row": row.reshape(lanes.shape).astype(small),
        "decode_shutter": np.packbits(shutters[used], axis=-1, bitorder="little"),
        "decode_slot_us": np.array(container.slot_us, np.float64),
        "decode_gain": tables[0],
        "decode_bias_e": tables[1],
        "decode_variance_e2": tables[2],
    }


def _kept_selection(plan: Mapping[str, Any]) -> Selection:
    names = frozenset(row["name"] for row in plan["effects"] if row["decision"] == "kept")
    return Selection(names & everything().on, frozenset())


def _planned_e2(kept_effects: Selection, plan: Mapping[str, Any] | None) -> float:
    """Return the variance of effects whose size only the plan states, in square electrons."""
    known = set().union(*(kept_effects.names(kind) for kind in _KNOWN))
    plan_effects = [] if plan is None else plan["effects"]
    return sum(
        (row["predicted_rms_e"] or 0.0) ** 2 for row in plan_effects
        if row["decision"] == "kept" and row["name"] not in known and row["kind"] != "after"
    )  # fmt: skip
