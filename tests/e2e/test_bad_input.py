"""Whatever is fed to nscc, it says one clear thing, ends with 1 or 2, and writes nothing."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from nscc_command import Outcome, invoke

GOOD = """nsl 1
frame 4 slots of 1ms
code stop : 1..4
open when n < stop
pixels stop = tile [[1, 2], [3, 4]]
"""

# Texts that grow: each is too much of something.
TOO_MUCH = {
    "line": "x" * 10_000_000,
    "lines": "\n" * 10_000_000,
    "comment": "nsl 1 # " + "y" * 10_000_000,
    "parentheses": GOOD.replace("n < stop", "(" * 5000 + "n < stop" + ")" * 5000),
    "open parentheses": "nsl 1\nframe 4 slots of 1ms\nopen when " + "(" * 100_000,
    "brackets": "nsl 1\nframe 4 slots of 1ms\npixels a = tile " + "[" * 100_000,
    "negations": GOOD.replace("n < stop", "not " * 20_000 + "n < stop"),
    "minus signs": GOOD.replace("n < stop", "n < " + "-" * 20_000 + "stop"),
    "sum": GOOD.replace("n < stop", "n < stop" + " + 1 - 1" * 20_000),
    "conditions": GOOD.replace("n < stop", "n < stop if true else " * 5000 + "true"),
    "digits": GOOD.replace("1..4", "1.." + "9" * 100_000),
    "slots": GOOD.replace("frame 4", "frame 99999999999999999999"),
    "shift": GOOD.replace("n < stop", "n < 1 << (1 << 60)"),
    "product": GOOD.replace("n < stop", "n < " + " * ".join(["9999999999"] * 2000)),
    "range": GOOD.replace("1..4", "1..1000000000000000000").partition("pixels")[0],
    "bits": "nsl 1\nframe 9 slots of 1ms\ncode b : bit[100000000]\nopen when b[n]\n",
    "lets": "nsl 1\n" + "".join(f"let a{i} = a{i + 1}\n" for i in range(5000)),
    "errors": "nsl 1\n" + "frame\n" * 5000,
    "time": GOOD.replace("1ms", "1" + "0" * 400 + "ms"),
    "small time": GOOD.replace("1ms", "0." + "0" * 400 + "1ns"),
    "exponent": GOOD.replace("1ms", "1e999999999ms"),
}


@pytest.mark.parametrize("text", TOO_MUCH.values(), ids=TOO_MUCH)
def test_programs_that_ask_for_too_much_are_refused(text: str, tmp_path: Path) -> None:
    """Each program of `TOO_MUCH` is refused by check and by build with an error, and not by a
    crash."""
    (tmp_path / "bad.nsl").write_text(text)
    refused(["check", "bad.nsl"], tmp_path)
    refused(["build", "bad.nsl", "-o", "bad.icw", "--emit", "report,asm"], tmp_path)


@pytest.mark.parametrize(
    "data",
    [b"", b"\0" * 1000, b"\xff\xfe\xff", bytes(range(256)) * 64, "nsl 1\n".encode("utf-16")],
    ids=["nothing", "zeros", "not utf-8", "every byte", "utf-16"],
)
@pytest.mark.parametrize(
    "arguments",
    [
        ["check", "bad.nsl"],
        ["build", "bad.nsl", "-o", "out.icw"],
        ["run", "bad.nsl", "--scene", "builtin:hdr", "-o", "out.npz"],
        ["run", "ok.nsl", "--scene", "bad.nsl", "-o", "out.npz"],
        ["run", "bad.icw", "--scene", "builtin:hdr", "-o", "out.npz"],
        ["run", "ok.nsl", "--scene", "bad.npz", "-o", "out.npz"],
        ["run", "ok.nsl", "--scene", "builtin:hdr", "--pixels", "bad.npz", "-o", "out.npz"],
        ["build", "ok.nsl", "--target", "bad.toml", "-o", "out.icw"],
        ["shutters", "bad.icw", "-o", "out.npz"],
        ["view", "bad.icw", "-o", "out.png"],
        ["prove", "bad.icw"],
        ["disasm", "bad.icw"],
        ["diff", "bad.icw", "bad.icw"],
    ],
    ids=" ".join,
)
def test_commands_refuse_files_of_other_content(
    data: bytes, arguments: list[str], tmp_path: Path
) -> None:
    (tmp_path / "ok.nsl").write_text(GOOD)
    for suffix in ("nsl", "icw", "npz", "toml"):
        (tmp_path / f"bad.{suffix}").write_bytes(data)
    # An empty file is valid TOML: nscc may accept it as a target, but must not fail.
    if data == b"" and "bad.toml" in arguments:
        assert invoke(arguments, tmp_path).status in (0, 1, 2)
        return
    refused(arguments, tmp_path)


@pytest.mark.parametrize(
    "arguments",
    [
        ["check", "."],
        ["check", "no/such/file.nsl"],
        ["check", "x" * 5000],
        ["check", ""],
        ["build", "ok.nsl", "-o", "."],
        ["build", "ok.nsl", "-o", "ok.nsl/ok.icw"],
        ["build", "ok.nsl", "-O", "9"],
        ["build", "ok.nsl", "--emit", "everything"],
        ["run", "ok.nsl"],
        ["run", "ok.nsl", "--scene", "builtin:no"],
        ["run", "ok.nsl", "--scene", "builtin:flat:nan"],
        ["run", "ok.nsl", "--scene", "builtin:hdr", "--exposure", "-1"],
        ["run", "ok.nsl", "--scene", "builtin:hdr", "--repeat", "0"],
        ["run", "ok.nsl", "--scene", "builtin:hdr", "--keep", "everything"],
        ["explain", "NS"],
        ["targets", "scamp99"],
        ["frobnicate"],
        [],
    ],
    ids=lambda arguments: " ".join(arguments)[:40] or "nothing",
)
def test_wrong_usage_is_refused_without_a_traceback(arguments: list[str], tmp_path: Path) -> None:
    (tmp_path / "ok.nsl").write_text(GOOD)
    refused(arguments, tmp_path)


@settings(max_examples=40)
@given(noise=st.binary(max_size=400))
def test_any_bytes_are_a_program_or_refused(
    noise: bytes, tmp_path_factory: pytest.TempPathFactory
) -> None:
    folder = fresh(tmp_path_factory)
    (folder / "bad.nsl").write_bytes(b"nsl 1\n" + noise)
    settled(["check", "bad.nsl"], folder)


VOCABULARY = """
    nsl 1 frame slots of 4 1ms code a b : .. ( ) [ ] , = == < <= + - * / % << not and or if else
    open when bucket pixels tile require let shutters book row bit true n x N 0 9999999999
"""
WORDS = st.sampled_from(VOCABULARY.split())


@settings(max_examples=60)
@given(words=st.lists(WORDS, max_size=60))
def test_any_words_are_a_program_or_refused(
    words: list[str], tmp_path_factory: pytest.TempPathFactory
) -> None:
    folder = fresh(tmp_path_factory)
    (folder / "bad.nsl").write_text("nsl 1\n" + " ".join(words))
    settled(["check", "bad.nsl"], folder)


@settings(max_examples=60)
@given(data=st.data())
def test_a_damaged_container_is_read_or_refused(
    data: st.DataObject, tmp_path_factory: pytest.TempPathFactory
) -> None:
    folder = fresh(tmp_path_factory)
    (folder / "ok.nsl").write_text(GOOD)
    assert invoke(["build", "ok.nsl", "-o", "ok.icw"], folder).status == 0
    whole = (folder / "ok.icw").read_bytes()
    place = data.draw(st.integers(0, len(whole) - 1))
    if data.draw(st.booleans()):
        damaged = whole[:place]
    else:
        flipped = whole[place] ^ data.draw(st.integers(1, 255))
        damaged = whole[:place] + bytes([flipped]) + whole[place + 1 :]
    (folder / "bad.icw").write_bytes(damaged)
    refused(["prove", "bad.icw"], folder)
    refused(["disasm", "bad.icw"], folder)


def fresh(factory: pytest.TempPathFactory) -> Path:
    """An empty folder; the one before is removed, as hundreds of examples follow each other."""
    folder = factory.getbasetemp() / "one"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    return folder


def refused(arguments: list[str], folder: Path) -> None:
    """The command must end with 1 or 2 and an error, and leave the folder as it was."""
    assert settled(arguments, folder).status in (1, 2)


def settled(arguments: list[str], folder: Path) -> Outcome:
    """Runs a command that may pass or refuse, but neither fail nor leave anything if it refuses."""
    before = {path: path.read_bytes() for path in sorted(folder.iterdir())}
    outcome = invoke(arguments, folder)
    assert outcome.status in (0, 1, 2), outcome.err
    if outcome.status:
        assert "error[NS" in outcome.err
        assert len(outcome.err) < 20_000
        assert "Traceback" not in outcome.err
        assert {path: path.read_bytes() for path in sorted(folder.iterdir())} == before
    return outcome
