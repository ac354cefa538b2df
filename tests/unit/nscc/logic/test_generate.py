"""Every generator by itself: its gates answer each demand and leave the planes as they were."""

from __future__ import annotations

import random
from dataclasses import replace
from itertools import combinations

import numpy as np
import pytest
from lowering_oracle import program_from
from marks import slow

from nscc.logic.bound import level_bound
from nscc.logic.cubes import Budget, cover
from nscc.logic.encodings import covered_fields
from nscc.logic.generate import GENERATORS, solutions
from nscc.logic.problem import Gates, GaveUp, Machine
from nscc.logic.replay import fault
from nscc.lower.decoding import problem_of
from nscc.lower.exposure_plan import levels, plan_exposure, timeline

N = np.arange(12)
TABLES = {
    "stops": [stop > N for stop in range(13)],
    "windows": [(start <= N) & (start + 3 > N) for start in range(10)],
    "bumps": [(a <= N) & (b > N) for a in range(12) for b in range(a + 1, 13)],
    "bits": [[i >> k & 1 for k in range(6)] for i in range(64)],
    "book": np.random.default_rng(2).integers(0, 2, (16, 9)),
    "sparse": np.random.default_rng(3).random((30, 12)) < 0.1,
    "buckets": [[stop > N, stop <= N] for stop in range(1, 12)],
    "two": [[1, 1, 0, 1], [0, 1, 1, 0]],
    "short": [(a <= N[:6]) & (b > N[:6]) for a in range(6) for b in range(a + 1, min(a + 3, 7))],
}
MACHINES = {
    "scamp5": Machine(13, True, None, None, False),
    "calls": Machine(13, True, 4, 3, False),
    "narrow": Machine(13, True, 2, 2, True),
    "small": Machine(6, False, None, None, True),
    "tiny": Machine(3, True, None, None, False),
}
SINGLE = [g for g in GENERATORS.values() if g.kind not in ("family", "cascade")]
FAMILIES = [g for g in GENERATORS.values() if g.kind == "family"]


def problem(table, lowering):
    """The demands of a table in one lowering, with the bits of each shutter as its fields."""
    program = program_from((TABLES | LONG_TABLES)[table])
    opens = levels(program)
    plan = plan_exposure(program, lowering, opens)
    time = timeline(program.frame.slot_us, len(program.buckets), program.target)
    asked, _ = problem_of(program, plan, time, opens)
    rows = program.table.shutters.reshape(asked.shutters, -1)
    first = rows.argmax(axis=1)
    return replace(asked, values={"first": first, "count": rows.sum(axis=1)})


class Pixels:
    """Virtual registers as truth vectors over all shutters; those that nobody wrote are random."""

    def __init__(self, asked, machine, solution, seed):
        self.all = asked.everything
        self.machine = machine
        self.solution = solution
        self.choose = random.Random(seed)
        self.held = {f"p{i}": plane for i, plane in enumerate(solution.planes)}
        self.held |= {f"s{i}": self.noise() for i in range(solution.states)}
        self.held |= {f"t{i}": self.noise() for i in range(solution.scratch)}
        self.held["FLAG"] = self.noise()

    def noise(self):
        """A random truth vector."""
        return self.choose.getrandbits(max(1, self.all.bit_length())) & self.all

    def run(self, segments):
        """Gates, within the fan-in of the machine."""
        for segment in segments:
            for gate in segment:
                some = 0
                for name in gate.sources:
                    some |= self.held[name]
                if gate.name == "WHERE":
                    assert gate.destination == "FLAG"
                    assert len(gate.sources) <= (self.machine.where_sources or 99)
                    assert self.machine.where_reads_flag or "FLAG" not in gate.sources
                elif gate.name in ("NOR", "OR"):
                    assert 2 <= len(gate.sources) <= (self.machine.or_sources or 99)
                else:
                    assert len(gate.sources) == (gate.name in ("NOT", "MOV"))
                inverted = gate.name in ("NOR", "NOT", "SET")
                value = some ^ (self.all if inverted else 0)
                if gate.masked:
                    mask, before = self.held["t0"], self.held[gate.destination]
                    value = value & mask | before & ~mask
                self.held[gate.destination] = value


def check(asked, machine, solution, seed):
    """Two frames: every demand answered, every plane back."""
    assert len(solution.planes) + solution.states + solution.scratch <= machine.registers
    assert len(solution.holders) == len(solution.planes)
    assert fault(asked, machine, solution) is None
    pixels = Pixels(asked, machine, solution, seed)
    code = {f"p{i}": plane for i, plane in enumerate(solution.planes)}
    for _ in range(2):
        pixels.run(solution.opening)
        for demand, answer in zip(asked.demands, solution.answers, strict=True):
            if not demand.flag_kept:
                pixels.held["FLAG"] = pixels.noise()
            pixels.run(answer)
            assert pixels.held["FLAG"] == demand.predicate
        pixels.run(solution.closing)
        assert all(pixels.held[name] == plane for name, plane in code.items())


@pytest.mark.parametrize("machine", MACHINES)
@pytest.mark.parametrize("lowering", ["accumulate", "edges"])
@pytest.mark.parametrize("table", TABLES)
def test_every_generator_answers_its_demands(table, lowering, machine):
    asked = problem(table, lowering)
    for number, generator in enumerate(SINGLE):
        try:
            found = list(generator.solve(asked, MACHINES[machine], 400_000))
        except GaveUp:
            continue
        assert found
        for solution in found:
            check(asked, MACHINES[machine], solution, number)


LONG = np.arange(40)
M = np.arange(21)
LONG_TABLES = {
    "long stops": [stop > LONG for stop in range(41)],
    "late starts": [start <= LONG for start in range(38)],
    "split": [[stop > LONG, stop <= LONG] for stop in range(1, 40)],
    "some stops": [stop > LONG for stop in (3, 4, 9, 17, 18, 30, 33, 40)],
    "cut windows": [(start <= LONG) & (start + 6 > LONG) for start in range(40)],
    "narrow windows": [(start <= LONG) & (start + 4 > LONG) for start in range(40)],
    "wide windows": [(start <= LONG) & (start + 13 > LONG) for start in range(28)],
    "long bumps": [(a <= M) & (b > M) for a in range(21) for b in range(a, 22)],
    "some bumps": [(a <= LONG) & (a + 3 + 5 * a % 17 > LONG) for a in range(36)],
}


@pytest.mark.parametrize("machine", MACHINES)
@pytest.mark.parametrize("lowering", ["accumulate", "edges"])
@pytest.mark.parametrize("table", [*TABLES, *LONG_TABLES])
def test_every_family_answers_its_demands(table, lowering, machine):
    """Each solution of a family gives the demanded values, or the family gives up within 100 000
    steps."""
    asked = problem(table, lowering)
    for number, family in enumerate(FAMILIES):
        try:
            for solution in family.solve(asked, MACHINES[machine], 100_000):
                check(asked, MACHINES[machine], solution, number)
        except GaveUp:
            continue


@pytest.mark.parametrize("flag_kept", [False, True])
@pytest.mark.parametrize("table", LONG_TABLES)
def test_families_solve_problems_whether_flag_lasts_or_not(table, flag_kept):
    asked = problem(table, "accumulate")
    demands = tuple(replace(d, flag_kept=flag_kept and i > 0) for i, d in enumerate(asked.demands))
    asked = replace(asked, demands=demands, flag_lasts=flag_kept)
    for number, family in enumerate(FAMILIES):
        try:
            for solution in family.solve(asked, MACHINES["scamp5"], 100_000):
                check(asked, MACHINES["scamp5"], solution, number)
        except GaveUp:
            continue


@pytest.mark.parametrize("seed", range(20))
def test_cubes_may_contain_free_shutters_and_prefer_standing_planes(seed):
    """The cubes contain all shutters that must be in, and no others but free ones. Of 16 codes of
    four planes, the code of one shutter with eight free ones is covered without inversions."""
    choose = random.Random(seed)
    everything = (1 << 16) - 1
    planes = [sum((code >> bit & 1) << code for code in range(16)) for bit in range(4)]
    on, free = choose.getrandbits(16), choose.getrandbits(16)
    standing = [choose.getrandbits(1) for _ in planes]
    cubes = cover(on, planes, everything, Budget(10_000), free=free, standing=standing)
    covered = {
        code for code in range(16) for cube in cubes if all(code >> p & 1 == v for p, v in cube)
    }
    assert {code for code in range(16) if on >> code & 1} <= covered
    assert covered <= {code for code in range(16) if (on | free) >> code & 1}
    half = sum(1 << code for code in range(16) if code & 1 == standing[0])
    (cube,) = cover(half & -half, planes, everything, Budget(100), free=half, standing=standing)
    assert cube == ((0, standing[0]),)


def test_every_generator_solves_some_table():
    """For each generator there is a table, chip and lowering for which it does not give up. One
    that serves none should be deleted."""
    served = set()
    for table, machine in ((t, m) for t in TABLES for m in ("scamp5", "small")):
        for lowering in ("accumulate", "edges"):
            for number, generator in enumerate(SINGLE):
                if number in served:
                    continue
                try:
                    list(generator.solve(problem(table, lowering), MACHINES[machine], 400_000))
                except GaveUp:
                    continue
                served.add(number)
    assert served == set(range(len(SINGLE)))


def test_every_family_solves_some_long_table():
    served = set()
    for table in LONG_TABLES:
        for lowering in ("accumulate", "edges"):
            for number, family in enumerate(FAMILIES):
                if number in served:
                    continue
                try:
                    if list(family.solve(problem(table, lowering), MACHINES["scamp5"], 100_000)):
                        served.add(number)
                except GaveUp:
                    continue
    assert served == set(range(len(FAMILIES)))


@pytest.mark.parametrize("level", [0, 1, slow(2)])
def test_solutions_are_the_same_every_time(level):
    """The generator run twice gives equal solutions in equal order, at each level."""
    asked = problem("book", "edges")
    first = list(solutions(asked, MACHINES["scamp5"], level))
    assert first
    assert first == list(solutions(asked, MACHINES["scamp5"], level))


def test_equal_shutters_have_no_demands():
    asked = replace(problem("two", "edges"), demands=())
    (solution,) = solutions(asked, MACHINES["tiny"], 1)
    assert solution.planes == ()


def test_random_rows_that_need_more_steps_than_the_first_try_are_solved():
    """The table has 150 random rows of 40 slots."""
    TABLES["many"] = np.random.default_rng(5).integers(0, 2, (150, 40))
    asked = problem("many", "accumulate")
    del TABLES["many"]
    assert len(list(solutions(asked, MACHINES["scamp5"], 0))) >= 1


@pytest.mark.parametrize("seed", range(8))
def test_covers_contain_all_required_codes_and_no_forbidden_ones(seed):
    choose = random.Random(seed)
    everything = (1 << 64) - 1
    planes = [sum((i >> k & 1) << i for i in range(64)) for k in range(6)]
    on = choose.getrandbits(64)
    off = everything & ~on
    covered = 0
    for cube in cover(on, planes, everything, Budget(100_000)):
        where = everything
        for plane, value in cube:
            where &= planes[plane] if value else everything & ~planes[plane]
        assert where & on
        covered |= where
    assert on & ~covered == 0
    assert off & covered == 0


def test_a_cover_gives_up_if_equal_codes_must_differ():
    """Two shutters of one code that must differ, and too few steps, raise GaveUp."""
    with pytest.raises(GaveUp, match="same code"):
        cover(0b01, [0b11, 0b00], 0b11, Budget(1000))
    with pytest.raises(GaveUp, match="steps"):
        cover(0b01, [0b01] * 9, 0b11, Budget(5))


@pytest.mark.parametrize("limit", [2, 3, 4, None])
@pytest.mark.parametrize("count", range(9))
@pytest.mark.parametrize("inside", [False, True])
def test_gates_keep_the_fan_in(limit, count, inside):
    """NOR, OR and WHERE of any number of sources, the destination among them or not."""
    machine = Machine(13, True, limit, limit, False)
    choose = random.Random(count)
    sources = [f"p{i}" for i in range(count)] + ["t0"] * inside
    for kind in ("nor", "or_", "where"):
        if kind == "where" and not sources:
            continue
        gates = Gates(machine)
        held = {name: choose.random() < 0.3 for name in [*sources, "t0"]}
        truth = any(held[name] for name in sources)
        if kind == "where":
            gates.load_flag(sources, "t0")
        else:
            getattr(gates, kind)("t0", sources)
        for gate in gates.take():
            some = any(held[name] for name in gate.sources)
            assert limit is None or len(gate.sources) <= limit
            held[gate.destination] = some ^ (gate.name in ("NOR", "NOT", "SET"))
        result = held["FLAG" if kind == "where" else "t0"]
        assert result == (truth ^ (kind == "nor"))


@pytest.mark.parametrize(
    ("name", "shutters", "slots", "bound"),
    [
        ("b", 8, 8, 7),
        ("b", 9, 8, 8),
        ("b", 64, 64, 113),
        ("b", 256, 256, 497),
        ("c", 64, 64, 115),
        ("c", 57, 64, 108),
        ("d", 36, 8, 8),
        ("d", 136, 16, 22),
        ("d", 528, 32, 57),
        ("d", 2080, 64, 124),
        ("d", 2081, 64, 124),
        ("d", 5, 64, None),
        ("e", 64, 6, None),
    ],
)
def test_level_bound_is_the_known_number_of_words(name, shutters, slots, bound):
    assert level_bound(name, shutters, slots, 13) == bound


@pytest.mark.parametrize("slots", range(2, 9))
@pytest.mark.parametrize("registers", range(2, 7))
def test_the_bound_of_bumps_counts_the_registers_that_can_be_loaded_at_first(slots, registers):
    """The expected number comes from all sets of slots. A set can be loaded if the other registers
    can distinguish the bumps that contain none of its slots."""
    bumps = [(a, b) for a in range(slots) for b in range(a, slots)]
    if len(bumps) > 1 << registers:
        return
    loadable = max(
        size
        for size in range(min(registers, slots) + 1)
        for loaded in combinations(range(slots), size)
        if sum(not any(a <= n <= b for n in loaded) for a, b in bumps) <= 1 << registers - size
    )
    assert level_bound("d", len(bumps), slots, registers) == slots + slots - loadable


def test_fields_are_encoded_where_there_are_two_and_room_for_their_bits():
    asked, machine = problem("bumps", "edges"), MACHINES["scamp5"]
    assert len(asked.values) == 2
    planes = covered_fields(asked, machine, Budget(100_000)).planes
    assert {name.split(",")[0] for _, name in planes} == {"first", "count"}
    with pytest.raises(GaveUp, match="one field"):
        covered_fields(replace(asked, values={"first": asked.values["first"]}), machine, Budget(9))
    exact = replace(machine, registers=len(planes) + 1)
    assert covered_fields(asked, exact, Budget(100_000)).planes == planes
    with pytest.raises(GaveUp, match="no register to compute with"):
        covered_fields(asked, replace(exact, registers=len(planes)), Budget(100_000))
