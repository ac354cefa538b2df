"""Replays words over every code at once, exactly as a pixel of each code would run them.

Digital registers are truth vectors over the lanes (one lane a distinct code), analog registers
float64 arrays (lanes, lights): several lights are carried side by side. Meaning comes from
`nscc.words.operations`, as it does for the emulator, but no line of code is shared with it.

What a real pixel leaves open is filled with noise from a fixed seed: what registers, FLAG and PIX
hold when the first frame starts, the reset level, what SELECT and IN read. A program whose result
hangs on any of it does not prove.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nscc.logic.truth import columns, members
from nscc.prove.noise import Noise
from nscc.target.model import Target
from nscc.words.container import Container
from nscc.words.operations import Effect, Op, Phase

Lights = NDArray[np.float64]


class Faded(Exception):
    """A digital register was read after its bit had decayed: the register and where."""

    def __init__(self, register: str, frame: int, boundary: int) -> None:
        super().__init__(register, frame, boundary)
        self.register = register
        self.frame = frame
        self.boundary = boundary


@dataclass
class Replay:
    """The pixels of all codes, and the words that they run, over consecutive frames.

    `kernels` are decoded words. `exposures` runs one frame and leaves the state for the next.
    `quiet` starts analog state at zero instead of noise.
    """

    container: Container
    kernels: Sequence[Sequence[Op]]
    lights: int
    seed: int = 20201
    quiet: bool = False

    def __post_init__(self) -> None:
        container = self.container
        target = container.target
        self.target: Target = target
        self.lanes = len(container.encoding)
        self.everything = (1 << self.lanes) - 1
        self._random = Noise(self.seed)
        self._reset_level = self._noise()
        self.pix = self._noise()
        self.analog = {name: self._noise() for name in target.analog_registers}
        self.digital = {name: self._bits() for name in target.digital_registers}
        encoded = columns(container.encoding)
        column = {name: i for i, name in enumerate(target.digital_registers)}
        self.code = {name: encoded[column[name]] for name in container.code_registers}
        self.digital.update(self.code)
        self._sources = {"SELECT": self._bits()}
        self._inputs = {"IN": self._noise()}
        self.flag = self._bits()
        self._bus = 0
        self._where: tuple[int, NDArray[np.intp] | slice] = (0, slice(0, 0))
        self._written_us = dict.fromkeys(target.digital_registers, 0.0)
        self._written_us["FLAG"] = 0.0
        self._now_us = 0.0
        self._place = (0, 0)

    def exposures(self, light: Lights) -> dict[str, Lights]:
        """Runs one frame; light (N, lights) is in electrons a slot.

        Returns, by bucket, the exposure in electrons (lanes, lights). Raises Faded where a register
        is read later than the target's retention after its last write.
        """
        container = self.container
        frame_start_us = self._now_us
        boundary_us = np.concatenate(([0.0], np.cumsum(container.slot_us)))
        launches = iter([*container.launches, None])
        launch = next(launches)
        frame = self._place[0] + 1
        for boundary in range(container.slots + 1):
            self._now_us = frame_start_us + float(boundary_us[boundary])
            self._place = (frame, boundary)
            while launch is not None and launch.instant == boundary:
                for word in self.kernels[launch.kernel]:
                    self._run(word)
                launch = next(launches)
            if boundary < container.slots:
                self.pix += light[boundary]
        self._now_us += self.target.readout_us * len(container.readouts)
        return {r.bucket: self.analog[r.register] * r.gain for r in container.readouts}

    @property
    def code_kept(self) -> bool:
        """Whether the code registers hold what they held when the first frame started."""
        return all(self.digital[name] == vector for name, vector in self.code.items())

    def _noise(self) -> Lights:
        if self.quiet:
            return np.zeros((self.lanes, self.lights))
        return self._random.levels(self.lanes, self.lights)

    def _bits(self) -> int:
        return self._random.bits(self.lanes)

    def _run(self, word: Op) -> None:
        row = word.operation
        match row.effect:
            case Effect.NONE:
                pass
            case Effect.RESET_PIX:
                if self.target.reset_honours_flag == "no":
                    self.pix[:] = self._reset_level
                else:
                    where = self._flagged()
                    self.pix[where] = self._reset_level[where]
            case Effect.BUS:
                where = self._flagged()
                value = self._total(word, where)
                for name in word.destinations:
                    self.analog[name][where] = value / -row.divisor
            case Effect.FLAG_ALL:
                self._set_flag(self.everything)
            case Effect.FLAG_ANALOG:
                positive = self._total(word, slice(None))[:, :1] > 0
                chosen = columns(positive)[0]
                # Where `where` obeys FLAG, pixels that were masked stay masked.
                self._set_flag(chosen & self.flag if self.target.where_obeys_flag else chosen)
            case Effect.FLAG_DIGITAL:
                self._set_flag(self._some(word))
            case Effect.DIGITAL:
                self._digital(word)

    def _digital(self, word: Op) -> None:
        row = word.operation
        if row.phase is Phase.WRITE:
            value = self._bus
        else:
            value = self._some(word)
            if row.inverted:
                value ^= self.everything
            if row.phase is Phase.READ:
                self._bus = value
                return
        mask = self.digital.get(self.target.mask_register or "", self.everything)
        for name in word.destinations:
            if name != self.target.masked_register:
                self.digital[name] = value
                self._written_us[name] = self._now_us
            else:
                self._read_check(self.target.mask_register or name)
                self.digital[name] = (self.digital[name] & ~mask) | (value & mask)
                if mask == self.everything:
                    self._written_us[name] = self._now_us

    def _some(self, word: Op) -> int:
        value = 0
        for name in word.sources:
            if name == "FLAG":
                self._read_check(name)
                value |= self.flag
            elif name in self._sources:
                value |= self._sources[name]
            else:
                self._read_check(name)
                value |= self.digital[name]
        return value

    def _total(self, word: Op, where: NDArray[np.intp] | slice) -> Lights:
        total: Lights | None = None
        for name in word.sources:
            if name == "PIX":
                source = self.pix
            else:
                source = self._inputs.get(name, self.analog.get(name, self.pix))
            total = source[where] if total is None else total + source[where]
        return np.zeros((1, self.lights)) if total is None else total

    def _set_flag(self, vector: int) -> None:
        self.flag = vector
        self._written_us["FLAG"] = self._now_us

    def _flagged(self) -> NDArray[np.intp] | slice:
        """Lanes whose FLAG is 1, as an index; cached while FLAG does not change."""
        self._read_check("FLAG")
        if self._where[0] != self.flag or self._where[0] == 0:
            if self.flag == self.everything:
                self._where = (self.flag, slice(None))
            else:
                self._where = (self.flag, members(self.flag, self.lanes))
        return self._where[1]

    def _read_check(self, name: str) -> None:
        if self._now_us - self._written_us[name] > self.target.digital_retention_us:
            raise Faded(name, *self._place)


# Slots whose light is told apart in one float64: powers of four from 1 to 4^23, so that weights of
# -1, 0, 1 and 2 a slot are exact.
_SLOTS_A_LIGHT = 24


def shutters(container: Container, kernels: Sequence[Sequence[Op]]) -> NDArray[np.bool_] | None:
    """S[n] of every lane, (lanes, buckets, slots), found by replaying the words with light in one
    slot at a time; None where a slot's weight in an exposure is neither 0 nor 1.

    Lanes are the rows of `container.encoding`.
    """
    slots = container.slots
    lights = -(-slots // _SLOTS_A_LIGHT)
    light = np.zeros((slots, lights))
    numbers = np.arange(slots)
    light[numbers, numbers // _SLOTS_A_LIGHT] = 4.0 ** (numbers % _SLOTS_A_LIGHT)
    # A reset level of zero keeps the sums exact; that programs subtract it is the proof's business.
    replay = Replay(container, kernels, lights, quiet=True)
    measured = replay.exposures(light)
    found = np.zeros((replay.lanes, len(container.buckets), slots), dtype=np.bool_)
    for index, bucket in enumerate(container.buckets):
        value = measured[bucket]
        for digit in range(_SLOTS_A_LIGHT):
            weight = np.rint(value) % 4
            if not np.isin(weight, (0, 1)).all():
                return None
            columns_ = slice(digit, None, _SLOTS_A_LIGHT)
            found[:, index, columns_] = weight[:, : len(range(*columns_.indices(slots)))] == 1
            value = (value - weight) / 4
        if np.any(value != 0):
            return None
    return found
