"""The simplest decoder: divide each exposure by the time that its pixel was open."""

from __future__ import annotations

from collections.abc import Sequence

from torch import Tensor, nn

from nscc_training.decoders.declared import DecoderTask
from nscc_training.sensor_model import laid


class Divided(nn.Module):
    """A decoder for stills that divides a frame by the open fraction of each pixel.

    It has no weights and uses no neighbours. All decoders have the same arguments, which it
    ignores."""

    def __init__(self, _channels: Sequence[int], _task: DecoderTask, _size: str) -> None:
        """Begin; there is nothing to learn."""
        super().__init__()

    def forward(self, frame: Tensor, shutters: Tensor) -> Tensor:
        """Return the light over the whole frame (batch, rows, cols): the frame divided by the open
        fraction of each pixel.

        `shutters` (N, r, c) are those of a tile. A pixel that never opens is divided by 1e-9."""
        share = laid(shutters.mean(dim=-3), *frame.shape[-2:])
        return frame / share.clamp(min=1e-9)
