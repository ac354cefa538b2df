"""Reconstruct stills and clips of any code, and the trainable decoder `any`."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from importlib.resources import as_file, files
from pathlib import Path

import torch
from torch import Tensor, nn
from torch.nn import functional

from nscc_runtime.progress import Progress, unseen
from nscc_training.any_code.network import WIDTHS, ClipDenoiser, bf16_where_multiplied
from nscc_training.any_code.stages import (
    STAGES,
    STILL_STAGES,
    denoised_in_tiles,
    led,
    mirrored,
    schedule,
    stage,
    started_still,
    still_stages,
)
from nscc_training.baselines.gap_tv import gap_step, gap_tv_of
from nscc_training.decoders.declared import DecoderTask
from nscc_training.measured import Measured
from nscc_training.sensor_model import laid, shared_out

WEIGHTS = "weights.safetensors"
_BRIGHT = 0.995
"""The quantile of light that counts as white."""


@cache
def shipped(kind: str) -> ClipDenoiser:
    """Return the denoiser whose weights come with nscc, for evaluation only: it holds no gradients.

    `kind` is "clip" or "still"; another one has no weights, which raises RuntimeError. The result
    is cached, so all callers share one network."""
    from safetensors.torch import load_file

    with as_file(files(__package__) / WEIGHTS) as path:
        weights = load_file(path)
    state = {
        name.removeprefix(f"{kind}."): weight.float()
        for name, weight in weights.items()
        if name.startswith(f"{kind}.")
    }
    denoiser = ClipDenoiser()
    denoiser.load_state_dict(state)
    return denoiser.eval().requires_grad_(False)


def write_shipped(clip: Path, still: Path, out: Path) -> None:
    """Write the denoisers of two training runs into one safetensors file, in half precision.

    `clip` and `still` are the folders of the runs, whose decoders must be "any"; `out` is the file
    that `shipped` reads as part of the package. Other weights of their decoders are left out."""
    from safetensors.torch import load_file, save_file

    state = {
        f"{kind}.{name.removeprefix('denoiser.')}": weight.half()
        for kind, run in (("clip", clip), ("still", still))
        for name, weight in load_file(run / "decoder.safetensors").items()
        if name.startswith("denoiser.")
    }
    save_file(state, out)


@torch.no_grad()
def decoded_clip(
    measured: Measured[Tensor], count: int = STAGES, progress: Progress = unseen
) -> Tensor:
    """Reconstruct the clip (batch, N, rows, cols) from frames, in their unit, in `count` stages.

    A stage is a correction towards the frames and a denoiser. If one of several readouts was always
    open, `joined` adds static content from all readouts. The denoiser expects white to be 1, so the
    measurement is first divided by an estimate of white. The result is at least 0. `progress`
    receives the stages and may show a bar. `measured` has light in any unit, and may have several
    readouts."""
    unit = white(measured)
    measured = measured.over(unit)
    number = always_open(measured)
    if number is None:
        clip = _coded_clip(measured, count, count, progress)
    else:
        coded = _coded_clip(measured, count, min(count, FIRST_STAGE), progress)
        clip = joined(measured, coded, number)
    return clip.clamp_(min=0).mul_(unit.reshape(-1, 1, 1, 1))


def _coded_clip(measured: Measured[Tensor], count: int, first: int, progress: Progress) -> Tensor:
    """Return the mean (batch, N, rows, cols) of the clips after stages `first` to `count` (1 is the
    first stage; `first` is at most `count`), corrected once towards the frames.

    The measurement must be divided by white. `progress` receives the stages."""
    clip, target = gap_tv_of(measured)
    mean = clip.new_zeros(())
    with bf16_where_multiplied():
        for number, sigma in enumerate(progress(schedule(count), "decoding the clip", count)):
            level = clip.new_full((len(clip),), sigma)
            clip, target = gap_step(measured, clip, target, level)
            clip = denoised_in_tiles(
                shipped("clip"),
                clip,
                lambda rows, cols: measured.crop(rows, cols).planes(),
                level,
                number,
            )
            if number + 1 >= first:
                # In place, because clips are the largest part of the memory.
                mean = (clip / (count + 1 - first)).add_(mean)
        del clip
        return led(measured, mean)


@torch.no_grad()
def decoded_still(measured: Measured[Tensor], count: int = STILL_STAGES) -> Tensor:
    """Reconstruct the light over the whole frame (batch, rows, cols), in the frames' unit, by
    `count` stages (at least one). The masks of `measured` have one slot, the open fraction of the
    frame.

    A stage is a correction towards the frames and a denoiser."""
    # Scale so that nearly the largest value is 1, as the stages require.
    unit = measured.value.amax(dim=(1, 2, 3)).clamp(min=1e-6)
    measured = measured.over(unit)
    light = started_still(measured)
    with bf16_where_multiplied():
        *_, light = still_stages(
            measured,
            lambda light, planes, level: denoised_in_tiles(
                shipped("still"), light, lambda rows, cols: planes[..., rows, cols], level
            ),
            light,
            count,
        )
    return light * unit.reshape(-1, 1, 1)


def white(measured: Measured[Tensor]) -> Tensor:
    """Return the light that counts as white for each measurement of the batch `measured`, (batch,):
    the 99.5 % quantile of the mean light of pixels that open at all.

    It is 1 for a frame whose pixels never open, and at least 1e-6."""
    total = measured.mask.sum(dim=(1, 2))
    mean = measured.mean()
    opened = (total > 0).expand_as(mean).flatten(1)
    # Pixels that never open are sorted to the front and not counted.
    ordered = torch.where(opened, mean.flatten(1), -torch.inf).sort(dim=1).values
    count = opened.sum(dim=1)
    closed = ordered.shape[1] - count
    rank = closed + _BRIGHT * (count - 1).clamp(min=0)
    below = rank.floor().long().clamp(max=ordered.shape[1] - 1)
    above = (below + 1).clamp(max=ordered.shape[1] - 1)
    low, high = (ordered.gather(1, index[:, None])[:, 0] for index in (below, above))
    level = torch.where(count > 0, low + (high - low) * (rank - below).to(low), 1.0)
    return level.clamp(min=1e-6)


FIRST_STAGE = 4
"""The first stage whose clip enters the mean of clips.

The errors of the stages differ, because each sees the clip mirrored in another way. The mean gains
0.2 dB in moving and 4 dB in static regions."""
_WIDE, _NARROW, _AROUND = 9, 5, 15
"""Window sides in pixels: for two measures of motion, and for the error of the clip's mean."""
_STILL, _MOVING = 0.25, 0.6
"""Limits of the motion measure: below the first all is static, above the second all is moving."""


def always_open(measured: Measured[Tensor]) -> int | None:
    """Return the index of the readout of `measured` whose shutters never close in any slot and
    pixel, for all of the batch.

    If there are several, the first is returned. Return None if there is none, or if all readouts
    are always open."""
    opened = (measured.mask > 0).all(dim=2).flatten(2).all(dim=2).all(dim=0)
    if bool(opened.all()) or not bool(opened.any()):
        return None
    return int(opened.int().argmax())


def joined(measured: Measured[Tensor], clip: Tensor, number: int) -> Tensor:
    """Return the clip (batch, N, rows, cols) with static light where the readouts agree, and `clip`
    elsewhere.

    `number` is the index, among the readouts of `measured`, of one that is always open; motion is
    judged by the other readouts. Without motion all readouts measure the same light, and their mean
    has less noise than an ordinary frame. This needs no training, because the noise of every
    readout is known. The static light is the mean of all readouts, weighted by precision. It is
    moved towards the mean of `clip` if their difference is within the noise. Its error is therefore
    close to the noise of the readouts at most, and it is smooth if `clip` is right."""
    opened = measured.mask.sum(dim=2)
    light = measured.value / opened.clamp(min=1e-9)
    variance = measured.variance / opened.clamp(min=1e-9).square()
    known = (opened > 0) & ~measured.saturated
    precision = torch.where(known, 1 / variance.clamp(min=1e-12), 0.0)
    total = precision.sum(dim=1, keepdim=True)
    noise = 1 / total.clamp(min=1e-12)
    mean = (precision * light).sum(dim=1, keepdim=True) * noise
    # A saturated pixel had at least the light of its fullest readout.
    still = torch.where(total > 0, mean, light.amax(dim=1, keepdim=True))
    smooth = clip.mean(dim=1, keepdim=True)
    apart = _around((still - smooth).square(), _AROUND)
    share = (1 - _around(noise.clamp(max=1), _AROUND) / apart.clamp(min=1e-12)).clamp(0, 1)
    steady = smooth + share * (still - smooth)
    # The mean contains a part of each readout's noise, so their difference has less noise.
    spread = (variance - noise).clamp(min=1e-3 * variance.clamp(min=1e-9)).sqrt()
    deviation = torch.where(known, (light - mean) / spread, 0.0)
    coded = [k for k in range(light.shape[1]) if k != number]
    gate = ((_MOVING - motion(deviation[:, coded])) / (_MOVING - _STILL)).clamp(0, 1)
    return clip + gate.unsqueeze(1) * (steady - clip)


def motion(deviation: Tensor) -> Tensor:
    """Return a measure of motion (batch, rows, cols): about 0 where nothing moves.

    `deviation` (batch, B, rows, cols) is the difference of each coded readout from the light that
    it would have without motion, in standard deviations of its noise. The measure is the mean
    square in a wide window minus 1, plus the squared mean in a narrow window, averaged over
    readouts."""
    wide = _around(deviation.square(), _WIDE) - 1
    return (wide + _around(deviation, _NARROW).square()).mean(dim=1)


def _around(values: Tensor, side: int) -> Tensor:
    """Return the mean of `values` (batch, [B,] rows, cols) in a square of `side` pixels (odd)
    around each pixel.

    At the border only the pixels inside count."""
    return functional.avg_pool2d(values, side, 1, side // 2, count_include_pad=False)


_STAGES = {"paper": 8, "small": 4}
"""Number of stages for clips, by the size of the decoder that the settings name."""
_NOISE = (1e-5, 3e-5)
"""Variance of a dark pixel, and its increase up to a full pixel, relative to the squared full well.

The values fit a full well of 30,000 electrons and 8 bits. Runs use their own noise."""


class AnyCode(nn.Module):
    """The decoder for any code as a torch module: `stages` times a step towards the frames and a
    denoiser.

    It starts from nscc's weights if it has their widths.

    Inputs: frames (batch, rows, cols), or of two buckets (batch, 2, rows, cols), in full wells and
    saturated at 1; shutters (N, r, c) of the first bucket, as a tile. Output: light in full wells
    over the frame (batch, rows, cols), or for clips in full wells / N per slot (batch, N, rows,
    cols). Clips start from GAP-TV, which passes no gradient."""

    def __init__(self, channels: Sequence[int], task: DecoderTask, size: str) -> None:
        """Build the decoder. Take the shipped weights if `channels`, the widths of its three
        scales, are those of the shipped network, else random ones.

        `task` says whether to decode stills or clips. `size` ("paper" or "small") chooses the
        number of stages for clips, 8 or 4. The two noise parameters are learned, too."""
        super().__init__()
        self.still = task.kind == "still"
        self.stages = STILL_STAGES if self.still else _STAGES[size]
        self.denoiser = ClipDenoiser(tuple(channels))
        if self.denoiser.widths == WIDTHS:
            self.denoiser.load_state_dict(shipped(task.kind).state_dict())
        self.noise = nn.Parameter(torch.tensor(_NOISE).log())

    def begin_anew(self) -> None:
        """Replace the weights of the denoiser, which may be those that nscc ships, by random
        weights."""
        self.denoiser = ClipDenoiser(self.denoiser.widths)

    def forward(self, frame: Tensor, shutters: Tensor) -> Tensor:
        """Return the light of frames: (batch, rows, cols) for stills, (batch, N, rows, cols) for
        clips.

        `frame` (batch, [buckets,] rows, cols) is in full wells; a value of 1 counts as saturated.
        `shutters` (N, r, c) are 1 where the first bucket is open, for one tile that is repeated
        over the frame. Light over the frame is in full wells, the light of a slot in full wells /
        N."""
        opened = laid(shutters, *frame.shape[-2:]).to(frame.dtype)
        slots = 1 if self.still else opened.shape[-3]
        mask = opened.mean(dim=-3, keepdim=True) if self.still else opened
        if frame.ndim == 3:
            frame, masks = frame.unsqueeze(1), mask.unsqueeze(-4)
        else:
            masks = shared_out(mask, frame.shape[1])
        dark, gained = self.noise.exp()
        # Frames of clips are multiplied by N, because light is in units of a full well / N.
        variance = slots**2 * (dark + gained * frame.clamp(min=0))
        masks = masks if masks.ndim == 5 else masks.unsqueeze(0)
        measured = Measured(slots * frame, masks, variance, frame >= 1)
        if self.still:
            start = started_still(measured)
            *_, light = still_stages(measured, self.denoiser, start, self.stages)
            return light
        # The start of a clip has no gradient: GAP-TV would need the memory of all its iterations.
        with torch.no_grad():
            unit = white(measured)
            clip, target = gap_tv_of(measured.over(unit))
        measured = measured.over(unit)
        for number, sigma in enumerate(schedule(self.stages)):
            clip, target = stage(measured, mirrored(self.denoiser, number), clip, target, sigma)
        return led(measured, clip) * unit.reshape(-1, 1, 1, 1)
