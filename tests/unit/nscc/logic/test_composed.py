"""Rules composed from parts: few words a slot, run as gates on pixels of a chip."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest
from improve_oracle import chip, words_of
from program_oracle import program_of

from nscc.logic.composed import composed
from nscc.logic.problem import Gate, GaveUp, Machine
from nscc.logic.replay import fault
from nscc.logic.rule_parts import Composition, RulePart, composition
from nscc.lower.decoding import problem_of
from nscc.lower.exposure_plan import frame_time, levels, plan_exposure
from nscc.truth import rows


def problem(rule, slots, codes="code stop : 1..N code k : 0..3"):
    """What the level lowering asks for all codes of a rule."""
    program = program_of(f"nsl 1 frame {slots} slots of 100us {codes} open when {rule}", "open")
    opens = levels(program)
    plan = plan_exposure(program, "accumulate", opens)
    return problem_of(program, plan, frame_time(program), opens)[0]


def bucket_problem(slots, codes, *rules):
    """What the level lowering asks for all codes of one bucket for each rule."""
    buckets = " ".join(f"bucket b{i} open when {rule}" for i, rule in enumerate(rules))
    program = program_of(f"nsl 1 frame {slots} slots of 100us {codes} {buckets}", "open")
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


AND_OR_NOT = "(n < a or n % 8 == b) and not (c == 1 and n > N / 2)"


@pytest.mark.parametrize("slots", [48, 64, 65, 100, 128])
def test_a_bit_takes_a_plane_and_no_state(slots):
    """Eleven planes and a state leave one register; analog words add five to nine words a slot."""
    found = words(problem(AND_OR_NOT, slots, "code a : 1..N code b : 0..7 code c : 0..1"), chip())
    assert found
    assert min(found) <= 9 * slots


@pytest.mark.parametrize(("slots", "registers"), [(64, 11), (100, 12)])
def test_without_a_register_for_a_state_numbers_are_compared(slots, registers):
    """All registers but one hold planes."""
    asked = problem(AND_OR_NOT, slots, "code a : 1..N code b : 0..7 code c : 0..1")
    found = [*composed(asked, Machine.of(chip(registers)), 1000)]
    assert {solution.states for solution in found} == {0}
    assert min(words_of(solution, asked, chip(registers)) for solution in found) <= 17 * slots


@pytest.mark.parametrize(
    "target", [chip(8), chip(8, masked=False, or_sources=2, where_sources=1)], ids=["masked", "few"]
)
@pytest.mark.parametrize("sign", ["<", ">="])
@pytest.mark.parametrize("join", ["and", "or"])
def test_comparisons_run_with_one_scratch_register(sign, join, target):
    """Seven planes of 21 stops and four phases leave one of eight registers."""
    asked = problem(f"n {sign} stop {join} n % 4 == k", 21)
    found = [*composed(asked, Machine.of(target), 1000)]
    assert {solution.states for solution in found} == {0}
    assert all(fault(asked, Machine.of(target), solution) is None for solution in found)


@pytest.mark.parametrize("slots", [17, 64, 128, 256])
def test_an_exclusive_or_with_a_range_takes_few_words(slots):
    found = words(problem("n < a xor n % 8 < k", slots, "code a : 1..N code k : 0..7"), chip())
    assert found
    assert min(found) <= 9 * slots


@pytest.mark.parametrize(
    "rule",
    [
        "a <= n < a + 8 and n % 4 != k",
        "a <= n < a + 8 or n % 4 == k",
        "a <= n < a + 8 xor n % 4 == k",
        "n == a or n % 4 == k",
        "not (a <= n < a + 5) and n % 4 == k",
    ],
)
def test_windows_are_states_that_open_and_close(rule):
    found = words(problem(rule, 40, "code a : 0..N - 8 code k : 0..3"), chip())
    assert found
    assert min(found) <= 9 * 40


@pytest.mark.parametrize(
    ("length", "join", "most"), [(8, "and", 6), (8, "or", 6), (5, "and", 8), (6, "xor", 9)]
)
def test_one_cube_selects_windows_that_open_and_close(length, join, most):
    """Starts are divided by the length of the window, whether it is a power of two or not."""
    codes = f"code a : 0..N - {length} code k : 0..3"
    found = words(problem(f"a <= n < a + {length} {join} n % 4 != k", 100, codes), chip())
    assert found
    assert min(found) <= most * 100


@pytest.mark.parametrize(
    "rules",
    [
        ("n < a and n % 4 != k", "n >= a and n % 4 != k"),
        ("n < a", "n % 4 == k"),
        ("n < a xor n % 4 == k", "n >= a or n % 4 == k"),
    ],
)
def test_buckets_share_the_parts_of_their_rules(rules):
    """Each bucket takes at most six words a slot."""
    found = words(bucket_problem(40, "code a : 1..N - 1 code k : 0..3", *rules), chip())
    assert found
    assert min(found) <= 12 * 40


@pytest.mark.parametrize(
    ("rule", "codes"),
    [
        ("n < a and m[n % 3]", "code a : 1..N code m : bit[3]"),
        ("n < a xor m[n % 4]", "code a : 1..N code m : bit[4]"),
        ("n < a if n < N / 2 else n < a or n % 4 == k", "code a : 1..N code k : 0..3"),
        ("n < a and n >= b xor n % 4 == k", "code a : 8..N code b : 0..3 code k : 0..3"),
    ],
)
def test_operators_may_differ_between_slots(rule, codes):
    found = words(problem(rule, 32, codes), chip())
    assert found
    assert min(found) <= 10 * 32


def test_a_part_that_is_inverted_in_some_slots_is_a_state():
    """The exclusive or with a condition on n only inverts the demands of a stop."""
    found = words(problem("n < a xor n % 3 == 1", 64, "code a : 1..N"), chip())
    assert min(found) <= 4 * 64


def value(rule, asked):
    """What a rule opens at each demand, bool (shutters, demands), from its parts."""
    if isinstance(rule, RulePart):
        return rule.open ^ rule.inverted
    first, second = value(rule.first, asked), value(rule.second, asked)
    by_operator = {
        "and": first & second,
        "or": first | second,
        "xor": first ^ second,
        "first": first,
        "second": second,
    }
    columns = [by_operator[name][:, i] for i, name in enumerate(rule.operators)]
    return np.stack(columns, axis=1)


def test_parts_joined_by_their_operators_are_the_rule():
    codes = "code a : 1..N code b : 0..3 code c : 0..1"
    rule = (
        "(n < a or n % 4 == b) and not (c == 1 and n > N / 2) if n % 5 != 0 else n >= a xor c == 0"
    )
    asked = problem(rule, 24, codes)
    parts = composition(asked)
    assert isinstance(parts, Composition)
    expected = rows([demand.predicate for demand in asked.demands], asked.shutters)
    assert np.array_equal(value(parts, asked), expected)


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
