"""Several readouts of one exposure: how they are joined, and what demos reach with them."""

from __future__ import annotations

import os
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from checkout import ROOT
from PIL import Image

torch = pytest.importorskip("torch")

from nscc.compiler import compile_file  # noqa: E402
from nscc.examples import examples  # noqa: E402
from nscc.pipeline import Options  # noqa: E402
from nscc_runtime.scenes import Scene  # noqa: E402
from nscc_training import made_scenes  # noqa: E402
from nscc_training.any_code.decode import always_open, joined  # noqa: E402
from nscc_training.command_settings import DemoSettings  # noqa: E402
from nscc_training.demo import demo  # noqa: E402
from nscc_training.demo.expose import CLIPS  # noqa: E402
from nscc_training.design.bracket import camera  # noqa: E402
from nscc_training.measured import Measured  # noqa: E402

DATA = Path(os.environ.get("NSCC_DATA", ROOT / "../shared/data"))
KEPT_BACK = (
    "video/pose2sim_multi_cam04.mp4",
    "video/pose2sim_single_cam04.mp4",
    "video/cvvdp_ferris.mp4",
    "sci/runner.mat",
    "sci/drop.mat",
)
"""Programs, weights and the default number of readouts were chosen without these."""


def measured_of(clip: np.ndarray, masks: np.ndarray, sd: float = 0.0) -> Measured:
    """Readouts (B, rows, cols) of a clip, as they are without noise, with a stated one."""
    light, mask = torch.from_numpy(clip)[None], torch.from_numpy(masks)[None]
    value = (mask * light.unsqueeze(1)).sum(dim=2)
    full = torch.zeros_like(value, dtype=torch.bool)
    return Measured(value, mask, torch.full_like(value, sd**2), full)


def masks_of(name: str, size: int = 16) -> np.ndarray:
    """The shutters (B, N, size, size) of an example."""
    container = compile_file(examples()[name], Options(level=0)).container
    assert container is not None
    assert container.pixel_codes is not None
    shutters = container.table.shutters[container.table.shutter_of_code[container.pixel_codes]]
    return np.ascontiguousarray(shutters[:size, :size].transpose(2, 3, 0, 1), np.float32)


@pytest.mark.parametrize(("count", "name"), CLIPS.items())
def test_the_programs_have_so_many_readouts(count: int, name: str) -> None:
    masks = masks_of(name)
    assert masks.shape[:2] == (count, 16)
    open_one = always_open(measured_of(np.ones((16, 16, 16), np.float32), masks))
    assert open_one == (None if count == 1 else 0)
    # Every moment is in a coded readout of some pixel, or the always open one tells the rest.
    coded = masks[-1:] if count == 1 else masks[1:]
    assert coded.sum(axis=(0, 2, 3)).min() > 0 or count > 2


def test_the_joined_light_of_a_still_scene_is_weighted_by_the_precision_of_readouts() -> None:
    """The given clip is grey and contains nothing of the scene. The expected mean is computed by
    hand."""
    masks = masks_of("three_readouts", 32)
    rng = np.random.default_rng(1)
    scene = rng.uniform(0.2, 0.8, (32, 32)).astype(np.float32)
    exact = measured_of(np.broadcast_to(scene, (16, 32, 32)).copy(), masks, sd=0.1)
    noise = torch.from_numpy(rng.normal(0, 0.1, exact.value.shape).astype(np.float32))
    measured = replace(exact, value=exact.value + noise)
    found = joined(measured, torch.full((1, 16, 32, 32), 0.5), 0)[0].numpy()
    light = measured.value[0].numpy() / np.array([16, 4, 4])[:, None, None]
    weights = np.array([256, 16, 16])[:, None, None]
    expected = (weights * light).sum(axis=0) / weights.sum()
    # Chance makes a few places look as if they moved.
    assert np.median(np.abs(found - expected)) < 1e-3  # noise is little beside the scene
    assert np.ptp(found, axis=0).max() < 1e-6


def test_a_correct_clip_reduces_the_noise_of_readouts() -> None:
    masks = masks_of("three_readouts", 64)
    flat = np.full((16, 64, 64), 0.5, np.float32)
    exact = measured_of(flat, masks, sd=0.3)
    noise = np.random.default_rng(2).normal(0, 0.3, exact.value.shape).astype(np.float32)
    measured = replace(exact, value=exact.value + torch.from_numpy(noise))
    found = joined(measured, torch.from_numpy(flat)[None], 0)[0].numpy()
    # The always open readout alone: its noise over 16 slots.
    alone = noise[0, 0] / 16
    assert np.std(found - 0.5) < 0.4 * np.std(alone)


def test_moving_parts_of_joined_readouts_keep_the_given_clip() -> None:
    masks = masks_of("three_readouts", 64)
    clip = np.full((16, 64, 64), 0.5, np.float32)
    clip[8:, 20:44, 20:44] = 0.1
    measured, given = measured_of(clip, masks, sd=0.05), torch.full((1, 16, 64, 64), 0.25)
    found = joined(measured, given, 0)[0].numpy()
    assert (found[:, 24:40, 24:40] == 0.25).all()
    np.testing.assert_allclose(found[:, :8, :8], 0.5, atol=0.01)


def test_saturated_readouts_are_replaced_by_others() -> None:
    masks = masks_of("three_readouts", 16)
    clip = np.full((16, 16, 16), 1.5, np.float32)
    measured = measured_of(clip, masks, sd=0.01)
    measured.saturated[:, 0], measured.value[:, 0] = True, 16.0
    found = joined(measured, torch.full((1, 16, 16, 16), 0.3), 0).numpy()
    np.testing.assert_allclose(found, 1.5, atol=0.01)


def test_motion_shows_where_the_always_open_readout_is_full() -> None:
    masks = masks_of("three_readouts", 32)
    clip = np.full((16, 32, 32), 2.0, np.float32)
    clip[8:] = 0.5
    measured = measured_of(clip, masks, sd=0.05)
    # The slots add up to 20, but the readout is full at 16.
    measured.saturated[:, 0], measured.value[:, 0] = True, 16.0
    found = joined(measured, torch.full((1, 16, 32, 32), 0.25), 0).numpy()
    assert (found == 0.25).all()


@pytest.mark.parametrize(("buckets", "name"), [(1, "class_c"), (2, "coded_two_buckets")])
def test_readouts_are_not_joined_without_an_always_open_one(buckets: int, name: str) -> None:
    masks = masks_of(name)
    assert masks.shape[0] == buckets
    assert always_open(measured_of(np.ones((masks.shape[1], 16, 16), np.float32), masks)) is None
    both = np.ones((2, 8, 16, 16), np.float32)
    assert always_open(measured_of(np.ones((8, 16, 16), np.float32), both)) is None


def test_a_burst_shares_out_the_frame() -> None:
    """Two to four readouts divide 16 slots: each slot is in one, in the order of time."""
    for frames in (2, 3, 4):
        shutters = camera(16, 125.0, frames=frames).table.shutters[0]
        assert shutters.shape == (frames, 16)
        np.testing.assert_array_equal(shutters.sum(axis=0), 1)
        assert (np.diff(shutters.argmax(axis=0)) >= 0).all()


def procedural(kind: str) -> np.ndarray:
    """Light (16, 256, 256) of a textured scene with things before it: both move as `kind` says."""
    generator = np.random.default_rng([43, len(kind)])
    pan, speed = {
        "still": (0.0, 0.0),
        "slow": (0.25, 0.4),
        "fast": (5.0, 7.0),
        "mixed": (0.0, 5.0),
    }[kind]
    ground, thing = (made_scenes.clip(generator, 1, size)[0] for size in (420, 96))
    rows, cols = np.mgrid[:96, :96]
    disc = np.hypot(rows - 48, cols - 48) < 46
    clip = np.empty((16, 256, 256), np.float32)
    for k in range(16):
        at = 70 + pan * k
        row, share = int(at), at % 1
        window = ground[row : row + 257, 70:326]
        clip[k] = (1 - share) * window[:-1] + share * window[1:]
        left = round(20 + speed * k)
        clip[k, 80:176, left : left + 96][disc] = thing[disc]
    return clip * (30000 / np.percentile(clip.sum(axis=0), 99))


@pytest.mark.parametrize("kind", ["still", "slow", "fast", "mixed"])
def test_a_clip_is_never_worse_than_an_ordinary_cameras(kind: str, tmp_path: Path) -> None:
    np.savez(tmp_path / f"{kind}.npz", light=procedural(kind))
    made = demo(Scene(str(tmp_path / f"{kind}.npz")), tmp_path / "out")
    assert made.psnr_db > made.open_db + {"fast": 4.0, "mixed": 2.0}.get(kind, -0.3)
    assert made.fair_db is not None
    assert made.psnr_db > made.fair_db


@pytest.mark.slow
@pytest.mark.parametrize("name", KEPT_BACK)
def test_a_film_is_never_worse_than_an_ordinary_cameras(name: str, tmp_path: Path) -> None:
    if not (DATA / name).is_file():
        pytest.skip(f"'{name}' is not in {DATA}: set NSCC_DATA")
    made = demo(Scene(str(DATA / name)), tmp_path / "out")
    assert made.psnr_db > made.open_db - 0.3


def test_the_demo_takes_the_requested_readouts(tmp_path: Path) -> None:
    frames = [
        Image.fromarray(np.uint8(200 * frame))
        for frame in made_scenes.clip(np.random.default_rng(1), 16, 64)
    ]
    frames[0].save(tmp_path / "a.gif", save_all=True, append_images=frames[1:])
    for count in (1, 2):
        made = demo(Scene(str(tmp_path / "a.gif")), tmp_path / "o", DemoSettings(readouts=count))
        assert made.readouts == count
        assert (made.fair_db is None) == (count == 1)
        assert (tmp_path / "o/clip.nsl").read_bytes() == examples()[CLIPS[count]].read_bytes()
        with np.load(tmp_path / "o/clip_frame.npz") as file:
            assert file["frame"].shape[0] == count
