"""Alternatives for a program that does not fit: similar programs that were compiled and fit.

A similar program keeps the target, the slot lengths and the user's limits. It does less: only the
used codes, smaller states, fewer slots, fewer codebook rows, one bump per pixel, or a codebook of
few shutters. The last three replace the whole text, so that they are only for programs without
senses, images and planes. The numbers of values, rows and slots are found by search. Codebooks that
the user would have to provide are replaced by pseudo-random rows."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import partial
from itertools import islice
from time import process_time
from typing import Any, Protocol

import numpy as np

from nscc.arrays import Bools
from nscc.limits.families import (
    book_text,
    bump_rule,
    program_text,
    random_rows,
    stop_rule,
)
from nscc.lower.lowered import Lowered
from nscc.pipeline import KINDS
from nscc.program.limits import largest_with
from nscc.program.problems import counted
from nscc.program.program import Codes, Program
from nscc.source import Source
from nscc.syntax import tree
from nscc.syntax.parse import parse

MOST_SHOWN = 3
"""Most similar programs suggested in one error message."""
QUICK_LEVEL = 1
"""Highest optimisation level for alternatives, because one error message compiles several programs.

Programs with fewer codebook rows use the full level."""
_MOST_S = 10.0
"""Processor seconds for all attempts of one error message; the last one may take some more."""
_GROWTH = 3
"""A program of twice the size is assumed to take at most 2 ** _GROWTH times as long: random rows of
4,096 slots do, all else takes less."""
_BOOK_ROWS = 64
"""Rows of the codebook that is suggested instead of a larger shutter class."""
_LONGEST_BOOK = 256
"""Most slots for which such a codebook is tried."""

Statements = tuple[tree.Statement, ...]


class Attempt(Protocol):
    """A function that compiles a program for the target."""

    def __call__(self, source: Source, codes: Codes, level: int) -> Lowered | None:
        """Return the lowered program of `source`, or None if it does not fit.

        `codes` is "open" (all legal codes) or "fixed" (those in use), and `level` the optimisation
        level."""


@dataclass(frozen=True)
class WayOut:
    """A similar program that fits: `text`, for people, says what to write and what it costs;
    `data`, for programs that read the error, has its numbers, such as `rows`."""

    text: str
    data: Mapping[str, Any] = field(default_factory=dict)


class _Trials:
    """The compilations for one error message, which share `_MOST_S` of processor time."""

    def __init__(self, attempt: Attempt) -> None:
        """Begin to measure the time; `attempt` compiles a program."""
        self.attempt, self._end = attempt, process_time() + _MOST_S

    @property
    def seconds_left(self) -> float:
        """The processor time that is left, 0 if it is used up."""
        return max(0.0, self._end - process_time())

    def largest(
        self, least: int, most: int, source: Callable[[int], Source], level: int
    ) -> tuple[int, Lowered | None, str]:
        """Return the largest size in `least`..`most` that fits, as (size, lowered program, remark);
        (0, None, "") if none was found.

        `source` returns the program text of a size, which is compiled at `level`. The size is
        doubled while it fits, because small programs take little time; then it is found by
        bisection. The remark names the size above that does not fit, or the sizes that were not
        tried; it is empty for `most`."""
        fit, lowered, above = 0, None, most + 1
        size, seconds = least, 0.0
        while fit < size < above:
            if lowered is not None:
                reach = (self.seconds_left / max(seconds, 0.01)) ** (1 / _GROWTH)
                size = min(size, int(fit * reach))
            if size <= fit or not self.seconds_left:
                break
            begin = process_time()
            trial = self.attempt(source(size), "open", level)
            if trial is not None:
                fit, lowered, seconds = size, trial, process_time() - begin
            elif lowered is not None:
                above = size
            elif size == most:
                break
            # A size below all that fit may be too small for the rule, so it is doubled as well.
            size = min(2 * size, most) if above > most else (fit + above) // 2
        if lowered is None or fit == most:
            return fit, lowered, ""
        if above == fit + 1:
            return fit, lowered, f"; {above} does not fit"
        return fit, lowered, f"; looked no further: {fit + 1} to {above - 1} would take long"


def ways_out(source: Source, program: Program | None, attempt: Attempt, level: int) -> list[WayOut]:
    """Return at most `MOST_SHOWN` similar programs that were compiled and fit, smallest change
    first; none if nothing was found.

    `program` is the program of the text `source`, None if its shutters are too many to list.
    `attempt` compiles a program, and `level` is the optimisation level of the program that does not
    fit. The text of each result names the level at which it was compiled."""
    return list(islice(_candidates(source, program, _Trials(attempt), level), MOST_SHOWN))


def _candidates(
    source: Source, program: Program | None, trials: _Trials, most: int
) -> Iterator[WayOut]:
    """Yield similar programs that fit, in the order in which the error lists them.

    `source` and `program` are those of the error, `trials` compiles programs, and `most` is the
    user's optimisation level. All but programs with fewer codebook rows are compiled at
    `QUICK_LEVEL` or below. A change that does not fit, or does not apply to the program, is left
    out."""
    level = min(most, QUICK_LEVEL)
    if program is not None and program.mode == "open" and program.pixel_codes is not None:
        lowered = trials.attempt(source, "fixed", level)
        if lowered is not None:
            in_use = counted(len(lowered.program.table.shutters), "shutter")
            yield _way_out("`--codes fixed`", f"only the {in_use} in use", lowered, level)
    smaller = list(_smaller_states(source, trials, level))
    yield from smaller
    if not smaller:
        yield from _fewer_slots(source, program, trials, level)
    if program is None or not KINDS.of(program).has_simpler_programs:
        return
    yield from _fewer_rows(program, trials, most)
    for other, change, why in _of_other_classes(program):
        lowered = trials.attempt(other, "open", level) if trials.seconds_left else None
        if lowered is not None:
            yield _way_out(change, why, lowered, level)


def _way_out(change: str, why: str, lowered: Lowered, level: int, **data: int) -> WayOut:
    """Return a change of the program with its cost in words, as text in two columns.

    `change` is what the user writes, `why` describes the result, `lowered` is the changed program,
    compiled at `level`. `data` is added for programs that read the error."""
    words = lowered.schedule.words_total / len(lowered.program.frame.slot_us)
    return WayOut(f"{change:<24}{why}: {words:.3g} words a slot at -O{level}", data)


def _source_of_rule(program: Program, rule: str, slots: int) -> Source:
    """Return a program with the statements `rule` and `slots` equal slots, as long as the
    original's slots on average."""
    slot_us = sum(program.frame.slot_us) / len(program.frame.slot_us)
    # A shorter time would be written as 0.000us, which the language refuses.
    return Source("way-out.nsl", program_text(slots, f"{max(slot_us, 0.001):.3f}us", rule))


def _book(program: Program, shutters: Bools) -> Source:
    """Return a program of the codebook `shutters`, bool (rows, buckets, slots), for the same frame
    and buckets."""
    buckets = [bucket.name for bucket in program.buckets]
    return Source("way-out.nsl", book_text(program.frame.slot_us, buckets, shutters))


def _fewer_rows(program: Program, trials: _Trials, level: int) -> Iterator[WayOut]:
    """Yield the program with the largest codebook that fits: the first of the rows in use.

    Yield nothing for programs without a codebook, with further code fields, or if none fits.
    `trials` compiles programs, at the optimisation level `level`."""
    if program.class_name != "codebook" or len(program.fields) != 1:
        return
    table = program.table
    rows = len(table.codes)
    registers = len(program.target.digital_registers)
    # Every shutter needs a different content of the code registers, so more rows cannot fit. The
    # function counts the distinct shutters of the first rows.
    most = largest_with(
        lambda count: len(np.unique(table.shutter_of_code[:count])),
        1 << registers,
        least=1,
        ceiling=rows - 1,
    )

    def of_first(count: int) -> Source:
        """Return the program with the first `count` rows of its codebook."""
        return _book(program, table.shutters[table.shutter_of_code[:count]])

    count, lowered, remark = trials.largest(1, most, of_first, level)
    if lowered is None:
        return
    field, last = program.fields[0], table.codes[count - 1, 0]
    whose = "in use" if program.mode == "fixed" else "allowed"
    until = f"up to row {last}" if field.kind == "row" else f"up to {field.name} = {last}"
    why = f"the first {count} of the {rows} rows {whose}, {until}"
    why += f", at most {max(lowered.words_per_boundary)} words in a slot{remark}"
    yield _way_out(f"K = {count}", why, lowered, level, rows=count)


def _fewer_slots(
    source: Source, program: Program | None, trials: _Trials, level: int
) -> Iterator[WayOut]:
    """Yield the program with the most slots that fit, if that is fewer than the frame has.

    `trials` compiles programs, at the optimisation level `level`. The rule is kept as it is
    written; N in it follows the frame. Yield nothing for codebooks, whose rows have the length of
    the frame."""
    if program is not None and program.class_name == "codebook":
        return
    statements = parse(source)[0].statements
    frames = [s for s in statements if isinstance(s, tree.EqualSlots | tree.ListedSlots)]
    slots = _slot_count(frames[0]) if program is None else len(program.frame.slot_us)
    build = partial(_with_slots, source, statements)
    count, lowered, remark = trials.largest(1, slots - 1, build, level)
    if lowered is not None:
        why = f"{counted(slots - count, 'slot')} fewer{remark}"
        yield _way_out(f"frame {count} slots", why, lowered, level)


def _slot_count(frame: tree.EqualSlots | tree.ListedSlots) -> int:
    """Return the number of slots that a statement `frame` writes as a number or as a list, else
    0."""
    if isinstance(frame, tree.ListedSlots):
        return len(frame.lengths)
    return frame.count.value if isinstance(frame.count, tree.Int) else 0


def _smaller_states(source: Source, trials: _Trials, level: int) -> Iterator[WayOut]:
    """Yield the program whose largest state has the most values that fit. The number that ends its
    range is replaced in the statements that name the state; without such a number, yield nothing.

    `trials` compiles programs, at the optimisation level `level`."""
    statements = parse(source)[0].statements
    ends = [
        (statement.high.value, statement.name.text)
        for statement in statements
        if isinstance(statement, tree.StateRange) and isinstance(statement.high, tree.Int)
    ]
    most, name = max(ends, default=(0, ""))

    def with_values(high: int) -> Source:
        """Return the program text with `high` instead of `most`."""

        def changed(_statement: tree.Statement, text: str) -> str:
            """Return the text of a statement with the number replaced if it names the state."""
            if not re.search(rf"\b{name}\b", text):
                return text
            return re.sub(rf"\b{most}\b", str(high), text)

        return _rewritten(source, statements, changed)

    high, lowered, remark = trials.largest(1, most - 1, with_values, level)
    if lowered is not None:
        why = f"a smaller range of `{name}`{remark}"
        yield _way_out(f"{high} instead of {most}", why, lowered, level)


def _with_slots(source: Source, statements: Statements, slots: int) -> Source:
    """Return the program text with `slots` slots, at most as many as it lists, and without the
    codes of pixels, which may need more. `statements` are those of the text."""

    def changed(statement: tree.Statement, text: str) -> str:
        """Return the new text of a statement."""
        if isinstance(statement, tree.PixelsExpr | tree.PixelsTile | tree.PixelsFromFile):
            return ""
        start = statement.span.start
        if isinstance(statement, tree.EqualSlots):
            count = statement.count.span
            return text[: count.start - start] + str(slots) + text[count.end - start :]
        if isinstance(statement, tree.ListedSlots):
            return text[: statement.lengths[slots - 1].span.end - start] + "]"
        return text

    return _rewritten(source, statements, changed)


def _rewritten(
    source: Source, statements: Statements, changed: Callable[[tree.Statement, str], str]
) -> Source:
    """Return the text `source` with `changed(statement, text)` for the text of each of its
    `statements`."""
    text = source.text
    for statement in reversed(statements):
        span = statement.span
        new = changed(statement, text[span.start : span.end])
        text = text[: span.start] + new + text[span.end :]
    return Source("way-out.nsl", text)


def _of_other_classes(program: Program) -> Iterator[tuple[Source, str, str]]:
    """Yield programs of other shutter classes for the same frame.

    Each is (program text, what the user would write, description). They do less than the original:
    a codebook of few rows, one bump a pixel, or open up to a stop."""
    slots, buckets = len(program.frame.slot_us), [bucket.name for bucket in program.buckets]
    rows = random_rows(_BOOK_ROWS, len(buckets) * slots)
    if slots <= _LONGEST_BOOK and len(rows) < len(program.table.shutters):
        shutters = np.array([list(row) for row in rows]) == "1"
        shutters = shutters.reshape(len(rows), len(buckets), slots)
        yield (
            _book(program, shutters),
            "`code id : row of book`",
            f"{slots} slots kept, {len(rows)} shutters instead of {len(program.table.shutters)} "
            "(compiled with pseudo-random rows)",
        )
    if len(buckets) > 1:
        return
    if program.class_name not in ("b", "c", "d"):
        source = _source_of_rule(program, bump_rule(), slots)
        yield source, "`start <= n < stop`", f"{slots} slots kept, one bump a pixel"
    if program.class_name != "b":
        yield (
            _source_of_rule(program, stop_rule("1"), slots),
            "`n < stop`",
            f"{slots} slots kept, open from the start to a stop of each pixel",
        )
