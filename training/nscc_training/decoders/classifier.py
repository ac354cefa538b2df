"""A small network that classifies the scene of a coded frame."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import torch
from torch import Tensor, nn

from nscc_training.decoders.declared import DecoderTask
from nscc_training.sensor_model import laid, lifted, shared_out


class Classifier(nn.Module):
    """A network that names the class of a clip: pairs of 3 x 3 convolutions, the mean over all
    pixels, and a linear layer.

    The second convolution of a pair halves the resolution. Input: the frames of one or two buckets;
    with `sees_code` also S^T E of each bucket, the frame copied to the slots in which each pixel
    was open, with one channel per slot. Inputs are divided by their means, so that the brightness
    of a scene has no influence. Output (batch, classes): the logarithms of likelihoods, up to a
    constant that all classes share. Frames may have any size."""

    def __init__(self, channels: Sequence[int], task: DecoderTask, _size: str) -> None:
        """Build the network for the slots, buckets and classes of `task`. `channels` are the widths
        of its levels."""
        super().__init__()
        self.slots, self.sees_code = task.slots, task.sees_code
        layers: list[nn.Module] = []
        inputs = task.buckets * (1 + task.sees_code * task.slots)
        for before, width in pairwise([inputs, *channels]):
            layers += [
                *_convolution(before, width, stride=1),
                *_convolution(width, width, stride=2),
            ]
        self.network = nn.Sequential(*layers)
        self.last = nn.Linear(channels[-1], len(task.classes))

    def forward(self, frame: Tensor, shutters: Tensor) -> Tensor:
        """Return the score of each class, (batch, classes), before softmax.

        `frame` is (batch, [buckets,] rows, cols), `shutters` (N, r, c) are those of the first
        bucket for a tile. If the network sees the code, the frame copied to the open slots of each
        pixel is also an input."""
        frames = frame if frame.ndim == 4 else frame.unsqueeze(1)
        inputs = [relative(frames, torch.ones_like(frames))]
        if self.sees_code:
            opened = laid(shared_out(shutters, frames.shape[1]), *frame.shape[-2:]).to(frame.dtype)
            for bucket, tile in zip(
                frames.unbind(1), opened if opened.ndim == 4 else opened[None], strict=True
            ):
                inputs.append(relative(lifted(bucket, tile)[0], tile))
        output: Tensor = self.last(self.network(torch.cat(inputs, dim=1)).mean(dim=(2, 3)))
        return output.float()


def relative(values: Tensor, weight: Tensor) -> Tensor:
    """Return `values` (batch, channels, rows, cols) divided by their mean, minus 1.

    `weight` (0 or 1) marks the values that count: the mean is taken over them, and the result is 0
    at the others."""
    axes = tuple(range(1, values.ndim))
    weight = weight.expand_as(values)
    mean = (values * weight).sum(axes, keepdim=True) / weight.sum(axes, keepdim=True)
    return (values / mean.clamp(min=1e-6) - 1) * weight


def _convolution(inputs: int, outputs: int, stride: int) -> list[nn.Module]:
    """Return a 3 x 3 convolution from `inputs` to `outputs` channels, with batch normalisation and
    ReLU. A `stride` of 2 halves the resolution."""
    return [
        nn.Conv2d(inputs, outputs, 3, padding=1, stride=stride, bias=False),
        nn.BatchNorm2d(outputs),
        nn.ReLU(inplace=True),
    ]
