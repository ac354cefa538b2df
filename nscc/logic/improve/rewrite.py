"""A local change, and the repair of the code after it.

A change drops operations or inserts others. Then the changed registers are followed through the
code. An operation whose result would change gets other sources, is preceded by a new gate in a free
register, or is dropped if its register already holds the needed value. Only values that matter
later must stay equal.

This is resubstitution with don't-cares. It is close to the transduction method for NOR networks
(Muroga, Kambayashi, Lai and Culliney, IEEE Trans. Computers 38, 1989), which computes a gate's
permissible functions first; here a change is tried and followed while it makes a difference.

A target of a gate is (ones, zeros): the shutters in which the result must be 1 and those in which
it must be 0. An OR computes it if its sources avoid `zeros` and together cover `ones`; a NOR if
they avoid `ones` and cover `zeros`. So a gate exists if all sources that may be read cover the
target. Covers are made small greedily; their size matters only if the number of sources is limited,
because a word costs the same with any number of sources."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass

from nscc.logic.improve.code import Check, Content, GateOp, Item
from nscc.logic.improve.tracked_run import HORIZON, TrackedRun
from nscc.truth import union


def cover(
    target: int, sources: Sequence[tuple[int, int]], limit: int | None
) -> tuple[int, ...] | None:
    """Return the registers, ascending, of a small set of `sources` (register, content) that covers
    the truth vector `target`, at most `limit` of them (None: any number).

    None if all sources together do not cover it, or no `limit` of them do. An empty target takes no
    source. Of equally good sources, earlier ones are taken. A truth vector is an integer with one
    bit for each shutter."""
    reachable = 0
    for _, content in sources:
        reachable |= content
    if target & ~reachable:
        return None
    uncovered = target
    chosen: list[tuple[int, int]] = []
    while uncovered:
        gain = 0
        best = sources[0]
        for source in sources:
            covered = (source[1] & uncovered).bit_count()
            if covered > gain:
                gain, best = covered, source
        chosen.append(best)
        uncovered &= ~best[1]
    # One of three or more may be covered by later ones. Of two none can be: the first covers most,
    # and the second covers a rest.
    if len(chosen) > 2:
        for source in list(chosen):
            other_contents = [content for register, content in chosen if register != source[0]]
            if not target & ~union(other_contents):
                chosen.remove(source)
    if limit is not None and len(chosen) > limit:
        exact = _within(target, sources, limit)
        return None if exact is None else tuple(sorted(exact))
    return tuple(sorted(register for register, _ in chosen))


def _within(target: int, sources: Sequence[tuple[int, int]], limit: int) -> tuple[int, ...] | None:
    """Return the registers of at most `limit` of `sources` (register, content) that cover the truth
    vector `target`, by exhaustive search; None if there are none.

    Each step tries the sources that contain the first uncovered shutter. The registers are in the
    order of the steps. A truth vector is an integer with one bit for each shutter."""
    if not target:
        return ()
    if limit == 0:
        return None
    low = target & -target
    for register, content in sources:
        if content & low:
            deeper = _within(target & ~content, sources, limit - 1)
            if deeper is not None:
                return (register, *deeper)
    return None


def gate(
    ones: int,
    zeros: int,
    contents: Sequence[Content],
    readable: Sequence[int],
    limit: int | None,
    *,
    inverted: tuple[bool, ...] = (False, True),
    fewest: int = 0,
) -> tuple[bool, tuple[int, ...]] | None:
    """Return a gate over `readable` registers that is 1 on `ones` and 0 on `zeros`, as (inverted,
    sources); None if there is no such gate.

    `inverted` in the result is True for a NOR; the argument lists the kinds that are allowed, and
    of two with equally many sources the first is taken. `ones` and `zeros` are truth vectors
    (integers with one bit for each shutter). `contents` are those of every register by number;
    unknown ones (None) are not read. At most `limit` sources are read (None: any number). With
    `fewest` 1 at least one source is read, as WHERE requires; 1 is the largest value that is
    allowed."""
    best: tuple[bool, tuple[int, ...]] | None = None
    for invert in inverted:
        avoid, target = (ones, zeros) if invert else (zeros, ones)
        allowed = _avoiding(avoid, contents, readable)
        chosen = cover(target, allowed, limit)
        if chosen is None:
            continue
        if len(chosen) < fewest:
            if not allowed:
                continue
            # Any register that is 0 wherever the result must be 0 may be read, too.
            chosen = (allowed[0][0],)
        if best is None or len(chosen) < len(best[1]):
            best = invert, chosen
    return best


def inner(
    ones: int,
    zeros: int,
    contents: Sequence[Content],
    readable: Sequence[int],
    inverted: tuple[bool, ...] = (False, True),
) -> list[tuple[bool, int, int]]:
    """Return gates that would be 1 on `ones` and 0 on `zeros` if they had one additional source,
    one for each kind in `inverted`.

    Each item is (inverted, ones', zeros'). `inverted` means a NOR, otherwise the gate is an OR. The
    additional source must be 1 on ones' and 0 on zeros'. The gate also reads all `readable`
    registers that it may read; `contents` holds the content of every register by number."""
    ways = []
    for invert in inverted:
        avoid, target = (ones, zeros) if invert else (zeros, ones)
        for _, content in _avoiding(avoid, contents, readable):
            target &= ~content
        ways.append((invert, target, avoid))
    return ways


def _avoiding(
    avoid: int, contents: Sequence[Content], readable: Sequence[int]
) -> list[tuple[int, int]]:
    """Return the `readable` registers, as (register, content), whose known content is 0 in all
    shutters of `avoid`. `contents` holds the contents by register, None if unknown."""
    return [
        (register, content)
        for register in readable
        if (content := contents[register]) is not None and not content & avoid
    ]


def shrink(run: TrackedRun, span: int) -> None:
    """Drop from `run`, in place, each operation, and each pair of operations at most `span` items
    apart, if the repair of the code after it saves words.

    Single operations are tried first, from the end to the start; then pairs. Raises GaveUp if the
    budget of `run` is used up; what was dropped before stays so."""
    for k in reversed(range(len(run.items))):
        if k < len(run.items):
            _drop(run, k)
    k = len(run.items) - 2
    while k >= 0:
        for j in range(k + 1, min(k + 1 + span, len(run.items))):
            if _drop(run, k, j):
                # A later change may make this one possible.
                k = min(k + span, len(run.items) - 1)
                break
        k -= 1


def _drop(run: TrackedRun, *dropped: int) -> bool:
    """Drop the items with the indices `dropped` (ascending) from `run`, in place, if a repair of
    the code saves words; return whether it did. A check is never dropped."""
    if not all(isinstance(run.items[k], GateOp) for k in dropped):
        return False
    rewriting = Rewriter(run, dropped[0], least=1, deepen=True).rewrite((), dropped)
    if rewriting is not None:
        run.splice(rewriting.start, rewriting.end, rewriting.items)
    return rewriting is not None


@dataclass(frozen=True)
class Rewrite:
    """A replacement of items[start:end] of a run by `items`, which saves `gain` words."""

    start: int
    end: int
    items: list[Item]
    gain: int


class Rewriter:
    """A change of a run from item `start` on, and the repair of the code after it; make a new one
    for each change.

    A rewriting must save `least` words. With `deepen`, the repair may insert gates. `order` lists
    the registers by preference as sources. `contents` holds the contents after the new code so far
    (`out`), `changed` is the bit mask of registers that differ from the old run, and `gain` the
    words saved so far."""

    def __init__(
        self,
        run: TrackedRun,
        start: int,
        *,
        least: int,
        deepen: bool = False,
        order: Sequence[int] | None = None,
    ) -> None:
        """Begin a rewrite of the code of `run` at the index `start` of an item. The run itself is
        not changed.

        `least` is the number of words that the rewrite must gain; `deepen` also allows repairs that
        need new gates; `order` is the order in which registers are tried as sources (None:
        ascending)."""
        self.run, self.frame, self.start = run, run.frame, start
        self.least, self.deepen = least, deepen
        self.order = order if order is not None else range(run.frame.flag + 1)
        self.contents: list[Content] = list(run.before[start])
        self.changed = 0
        self.gain = 0
        self.out: list[Item] = []

    def rewrite(self, lead: Sequence[GateOp], dropped: Collection[int]) -> Rewrite | None:
        """Insert the operations `lead` before item `start`, drop the items with the indices
        `dropped`, and repair the code after them; return None if that does not save enough words,
        or if it cannot be repaired within HORIZON items.

        No index of `dropped` may be below `start`. Call it once. Raises GaveUp if the budget is
        used up."""
        run, frame, items = self.run, self.frame, self.run.items
        run.budget.spend(run.step)
        self.gain = sum(frame.words(items[k]) for k in dropped)
        last = max(dropped, default=self.start - 1)
        for new in lead:
            if not frame.legal(new) or not self._insert(new):
                return None
        self._compare(run.before[self.start], -1)
        k = self.start
        end = min(len(items), self.start + HORIZON)
        while k <= last or self.changed & run.live[k]:
            if k >= end or self.gain < self.least:
                return None
            item = items[k]
            if isinstance(item, Check):
                if item.need is not None and self.contents[frame.flag] != item.need:
                    return None
                self.out.append(item)
                frame.apply(item, self.contents)
                self.changed &= ~item.forgets
            else:
                if k not in dropped and not self._follow(k, item):
                    return None
                self._compare(run.before[k + 1], item.destination)
            k += 1
        # Following an item takes about a quarter of the time of a look at all registers.
        run.budget.spend((k - self.start) * run.step // 4)
        gain = self.gain - run.refresh(items[self.start : k], self.out)
        if gain < self.least:
            return None
        return Rewrite(self.start, k, self.out, gain)

    def _compare(self, reference: Sequence[Content], register: int) -> None:
        """Update `changed`, the bit mask of registers that differ from `reference`, after a
        possible write to `register` (-1: any register).

        `reference` holds the contents at this point of the unchanged run."""
        if register < 0:
            self.changed = 0
            for i, content in enumerate(self.contents):
                if content != reference[i]:
                    self.changed |= 1 << i
        elif self.contents[register] == reference[register]:
            self.changed &= ~(1 << register)
        else:
            self.changed |= 1 << register

    def _insert(self, item: GateOp) -> bool:
        """Append the operation `item`, update the contents, and subtract its words from the gain.
        Return False, without a change, if its result is unknown."""
        value = self.frame.value(item, self.contents)
        if value is None:
            return False
        self._store(item, value)
        self.gain -= self.frame.words(item)
        return True

    def _store(self, item: GateOp, value: Content) -> None:
        """Append an operation to the new run, and store `value`, its result, as the register's
        content."""
        self.out.append(item)
        self.contents[item.destination] = value

    def _follow(self, k: int, item: GateOp) -> bool:
        """Keep, drop or repair operation `item`, which has index k in the run, in the current
        state; return whether that succeeded.

        After a failure the gain is wrong, so the rewrite must end."""
        target = item.destination
        # In order: drop if the register already holds the result; keep if the result is equal; drop
        # if the old content is equivalent; keep if the new result is equivalent; find other
        # sources.
        required = self.run.before[k + 1][target]
        assert required is not None
        current = self.contents[target]
        value = self.frame.value(item, self.contents) if item.reads & self.changed else required
        if current == required and self.changed >> target & 1:
            self.gain += self.frame.words(item)
            return True
        if value == required:
            self._store(item, value)
            return True
        matters = self.run.care(k)
        if current is not None and not (current ^ required) & matters:
            self.gain += self.frame.words(item)
            return True
        if value is not None and not (value ^ required) & matters:
            self._store(item, value)
            return True
        self.gain += self.frame.words(item)
        ones, zeros = required & matters, matters & ~required
        self.run.budget.spend(self.run.step)
        new = self._single(item, ones, zeros, in_place=False)
        # Two gates, or one in place, take two words.
        if new is None and self.gain - 2 < self.least:
            return False
        new = new or self._single(item, ones, zeros, in_place=True)
        return self._insert(new) if new else self.deepen and self._double(k, item, ones, zeros)

    def _readable(self, target: int) -> list[int]:
        """Return the registers with known contents that an operation writing the register `target`
        may read, in the order of preference. It may be `target` itself."""
        frame = self.frame
        banned = -1
        if target == frame.flag and not frame.machine.where_reads_flag:
            banned = frame.flag
        return [r for r in self.order if self.contents[r] is not None and r != banned]

    def _single(self, item: GateOp, ones: int, zeros: int, *, in_place: bool) -> GateOp | None:
        """Return one gate that replaces `item` and is 1 on `ones` and 0 on `zeros`; None if there
        is no such gate, or the machine lacks it.

        `ones` and `zeros` are truth vectors (integers with one bit for each shutter); other
        shutters do not matter. With `in_place`, the gate may read its own destination, which takes
        a word more; a WHERE is never in place."""
        frame, target = self.frame, item.destination
        readable = self._readable(target)
        if target == frame.flag:
            if in_place:
                return None
            limit = frame.machine.where_sources
            chosen = gate(ones, zeros, self.contents, readable, limit, inverted=(False,), fewest=1)
        else:
            if not in_place:
                readable = [r for r in readable if r != target]
            chosen = gate(ones, zeros, self.contents, readable, frame.machine.or_sources)
        if chosen is None:
            return None
        new = frame.op(chosen[0], target, chosen[1], item.demand_index, item.segment)
        return new if frame.legal(new) else None

    def _double(self, k: int, item: GateOp, ones: int, zeros: int) -> bool:
        """Replace operation `item`, which has index k in the run, by two gates, the first into a
        free register; append them and return whether that was possible.

        The result must be 1 on the truth vector `ones` and 0 on `zeros`. The first pair found is
        taken. A truth vector is an integer with one bit for each shutter."""
        frame, target = self.frame, item.destination
        kinds = (False,) if target == frame.flag else (False, True)
        readable = [r for r in self._readable(target) if r != target]
        # A write of the masked register overwrites its mask, so the inner value cannot be there.
        busy = {target, *[frame.first_scratch] * (target == frame.masked)}
        for _, inner_ones, inner_zeros in inner(ones, zeros, self.contents, readable, kinds):
            for spare in self.run.free(k + 1, busy):
                sources = [r for r in self._readable(spare) if r != spare]
                chosen = gate(
                    inner_ones, inner_zeros, self.contents, sources, frame.machine.or_sources
                )
                if chosen is None:
                    continue
                new = frame.op(chosen[0], spare, chosen[1], item.demand_index, item.segment)
                value = frame.value(new, self.contents)
                # The outer gate is searched as if the inner one had run; nothing is changed if
                # there is none.
                previous = self.contents[spare]
                self.contents[spare] = value
                outer = self._single(item, ones, zeros, in_place=False)
                self.contents[spare] = previous
                if outer is not None and frame.legal(new):
                    self._insert(new)
                    self._compare(self.run.before[k], spare)
                    return self._insert(outer)
        return False
