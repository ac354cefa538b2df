"""The inputs of compiled loops that depend on effects, by the names of the loops' records."""

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
"""A record of `nscc_runtime.loop.record`."""


def switches(record: Record, effects: Selection) -> dict[str, int]:
    """Return whether each effect with a switch is on."""
    names = _names(record)
    return {
        loop.switch: int(effect in effects)
        for effect, loop in _in_loops()
        if loop.switch is not None and loop.switch in names
    }


def figures(record: Record, sensor: Sensor, effects: Selection) -> dict[str, float]:
    """Return the values of the effects; 0 for effects that are off."""
    names = _names(record)
    return {
        name: figure(sensor) if effect in effects else 0.0
        for effect, loop in _in_loops()
        for name, figure in loop.numbers.items()
        if name in names
    }


def device_keys(record: Record, device_seed: int) -> dict[str, np.uint64]:
    """Return the keys of fixed patterns of the chip."""
    names = _names(record)
    return {
        loop.device_key: key(device_seed, effect.stream) for effect, loop in _in_loops()
        if loop.device_key is not None and loop.device_key in names
    }  # fmt: skip


def draws_keys(record: Record, seed: int, source: int) -> dict[str, np.uint64]:
    """Return the keys of draws at words: of small errors by their source, and of other draws."""
    found: dict[str, np.uint64] = {
        part.at: base(seed, effect.stream, source)
        for effect in registered()
        for part in effect.parts(Errors)
    }
    for effect, loop in _in_loops():
        if loop.draws_key is not None:
            found[loop.draws_key] = base(seed, effect.stream, source)
    return {name: each for name, each in found.items() if name in _names(record)}


def _names(record: Record) -> set[str]:
    return {name for name, *_ in record._fields_}


def _in_loops() -> Iterator[tuple[Effect, InLoop]]:
    for effect in registered():
        if isinstance(effect.words, InLoop):
            yield effect, effect.words
