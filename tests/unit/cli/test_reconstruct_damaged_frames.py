"""`nscc reconstruct`: frame files that are damaged, and dark frames that are not."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from nscc_command import invoke

pytest.importorskip("torch")

from small_runs import trained

HALF = {"effects": [{"name": "shot"}]}


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A run `r` with a frame `f` and dark ones: `d`, `lit`, and `other`, of another program."""
    folder = tmp_path_factory.mktemp("dark")
    trained(folder / "r", shutter={"slots": 4, "tile": [2, 2]})
    (folder / "other.nsl").write_text("nsl 1\nframe 4 slots of 125us\nopen when n < 2\n")
    np.save(folder / "zeros.npy", np.zeros((4, 256, 256), np.float32))
    night = ["--scene", "builtin:dark"]
    for name, words in {
        "f": ["--like", "r", "--scene", "builtin:hdr"],
        "d": ["--like", "r", *night],
        "zeros": ["--like", "r", "--scene", "zeros.npy"],
        "lit": ["--like", "r", "--scene", "builtin:flat:400"],
        "bright": ["--like", "r", "--scene", "builtin:flat:900000"],
        "other": ["other.nsl", *night],
    }.items():
        done = invoke(["run", *words, "-o", f"{name}.npz"], folder)
        assert done.status == 0, done.err
    return folder


def remade(folder: Path, given: str, name: str, change: Callable[[dict[str, Any]], Any]) -> None:
    """A frame file whose arrays, with the meta in JSON's values, `change` has changed."""
    with np.load(folder / f"{given}.npz") as file:
        arrays: dict[str, Any] = dict(file)
    arrays["meta"] = json.loads(str(arrays["meta"]))
    change(arrays)
    np.savez(folder / f"{name}.npz", **{**arrays, "meta": json.dumps(arrays["meta"])})


@pytest.mark.parametrize("plan", [[1, 2], HALF, {"effects": 5}, "all", {"effects": [3]}], ids=str)
def test_a_damaged_plan_in_a_frame_file_is_refused(plan: object, folder: Path) -> None:
    """A plan of another type in the meta data gives NS0819 for a run and for any program."""
    remade(folder, "f", "bad", lambda arrays: arrays["meta"].update(plan=plan))
    for by in (["r"], ["any"], ["any", "--program", "r/shutter.nsl"]):
        done = invoke(["reconstruct", by[0], "bad.npz", "-o", "o.npz", *by[1:]], folder)
        assert (done.status, done.codes) == (2, ["NS0819"]), done.err


@pytest.mark.parametrize("value", [None, "7", float("nan"), [1], True], ids=str)
def test_a_dark_frame_says_the_offset_of_its_converter(value: object, folder: Path) -> None:
    """A missing offset, or one that is no finite number, gives NS0819 with the key's name."""
    remade(folder, "d", "bad", lambda arrays: arrays["meta"].update(adc_offset=value))
    for by in ("r", "any"):
        line = ["reconstruct", by, "f.npz", "-o", "o.npz", "--dark", "bad.npz"]
        done = invoke(line, folder)
        assert (done.status, done.codes) == (2, ["NS0819"]), done.err
        assert "adc_offset" in done.err


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("slot_us", 0),
        ("slot_us", np.inf),
        ("gain", np.nan),
        ("gain", 0),
        ("bias_e", np.nan),
        ("variance_e2", np.nan),
        ("variance_e2", -1),
    ],
)
@pytest.mark.filterwarnings("error")
def test_frames_without_numbers_in_their_meta_give_no_light(
    name: str, value: float, folder: Path
) -> None:
    def change(arrays: dict[str, Any]) -> None:
        arrays[f"decode_{name}"] = np.full_like(arrays[f"decode_{name}"], value)

    remade(folder, "f", "bad", change)
    done = invoke(["reconstruct", "any", "bad.npz", "-o", "o.npz"], folder)
    assert (done.status, done.codes) == (2, ["NS0819"]), done.err
    assert f"decode_{name}" in done.err
    assert "Warning" not in done.err


@pytest.mark.parametrize("by", ["r", "any"])
def test_dark_frames_that_are_lit_or_of_another_program_are_refused(by: str, folder: Path) -> None:
    line = ["reconstruct", by, "f.npz", "-o", "o.npz", "--dark"]
    for name, reason in (("lit", "exposed to light"), ("other", "exposed with another program")):
        done = invoke([*line, f"{name}.npz"], folder)
        assert (done.status, done.codes) == (2, ["NS0819"]), done.err
        assert f"'{name}.npz'" in done.err
        assert reason in done.err
    for name in ("d", "zeros"):
        done = invoke([*line, f"{name}.npz"], folder)
        assert (done.status, done.codes) == (0, []), done.err
    # `--force` makes the error a warning.
    if by == "r":
        forced = invoke([*line, "lit.npz", "--force"], folder)
        assert (forced.status, forced.codes) == (0, ["NS0819"]), forced.err


@pytest.mark.parametrize("by", ["r", "any"])
def test_a_dark_frame_of_a_chip_gives_a_warning_if_its_pixels_are_saturated(
    by: str, folder: Path
) -> None:
    """The scene of a chip's frame is unknown, so saturated pixels give a warning and not an
    error."""
    for name, codes in (("d", []), ("bright", ["NS0844"])):
        remade(folder, name, "chip", lambda arrays: arrays["meta"].update(scene_sha256=None))
        line = ["reconstruct", by, "f.npz", "-o", "o.npz", "--dark", "chip.npz"]
        done = invoke(line, folder)
        assert (done.status, done.codes) == (0, codes), done.err


def test_reconstruct_in_python_refuses_a_dark_frame_that_was_exposed_to_light(folder: Path) -> None:
    """A frame of the scene `dark` is accepted. The frame of `hdr`, given as the dark one, is
    refused."""
    from nscc.diagnostics.diagnostic import Rejected
    from nscc_training import load_run

    run = load_run(folder / "r")
    frame, dark = (run.capture(f"builtin:{scene}") for scene in ("hdr", "dark"))
    assert run.reconstruct(frame, dark=dark).shape == (256, 256)
    with pytest.raises(Rejected, match="exposed to light"):
        run.reconstruct(frame, dark=frame)
