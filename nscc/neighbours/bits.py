"""Emit the words of planes: comparisons, logic, and bits of neighbours."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

from nscc.neighbours.held import Emitter, Held, PictureRefused
from nscc.operations import STEERING, Phase, WordEffect, op, pair
from nscc.words import pictures as p

_OF_STEP = {step: name for name, step in STEERING.items()}
"""The register of R1 to R4 that chooses a nearest neighbour, by the neighbour's offset."""
Offset = tuple[int, int]
"""An offset: columns to the right and rows down."""
Kept = tuple[str, str | None]
"""A register that holds a bit, and the plane it belongs to, or None for an intermediate result."""


class BitWords:
    """The digital registers while images and planes are compiled, and the words that fill them.

    `planes` has the register of each plane by name, `uses` the number of its reads that are left,
    and `free` the free registers. `steered` are the directions that R1 to R4 choose now, None if
    unknown. R1 to R4, which choose the neighbours to read, are reserved until the last item that
    reads bits of neighbours. States are in registers that no word of the exposure writes."""

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
        self.steered: frozenset[str] | None = None
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

    def declare(self, name: str, node: p.Condition) -> None:
        """Emit the words that compute the plane `name`, which then owns the register of the result.

        If the condition is only the name of another plane, its bits are copied. Programs of version
        4 take over that plane's register instead if nothing else reads it; words of older programs
        stay as they are. A plane that nothing reads loses its register at once. Raises
        PictureRefused if registers run out."""
        register, owner = self.bit(node)
        taken_over = self.lowering.saves_words and owner and self.hand_over(owner)
        if owner is not None and not taken_over:
            register = self._emit_word("MOV", [register], [(register, owner)])
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
                bit = self.bit(state.next)
                # That state may step first. Without a register for a copy, it has to step later.
                if bit[1] in names and self.free:
                    bit = self._emit_word("MOV", [bit[0]], [bit]), None
                nexts[state.name] = bit
        return nexts

    def refresh(self, name: str) -> None:
        """Emit the words that write the plane `name` again, so that its register keeps the bits for
        another frame.

        `name` must have a register."""
        register = self.planes[name]
        for word in pair("REFRESH", register, [register]):
            self.lowering.word(word)

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
                raise self._no_free_register()
            bit = waiting.pop(name)
            # No later value is copied from the register of the last state, so the word that
            # computed its value may write it. Words of older programs stay as they are.
            if self.lowering.saves_words and not waiting:
                self.store(name, bit)
                continue
            self.lowering.word(op("MOV", [self.planes[name]], [bit[0]]))
            self.give(bit)

    def copy(self, register: str, owner: str | None) -> str:
        """Emit a word that copies a bit to a free register, and return that register.

        `owner` is the plane that owns the bit, or None; the copy counts as a read. Raises
        PictureRefused if no register is free."""
        return self._emit_word("MOV", [register], [(register, owner)])

    def hand_over(self, name: str) -> bool:
        """Return whether the caller is the only remaining reader of the plane `name`.

        If so, the plane is forgotten, and its register belongs to the caller. Otherwise nothing
        changes."""
        if self.uses[name] != 1:
            return False
        self.uses[name] = 0
        del self.planes[name]
        return True

    def store(self, name: str, bit: Kept) -> None:
        """Emit a word that writes a bit, (register, owner), to the register of the plane `name`;
        the bit has then been read.

        If the word before wrote the bit, which nothing else reads, that word writes the plane's
        register instead, unless it reads that register."""
        self.write(self.planes[name], bit)

    def write(self, register: str, bit: Kept) -> None:
        """Emit a word that writes a bit, (register, owner), to any digital register; the bit has
        then been read.

        If the word before wrote the bit to a register without an owner, that word writes `register`
        instead, unless it reads `register`."""
        (source, owner), words = bit, self.lowering.words
        # A comparison ends with a word that sets FLAG everywhere; the word before wrote the bit.
        index = -2 if words[-1][0].operation.effect is WordEffect.FLAG_ALL else -1
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
        else:
            self.lowering.word(op("MOV", [register], [source]))
        self.give(bit)

    def take(self) -> str:
        """Return a free digital register, which is then occupied; raise PictureRefused if there is
        none."""
        if not self.free:
            raise self._no_free_register()
        return self.free.pop(0)

    def vacate(self, register: str) -> None:
        """Occupy the digital register `register`. A plane that it holds moves to a free register;
        raise PictureRefused if there is none."""
        for name, of_plane in self.planes.items():
            if of_plane == register:
                self.planes[name] = self.take()
                self.lowering.word(op("MOV", [self.planes[name]], [register]))
                return
        self.free.remove(register)

    def _no_free_register(self) -> PictureRefused:
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

    def to_flag(self, node: p.Condition) -> None:
        """Emit words that set FLAG (the bit that lets a pixel act) to 1 in the pixels where a
        condition holds, and to 0 elsewhere.

        Raises PictureRefused if registers run out."""
        bit = self.bit(node)
        self.lowering.word(op("WHERE", [], [bit[0]]))
        self.give(bit)

    def bit(self, node: p.Condition) -> Kept:
        """Emit the words that compute a condition; return its register and the plane that owns it.

        The owner is None for an intermediate result, whose register the caller gives back by
        `give`. A `Bit` (the name of a plane) needs no words. Raises PictureRefused if registers run
        out; propagations and repeated planes must not occur."""
        match node:
            case p.Bit():
                return self.planes[node.name], node.name
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
                return self._chosen(node), None
            case p.Propagated():
                raise AssertionError("a propagation is the step of a flood")
            case p.RepeatedPlane():
                raise AssertionError("a repeated plane is not part of another expression")
            case p.Inverse():
                inner = self.bit(node.condition)
                return self._emit_word("NOT", [inner[0]], [inner]), None
            case p.Joined():
                return self._joined(node), None
            case p.At():
                bit, outside = self.bit(node.condition), self.lowering.pictures.outside or 0
                moved = self._moved(bit[0], outside, (node.right, node.down))
                self.give(bit)
                return moved, None
            case p.Near():
                return self._near_bit(node), None

    def _emit_word(self, name: str, sources: Sequence[str], used: Sequence[Kept]) -> str:
        """Emit the word `name` with these source registers; return the register of the result.

        `used` are the bits, each (register, owner), that have then been read. Without a free
        register, two words overwrite the register of a bit of `used` with the result, if
        `_in_place` finds one. Raises PictureRefused otherwise."""
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
        if self.free or not self.lowering.saves_words or name not in ("OR", "NOR", "NOT"):
            return None
        for register, owner in used:
            if owner is None or self.hand_over(owner):
                return register, owner
        return None

    def _chosen(self, node: p.ChosenPlane) -> str:
        """Emit the words of a choice between two bits, and return the register of the result.

        The result is the NOR of the two ways in which it is 0. The longer one of both expressions
        comes first, so that chains of choices need few registers. Raises PictureRefused if
        registers run out."""
        then_size, otherwise_size = (
            len([*p.subexpressions(branch)]) for branch in (node.then, node.otherwise)
        )
        # `then_0`: the condition is 1, the first bit 0. `otherwise_0`: the condition is 0, the
        # second bit 0.
        if otherwise_size > then_size:
            otherwise, condition = self.bit(node.otherwise), self.bit(node.condition)
            otherwise_0 = self._nor([otherwise[0], condition[0]], used=[otherwise])
            then = self.bit(node.then)
            inverse = self._emit_word("NOT", [condition[0]], used=[condition])
            then_0 = self._nor([then[0], inverse], used=[then, (inverse, None)])
            return self._nor([then_0, otherwise_0], used=[(then_0, None), (otherwise_0, None)])
        then, condition = self.bit(node.then), self.bit(node.condition)
        inverse = self._emit_word("NOT", [condition[0]], used=[])
        then_0 = self._nor([then[0], inverse], used=[then, (inverse, None)])
        otherwise = self.bit(node.otherwise)
        sources = [otherwise[0], condition[0]]
        otherwise_0 = self._nor(sources, used=[otherwise, condition])
        return self._nor([then_0, otherwise_0], used=[(then_0, None), (otherwise_0, None)])

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
        return self._emit_word("NOR" if len({*registers}) > 1 else "NOT", registers, used)

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
        """Emit `and`, `or` or `xor` of two conditions, and return the register of the result.

        `or` takes one OR word, and `and` is the NOR of both inverses. From version 4 on, `xor` is
        the OR of the two ways in which one bit is 1 and the other 0, before it the NOR of `and` and
        the NOR of both. Raises PictureRefused if registers run out."""
        planes = self._operands(node.first, node.second) if node.op == "or" else []
        if planes:
            registers = [register for register, _ in planes]
            # An OR word needs two different sources: a plane `or` itself is a copy.
            return self._emit_word("OR" if len({*registers}) > 1 else "MOV", registers, planes)
        first, second = self.bit(node.first), self.bit(node.second)
        a, b = first[0], second[0]
        if a == b:  # a plane `and` itself is the plane; `xor` itself is 0
            name, sources = ("CLR", []) if node.op == "xor" else ("MOV", [a])
            return self._emit_word(name, sources, [first, second])
        saves_words = self.lowering.saves_words
        if node.op == "xor" and saves_words:
            neither = self._emit_word("NOR", [a, b], used=[])
            only_b = self._emit_word("NOR", [a, neither], used=[first])
            only_a = self._emit_word("NOR", [b, neither], used=[second, (neither, None)])
            return self._emit_word("OR", [only_a, only_b], [(only_a, None), (only_b, None)])
        not_a = self._emit_word("NOT", [a], used=[first] * saves_words)
        not_b = self._emit_word("NOT", [b], used=[second] * saves_words)
        both = self._emit_word("NOR", [not_a, not_b], [(not_a, None), (not_b, None)])
        if saves_words:
            return both
        if node.op == "and":
            self.give(first, second)
            return both
        neither = self._emit_word("NOR", [a, b], [first, second])
        return self._emit_word("NOR", [both, neither], [(both, None), (neither, None)])

    # --- neighbours

    def _or_of_neighbours(self, register: str, outside: int, steps: frozenset[Offset]) -> str:
        """Emit a word that gives each pixel the OR of a register's bits in some nearest neighbours.

        `steps` are the offsets (columns right, rows down) of these neighbours, each of length 1.
        `outside` is the bit, 0 or 1, of pixels beyond the array. Return the register of the result;
        `register` stays occupied."""
        directions = frozenset(_OF_STEP[step] for step in steps)
        if directions != self.steered:
            self.steer(directions)
        return self._emit_word("DNEWS1" if outside else "DNEWS0", [register], used=[])

    def steer(self, directions: frozenset[str]) -> None:
        """Emit the words that set R1 to R4 in every pixel, so that DNEWS reads the neighbours in
        these `directions`.

        `directions` are names of these registers. From version 4 on, they need not be cleared first
        if all four are set."""
        if len(directions) < len(STEERING) or not self.lowering.saves_words:
            self.lowering.word(op("CLR", list(STEERING)))
        self.lowering.word(op("SET", sorted(directions)))
        self.steered = directions

    def _moved(self, register: str, outside: int, at: Offset) -> str:
        """Emit words that fetch the bit of the pixel at the offset `at` (columns right, rows down),
        one pixel per word; return its register.

        The bit moves along the row first. `outside` is the bit, 0 or 1, of pixels beyond the array.
        For (0, 0), the bit is copied. `register` stays occupied."""
        x, y = at
        steps = [(1 if x > 0 else -1, 0)] * abs(x) + [(0, 1 if y > 0 else -1)] * abs(y)
        moved = None
        for step in steps:
            neighbour = self._or_of_neighbours(moved or register, outside, frozenset({step}))
            if moved is not None:
                self.give((moved, None))
            moved = neighbour
        return moved or self._emit_word("MOV", [register], used=[])

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
        bit = self.bit(node.condition)
        if node.kind == "all":
            bit = self._emit_word("NOT", [bit[0]], [bit]), None
            outside = 1 - outside  # the pixels beyond the array are inverted as well
        register = self._any(bit[0], outside, offsets)
        self.give(bit)
        if node.kind == "all":
            return self._emit_word("NOT", [register], [(register, None)])
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
            return self._emit_word("MOV", [register], used=[])
        total, *further_registers = registers
        for further in further_registers:
            for word in pair("OR", total, [total, further]):
                self.lowering.word(word)
            self.give((further, None))
        if (0, 0) in offsets:
            return self._emit_word("OR", [total, register], [(total, None)])
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
