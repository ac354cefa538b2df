"""Symbolic replay: the registers of all pixels that a proof distinguishes, and the effects of
words.

Each of these pixels is a lane: a code, or for a program with senses a history of answers. A bit of
all lanes is a pair of truth vectors. The value of an analog register is a row of parts in each
lane: lights that are computed in parallel, then the terms of a linear form. Words act on every part
alike. The meaning of words comes from `nscc.operations`, as in the emulator, but the two share no
other code.

What a real pixel does not determine is unknown. A bit is unknown if it was never written, has
decayed, is read from SELECT, or is the result of comparing analog values. An analog value that was
never written is random noise with a fixed seed, and so is the result of a word where FLAG is
unknown. The proof fails if the result of a program depends on any of these."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import groupby
from math import inf
from operator import attrgetter

import numpy as np

from nscc.arrays import Bools, Floats, Indices
from nscc.operations import Op, Phase, WordEffect
from nscc.truth import columns, members, rows
from nscc.words.container import Container


class Noise:
    """A pseudo-random stream from a seed, which is equal on all machines.

    It comes from a counter and the SplitMix64 mixer (Steele, Lea, Flood, OOPSLA 2014). Importing
    numpy.random would take longer than most proofs."""

    def __init__(self, seed: int) -> None:
        """Begin the sequence of random numbers that the seed, from 0 on and below 2^32, determines.
        Different seeds have different counters for the first 2^32 numbers."""
        self._next = seed << 32

    def levels(self, rows: int, columns: int) -> Floats:
        """Return the next `rows` x `columns` pseudo-random values, between 1/4 and 1, as float64
        (rows, columns). None is near 0, so that no light goes unnoticed."""
        end = self._next + rows * columns
        x = np.arange(self._next, end, dtype=np.uint64)
        self._next = end
        x *= np.uint64(0x9E3779B97F4A7C15)
        x ^= x >> np.uint64(30)
        x *= np.uint64(0xBF58476D1CE4E5B9)
        x ^= x >> np.uint64(27)
        x *= np.uint64(0x94D049BB133111EB)
        x ^= x >> np.uint64(31)
        # The upper 53 bits, which a float64 holds exactly, as a number from 0 to 1.
        unit = (x >> np.uint64(11)).astype(np.float64) * 2.0**-53
        return (0.25 + 0.75 * unit).reshape(rows, columns)


TOLERANCE = 1e-9
"""Largest error of an exposure, relative to the total light of the frame."""

Bits = tuple[int, int]
"""A bit of every lane: the lanes where it is known to be 1, and the lanes where it is known to be
0."""

UNKNOWN: Bits = (0, 0)
"""A bit that is known in no lane."""

Lanes = Indices | slice
"""A choice of lanes (simulated pixels), to index an array of values."""

WRONG_EXPOSURE = "exposure differs from the sum of light over the open slots"
WRONG_CODE = "the code registers do not hold their code at the end of the frame"


class ReplayError(Exception):
    """Raised for an error in the words, with its `reason` in words, and the `bucket` (name) and
    `shutter` (number) concerned; these are None if all are."""

    def __init__(self, reason: str, bucket: str | None = None, shutter: int | None = None) -> None:
        """Store the reason why a replay fails, and the bucket and shutter concerned; None if all
        are."""
        super().__init__(reason)
        self.reason, self.bucket, self.shutter = reason, bucket, shutter


class ReplayPixels:
    """A replay of the words of a container (a compiled program), frame by frame, for all pixels
    that a proof distinguishes.

    Each such pixel is a lane. `kernels` are the decoded words of the container; `encoding` bool
    (lanes, registers) is loaded by the host. An analog value has several parts in each lane:
    `lights` charges in electrons, then `terms` terms of a linear form, which start at zero. With
    `quiet`, analog values that were never written are zero, and the result of a word is NaN where
    FLAG (the bit that lets a pixel act) is unknown; else both are random. `transitions` counts the
    answers of comparisons that were followed, in all lanes. `doubts` tell why known bits became
    unknown, and which analog word first found FLAG unknown."""

    def __init__(
        self,
        container: Container,
        kernels: Sequence[Sequence[Op]],
        encoding: Bools,
        *,
        lights: int = 1,
        terms: int = 0,
        quiet: bool = False,
    ) -> None:
        """Begin a replay with one lane (simulated pixel) for each row of `encoding`; see the class
        for the arguments.

        Registers that are not loaded are unknown."""
        self.container, self.kernels, self.target = container, kernels, container.target
        self.lights, self.parts, self.quiet = lights, lights + terms, quiet
        self.doubts: list[str] = []
        self.transitions = 0
        self._random = Noise(_SEED)
        self._reset_level = self._noise(1)
        self._resize(len(encoding))
        self.bits: dict[str, Bits] = {
            **dict.fromkeys((*self.target.digital_registers, "FLAG", "SELECT", "bus"), UNKNOWN),
            **self.code_bits(encoding),
        }
        self.analog: dict[str, Floats] = {}
        by_boundary = groupby(container.launches, key=attrgetter("instant"))
        self.launches = {boundary: tuple(launches) for boundary, launches in by_boundary}
        self._boundary_us = np.concatenate(([0.0], np.cumsum(container.slot_us)))
        self._frame, self._boundary = 0, 0
        self._start_us = self._now_us = 0.0
        self._written_us = dict.fromkeys(self.bits, 0.0)
        self._never_written = set(self.bits)

    # Lanes.

    def _resize(self, lanes: int) -> None:
        """Set the number of lanes (simulated pixels), and forget which of them have FLAG (the bit
        that lets a pixel act) = 1."""
        self.lanes, self.everything = lanes, (1 << lanes) - 1
        self._split: tuple[Bits, Lanes, Lanes | None] = (UNKNOWN, slice(0, 0), slice(None))

    def choose(self, lanes: Indices) -> None:
        """Replace the lanes (pixels that the proof distinguishes) by those with the indices
        `lanes`, in this order.

        An index may be repeated, to follow two answers of one pixel, or left out. All registers are
        changed in place."""
        vectors = [vector for bits in self.bits.values() for vector in bits]
        chosen = iter(columns(rows(vectors, self.lanes)[lanes]))
        self.bits = {name: (next(chosen), next(chosen)) for name in self.bits}
        self.analog = {name: values[lanes] for name, values in self.analog.items()}
        self._resize(len(lanes))

    def known(self, bits: Bools) -> list[Bits]:
        """Return known bits, bool (lanes, registers), as a pair of truth vectors (integers with one
        bit for each lane) for each register."""
        return [(ones, self.everything & ~ones) for ones in columns(bits)]

    def code_bits(self, encoding: Bools) -> dict[str, Bits]:
        """Return the contents of the code registers by name, each as a pair of truth vectors (known
        1, known 0), from `encoding` bool (lanes, digital registers). A lane is a simulated pixel.
        """
        registers, names = self.target.digital_registers, self.container.code_registers
        columns = [registers.index(name) for name in names]
        return dict(zip(names, self.known(encoding[:, columns]), strict=True))

    # Frames.

    def prove_frame(self, light: Floats) -> None:
        """Run one frame in `light`, float64 (N,), in electrons per slot.

        Raises ReplayError if the result differs from the program. Subclasses define what is
        compared."""
        raise NotImplementedError

    def start_frame(self) -> None:
        """Begin the next frame: all analog registers, PIX (the photodiode) and IN (the level sent
        to all pixels) are unknown.

        From the second frame on, digital registers that no frame has written so far are unknown,
        too."""
        if self._frame:
            # The chip runs frame after frame: a bit that no frame writes decays.
            self._written_us.update(dict.fromkeys(self._never_written, -inf))
        self._frame += 1
        self._start_us = self._now_us
        names = (*self.target.analog_registers, "PIX", "IN")
        for name, value in zip(names, self._noise(len(names)), strict=True):
            self.analog[name] = np.full((self.lanes, self.parts), value)

    def run_launches(self, boundary: int) -> None:
        """Set the time to a boundary, and run the kernels (lists of words) that the program starts
        there.

        A start may set IN, the value that all pixels receive, before its words run."""
        self._boundary = boundary
        self._now_us = self._start_us + float(self._boundary_us[boundary])
        for launch in self.launches.get(boundary, ()):
            if launch.level is not None:
                self.set_in(launch.level)
            for word in self.kernels[launch.kernel]:
                self.run(word)

    def end_frame(self) -> None:
        """Set the time to the end of the frame and its readout.

        If the program has images or planes, all digital registers but those of the code become
        unknown: the words that compute them are proved elsewhere."""
        if self.container.pictures.launches:
            for name in self.bits.keys() - {*self.container.code_registers}:
                self.write(name, UNKNOWN)
        self._boundary = self.container.slots
        self._now_us = self._start_us + float(self._boundary_us[-1])
        self._now_us += self.target.readout_us * len(self.container.readouts)

    def set_in(self, level: int) -> None:
        """Set the charge that IN (the level sent to all pixels) supplies to `level` steps, in all
        lanes (simulated pixels). All lights get it; terms of linear forms become 0."""
        self.analog["IN"][:] = 0.0
        self.analog["IN"][:, : self.lights] = level * self.target.electrons_per_step

    def _noise(self, rows: int) -> Floats:
        """Return values for registers that were never written, float64 (rows, parts), a row for
        each register, for all lanes (simulated pixels) alike.

        Lights are random, or zero with `quiet`; terms are zero."""
        values = np.zeros((rows, self.parts))
        if not self.quiet:
            values[:, : self.lights] = self._random.levels(rows, self.lights)
        return values

    # Words.

    def run(self, word: Op) -> None:
        """Run a word in every lane (a simulated pixel), as FLAG (the bit that lets a pixel act) and
        the target's rules allow it.

        Raises nothing: a result that a real chip does not determine becomes unknown."""
        match word.operation.effect:
            case WordEffect.RESET_PIX:
                lanes: Lanes = slice(None)
                unsure = None
                if self.target.reset_honours_flag != "no":
                    lanes, unsure = self._flagged("rpix")
                # The reset may or may not happen in every pixel whose FLAG is not surely 1.
                if self.target.reset_honours_flag == "unknown":
                    unflagged = self.everything & ~self.read("FLAG")[0]
                    unsure = members(unflagged, self.lanes) if unflagged else None
                self._store("PIX", self._reset_level, lanes, unsure)
            case WordEffect.BUS:
                lanes, unsure = self._flagged(str(word))
                # A bus word writes the negative of the sum of its sources.
                value = self.total(word, lanes) / -word.operation.divisor
                for name in word.destinations:
                    self._store(name, value, lanes, unsure)
            case WordEffect.FLAG_ALL:
                self.write("FLAG", (self.everything, 0))
            case WordEffect.FLAG_ANALOG:
                self.write("FLAG", self.compare(word))
            case WordEffect.FLAG_DIGITAL:
                self.write("FLAG", self._or_sources(word))
            case WordEffect.DIGITAL:
                self._digital(word)

    def _store(self, name: str, value: Floats, lanes: Lanes, unsure: Lanes | None) -> None:
        """Store an analog value, float64 (lanes, parts) or (1, parts) for all, in the register
        `name` of the pixels `lanes`; in those of `unsure` (None: no pixel) it becomes unknown. A
        lane is a simulated pixel."""
        self.analog[name][lanes] = value
        if unsure is not None:
            self.analog[name][unsure] = np.nan if self.quiet else self._noise(1)

    def total(self, word: Op, lanes: Lanes = slice(None)) -> Floats:
        """Return the sum of a word's analog sources in `lanes`, float64 (lanes, parts), without the
        change of sign that bus words make; zeros (1, parts) without sources. A lane is a simulated
        pixel."""
        if not word.sources:
            return np.zeros((1, self.parts))
        first, *further_sources = (self.analog[name][lanes] for name in word.sources)
        return sum(further_sources, first)

    def compare(self, word: Op) -> Bits:
        """Return the bits of FLAG (the bit that lets a pixel act) after a comparison of analog
        values: unknown, because it depends on the light, except 0 where the comparison does not
        act.

        Programs with senses override this."""
        self._doubt(f"`{word}` makes FLAG depend on the light")
        # If `where` obeys FLAG on this target, masked pixels stay masked.
        return 0, self.read("FLAG")[1] if self.target.where_obeys_flag else 0

    def _flagged(self, word: str) -> tuple[Lanes, Lanes | None]:
        """Return the lanes whose FLAG (the bit that lets a pixel act) is 1, and those whose FLAG is
        unknown (None if there are none).

        `word` is the word that asks, for the doubt that is noted. The result is cached until FLAG
        changes. A lane is a simulated pixel."""
        flag = self.read("FLAG")
        if flag != self._split[0]:
            known_1, known_0 = flag
            ones = slice(None) if known_1 == self.everything else members(known_1, self.lanes)
            unsure = self.everything & ~(known_1 | known_0)
            self._split = flag, ones, members(unsure, self.lanes) if unsure else None
        if self._split[2] is not None:
            self._doubt(f"FLAG is unknown to `{word}` in some pixels")
        return self._split[1:]

    def _digital(self, word: Op) -> None:
        """Run a digital word on the bits of all lanes (simulated pixels).

        In a pair, the first word writes the inner bus and the second reads it. The masked register
        changes only where its mask is 1."""
        row = word.operation
        if row.phase is Phase.WRITE:
            value = self.read("bus")
        else:
            value = self._or_sources(word)
            if row.inverted:
                value = value[1], value[0]
            if row.phase is Phase.READ:
                self.write("bus", value)
                return
        # The mask's value before the word counts: the word may also write the mask.
        masked, mask = self.target.masked_register, self.target.mask_register
        for name in sorted(word.destinations, key=lambda name: name != masked):
            self.write(name, value, mask if name == masked else None)

    def read(self, name: str) -> Bits:
        """Return the bits of a digital register or of FLAG (the bit that lets a pixel act), now, as
        a pair of truth vectors.

        They are unknown if they were written longer ago than the retention time; a bit that was
        known is noted as a doubt."""
        value = self.bits[name]
        if self._now_us - self._written_us[name] <= self.target.digital_retention_us:
            return value
        if value != UNKNOWN:
            never = self._written_us[name] == -inf
            self._doubt(f"{name} has decayed{': no frame writes it again' if never else ''}")
        return UNKNOWN

    def _or_sources(self, word: Op) -> Bits:
        """Return the OR of a word's digital sources in all pixels, as a pair of truth vectors
        (known 1, known 0). Without sources it is 0 everywhere."""
        known_1, known_0 = 0, self.everything
        for name in word.sources:
            ones, zeros = self.read(name)
            known_1 |= ones
            known_0 &= zeros
        return known_1, known_0

    def write(self, name: str, value: Bits, mask: str | None = None) -> None:
        """Write the bits of a register, now.

        With the register `mask`, only lanes (simulated pixels) where it is 1 change, and the
        content counts as old as before, unless it is 1 in all lanes. A lane whose mask is unknown
        keeps only a bit that is equal before and after."""
        on, off = (self.everything, 0) if mask is None else self.read(mask)
        if on == self.everything:
            self.bits[name] = value
            self._written_us[name] = self._now_us
            self._never_written.discard(name)
            return
        known_1, known_0 = (
            (on & new) | (off & old) | (new & old)
            for new, old in zip(value, self.read(name), strict=True)
        )
        self.bits[name] = known_1, known_0

    def _doubt(self, reason: str) -> None:
        """Note why a bit became unknown, unless there are `_MOST_DOUBTS` notes already."""
        if len(self.doubts) < _MOST_DOUBTS:
            self.doubts.append(f"{reason}, at boundary {self._boundary} of frame {self._frame}")


_SEED = 20201
"""Fixed, so that a replay always gives the same result."""
_MOST_DOUBTS = 4
"""Most reasons noted for bits that became unknown."""
