"""Hard case 25: with bf16 autocast around it the sensor's physics stays what it is."""

from __future__ import annotations

import pytest

torch = pytest.importorskip("torch")

from nscc_training.encoders import ShutterSpec, make_encoder  # noqa: E402
from nscc_training.sensor_model import SensorModel, differentiable_capture  # noqa: E402

SPECS = [
    ShutterSpec("b", 64, (4, 4)),
    ShutterSpec("d", 16, (4, 4)),
    ShutterSpec("e", 13, (4, 4)),
    ShutterSpec("codebook", 16, (4, 4), rows=16),
]


@pytest.mark.parametrize("kind", [torch.bfloat16, torch.float16])
@pytest.mark.parametrize("relaxation", ["straight-through", "sigmoid"])
@pytest.mark.parametrize("spec", SPECS, ids=lambda spec: spec.kind)
def test_autocast_gives_the_same_numbers(
    spec: ShutterSpec, relaxation: str, kind: torch.dtype
) -> None:
    encoder = make_encoder(spec, "random", 1, relaxation)
    model = SensorModel(30000.0, 30000.0 / 255, shot_noise=True, adc_noise_lsb=0.65)
    light = torch.exp(torch.rand(2, spec.slots, 8, 8) * 30 - 10)  # 4e-5 .. 5e8 electrons
    found = []
    for enabled in (False, True):
        generator = torch.Generator().manual_seed(5)
        encoder.zero_grad()
        with torch.autocast("cpu", kind, enabled=enabled):
            result = differentiable_capture(light, encoder, model, generator=generator)
            loss = result.frame.double().sum()
        loss.backward()
        found.append((result, [p.grad.clone() for p in encoder.parameters()]))
    assert torch.equal(found[0][0].exposure_e, found[1][0].exposure_e)
    assert torch.equal(found[0][0].frame, found[1][0].frame)
    assert torch.isfinite(found[1][0].exposure_e).all()
    for plain, mixed in zip(found[0][1], found[1][1], strict=True):
        assert torch.equal(plain, mixed)
