"""Pixels that look, learned: the model is the machine, and a bad start gets better."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pytest
from nscc_command import invoke

torch = pytest.importorskip("torch")

from nscc_training.encoders import ShutterSpec, make_encoder  # noqa: E402
from nscc_training.looking_model import looked  # noqa: E402
from nscc_training.sensor_model import SensorModel  # noqa: E402

WELL_E, STEP_E = 30000.0, 30000.0 / 127
SPEC = ShutterSpec("looks", 64, (1, 3), levels=126)
CONFIG = """
[shutter]
class = "looks"
slots = 64
exposures = 4
init = "uniform"
relaxation = "tried"
[decoder]
name = "divided"
[loss]
name = "psnr-mu"
[data]
patch = 32
scenes = 4
val_items = 4
[train]
steps = 60
batch = 4
code_rate = 0.05
validate_every = 60
device = "cpu"
"""


def by_hand(light: float, at: list[int], levels: list[int]) -> tuple[float, float]:
    """What one pixel holds when it closes, and its part of the frame, without noise."""
    for boundary, level in zip(at, levels, strict=True):
        held = min(light * boundary / 64, WELL_E)
        if held > level * STEP_E:
            return held, boundary / 64
    return min(light, WELL_E), 1.0


def test_the_model_of_looking_pixels_equals_a_computation_by_hand() -> None:
    """For 600 lights from 10 to 5 million electrons a second, codes and open shares are those of a
    loop over three looks."""
    at, levels = [1, 7, 20], [30, 55, 90]
    fields = torch.tensor([*at, *levels], dtype=torch.float32).reshape(-1, 1, 1)
    light = np.geomspace(10, 5e6, 30 * 20).reshape(30, 20)
    sensor = SensorModel(WELL_E, WELL_E / 255)
    codes, share = looked(torch.tensor(light)[None], fields, 64, STEP_E, sensor, None)
    for place, electrons in np.ndenumerate(light):
        held, part = by_hand(float(electrons), at, levels)
        assert float(share[0][place]) == pytest.approx(part)
        assert abs(float(codes[0][place]) - held / (WELL_E / 255)) <= 0.5 + 1e-6


def test_answers_are_as_sure_as_the_comparator() -> None:
    """A light at the level closes half of the pixels, one standard deviation above it 84 %."""
    sensor = SensorModel(WELL_E, WELL_E / 255, comparator_noise=0.02, comparator_offset=0.0)
    fields = torch.tensor([32.0, 60.0]).reshape(-1, 1, 1)
    for sigmas, expected in ((0.0, 0.5), (1.0, 0.8413)):
        light = torch.full((1, 200, 200), 2 * (60 * STEP_E + sigmas * 0.02 * WELL_E))
        drawn = torch.Generator().manual_seed(1)
        _, share = looked(light, fields, 64, STEP_E, sensor, drawn)
        assert float((share == 0.5).float().mean()) == pytest.approx(expected, abs=0.01)


def test_boundaries_of_looks_increase_and_levels_stay_in_their_range() -> None:
    """Boundaries increase and stay within the frame whatever the parameters. Codes in another order
    are refused."""
    encoder = make_encoder(SPEC, "quad")
    encoder.load_codes({"at": np.array([[2, 9, 33]]), "level": np.array([[5, 60, 126]])})
    assert encoder.codes()["at"].tolist() == [[2, 9, 33]]
    assert encoder.codes()["level"].tolist() == [[5, 60, 126]]
    with torch.no_grad():
        encoder.moment.copy_(torch.tensor([9.0, 9.0, 0.0]))
        encoder.level.copy_(torch.tensor([-4.0, 1e4, 7.4]))
    # The last three boundaries of 64 slots; levels are steps 1 to 126.
    assert encoder.codes()["at"].tolist() == [[61, 62, 63]]
    assert encoder.codes()["level"].tolist() == [[1, 126, 7]]
    with pytest.raises(ValueError, match="follow"):
        encoder.load_codes({"at": np.array([[9, 2, 33]]), "level": np.array([[5, 60, 126]])})


@pytest.mark.parametrize("relaxation", ["straight-through", "tried"])
def test_gradients_reach_moments_and_levels(relaxation: str) -> None:
    """With `straight-through`, moments and levels have gradients that are not 0. With `tried`, a
    trial has shutters and fields that need one."""
    encoder = make_encoder(SPEC, "quad", relaxation=relaxation)
    light = torch.tensor(np.geomspace(10, 5e6, 32 * 32).reshape(1, 32, 32))
    sensor = SensorModel(WELL_E, WELL_E / 255, comparator_noise=0.02)
    # Trials get their gradient from the trainer, so only their shapes are tested.
    if relaxation == "tried":
        trial = encoder.trial(lambda tile: tile.expand(-1, 32, 32), torch.Generator())
        assert trial.shutters[0].shape == (6, 32, 32)
        assert trial.fields.requires_grad
        return
    codes, share = looked(light, encoder(), 64, STEP_E, sensor, torch.Generator().manual_seed(1))
    (codes / share).log1p().mean().backward()
    for parameter in encoder.parameters():
        assert bool((parameter.grad != 0).all())


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("looks")
    (folder / "c.toml").write_text(CONFIG)
    done = invoke(["train", "c.toml", "--out", "r"], folder)
    assert done.status == 0, done.err
    return folder


def test_learning_makes_a_bad_start_better(run: Path) -> None:
    kept = invoke(
        ["train", "c.toml", "--out", "k", "--set", "train.code_rate=0", "--set", "train.steps=1"],
        run,
    )
    assert kept.status == 0, kept.err
    learned, start = (json.loads((run / name / "result.json").read_text()) for name in ("r", "k"))
    assert start["codes"]["moved"] == 0
    assert start["codes"]["at"] == [16, 32, 48]
    assert learned["stages"]["hard"] > start["stages"]["hard"]
    losses = [
        float((run / name / "metrics.csv").read_text().splitlines()[-1].split(",")[2])
        for name in ("r", "k")
    ]
    assert losses[0] < losses[1] - 0.3  # three decibels of PSNR-mu
    assert learned["stages"]["compiled_equals_hard"]
    assert learned["stages"]["emulated"] == pytest.approx(learned["stages"]["hard"], abs=0.05)


def test_a_program_of_learned_looks_is_exposed_and_reconstructed(run: Path) -> None:
    """The decoder of the run and the reconstruction without a run give nearly the same light."""
    text = (run / "r/shutter.nsl").read_text()
    assert text.splitlines()[2] == "nsl 2"
    steps = [
        ["run", "r/shutter.nsl", "--scene", "builtin:hdr", "--exposure", "300000", "-o", "f.npz"],
        ["reconstruct", "r", "f.npz", "-o", "by_run.npz"],
        ["reconstruct", "f.npz", "-o", "alone.npz"],
    ]
    for step in steps:
        done = invoke(step, run)
        assert done.status == 0, done.err
    one, other = (np.load(run / f"{name}.npz")["image"] for name in ("by_run", "alone"))
    assert np.percentile(np.abs(one / np.maximum(other, 1) - 1), 90) < 0.02


def test_a_design_is_a_start(run: Path) -> None:
    """Designs of pixels that look and of fixed tiles start a training."""
    scene = ["--scene", "builtin:hdr", "--exposure", "300000", "--slots", "64", "-O", "0"]
    one = ["--set", "train.steps=1", "--set", "train.code_rate=0"]
    assert invoke(["design", "--looks", "4", *scene, "-o", "d.nsl"], run).status == 0
    done = invoke(["train", "c.toml", "--out", "d", "--set", "shutter.init=d.nsl", *one], run)
    assert done.status == 0, done.err
    body = [(run / name).read_text().partition("nsl 2")[2] for name in ("d.nsl", "d/shutter.nsl")]
    assert body[0] == body[1]
    wrong = invoke(
        [
            "train",
            "c.toml",
            "--out",
            "w",
            "--set",
            "shutter.init=d.nsl",
            "--set",
            "shutter.exposures=3",
        ],
        run,
    )
    assert wrong.codes == ["NS0815"]
    assert invoke(["design", "--criterion", "sve-risk", *scene, "-o", "t.nsl"], run).status == 0
    tile = [
        "--set",
        "shutter.class=b",
        "--set",
        "shutter.init=t.nsl",
        "--set",
        "shutter.tile=[2,2]",
        *one,
    ]
    done = invoke(["train", "c.toml", "--out", "t", *tile], run)
    assert done.status == 0, done.err
    tiles = [
        re.findall(r"\d+", (run / name).read_text().rpartition("tile")[2])
        for name in ("t.nsl", "t/shutter.nsl")
    ]
    assert len(tiles[0]) == 4
    assert tiles[0] == tiles[1]


@pytest.mark.parametrize(
    "change",
    [
        ["data.protocol=video-v1"],
        ["shutter.words_weight=1"],
        ["shutter.exposures=32", "shutter.slots=16"],
        ["shutter.require=stop < 3"],
        ["decoder.name=unet3d"],
    ],
    ids=lambda change: change[0],
)
def test_invalid_settings_for_looks_are_refused(run: Path, change: list[str]) -> None:
    sets = [part for each in change for part in ("--set", each)]
    done = invoke(["train", "c.toml", "--out", "x", *sets], run)
    assert done.codes == ["NS0815"], done.err
    assert not (run / "x").exists()
