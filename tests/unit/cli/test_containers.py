"""The commands asm, disasm, diff and targets through click."""

from __future__ import annotations

from pathlib import Path

import pytest
from click.testing import CliRunner

from nscc.chips.load import builtin_target, load_target
from nscc.diagnostics.diagnostic import Rejected
from nscc_cli import targets
from nscc_cli.containers import asm, diff, disasm

PROGRAM = ".wait 1ms x4\n.kernel k\nrespix A\n.slot 0..4 k\n.readout A frame\n"


def test_disassembled_text_assembles_to_the_same_container(tmp_path: Path) -> None:
    runner, text = CliRunner(), tmp_path / "x.asm"
    text.write_text(PROGRAM, encoding="utf-8")
    assert runner.invoke(asm, [str(text)]).exit_code == 0
    first = tmp_path / "x.icw"
    listing = runner.invoke(disasm, [str(first)])
    assert listing.exit_code == 0
    assert ".slot 0..4 k" in listing.stdout
    second = tmp_path / "y.icw"
    again = runner.invoke(asm, ["-", "-o", str(second)], input=listing.stdout)
    assert again.exit_code == 0
    assert first.read_bytes() == second.read_bytes()
    assert runner.invoke(diff, [str(first), str(second)]).stdout == "identical\n"
    text.write_text(PROGRAM.replace("x4", "x5"), encoding="utf-8")
    assert runner.invoke(asm, [str(text), "-o", str(second)]).exit_code == 0
    changed = runner.invoke(diff, [str(first), str(second)]).stdout
    assert "-.wait 1000us x4" in changed
    assert "+.wait 1000us x5" in changed


def test_asm_writes_the_published_words() -> None:
    """The two words of `AND R6, R2, R3` and of `all` are those that the chip's makers published."""
    found = CliRunner().invoke(asm, ["-", "--words"], input="AND R6, R2, R3\nall")
    assert found.stdout.split("\n")[3:] == [
        "0x80020 0x10000 0x20800 0x3b602 0x40000",
        "0x00800 0x11000 0x20000 0x32000 0x40000",
        "",
    ]


def test_a_refused_text_leaves_no_file(tmp_path: Path) -> None:
    """An unknown operation gives NS0710 and bytes that are no text NS0717. Text from stdin needs
    the name of an output."""
    text = tmp_path / "x.asm"
    text.write_text(PROGRAM + "nope R1\n", encoding="utf-8")
    with pytest.raises(Rejected, match="NS0710"):
        CliRunner().invoke(asm, [str(text)], catch_exceptions=False)
    text.write_bytes(b"\xff\xff")
    with pytest.raises(Rejected, match="NS0717"):
        CliRunner().invoke(asm, [str(text)], catch_exceptions=False)
    assert [path.name for path in tmp_path.iterdir()] == ["x.asm"]
    assert CliRunner().invoke(asm, ["-"], input=PROGRAM).exit_code == 2


def test_targets_are_listed_and_printed(tmp_path: Path) -> None:
    listed = CliRunner().invoke(targets.command).stdout
    assert [line.split()[0] for line in listed.splitlines()] == [
        "name",
        "dual-tap",
        "scamp5",
        "scamp5-algorithm1",
        "scamp7",
    ]
    details = CliRunner().invoke(targets.command, ["scamp7"]).stdout
    assert "R0..R22" in details
    assert "(not public)" in details
    (tmp_path / "t.toml").write_text(
        CliRunner().invoke(targets.command, ["scamp7", "--toml"]).stdout, encoding="utf-8"
    )
    assert load_target("t.toml", tmp_path) == builtin_target("scamp7")
