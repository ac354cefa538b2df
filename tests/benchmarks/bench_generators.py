"""The table that decides which generators and improvers of gates stay: the words without each.

    python tests/benchmarks/bench_generators.py [--levels 1,2] [--random 150] [--seconds 3600]
        [--without equalities,wander] [--lowering auto]

The programs are the examples and tests/cases/pass (for the codes of their pixels and for all codes)
and random programs. A line for each: level, words a frame without refresh, and the generator of the
solution; then, for this generator (or for each name of --without), the words without it. The table
at the end shows for each name the wins, and the largest growth of the words and of the largest slot
without it. A generator stays if that of the words is above 3 % for some program with the default
lowering, or if the words of all programs together would rise. `balance` changes no words: it stays
for the largest slot, which sets the shortest slot of a program.
"""

from __future__ import annotations

import argparse
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from math import inf
from pathlib import Path
from random import Random
from time import monotonic
from typing import Any, get_args
from unittest.mock import patch

from nscc.diagnostics.diagnostic import Rejected
from nscc.logic.generate import GENERATORS, Generator
from nscc.options import Options
from nscc.pipeline import run_passes
from nscc.program.program import Codes
from nscc.source import Source
from nscc.syntax.parse import read_source

ROOT = Path(__file__).parents[2]
IMPROVERS: dict[str, tuple[str, Callable[..., Any]]] = {
    "balance": ("nscc.logic.improve.search.balance", lambda solution, *_: solution),
    "recolour": ("nscc.logic.improve.search.recoloured", lambda *_: None),
    "shrink": ("nscc.logic.improve.search.shrink", lambda *_: None),
    "wander": ("nscc.logic.improve.search.wander", lambda *_: 0),
}
"""What each improver is replaced by to leave it out."""


def programs(random_count: int) -> Iterator[tuple[str, Source, Path, Codes]]:
    """The name, the text, the folder and the codes of each program."""
    for folder in ("examples", "tests/cases/pass"):
        for path in sorted((ROOT / folder).glob("*.nsl")):
            for codes in get_args(Codes):
                yield f"{path.stem}, {codes}", read_source(path), path.parent, codes
    for seed in range(random_count):
        yield f"random {seed}", Source("random.nsl", random_program(seed)), ROOT, "open"


def random_program(seed: int) -> str:
    """The text of a random program: a class of the paper, a codebook, or a composed rule."""
    choose = Random(seed)
    slots = choose.choice([6, 8, 12, 16, 20, 24, 32, 33, 40, 48, 64, 65, 80, 100, 128])
    few = choose.choice([3, 4, 5, 8])
    start, length = choose.randrange(2, min(slots, 24)), choose.choice([2, 3, 4, 5])
    book_slots = min(slots, 32)
    rows = (
        "".join(choose.choice("01") for _ in range(book_slots))
        for _ in range(choose.choice([4, 16, 30, 64]))
    )
    kinds = [
        (slots, f"code stop : {seed % 2}..N", choose.choice(STOPS).format(few)),
        (slots, f"code start : 0..N - {choose.choice([1, length])}",
         f"start <= n < start + {length}"),
        (book_slots, "code start : 0..N - 1 code stop : 1..N require start < stop",
         "start <= n < stop"),
        (slots, f"code phase : 0..{few - 1}", f"(n + phase) % {few} < {1 + seed % (few - 1)}"),
        (book_slots, f"shutters book [{', '.join(rows)}] code id : row of book", "book[id]"),
        (book_slots, f"code bits : bit[{few}]", f"bits[n * {few} / N]"),
        (slots, f"code stop : 1..N code k : 0..{few - 1}",
         f"n < stop {choose.choice(['and', 'or', 'xor'])} n % {few} != k"),
        (slots, f"code a : 0..{start} code b : 0..{few}", choose.choice(TWO_FIELDS)),
    ]  # fmt: skip
    slots, codes, rule = kinds[seed % len(kinds)]
    return f"nsl 1 frame {slots} slots of 1ms {codes} open when {rule}"


STOPS = ("n < stop", "n >= stop", "n != stop", "n < stop and n % {} != 1")
TWO_FIELDS = (
    "n <= a and n != b",
    "n < a or n / 2 == b",
    "n % (b + 1) == 0 and n >= a",
    "a <= n < a + b + 1",
    "n > a xor n % 3 == b",
    "a <= n and n % 2 == b % 2",
)


@contextmanager
def without(name: str) -> Iterator[None]:
    """Leaves out a generator or an improver."""
    if name in IMPROVERS:
        with patch(*IMPROVERS[name]):
            yield
    else:
        with patch.dict(GENERATORS):
            GENERATORS.pop(name, None)
            yield


def known(made: dict[str, str]) -> dict[str, Generator]:
    """The generators, which note in `made` whose each encoding is."""

    def noting(name: str, generator: Generator) -> Generator:
        def solve(*problem: Any) -> Iterator[Any]:
            for solution in generator.solve(*problem):
                made[solution.encoding] = name
                yield solution

        return replace(generator, solve=solve)

    return {name: noting(name, generator) for name, generator in GENERATORS.items()}


def price(source: Source, base: Path, options: Options) -> tuple[int, int, str] | None:
    """Words without refresh, those of the largest slot, and the encoding.

    None if nothing fits or no gates are needed."""
    try:
        lowered = run_passes(source, base, options).lowered
    except Rejected:
        return None
    if lowered is None or not lowered.solution.segments():
        return None
    return *lowered.price[2:4], lowered.solution.encoding


def main() -> None:
    """Measures and prints."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--levels", default="1,2")
    parser.add_argument("--random", type=int, default=150)
    parser.add_argument("--seconds", type=float, default=3600)
    parser.add_argument("--without", default="")
    parser.add_argument("--lowering", default="auto")
    asked = parser.parse_args()
    end, made, total = monotonic() + asked.seconds, dict[str, str](), 0
    wins, without_total = Counter[str](), Counter[str]()
    most = {figure: dict[str, tuple[float, str]]() for figure in ("words", "largest slot")}
    names = [name for name in asked.without.split(",") if name]
    with patch.dict(GENERATORS, known(made)):
        for level in map(int, asked.levels.split(",")):
            for title, source, base, codes in programs(asked.random):
                options = Options(level=level, codes=codes, lowering=asked.lowering, cache=False)
                best = price(source, base, options) if monotonic() < end else None
                if best is None:
                    continue
                words, winner = best[0], made.get(best[2], "")
                total += words
                wins[winner] += 1
                line = f"{title}, -O{level}: {words} words, {winner or best[2]}"
                for name in names or [winner] * bool(winner):
                    with without(name):
                        other = price(source, base, options)
                    line += f"; without {name}: {other[0] if other else 'none'}"
                    without_total[name] += (other or best)[0] - words
                    for index, largest in enumerate(most.values()):
                        growth = other[index] / best[index] - 1 if other else inf
                        of_program = growth, f"{title}, -O{level}"
                        largest[name] = max(largest.get(name, (0.0, "")), of_program)
                print(line, flush=True)
    print(f"\n{total} words in all\n{'name':<26}{'wins':>6}{'words more':>12}  largest growth")
    for name in [*GENERATORS, *IMPROVERS]:
        growths = ", ".join(
            f"{figure} {growth:.1%} ({program})"
            for figure, largest in most.items()
            for growth, program in [largest.get(name, (0.0, "none"))]
        )
        print(f"{name:<26}{wins[name]:>6}{without_total[name]:>12}  {growths}")


if __name__ == "__main__":
    main()
