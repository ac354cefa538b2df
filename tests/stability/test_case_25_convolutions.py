"""Hard case 25, the network's side: gradients under bf16 are those of float32, less precise."""

from __future__ import annotations

import pytest
from marks import slow

torch = pytest.importorskip("torch")

from nscc_training.decoders.declared import DecoderTask  # noqa: E402
from nscc_training.decoders.decoder_building import make_decoder  # noqa: E402


@pytest.mark.parametrize("side", [32, slow(64)])
@pytest.mark.parametrize("slots", [1, 8, 13, 16])
@pytest.mark.parametrize("name", ["unet2d", "unet3d", "unrolled"])
def test_gradients_of_small_networks_equal_finite_differences(
    name: str, slots: int, side: int
) -> None:
    torch.manual_seed(1)
    decoder = make_decoder(name, "small", DecoderTask("clip", slots, (4, 4)))
    for parameter in decoder.parameters():
        # Where a network begins by adding nothing, most of it has no gradient.
        torch.nn.init.normal_(parameter, std=0.05)
    frame, shutters = torch.rand(2, side, side), (torch.rand(slots, side, side) < 0.5).float()
    found = []
    for enabled in (False, True):
        # What was freed before is not zero: uninitialised memory does not pass for a gradient.
        del [torch.full((100_000,), float("nan")) for _ in range(20)][:]
        decoder.zero_grad()
        with torch.autocast("cpu", torch.bfloat16, enabled=enabled):
            made = decoder(frame, shutters)
        made.float().square().mean().backward()
        found.append({key: p.grad.clone() for key, p in decoder.named_parameters()})
    for key, exact in found[0].items():
        error = (found[1][key] - exact).norm() / exact.norm().clamp(min=1e-12)
        assert error < 0.2, key
