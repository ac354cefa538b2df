"""Several readouts of one exposure, one of them always open: what stands still, and what moves.

The always open readout has all the light and little noise, and is right wherever nothing moves.
The coded readouts say where that is. A network of the denoiser's form sees both and chooses for
every pixel and slot.
"""

from __future__ import annotations

import torch
from torch import Tensor

from nscc_training.any_code.network import ClipDenoiser
from nscc_training.measured import Measured

STAGES = 4
"""Stages of the clip that the network is given: more gain motion less than they cost stills."""
SEEN = 5
"""Planes beside the clip, see `planes`."""
_SIGMA = 12 / 255
"""How wrong the clip of the last stage is taken to be."""
_TRUSTED = -1.0
"""The gate before training, as a logarithm of odds: a quarter of the always open readout."""


class ReadoutFusion(ClipDenoiser):
    """A denoiser that sees the always open readout, and a gate beside its correction."""

    def __init__(self, widths: tuple[int, ...] | None = None) -> None:
        super().__init__(*(() if widths is None else (widths,)), seen=SEEN, found=2)

    def begin_with(self, denoiser: ClipDenoiser) -> None:
        """Take over the weights of a denoiser, which sees the clip alone of these planes."""
        own, state = self.state_dict(), denoiser.state_dict()
        one, planes_seen = state["last.weight"].shape[0], slice(0, state["last.weight"].shape[0])
        state |= {name: torch.zeros_like(own[name]) for name in ("first.weight", "last.weight",
                  "last.bias")}  # fmt: skip
        there = denoiser.state_dict()
        state["first.weight"][:, planes_seen] = there["first.weight"][:, planes_seen]
        state["first.weight"][:, -1] = there["first.weight"][:, -1]
        state["last.weight"][:one], state["last.bias"][:one] = (
            there["last.weight"], there["last.bias"])  # fmt: skip
        self.load_state_dict(state)

    def fused(self, measured: Measured, clip: Tensor) -> Tensor:
        """Return the clip (batch, N, rows, cols) that a coded one and the readouts make together,
        in their unit, whose white is 1."""
        seen = planes(measured)
        correction, gate = self.found(clip, seen, clip.new_full((len(clip),), _SIGMA))
        share = torch.sigmoid(gate + _TRUSTED)
        return clip + share * (seen[:, 0] - clip) + _SIGMA * correction


def always_open(measured: Measured) -> int | None:
    """Return the number of the readout whose shutters never close, if there is one beside others
    that do."""
    opened = (measured.mask > 0).flatten(3).all(dim=3).all(dim=2).all(dim=0)
    if len(opened) < 2 or not bool(opened.any()) or bool(opened.all()):
        return None
    return int(opened.int().argmax())


def planes(measured: Measured) -> Tensor:
    """Return what the network sees (batch, SEEN, N, rows, cols).

    These are the light of a slot that the always open readout has, and its standard deviation; the
    mean of what the coded readouts that are open in a slot have more, and its standard deviation;
    and how many of them are open. Where no coded readout is open, or one is saturated, the third
    is 0 and the fourth 1.
    """
    number = always_open(measured)
    assert number is not None
    coded = [k for k in range(measured.mask.shape[1]) if k != number]
    count = measured.mask.shape[2]
    opened = measured.mask.sum(dim=2)  # (batch or 1, B, rows, cols)
    light = measured.value / opened.clamp(min=1e-6)
    spread = measured.variance / opened.clamp(min=1e-6).square()
    still, still_variance = light[:, number], spread[:, number]
    known = torch.where(opened[:, coded] > 0, ~measured.saturated[:, coded], False)
    weight = (measured.mask[:, coded] > 0) & known.unsqueeze(2)  # (batch, B - 1, N, rows, cols)
    more = light[:, coded] - still.unsqueeze(1)
    variance = spread[:, coded] + still_variance.unsqueeze(1)
    total = weight.sum(dim=1).clamp(min=1)
    open_there = weight.any(dim=1)
    mean = (weight * more.unsqueeze(2)).sum(dim=1) / total
    sd = (weight * variance.unsqueeze(2)).sum(dim=1).sqrt() / total
    full = measured.saturated[:, number]
    flat = [still, torch.where(full, 1.0, still_variance.sqrt().clamp(max=1))]
    wide = [part.unsqueeze(1).expand(-1, count, -1, -1) for part in flat]
    return torch.stack(
        [*wide, mean, torch.where(open_there, sd.clamp(max=1), 1.0), weight.sum(dim=1).to(mean)],
        dim=1,
    )
