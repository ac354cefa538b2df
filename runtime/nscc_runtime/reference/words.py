"""Execute analog words on some pixels, in float64 with the given effects."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from typing import ClassVar

import numpy as np

from nscc.arrays import Bools, Bytes, Floats
from nscc.chips.target import Target
from nscc.operations import OPERATIONS, Op, WordEffect
from nscc.words.container import Container
from nscc_runtime.effects import Selection, Sensor
from nscc_runtime.effects.parts import Errors
from nscc_runtime.effects.registry import by_name
from nscc_runtime.effects.views import Pixels, Word
from nscc_runtime.exposed_frame import Exposure
from nscc_runtime.noise import key, normals, uniforms
from nscc_runtime.pool import in_strips, threads_of
from nscc_runtime.reference.digital import Digital
from nscc_runtime.reference.trace import RunningWord, readout_waits_s
from nscc_runtime.reference.weights import error_sign

Full = Bytes

ADDED, SUBTRACTED, LEVEL = 1, 2, 4  # bits of `Marks.full`


class Marks:
    """Saturation marks of some pixels, by register and PIX (the photodiode); arrays are (pixels,).

    `full`: uint8 by name; its bits tell whether the content includes a full PIX with positive sign
    (ADDED), with negative sign (SUBTRACTED), or in a reset level (LEVEL). `lost`: by name, the
    electrons that registers lost at the ends of their range, summed up over the words on which the
    content depends."""

    def __init__(self, registers: Iterable[str], pixels: int) -> None:
        """Begin with `pixels` pixels without saturation: no mark and no lost electrons in any of
        the `registers`."""
        self.full = {name: np.zeros(pixels, np.uint8) for name in registers}
        self.lost = {name: np.zeros(pixels) for name in registers}

    def fill(self, full: Bools) -> None:
        """Mark PIX (the photodiode) as full where the mask `full` (pixels,) is True; other marks of
        PIX stay."""
        self.full["PIX"] = self.full["PIX"] | full.astype(np.uint8) * np.uint8(ADDED)

    def empty(self, acting: Bools) -> None:
        """Clear the marks of PIX (the photodiode) where it is reset: in the pixels of the mask
        `acting`."""
        self.full["PIX"] = np.where(acting, np.uint8(0), self.full["PIX"])

    def gathered(self, op: Op, fresh: Bools, lit: bool) -> tuple[Full, Floats]:
        """Return the marks, as bits ADDED, SUBTRACTED and LEVEL, and the lost electrons that the
        result of the bus word `op` inherits from its sources, each (pixels,).

        `fresh`: where the word reads the reset level of PIX (the photodiode). `lit`: whether it
        reads it with light; LEVEL is then set where PIX is full. Without light a full PIX leaves no
        mark there."""
        full, lost_e = np.zeros_like(self.full["PIX"]), np.zeros_like(self.lost["PIX"])
        for name in op.sources:
            source_full = self.full[name]
            if name == "PIX":
                of_level = np.where(source_full, source_full | np.uint8(LEVEL), np.uint8(0))
                source_full = np.where(fresh, of_level if lit else np.uint8(0), source_full)
            full |= source_full
            lost_e = lost_e + self.lost[name]
        return inverted(full), lost_e / op.operation.divisor

    def write(self, name: str, acting: Bools, full: Full, lost_e: Floats) -> None:
        """Set the marks `full` and the lost electrons `lost_e` of the register `name` in the pixels
        of the mask `acting`; others keep theirs. All are (pixels,)."""
        self.full[name] = np.where(acting, full, self.full[name])
        self.lost[name] = np.where(acting, lost_e, self.lost[name])

    def read_out(self, name: str, gain: float, effects: Selection, sensor: Sensor) -> Bytes:
        """Return the bits of `saturated_by` (pixels,) for the readout of the register `name`.

        A negative `gain` inverts its sign, so added and subtracted charge are exchanged. A bit is
        set where an effect of `effects` has such a mark; that of registers where their losses
        exceed the mark's least number of electrons."""
        full = inverted(self.full[name]) if gain < 0 else self.full[name]
        bits = np.zeros_like(full)
        for at, amount in (
            ("well", full & ADDED),
            ("subtracted", full & SUBTRACTED),
            ("level", full & LEVEL),
            ("registers", self.lost[name]),
        ):
            mark = effects.marking(at)
            if mark is not None:
                is_marked = amount > mark.least_e(sensor)
                bits |= np.where(is_marked, np.uint8(mark.bit), np.uint8(0))
        return bits


def inverted(full: Full) -> Full:
    """Return the marks of the negated value: the bits ADDED and SUBTRACTED are exchanged, and LEVEL
    stays."""
    exchanged = (full & ADDED) * SUBTRACTED | (full & SUBTRACTED) // SUBTRACTED
    return np.asarray(exchanged | full & LEVEL, np.uint8)


def clipped(pixels: Pixels, effects: Selection, at: str, value: Floats) -> tuple[Floats, Floats]:
    """Return `value` after those `effects` that act at the stage `at`, "well" or "registers", and
    by how much those with a saturation mark have changed it; all in electrons (pixels,)."""
    lost_e = np.zeros_like(value)
    for effect, clip in effects.acting(at):
        value_before, value = value, clip(pixels, value)
        if at in effect.marks:
            lost_e = lost_e + np.abs(value_before - value)
    return value, lost_e


Bits = Bools

Marked = tuple[Floats, Bytes]
"""Exposures (buckets, pixels) in electrons, and their saturation marks, of the same shape."""

CELLS = 1 << 21
"""Largest number of slots x pixels that are processed at once, in about ten arrays of that size."""
WORD_DRAWS = 1
"""Source number, in random keys, of draws for the words of an exposure."""
START = 0
"""Random stream of register contents at the start of a frame; effects have streams from 1."""


def most_destinations(target: Target) -> int:
    """Return the difference between the draw numbers of consecutive words of a target.

    Errors of words are drawn by number: this difference times the word's number, plus the index of
    the destination. It is a power of two of at least the largest number of destinations of a bus
    word, so that words of its own rarely change a target's other draws."""
    rows = (*OPERATIONS, *target.words)
    most = max(row.destinations[1] or 0 for row in rows if row.effect is WordEffect.BUS)
    return 1 << (most - 1).bit_length()


def in_rows(
    run: Callable[[range], tuple[Marked, Bools]],
    rows: range,
    shape: tuple[int, int, int],
    threads: int | None,
) -> Exposure:
    """Return the exposure of the consecutive `rows` of a frame, computed in strips of rows.

    `run(strip)` returns the exposures and marks of the rows `strip`, and the mask (rows, cols) of
    its valid pixels, which must not depend on the strips. `shape`: numbers of buckets, of columns,
    and of slots or intervals in the charge. `threads`: None for all processors. Values that are not
    finite become invalid."""
    buckets, cols, slots = shape
    exposure = np.empty((buckets, len(rows), cols))
    saturated_by = np.empty(exposure.shape, np.uint8)
    valid = np.empty((len(rows), cols), np.bool_)

    def fill(strip: range) -> None:
        """Expose one strip of rows, and write exposures, marks and validity into the whole
        arrays."""
        chunk = slice(strip.start - rows.start, strip.stop - rows.start)
        (strip_exposure, marked), valid[chunk] = run(strip)
        exposure[:, chunk] = strip_exposure.reshape(-1, len(strip), cols)
        saturated_by[:, chunk] = marked.reshape(-1, len(strip), cols)

    in_strips(fill, rows, CELLS // (slots * cols), threads_of(threads))
    exposure[:, ~valid] = np.nan
    return Exposure(exposure, np.isfinite(exposure), saturated_by)


@dataclass(eq=False, kw_only=True)
class WordPixels(Pixels):
    """The contents of some pixels while the words of one frame run. All arrays are (pixels,).

    `charge`: electrons of PIX (the photodiode). `register`: electrons of the analog registers by
    name. `digital`: the digital registers, which `run_word` needs. `word_draws`: the source number,
    in random keys, of draws for single words; a subclass whose words have other numbers has
    another."""

    word_draws: ClassVar[int] = WORD_DRAWS
    container: Container
    effects: Selection
    digital: Digital = field(init=False)

    def __post_init__(self) -> None:
        """Set PIX (the photodiode) and the analog registers to arbitrary values of the device seed,
        without saturation marks, and the reset level to 0, as if PIX was reset before the frame.
        Look up what does not depend on pixels: `at`, the functions of effects by stage; `target`;
        `most`, see `most_destinations`; `errors_at`, the stage of an effect's random errors, by
        name."""
        self.at, self.target = self.effects.at, self.container.target
        self.most = most_destinations(self.target)
        self.errors_at = {effect.name: errors.at for effect, errors in self.effects.having(Errors)}
        names = ("PIX", *self.target.analog_registers)
        start = {name: self.arbitrary(i) for i, name in enumerate(names)}
        # Values well inside the range, so that reading an unwritten register causes a large error.
        self.charge = start.pop("PIX") * self.sensor.full_well_e / 2
        self.register = {name: u * self.sensor.register_max_e / 2 for name, u in start.items()}
        self.level_e = np.zeros(len(self.places))
        self.reset_boundary = np.full(len(self.places), -1)
        self.marks = Marks((*names, "IN"), len(self.places))

    def arbitrary(self, group: int) -> Floats:
        """Return uniform numbers in [0, 1), (pixels,), for the initial values of a register. They
        depend on the device seed and on `group`, the number of the register."""
        return uniforms(key(self.device_seed, START, group=group), self.places)

    def draw(self, name: str, number: int) -> Floats:
        """Return standard normal numbers (pixels,) of the effect called `name`. `number` counts the
        draws of this effect in a frame; the same number gives the same draw."""
        stream = by_name()[name].stream
        return normals(key(self.seed, stream, self.word_draws, self.frame, number), self.places)

    def error(self, name: str, word: Word, destination: int = 0) -> Floats:
        """Return standard normal numbers (pixels,) of the effect called `name` for `word`. For an
        effect of results of words they differ for each `destination` (its index in the word);
        effects of reads, resets and comparisons have one draw a word."""
        number = word.number
        if self.errors_at.get(name) == "words":
            number = number * self.most + destination
        return self.draw(name, number)

    def fall(self, charge: Floats) -> None:
        """Add `charge` (pixels,), in electrons, to PIX (the photodiode), which may saturate."""
        self.charge, lost_e = clipped(self, self.effects, "well", self.charge + charge)
        self.marks.fill(lost_e > 0)

    def hold(self, seconds: float) -> None:
        """Let analog registers leak for a time in seconds, if the effects include leakage; PIX
        keeps its charge. PIX is the photodiode."""
        for decay in self.at("hold"):
            remaining = decay(self, seconds)
            self.register = {name: value * remaining for name, value in self.register.items()}

    def reset(self, word: RunningWord, acting: Bits) -> None:
        """Run the reset word `word`: empty PIX (the photodiode) in the pixels of the mask `acting`,
        clear its marks, set its reset level, and note the boundary."""
        level_e = np.zeros(len(self.places))
        for change in self.at("resets"):
            level_e = change(self, level_e, word)
        self.charge = np.where(acting, 0.0, self.charge)
        self.marks.empty(acting)
        self.level_e = np.where(acting, level_e, self.level_e)
        self.reset_boundary = np.where(acting, word.boundary, self.reset_boundary)

    def read_level(self, word: RunningWord) -> Floats:
        """Return the electrons (pixels,) that `word` finds on PIX (the photodiode): reset level and
        charge. Where PIX was reset at this boundary, only the level is read; effects that let light
        into it add their charge."""
        is_fresh = self.reset_boundary == word.boundary
        charge = np.where(is_fresh, 0.0, self.charge)
        for lit in self.at("level"):
            charge = np.where(is_fresh, lit(self, self.charge, word), self.charge)
        return charge + self.level_e

    def total(self, word: RunningWord) -> Floats:
        """Return the sum of a word's sources in electrons (pixels,); reading PIX adds its reset
        level and read errors. PIX is the photodiode."""
        total = np.zeros(len(self.places))
        for name in word.op.sources:
            if name == "IN":
                total += word.in_e
            elif name == "PIX":
                level = self.read_level(word)
                for read in self.at("reads"):
                    level = read(self, level, word)
                total += level
            else:
                total += self.register[name]
        return total

    def compared(self, word: RunningWord) -> Floats:
        """Return the electrons (pixels,) that the comparison `word` tests for being above 0: the
        sum of its sources, with the comparator's errors if these effects are on."""
        total = self.total(word)
        for compare in self.at("compare"):
            total = compare(self, total, word)
        return total

    def bus(self, word: RunningWord, acting: Bits) -> None:
        """Run a bus word in the pixels of the mask `acting`: write -(sum of its sources) / divisor,
        with the errors of words and saturation, and the marks of its sources to each
        destination."""
        result = self.total(word) / -word.op.operation.divisor
        is_fresh, lit = self.reset_boundary == word.boundary, bool(self.at("level"))
        full, lost_e = self.marks.gathered(word.op, is_fresh, lit)
        for index, name in enumerate(word.op.destinations):
            value = result
            for written in self.at("words"):
                value = written(self, value, word, index, error_sign(name, self.container))
            value, lost_in_register_e = clipped(self, self.effects, "registers", value)
            self.register[name] = np.where(acting, value, self.register[name])
            self.marks.write(name, acting, full, lost_e + lost_in_register_e)

    def run_word(self, word: RunningWord) -> None:
        """Execute one word in all pixels: a reset, a bus word, a comparison, or a digital word. The
        first two act where FLAG (the bit that lets a pixel act) is 1 (a reset everywhere on chips
        whose resets ignore FLAG)."""
        flag = self.digital.read("FLAG") == 1
        match word.op.operation.effect:
            case WordEffect.RESET_PIX:
                everywhere = self.target.reset_honours_flag == "no"
                self.reset(word, np.ones_like(flag) if everywhere else flag)
            case WordEffect.BUS:
                self.bus(word, flag)
            case WordEffect.FLAG_ANALOG:
                is_above = self.compared(word) > 0
                self.digital.write(
                    "FLAG", is_above & flag if self.target.where_obeys_flag else is_above
                )
            case _:
                self.digital.run(word.op)

    def read_out(self) -> Marked:
        """Return exposures in electrons and saturation marks of the frame, each (buckets, pixels).
        Registers leak until their readout; the registers themselves do not change. In a program
        with images they are returned as they are, because images are computed first."""
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
            marked[bucket] = self.marks.read_out(
                readout.register, readout.gain, self.effects, self.sensor
            )
        return exposures, marked
