"""Rules composed from parts: few words a slot, run as gates on pixels of a chip."""

from __future__ import annotations

from itertools import product

import pytest
from improve_oracle import chip, words_of
from program_oracle import program_of

from nscc.logic.composed import composed
from nscc.logic.problem import Gate, GaveUp, Machine
from nscc.logic.replay import fault
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
    """A rule of two parts takes at most eleven words a slot, for 17 and 64 slots."""
    found = words(problem(rule, slots), chip())
    assert found
    assert min(found) <= 11 * slots


@pytest.mark.parametrize(
    "target", [chip(10, masked=False, or_sources=2, where_sources=1), chip(9)], ids=["two", "nine"]
)
@pytest.mark.parametrize("rule", RULES[::4])
def test_composed_rules_run_on_chips_with_few_registers(rule, target):
    """Ten registers without masks, and nine with, are enough for these rules."""
    assert words(problem(rule, 12), target)


@pytest.mark.parametrize("rule", [rule for rule in RULES if " < k" not in rule])
def test_one_scratch_register_is_enough(rule):
    """On ten registers, rules of 64 slots take at most nine words a slot."""
    found = words(problem(rule, 64), chip(10))  # 6 + 2 planes and a state in the masked register
    assert found
    assert min(found) <= 9 * 64  # analog words add five


@pytest.mark.parametrize(
    ("period", "rule", "most"),
    [
        (3, "n < stop and n % 3 != k", 5),
        (3, "n >= stop xor n % 3 == k", 7),
        (5, "n < stop xor n % 5 == k", 9),
        (5, "not (n < stop or n % 5 == k)", 8),
        (8, "n < stop and n % 8 < k", 8),
    ],
)
def test_periods_take_few_words_a_slot(period, rule, most):
    slots = 96 if period == 3 else 100
    codes = f"code stop : 1..N code k : 0..{period - 1}"
    found = words(problem(rule, slots, codes), chip(12 if period == 8 else 11 + (period == 5)))
    assert found
    assert min(found) <= most * slots


THREE_PARTS = [
    "(n < stop and n % 4 != k) or n % 3 == j",
    "n < stop and n % 4 != k and n % 3 != j",
    "not (n < stop or n % 4 == k) and n % 3 != j",
    "n >= stop and (n % 4 == k or n % 3 == j)",
    "(n >= stop xor n % 4 == k) and n % 3 != j",
]


@pytest.mark.parametrize("rule", THREE_PARTS)
@pytest.mark.parametrize("registers", [12, 13], ids=["one", "two"])
def test_rules_of_three_parts_take_few_words(rule, registers):
    codes = "code stop : 1..N code k : 0..3 code j : 0..2"
    found = words(problem(rule, 60, codes), chip(registers))
    assert found
    # Eleven words for each of 60 slots.
    assert min(found) <= 11 * 60


@pytest.mark.parametrize("rule", ["n < stop xor n % 4 == k xor n % 3 == j", THREE_PARTS[-1]])
def test_rules_with_exclusive_or_of_three_parts_run(rule):
    codes = "code stop : 1..N code k : 0..3 code j : 0..2"
    assert words(problem(rule, 24, codes), chip(13))


def test_masked_gates_change_only_where_the_mask_is_set():
    """The gate inverts s0 where t0 is set and keeps it elsewhere. A chip without masks cannot run
    the solution."""
    gate = Gate("NOT", "s0", ("s0",), masked=True)
    assert gate.reads == ("s0", "t0", "s0")
    assert gate.result({"s0": 0b0011, "t0": 0b0101}, 0b1111) == 0b0110
    asked = problem("n < stop xor n % 4 == k", 16)
    solution = next(composed(asked, Machine.of(chip()), 1000))
    assert solution.masked_state() == "s0"
    assert fault(asked, Machine.of(chip()), solution) is None
    assert "does not write the masked register" in fault(
        asked, Machine.of(chip(masked=False)), solution
    )


def test_parts_that_read_one_field_together_are_not_composed():
    asked = problem("n < stop and n % 4 != stop % 4 or n + k == stop", 16)
    assert composition(asked) is None
    with pytest.raises(GaveUp):
        words(asked, chip())
