"""Alternatives for a program that does not fit: similar programs that were compiled and fit.

A similar program keeps the target, the slot length and the user's limits. It does less: only the
used codes, fewer codebook rows, fewer slots, one bump per pixel, or a codebook of few shutters. A
program with senses gets the used codes, smaller states or fewer slots; one with images or planes
only the used codes; several buckets only codebooks. The numbers of values, rows and slots are found
by search. Codebooks that the user would have to provide are replaced by pseudo-random rows."""

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
from nscc.program.limits import largest, largest_with
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
_FRAME_TRIALS = 10
"""Most compilations in a search for the largest number of slots."""
_MOST_S = 15.0
"""Processor seconds after which no further size is tried; the last attempt may take some more."""
_ROW_TRIALS = 10
"""Most compilations in a search for the largest number of codebook rows."""
_BOOK_ROWS = 64
"""Rows of the codebook that is suggested instead of a larger shutter class."""
_LONGEST_BOOK = 256
"""Most slots for which such a codebook is tried."""
_MOST_DIGITS = 1 << 13
"""Most digits of a codebook that is compiled for one error message."""


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


def ways_out(program: Program, attempt: Attempt, level: int) -> list[WayOut]:
    """Return at most `MOST_SHOWN` similar programs that were compiled and fit, smallest change
    first; none if nothing was found.

    `attempt` compiles a program, and `level` is the optimisation level of the program that does not
    fit. The text of each result names the level at which it was compiled."""
    return list(islice(_candidates(program, attempt, level), MOST_SHOWN))


def _candidates(program: Program, attempt: Attempt, most: int) -> Iterator[WayOut]:
    """Yield similar programs that fit, in the order in which the error lists them.

    `attempt` compiles a program; `most` is the user's optimisation level. All but programs with
    fewer codebook rows are compiled at `QUICK_LEVEL` or below. A change that does not fit, or does
    not apply to the program, is left out."""
    level = min(most, QUICK_LEVEL)
    if program.mode == "open" and program.pixel_codes is not None:
        lowered = attempt(program.source, "fixed", level)
        if lowered is not None:
            in_use = counted(len(lowered.program.table.shutters), "shutter")
            yield _way_out("`--codes fixed`", f"only the {in_use} in use", lowered, level)
    if program.machine.looks:
        yield from _smaller_states(program, attempt, level)
    if not KINDS.of(program).has_simpler_programs:
        return
    yield from _fewer_rows(program, attempt, most)
    if len(program.buckets) == 1:
        yield from _fewer_slots(program, attempt, level)
    for source, change, why in _of_other_classes(program):
        lowered = attempt(source, "open", level)
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


def _fewer_rows(program: Program, attempt: Attempt, level: int) -> Iterator[WayOut]:
    """Yield the program with the largest codebook that fits: the first of the rows in use.

    Yield nothing for programs without a codebook, with further code fields, or if none fits.
    `attempt` compiles a program, at the optimisation level `level`."""
    if program.class_name != "codebook" or len(program.fields) != 1:
        return
    table, slots = program.table, len(program.frame.slot_us)
    rows = len(table.codes)
    digits = slots * len(program.buckets)
    registers = len(program.target.digital_registers)
    most = min(rows - 1, max(1, _MOST_DIGITS // digits))
    untried = "" if most == rows - 1 else f" ({most} was the most tried)"
    # Every shutter needs a different content of the code registers, so more rows cannot fit. The
    # function counts the distinct shutters of the first rows.
    most = largest_with(
        lambda count: len(np.unique(table.shutter_of_code[:count])),
        1 << registers,
        least=1,
        ceiling=most,
    )

    def of_first(count: int) -> Source:
        """Return the program with the first `count` rows of its codebook."""
        return _book(program, table.shutters[table.shutter_of_code[:count]])

    count, lowered, remark = _largest(
        least=1,
        most=most,
        source=of_first,
        attempt=partial(attempt, level=level),
        budget=_ROW_TRIALS,
    )
    if lowered is None:
        return
    field, last = program.fields[0], table.codes[count - 1, 0]
    whose = "in use" if program.mode == "fixed" else "allowed"
    until = f"up to row {last}" if field.kind == "row" else f"up to {field.name} = {last}"
    why = f"the first {count} of the {rows} rows {whose}, {until}"
    if count == most:
        why += untried
    why += f", at most {max(lowered.words_per_boundary)} words in a slot{remark}"
    yield _way_out(f"K = {count}", why, lowered, level, rows=count)


def _largest(
    least: int,
    most: int,
    source: Callable[[int], Source],
    attempt: Callable[[Source, Codes], Lowered | None],
    budget: int,
) -> tuple[int, Lowered | None, str]:
    """Return the largest size in `least`..`most` that fits, as (size, lowered program, remark).

    `source` returns the program text of a size, `attempt` compiles it, and `budget` limits the
    number of compilations. If none fits, the result is (0, None, ""). The remark tells if the time
    `_MOST_S` ended before all sizes were tried, else it is empty."""
    built: dict[int, Lowered | None] = {}
    begin, remark = process_time(), ""

    def fits(size: int) -> bool:
        """Compile the size and store the result in `built`; return whether it fits.

        Once a size fits and the time is used up, further sizes count as not fitting, and `remark`
        says so."""
        nonlocal remark
        # Small sizes take little time, so that some size is found even if the time is used up.
        if process_time() > begin + _MOST_S and any(built.values()):
            remark = f"; looked no further after {_MOST_S:g} s"
        built[size] = None if remark else attempt(source(size), "open")
        return built[size] is not None

    size = largest(least, most, fits, budget)
    return (0, None, "") if size is None else (size, built[size], remark)


def _fewer_slots(program: Program, attempt: Attempt, level: int) -> Iterator[WayOut]:
    """Yield the program with the most slots that fit, if that is fewer than the frame has.

    `attempt` compiles a program, at the optimisation level `level`. The rule is kept as it is
    written; N in it follows the frame. Yield nothing for codebooks, whose rows have the length of
    the frame, and for frames that list the lengths of slots."""
    slots = len(program.frame.slot_us)
    statements = parse(program.source)[0].statements
    build = partial(_with_slots, program, statements)
    if program.class_name != "codebook" and build(2).text != build(3).text:
        quick = partial(attempt, level=level)
        count, lowered, remark = _largest(2, slots - 1, build, quick, _FRAME_TRIALS)
        if lowered is not None:
            fewer = counted(slots - count, "slot")
            why = f"{fewer} fewer, every shutter still possible{remark}"
            yield _way_out(f"frame {count} slots", why, lowered, level)


def _smaller_states(program: Program, attempt: Attempt, level: int) -> Iterator[WayOut]:
    """Yield the program whose largest state has the most values that fit. The number that ends its
    range is replaced in the statements that name the state; without such a number, the program with
    the most slots that fit.

    `attempt` compiles a program, at the optimisation level `level`."""
    most, name = max((int(state.high), state.name) for state in program.machine.states)
    statements = parse(program.source)[0].statements

    def with_values(high: int) -> Source:
        """Return the program text with `high` instead of `most`."""

        def changed(_statement: tree.Statement, text: str) -> str:
            """Return the text of a statement with the number replaced if it names the state."""
            if not re.search(rf"\b{name}\b", text):
                return text
            return re.sub(rf"\b{most}\b", str(high), text)

        return _rewritten(program, statements, changed)

    if most < 2 or with_values(1).text == program.source.text:
        yield from _fewer_slots(program, attempt, level)
        return
    quick = partial(attempt, level=level)
    high, lowered, remark = _largest(1, most - 1, with_values, quick, _FRAME_TRIALS)
    if lowered is not None:
        why = f"the largest value of `{name}` that fits{remark}"
        yield _way_out(f"{high} instead of {most}", why, lowered, level)


def _with_slots(program: Program, statements: Statements, slots: int) -> Source:
    """Return the program text with `slots` slots and without the codes of pixels, which may need
    more. The number of slots stays if the frame lists their lengths. `statements` are those of the
    program."""

    def changed(statement: tree.Statement, text: str) -> str:
        """Return the new text of a statement."""
        if isinstance(statement, tree.PixelsExpr | tree.PixelsTile | tree.PixelsFromFile):
            return ""
        if isinstance(statement, tree.EqualSlots):
            return re.sub(r"\d+(?=\s+slots?\b)", str(slots), text, count=1)
        return text

    return _rewritten(program, statements, changed)


def _rewritten(
    program: Program, statements: Statements, changed: Callable[[tree.Statement, str], str]
) -> Source:
    """Return the text of the program with `changed(statement, text)` for the text of each of its
    `statements`."""
    text = program.source.text
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
