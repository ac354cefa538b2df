"""Losses in decibels against the metrics they stand for, and sums of losses."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

torch = pytest.importorskip("torch")

from nscc.diagnostics.diagnostic import Rejected  # noqa: E402
from nscc_training import metrics  # noqa: E402
from nscc_training.loop.setup import make_setup  # noqa: E402
from nscc_training.losses import LEAST_ERROR, LOSSES, Loss  # noqa: E402
from nscc_training.settings import settings_of  # noqa: E402


def pair(error: float) -> tuple[torch.Tensor, torch.Tensor]:
    generator = torch.Generator().manual_seed(2)
    truth = torch.rand(2, 9, 11, generator=generator, dtype=torch.float64)
    noise = torch.rand(2, 9, 11, generator=generator, dtype=torch.float64) - 0.5
    return (truth + error * noise).clamp(0, 1), truth


@pytest.mark.parametrize("error", [1.0, 0.1, 0.01])
def test_losses_in_decibels_equal_the_metrics(error: float) -> None:
    """Minus ten times the loss is the metric in dB, within 0.1, for errors of 1, 0.1 and 0.01. The
    loss adds LEAST_ERROR to the squared error."""
    made, truth = pair(error)
    for name, metric in (
        ("psnr", lambda t, m: metrics.psnr(t, m, 1.0)),
        ("psnr-mu", lambda t, m: metrics.mu_psnr(t, m, 1.0)),
    ):
        wanted = metric(truth.numpy(), made.numpy())
        assert wanted < 55
        assert -10 * LOSSES[name](made, truth).item() == pytest.approx(wanted, abs=0.1)
    # the least error is added, no more
    mse = float(np.mean((truth - made).numpy() ** 2))
    assert LOSSES["psnr"](made, truth).item() == pytest.approx(np.log10(mse + LEAST_ERROR))


def test_halving_the_error_lowers_the_psnr_loss_by_6_decibels_at_any_error() -> None:
    """The loss is the decimal logarithm of the squared error. It falls by 2 log10(2), whether the
    error was 0.5 or 0.05."""
    for error in (0.5, 0.05):
        values = []
        for part in (1.0, 0.5):
            made, truth = pair(error * part)
            truth = truth * 0 + 0.5
            made = truth + error * part * (pair(1.0)[1] - 0.5)
            values.append(LOSSES["psnr"](made, truth).item())
        # The loss is the decimal logarithm of the squared error.
        assert values[0] - values[1] == pytest.approx(2 * np.log10(2), abs=1e-3)


def test_display_errors_are_those_of_srgb() -> None:
    """The loss is the mean absolute difference of both pictures after the sRGB curve, also for
    values on its straight part."""
    made, truth = np.array([0.25, 0.81, 0.001, 0.0]), np.array([0.36, 0.49, 0.0, 0.002])
    shown = [
        np.where(x > 0.0031308, 1.055 * x ** (1 / 2.4) - 0.055, 12.92 * x) for x in (made, truth)
    ]
    wanted = np.abs(shown[0] - shown[1]).mean()
    found = LOSSES["display"](torch.from_numpy(made), torch.from_numpy(truth))
    assert found.item() == pytest.approx(wanted, rel=1e-12)


def loss_of(name: str) -> Loss:
    return make_setup(settings_of({"shutter": {"slots": 16}, "loss": {"name": name}})).loss


def test_a_sum_of_losses_has_the_sum_of_values_and_gradients() -> None:
    """The order and the blanks of the parts change nothing. A part named twice counts twice."""
    made, truth = (x.clone().requires_grad_() for x in pair(0.1))
    single = {name: LOSSES[name](made, truth) for name in ("psnr", "psnr-mu", "l1")}
    for text in ("psnr+psnr-mu+l1", " l1 + psnr-mu  +psnr"):
        found = loss_of(text)(made, truth)
        assert found.item() == pytest.approx(sum(x.item() for x in single.values()))
    (slope,) = torch.autograd.grad(found, made, retain_graph=True)
    parts = [torch.autograd.grad(x, made, retain_graph=True)[0] for x in single.values()]
    assert torch.allclose(slope, sum(parts))
    twice = loss_of("l1+l1")(made, truth)
    assert twice.item() == pytest.approx(2 * single["l1"].item())


def test_a_loss_by_import_path_is_added(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """`l1 + module:function` is the mean absolute difference plus the function's value."""
    (tmp_path / "loss_in_a_sum.py").write_text("def one(p, t):\n    return p.mean()\n")
    monkeypatch.chdir(tmp_path)
    made, truth = pair(0.1)
    found = loss_of("l1 + loss_in_a_sum:one")(made, truth)
    assert found.item() == pytest.approx((made - truth).abs().mean().item() + made.mean().item())


@pytest.mark.parametrize("name", ["psnr+psmr", "l1+", "+", "l1++mu-law", "", "l1,psnr"])
def test_an_unknown_part_is_refused(name: str) -> None:
    """A misspelt or empty part, or a comma, gives NS0815 with the list of losses."""
    with pytest.raises(Rejected) as caught:
        loss_of(name)
    (found,) = caught.value.diagnostics
    assert found.code == "NS0815"
    assert "psnr-mu" in found.message
