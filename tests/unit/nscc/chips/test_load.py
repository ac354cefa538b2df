"""Target tables: the builtin ones, files of a user's own, and what is wrong with them."""

from __future__ import annotations

from dataclasses import fields, replace
from pathlib import Path

import pytest

from nscc.chips.load import (
    builtin_names,
    builtin_target,
    load_target,
    target_dict,
    target_from_dict,
    target_toml,
)
from nscc.chips.target import SCHEMA, STREAM_SCHEMA, Target
from nscc.diagnostics.diagnostic import Diagnostic, Rejected
from nscc.source import Source

MINIMAL = """\
name = "mine"
[array]
rows = 4
cols = 8
[registers]
analog = ["A", "B", "NEWS"]
analog_scratch = "NEWS"
digital = ["R0", "R1"]
"""


def load(text: str | bytes, folder: Path) -> Target:
    (folder / "mine.toml").write_bytes(text.encode() if isinstance(text, str) else text)
    return load_target("mine.toml", folder)


def rejected(text: str | bytes, folder: Path) -> list[Diagnostic]:
    with pytest.raises(Rejected) as caught:
        load(text, folder)
    return list(caught.value.diagnostics)


def test_the_schema_covers_every_attribute_once() -> None:
    """A chip of either kind has the keys of its own kind, and shares some with the other."""
    every = sorted(f.name for f in fields(Target))
    both = {key.attribute for schema in (SCHEMA, STREAM_SCHEMA) for key in schema.keys}
    assert sorted(both) == every
    for schema in (SCHEMA, STREAM_SCHEMA):
        own = [key.attribute for key in schema.keys]
        assert len(set(own)) == len(own)


def test_builtin_targets_have_the_published_values() -> None:
    """SCAMP-5 has 256 x 256 pixels, 13 digital registers and a store of 1024 words. SCAMP-7 has 23
    registers."""
    assert builtin_names() == ("dual-tap", "scamp5", "scamp5-algorithm1", "scamp7")
    scamp5 = load_target("scamp5", Path())
    assert (scamp5.rows, scamp5.cols, scamp5.store_words) == (256, 256, 1024)
    assert len(scamp5.digital_registers) == 13
    # A full well of 30000 electrons has the last of 256 codes.
    assert scamp5.electrons_per_lsb == 30000 / 255
    assert len(load_target("scamp7", Path()).digital_registers) == 23
    assert load_target("scamp5-algorithm1", Path()).reset_honours_flag == "yes"


@pytest.mark.parametrize("name", builtin_names())
def test_a_printed_table_reads_back(name: str, tmp_path: Path) -> None:
    target = replace(
        builtin_target(name),
        name="x-1",
        description='say "1" \\ é',
        or_sources=4,
        mask_register=None,
        masked_register=None,
        adc_offset_lsb=-0.5,
        launch_us=1e-7,
    )
    if not target.has_logic:
        target = replace(builtin_target(name), drain=True, taps=("A", "B", "C"), tap_gain=())
    for each in (target, builtin_target(name)):
        assert load(target_toml(each), tmp_path) == each
        assert target_from_dict(target_dict(each)) == each


def test_missing_keys_have_the_values_of_scamp5(tmp_path: Path) -> None:
    """A minimal file takes times, full well and store from SCAMP-5. It has no mask registers, which
    must be named."""
    target, scamp5 = load(MINIMAL, tmp_path), builtin_target("scamp5")
    assert (target.mask_register, target.masked_register) == (None, None)
    assert target.analog_word_us == scamp5.analog_word_us
    assert target.full_well_e == scamp5.full_well_e
    assert target.store_words == scamp5.store_words


def test_an_unknown_name_gets_a_suggestion(tmp_path: Path) -> None:
    """`scamp-5` gives NS0230 and proposes `scamp5`. A missing file gives NS0231. Both have status
    2."""
    with pytest.raises(Rejected) as caught:
        load_target("scamp-5", tmp_path)
    found = caught.value.diagnostics[0]
    assert (found.code, caught.value.status) == ("NS0230", 2)
    assert found.helps[0] == "did you mean `scamp5`?"
    with pytest.raises(Rejected) as caught:
        load_target("none.toml", tmp_path)
    assert (caught.value.diagnostics[0].code, caught.value.status) == ("NS0231", 2)


@pytest.mark.parametrize(
    ("old", "new", "code", "words"),
    [
        ("rows = 4", "rows = 0", "NS0235", "whole number from 1 to 8192"),
        ("rows = 4", "rows = true", "NS0235", "a whole number from 1 to 8192, not true"),
        ("rows = 4", "rows = 4.0", "NS0235", "a whole number from 1 to 8192, not 4.0"),
        ("rows = 4", f"rows = {9**99}", "NS0235", "a huge number"),
        ("rows = 4", "", "NS0234", "array.rows is missing"),
        ("rows = 4", "rosw = 4", "NS0233", "no key 'rosw'"),
        ("rows = 4", "launch_us = 4.0", "NS0233", "no key 'launch_us'"),
        ("[array]", "time = 3\n[array]", "NS0235", "time must be a table"),
        ("[array]", "[arrays]", "NS0233", "no table 'arrays'"),
        ('"B"', '"A"', "NS0236", "lists 'A' twice"),
        ('"B"', '"Q"', "NS0236", "lists 'Q'"),
        ('"B"', "3", "NS0235", "list of register names"),
        ('scratch = "NEWS"', 'scratch = "C"', "NS0236", "analog_scratch is 'C'"),
        ('"mine"', '"a b"', "NS0235", "a name of letters"),
        ('"R1"]', '"R1"]\nmask = "R0"', "NS0236", "give both or neither"),
        ('"R1"]', '"R1"]\nmask = "R0"\nmasked = "R0"', "NS0236", "both 'R0'"),
        ('"R1"]', '"R1"]\nmask = "R0"\nmasked = "R12"', "NS0236", "masked is 'R12'"),
        ('"R1"]', '"R1"]\n[behaviour]\nor_sources = 1', "NS0235", '"any" or a whole number from 2'),
        ('"R1"]', '"R1"]\n[behaviour]\nwhere_reads_flag = "yes"', "NS0235", "true or false"),
        ('"R1"]', '"R1"]\n[behaviour]\nreset_honours_flag = true', "NS0235", '"unknown"'),
        ('"R1"]', '"R1"]\n[time]\nanalog_word_us = 0', "NS0235", "from 1e-09"),
        ('"R1"]', '"R1"]\n[time]\nanalog_word_us = nan', "NS0235", "not nan"),
        ('"R1"]', '"R1"]\n[time]\nreadout_us = inf', "NS0235", "not inf"),
        ('"R1"]', '"R1"]\n[range]\nregister_min_e = 0.0', "NS0235", "to -1e-09"),
        ('"R1"]', '"R1"]\n[range]\nadc_bits = 17', "NS0235", "from 1 to 16"),
        ("rows = 4", "rows = ", "NS0232", "TOML"),
        ("rows = 4", "rows = 4\n#" + "x" * 2000, "NS0232", "characters"),
    ],
)
def test_a_wrong_table_is_explained(
    old: str, new: str, code: str, words: str, tmp_path: Path
) -> None:
    found = rejected(MINIMAL.replace(old, new, 1), tmp_path)
    assert (code, True) in [(d.code, words in d.message) for d in found]


def test_a_wrong_table_is_wrong_usage_where_an_option_names_it(tmp_path: Path) -> None:
    """The same fault has status 2 if an option names the file, and status 1 if a program does."""
    path = tmp_path / "chip.toml"
    for text in (MINIMAL.replace("rows = 4", "rows = 0"), "no table ["):
        path.write_text(text)
        for source, status in ((None, 2), (Source("p.nsl", 'target "chip.toml"'), 1)):
            with pytest.raises(Rejected) as caught:
                load_target("chip.toml", tmp_path, source=source)
            assert caught.value.status == status


def test_all_errors_of_a_target_file_are_reported_at_their_lines(tmp_path: Path) -> None:
    """A negative size in line 3 and a misspelt register in line 6 are reported together."""
    found = rejected(MINIMAL.replace("rows = 4", "rows = -4").replace('"A"', '"a"'), tmp_path)
    places = []
    for diagnostic in found:
        assert diagnostic.source is not None
        assert diagnostic.label is not None
        row, _ = diagnostic.source.row_column(diagnostic.label.span.start)
        places.append((diagnostic.code, row))
    assert places == [("NS0235", 3), ("NS0236", 6)]
    assert found[1].helps == ("did you mean `A`?",)


@pytest.mark.parametrize(
    "data",
    [b"\xff\xfe", b"\0" * 100, b"a = " + b"[" * 900, b"x" * 70_000, b'a = "' + b"\\u" * 99, b""],
    ids=["utf-16", "zeros", "brackets", "one long line", "backslashes", "empty"],
)
def test_no_text_at_all_is_refused(data: bytes, tmp_path: Path) -> None:
    """Bytes that are no TOML text, an empty file among them, give NS0232 or NS0234."""
    assert {d.code for d in rejected(data, tmp_path)} <= {"NS0232", "NS0234"}
