"""Programs in Python: what `nscc.compile` and `nscc.load` give, against rules done by hand."""

from __future__ import annotations

import json
import pickle
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from checkout import ROOT
from nscc_command import invoke

import nscc
from nscc.chips.load import builtin_target
from nscc.diagnostics.diagnostic import Rejected
from nscc.emit.products import SUFFIXES

ROWS, COLS = 6, 5
TARGET = replace(builtin_target("scamp5"), rows=ROWS, cols=COLS)
TEXT = """nsl 1
frame 7 slots of 1ms
code split : 1..6
bucket early open when n < split
bucket late open when n > split
pixels split = 1 + (x + 2 * y) % 6
"""
Y, X = np.mgrid[:ROWS, :COLS]
SPLIT = 1 + (X + 2 * Y) % 6
SLOT = np.arange(7)


def program(**options: Any) -> nscc.ShutterProgram:
    return nscc.compile(TEXT, **{"target": TARGET, "level": 1, **options})


def opened(split: np.ndarray) -> np.ndarray:
    """bool (buckets, slots, *split.shape), as the rules say."""
    n = SLOT.reshape(-1, *[1] * split.ndim)
    return np.stack([n < split, n > split])


def test_codes_and_shutters_are_those_of_the_rules() -> None:
    p = program()
    assert list(p.codes) == ["split"]
    assert p.codes["split"].tolist() == [1, 2, 3, 4, 5, 6]
    by_code = p.shutters()
    assert (by_code.shape, by_code.dtype) == ((2, 6, 7), np.bool_)
    np.testing.assert_array_equal(by_code, opened(p.codes["split"]).transpose(0, 2, 1))
    np.testing.assert_array_equal(p.codes["split"][p.code_at_pixels], SPLIT)
    np.testing.assert_array_equal(p.shutters(pixels=True), opened(SPLIT))
    assert (p.slots, p.buckets, p.shape, p.target) == (7, ("early", "late"), (ROWS, COLS), TARGET)
    assert p.slot_us == (1000.0,) * 7


def test_a_program_of_one_code_needs_no_data() -> None:
    p = nscc.compile("nsl 1\nframe 3 slots of 1ms\nopen when n != 1\n", target=TARGET)
    assert p.codes == {}
    assert p.shutters().tolist() == [[[True, False, True]]]
    assert p.shutters(pixels=True).shape == (1, 3, ROWS, COLS)


def test_a_saved_program_is_loaded_as_it_was(tmp_path: Path) -> None:
    p = program()
    assert p.save(tmp_path / "p.icw") == tmp_path / "p.icw"
    again = nscc.load(tmp_path / "p.icw")
    np.testing.assert_array_equal(again.words, p.words)
    assert (again.words.dtype, again.words.shape[1]) == (np.uint32, 5)
    np.testing.assert_array_equal(again.shutters(pixels=True), opened(SPLIT))
    assert again.words_per_frame == p.words_per_frame
    again.save(tmp_path / "q.icw")
    assert (tmp_path / "q.icw").read_bytes() == (tmp_path / "p.icw").read_bytes()
    with pytest.raises(nscc.Rejected, match="NS0743"):
        _ = again.report
    with pytest.raises(nscc.Rejected, match="NS0743"):
        again.save(tmp_path / "p.cpp")


def test_files_and_defaults_are_those_of_the_command(tmp_path: Path) -> None:
    (tmp_path / "p.nsl").write_text(TEXT)
    kinds = ",".join(kind for kind in SUFFIXES if kind != "planes")  # of another kind of chip
    assert invoke(["build", "p.nsl", "-o", "p.nsl/p.icw"], tmp_path).status == 2  # not a folder
    (tmp_path / "c").mkdir()
    outcome = invoke(["build", "p.nsl", "-o", "c/p.icw", "--emit", kinds], tmp_path)
    assert outcome.status == 0, outcome.err
    p = nscc.compile(tmp_path / "p.nsl")
    (tmp_path / "python").mkdir()
    for kind in kinds.split(","):
        p.save(tmp_path / "python" / f"p{SUFFIXES[kind]}")
    for file in (tmp_path / "c").iterdir():
        assert (tmp_path / "python" / file.name).read_bytes() == file.read_bytes(), file.name
    assert p.report == json.loads((tmp_path / "c" / "p.report.json").read_bytes())
    assert p.report["alternatives"]


def test_other_codes_are_laid_over_the_array_and_invalid_ones_refused(tmp_path: Path) -> None:
    p = program(codes="open")
    other = np.full((ROWS, COLS), 2)
    other[0, 1] = 5
    np.testing.assert_array_equal(p.with_pixels(split=other).shutters(pixels=True), opened(other))
    np.savez(tmp_path / "codes.npz", split=other)
    np.testing.assert_array_equal(
        p.with_pixels(tmp_path / "codes.npz").shutters(pixels=True), opened(other)
    )
    for fields, words in (
        ({"splt": other}, "did you mean `split`"),
        ({}, "array for the code field 'split'"),
        ({"split": other * 1.0}, r"\(6, 5\) of float64, but must contain integers \(6, 5\)"),
        ({"split": other[1:]}, r"\(5, 5\) of int64"),
        ({"split": other + 4}, r"x = 1, y = 0.*split = 9, outside 1..6"),
    ):
        with pytest.raises(nscc.Rejected, match=words):
            p.with_pixels(**fields)
    few = nscc.compile(TEXT.replace("1 + (x + 2 * y) % 6", "3"), target=TARGET, level=1)
    with pytest.raises(nscc.Rejected, match="NS0319"):
        few.with_pixels(split=other)
    empty = nscc.compile(TEXT.rpartition("pixels")[0], target=TARGET, level=1)
    assert empty.shutters().shape == (2, 6, 7)
    with pytest.raises(nscc.Rejected, match="NS0741"):
        empty.shutters(pixels=True)


def test_a_str_that_ends_in_nsl_is_a_path_and_any_other_a_program(tmp_path: Path) -> None:
    path = tmp_path / "here.nsl"
    path.write_text(TEXT)
    for source in (str(path), path, TEXT, TEXT + "# here.nsl"):
        assert nscc.compile(source, target=TARGET, level=1).slots == 7
    with pytest.raises(nscc.Rejected, match=r"NS0101.*gone.nsl"):
        nscc.compile("gone.nsl")
    (tmp_path / "c.npz").write_bytes(b"")
    np.savez(tmp_path / "c.npz", split=SPLIT)
    named = TEXT.rpartition("pixels")[0] + 'pixels from "c.npz"\n'
    laid = nscc.compile(named, target=TARGET, level=1, folder=tmp_path)
    np.testing.assert_array_equal(laid.shutters(pixels=True), opened(SPLIT))


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: nscc.compile(b"nsl 1"), "path or its text, not the bytes b'nsl 1'"),
        (lambda: nscc.compile(None), "path or its text, not None"),
        (lambda: nscc.compile("hdr_2x2"), "neither a program nor the path of one"),
        (lambda: nscc.compile("x.icw"), r"use nscc.load\('x.icw'\)"),
        (lambda: nscc.load("x.nsl"), r"nscc.compile\('x.nsl'\) compiles it"),
        (lambda: nscc.load(np.ones(3)), r"takes a path, not an array \(3,\) of float64"),
        (lambda: nscc.compile(TEXT, level=4), "level is a whole number from 0 to 3, not 4"),
        (lambda: nscc.compile(TEXT, level=True), "level is a whole number from 0 to 3, not True"),
        (lambda: nscc.compile(TEXT, codes="opn"), "did you mean `open`"),
        (lambda: nscc.compile(TEXT, lowering="edge"), "did you mean `edges`"),
        (lambda: nscc.compile(TEXT, target=5), "its file or a Target, not 5"),
        (lambda: nscc.compile(TEXT, max_words_per_slot=0), "a whole number from 1, not 0"),
        (lambda: nscc.compile("x.nsl", folder="."), "leave it out"),
        (lambda: nscc.compile(TEXT, cache="no"), "cache is True or False, not the text 'no'"),
        (lambda: program().shutters(pixels="yes"), "pixels is True or False"),
        (lambda: program().save(5), "save takes a path, not 5"),
        (lambda: program().save("a\0.icw"), "save takes a path"),
        (lambda: program().with_pixels(split=[[1], [1, 2]]), "cannot convert 'split' to an array"),
        (lambda: program().with_pixels("a.npz", split=SPLIT), "either a file or fields"),
    ],
)
def test_wrong_arguments_are_refused_in_a_sentence(call: Any, words: str) -> None:
    with pytest.raises(TypeError, match=words) as caught:
        call()
    assert isinstance(caught.value, nscc.Rejected)
    assert caught.value.diagnostics[0].code == "NS0789"


def test_a_rejection_says_all_that_the_command_line_says(tmp_path: Path) -> None:
    wrong = TEXT.replace("n < split", "n < splt").replace("x + 2", "z + 2")
    (tmp_path / "p.nsl").write_text(wrong)
    shown = invoke(["check", "p.nsl"], tmp_path).err
    with pytest.raises(nscc.Rejected) as caught:
        nscc.compile(wrong)
    assert str(caught.value) == shown.rstrip().replace("p.nsl", "<text>")
    assert len(caught.value.diagnostics) > 1
    assert repr(caught.value).startswith("Rejected('NS0214: ")
    again = pickle.loads(pickle.dumps(caught.value))
    assert (str(again), again.status) == (str(caught.value), 1)


def test_compile_gives_warnings_as_python_warnings_at_the_line_of_the_call() -> None:
    text = "nsl 1\nframe 4 slots of 1ms\nopen when false\n"
    with pytest.warns(UserWarning, match=r"NS0350.*\n  --> <text>:3:11") as caught:
        nscc.compile(text, target=TARGET)
    assert caught[0].filename == __file__


@pytest.mark.parametrize("made", ["compiled", "loaded", "container", "program", "choice", "table"])
def test_repr_of_compiled_values_is_one_line(made: str, tmp_path: Path) -> None:
    p = program(codes="open")
    assert p.compiled is not None
    values = {
        "compiled": p.compiled,
        "container": p.container,
        "program": p.compiled.program,
        "choice": p.compiled.layout,
        "table": p.container.table,
        "loaded": nscc.load(p.save(tmp_path / "p.icw")),
    }
    for text in (repr(values[made]), repr(p)):
        assert "\n" not in text
        assert len(text) < 250


def test_the_report_of_pixels_that_look_is_of_their_own_words() -> None:
    """The report counts the words of the state machine, not those of the shutters without light."""
    looking = nscc.compile(ROOT / "examples/auto_exposure.nsl", level=0)
    report = looking.report
    assert report["words_total"] == looking.words_per_frame
    assert report["looks"]["boundaries"] == list(looking.container.machine.looks)
    with pytest.raises(Rejected) as caught:
        looking.shutters()
    assert [each.code for each in caught.value.diagnostics] == ["NS0444"]
