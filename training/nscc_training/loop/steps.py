"""One step of training, and a validation: capture, decode, score."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
import torch
from torch import Tensor

from nscc.diagnostics.rejection import rejected
from nscc_training import metrics
from nscc_training.data import Batch
from nscc_training.encoders.looks import LOOKS
from nscc_training.looking_model import looked
from nscc_training.loop.setup import Parts
from nscc_training.sensor_model import SensorModel, exposed, filled, read_out, shared_out


@dataclass(frozen=True)
class Scores:
    """Means over patches: the loss, PSNR in dB on 0..1 of the peak, SSIM."""

    loss: float
    psnr_db: float
    ssim: float


def generator_of(*numbers: int) -> torch.Generator:
    """A generator whose stream depends on all the numbers."""
    state = np.random.SeedSequence(list(numbers)).generate_state(1, np.uint64)[0]
    return torch.Generator().manual_seed(int(state) >> 1)


def window(shutters: Tensor, rows: int, cols: int, seed: tuple[int, ...]) -> Tensor:
    """The shutters over a patch: a tile from its corner, or some part of an array of free codes."""
    if shutters.shape[1] <= rows and shutters.shape[2] <= cols:
        return shutters
    draw = np.random.default_rng(list(seed))
    row = int(draw.integers(max(shutters.shape[1] - rows, 0) + 1))
    col = int(draw.integers(max(shutters.shape[2] - cols, 0) + 1))
    return shutters[:, row : row + rows, col : col + cols]


def decoded(
    parts: Parts, light: Tensor, shutters: Tensor, model: SensorModel,
    generator: torch.Generator | None,
) -> Tensor:  # fmt: skip
    """What the decoder makes of a capture of `light` with `shutters`, a tile that repeats, those of
    the first bucket; a model without noise has no other effects either."""
    if parts.encoder.spec.kind == LOOKS:
        return _decoded_looks(parts, light, shutters, model, generator)
    with torch.autocast(parts.device.type, enabled=False):
        # What a frame means is the run's to say, under another sensor too.
        if parts.emulated is None or not model.shot_noise:
            exposure = exposed(light, shared_out(shutters, parts.buckets))
            codes = read_out(exposure, model, generator) - model.adc_offset_lsb
            frame = parts.model.relative(codes)
        else:
            exposure = exposed(parts.emulated.smeared(light), shutters)
            share = shutters.detach().mean(dim=0)
            codes, full = parts.emulated.read_out(exposure, share, model, generator)
            frame = filled(parts.model.relative(codes), full, shutters.detach())
    mixed = parts.settings.train.dtype == "bf16"
    with torch.autocast(parts.device.type, torch.bfloat16, enabled=mixed):
        found: Tensor = parts.decoder(frame, shutters)
    return found.float()


def _decoded_looks(
    parts: Parts, light: Tensor, fields: Tensor, model: SensorModel,
    generator: torch.Generator | None,
) -> Tensor:  # fmt: skip
    """The same of pixels that look: the decoder is told how long each pixel was open."""
    step_e = parts.target.electrons_per_step
    with torch.autocast(parts.device.type, enabled=False):
        codes, share = looked(light, fields, parts.slots, step_e, model, generator)
        frame = parts.model.relative(codes - model.adc_offset_lsb)
    mixed = parts.settings.train.dtype == "bf16"
    with torch.autocast(parts.device.type, torch.bfloat16, enabled=mixed):
        # Each patch has open times of its own, and a decoder takes one map of them.
        made = [parts.decoder(f[None], s[None]) for f, s in zip(frame, share, strict=True)]
    return torch.cat(made).float()


def loss_of(parts: Parts, prediction: Tensor, batch: Batch, shutters: Tensor) -> Tensor:
    """The loss, and the stand-in for words a slot: how many places change between slots."""
    found = parts.loss(*compared(prediction, batch))
    weight = parts.settings.shutter.words_weight
    if weight:
        found = found + weight * changes_of(shutters).mean()
    return found


def changes_of(shutters: Tensor) -> Tensor:
    """In which part of the steps from slot to slot each place of (N, rows, cols) changes."""
    return (shutters[1:] - shutters[:-1]).abs().sum(dim=0) / max(1, len(shutters) - 1)


def compared(prediction: Tensor, batch: Batch) -> tuple[Tensor, Tensor]:
    """Prediction and truth over the peak, as losses take them.

    As in metrics, light above the peak counts as the peak, wherever the truth is above it.
    """
    made = prediction / batch.peak.reshape(-1, *([1] * (prediction.ndim - 1)))
    return made if batch.most is None else made.clamp(max=batch.most), batch.goal


def finite_norm(loss: Tensor, parts: Parts, batch: Batch, step: int) -> Tensor:
    """The norm of the decoder's gradients, all taken together.

    Rejected (NS0817, status 3) where the loss or a gradient, the codes' included, is not finite;
    nothing was learned. The batch is named, so that its scenes can be looked at.
    """
    decoder, codes = (
        {key: p.grad for key, p in module.named_parameters() if p.grad is not None}
        for module in (parts.decoder, parts.encoder)
    )
    norms = [torch.nn.utils.get_total_norm(grads.values()) for grads in (decoder, codes)]
    if all(map(math.isfinite, (loss.item(), *(norm.item() for norm in norms)))):
        return norms[0]
    wrong = "the loss"
    if math.isfinite(loss.item()):
        named = {f"decoder.{k}": v for k, v in decoder.items()}
        named |= {f"codes.{k}": v for k, v in codes.items()}
        bad = (name for name, grad in named.items() if not bool(torch.isfinite(grad).all()))
        wrong = f"the gradient of {next(bad, 'all parameters together')}"
    raise rejected(
        "NS0817",
        f"{wrong} is not finite in step {step}",
        notes=("the batch: " + "; ".join(batch.names),),
        helps=("look at these scenes, lower [train] rate, or use the dtype f32",),
        data={"step": step, "batch": list(batch.names)},
        status=3,
    )


@torch.no_grad()
def scored(
    parts: Parts, batches: Iterable[Batch], shutters: Tensor, model: SensorModel, seed: int,
    exposure: float = 1.0,
) -> Scores:  # fmt: skip
    """Scores of the decoder on batches, with shutters of the tile or the array.

    `exposure` makes all light so many times brighter than the decoder expects; the truth with it.
    """
    losses, values, similar = [], [], []
    for index, given in enumerate(batches):
        batch = given.to(parts.device)
        rows, cols = batch.light.shape[-2:]
        laid_out = window(shutters, rows, cols, (seed, 8, index)).to(parts.device)
        generator = generator_of(seed, 9, index)
        prediction = decoded(parts, batch.light * exposure, laid_out, model, generator) / exposure
        losses.append(loss_of(parts, prediction, batch, laid_out).item())
        for made, truth, peak in zip(prediction, batch.truth, batch.peak, strict=True):
            pair = [np.clip((x / peak).cpu().numpy(), 0, 1) for x in (truth, made)]
            values.append(metrics.psnr(pair[0], pair[1], 1.0))
            similar.append(metrics.ssim(pair[0], pair[1], 1.0))
    return Scores(float(np.mean(losses)), metrics.finite_mean(values), float(np.mean(similar)))
