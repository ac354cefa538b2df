"""Pictures of several pages or windows, clips, raw files and MATLAB 7.3: sizes before decoding."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
import tifffile
from PIL import Image

from nscc.diagnostics.diagnostic import Rejected
from nscc.npy import InvalidArrays
from nscc_runtime.scenes import pages as limits
from nscc_runtime.scenes.light_arrays import mat_array, mat_arrays
from nscc_runtime.scenes.picture_files import open_pages
from nscc_training.array_files import read_picture_or_clip, real_array

SMALL, LARGE = np.full((20, 30, 3), 100, np.uint8), np.full((30, 40, 3), 100, np.uint8)


@pytest.fixture
def bound(monkeypatch: pytest.MonkeyPatch) -> None:
    """Sets the largest permitted number of pixels to one less than LARGE has."""
    monkeypatch.setattr(limits, "MOST_PIXELS", 1199)


def refused(path: Path) -> str:
    """Checks that a picture is refused for its size (NS0734), and returns the message."""
    with pytest.raises(Rejected) as raised:
        next(open_pages(path).read())
    (diagnostic,) = raised.value.diagnostics
    assert diagnostic.code == "NS0734"
    return diagnostic.message


@pytest.mark.parametrize("dtype", [np.uint8, np.uint16])
def test_a_tiff_with_one_page_above_the_size_limit_is_refused(
    tmp_path: Path, bound: None, dtype: Any
) -> None:
    """The first page is small enough and the second has 30 x 40 pixels, above the lowered limit."""
    with tifffile.TiffWriter(tmp_path / "a.tiff") as file:
        file.write(SMALL.astype(dtype))
        file.write(LARGE.astype(dtype))
    assert "30 x 40 pixels" in refused(tmp_path / "a.tiff")


def write_exr(path: Path, count: int = 1, **header: Any) -> None:
    import OpenEXR

    given = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage, **header}
    picture = SMALL.astype(np.float32)
    parts = [OpenEXR.Part(dict(given), {"RGB": picture}, name=str(n)) for n in range(count)]
    OpenEXR.File(parts).write(str(path))


def test_an_exr_with_a_display_window_above_the_size_limit_is_refused(
    tmp_path: Path, bound: None
) -> None:
    window = (np.array([0, 0], np.int32), np.array([39, 29], np.int32))
    write_exr(tmp_path / "a.exr", displayWindow=window)
    assert "30 x 40 pixels" in refused(tmp_path / "a.exr")


def test_the_size_limit_holds_for_all_parts_of_an_exr_together(tmp_path: Path, bound: None) -> None:
    """Two parts of 20 x 30 pixels pass the lowered limit. Three have 5400 samples together and are
    refused."""
    write_exr(tmp_path / "two.exr", 2)
    assert open_pages(tmp_path / "two.exr").count == 2
    write_exr(tmp_path / "three.exr", 3)
    assert "5,400 samples" in refused(tmp_path / "three.exr")


@pytest.mark.parametrize(
    "line", [b"-Y 30 +X 40", b"+Y 30 -X 40", b"+X 40 -Y 30", b"# -Y 1 +X 1 \n-Y 30 +X 40"]
)
def test_large_radiance_files_of_every_orientation_are_refused(
    tmp_path: Path, bound: None, line: bytes
) -> None:
    """The size line may name rows or columns first, with any sign. A comment that looks like a size
    does not count."""
    head = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n"
    comment, newline, size = line.rpartition(b"\n")
    data = head + comment + newline + b"\n" + size + b"\n" + bytes(4 * 1200)
    (tmp_path / "a.hdr").write_bytes(data)
    refused(tmp_path / "a.hdr")


@pytest.mark.parametrize("ending", [".heic", ".avif", ".webp", ".png"])
def test_large_pictures_and_animations_are_refused(
    tmp_path: Path, bound: None, ending: str
) -> None:
    """A picture or animation of 30 x 40 pixels is above the lowered limit and refused with its
    size."""
    path = tmp_path / f"a{ending}"
    if ending == ".heic":
        heif = pytest.importorskip("pillow_heif")
        heif.from_pillow(Image.fromarray(LARGE)).save(path)
    else:
        first = Image.fromarray(LARGE)
        first.save(path, save_all=True, append_images=[Image.fromarray(LARGE // 2)])
    assert "30 x 40 pixels" in refused(path)


def test_raw_files_above_the_limit_are_refused(tmp_path: Path, bound: None) -> None:
    pytest.importorskip("rawpy")
    tags = [
        (50706, "B", 4, (1, 4, 0, 0), True), (50708, "s", 0, "Test", True),
        (33421, "H", 2, (2, 2), True), (33422, "B", 4, (0, 1, 1, 2), True),
    ]  # fmt: skip
    mosaic = np.full((64, 80), 1000, np.uint16)
    tifffile.imwrite(tmp_path / "a.dng", mosaic, photometric=32803, extratags=tags, metadata=None)
    assert "64 x 80 pixels" in refused(tmp_path / "a.dng")


def write_video(path: Path, picture: np.ndarray, codec: str) -> None:
    av = pytest.importorskip("av")
    with av.open(str(path), "w") as container:
        stream = container.add_stream(codec, rate=25)
        stream.height, stream.width = picture.shape[:2]
        stream.pix_fmt = "yuv420p"
        for _ in range(3):
            container.mux(stream.encode(av.VideoFrame.from_ndarray(picture, format="rgb24")))
        container.mux(stream.encode())


@pytest.mark.parametrize("codec", ["ffv1", "mpeg4"])
def test_videos_above_the_limit_are_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, codec: str
) -> None:
    write_video(tmp_path / "a.mkv", np.full((48, 64, 3), 100, np.uint8), codec)
    assert len([*open_pages(tmp_path / "a.mkv").read()]) == 3
    monkeypatch.setattr(limits, "MOST_PIXELS", 48 * 64 - 1)
    with pytest.raises(Rejected) as raised:
        open_pages(tmp_path / "a.mkv")
    (diagnostic,) = raised.value.diagnostics
    assert diagnostic.code == "NS0732"
    assert diagnostic.notes == (
        "the reader says: its frames have no size, or more than 3,071 pixels",
    )


def test_clips_to_compare_are_refused_above_the_limit_in_bytes(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Five frames are read. With a limit of three frames in bytes they are refused."""
    with tifffile.TiffWriter(tmp_path / "a.tiff") as file:
        for _ in range(5):
            file.write(SMALL[..., 0])
    assert read_picture_or_clip(tmp_path / "a.tiff").shape == (5, 20, 30)
    # Three of the five frames of 600 bytes.
    monkeypatch.setattr("nscc_training.array_files._MOST_BYTES", 3 * 600)
    with pytest.raises(Rejected, match="NS0801"):
        read_picture_or_clip(tmp_path / "a.tiff")


def test_huge_arrays_of_matlab_7_3_are_not_read(tmp_path: Path) -> None:
    h5py = pytest.importorskip("h5py")
    path = tmp_path / "a.mat"
    values = np.random.default_rng(1).random((4, 5, 6))
    with h5py.File(path, "w", userblock_size=512) as file:
        file["a"] = values.T
        file.create_dataset("packed", data=values.T, compression="gzip", shuffle=True)
        file.create_dataset("huge", (100_000, 100_000), "f8", chunks=(100, 100))
        file.create_group("struct")
    assert mat_arrays(path, ["a", "packed"]).keys() == {"a", "packed"}
    for name in ("a", "packed"):
        np.testing.assert_array_equal(mat_array(path, name), values)
        with pytest.raises(InvalidArrays, match="unpack to"):
            mat_array(path, name, 8 * 120 - 1)
    for names in (["huge"], None):
        with pytest.raises(InvalidArrays, match="76,29"):
            mat_arrays(path, names)
    with pytest.raises(ValueError, match="not an array"):
        mat_array(path, "struct")
    with pytest.raises(Rejected) as raised:
        real_array(path, "huge")
    assert "MiB are allowed" in str(raised.value.diagnostics[0].notes)


def test_a_chunk_that_unpacks_to_more_is_refused(tmp_path: Path) -> None:
    import zlib

    h5py = pytest.importorskip("h5py")
    path = tmp_path / "a.mat"
    with h5py.File(path, "w") as file:
        held = file.create_dataset("a", (8, 8), "f8", chunks=(8, 8), compression="gzip")
        held.id.write_direct_chunk((0, 0), zlib.compress(bytes(1 << 24)))
    with pytest.raises(InvalidArrays, match="unpack to"):
        mat_array(path, "a")


def test_measurements_beyond_single_precision_are_refused(tmp_path: Path) -> None:
    """A value of -1e300 in a measurement is refused: the limit is 1e15."""
    np.savez(tmp_path / "a.npz", meas=np.array([[1.0, -1e300]]))
    with pytest.raises(Rejected, match="beyond 1e\\+15"):
        real_array(tmp_path / "a.npz", "meas")


def test_npy_masks_above_the_limit_are_refused(tmp_path: Path) -> None:
    """A header that declares 100 000 x 100 000 values is refused before they are read."""
    stated = {"descr": "<f8", "fortran_order": False, "shape": (100_000, 100_000)}
    with open(tmp_path / "a.npy", "wb") as file:
        np.lib.format.write_array_header_1_0(file, stated)
    with pytest.raises(Rejected) as raised:
        real_array(tmp_path / "a.npy", "mask")
    assert "MiB are allowed" in str(raised.value.diagnostics[0].notes)
