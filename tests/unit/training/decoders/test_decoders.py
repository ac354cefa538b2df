"""Decoders: shapes, sizes, what they see, and that sizes are the paper's."""

from __future__ import annotations

from pathlib import Path

import pytest

torch = pytest.importorskip("torch")

from nscc.diagnostics.diagnostic import Rejected  # noqa: E402
from nscc_training.any_code.decode import decoded_still  # noqa: E402
from nscc_training.any_code.network import bf16_where_multiplied  # noqa: E402
from nscc_training.decoders.blocks import BlockNet, fold_blocks, unfold_blocks  # noqa: E402
from nscc_training.decoders.declared import DECODERS, DecoderTask  # noqa: E402
from nscc_training.decoders.decoder_building import (  # noqa: E402
    flops,
    make_decoder,
    parameter_count,
)
from nscc_training.decoders.unet import UNet  # noqa: E402
from nscc_training.measured import Measured  # noqa: E402

STILL = DecoderTask("still", 256, (8, 8))
CLIP = DecoderTask("clip", 16, (8, 8))


def coded(slots: int, rows: int, cols: int) -> tuple[torch.Tensor, torch.Tensor]:
    generator = torch.Generator().manual_seed(1)
    frame = torch.rand(2, rows, cols, generator=generator)
    return frame, (torch.rand(slots, rows, cols, generator=generator) < 0.5).float()


@pytest.mark.parametrize("size", [(32, 32), (37, 41), (16, 24)])
@pytest.mark.parametrize("name", [name for name, each in DECODERS.items() if each.clips])
def test_decoders_return_finite_clips_of_any_size(name: str, size: tuple[int, int]) -> None:
    """A clip of 16 slots comes back in the size of the frame, also for sides that no power of two
    divides."""
    decoder = make_decoder(name, "small", CLIP)
    found = decoder(*coded(16, *size))
    assert found.shape == (2, 16, *size)
    assert found.dtype == torch.float32
    assert torch.isfinite(found).all()


@pytest.mark.parametrize("sees_code", [True, False])
def test_still_decoders_see_the_code_only_if_they_say_so(sees_code: bool) -> None:
    """With the inverted shutters the output changes if `sees_code` is true, and else it is
    equal."""
    decoder = make_decoder("unet2d", "small", DecoderTask("still", 64, (4, 4), sees_code))
    frame, shutters = coded(64, 29, 35)
    found = decoder(frame, shutters)
    assert found.shape == frame.shape
    other = decoder(frame, 1 - shutters)
    assert torch.equal(found, other) != sees_code


def test_decoders_have_the_documented_numbers_of_parameters() -> None:
    """The networks have 31, 13 and 51 million parameters in the size of the paper, and at most 0.6
    million in the small size."""
    wanted = {("unet2d", "still"): 31e6, ("unet3d", "clip"): 13e6, ("fcnet", "clip"): 51e6}
    for (name, kind), count in wanted.items():
        task = STILL if kind == "still" else CLIP
        with torch.device("meta"):
            assert parameter_count(make_decoder(name, "paper", task)) == pytest.approx(
                count, rel=0.03
            )
            assert parameter_count(make_decoder(name, "small", task)) <= 600_000
    with torch.device("meta"):
        for name, decoder in DECODERS.items():
            if decoder.fixed_channels or decoder.classifies:
                continue
            assert parameter_count(make_decoder(name, "small", CLIP)) <= 600_000


def test_the_decoder_for_any_code_begins_with_its_shipped_weights() -> None:
    """A decoder that comes with weights makes of a frame what these weights make of it."""
    frame, shutters = coded(8, 24, 32)
    frame[:, 0, 0], shutters[:, 0, 0] = 1, 1
    run = make_decoder("any", "small", DecoderTask("still", 8, (24, 32)))
    dark, gained = run.noise.exp().detach()
    share = shutters.mean(dim=0)[None, None, None]
    variance = dark + gained * frame
    measured = Measured(frame[:, None], share, variance[:, None], frame[:, None] >= 1)
    with torch.no_grad(), bf16_where_multiplied():
        found = run(frame, shutters)
    assert torch.allclose(found, decoded_still(measured), rtol=1e-3, atol=1e-4)


def test_other_widths_of_the_decoder_for_any_code_begin_at_random() -> None:
    """At width 1 the shipped weights are loaded, whatever the seed. At 0.5 and 2 they are
    random."""
    counts = []
    for width in (0.5, 1, 2):
        decoder = make_decoder("any", "small", CLIP, width)
        counts.append(parameter_count(decoder))
        torch.manual_seed(5)
        again = make_decoder("any", "small", CLIP, width)
        name, weights = next((n, w) for n, w in decoder.named_parameters() if w.ndim > 1)
        assert torch.equal(weights, dict(again.named_parameters())[name]) == (width == 1)
    assert counts == sorted(set(counts))


def test_operations_are_counted() -> None:
    """The paper's 2D network: 34 GFLOP, of which a multiplication and addition are two."""
    with torch.device("meta"):
        decoder = make_decoder("unet2d", "paper", DecoderTask("still", 16, (8, 8), sees_code=False))
    assert flops(decoder, 16, 256, 256) == pytest.approx(34e9, rel=0.1)


def test_a_unet_of_one_level_equals_its_convolutions_written_out() -> None:
    """The network has two convolutions and a mixing layer."""
    network = UNet(2, 3, (4,), 2).double()
    x = torch.rand(1, 2, 6, 5, dtype=torch.float64)
    first, _, second, _ = network.down[0]

    def convolved(x: torch.Tensor, layer: torch.nn.Conv2d) -> torch.Tensor:
        rows, cols = x.shape[2:]
        padded = torch.zeros(1, x.shape[1], rows + 2, cols + 2, dtype=torch.float64)
        padded[:, :, 1:-1, 1:-1] = x
        out = layer.bias.reshape(1, -1, 1, 1).expand(1, -1, rows, cols).clone()
        for r in range(3):
            for c in range(3):
                part = padded[:, :, r : r + rows, c : c + cols]
                out += torch.einsum("oi,birc->borc", layer.weight[:, :, r, c], part)
        return out

    middle = convolved(convolved(x, first).clamp(min=0), second).clamp(min=0)
    wanted = torch.einsum("oi,birc->borc", network.last.weight[:, :, 0, 0], middle)
    wanted += network.last.bias.reshape(1, -1, 1, 1)
    assert torch.allclose(network(x), wanted)


def test_blocks_overlap_and_are_averaged() -> None:
    """The expected clip comes from a loop that adds each block at its place."""
    net = BlockNet((8,), DecoderTask("clip", 3, (2, 2)), "small")
    frame = torch.rand(1, 6, 8)
    total, holders = torch.zeros(3, 6, 8), torch.zeros(6, 8)
    for row in (0, 2):
        for col in (0, 2, 4):
            made = net.layers(frame[0, row : row + 4, col : col + 4].reshape(1, 16))
            total[:, row : row + 4, col : col + 4] += made.reshape(3, 4, 4)
            holders[row : row + 4, col : col + 4] += 1
    found = net(frame, torch.ones(3, 6, 8))
    assert torch.allclose(found[0], (total / holders), atol=1e-6)


BLOCKS = [
    ((4, 6), (2, 3), (10, 12)), ((4, 6), (4, 3), (8, 9)), ((4, 6), (2, 6), (4, 18)),
    ((4, 6), (4, 6), (12, 6)), ((2, 2), (1, 1), (5, 7)),
]  # fmt: skip


@pytest.mark.parametrize(("block", "step", "size"), BLOCKS)
def test_blocks_are_taken_and_put_as_torch_does(
    block: tuple[int, int], step: tuple[int, int], size: tuple[int, int]
) -> None:
    """Our blocks equal those of torch's unfold, and put back they equal its fold."""
    pictures = torch.rand(2, 3, *size, dtype=torch.float64)
    wanted = torch.nn.functional.unfold(pictures, block, stride=step)
    found = unfold_blocks(pictures, block, step)
    assert torch.equal(found, wanted.transpose(1, 2))
    back = torch.nn.functional.fold(wanted, size, block, stride=step)
    assert torch.allclose(fold_blocks(found, (3, *size), block, step), back, rtol=1e-12)


@pytest.mark.parametrize("overlapping", [(True, True), (False, True), (False, False)])
def test_gradients_of_blocks_equal_finite_differences(overlapping: tuple[bool, bool]) -> None:
    """The gradients are those of the frame and of one layer's weights. Whole blocks do not fill the
    frame."""
    net = BlockNet((3,), DecoderTask("clip", 2, (2, 1)), "small").double()
    net.layers[1] = net.layers[3] = net.layers[5] = torch.nn.Tanh()
    net.overlapping = overlapping
    frame = torch.rand(2, 5, 4, dtype=torch.float64, requires_grad=True)
    weight = net.layers[6].weight
    unread = torch.ones(2, 5, 4)

    def made(frame: torch.Tensor, weight: torch.Tensor) -> torch.Tensor:
        return torch.func.functional_call(net, {"layers.6.weight": weight}, (frame, unread))

    # the network's result is float32 by contract, its gradients no better than that
    assert torch.autograd.gradcheck(made, (frame, weight), eps=1e-2, atol=1e-3, rtol=1e-3)


def test_invalid_decoders_are_refused() -> None:
    for name, task, words in (
        ("unet3d", STILL, "clips"),
        ("fcnet", STILL, "clips"),
        ("unet3d", DecoderTask("clip", 16, (8, 8), sees_code=False), "S\\^T E"),
        ("unrolled", STILL, "clips"),
        ("refined", STILL, "clips"),
        ("unrolled", DecoderTask("clip", 16, (8, 8), sees_code=False), "unrolled projects"),
        ("refined", DecoderTask("clip", 16, (8, 8), sees_code=False), "refined projects"),
        ("unet4d", CLIP, "is unknown; the decoders are"),
    ):
        with pytest.raises(ValueError, match=words):
            make_decoder(name, "small", task)


@pytest.mark.parametrize("name", ["unet2d", "unet3d", "fcnet", "unrolled"])
def test_narrower_decoders_have_fewer_weights(name: str) -> None:
    """At half the width there are about a quarter to a half of the weights. At 0.01 the decoder
    still works."""
    counts = [parameter_count(make_decoder(name, "small", CLIP, w)) for w in (1.0, 0.5, 0.01)]
    assert counts[0] == parameter_count(make_decoder(name, "small", CLIP))
    # Layers between layers shrink by both of their sides, the first and the last by one.
    assert counts[0] / 4.2 < counts[1] < counts[0] / 1.8
    made = make_decoder(name, "small", CLIP, 0.01)(torch.rand(1, 32, 32), torch.ones(16, 32, 32))
    assert made.shape == (1, 16, 32, 32)


@pytest.mark.parametrize("name", ["unet2d", "unet3d", "fcnet", "unrolled"])
def test_wider_decoders_are_as_wide_as_asked(name: str) -> None:
    one, wide = (parameter_count(make_decoder(name, "small", CLIP, w)) for w in (1.0, 1.5))
    # 1.5 times the channels are 1.5 to 2.25 times the weights.
    assert 1.4 * one < wide < 2.4 * one


def test_a_decoder_by_import_path_is_used(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "mine_of_tests.py").write_text(
        "import torch\n"
        "class Mine(torch.nn.Module):\n"
        "    def __init__(self, size, kind, slots, tile, sees_code):\n"
        "        super().__init__()\n"
        "        self.gain = torch.nn.Parameter(torch.tensor(float(slots)))\n"
        "    def forward(self, frame, shutters):\n"
        "        return frame * self.gain\n"
        "number = 3\n"
        "def wrong(**settings):\n"
        "    return settings\n"
    )
    monkeypatch.chdir(tmp_path)
    decoder = make_decoder("mine_of_tests:Mine", "small", STILL)
    assert decoder(torch.ones(1, 4, 4), torch.ones(1, 4, 4)).mean() == 256
    for name in ("mine_of_tests:number", "mine_of_tests:Other", "no_such_module:X", ":"):
        with pytest.raises(Rejected, match="NS0812"):
            make_decoder(name, "small", STILL)
    with pytest.raises(ValueError, match="not a torch module"):
        make_decoder("mine_of_tests:wrong", "small", STILL)
    with pytest.raises(ValueError, match="width applies only to nscc's own"):
        make_decoder("mine_of_tests:Mine", "small", STILL, 0.5)


@pytest.mark.parametrize("kind", ["still", "clip"])
@pytest.mark.parametrize("name", DECODERS)
def test_codes_below_the_offset_of_the_adc_stay_finite(name: str, kind: str) -> None:
    """A pedestal of some codes and readout noise make the frame negative where it is dark."""
    declared = DECODERS[name]
    if not (declared.stills if kind == "still" else declared.clips):
        return
    decoder = make_decoder(name, "small", DecoderTask(kind, 8, (2, 2)))
    shutters = torch.ones(8, 2, 2)
    shutters[1:, 0, 0], shutters[:, 1, 1] = 0, 0
    frame = torch.full((1, 16, 16), -8 / 255, requires_grad=True)
    made = decoder(frame, shutters)
    made.square().sum().backward()
    assert torch.isfinite(made).all()
    assert torch.isfinite(frame.grad).all()
