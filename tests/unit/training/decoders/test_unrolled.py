"""Unrolled projections: they begin with a guess taken to a clip that gives the frame."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

torch = pytest.importorskip("torch")

from nscc_training.baselines.gap_tv import gap_tv_of  # noqa: E402
from nscc_training.decoders.declared import DecoderTask  # noqa: E402
from nscc_training.decoders.decoder_building import make_decoder  # noqa: E402
from nscc_training.decoders.guess import clip_guess  # noqa: E402
from nscc_training.measured import Measured  # noqa: E402
from nscc_training.sensor_model import lifted  # noqa: E402

NAMES = ("unrolled", "refined")
SIZES = [(1, 1), (5, 3), (13, 10)]


def coded(slots: int, rows: int, cols: int, tile: int = 4) -> tuple[Any, Any]:
    """Two frames and a tile in which one place never opens and one is always open."""
    generator = torch.Generator().manual_seed(2)
    shutters = (torch.rand(slots, tile, tile, generator=generator) < 0.4).float()
    shutters[:, 2, 1], shutters[:, 0, 0] = 0.0, 1.0
    return torch.rand(2, rows, cols, generator=generator), shutters


def whole(shutters: Any, rows: int, cols: int) -> Any:
    """The shutters of a tile over an array, pixel by pixel."""
    tile = shutters.shape[-1]
    return shutters[:, torch.arange(rows) % tile][:, :, torch.arange(cols) % tile]


def given_back(clip: Any, frame: Any, mask: Any) -> Any:
    """The nearest clip that gives the frame, in loops: a pixel's open slots share what misses."""
    found = clip.double().clone()
    batch, slots, rows, cols = clip.shape
    for b, r, c in np.ndindex(batch, rows, cols):
        opened = [n for n in range(slots) if mask[n, r, c] == 1]
        for n in opened:
            missing = slots * frame[b, r, c].double() - clip[b, opened, r, c].double().sum()
            found[b, n, r, c] += missing / len(opened)
    return found


@pytest.mark.parametrize("slots", [1, 3, 16])
@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("name", NAMES)
def test_the_first_clip_reproduces_the_frame(name: str, size: tuple[int, int], slots: int) -> None:
    decoder = make_decoder(name, "small", DecoderTask("clip", slots, (4, 4)))
    frame, shutters = coded(slots, *size)
    mask = whole(shutters, *size)
    if name == "refined":
        measured = Measured.exact(slots * frame, mask.unsqueeze(0))
        start = gap_tv_of(measured, 20)[0]
    else:
        start = clip_guess(lifted(slots * frame, mask)[0], mask)
    found = decoder(frame, shutters)
    assert (found.shape, found.dtype) == ((2, slots, *size), torch.float32)
    opened = mask.sum(dim=0) > 0
    again = (found * mask).sum(dim=1) / slots
    torch.testing.assert_close(again[:, opened], frame[:, opened], rtol=1e-5, atol=1e-6)
    torch.testing.assert_close(found.double(), given_back(start, frame, mask), rtol=1e-5, atol=1e-5)
    # where a shutter is closed the start is kept, and a whole array is as good as its tile
    torch.testing.assert_close(found * (1 - mask), start * (1 - mask))
    torch.testing.assert_close(decoder(frame, mask), found)


def test_a_stage_reduces_the_residual_by_its_step() -> None:
    """A step of 1 reproduces the frame, and a step of 1/2 leaves half of the residual."""
    decoder = make_decoder("unrolled", "small", DecoderTask("clip", 5, (4, 4)))
    frame, shutters = coded(5, 13, 10)
    mask = whole(shutters, 13, 10)
    missing = {}
    for step in (0.0, 0.5, 1.0):
        with torch.no_grad():
            decoder.steps[:] = torch.tensor([0.0, step, 0.0])
            made = decoder(frame, shutters)
        missing[step] = (5 * frame - (mask * made).sum(dim=1)) * (mask.sum(dim=0) > 0)
    assert missing[0.0].abs().max() > 0.1
    torch.testing.assert_close(missing[0.5], missing[0.0] / 2, rtol=1e-4, atol=1e-5)
    assert missing[1.0].abs().max() < 1e-5


def test_refined_begins_nearer_to_the_truth() -> None:
    """The clip is a moving square, for which the first guess uses iterations of GAP-TV."""
    rows, cols = np.mgrid[:32, :32]
    clip = np.stack(
        [0.2 + 0.6 * ((abs(rows - 14) < 6) & (abs(cols - 8 - k) < 5)) for k in range(8)]
    )
    rng = np.random.default_rng(1)
    mask = (rng.random(clip.shape) < 0.5).astype(np.float32)
    frame = torch.from_numpy((clip * mask).sum(axis=0) / 8).float()[None]
    errors = {}
    for name in NAMES:
        made = make_decoder(name, "small", DecoderTask("clip", 8, (4, 4)))(
            frame, torch.from_numpy(mask)
        )
        errors[name] = float(np.mean((made[0].detach().numpy() - clip) ** 2))
    assert errors["refined"] < errors["unrolled"] / 2


@pytest.mark.parametrize("name", NAMES)
def test_pixels_that_never_open_are_ignored(name: str) -> None:
    decoder = make_decoder(name, "small", DecoderTask("clip", 5, (4, 4)))
    frame, shutters = coded(5, 13, 10)
    closed = whole(shutters, 13, 10).sum(dim=0) == 0
    assert closed.any()
    made = []
    for level in (0.0, 0.02, 1.0):
        frame[:, closed] = level
        made.append(decoder(frame, shutters))
    assert torch.isfinite(made[0]).all()
    assert torch.equal(made[0], made[1])
    assert torch.equal(made[0], made[2])
    dark = decoder(frame, torch.zeros_like(shutters))
    assert torch.equal(dark, torch.zeros_like(dark))


@pytest.mark.parametrize("name", NAMES)
def test_gradients_reach_everything_and_are_finite(name: str) -> None:
    decoder = make_decoder(name, "small", DecoderTask("clip", 5, (4, 4)))
    frame, shutters = coded(5, 13, 10)
    frame.requires_grad_()
    shutters.requires_grad_()
    for begins in (True, False):
        if not begins:
            with torch.no_grad():
                for denoiser in decoder.denoisers:
                    denoiser.last.weight.normal_(std=0.1)
        decoder.zero_grad()
        made = decoder(frame, shutters)
        (made * torch.linspace(-1, 1, made.numel()).reshape(made.shape)).sum().backward()
        for denoiser in decoder.denoisers:
            assert denoiser.last.weight.grad.abs().max() > 0
        for grad in (frame.grad, shutters.grad, *(p.grad for p in decoder.parameters())):
            assert torch.isfinite(grad).all()
    assert all(p.grad.abs().max() > 0 for p in decoder.parameters())
    assert frame.grad.abs().max() > 0
    assert shutters.grad.abs().max() > 0


def test_gradients_through_the_projection_equal_finite_differences() -> None:
    """The network is replaced by zeros, so the gradient is that of the projection of the start."""
    decoder = make_decoder("unrolled", "small", DecoderTask("clip", 3, (2, 2))).double()
    generator = torch.Generator().manual_seed(4)
    frame = torch.rand(1, 3, 4, generator=generator, dtype=torch.float64).requires_grad_()
    # above 1 a pixel, so that no count is at its bound
    shutters = torch.rand(3, 2, 2, generator=generator, dtype=torch.float64) / 2 + 0.5
    for denoiser in decoder.denoisers:
        denoiser.forward = lambda x: torch.zeros_like(x[:, :3]).float()
    assert torch.autograd.gradcheck(decoder, (frame, shutters.requires_grad_()))


@pytest.mark.parametrize("name", NAMES)
def test_projections_are_not_rounded_to_bf16_under_autocast(name: str) -> None:
    """Under autocast to bfloat16, the output is float32 and equal to 1e-5."""
    decoder = make_decoder(name, "small", DecoderTask("clip", 5, (4, 4)))
    frame, shutters = coded(5, 13, 10)
    exact = decoder(frame, shutters)
    with torch.autocast("cpu", torch.bfloat16):
        found = decoder(frame, shutters)
    assert found.dtype == torch.float32
    torch.testing.assert_close(found, exact, rtol=1e-5, atol=1e-6)
