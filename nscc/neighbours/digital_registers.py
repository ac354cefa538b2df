"""The digital registers while images and planes are compiled, and who owns them."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from nscc.neighbours.held import Emitter, PictureRefused
from nscc.operations import STEERING, Phase, WordEffect, op, pair
from nscc.words import pictures as p

Kept = tuple[str, str | None]
"""A register that holds a bit, and the plane it belongs to, or None for an intermediate result."""


class DigitalRegisters:
    """The digital registers while images and planes are compiled.

    `planes` has the register of each plane by name, `uses` the number of its reads that are left,
    and `free` the free registers. `steered` are those of R1 to R4 that are 1 in all pixels now, and
    those that differ from pixel to pixel, None if unknown. R1 to R4, which choose the neighbours to
    read, are reserved until the last item that reads bits of neighbours. `known` has the registers
    that still hold conditions; it stays empty before version 4, whose programs keep their words.
    States are in registers that no word of the exposure writes."""

    def __init__(
        self,
        lowering: Emitter,
        registers: Sequence[str],
        unwritten: Collection[str],
        or_sources: int | None,
    ) -> None:
        """Assign registers to kept and input planes, and count how often each plane is read.

        `lowering` emits the words. `registers` are the free digital registers. `unwritten` are
        those that the exposure's words never write, which can keep planes from frame to frame.
        `or_sources` is the most sources of an OR or NOR word, None for any number. Raises
        PictureRefused ("steering" or "planes") if there are too few registers."""
        self.lowering = lowering
        pictures = lowering.pictures
        expressions = pictures.expressions
        nodes = [node for each in expressions.values() for node in p.subexpressions(each)]
        self.steering = [*pictures.steering]
        self.count_steps, self.or_sources = pictures.count_steps, or_sources
        # R1 to R4 choose the neighbours to read, so planes may not occupy them meanwhile.
        self.kept_for_steering = [r for r in registers if self.steering and r in STEERING]
        if self.steering and len(self.kept_for_steering) < len(STEERING):
            available = len(self.kept_for_steering)
            raise PictureRefused("steering", self.steering[0], len(STEERING), available)
        self.available = [r for r in registers if r not in self.kept_for_steering]
        self.free = list(self.available)
        self.planes: dict[str, str] = {}
        self.uses: dict[str, int] = {}
        # A register becomes free after the last of these reads.
        for node in nodes:
            if isinstance(node, p.Bit):
                self.uses[node.name] = self.uses.get(node.name, 0) + 1
        for name in pictures.outputs:
            self.uses[name] = self.uses.get(name, 0) + 1
        self.steered: tuple[frozenset[str], frozenset[str]] | None = None
        self.known: dict[p.Condition, str] = {}
        self.choices = 0
        # A plane that is kept between frames needs a register that the exposure never writes.
        lasting = [register for register in self.free if register in unwritten]
        held = pictures.held_planes
        for name in held:
            if not lasting:
                raise PictureRefused("planes", name, len(held), len(self.planes))
            self.planes[name] = lasting.pop(0)
            self.free.remove(self.planes[name])
            self.uses[name] = self.uses.get(name, 0) + 1  # never freed

    def begin(self, name: str) -> None:
        """Begin the words of the image, plane or state `name`; items must begin in the order of the
        program.

        If neither this item nor a later one reads bits of neighbours, R1 to R4, which choose
        neighbours, become free."""
        if name in self.steering:
            self.steering.remove(name)
        elif not self.steering:
            self.available += self.kept_for_steering
            self.free += self.kept_for_steering
            self.kept_for_steering = []

    def refresh(self, name: str) -> None:
        """Emit the words that write the plane `name` again, so that its register keeps the bits for
        another frame.

        `name` must have a register."""
        register = self.planes[name]
        for word in pair("REFRESH", register, [register]):
            self.lowering.word(word)

    def copy(self, register: str, owner: str | None) -> str:
        """Emit a word that copies a bit to a free register, and return that register.

        `owner` is the plane that owns the bit, or None; the copy counts as a read. Raises
        PictureRefused if no register is free."""
        return self.emit_word("MOV", [register], [(register, owner)])

    def hand_over(self, name: str) -> bool:
        """Return whether the caller is the only remaining reader of the plane `name`.

        If so, the plane is forgotten, and its register belongs to the caller. Otherwise nothing
        changes."""
        if self.uses[name] != 1:
            return False
        self.uses[name] = 0
        del self.planes[name]
        return True

    def write(self, register: str, bit: Kept) -> None:
        """Emit a word that writes a bit, (register, owner), to any digital register; the bit has
        then been read.

        If the word before wrote the bit to a register without an owner, that word writes `register`
        instead, unless it reads `register`."""
        (source, owner), words = bit, self.lowering.words
        # A comparison ends with a word that sets FLAG everywhere; the word before wrote the bit.
        is_after = len(words) > 1 and words[-1][0].operation.effect is WordEffect.FLAG_ALL
        index = -2 if is_after else -1
        last = words[index][0]
        digital = last.operation.effect in (WordEffect.DIGITAL, WordEffect.DIGITAL_NEIGHBOURS)
        if (
            owner is None
            and digital
            # The second word of a pair must write a register that the first one reads.
            and last.operation.phase is Phase.WHOLE
            and last.destinations == (source,)
            and register not in last.sources
        ):
            words[index] = (op(last.name, [register], last.sources), None)
            self.forget((source, register))
        else:
            self.lowering.word(op("MOV", [register], [source]))
        self.give(bit)

    def take(self) -> str:
        """Return a free digital register, which is then occupied; raise PictureRefused if there is
        none."""
        if not self.free:
            raise self.no_free_register()
        # A register whose condition may be read again, and the mask of floods, are taken last.
        holding = {
            *self.known.values(),
            *(self.available[-1:] if self.lowering.saves_words else []),
        }
        register = min(self.free, key=holding.__contains__)
        self.free.remove(register)
        return register

    def vacate(self, register: str) -> None:
        """Occupy the digital register `register`. A plane that it holds moves to a free register;
        raise PictureRefused if there is none."""
        for name, of_plane in self.planes.items():
            if of_plane == register:
                self.planes[name] = self.take()
                self.lowering.word(op("MOV", [self.planes[name]], [register]))
                return
        self.free.remove(register)

    def no_free_register(self) -> PictureRefused:
        """Return the exception that the item whose words are emitted now needs one more digital
        register."""
        count = len(self.available)
        return PictureRefused("planes", self.lowering.now, count + 1, count)

    def give(self, *bits: Kept) -> None:
        """Note that bits, each a (register, plane that owns it or None), have been read once; free
        each register that nothing else reads.

        A bit without an owner is read only once. A plane without further reads is forgotten."""
        for register, owner in bits:
            if owner is not None:
                self.uses[owner] -= 1
                if self.uses[owner]:
                    continue
                del self.planes[owner]
            self.free.append(register)
            self.free.sort(key=self.available.index)

    def forget(self, registers: Collection[str]) -> None:
        """Note that these registers no longer hold the conditions that they held."""
        if self.known:
            self.known = {node: name for node, name in self.known.items() if name not in registers}

    def skip(self, node: p.Condition) -> None:
        """Count all reads of an expression as done, because its words are not needed."""
        for part in p.subexpressions(node):
            if isinstance(part, p.Bit):
                self.give((self.planes[part.name], part.name))
            elif isinstance(part, p.Source):
                self.lowering.give(self.lowering.held[part.name])

    def read_instead(self, node: p.Condition, *others: p.Condition) -> None:
        """Count the reads of `others`, whose words compute the condition `node` instead of its
        own."""
        for part in (part for other in others for part in p.subexpressions(other)):
            if isinstance(part, p.Bit):
                self.uses[part.name] += 1
            elif isinstance(part, p.Source):
                self.lowering.uses[part.name] += 1
        self.skip(node)

    def emit_word(self, name: str, sources: Sequence[str], used: Sequence[Kept]) -> str:
        """Emit the word `name` with these source registers; return the register of the result.

        `used` are the bits, each (register, owner), that have then been read. Without a free
        register, two words overwrite the register of a bit of `used` with the result, if
        `_in_place` finds one. Raises PictureRefused otherwise."""
        last = self.lowering.words[-1][0]
        # The inverse of an OR takes one word instead of both.
        is_of_or = last.name == "OR" and last.destinations == (*sources,)
        if name == "NOT" and self.lowering.saves_words and is_of_or and (sources[0], None) in used:
            self.lowering.words[-1] = op("NOR", last.destinations, last.sources), None
            self.forget(last.destinations)
            return sources[0]
        in_place = self._in_place(name, used)
        if in_place is not None:
            for word in pair("OR" if name == "OR" else "NOR", in_place[0], sources):
                self.lowering.word(word)
            self.give(*(bit for bit in used if bit != in_place))
            return in_place[0]
        target = self.take()
        self.lowering.word(op(name, [target], sources))
        self.give(*used)
        return target

    def _in_place(self, name: str, used: Sequence[Kept]) -> Kept | None:
        """Return the first bit (register, owner) of `used` whose register may be overwritten by the
        result of the word `name`.

        Its owner, if any, is then forgotten. Return None if a register is free, if no bit may be
        overwritten, if the word is not OR, NOR or NOT, or before version 4, whose programs keep
        their words."""
        is_of_version_4 = self.lowering.saves_words
        if self.free or not is_of_version_4 or name not in ("OR", "NOR", "NOT"):
            return None
        for register, owner in used:
            if owner is None or self.hand_over(owner):
                return register, owner
        return None

    def steer(self, chosen: frozenset[str], varying: frozenset[str] = frozenset()) -> None:
        """Emit the words that set the registers `chosen` of R1 to R4 in every pixel, so that DNEWS
        reads the neighbours in these directions, and clear the others.

        `varying` are those that other words write, with bits that differ from pixel to pixel. From
        version 4 on, only registers that change are written."""
        before = self.steered
        if before == (chosen, varying):
            return
        self.steered = chosen, varying
        if not self.lowering.saves_words:
            before, cleared = None, [*STEERING]
        else:
            kept = {*STEERING} if before is None else {*before[0], *before[1]}
            cleared = sorted(kept - chosen - varying)
        if cleared:
            self.lowering.word(op("CLR", cleared))
        changed = sorted(chosen - (before[0] if before else frozenset()))
        if changed:
            self.lowering.word(op("SET", changed))
