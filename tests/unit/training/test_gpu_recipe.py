"""The recipe for a GPU: five steps of each of its runs, on the CPU and on few, small scenes."""

from __future__ import annotations

import json
from pathlib import Path

import cv2
import numpy as np
import pytest
from checkout import ROOT
from nscc_command import invoke

torch = pytest.importorskip("torch")

from nscc_training.any_code import lessons  # noqa: E402
from nscc_training.settings import settings_of  # noqa: E402

RECIPE = ROOT / "training/grids/gpu.toml"


def pictures(folder: Path) -> None:
    """Write photographs and panoramas as the recipe names them."""
    draw = np.random.default_rng(1)
    for place in ("photos/a", "panoramas"):
        (folder / "data" / place).mkdir(parents=True)
    for number in range(2):
        coarse = draw.integers(0, 255, (40, 40), np.uint8)
        cv2.imwrite(str(folder / f"data/photos/a/{number}.png"), cv2.resize(coarse, (320, 320)))
    for number in range(5):
        light = np.exp(draw.uniform(-4, 4, (64, 128))).astype(np.float32)
        panorama = np.repeat(cv2.resize(light, (1024, 512))[..., None], 3, axis=2)
        cv2.imwrite(str(folder / f"data/panoramas/{number}.hdr"), panorama)


def test_a_quarter_of_the_clips_stands_still_and_some_codes_are_the_searched_one() -> None:
    chosen = {"name": "any", "lessons": "codes", "still": 0.25, "searched": 0.5, "films": 1.0}
    settings = settings_of(
        {
            "decoder": chosen,
            "shutter": {"learn": False},
            "data": {"patch": 32},
            "train": {"batch": 4},
        }
    )
    picture = np.random.default_rng(2).integers(0, 255, (200, 200), np.uint8)
    drawn = [lessons.LessonSet([picture], settings)[step] for step in range(60)]
    still = [bool((clip == clip[:1]).all()) for lesson in drawn for clip in lesson.light]
    assert 0.15 < np.mean(still) < 0.4  # clips whose layers all stand still count, too
    tile = lessons._searched_tile()
    opened = {mask.sum() for lesson in drawn for mask in lesson.mask.numpy()}
    long = [lesson for lesson in drawn if lesson.light.shape[1] == lessons.SEARCHED_SLOTS]
    searched = [lesson for lesson in long if float(lesson.mask[0].sum()) == 16 * tile.sum()]
    assert 0.25 < len(searched) / len(long) < 0.75
    assert len(opened) > 5


@pytest.mark.slow
def test_each_run_of_the_recipe_takes_five_steps(tmp_path: Path) -> None:
    pictures(tmp_path)
    text = RECIPE.read_text().replace('"cuda"', '"cpu"')
    text = text.replace("data.patch = 128", "data.patch = 32")  # of clips: minutes, otherwise
    for key, value in {"steps": 5, "batch": 1, "validate_every": 5, "workers": 0}.items():
        text = changed(text, f"train.{key}", value)
    for key, value in {"data.val_items": 1, "data.together": 1}.items():
        text = changed(text, key, value)
    (tmp_path / "gpu.toml").write_text(text)
    outcome = invoke(["sweep", "gpu.toml", "--out", "out", "--workers", "0"], tmp_path)
    assert outcome.status == 0, outcome.err
    assert ", 0 with a message" in outcome.out + outcome.err
    for name, least in (("gpu/clip/codes", 5e6), ("gpu/still/unet2d", 3e7)):
        result = json.loads((tmp_path / "out/runs" / name / "result.json").read_text())
        assert least < result["parameters"] < 2 * least


def changed(text: str, key: str, value: int) -> str:
    """Return a grid with another value of a key wherever it is set."""
    lines = [
        f"{key} = {value}" if line.split(" = ")[0] == key else line for line in text.splitlines()
    ]
    return "\n".join(lines) + "\n"
