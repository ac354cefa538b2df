"""Arguments of the loop over words that depend on effects, by the field names of its records."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache

import numpy as np

from nscc.arrays import Floats
from nscc_runtime.effects.effect import Effect, InLoop
from nscc_runtime.effects.parts import Errors
from nscc_runtime.effects.registry import of_registered, registered
from nscc_runtime.effects.selection import Selection
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.effects.views import Device, OnDevice, Places
from nscc_runtime.loop import Words
from nscc_runtime.noise.arrays import bases


@of_registered
def switches(effects: Selection) -> Mapping[str, int]:
    """Return the switches of the compiled loop by field of `Switches`: 1 if the effect to which it
    belongs is among `effects`, else 0."""
    return {
        loop.switch: int(effect in effects)
        for effect, loop in _in_loops()
        if loop.switch is not None
    }


@of_registered
def figures(sensor: Sensor, effects: Selection) -> Mapping[str, float]:
    """Return the numbers of effects that the compiled loop takes, by field of `Numbers`, with the
    values of `sensor`; 0 for effects that are not in `effects`."""
    return {
        name: figure(sensor) if effect in effects else 0.0
        for effect, loop in _in_loops()
        for name, figure in loop.numbers.items()
    }


def patterns(effects: Selection, device: Device) -> dict[str, Floats]:
    """Return the fixed patterns of effects for all pixels of the `device`, each (pixels,), by field
    of `FixedPatterns`; zeros for effects that are not in `effects`. Callers do not change them."""
    return {name: device.fixed(pattern) for name, pattern in _patterns_on(effects).items()}


@of_registered
def _patterns_on(effects: Selection) -> Mapping[str, OnDevice]:
    """Return the functions that make the fixed patterns of `patterns`, by field of
    `FixedPatterns`."""
    return {
        name: pattern if effect in effects else _none
        for effect, loop in _in_loops()
        for name, pattern in loop.patterns.items()
    }


def _none(_sensor: Sensor, _device_seed: int, places: Places) -> Floats:
    """Return the fixed pattern of an effect that is off: zeros, (pixels,)."""
    return np.zeros(len(places))


def draws_keys(seed: int, source: int) -> dict[str, np.uint64]:
    """Return the part of the random keys for errors of words that does not depend on frame and
    group (`nscc_runtime.noise.keys.base`), by field of `WordKeys`. The keys are for all effects,
    also those that are off. `seed`: of the noise. `source`: number that distinguishes uses of an
    effect's stream."""
    names, streams = _streams(registered())
    return dict(zip(names, bases(seed, streams, source), strict=True))


@lru_cache(4)
def _streams(effects: tuple[Effect, ...]) -> tuple[list[str], Words]:
    """Return the fields of `WordKeys`, and for each the random stream of its errors; `effects` are
    all that are registered."""
    streams: dict[str, int] = {
        error_part.at: effect.stream
        for effect in effects
        for error_part in effect.parts_of_kind(Errors)
    }
    streams |= {loop.draws: effect.stream for effect, loop in _in_loops() if loop.draws}
    return [*streams], np.array([*streams.values()], np.uint64)


def _in_loops() -> list[tuple[Effect, InLoop]]:
    """Return the effects that the loops over words apply, with their declarations."""
    return [(effect, effect.words) for effect in registered() if isinstance(effect.words, InLoop)]
