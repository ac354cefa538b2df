"""`nscc reconstruct` where torch is missing: by merging, by GAP-TV, and what it says."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest
from nscc_command import invoke

STILL = "nsl 1\nframe 8 slots of 1ms\ncode stop : 1..8\nopen when n < stop\npixels stop = {}\n"
FILM = "nsl 1\nframe 8 slots of 1ms\ncode b : bit[8]\nopen when b[n]\npixels b = {}\n"


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with a frame of a still and of a clip, and no torch from then on."""
    programs = {
        "still": STILL.format("1 if (x + y) % 2 == 1 else 8"),
        "clip": FILM.format("(37 * x + 91 * y) % 255 + 1"),
    }
    for name, text in programs.items():
        (tmp_path / f"{name}.nsl").write_text(text)
        scene = "builtin:hdr" if name == "still" else "builtin:motion"
        command = ["run", f"{name}.nsl", "--scene", scene, "--exposure", "60000", "-O", "1",
                   "--keep", "truth", "-o", f"{name}.npz"]  # fmt: skip
        assert invoke(command, tmp_path).status == 0
    monkeypatch.setitem(sys.modules, "torch", None)
    monkeypatch.setattr("nscc_training.reconstruct_any.find_spec", lambda _name: None)
    return tmp_path


@pytest.mark.parametrize(
    ("name", "key", "method", "least_db"),
    [("still", "image", "merge", 25), ("clip", "video", "gap-tv", 20)],
)
def test_any_decodes_stills_without_torch(
    folder: Path, name: str, key: str, method: str, least_db: float
) -> None:
    outcome = invoke(["reconstruct", "any", f"{name}.npz", "-o", "out.npz"], folder)
    assert outcome.status == 0, outcome.err
    assert f"method {method}" in outcome.err
    with np.load(folder / "out.npz") as made, np.load(folder / f"{name}.npz") as frame:
        assert str(made["method"]) == method
        light, truth = made[key], frame["truth_e"]
    assert light.shape == truth.shape
    white = np.quantile(truth, 0.99)
    error = np.clip(light, 0, white) - np.clip(truth, 0, white)
    assert -10 * np.log10(np.mean((error / white) ** 2)) > least_db
    named = invoke(
        ["reconstruct", "any", f"{name}.npz", "--method", method, "-o", "named.npz"], folder
    )
    assert "without torch" not in named.err
    assert (folder / "named.npz").read_bytes() == (folder / "out.npz").read_bytes()


def test_methods_refuse_the_wrong_kind_of_result(folder: Path) -> None:
    """`merge` with `video`, and `gap-tv` with `image`, have status 2. So has a method beside a
    run."""
    for arguments in (
        ["--method", "merge", "--as", "video"],
        ["--method", "gap-tv", "--as", "image"],
    ):
        outcome = invoke(["reconstruct", "any", "still.npz", "-o", "out.npz", *arguments], folder)
        assert outcome.status == 2
        assert "merge makes pictures, gap-tv clips" in outcome.err
    outcome = invoke(
        ["reconstruct", "hdr", "still.npz", "-o", "o.npz", "--method", "merge"], folder
    )
    assert outcome.status == 2


@pytest.mark.parametrize("run", ["any", "hdr"])
def test_a_missing_frame_comes_before_a_missing_extra(folder: Path, run: str) -> None:
    """A missing file is named, and torch is not. With the file there, torch is."""
    outcome = invoke(["reconstruct", run, "nowhere.npz", "-o", "out.npz"], folder)
    assert outcome.status == 2
    assert "the file does not exist" in outcome.err
    assert "torch" not in outcome.err
    assert "'torch'" in invoke(["reconstruct", "hdr", "still.npz", "-o", "out.npz"], folder).err


def test_products_make_their_folders(folder: Path) -> None:
    """Two products in folders that do not exist are written into them."""
    command = ["reconstruct", "any", "still.npz", "-o", "new/deep/out.npz", "--png", "other/p.png"]
    assert invoke(command, folder).status == 0
    assert (folder / "new/deep/out.npz").is_file()
    assert (folder / "other/p.png").is_file()
