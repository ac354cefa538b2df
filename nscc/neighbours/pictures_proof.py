"""Prove images and planes: replay the words after the exposure on a small array.

Registers contain exact forms in the exposures of pixels (`nscc.prove.diagrams`); bits are decision
diagrams over answers of comparisons. The array is just large enough that its pixels are affected by
the border in every way that is possible on a larger array; its middle pixel has all the pixels that
it depends on. The final register contents must be what the text defines, for all exposures and
answers, in every pixel except those that depend on a bus outside the array, whose value is unknown.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from functools import partial
from operator import attrgetter
from typing import Literal

from nscc.chips.target import Target
from nscc.diagnostics.diagnostic import Rejected
from nscc.operations import NEIGHBOURS, STEERING, STEPS, Op, Phase, WordEffect
from nscc.prove.diagrams import IN, AlwaysEqual, Form, Forms, TooLarge, in_at
from nscc.prove.meaning import Bits, Fields, PictureMeaning, Place, reaches
from nscc.prove.proof import ALWAYS_EQUAL, FRAMES, Failure
from nscc.words.container import Container
from nscc.words.legality import decoded, picture_kernels
from nscc.words.picture_launches import LaunchLoop, LevelOf, LoopValue
from nscc.words.pictures import Condition, Node, RepeatedImage, RepeatedPlane
from nscc.words.reach import Reach, RegisterReaches

Launched = Sequence[Sequence[Op]]
"""The words of each launch (start of a kernel), in order."""


class PictureReplayError(Exception):
    """Raised for a word that the proof does not support, or for a register with another value than
    the program requires; the text is the reason."""


def pictures_failure(container: Container) -> Failure | None:
    """Return the error in the words of a container's images and planes as a failure of the last
    frame; None if they are proved, or if there are none.

    If the proof is too large, or compared values are always equal, the failure says so, and names
    the image or plane in `unproved`."""
    try:
        reason = pictures_fault(container)
    except TooLarge as large:
        return Failure("its proof is too large", FRAMES, unproved=large.name)
    except AlwaysEqual as equal:
        return Failure(ALWAYS_EQUAL, FRAMES, unproved=str(equal))
    return Failure(reason, FRAMES) if reason else None


def pictures_fault(container: Container) -> str | None:
    """Return the error in the words of a container's images and planes as text; None if they are
    proved.

    Raises TooLarge, with the name of an image or plane, if the proof needs too many nodes of
    decision diagrams, and AlwaysEqual if two values that are compared are equal."""
    pictures = container.pictures
    number = 0
    try:
        kernels = picture_kernels(container)
        launched = [kernels[launch.kernel] for launch in pictures.launches]
        words = [op for ops in launched for op in ops]
        by_words = RegisterReaches(container.target, words).reach
        size = Reach().joined(*by_words.values(), *reaches(pictures, of_a_step=True).values())
        # The smallest array whose pixel `middle` has all the pixels that any value depends on.
        forms = Forms(size.up + size.down + 1, size.left + size.right + 1)
        replay = PictureReplay(container, forms)
        meaning, middle = PictureMeaning(pictures, forms), (size.left, size.up)
        compare = partial(_compare, replay=replay, meaning=meaning, middle=middle)
        levels: dict[int, int | LevelOf | None] = dict(
            enumerate(launch.level for launch in pictures.launches)
        )
        levels |= {level.launch: level for level in pictures.levels_of}
        starts = {loop.first: loop for loop in pictures.loops}
        ends = {loop.first + loop.launches - 1: loop for loop in pictures.loops}
        for launch, ops in enumerate(launched):
            # One step from unknown values proves every step, however many there are.
            if launch in starts:
                _check_steps(starts[launch], meaning, compare, attrgetter("start"))
                replay.forget(starts[launch], launched)
            for op in ops:
                replay.run(op, levels[launch])
                number += 1
            if launch in ends:
                _check_steps(ends[launch], meaning, compare, attrgetter("step"))
                replay.forget(ends[launch], launched)
        if {*pictures.repeated} != {value.name for loop in pictures.loops for value in loop.values}:
            return "its loops do not belong to its repeated names"
        written = {register for op in words for register in op.destinations}
        return _difference(container, written, replay, meaning, middle)
    except PictureReplayError as wrong:
        return str(wrong)
    except Rejected as rejected:
        return rejected.diagnostics[0].message
    except TooLarge as large:
        name_of_word = [cost.name for cost in pictures.costs for _ in range(cost.words)]
        # Word 0 sets FLAG and belongs to no image.
        large.name = name_of_word[min(number, len(name_of_word)) - 1]
        raise


def _check_steps(
    loop: LaunchLoop,
    meaning: PictureMeaning,
    compare: Callable[[LoopValue, Node], None],
    expected: Callable[[RepeatedImage | RepeatedPlane], Node],
) -> None:
    """Compare the register of each name that a loop repeats with an expression of that name.

    `meaning` has the images and planes of the program. `expected` chooses the expression: the
    initial value or the step. `compare` compares one register with it. Raises PictureReplayError
    for a difference, also in the number of steps."""
    for value in loop.values:
        node = meaning.pictures.repeated[value.name]
        if node.times != loop.times:
            raise PictureReplayError(f"`{value.name}` has another number of steps than its loop")
        compare(value, expected(node))


def _compare(
    value: LoopValue, node: Node, replay: PictureReplay, meaning: PictureMeaning, middle: Place
) -> None:
    """Raise PictureReplayError unless a register holds the expression `node`, times the sign of
    `value`, in every pixel.

    `value` has the register, `replay` the contents of registers now; `meaning` gives what `node`
    must be at a pixel. Pixels that depend on pixels beyond the array are skipped, except `middle`
    (column, row), which must not. Raises AlwaysEqual if the expression compares equal values."""
    name = value.name
    if meaning.forms.compares_equal(meaning.of(node, middle)):
        raise AlwaysEqual(name)
    contents = replay.contents(value.register, isinstance(node, Condition))
    reason = _differs(
        name,
        contents,
        expected=lambda at: meaning.of(node, at),
        sign=value.sign,
        replay=replay,
        middle=middle,
    )
    if reason:
        raise PictureReplayError(reason)


def _differs(
    name: str,
    contents: Fields | Bits | None,
    expected: Callable[[Place], Form | int],
    sign: int,
    replay: PictureReplay,
    middle: Place,
) -> str | None:
    """Return as text how register contents differ from `sign` (1 or -1) times the expected values;
    None if they do not.

    `name` is the image or plane, for the text. `contents` has a value for each pixel; None means
    that there is no register. `expected` returns the exact value at a pixel. Pixels that depend on
    pixels beyond the array are skipped, except `middle` (column, row), which must not. The sign of
    bits is ignored."""
    forms = replay.forms
    if contents is None:
        return f"no register holds `{name}`"
    for at in forms.pixels():
        if forms.depends_beyond(contents[at]):
            if at == middle:
                return f"`{name}` depends on pixels outside the array in every pixel"
            continue
        value = expected(at)
        if sign < 0 and not isinstance(value, int):
            value = forms.sum((Fraction(-1), value))
        if contents[at] != value and not forms.compares_equal(value):
            return f"`{name}` differs from its expression in the program"
    return None


def _difference(
    container: Container,
    written: set[str],
    replay: PictureReplay,
    meaning: PictureMeaning,
    middle: tuple[int, int],
) -> str | None:
    """Return the first difference between the registers at the end and the program text, as text;
    None if there is none.

    `written` are the registers that the words of images write. They must not be registers of codes,
    and states must have registers of their own. `middle` is a pixel (column, row) that no border
    affects. Raises AlwaysEqual if an expression compares equal values."""
    pictures, forms = container.pictures, replay.forms
    for name in pictures.expressions:
        if forms.compares_equal(meaning.value(name, middle)):
            raise AlwaysEqual(name)
    kept = [pictures.registers.get(name, "") for name in pictures.kept]
    exposing = {r for words in decoded(container) for op in words for r in op.destinations}
    registers = [*kept, *(readout.register for readout in container.readouts)]
    # What is kept must be neither an exposure nor written by its words.
    if len(set(registers)) < len(registers) or exposing & {*kept}:
        return "the register of a state is also used for other bits"
    for name in dict.fromkeys((*pictures.outputs, *pictures.kept)):
        contents = replay.contents(pictures.registers.get(name, ""), name in pictures.planes)
        sign = -1 if name in pictures.negated else 1
        reason = _differs(
            name,
            contents,
            expected=partial(meaning.value, name),
            sign=sign,
            replay=replay,
            middle=middle,
        )
        if reason:
            return reason
    spoilt = written & {*container.code_registers}
    return f"{min(spoilt)} holds a code bit, but a word overwrites it" if spoilt else None


@dataclass
class Masked:
    """The content of an analog register after a word that wrote it only where FLAG (the bit that
    lets a pixel act) was 1.

    `flag` are these bits by pixel, `written` is what the word wrote, and `before` the content
    before it. `PictureReplay.fields` merges `written` and `before` only when a word needs the
    merged value."""

    flag: Bits
    written: Fields
    before: Fields | Masked


@dataclass
class PictureReplay:
    """The registers of all pixels of a small array while the words after an exposure run.

    `analog` has, by register and pixel (column, row), an exact weighted sum of exposures and other
    unknowns. `digital` has the decision diagram of a bit; FLAG (the bit that lets a pixel act) and
    the inner bus are among its registers. `forms` makes both and knows the size of the array."""

    container: Container
    forms: Forms
    analog: dict[str, Fields | Masked] = field(default_factory=dict)
    digital: dict[str, Bits] = field(default_factory=dict)

    def __post_init__(self) -> None:
        """Set the registers as the exposure leaves them: exposures where they are read out.

        All other registers, FLAG (the bit that lets a pixel act) and kept values hold unknowns of
        their own in each pixel."""
        container, forms = self.container, self.forms
        target = container.target
        pixels = forms.pixels()
        readout_of = {readout.register: readout for readout in container.readouts}
        for name in target.analog_registers:
            readout = readout_of.get(name)
            if readout is not None:
                gain = Fraction(1) / Fraction(readout.gain)
                self.analog[name] = {
                    at: forms.sum((gain, forms.exposure(readout.bucket, *at))) for at in pixels
                }
            else:
                before_frame = f"what {name} held"
                self.analog[name] = {at: {(before_frame, *at): forms.diagrams.one} for at in pixels}
        for name in (*target.digital_registers, "FLAG", "SELECT", "bus"):
            self.digital[name] = {at: forms.diagrams.new_variable(at) for at in pixels}
        pictures = container.pictures
        for name in pictures.kept:
            sign: Literal[-1, 1] = -1 if name in pictures.negated else 1
            self.set_unknown(LoopValue(name, pictures.registers.get(name, ""), sign))

    def set_unknown(self, value: LoopValue) -> None:
        """Set the register of a kept or repeated name to unknowns that stand for its values before
        the frame or step.

        An analog register gets them times the sign of `value`."""
        forms, register = self.forms, value.register
        if register in self.analog:
            sign = Fraction(value.sign)
            self.analog[register] = {
                at: forms.sum((sign, forms.exposure(value.name, *at))) for at in forms.pixels()
            }
        else:
            self.digital[register] = {at: forms.kept_bit(value.name, at) for at in forms.pixels()}

    def forget(self, loop: LaunchLoop, launched: Launched) -> None:
        """Set the registers that the words of a loop write to unknowns, as they are before or after
        any step.

        The registers of its repeated names get the unknowns of these names. `launched` are the
        words of all launches (starts of kernels), not of the loop only. Raises PictureReplayError
        if FLAG (the bit that lets a pixel act) is not 1 in all pixels."""
        forms = self.forms
        if any(bit != forms.diagrams.one for bit in self.digital["FLAG"].values()):
            raise PictureReplayError("FLAG is not 1 in all pixels between the steps of a loop")
        steps = launched[loop.first : loop.first + loop.launches]
        for name in {name for ops in steps for op in ops for name in op.destinations}:
            if name in self.digital:
                new_bit = forms.diagrams.new_variable
                self.digital[name] = {at: new_bit(at) for at in forms.pixels()}
            else:
                name = "NEWS" if name in NEIGHBOURS else name
                self.analog[name] = {at: forms.beyond() for at in forms.pixels()}
        for value in loop.values:
            self.set_unknown(value)

    def contents(self, register: str, is_plane: bool) -> Fields | Bits | None:
        """Return the content of a digital (`is_plane`) or analog register at each pixel (column,
        row); None if there is no such register."""
        if is_plane:
            return self.digital.get(register)
        return self.fields(register) if register in self.analog else None

    def fields(self, name: str, flag: Bits | None = None) -> Fields:
        """Return the content of the analog register `name` at each pixel; raise KeyError if there
        is none.

        With `flag`, the result is correct only where `flag` is 1, which saves merging what was
        written under FLAG (the bit that lets a pixel act)."""
        held, masked = self.analog[name], []
        if isinstance(held, Masked) and flag is not None and held.flag == flag:
            return held.written
        while isinstance(held, Masked):
            masked.append(held)
            held = held.before
        chosen = self.forms.chosen
        for write in reversed(masked):  # the oldest masked write first
            held = {at: chosen(bit, write.written[at], held[at]) for at, bit in write.flag.items()}
        self.analog[name] = held
        return held

    def run(self, op: Op, level: int | LevelOf | None) -> None:
        """Replay one word in all pixels.

        `level` is the value of IN (the level sent to all pixels) in steps, how it follows from a
        parameter, or None while it is not set. Raises PictureReplayError for a word that cannot run
        after the exposure."""
        forms, true_bit = self.forms, self.forms.diagrams.one
        row = op.operation
        match row.effect:
            case WordEffect.NONE:
                return
            case WordEffect.FLAG_ALL:
                self.digital["FLAG"] = dict.fromkeys(forms.pixels(), true_bit)
            case WordEffect.FLAG_DIGITAL:
                self.digital["FLAG"] = self._or_sources(op)
            case WordEffect.FLAG_ANALOG:
                before, totals = self.digital["FLAG"], self._totals(op, level, Fraction(1))
                flags = {at: forms.positive(total, at) for at, total in totals.items()}
                # On some chips a comparison leaves FLAG 0 where it was 0.
                if self.container.target.where_obeys_flag:
                    times = forms.diagrams.times
                    flags = {at: times(bit, before[at]) for at, bit in flags.items()}
                self.digital["FLAG"] = flags
            case WordEffect.BUS:
                self._bus(op, level)
            case WordEffect.DIGITAL_NEIGHBOURS:
                self._write(op.destinations[0], self._or_neighbours(op))
            case WordEffect.PROPAGATION:
                self._propagate(op.destinations[0])
            case WordEffect.DIGITAL:
                self._digital(op)
            case _:
                raise PictureReplayError(f"`{op}` cannot run after the exposure")

    def _totals(
        self, op: Op, level: int | LevelOf | None, factor: Fraction, flag: Bits | None = None
    ) -> Fields:
        """Return `factor` times the sum of a word's analog sources, at each pixel.

        `level` is the value of IN (the level sent to all pixels) in steps, how it follows from a
        parameter, or None while it is not set. With `flag`, the result is correct only where `flag`
        is 1. Raises PictureReplayError if the word reads IN while it is not set, or a register that
        does not exist. A read of a neighbour spoils NEWS on chips where NEWS does not keep its
        value."""
        forms = self.forms
        fields: list[Fields | Mapping[tuple[int, int], Form]] = []
        for name in op.sources:
            if name == "IN":
                if level is None:
                    raise PictureReplayError(f"`{op}` reads IN, which is not set")
                if isinstance(level, LevelOf):
                    unit, number = in_at(level.param), level.factor
                else:
                    unit, number = IN, level
                # A form has no terms that are 0.
                steps = {unit: forms.diagrams.leaf(Fraction(number))} if number else {}
                fields.append(dict.fromkeys(forms.pixels(), steps))
            elif name in NEIGHBOURS:
                fields.append(self._moved(self.fields("NEWS"), *STEPS[name]))
                if not self.container.target.news_read_keeps:
                    self.analog["NEWS"] = {at: forms.beyond() for at in forms.pixels()}
            elif name in self.analog:
                fields.append(self.fields(name, flag))
            else:
                raise PictureReplayError(f"`{op}` reads {name} after the exposure")
        return {at: forms.sum(*((factor, field[at]) for field in fields)) for at in forms.pixels()}

    def _moved(self, fields: Fields, right: int, down: int) -> Fields:
        """Return for each pixel the value of the pixel `right` columns and `down` rows away.

        Values beyond the array are new unknowns, a different one for each pixel."""
        return {
            (x, y): fields[offset]
            if (offset := (x + right, y + down)) in fields
            else self.forms.beyond()
            for x, y in fields
        }

    def _bus(self, op: Op, level: int | LevelOf | None) -> None:
        """Replay an analog word, which writes minus the sum of its sources, perhaps divided.

        `level` is the value of IN (the level sent to all pixels) in steps, how it follows from a
        parameter, or None. Raises PictureReplayError if the word reaches neighbours while FLAG (the
        bit that lets a pixel act) is not 1 in all pixels, or reads IN while that is not set."""
        forms, flag = self.forms, self.digital["FLAG"]
        masked = any(bit != forms.diagrams.one for bit in flag.values())
        if masked and NEIGHBOURS.keys() & {*op.sources, *op.destinations}:
            raise PictureReplayError(
                f"`{op}` accesses neighbours while FLAG is not 1 in all pixels"
            )
        values = self._totals(op, level, Fraction(-1, op.operation.divisor), flag)
        for name in op.destinations:
            if name in NEIGHBOURS:
                right, down = STEPS[name]
                self.analog["NEWS"] = self._moved(values, -right, -down)
                continue
            self.analog[name] = Masked(flag, values, self.analog[name]) if masked else values

    def _or_sources(self, op: Op) -> Bits:
        """Return the OR of the digital sources of `op` at every pixel; 0 everywhere without
        sources.

        Raises KeyError for a register that does not exist."""
        diagrams = self.forms.diagrams
        bits = dict.fromkeys(self.forms.pixels(), diagrams.zero)
        for name in op.sources:
            bits = {at: diagrams.either(bit, self.digital[name][at]) for at, bit in bits.items()}
        return bits

    def _or_neighbours(self, op: Op) -> Bits:
        """Return at each pixel the OR of a register's bits in the neighbours that R1 to R4 choose
        there.

        Bits beyond the array are 1 for a word that is `inverted` (DNEWS1), else 0."""
        diagrams = self.forms.diagrams
        source = self.digital[op.sources[0]]
        beyond = diagrams.one if op.operation.inverted else diagrams.zero
        bits = {}
        for x, y in source:
            bit = diagrams.zero
            for name, (right, down) in STEERING.items():
                neighbour = source.get((x + right, y + down), beyond)
                bit = diagrams.either(bit, diagrams.times(self.digital[name][x, y], neighbour))
            bits[x, y] = bit
        return bits

    def _propagate(self, name: str) -> None:
        """Replace the bits of the register `name` by unknowns that stand for their propagation
        under the mask register.

        Raises PictureReplayError unless R1 to R4 choose all four directions in every pixel."""
        true_bit, bits = self.forms.diagrams.one, self.digital[name]
        if any(self.digital[each][at] != true_bit for each in STEERING for at in bits):
            raise PictureReplayError(
                "a propagation needs all four directions, but one of R1 to R4 is 0"
            )
        mask = self.digital[self.container.target.mask_register or ""]
        self.digital[name] = {at: self.forms.propagated(bits[at], mask[at], at) for at in bits}

    def _digital(self, op: Op) -> None:
        """Replay a digital word, which writes the OR of its sources or the inverse of that.

        In a pair, the first word writes the inner bus and the second reads it."""
        row = op.operation
        if row.phase is Phase.WRITE:
            value = self.digital["bus"]
        else:
            value = self._or_sources(op)
            if row.inverted:
                value = {at: self.forms.diagrams.inverse(bit) for at, bit in value.items()}
            if row.phase is Phase.READ:
                self.digital["bus"] = value
                return
        target: Target = self.container.target
        # The mask's value before the word counts, so the masked register is written first.
        for name in sorted(op.destinations, key=lambda name: name != target.masked_register):
            self._write(name, value)

    def _write(self, name: str, value: Bits) -> None:
        """Write bits, one for each pixel, to a digital register; the masked register changes only
        where its mask is 1."""
        target, diagrams = self.container.target, self.forms.diagrams
        if name == target.masked_register and target.mask_register is not None:
            mask, previous = self.digital[target.mask_register], self.digital[name]
            value = {at: diagrams.chosen(mask[at], bit, previous[at]) for at, bit in value.items()}
        self.digital[name] = dict(value)
