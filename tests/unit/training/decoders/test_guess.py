"""First guesses: constant light comes back from any code, all else stays finite."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

torch = pytest.importorskip("torch")

from nscc_training.baselines.merge_loop import merged  # noqa: E402
from nscc_training.decoders import unet  # noqa: E402
from nscc_training.decoders.declared import DecoderTask  # noqa: E402
from nscc_training.decoders.decoder_building import make_decoder  # noqa: E402
from nscc_training.decoders.guess import averaged, clip_guess, still_guess  # noqa: E402
from nscc_training.decoders.unet import ClipUNet, StillUNet  # noqa: E402
from nscc_training.sensor_model import lifted  # noqa: E402

SIZES = [(1, 1), (1, 7), (5, 3), (16, 16), (33, 21)]


def drawn(*shape: int, seed: int = 0) -> Any:
    return torch.rand(shape, generator=torch.Generator().manual_seed(seed), dtype=torch.float64)


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("scale", [1e-9, 1.0, 1e6])
def test_the_weighted_average_of_a_constant_is_the_constant(
    size: tuple[int, int], scale: float
) -> None:
    """Weights may be nearly 0, and most pixels have none."""
    weights = scale * drawn(2, 3, *size) * (drawn(2, 3, *size, seed=1) < 0.3)
    weights[..., 0, 0] = scale
    found = averaged(torch.full((2, 3, *size), 0.37, dtype=torch.float64), weights)
    assert found.shape == (2, 3, *size)
    assert (found - 0.37).abs().max() < 1e-12


def test_heavy_weights_limit_averages_to_3_by_3_pixels() -> None:
    """The expected mean of 3 x 3 pixels is written out. Its factors are 8 at the pixel, 1/2 beside
    it and 1/4 at the corners."""
    values, weights = drawn(1, 1, 6, 9).numpy()[0, 0], 1e7 * (1 + drawn(6, 9, seed=1).numpy())
    wanted = np.empty_like(values)
    near = {(0, 0): 8.0, (0, 1): 0.5, (1, 0): 0.5, (1, 1): 0.25}
    for row in range(6):
        for col in range(9):
            top = bottom = 0.0
            for r in range(max(0, row - 1), min(6, row + 2)):
                for c in range(max(0, col - 1), min(9, col + 2)):
                    part = near[abs(r - row), abs(c - col)] * weights[r, c]
                    top, bottom = top + part * values[r, c], bottom + part
            wanted[row, col] = top / bottom
    found = averaged(*(torch.from_numpy(x)[None, None] for x in (values, weights)))
    np.testing.assert_allclose(found[0, 0], wanted, rtol=1e-7)


@pytest.mark.parametrize("size", SIZES)
def test_an_average_is_between_the_least_and_the_largest_measured_value(
    size: tuple[int, int],
) -> None:
    values = drawn(1, 2, *size)
    weights = drawn(1, 2, *size, seed=1) * (drawn(1, 2, *size, seed=2) < 0.2)
    weights[..., -1, -1] = 1.0
    found = averaged(values, weights)
    for channel in range(2):
        measured = values[0, channel][weights[0, channel] > 0]
        assert found[0, channel].min() >= measured.min() - 1e-12
        assert found[0, channel].max() <= measured.max() + 1e-12
    # what has no weight says nothing, however loud
    shouting = torch.where(weights > 0, values, torch.full_like(values, 1e6))
    assert torch.allclose(averaged(shouting, weights), found)


def test_a_single_measurement_is_the_average_at_every_pixel() -> None:
    weights = torch.zeros(1, 1, 37, 50)
    weights[0, 0, 30, 2] = 5.0
    values = torch.zeros(1, 1, 37, 50)
    values[0, 0, 30, 2] = 0.8
    assert (averaged(values, weights) - 0.8).abs().max() < 1e-5


def test_gradients_of_averages_equal_finite_differences() -> None:
    values = drawn(1, 2, 5, 3).requires_grad_()
    weights = (0.05 + drawn(1, 2, 5, 3, seed=1)).requires_grad_()
    assert torch.autograd.gradcheck(averaged, (values, weights))


@pytest.mark.parametrize("light", [0.02, 0.7, 3.0, 60.0])
def test_the_guess_of_constant_light_is_exact_for_any_still_code(light: float) -> None:
    """Exposures of 1/256 to 1 saturate wherever light x share is a full well."""
    generator = torch.Generator().manual_seed(3)
    stops = torch.randint(0, 9, (2, 23, 18), generator=generator)
    share = 2.0**-stops
    found = still_guess((light * share).clamp(max=1), share)
    assert ((light * share) >= 1).any() == (light >= 1)
    assert (found / light - 1).abs().max() < 1e-4


def test_guesses_of_saturated_pixels_are_their_neighbours_light_or_the_least_that_saturates() -> (
    None
):
    share = torch.full((1, 9, 9), 1 / 16)
    share[0, 4, 4] = 0.5
    # The pixel saturates at a light of 1 / 0.5 = 2.
    for around, wanted in ((6.0, 6.0), (2.5, 2.5), (1.2, 2.0), (0.1, 2.0)):
        frame = around * share
        frame[0, 4, 4] = 1.0
        found = still_guess(frame, share)[0, 4, 4].item()
        assert found == pytest.approx(wanted, rel=1e-3)


def test_a_pixel_that_never_opens_takes_its_neighbours_light() -> None:
    share = torch.full((1, 9, 9), 0.25)
    share[0, 3, 5] = 0.0
    frame = 2.0 * share
    frame[0, 3, 5] = 0.02  # noise of the readout
    found = still_guess(frame, share)
    assert (found - 2.0).abs().max() < 1e-3


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("level", [0.0, 1.0, -0.02])
@pytest.mark.parametrize("opened", [0.0, 1 / 256, 1.0])
def test_guesses_from_constant_frames_and_shutters_are_finite(
    size: tuple[int, int], level: float, opened: float
) -> None:
    """Dark, full and negative frames with closed to open shutters give finite guesses and
    gradients. If shutters open, a dark or full frame is guessed as level / opened."""
    frame = torch.full((2, *size), level, requires_grad=True)
    found = still_guess(frame, torch.full(size, opened))
    found.sum().backward()
    assert torch.isfinite(found).all()
    assert torch.isfinite(frame.grad).all()
    if opened and level in (0.0, 1.0):
        assert torch.allclose(found, torch.full_like(found, level / opened))


def test_a_still_is_what_the_merging_baseline_makes_of_it() -> None:
    """An independent implementation, with its own sums and units."""
    rng = np.random.default_rng(5)
    rows, cols = np.mgrid[:24, :30]
    share = np.array([[1, 1 / 4], [1 / 16, 1 / 64]])[rows % 2, cols % 2]
    light = np.exp(1.2 + np.sin(rows / 5) + np.cos(cols / 6)) * rng.uniform(0.98, 1.02, (24, 30))
    frame = np.clip(np.rint(light * share * 255), 0, 255).astype(np.float32)
    assert 0.2 < (frame == 255).mean() < 0.6
    well = 30000.0
    # 0.65 codes are the noise of the converter.
    wanted = merged(frame, share, well / 255, frame >= 255, 0.65 * well / 255) / well
    found = still_guess(torch.from_numpy(frame / 255)[None], torch.from_numpy(share).float())
    np.testing.assert_allclose(found[0], wanted, rtol=5e-3)
    # and both say something about the light
    assert np.median(np.abs(found[0].numpy() / light - 1)) < 0.1


def random_shutters(slots: int, rows: int, cols: int) -> Any:
    generator = torch.Generator().manual_seed(4)
    shutters = (torch.rand(slots, rows, cols, generator=generator) < 0.3).float()
    shutters[:, rows // 2, cols // 2] = 0.0
    shutters[:, 0, 0] = 1.0
    return shutters


@pytest.mark.parametrize("size", SIZES[1:])
def test_the_guess_of_a_constant_clip_is_exact_for_any_code(size: tuple[int, int]) -> None:
    """One pixel never opens, one always; in every slot some pixel does."""
    shutters = random_shutters(5, *size)
    exposure = 0.3 * shutters.sum(dim=0)[None]
    volume, _ = lifted(exposure, shutters)
    assert (clip_guess(volume, shutters) - 0.3).abs().max() < 1e-5


def test_the_guess_of_a_slot_uses_only_the_pixels_that_were_open_in_it() -> None:
    """Half of the pixels are open in the first slot only, half in the second; the light of both
    slots is recovered."""
    rows, cols = np.mgrid[:12, :13]
    first = torch.from_numpy((rows + cols) % 2 == 0).float()
    shutters = torch.stack([first, 1 - first])
    exposure = (0.2 * first + 0.7 * (1 - first))[None]
    volume, _ = lifted(exposure, shutters)
    found = clip_guess(volume, shutters)
    assert (found[0, 0] - 0.2).abs().max() < 1e-5
    assert (found[0, 1] - 0.7).abs().max() < 1e-5


@pytest.mark.parametrize("size", SIZES)
def test_clips_without_any_light_or_shutter_stay_finite(size: tuple[int, int]) -> None:
    """With all shutters closed or open, and no light or full light, the guess is finite and is the
    lifted clip."""
    for shutters in (torch.zeros(3, *size), torch.ones(3, *size)):
        for level in (0.0, 1.0):
            volume, _ = lifted(torch.full((1, *size), level), shutters)
            found = clip_guess(volume, shutters)
            assert torch.isfinite(found).all()
            assert torch.allclose(found, volume)


def noisy_frame(rows: int, cols: int) -> Any:
    frame = torch.rand(2, rows, cols, generator=torch.Generator().manual_seed(6))
    frame[0, 2, 3], frame[1, 4, 4] = 1.0, 0.0
    return frame


def test_small_decoders_of_stills_begin_with_the_guess() -> None:
    decoder = make_decoder("unet2d", "small", DecoderTask("still", 16, (4, 4)))
    shutters = (torch.arange(16).reshape(-1, 1, 1) < torch.tensor([[1, 4], [16, 2]])).float()
    frame = noisy_frame(13, 10)
    wanted = still_guess(frame, shutters.mean(dim=0).repeat(7, 5)[:13])
    torch.testing.assert_close(decoder(frame, shutters), wanted, rtol=1e-5, atol=1e-6)


@pytest.mark.parametrize("name", ["unet2d", "unet3d"])
def test_small_decoders_of_clips_begin_with_the_guess(name: str) -> None:
    """Before any training the decoder returns the guess, to the bit."""
    decoder = make_decoder(name, "small", DecoderTask("clip", 5, (4, 4)))
    shutters, frame = random_shutters(5, 13, 10), noisy_frame(13, 10)
    # a frame counts full wells, a slot's light full wells / N
    wanted = clip_guess(lifted(5 * frame, shutters)[0], shutters)
    assert torch.equal(decoder(frame, shutters), wanted)


@pytest.mark.parametrize("name", ["unet2d", "unet3d"])
def test_the_last_layer_scales_the_guess_and_adds_to_it(name: str) -> None:
    """Its first half of biases is added to the guess, and its second half, plus 1, multiplies
    it."""
    decoder = make_decoder(name, "small", DecoderTask("clip", 5, (4, 4)))
    shutters, frame = random_shutters(5, 13, 10), noisy_frame(13, 10)
    guess = clip_guess(lifted(5 * frame, shutters)[0], shutters)
    bias = decoder.network.last.bias
    with torch.no_grad():
        for added, more in ((0.25, 0.0), (0.25, -1.0), (0.0, 0.5)):
            half = len(bias) // 2
            bias.copy_(torch.cat([torch.full((half,), added), torch.full((half,), more)]))
            wanted = added + guess * (1 + more)
            torch.testing.assert_close(decoder(frame, shutters), wanted, rtol=1e-6, atol=1e-6)


def test_first_guesses_are_not_rounded_to_bf16_under_autocast() -> None:
    """An untrained small decoder returns its first guess. Under autocast to bf16 this guess stays
    the same to 1e-5."""
    decoder = make_decoder("unet2d", "small", DecoderTask("still", 16, (4, 4)))
    shutters = (torch.arange(16).reshape(-1, 1, 1) < torch.tensor([[1, 4], [16, 2]])).float()
    frame = noisy_frame(13, 10)
    exact = decoder(frame, shutters)
    with torch.autocast("cpu", torch.bfloat16):
        torch.testing.assert_close(decoder(frame, shutters), exact, rtol=1e-5, atol=1e-6)


def test_only_decoders_with_guess_use_the_first_guess(monkeypatch: pytest.MonkeyPatch) -> None:
    """If a decoder has no guess, doubling the guess changes nothing."""
    unet_scale = [1.0]
    for name in ("still_guess", "clip_guess"):
        was = getattr(unet, name)
        monkeypatch.setattr(unet, name, lambda *x, was=was: was(*x) * unet_scale[0])
    shutters, frame = random_shutters(5, 13, 10), noisy_frame(13, 10)
    for guesses in (False, True):
        for decoder in (
            network((4, 8), DecoderTask(kind, 5, (13, 10), guess=guesses), "small")
            for network, kind in ((StillUNet, "still"), (StillUNet, "clip"), (ClipUNet, "clip"))
        ):
            made = []
            for scale in (1.0, 2.0):
                unet_scale[0] = scale
                made.append(decoder(frame, shutters))
            assert torch.equal(*made) != guesses
    # without the code there is nothing to guess from
    blind = StillUNet((4, 8), DecoderTask("still", 5, (13, 10), sees_code=False), "small")
    assert torch.equal(blind(frame, shutters), blind(frame, 1 - shutters))


@pytest.mark.parametrize(
    ("name", "kind", "channels"),
    [("unet2d", "still", 3), ("unet2d", "clip", 6), ("unet3d", "clip", 1)],
)
def test_networks_of_the_papers_size_start_without_a_guess(
    name: str, kind: str, channels: int
) -> None:
    """These networks keep the published inputs: their first layer has 3, 6 or 1 channels, and no
    guess is used."""
    with torch.device("meta"):
        decoder = make_decoder(name, "paper", DecoderTask(kind, 5, (4, 4)))
    first = decoder.network.down[0][0]
    assert first.in_channels == channels
    assert decoder.guesses is False


def test_the_setting_guess_adds_or_removes_the_first_guess() -> None:
    """It works in every size. Decoders without a first guess refuse it, and so do decoders that do
    not see the code."""
    still = DecoderTask("still", 5, (4, 4), guess=True)
    with torch.device("meta"):
        assert make_decoder("unet2d", "paper", still).network.down[0][0].in_channels == 4
        assert make_decoder("unet2d", "small", replace(still, guess=False)).guesses is False
    with pytest.raises(ValueError, match=r"decoder\.guess applies to unet2d and unet3d"):
        make_decoder("unrolled", "small", DecoderTask("clip", 5, (4, 4), guess=False))
    with pytest.raises(ValueError, match=r"needs decoder\.sees_code"):
        make_decoder("unet2d", "small", replace(still, sees_code=False))
