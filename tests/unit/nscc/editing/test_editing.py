"""What editors ask about a program's text: answers in plain Python, no protocol."""

from __future__ import annotations

import re
from hashlib import sha256
from pathlib import Path

import numpy as np
import pytest
from checkout import ROOT
from syntax_text import bare

from nscc.chips.load import builtin_target
from nscc.compiler import compile_source
from nscc.editing.complete import Listing, complete, complete_listing
from nscc.editing.document import Document, fixes_at, outline, text_with_safe_fixes
from nscc.editing.hover import hints, hover
from nscc.editing.mentions import CannotRename, renamed
from nscc.lower.resources import time_text
from nscc.pipeline import Options
from nscc.source import Source, Span
from nscc.words.disassembly import disassemble

STOPS = """nsl 1
frame slots [1ms, 2ms, 4ms]   # three
let most = 1 + 2
code stop : 1..most
open when n < stop
pixels stop = 1 + x % 2
"""
LOOKS = (ROOT / "examples/float_pixel.nsl").read_text(encoding="utf-8")
SMALL = "nsl 2\nsense b when light > 45% at n == 1\nstate s : 0..3 = 0\n"


def document(text: str, folder: Path = ROOT) -> Document:
    return Document((folder / "a.nsl").as_posix(), text, folder)


def offered(text: str, folder: Path = ROOT) -> list[str]:
    """What may stand at the bar in a text, in place of the word that is begun there."""
    at = text.index("|")
    span, offers = complete(document(text.replace("|", ""), folder), at)
    assert span.end == at
    return [offer.text for offer in offers]


def told(text: str, piece: str) -> str:
    """What is said of the last piece of that kind in a text."""
    found = hover(document(text), text.rindex(piece))
    assert found is not None
    return found.text


@pytest.mark.parametrize(
    ("text", "wanted", "unwanted"),
    [
        ("|", {"nsl 1", "nsl 2"}, {"frame"}),
        ("nsl 1\nfr|", {"frame", "code"}, {"nsl", "sense"}),
        ("nsl 2\nfr|", {"frame", "sense"}, {"nsl"}),
        ("nsl 1 frame 8 slots of 1ms |", {"code", "open"}, {"frame"}),
        ("nsl 1\ntarget sc|", {"scamp5", "scamp7", "scamp5-algorithm1"}, {"frame"}),
        ("nsl 1\nframe 8 slots |", {"of"}, {"slots"}),
        (STOPS.replace("n < stop", "|"), {"n", "stop", "most", "N", "not"}, {"x", "y", "frame"}),
        (STOPS.replace("1 + x % 2", "|"), {"x", "y", "most", "tile"}, {"n", "stop"}),
        (STOPS.replace("1..most", "1..|"), {"most", "N", "rows"}, {"n", "stop", "x"}),
        (STOPS.replace("pixels stop", "pixels |"), {"stop", "from"}, {"most"}),
        (STOPS.replace("three", "fr|"), set(), {"frame"}),
        (STOPS + "bucket a |", {"open"}, {"n"}),
        (STOPS + "let |", set(), {"n", "stop", "most"}),
        (SMALL + "next |", {"s"}, {"b", "n"}),
        (SMALL + "next s = |", {"s", "b", "n", "looks"}, {"x"}),
        (SMALL + "sense c when |", {"light", "exposure"}, {"n"}),
        (SMALL + "sense c when light > 45% at |", {"n", "N"}, {"b", "s"}),
        ("nsl 2 bucket early open when true sense c when exposure |", {"early"}, {"c"}),
        ("nsl 1\nshutters u [ 10 ]\ncode c : row of |", {"u"}, {"c"}),
        ("nsl 1\nopen when n |", {"and", "or"}, {"in"}),
        ("nsl 2\nopen when n |", {"and", "in"}, set()),
    ],
)
def test_completion_offers_valid_continuations(
    text: str, wanted: set[str], unwanted: set[str]
) -> None:
    found = offered(text)
    assert wanted <= {*found}
    assert not unwanted.intersection(found)
    assert len(found) == len({*found})


def test_files_and_their_digests_are_offered(tmp_path: Path) -> None:
    """In a string, the editor offers files of the right suffix and folders. After `sha256` it
    offers the digest, and nothing for a missing file."""
    np.savez(tmp_path / "codes.npz", stop=np.ones((2, 2), int))
    (tmp_path / "chip.toml").touch()
    (tmp_path / "deep").mkdir()
    assert offered('nsl 1\npixels from "|', tmp_path) == ["codes.npz", "deep/"]
    assert offered('nsl 1\npixels from "deep/../co|', tmp_path)[0] == "deep/../codes.npz"
    assert offered('nsl 1\ntarget "|', tmp_path) == ["chip.toml", "deep/"]
    assert offered('nsl 1\npixels from "none/|', tmp_path) == []
    digest = sha256((tmp_path / "codes.npz").read_bytes()).hexdigest()
    assert offered('nsl 1\npixels from "codes.npz" sha256 "|', tmp_path) == [digest]
    assert offered('nsl 1\npixels from "gone.npz" sha256 "|', tmp_path) == []


@pytest.mark.parametrize(
    ("text", "piece", "said"),
    [
        (STOPS, "stop", ["1..3", "2 of its 3 values in use: 1, 2"]),
        (STOPS, "most", ["a constant, 3"]),
        (STOPS, "x % 2", ["the column of a pixel"]),
        (STOPS, "frame", ["7 ms in all", "words a frame", "frame N slots of TIME"]),
        (STOPS, "2ms", ["Slot 1, 2 ms: ", " at its start, "]),
        (STOPS, "open", ["Class b", "open when EXPR"]),
        (LOOKS, "bright and", ["8 times", "1, 2, 4, 8"]),
        (LOOKS, "closed_at", ["0..8, 0 at the start, read out"]),
        (LOOKS, "looks when", ["including this one"]),
        (STOPS.replace("n < stop", "n < sto"), "sto\n", ["# NS0214", "## What to do"]),
        ("nsl 1\nlet a = b\nlet b = a\n", "a = b", ["a constant", "# NS0203"]),
    ],
)
def test_hovering_describes_the_name_at_a_place(text: str, piece: str, said: list[str]) -> None:
    found = told(text, piece)
    assert [each for each in said if each not in found] == []


def test_hints_of_slots_equal_the_compiled_words() -> None:
    """Words at each boundary, counted from the launches of the compiled container."""
    compiled = compile_source(Source("a.nsl", STOPS), ROOT, Options(level=1))
    container = compiled.container
    assert container is not None
    counts = [0] * 4
    for launch in container.launches:
        counts[launch.instant] += len(container.kernels[launch.kernel].words)
    said = [told(STOPS, f"{length}ms") for length in (1, 2, 4)]
    assert [
        f"{count} words at its start" in text for count, text in zip(counts, said, strict=False)
    ] == [True] * 3
    assert f"{sum(counts)} words a frame" in told(STOPS, "slots")
    frame, most = hints(document(STOPS))
    assert frame.text.startswith(f"{sum(counts)} words a frame, shortest slot ")
    assert STOPS[: frame.offset].endswith("4ms]")
    assert (most.text, STOPS[: most.offset].endswith("1 + 2")) == ("= 3", True)


def test_hints_of_planes_equal_the_load_times_of_their_rows() -> None:
    """A row after the other, each in the time that the chip's table gives it."""
    chip = builtin_target("dual-tap")
    load_us = chip.rows * chip.row_load_us
    text = "nsl 1\ntarget dual-tap\nframe slots [1ms, 2ms]\nopen when n < 1\n"
    (hint,) = hints(document(text))
    assert hint.text == f"2 planes a frame, shortest slot {time_text(load_us)}"
    assert f"2 planes of {chip.rows} x {chip.cols} bits a frame" in told(text, "slots")
    assert f"loaded in {time_text(load_us)} or {load_us / 20:.2g} %" in told(text, "2ms")


def test_the_outline_lists_names_even_of_broken_programs() -> None:
    found = outline(document(LOOKS))
    assert [(entry.kind, entry.name) for entry in found] == [
        ("frame", "frame"),
        ("sense", "bright"),
        ("state", "closed_at"),
        ("open", "open"),
    ]
    assert found[0].detail == "256 slots of 125us"
    assert all(LOOKS[e.at.start : e.at.end] == e.name for e in found)
    broken = outline(document("nsl 1\nlet a = 1\nopen wen n\ncode c : 0..1\nlet"))
    assert [entry.name for entry in broken] == ["a", "c"]


@pytest.mark.parametrize("name", ["stop", "most"])
def test_renaming_changes_one_name_only(name: str) -> None:
    """The tree of the renamed text is the old one with one name for another."""
    places = renamed(document(STOPS), STOPS.rindex(name), "other_1")
    text = STOPS
    for place in sorted(places, key=lambda place: -place.start):
        assert text[place.start : place.end] == name
        text = text[: place.start] + "other_1" + text[place.end :]
    old, new = (repr(bare(document(t).parsed[0].statements)) for t in (STOPS, text))
    assert old.replace(f"'{name}'", "'other_1'") == new
    assert not document(text).checked.diagnostics


@pytest.mark.parametrize(
    ("text", "wanted", "unwanted"),
    [
        ("|", {".kernel", ".slot", "WHERE", "bus"}, {"R1", "k0"}),
        ("  .ke|", {".kernel"}, set()),
        (".target sc|", {"scamp5", "scamp7"}, {".kernel"}),
        (".kernel k0\n all\n.slot 0 |", {"k0"}, {"R1"}),
        ("MOV |", {"R0", "R12", "A", "PIX"}, {"R13", "all"}),
        (".target scamp7\nMOV R1, |", {"R13"}, {"k0"}),
        ("all ; |", set(), {"R1"}),
        (".source\n| nsl |".replace("| nsl", "\x00 nsl"), set(), {"R1"}),
    ],
)
def test_completion_in_assembly_offers_valid_continuations(
    text: str, wanted: set[str], unwanted: set[str]
) -> None:
    at = text.index("|")
    found = Listing("a.asm", text.replace("|", "").replace("\x00", "|"), ROOT)
    span, offers = complete_listing(found, at)
    names = {offer.text for offer in offers}
    assert wanted <= names
    assert not unwanted & names
    assert span.end == at


def test_assembly_is_checked_as_nscc_asm_does() -> None:
    """A disassembled program has no error. With `.wiat` for `.wait` the error is at that word."""
    compiled = compile_source(Source("a.nsl", STOPS), ROOT, Options(level=1))
    assert compiled.container is not None
    text = disassemble(compiled.container)
    assert Listing("a.asm", text, ROOT).checked.diagnostics == ()
    wrong, *_ = Listing("a.asm", text.replace(".wait", ".wiat", 1), ROOT).checked.diagnostics
    assert wrong.label is not None
    assert wrong.label.span.start == text.index(".wait")


def test_invalid_renames_are_refused_with_the_reason() -> None:
    for text, piece, name, why in (
        (STOPS, "stop", "7up", "not a valid name"),
        (STOPS, "stop", "open", "reserved word of the language"),
        (STOPS, "stop", "n", "predefined"),
        (STOPS, "stop", "most", "another meaning"),
        (STOPS, "x % 2", "a", "is predefined"),
        (STOPS, "frame", "a", "no name of the program"),
        (STOPS.replace("n < stop", "n < sto"), "sto\n", "a", "not declared"),
        (STOPS.partition("pixels")[0] + 'pixels from "a.npz"', "stop", "a", "a.npz"),
    ):
        with pytest.raises(CannotRename, match=why):
            renamed(document(text), text.rindex(piece), name)


def test_words_of_version_2_are_names_in_version_1() -> None:
    """`light` is a free name in version 1. In version 2 it is a reserved word, and renaming is
    refused."""
    assert renamed(document(STOPS), STOPS.rindex("stop"), "light")
    with pytest.raises(CannotRename, match="reserved word of the language"):
        renamed(document(LOOKS), LOOKS.rindex("closed_at"), "light")


def test_buckets_have_names_of_their_own() -> None:
    """Bucket `a` and code `a` are two things: renaming the bucket changes one place, renaming the
    code three."""
    rules = "bucket a open when n < a\nbucket b open when n >= a\n"
    text = f"nsl 1\nframe 4 slots of 1ms\ncode a : 1..3\n{rules}"
    assert len(renamed(document(text), text.index("bucket a") + 7, "early")) == 1
    assert len(renamed(document(text), text.index("code a") + 5, "stop")) == 3


def test_fixes_are_found_at_a_place_and_applied_in_a_text() -> None:
    """At `wehn` one unsure fix is found. Only the sure one, `1 ms` to `1ms`, is applied to the
    text. A right text gives None."""
    text = "nsl 1\nframe 8 slots of 1 ms\nopen wehn n < 3\n"
    found = document(text)
    titles = [fix.title for _, fix in fixes_at(found, Span(0, len(text)))]
    assert len(titles) == 2
    at = text.index("wehn")
    ((diagnostic, fix),) = fixes_at(found, Span(at + 1, at + 1))
    assert (diagnostic.code, fix.replacement, fix.sure) == ("NS0107", "when", False)
    assert text_with_safe_fixes(found) == text.replace("1 ms", "1ms")
    assert text_with_safe_fixes(document(STOPS)) is None


def test_the_code_on_the_editors_page_runs(monkeypatch: pytest.MonkeyPatch) -> None:
    """The one block of Python code on the page ends without an error."""
    monkeypatch.chdir(ROOT)
    (shown,) = re.findall(
        r"^```python\n(.*?)^```$", (ROOT / "docs/editors.md").read_text(), re.M | re.S
    )
    exec(compile(shown, "editors.md", "exec"), {})


@pytest.mark.parametrize("text", ["\ud800", "nsl 1\n\0", "\ufeffnsl 1", "x" * (257 << 10), "\r\r"])
def test_invalid_texts_are_reported_in_editors(text: str) -> None:
    """Lone surrogates, zeros and texts that are too long get a message. Completion and hovering do
    not fail."""
    found = document(text)
    assert found.checked.diagnostics
    complete(found, 1)
    hover(found, 1)
    assert [*hints(found), *outline(found)] == []
