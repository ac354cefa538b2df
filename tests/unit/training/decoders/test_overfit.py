"""A network that cannot learn one batch by heart learns nothing: 40 dB within 500 steps."""

from __future__ import annotations

import pytest
from marks import slow

torch = pytest.importorskip("torch")

from nscc_training.curves import mu_law  # noqa: E402
from nscc_training.data import Batch, ExposureSet, cut_batch, load_scenes  # noqa: E402
from nscc_training.decoders.declared import DecoderTask  # noqa: E402
from nscc_training.decoders.decoder_building import make_decoder  # noqa: E402
from nscc_training.encoders import ShutterSpec, make_encoder  # noqa: E402
from nscc_training.losses import LOSSES  # noqa: E402
from nscc_training.sensor_model import SensorModel, differentiable_capture  # noqa: E402
from nscc_training.settings import DataSettings  # noqa: E402

SENSOR = SensorModel(30000.0, 30000.0 / 255)


def one_batch(still: bool, spec: ShutterSpec) -> Batch:
    """A made still; for clips a smooth thing that moves, which a convolution can know by heart."""
    if still:
        data = DataSettings(patch=16, scenes=2, augment=False)
        scenes = load_scenes(data, True, spec.slots, seed=1)
        drawn = ExposureSet(scenes, data, slots=spec.slots, batch=1, seed=1)[0]
        return cut_batch(drawn, data, 30000.0, torch.device("cpu"))
    t, y, x = torch.meshgrid(torch.arange(8.0), *[torch.arange(16.0)] * 2, indexing="ij")
    truth = 0.2 + torch.exp(-((x - 3 - t) ** 2 + (y - 10 + t / 2) ** 2) / 18)
    light = truth[None] * (30000.0 / spec.slots)
    return Batch(light, truth[None], torch.tensor([1.2]), ("a thing that moves",))


def decibels(kind: str, name: str, loss_name: str, steps: int, rate: float) -> float:
    """The best PSNR of one noiseless batch, on 0..1 of each patch's peak, within so many steps.

    Stills are learned and scored on the mu-law of light, clips on light.
    """
    still = kind == "still"
    spec = ShutterSpec("b", 64, (2, 2)) if still else ShutterSpec("e", 8, (8, 8))
    encoder = make_encoder(spec, "quad" if still else "random", seed=1)
    batch = one_batch(still, spec)
    torch.manual_seed(0)
    decoder = make_decoder(name, "small", DecoderTask(kind, spec.slots, spec.tile))
    optimiser = torch.optim.Adam(decoder.parameters(), lr=rate)
    shutters = encoder.hard()
    frame = differentiable_capture(batch.light, shutters, SENSOR).frame / SENSOR.top_code
    peak = batch.peak.reshape(-1, *([1] * (batch.truth.ndim - 1)))
    curve = mu_law if still else (lambda x: x)
    truth = curve((batch.truth / peak).clamp(0, 1))
    best = 0.0
    for step in range(steps):
        for group in optimiser.param_groups:
            group["lr"] = rate * (1 - step / steps)
        optimiser.zero_grad()
        made = decoder(frame, shutters) / peak
        loss = LOSSES[loss_name](curve(made), curve(batch.truth / peak))
        loss.backward()
        optimiser.step()
        error = (curve(made.detach().clamp(0, 1)) - truth).square().mean().item()
        best = max(best, -10 * torch.log10(torch.tensor(error)).item())
        if best > 40:
            break
    return best


@pytest.mark.parametrize(
    ("kind", "name", "loss", "rate"),
    [
        ("still", "unet2d", "l1", 2e-3),
        ("clip", "fcnet", "l1", 3e-3),
        ("clip", "unet2d", "l1", 3e-3),
        ("clip", "unet2d", "psnr", 3e-3),
        slow("clip", "unet3d", "l1", 3e-3),
        slow("clip", "unet3d", "psnr", 2e-3),
    ],
)
def test_decoders_learn_one_batch_by_heart(kind: str, name: str, loss: str, rate: float) -> None:
    # After 500 steps; 40 dB are an error of one percent.
    assert decibels(kind, name, loss, 500, rate) > 40
