"""Levels of effort: which one a command takes, and that more effort never costs words."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from lowering_oracle import lowered_as, program_from
from marks import slow
from nscc_command import invoke

from nscc.chips.load import builtin_target
from nscc.compiler import compile_file, compile_source
from nscc.diagnostics.diagnostic import Rejected
from nscc.logic.generate import solutions
from nscc.logic.problem import Machine, Problem
from nscc.lower import gate_search
from nscc.lower.lowered import lay_out
from nscc.pipeline import LEVELS, Options
from nscc.source import Source

TEXTS = {
    "b": "frame 40 slots of 1ms code stop : 0..39 open when n < stop",
    "c": "frame 30 slots of 1ms code s : 0..25 open when s <= n < s + 5",
    "d": "frame 14 slots of 1ms code a : 0..13 code b : 1..14 require a < b open when a <= n < b",
    "e": "frame 9 slots of 1ms code bits : bit[9] open when bits[n]",
    "modulo": "frame 24 slots of 1ms code p : 0..5 open when (n + p) % 6 < 2",
}


@pytest.mark.parametrize("level", [0, 1])
@pytest.mark.parametrize("lowering", ["accumulate", "edges"])
@pytest.mark.parametrize("name", TEXTS)
def test_the_fewest_words_of_those_found_win(
    name: str, lowering: str, level: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    found = []

    def watched(*asked: Any) -> Any:
        for solution in solutions(*asked):
            found.append(solution)
            yield solution

    monkeypatch.setattr(gate_search, "solutions", watched)
    options = Options(level=level, codes="open", lowering=lowering, cache=False)
    best = compile_source(Source("p.nsl", f"nsl 1 {TEXTS[name]}"), Path(), options).lowered
    assert best is not None
    laid = [
        lay_out(best.program, replace(best.decoding, solution=solution), best.time, None)
        for solution in found
    ]
    assert best.price == min(each.price for each in laid)


@pytest.mark.parametrize("lowering", ["accumulate", "edges"])
@pytest.mark.parametrize("name", [slow(each) if each == "e" else each for each in TEXTS])
def test_more_effort_never_costs_words(name: str, lowering: str) -> None:
    words = []
    for level in LEVELS[:3]:
        options = Options(level=level, codes="open", lowering=lowering, cache=False)
        compiled = compile_source(Source("p.nsl", f"nsl 1 {TEXTS[name]}"), Path(), options)
        words.append(compiled.lowered.schedule.words_total)
    assert words == sorted(words, reverse=True)


@pytest.mark.parametrize(("lowering", "store_words"), [("accumulate", 400), ("edges", 60)])
def test_more_effort_fits_where_less_does(lowering: str, store_words: int) -> None:
    """Stores for kernels that are just large enough for 505 bumps of 33 slots without effort are
    large enough with effort."""
    n = np.arange(33)
    bumps = np.array([(a <= n) & (b > n) for a in range(33) for b in range(a + 1, 34)])
    some = np.random.default_rng(0).permutation(len(bumps))[:505]
    target = replace(builtin_target("scamp5"), store_words=store_words)
    program = program_from(bumps[some], target=target)
    prices = [lowered_as(program, lowering, level).price for level in (0, 1)]
    assert not prices[0][0]
    assert prices == sorted(prices, reverse=True)


def test_a_level_never_costs_more_than_the_levels_below(monkeypatch: pytest.MonkeyPatch) -> None:
    """A search with more steps may end elsewhere, so lower levels are tried, too."""
    n = np.arange(9)
    program = program_from([(a <= n) & (n < b) for a in range(9) for b in range(a + 1, 10)])
    real = gate_search.solutions
    prices = []
    for level in (1, 2, 3):
        worse = 0 if level == 1 else level

        def stunted(problem: Problem, machine: Machine, asked: int, worse: int = worse) -> Any:
            found = real(problem, machine, 1)
            return iter(()) if asked == worse else found

        monkeypatch.setattr(gate_search, "solutions", stunted)
        prices.append(lowered_as(program, "accumulate", level).price)
    assert prices == sorted(prices, reverse=True)


@pytest.mark.parametrize("level", [-1, 4])
def test_other_levels_are_refused(level: int, tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="not one of"):
        compile_source(Source("p.nsl", "nsl 1"), Path(), Options(level=level))
    done = invoke(["build", "p.nsl", "-O", level], tmp_path)
    assert (done.status, done.codes) == (2, ["NS0783"])
    assert "0<=x<=3" in done.err


@pytest.mark.parametrize(
    ("arguments", "level"),
    [
        (["check"], 1),
        (["check", "-O", "3"], 3),
        (["build"], 2),
        (["build", "-O", "0"], 0),
        (["run", "--scene", "builtin:dark", "-o", "f.npz"], 2),
        (["shutters", "-o", "s.npz"], 2),
        (["view"], 2),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, list) else f"-O{value}",
)
def test_commands_compile_at_their_documented_level(
    arguments: list[str], level: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "p.nsl").write_text(
        "nsl 1 frame 4 slots of 1ms code stop : 1..4 open when n < stop pixels stop = 1 + x % 4"
    )
    taken = []

    def compiled(path, options, see=None):
        taken.append(options.level)
        return compile_file(path, options, see)

    for module in ("compiler", "containers"):
        monkeypatch.setattr(f"nscc.{module}.compile_file", compiled)
    command, *more = arguments
    assert invoke([command, "p.nsl", *more], tmp_path).status == 0
    assert taken == [level]


def test_suggestions_are_compiled_at_level_1(monkeypatch: pytest.MonkeyPatch) -> None:
    """The program cannot fit at any level. The suggestions of its error were compiled at -O1."""
    from nscc import pipeline

    levels = []
    find_gates = pipeline.find_gates

    def watched(planned, level, **more):
        levels.append(level)
        return find_gates(planned, level, **more)

    monkeypatch.setattr(pipeline, "find_gates", watched)
    text = "nsl 1 frame 16 slots of 1ms code bits : bit[16] open when bits[n]"
    with pytest.raises(Rejected) as caught:
        compile_source(Source("p.nsl", text), Path(), Options(level=3))
    assert caught.value.diagnostics[-1].ways_out
    assert set(levels) == {1}
