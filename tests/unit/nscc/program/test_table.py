"""Decode tables, against an oracle that interprets the rule code by code and slot by slot."""

from __future__ import annotations

import numpy as np
import pytest
from program_oracle import program_of, shutters, table_of

FRAME = "nsl 1 frame 9 slots of 1ms "

CASES = {
    "stop": ("code stop : 0..9 open when n < stop", [("stop", range(10))]),
    "bump": (
        "code start : 0..8 code stop : 1..9 require start < stop open when start <= n < stop",
        [("start", range(9)), ("stop", range(1, 10))],
    ),
    "negative": ("code a : -4..3 open when (n + a) % 3 == a / 2 + 2", [("a", range(-4, 4))]),
    "divisor": ("code a : -3..-1 open when n % a == -1 or n / a < -4", [("a", range(-3, 0))]),
    "buckets": (
        "code s : 1..8 bucket early open when n < s bucket late open when n >= s "
        "bucket odd open when n % 2 == 1 xor n == s",
        [("s", range(1, 9))],
    ),
    "calls": (
        "code a : 0..5 open when min(a, n, 4) < max(2, n - a) and not n == 7",
        [("a", range(6))],
    ),
    "choice": (
        "code a : 0..3 open when (8 / a if a > 0 else n) <= n",
        [("a", range(4))],
    ),
    "shift": ("code a : 0..3 open when 1 << a + n % 3 > n", [("a", range(4))]),
    "chain": ("code a : 0..4 open when 0 != a <= n < 2 * a == a + a", [("a", range(5))]),
    "booleans": ("code a : 0..3 open when (n < a) == (n % 2 == 0)", [("a", range(4))]),
    "two require": (
        "code a : 0..6 require a != 0 require 6 % a == 0 open when n % a == 0",
        [("a", range(7))],
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_the_table_is_what_the_rule_says(name: str) -> None:
    """For each program of `CASES`, codes and shutters are those of the rule evaluated in Python."""
    text, fields = CASES[name]
    program = program_of(FRAME + text, codes="open")
    assert table_of(program) == shutters(FRAME + text, fields, N=9)
    assert program.legal_codes == len(program.table.codes)


def test_bits_and_codebooks_in_one_rule_give_the_right_table() -> None:
    text = (
        "nsl 1 frame 5 slots of 1ms shutters book [11_000, 00110, 10101] "
        "code bits : bit[5] code id : row of book "
        "open when bits[(n + 2) % 5] and book[id] or book[2 - id]"
    )
    names = {"N": 5, "bits[]": 5, "book": ["11000", "00110", "10101"]}
    expected = shutters(text, [("bits", range(32)), ("id", range(3))], **names)
    assert table_of(program_of(text)) == expected


def test_codes_and_shutters_are_sorted_and_distinct() -> None:
    program = program_of(
        "nsl 1 frame 70 slots of 1ms code a : -1..1 code b : 0..70 "
        "open when n < b + a pixels a = x % 3 - 1 pixels b = (7 * x + y) % 71"
    )
    table = program.table
    codes = [tuple(code) for code in table.codes.tolist()]
    assert codes == sorted(set(codes))
    assert table.fields == ("a", "b")
    assert table.codes.dtype == np.int64
    assert table.shutter_of_code.dtype == np.int32
    rows = ["".join(map(str, row.ravel().astype(int))) for row in table.shutters]
    assert rows == sorted(set(rows))
    assert set(table.shutter_of_code.tolist()) == set(range(len(rows)))


def test_pixels_get_the_rows_of_their_codes() -> None:
    text = (
        "nsl 1 frame 8 slots of 1ms code a : 0..7 code b : 0..7 require a + b < 12 "
        "open when a <= n <= b pixels a = (x + y) % 5 pixels b = x * y % 7"
    )
    y, x = np.mgrid[:256, :256]
    for mode, count in (("fixed", 35), ("open", 58)):
        program = program_of(text, codes=mode)
        assert program.mode == mode
        assert len(program.table.codes) == count
        assert program.pixel_codes is not None
        assert program.pixel_codes.dtype == np.int32
        values = program.table.codes[program.pixel_codes]
        np.testing.assert_array_equal(values[..., 0], (x + y) % 5)
        np.testing.assert_array_equal(values[..., 1], x * y % 7)


def test_a_file_without_pixels_is_compiled_for_every_code() -> None:
    """Without `pixels`, fixed codes become open ones: all nine are in the table."""
    program = program_of(FRAME + "code stop : 1..9 open when n < stop", codes="fixed")
    assert program.mode == "open"
    assert program.pixel_codes is None
    assert len(program.table.codes) == 9


def test_a_program_without_fields_has_one_code_everywhere() -> None:
    """The one code has no fields, is open in the first three slots, and every pixel has it."""
    program = program_of(FRAME + "open when n < 3")
    assert program.table.codes.shape == (1, 0)
    assert program.table.shutters[0, 0].tolist() == [True] * 3 + [False] * 6
    assert program.pixel_codes is not None
    assert not program.pixel_codes.any()


def test_rows_wider_than_a_machine_word_are_sorted() -> None:
    # 4 x 100 digits do not fit one machine word, so another way of sorting is taken.
    text = (
        "nsl 1 frame 100 slots of 1us code a : 0..3 bucket p open when n == a * 33 "
        "bucket q open when n / 50 == a / 2 bucket r open when n == 99 bucket s open when false"
    )
    program = program_of(text)
    assert table_of(program) == shutters(text, [("a", range(4))], N=100)


def test_a_table_of_many_codes_and_slots_is_right() -> None:
    program = program_of(
        "nsl 1 frame 4096 slots of 20us code stop : 1..4096 open when n < stop "
        "pixels stop = 1 + (16 * x + 4099 * y) % 4096"
    )
    np.testing.assert_array_equal(
        np.count_nonzero(program.table.shutters[:, 0], axis=1), np.arange(1, 4097)
    )


@pytest.mark.parametrize("slots", [1, 2, 7, 63, 64, 65])
def test_tables_of_any_number_of_slots_equal_the_oracle(slots: int) -> None:
    """Around the width of a machine word, 64 slots, the table is that of the rule in Python."""
    text = f"nsl 1 frame {slots} slots of 1us code stop : 0..N open when n < stop"
    assert table_of(program_of(text)) == shutters(text, [("stop", range(slots + 1))], N=slots)


def test_slots_are_equal_if_their_times_are() -> None:
    """50us, 1.6ms, 2s and 250ns are read as microseconds. 1ms and 1000us are equal slots."""
    program = program_of("nsl 1 frame slots [50us, 1.6ms, 2s, 250ns] open when n < 2")
    assert program.frame.slot_us == (50.0, 1600.0, 2e6, 0.25)
    assert not program.frame.equal
    assert program_of("nsl 1 frame slots [1ms, 1000us] open when n < 2").frame.equal
