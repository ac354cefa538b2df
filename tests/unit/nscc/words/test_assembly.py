"""Assembly text by hand: what it means, what is wrong with it, and what a listing looks like."""

from __future__ import annotations

from dataclasses import replace
from hashlib import sha256
from pathlib import Path

import numpy as np
import pytest

from nscc.chips.load import builtin_target, target_toml
from nscc.diagnostics.diagnostic import Diagnostic, Rejected
from nscc.operations import op
from nscc.source import Source
from nscc.words.assembly import assemble, assemble_words
from nscc.words.assembly_text import (
    ranges_text,
    read_integer,
    read_ranges,
    read_slots,
    read_time_us,
    slots_text,
)
from nscc.words.container import Container, DecodeTable, Launch, Readout, StoredKernel
from nscc.words.cost import frame_cost
from nscc.words.diff import differences
from nscc.words.disassembly import disassemble
from nscc.words.encoding import encode, word_text
from nscc.words.file import read_container, to_bytes
from nscc.words.legality import decoded

HAND = """\
; class b by hand
.target scamp5
.wait 125us x4
.kernel start
    respix A                    # A := reset level
.kernel step
    WHERE R1
    sub B, PIX, A
    all
    NOT R1
    OR R3, R3, R4, R5
.slot 0 start
.slot 1..4 step
.readout B frame -1
"""


def assembled(text: str, base: Path = Path()) -> Container:
    return assemble(Source("x.asm", text), base)


def rejected(text: str, base: Path = Path()) -> list[Diagnostic]:
    with pytest.raises(Rejected) as caught:
        assembled(text, base)
    return list(caught.value.diagnostics)


def test_a_program_by_hand_becomes_a_container() -> None:
    container = assembled(HAND)
    assert container.slot_us == (125.0,) * 4
    assert container.buckets == ("frame",)
    assert [kernel.name for kernel in container.kernels] == ["start", "step"]
    assert [(x.instant, x.kernel) for x in container.launches] == [
        (0, 0),
        (1, 1),
        (2, 1),
        (3, 1),
        (4, 1),
    ]
    assert container.readouts == (Readout("B", "frame", -1.0),)
    assert container.pixel_codes is None
    assert not container.has_table
    assert [str(o) for o in decoded(container)[1]] == [
        "WHERE R1",
        "bus NEWS, PIX",
        "bus B, A, NEWS",
        "all",
        "NOR.read R1",
        "NOR.write R1",
        "OR.read R3, R4, R5",
        "OR.write R3",
    ]
    cost = frame_cost(container)
    assert (cost.stored_words, cost.words, cost.launches) == (13, 5 + 4 * 8, 5)
    assert cost.busy_us == pytest.approx(5 * 1 + 5 * 0.2 + 4 * (3 * 0.2 + 5 * 0.1))


def test_the_listing_reads_well_and_reads_back() -> None:
    container = replace(assembled(HAND), source_lines=("nsl 1", "", "frame  4 slots "))
    text = disassemble(container)
    for line in (
        ".target scamp5",
        ".wait 125us x4",
        "| nsl 1",
        '|= "frame  4 slots "',
        "    NOT R1",
        "    OR R3, R3, R4, R5",
        ".slot 1..4 step",
        ".readout B frame -1",
    ):
        assert line in text.split("\n")
    assert "launched at 1..4" in text
    assert to_bytes(assembled(text)) == to_bytes(container)


def test_bare_instructions_give_words() -> None:
    """`AND` is four words. `SET R13` needs a chip with R13: NS0708 without the line `.target
    scamp7`."""
    words = assemble_words(Source("-", "AND R6, R2, R3\n"), Path())
    assert word_text(words[0]) == "0x80020 0x10000 0x20000 0x31100 0x40000"
    assert len(words) == 4
    with pytest.raises(Rejected, match="NS0708"):
        assemble_words(Source("-", "SET R13"), Path())
    assert len(assemble_words(Source("-", ".target scamp7\nSET R13"), Path())) == 1


def test_words_that_no_line_stands_for_are_printed_as_bits() -> None:
    lone, wide = encode(op("OR.read", (), ["R2"])), encode(op("SET", ["R20"]))
    other = (1, 2, 3, 4, 0xFFFFFFFF)
    container = replace(
        assembled(HAND), kernels=(StoredKernel("k", (lone, wide, other)),), launches=()
    )
    text = disassemble(container)
    assert text.count(".word 0x") == 3
    assert "half of a pair" in text
    assert "has no register R20" in text
    assert "matches no operation" in text
    assert to_bytes(assembled(text)) == to_bytes(container)
    with pytest.raises(Rejected) as caught:
        decoded(container)
    assert [d.code for d in caught.value.diagnostics] == ["NS0708", "NS0701"]


def test_planes_of_an_assembly_text_become_the_codes_of_pixels(tmp_path: Path) -> None:
    target = replace(builtin_target("scamp5"), rows=2, cols=3, name="small")
    (tmp_path / "small.toml").write_text(target_toml(target), encoding="utf-8")
    first, second = np.array([[1, 0, 1], [0, 0, 1]]), np.array([[0, 0, 1], [0, 0, 0]], dtype=bool)
    np.save(tmp_path / "r0.npy", np.asfortranarray(first))
    np.savez(tmp_path / "r12.npz", R12=second, other=first)
    digest = sha256((tmp_path / "r0.npy").read_bytes()).hexdigest()
    text = HAND.replace(".target scamp5", ".target small.toml") + (
        f".plane R0 r0.npy sha256 {digest}\n.plane R12 r12.npz\n"
    )
    container = assembled(text, tmp_path)
    assert container.code_registers == ("R12", "R0")
    planes = container.planes()
    assert np.array_equal(planes["R0"], first.astype(bool))
    assert np.array_equal(planes["R12"], second)
    assert len(container.table.codes) == 3
    listing = disassemble(container)
    assert to_bytes(assembled(listing)) == to_bytes(container)

    found = rejected(text.replace(digest, "0" * 64), tmp_path)
    assert [d.code for d in found] == ["NS0716"]
    assert digest in found[0].message
    np.save(tmp_path / "r0.npy", first * 2)
    assert "0 and 1" in rejected(text.replace(f" sha256 {digest}", ""), tmp_path)[0].message
    np.save(tmp_path / "r0.npy", np.zeros((9, 9)))
    assert "(9, 9)" in rejected(text.replace(f" sha256 {digest}", ""), tmp_path)[0].message


def test_all_errors_are_reported_at_once_with_their_places() -> None:
    text = (
        HAND.replace("WHERE R1", "were R1")
        .replace("NOT R1", "NOT R1x, R2")
        .replace(".slot 1..4 step", ".slot 1..9 step\n.slot 0 stop")
    )
    found = rejected(text)
    places = []
    for diagnostic in found:
        assert diagnostic.source is not None
        assert diagnostic.label is not None
        row, column = diagnostic.source.row_column(diagnostic.label.span.start)
        places.append((diagnostic.code, row, column))
    assert places == [("NS0710", 7, 5), ("NS0712", 10, 9), ("NS0714", 13, 7), ("NS0719", 14, 9)]
    assert found[0].helps == ("did you mean `WHERE`?",)
    assert found[3].helps == ("did you mean `step`?",)


@pytest.mark.parametrize(
    ("line", "code", "words"),
    [
        (".slots 0 step", "NS0713", "unknown directive '.slots'"),
        ("| text", "NS0713", "continuation line"),
        (".wait 1 us", "NS0714", "'1' does not belong here: .wait takes the lengths of slots"),
        (".wait x3", "NS0714", "'x3' does not belong here: .wait"),
        (".wait -1us", "NS0714", "'-1us' does not belong here: .wait"),
        (".wait 1us x99999999", "NS0714", "slots"),
        (".wait 1e999us", "NS0714", "not the length"),
        (".word 1 2 3", "NS0714", "five integers"),
        (".word 1 2 3 4 0x1ffffffff", "NS0714", "32-bit"),
        (".kernel step", "NS0719", "two kernels"),
        (".kernel", "NS0714", "one name"),
        (".readout Z", "NS0719", "analog register"),
        (".readout A frame nan", "NS0714", "'nan' does not belong here: .readout takes"),
        (".readout A frame", "NS0719", "read out twice"),
        (".bucket late", "NS0719", "undefined bucket"),
        (".readout A frame x", "NS0714", "'x' does not belong here: .readout takes"),
        (".note a b\n.note a c", "NS0719", "the note 'a' appears twice"),
        (".bucket frame other", "NS0715", "the bucket 'other' is not read out"),
        (".code 0\n.fields a a", "NS0719", "'a' is defined twice"),
        (".target scamp7", "NS0719", "appears twice"),
        (".load Z9", "NS0719", "digital register"),
        (".shutter 01 never", "NS0714", "13 digits"),
        (".shutter 0000000000000 0..9", "NS0714", "not a valid set of slots in 0..3"),
        (".shutter 0000000000000 never never", "NS0714", "buckets"),
        (".code 7", "NS0714", "unknown shutter"),
        (".code 0 9", "NS0714", "values"),
        (".pixels tile", "NS0714", "form and a size"),
        (".pixels tile 1 2\n| 0", "NS0714", "not 1 x 2 codes"),
        (".pixels tile 1 1\n| 5", "NS0714", "not one of the"),
        (".pixels plane 1 1\n| AAAAAA==", "NS0714", "does not match scamp5"),
        (".plane R1 none.npy", "NS0716", "does not exist"),
        (".note a", "NS0714", "key and a text"),
        ('.note a "b', "NS0714", "quotation marks"),
        ("SET R1 R2", "NS0711", "separated by commas"),
        ("SET R1,", "NS0712", "is empty"),
        ("AND R1, R0, R2", "NS0711", "overwrites R0"),
        ("SET R13", "NS0708", "no register R13"),
        ("\n".join(["nop"] * 1020), "NS0718", "1033 words"),
    ],
)
def test_a_wrong_line_is_explained(line: str, code: str, words: str) -> None:
    table = ".shutter 0000000000000 0..3\n.code 0\n"
    needs_table = line.startswith((".shutter", ".code", ".pixels"))
    found = rejected(HAND + (table if needs_table else "") + line + "\n")
    explained = [d for d in found if d.code == code and words in d.message]
    assert explained
    assert all(d.helps for d in explained), "a help says what to write"


def test_missing_parts_of_an_assembly_text_are_named() -> None:
    """A text of words alone lacks two parts. `.pixels` without codes gets a help with both ways
    out."""
    found = rejected("nop\n")
    assert [d.code for d in found] == ["NS0715", "NS0715"]
    found = rejected(HAND + ".pixels tile 1 1\n| 0\n")
    assert [d.message for d in found] == [".pixels needs codes, but .code is missing"]
    assert found[0].helps == ("write `.code` and `.shutter` lines, or remove .pixels",)


def test_class_b_with_4096_slots_stays_small() -> None:
    slots = 4096
    base = assembled(HAND)
    target = base.target
    rng = np.random.default_rng(1)
    container = replace(
        base,
        slot_us=(10.0,) * slots,
        table=DecodeTable(
            ("stop",),
            np.arange(slots)[:, None],
            np.arange(slots, dtype=np.int32),
            np.arange(slots) < np.arange(slots)[:, None, None],
        ),
        launches=tuple(Launch(n, n & 1) for n in range(slots + 1)),
        encoding=rng.random((slots, len(target.digital_registers))) < 0.5,
        pixel_codes=rng.integers(0, slots, (target.rows, target.cols), dtype=np.int32),
    )
    data, text = to_bytes(container), disassemble(container)
    assert len(data) < 3_000_000
    assert ".slot 1..4095/2 step" in text
    assert to_bytes(assembled(text)) == data


def test_diff_names_what_changed(tmp_path: Path) -> None:
    first = assembled(HAND)
    assert differences(first, first) == []
    second = assembled(
        HAND.replace("NOT R1", "NOT R2").replace("125us x4", "250us x4").replace(" -1", " 1")
    )
    text = "\n".join(differences(first, second))
    assert "-NOT R1" in text
    assert "+NOT R2" in text
    assert "frame time: 500 us -> 1000 us (+100.0%)" in text
    assert "-.readout B frame -1" in text
    assert "+.readout B frame 1" in text
    path = tmp_path / "x.icw"
    path.write_bytes(to_bytes(first))
    assert differences(read_container(path), first) == []
    third = replace(
        assembled(HAND + ".kernel idle\nnop\n.slot 2,4 idle\n"),
        pixel_codes=np.zeros((256, 256), np.int32),
    )
    text = "\n".join(differences(first, third))
    assert "kernel idle:" in text
    assert "+.kernel idle                             ; 1 word, 1.2 us; launched at 2,4" in text
    assert "+.slot 2,4 step idle" in text
    assert "+.pixels tile 1 1" in text


def test_diff_shows_lines_of_text_and_only_tells_that_data_differ() -> None:
    """A line of source without a space, a tile of one column, and a plane of codes."""
    first = assembled(HAND)
    first, second = (replace(first, source_lines=(line,)) for line in ("#a", "#bcd"))
    assert differences(first, second)[-2:] == ["  -| #a", "  +| #bcd"]
    codes = np.zeros((256, 256), np.int32)
    tiled = [replace(first, pixel_codes=codes + code) for code in (0, 1)]
    tiled = [
        replace(
            each,
            table=replace(
                each.table, codes=np.zeros((2, 0), np.int64), shutter_of_code=np.zeros(2, np.int32)
            ),
        )
        for each in tiled
    ]
    assert differences(*tiled)[-2:] == ["  -| 0", "  +| 1"]
    codes[:] = np.arange(256) % 2
    codes[7, 9] = 1 - codes[7, 9]
    wide = replace(tiled[0], pixel_codes=codes)
    assert differences(wide, replace(wide, pixel_codes=1 - codes))[-1] == (
        "  the data in base64 differ"
    )


def test_unreadable_containers_are_refused(tmp_path: Path) -> None:
    """A missing file and a folder have status 2. `/dev/zero` is refused with status 1 and not read
    for ever."""
    for name, status in (("missing.icw", 2), (".", 2), ("/dev/zero", 1)):
        with pytest.raises(Rejected) as caught:
            read_container(tmp_path / name)
        assert caught.value.status == status


def test_ranges_of_boundaries_read_back() -> None:
    assert ranges_text([0, 1, 2, 5, 7, 9, 11, 20, 30]) == "0..2,5..11/2,20,30"
    assert [list(r) for r in read_ranges("0..2,5..11/2,20", 99) or []] == [
        [0, 1, 2],
        [5, 7, 9, 11],
        [20],
    ]
    assert read_ranges("0..100", 99) is None
    assert read_ranges("5..3", 99) is None
    assert read_ranges("1..3/0", 99) is None
    assert read_time_us("1.6ms") == 1600.0
    assert read_time_us("0.1us") == 0.1
    assert read_time_us("3s") == 3e6
    assert read_time_us("0us") is None
    noise = np.random.default_rng(0).random(100) < 0.5
    assert slots_text(noise).startswith("x")
    found = read_slots(slots_text(noise), 100)
    assert found is not None
    assert np.array_equal(found, noise)
    assert read_slots("x" + "f" * 26, 100) is None


@pytest.mark.parametrize(("wrong", "shown"), [(49, 49), (50, 50), (51, 50), (80, 50)])
def test_at_most_fifty_faults_of_a_text_are_shown(wrong: int, shown: int) -> None:
    """49 and 50 wrong lines give as many errors; 51 and 80 give 50."""
    text = "nonsense R1\n" * wrong
    with pytest.raises(Rejected) as raised:
        assemble_words(Source("a.asm", text), Path())
    unknown = [each for each in raised.value.diagnostics if each.code == "NS0710"]
    assert len(unknown) == shown


def test_integers_have_64_bits_and_fields_of_words_32() -> None:
    """The last number that is read, and the first that is not."""
    for last, beyond in ((2**63 - 1, 2**63), (-(2**63), -(2**63) - 1)):
        assert read_integer(str(last)) == last
        assert read_integer(str(beyond)) is None
    text = HAND.replace("    all\n", "    .word 0 0 0 0 {}\n")
    words = assembled(text.format(2**32 - 1)).kernels[1].words
    assert (0, 0, 0, 0, 2**32 - 1) in [tuple(map(int, word)) for word in words]
    assert [each.code for each in rejected(text.format(2**32))] == ["NS0714"]
