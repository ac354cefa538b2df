"""U-Nets, and networks that unroll GAP-TV with U-Nets as denoisers."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import torch
from torch import Tensor, nn
from torch.nn import functional

from nscc_training.baselines.gap_tv import gap_tv_of
from nscc_training.curves import log_curve_inverse
from nscc_training.decoders.declared import DecoderTask
from nscc_training.decoders.guess import clip_guess, still_guess
from nscc_training.measured import Measured
from nscc_training.sensor_model import laid, lifted, shared_out

LOG_FLOOR = 1e-3
"""Networks predict stills as log(1 + light / LOG_FLOOR)."""
# The networks of the paper have no first guess; the small ones train too briefly without one.
_GUESSES = {"paper": False, "small": True}


def _guesses(task: DecoderTask, size: str) -> bool:
    """Return whether a decoder of this size makes a first guess: as `task.guess` says, or if that
    is None, only the small ones."""
    return _GUESSES[size] if task.guess is None else task.guess


class UNet(nn.Module):
    """A U-Net: at each level two convolutions, and half the resolution at the next; on the way
    back, the result is joined with that of the same level.

    `widths` are the channels from the finest level to the coarsest. The input is padded to a
    multiple of 2 ** (levels - 1) by repeating its edge, and the result is cut to the size of the
    input."""

    def __init__(self, inputs: int, outputs: int, widths: Sequence[int], dimensions: int) -> None:
        """Build a U-Net with `inputs` and `outputs` channels in two or three `dimensions`.

        `widths` are the channels of its levels, from fine to coarse; each level but the first
        halves the sides. In three dimensions, slots are an axis like rows and columns."""
        super().__init__()
        self.dimensions = dimensions
        convolution = nn.Conv2d if dimensions == 2 else _Convolution3d
        self.pool = nn.AvgPool2d(2) if dimensions == 2 else nn.AvgPool3d(2)

        def double(channels: int, width: int) -> nn.Module:
            """Return two convolutions of size 3, from `channels` to `width` and to `width`
            channels, each followed by ReLU."""
            return nn.Sequential(
                convolution(channels, width, 3, padding=1),
                nn.ReLU(inplace=True),
                convolution(width, width, 3, padding=1),
                nn.ReLU(inplace=True),
            )

        self.down = nn.ModuleList(
            double(before, width) for before, width in pairwise([inputs, *widths])
        )
        self.up = nn.ModuleList(
            double(widths[k + 1] + widths[k], widths[k]) for k in reversed(range(len(widths) - 1))
        )
        self.last = convolution(widths[0], outputs, 1)
        self.multiple = 2 ** (len(widths) - 1)
        for layer in self.modules():
            if isinstance(layer, convolution) and layer.bias is not None and not layer.bias.is_meta:
                # He et al. 2015: with another initialisation, the signal fades in this many layers.
                nn.init.kaiming_normal_(layer.weight, nonlinearity="relu")
                nn.init.zeros_(layer.bias)
        if dimensions == 3:
            # With this memory format, a step on a CPU takes half the time.
            self.to(memory_format=torch.channels_last_3d)  # type: ignore[call-overload]

    def forward(self, x: Tensor) -> Tensor:
        """Map `x` (batch, inputs, [N,] rows, cols) to (batch, outputs, [N,] rows, cols). Sizes need
        not be multiples of the network's: the edges are repeated and cut."""
        sizes = x.shape[2:]
        # Repeat the edge pixels up to the next multiple.
        margins = [margin for size in reversed(sizes) for margin in (0, -size % self.multiple)]
        if any(margins):
            x = functional.pad(x, margins, mode="replicate")
        skips: list[Tensor] = []
        for level, layer in enumerate(self.down):
            x = layer(x if level == 0 else self.pool(x))
            skips.append(x)
        skips.pop()
        mode = "bilinear" if self.dimensions == 2 else "trilinear"
        for layer in self.up:
            finer = skips.pop()
            x = functional.interpolate(x, size=finer.shape[2:], mode=mode, align_corners=False)
            x = layer(torch.cat([x, finer], dim=1))
        output: Tensor = self.last(x)
        return output[(slice(None), slice(None), *(slice(0, size) for size in sizes))]


class _Convolution3d(nn.Conv3d):
    """A 3D convolution that uses float32 on CPUs if only two slots remain.

    In bfloat16, torch 2.13 returns uninitialised memory for some gradients of its weights on
    processors with AVX512-BF16."""

    def forward(self, x: Tensor) -> Tensor:
        """Convolve x (batch, channels, N, rows, cols); in float32 if it has two slots and is on a
        CPU, whatever autocast says."""
        if x.device.type != "cpu" or x.shape[2] != 2:
            return super().forward(x)
        with torch.autocast("cpu", enabled=False):
            return super().forward(x.float())


class StillUNet(nn.Module):
    """A two-dimensional U-Net for stills, or for clips with the slots as channels.

    Inputs: the frame, or the frames of two buckets. With `sees_code`, stills have two further
    inputs, the open fraction of each pixel and the frame divided by it. Clips have S^T E as input,
    the frame copied to the slots in which each pixel was open, with one channel per slot. Output:
    the logarithm of the light of a still, or one channel per slot of a clip (`slots`).

    With `guesses`, the first guess is another input, and the network predicts a correction to it,
    for clips also a gain (`gated`); this needs `sees_code`."""

    def __init__(self, channels: Sequence[int], task: DecoderTask, size: str) -> None:
        """Build a two-dimensional U-Net for stills, or for clips with slots as channels.

        `channels` are the widths of its levels. Its inputs are the frame, the shutters if `task`
        lets it see the code, and a first guess if this `size` makes one."""
        super().__init__()
        slots = None if task.kind == "still" else task.slots
        self.slots, self.sees_code = slots, task.sees_code
        self.guesses = _guesses(task, size) and task.sees_code
        known = (2 if slots is None else task.buckets * slots) if task.sees_code else 0
        guessed = (slots or 1) if self.guesses else 0
        gates = slots if slots is not None and self.guesses else 0
        network = UNet(
            task.buckets + known + guessed,
            outputs=(slots or 1) + gates,
            widths=channels,
            dimensions=2,
        )
        self.network = begin_with_nothing(network) if self.guesses else network

    def forward(self, frame: Tensor, shutters: Tensor) -> Tensor:
        """Return the light of stills (batch, rows, cols) or clips (batch, N, rows, cols), in full
        wells, or full wells / N for a slot.

        `frame` is (batch, [buckets,] rows, cols) in full wells, `shutters` (N, r, c) are those of
        the first bucket for a tile."""
        return self._clip(frame, shutters) if self.slots else self._still(frame, shutters)

    def _still(self, frame: Tensor, shutters: Tensor) -> Tensor:
        """Return the light of stills (batch, rows, cols), in full wells, from frames of the same
        shape, in full wells, and `shutters` (N, r, c), a repeating tile.

        The network works on the logarithm of the light. If it guesses, it predicts the difference
        to the first guess."""
        inputs, guess = [frame], None
        if self.sees_code:
            share = laid(shutters.mean(dim=-3), *frame.shape[-2:]).expand_as(frame)
            pixel_light = torch.where(
                share > 0, frame / share.clamp(min=1e-6), torch.zeros_like(frame)
            )
            # Readout noise takes dark pixels below the offset of the ADC.
            inputs += [share, torch.log1p(pixel_light.clamp(min=0) / LOG_FLOOR)]
            if self.guesses:
                guess = torch.log1p(still_guess(frame, share).clamp(min=0) / LOG_FLOOR)
                inputs.append(guess)
        output: Tensor = self.network(torch.stack(inputs, dim=1)).float()[:, 0]
        return log_curve_inverse(output if guess is None else output + guess, LOG_FLOOR)

    def _clip(self, frame: Tensor, shutters: Tensor) -> Tensor:
        """Return the light of clips (batch, N, rows, cols), in full wells / N, from a frame (batch,
        [buckets,] rows, cols) in full wells, and `shutters` (N, r, c) of the first bucket, a
        repeating tile."""
        assert self.slots is not None
        inputs, guess = [frame if frame.ndim == 4 else frame.unsqueeze(1)], None
        if self.sees_code:
            volumes, opened = _lifted(frame, shutters, self.slots)
            inputs += volumes
            if self.guesses:
                guess = clip_guess(_added(volumes), *opened)
                inputs.append(guess)
        output: Tensor = self.network(torch.cat(inputs, dim=1)).float()
        return output if guess is None else gated(guess, *output.chunk(2, dim=1))


class ClipUNet(nn.Module):
    """A three-dimensional U-Net for clips. Its input is S^T E of each bucket: the frame E, copied
    to the slots in which each pixel was open, and 0 in the others.

    With `guesses`, a first guess of the clip is another input, and the network predicts a
    correction and a gain of it (`gated`)."""

    def __init__(self, channels: Sequence[int], task: DecoderTask, size: str) -> None:
        """Build a three-dimensional U-Net for clips, with levels of `channels` channels.

        Its inputs are the frame copied to the open slots, for each bucket, and a first guess if
        this `size` makes one."""
        super().__init__()
        self.slots, self.guesses = task.slots, _guesses(task, size)
        network = UNet(
            task.buckets + self.guesses,
            outputs=2 if self.guesses else 1,
            widths=channels,
            dimensions=3,
        )
        self.network = begin_with_nothing(network) if self.guesses else network

    def forward(self, frame: Tensor, shutters: Tensor) -> Tensor:
        """Return the light of clips (batch, N, rows, cols), in full wells / N.

        `frame` is (batch, [buckets,] rows, cols) in full wells, `shutters` (N, r, c) are those of
        the first bucket for a tile."""
        volumes, opened = _lifted(frame, shutters, self.slots)
        guess = clip_guess(_added(volumes), *opened) if self.guesses else None
        inputs = volumes if guess is None else [*volumes, guess]
        output: Tensor = self.network(torch.stack(inputs, dim=1)).float()
        return output[:, 0] if guess is None else gated(guess, output[:, 0], output[:, 1])


def gated(guess: Tensor, added: Tensor, extra_share: Tensor) -> Tensor:
    """Return `guess * (1 + extra_share) + added`, all of one shape; with both 0, the guess itself.

    A clip's guess contains the pattern of the code. Removing it by addition would make the network
    reproduce the pattern; a gain removes it with one number."""
    return added + guess * (1 + extra_share)


def _lifted(frame: Tensor, shutters: Tensor, slots: int) -> tuple[list[Tensor], tuple[Tensor, ...]]:
    """Return S^T E (batch, N, rows, cols) of each bucket, the frame copied to the bucket's open
    slots, and the shutters of each bucket (N, rows, cols).

    `slots` is N; light is in full wells / N. The buckets stay separate, because their sum has light
    in every slot."""
    frames = frame.unbind(1) if frame.ndim == 4 else (frame,)
    array_shutters = laid(shutters, *frame.shape[-2:]).to(frame.dtype)
    opened = (
        shared_out(array_shutters, len(frames)).unbind() if len(frames) > 1 else (array_shutters,)
    )
    # A frame is the sum over its open slots; S^T E is in light a slot, so 1 is full well / N.
    return [lifted(e * slots, way)[0] for e, way in zip(frames, opened, strict=True)], opened


def _added(volumes: Sequence[Tensor]) -> Tensor:
    """Return the sum of tensors of one shape; a single one is returned itself, not copied."""
    return volumes[0] if len(volumes) == 1 else torch.stack([*volumes]).sum(dim=0)


def begin_with_nothing(network: UNet) -> UNet:
    """Set the weights of the last layer to zero in place, so that the untrained network adds
    nothing to the guess. Return the network."""
    nn.init.zeros_(network.last.weight)
    return network


_STAGES = {"paper": 9, "small": 3}
"""Number of stages, by the size of the decoder."""


class Unrolled(nn.Module):
    """A decoder that alternates a projection and a 2D U-Net.

    The projection is that of generalised alternating projection (Liao, Li and Carin, SIAM Journal
    on Imaging Sciences 2014): it distributes the difference between the frame and the clip's own
    capture over the slots in which each pixel was open. A U-Net has a channel per slot and sees the
    shutters.

    The clip starts from the first guess, or from `tv_iterations` of GAP-TV."""

    tv_iterations = 0
    """Iterations of GAP-TV that the clip starts from; 0 starts from the first guess."""

    def __init__(self, channels: Sequence[int], task: DecoderTask, size: str) -> None:
        """Build a denoiser, whose levels have `channels` channels, and a step size for each stage.
        `size` ("paper" or "small") chooses the number of stages."""
        super().__init__()
        self.slots = task.slots
        self.steps = nn.Parameter(torch.ones(_STAGES[size]))
        self.denoisers = nn.ModuleList(
            begin_with_nothing(
                UNet(2 * task.slots, outputs=task.slots, widths=channels, dimensions=2)
            )
            for _ in range(len(self.steps))
        )

    def forward(self, frame: Tensor, shutters: Tensor) -> Tensor:
        """Return the light of clips (batch, N, rows, cols), in full wells / N for each slot.

        `frame` (batch, rows, cols) is in full wells, `shutters` (N, r, c) are those of a tile. Each
        stage first corrects the clip so that it fits the measurement, then denoises it."""
        opened = laid(shutters, *frame.shape[-2:]).to(frame.dtype)
        energy = opened.square().sum(dim=0).clamp(min=1)
        # 1 is a full well for a frame, a full well / N for a slot.
        total = frame * self.slots
        if self.tv_iterations:
            clip = self._gap_tv(total, opened)
        else:
            clip = clip_guess(lifted(total, opened)[0], opened)
        shutter_channels = opened.expand_as(clip)
        for step, denoiser in zip(self.steps, self.denoisers, strict=True):
            missing = (total - (opened * clip).sum(dim=1)) / energy
            clip = clip + step * opened * missing.unsqueeze(1)
            clip = clip + denoiser(torch.cat([clip, shutter_channels], dim=1)).float()
        return clip

    @torch.no_grad()
    def _gap_tv(self, total: Tensor, opened: Tensor) -> Tensor:
        """Return clips (batch, N, rows, cols) by GAP-TV, from which the stages start; they pass no
        gradient.

        `total` (batch, rows, cols) is the frame in units of a slot, `opened` (N, rows, cols) its
        shutters."""
        measured = Measured.exact(total.float(), opened.float().unsqueeze(0))
        return gap_tv_of(measured, self.tv_iterations)[0].to(total)


class Refined(Unrolled):
    """The decoder `Unrolled`, started from a clip by GAP-TV. This start is better than the first
    guess, but passes no gradient to the codes."""

    tv_iterations = 20
