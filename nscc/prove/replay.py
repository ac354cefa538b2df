"""Replays words over every code at once, exactly as a pixel of each code would run them.

Digital registers are pairs of truth vectors over the lanes (one lane a distinct code), analog
registers float64 arrays (lanes, lights): several lights are carried side by side. Meaning comes
from `nscc.operations`, as it does for the emulator, but no line of code is shared with it.

What a real pixel leaves open stays open. A bit is unknown that nobody wrote, that SELECT reads,
that has decayed, or that `where` took from analog values, for it hangs on the light. An analog
value that nobody wrote is noise from a fixed seed, and so is whatever a word leaves where FLAG is
unknown. A program whose result hangs on any of it does not prove.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from math import inf

import numpy as np
from numpy.typing import NDArray

from nscc.operations import Op
from nscc.prove.interpreter import Interpreter
from nscc.prove.noise import Noise
from nscc.truth import columns, members
from nscc.words.container import Container

Lights = NDArray[np.float64]

Bits = tuple[int, int]
"""A bit of every lane: the lanes where it is known to be 1, and those where it is known to be 0."""

UNKNOWN: Bits = (0, 0)

_Lanes = NDArray[np.intp] | slice


@dataclass
class Replay(Interpreter[Bits]):
    """The pixels of all codes, and the words that they run, over consecutive frames.

    `kernels` are decoded words. `exposures` runs one frame and leaves the state for the next.
    With `quiet`, analog values that nobody wrote are zero, and what a word leaves where FLAG is
    unknown is NaN. `doubts` collects in words why bits became unknown that once were known, and
    which analog word first found FLAG unknown.
    """

    container: Container
    kernels: Sequence[Sequence[Op]]
    lights: int
    quiet: bool = False
    doubts: list[str] = field(default_factory=list)

    def __post_init__(self) -> None:
        container = self.container
        self.target = target = container.target
        self.lanes = len(container.encoding)
        self.everything = (1 << self.lanes) - 1
        self._random = Noise(_SEED)
        self._reset_level = self._noise(self.lanes)
        self.pix = self._noise(self.lanes)
        self.analog = {name: self._noise(self.lanes) for name in target.analog_registers}
        self._sources = {**self.analog, "IN": self._noise(self.lanes)}
        encoded = columns(container.encoding)
        column = {name: i for i, name in enumerate(target.digital_registers)}
        self.code: dict[str, Bits] = {}
        for name in container.code_registers:
            ones = encoded[column[name]]
            self.code[name] = (ones, self.everything & ~ones)
        self.digital: dict[str, Bits] = {
            **dict.fromkeys((*target.digital_registers, "FLAG", "SELECT", "bus"), UNKNOWN),
            **self.code,
        }
        self._split: tuple[Bits, _Lanes, _Lanes | None] = (UNKNOWN, slice(0, 0), slice(None))
        self._now_us = 0.0
        self._written_us = dict.fromkeys(self.digital, 0.0)
        self._only_loaded = set(self.digital)
        self._place = (0, 0)

    def exposures(self, light: Lights) -> dict[str, Lights]:
        """Runs one frame; light (N, lights) is in electrons a slot.

        Returns, by bucket, the exposure in electrons (lanes, lights).
        """
        container = self.container
        frame_start_us = self._now_us
        boundary_us = np.concatenate(([0.0], np.cumsum(container.slot_us)))
        gathered = np.zeros((container.slots + 1, light.shape[1]))
        np.cumsum(light, axis=0, out=gathered[1:])
        frame = self._place[0] + 1
        if frame > 1:
            # Frames follow each other for as long as the chip runs: what none of them writes fades.
            self._written_us.update(dict.fromkeys(self._only_loaded, -inf))
        boundary = 0
        for launch in container.launches:
            if launch.instant > boundary:
                self.pix += gathered[launch.instant] - gathered[boundary]
                boundary = launch.instant
            self._now_us = frame_start_us + float(boundary_us[boundary])
            self._place = (frame, boundary)
            for word in self.kernels[launch.kernel]:
                self._run(word)
        self.pix += gathered[-1] - gathered[boundary]
        self._place = (frame, container.slots)
        self._now_us = frame_start_us + float(boundary_us[-1])
        self._now_us += self.target.readout_us * len(container.readouts)
        return {r.bucket: self.analog[r.register] * r.gain for r in container.readouts}

    def prepared(self, words: Sequence[Op], in_e: Lights) -> dict[str, Lights]:
        """What analog registers hold after more words, with IN at `in_e` electrons."""
        self._sources["IN"] = in_e
        for word in words:
            self._run(word)
        return self.analog

    @property
    def code_kept(self) -> bool:
        """Whether the code registers hold what they held when the first frame started."""
        return all(self._read(name) == bits for name, bits in self.code.items())

    def _noise(self, lanes: int) -> Lights:
        if self.quiet:
            return np.zeros((lanes, self.lights))
        return self._random.levels(lanes, self.lights)

    def _bus(self, word: Op) -> None:
        where, unsure = self._flagged(word)
        value = self._total(word, where)
        for name in word.destinations:
            self.analog[name][where] = value / -word.operation.divisor
            if unsure is not None:
                self._spoil(self.analog[name], unsure)

    def _compare(self, word: Op) -> None:
        # Where `where` obeys FLAG, pixels that were masked stay masked.
        masked = self._read("FLAG")[1] if self.target.where_obeys_flag else 0
        self._write("FLAG", (0, masked))
        self._doubt(f"`{word}` makes FLAG hang on the light")

    def _reset(self, word: Op) -> None:
        if self.target.reset_honours_flag == "no":
            self.pix[:] = self._reset_level
            return
        where, unsure = self._flagged(word)
        if self.target.reset_honours_flag == "unknown":
            rest = self.everything & ~self._split[0][0]
            unsure = members(rest, self.lanes) if rest else None
        self.pix[where] = self._reset_level[where]
        if unsure is not None:
            self._spoil(self.pix, unsure)

    def _ones(self) -> Bits:
        return self.everything, 0

    def _inverse(self, value: Bits) -> Bits:
        return value[1], value[0]

    def _write(self, name: str, value: Bits) -> None:
        self.digital[name] = value
        self._written_us[name] = self._now_us
        self._only_loaded.discard(name)

    def _write_masked(self, name: str, value: Bits) -> None:
        """Where the mask is 1 the register takes the value, where it is 0 it keeps its own."""
        on, off = self._read(self.target.mask_register or name)
        if on == self.everything:
            self._write(name, value)
            return
        old = self._read(name)
        one, zero = (
            (on & new) | (off & kept) | (new & kept) for new, kept in zip(value, old, strict=True)
        )
        self.digital[name] = (one, zero)

    def _read(self, name: str) -> Bits:
        """What a digital source gives; nothing that is known once its bit has decayed."""
        value = self.digital[name]
        if self._now_us - self._written_us[name] <= self.target.digital_retention_us:
            return value
        if value != UNKNOWN:
            never = self._written_us[name] == -inf
            self._doubt(f"{name} has decayed{': no frame writes it anew' if never else ''}")
        return UNKNOWN

    def _some(self, word: Op) -> Bits:
        one, zero = 0, self.everything
        for name in word.sources:
            ones, zeros = self._read(name)
            one |= ones
            zero &= zeros
        return one, zero

    def _total(self, word: Op, where: _Lanes) -> Lights:
        if not word.sources:
            return np.zeros((1, self.lights))
        first, *others = (self._sources.get(name, self.pix)[where] for name in word.sources)
        return sum(others, first)

    def _flagged(self, word: Op) -> tuple[_Lanes, _Lanes | None]:
        """Lanes whose FLAG is 1 and, if there are any, those whose FLAG is unknown."""
        flag = self._read("FLAG")
        if flag != self._split[0]:
            one, zero = flag
            ones = slice(None) if one == self.everything else members(one, self.lanes)
            rest = self.everything & ~(one | zero)
            self._split = flag, ones, members(rest, self.lanes) if rest else None
        if self._split[2] is not None:
            self._doubt(f"FLAG is unknown to `{word}` in some pixels")
        return self._split[1:]

    def _spoil(self, values: Lights, lanes: _Lanes) -> None:
        rows = len(values[lanes])
        values[lanes] = np.nan if self.quiet else self._noise(rows)

    def _doubt(self, what: str) -> None:
        if len(self.doubts) < _MOST_DOUBTS:
            frame, boundary = self._place
            self.doubts.append(f"{what}, at boundary {boundary} of frame {frame}")


_SEED = 20201
_MOST_DOUBTS = 4

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
        if not np.isfinite(value).all():
            return None
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
