"""The arguments of compiled loops that depend on effects, by the field names of the loops'
records."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from nscc_runtime.effects.effect import Effect, InLoop
from nscc_runtime.effects.parts import Errors
from nscc_runtime.effects.registry import registered
from nscc_runtime.effects.selection import Selection
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.noise import key
from nscc_runtime.noise.keys import base

Record = type[Any]
"""A record class made by `nscc_runtime.loop.record`."""


def switches(record: Record, effects: Selection) -> dict[str, int]:
    """Return for each switch in `record` whether its effect is on (1 or 0)."""
    names = _names(record)
    return {
        loop.switch: int(effect in effects)
        for effect, loop in _in_loops()
        if loop.switch is not None and loop.switch in names
    }


def figures(record: Record, sensor: Sensor, effects: Selection) -> dict[str, float]:
    """Return the values of effects for the fields of `record`; 0 for effects that are off."""
    names = _names(record)
    return {
        name: figure(sensor) if effect in effects else 0.0
        for effect, loop in _in_loops()
        for name, figure in loop.numbers.items()
        if name in names
    }


def device_keys(record: Record, device_seed: int) -> dict[str, np.uint64]:
    """Return the random keys of the chip's fixed patterns for the fields of `record`."""
    names = _names(record)
    return {
        loop.device_key: key(device_seed, effect.stream) for effect, loop in _in_loops()
        if loop.device_key is not None and loop.device_key in names
    }  # fmt: skip


def draws_keys(record: Record, seed: int, source: int) -> dict[str, np.uint64]:
    """Return first halves of random keys of draws at words, for the fields of `record`."""
    keys_by_name: dict[str, np.uint64] = {
        error_part.at: base(seed, effect.stream, source)
        for effect in registered()
        for error_part in effect.parts_of_kind(Errors)
    }
    for effect, loop in _in_loops():
        if loop.draws_key is not None:
            keys_by_name[loop.draws_key] = base(seed, effect.stream, source)
    return {name: draws_key for name, draws_key in keys_by_name.items() if name in _names(record)}


def _names(record: Record) -> set[str]:
    return {name for name, *_ in record._fields_}


def _in_loops() -> Iterator[tuple[Effect, InLoop]]:
    for effect in registered():
        if isinstance(effect.words, InLoop):
            yield effect, effect.words
