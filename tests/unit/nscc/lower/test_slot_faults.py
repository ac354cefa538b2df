"""Programs that do not fit: the numbers, the places, what is proved, and ways out that hold."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from marks import slow

from nscc.chips.load import load_target
from nscc.compiler import compile_source
from nscc.diagnostics.diagnostic import Rejected, Severity
from nscc.limits import ways_out
from nscc.pipeline import Options
from nscc.source import Source

BUMPS = "code a : 0..N - 1\ncode b : 1..N\nrequire a < b\nopen when a <= n < b"
E16 = "frame 16 slots of 1ms\ncode bits : bit[16]\nopen when bits[n]"
STOPS = "code stop : 1..N\nopen when n < stop"


def compiled(text, codes="open", target=None, version=1, **options):
    """The compiled program of a text without its first line."""
    source = Source("test.nsl", f"nsl {version}\n{text}\n")
    return compile_source(source, Path(), Options(codes=codes, target=target, **options))


def fault(text, *args, **options):
    """The only error that a program raises."""
    with pytest.raises(Rejected) as caught:
        compiled(text, *args, **options)
    errors = [d for d in caught.value.diagnostics if d.severity is Severity.ERROR]
    assert len(errors) == 1
    return errors[0]


def book_file(folder, rows, slots):
    """A codebook of distinct pseudo-random rows as a program."""
    random = np.random.default_rng(4)
    book = np.unique(random.integers(0, 2, (2 * rows, slots), dtype=np.uint8), axis=0)[:rows]
    np.savez(folder / "book.npz", book)
    return (
        f"frame {slots} slots of 2ms\nshutters book from {str(folder / 'book.npz')!r}\n"
        "code id : row of book\nopen when book[id]"
    ).replace("'", '"')


@pytest.mark.parametrize("chip", ["scamp5", None])
@pytest.mark.parametrize(
    ("text", "codes", "required", "what"),
    [
        (E16, "open", 16, "16 slots, each free: 65536 shutters"),
        (
            E16 + "\npixels bits = (256 * y + x) % 65536",
            "fixed",
            16,
            "65536 different shutters in use",
        ),
        slow(f"frame 200 slots of 1ms\n{BUMPS}", "open", 15, "20100 different shutters"),
        (
            "frame 9 slots of 1ms\ncode a : bit[9]\ncode b : bit[9]\n"
            "bucket one open when a[n]\nbucket two open when b[n]",
            "open",
            18,
            "9 slots in 2 buckets, each free: 262144 shutters",
        ),
    ],
)
def test_more_shutters_than_register_states_are_refused(chip, text, codes, required, what):
    found = fault(f"target {chip}\n{text}" if chip else text, codes)
    # `required` is the binary logarithm of the number of shutters, rounded up.
    assert found.code == "NS0412"
    assert f"its codes need {required} bits per pixel, but the chip has 13" in found.message
    assert found.label.text == what
    assert found.data == {
        "resource": "digital registers",
        "required": required,
        "available": 13,
        "proved": True,
    }
    second = [label.text for label in found.related] if chip else list(found.notes)
    assert any("13 one-bit registers a pixel (R0-R12)" in place for place in second)
    assert any(note.startswith("certain") for note in found.notes)
    assert found.ways_out


@pytest.mark.slow
def test_a_codebook_that_is_too_large_is_refused(tmp_path):
    found = fault(book_file(tmp_path, 8200, 20))
    # 14 bits tell 8200 rows apart, 13 only 8192.
    assert (found.code, found.data["required"]) == ("NS0412", 14)
    check_ways_out(found, 20)


def bump(slots):
    """Any one bump a pixel, compiled as ways out are."""
    return compiled(f"frame {slots} slots of 1ms\n{BUMPS}", level=1)


def check_ways_out(found, slots, more=None):
    """Every way out compiles when it is written as a program, at the price that it states."""
    ways = {
        "`start <= n < stop`": lambda: bump(slots),
        "`n < stop`": lambda: compiled(f"frame {slots} slots of 1ms\n{STOPS}", level=1),
        "`code id : row of book`": None,
        **(more or {}),
    }
    assert found.ways_out
    for text in found.ways_out:
        what, price = text[:24].strip(), re.search(r": ([0-9.]+) words a slot at -O1$", text)
        frame, rows = re.fullmatch(r"frame (\d+) slots", what), re.fullmatch(r"K = (\d+)", what)
        if frame and what not in ways:
            ways[what] = lambda slots=int(frame[1]): bump(slots)
        if rows:
            assert found.data["rows"] == int(rows[1])
            continue
        write = ways[what]
        if write is not None:
            done = write()
            per_slot = done.lowered.schedule.words_total / len(done.program.frame.slot_us)
            assert float(price[1]) == pytest.approx(per_slot, rel=1e-2)
    return [text[:24].strip() for text in found.ways_out]


def test_suggestions_for_too_many_free_bits_compile():
    """The error for 16 free bits offers fixed codes and 13 slots first. Each offer compiles."""
    text = E16 + "\npixels bits = tile [[1, 2], [3, 4]]"
    offered = check_ways_out(
        fault(text),
        16,
        {
            "`--codes fixed`": lambda: compiled(text, "fixed"),
            "frame 13 slots": lambda: compiled(
                "frame 13 slots of 1ms\ncode bits : bit[13]\nopen when bits[n]"
            ),
        },
    )
    assert offered[:2] == ["`--codes fixed`", "frame 13 slots"]


def test_ways_out_of_a_general_rule_fit():
    """The rule keeps its text; the frame gets the largest number of slots that fits."""
    text = "frame {} slots of 1ms\ncode s : 1..N code a : bit[9]\nopen when n < s xor a[n % 9]"
    offered = check_ways_out(
        fault(text.format(20)),
        20,
        {"frame 13 slots": lambda: compiled(text.format(13), level=1)},
    )
    assert offered[0] == "frame 13 slots"
    with pytest.raises(Rejected):
        compiled(text.format(14), level=1)


@pytest.mark.slow
@pytest.mark.parametrize(("slots", "code"), [(200, "NS0412"), (92, "NS0412"), (91, "NS0502")])
def test_suggestions_for_too_many_bumps_compile(slots, code):
    """The number of slots that is offered compiles, and one slot more does not."""
    found = fault(f"frame {slots} slots of 1ms\n{BUMPS}")
    assert found.code == code
    offered = check_ways_out(found, slots)
    most = int(re.fullmatch(r"frame (\d+) slots", offered[0])[1])
    assert most >= 64
    with pytest.raises(Rejected):
        bump(most + 1)


@pytest.mark.slow
def test_a_codebook_of_random_rows_costs_no_more_than_its_stand_in(tmp_path):
    (text,) = (text for text in fault(E16).ways_out if text.startswith("`code id"))
    assert "pseudo-random" in text
    done = compiled(book_file(tmp_path, 64, 16))
    price = float(re.search(r": ([0-9.]+) words", text)[1])
    # A tenth is for the luck of the rows.
    assert done.lowered.schedule.words_total / 16 < 1.1 * price


@pytest.mark.parametrize(
    ("buckets", "lowering", "required", "most"),
    [(7, "auto", 7, 6), (8, "auto", 8, 6), (6, "accumulate", 7, 5), (6, "latch", 7, 5)],
)
def test_too_many_buckets_are_refused(buckets, lowering, required, most):
    def text(count):
        rules = (f"bucket b{i} open when n < s" for i in range(count))
        return "frame 8 slots of 1ms\ncode s : 0..7\n" + "\n".join(rules)

    found = fault(text(buckets), lowering=lowering)
    assert found.code == "NS0413"
    assert found.data["required"] == required
    assert found.data["available"] == 6
    assert found.data["proved"] is True
    assert found.helps[0] == f"keep at most {most} buckets"
    assert compiled(text(most), lowering=lowering).proof.holds
    assert ("leave --lowering at auto" in " ".join(found.helps)) == (lowering != "auto")


def test_the_lowering_latch_is_refused_for_shutters_that_open_later():
    """A shutter that opens at slot s gives NS0414 for `latch`. With the lowering left open it
    compiles."""
    text = "frame 8 slots of 1ms\ncode s : 0..7\nopen when n == s"
    found = fault(text, lowering="latch")
    assert found.code == "NS0414"
    assert "latch requires" in found.message
    assert compiled(text).proof.holds


def test_a_lowering_that_was_refused_is_not_advised():
    """The help for NS0414 proposes `auto` and not the refused `accumulate`, and `auto` compiles."""
    text = (
        "frame 8 slots of 1ms\nsense b when light > 45% at n in [2, 4]\n"
        "state c : 0..2 = 0\nnext c = looks when b and c == 0\nopen when c == 0 and n > 1\nread c"
    )
    found = fault(text, lowering="accumulate", version=2)
    assert found.code == "NS0414"
    assert "leave --lowering at auto" in found.helps[0]
    assert "accumulate" not in " ".join(found.helps)
    assert compiled(text, version=2).proof.holds


LOOKS = (
    "frame 16 slots of 1ms\nsense b when light > 45% at n in [2, 4]\n"
    "state c : 0..2 = 0\nnext c = looks when b and c == 0\nread c\n"
)


def test_the_lowering_of_a_program_that_looks_is_the_requested_one():
    """A shutter that closes between two looks is latched, too."""
    rules = {"code s : 3..16\nopen when n < s and c == 0": "latch", "open when c == 1": "edges"}
    for rule, cheapest in rules.items():
        text = LOOKS + rule
        for lowering in ("auto", "latch", "edges"):
            if lowering == "latch" != cheapest:
                found = fault(text, lowering=lowering, version=2)
                assert found.code == "NS0414"
                assert "latch requires" in found.message
                continue
            done = compiled(text, lowering=lowering, version=2)
            assert done.proof.holds
            assert done.lowered.plan.lowering == (cheapest if lowering == "auto" else lowering)
    buckets = "".join(f"bucket b{i} open when n == {i} and c == 0\n" for i in range(7))
    assert fault(LOOKS + buckets, version=2).helps == ("keep at most 5 buckets",)


@pytest.mark.parametrize(
    ("version", "text"),
    [
        (1, "".join(f"code c{i} : bit[9]\nbucket b{i} open when c{i}[n]\n" for i in range(2))),
        (
            3,
            "open when true\n"
            + "".join(f"plane p{i} = exposure > {i}%\n" for i in range(1, 16))
            + "read "
            + ", ".join(f"p{i}" for i in range(1, 16)),
        ),
    ],
)
def test_suggestions_keep_all_buckets_and_planes_of_the_program(version, text):
    """The help suggests neither a single bump for two buckets, nor bumps for planes."""
    found = fault("frame 9 slots of 1ms\n" + text, version=version)
    assert found.data["resource"] == "digital registers"
    offered = [way[:24].strip() for way in found.ways_out]
    assert offered == ["frame 6 slots", "`code id : row of book`"] * (version == 1)
    assert ("nscc looked no further" in " ".join(found.helps)) == (version == 3)


FREE = "code b : bit[N]\nopen when b[n]"
TWO = "frame {0} slots of 1ms\ncode a : bit[N] code b : bit[N]\nbucket one open when "
PLANE = "plane p = exposure > 5% read p"
KEPT = "plane p = exposure > 5% state c : 0..{0} = 0 kept next c = min(c + 1, {0}) when p read c"


@pytest.mark.parametrize(
    ("version", "text", "size", "code", "change", "most"),
    [
        (1, TWO + "a[n] bucket two open when b[n]", 9, "NS0412", "frame {} slots", 6),
        (1, "frame slots [{1}]\n" + FREE, 16, "NS0412", "frame {} slots", 13),
        (3, "frame {0} slots of 1ms\n" + FREE + "\n" + PLANE, 13, "NS0535", "frame {} slots", 10),
        (4, "frame 64 slots of 1ms\n" + STOPS + "\n" + KEPT, 255, "NS0535", "{} instead of 255", 1),
        (
            1,
            "frame {0} slots of 1ms\ncode b : bit[N]\nrequire b[0]\nopen when b[n]",
            23,
            "NS0450",
            "frame {} slots",
            14,
        ),
    ],
)
def test_the_largest_size_that_fits_is_named(version, text, size, code, change, most):
    """For several buckets, slots of different lengths, planes, kept states, and codes that are too
    many to list. The next larger size does not compile."""

    def written(count):
        return text.format(count, ", ".join(f"{1000 + i}us" for i in range(count)))

    found = fault(written(size), version=version)
    assert found.code == code
    assert found.ways_out[0].startswith(change.format(most) + " ")
    assert f"; {most + 1} does not fit" in found.ways_out[0]
    assert compiled(written(most), version=version, level=1).proof.holds
    with pytest.raises(Rejected):
        compiled(written(most + 1), version=version, level=1)


def test_the_search_for_a_size_ends_with_its_time(monkeypatch):
    """The error for 40 stops that do not fit names a size, and the sizes that were not tried."""
    clock = iter(range(0, 10**6, 2))
    monkeypatch.setattr(ways_out, "process_time", lambda: next(clock))
    tiny = replace(load_target("scamp5", Path()), store_words=20)
    found = fault(f"frame 40 slots of 1ms\n{STOPS}", target=tiny)
    assert "; looked no further: 2 to 39 would take long" in found.ways_out[0]


@pytest.mark.parametrize(("slot_s", "readout_s", "buckets"), [(2, 0, 1), (0, 2, 1), (0, 0.7, 2)])
def test_bits_that_decay_in_a_slot_or_a_readout_are_refused(slot_s, readout_s, buckets):
    """Bits of codes, and those of states in a program that looks."""
    target = replace(load_target("scamp5", Path()), readout_us=readout_s * 1e6)
    frame = f"frame 4 slots of {slot_s or 0.001}s\n"
    looks = "sense b when light > 45% at n == 2\nstate c : bit = 0\nnext c = b\nread c\n"
    rules = "".join(f"bucket b{i} open when not c\n" for i in range(buckets))
    codes = "code s : 1..4\n" + rules.replace("not c", "n < s")
    for version, text in ((2, looks + rules), (1, codes)):
        found = fault(frame + text, target=target, version=version)
        assert found.code == "NS0602"
        assert found.data["required"] == max(slot_s, readout_s * buckets) * 1e6
        assert ("split the slot" in found.helps[0]) == (slot_s == 2)


def test_a_search_without_gates_is_an_unproved_error():
    """The search finds nothing for 4186 bumps: NS0502 says that this is not proved."""
    found = fault(f"frame 91 slots of 1ms\n{BUMPS}", lowering="accumulate")
    assert found.code == "NS0502"
    assert found.data["proved"] is False
    assert "leave --lowering at auto" in found.helps[0]


def test_too_many_stored_words_are_reported_with_the_number_that_suffices():
    """A store of 20 words gives NS0501 with a number. A store of that number is enough."""
    text = f"frame 40 slots of 1ms\n{STOPS}"
    tiny = replace(load_target("scamp5", Path()), store_words=20)
    found = fault(text, target=tiny)
    assert found.code == "NS0501"
    assert (found.data["available"], found.data["proved"]) == (20, False)
    stored = found.data["required"]
    assert f"needs {stored} stored words" in found.message
    enough = replace(tiny, store_words=stored)
    done = compiled(text, target=enough)
    assert done.lowered.schedule.words_stored <= stored


def test_check_prints_a_note_if_only_build_can_decide():
    """What is an error of `build` is a note NS0503 here, and nothing is lowered."""
    done = compiled(f"frame 91 slots of 1ms\n{BUMPS}", unproved_is_error=False)
    (note,) = (d for d in done.diagnostics if d.code == "NS0503")
    assert note.severity is Severity.NOTE
    assert done.lowered is None


@pytest.mark.parametrize(
    ("slot", "proved"), [("1us", True), ("2.39us", True), ("2.41us", False), ("2.5us", False)]
)
def test_too_short_slots_are_reported_with_a_length_that_compiles(slot, proved):
    """NS0601 says whether it is proved. Slots of the length in its help compile."""
    found = fault(f"frame 64 slots of {slot}\n{STOPS}", level=1)
    assert (found.code, found.data["proved"]) == ("NS0601", proved)
    assert found.data["required"] > found.data["available"] == float(slot[:-2])
    enough = re.search(r"slots of ([0-9.]+) us or longer", found.helps[0])[1]
    assert compiled(f"frame 64 slots of {enough}us\n{STOPS}").proof.holds


def test_words_that_only_one_lowering_needs_prove_nothing():
    """A shutter that closes after slot 1 has to be read there, but its rise may need no words."""
    text = "frame slots [1ms, 1us, 1ms, 1ms]\ncode s : 0..1\nopen when 1 <= n < 3 - s"
    found = fault(text, lowering="edges")
    assert found.data["proved"] is True
    assert compiled(text.replace("1us", "2ms")).proof.holds


def test_slots_longer_than_the_memory_are_refused():
    """Slots of 2 s exceed 0.9 of the retention: NS0602. Slots of 1 s compile, and so do those of 2
    s without codes."""
    found = fault(f"frame 4 slots of 2s\n{STOPS}")
    assert found.code == "NS0602"
    assert found.data["required"] == 2e6
    # A retention of 1.5 s, less a margin of a tenth.
    assert found.data["available"] == pytest.approx(0.9 * 1.5e6)
    assert compiled(f"frame 8 slots of 1s\n{STOPS}").proof.holds
    assert compiled("frame 4 slots of 2s\nopen when true").proof.holds
