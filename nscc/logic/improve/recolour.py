"""Register allocation: values written in place get free registers instead.

NOT of a plane in place takes two words. NOT into a free register takes one word, and frees the old
register. So planes move in the frame, and are copied to their original registers ("homes") at the
end.

In straight-line code live ranges are intervals, so this is interval colouring from left to right
(linear scan; Poletto and Sarkar, ACM TOPLAS 21, 1999). It fails only if registers are excluded or
banned for values. The choice among free registers determines the number of words."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from nscc.logic.improve.code import CLOSING, Check, FrameContext, GateOp, Item
from nscc.truth import set_bits


@dataclass(slots=True)
class _Value:
    """The result of an operation, or the initial content of a register.

    `first` is the index of the item that computes it (-1: the initial content), `last` that of the
    last item that reads it. `home` is the register required at the end, -1 if none. `banned` is the
    bit mask of registers in which it would be overwritten, `sources` the indices of the values that
    the operation reads."""

    first: int
    last: int
    home: int = -1
    banned: int = 0
    sources: tuple[int, ...] = ()


def recoloured(frame: FrameContext, items: Sequence[Item]) -> list[Item] | None:
    """Return the same operations with other registers, and copies of planes (contents of code
    registers) to their homes at the end; None if there are too few registers.

    `items` are those of one frame, in order. The caller ensures that the result of every operation
    is read. The result may have more words than `items`, and may be illegal on the machine."""
    return _Painter(frame, items, *_values(frame, items)).paint()


def _values(frame: FrameContext, items: Sequence[Item]) -> tuple[list[_Value], list[int]]:
    """Return all values that registers hold while `items` run, and for each item the index of its
    result (-1 for checks).

    The first values are the initial contents, one for each register by number, the others the
    results in order. A value that nothing reads, nor needs at the end, has `last` equal to
    `first`."""
    values = [_Value(-1, -1) for _ in range(frame.flag + 1)]
    holds = list(range(frame.flag + 1))
    written = []
    for k, item in enumerate(items):
        if isinstance(item, Check):
            written.append(-1)
            if item.need is not None:
                values[holds[frame.flag]].last = k
            continue
        for register in set_bits(item.reads):
            values[holds[register]].last = k
        sources = tuple(holds[register] for register in item.sources)
        holds[item.destination] = len(values)
        written.append(len(values))
        values.append(_Value(k, k, sources=sources))
    for register in range(frame.planes):
        values[holds[register]].last = len(items)
        values[holds[register]].home = register
    # Checks at which registers lose their contents: a value that is read later must not be there.
    lossy = [
        (k, forgets)
        for k, item in enumerate(items)
        # A value in FLAG stays in FLAG, so its loss forbids no other register.
        if isinstance(item, Check) and (forgets := item.forgets & ~(1 << frame.flag))
    ]
    next_lossy = 0
    for value in values:
        while next_lossy < len(lossy) and lossy[next_lossy][0] < value.first:
            next_lossy += 1
        for k, forgets in lossy[next_lossy:]:
            if k >= value.last:
                break
            value.banned |= forgets
    return values, written


class _Painter:
    """An assignment of registers to values, made in execution order; make a new one for each run of
    `paint`."""

    def __init__(
        self, frame: FrameContext, items: Sequence[Item], values: list[_Value], written: list[int]
    ) -> None:
        """Begin with each initial value in its own register; the `values` that items write have no
        register yet (-1).

        `written` is the index of the value that each item writes, -1 for checks."""
        self.frame, self.items = frame, items
        self.values, self.written = values, written
        self.register_of = list(range(frame.flag + 1)) + [-1] * (len(values) - frame.flag - 1)
        # The value in each register; initial values without a reader do not count.
        self.holds: list[int] = list(range(frame.flag))
        # Where the value is written that a register must hold at the end.
        self.homing = [-1] * frame.flag
        for value in values:
            if value.home >= 0:
                self.homing[value.home] = value.first

    def paint(self) -> list[Item] | None:
        """Return the items with new registers and copies of planes (contents of code registers) to
        their homes; None if an operation finds no register, or if copies need one and none is free.

        Copies of a register to itself are left out."""
        out: list[Item] = []
        for k, item in enumerate(self.items):
            if isinstance(item, Check):
                out.append(item)
                continue
            number = self.written[k]
            value = self.values[number]
            sources = [self.register_of[source] for source in value.sources]
            if item.destination == self.frame.flag:
                target = self.frame.flag
            else:
                chosen = self._choose(k, item, value, sources)
                if chosen is None:
                    return None
                target = chosen
                self.holds[target] = number
            self.register_of[number] = target
            # A copy of a register to itself is no operation.
            if not _copies(item) or sources != [target]:
                out.append(
                    self.frame.op(item.inverted, target, sources, item.demand_index, item.segment)
                )
        return self._bring_home(out)

    def _choose(self, k: int, item: GateOp, value: _Value, sources: Sequence[int]) -> int | None:
        """Return the cheapest free register for the result of operation `k`, or None if there is
        none.

        `value` is the result with its lifetime and its banned registers; `sources` are the new
        registers that the operation reads. A register is free if its value is not read after item
        k, so it may be a source. A value of the masked register stays there. Of equal registers the
        lowest is taken."""
        masked = self.frame.masked
        if item.destination == masked:
            return masked

        def price(register: int) -> tuple[int, bool, bool, int]:
            """Return the sort key of a register: extra words first, then whether it blocks the home
            of a plane (the content of a code register), then a change of register; then registers
            without a plane, or whose plane comes home late."""
            in_place = int(register in sources)
            if in_place and _copies(item):
                in_place = -1  # no operation
            away = value.home >= 0 and register != value.home
            # A value in a plane's home makes that plane go elsewhere first.
            plane = register < self.frame.planes
            in_the_way = plane and register != value.home and value.last > self.homing[register] > k
            # Sort key: words, including the copy home; then no plane's home blocked; then few
            # changes; then a register that no plane needs, or only late.
            return (
                in_place + away,
                in_the_way,
                register != item.destination,
                -self.homing[register] if self.homing[register] >= 0 else -len(self.items),
            )

        free = [
            register
            for register in range(self.frame.flag)
            if register != masked
            and not value.banned >> register & 1
            and self.values[self.holds[register]].last <= k
        ]
        return min(free, key=price, default=None)

    def _bring_home(self, out: list[Item]) -> list[Item] | None:
        """Append copies of all displaced planes to their homes to `out`, in place, and return it;
        None if a register is missing.

        This is a parallel move. A plane is copied after the plane in its home has left. If planes
        wait for each other in a circle, one of them moves to a free register meanwhile."""
        frame = self.frame
        # Register that holds each plane now, by the plane's home register.
        current_place = {
            value.home: self.register_of[number]
            for number, value in enumerate(self.values)
            if value.home >= 0
        }
        astray = {plane: at for plane, at in current_place.items() if plane != at}
        segments = (
            item.segment
            for item in out
            if isinstance(item, GateOp) and item.demand_index == CLOSING
        )
        segment = max(segments, default=0)

        def copy(target: int, source: int) -> int:
            """Append an operation that copies a register to another at the end of the frame; return
            the source, which is the home of the next plane of a circle."""
            out.append(frame.op(False, target, (source,), CLOSING, segment))
            return source

        while free_homes := [plane for plane in astray if plane not in astray.values()]:
            copy(free_homes[0], astray.pop(free_homes[0]))
        # Only circles are left.
        free = [r for r in range(frame.flag) if r not in current_place and r != frame.masked]
        if astray and not free:
            return None
        while astray:
            first = next(iter(astray))
            plane = copy(free[0], astray.pop(first))
            while plane != first:
                plane = copy(plane, astray.pop(plane))
            copy(first, free[0])
        return out


def _copies(item: GateOp) -> bool:
    """Return whether an operation only copies a register."""
    return not item.inverted and len(item.sources) == 1
