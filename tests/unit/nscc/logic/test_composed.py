"""Rules composed from parts: few words a slot, run as gates on pixels of a chip."""

from __future__ import annotations

from itertools import product

import pytest
from improve_oracle import chip, words_of
from program_oracle import program_of

from nscc.logic.composed import composed
from nscc.logic.problem import GaveUp, Machine
from nscc.logic.rule_parts import composition
from nscc.lower.decoding import problem_of
from nscc.lower.exposure_plan import frame_time, levels, plan_exposure


def problem(rule, slots, codes="code stop : 1..N code k : 0..3"):
    """What the level lowering asks for all codes of a rule."""
    program = program_of(f"nsl 1 frame {slots} slots of 100us {codes} open when {rule}", "open")
    opens = levels(program)
    plan = plan_exposure(program, "accumulate", opens)
    return problem_of(program, plan, frame_time(program), opens)[0]


def words(asked, target):
    """Words of each solution, which is run for every shutter."""
    solutions = composed(asked, Machine.of(target), 1000)
    return [words_of(solution, asked, target) for solution in solutions]


RULES = [
    f"n {sign} stop {join} n % 4 {test} k"
    for sign, join, test in product(("<", ">="), ("and", "or", "xor"), ("==", "!=", "<"))
]


@pytest.mark.parametrize("rule", RULES)
@pytest.mark.parametrize("slots", [17, 64])
def test_two_parts_take_few_words_a_slot(rule, slots):
    found = words(problem(rule, slots), chip())
    assert found
    assert min(found) <= 11 * slots


@pytest.mark.parametrize(
    "target", [chip(10, masked=False, or_sources=2, where_sources=1), chip(9)], ids=["two", "nine"]
)
@pytest.mark.parametrize("rule", RULES[::4])
def test_composed_rules_run_on_chips_with_few_registers(rule, target):
    assert words(problem(rule, 12), target)


ONE_SCRATCH = [rule for rule in RULES if " == k" in rule or "!= k" in rule]
ONE_SCRATCH.remove("n >= stop and n % 4 != k")


@pytest.mark.parametrize("rule", ONE_SCRATCH)
def test_one_scratch_register_is_enough(rule):
    found = words(problem(rule, 64), chip(10))  # 6 + 2 planes and a state
    assert found
    assert min(found) <= 19 * 64


def test_rules_of_three_parts_take_few_words():
    codes = "code stop : 1..N code k : 0..3 code j : 0..2"
    rule = "(n < stop and n % 4 != k) or n % 3 == j"
    found = words(problem(rule, 24, codes), chip())
    assert found
    assert min(found) <= 16 * 24


def test_parts_that_read_one_field_together_are_not_composed():
    asked = problem("n < stop and n % 4 != stop % 4 or n + k == stop", 16)
    assert composition(asked) is None
    with pytest.raises(GaveUp):
        words(asked, chip())
