"""Files that are no scenes: whatever their bytes, one clear error and nothing printed."""

from __future__ import annotations

import io
import os
import tempfile
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, example, given, settings
from hypothesis import strategies as st
from one_scene import load_scene

from nscc.diagnostics.diagnostic import Rejected
from nscc_runtime.scenes import ExposureLevel
from nscc_runtime.scenes.picture_files import quiet

SUFFIXES = (
    *(".npz", ".npy", ".mat", ".hdr", ".exr", ".pfm", ".png", ".jpg", ".jpeg"),
    *(".bmp", ".tif", ".tiff", ".webp", ".mp4", ".avi", ".gif"),
)
QUICK = settings(
    max_examples=25, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)


def load(data: bytes, suffix: str) -> bool:
    """Does a file of these bytes load? Anything but a scene or one error is raised."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "scene" + suffix)
        path.write_bytes(data)
        refused = None
        try:
            light = load_scene(
                str(path),
                slot_us=(10.0, 20.0),
                rows=4,
                cols=5,
                exposure=ExposureLevel(1000.0, 100.0),
            )
        except Rejected as rejected:
            refused = rejected
    if refused:
        assert refused.status == 2
        assert len(refused.diagnostics) == 1
        return False
    dense = light.dense()
    assert dense.shape == (2, 4, 5)
    assert np.isfinite(dense).all()
    assert dense.min() >= 0
    return True


@cache
def whole(suffix: str) -> bytes:
    """A small scene of the format."""
    rng = np.random.default_rng(0)
    rgb = rng.integers(0, 256, (6, 7, 3), np.uint8)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "scene" + suffix)
        if suffix in (".npz", ".npy"):
            light = rng.random((2, 4, 5), np.float32)
            np.savez(path, light=light) if suffix == ".npz" else np.save(path, light)
        elif suffix == ".mat":
            from scipy.io import savemat

            savemat(path, {"orig": rng.random((6, 7, 3))})
        elif suffix == ".exr":
            import OpenEXR

            header = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}
            OpenEXR.File(header, {"RGB": rng.random((6, 7, 3), np.float32)}).write(str(path))
        elif suffix in (".mp4", ".avi"):
            write_video(path, rng)
        elif suffix in (".hdr", ".pfm"):
            import cv2

            cv2.imwrite(str(path), rng.random((6, 7, 3), np.float32))
        else:
            from PIL import Image

            image, more = Image.fromarray(rgb), [Image.fromarray(rgb // 2)]
            image.save(
                path, **({"save_all": True, "append_images": more} if suffix == ".gif" else {})
            )
        return path.read_bytes()


def write_video(path: Path, rng: np.random.Generator) -> None:
    import cv2

    kind = cv2.VideoWriter.fourcc(*("MJPG" if path.suffix == ".avi" else "mp4v"))
    # FFmpeg takes how much it prints from who uses it first: here that is the writer.
    with quiet():
        writer = cv2.VideoWriter(str(path), kind, 25.0, (16, 16))
        for _ in range(3):
            writer.write(rng.integers(0, 256, (16, 16, 3), np.uint8))
        writer.release()


@pytest.fixture
def silent(capfd: pytest.CaptureFixture[str]) -> Iterator[None]:
    """Decoders must not print past the diagnostics."""
    capfd.readouterr()
    yield
    out, err = capfd.readouterr()
    assert out == ""
    assert err == ""


@pytest.mark.usefixtures("silent")
@pytest.mark.parametrize("suffix", SUFFIXES)
class TestBadFiles:
    """The same promises for every format."""

    def test_a_whole_file_loads(self, suffix: str) -> None:
        assert load(whole(suffix), suffix)

    @QUICK
    @given(data=st.binary(max_size=300))
    @example(data=b"")
    def test_random_bytes_load_or_are_refused(self, suffix: str, data: bytes) -> None:
        load(data, suffix)

    @QUICK
    @given(share=st.floats(0.0, 0.999))
    def test_cut_scene_files_load_or_are_refused(self, suffix: str, share: float) -> None:
        data = whole(suffix)
        load(data[: int(len(data) * share)], suffix)

    @QUICK
    @given(place=st.floats(0.0, 0.999), value=st.binary(min_size=1, max_size=16))
    def test_changed_scene_files_load_or_are_refused(
        self, suffix: str, place: float, value: bytes
    ) -> None:
        data = bytearray(whole(suffix))
        start = int(len(data) * place)
        data[start : start + len(value)] = value
        load(bytes(data), suffix)


@pytest.mark.parametrize(
    "header",
    [
        "{'descr': '<f4', 'fortran_order': False, 'shape': (2, 4, 5)}",
        "{'descr': '<f4', 'fortran_order': False, 'shape': (99999999, 99999999, 4, 5)}",
        "{'descr': '<f4', 'fortran_order': False, 'shape': (-2, 4, 5)}",
        "{'descr': '|O', 'fortran_order': False, 'shape': (2, 4, 5)}",
        "{'descr': [('a', '<f4')], 'fortran_order': False, 'shape': (2, 4, 5)}",
        "[" * 3000,
        "",
    ],
)
def test_arrays_with_false_headers_are_refused(header: str) -> None:
    text = header.encode() + b"\n"
    data = b"\x93NUMPY\x01\x00" + len(text).to_bytes(2, "little") + text
    assert not load(data, ".npy")


def test_a_large_claim_costs_no_memory() -> None:
    """A header may claim terabytes: sizes are compared before anything is allocated."""
    file = io.BytesIO()
    np.lib.format.write_array_header_1_0(
        file, {"descr": "<f8", "fortran_order": False, "shape": (10**6, 10**6)}
    )
    assert not load(file.getvalue(), ".npy")


def test_broken_links_and_pipes_are_refused_as_scenes(tmp_path: Path) -> None:
    """A folder whose only picture is a link to nothing, and a named pipe, are refused. Nobody waits
    for the pipe."""
    (tmp_path / "0.png").symlink_to(tmp_path / "gone.png")
    with pytest.raises(Rejected):
        load_scene(str(tmp_path), slot_us=(1.0,), rows=1, cols=1, exposure=ExposureLevel(1.0))
    os.mkfifo(tmp_path / "pipe.npz")
    with pytest.raises(Rejected):
        load_scene(str(tmp_path / "pipe.npz"), slot_us=(1.0,), rows=1, cols=1)
