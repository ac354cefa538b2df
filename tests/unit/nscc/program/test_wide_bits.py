"""Bit fields of any length: more bits than a number has are kept as several numbers."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import nscc
from nscc.chips.load import load_target
from nscc.diagnostics.diagnostic import Rejected

ROWS, COLS = 5, 9
STREAM = replace(load_target("dual-tap", Path()), rows=ROWS, cols=COLS, name="small")
SCAMP = replace(load_target("scamp5", Path()), rows=ROWS, cols=COLS, name="scamp")


def text(count: int, rule: str = "bits[n]", pixels: str = 'pixels from "bits.npz"') -> str:
    return (
        f"nsl 1\nframe {count} slots of 1ms\ncode bits : bit[{count}]\nopen when {rule}\n{pixels}\n"
    )


@pytest.mark.parametrize("count", [1, 61, 62, 63, 100, 124, 125, 300])
def test_every_bit_of_every_pixel_is_a_slot(count: int, tmp_path: Path) -> None:
    bits = np.random.default_rng(count).integers(0, 2, (ROWS, COLS, count)).astype(np.uint8)
    np.savez(tmp_path / "bits.npz", bits=bits)
    for rule, wanted in (("bits[n]", bits), ("bits[N - 1 - n]", bits[:, :, ::-1])):
        program = nscc.compile(text(count, rule), target=STREAM, folder=tmp_path)
        found = program.shutters(pixels=True)[0].transpose(1, 2, 0)
        assert np.array_equal(found, wanted == 1)
    program.save(tmp_path / "p.icw")
    again = nscc.load(tmp_path / "p.icw")
    turned = bits[::-1, ::-1]
    if count > 62:
        moved = again.with_pixels(bits=turned).shutters(pixels=True)[0]
        assert np.array_equal(moved.transpose(1, 2, 0), turned[:, :, ::-1] == 1)


def test_registers_hold_only_codes_in_use(tmp_path: Path) -> None:
    """Of 100 bits a pixel only four patterns occur, and the program has just these shutters."""
    few = np.random.default_rng(0).integers(0, 2, (4, 100))
    np.savez(tmp_path / "bits.npz", bits=few[np.arange(ROWS * COLS).reshape(ROWS, COLS) % 4])
    program = nscc.compile(text(100), target=SCAMP, folder=tmp_path)
    assert np.array_equal(np.unique(program.shutters()[0], axis=0), np.unique(few == 1, axis=0))


def test_numbers_give_the_lowest_bits() -> None:
    """The number 5 sets bits 0 and 2 of 70, and 13 bit 3 too."""
    program = nscc.compile(text(70, pixels="pixels bits = 5 + 8 * (x % 2)"), target=STREAM)
    found = program.shutters(pixels=True)[0]
    assert np.flatnonzero(found[:, 0, 0]).tolist() == [0, 2]
    assert np.flatnonzero(found[:, 0, 1]).tolist() == [0, 2, 3]


@pytest.mark.parametrize("count", [63, 100])
@pytest.mark.parametrize("value", [2**62, 2**62 + 5, 2**63 - 1, -1, np.uint64(2**63 + 1)], ids=str)
def test_numbers_of_a_file_are_the_lowest_bits_or_refused(
    count: int, value: int, tmp_path: Path
) -> None:
    """A number gives the lowest 62 bits of a field. Larger and negative numbers are refused."""
    numbers = np.full((ROWS, COLS), 2**62 - 1, np.asarray(value).dtype)
    np.savez(tmp_path / "bits.npz", bits=numbers)
    found = nscc.compile(text(count), target=STREAM, folder=tmp_path).shutters(pixels=True)
    # 2^62 - 1 has 62 ones.
    assert found[0].sum(axis=0).tolist() == [[62] * COLS] * ROWS
    numbers[3, 4] = value
    np.savez(tmp_path / "bits.npz", bits=numbers)
    with pytest.raises(Rejected, match=r"NS0311.* x = 4, y = 3") as caught:
        nscc.compile(text(count), target=STREAM, folder=tmp_path)
    assert caught.value.diagnostics[0].data["pixels"] == 1


@pytest.mark.parametrize(
    ("program", "code"),
    [
        (text(70, "bits > 3", "pixels bits = 5"), "NS0513"),
        (text(70, "bits[70]", "pixels bits = 5"), "NS0303"),
        (text(70, pixels="pixels bits = -1"), "NS0311"),
        (text(70, pixels=""), "NS0450"),
        (text(20000, pixels=""), "NS0450"),
        (text(70, pixels='pixels from "bits.npz"'), "NS0314"),
    ],
)
def test_invalid_uses_of_wide_bit_fields_are_refused(
    program: str, code: str, tmp_path: Path
) -> None:
    np.savez(tmp_path / "bits.npz", bits=np.zeros((ROWS, COLS, 69), np.uint8))
    with pytest.raises(Rejected) as caught:
        nscc.compile(program, target=STREAM, folder=tmp_path)
    (wrong,) = caught.value.diagnostics
    assert wrong.code == code
    # A message does not repeat a number of thousands of bits.
    assert len(wrong.message) < 250


def test_bits_are_0_and_1(tmp_path: Path) -> None:
    np.savez(tmp_path / "bits.npz", bits=np.full((ROWS, COLS, 70), 2))
    with pytest.raises(Rejected, match="other than 0 and 1"):
        nscc.compile(text(70), target=STREAM, folder=tmp_path)
