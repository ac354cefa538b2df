"""Execute analog words on some pixels, in float64 with the given effects."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from nscc.chips.target import Target
from nscc.operations import OPERATIONS, Op, WordEffect
from nscc.words.container import Container
from nscc_runtime.effects import Selection
from nscc_runtime.effects.parts import Errors
from nscc_runtime.effects.registry import by_name
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.effects.views import Pixels, Word
from nscc_runtime.interface import Exposure
from nscc_runtime.noise import key, normals, uniforms
from nscc_runtime.pool import in_strips, threads_of
from nscc_runtime.reference.charge import Fallen
from nscc_runtime.reference.trace import RunningWord, readout_waits_s
from nscc_runtime.reference.weights import error_sign

Full = NDArray[np.uint8]
Values = NDArray[np.float64]

ADDED, SUBTRACTED, LEVEL = 1, 2, 4


class Marks:
    """Saturation marks of some pixels, by register and PIX; arrays are (pixels,).

    `full`: bits that tell whether the content includes a full PIX with positive sign (ADDED), with
    negative sign (SUBTRACTED), or in a reset level (LEVEL). `lost`: electrons that registers lost.
    """

    def __init__(
        self, effects: Selection, sensor: Sensor, registers: Iterable[str], pixels: int
    ) -> None:
        """Begin with `pixels` pixels without saturation: no mark and no lost electrons in any of
        the `registers`."""
        self.effects, self.sensor = effects, sensor
        self.mark = {at: effects.marking(at) for at in ("well", "subtracted", "level", "registers")}
        self.full = {name: np.zeros(pixels, np.uint8) for name in registers}
        self.lost = {name: np.zeros(pixels) for name in registers}

    def fill(self, full: NDArray[np.bool_]) -> None:
        """Mark PIX as full where the mask is True."""
        self.full["PIX"] = self.full["PIX"] | full.astype(np.uint8) * np.uint8(ADDED)

    def fallen(self, pixels: Pixels, charge: Values) -> Values:
        """Return the charge of PIX after saturation; mark PIX as full where charge is lost."""
        for effect, clip in self.effects.acting("well"):
            charge_before, charge = charge, clip(pixels, charge)
            if "well" in effect.marks:
                self.fill(charge < charge_before)
        return charge

    def clip_register(self, pixels: Pixels, value: Values, lost_e: Values) -> tuple[Values, Values]:
        """Return a register's value after saturation, and the electrons lost including `lost_e`."""
        for effect, clip in self.effects.acting("registers"):
            value_before, value = value, clip(pixels, value)
            if "registers" in effect.marks:
                lost_e = lost_e + np.abs(value_before - value)
        return value, lost_e

    def empty(self, acting: NDArray[np.bool_]) -> None:
        """Clear the marks of PIX where it is reset."""
        self.full["PIX"] = np.where(acting, np.uint8(0), self.full["PIX"])

    def gathered(
        self, op: Op, unseen: NDArray[np.bool_], lit: NDArray[np.bool_]
    ) -> tuple[Full, Values]:
        """Return the marks and lost electrons that a bus word's result inherits from its sources.

        `unseen`: where the word does not read the charge of PIX. `lit`: where it reads a reset
        level with light."""
        full, lost_e = np.zeros_like(self.full["PIX"]), np.zeros_like(self.lost["PIX"])
        for name in op.sources:
            source_full = self.full[name]
            if name == "PIX":
                source_full = np.where(unseen, np.uint8(0), source_full)
                source_full = source_full | np.where(
                    lit & (source_full != 0), np.uint8(LEVEL), np.uint8(0)
                )
            full |= source_full
            lost_e = lost_e + self.lost[name]
        return inverted(full), lost_e / op.operation.divisor

    def write(self, name: str, acting: NDArray[np.bool_], full: Full, lost_e: Values) -> None:
        """Set the marks and lost electrons of a register where `acting`."""
        self.full[name] = np.where(acting, full, self.full[name])
        self.lost[name] = np.where(acting, lost_e, self.lost[name])

    def read_out(self, name: str, gain: float) -> NDArray[np.uint8]:
        """Return the bits of `saturated_by` (pixels,) for the readout of a register with this
        gain."""
        full = inverted(self.full[name]) if gain < 0 else self.full[name]
        bits = np.zeros_like(full)
        for at, is_marked in (
            ("well", full & ADDED),
            ("subtracted", full & SUBTRACTED),
            ("level", full & LEVEL),
        ):
            mark = self.mark[at]
            if mark is not None:
                bits |= np.where(is_marked, np.uint8(mark.bit), np.uint8(0))
        mark = self.mark["registers"]
        if mark is not None:
            exceeds = self.lost[name] > mark.least_e(self.sensor)
            bits |= np.where(exceeds, np.uint8(mark.bit), np.uint8(0))
        return bits


def inverted(full: Full) -> Full:
    """Return the marks of the negated value: ADDED and SUBTRACTED are exchanged."""
    exchanged = (full & ADDED) * SUBTRACTED | (full & SUBTRACTED) // SUBTRACTED
    return np.asarray(exchanged | full & LEVEL, np.uint8)


Bits = NDArray[np.bool_]


class Resets:
    """The reset levels of some pixels; arrays are (pixels,). Boundaries are rising numbers."""

    def __init__(self, effects: Selection, pixels: int) -> None:
        """Begin with no reset level in any pixel."""
        self._leaving, self._letting_in = effects.at("resets"), effects.at("level")
        self._level_e, self._last = np.zeros(pixels), np.full(pixels, -1.0)

    def reset(self, pixels: Pixels, acting: Bits, word: Word, boundary: float) -> None:
        """Set the reset level of the pixels in the mask `acting`, at the boundary of the reset
        word."""
        level = np.zeros_like(self._level_e)
        for change in self._leaving:
            level = change(pixels, level, word)
        self._level_e = np.where(acting, level, self._level_e)
        self._last = np.where(acting, boundary, self._last)

    def unseen(self, boundary: float) -> Bits:
        """Return a mask of pixels where words do not read the charge of PIX: PIX was reset at this
        boundary, and no effect lets light into the level."""
        return np.asarray((self._last == boundary) & (not self._letting_in))

    def lit(self, boundary: float) -> Bits:
        """Return a mask of pixels where words read the reset level plus light since the reset."""
        return np.asarray((self._last == boundary) & bool(self._letting_in))

    def read_level(self, pixels: Pixels, charge: Values, word: Word, boundary: float) -> Values:
        """Return the value that a word reads from PIX when PIX contains `charge`."""
        charge_and_level = np.where(self.unseen(boundary), 0.0, charge)
        for lit in self._letting_in:
            charge_and_level = np.where(self._last == boundary, lit(pixels, charge, word), charge)
        return charge_and_level + self._level_e


Marked = tuple[Values, NDArray[np.uint8]]
"""Exposures (buckets, pixels) in electrons, and saturation marks."""

CELLS = 1 << 21
"""Largest number of slots x pixels that are processed at once, in about ten arrays of that size."""
WORD_DRAWS = 1
"""Source number, in random keys, of draws for the words of an exposure."""
START = 0
"""Random stream of register contents at the start of a frame; effects have streams from 1."""


def most_destinations(target: Target) -> int:
    """Return the difference between the draw numbers of consecutive words.

    Draws of errors are numbered by word and destination. The result is a power of two of at least
    the largest number of destinations, so that a target's own words rarely change other draws."""
    rows = (*OPERATIONS, *target.words)
    most = max(row.destinations[1] or 0 for row in rows if row.effect is WordEffect.BUS)
    return 1 << (most - 1).bit_length()


def in_rows(
    fall: Callable[[range], Fallen],
    run: Callable[[range, Fallen], Marked],
    rows: range,
    shape: tuple[int, int, int],
    threads: int | None,
) -> Exposure:
    """Return the exposure of consecutive rows of a frame, computed in strips of rows.

    `fall` returns the charge of a strip, and `run` its exposures. `shape`: buckets, cols, and the
    number of slots or intervals that are processed at once."""
    buckets, cols, slots = shape
    exposure = np.empty((buckets, len(rows), cols))
    saturated_by = np.empty(exposure.shape, np.uint8)
    valid = np.empty((len(rows), cols), np.bool_)

    def fill(strip: range) -> None:
        """Expose one strip of rows, and write exposures, marks and validity into the whole
        arrays."""
        fallen = fall(strip)
        strip_exposure, marked = run(strip, fallen)
        chunk = slice(strip.start - rows.start, strip.stop - rows.start)
        exposure[:, chunk] = strip_exposure.reshape(-1, len(strip), cols)
        saturated_by[:, chunk] = marked.reshape(-1, len(strip), cols)
        valid[chunk] = fallen.valid

    in_strips(fill, rows, CELLS // (slots * cols), threads_of(threads))
    return Exposure(exposure, np.isfinite(exposure) & valid, saturated_by)


@dataclass(eq=False, kw_only=True)
class WordPixels(Pixels):
    """The contents of some pixels while the words of one frame run. All arrays are (pixels,).
    `word_draws`: the source number, in random keys, of draws for single words."""

    word_draws: ClassVar[int] = WORD_DRAWS
    container: Container
    effects: Selection

    def __post_init__(self) -> None:
        """Set PIX and the analog registers to arbitrary values of the device seed."""
        self.begin()
        names = ("PIX", *self.target.analog_registers)
        start = {name: self.arbitrary(i) for i, name in enumerate(names)}
        # Values well inside the range, so that reading an unwritten register causes a large error.
        self.charge = start.pop("PIX") * self.sensor.full_well_e / 2
        self.register = {name: u * self.sensor.register_max_e / 2 for name, u in start.items()}
        self.resets = Resets(self.effects, len(self.places))
        self.marks = Marks(self.effects, self.sensor, (*names, "IN"), len(self.places))

    def begin(self) -> None:
        """Look up everything that does not depend on pixels, such as the effects of each stage."""
        self.at, self.target = self.effects.at, self.container.target
        self.most = most_destinations(self.target)
        self.errors_at = {
            effect.name: error_part.at for effect, error_part in self.effects.having(Errors)
        }

    def arbitrary(self, group: int) -> Values:
        """Return uniform numbers (pixels,) of the chip for the initial values of a register."""
        return uniforms(key(self.device_seed, START, group=group), self.places)

    def draw(self, name: str, number: int) -> Values:
        """Return the standard normal error (pixels,) of an effect in draw `number` of its words."""
        stream = by_name()[name].stream
        return normals(key(self.seed, stream, self.word_draws, self.frame, number), self.places)

    def error(self, name: str, word: Word, destination: int = 0) -> Values:
        """Return the random numbers of an effect for a word, different for each `destination` if
        the effect acts on words."""
        number = word.number
        if self.errors_at.get(name) == "words":
            number = number * self.most + destination
        return self.draw(name, number)

    def fall(self, charge: Values) -> None:
        """Add charge to PIX."""
        self.charge = self.marks.fallen(self, self.charge + charge)

    def hold(self, seconds: float) -> None:
        """Let registers leak for a time in seconds."""
        for decay in self.at("hold"):
            remaining = decay(self, seconds)
            self.register = {name: value * remaining for name, value in self.register.items()}

    def reset(self, word: RunningWord, acting: Bits) -> None:
        """Reset PIX in the pixels of the mask `acting`."""
        self.charge = np.where(acting, 0.0, self.charge)
        self.marks.empty(acting)
        self.resets.reset(self, acting, word, word.boundary)

    def total(self, word: RunningWord) -> Values:
        """Return the sum of a word's sources in electrons (pixels,); reading PIX adds its reset
        level and read errors."""
        total = np.zeros(len(self.places))
        for name in word.op.sources:
            if name == "IN":
                total += word.in_e
            elif name == "PIX":
                level = self.resets.read_level(self, self.charge, word, word.boundary)
                for read in self.at("reads"):
                    level = read(self, level, word)
                total += level
            else:
                total += self.register[name]
        return total

    def compared(self, word: RunningWord) -> Values:
        """Return the electrons (pixels,) that a comparison tests for being above 0, with the
        comparator's errors."""
        total = self.total(word)
        for compare in self.at("compare"):
            total = compare(self, total, word)
        return total

    def bus(self, word: RunningWord, acting: Bits) -> None:
        """Write -(sum of a word's sources) / divisor to its destinations where `acting`."""
        result, at = self.total(word) / -word.op.operation.divisor, word.boundary
        full, lost_e = self.marks.gathered(word.op, self.resets.unseen(at), self.resets.lit(at))
        for index, name in enumerate(word.op.destinations):
            value = result
            for written in self.at("words"):
                value = written(self, value, word, index, error_sign(name, self.container))
            value, lost_in_register_e = self.marks.clip_register(self, value, lost_e)
            self.register[name] = np.where(acting, value, self.register[name])
            self.marks.write(name, acting, full, lost_in_register_e)

    def read_out(self) -> Marked:
        """Return exposures in electrons and saturation marks of the frame, each (buckets,
        pixels)."""
        exposures = np.empty((len(self.container.buckets), len(self.places)))
        marked = np.empty(exposures.shape, np.uint8)
        stays = bool(self.container.pictures.launches)  # readout follows the words of images
        waits_s = readout_waits_s(self.container)
        for readout in self.container.readouts:
            value = self.register[readout.register] * readout.gain
            bucket = self.container.buckets.index(readout.bucket)
            for decay in () if stays else self.at("hold"):
                value = value * decay(self, waits_s[bucket])
            for leaves in () if stays else self.at("readout"):
                value = leaves(self, value, bucket)
            exposures[bucket] = value + 0.0  # -0 + 0 is +0
            marked[bucket] = self.marks.read_out(readout.register, readout.gain)
        return exposures, marked
