"""The decoder for any code: its data term, its stages, frames of every program."""

from __future__ import annotations

import json
from contextlib import nullcontext
from importlib.resources import files
from pathlib import Path

import numpy as np
import pytest
from marks import slow
from nscc_command import invoke

torch = pytest.importorskip("torch")

from small_runs import run  # noqa: E402

from nscc_training import made_scenes  # noqa: E402
from nscc_training.any_code.decode import decoded_clip, decoded_still, white  # noqa: E402
from nscc_training.any_code.frames import coded_frame  # noqa: E402
from nscc_training.any_code.lessons import Lesson, mask_drawn, measured_lesson  # noqa: E402
from nscc_training.any_code.network import exchanged  # noqa: E402
from nscc_training.any_code.stages import (  # noqa: E402
    led,
    mirrored,
    schedule,
    stage,
    started_still,
)
from nscc_training.baselines.gap_tv import gap_tv_of  # noqa: E402
from nscc_training.baselines.tensor_tv import tv_by_operators, tv_denoised  # noqa: E402
from nscc_training.baselines.tv_loop import tv_denoise  # noqa: E402
from nscc_training.loop.optimizers import Muon  # noqa: E402
from nscc_training.measured import Measured  # noqa: E402
from nscc_training.sensor_model import SensorModel  # noqa: E402


def psnr_db(found: np.ndarray, truth: np.ndarray) -> float:
    return float(-10 * np.log10(np.mean((np.clip(found, 0, 1) - truth) ** 2)))


def any_clip(frame: np.ndarray, mask: np.ndarray, count: int = 12) -> np.ndarray:
    """The clip of one frame without noise."""
    pair = (torch.from_numpy(np.asarray(part, np.float32))[None] for part in (frame, mask))
    return decoded_clip(Measured.exact(*pair), count)[0].numpy()


def scene(seed: int, frames: int, size: int, share: float = 0.5) -> tuple[np.ndarray, np.ndarray]:
    """A made clip and a random mask."""
    generator = np.random.default_rng([7, seed])
    clip = made_scenes.clip(generator, frames, size)
    return clip, (generator.random(clip.shape) < share).astype(np.float32)


def random_measured(buckets: int, disjoint: bool = False) -> Measured:
    generator = torch.Generator().manual_seed(buckets)
    mask = torch.rand(2, buckets, 5, 3, 4, generator=generator)
    if disjoint:
        owner = torch.randint(buckets, (2, 1, 5, 3, 4), generator=generator)
        mask = mask * (owner == torch.arange(buckets).reshape(1, -1, 1, 1, 1))
    value = torch.rand(2, buckets, 3, 4, generator=generator) * 3
    variance = torch.rand(2, buckets, 3, 4, generator=generator) + 0.1
    return Measured(value, mask, variance, torch.zeros_like(value, dtype=torch.bool))


@pytest.mark.parametrize(("buckets", "disjoint"), [(1, False), (2, False), (3, False), (3, True)])
def test_a_correction_is_the_most_likely_error(buckets: int, disjoint: bool) -> None:
    """The expected value is the posterior mean of one pixel's slots, from dense matrices in
    float64."""
    measured = random_measured(buckets, disjoint)
    assert measured.disjoint == (disjoint or buckets == 1)
    sigma = torch.tensor([0.5, 2.0])
    found = measured.correction(measured.value, sigma)
    for place in ((0, 0, 0), (1, 2, 3)):
        batch, row, col = place
        mask = measured.mask[batch, :, :, row, col].double().numpy()
        noise = np.diag(measured.variance[batch, :, row, col].double().numpy())
        gap = measured.value[batch, :, row, col].double().numpy()
        spread = float(sigma[batch]) ** 2
        joint = spread * mask @ mask.T + noise
        wanted = spread * mask.T @ np.linalg.solve(joint, gap)
        np.testing.assert_allclose(found[batch, :, row, col], wanted, rtol=2e-3, atol=1e-4)


def test_saturated_values_are_lower_bounds_and_noisier_values_weigh_less() -> None:
    """If all values are saturated, a larger estimate has no gap and a smaller one has. Four times
    the variance lowers the weight."""
    measured = random_measured(1)
    full = Measured(
        measured.value, measured.mask, measured.variance, torch.ones_like(measured.saturated)
    )
    gap = full.missing(measured.value + 1, measured.value)
    assert torch.equal(gap, torch.zeros_like(gap))
    assert (full.missing(measured.value - 1, measured.value) > 0).all()
    sigma = torch.tensor([0.5, 0.5])
    noisier = Measured(measured.value, measured.mask, 4 * measured.variance, measured.saturated)
    assert (noisier.trust(sigma) < measured.trust(sigma)).all()


def test_the_start_is_gap_tv_of_light_that_stood_still() -> None:
    clip, mask = scene(1, 8, 40)
    frame, energy = (clip * mask).sum(axis=0), np.maximum(mask.sum(axis=0), 1e-6)
    wanted = np.broadcast_to(frame / energy, mask.shape)
    target = frame.copy()
    for _ in range(20):
        seen = (mask * wanted).sum(axis=0)
        target += frame - seen
        wanted = tv_denoise(
            (wanted + mask * ((target - seen) / energy)).astype(np.float32), 0.1, 5, 0.3
        )
    measured = Measured.exact(*(torch.from_numpy(part)[None] for part in (frame, mask)))
    np.testing.assert_allclose(gap_tv_of(measured, 20)[0][0], wanted, atol=2e-5)


def test_slots_that_are_open_nowhere_are_not_darker() -> None:
    """Bumps of eight slots in the first half of a long frame, and light that stands still."""
    still = made_scenes.clip(np.random.default_rng(4), 1, 32)[0]
    first = np.add.outer(8 * np.arange(32), 16 * np.arange(32)) % 25
    slot = np.arange(48)[:, None, None]
    mask = ((slot >= first) & (slot < first + 8)).astype(np.float32)
    found = any_clip(8 * still, mask, 2)
    means = found.mean(axis=(1, 2)) / still.mean()
    np.testing.assert_allclose(means, 1, atol=0.03)


def test_a_stage_without_noise_and_denoiser_gives_the_frame() -> None:
    clip, mask = scene(2, 6, 24)
    measured = Measured.exact(
        *(torch.from_numpy(part)[None] for part in ((clip * mask).sum(axis=0), mask))
    )
    now, target = gap_tv_of(measured, 3)
    for sigma in schedule(2):
        now, target = stage(measured, lambda noisy, _seen, _sigma: noisy, now, target, sigma)
        # Asked for again: what the clip before lacked, on top of the frame.
        open_somewhere = measured.energy > 0
        np.testing.assert_allclose(
            measured.of(now)[open_somewhere], target[open_somewhere], atol=1e-4
        )


def test_each_stage_mirrors_what_the_denoiser_sees_and_its_answer_back() -> None:
    """A denoiser that pushes clips down and to the right leads nowhere: four stages have pushed to
    all sides."""
    clip = torch.zeros(1, 5, 7, 9)
    clip[0, 2, 3, 4] = 1
    planes = clip.unsqueeze(1).expand(-1, 3, -1, -1, -1)
    shifted = []

    def denoiser(seen: torch.Tensor, told: torch.Tensor, _level: torch.Tensor) -> torch.Tensor:
        assert torch.equal(told[:, 0], seen)  # the planes are mirrored with the clip
        return seen.roll((1, 2), (-2, -1))

    for number in range(4):
        made = mirrored(denoiser, number)(clip, planes, torch.ones(1))
        shifted.append((made[0].nonzero()[0] - torch.tensor([2, 3, 4])).tolist())
    assert sorted(shifted) == [[0, -1, -2], [0, -1, 2], [0, 1, -2], [0, 1, 2]]


def test_corrected_clips_reproduce_exact_frames() -> None:
    """`led` corrects a clip that is 0.3 too bright, so that it gives the frame through the mask."""
    clip, mask = scene(4, 6, 24)
    frame = (clip * mask).sum(axis=0)
    measured = Measured.exact(*(torch.from_numpy(part)[None] for part in (frame, mask)))
    found = led(measured, torch.from_numpy(clip)[None] + 0.3)
    open_somewhere = (mask.sum(axis=0) > 0)[None, None]
    np.testing.assert_allclose(
        measured.of(found)[open_somewhere], measured.value[open_somewhere], atol=1e-5
    )
    # The correction is the smallest possible: values in closed slots stay as they were.
    closed = mask == 0
    np.testing.assert_allclose(found[0].numpy()[closed], clip[closed] + 0.3, atol=1e-6)


@pytest.mark.parametrize("seed", range(3))
def test_decoded_stills_have_less_error_than_their_start(seed: int) -> None:
    """The error is the mean squared difference of logarithms, for a 2 x 2 tile and a noisy
    sensor."""
    generator = np.random.default_rng([8, seed])
    light = made_scenes.still(generator, 96)
    light /= np.quantile(light, 0.7)
    share = np.tile(np.array([[1, 1 / 4], [1 / 16, 1 / 64]], np.float32), (48, 48))
    sensor = SensorModel(30000.0, 30000 / 255, adc_noise_lsb=0.65, shot_noise=True)
    electrons = generator.poisson(np.minimum(light * share, 2) * 30000)
    codes = np.clip(np.rint(electrons / sensor.electrons_per_lsb), 0, 255).astype(np.float32)
    measured = Measured.read(codes[None], share[None, None], sensor).tensors()
    reached = [
        float(((made / 30000 + 1e-3).log() - torch.from_numpy(light + 1e-3).log()).square().mean())
        for made in (started_still(measured), decoded_still(measured))
    ]
    assert reached[1] < reached[0]


@pytest.mark.parametrize("count", [2, 4, 8])
@pytest.mark.parametrize("seed", range(2))
def test_decoded_clips_have_a_higher_psnr_than_their_gap_tv_start(seed: int, count: int) -> None:
    """The bits are random (seed 0) or those of a 2 x 2 tile (seed 1), for 2, 4 and 8 stages."""
    clip, mask = scene(10 + seed, 8, 64)
    if seed:
        first = np.tile(np.array([[0, 2], [4, 6]]), (32, 32))
        slot = np.arange(8)[:, None, None]
        mask = ((slot >= first) & (slot < first + 2)).astype(np.float32)
    frame = (clip * mask).sum(axis=0)
    measured = Measured.exact(*(torch.from_numpy(part)[None] for part in (frame, mask)))
    begun = psnr_db(gap_tv_of(measured)[0][0].numpy(), clip)
    assert psnr_db(any_clip(frame, mask, count), clip) > begun


@pytest.mark.parametrize(("frames", "rows", "cols"), [(1, 9, 16), (4, 37, 41), (30, 24, 20)])
def test_any_clip_returns_finite_light_for_any_length_and_size(
    frames: int, rows: int, cols: int
) -> None:
    """For clips of 1, 4 and 30 frames the light is finite and not negative, also where a pixel
    never opens."""
    generator = np.random.default_rng(frames)
    mask = (generator.random((frames, rows, cols)) < 0.5).astype(np.float32)
    mask[:, 2, 3] = 0
    found = any_clip(generator.random((rows, cols)).astype(np.float32) * mask.sum(axis=0), mask)
    assert found.shape == mask.shape
    assert np.isfinite(found).all()
    assert found.min() >= 0


def test_twice_the_light_gives_twice_the_clip() -> None:
    clip, mask = scene(3, 8, 32)
    frame = (clip * mask).sum(axis=0)
    np.testing.assert_allclose(
        any_clip(2e4 * frame, mask), 2e4 * any_clip(frame, mask), rtol=2e-2, atol=200
    )


def test_two_buckets_give_a_better_clip_than_one() -> None:
    clip, mask = scene(4, 8, 48)
    both = np.stack([mask, 1 - mask])
    frames = (clip * both).sum(axis=1)
    arrays = (frames, both, np.zeros_like(frames), np.zeros(frames.shape, bool))
    for_two = Measured(*(torch.from_numpy(part)[None] for part in arrays))
    found = decoded_clip(for_two)[0].numpy()
    assert psnr_db(found, clip) > psnr_db(any_clip(frames[0], mask), clip) + 1


@pytest.mark.parametrize("buckets", [1, 2])
def test_gap_tv_of_arrays_equals_that_of_tensors(buckets: int) -> None:
    """The measurement has noise, saturated pixels, and two buckets that share light."""
    clip, mask = scene(5, 6, 40)
    masks = np.stack([mask, np.maximum(mask, 1 - mask[::-1])])[:buckets].astype(np.float32)
    frames = (clip * masks).sum(axis=1).astype(np.float32)
    arrays = (frames, masks, 0.01 * frames + 1e-4, frames > np.quantile(frames, 0.95))
    measured = Measured(*(part[None] for part in arrays))
    assert measured.disjoint == (buckets == 1)
    for ours, of_torch in zip(
        gap_tv_of(measured, 8), gap_tv_of(measured.tensors(), 8), strict=True
    ):
        assert isinstance(ours, np.ndarray)
        np.testing.assert_allclose(ours, of_torch.numpy(), atol=2e-5)


def test_masks_are_of_every_kind_and_open_everywhere() -> None:
    """Sixty random masks hold 0 and 1 and open each pixel. Some repeat a tile and some do not."""
    generator = np.random.default_rng(1)
    drawn = [mask_drawn(generator, 8, 12) for _ in range(60)]
    assert all(mask.shape == (8, 12, 12) and set(np.unique(mask)) <= {0, 1} for mask in drawn)
    assert all(mask.any(axis=0).all() for mask in drawn)
    tiled = [np.array_equal(mask[:, :4, :4], mask[:, 4:8, 8:12]) for mask in drawn]
    # Some masks are tiled and some are not.
    assert 5 < sum(tiled) < 55


def test_measured_lessons_equal_light_through_the_masks_within_the_noise() -> None:
    """The standard deviation of the difference is the one that `variance` states. Saturated values
    are not compared."""
    generator = np.random.default_rng(4)
    noise = torch.Generator().manual_seed(4)
    off = []
    for _ in range(12):
        clip = np.kron(generator.random((2, 8, 4, 4)), np.ones((1, 1, 8, 8))).astype(np.float32)
        masks = np.stack([mask_drawn(generator, 8, 32) for _ in range(2)])
        pair = torch.from_numpy(clip), torch.from_numpy(masks)
        light, measured, shown = measured_lesson(Lesson(*pair, False, True, ("one",)), noise)
        assert bool((light >= 0).all())
        # The display's white, in units of what is guessed for white.
        assert shown is not None
        assert float((light / shown.reshape(-1, 1, 1, 1)).max()) <= 1.001
        gap = (measured.value - measured.of(light)) / measured.variance.sqrt()
        off.append(gap[~measured.saturated].numpy())
        assert bool((measured.value[measured.saturated] > 0).all())
    # Codes below 0 do not exist: the darkest places are less far off.
    assert 0.8 < np.concatenate(off).std() < 1.1


def test_white_is_a_quantile_of_the_pixels_that_ever_open() -> None:
    """For two scenes it is the 0.995 quantile of the pixels that open. For one that never opens it
    is 1."""
    generator = np.random.default_rng(2)
    mask = torch.from_numpy((generator.random((3, 1, 4, 20, 20)) < 0.3).astype(np.float32))
    mask[2] = 0
    value = torch.from_numpy(generator.random((3, 1, 20, 20)).astype(np.float32))
    measured = Measured(value, mask, torch.zeros_like(value), torch.zeros_like(value) > 0)
    found = white(measured)
    for k in range(2):
        opened = mask[k].sum(dim=(0, 1)) > 0
        wanted = np.quantile(measured.mean()[k][opened].numpy(), 0.995)
        assert float(found[k]) == pytest.approx(wanted, rel=1e-5)
    assert float(found[2]) == 1


@pytest.mark.parametrize("shape", [(2, 3, 9, 11), (1, 1, 5, 4), (3, 4, 1, 7)])
@pytest.mark.parametrize("time", [0.0, 0.3])
def test_total_variation_is_the_same_by_operators_and_by_the_loop(
    shape: tuple[int, ...], time: float
) -> None:
    """Clips of a batch do not mix: both results equal the loop over single clips."""
    clips = torch.rand(shape, generator=torch.Generator().manual_seed(1))
    by_loop, by_operators = (f(clips, 0.2, 6, time) for f in (tv_denoised, tv_by_operators))
    alone = np.stack([tv_denoise(clip.numpy(), 0.2, 6, time) for clip in clips])
    np.testing.assert_array_equal(by_loop, alone)
    np.testing.assert_allclose(by_operators, alone, atol=1e-6)
    with torch.device("meta"):
        assert tv_denoised(torch.empty(shape), 0.2, 6, time).shape == shape


def test_shipped_weights_are_small() -> None:
    weights = files("nscc_training.any_code") / "weights.safetensors"
    # 4 MiB, so that packages stay small.
    assert len(weights.read_bytes()) <= 4 << 20


@pytest.mark.parametrize("lessons", ["denoise", "codes", "stills"])
def test_lessons_resume_where_they_stopped(lessons: str, tmp_path: Path) -> None:
    """With Muon and a moving average, resumed lessons write the same bytes."""
    import cv2

    (tmp_path / "in").mkdir()
    noise = np.random.default_rng(5).integers(0, 255, (80, 90), np.uint8)
    cv2.imwrite(str(tmp_path / "in/p.png"), cv2.GaussianBlur(noise, (0, 0), 2))
    stills = lessons == "stills"
    values = {
        "shutter": {
            "class": "b" if stills else "c",
            "slots": 8,
            "tile": [2, 2],
            "length": 2,
            "learn": False,
        },
        "decoder": {"name": "any", "lessons": lessons, "films": 0.5, "stages": 4, "through": 2},
        "data": {
            "train": str(tmp_path / "in"),
            "val": "procedural",
            "patch": 16,
            "scenes": 4,
            "protocol": "hdr-v1" if stills else "video-v1",
            "val_items": 1,
        },
        "train": {"steps": 3, "batch": 1, "validate_every": 2, "optimizer": "muon", "average": 0.5},
    }
    run(values, tmp_path / "whole")
    run(values, tmp_path / "parts", stop_after=2)
    run(values, tmp_path / "parts")
    for name in ("decoder.safetensors", "metrics.csv", "checkpoint.safetensors", "result.json"):
        whole, parts = ((tmp_path / k / name).read_bytes() for k in ("whole", "parts"))
        assert whole == parts, name
    assert "nan" not in (tmp_path / "whole/metrics.csv").read_text()


@pytest.mark.parametrize("shape", [(3, 20), (20, 3), (8, 2, 2, 2), (8, 2, 3, 3, 3)])
def test_steps_of_muon_are_orthogonal(shape: tuple[int, ...]) -> None:
    """The singular values of a step are nearly equal, and its singular vectors are those of the
    gradient. Weights of 3D networks have channels last in memory."""
    weight = torch.zeros(shape)
    if weight.ndim == 5:
        weight = weight.to(memory_format=torch.channels_last_3d)
    weight.requires_grad_()
    gradient = torch.randn(*shape, generator=torch.Generator().manual_seed(4))
    optimizer = Muon([weight], lr=1.0)
    weight.grad = gradient
    optimizer.step()
    step, wanted = (x.detach().flatten(1).double() for x in (weight, gradient))
    # A step has singular values near 0.2 times the root of the longer side, made by few iterations.
    values = torch.linalg.svdvals(step) / (0.2 * max(step.shape) ** 0.5)
    assert ((values > 0.5) & (values < 1.4)).all()
    left, _, right = torch.linalg.svd(wanted, full_matrices=False)
    inner = left.mT @ -step @ right.mT
    assert torch.allclose(inner, torch.diag(inner.diagonal()), atol=0.05)


def test_neighbours_get_channels_and_gradients() -> None:
    """Values and gradients equal those of slices of whole clips."""

    def sliced(x: torch.Tensor, frames: int) -> torch.Tensor:
        parts, count = x.unflatten(0, (-1, frames)), x.shape[1] // 4
        before = torch.cat([parts[:, :1], parts[:, :-1]], dim=1)[:, :, :count]
        after = torch.cat([parts[:, 1:], parts[:, -1:]], dim=1)[:, :, count : 2 * count]
        return torch.cat([before, after, parts[:, :, 2 * count :]], dim=2).flatten(0, 1)

    for frames in (1, 2, 5):
        x, weight = torch.randn(2, 2 * frames, 8, 3, 4, dtype=torch.float64)
        x.requires_grad_()
        found, wanted = exchanged(x, frames), sliced(x, frames)
        assert torch.equal(found, wanted)
        slopes = [torch.autograd.grad((y * weight).sum(), x)[0] for y in (found, wanted)]
        assert torch.allclose(*slopes)


PROGRAMS = {
    "stops": "frame 16 slots of 1ms\ncode stop : 1..16\nopen when n < stop\n"
    "pixels stop = 1 + x % 16",
    "bits": "frame 6 slots of 1ms\ncode bits : bit[6]\nopen when bits[n]\n"
    "pixels bits = 1 + (13 * x + 29 * y) % 62",
    "unequal": "frame slots [1ms, 2ms, 4ms]\ncode skip : 0..3\nopen when n != skip\n"
    "pixels skip = (x + 2 * y) % 4",
    "buckets": "frame 4 slots of 1ms\ncode at : 1..3\nbucket early open when n < at\n"
    "bucket late open when n >= at\npixels at = 1 + (x + y) % 3",
}


@pytest.mark.parametrize(
    ("name", "effects"),
    [(name, "all") for name in PROGRAMS] + [slow(name, "none") for name in PROGRAMS],
)
def test_frames_of_every_program_are_reconstructed(name: str, effects: str, tmp_path: Path) -> None:
    (tmp_path / "p.nsl").write_text(f"nsl 1\n{PROGRAMS[name]}\n")
    scene = f"builtin:{'hdr' if name == 'stops' else 'motion'}"
    line = ["run", "p.nsl", "--scene", scene, "--effects", effects, "--keep", "light"]
    assert invoke([*line, "-o", "f.npz"], tmp_path).status == 0
    made = invoke(["reconstruct", "any", "f.npz", "-o", "o.npz"], tmp_path)
    assert made.status == 0, made.err
    light = np.load(tmp_path / "f.npz")["light"]
    arrays = dict(np.load(tmp_path / "o.npz"))
    assert arrays.pop("method") == ("network" if name in ("stops", "unequal") else "gap-tv")
    [(key, found)] = arrays.items()
    assert key == ("image" if name == "stops" else "video")
    truth = light.sum(axis=0) if key == "image" else light
    assert found.shape == truth.shape
    peak = float(np.percentile(truth, 99.9))
    # Decibels that a reconstruction reaches and a wrong unit, order or shutter does not.
    assert psnr_db(found / peak, np.clip(truth / peak, 0, 1)) > (
        24 if effects == "none" or name != "stops" else 20
    )


def test_older_files_need_their_program_and_others_are_refused(tmp_path: Path) -> None:
    (tmp_path / "p.nsl").write_text(f"nsl 1\n{PROGRAMS['unequal']}\n")
    line = ["run", "p.nsl", "--scene", "builtin:motion", "--effects", "all", "-o", "f.npz"]
    assert invoke(line, tmp_path).status == 0
    with np.load(tmp_path / "f.npz") as file:
        whole = dict(file)
    np.savez(tmp_path / "old.npz", **{k: v for k, v in whole.items() if k[:7] != "decode_"})
    refused = invoke(["reconstruct", "any", "old.npz", "-o", "o.npz"], tmp_path)
    assert (refused.status, refused.codes) == (2, ["NS0819"])
    assert "--program" in refused.err
    kept = ["reconstruct", "any", "f.npz", "-o", "a.npz", "--as", "image"]
    named = ["reconstruct", "any", "old.npz", "-o", "b.npz", "--as", "image", "--program", "p.nsl"]
    assert invoke(kept, tmp_path).status == invoke(named, tmp_path).status == 0
    assert (tmp_path / "a.npz").read_bytes() == (tmp_path / "b.npz").read_bytes()
    np.savez(tmp_path / "row.npz", **{**whole, "decode_row": whole["decode_row"][:9]})
    np.savez(tmp_path / "high.npz", **{**whole, "decode_row": whole["decode_row"] + 99})
    (tmp_path / "not.npz").write_bytes(b"PK")
    (tmp_path / "photo.png").write_bytes(b"\x89PNG\r\n")
    reasons = {
        "row.npz": "do not match each other",
        "high.npz": "do not match each other",
        "not.npz": "not an .npz file",
        "photo.png": "not an .npz file",
        "none.npz": "file does not exist",
        "a.npz": "array `meta` is missing",
    }
    for by in ("any", "clip"):
        for name, reason in reasons.items():
            refused = invoke(["reconstruct", by, name, "-o", "o.npz"], tmp_path)
            assert (refused.status, refused.codes) == (2, ["NS0819"]), refused.err
            if by == "any":
                assert reason in refused.err
    chip = invoke(["targets", "scamp5", "--toml"], tmp_path).out
    small = chip.replace("rows = 256", "rows = 64").replace('name = "scamp5"', 'name = "small"')
    (tmp_path / "small.toml").write_text(small)
    assert invoke(["build", "p.nsl", "--target", "small.toml", "-o", "s.icw"], tmp_path).status == 0
    other = invoke([*kept, "--program", "s.icw"], tmp_path)
    assert "it has 256 x 256 pixels, but 's.icw' has 64 x 256" in other.err
    assert invoke([*kept, "--force"], tmp_path).status == 2
    assert invoke(["reconstruct", "./any", *named[2:]], tmp_path).status == 2


def test_frames_of_another_program_are_refused(tmp_path: Path) -> None:
    """Programs are compared by the shutters in the frame, or without these by their digest."""
    for name, stop in (("p", "x % 5"), ("q", "y % 5")):
        text = "nsl 1\nframe 4 slots of 1ms\ncode stop : 0..4\nopen when n < stop\n"
        text += f"pixels stop = {stop}\n"
        (tmp_path / f"{name}.nsl").write_text(text)
        assert (
            invoke(["build", f"{name}.nsl", "-o", f"{name}.icw", "-O", "1"], tmp_path).status == 0
        )
    line = ["run", "p.icw", "--scene", "builtin:hdr", "-o", "f.npz"]
    assert invoke(line, tmp_path).status == 0
    with np.load(tmp_path / "f.npz") as file:
        old = {key: values for key, values in file.items() if key[:7] != "decode_"}
    np.savez(tmp_path / "old.npz", **old)
    for frame in ("f.npz", "old.npz"):
        line = ["reconstruct", "any", frame, "-o", "o.npz", "--as", "image", "--program"]
        for program in ("q.icw", "q.nsl"):
            refused = invoke([*line, program], tmp_path)
            assert (refused.status, refused.codes) == (2, ["NS0819"])
            assert "program_sha256" in refused.err
        for program in ("p.icw", "p.nsl"):
            assert invoke([*line, program], tmp_path).status == 0


@pytest.mark.parametrize("laid", [1, 2])
def test_a_dark_frame_replaces_the_predicted_bias(laid: int) -> None:
    """The frame has the pixels of `laid` x `laid` arrays, the dark frame those of one. Without the
    dark frame, the wrong `decode_bias_e` of 33 e is subtracted."""
    generator = np.random.default_rng(laid)
    light_e, dark = generator.uniform(50, 90, (1, 4 * laid, 6 * laid)), generator.random((1, 4, 6))
    gain, lsb_e = 0.5, 2.0
    read = gain * light_e / lsb_e + np.tile(dark, (1, laid, laid))
    arrays = {
        "frame": 7 + read, "saturated": np.zeros(read.shape, bool),
        "decode_shutter": np.full((1, 1, 1), 3, np.uint8), "decode_slot_us": np.ones(2),
        "decode_row": np.zeros(read.shape[1:], int), "decode_gain": np.full((1, 1), gain),
        "decode_bias_e": np.full((1, 1), 33.0), "decode_variance_e2": np.ones((1, 1)),
    }  # fmt: skip
    meta = {"adc_offset": 7, "electrons_per_lsb": lsb_e}
    found = coded_frame(arrays, meta, dark)
    np.testing.assert_allclose(found.value_e, light_e, rtol=1e-5)
    assert abs(coded_frame(arrays, meta).value_e - light_e).min() > 20


def test_dark_frames_that_are_missing_or_of_another_size_are_refused(tmp_path: Path) -> None:
    (tmp_path / "p.nsl").write_text(f"nsl 1\n{PROGRAMS['stops']}\n")
    for name, scene in (("f", "builtin:hdr"), ("d", "builtin:dark")):
        line = ["run", "p.nsl", "--scene", scene, "--exposure", "30000", "-o", f"{name}.npz"]
        assert invoke(line if name == "f" else line[:4] + line[6:], tmp_path).status == 0
    line = ["reconstruct", "any", "f.npz", "-o", "o.npz", "--dark"]
    assert invoke([*line, "d.npz"], tmp_path).status == 0
    with np.load(tmp_path / "d.npz") as file:
        whole = dict(file)
    cut = {name: whole[name][..., :99] for name in ("frame", "saturated")}
    np.savez(tmp_path / "s.npz", **{**whole, **cut})
    refused = invoke([*line, "s.npz"], tmp_path)
    assert (refused.status, refused.codes) == (2, ["NS0819"])
    assert "the dark frame has 256 x 99 pixels, but the frame has 256 x 256" in refused.err
    lost = invoke([*line, "none.npz"], tmp_path)
    assert "the file does not exist" in lost.err


def test_colours_are_decoded_one_by_one(tmp_path: Path) -> None:
    import cv2

    made = np.random.default_rng(2).integers(40, 200, (64, 64, 3)).astype(np.uint8)
    cv2.imwrite(str(tmp_path / "c.png"), cv2.resize(made, (256, 256)))
    (tmp_path / "p.nsl").write_text(f"nsl 1\n{PROGRAMS['stops']}\n")
    line = ["run", "p.nsl", "--scene", "c.png", "--color", "--exposure", "30000", "-o", "f.npz"]
    assert invoke(line, tmp_path).status == 0
    done = invoke(["reconstruct", "any", "f.npz", "-o", "o.npz"], tmp_path)
    assert done.status == 0, done.err
    image = np.load(tmp_path / "o.npz")["image"]
    assert image.shape == (256, 256, 3)
    with np.load(tmp_path / "f.npz") as file:
        whole = dict(file)
    meta = json.loads(str(whole["meta"]))
    del meta["colours"]
    one = {**whole, **{name: whole[name][1] for name in ("frame", "saturated")}}
    np.savez(tmp_path / "g.npz", **{**one, "meta": json.dumps(meta)})
    assert invoke(["reconstruct", "any", "g.npz", "-o", "g_o.npz"], tmp_path).status == 0
    assert np.array_equal(image[..., 1], np.load(tmp_path / "g_o.npz")["image"])


def test_weights_are_written_as_they_are_shipped(tmp_path: Path) -> None:
    """A new decoder starts with the shipped weights; from runs without any step, `write_shipped`
    writes equal ones."""
    from safetensors.torch import load_file, save_file

    from nscc_training.any_code.decode import WEIGHTS, AnyCode, write_shipped
    from nscc_training.any_code.network import ClipDenoiser
    from nscc_training.decoders.declared import DecoderTask

    for kind in ("clip", "still"):
        decoder = AnyCode(ClipDenoiser().widths, DecoderTask(kind, 16, (8, 8)), "small")
        (tmp_path / kind).mkdir()
        state = {name: weight.contiguous() for name, weight in decoder.state_dict().items()}
        save_file(state, tmp_path / kind / "decoder.safetensors")
    write_shipped(tmp_path / "clip", tmp_path / "still", tmp_path / WEIGHTS)
    shipped = Path(str(files("nscc_training.any_code") / WEIGHTS))
    wanted, found = load_file(shipped), load_file(tmp_path / WEIGHTS)
    assert wanted.keys() == found.keys()
    assert all(torch.equal(wanted[name], found[name]) for name in wanted)


def test_decoding_in_tiles_equals_decoding_the_whole(monkeypatch: pytest.MonkeyPatch) -> None:
    """The sides of the clip are not multiples of the tile; four stages mirror it in all ways."""
    from nscc_training.any_code import decode, stages

    monkeypatch.setattr(decode, "bf16_where_multiplied", nullcontext)
    generator = np.random.default_rng(5)
    clip = made_scenes.clip(generator, 4, 256)[:, :230, :209]
    mask = (generator.random(clip.shape) < 0.5).astype(np.float32)
    frame = (mask * clip).sum(axis=0)
    whole = any_clip(frame, mask, 4)
    monkeypatch.setattr(stages, "MOST_VALUES", 4 * 96 * 96)
    in_tiles = any_clip(frame, mask, 4)
    assert np.abs(in_tiles - whole).max() < 1e-4
    assert np.abs(in_tiles - whole).max() > 0
