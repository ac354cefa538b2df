"""Hard case 18: S^T E of a pixel that never opens is 0, marked invalid, and has gradient 0."""

from __future__ import annotations

import pytest

torch = pytest.importorskip("torch")

from nscc_training.sensor_model import lifted  # noqa: E402


def test_a_pixel_that_never_opens_is_0_and_invalid_with_gradient_0() -> None:
    shutters = torch.tensor([[1.0, 0.0], [1.0, 0.0], [0.0, 0.0]]).reshape(3, 1, 2)
    shutters.requires_grad_()
    exposure = torch.tensor([[[8.0, 5.0]]], requires_grad=True)
    video, valid = lifted(exposure, shutters)
    assert valid.tolist() == [[True, False]]
    assert video[0, :, 0, 0].tolist() == [4.0, 4.0, 0.0]
    assert video[0, :, 0, 1].tolist() == [0.0, 0.0, 0.0]
    video.square().sum().backward()
    assert torch.isfinite(shutters.grad).all()
    assert exposure.grad[0, 0, 1] == 0
    assert (shutters.grad[:, 0, 1] == 0).all()
    assert exposure.grad[0, 0, 0] == 8.0


def test_nan_in_pixels_that_never_open_is_ignored() -> None:
    """The first pixel opens and keeps its 1.0. The second never opens, and its NaN becomes 0."""
    exposure = torch.tensor([[[1.0, float("nan")]]])
    shutters = torch.tensor([[1.0, 0.0]]).reshape(1, 1, 2)
    assert lifted(exposure, shutters)[0].tolist() == [[[[1.0, 0.0]]]]
