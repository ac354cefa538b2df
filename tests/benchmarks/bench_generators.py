"""What each generator and each improver of gates adds: where it wins, and the words without it.

    python tests/benchmarks/bench_generators.py [--levels 2] [--slots 32] [--seconds 300]
        [--without windows,wander] [--lowerings accumulate,edges]

The programs are the examples, tests/cases/pass and synthesis.toml up to so many slots, in each
lowering. A line for each program: level, words a frame without refresh, and the generator that the
solution comes from; then, for the winner (or for each name of --without), the words without it. The
table at the end counts for each name the wins, and how often its absence costs words or saves some.
"""

from __future__ import annotations

import argparse
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from functools import partial
from pathlib import Path
from time import monotonic
from typing import Any
from unittest.mock import patch

from nscc.diagnostics.diagnostic import Rejected
from nscc.logic.generate import GENERATORS, Generator
from nscc.pipeline import Compiled, Options, run_passes
from nscc.syntax.parse import read_source
from nscc_training.sweep.grid import read_grid
from nscc_training.sweep.point_programs import compiled_of

ROOT = Path(__file__).parents[2]
IMPROVERS: dict[str, tuple[str, Callable[..., Any]]] = {
    "balance": ("nscc.lower.refinery.balance", lambda solution, *_: solution),
    "recolour": ("nscc.logic.improve.search.recoloured", lambda *_: None),
    "shrink": ("nscc.logic.improve.search.shrink", lambda *_: None),
    "wander": ("nscc.logic.improve.search.wander", lambda *_: 0),
}
"""What each improver is replaced by to leave it out."""

Program = tuple[str, Callable[[], Compiled]]


def programs(level: int, lowerings: list[str], most_slots: int) -> Iterator[Program]:
    """The names of all programs, and what compiles each."""
    for folder in ("examples", "tests/cases/pass"):
        for path in sorted((ROOT / folder).glob("*.nsl")):
            for lowering in lowerings:
                options = Options(level=level, cache=False, lowering=lowering)  # type: ignore[arg-type]
                yield f"{path.stem}, {lowering}", partial(of_file, path, options)
    for point in read_grid(Path(__file__).with_name("synthesis.toml")).points:
        values = {**point.values, "level": level}
        if values["slots"] <= most_slots and values["lowering"] in lowerings:
            store = values.get("chip.store_words") or 0
            name = (
                f"{point.grid_part} {values['slots']}, {values['lowering']}"
                + f", {store}" * bool(store)
            )
            yield name, partial(compiled_of, values)


def of_file(path: Path, options: Options) -> Compiled:
    """The program of a file, compiled."""
    return run_passes(read_source(path), path.parent, options)


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


def price(compile_program: Callable[[], Compiled]) -> tuple[int, int, str] | None:
    """Words without refresh, most at a boundary, and the encoding; None where nothing fits."""
    try:
        lowered = compile_program().lowered
    except Rejected:
        return None
    if lowered is None or not lowered.solution.segments():
        return None
    return lowered.price[2], lowered.price[3], lowered.solution.encoding


def main() -> None:
    """Measures and prints."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--levels", default="2")
    parser.add_argument("--slots", type=int, default=32)
    parser.add_argument("--seconds", type=float, default=300)
    parser.add_argument("--without", default="")
    parser.add_argument("--lowerings", default="accumulate,edges")
    asked = parser.parse_args()
    end, made = monotonic() + asked.seconds, dict[str, str]()
    wins, costs, saves = Counter[str](), Counter[str](), Counter[str]()
    names = [name for name in asked.without.split(",") if name]
    with patch.dict(GENERATORS, known(made)):
        for level in map(int, asked.levels.split(",")):
            for title, program in programs(level, asked.lowerings.split(","), asked.slots):
                found = price(program) if monotonic() < end else None
                if found is None:
                    continue
                winner = made.get(found[2], "")  # states of programs that look have no generator
                wins[winner] += 1
                line = f"{title}, -O{level}: {found[0]} words, {winner or found[2]}"
                for name in names or [winner] * bool(winner):
                    with without(name):
                        other = price(program)
                    line += f"; without {name}: {other[0] if other else 'none'}"
                    costs[name] += other is None or other[:2] > found[:2]
                    saves[name] += other is not None and other[0] < found[0]
                print(line, flush=True)
    print(f"\n{'name':<26}{'wins':>6}{'costs':>7}{'saves':>7}")
    for name in [*GENERATORS, *IMPROVERS]:
        print(f"{name:<26}{wins[name]:>6}{costs[name]:>7}{saves[name]:>7}")


if __name__ == "__main__":
    main()
