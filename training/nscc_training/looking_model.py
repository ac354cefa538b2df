"""Sensor model for training pixels that look: from light to codes and open times.

The light is constant. A look compares the charge of the pixel, plus the comparator's offset and
noise, with the level. The first look above its level closes the pixel."""

from __future__ import annotations

import torch
from torch import Tensor
from torch.special import ndtr

from nscc_training.draws import normal
from nscc_training.gradients import saturated
from nscc_training.sensor_model import SensorModel, laid, read_out


def looked(
    light: Tensor,
    fields: Tensor,
    slots: int,
    step_e: float,
    sensor: SensorModel,
    generator: torch.Generator | None,
) -> tuple[Tensor, Tensor]:
    """Return the converter codes of the frame and the open fraction of each pixel, both (batch,
    rows, cols).

    `light` (batch, rows, cols) is in electrons over the frame. `fields` (2 looks, r, c) contains
    first the boundaries of the looks (whole numbers of slots, increasing), then their levels in
    steps of IN of `step_e` electrons; it repeats over the pixels. `slots` is the number of slots of
    the frame. Charge saturates at the full well of `sensor`. A pixel that no look closes stays open
    for the whole frame. Noise is drawn from `generator`, the same amount for all fields, so that
    two captures with equal generators differ only by the fields. Without a generator there is no
    noise. If fields have gradients, the exposure of a pixel is the drawn one, with the gradient of
    its probability. IN is the level sent to all pixels."""
    boundary, level = laid(fields.double(), *light.shape[-2:]).chunk(2)
    share = torch.cat([boundary / slots, torch.ones_like(boundary[:1])])
    light = light.double()
    charge = light[:, None] * share
    if generator is not None and sensor.shot_noise:
        between = torch.diff(share.detach(), dim=0, prepend=torch.zeros_like(share[:1]))
        photons = torch.sqrt((light.detach()[:, None] * between).clamp(min=0))
        # The charges at successive looks share the photons that arrived before, so that their noise
        # is added up.
        counted = (photons * normal(charge, generator)).cumsum(dim=1)
        charge = charge + sensor.noise_factor * counted
    charge_e = saturated(charge, -sensor.full_well_e, sensor.full_well_e, sensor.slope)
    well = sensor.full_well_e
    margin = charge_e[:, :-1] - level * step_e
    sigma = torch.sqrt((sensor.comparator_noise * well) ** 2 + light.detach()[:, None] * share[:-1])
    if generator is not None:
        offset = sensor.comparator_offset * well * normal(light, generator)[:, None]
        margin = margin + offset + sensor.comparator_noise * well * normal(margin, generator)
    chosen = _first(margin.detach() > 0)
    if fields.requires_grad:
        # The value of what was drawn, with the gradient of its probability.
        likely = _first(ndtr((charge_e[:, :-1] - level * step_e) / sigma.clamp(min=1.0)))
        chosen = chosen + likely - likely.detach()
    exposure = (chosen * charge_e).sum(dim=1)
    open_share = (chosen * share).sum(dim=1)
    # Photons are counted already; only the readout remains.
    quiet = sensor.counted()
    return read_out(exposure, quiet, generator), open_share.float()


def _first(above: Tensor) -> Tensor:
    """Return the weight of each exposure that a pixel may take, (batch, looks + 1, rows, cols).

    `above` (batch, looks, rows, cols) says whether each look is above its level, or with what
    probability. The weight is 1, or the probability, for the first look above; for the last
    exposure, the whole frame, that no look is above. The weights of a pixel add up to 1."""
    above = above.double()
    still = torch.cumprod(1 - above, dim=1)
    before = torch.cat([torch.ones_like(still[:, :1]), still[:, :-1]], dim=1)
    return torch.cat([above * before, still[:, -1:]], dim=1)
