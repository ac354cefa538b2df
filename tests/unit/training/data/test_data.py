"""Patches of one exposure, cameras in panoramas, splits by file, and the best state of a run."""

from __future__ import annotations

import json
from collections import defaultdict
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from nscc_command import invoke

torch = pytest.importorskip("torch")

from safetensors import safe_open  # noqa: E402
from safetensors.torch import load_file  # noqa: E402

from nscc.diagnostics.diagnostic import Rejected  # noqa: E402
from nscc_training import turning_camera  # noqa: E402
from nscc_training.any_code.lessons import LessonSet  # noqa: E402
from nscc_training.data import Batch, ExposureSet, Scenes, SourceScene, cut_batch, load_scenes  # noqa: E402
from nscc_training.data.exposures import quantiles  # noqa: E402
from nscc_training.loop.train import train  # noqa: E402
from nscc_training.settings import DataSettings, settings_of  # noqa: E402
from nscc_training.turning_camera import turned, view  # noqa: E402

WELL = 30000.0


class Cuts:
    """Batches of scenes by step, cut on the CPU."""

    def __init__(
        self, lights: dict[str, Any], batch: int = 6, seed: int = 3, slots: int = 4, **settings: Any
    ) -> None:
        scenes = tuple(SourceScene(n, n, np.asarray(x, np.float32)) for n, x in lights.items())
        self.settings = DataSettings(**{"patch": 16, **settings})
        self.drawn = ExposureSet(
            Scenes(scenes, scenes), self.settings, slots=slots, batch=batch, seed=seed
        )

    def train(self, step: int) -> Batch:
        return cut_batch(self.drawn[step], self.settings, WELL, torch.device("cpu"))


def places(batch: Batch) -> list[tuple[str, int, int]]:
    """Of every patch: its exposure's name, and its corner in it."""
    found = []
    for name in batch.names:
        exposure, _, corner = name.rpartition("+")
        row, col = corner.split(",")
        found.append((exposure, int(row), int(col)))
    return found


def random_light(*shape: int, seed: int = 1) -> Any:
    return np.exp(np.random.default_rng(seed).normal(0, 2, shape))


def test_clips_of_a_protocol_with_a_light_are_as_bright_as_that() -> None:
    """50 lux: grey gathers 3636 electrons, whatever the unit of the source."""
    light = random_light(8, 24, 24)
    for factor in (1.0, 1e3):
        of = {"s": factor * light}
        cut = Cuts(of, batch=1, slots=8, patch=24, protocol="deblur-v1").train(0)
        assert np.median(cut.light[0].sum(dim=0).numpy()) == pytest.approx(3636, rel=1e-3)


@pytest.mark.parametrize("size", [(40, 40), (300, 290)])
def test_patches_of_one_exposure_share_level_and_peak(size: tuple[int, int]) -> None:
    """30 % of all that is exposed saturates, and 1 is its 99.9th percentile, in every patch."""
    light = random_light(*size)
    cut = Cuts({"s": light}, batch=7, together=3, augment=False).train(0)
    groups = defaultdict(list)
    for index, (exposure, row, col) in enumerate(places(cut)):
        groups[index // 3].append(index)
        corner = [int(x) for x in exposure.partition(" at ")[2].split(",")]
        assert all(0 <= c <= max(0, side - 256) for c, side in zip(corner, size, strict=True))
        around = light[corner[0] : corner[0] + 256, corner[1] : corner[1] + 256]
        level, white = np.quantile(around, (0.7, 0.999))
        wanted = around[row : row + 16, col : col + 16] * (WELL / level)
        np.testing.assert_allclose(cut.light[index], wanted, rtol=1e-5)
        np.testing.assert_allclose(cut.truth[index], wanted / WELL, rtol=1e-5)
        assert cut.peak[index].item() == pytest.approx(white / level, rel=1e-5)
    assert [len(g) for g in groups.values()] == [3, 3, 1]
    for group in groups.values():
        assert len({places(cut)[k][0] for k in group}) == 1
        assert len({places(cut)[k][1:] for k in group}) == len(group)
        assert len(set(cut.peak[group].tolist())) == 1


def test_a_dark_patch_stays_dark_beside_a_bright_one() -> None:
    """One half of the scene is 10 000 times brighter. Patches of the dark half stay below a
    thousandth of the well."""
    light = np.ones((120, 120))
    light[:, 60:] = 1e4
    cut = Cuts({"s": light}, batch=40, together=40, augment=False).train(0)
    brightest = cut.light.amax(dim=(1, 2))
    assert (brightest < WELL / 1000).any()
    assert (brightest >= WELL * 0.99).any()


def test_patches_of_one_exposure_of_a_clip_share_its_scale() -> None:
    """The 99th percentile of what an open pixel gathers fills a well; 1 is white."""
    light = np.random.default_rng(2).random((9, 30, 33))
    cut = Cuts({"s": light}, batch=4, together=2, augment=False).train(1)
    for index, (exposure, row, col) in enumerate(places(cut)):
        first, _, corner = exposure.partition(" from ")[2].partition(" at ")
        top, left = map(int, corner.split(","))
        window = light[int(first) : int(first) + 4, top : top + 30, left : left + 30]
        level = np.percentile(window.sum(axis=0), 99)
        wanted = window[:, row : row + 16, col : col + 16] * (WELL / level)
        np.testing.assert_allclose(cut.light[index], wanted, rtol=1e-5)
        assert cut.peak[index].item() == pytest.approx(4 / level, rel=1e-5)
    names = [p[0] for p in places(cut)]
    assert names[0] == names[1]
    assert names[2] == names[3]


@pytest.mark.parametrize("together", [1, 3])
def test_augmentation_bends_level_and_peak_with_the_light(together: int) -> None:
    """30 % saturate and 0.1 % are above the peak, whatever the contrast."""
    light = random_light(16, 16)
    values = set()
    for step in range(6):
        cut = Cuts({"s": light}, batch=3, together=together).train(step)
        for patch, peak in zip(cut.truth, cut.peak, strict=True):
            assert np.mean(patch.numpy() > 1) == pytest.approx(0.3, abs=0.01)
            assert 0 < np.mean(patch.numpy() > peak.item()) < 0.01
            values.add(round(peak.item(), 4))
    # A peak for each exposure; `together` patches of the 18 share one.
    assert len(values) == 18 // together


@pytest.mark.parametrize(
    ("shape", "poles"), [((512, 1024), True), ((512, 1000), False), ((400, 800), False)]
)
def test_the_poles_of_a_panorama_are_left_out(shape: tuple[int, int], poles: bool) -> None:
    """A picture twice as wide as high, with at least 512 rows, is a panorama. No patch shows its
    bright upper and lower eighth."""
    light = np.full(shape, 1.0)
    eighth = shape[0] // 8
    light[eighth:-eighth] += np.random.default_rng(1).random((shape[0] - 2 * eighth, shape[1]))
    light[:eighth] = light[-eighth:] = 5.0  # brighter than anything between
    cut = Cuts({"s": light}, batch=60, augment=False, patch=64).train(0)
    at_a_pole = (cut.light == cut.light.amax(dim=(1, 2), keepdim=True)).sum(dim=(1, 2)) > 1
    assert bool(at_a_pole.any()) != poles


def test_training_batches_differ_between_steps_and_are_reproducible() -> None:
    """Step 5 gives the same light twice. Step 6 has other patches."""
    source = Cuts({"a": random_light(40, 50)}, together=2)
    one, two, again = source.train(5), source.train(6), source.train(5)
    assert torch.equal(one.light, again.light)
    assert one.names != two.names


def test_completely_dark_scenes_stay_finite() -> None:
    """For a still and a clip of zeros the light stays 0 and the peak is finite and above 0."""
    for shape in ((30, 30), (6, 30, 30)):
        source = Cuts({"a": np.zeros(shape)}, together=2)
        cut = source.train(0)
        assert (cut.light <= 1e-12).all()
        assert (cut.peak > 0).all()
        assert torch.isfinite(cut.peak).all()


@pytest.mark.parametrize("still", [True, False])
def test_patches_are_those_that_numpy_turns_and_mirrors(still: bool) -> None:
    light = np.random.default_rng(1).random((20, 20) if still else (5, 20, 20)) + 0.1
    source = Cuts({"s": light}, batch=12, together=1, slots=5, patch=9)
    seen = set()
    for step in range(6):
        drawn, cut = source.drawn[step], source.train(step)
        for k, (turns, mirrored, back) in enumerate(
            zip(drawn.turns, drawn.mirrored, drawn.backwards, strict=True)
        ):
            whole = np.rot90(drawn.light[k].numpy(), int(turns), axes=(-2, -1))
            whole = whole[..., ::-1] if mirrored else whole
            whole = whole[::-1] if back else whole
            row, col = drawn.corner[k].tolist()
            wanted = whole[..., row : row + 9, col : col + 9] ** float(drawn.contrast[k])
            made = cut.light[k].numpy()
            np.testing.assert_allclose(made / made.max(), wanted / wanted.max(), rtol=1e-5)
            seen.add((int(turns), bool(mirrored), bool(back)))
    assert len(seen) == (8 if still else 16)


@given(st.integers(1, 300), st.floats(0, 1), st.integers(0, 2**32 - 1))
def test_quantiles_are_those_of_numpy(count: int, part: float, seed: int) -> None:
    values = np.random.default_rng(seed).normal(size=(3, count))
    found = quantiles(torch.from_numpy(values), part)
    np.testing.assert_allclose(found, np.quantile(values, part, axis=1), rtol=1e-9, atol=1e-12)


@given(st.integers(1, 300), st.floats(0, 1), st.integers(0, 2**32 - 1))
def test_quantiles_of_rows_equal_numpy(count: int, part: float, seed: int) -> None:
    rng = np.random.default_rng(seed)
    values, parts = rng.normal(size=(3, count)), [part, 0.0, 1.0]
    found = quantiles(torch.from_numpy(values), torch.tensor(parts, dtype=torch.float64))
    wanted = [np.quantile(row, each) for row, each in zip(values, parts, strict=True)]
    np.testing.assert_allclose(found, wanted, rtol=1e-9, atol=1e-12)


def panorama(path: Path, seed: int) -> None:
    import cv2

    light = np.exp(np.random.default_rng(seed).normal(0, 1, (64, 128, 1)))
    cv2.imwrite(str(path), np.repeat(light, 3, 2).astype(np.float32))


def loaded(train: Path, val: str = "", seed: int = 0, **settings: Any) -> Scenes:
    data = DataSettings(
        train=str(train), val=val, protocol="video-v1", patch=16, **{"paths": 3, **settings}
    )
    return load_scenes(data, still=False, slots=3, seed=seed)


def test_a_panorama_gives_several_clips_each_its_own(tmp_path: Path) -> None:
    for seed in range(3):
        panorama(tmp_path / f"p{seed}.hdr", seed)
    found = loaded(tmp_path)
    scenes = [*found.train, *found.val]
    # Three clips of each of three panoramas.
    assert len(scenes) == 9
    assert len({s.name for s in scenes}) == 9
    assert len({s.light.tobytes() for s in scenes}) == 9
    for scene in scenes:
        assert scene.light.shape == (3, 256, 256)
        assert np.percentile(scene.light, 99) == pytest.approx(1, rel=1e-3)
    again = loaded(tmp_path)
    for one, two in zip(scenes, [*again.train, *again.val], strict=True):
        assert (one.name, one.sha256) == (two.name, two.sha256)
        assert np.array_equal(one.light, two.light)
    other = loaded(tmp_path, seed=1)
    assert not np.array_equal(found.train[0].light, other.train[0].light)
    # fewer paths are the first ones
    few = {s.name: s.light for s in loaded(tmp_path, paths=1).train}
    assert len(few) == 2
    for scene in found.train:
        if scene.name in few:
            assert np.array_equal(few[scene.name], scene.light)


def test_clips_of_panoramas_are_encoded_where_values_are_taken_as_light(tmp_path: Path) -> None:
    for seed in range(2):
        panorama(tmp_path / f"p{seed}.hdr", seed)
    plain, srgb, stored = (loaded(tmp_path, transfer=t) for t in ("", "srgb", "linear"))
    for one, two, three in zip(plain.train, srgb.train, stored.train, strict=True):
        assert np.array_equal(one.light, two.light)
        assert one.light.max() > 1.5
        light = np.clip(one.light.astype(float), 0, 1)
        wanted = np.where(light > 0.0031308, 1.055 * light ** (1 / 2.4) - 0.055, 12.92 * light)
        np.testing.assert_allclose(three.light, wanted, atol=1e-6)
        assert three.light.dtype == np.float32
        assert 0 <= three.light.min() < three.light.max() <= 1
        assert (three.name, three.sha256) == (one.name, one.sha256)


def test_clips_made_from_photographs_have_moving_parts(tmp_path: Path) -> None:
    """A clip shows parts of one photograph only, and loading the data again gives the same
    clips."""
    import cv2

    rng = np.random.default_rng(1)
    for name, low in (("a.png", 0), ("b.jpg", 0), ("c.png", 128)):
        picture = cv2.resize(rng.integers(low, low + 128, (40, 60), np.uint8), (480, 320))
        cv2.imwrite(str(tmp_path / name), picture)
    found = loaded(tmp_path, paths=4)
    assert {s.name.partition(",")[0] for s in found.train} == {"b.jpg", "c.png"}
    assert {s.name.partition(",")[0] for s in found.val} == {"a.png"}
    moved = 0
    for scene, again in zip(found.train, loaded(tmp_path, paths=4).train, strict=True):
        assert np.array_equal(scene.light, again.light)
        assert scene.light.shape == (3, 256, 256)
        assert 0 <= scene.light.min() < scene.light.max() <= 1
        moved += bool(np.abs(np.diff(scene.light, axis=0)).mean() > 1e-4)
    assert moved >= 4
    stored = loaded(tmp_path, paths=4, transfer="linear").train[0].light
    assert np.all(stored >= found.train[0].light - 1e-6)


def smooth_panorama() -> Any:
    """Light that a direction (ahead, right, down) has: 2 + 0.9 ahead - 0.6 right + 0.5 down."""
    rows, cols = np.mgrid[:512, :1024] + 0.5
    longitude, latitude = cols / 1024 * 2 * np.pi, (rows / 512 - 0.5) * np.pi
    ahead, right = np.cos(latitude) * np.cos(longitude), np.cos(latitude) * np.sin(longitude)
    return (2 + 0.9 * ahead - 0.6 * right + 0.5 * np.sin(latitude)).astype(np.float32)


@pytest.mark.parametrize("yaw", [0.0, 100.0, 179.9, 300.0, 721.0])
@pytest.mark.parametrize("pitch", [0.0, 14.0, -20.0])
def test_a_view_samples_the_panorama_along_pinhole_rays(yaw: float, pitch: float) -> None:
    """Rays of a pinhole with 90 degrees, turned by matrices; pitch is upwards."""
    found = view(smooth_panorama(), np.radians(yaw), np.radians(pitch), 40)
    a, b = np.radians(yaw), np.radians(pitch)
    up = np.array([[np.cos(b), 0, np.sin(b)], [0, 1, 0], [-np.sin(b), 0, np.cos(b)]])
    around = np.array([[np.cos(a), -np.sin(a), 0], [np.sin(a), np.cos(a), 0], [0, 0, 1]])
    for row in range(0, 40, 3):
        for col in range(0, 40, 3):
            ray = np.array([1.0, (col + 0.5) / 20 - 1, (row + 0.5) / 20 - 1])
            ahead, right, down = around @ up @ (ray / np.linalg.norm(ray))
            wanted = 2 + 0.9 * ahead - 0.6 * right + 0.5 * down
            assert found[row, col] == pytest.approx(wanted, abs=1e-3)


def test_objects_before_a_turning_camera_keep_their_size(monkeypatch: pytest.MonkeyPatch) -> None:
    """Their texture is a plane of slope 1 down and 2 across, so this ratio stays wherever they are
    and however bright."""
    rows, cols = np.mgrid[:64, :64].astype(np.float32)
    texture = 100 + rows + 2 * cols
    ratios: list[float] = []
    for seed in range(8):
        views = iter([np.ones((64, 64), np.float32)] * 3)
        monkeypatch.setattr(turning_camera, "view", lambda *_, views=views: next(views, texture))
        for frame in turned(rows, np.random.default_rng(seed), 3, 64).astype(np.float64):
            down, across = np.diff(frame, axis=0)[:-1, :-2], np.diff(frame, axis=1)[:-2, :-1]
            # The border of an object, and of a reflection in it, is bent.
            bend = np.abs(np.diff(frame, 2, axis=0))[:, :-2] + np.abs(np.diff(frame, 2))[:-2]
            inside = (bend < 0.01 * np.abs(down)) & (np.abs(down) > 1e-3)
            ratios += np.abs(across[inside] / down[inside]).tolist()
    assert len(ratios) > 1000
    np.testing.assert_allclose(np.quantile(ratios, [0.05, 0.95]), 2, rtol=0.01)


def test_a_turning_camera_moves_the_whole_picture() -> None:
    light = np.exp(np.random.default_rng(5).normal(0, 1, (128, 256))).astype(np.float32)
    moved = 0
    for seed in range(6):
        found = turned(light, np.random.default_rng(seed), 7, 96)
        assert (found.shape, found.dtype) == ((7, 96, 96), np.float32)
        assert np.isfinite(found).all()
        assert found.min() >= 0
        assert np.array_equal(found, turned(light, np.random.default_rng(seed), 7, 96))
        draws = np.random.default_rng(seed)
        yaw, pitch = np.radians(draws.uniform(0, 360)), np.radians(draws.uniform(-15, 15))
        size, angle = np.exp(draws.uniform(*np.log((0.1, 4.0)))), draws.uniform(0, 2 * np.pi)
        along, across = np.radians(size * np.array([np.sin(angle), np.cos(angle)]) * (0.3, 1.0))
        first = view(light, yaw, pitch, 96)
        shown = [found[k] == view(light, yaw + across * k, pitch + along * k, 96) for k in range(7)]
        # three things of a fifth of the side at most cover less than two fifths of the picture
        assert min(np.mean(part) for part in shown) > 0.6
        assert min(np.mean(part) for part in shown) < 1
        if abs(across) > np.radians(0.1):
            assert np.mean(found[6] == first) < 0.2
            moved += 1
    assert moved >= 2
    other = turned(light, np.random.default_rng(9), 7, 96)
    assert not np.array_equal(other, turned(light, np.random.default_rng(8), 7, 96))


def test_a_dark_panorama_and_one_pixel_of_light_stay_finite() -> None:
    """A turned panorama of zeros is zero. With one pixel of a million it is finite and not
    negative."""
    dark = np.zeros((64, 128), np.float32)
    assert (turned(dark, np.random.default_rng(1), 3, 32) == 0).all()
    dark[30, 60] = 1e6
    found = turned(dark, np.random.default_rng(1), 3, 32)
    assert np.isfinite(found).all()
    assert found.min() >= 0


def test_a_file_is_never_in_both_training_and_validation_data(tmp_path: Path) -> None:
    for seed in range(6):
        panorama(tmp_path / f"p{seed}.hdr", seed)
    (tmp_path / "p9.hdr").write_bytes((tmp_path / "p0.hdr").read_bytes())  # under two names
    found = loaded(tmp_path)
    sides = [{s.sha256 for s in part} for part in (found.train, found.val)]
    assert not sides[0] & sides[1]
    assert [len(side) for side in sides] == [4, 2]
    assert len(found.train) == 12
    assert {s.name.partition(",")[0] for s in found.val} == {"p0.hdr", "p5.hdr", "p9.hdr"}
    listed = found.split()
    assert len(listed["val"]) == len(found.val)
    (tmp_path / "val").mkdir()
    (tmp_path / "p3.hdr").rename(tmp_path / "val/renamed.hdr")
    assert loaded(tmp_path, str(tmp_path / "val"))
    panorama(tmp_path / "val/p1.hdr", 1)
    with pytest.raises(Rejected, match="NS0811"):
        loaded(tmp_path, str(tmp_path / "val"))


def test_a_single_panorama_is_refused_for_training(tmp_path: Path) -> None:
    panorama(tmp_path / "p.hdr", 1)
    with pytest.raises(Rejected, match="NS0811"):
        loaded(tmp_path, paths=20)


@pytest.mark.parametrize(("side", "is_refused"), [(31, True), (32, False)])
def test_stills_for_lessons_are_cut_from_pictures_of_two_patches_by_two(
    tmp_path: Path, side: int, is_refused: bool
) -> None:
    import cv2

    cv2.imwrite(str(tmp_path / "small.png"), np.full((side, 64), 90, np.uint8))
    settings = DataSettings(str(tmp_path), patch=16)
    if is_refused:
        with pytest.raises(Rejected, match="NS0811") as refusal:
            load_scenes(settings, still=True, slots=4, seed=0, pictures=True)
        assert "31 x 64, but lessons need 32 x 32" in str(refusal.value)
        return
    scenes = load_scenes(settings, still=True, slots=4, seed=0, pictures=True)
    lessons = LessonSet(
        [scene.light for scene in scenes.train],
        settings_of({"decoder": {"lessons": "stills"}, "data": {"patch": 16}}),
    )
    assert {lessons[step].light.shape for step in range(8)} == {(4, 1, 16, 16)}


@pytest.mark.parametrize(("name", "best"), [("away", -1), ("near", None)])
def test_the_best_state_is_that_of_the_least_loss(
    name: str, best: int | None, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The state of least loss counts even if its PSNR is lower."""
    (tmp_path / "losses_of_best.py").write_text(
        "def away(p, t):\n    return -(p - t).abs().mean()\n"
        "def near(p, t):\n    return (p - t).abs().mean()\n"
    )
    monkeypatch.chdir(tmp_path)
    values = {
        "shutter": {"slots": 16, "tile": [2, 2], "learn": False},
        "data": {"patch": 16, "scenes": 2, "val_items": 2},
        "loss": {"name": f"losses_of_best:{name}"},
        "train": {"steps": 8, "batch": 1, "validate_every": 2, "rate": 0.01},
    }
    train(settings_of(values), tmp_path / "r")
    rows = [row.split(",") for row in (tmp_path / "r/metrics.csv").read_text().splitlines()[1:]]
    val = [(int(r[0]), float(r[2]), float(r[3])) for r in rows if r[1] == "val"]
    losses, decibels = [v[1] for v in val], [v[2] for v in val]
    least, highest = int(np.argmin(losses)), int(np.argmax(decibels))
    if best is not None:
        assert val[least][0] == 8
        assert highest == 0
    with safe_open(str(tmp_path / "r/checkpoint.safetensors"), framework="pt") as file:
        about = json.loads(file.metadata()["nscc"])
        kept = {k: file.get_tensor(k) for k in file.keys()}  # noqa: SIM118
    assert (about["best_step"], about["best_loss"]) == (val[least][0], repr(losses[least]))
    for key, tensor in load_file(tmp_path / "r/decoder.safetensors").items():
        assert torch.equal(tensor, kept[f"best.decoder.{key}"])


def test_the_settings_together_and_paths_must_be_above_0(tmp_path: Path) -> None:
    (tmp_path / "c.toml").write_text("[data]\ntogether = 0\npaths = 0\n")
    found = invoke(["train", "c.toml", "--out", "r"], tmp_path)
    assert (found.status, found.codes) == (2, ["NS0815", "NS0815"])
