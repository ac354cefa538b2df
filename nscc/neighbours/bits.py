"""Emit the words of planes: comparisons, logic, and bits of neighbours."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace

from nscc.neighbours.digital_registers import DigitalRegisters, Kept
from nscc.neighbours.held import Held
from nscc.neighbours.steered_reads import SteeredRead, steered_read
from nscc.operations import STEERING, op, pair
from nscc.words import pictures as p

_OF_STEP = {step: name for name, step in STEERING.items()}
"""The register of R1 to R4 that chooses a nearest neighbour, by the neighbour's offset."""
Offset = tuple[int, int]
"""An offset: columns to the right and rows down."""


class BitWords(DigitalRegisters):
    """The words that fill the digital registers while images and planes are compiled."""

    def declare(self, name: str, node: p.Condition) -> None:
        """Emit the words that compute the plane `name`, which then owns the register of the result.

        If the condition is only the name of another plane, its bits are copied. Programs of version
        4 take over that plane's register instead if nothing else reads it; words of older programs
        stay as they are. A plane that nothing reads loses its register at once. Raises
        PictureRefused if registers run out."""
        register, owner = self.shortest(node)
        taken_over = self.lowering.saves_words and owner and self.hand_over(owner)
        if owner is not None and not taken_over:
            register = self.emit_word("MOV", [register], [(register, owner)])
        self.planes[name] = register
        # `give` takes back one use, and so frees the register of a plane that nothing reads.
        self.uses[name] = self.uses.get(name, 0) + 1
        self.give((register, name))

    def next_bits(self, states: Sequence[p.KeptPlane]) -> dict[str, Kept]:
        """Emit the words that compute the next values of states, and return them by name, each as
        (register, plane that owns it or None).

        `step` writes them to the states' registers later. States that keep their bits are refreshed
        (written again), so that they do not fade, and left out of the result. Raises PictureRefused
        if registers run out."""
        names: set[str] = {state.name for state in states}
        nexts: dict[str, Kept] = {}
        for state in states:
            self.lowering.now = state.name
            self.begin(state.name)
            if state.next == p.Bit(state.name):
                self.refresh(state.name)
                # That was the read by its own next value.
                self.uses[state.name] -= 1
            else:
                bit = self.shortest(state.next)
                # That state may step first. Without a register for a copy, it has to step later.
                if bit[1] in names and self.free:
                    bit = self.emit_word("MOV", [bit[0]], [bit]), None
                nexts[state.name] = bit
        return nexts

    def step(self, nexts: dict[str, Kept]) -> None:
        """Emit the words that give all states their next values. `nexts` is the result of
        `next_bits`: (register, plane that owns it or None) by state.

        A state is written only when no other new value is still to be copied from its register.
        Raises PictureRefused if the states wait for each other in a circle."""
        waiting = dict(nexts)
        while waiting:
            read = {owner for _, owner in waiting.values()}
            name = next((name for name in waiting if name not in read), None)
            if name is None:  # each waits for another, and `next_bits` had no register for a copy
                raise self.no_free_register()
            bit = waiting.pop(name)
            # No later value is copied from the register of the last state, so the word that
            # computed its value may write it. Words of older programs stay as they are.
            if self.lowering.saves_words and not waiting:
                self.store(name, bit)
                continue
            self.lowering.word(op("MOV", [self.planes[name]], [bit[0]]))
            self.give(bit)

    def store(self, name: str, bit: Kept) -> None:
        """Emit a word that writes a bit, (register, owner), to the register of the plane `name`;
        the bit has then been read.

        If the word before wrote the bit, which nothing else reads, that word writes the plane's
        register instead, unless it reads that register."""
        self.write(self.planes[name], bit)

    def to_flag(self, node: p.Condition) -> None:
        """Emit words that set FLAG (the bit that lets a pixel act) to 1 in the pixels where a
        condition holds, and to 0 elsewhere.

        Raises PictureRefused if registers run out."""
        bit = self.bit(node)
        self.lowering.word(op("WHERE", [], [bit[0]]))
        self.give(bit)

    def shortest(self, node: p.Condition) -> Kept:
        """Emit the words that compute a condition, as `bit` does; reads of neighbours under
        conditions become one read if that needs fewer words."""
        read = steered_read(node) if self.lowering.saves_words else None
        if read is None:
            return self.bit(node)
        ways = [lambda: self.bit(node), lambda: self._steered(node, read, in_flag=False)]
        # FLAG saves a register, unless comparisons of the guards write FLAG themselves.
        guards = [part for guard in read.guards.values() for part in p.subexpressions(guard)]
        if isinstance(read.source, p.Bit) and not any(isinstance(n, p.Source) for n in guards):
            ways += [lambda: self._steered(node, read, in_flag=True)] if read.rest else []
        return self.lowering.do_shortest(ways, [1] * len(ways))

    def bit(self, node: p.Condition) -> Kept:
        """Emit the words that compute a condition; return its register and the plane that owns it.

        The owner is None for an intermediate result, whose register the caller gives back by
        `give`. A `Bit` (the name of a plane) needs no words, nor does a condition that a register
        still holds. Raises PictureRefused if registers run out; propagations and repeated planes
        must not occur."""
        if isinstance(node, p.Bit):
            return self.planes[node.name], node.name
        register = self.known.get(node, "")
        owner = next((name for name, of in self.planes.items() if of == register), None)
        if owner is not None:
            self.uses[owner] += 1
        elif register in self.free:
            self.free.remove(register)
        else:
            result = self._computed(node)
            # Counts are counted ahead, so their reads cannot be left out.
            parts = p.subexpressions(node)
            if self.lowering.saves_words and not any(
                isinstance(part, p.Agreement) for part in parts
            ):
                self.known[node] = result[0]
            return result
        self.skip(node)
        return register, owner

    def _computed(self, node: p.Condition) -> Kept:
        """Emit the words of a condition that is not a plane's name, and return what `bit` does."""
        match node:
            case p.Constant():
                register = self.take()
                self.lowering.word(op("SET" if node.bit else "CLR", [register]))
                return register, None
            case p.Above() | p.AboveParam() | p.Exceeds():
                return self._above(node), None
            case p.Neither():
                bits = self._operands(node.first, node.second)
                return self._nor([register for register, _ in bits], bits), None
            case p.ChosenPlane():
                return self._chosen(node)
            case p.Inverse():
                simpler = p.inverse_of(node.condition)
                if self.lowering.saves_words and simpler != node:
                    return self.bit(simpler)
                inner = self.bit(node.condition)
                return self.emit_word("NOT", [inner[0]], [inner]), None
            case p.Joined():
                return self._joined(node), None
            case p.At():
                bit, outside = self.bit(node.condition), self.lowering.pictures.outside or 0
                moved = self._moved(bit[0], outside, (node.right, node.down))
                self.give(bit)
                return moved, None
            case p.Near():
                return self._near_bit(node), None
        raise AssertionError("propagations and repeated planes are no part of another expression")

    def _chosen(self, node: p.ChosenPlane) -> Kept:
        """Emit the words of a choice between two bits, and return the register of the result.

        The result is the NOR of the two ways in which it is 0. The longer one of both expressions
        comes first, so that chains of choices need few registers. Raises PictureRefused if
        registers run out."""
        condition = node.condition
        if not isinstance(condition, p.Bit):  # it is read twice, but computed once
            register, owner = self.bit(condition)
            if owner is None:
                self.choices += 1
                owner = f"choice {self.choices}"
                self.planes[owner], self.uses[owner] = register, 1
            condition = p.Bit(owner)
            node = replace(node, condition=condition)
        ways = [p.Neither(node.then, p.Inverse(condition)), p.Neither(node.otherwise, condition)]
        ways.sort(key=lambda way: -len([*p.subexpressions(way.first)]))
        result = p.Neither(*ways)
        self.read_instead(node, result)
        return self.bit(result)

    def _steered(self, node: p.Condition, read: SteeredRead, *, in_flag: bool) -> Kept:
        """Emit the words of a condition as one read of the neighbours that R1 to R4 choose.

        With `in_flag`, the rest of the condition comes first and waits in FLAG, which takes a word
        more and a register less. Raises PictureRefused if registers run out."""
        self.read_instead(node, *read.conditions)
        if in_flag and read.rest is not None:
            self.to_flag(read.rest)
        source = self.bit(read.source)
        register = source[0]
        for name, guard in read.guards.items():
            self.write(name, self.bit(guard))
            # DNEWS cannot write the register that it reads; a copy leaves the plane's own free.
            register = name if guard == read.source else register
        self.steer(frozenset(), frozenset(read.guards))
        outside = self.lowering.pictures.outside
        moved = self.emit_word("DNEWS1" if outside else "DNEWS0", [register], [source]), None
        if read.rest is None:
            return moved
        if in_flag:
            return self.emit_word("OR", [moved[0], "FLAG"], [moved]), None
        rest = self.bit(read.rest)
        return self.emit_word("OR", [moved[0], rest[0]], [moved, rest]), None

    def _operands(self, *nodes: p.Condition) -> list[Kept]:
        """Emit the words of conditions and return their bits, each (register, owner), as sources of
        one OR or NOR word.

        From version 4 on, a condition that is an `or` of planes only gives a bit for each plane. If
        the word would then have more sources than the chip allows, each condition gives one bit."""
        flat: list[p.Condition] = []
        for node in nodes:
            planes = _planes_of_or(node) if self.lowering.saves_words else []
            flat += planes or [node]
        most = self.or_sources
        return [self.bit(node) for node in (flat if most is None or len(flat) <= most else nodes)]

    def _nor(self, registers: Sequence[str], used: Sequence[Kept]) -> str:
        """Emit the NOR of these registers and return the register of the result.

        Some registers may be equal; if all are, the word is a NOT. `used` are the bits, each
        (register, owner), that have then been read."""
        return self.emit_word("NOR" if len({*registers}) > 1 else "NOT", registers, used)

    def compare(self, node: p.Comparison, value: Held) -> None:
        """Emit the word `where`, which sets FLAG (the bit that lets a pixel act) to whether a value
        is above the level of the comparison `node`.

        `value` is the register of the compared value, which is not given back. The word tests
        whether the sum of the register and IN (the level sent to all pixels) is above 0, and IN is
        minus the level. If the register holds minus the value, FLAG is the inverse of the answer.
        """
        lowering, param = self.lowering, ""
        match node:
            case p.Above():
                steps = node.steps
            case p.AboveParam():
                steps, param = node.factor, node.param
            case p.Exceeds():
                # `count_unit` chose the steps of a count so that this is a whole number.
                steps = int(node.level * self.count_steps)
        lowering.everywhere()
        level = -steps * value.sign
        sources = [value.register, *(["IN"] if level else [])]
        lowering.word(op("where", [], sources), (param, level) if param else level or None)

    def _above(self, node: p.Comparison) -> str:
        """Emit the comparison `node`, and return the digital register of its answer, 1 where the
        value is above the level.

        FLAG (the bit that lets a pixel act) is 1 in all pixels afterwards."""
        lowering = self.lowering
        value = lowering.value(node.value)
        self.compare(node, value)
        lowering.give(value)
        register = self.take()
        lowering.word(op("MOV" if value.sign > 0 else "NOT", [register], ["FLAG"]))
        lowering.everywhere()
        return register

    def _joined(self, node: p.Joined) -> str:
        """Emit `or` or `xor` of two conditions, or before version 4 `and`; return the register of
        the result.

        `or` takes one OR word, and `and` is the NOR of both inverses. From version 4 on, `xor` is
        the OR of the two ways in which one bit is 1 and the other 0, before it the NOR of `and` and
        the NOR of both. Raises PictureRefused if registers run out."""
        planes = self._operands(node.first, node.second) if node.op == "or" else []
        if planes:
            registers = [register for register, _ in planes]
            # An OR word needs two different sources: a plane `or` itself is a copy.
            return self.emit_word("OR" if len({*registers}) > 1 else "MOV", registers, planes)
        first, second = self.bit(node.first), self.bit(node.second)
        a, b = first[0], second[0]
        if a == b:  # a plane `and` itself is the plane; `xor` itself is 0
            name, sources = ("CLR", []) if node.op == "xor" else ("MOV", [a])
            return self.emit_word(name, sources, [first, second])
        if self.lowering.saves_words:
            neither = self.emit_word("NOR", [a, b], used=[])
            only_b = self.emit_word("NOR", [a, neither], used=[first])
            only_a = self.emit_word("NOR", [b, neither], used=[second, (neither, None)])
            return self.emit_word("OR", [only_a, only_b], [(only_a, None), (only_b, None)])
        not_a = self.emit_word("NOT", [a], used=[])
        not_b = self.emit_word("NOT", [b], used=[])
        both = self.emit_word("NOR", [not_a, not_b], [(not_a, None), (not_b, None)])
        if node.op == "and":
            self.give(first, second)
            return both
        neither = self.emit_word("NOR", [a, b], [first, second])
        return self.emit_word("NOR", [both, neither], [(both, None), (neither, None)])

    # --- neighbours

    def _or_of_neighbours(self, register: str, outside: int, steps: frozenset[Offset]) -> str:
        """Emit a word that gives each pixel the OR of a register's bits in some nearest neighbours.

        `steps` are the offsets (columns right, rows down) of these neighbours, each of length 1.
        `outside` is the bit, 0 or 1, of pixels beyond the array. Return the register of the result;
        `register` stays occupied."""
        directions = frozenset(_OF_STEP[step] for step in steps)
        self.steer(directions)
        return self.emit_word("DNEWS1" if outside else "DNEWS0", [register], used=[])

    def _moved(self, register: str, outside: int, at: Offset) -> str:
        """Emit words that fetch the bit of the pixel at the offset `at` (columns right, rows down),
        one pixel per word; return its register.

        The bit moves along the row first. `outside` is the bit, 0 or 1, of pixels beyond the array.
        For (0, 0), the bit is copied. `register` stays occupied."""
        x, y = at
        steps = [(1 if x > 0 else -1, 0)] * abs(x) + [(0, 1 if y > 0 else -1)] * abs(y)
        moved = None
        for step in steps:
            source = moved or register
            if moved is not None and not self.free and self.lowering.saves_words:
                self.lowering.word(op("WHERE", [], [moved]))
                self.give((moved, None))
                source, moved = "FLAG", None
            neighbour = self._or_of_neighbours(source, outside, frozenset({step}))
            if moved is not None:
                self.give((moved, None))
            moved = neighbour
        return moved or self.emit_word("MOV", [register], used=[])

    def neighbour_bits(
        self, register: str, offsets: Collection[Offset]
    ) -> Iterator[tuple[Offset, str]]:
        """Yield each offset (columns right, rows down) with a register that holds the bit of the
        pixel at this offset.

        The bits move along the row, and from there along each column. A step always leads away from
        the pixel, so that no bit is lost beyond the border of the array. A register is valid until
        the next result. `register` holds the bits themselves, and is the result for (0, 0)."""
        for right in (1, -1):
            line = register
            # The own column (distance 0) belongs to the way to the right only.
            for distance in range(right < 0, 1 + max(right * x for x, _ in offsets)):
                x = right * distance
                if x:
                    line = self._stepped(line, register, (right, 0))
                if (x, 0) in offsets:
                    yield (x, 0), line
                yield from self._column(line, x, offsets)
            if line != register:
                self.give((line, None))

    def _column(
        self, line: str, x: int, offsets: Collection[Offset]
    ) -> Iterator[tuple[Offset, str]]:
        """Yield the offsets above and below column `x` of the row, with the registers of their
        bits.

        `x` is the number of columns to the right, and `line` the register of the bit at (x, 0).
        Offsets of other columns are left out. A register is valid until the next result."""
        for down in (1, -1):
            cell = line
            for y in range(1, 1 + max((down * b for a, b in offsets if a == x), default=0)):
                cell = self._stepped(cell, line, (0, down))
                if (x, down * y) in offsets:
                    yield (x, down * y), cell
            if cell != line:
                self.give((cell, None))

    def _stepped(self, register: str, first: str, step: Offset) -> str:
        """Emit a word that gives each pixel the bit of `register` in the neighbour at the offset
        `step`; return the register of the result.

        `register` is freed unless it is `first`, which holds the bits before all steps."""
        outside = self.lowering.pictures.outside or 0
        neighbour = self._or_of_neighbours(register, outside, frozenset({step}))
        if register != first:
            self.give((register, None))
        return neighbour

    def _near_bit(self, node: p.Near) -> str:
        """Emit `any` or `all` of a condition's bits under a convolution kernel, and return the
        register of the result.

        Only the offsets of the kernel's weights count. `any` is an OR of neighbours, and `all` the
        inverse of `any` of the inverses."""
        offsets = set(self.lowering.weights[node.kernel].taps)
        outside = self.lowering.pictures.outside or 0
        bit = self.bit(p.Inverse(node.condition) if node.kind == "all" else node.condition)
        if node.kind == "all":
            outside = 1 - outside  # the pixels beyond the array are inverted as well
        register = self._any(bit[0], outside, offsets)
        self.give(bit)
        if node.kind == "all":
            return self.emit_word("NOT", [register], [(register, None)])
        return register

    def _any(self, register: str, outside: int, offsets: set[Offset]) -> str:
        """Emit the OR of a register's bits in the pixels at these offsets (columns right, rows
        down), and return the register of the result.

        For a full rectangle, the OR along rows comes first, then that along columns. `outside` is
        the bit, 0 or 1, of pixels beyond the array. `register` stays occupied."""
        rows, cols = {y for _, y in offsets}, {x for x, _ in offsets}
        if len(rows) > 1 and len(cols) > 1 and len(offsets) == len(rows) * len(cols):
            line = self._line(register, outside, {(x, 0) for x in cols})
            result = self._line(line, outside, {(0, y) for y in rows})
            self.give((line, None))
            return result
        return self._line(register, outside, offsets)

    def _line(self, register: str, outside: int, offsets: set[Offset]) -> str:
        """Emit the OR of a register's bits in the pixels at these offsets (columns right, rows
        down), and return the register of the result.

        One word reads all nearest neighbours; every other bit is moved here first. Without offsets,
        or with (0, 0) only, the bits are copied. `outside` is the bit, 0 or 1, of pixels beyond the
        array."""
        nearest_offsets = frozenset(offsets & set(_OF_STEP))
        registers = (
            [self._or_of_neighbours(register, outside, nearest_offsets)] if nearest_offsets else []
        )
        for at in sorted(offsets - nearest_offsets - {(0, 0)}):
            registers.append(self._moved(register, outside, at))
        if not registers:
            return self.emit_word("MOV", [register], used=[])
        total, *further_registers = registers
        for further in further_registers:
            for word in pair("OR", total, [total, further]):
                self.lowering.word(word)
            self.give((further, None))
        if (0, 0) in offsets:
            return self.emit_word("OR", [total, register], [(total, None)])
        return total


def _planes_of_or(node: p.Condition) -> list[p.Condition]:
    """Return the planes that an `or` combines, also nested ones, or a single plane; [] for any
    other condition.

    An `or` with an operand that is neither a plane nor such an `or` also gives []."""
    if isinstance(node, p.Bit):
        return [node]
    if not isinstance(node, p.Joined) or node.op != "or":
        return []
    first, second = _planes_of_or(node.first), _planes_of_or(node.second)
    return [*first, *second] if first and second else []
