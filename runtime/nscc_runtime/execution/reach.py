"""How far the registers of a program may go from zero: for light, and for what is not light.

The words run forwards over some lanes. What registers hold hangs linearly on the charge of each
stretch of slots between words, on the fixed error of a word, and on noise.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects import Selection
from nscc_runtime.effects.parts import WordGain
from nscc_runtime.execution.tables import Tables
from nscc_runtime.reference.trace import AnalogWord
from nscc_runtime.reference.weights import error_sign

Values = NDArray[np.float64]

_MOST_LANES = 64
_MOST_STRETCHES = 128
_SIGMAS = 6.0
_KINDS = 2
"""Of what registers hold of the slots: as a rule the light of open ones, and that of closed ones,
which is taken away again."""
_ROUNDING = 1e-9


@dataclass(frozen=True, eq=False)
class Reach:
    """What registers hold is at most what one of the `held` (kinds, N, lanes) makes of the slots'
    charge, and they stay in their linear range as long as each of these is below its `least_e`
    (kinds, lanes), 0 where noise alone may take them out of it; without `held` as long as what PIX
    has seen is below it."""

    held: Values | None
    least_e: Values


def reach_of(tables: Tables, kept: Selection, linear_e: float) -> Reach:
    """The reach of a program with the noise of the effects in `kept`, where registers are linear
    up to `linear_e`; the same on every call."""
    lanes, slots = len(tables.container.encoding), tables.container.slots
    some = np.unique(np.linspace(0, lanes - 1, min(lanes, _MOST_LANES)).astype(np.intp))
    ends = np.unique([word.boundary for word in tables.decayed])
    shown = np.unique(np.linspace(0, len(ends) - 1, min(len(ends), _MOST_STRETCHES)).astype(int))
    found = _farthest(tables, some, ends[shown], kept, linear_e)
    if len(some) < lanes or len(shown) < len(ends):
        # Only some lanes or stretches are known.
        return Reach(None, np.full((1, lanes), found.least.min() / found.most))
    of_slot = np.searchsorted(ends, np.arange(slots), side="right")
    weights = np.append(found.held, np.zeros((*found.least.shape, 1)), axis=2)
    return Reach(np.moveaxis(weights[:, :, of_slot], 1, 2), found.least)


def _farthest(
    tables: Tables, some: NDArray[np.intp], ends: NDArray[np.int64], kept: Selection,
    linear_e: float,
) -> _Found:  # fmt: skip
    """What is found of some lanes, and of the stretches of slots that end at some boundaries."""
    part, sensor = kept.part(WordGain), tables.program.sensor
    error_e = (part.mean_e(sensor), part.spread_e(sensor)) if part else (0.0, 0.0)
    state = _State(tables, len(some), len(ends), kept)
    held, least = np.zeros((_KINDS, len(some), len(ends))), np.full((_KINDS, len(some)), np.inf)
    found, at = _Found(linear_e, error_e, held, least), -1
    for word in tables.decayed:
        state.held[:, state.pix, :-1][:, (ends > at) & (ends <= word.boundary)] = 1.0
        at, here = word.boundary, word.lanes[some]
        if word.resets:
            state.reset(here)
        elif here.any():
            state.execute(word, here)
            for row in map(state.names.index, word.op.destinations):
                lit, fixed = state.held[:, row, :-1], state.held[:, row, -1]
                found.add(here, lit, fixed, np.sqrt(state.covariance[:, row, row]))
    return found


class _State:
    """What registers, PIX and its reset level hold: `held` (lanes, rows, columns) of the charge of
    each stretch and, last, of the fixed error; and the `covariance` (lanes, rows, rows) of their
    noise."""

    def __init__(self, tables: Tables, lanes: int, stretches: int, kept: Selection) -> None:
        self._container, sensor = tables.container, tables.program.sensor
        self.names = (*self._container.target.analog_registers, "IN", "PIX", "level")
        self.pix, self._level = len(self.names) - 2, len(self.names) - 1
        self.held = np.zeros((lanes, len(self.names), stretches + 1))
        self.covariance = np.zeros((lanes, len(self.names), len(self.names)))
        gain = kept.part(WordGain)
        # Plans may leave a gain below 1 out.
        self._gain = max(1.0, gain.gain(sensor)) if gain else 1.0
        self._variance = {"reads": 0.0, "resets": 0.0, "words": 0.0}
        for _, errors in kept.errors():
            self._variance[errors.at] += errors.sigma_e(sensor) ** 2

    def reset(self, here: NDArray[np.bool_]) -> None:
        """PIX is reset in these lanes."""
        self._write(np.flatnonzero(here), [self.pix, self._level], np.zeros(len(self.names)), 0.0)
        self.covariance[here, self._level, self._level] = self._variance["resets"]

    def execute(self, word: AnalogWord, here: NDArray[np.bool_]) -> None:
        """One bus word, in these lanes."""
        part = -self._gain / word.op.operation.divisor
        total = np.zeros(len(self.names))
        for name in word.op.sources:
            total[self.names.index(name)] += part
            total[self._level] += part if name == "PIX" else 0.0
        rows = [self.names.index(name) for name in word.op.destinations]
        # One read, whatever is written.
        read = part**2 * self._variance["reads"] if "PIX" in word.op.sources else 0.0
        lanes = np.flatnonzero(here)
        self._write(lanes, rows, total, read)
        for name, row in zip(word.op.destinations, rows, strict=True):
            self.held[lanes, row, -1] += error_sign(name, self._container)
            self.covariance[lanes, row, row] += self._variance["words"]

    def _write(
        self, lanes: NDArray[np.intp], rows: list[int], total: Values, variance: float
    ) -> None:
        """Some rows become the sum of all, so much of each, with noise of a variance beside."""
        held, beside = total @ self.held[lanes], total @ self.covariance[lanes]
        for row in rows:
            self.held[lanes, row] = held
            self.covariance[lanes, row] = self.covariance[lanes, :, row] = beside
        own = beside @ total + variance
        for row in rows:
            self.covariance[lanes[:, None], row, rows] = own[:, None]


@dataclass(eq=False)
class _Found:
    """What `Reach` has, of the registers that were written so far: `held` (kinds, lanes,
    stretches). `error_e`: mean and spread of the fixed error."""

    linear_e: float
    error_e: tuple[float, float]
    held: Values
    least: Values

    @property
    def most(self) -> float:
        """The largest part of a charge that a register holds: 1 if nothing counts twice."""
        return max(1.0, float(self.held.max(initial=0.0)))

    def add(self, here: NDArray[np.bool_], lit: Values, fixed: Values, sigma: Values) -> None:
        """A register is written in the lanes that are `here`: with so much (lanes, stretches) of
        their charge and of the fixed error, and noise of this standard deviation."""
        mean_e, spread_e = self.error_e
        one, other = (fixed * (mean_e + side * _SIGMAS * spread_e) for side in (-1.0, 1.0))
        above = self.linear_e - np.maximum(one, other) - _SIGMAS * sigma
        below = self.linear_e + np.minimum(one, other) - _SIGMAS * sigma
        least = np.where((lit > _ROUNDING).any(axis=1), above, np.inf)
        least = np.minimum(least, np.where((lit < -_ROUNDING).any(axis=1), below, np.inf))
        least = np.where((above < 0) | (below < 0), 0.0, least)
        self._hold(here, np.abs(lit), least)

    def _hold(self, left: NDArray[np.bool_], size: Values, least: Values) -> None:
        """Add what is held to the first kind that has no less of any stretch, or no more; to the
        last one if there is none."""
        for kind in range(_KINDS):
            held = self.held[kind]
            more, less = (size <= held + _ROUNDING).all(axis=1), (held <= size).all(axis=1)
            here = left & (more | less | (kind == _KINDS - 1))
            self.held[kind] = np.where(here[:, None], np.maximum(held, size), held)
            self.least[kind] = np.where(here, np.minimum(self.least[kind], least), self.least[kind])
            left = left & ~here
