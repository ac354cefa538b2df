"""Decoders, losses and data of the user's own that do not do what they should."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from nscc_command import invoke

torch = pytest.importorskip("torch")

from nscc.diagnostics.diagnostic import Rejected  # noqa: E402
from nscc_training.data.sources import load_scenes  # noqa: E402
from nscc_training.loop.train import train  # noqa: E402
from nscc_training.run_folder import load_run  # noqa: E402
from nscc_training.settings import DataSettings, settings_of  # noqa: E402

CODE = """
import numpy as np
import torch


class Own(torch.nn.Module):
    def __init__(self, **about):
        super().__init__()
        self.gain = torch.nn.Parameter(torch.ones(()))

    def forward(self, frame, shutters):
        return self.made(frame * self.gain)


def decoder(made):
    return type("Decoder", (Own,), {"made": lambda self, frame: made(frame)})


def broken(frame):
    raise RuntimeError("no idea")


good = decoder(lambda frame: frame)
raises = decoder(broken)
one_axis_more = decoder(lambda frame: frame[:, None])
one_pixel = decoder(lambda frame: frame[..., :1, :1])
one_of_the_batch = decoder(lambda frame: frame[:1])
a_pair = decoder(lambda frame: (frame, frame))
no_gradient = decoder(lambda frame: frame.detach())


class NothingToLearn(torch.nn.Module):
    def __init__(self, **about):
        super().__init__()

    def forward(self, frame, shutters):
        return frame


class NotMade(torch.nn.Module):
    def __init__(self):
        super().__init__()


squared = lambda made, truth: (made - truth).square().mean()
listed = lambda made, truth: (made - truth).square().mean().reshape(1)
unreduced = lambda made, truth: (made - truth).square()
a_float = lambda made, truth: 1.0
detached = lambda made, truth: (made - truth).square().mean().detach()
failing = lambda made, truth: {}["x"]
one_argument = lambda made: made.mean()

torch_is_full = lambda made, truth: torch.empty(1 << 50).sum()
numpy_is_full = lambda made, truth: torch.from_numpy(np.empty(1 << 50)).sum()


def gpu_is_full(made, truth):
    raise torch.OutOfMemoryError("CUDA out of memory. Tried to allocate 20.00 GiB.")


nothing = lambda **about: None
pictures_alone = lambda **about: [np.ones((20, 20))]
complex_light = lambda **about: [("a", np.ones((20, 20)) * 1j)]
too_bright = lambda **about: [("a", np.full((20, 20), 1e300))]


def ends_early(**about):
    yield "a", np.ones((20, 20))
    raise OSError("the disk is gone")


def scaled(kind, part, slots, seed):
    unit = float(open_unit())
    return [(part, unit * np.random.default_rng(len(part)).random((20, 20)) ** 4)]


def open_unit():
    with open("unit.txt") as file:
        return file.read()
"""


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    (tmp_path / "own_code_of_tests.py").write_text(CODE)
    monkeypatch.chdir(tmp_path)
    return tmp_path


def outcome(folder: Path, section: str, name: str, **shutter: Any) -> list[str]:
    """The codes that a run ends with; none if it is finished."""
    path = f"own_code_of_tests:{name}"
    values: dict[str, dict[str, Any]] = {
        "shutter": {"slots": 8, "tile": [2, 2], **shutter},
        "data": {"patch": 16, "scenes": 2, "val_items": 1},
        "train": {"steps": 1, "batch": 2, "device": "cpu"},
    }
    more = {"train": path, "val": path} if section == "data" else {"name": path}
    values[section] = {**values.get(section, {}), **more}
    try:
        train(settings_of(values), folder / "run", resume="never")
    except Rejected as rejected:
        return [diagnostic.code for diagnostic in rejected.diagnostics]
    return []


@pytest.mark.parametrize(
    ("section", "name"),
    [
        ("decoder", "good"),
        ("decoder", "NothingToLearn"),
        ("loss", "squared"),
        ("loss", "listed"),
    ],
)
def test_working_user_code_trains(folder: Path, section: str, name: str) -> None:
    assert outcome(folder, section, name) == []
    assert (folder / "run/result.json").is_file()


@pytest.mark.parametrize(
    ("section", "name"),
    [
        *(
            ("decoder", name)
            for name in (
                "raises",
                "one_axis_more",
                "one_pixel",
                "one_of_the_batch",
                "a_pair",
                "no_gradient",
                "NotMade",
            )
        ),
        *(
            ("loss", name)
            for name in (
                "unreduced",
                "a_float",
                "detached",
                "failing",
                "one_argument",
            )
        ),
        *(("data", name) for name in ("nothing", "pictures_alone", "ends_early")),
    ],
)
def test_errors_in_code_of_the_user_are_attributed_to_it(
    folder: Path, section: str, name: str
) -> None:
    assert outcome(folder, section, name) == ["NS0822"]
    assert not (folder / "run/result.json").exists()


@pytest.mark.parametrize("section", ["decoder", "loss"])
def test_a_run_executes_nothing_until_it_is_trusted(folder: Path, section: str) -> None:
    """A run folder comes from anybody, and modules are looked for in the current folder."""
    name = "good" if section == "decoder" else "squared"
    assert outcome(folder, section, name) == []
    (folder / "own_code_of_tests.py").write_text(CODE + "open('executed', 'w').close()\n")
    sys.modules.pop("own_code_of_tests")
    np.savez(folder / "f.npz", frame=np.zeros((1, 256, 256), np.uint8))
    for command in (
        ["reconstruct", "run", "f.npz", "-o", "out.npz"],
        ["evaluate", "run", "--data", ".", "--protocol", "hdr-v1"],
        ["tradeoff", "decoder", "--run", "run", "--csv", "t.csv"],
    ):
        found = invoke(command, folder)
        assert (found.status, found.codes) == (2, ["NS0823"]), found.err
        assert f"own_code_of_tests:{name}" in found.err
        assert "--trust-code" in found.err
        assert not (folder / "executed").exists()
    with pytest.raises(Rejected, match="NS0823"):
        load_run(folder / "run")
    assert load_run(folder / "run", trust_code=True).setup.still
    assert (folder / "executed").exists()
    # With trust it is the frame that is wrong.
    assert invoke(
        ["reconstruct", "run", "f.npz", "-o", "out.npz", "--trust-code"], folder
    ).codes == ["NS0819"]


@pytest.mark.parametrize("name", ["complex_light", "too_bright"])
def test_invalid_light_is_refused(folder: Path, name: str) -> None:
    assert outcome(folder, "data", name) == ["NS0811"]


@pytest.mark.parametrize("name", ["torch_is_full", "numpy_is_full", "gpu_is_full"])
def test_running_out_of_memory_is_reported_with_settings_that_need_less(
    folder: Path, name: str
) -> None:
    """The error blames neither nscc (status 70) nor the user's code."""
    small = {
        "shutter.slots": 8,
        "shutter.tile": "[2,2]",
        "data.patch": 16,
        "data.scenes": 2,
        "data.val_items": 1,
        "train.steps": 1,
        "train.batch": 1,
        "train.device": "cpu",
        "loss.name": f"own_code_of_tests:{name}",
    }
    (folder / "c.toml").write_text("")
    changes = [part for key, value in small.items() for part in ("--set", f"{key}={value}")]
    found = invoke(["train", "c.toml", "--out", "run", *changes], folder)
    assert (found.status, found.codes) == (3, ["NS0902"])
    assert "train.batch" in found.err
    assert ("on the GPU" in found.err) == ("CUDA_VISIBLE_DEVICES" in found.err) == ("gpu" in name)
    assert not list(folder.glob("*.zip"))


def test_a_training_without_anything_to_learn_is_refused(folder: Path) -> None:
    settings = settings_of(
        {
            "shutter": {"slots": 8, "tile": [2, 2], "learn": False},
            "decoder": {"name": "own_code_of_tests:NothingToLearn"},
        }
    )
    with pytest.raises(Rejected) as caught:
        train(settings, folder / "run")
    assert [d.code for d in caught.value.diagnostics] == ["NS0815"]


@pytest.mark.parametrize("unit", ["1e-300", "1e-30", "1e30"])
def test_stills_are_scaled_so_that_their_unit_has_no_effect(folder: Path, unit: str) -> None:
    """Contrast is changed above a floor, and powers of the light must stay finite."""
    lights = []
    for text in ("1", unit):
        (folder / "unit.txt").write_text(text)
        path = "own_code_of_tests:scaled"
        scenes = load_scenes(DataSettings(train=path, val=path, patch=16), True, 8, 0)
        lights.append(scenes.train[0].light.astype(np.float64))
    assert lights[1] / lights[1].max() == pytest.approx(lights[0] / lights[0].max(), rel=1e-6)
    assert 1e-8 < lights[1].max() < 1e8
