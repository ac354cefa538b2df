"""Every reader checks the size that a file states, or stops reading, before memory is taken."""

from __future__ import annotations

import zlib
from collections.abc import Callable
from pathlib import Path
from struct import pack
from zipfile import ZIP_DEFLATED, ZipFile

import cv2
import numpy as np
import pytest
from nscc_command import RunNscc

from nscc.diagnostics.diagnostic import Rejected
from nscc.files import file_sha256, read_whole
from nscc.npy import InvalidArrays, npz_arrays
from nscc_runtime.scenes import pages as limits
from nscc_runtime.scenes.light_arrays import mat_arrays
from nscc_runtime.scenes.picture_files import read_picture
from nscc_training.array_files import read_picture_or_clip
from nscc_training.codes_files import load_codes

HUGE = (100_000, 100_000)


def huge_npz(path: Path, *names: str, header: bytes = b"") -> Path:
    """An .npz file whose arrays state 80 GB each, and have no data behind their headers."""
    with ZipFile(path, "w", ZIP_DEFLATED) as archive:
        for name in names:
            with archive.open(f"{name}.npy", "w") as entry:
                if header:
                    entry.write(header)
                    continue
                stated = {"descr": "<f8", "fortran_order": False, "shape": HUGE}
                np.lib.format.write_array_header_1_0(entry, stated)
    return path


def test_arrays_are_read_as_numpy_wrote_them(tmp_path: Path) -> None:
    """Arrays of floats in rows, whole numbers in columns, text, no values, bits and big-endian keep
    values and dtype. A chosen name is read alone."""
    rng = np.random.default_rng(1)
    saved = {
        "a": rng.random((3, 4)), "b": np.asfortranarray(rng.integers(0, 9, (2, 3))),
        "text": np.array("abc"), "none": np.zeros((0, 3)), "bits": rng.random(5) < 0.5,
        "big": np.arange(3, dtype=">i4"),
    }  # fmt: skip
    np.savez_compressed(tmp_path / "a.npz", **saved)
    arrays, names = npz_arrays(tmp_path / "a.npz")
    assert names == [*saved]
    for name, values in saved.items():
        np.testing.assert_array_equal(arrays[name], values)
        assert arrays[name].dtype == values.dtype
    assert [*npz_arrays(tmp_path / "a.npz", "b".__eq__)[0]] == ["b"]


def test_a_size_is_refused_before_it_is_unpacked(tmp_path: Path) -> None:
    """The header declares 76 GiB: it is refused. The bound is for all arrays of a file together."""
    path = huge_npz(tmp_path / "a.npz", "image")
    with pytest.raises(InvalidArrays, match="unpack to 76,294 MiB, but at most 1,024 MiB"):
        npz_arrays(path)
    np.savez(tmp_path / "b.npz", a=np.zeros(700), b=np.zeros(700))
    with pytest.raises(InvalidArrays, match="unpack to"):  # together, not one by one
        npz_arrays(tmp_path / "b.npz", most_bytes=8 * 1000)


def test_a_header_without_end_is_refused(tmp_path: Path) -> None:
    header = b"\x93NUMPY\x02\x00" + pack("<I", 0xFFFF_FFF0) + b" " * 1000
    with pytest.raises(InvalidArrays, match="header of an array is longer"):
        npz_arrays(huge_npz(tmp_path / "a.npz", "a", header=header))


def test_python_objects_are_refused(tmp_path: Path) -> None:
    np.savez(tmp_path / "a.npz", a=np.array([{}], object))
    with pytest.raises(InvalidArrays, match="Python objects"):
        npz_arrays(tmp_path / "a.npz")


@pytest.mark.parametrize(
    "line",
    [
        "metrics a.npz a.npz --data-range 1",
        "view a.npz -o out.png",
        "reconstruct any a.npz -o out.npz",
        "reconstruct hdr a.npz -o out.npz",
        "reconstruct a.npz -o out.npz",
        "run a.nsl --scene a.npz -o out.npz",
        "calibrate --flat a.npz@1ms --dark a.npz@1ms -o out.toml",
    ],
)
def test_commands_refuse_huge_arrays(tmp_path: Path, run_nscc: RunNscc, line: str) -> None:
    huge_npz(tmp_path / "a.npz", "image", "frame", "meta", "light", "light_e_per_s")
    (tmp_path / "a.nsl").write_text("nsl 1\nframe 4 slots of 1ms\nopen when n < 2\n")
    outcome = run_nscc(line.split(), tmp_path)
    assert outcome.status in (1, 2)
    assert outcome.err.startswith("error[NS")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.npz", "a.nsl"]


def test_a_plan_without_end_is_refused(tmp_path: Path, run_nscc: RunNscc) -> None:
    """`--plan /dev/zero` ends with NS0747 after 64 MiB."""
    (tmp_path / "a.nsl").write_text("nsl 1\nframe 4 slots of 1ms\nopen when n < 2\n")
    line = "run a.nsl --scene builtin:flat:100 --plan /dev/zero -o out.npz"
    outcome = run_nscc(line.split(), tmp_path)
    assert outcome.codes == ["NS0747"]
    assert "more than 64 MiB" in outcome.err


def test_a_file_is_read_to_its_bound(tmp_path: Path) -> None:
    """A file of 100 bytes is read with a bound of 100 and refused with one of 99. Its digest is the
    known SHA-256."""
    path = tmp_path / "a"
    path.write_bytes(b"x" * 100)
    assert read_whole(path, 100) == b"x" * 100
    assert file_sha256(path) == "09ecb6ebc8bcefc733f6f2ec44f791abeed6a99edf0cc31519637898aebd52d8"
    with pytest.raises(ValueError, match="more than"):
        read_whole(path, 99)


def mat_file(data: bytes, stated: int | None = None) -> bytes:
    """A version 5 file with one compressed element."""
    head = b"MATLAB 5.0 MAT-file".ljust(124) + pack("<H", 0x0100) + b"IM"
    packed = zlib.compress(data)
    return head + pack("<II", 15, len(packed) if stated is None else stated) + packed


def test_mat_files_are_read_as_scipy_wrote_them(tmp_path: Path) -> None:
    """Two arrays come back equal, compressed or not. With a bound of 1000 bytes the file is
    refused."""
    from scipy.io import savemat

    saved = {"a": np.random.default_rng(2).random((5, 6, 7)), "b": np.arange(4)[None]}
    for compressed in (False, True):
        savemat(tmp_path / "a.mat", saved, do_compression=compressed)
        arrays = mat_arrays(tmp_path / "a.mat")
        assert arrays.keys() == saved.keys()
        for name, values in saved.items():
            np.testing.assert_array_equal(arrays[name], values)
        with pytest.raises(InvalidArrays):
            mat_arrays(tmp_path / "a.mat", most_bytes=1000)


def test_an_element_larger_than_its_array_is_refused(tmp_path: Path) -> None:
    """The header of the array says 1 x 1, the bytes behind it are 8 MB."""
    name = pack("<HHI", 1, 1, ord("a"))
    array = pack("<IIII", 6, 8, 6, 0) + pack("<IIii", 5, 8, 1, 1) + name
    values = pack("<II", 9, 8_000_000) + bytes(8_000_000)
    data = pack("<II", 14, len(array) + len(values)) + array + values
    (tmp_path / "a.mat").write_bytes(mat_file(data))
    with pytest.raises(InvalidArrays, match="unpack to"):
        mat_arrays(tmp_path / "a.mat", most_bytes=1 << 20)


@pytest.mark.parametrize("read", [load_codes, read_picture_or_clip])
@pytest.mark.parametrize("ending", [".npz", ".mat"])
def test_readers_of_training_refuse_huge_arrays(
    tmp_path: Path, read: Callable[[Path], object], ending: str
) -> None:
    """An `.npz` or `.mat` file that declares a huge array is refused by the codes reader and the
    picture reader, with the allowed MiB."""
    path = huge_npz(tmp_path / "a.npz", "image")
    if ending == ".mat":
        path = tmp_path / "a.mat"
        name = pack("<HHI", 1, 1, ord("a"))
        array = pack("<IIII", 6, 8, 6, 0) + pack("<IIii", 5, 8, *HUGE) + name
        path.write_bytes(mat_file(pack("<II", 14, len(array) + 8) + array + pack("<II", 9, 0)))
    with pytest.raises(Rejected) as raised:
        read(path)
    assert "MiB are allowed" in str(raised.value.diagnostics[0].notes)


@pytest.mark.parametrize("ending", [".png", ".tiff", ".bmp", ".jpg", ".hdr", ".pfm", ".exr"])
def test_huge_pictures_are_refused_by_their_header(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, ending: str
) -> None:
    path = tmp_path / f"a{ending}"
    picture = np.full((30, 40, 3), 100, np.uint8)
    if ending == ".exr":
        import OpenEXR

        header = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}
        with OpenEXR.File(header, {"RGB": picture.astype(np.float32)}) as file:
            file.write(str(path))
    else:
        cv2.imwrite(
            str(path), picture.astype(np.float32) if ending in (".hdr", ".pfm") else picture
        )
    assert read_picture(path).shape[:2] == (30, 40)
    # One less than 30 x 40.
    monkeypatch.setattr(limits, "MOST_PIXELS", 1199)
    with pytest.raises(Rejected) as raised:
        read_picture(path)
    (diagnostic,) = raised.value.diagnostics
    assert diagnostic.code == "NS0734"
    assert "30 x 40 pixels, but at most 1,199 are allowed" in diagnostic.message


def test_a_picture_of_900_million_pixels_takes_no_memory(tmp_path: Path) -> None:
    """Only the header of a PNG file is there."""
    chunk = b"IHDR" + pack(">IIBBBBB", 30_000, 30_000, 8, 2, 0, 0, 0)
    whole = b"\x89PNG\r\n\x1a\n" + pack(">I", 13) + chunk + pack(">I", zlib.crc32(chunk))
    (tmp_path / "a.png").write_bytes(
        whole + pack(">I", 0) + b"IDAT" + pack(">I", zlib.crc32(b"IDAT"))
    )
    with pytest.raises(Rejected) as raised:
        read_picture(tmp_path / "a.png")
    assert [each.code for each in raised.value.diagnostics] == ["NS0734"]
