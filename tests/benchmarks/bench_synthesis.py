"""The words of decode logic, beside the best counts known for the same cases.

    python tests/benchmarks/bench_synthesis.py [--levels 2,3] [--rows TEXT] [--tables level,edges]
        [--markdown]

A line for each case: operations and words of a frame, most words in one slot, registers, the proved
bound on operations, seconds of one compilation from text to proof (no cache), and what there is to
reach: words, or operations where no words are known. `x 1.03` is the ratio of the two, `OVER` marks
what is above: 1 at -O3, 1.05 at -O2. The counts to reach were found by search outside of this
project's compiler; `+` rows write all registers and may take two words more (SET R0). F rows are
counted without and with a WHERE that may read FLAG. What does not fit scamp5's store, or takes more
words to fit it, is counted with a larger store, too: the counts to reach know none.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from time import perf_counter

import numpy as np

from nscc.diagnostics.diagnostic import Rejected
from nscc.emit.report import report
from nscc.pipeline import Options, run_passes
from nscc.source import Source
from nscc.target.load import builtin_target
from nscc.target.target import Target

SLOT = "100us"
ROOM = {2: 1.05, 3: 1.0}
LARGE_STORE = 10**6
SET_R0 = 2


@dataclass(frozen=True)
class Row:
    """A case and the best known counts of its logic, level lowering, None where not known.

    `reads_flag`: they need a WHERE that reads FLAG; `masked`: they leave out SET R0.
    """

    name: str
    text: str
    ops: int | None
    words: int | None
    reads_flag: bool = False
    masked: bool = False


def frame(slots: int) -> str:
    return f"nsl 1\nframe {slots} slots of {SLOT}\n"


def b(slots: int, ops: int, words: int, **marks: bool) -> Row:
    """Stops 0..N-1."""
    text = frame(slots) + f"code stop : 0..{slots - 1}\nopen when n < stop\n"
    return Row(f"b {slots}", text, ops, words, **marks)


def c(slots: int, length: int, ops: int, words: int | None, **marks: bool) -> Row:
    """Starts 0..N-1, late bumps cut by the end of the frame."""
    rule = f"code start : 0..{slots - 1}\nopen when start <= n < start + {length}\n"
    return Row(f"c ({slots}, {length})", frame(slots) + rule, ops, words, **marks)


def d(slots: int, ops: int, words: int | None, *, never: bool = False, **marks: bool) -> Row:
    """All bumps; with `never`, the shutter that stays closed, too."""
    legal = "start < stop or start + stop == 0" if never else "start < stop"
    rule = (
        f"code start : 0..{slots - 1}\ncode stop : {0 if never else 1}..{slots}\n"
        f"require {legal}\nopen when start <= n < stop\n"
    )
    name = f"d {slots}, never" if never else f"d {slots}"
    return Row(name, frame(slots) + rule, ops, words, **marks)


def e(slots: int) -> Row:
    """Any pattern: a word a slot."""
    text = frame(slots) + f"code bits : bit[{slots}]\nopen when bits[n]\n"
    return Row(f"e {slots}", text, slots, slots)


def codebook(seed: int, ops: int, words: int) -> Row:
    """64 random rows of 16 slots."""
    rows = np.random.default_rng(seed).integers(0, 2, (64, 16))
    book = ",\n".join("".join(map(str, row)) for row in rows)
    rule = f"shutters book [{book}]\ncode id : row of book\nopen when book[id]\n"
    return Row(f"codebook 64 x 16, seed {seed}", frame(16) + rule, ops, words)


ROWS = (
    b(8, 8, 8), b(14, 14, 14), b(16, 24, 24), b(32, 63, 63), b(64, 127, 127), b(100, 200, 200),
    b(128, 266, 276), b(256, 558, 604), b(512, 1195, 1364),
    b(1024, 2814, 3582, reads_flag=True, masked=True),
    b(2048, 7166, 10238, reads_flag=True, masked=True),
    b(4096, 23952, 34724, reads_flag=True, masked=True),
    c(64, 4, 144, 160), c(64, 8, 192, 256), c(64, 16, 373, 443), c(128, 4, 288, None),
    c(256, 8, 768, None, masked=True), c(65, 5, 144, None), c(1024, 32, 6145, None, masked=True),
    c(64, 13, 534, None),
    d(4, 14, None), d(8, 30, 36), d(16, 94, 125), d(32, 222, 317, masked=True),
    d(64, 571, 762, reads_flag=True, masked=True),
    d(64, 571, 762, never=True, reads_flag=True, masked=True),
    e(8), e(13),
    codebook(1, 150, 208), codebook(2, 142, 208),
)  # fmt: skip

EDGES = {"d 64": 384, "d 64, never": 384, **{f"b {n}": 3 * n for n in (64, 256, 1024, 2048, 4096)}}
"""Known operations of the edge lowering: about."""


@dataclass(frozen=True)
class Count:
    """What a compilation took, and what it says of its logic; `refused` where nothing fits."""

    seconds: float
    ops: int = 0
    words: int = 0
    largest: int = 0
    registers: int = 0
    bound: int | None = None
    refused: str = ""


def counted(row: Row, lowering: str, level: int, target: Target) -> Count:
    """One compilation."""
    options = Options(level=level, codes="open", lowering=lowering, target=target, cache=False)
    begin = perf_counter()
    try:
        compiled = run_passes(Source("row.nsl", row.text), Path(), options)
    except Rejected as rejected:
        last = rejected.diagnostics[-1]
        return Count(perf_counter() - begin, refused=f"{last.code} {last.message}")
    seconds = perf_counter() - begin
    logic = report(compiled.choice, compiled.proof)["logic"]
    return Count(
        seconds, logic["ops"], logic["words"], logic["max_slot_words"], logic["registers"],
        logic["bound"],
    )  # fmt: skip


def targets(row: Row, lowering: str) -> Iterator[tuple[str, Target]]:
    """The chips that a row is counted on, and what to call them."""
    plain = builtin_target("scamp5")
    yield "", plain
    if row.reads_flag and lowering == "accumulate":
        yield "F", replace(plain, where_reads_flag=True)


def goal(row: Row, lowering: str) -> tuple[str, int | None]:
    """What to reach: ("ops" or "words", how many)."""
    if lowering == "edges":
        return "ops", EDGES.get(row.name)
    ops, words, more = row.ops, row.words, SET_R0 if row.masked else 0
    if words is not None:
        return "words", words + more
    return "ops", None if ops is None else ops + more


@dataclass(frozen=True)
class Line:
    """A case at a level, counted."""

    name: str
    level: int
    count: Count
    wanted: tuple[str, int | None]

    def cells(self) -> tuple[str, ...]:
        """What the columns of HEAD hold; the reason alone where nothing fits."""
        count, (kind, most) = self.count, self.wanted
        seconds = f"{count.seconds:.2f}"
        if count.refused:
            return (self.name, f"-O{self.level}", *[""] * 5, seconds, count.refused)
        bound = "" if count.bound is None else str(count.bound)
        numbers = (count.ops, count.words, count.largest, count.registers, bound)
        goal = ""
        if most is not None:
            ratio = (count.words if kind == "words" else count.ops) / most
            over = " OVER" if ratio > ROOM.get(self.level, 1.0) else ""
            goal = f"{most} {kind} x {ratio:.2f}{over}"
        return (self.name, f"-O{self.level}", *map(str, numbers), seconds, goal)


HEAD = ("case", "level", "ops", "words", "largest slot", "registers", "bound", "s", "to reach")
WIDTHS = (34, 5, 6, 6, 12, 9, 6, 7, 0)


def text(cells: tuple[str, ...], markdown: bool) -> str:
    """A row of the table."""
    if markdown:
        return f"| {' | '.join(cells)} |"
    padded = (
        f"{cell:<{width}}" if column in (0, 1, 8) else f"{cell:>{width}}"
        for column, (cell, width) in enumerate(zip(cells, WIDTHS, strict=True))
    )
    return "  ".join(padded).rstrip()


def lines(row: Row, lowering: str, level: int) -> Iterator[Line]:
    """The lines of a case, one after the other."""
    wanted = goal(row, lowering)
    kind, most = wanted
    for mark, target in targets(row, lowering):
        name = f"{row.name} {mark}".rstrip()
        count = counted(row, lowering, level, target)
        yield Line(name, level, count, wanted)
        reached = most is not None and (count.words if kind == "words" else count.ops) <= most
        if count.refused or not reached:
            larger = counted(row, lowering, level, replace(target, store_words=LARGE_STORE))
            if (larger.words, larger.ops) != (count.words, count.ops):
                yield Line(f"{name} (larger store)", level, larger, wanted)


def main() -> None:
    """Prints the tables."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--levels", default="2", help="such as 2,3: -O3 takes a minute a row")
    parser.add_argument("--rows", default="", help="only rows whose name begins so")
    parser.add_argument("--tables", default="level,edges")
    parser.add_argument("--markdown", action="store_true")
    chosen = parser.parse_args()
    lowerings = {"level": "accumulate", "edges": "edges"}
    for table in chosen.tables.split(","):
        print(f"{'' if table == 'level' else chr(10)}{table} lowering, scamp5\n")
        print(text(HEAD, chosen.markdown))
        if chosen.markdown:
            print("|---|---|" + "--:|" * 6 + "---|")
        for row in ROWS:
            if row.name.startswith(chosen.rows):
                for level in map(int, chosen.levels.split(",")):
                    for line in lines(row, lowerings[table], level):
                        print(text(line.cells(), chosen.markdown), flush=True)


if __name__ == "__main__":
    main()
