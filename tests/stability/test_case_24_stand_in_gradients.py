"""Hard case 24: gradients past a quantisation are 1 inside and at the bounds, 0 outside."""

from __future__ import annotations

import pytest

torch = pytest.importorskip("torch")

from nscc_training.code_choices import SLOPED  # noqa: E402
from nscc_training.encoders import ShutterSpec, make_encoder  # noqa: E402
from nscc_training.gradients import opened, rounded, saturated, signed  # noqa: E402
from nscc_training.sensor_model import SensorModel, differentiable_capture  # noqa: E402

SPECS = [
    ShutterSpec("b", 64, (8, 8)),
    ShutterSpec("c", 16, (8, 8), length=4),
    ShutterSpec("d", 16, (8, 8)),
    ShutterSpec("e", 13, (8, 8)),
    ShutterSpec("codebook", 16, (8, 8), rows=64),
]


def gradient(function: object, values: list[float]) -> list[float]:
    x = torch.tensor(values, dtype=torch.float64, requires_grad=True)
    function(x).sum().backward()  # type: ignore[operator]
    return list(x.grad.tolist())


def test_small_signals_have_the_digit_zero() -> None:
    values = [-1.001, -1.0, -0.1, 0.0, 0.7, 1.0, 1.001]
    assert gradient(signed, values) == [0, 1, 1, 1, 1, 1, 0]
    assert signed(torch.tensor(values)).tolist() == [0, 0, 0, 0, 1, 1, 1]


def test_rounding_and_clipping_have_stand_in_gradients() -> None:
    values = [-0.001, 0.0, 0.5, 1.5, 7.2, 8.0, 8.001]
    assert gradient(lambda x: rounded(torch.clamp(x, 0, 8)), values) == [0, 1, 1, 1, 1, 1, 0]
    assert rounded(torch.tensor([0.5, 1.5, 2.4])).tolist() == [0, 2, 2]
    assert gradient(lambda x: saturated(x, 0, 8), values) == [0, 1, 1, 1, 1, 1, 0]


def test_an_edges_gradient_has_unit_area() -> None:
    """However wide the stand-in is, moving an edge across all slots opens each of them once."""
    for width in (0.5, 1.0, 3.0):
        x = torch.linspace(-8, 8, 160001, dtype=torch.float64, requires_grad=True)
        opened(x, width).sum().backward()
        assert float(x.grad.sum()) * 1e-4 == pytest.approx(1.0, abs=1e-3)
        assert float(x.grad[x.detach().abs() > width + 1e-9].abs().sum()) == 0


@pytest.mark.parametrize("spec", SPECS, ids=lambda spec: spec.kind)
def test_gradients_of_soft_shutters_equal_finite_differences(spec: ShutterSpec) -> None:
    small = ShutterSpec(
        spec.kind, 6, (2, 2), length=2 if spec.length else None, rows=spec.rows and 4
    )
    encoder = make_encoder(small, "random", 2, "sigmoid").double()
    weights = torch.rand(6, 2, 2, dtype=torch.float64)
    for parameter in encoder.parameters():
        with torch.no_grad():
            parameter += 0.05 * torch.rand_like(parameter)

        def loss(values: torch.Tensor, parameter: torch.Tensor = parameter) -> torch.Tensor:
            return (encoder(None).double() * weights).sum()

        encoder.zero_grad()
        loss(parameter).backward()
        found = parameter.grad.clone().reshape(-1)
        flat = parameter.detach().reshape(-1)
        for place in range(0, flat.numel(), max(1, flat.numel() // 5)):
            kept = float(flat[place])
            ends = []
            for step in (-1e-3, 1e-3):
                flat[place] = kept + step
                ends.append(float(loss(parameter).detach()))
            flat[place] = kept
            assert found[place] == pytest.approx((ends[1] - ends[0]) / 2e-3, abs=2e-4)


@pytest.mark.parametrize("relaxation", SLOPED)
@pytest.mark.parametrize("spec", SPECS, ids=lambda spec: spec.kind)
def test_most_codes_have_a_gradient_at_the_start(spec: ShutterSpec, relaxation: str) -> None:
    """A parameter is dead if its gradient is exactly 0: it cannot learn from the batch."""
    encoder = make_encoder(spec, "random", 1, relaxation)
    generator = torch.Generator().manual_seed(0)
    # A third of the pixels would saturate if they were always open.
    light = 45000 * torch.rand(2, spec.slots, 16, 16, generator=generator) / spec.slots * 2
    model = SensorModel(30000.0, 30000.0 / 255, shot_noise=True)
    frame = differentiable_capture(light, encoder, model, generator=generator).frame
    (frame / 255).square().sum().backward()
    assert encoder.dead_share() < 0.5


def test_saturated_pixels_have_a_gradient_only_with_a_slope_above_the_full_well() -> None:
    """All pixels are saturated. With slope 0 all parameters are dead, with slope 0.1 none is."""
    encoder = make_encoder(ShutterSpec("b", 16, (4, 4)), "quad")
    light = torch.full((1, 16, 4, 4), 1e6)
    shares = []
    for slope in (0.0, 0.1):
        encoder.zero_grad()
        differentiable_capture(
            light, encoder, SensorModel(3e4, 3e4 / 255, slope=slope)
        ).frame.sum().backward()
        shares.append(encoder.dead_share())
    assert shares == [1.0, 0.0]
