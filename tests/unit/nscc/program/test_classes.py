"""Classes are recognised from shutters, however the rule is written; advice is given once."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from program_oracle import program_of

from nscc.emit.listing import program_text
from nscc.emit.summary import summary
from nscc.pipeline import Options, run_passes
from nscc.program.limits import bits_needed
from nscc.source import Source

FRAME = "nsl 1 frame 8 slots of 1ms "

CLASSES = [
    ("a", "open when true"),
    ("a", "open when n * n >= 0"),
    ("b", "code stop : 0..8 open when n < stop"),
    ("b", "code stop : 0..7 open when not n > stop"),
    ("b", "code k : 0..7 open when n * n < k"),
    ("c", "code start : 0..5 open when start <= n < start + 3"),
    ("c", "code start : 0..7 open when n == start"),
    ("c", "code start : 0..6 open when (n - start) * (n - start - 1) == 0"),
    ("c", "code start : -2..7 open when start <= n < start + 3"),
    ("d", "code a : 0..7 code b : 1..8 require a < b open when a <= n < b"),
    ("d", "code a : 0..7 code b : 0..8 open when a <= n < b"),
    ("d", "code start : 0..7 open when n >= start"),
    ("e", "code bits : bit[8] open when bits[n]"),
    ("e", "code bits : bit[9] open when bits[N - n]"),
    ("e", "code v : 0..255 open when v / (1 << n) % 2 == 1"),
    ("codebook", "shutters b [10110000, 00000001] code id : row of b open when b[id]"),
    ("general", "code a : 0..7 open when n != a"),
    ("general", "code bits : bit[4] open when bits[n / 2]"),
    ("general", "bucket p open when n < 3 bucket q open when n == 5"),
    ("b", "code s : 1..7 bucket p open when n < s bucket q open when n <= s / 2"),
]


@pytest.mark.parametrize(("name", "text"), CLASSES)
def test_a_rule_has_the_class_of_its_shutters(name: str, text: str) -> None:
    """Each rule of `CLASSES` has the class beside it, with a reason."""
    program = program_of(FRAME + text)
    assert program.class_name == name
    assert program.class_reason


def test_the_class_is_that_of_all_codes_not_only_those_in_use() -> None:
    program = program_of(
        FRAME + "code a : 0..7 code b : 1..8 require a < b open when a <= n < b "
        "pixels a = 0 pixels b = 8"
    )
    assert program.class_name == "d"


def test_the_length_of_bumps_is_named() -> None:
    program = program_of(FRAME + "code start : 0..5 open when start <= n < start + 3")
    assert "3 slots" in program.class_reason


def test_programs_of_the_language_page_have_their_classes() -> None:
    found = {
        "b": "frame 256 slots of 125us code stop : 1..256 open when n < stop "
        "pixels stop = tile [[256, 64], [16, 4]]",
        "c": "frame 64 slots of 500us let len = 8 code start : 0..N - len "
        "open when start <= n < start + len pixels start = (8 * x + 16 * y) % 57",
        "d": "frame 64 slots of 500us code start : 0..63 code stop : 1..64 require start < stop "
        "open when start <= n < stop pixels start = (x + 4 * y) % 32 "
        "pixels stop = 33 + (x * y) % 32",
        "e": "frame 13 slots of 1ms code bits : bit[13] open when bits[n] "
        "pixels bits = (2917 * x + 4421 * y) % 8192",
        "general": "frame slots [50us, 100us, 200us, 400us, 800us, 1.6ms, 3.2ms, 6.4ms] "
        "code longest : 0..7 code skip : 0..7 open when n <= longest and n != skip "
        "pixels longest = (x + y) % 8 pixels skip = (3 * x + 5 * y) % 8",
    }
    for name, text in found.items():
        assert program_of("nsl 1 " + text).class_name == name


ADVICE = [
    ("open when true", []),
    ("open when false", ["NS0350"]),
    ("code s : 1..8 open when n < s", []),
    ("code s : 1..8 open when n < s - 8", ["NS0350", "NS0358"]),
    ("code s : 8..9 open when n < s", ["NS0351"]),
    ("code s : 1..8 open when n < s pixels s = 8", []),
    ("code s : 0..7 open when n < s pixels s = 0", ["NS0350"]),
    ("code s : 1..8 bucket p open when n < s bucket q open when n > 7", ["NS0350", "NS0358"]),
    ("code s : 1..8 code t : 0..1 open when n < s", ["NS0352"]),
    ("code s : 1..8 open when n < s and n != 8", ["NS0358"]),
    ("code s : 1..8 let last = 9 open when n < s or s == last and 0 != s", ["NS0358", "NS0358"]),
    ("code s : 1..8 open when n < s and n != 7 or s == 8", []),
    ("code s : 1..8 open when n < s or n >= 9", ["NS0358"]),
    ("code s : 1..8 open when n < s or 9 <= n <= 12", ["NS0358"]),
    ("code s : 1..8 open when n < s or n % 4 == 5 or n / 2 == 4 or n + 1 > 8", ["NS0358"] * 3),
    ("code s : 1..8 open when n < s and n != -1 and s != N + 1", ["NS0358"] * 2),
    ("code s : 1..8 open when n < s and n <= 7 or s >= 1 and N == 9", []),
    ("code s : 1..8 require s != 9 open when n < s", ["NS0358"]),
    ("code s : 1..8 open when n < s or n % 4 == 3 or n / 2 == 3 or n + 1 == 8", []),
    ("code s : 1..8 open when n < s pixels s = 1 + x % 8", []),
    ("code s : 1..8 open when n < s pixels s = 1 + x % 4", []),
    ("code s : 0..7 open when s <= n < s + 3", ["NS0354"]),
    ("let k = 3 code s : 1..8 open when n < s", ["NS0355"]),
    ("let k = 3 code s : 1..k open when n < s", []),
    ("shutters b [11110000] code s : 1..8 open when n < s", ["NS0355"]),
    ('code s : 1..8 open when n < s pixels s = 1 + x % 8 pixels from "f.npz"', ["NS0356"]),
    (
        "code s : 1..8 open when n < s pixels s = tile [[" + ", ".join("12345678" * 33) + "]]",
        ["NS0357"],
    ),
]


@pytest.mark.parametrize(("text", "codes"), ADVICE)
def test_a_program_gets_the_advice_of_its_kind(text: str, codes: list[str]) -> None:
    """The messages of each program of `ADVICE` have the codes beside it, and no others."""
    assert [d.code for d in program_of(FRAME + text).messages] == codes


def test_unused_codes_are_counted_by_check_without_a_diagnostic() -> None:
    """Unused codes are valid, so they appear in the summary only."""
    text = FRAME + "code s : 1..8 open when n < s pixels s = "
    for data, codes, said in (
        ("tile [[1, 2, 3]]", "fixed", "3 in use of 8 legal, 3 shutters"),
        ("1 + x % 8", "fixed", "8 in use, 8 shutters"),
        ("tile [[1, 2, 3]]", "open", "8 legal, 3 in use, 8 shutters"),
        ("1 + x % 8", "open", "8 legal, 8 shutters"),
    ):
        compiled = run_passes(Source("p.nsl", text + data), Path(), Options(codes=codes, level=0))
        assert f"codes      {said}" in summary("p.nsl", compiled)
        assert compiled.diagnostics == ()


def test_the_listing_shows_shutters_and_their_codes() -> None:
    """The listing has the field with its range and a row of bits for each of the two shutters."""
    text = program_text(program_of(FRAME + "code s : 6..7 open when n < s pixels s = 6 + x % 2"))
    assert re.search(r"^field +s : 6\.\.7$", text, re.MULTILINE)
    assert re.search(r"^ +0  11111100  1 code$", text, re.MULTILINE)
    assert re.search(r"^ +1  11111110  1 code$", text, re.MULTILINE)


def test_printing_cuts_long_tables() -> None:
    """Of 300 slots 256 are shown and of 301 shutters 64, and the text says how many more there
    are."""
    text = program_text(program_of("nsl 1 frame 300 slots of 1us code s : 0..N open when n < s"))
    # 256 of 300 slots and 64 of 301 shutters are shown.
    assert "(44 slots more)" in text
    assert "... 237 shutters more" in text
    assert max(map(len, text.splitlines())) < 300


def test_a_target_is_named_by_the_file_or_the_caller(tmp_path: Path) -> None:
    """The program names scamp7. If the caller gives a target, that very object is used."""
    seven = program_of("nsl 1 target scamp7 frame 8 slots of 1ms open when n < rows")
    assert seven.target.name == "scamp7"
    assert seven.target_span is not None
    other = program_of(
        "nsl 1 target scamp7 frame 8 slots of 1ms open when n < rows", target=seven.target
    )
    assert other.target is seven.target


@pytest.mark.parametrize(
    ("shutters", "registers"), [(1, 0), (2, 1), (3, 2), (4, 2), (5, 3), (256, 8), (257, 9)]
)
def test_bits_needed_is_the_logarithm_rounded_up(shutters: int, registers: int) -> None:
    """One shutter needs no register, 256 need 8 and 257 need 9."""
    assert bits_needed(shutters) == registers
