"""The choice of a method by pixels that are left out: it follows the error against the truth."""

from __future__ import annotations

import numpy as np
import pytest

from nscc_training.measured import Measured
from nscc_training.reconstruct_any import best_weight, prediction_errors, with_weight


def coded(noise: float) -> tuple[Measured, np.ndarray]:
    """A square that moves over a ramp, and its frame with random shutters."""
    generator = np.random.default_rng(1)
    clip = np.broadcast_to(np.linspace(0.1, 0.4, 64, dtype=np.float32), (8, 64, 64)).copy()
    for k in range(8):
        clip[k, 20:40, 8 + 4 * k : 24 + 4 * k] = 0.9
    mask = (generator.random(clip.shape) < 0.5).astype(np.float32)
    value = (mask * clip).sum(axis=0) + noise * generator.standard_normal((64, 64))
    value = value.astype(np.float32)[None, None]
    variance = np.full_like(value, noise**2)
    return Measured(value, mask[None, None], variance, np.zeros(value.shape, bool)), clip


@pytest.mark.parametrize("noise", [0.01, 0.3])
def test_the_weight_of_total_variation_follows_the_noise(noise: float) -> None:
    """At weak and at strong noise the chosen weight has an error at most 15 % above the best of
    five weights."""
    measured, clip = coded(noise)
    weight, found = best_weight(measured, 20)
    errors = {
        w: float(np.sqrt(np.mean((with_weight(w, 20)(measured)[0] - clip) ** 2)))
        for w in (0.05, 0.1, 0.2, 0.5, 1.0)
    }
    assert errors[weight] < 1.15 * min(errors.values())
    np.testing.assert_array_equal(found, prediction_errors(measured, with_weight(weight, 20)))


@pytest.mark.parametrize("is_right", [True, False])
def test_the_method_that_predicts_better_is_chosen(
    monkeypatch: pytest.MonkeyPatch, is_right: bool
) -> None:
    """A network that knows the clip is chosen, one that returns grey is not."""
    torch = pytest.importorskip("torch")
    from nscc_training.any_code import decode
    from nscc_training.reconstruct_any import chosen_for_clip

    measured, clip = coded(0.01)
    white = np.quantile(measured.mean(), 0.995)
    answer = torch.from_numpy(clip[None] / white if is_right else np.full_like(clip, 0.5)[None])
    monkeypatch.setattr(decode, "decoded_clip", lambda _measured: answer.float())
    method, reason, _ = chosen_for_clip(measured)
    assert method == ("network" if is_right else "gap-tv")
    assert bool(reason) != is_right


def test_noise_of_the_pixels_that_are_left_out_does_not_hide_the_better_method(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """A network with 70 % of the errors of GAP-TV, beside noise that is larger than the errors."""
    torch = pytest.importorskip("torch")
    from nscc_training.any_code import decode
    from nscc_training.reconstruct_any import chosen_for_clip

    measured, clip = coded(1.0)
    white = np.quantile(measured.mean(), 0.995)
    weight, _ = best_weight(measured.over(np.array([white], np.float32)), 40)

    def closer(without: Measured) -> object:
        found = with_weight(weight, 40)(without)
        return torch.from_numpy((0.7 * found + 0.3 * clip / white).astype(np.float32))

    monkeypatch.setattr(decode, "decoded_clip", closer)
    assert chosen_for_clip(measured) == ("network", "", weight)
