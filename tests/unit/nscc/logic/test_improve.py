"""What `improve` removes from gates written by hand and from those of the generators."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from improve_oracle import chip, random_solution, words_of
from lowering_oracle import program_from

from nscc.logic.cubes import Budget
from nscc.logic.generate import GENERATORS
from nscc.logic.improve.search import balance, improve
from nscc.logic.problem import Demand, Gate, GaveUp, Machine, Problem, Solution
from nscc.lower.decoding import problem_of
from nscc.lower.exposure_plan import levels, plan_exposure, timeline
from nscc.lower.gate_search import GateSearch
from nscc.pipeline import Options, run_passes
from nscc.source import Source

SCAMP = chip()
MACHINE = Machine.of(SCAMP)

A, B, C = 0b00001111, 0b00110011, 0b01010101
ALL = 0b11111111


def gates(text):
    """Gates from `t0 = NOR p0 p1; p2 = MOV p1; FLAG = WHERE t0`."""
    found = []
    for part in filter(None, (part.strip() for part in text.split(";"))):
        destination, rest = part.split("=")
        name, *sources = rest.split()
        found.append(Gate(name, destination.strip(), tuple(sources)))
    return tuple(found)


def solved(predicates, answers, *, closing="", states=0, scratch=1, planes=(A, B, C), **more):
    """A problem over eight shutters with one demand a boundary, and its solution."""
    demands = tuple(Demand(i + 1, "open", 0, p, False) for i, p in enumerate(predicates))
    problem = Problem(demands, 8, ((),), True, {})
    problem = replace(problem, **more)
    parts = tuple(
        tuple(gates(part) for part in answer.split("|") if part.strip()) for answer in answers
    )
    end = tuple(gates(part) for part in closing.split("|") if part.strip())
    names = tuple(f"plane {i}" for i in range(len(planes)))
    return problem, Solution("by hand", planes, names, states, scratch, (), parts, end)


def improved(problem, solution, target=SCAMP, steps=3000):
    """The improved solution and its words, checked; the words include refresh."""
    machine = Machine.of(target)
    before = words_of(solution, problem, target)
    found = improve(solution, problem, machine, Budget(steps))
    after = words_of(found, problem, target, seed=3)
    assert after <= before
    return found, after


REFRESH = 6  # three planes that nobody writes


@pytest.mark.parametrize(
    ("predicates", "answers", "closing", "least"),
    [
        # A gate that nobody reads.
        ([A], ["t0 = NOR p1 p2; t0 = MOV p0; FLAG = WHERE t0"], "", 1),
        # Turned over and back.
        ([ALL ^ A], ["p0 = NOT p0 | FLAG = WHERE p0"], "p0 = NOT p0", 2),
        # The same gate twice.
        ([ALL ^ (A | B)] * 2, ["t0 = NOR p0 p1; FLAG = WHERE t0"] * 2, "", 3),
        # A source that is covered by another one.
        ([A | B], ["t0 = NOR p0 p1; t1 = NOT t0; FLAG = WHERE t1 p0"], "", 1),
        # NOT NOT.
        ([A], ["t0 = NOT p0; t1 = NOT t0; FLAG = WHERE t1"], "", 1),
        # A state that is no better than the plane it came from.
        ([A, A], ["s0 = MOV p0; FLAG = WHERE s0", "FLAG = WHERE s0"], "", 2),
    ],
)
def test_unneeded_operations_are_removed(predicates, answers, closing, least):
    problem, solution = solved(predicates, answers, closing=closing, states=1, scratch=2)
    found, words = improved(problem, solution)
    assert words == least + REFRESH
    assert len(found.segments()) == len(predicates)


def test_a_plane_that_is_inverted_in_place_moves_through_a_free_register():
    """Inverting a plane in place and back takes two pairs of words. Through another register it
    takes two single words."""
    reads = [ALL ^ A, ALL ^ (A | B), ALL ^ (A | C), ALL ^ A]
    answers = [
        "p0 = NOT p0 | FLAG = WHERE p0",
        "t0 = NOT p0; t0 = NOR t0 p1; FLAG = WHERE t0",
        "t0 = NOT p0; t0 = NOR t0 p2; FLAG = WHERE t0",
        "FLAG = WHERE p0",
    ]
    problem, solution = solved(reads, answers, closing="p0 = NOT p0")
    assert words_of(solution, problem, SCAMP) == 14 + 4
    assert improved(problem, solution)[1] == 7 + REFRESH


def test_improvement_uses_registers_that_the_generator_left_free():
    """`s := s OR t` takes two words in place, but one word if it writes another register."""
    answers = [
        "t0 = NOR p0 p1; s0 = MOV t0; FLAG = WHERE s0",
        "t0 = NOR p0 p2; s0 = OR s0 t0; FLAG = WHERE s0",
        "t0 = NOR p1 p2; s0 = OR s0 t0; FLAG = WHERE s0",
    ]
    one, two, three = (ALL ^ (x | y) for x, y in ((A, B), (A, C), (B, C)))
    problem, solution = solved([one, one | two, one | two | three], answers, states=1)
    _, words = improved(problem, solution)
    assert words <= 3 + 3 + REFRESH


def test_values_do_not_outlast_memory():
    """A value is computed again if its scratch register decays before the next demand."""
    answers = ["t0 = NOR p0 p1; FLAG = WHERE t0"] * 2
    predicate = ALL ^ (A | B)
    problem, solution = solved([predicate] * 2, answers, flag_lasts=False)
    lost = tuple(replace(d, scratch_kept=False) for d in problem.demands)
    _, words = improved(replace(problem, demands=lost), solution)
    assert words == 4 + REFRESH


def test_improvement_reads_flag_where_it_is_kept():
    answers = ["t0 = NOR p0 p1; FLAG = WHERE t0", "t0 = NOR p0 p1; t1 = NOT t0; FLAG = WHERE t1"]
    first = ALL ^ (A | B)
    problem, solution = solved([first, ALL ^ first], answers, scratch=2)
    kept = tuple(replace(d, flag_kept=i > 0) for i, d in enumerate(problem.demands))
    _, words = improved(replace(problem, demands=kept), solution)
    assert words == 3 + REFRESH


def test_gates_are_improved_if_all_registers_are_in_use():
    """Twelve registers hold planes and one is free. Each write of the plane in the masked register
    costs one more word, which also removes the mask."""
    random = np.random.default_rng(1)
    planes = tuple(int(x) for x in random.integers(1, 255, 12))
    turn = " | ".join(f"p{i} = NOT p{i}" for i in range(12))
    shown = [planes[i] for i in range(12)]
    answers = [f"{turn if i == 0 else ''} | t0 = NOT p{i}; FLAG = WHERE t0" for i in range(12)]
    problem, solution = solved(shown, answers, closing=turn, planes=planes)
    assert words_of(solution, problem, SCAMP) == 48 + 24 + 2
    _, words = improved(problem, solution)
    assert words == 12 + 24


def test_improved_gates_keep_the_sources_of_a_narrow_chip():
    narrow = chip(or_sources=2, where_sources=1)
    answers = ["t0 = NOR p0 p1; t1 = OR t0 p2; t1 = OR t1 p0; FLAG = WHERE t1"]
    problem, solution = solved([(ALL ^ (A | B)) | C | A], answers, scratch=2)
    found, _ = improved(problem, solution, narrow)
    assert all(len(g.sources) <= 2 for s in found.segments() for g in s)


def test_wrong_solutions_are_not_improved():
    problem, solution = solved([A], ["FLAG = WHERE p1"])
    assert improve(solution, problem, MACHINE, Budget(1000)) is solution


def test_without_search_steps_words_do_not_increase():
    problem, solution = random_solution(5, MACHINE)
    same = improve(solution, problem, MACHINE, Budget(0))
    assert words_of(same, problem, SCAMP) <= words_of(solution, problem, SCAMP)


def test_improving_is_deterministic():
    problem, solution = random_solution(7, MACHINE)
    first = improve(solution, problem, MACHINE, Budget(5000))
    assert first == improve(solution, problem, MACHINE, Budget(5000))


N = np.arange(12)
TABLES = {
    "stops": [stop > N for stop in range(13)],
    "windows": [(start <= N) & (start + 3 > N) for start in range(10)],
    "bumps": [(a <= N) & (b > N) for a in range(12) for b in range(a + 1, 13)],
    "book": np.random.default_rng(2).integers(0, 2, (16, 9)),
}


@pytest.mark.parametrize("lowering", ["accumulate", "edges"])
@pytest.mark.parametrize("table", TABLES)
def test_gates_of_every_generator_are_improved_and_stay_correct(table, lowering):
    """All generators' gates still answer, and rewriting gains in every table."""
    program = program_from(TABLES[table])
    plan = plan_exposure(program, lowering, levels(program))
    time = timeline(program.frame.slot_us, 1, program.target)
    asked, _ = problem_of(program, plan, time, levels(program))
    rows = program.table.shutters.reshape(asked.shutters, -1)
    asked = replace(asked, values={"first": rows.argmax(axis=1), "count": rows.sum(axis=1)})
    gains = []
    for generator in GENERATORS.values():
        if generator.kind not in ("equality", "cover"):
            continue
        try:
            found = list(generator.solve(asked, MACHINE, 100_000))
        except GaveUp:
            continue
        assert found
        for solution in found:
            _, words = improved(asked, solution, steps=6000)
            gains.append(words_of(solution, asked, SCAMP) - words)
    assert gains
    assert max(gains) > 5


def test_work_moves_to_slots_that_have_time():
    """Three NORs for one demand: two of them can be computed in the slots before."""
    reads = [A, B, (ALL ^ (A | B)) | (ALL ^ (A | C)) | (ALL ^ (B | C))]
    answers = [
        "FLAG = WHERE p0",
        "FLAG = WHERE p1",
        "t0 = NOR p0 p1; t1 = NOR p0 p2; t2 = NOR p1 p2; FLAG = WHERE t0 t1 t2",
    ]
    problem, solution = solved(reads, answers, scratch=3)
    found = balance(solution, problem, MACHINE, Budget(3000), [0, 0, 0, 0])
    assert words_of(found, problem, SCAMP) == words_of(solution, problem, SCAMP)
    assert max(sum(map(len, answer)) for answer in found.answers) == 2
    busy = balance(solution, problem, MACHINE, Budget(3000), [2, 1, 0, 0])
    assert [sum(map(len, answer)) for answer in busy.answers] == [1, 2, 3]
    wrong = replace(solution, planes=(A, B, A))
    assert balance(wrong, problem, MACHINE, Budget(3000), [0, 0, 0, 0]) is wrong


def test_an_improvement_that_raises_is_left_out_and_named(monkeypatch):
    def broken(*_: object) -> None:
        raise IndexError("not expected")

    text = "nsl 1 frame 16 slots of 1ms code a : 0..15 open when a <= n and n < a + 4"
    options = Options(level=2, cache=False)
    improved = run_passes(Source("p.nsl", text), Path(), options)
    monkeypatch.setattr(GateSearch, "improved_best", broken)
    kept = run_passes(Source("p.nsl", text), Path(), options)
    assert "NS0504" not in [d.code for d in improved.diagnostics]
    (warning,) = (d for d in kept.diagnostics if d.code == "NS0504")
    assert "'improve'" in warning.message
    assert kept.layout.failed_generators == ("improve",)
    assert kept.lowered.schedule.words_total > improved.lowered.schedule.words_total
