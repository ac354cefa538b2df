"""One step of training: capture, decode, and the loss of decoded light and of lessons."""

from __future__ import annotations

from collections.abc import Iterator
from math import log

import numpy as np
import torch
from torch import Tensor, nn
from torch.nn import functional

from nscc.diagnostics.diagnostic import rejected
from nscc_training.any_code.decode import AnyCode
from nscc_training.any_code.lessons import Lesson, measured_lesson, noisy
from nscc_training.any_code.network import SEEN
from nscc_training.any_code.stages import coded_light, schedule, stage, started_still, still_stages
from nscc_training.baselines.gap_tv import gap_tv_of
from nscc_training.code_choices import LOOKS, SEARCHED
from nscc_training.curves import MU, srgb
from nscc_training.data import Batch
from nscc_training.data.exposures import quantiles
from nscc_training.draws import generator_of
from nscc_training.encoders import CodeTrial, Encoder
from nscc_training.looking_model import looked
from nscc_training.loop.optimizers import codes_learn, settling_step
from nscc_training.loop.ranks import Ranks
from nscc_training.loop.setup import TrainingSetup
from nscc_training.random_streams import DrawStream
from nscc_training.sensor_model import SensorModel, exposed, filled, laid, read_out, shared_out


def window(shutters: Tensor, rows: int, cols: int, seed: tuple[int, ...]) -> Tensor:
    """Return the shutters (N, r, c) for patches of rows x cols. A tile that fits in a patch is
    returned whole; of a larger one, a random part of that size, drawn with `seed`."""
    if shutters.shape[1] <= rows and shutters.shape[2] <= cols:
        return shutters
    draw = np.random.default_rng(list(seed))
    row = int(draw.integers(max(shutters.shape[1] - rows, 0) + 1))
    col = int(draw.integers(max(shutters.shape[2] - cols, 0) + 1))
    return shutters[:, row : row + rows, col : col + cols]


def decoded(
    setup: TrainingSetup,
    light: Tensor,
    shutters: Tensor,
    model: SensorModel,
    generator: torch.Generator | None,
) -> Tensor:
    """Capture `light` and decode the frames. Return light as decoders do: (batch, rows, cols) for
    stills, (batch, N, rows, cols) for clips.

    `light` is (batch, rows, cols) in electrons over the frame, or (batch, N, rows, cols) per slot.
    `shutters` (N, r, c) are a tile for the first bucket; for pixels that look, their boundaries and
    levels. `model` may differ from the run's own; without photon noise it has no other effects
    either. Without a generator there is no noise."""
    with torch.autocast(setup.device.type, enabled=False):
        # The run's own model defines the unit of a frame, under another sensor too.
        if setup.encoder.spec.kind == LOOKS:
            step_e = setup.target.electrons_per_step
            codes, share = looked(light, shutters, setup.slots, step_e, model, generator)
            frame = setup.model.relative(codes - model.adc_offset_lsb)
            shutters = share.unsqueeze(1)  # the open fraction of each pixel
        elif setup.emulated is None or not model.shot_noise:
            exposure = exposed(light, shared_out(shutters, setup.buckets))
            codes = read_out(exposure, model, generator) - model.adc_offset_lsb
            frame = setup.model.relative(codes)
        else:
            exposure = exposed(setup.emulated.smeared(light), shutters)
            codes, full = setup.emulated.read_out(exposure, model, generator)
            frame = filled(setup.model.relative(codes), full, shutters.detach())
    mixed = setup.settings.train.dtype == "bf16"
    with torch.autocast(setup.device.type, torch.bfloat16, enabled=mixed):
        prediction: Tensor = setup.decoder(frame, shutters)
    return prediction.float()


def loss_of(setup: TrainingSetup, prediction: Tensor, batch: Batch, shutters: Tensor) -> Tensor:
    """Return the loss of a prediction (as decoders return it) for a batch, a scalar. `shutters` (N,
    r, c) are those of the step. With `shutter.words_weight`, how often the shutters change, which
    takes words, is added."""
    loss = setup.loss(*compared(prediction, batch))
    weight = setup.settings.shutter.words_weight
    if weight:
        loss = loss + weight * changes_of(shutters).mean()
    return loss


def changes_of(shutters: Tensor) -> Tensor:
    """Return the fraction of the boundaries between slots at which the shutter (N, rows, cols) of
    each pixel changes, (rows, cols); 0 for one slot. Soft shutters count by how much they change.
    """
    return (shutters[1:] - shutters[:-1]).abs().sum(dim=0) / max(1, len(shutters) - 1)


def compared(prediction: Tensor, batch: Batch) -> tuple[Tensor, Tensor]:
    """Return prediction and truth as losses compare them: relative to the peak, the light that
    counts as 1.

    As in metrics, predictions above the peak are clipped where the truth reaches the peak. For
    classes, return the prediction and the classes of the batch, both (batch, classes), unchanged.
    """
    if batch.classes is not None:
        return prediction, batch.classes
    relative = prediction / batch.peak.reshape(-1, *([1] * (prediction.ndim - 1)))
    return torch.minimum(relative, batch.most), batch.goal


def finite_norm(loss: Tensor, setup: TrainingSetup, names: tuple[str, ...], step: int) -> Tensor:
    """Return the norm of all gradients of the decoder, to be called before the update of step
    `step`.

    Raises Rejected (NS0817, status 3) if the loss or a gradient of decoder or codes is not finite.
    The message contains `names`, the scenes of the batch."""
    decoder, codes = (
        {key: p.grad for key, p in module.named_parameters() if p.grad is not None}
        for module in (setup.decoder, setup.encoder)
    )
    norms = [torch.nn.utils.get_total_norm(grads.values()) for grads in (decoder, codes)]
    values = torch.stack(
        [loss.detach().double(), *(norm.to(loss.device).double() for norm in norms)]
    )
    if bool(torch.isfinite(values).all()):
        return norms[0]
    culprit = "the loss"
    if bool(torch.isfinite(values[0])):
        named = {f"decoder.{k}": v for k, v in decoder.items()}
        named |= {f"codes.{k}": v for k, v in codes.items()}
        not_finite = (name for name, grad in named.items() if not bool(torch.isfinite(grad).all()))
        culprit = f"the gradient of {next(not_finite, 'all parameters together')}"
    raise rejected(
        "NS0817",
        f"{culprit} is not finite in step {step}",
        notes=("the batch: " + "; ".join(names),),
        helps=("check these scenes, lower [train] rate, or use the dtype f32",),
        data={"step": step, "batch": list(names)},
        status=3,
    )


class StepLoss(nn.Module):
    """The loss of a batch in one step. It is a module, so that torch averages its gradients over
    the processes that train together."""

    def __init__(self, setup: TrainingSetup, ranks: Ranks) -> None:
        """Prepare to compute losses of the run `setup`. `ranks` are the processes that train
        together."""
        super().__init__()
        self.encoder, self.decoder = setup.encoder, setup.decoder
        self._setup, self._ranks = setup, ranks

    def forward(self, batch: Batch, step: int) -> Tensor:
        """Return the loss of one step on this process's share of the batch, times the weight of
        that share.

        In a step in which codes do not learn, they are fixed, and a search that has not begun uses
        random ones. Otherwise they are relaxed or tried: with a trial, two versions of the codes
        are decoded, and the difference of their losses gives the codes a gradient."""
        setup, settings, rank = self._setup, self._setup.settings, self._ranks.rank
        seed, device = settings.train.seed, setup.device
        rows, cols = batch.light.shape[-2:]
        window_seed = (seed, DrawStream.TILE_WINDOWS, step)
        trial = None
        learns = codes_learn(settings, step)
        if learns and setup.encoder.relaxation == "tried":
            trial = trial_of(
                setup.encoder, rows, cols, (seed, DrawStream.RELAXED_CODES, step, rank), window_seed
            )
            shutters = trial.shutters[0]
        elif learns:
            # All processes share the noise of the codes, and draw the sensor's noise independently.
            tile = setup.encoder(generator_of(device, seed, DrawStream.RELAXED_CODES, step))
            shutters = window(tile, rows, cols, window_seed)
        else:
            searched = settings.shutter.learn and setup.encoder.relaxation in SEARCHED
            waits = searched and step < settling_step(settings)
            tile = setup.random_tile(step) if waits else setup.encoder.hard()
            shutters = window(tile, rows, cols, window_seed)
        noise = (seed, DrawStream.READOUT_NOISE, step, rank)
        prediction = decoded(
            setup, batch.light, shutters, setup.model, generator_of(device, *noise)
        )
        loss = loss_of(setup, prediction, batch, shutters)
        if trial is not None:
            loss = loss + pull(setup, batch, trial, prediction, generator_of(device, *noise))
        return loss * self._ranks.weight(settings.train.batch)


def trial_of(
    encoder: Encoder, rows: int, cols: int, seed: tuple[int, ...], window_seed: tuple[int, ...]
) -> CodeTrial:
    """Return a trial (`CodeTrial`) of the encoder's codes, which it must have, for patches of rows
    x cols.

    `seed` is that of the trial's random moves. If the tile is larger than a patch, `window_seed`
    seeds the choice of its part."""

    def over(tile: Tensor) -> Tensor:
        """Return values of the tile (.., r, c), or of a part of it, repeated over a patch."""
        return laid(window(tile, rows, cols, window_seed), rows, cols)

    return encoder.trial(over, generator_of(next(encoder.parameters()).device, *seed))


def pull(
    setup: TrainingSetup, batch: Batch, trial: CodeTrial, prediction: Tensor, noise: torch.Generator
) -> Tensor:
    """Return a scalar of value 0 whose gradient with respect to the codes is that of the loss,
    estimated from a trial.

    A gradient through the capture shows the effect of a little more light on a measurement. It does
    not show that a saturated pixel carries no more information, nor what information its neighbours
    then lack. A trial does. Every pixel moves its code by independent normal noise, in both
    directions, and is credited with the difference of the losses around it: the gradient of the
    loss smoothed by that noise (Nesterov and Spokoiny, Foundations of Computational Mathematics
    2017), with one trial per pixel and step. The decoder learns from the first side, so that it
    also decodes the codes that are tried. Regular patterns then appear worse than they are; to
    reduce this, only a share of the pixels moves in a step.

    `prediction` is the decoder's output for the first side of the trial. `noise` must be a
    generator in the state that it had before that prediction."""
    with torch.no_grad():
        other_prediction = decoded(setup, batch.light, trial.shutters[1], setup.model, noise)
    sides = [prediction.detach().requires_grad_(), other_prediction.requires_grad_()]
    losses = torch.stack([setup.loss(*compared(estimate, batch)) for estimate in sides])
    # The difference of the losses, distributed over pixels by the trapezoidal rule
    # between both sides; exact for squared errors.
    gradient, other_gradient = torch.autograd.grad(losses.sum(), sides)
    with torch.no_grad():
        gain = (gradient + other_gradient) / 2 * (sides[0] - sides[1])
        gain = gain.sum(dim=tuple(range(gain.ndim - 2)))
        reach = setup.encoder.reach
        side = 2 * reach + 1
        around = side**2 * functional.avg_pool2d(gain[None], side, 1, reach)
        if weight := setup.settings.shutter.words_weight:
            # Words are credited to the pixel itself.
            first, second = map(changes_of, trial.shutters)
            around += weight * (first - second) / first.numel()
        slope = trial.moved * around / (2 * trial.spread**2 * setup.encoder.tried_share)
    pulled = (trial.fields * slope).sum()
    return pulled - pulled.detach()


def lesson_losses(
    setup: TrainingSetup, lesson: Lesson, generator: torch.Generator
) -> Iterator[Tensor]:
    """Yield the losses of a lesson, the training examples of one step of the decoder for any code.

    The caller updates the decoder after each loss; only then is the next one computed. `generator`
    draws the noise."""
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
    """Return the loss of denoising the clips of `lesson`, to which noise from `generator` is added:
    squared and absolute errors in units of the standard deviation of the noise."""
    clip = lesson.light
    noise, sigma = noisy(clip, generator)
    no_features = clip.new_zeros(len(clip), SEEN, *clip.shape[1:])
    error = (decoder.denoiser(noise, no_features, sigma) - clip) / sigma.reshape(-1, 1, 1, 1)
    loss: Tensor = error.square().mean() + 0.2 * error.abs().mean()
    return loss


def _of_codes(
    decoder: AnyCode, lesson: Lesson, generator: torch.Generator, stages: int, through: int
) -> Iterator[Tensor]:
    """Yield the losses of decoding the coded clips of `lesson` in `stages` stages, one loss for
    each `through` stages and for a rest at the end.

    No gradient passes from one loss to the stages of an earlier one, so that gradients fit in
    memory."""
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
    """Return the loss of decoding the coded stills of `lesson`: the mean of the losses
    (`_still_loss`) of the light after each of `stages` stages. `generator` draws the noise."""
    with torch.no_grad():
        truth, measured, _ = measured_lesson(lesson, generator)
        start = started_still(measured)
    lights = still_stages(measured, decoder.denoiser, start, stages)
    return torch.stack([_still_loss(light, truth[:, 0]) for light in lights]).mean()


def _difference(clip: Tensor, truth: Tensor, shown: Tensor | None) -> Tensor:
    """Return `clip` minus `truth`, both (batch, T, rows, cols). With `shown` (batch,), the light
    that a display shows as white, return the difference in display encoding; None returns that of
    light."""
    if shown is None:
        return clip - truth
    level = shown.reshape(-1, 1, 1, 1)
    return srgb(clip / level) - srgb(truth / level)


def _still_loss(light: Tensor, truth: Tensor) -> Tensor:
    """Return the error of light (batch, rows, cols): ten times the sum of an RMS error of linear
    light, one on the mu-law curve, and a mean error of the logarithm.

    The first two are relative to the 99.9 % quantile of the truth, clipped to 0..1, and averaged
    over the batch."""
    peak = quantiles(truth.flatten(1), 0.999).to(truth).clamp(min=1e-6).reshape(-1, 1, 1)
    relative, relative_truth = ((values / peak).clamp(0, 1) for values in (light, truth))
    # The square root of 1e-6 limits the slope for errors near 0.
    linear = (relative - relative_truth).square().mean(dim=(1, 2)).add(1e-6).sqrt()
    curved = [torch.log1p(MU * values) / log(1 + MU) for values in (relative, relative_truth)]
    bent = (curved[0] - curved[1]).square().mean(dim=(1, 2)).add(1e-6).sqrt()
    coded_error = (coded_light(light) - coded_light(truth)).abs().mean(dim=(1, 2))
    return 10 * (linear + bent + coded_error).mean()
