"""The compile-time tradeoff: words per frame against time, for each level, lowering and program."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import partial
from itertools import product
from pathlib import Path
from typing import Any, Literal

import numpy as np

from nscc.diagnostics.diagnostic import Diagnostic, Rejected
from nscc.experiment_store import Rows
from nscc.limits.families import bits_rule, book_rule, bump_rule, program_text, start_rule
from nscc.lower.exposure_plan import Lowering
from nscc.options import Options
from nscc.pipeline import KINDS, LEVELS, Compiled, run_passes
from nscc.program.program import Codes
from nscc.source import Source
from nscc.syntax.parse import read_source
from nscc.tradeoff.points import Point
from nscc.tradeoff.stopwatch import Stopwatch

Count = Literal["all", "logic"]
"""Which words to count: all words of a frame, or only those that decode codes."""

UNITS: dict[Count, str] = {"all": "words_per_frame", "logic": "logic_words_per_frame"}

DOES_NOT_FIT = ("NS04", "NS05", "NS06")


@dataclass(frozen=True)
class SynthesisCase:
    """A program to compile in all variants.

    Paths in it are relative to `base`; `target` replaces its own target."""

    name: str
    source: Source
    base: Path
    codes: Codes
    target: str | None = None


@dataclass(frozen=True)
class CompileVariant:
    """A program with a lowering and an optimisation level."""

    case: SynthesisCase
    lowering: Lowering
    level: int

    def __str__(self) -> str:
        return f"{self.case.name}, {self.lowering}, -O{self.level}"


Progress = Callable[[Sequence[CompileVariant]], Iterable[CompileVariant]]
"""A function that yields the variants one by one and may show progress."""


@dataclass(frozen=True)
class SynthesisMeasurements:
    """Points by program, lowering and level, and the variants that do not fit, with reasons."""

    points: tuple[Point, ...]
    refused: tuple[tuple[CompileVariant, str], ...]


def builtin_cases() -> tuple[SynthesisCase, ...]:
    """Return programs of classes b to e and a random codebook, in sizes for a chip with 13
    registers."""
    rows = np.random.default_rng(1).integers(0, 2, (64, 16))
    rules = {
        **{f"b {n}": (n, f"code stop : 0..{n - 1}\nopen when n < stop") for n in (16, 64, 256)},
        **{f"c (64, {length})": (64, start_rule(length)) for length in (8, 13)},
        **{f"d {n}": (n, bump_rule()) for n in (16, 32)},
        "e 12": (12, bits_rule()),
        "codebook 64 x 16": (16, book_rule(["".join(map(str, row)) for row in rows])),
    }
    return tuple(
        SynthesisCase(name, Source(f"{name}.nsl", program_text(slots, "1ms", rule)), Path(), "open")
        for name, (slots, rule) in rules.items()
    )


def cases_of(files: Sequence[Path]) -> tuple[SynthesisCase, ...]:
    """Return the programs in these files, with their shortest distinct names."""
    paths = list(dict.fromkeys(files))
    short = len({path.stem for path in paths}) == len(paths)
    return tuple(
        SynthesisCase(
            path.stem if short else path.as_posix(), read_source(path), path.parent, "fixed"
        )
        for path in paths
    )


def measure(
    ways: Sequence[CompileVariant],
    repeats: int,
    count: Count,
    progress: Progress = iter,
    rows: Rows | None = None,
) -> SynthesisMeasurements:
    """Compile each variant `repeats` times, from text to proof, without the cache.

    Each repeat compiles all variants in turn, to spread disturbances. Results in `rows` are not
    measured again. Raises Rejected for an invalid program; variants that do not fit are listed as
    refused."""
    rows = rows or Rows()
    watch = Stopwatch()
    times_ms: dict[CompileVariant, list[float]] = {way: [] for way in ways}
    words: dict[CompileVariant, tuple[float, float | None]] = {}
    refused: dict[CompileVariant, str] = {}
    for way in progress([way for _ in range(repeats) for way in ways]):
        if way in refused:
            continue
        row = rows.once(f"{way}, {len(times_ms[way])}", partial(_timed, watch, way, count))
        if "refused" in row:
            refused[way] = row["refused"]
        else:
            words[way] = row["words"], row["bound"]
            times_ms[way].append(row["ms"])
    points = [
        Point(
            way.case.name, way.lowering, f"-O{way.level}", number, UNITS[count],
            tuple(times_ms[way]), bound,
        )
        for way, (number, bound) in words.items()
    ]  # fmt: skip
    return SynthesisMeasurements(tuple(points), tuple(refused.items()))


def _timed(watch: Stopwatch, way: CompileVariant, count: Count) -> dict[str, Any]:
    kind = way.case.name, way.lowering
    least = partial(compiled_or_not, replace(way, level=min(LEVELS)))
    compiled, taken_ms = watch.ms(kind, way.level, partial(compiled_or_not, way), least)
    if isinstance(compiled, Diagnostic):
        return {"refused": f"{compiled.message} ({compiled.code})"}
    # The bound is that of the logic, plus the analog words of the plan if all words count.
    lowered = compiled.lowered
    assert lowered is not None
    logic = KINDS.of(compiled.program).report(compiled)["logic"]
    words, bound = logic["words"], logic["bound"]
    if count == "all":
        words = lowered.schedule.words_total
        if bound is not None:
            bound += sum(len(step.words) for step in lowered.plan.steps)
    return {"ms": taken_ms, "words": words, "bound": bound}


def refusals_text(refused: Sequence[tuple[CompileVariant, str]]) -> list[str]:
    """Return why programs have no point in a lowering, one line for all levels with the same
    reason."""
    levels: dict[tuple[str, str, str], list[str]] = {}
    for way, reason in refused:
        key = (way.case.name, way.lowering, reason)
        levels.setdefault(key, []).append(f"-O{way.level}")
    return [
        f"{case}, {lowering}, {' '.join(at)}: {reason}"
        for (case, lowering, reason), at in levels.items()
    ]


def every_way(
    cases: Sequence[SynthesisCase], lowerings: Sequence[Lowering], levels: Sequence[int]
) -> Iterator[CompileVariant]:
    """Return all combinations of program, lowering and level."""
    return (CompileVariant(*way) for way in product(cases, lowerings, levels))


def compiled_or_not(way: CompileVariant) -> Compiled | Diagnostic:
    """Return the compiled program, or the error if it does not fit; raise Rejected for other
    errors."""
    case = way.case
    options = Options(
        level=way.level, codes=case.codes, lowering=way.lowering, target=case.target,
        cache=False,
    )  # fmt: skip
    try:
        return run_passes(case.source, case.base, options)
    except Rejected as rejected:
        last = rejected.diagnostics[-1]
        if not last.code.startswith(DOES_NOT_FIT):
            raise
        return last
