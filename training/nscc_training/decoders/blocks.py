"""FC-net: fully connected layers on blocks of 2 x 2 tiles, at every shift by a tile."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import torch
from torch import Tensor, nn
from torch.autograd import Function
from torch.nn import functional

from nscc_training.decoders.declared import DecoderTask

Size = tuple[int, int]


def unfold_blocks(pictures: Tensor, block: Size, step: Size) -> Tensor:
    """Return overlapping blocks of `pictures` (batch, count, rows, cols), as (batch, blocks, count
    * pixels of a block).

    `block` (rows, cols) is the size of a block, at most that of the pictures; pixels at the end
    that no block reaches are left out. Blocks begin every `step` (rows, cols) pixels and are
    ordered row by row."""
    blocks = pictures.unfold(2, block[0], step[0]).unfold(3, block[1], step[1])
    batch, count, down, across = blocks.shape[:4]
    return blocks.permute(0, 2, 3, 1, 4, 5).reshape(
        batch, down * across, count * block[0] * block[1]
    )


def fold_blocks(blocks: Tensor, size: tuple[int, int, int], block: Size, step: Size) -> Tensor:
    """Return the pictures (batch, *size) in which overlapping blocks are added up: the adjoint of
    `unfold_blocks`.

    `size` is (count, rows, cols). `block` must be a multiple of `step` in both directions, and the
    blocks must fill the pictures. `blocks` is as `unfold_blocks` returns it, with the blocks row by
    row."""
    batch, (count, rows, cols) = len(blocks), size
    down, across = ((n - b) // s + 1 for n, b, s in zip((rows, cols), block, step, strict=True))
    # Each pixel lies in this many blocks in each direction.
    again = block[0] // step[0], block[1] // step[1]
    split_blocks = blocks.reshape(batch, down, across, count, again[0], step[0], again[1], step[1])
    split_blocks = split_blocks.permute(0, 3, 4, 6, 1, 5, 2, 7)
    total = blocks.new_zeros(batch, count, rows // step[0], step[0], cols // step[1], step[1])
    for row in range(again[0]):
        for col in range(again[1]):
            total[:, :, row : row + down, :, col : col + across] += split_blocks[:, :, row, col]
    return total.reshape(batch, *size)


class _Taken(Function):
    """The function `unfold_blocks` with a gradient that adds the blocks' gradients up again
    (`_Put`), faster than torch's own."""

    @staticmethod
    def forward(ctx: Any, pictures: Tensor, block: Size, step: Size) -> Tensor:
        """Return the overlapping blocks (batch, blocks, count * pixels) of `pictures` (batch,
        count, rows, cols), as `unfold_blocks`: `block` is their size, `step` their distance, each
        (rows, cols)."""
        ctx.how = tuple(pictures.shape[1:]), block, step
        return unfold_blocks(pictures, block, step)

    @staticmethod
    def backward(ctx: Any, grad: Tensor) -> tuple[Tensor, None, None]:
        """Return the gradient of the pictures: the gradients of their blocks, added up. The sizes
        have none (None)."""
        return _Put.apply(grad, *ctx.how), None, None  # type: ignore[no-untyped-call]


class _Put(Function):
    """The function `fold_blocks` with a gradient that cuts blocks out again (`_Taken`), faster than
    torch's own."""

    @staticmethod
    def forward(
        ctx: Any, blocks: Tensor, size: tuple[int, int, int], block: Size, step: Size
    ) -> Tensor:
        """Return pictures (batch, *size) in which `blocks` (batch, blocks, count * pixels) are
        added, as `fold_blocks`: `block` is their size, `step` their distance, each (rows, cols)."""
        ctx.how = block, step
        return fold_blocks(blocks, size, block, step)

    @staticmethod
    def backward(ctx: Any, grad: Tensor) -> tuple[Tensor, None, None, None]:
        """Return the gradient of the blocks: the gradient of the pictures, cut into blocks. The
        sizes have none (None)."""
        return _Taken.apply(grad, *ctx.how), None, None, None  # type: ignore[no-untyped-call]


class BlockNet(nn.Module):
    """Fully connected layers that map every block of 2 x 2 tiles of the frame to the same block of
    N slots.

    Blocks overlap by a tile in both directions; each pixel is the average over the blocks that
    contain it. The network does not receive the code, but blocks always begin at the corner of a
    tile. `overlapping` (down, across) may be switched off after training to use fewer blocks."""

    def __init__(self, channels: Sequence[int], task: DecoderTask, _size: str) -> None:
        """Build the layers for the tile and the slots of `task`. `channels` has one number, the
        width of the hidden layers."""
        super().__init__()
        self.slots, self.tile = task.slots, task.tile
        self.block = (2 * task.tile[0], 2 * task.tile[1])
        self.overlapping = (True, True)
        (hidden,), inputs = channels, self.block[0] * self.block[1]
        self.layers = nn.Sequential(
            nn.Linear(inputs, hidden),
            nn.ReLU(inplace=True),
            nn.Linear(hidden, hidden),
            nn.ReLU(inplace=True),
            nn.Linear(hidden, hidden),
            nn.ReLU(inplace=True),
            nn.Linear(hidden, task.slots * inputs),
        )

    def forward(self, frame: Tensor, shutters: Tensor) -> Tensor:
        """Return the clip (batch, N, rows, cols): the mean of the outputs of all blocks that
        contain a pixel.

        `frame` is (batch, rows, cols), of any size. `shutters` are not used: the network learns one
        code."""
        rows, cols = frame.shape[-2:]
        step = self.step
        down, across = (self.grown(size, k) for k, size in enumerate((rows, cols)))
        padded = functional.pad(
            frame.unsqueeze(1), (0, across - cols, 0, down - rows), mode="replicate"
        )
        decoded = self.layers(_Taken.apply(padded, self.block, step)).float()  # type: ignore[no-untyped-call]
        total: Tensor = _Put.apply(decoded, (self.slots, down, across), self.block, step)  # type: ignore[no-untyped-call]
        # The number of blocks that contain each pixel: a sum of ones.
        ones = torch.ones(
            (1, decoded.shape[1], self.block[0] * self.block[1]), device=decoded.device
        )
        holders = fold_blocks(ones, (1, down, across), self.block, step)
        return (total / holders)[..., :rows, :cols]

    @property
    def step(self) -> tuple[int, int]:
        """Return the distance between the corners of neighbouring blocks in pixels, down and
        across: a tile if blocks overlap, else a block."""
        down, across = self.overlapping
        return (self.tile if down else self.block)[0], (self.tile if across else self.block)[1]

    def grown(self, size: int, axis: int) -> int:
        """Return the smallest size in pixels, at least `size`, that whole blocks fill along an axis
        (0 is down, 1 across): at least one block."""
        block, step = self.block[axis], self.step[axis]
        return block + max(0, -(-(size - block) // step)) * step
