"""One step of training: capture, decode, and what the loss makes of it."""

from __future__ import annotations

import numpy as np
import torch
from torch import Tensor

from nscc.diagnostics.rejection import rejected
from nscc_training.data import Batch
from nscc_training.encoders.looks import LOOKS
from nscc_training.looking_model import looked
from nscc_training.loop.setup import Parts
from nscc_training.sensor_model import SensorModel, exposed, filled, read_out, shared_out


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
        made: Tensor = parts.decoder(frame, share.unsqueeze(1))
    return made.float()


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
    return torch.minimum(made, batch.most), batch.goal


def finite_norm(loss: Tensor, parts: Parts, names: tuple[str, ...], step: int) -> Tensor:
    """The norm of the decoder's gradients, all taken together.

    Rejected (NS0817, status 3) where the loss or a gradient, the codes' included, is not finite;
    nothing was learned. The batch is named, so that its scenes can be looked at.
    """
    decoder, codes = (
        {key: p.grad for key, p in module.named_parameters() if p.grad is not None}
        for module in (parts.decoder, parts.encoder)
    )
    norms = [torch.nn.utils.get_total_norm(grads.values()) for grads in (decoder, codes)]
    told = torch.stack([loss.detach().double(), *(norm.to(loss.device).double() for norm in norms)])
    if bool(torch.isfinite(told).all()):
        return norms[0]
    wrong = "the loss"
    if bool(torch.isfinite(told[0])):
        named = {f"decoder.{k}": v for k, v in decoder.items()}
        named |= {f"codes.{k}": v for k, v in codes.items()}
        bad = (name for name, grad in named.items() if not bool(torch.isfinite(grad).all()))
        wrong = f"the gradient of {next(bad, 'all parameters together')}"
    raise rejected(
        "NS0817",
        f"{wrong} is not finite in step {step}",
        notes=("the batch: " + "; ".join(names),),
        helps=("look at these scenes, lower [train] rate, or use the dtype f32",),
        data={"step": step, "batch": list(names)},
        status=3,
    )
