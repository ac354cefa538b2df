"""Prove images and planes: replay the words after the exposure on a small array.

Registers contain exact forms in the exposures of pixels (`nscc.prove.diagrams`); bits are decision
diagrams over answers of comparisons. The array is just large enough that its pixels are affected by
the border in every way that is possible on a larger array; its middle pixel has all the pixels that
it depends on. The final register contents must be what the text defines, for all exposures and
answers, in every pixel except those that depend on a bus outside the array, whose value is unknown.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction

from nscc.chips.target import Target
from nscc.diagnostics.diagnostic import Rejected
from nscc.operations import NEIGHBOURS, STEERING, STEPS, Op, Phase, WordEffect
from nscc.prove.diagrams import IN, AlwaysEqual, Form, Forms, TooLarge
from nscc.prove.meaning import Bits, Fields, PictureMeaning, reaches
from nscc.prove.proof import ALWAYS_EQUAL, FRAMES, Failure
from nscc.words.container import Container
from nscc.words.legality import decoded, picture_words
from nscc.words.pictures import Condition
from nscc.words.reach import Reach, RegisterReaches


class PictureReplayError(Exception):
    """Raised for a word that the proof does not support."""


def pictures_failure(container: Container) -> Failure | None:
    """Return the error in the words of a container's images and planes, or None."""
    try:
        reason = pictures_fault(container)
    except TooLarge as large:
        return Failure("its proof is too large", FRAMES, unproved=large.name)
    except AlwaysEqual as equal:
        return Failure(ALWAYS_EQUAL, FRAMES, unproved=str(equal))
    return Failure(reason, FRAMES) if reason else None


def pictures_fault(container: Container) -> str | None:
    """Return the error in the words of a container's images and planes; None if the proof holds.

    Raises TooLarge for planes whose decision diagrams are too large, and AlwaysEqual."""
    pictures = container.pictures
    number = 0
    try:
        words = picture_words(container)
        by_words = RegisterReaches(container.target, (op for op, _ in words)).reach
        size = Reach().joined(*by_words.values(), *reaches(pictures).values())
        forms = Forms(size.up + size.down + 1, size.left + size.right + 1)
        replay = PictureReplay(container, forms)
        for op, level in words:
            replay.run(op, level)
            number += 1
        meaning, middle = PictureMeaning(pictures, forms), (size.left, size.up)
        written = {register for op, _ in words for register in op.destinations}
        return _difference(container, written, replay, meaning, middle)
    except PictureReplayError as wrong:
        return str(wrong)
    except Rejected as rejected:
        return rejected.diagnostics[0].message
    except TooLarge as large:
        owners = [cost.name for cost in pictures.costs for _ in range(cost.words)]
        large.name = owners[min(number, len(owners)) - 1]  # word 0 belongs to no image
        raise


def _difference(
    container: Container,
    written: set[str],
    replay: PictureReplay,
    meaning: PictureMeaning,
    middle: tuple[int, int],
) -> str | None:
    """Return the first difference between register contents and the text; None if there is none.

    `written`: the registers that the words of images write."""
    pictures, forms = container.pictures, replay.forms
    for name in pictures.expressions:
        if forms.compares_equal(meaning.value(name, middle)):
            raise AlwaysEqual(name)
    kept = [pictures.registers.get(state.name, "") for state in pictures.states]
    exposing = {r for words in decoded(container) for op in words for r in op.destinations}
    if len(set(kept)) < len(kept) or exposing & {*kept}:
        return "the register of a state is also used for other bits"
    for name in dict.fromkeys((*pictures.outputs, *(state.name for state in pictures.states))):
        register = pictures.registers.get(name, "")
        contents: Fields | Bits | None = None
        if register in replay.analog:
            contents = replay.fields(register)
        if isinstance(meaning.nodes.get(name), Condition):
            contents = replay.digital.get(register)
        if contents is None:
            return f"no register holds `{name}`"
        for at in forms.places():
            if forms.depends_beyond(contents[at]):
                if at == middle:
                    return f"`{name}` depends on pixels outside the array in every pixel"
            elif contents[at] != (value := meaning.value(name, at)) and not (
                forms.compares_equal(value)
            ):
                return f"`{name}` differs from its expression in the program"
    spoilt = written & {*container.code_registers}
    return f"{min(spoilt)} holds a code bit, but a word overwrites it" if spoilt else None


@dataclass
class Masked:
    """The content of a register after a word that wrote it where FLAG was 1.

    `PictureReplay.fields` merges `written` and `before` only when a word needs the merged value."""

    flag: Bits
    written: Fields
    before: Fields | Masked


@dataclass
class PictureReplay:
    """The registers of a small array of pixels while the words after an exposure run."""

    container: Container
    forms: Forms
    analog: dict[str, Fields | Masked] = field(default_factory=dict)
    digital: dict[str, Bits] = field(default_factory=dict)

    def __post_init__(self) -> None:
        container, forms = self.container, self.forms
        target = container.target
        places = forms.places()
        readout_of = {readout.register: readout for readout in container.readouts}
        for name in target.analog_registers:
            readout = readout_of.get(name)
            if readout is not None:
                gain = Fraction(1) / Fraction(readout.gain)
                self.analog[name] = {
                    at: forms.sum((gain, forms.exposure(readout.bucket, *at))) for at in places
                }
            else:
                before_frame = f"what {name} held"
                self.analog[name] = {at: {(before_frame, *at): forms.diagrams.one} for at in places}
        for name in (*target.digital_registers, "FLAG", "SELECT", "bus"):
            self.digital[name] = {at: forms.diagrams.new_variable(at) for at in places}
        pictures = container.pictures
        for state in pictures.states:
            register = pictures.registers.get(state.name, "")
            self.digital[register] = {at: forms.kept_bit(state.name, at) for at in places}

    def fields(self, name: str, flag: Bits | None = None) -> Fields:
        """Return the content of an analog register; with `flag`, correct only where `flag` is 1."""
        held, masked = self.analog[name], []
        if isinstance(held, Masked) and flag is not None and held.flag == flag:
            return held.written
        while isinstance(held, Masked):
            masked.append(held)
            held = held.before
        chosen = self.forms.chosen
        for each in reversed(masked):
            held = {at: chosen(bit, each.written[at], held[at]) for at, bit in each.flag.items()}
        self.analog[name] = held
        return held

    def run(self, op: Op, level: int | None) -> None:
        """Run one word in all pixels, with IN at `level` steps."""
        forms, true_bit = self.forms, self.forms.diagrams.one
        row = op.operation
        match row.effect:
            case WordEffect.NONE:
                return
            case WordEffect.FLAG_ALL:
                self.digital["FLAG"] = dict.fromkeys(forms.places(), true_bit)
            case WordEffect.FLAG_DIGITAL:
                self.digital["FLAG"] = self._or_sources(op)
            case WordEffect.FLAG_ANALOG:
                before, totals = self.digital["FLAG"], self._totals(op, level, Fraction(1))
                flags = {at: forms.positive(total, at) for at, total in totals.items()}
                if self.container.target.where_obeys_flag:
                    times = forms.diagrams.times
                    flags = {at: times(bit, before[at]) for at, bit in flags.items()}
                self.digital["FLAG"] = flags
            case WordEffect.BUS:
                self._bus(op, level)
            case WordEffect.DIGITAL_NEIGHBOURS:
                self._write(op.destinations[0], self._or_neighbours(op))
            case WordEffect.DIGITAL:
                self._digital(op)
            case _:
                raise PictureReplayError(f"`{op}` cannot run after the exposure")

    def _totals(
        self, op: Op, level: int | None, factor: Fraction, flag: Bits | None = None
    ) -> Fields:
        """Return the sum of a word's analog sources in every pixel, times a factor; with `flag`,
        correct only where `flag` is 1."""
        forms = self.forms
        fields: list[Fields | Mapping[tuple[int, int], Form]] = []
        for name in op.sources:
            if name == "IN":
                if level is None:
                    raise PictureReplayError(f"`{op}` reads IN, which is not set")
                steps = {IN: forms.diagrams.leaf(Fraction(level))} if level else {}
                fields.append(dict.fromkeys(forms.places(), steps))
            elif name in NEIGHBOURS:
                fields.append(self._moved(self.fields("NEWS"), *STEPS[name]))
                if not self.container.target.news_read_keeps:
                    self.analog["NEWS"] = {at: forms.beyond() for at in forms.places()}
            elif name in self.analog:
                fields.append(self.fields(name, flag))
            else:
                raise PictureReplayError(f"`{op}` reads {name} after the exposure")
        return {at: forms.sum(*((factor, field[at]) for field in fields)) for at in forms.places()}

    def _moved(self, fields: Fields, right: int, down: int) -> Fields:
        """Return for each pixel the value of the pixel `right` columns and `down` rows away."""
        return {
            (x, y): fields[place]
            if (place := (x + right, y + down)) in fields
            else self.forms.beyond()
            for x, y in fields
        }

    def _bus(self, op: Op, level: int | None) -> None:
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
        """Return the OR of a word's digital sources."""
        diagrams = self.forms.diagrams
        bits = dict.fromkeys(self.forms.places(), diagrams.zero)
        for name in op.sources:
            bits = {at: diagrams.either(bit, self.digital[name][at]) for at, bit in bits.items()}
        return bits

    def _or_neighbours(self, op: Op) -> Bits:
        """Return the OR of a source in those neighbours that a pixel chooses."""
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

    def _digital(self, op: Op) -> None:
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
        for name in sorted(op.destinations, key=lambda name: name != target.masked_register):
            self._write(name, value)

    def _write(self, name: str, value: Bits) -> None:
        target, diagrams = self.container.target, self.forms.diagrams
        if name == target.masked_register and target.mask_register is not None:
            mask, previous = self.digital[target.mask_register], self.digital[name]
            value = {at: diagrams.chosen(mask[at], bit, previous[at]) for at, bit in value.items()}
        self.digital[name] = dict(value)
