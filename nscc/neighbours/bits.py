"""The words of planes: comparisons, logic, and bits of neighbours."""

from __future__ import annotations

from collections.abc import Sequence

from nscc.neighbours.held import Emitter, Refused
from nscc.operations import STEERING, op, pair
from nscc.words import pictures as p

_OF_STEP = {step: name for name, step in STEERING.items()}
Offset = tuple[int, int]


class BitWords:
    """The digital registers of a lowering, and the words that fill them.

    The registers that steer DNEWS are kept for it where the text reads neighbours.
    """

    def __init__(self, lowering: Emitter, registers: Sequence[str]) -> None:
        self.lowering = lowering
        pictures = lowering.pictures
        nodes = [node for item in pictures.items for node in p.every(item.node)]
        self.steers = any(isinstance(node, p.Near | p.At) for node in nodes)
        self.available = [r for r in registers if not (self.steers and r in STEERING)]
        self.free = list(self.available)
        self.planes: dict[str, str] = {}
        self.uses: dict[str, int] = {}
        for node in nodes:
            if isinstance(node, p.Bit):
                self.uses[node.name] = self.uses.get(node.name, 0) + 1
        for name in pictures.wanted:
            self.uses[name] = self.uses.get(name, 0) + 1
        self.steered: frozenset[str] | None = None

    def declare(self, name: str, node: p.Condition) -> None:
        """Computes a plane, and keeps it while it is read."""
        register, mine = self.bit(node)
        if not mine:
            copy = self.take()
            self.lowering.word(op("MOV", [copy], [register]))
            register = copy
        self.planes[name] = register
        self._release(name)

    def take(self) -> str:
        """A register that is free."""
        if not self.free:
            count = len(self.available)
            raise Refused("planes", self.lowering.now, count + 1, count)
        return self.free.pop(0)

    def give(self, register: str, mine: bool) -> None:
        """A register whose bit nobody reads any more."""
        if mine:
            self.free.append(register)
            self.free.sort(key=self.available.index)

    def _release(self, name: str) -> None:
        if not self.uses.get(name):
            self.give(self.planes.pop(name), True)

    def to_flag(self, node: p.Condition) -> None:
        """FLAG is 1 where a condition is."""
        register, mine = self.bit(node)
        self.lowering.word(op("WHERE", [], [register]))
        self.give(register, mine)

    def bit(self, node: p.Condition) -> tuple[str, bool]:
        """The register of a condition, and whether nobody else reads it."""
        match node:
            case p.Bit():
                self.uses[node.name] -= 1
                register = self.planes[node.name]
                if self.uses[node.name]:
                    return register, False
                del self.planes[node.name]
                return register, True
            case p.Constant():
                register = self.take()
                self.lowering.word(op("SET" if node.bit else "CLR", [register]))
                return register, True
            case p.Above():
                return self._above(node), True
            case p.Inverse():
                register, mine = self.bit(node.condition)
                return self._made("NOT", [register], [(register, mine)]), True
            case p.Joined():
                return self._joined(node), True
            case p.At():
                return self._at(node), True
            case p.Near():
                return self._near(node), True

    def _made(self, name: str, sources: Sequence[str], used: Sequence[tuple[str, bool]]) -> str:
        """A register that a word fills; the bits that were `used` are then given back."""
        target = self.take()
        self.lowering.word(op(name, [target], sources))
        for register, mine in used:
            self.give(register, mine)
        return target

    def _above(self, node: p.Above) -> str:
        """A comparison: `where` asks whether the value and IN together are above 0."""
        lowering = self.lowering
        value = lowering.value(node.value)
        lowering.everywhere()
        level = -node.steps * value.sign
        sources = [value.register, *(["IN"] if level else [])]
        lowering.word(op("where", [], sources), level or None)
        lowering.give(value)
        register = self.take()
        # What is held may be minus the value: then FLAG says the opposite.
        lowering.word(op("MOV" if value.sign > 0 else "NOT", [register], ["FLAG"]))
        lowering.everywhere()
        return register

    def _joined(self, node: p.Joined) -> str:
        """`or` is one word, `and` the inverse of that of the inverses."""
        left, right = self.bit(node.left), self.bit(node.right)
        a, b = left[0], right[0]
        if a == b:
            made = self._made("CLR" if node.op == "xor" else "MOV",
                              [] if node.op == "xor" else [a], [left])  # fmt: skip
            return made
        if node.op == "or":
            return self._made("OR", [a, b], [left, right])
        not_a = self._made("NOT", [a], [])
        not_b = self._made("NOT", [b], [])
        both = self._made("NOR", [not_a, not_b], [(not_a, True), (not_b, True)])
        if node.op == "and":
            self.give(*left)
            self.give(*right)
            return both
        neither = self._made("NOR", [a, b], [left, right])
        return self._made("NOR", [both, neither], [(both, True), (neither, True)])

    # --- neighbours

    def _steer(self, step: Offset | None, steps: frozenset[Offset] = frozenset()) -> None:
        """R1..R4 choose these neighbours, in all pixels."""
        wanted = frozenset(_OF_STEP[each] for each in (steps or {step} if step else steps))
        if wanted == self.steered:
            return
        self.lowering.word(op("CLR", list(STEERING)))
        self.lowering.word(op("SET", sorted(wanted)))
        self.steered = wanted

    def _look(self, register: str, outside: int, steps: frozenset[Offset]) -> str:
        """The OR of the bits of these neighbours."""
        self._steer(None, steps)
        return self._made("DNEWS1" if outside else "DNEWS0", [register], [])

    def _moved(self, register: str, outside: int, at: Offset) -> tuple[str, bool]:
        """The bit of the pixel so far away, one step at a time."""
        x, y = at
        steps = [(1 if x > 0 else -1, 0)] * abs(x) + [(0, 1 if y > 0 else -1)] * abs(y)
        mine = False
        for step in steps:
            moved = self._look(register, outside, frozenset({step}))
            self.give(register, mine)
            register, mine = moved, True
        return register, mine

    def _at(self, node: p.At) -> str:
        register, mine = self.bit(node.condition)
        outside = self.lowering.pictures.outside or 0
        moved, own = self._moved(register, outside, (node.right, node.down))
        if not own:
            moved = self._made("MOV", [register], [])
        self.give(register, mine)
        return moved

    def _near(self, node: p.Near) -> str:
        """`any`: the OR of neighbours; `all`: the inverse of any of the inverse."""
        offsets = set(self.lowering.weights[node.kernel].taps)
        outside = self.lowering.pictures.outside or 0
        register, mine = self.bit(node.condition)
        if node.kind == "all":
            register, mine = self._made("NOT", [register], [(register, mine)]), True
            outside = 1 - outside
        found = self._any(register, outside, offsets)
        self.give(register, mine)
        if node.kind == "all":
            return self._made("NOT", [found], [(found, True)])
        return found

    def _any(self, register: str, outside: int, offsets: set[Offset]) -> str:
        """The OR of the bits at these offsets: of rectangles row by row, then column by column."""
        rows, cols = {y for _, y in offsets}, {x for x, _ in offsets}
        if len(rows) > 1 and len(cols) > 1 and len(offsets) == len(rows) * len(cols):
            line = self._line(register, outside, {(x, 0) for x in cols})
            found = self._line(line, outside, {(0, y) for y in rows})
            self.give(line, True)
            return found
        return self._line(register, outside, offsets)

    def _line(self, register: str, outside: int, offsets: set[Offset]) -> str:
        """The OR of the bits at these offsets: nearest neighbours in one word, others step by
        step."""
        near = frozenset(offsets & set(_OF_STEP))
        parts = [self._look(register, outside, near)] if near else []
        for at in sorted(offsets - near - {(0, 0)}):
            parts.append(self._moved(register, outside, at)[0])
        total = parts.pop(0) if parts else None
        for part in parts:
            total = self._or(total, part)
        if (0, 0) in offsets:
            if total is None:
                return self._made("MOV", [register], [])
            return self._made("OR", [total, register], [(total, True)])
        assert total is not None
        return total

    def _or(self, first: str | None, second: str) -> str:
        """The OR of two bits of ours, in the place of the first."""
        assert first is not None
        for word in pair("OR", first, [first, second]):
            self.lowering.word(word)
        self.give(second, True)
        return first
