"""Losses for training the decoder for any code, one for each update."""

from __future__ import annotations

from collections.abc import Iterator
from math import log

import torch
from torch import Tensor

from nscc_training.any_code.decoder import AnyCode
from nscc_training.any_code.lessons import Lesson, measured_lesson, noisy
from nscc_training.any_code.network import SEEN
from nscc_training.any_code.stages import schedule, stage
from nscc_training.any_code.stills import coded_light, started_still, still_schedule, still_stage
from nscc_training.baselines.gap_tv import gap_tv_of
from nscc_training.curves import MU, srgb
from nscc_training.data.exposures import quantiles
from nscc_training.loop.setup import TrainingSetup


def lesson_losses(
    setup: TrainingSetup, lesson: Lesson, generator: torch.Generator
) -> Iterator[Tensor]:
    """Yield the losses of a lesson's updates; each is computed after the update before it."""
    decoder = setup.decoder
    assert isinstance(decoder, AnyCode)
    chosen = setup.settings.decoder
    mixed = setup.settings.train.dtype == "bf16"
    with torch.autocast(setup.device.type, torch.bfloat16, enabled=mixed):
        if chosen.lessons == "denoise":
            yield _of_noise(decoder, lesson, generator)
        elif chosen.lessons == "stills":
            yield _of_stills(decoder, lesson, generator, chosen.stages)
        else:
            yield from _of_codes(decoder, lesson, generator, chosen.stages, chosen.through)


def _of_noise(decoder: AnyCode, lesson: Lesson, generator: torch.Generator) -> Tensor:
    clip = lesson.light
    noise, sigma = noisy(clip, generator)
    no_features = clip.new_zeros(len(clip), SEEN, *clip.shape[1:])
    error = (decoder.denoiser(noise, no_features, sigma) - clip) / sigma.reshape(-1, 1, 1, 1)
    loss: Tensor = error.square().mean() + 0.2 * error.abs().mean()
    return loss


def _of_codes(
    decoder: AnyCode, lesson: Lesson, generator: torch.Generator, stages: int, through: int
) -> Iterator[Tensor]:
    with torch.no_grad():
        truth, measured, shown = measured_lesson(lesson, generator)
        clip, target = gap_tv_of(measured)
    waiting: list[Tensor] = []
    for number, sigma in enumerate(schedule(stages), start=1):
        clip, target = stage(measured, decoder.denoiser, clip, target, sigma)
        # The square root weights clips by relative error, similar to decibels.
        squared = _difference(clip, truth, shown).square().mean(dim=(1, 2, 3))
        waiting.append(squared.add(1e-6).sqrt().mean())
        if number % through == 0 or number == stages:
            yield torch.stack(waiting).mean() * 10
            waiting.clear()
            clip, target = clip.detach(), target.detach()


def _of_stills(decoder: AnyCode, lesson: Lesson, generator: torch.Generator, stages: int) -> Tensor:
    with torch.no_grad():
        truth, measured, _ = measured_lesson(lesson, generator)
        light = started_still(measured)
    losses = []
    for sigma in still_schedule(stages):
        light = still_stage(measured, decoder.denoiser, light, sigma)
        losses.append(_still_loss(light, truth[:, 0]))
    return torch.stack(losses).mean()


def _difference(clip: Tensor, truth: Tensor, shown: Tensor | None) -> Tensor:
    """Return the difference of two clips; with `shown` as white, in display encoding."""
    if shown is None:
        return clip - truth
    level = shown.reshape(-1, 1, 1, 1)
    return srgb(clip / level) - srgb(truth / level)


def _still_loss(light: Tensor, truth: Tensor) -> Tensor:
    """Return the error of light and of its logarithm, relative to the 99.9 % quantile.

    The loss is close to the scores of protocol hdr-v1."""
    peak = quantiles(truth.flatten(1), 0.999).to(truth).clamp(min=1e-6).reshape(-1, 1, 1)
    relative, relative_truth = ((values / peak).clamp(0, 1) for values in (light, truth))
    linear = (relative - relative_truth).square().mean(dim=(1, 2)).add(1e-6).sqrt()
    curved = [torch.log1p(MU * values) / log(1 + MU) for values in (relative, relative_truth)]
    bent = (curved[0] - curved[1]).square().mean(dim=(1, 2)).add(1e-6).sqrt()
    coded_error = (coded_light(light) - coded_light(truth)).abs().mean(dim=(1, 2))
    return 10 * (linear + bent + coded_error).mean()
