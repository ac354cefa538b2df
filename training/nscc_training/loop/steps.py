"""One step of training: capture, decode, loss."""

from __future__ import annotations

import numpy as np
import torch
from torch import Tensor

from nscc.diagnostics.diagnostic import rejected
from nscc_training.code_choices import LOOKS
from nscc_training.data import Batch
from nscc_training.looking_model import looked
from nscc_training.loop.setup import TrainingSetup
from nscc_training.sensor_model import SensorModel, exposed, filled, read_out, shared_out


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
