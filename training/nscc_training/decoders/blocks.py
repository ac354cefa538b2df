"""FC-net: blocks of 2 x 2 tiles through fully connected layers, at every shift by a tile."""

from __future__ import annotations

import torch
from torch import Tensor, nn
from torch.nn import functional


class BlockNet(nn.Module):
    """Every block of 2 x 2 tiles of the frame becomes N pictures of that block.

    Blocks overlap by a tile in both directions, and a pixel's values are averaged over the blocks
    that hold it. It sees no code but knows its tile: blocks always begin at a tile's corner.
    `overlapping` (down, across) may be switched off after training: fewer blocks, less work.
    """

    def __init__(self, hidden: int, slots: int, tile: tuple[int, int]) -> None:
        super().__init__()
        self.slots, self.tile = slots, tile
        self.block = (2 * tile[0], 2 * tile[1])
        self.overlapping = (True, True)
        inputs = self.block[0] * self.block[1]
        self.layers = nn.Sequential(
            nn.Linear(inputs, hidden), nn.ReLU(inplace=True),
            nn.Linear(hidden, hidden), nn.ReLU(inplace=True),
            nn.Linear(hidden, hidden), nn.ReLU(inplace=True),
            nn.Linear(hidden, slots * inputs),
        )  # fmt: skip

    def forward(self, frame: Tensor, shutters: Tensor) -> Tensor:
        rows, cols = frame.shape[-2:]
        step = self.step
        down, across = (self.grown(size, k) for k, size in enumerate((rows, cols)))
        padded = functional.pad(
            frame.unsqueeze(1), (0, across - cols, 0, down - rows), mode="replicate"
        )
        blocks = functional.unfold(padded, self.block, stride=step).transpose(1, 2)
        made = self.layers(blocks).float()
        # (batch, blocks, slots * pixels) to one picture a slot
        batch, count, _ = made.shape
        made = made.reshape(batch, count, self.slots, -1).permute(0, 2, 3, 1)
        made = made.reshape(batch * self.slots, -1, count)
        total = functional.fold(made, (down, across), self.block, stride=step)
        ones = torch.ones((1, made.shape[1], count), device=made.device)
        holders = functional.fold(ones, (down, across), self.block, stride=step)
        found = (total / holders).reshape(batch, self.slots, down, across)
        return found[..., :rows, :cols]

    @property
    def step(self) -> tuple[int, int]:
        """Pixels from a block to the next, down and across."""
        down, across = self.overlapping
        return (self.tile if down else self.block)[0], (self.tile if across else self.block)[1]

    def grown(self, size: int, axis: int) -> int:
        """The next size that whole blocks fill, at their steps."""
        block, step = self.block[axis], self.step[axis]
        return block + max(0, -(-(size - block) // step)) * step
