"""Operations, with the state at every point, kept up to date under changes.

The state contains the content of every register and the registers that are still read (liveness,
computed backwards). For each operation it contains the shutters in which the result matters (the
complement of the observability don't-cares). These are found by complementing the result and
running on: the result matters in the shutters where a demand or the frame's end changes. This is
exact, because bits of different shutters do not interact."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from nscc.logic.cubes import Budget
from nscc.logic.improve.code import REFRESH_WORDS, Check, FrameContext, Item, states_before

# How many items an influence is followed; beyond that it is assumed to matter in every shutter.
HORIZON = 4000

# Shutters for which a look at all registers is one step of the budget.
STEP_SHUTTERS = 16384


class TrackedRun:
    """Items with their states, under changes of the items.

    `before[k]` is the content of every register before item k, and `before[-1]` that after the
    last. `live[k]` is the bit mask of registers whose content at that point is read later or
    required at the end. `step` is the number of budget steps of one look at all registers."""

    def __init__(self, frame: FrameContext, items: Sequence[Item], budget: Budget) -> None:
        """Compute the state at every operation of `items`; raise Illegal if they are not a
        solution. Operations whose result is not read are dropped. The budget is not used yet."""
        self.frame = frame
        self.budget = budget
        self.step = 1 + frame.everything.bit_length() // STEP_SHUTTERS
        self.restart(items)

    def restart(self, items: Sequence[Item]) -> None:
        """Replace all items, and compute all states again; raise Illegal without a change if they
        are not a valid run. Operations whose result is not read are dropped."""
        frame = self.frame
        self.before = states_before(frame, items)
        self.items = list(items)
        self.live = [0] * (len(items) + 1)
        self.live[-1] = (1 << frame.planes) - 1
        self._cares: list[tuple[int, int] | None] = [None] * len(items)
        self._writes = frame.writes(items)
        self._settle(self._revive(0, len(items)), len(items))

    def words(self) -> int:
        """Return the words of a frame, including refresh of unwritten planes (contents of code
        registers)."""
        return self.frame.total(self.items)

    def care(self, k: int) -> int:
        """Return the shutters in which the result of operation k matters, as a truth vector (an
        integer with one bit for each shutter); it is computed when first needed.

        Item k must not be a check. The result may contain too many shutters, never too few. Raises
        GaveUp if the budget is used up."""
        known = self._cares[k]
        if known is None:
            known = self._cares[k] = self._follow(k)
        return known[0]

    def free(self, k: int, besides: Collection[int | None]) -> list[int]:
        """Return the digital registers that are not read from item k on, except the masked one and
        `besides`."""
        busy = (*besides, self.frame.masked)
        return [r for r in range(self.frame.flag) if r not in busy and not self.live[k] >> r & 1]

    def refresh(self, old: Sequence[Item], new: Sequence[Item]) -> int:
        """Return the additional refresh words if the items `new` replace the items `old`, negative
        if there are fewer: planes (contents of code registers) that a frame does not write need a
        refresh."""
        after = self._after(old, new)
        return REFRESH_WORDS * (after.count(0) - self._writes.count(0))

    def _after(self, old: Sequence[Item], new: Sequence[Item]) -> list[int]:
        """Return how often each plane is written after the items `new` replace the items `old` of
        the run."""
        written = self.frame.writes
        changes = zip(self._writes, written(old), written(new), strict=True)
        return [count - removed + added for count, removed, added in changes]

    def splice(self, start: int, end: int, new: Sequence[Item]) -> None:
        """Replace items[start:end] by `new`; the caller ensures that live contents after them stay
        equal.

        The state is computed again only where it may have changed. Operations whose result is no
        longer read are dropped, also before `start`."""
        self._writes = self._after(self.items[start:end], new)
        self.items[start:end] = new
        self.before[start:end] = [self.before[start]] * len(new)
        self.live[start:end] = [0] * len(new)
        self._cares[start:end] = [None] * len(new)
        tail = start + len(new)
        # No influence is followed further than HORIZON.
        for k in range(max(0, start - HORIZON), tail):
            known = self._cares[k]
            if known is not None and k + known[1] >= start:
                self._cares[k] = None
        first = self._revive(start, tail)
        self._settle(min(first, start), tail)

    def _settle(self, first: int, last: int) -> None:
        """Recompute the states before the items `first` to `last` and after the last one, and
        further while they change.

        Contents that are not live may differ, so the change may go on behind `last`."""
        if first:
            contents = list(self.before[first - 1])
            self.frame.apply(self.items[first - 1], contents)
        else:
            contents = list(self.frame.start)
        for k in range(first, len(self.items) + 1):
            now = tuple(contents)
            if k > last and now == self.before[k]:
                return
            self.before[k] = now
            if k < len(self.items):
                self.frame.apply(self.items[k], contents)

    def _revive(self, start: int, end: int) -> int:
        """Recompute liveness backwards from item `end`, and before `start` for as long as it
        changes.

        Operations whose result is not live are dropped. Returns the index of the first dropped
        item, `end` if there is none."""
        frame = self.frame
        dead: list[int] = []
        for k in range(end - 1, -1, -1):
            item = self.items[k]
            live = self.live[k + 1]
            if isinstance(item, Check):
                live &= ~item.forgets
                if item.need is not None:
                    live |= 1 << frame.flag
            elif live >> item.destination & 1:
                live = live & ~(1 << item.destination) | item.reads
            else:
                dead.append(k)
            # Items before `start` did not change, so neither does what they make live.
            if k < start and live == self.live[k]:
                break
            self.live[k] = live
        self._writes = self._after([self.items[k] for k in dead], ())
        for k in dead:
            del self.items[k], self.before[k], self.live[k], self._cares[k]
        return dead[-1] if dead else end

    def _follow(self, k: int) -> tuple[int, int]:
        """Return the shutters in which operation k's result matters, as a truth vector, and the
        number of items after it that were looked at.

        All shutters matter if the influence does not end within HORIZON items. Raises GaveUp if the
        budget is used up. A truth vector is an integer with one bit for each shutter."""
        frame, items, before = self.frame, self.items, self.before
        everything, flag = frame.everything, frame.flag
        source = items[k]
        assert not isinstance(source, Check)
        written = before[k + 1][source.destination]
        assert written is not None
        # The registers that would hold something else if the result were complemented, with that
        # content.
        flipped: dict[int, int] = {source.destination: written ^ everything}
        touched = 1 << source.destination
        matters = 0
        last = min(len(items), k + 1 + HORIZON)
        for index in range(k + 1, last):
            item = items[index]
            if isinstance(item, Check):
                if item.need is not None and flag in flipped:
                    matters |= flipped[flag] ^ item.need
                for register in [r for r in flipped if item.forgets >> r & 1]:
                    del flipped[register]
                    touched &= ~(1 << register)
            elif item.reads & touched:
                value = 0
                contents = before[index]
                for register in item.sources:
                    content = flipped[register] if register in flipped else contents[register]
                    value |= content  # type: ignore[operator]
                if item.inverted:
                    value ^= everything
                if value == before[index + 1][item.destination]:
                    flipped.pop(item.destination, None)
                    touched &= ~(1 << item.destination)
                else:
                    flipped[item.destination] = value
                    touched |= 1 << item.destination
            elif touched >> item.destination & 1:
                del flipped[item.destination]
                touched &= ~(1 << item.destination)
            if not touched or matters == everything:
                self.budget.spend(self.step * (1 + (index - k) // 8))
                return matters, index - k
        self.budget.spend(self.step * (1 + (last - k) // 8))
        if last < len(items):
            return everything, last - k
        for register, content in flipped.items():
            if register < frame.planes:
                matters |= content ^ before[-1][register]  # type: ignore[operator]
        return matters, last - k
