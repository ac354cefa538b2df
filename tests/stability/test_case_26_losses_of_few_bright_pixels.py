"""Hard case 26: a few bright pixels must not rule the loss on light of high dynamic range."""

from __future__ import annotations

import pytest

torch = pytest.importorskip("torch")

from nscc_training.losses import LOSSES  # noqa: E402


def share_of_the_brightest(name: str, seed: int) -> float:
    """The part of the loss that the top 0.1 % of lognormal light has, at 10 % error everywhere.

    Found by asking for the loss without them: a mean, so the parts add up.
    """
    generator = torch.Generator().manual_seed(seed)
    light = torch.exp(2.5 * torch.randn(200_000, generator=generator, dtype=torch.float64))
    truth, _ = torch.sort(light / torch.quantile(light[:100_000], 0.999))
    error = 1 + 0.2 * (torch.rand(truth.shape, generator=generator, dtype=torch.float64) - 0.5)
    loss = LOSSES[name]
    whole = loss(truth * error, truth) * len(truth)
    rest = loss((truth * error)[:-200], truth[:-200]) * (len(truth) - 200)
    return float((whole - rest) / whole)


@pytest.mark.parametrize("name", ["log", "mu-law", "pu21"])
def test_the_brightest_pixel_has_a_small_share_of_the_loss(name: str) -> None:
    assert share_of_the_brightest(name, 1) < 0.05


def test_bright_pixels_dominate_the_loss_of_linear_light() -> None:
    assert share_of_the_brightest("l1", 1) > 0.2


@pytest.mark.parametrize("name", [name for name in LOSSES if name != "class"])
def test_gradients_are_finite_without_light_and_at_a_sun(name: str) -> None:
    prediction = torch.tensor([0.0, -1e-7, 1e-6, 1e8, -3.0], requires_grad=True)
    truth = torch.tensor([0.5, 0.0, 0.0, 1.0, 0.0])
    loss = LOSSES[name](prediction, truth)
    loss.backward()
    assert torch.isfinite(loss)
    assert torch.isfinite(prediction.grad).all()
    assert (prediction.grad != 0).all()
    # tenths of dB below 0, down to an error of nothing: 70 dB
    least = -7.0 if name.startswith("psnr") else 0.0
    assert LOSSES[name](truth, truth).item() == pytest.approx(least, abs=1e-6)
