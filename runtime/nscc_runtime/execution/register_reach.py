"""The charge with which the registers of a program leave their linear range.

The words run forwards over some lanes. Register values are linear functions of the charge of each
interval of slots, of the fixed error of a word, and of noise. An interval ends at each boundary at
which an analog word runs, whatever the word does and in whichever lane.

Registers that leak subtract less of the charge from before a shutter opened. So the words run at
the lowest and at the highest leakage rate of the pixels that sums expose, and the larger charge
counts."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from nscc.arrays import Bools, Floats, Indices, Ints
from nscc_runtime.effects import Selection
from nscc_runtime.effects.parts import Soft, WordGain
from nscc_runtime.execution.moments import even_leak_rates
from nscc_runtime.execution.program import AnalysedProgram
from nscc_runtime.reference.trace import AnalogWord
from nscc_runtime.reference.weights import error_sign

_MOST_LANES = 64
_MOST_INTERVALS = 128
"""Largest numbers of lanes and of intervals that are followed; of more, a sample is."""
_SIGMAS = 4.0
"""Number of standard deviations by which noise may move a register. Errors may be larger: what lies
beyond has a mean of 7e-6 standard deviations, and a root mean square of 1.8e-3 of them."""
_KINDS = 2
"""Number of kinds of register content, usually light of open slots and light subtracted later."""
_ROUNDING = 1e-9
"""Weights that differ by less are equal; their differences are rounding errors."""
_ALIKE = 0.05
"""A register joins a kind if this adds at most this part to the weights. The larger weights count,
so this decides only how tight the bound is: gains and leakage leave parts of subtracted charge."""


@dataclass(frozen=True, eq=False)
class RegisterReach:
    """The charge up to which registers stay in their linear range.

    `charge_weights` (kinds, N, lanes): largest weights of the slots' charge in any register.
    Registers stay linear while the charge weighted by each of them is below `least_e` (kinds,
    lanes), which is 0 where noise alone may leave the range. If `charge_weights` is None, `least_e`
    limits the charge that PIX (the photodiode) has collected. A lane is the pixels of one distinct
    shutter."""

    charge_weights: Floats | None
    least_e: Floats


def reach_of(program: AnalysedProgram, effects: Selection) -> RegisterReach:
    """Return the charge up to which a program's registers stay in their linear range, with the
    words, gains, leakage and noise that `effects` give them; cached with the program.

    `effects` include one that saturates registers. With more than `_MOST_LANES` lanes or
    `_MOST_INTERVALS` intervals, only a sample evenly spread over them is followed, and the worst of
    it counts for all. A lane is the pixels of one distinct shutter."""
    return program.recent.of((RegisterReach, effects.on), lambda: _reach_of(program, effects))


def _reach_of(program: AnalysedProgram, effects: Selection) -> RegisterReach:
    """Return the charge with which registers of `program` leave their linear range under
    `effects`."""
    lanes, slots = len(program.container.encoding), program.container.slots
    sampled_lanes = np.unique(np.linspace(0, lanes - 1, min(lanes, _MOST_LANES)).astype(np.intp))
    ends = np.unique([word.boundary for word in program.words(program.model(effects))])
    shown = np.unique(np.linspace(0, len(ends) - 1, min(len(ends), _MOST_INTERVALS)).astype(int))
    register_reach = _farthest(program, effects, sampled_lanes, ends[shown])
    if len(sampled_lanes) < lanes or len(shown) < len(ends):
        # Only some lanes or intervals are known.
        return RegisterReach(
            None, np.full((1, lanes), register_reach.least.min() / register_reach.most)
        )
    # The interval of each slot; slots after the last word get the appended column of zeros.
    of_slot = np.searchsorted(ends, np.arange(slots), side="right")
    # One lane after the other for each leakage rate.
    weights = register_reach.charge_weights.reshape(_KINDS, -1, lanes, len(ends)).max(axis=1)
    weights = np.append(weights, np.zeros((_KINDS, lanes, 1)), axis=2)
    least = register_reach.least.reshape(_KINDS, -1, lanes).min(axis=1)
    return RegisterReach(np.moveaxis(weights[:, :, of_slot], 1, 2), least)


def _farthest(
    program: AnalysedProgram, effects: Selection, sampled_lanes: Indices, ends: Ints
) -> _RegisterReach:
    """Run the words over the lanes with the numbers `sampled_lanes`, at each leakage rate, and
    return how far the written registers are from the ends of their linear range: of all lanes at
    the lowest rate, then of all at the highest. Intervals of slots end at the boundaries `ends`,
    ascending. A lane is the pixels of one distinct shutter."""
    sensor, rates = program.sensor, even_leak_rates(program, effects)
    gain_part, linear_e = effects.find_part(WordGain), effects.require_part(Soft).linear_e(sensor)
    error_e = (gain_part.mean_e(sensor), gain_part.spread_e(sensor)) if gain_part else (0.0, 0.0)
    lanes, per_s = np.tile(sampled_lanes, len(rates)), np.repeat(rates, len(sampled_lanes))
    state = _RegisterState(program, effects, len(lanes), len(ends))
    charge_weights = np.zeros((_KINDS, len(lanes), len(ends)))
    least = np.full((_KINDS, len(lanes)), np.inf)
    reach, at = _RegisterReach(linear_e, error_e, charge_weights, least), -1
    start_s = np.concatenate(([0.0], np.cumsum(program.slot_s)))
    for word in program.words(program.model(effects)):
        if word.boundary > at:
            state.charge_weights[:, state.pix, :-1][:, (ends > at) & (ends <= word.boundary)] = 1.0
            state.leak(np.exp(-per_s * (start_s[word.boundary] - start_s[max(at, 0)])))
            at = word.boundary
        in_lane = word.lanes[lanes]
        if word.resets:
            state.reset(in_lane)
        elif in_lane.any():
            state.execute(word, in_lane)
            for row in map(state.names.index, word.op.destinations):
                lit, fixed = state.charge_weights[:, row, :-1], state.charge_weights[:, row, -1]
                reach.add(in_lane, lit, fixed, np.sqrt(state.covariance[:, row, row]))
    return reach


class _RegisterState:
    """The contents of registers, PIX and its reset level, as linear functions.

    `charge_weights` (lanes, rows, columns): weights of the charge of each interval and, in the last
    column, of the fixed error. `covariance` (lanes, rows, rows): covariance of their noise. A lane
    is the pixels of one distinct shutter."""

    def __init__(
        self, program: AnalysedProgram, effects: Selection, lanes: int, intervals: int
    ) -> None:
        """Begin with all registers at 0, without noise, for this number of `lanes` and of
        `intervals`. Words have the gains, and their errors the variances, that `effects` give."""
        self._container, self._model = program.container, program.model(effects)
        self.names = (*self._container.target.analog_registers, "IN", "PIX", "level")
        self.pix, self._level = len(self.names) - 2, len(self.names) - 1
        self.charge_weights = np.zeros((lanes, len(self.names), intervals + 1))
        self.covariance = np.zeros((lanes, len(self.names), len(self.names)))
        self._variance = {"reads": 0.0, "resets": 0.0, "words": 0.0}
        for _, errors in effects.errors():
            self._variance[errors.at] += errors.sigma_e(program.sensor) ** 2

    def leak(self, remaining: Floats) -> None:
        """Multiply the contents of analog registers by `remaining` (lanes,). A lane is the pixels
        of one distinct shutter."""
        registers = slice(len(self._container.target.analog_registers))
        self.charge_weights[:, registers] *= remaining[:, None, None]
        self.covariance[:, registers] *= remaining[:, None, None]
        self.covariance[:, :, registers] *= remaining[:, None, None]

    def reset(self, in_lane: Bools) -> None:
        """Reset PIX (the photodiode) in the lanes (the pixels of one distinct shutter each) of the
        mask `in_lane` (lanes,): its charge becomes 0, and its reset level has the variance of a
        reset, independent of everything before."""
        self._write(
            np.flatnonzero(in_lane), [self.pix, self._level], np.zeros(len(self.names)), 0.0
        )
        self.covariance[in_lane, self._level, self._level] = self._variance["resets"]

    def execute(self, word: AnalogWord, in_lane: Bools) -> None:
        """Run the bus word `word` in the lanes (the pixels of one distinct shutter each) of the
        mask `in_lane` (lanes,): update weights and covariance of its destinations, with the errors
        of reading PIX (the photodiode) and of the word itself."""
        gain = self._model.gain if word.adds else self._model.move_gain
        source_factor = -gain / word.op.operation.divisor
        total = np.zeros(len(self.names))
        for name in word.op.sources:
            total[self.names.index(name)] += source_factor
            total[self._level] += source_factor if name == "PIX" else 0.0
        rows = [self.names.index(name) for name in word.op.destinations]
        # PIX is read once, for any number of destinations.
        read = source_factor**2 * self._variance["reads"] if "PIX" in word.op.sources else 0.0
        lanes = np.flatnonzero(in_lane)
        self._write(lanes, rows, total, read)
        for name, row in zip(word.op.destinations, rows, strict=True):
            self.charge_weights[lanes, row, -1] += error_sign(name, self._container) * word.adds
            own = 1.0 if word.adds else self._model.move_noise**2
            self.covariance[lanes, row, row] += own * self._variance["words"]

    def _write(self, lanes: Indices, rows: list[int], total: Floats, variance: float) -> None:
        """Set the registers `rows` in the lanes `lanes` (their numbers) to the sum of all rows with
        the weights `total` (rows,), plus noise of this `variance` (e^2), the same in all `rows`. A
        lane is the pixels of one distinct shutter."""
        new_weights = total @ self.charge_weights[lanes]
        new_covariance = total @ self.covariance[lanes]
        for row in rows:
            self.charge_weights[lanes, row] = new_weights
            self.covariance[lanes, row] = self.covariance[lanes, :, row] = new_covariance
        own_variance = new_covariance @ total + variance
        for row in rows:
            self.covariance[lanes[:, None], row, rows] = own_variance[:, None]


@dataclass(eq=False)
class _RegisterReach:
    """The charge up to which the registers that were written so far stay in their linear range, as
    in `RegisterReach`.

    `linear_e`: end of that range, in electrons. `error_e`: mean and spread of the fixed error.
    `charge_weights` (kinds, lanes, intervals): largest weights of an interval's charge; 0 before
    the first register. `least` (kinds, lanes): the charge in electrons; infinite before. A lane is
    the pixels of one distinct shutter."""

    linear_e: float
    error_e: tuple[float, float]
    charge_weights: Floats
    least: Floats

    @property
    def most(self) -> float:
        """The largest weight of a charge in a register, at least 1."""
        return max(1.0, float(self.charge_weights.max(initial=0.0)))

    def add(self, lanes: Bools, lit: Floats, fixed: Floats, sigma: Floats) -> None:
        """Take a written register into account.

        `lanes`: mask (lanes,) of the lanes (the pixels of one distinct shutter each) that write it.
        `lit` (lanes, intervals), `fixed` (lanes,): weights of charge and of the fixed error in it.
        `sigma` (lanes,): standard deviation of its noise, in electrons."""
        mean_e, spread_e = self.error_e
        low_e, high_e = (fixed * (mean_e + side * _SIGMAS * spread_e) for side in (-1.0, 1.0))
        above = self.linear_e - np.maximum(low_e, high_e) - _SIGMAS * sigma
        below = self.linear_e + np.minimum(low_e, high_e) - _SIGMAS * sigma
        least = np.where((lit > _ROUNDING).any(axis=1), above, np.inf)
        least = np.minimum(least, np.where((lit < -_ROUNDING).any(axis=1), below, np.inf))
        least = np.where((above < 0) | (below < 0), 0.0, least)
        size = np.abs(lit)
        # Join the first kind that then holds little more than the larger of the two, else the kind
        # that grows least.
        joined = np.maximum(self.charge_weights, size)
        total = joined.sum(axis=2)
        more = total - np.maximum(self.charge_weights.sum(axis=2), size.sum(axis=1))
        kind = np.where(more <= _ALIKE * total, 0.0, more).argmin(axis=0)
        joins = lanes & (np.arange(_KINDS)[:, None] == kind)
        self.charge_weights = np.where(joins[:, :, None], joined, self.charge_weights)
        self.least = np.where(joins, np.minimum(self.least, least), self.least)
