"""`nscc run --like RUN`: frames as a run's decoder knows them, of the run's own chip and slots."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from nscc_command import invoke
from training_oracle import small_target

pytest.importorskip("torch")

SCENE = ["--scene", "builtin:motion"]


def run_folder(folder: Path, slot_us: str, target: str = "scamp5") -> Path:
    """What of a run's folder says how its frames are made."""
    (folder / "r").mkdir()
    (folder / "r/config.resolved.toml").write_text(
        f'[shutter]\nclass = "b"\nslots = 4\nslot_us = {slot_us}\ntarget = "{target}"\n'
        '[data]\nprotocol = "video-v1"\n'
    )
    rounded = f"{float(slot_us):.6f}"
    (folder / "r/shutter.nsl").write_text(
        f"nsl 1\nframe 4 slots of {rounded}us\ncode stop : 1..N\nopen when n < stop\n"
        "pixels stop = tile [[1, 4]]\n"
    )
    return folder / "r"


@pytest.mark.parametrize("slot_us", ["333.33333333333", "100.0000005", "1000.123456789"])
def test_slot_times_rounded_in_the_text_match_those_of_the_run_and_others_are_refused(
    slot_us: str, tmp_path: Path
) -> None:
    run_folder(tmp_path, slot_us)
    done = invoke(["run", "--like", "r", *SCENE, "-o", "f.npz"], tmp_path)
    assert done.status == 0, done.err
    near = f"{float(slot_us) + 2e-6:.6f}us"
    text = (tmp_path / "r/shutter.nsl").read_text().replace(f"{float(slot_us):.6f}us", near)
    (tmp_path / "near.nsl").write_text(text)
    done = invoke(["run", "near.nsl", "--like", "r", *SCENE, "-o", "g.npz"], tmp_path)
    assert (done.status, done.codes) == (2, ["NS0821"])


def test_a_container_runs_on_its_own_target_and_text_on_that_of_the_run(tmp_path: Path) -> None:
    """The target of a run is for text only, because the words of a container are compiled
    already."""
    text = invoke(["targets", "scamp5", "--toml"], tmp_path).out
    run = run_folder(tmp_path, "125", "mine.toml")
    (run / "target.toml").write_text(small_target(text, 64, 48))
    own = ["--target", "r/target.toml"]
    assert invoke(["build", "r/shutter.nsl", *own, "-o", "s.icw"], tmp_path).status == 0
    frames = []
    for program in (["s.icw"], ["r/shutter.nsl"], []):
        done = invoke(["run", *program, "--like", "r", *SCENE, "-o", "f.npz"], tmp_path)
        assert done.status == 0, done.err
        frames.append(np.load(tmp_path / "f.npz")["frame"])
    assert frames[0].shape == (1, 64, 48)
    assert all(np.array_equal(frames[0], each) for each in frames)
    given = invoke(["run", "s.icw", "--like", "r", *SCENE, *own, "-o", "f.npz"], tmp_path)
    assert given.codes == ["NS0743"]
