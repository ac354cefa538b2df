"""How far around a pixel the contents of its registers depend on other pixels, and which registers
words read before they write them."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from itertools import islice, repeat
from types import MappingProxyType
from typing import NamedTuple

import numpy as np

from nscc.arrays import Bools
from nscc.chips.target import Target
from nscc.operations import NEIGHBOURS, STEERING, STEPS, Op, Phase, WordEffect
from nscc.truth import unpacked_bits
from nscc.words.container import Container
from nscc.words.legality import picture_kernels

_FLAG = (WordEffect.FLAG_ANALOG, WordEffect.FLAG_DIGITAL, WordEffect.FLAG_ALL)


class Reach(NamedTuple):
    """How many columns and rows around a pixel a value of this pixel depends on, in each direction;
    0 if only on the pixel itself."""

    left: int = 0
    right: int = 0
    up: int = 0
    down: int = 0

    def joined(self, *reaches: Reach) -> Reach:
        """Return the reach of a value that depends on several values: the largest in each
        direction."""
        return Reach(*map(max, self, self, *reaches))

    def moved(self, right: int, down: int) -> Reach:
        """Return the reach, seen from this pixel, of the same value of another pixel.

        That pixel is `right` columns and `down` rows away."""
        return Reach(
            max(0, self.left - right),
            max(0, self.right + right),
            max(0, self.up - down),
            max(0, self.down + down),
        )

    def without(self, known: Reach) -> Reach:
        """Return the reach of a bit that is known along each side in as many columns and rows as
        `known` says; 0 where this covers all pixels that depend on values outside the array."""
        if not (any(self) and any(known)):
            return self
        return Reach(*(0 if far <= width else far for far, width in zip(self, known, strict=True)))

    def margin(self, shape: tuple[int, int]) -> Bools:
        """Return the pixels whose value depends on pixels outside the array, bool (rows, cols) of
        `shape`.

        These are the first rows and columns up to the reach upwards and to the left, and the last
        ones up to that downwards and to the right."""
        rows, cols = shape
        margin = np.ones(shape, np.bool_)
        margin[self.up : max(0, rows - self.down), self.left : max(0, cols - self.right)] = False
        return margin


_WHOLE_ARRAY = Reach(*[1 << 30] * 4)
"""More columns and rows than an array has."""


class Border(NamedTuple):
    """The columns and rows along each side of the array in which a bit is known, whatever the light
    is: how many of them are all 0 (`zeros`), and how many all 1 (`ones`)."""

    zeros: Reach = Reach()
    ones: Reach = Reach()

    @classmethod
    def of_bits(cls, bits: Bools) -> Border:
        """Return the border of a plane whose bits (rows, cols) are all known."""
        return cls(*(_width_without(differ) for differ in (bits, ~bits)))

    def inverse(self) -> Border:
        """Return the border of the inverted bit."""
        return Border(self.ones, self.zeros)

    def either(self, other: Border) -> Border:
        """Return the border of a bit that is the OR of two bits."""
        return Border(_narrower(self.zeros, other.zeros), self.ones.joined(other.ones))


def _narrower(first: Reach, second: Reach) -> Reach:
    """Return the smaller width on each side."""
    return Reach(*map(min, first, second))


def _width_without(bits: Bools) -> Reach:
    """Return how many columns and rows along each side of an array have no bit of `bits`."""
    if not bits.any():
        return _WHOLE_ARRAY
    rows, cols = (np.flatnonzero(bits.any(axis=axis)) for axis in (1, 0))
    last_row, last_col = (size - 1 for size in bits.shape)
    return Reach(*map(int, (cols[0], last_col - cols[-1], rows[0], last_row - rows[-1])))


class RegisterReaches:
    """How far around a pixel the content of every register depends on other pixels, after some
    words.

    `reach` has this by register; a missing one depends on its own pixel only. `before` is this
    reach of registers before the first word. With `bits_known`, bits beyond the array are known
    constants and do not count. A bit read from a neighbour then extends the reach only in
    directions in which the neighbour's bit itself depends on analog values beyond the array. An OR
    with a plane that is 1 along the whole border does not depend on them either."""

    def __init__(
        self,
        target: Target,
        words: Iterable[Op],
        *,
        bits_known: bool = False,
        before: Mapping[str, Reach] = MappingProxyType({}),
        fixed: Mapping[str, Bools] = MappingProxyType({}),
    ) -> None:
        """Compute the reach of all registers of `target` after `words` have run, in order.

        `before` has the reach of registers before, by name; others have none. With `bits_known`,
        bits beyond the array are known constants. `fixed` has the bits (rows, cols) of registers
        that are the same in every frame."""
        self.target, self.bits_known = target, bits_known
        self.reach: dict[str, Reach] = {**before}
        self._borders = {name: Border.of_bits(bits) for name, bits in fixed.items()}
        self.run(words)

    def of(self, name: str) -> Reach:
        """Return the reach of a register, or of a neighbour's NEWS (`XN`, `XE`, `XS`, `XW`); zeros
        for a register that no word wrote."""
        if name in NEIGHBOURS:
            return self.of("NEWS").moved(*STEPS[name])
        return self.reach.get(name, Reach())

    def _border(self, name: str) -> Border:
        """Return the known border of a digital register, of FLAG or of the bus; empty if nothing
        is known."""
        return self._borders.get(name, Border())

    def run(self, words: Iterable[Op]) -> None:
        """Run further words, in order."""
        for word in words:
            self._run(word)

    def repeat(self, words: Sequence[Op], least: int, most: int) -> None:
        """Run `words` again and again, any number of times from `least` to `most`.

        A register then has the largest reach, and the border that is known, after each of these
        numbers of times."""
        joined, known = dict(self.reach), dict(self._borders)
        for step in range(most + 1):
            if step <= least:
                joined, known = dict(self.reach), dict(self._borders)
            for name, far in self.reach.items() - joined.items():
                joined[name] = far.joined(joined.get(name, Reach()))
            for name, border in self._borders.items() - known.items():
                known[name] = Border(*map(_narrower, border, known.get(name, Border())))
            if step < most:
                self.run(words)
        self.reach, self._borders = joined, known

    def _run(self, op: Op) -> None:
        """Update the reach and the known border of the registers that one word writes.

        In pixels whose FLAG (the bit that lets a pixel act) is 0 an analog word leaves the old
        value, so the old reach counts, too. The same is true of the masked register where its mask
        is 0."""
        effect, phase = op.operation.effect, op.operation.phase
        reach, border = Reach().joined(*map(self.of, op.sources)), Border()
        if effect is WordEffect.DIGITAL_NEIGHBOURS:
            reach = self._of_neighbours(op.sources[0])
        elif effect is WordEffect.PROPAGATION:
            reach = self._of_propagation(reach)
        elif effect is WordEffect.FLAG_ALL:
            border = Border(ones=_WHOLE_ARRAY)
        elif phase is Phase.WRITE:
            reach, border = self.of("bus"), self._border("bus")
        elif effect in (WordEffect.DIGITAL, WordEffect.FLAG_DIGITAL):
            border = Border(zeros=_WHOLE_ARRAY)  # an OR of nothing is 0
            for name in op.sources:
                border = border.either(self._border(name))
            border = border.inverse() if op.operation.inverted else border
        if self.bits_known:
            reach = reach.without(border.zeros.joined(border.ones))
        written = ("FLAG",) if effect in _FLAG else ("bus",) if phase is Phase.READ else ()
        for name in (*written, *op.destinations):
            gate, new, known = None, reach, border
            if name in NEIGHBOURS:
                right, down = STEPS[name]
                name, new = "NEWS", reach.moved(-right, -down)
            if effect is WordEffect.BUS:
                gate = "FLAG"
            elif name == self.target.masked_register:
                gate = self.target.mask_register or ""
            if gate is not None:
                new, known = self._gated(gate, name, new, known)
            self.reach[name], self._borders[name] = new, known

    def _gated(self, gate: str, name: str, new: Reach, known: Border) -> tuple[Reach, Border]:
        """Return reach and border of the register `name` after a word that writes it where the
        register `gate` is 1; `new` and `known` are those of the word's result."""
        gated = self._border(gate)
        new, old = new.without(gated.zeros), self.of(name).without(gated.ones)
        # Where the gate is known, the register is the result or keeps its bit.
        if gated.ones != _WHOLE_ARRAY:
            known = Border(*map(_narrower, known, self._border(name)))
        return new.joined(old, self.of(gate)), known

    def _of_propagation(self, own: Reach) -> Reach:
        """Return the reach of bits after a propagation, if the propagated register itself has the
        reach `own`.

        The distance counts only with `bits_known`, and only in directions in which a bit depends on
        values beyond the array. A proof takes a propagation as one unknown function of both
        registers."""
        reach = own.joined(self.of(self.target.mask_register or ""))
        far = self.target.propagation_pixels if self.bits_known else 0
        return Reach(*(near + far if near else 0 for near in reach))

    def _of_neighbours(self, source: str) -> Reach:
        """Return the reach of a bit that a pixel reads from those neighbours that R1 to R4 choose.

        `source` is the register that is read there. A neighbour counts unless its register of R1 to
        R4 is known to be 0 in all pixels."""
        own, reach = self.of(source), Reach().joined(*map(self.of, STEERING))
        for name, step in STEERING.items():
            if self._border(name).zeros != _WHOLE_ARRAY:
                moved = own.moved(*step)
                if self.bits_known:
                    moved = Reach(
                        *(far if near else 0 for far, near in zip(moved, own, strict=True))
                    )
                reach = reach.joined(moved)
        return reach


def beyond_reaches(
    container: Container,
    before: Mapping[str, Reach] = MappingProxyType({}),
    params: Mapping[str, int] = MappingProxyType({}),
    any_value: Collection[str] = (),
) -> dict[str, Reach]:
    """Return how far around a pixel each output and each state depends on values outside the array,
    by name.

    `before` is the result for the previous frame, on whose states this frame depends; a missing
    state depends on nothing outside. `params` has values of parameters by name, by default their
    starts. The result is the largest one for all values of the parameters `any_value`."""
    pictures = container.pictures
    states = pictures.stepping
    registers, shape = pictures.registers, (container.target.rows, container.target.cols)
    kept = {registers[name]: before.get(name, Reach()) for name in states}
    fixed = {
        registers[plane.name]: unpacked_bits(plane.bits, shape)
        for plane in pictures.inputs
        if not plane.is_open
    }
    reaches = RegisterReaches(container.target, (), bits_known=True, before=kept, fixed=fixed)
    kernels, next_launch = picture_kernels(container), 0
    values: dict[str, tuple[int, ...]] = {
        param.name: param.ends
        if param.name in any_value
        else (params.get(param.name, param.start),)
        for param in pictures.params
    }

    def words(first: int, end: int | None) -> list[Op]:
        """Return the words of the launches from number `first` up to `end`, without it."""
        launches = pictures.launches[first:end]
        return [op for launch in launches for op in kernels[launch.kernel]]

    for loop in pictures.loops:
        name, begin = loop.times.param, next_launch
        next_launch = loop.first + loop.launches
        times = [loop.times.at({name: value}) for value in values.get(name, (0,))]
        reaches.run(words(begin, loop.first))
        reaches.repeat(words(loop.first, next_launch), min(times), max(times))
    reaches.run(words(next_launch, None))
    names = dict.fromkeys((*pictures.outputs, *states))
    return {name: reaches.of(registers[name]) for name in names}


def reaches_of_frames(
    container: Container,
    first: dict[str, Reach] | None = None,
    params: Iterable[Mapping[str, int]] = repeat(MappingProxyType({})),
    any_value: Collection[str] = (),
) -> Iterator[dict[str, Reach]]:
    """Yield the result of `beyond_reaches` frame by frame: how far each output and state depends on
    values outside the array, by name.

    `first` is the result for the first frame, None if it is not known. `params` has the values of
    parameters in each frame; by default their starts, without end. The parameters `any_value` may
    have any value in every frame."""
    names = container.pictures.stepping
    before: dict[str, Reach] = {}
    known: dict[object, dict[str, Reach]] = {}
    for values in params:
        key = tuple(before.items()), tuple(values.items())
        if key not in known:
            known[key] = first or beyond_reaches(container, before, values, any_value)
        first = None
        yield known[key]
        before = {name: known[key][name] for name in names}
        # States without reach have the key of the first frame, whose result is known.
        before = before if any(reach != Reach() for reach in before.values()) else {}


def film_reaches(
    container: Container, any_value: Collection[str] = ()
) -> list[dict[str, Reach]] | None:
    """Return how far each output and state depends on values outside the array, by name, in
    consecutive frames.

    The list ends with the frame from which this stays the same, so the last entry holds for all
    later frames. Return None if it grows with every further frame. Parameters have their starts, or
    for the names `any_value` any values in every frame."""
    film: list[dict[str, Reach]] = []
    # Growth from state to state passes each state once, unless it goes on for ever.
    kept = len(container.pictures.stepping)
    # One frame without the reach of states, one more for each state, and one to find no change.
    for reaches in islice(reaches_of_frames(container, any_value=any_value), kept + 2):
        if film and reaches == film[-1]:
            return film
        film.append(reaches)
    return None
