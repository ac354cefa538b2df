"""How far the registers of a program may go from zero: for light, and for what is not light.

The words run forwards over some lanes, many copies of each: with charge in single slots, which
shows how often a register counts it; and with noise and offsets alone, drawn at random.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects import Selection
from nscc_runtime.effects.parts import WordGain
from nscc_runtime.planner.tables import Tables
from nscc_runtime.reference.trace import AnalogWord
from nscc_runtime.reference.weights import error_sign

Values = NDArray[np.float64]

_MOST_LANES = 64
_COPIES = 32
_SIGMAS = 7.0
"""Of noise whose standard deviation is known from `_COPIES` copies only."""


@dataclass(frozen=True, eq=False)
class Reach:
    """`light`: the largest part of the charge seen by PIX that a register holds (1 for programs
    that count nothing twice). `offset_e` and `sigma_e` (lanes,): mean and standard deviation of the
    register that noise and offsets alone take farthest, every word with an error of `word_e`, more
    than that of almost all pixels.
    """

    light: float
    offset_e: Values
    sigma_e: Values
    word_e: float

    @property
    def noise_e(self) -> Values:
        """How far (lanes,) noise and offsets alone may take a register."""
        return np.asarray(self.offset_e + _SIGMAS * self.sigma_e)


def reach_of(tables: Tables, kept: Selection) -> Reach:
    """The reach of a program with the noise of the effects in `kept`; the same on every call."""
    lanes = len(tables.container.encoding)
    some = np.unique(np.linspace(0, lanes - 1, min(lanes, _MOST_LANES)).astype(np.intp))
    rng = np.random.default_rng(0)
    light, _ = _peak(tables, some, rng, None)
    offset, sigma = _peak(tables, some, rng, kept)
    if len(some) < lanes:
        worst = int(np.argmax(offset + _SIGMAS * sigma))
        offset, sigma = np.full(lanes, offset[worst]), np.full(lanes, sigma[worst])
    return Reach(max(1.0, float(light.max())), offset, sigma, abs(_word_e(tables, kept)))


def _word_e(tables: Tables, kept: Selection) -> float:
    """The fixed error of a word of the worst pixels."""
    gain, sensor = kept.part(WordGain), tables.program.sensor
    if gain is None:
        return 0.0
    mean_e = gain.mean_e(sensor)
    return mean_e + _SIGMAS * gain.spread_e(sensor) * math.copysign(1.0, mean_e)


def _peak(
    tables: Tables, some: NDArray[np.intp], rng: np.random.Generator, kept: Selection | None
) -> tuple[Values, Values]:
    """The largest value (lanes,) of any register and 0: of one electron in a random slot without
    `kept`; else mean and standard deviation of noise and offsets, where they reach farthest.
    """
    container, sensor = tables.container, tables.program.sensor
    shape = len(some), _COPIES
    registers = {name: np.zeros(shape) for name in (*container.target.analog_registers, "IN")}
    pix, level = np.zeros(shape), np.zeros(shape)
    slot = rng.integers(0, container.slots, shape)
    peak, sigma, at = np.zeros(len(some)), np.zeros(len(some)), 0
    offset = _word_e(tables, kept) if kept else 0.0
    errors: dict[str, list[float]] = {"reads": [], "resets": [], "words": []}
    for _, part in kept.errors() if kept else ():
        errors[part.at].append(part.sigma_e(sensor))

    def drawn(at: str) -> Values | float:
        return sum(sigma * rng.standard_normal(shape) for sigma in errors[at])

    for word in tables.decayed:
        if kept is None:
            pix = pix + ((slot >= at) & (slot < word.boundary))
        at = word.boundary
        here = word.lanes[some][:, None]
        if not here.any():
            continue
        if word.resets:
            pix = np.where(here, 0.0, pix)
            if errors["resets"]:
                level = np.where(here, drawn("resets"), level)
            continue
        total = _total(word, registers, pix + level)
        if "PIX" in word.op.sources:
            total = total + drawn("reads")
        for name in word.op.destinations:
            value = total / -word.op.operation.divisor
            value = value + error_sign(name, container) * (offset + drawn("words"))
            registers[name] = np.where(here, value, registers[name])
            if kept is None:
                peak = np.maximum(peak, np.abs(registers[name]).max(axis=1))
                continue
            mean, std = np.abs(registers[name].mean(axis=1)), registers[name].std(axis=1)
            farther = mean + _SIGMAS * std > peak + _SIGMAS * sigma
            peak, sigma = np.where(farther, mean, peak), np.where(farther, std, sigma)
    return peak, sigma


def _total(word: AnalogWord, registers: dict[str, Values], pix: Values) -> Values:
    total = np.zeros_like(pix)
    for name in word.op.sources:
        total = total + (pix if name == "PIX" else registers[name])
    return total
