"""The paper's figures from the runs that come with nscc."""

from __future__ import annotations

import io
from pathlib import Path

import numpy as np
import pytest
from nscc_command import invoke

torch = pytest.importorskip("torch")
Image = pytest.importorskip("PIL.Image")

from small_runs import clip, one_crop  # noqa: E402

NAMES = ["fig5_coded_frame", "fig6_frames", "fig7_shutters", "fig5_exposures", "fig5_tones"]


@pytest.mark.slow
def test_figures_are_drawn_of_given_scenes(tmp_path: Path) -> None:
    """A panorama and a clip of a folder change the pictures, but not the shutters."""
    (tmp_path / "d").mkdir()
    one_crop(tmp_path / "d/p.hdr")
    clip(tmp_path / "d/c.mat", 16, 256)
    for line in (["-o", "built-in"], ["--data", "d", "--effects", "shot,adc", "-o", "own"]):
        made = invoke(["evaluate", "figures", *line], tmp_path)
        assert made.status == 0, made.err
    same = []
    for name in NAMES:
        pair = [(tmp_path / folder / f"{name}.png").read_bytes() for folder in ("built-in", "own")]
        pictures = [np.asarray(Image.open(io.BytesIO(png)).convert("L")) for png in pair]
        assert all(picture.std() > 10 for picture in pictures)
        same.append(pair[0] == pair[1])
    assert same == [name == "fig7_shutters" for name in NAMES]


def test_a_folder_without_scenes_to_show_is_refused(tmp_path: Path) -> None:
    """An empty and a missing folder give NS0811."""
    (tmp_path / "d").mkdir()
    for folder in ("d", "nowhere"):
        made = invoke(["evaluate", "figures", "--data", folder, "-o", "f"], tmp_path)
        assert made.status == 2
        assert "NS0811" in made.err


def test_figures_refuse_unknown_effects(tmp_path: Path) -> None:
    """The effect `moonlight` gives NS0756, and no folder is written."""
    made = invoke(["evaluate", "figures", "--effects", "moonlight", "-o", "f"], tmp_path)
    assert made.status == 2
    assert "NS0756" in made.err
    assert not (tmp_path / "f").exists()
