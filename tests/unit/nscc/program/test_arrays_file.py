"""Codebooks and pixels from .npz files: the right ones are read, all others are refused."""

from __future__ import annotations

import hashlib
import io
import struct
import zipfile
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from nscc_command import invoke
from program_oracle import program_of

from nscc.diagnostics.diagnostic import Diagnostic, Rejected
from nscc.program.pixel_codes import codes_from
from nscc.program.program import Program
from nscc.words.container import DecodeTable

FRAME = "nsl 1 frame 8 slots of 1ms "
PIXELS = FRAME + "code a : 0..7 code b : 0..8 open when a <= n < b "
BOOK = 'shutters book from "f.npz" '
READ = "code id : row of book open when book[id] "


def refused(text: str, base: Path) -> str:
    with pytest.raises(Rejected) as caught:
        program_of(text, base=base)
    (found,) = caught.value.diagnostics
    assert "\n" not in found.message
    return found.code


def save(folder: Path, **arrays: object) -> str:
    np.savez(folder / "f.npz", **arrays)
    return hashlib.sha256((folder / "f.npz").read_bytes()).hexdigest()


def plane(program: Program, k: int) -> np.ndarray:
    assert program.pixel_codes is not None
    return program.table.codes[program.pixel_codes][..., k]


@pytest.mark.parametrize("dtype", ["u1", "i2", ">i4", "<u8", "i8"])
def test_pixel_codes_of_any_integer_type_are_read(tmp_path: Path, dtype: str) -> None:
    """Arrays of any integer type and order in memory are read, and a digest in capitals is
    accepted."""
    values = np.random.default_rng(3).integers(0, 8, (256, 256)).astype(dtype)
    digest = save(tmp_path, a=np.asfortranarray(values), b=values + 1, other="text")
    text = PIXELS + f'pixels from "f.npz" sha256 "{digest.upper()}"'
    program = program_of(text, base=tmp_path)
    np.testing.assert_array_equal(plane(program, 0), values)
    np.testing.assert_array_equal(plane(program, 1), values + 1)


def test_statements_of_pixels_take_precedence_over_the_file(tmp_path: Path) -> None:
    """The file's values of `a` are out of range, but `pixels a` replaces them. `b` comes from the
    file."""
    save(tmp_path, a=np.full((256, 256), 99), b=np.full((256, 256), 5))
    program = program_of(PIXELS + 'pixels a = x % 5 pixels from "f.npz"', base=tmp_path)
    assert (plane(program, 1) == 5).all()
    assert plane(program, 0).max() == 4


@pytest.mark.parametrize(
    ("code", "array"),
    [
        ("NS0314", np.zeros((256, 256))),
        ("NS0314", np.zeros((256, 256), bool)),
        ("NS0314", np.zeros((256, 255), int)),
        ("NS0314", np.zeros((1, 256, 256), int)),
        ("NS0314", np.zeros((2000, 2000), int)),
        ("NS0314", np.array(3)),
        ("NS0314", np.array([object()], dtype=object)),
        ("NS0314", np.array("text")),
        ("NS0311", np.full((256, 256), 8)),
        ("NS0311", np.full((256, 256), -1, "i1")),
        ("NS0311", np.full((256, 256), 2**64 - 1, "u8")),
    ],
)
def test_arrays_of_wrong_type_shape_or_range_are_refused_as_pixels(
    tmp_path: Path, code: str, array: np.ndarray
) -> None:
    save(tmp_path, a=array, b=np.zeros((256, 256), int))
    assert refused(PIXELS + 'pixels from "f.npz"', tmp_path) == code


def test_a_missing_array_is_named(tmp_path: Path) -> None:
    """The file has `A` in place of `a`: the message names `a`, proposes `A` and lists what the file
    has."""
    save(tmp_path, A=np.zeros((256, 256), int), b=np.zeros((256, 256), int))
    with pytest.raises(Rejected) as caught:
        program_of(PIXELS + 'pixels from "f.npz"', base=tmp_path)
    (found,) = caught.value.diagnostics
    assert "`a`" in found.message
    assert found.helps == ("did you mean `A`?",)
    assert found.notes == ("the file has `A`, `b`",)


@pytest.mark.parametrize("digest", ["0" * 64, "", "12", "x" * 64])
def test_a_file_with_another_digest_is_refused(tmp_path: Path, digest: str) -> None:
    """A wrong, empty or short digest, and one that is no hexadecimal number, give NS0315."""
    save(tmp_path, a=np.zeros((256, 256), int), b=np.zeros((256, 256), int))
    assert refused(PIXELS + f'pixels from "f.npz" sha256 "{digest}"', tmp_path) == "NS0315"


def _npz(header: str, body: bytes = b"") -> bytes:
    text = header.encode("latin-1") + b"\n"
    data = b"\x93NUMPY\x01\x00" + struct.pack("<H", len(text)) + text + body
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("a.npy", data)
    return stream.getvalue()


BROKEN = {
    "empty": b"",
    "text": b"hello, world",
    "npy": b"\x93NUMPY\x01\x00",
    "zip of nothing": b"PK\x05\x06" + bytes(18),
    "no npy": _npz("garbage"),
    "negative": _npz("{'descr': '<i8', 'fortran_order': False, 'shape': (-1, 256)}", bytes(99)),
    "short": _npz("{'descr': '<i8', 'fortran_order': False, 'shape': (256, 256)}", bytes(99)),
    "huge": _npz("{'descr': '<i8', 'fortran_order': False, 'shape': (99999999999, 99999)}"),
    "bomb": _npz("{'descr': '<i8', 'fortran_order': False, 'shape': (256, 256)}", bytes(2**25)),
    "code": _npz("{'descr': __import__('os').abort(), 'shape': (256, 256)}"),
    "pickle": _npz("{'descr': '|O', 'fortran_order': False, 'shape': (256, 256)}", b"cos\nabort\n"),
    "subarray": _npz("{'descr': ('<i4', (4,)), 'fortran_order': False, 'shape': (256, 256)}"),
    "fields": _npz("{'descr': [('a', '<i4')], 'fortran_order': False, 'shape': (256, 256)}"),
}


@pytest.mark.parametrize("name", BROKEN)
def test_broken_files_are_refused(tmp_path: Path, name: str) -> None:
    """Each damaged file of `BROKEN` gives NS0313 or NS0314."""
    (tmp_path / "f.npz").write_bytes(BROKEN[name])
    assert refused(PIXELS + 'pixels b = 3 pixels from "f.npz"', tmp_path) in {"NS0313", "NS0314"}


@pytest.mark.parametrize("path", ["", ".", "no/such.npz", "a" * 5000])
def test_paths_without_a_readable_file_are_refused_as_pixels(tmp_path: Path, path: str) -> None:
    """An empty path, a folder, a missing file and a name that is too long give NS0313."""
    assert refused(PIXELS + f'pixels from "{path}"', tmp_path) == "NS0313"


@pytest.mark.parametrize("dtype", ["u1", "bool", "i8"])
@pytest.mark.parametrize(
    ("keys", "statement"),
    [
        (["book"], BOOK),
        (["only"], BOOK),
        (["other", "book"], BOOK),
        (["other", "mine"], 'shutters book from "f.npz" key mine '),
    ],
)
def test_codebooks_of_any_integer_type_are_read(
    tmp_path: Path, dtype: str, keys: list[str], statement: str
) -> None:
    rows = np.random.default_rng(5).integers(0, 2, (6, 8)).astype(dtype)
    arrays = {key: np.zeros((3, 3)) for key in keys}
    save(tmp_path, **{**arrays, keys[-1]: rows})
    program = program_of(FRAME + statement + READ, base=tmp_path)
    np.testing.assert_array_equal(
        program.table.shutters[program.table.shutter_of_code][:, 0], rows.astype(bool)
    )


@pytest.mark.parametrize(
    ("code", "rows"),
    [
        ("NS0310", np.full((2, 8), 2, "u1")),
        ("NS0314", np.zeros((2, 7), "u1")),
        ("NS0314", np.zeros((0, 8), "u1")),
        ("NS0314", np.zeros(8, "u1")),
        ("NS0314", np.zeros((2, 8))),
    ],
)
def test_arrays_of_wrong_type_shape_or_values_are_refused_as_codebooks(
    tmp_path: Path, code: str, rows: np.ndarray
) -> None:
    save(tmp_path, book=rows)
    assert refused(FRAME + BOOK + READ, tmp_path) == code


def test_codes_of_a_file_are_found_in_a_compiled_table(tmp_path: Path) -> None:
    """Two arrays of field values are found as int32 numbers of rows in the table of 5 x 7
    pixels."""
    text = "code a : -3..7 code b : 0..8 require a < b open when a <= n < b"
    table = program_of(FRAME + text).table
    rng = np.random.default_rng(1)
    wanted = rng.integers(0, len(table.codes), (5, 7))
    save(tmp_path, a=table.codes[wanted][..., 0], b=table.codes[wanted][..., 1])
    found = codes_from(tmp_path / "f.npz", table, 5, 7)
    assert found.dtype == np.int32
    np.testing.assert_array_equal(found, wanted)


def outside_of(folder: Path, table: DecodeTable, **known: Any) -> Diagnostic:
    with pytest.raises(Rejected) as caught:
        codes_from(folder / "f.npz", table, 4, 6, shown="f.npz", **known)
    (found,) = caught.value.diagnostics
    assert not any("--codes open" in each for each in found.helps)
    return found


def test_values_beyond_the_ranges_of_a_program_are_refused(tmp_path: Path) -> None:
    """The container knows its codes; its fields are in the source that it carries."""
    text = "nsl 1\nframe 8 slots of 1ms\nlet top = 7\ncode stop : 1..top + 1\nopen when n < stop\n"
    (tmp_path / "p.nsl").write_text(text + "pixels stop = 4\n")
    assert invoke(["build", "p.nsl", "-o", "p.icw"], tmp_path).status == 0
    for value, code in ((9, "NS0311"), (3, "NS0319")):
        save(tmp_path, stop=np.full((256, 256), value))
        for program in ("p.nsl", "p.icw"):
            found = invoke(
                ["run", program, "--scene", "builtin:dark", "--pixels", "f.npz"], tmp_path
            )
            assert (found.status, found.codes) == (2, [code])
            assert ("1..8" in found.err) == (code == "NS0311")


def test_a_code_that_was_not_compiled_is_refused(tmp_path: Path) -> None:
    table = program_of(FRAME + "code a : 0..7 open when n < a pixels a = 2 + 2 * (x % 3)").table
    codes = np.full((4, 6), 4)
    codes[2, 5] = 5
    codes[3, :2] = 900
    save(tmp_path, a=codes)
    with pytest.raises(Rejected) as caught:
        codes_from(tmp_path / "f.npz", table, 4, 6, shown="f.npz")
    (found,) = caught.value.diagnostics
    assert found.code == "NS0319"
    assert "x = 5, y = 2 (row 2, column 5) has a = 5" in found.message
    assert found.data["pixels"] == 3
    assert "--codes open" in found.helps[0]
    # What no way of compiling would help is not said to be helped by one.
    assert outside_of(tmp_path, table, ranges=lambda: {"a": (0, 7)}).code == "NS0311"
    assert outside_of(tmp_path, table, mode="open").code == "NS0312"
    with pytest.raises(Rejected, match="NS0314"):
        codes_from(tmp_path / "f.npz", table, 6, 4)
    with pytest.raises(Rejected, match="NS0313"):
        codes_from(tmp_path / "g.npz", table, 4, 6)
