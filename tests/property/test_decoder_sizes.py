"""A small decoder is small whatever it is for, and as wide as the table says where it can be."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

torch = pytest.importorskip("torch")

from nscc_training.decoders.blocks import BlockNet  # noqa: E402
from nscc_training.decoders.declared import DECODERS, DecoderTask  # noqa: E402
from nscc_training.decoders.decoder_building import make_decoder  # noqa: E402
from nscc_training.decoders.unet import ClipUNet, Refined, StillUNet, Unrolled  # noqa: E402  # noqa: E402

MOST = 600_000
OURS = [
    name
    for name, decoder in DECODERS.items()
    if not decoder.fixed_channels and not decoder.classifies
]


def numbers(module: torch.nn.Module) -> int:
    return sum(parameter.numel() for parameter in module.parameters())


@settings(deadline=None, max_examples=60)
@given(
    st.sampled_from(OURS),
    st.one_of(st.integers(1, 40), st.integers(1, 3000)),
    st.tuples(st.integers(1, 24), st.integers(1, 24)),
)
def test_small_decoders_of_clips_are_small(name: str, slots: int, tile: tuple[int, int]) -> None:
    task = DecoderTask("clip", slots, tile)
    # Four neurons between two tiles a side and slots times as many outputs.
    pixels = 4 * tile[0] * tile[1]
    least = 4 * pixels + 2 * 4 * 4 + 3 * 4 + (4 + 1) * slots * pixels
    with torch.device("meta"):
        if name != "fcnet" or least <= MOST:
            assert numbers(make_decoder(name, "small", task)) <= MOST
        else:
            with pytest.raises(ValueError, match=f"{least:,} at its narrowest for {slots} slots"):
                make_decoder(name, "small", task)


@settings(deadline=None, max_examples=30)
@given(st.integers(1, 4096), st.booleans())
def test_small_decoders_of_stills_are_small(slots: int, sees_code: bool) -> None:
    with torch.device("meta"):
        made = make_decoder("unet2d", "small", DecoderTask("still", slots, (8, 8), sees_code))
    assert numbers(made) <= MOST


@pytest.mark.parametrize("slots", [1, 13, 16])
def test_decoders_keep_the_shapes_and_first_weights_of_earlier_runs(slots: int) -> None:
    """Weights of earlier runs load, and new runs begin with the same weights."""
    makers = {
        "unet2d": (StillUNet, (16, 32, 64, 128)), "unet3d": (ClipUNet, (8, 16, 32, 64)),
        "fcnet": (BlockNet, (96,)), "unrolled": (Unrolled, (24, 48, 64)),
        "refined": (Refined, (24, 48, 64)),
    }  # fmt: skip
    assert set(makers) == set(OURS)
    task = DecoderTask("clip", slots, (8, 8))
    for name, (maker, channels) in makers.items():
        torch.manual_seed(5)
        wanted = maker(channels, task, "small").state_dict()
        torch.manual_seed(5)
        found = make_decoder(name, "small", task).state_dict()
        assert found.keys() == wanted.keys()
        assert all(torch.equal(found[key], wanted[key]) for key in wanted), name


@pytest.mark.parametrize(
    ("name", "slots", "tile"),
    [
        ("unrolled", 20, (8, 8)),
        ("refined", 64, (8, 8)),
        ("fcnet", 23, (8, 8)),
        ("fcnet", 4, (24, 24)),
        ("unet2d", 500, (8, 8)),
    ],
)
def test_decoders_that_would_be_too_large_are_narrowed_slightly(
    name: str, slots: int, tile: tuple[int, int]
) -> None:
    with torch.device("meta"):
        made = make_decoder(name, "small", DecoderTask("clip", slots, tile))
    assert 0.9 * MOST < numbers(made) <= MOST
    cut = torch.rand(1, 50, 50)
    with torch.no_grad():
        real = make_decoder(name, "small", DecoderTask("clip", slots, tile))
        assert real(cut, torch.ones(slots, *tile)).shape == (1, slots, 50, 50)


def test_the_papers_size_is_not_narrowed() -> None:
    with torch.device("meta"):
        assert numbers(make_decoder("fcnet", "paper", DecoderTask("clip", 32, (8, 8)))) > 51e6


@pytest.mark.parametrize("tile", [(64, 64), (256, 256)])
def test_decoders_that_cannot_be_small_are_refused_without_memory(tile: tuple[int, int]) -> None:
    with pytest.raises(ValueError, match=r"fcnet has at most 600,000 parameters.*another decoder"):
        make_decoder("fcnet", "small", DecoderTask("clip", 16, tile))
