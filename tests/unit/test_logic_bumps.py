"""Bumps of which both ends are free: the cubes of the tables, and the gates that use them, run as
words on pixels of a chip (`improve_oracle`)."""

from __future__ import annotations

import tomllib
from dataclasses import replace
from itertools import product
from pathlib import Path

import numpy as np
import pytest
from improve_oracle import chip, words_of
from lowering_oracle import container_of, does_as_told, lowered_as, program_from

import nscc.logic.cube_tables
from nscc.logic.bumps import halved_bumps, paired_bumps
from nscc.logic.cube_tables import BumpCubes, number_cubes
from nscc.logic.digits import cycle
from nscc.logic.problem import GaveUp, Machine
from nscc.lower.decoding import problem_of
from nscc.lower.exposure_plan import levels, plan_exposure, timeline
from nscc.prove.proof import prove
from nscc.words.legality import decoded

TABLES = tomllib.loads(Path(nscc.logic.cube_tables.__file__).with_suffix(".toml").read_text())
SCAMP = chip()
CALLS = chip(or_sources=4, where_sources=3)
PLAIN = chip(masked=False)


def agrees(code, cube):
    """Whether a code, its lowest bit first, is in a cube as the tables write one."""
    return all(bit in ("-", str(code >> plane & 1)) for plane, bit in enumerate(cube))


def literals(cube):
    """A cube of the compiler as the tables write it, of ten planes."""
    values = dict(cube)
    return "".join(str(values.get(plane, "-")) for plane in range(10))


@pytest.mark.parametrize("number", range(len(TABLES["bumps"])))
def test_every_bump_has_a_code_that_rises_and_falls_in_its_groups_only(number):
    table = TABLES["bumps"][number]
    lines = [line.split("|") for line in table["rows"].strip().splitlines()]
    groups, codes = len(lines), range(1 << table["planes"])
    rises = [{c for c in codes if any(agrees(c, x) for x in rise.split())} for rise, _ in lines]
    falls = [{c for c in codes if agrees(c, fall.strip())} for _, fall in lines]
    for i in range(groups):
        for j in range(i, groups):
            allowed = rises[i] & falls[j] if j < groups - 1 else set(rises[i])
            for k in range(groups):
                if k < i or k > j:
                    allowed -= rises[k]
                elif k < j:
                    allowed -= falls[k]
            assert allowed, f"no code for groups {i} to {j}"


@pytest.mark.parametrize(("planes", "groups"), [(8, 5), (8, 16), (9, 24), (9, 28), (12, 3)])
def test_codes_are_in_the_cubes_of_their_ends_and_in_no_forbidden_one(planes, groups):
    cubes = BumpCubes.of(planes, groups)
    rises = [[literals(cube) for cube in rise] for rise in cubes.rises]
    falls = [literals(cube) for cube in cubes.falls]
    for i in range(groups):
        for j in range(i, groups):
            code = cubes.code(i, j)
            rising = [k for k in range(groups) if any(agrees(code, cube) for cube in rises[k])]
            assert i in rising
            assert all(i <= k <= j for k in rising)
            falling = [k for k in range(groups - 1) if agrees(code, falls[k])]
            assert j in falling or j == groups - 1
            assert not any(i <= k < j for k in falling)


def test_no_cubes_are_known_for_too_many_groups_or_too_few_planes():
    assert BumpCubes.of(9, 29) is None
    assert BumpCubes.of(4, 8) is None


@pytest.mark.parametrize(("planes", "count"), [*product((4, 5, 6), (5, 12, 16)), (6, 48), (7, 64)])
def test_every_number_has_a_cube_of_its_own(planes, count):
    codes, cubes = number_cubes(count, planes)
    inside = [[agrees(code, literals(cube)) for code in codes] for cube in cubes]
    assert np.array_equal(inside, np.eye(count))
    assert inversions(map(literals, cubes)) <= inversions(
        "".join(str(code >> plane & 1) for plane in range(planes)) for code in cycle(count, planes)
    )


def inversions(cubes):
    """How often a plane is asked for in the other polarity, the way back to the first included."""
    return sum(
        before != after
        for column in zip(*cubes, strict=True)
        for values in [[bit for bit in column if bit != "-"]]
        for before, after in zip(values, [*values[1:], *values[:1]], strict=True)
    )


def program_of(slots, *, never=False, keep=lambda a, b: True, slot_us=1000.0):
    """All bumps that `keep` lets pass."""
    n = np.arange(slots)
    ends = [(a, b) for a in range(slots) for b in range(a + 1, slots + 1) if keep(a, b)]
    table = [(a <= n) & (n < b) for a, b in ends] + [n < 0] * never
    return program_from(np.array(table), [slot_us] * slots)


def bumps(slots, **which):
    """What the level lowering asks for these bumps."""
    program = program_of(slots, **which)
    opens = levels(program)
    plan = plan_exposure(program, "accumulate", opens)
    time = timeline(program.frame.slot_us, 1, program.target)
    return problem_of(program, plan, time, opens)[0]


def solved(problem, target):
    """All solutions of both generators, each run on the chip; words by encoding, with refresh."""
    found = {}
    for generator in (paired_bumps, halved_bumps):
        try:
            for solution in generator(problem, Machine.of(target), 1000):
                found[solution.encoding] = words_of(solution, problem, target)
        except GaveUp:
            continue
    return found


SLOTS = [3, 4, 5, 7, 8, 15, 16, 17, 24, 31, 32, 33, 37, 40, 47, 48, 52, 55, 56, 57, 63, 64]


@pytest.mark.parametrize("target", [SCAMP, CALLS, PLAIN], ids=["scamp5", "calls", "plain"])
@pytest.mark.parametrize("slots", SLOTS)
def test_all_bumps(slots, target):
    found = solved(bumps(slots, never=slots % 2 == 1), target)
    masked = [name for name in found if "masked" in name]
    if target is PLAIN:
        assert not masked
        assert found or slots > 54
    else:
        assert len(masked) == len(found)
        assert found


@pytest.mark.parametrize("target", [SCAMP, PLAIN], ids=["scamp5", "plain"])
@pytest.mark.parametrize(
    "keep",
    [
        lambda a, b: b <= a + 7,
        lambda a, b: b >= a + 5,
        lambda a, b: a % 3 == 0,
        lambda a, b: a % 2 == 0 and b % 2 == 0,
        lambda a, b: a < 9 < b,
        lambda a, b: (7 * a + 5 * b) % 3 == 0,
    ],
)
@pytest.mark.parametrize("slots", [21, 46, 60])
def test_bumps_with_limits(slots, keep, target):
    assert solved(bumps(slots, keep=keep), target) or (target is PLAIN and slots == 60)


@pytest.mark.parametrize("slots", [24, 40, 64])
@pytest.mark.parametrize("kept", [True, False])
def test_frames_that_outlast_memory(slots, kept):
    """Scratch is lost between demands, and FLAG as well unless it is `kept`."""
    problem = bumps(slots)
    lost = tuple(
        replace(d, scratch_kept=False, flag_kept=kept and d.flag_kept) for d in problem.demands
    )
    assert solved(replace(problem, demands=lost, flag_lasts=False), SCAMP)


@pytest.mark.parametrize(
    "keep", [lambda a, b: a == 0, lambda a, b: b == 20, lambda a, b: b == min(a + 6, 20)]
)
def test_bumps_with_one_free_end_are_left_to_others(keep):
    assert not solved(bumps(20, keep=keep), SCAMP)


@pytest.mark.parametrize(
    ("slots", "most"),
    [(16, 56), (24, 90), (32, 124), (40, 180), (48, 224), (56, 320), (64, 402)],
)
def test_words_before_any_improvement(slots, most):
    """Words that refresh planes which no word writes are left out."""
    problem, machine = bumps(slots), Machine.of(SCAMP)
    words = []
    for generator in (paired_bumps, halved_bumps):
        for solution in generator(problem, machine, 1000):
            words.append(sum(gate.words for segment in solution.segments() for gate in segment))
    assert min(words) <= most


@pytest.mark.parametrize("slot_us", [1e3, 1e5, 6e5])
@pytest.mark.parametrize("slots", [20, 40, 64])
def test_words_gather_the_light_of_open_slots(slots, slot_us):
    """Bits fade on this chip, also those of a register that is written in some pixels only."""
    lowered = lowered_as(program_of(slots, slot_us=slot_us), "accumulate")
    assert lowered.solution.masked_pair() is not None
    assert "R12" in lowered.schedule.refreshed
    container = container_of(lowered)
    assert prove(container, decoded(container)).holds
    assert does_as_told(container)
