"""Crosstalk between neighbours."""

from __future__ import annotations

import numpy as np

from nscc_runtime.effects.effect import CannotHave, Effect, InLoop
from nscc_runtime.effects.field import Field, Sampled, Values
from nscc_runtime.effects.parameters import parameter
from nscc_runtime.effects.parts import Exchange
from nscc_runtime.effects.views import Slots

FRACTION = parameter(
    "crosstalk_fraction", "light", 0.005, "1", 0, 0.2,
    "part of a pixel's charge that each of its four neighbours gets",
)  # fmt: skip


def smeared(charge: Values, fraction: float) -> Values:
    """q + c laplacian(q) along the last two axes (rows, cols); the border reflects."""
    flow = np.zeros_like(charge)
    down = charge[..., 1:, :] - charge[..., :-1, :]
    right = charge[..., :, 1:] - charge[..., :, :-1]
    flow[..., :-1, :] += down
    flow[..., 1:, :] -= down
    flow[..., :, :-1] += right
    flow[..., :, 1:] -= right
    return np.asarray(charge + fraction * flow)


def _smear(slots: Slots, charge: Values) -> Values:
    return smeared(charge, FRACTION(slots.sensor))


def _field(sample: Sampled) -> Field:
    """rms and mean of c sum S laplacian(E), dark charge included, and of the noise of the counts
    that pass between pixels; worst at saturated and moving edges"""
    part = FRACTION(sample.sensor)
    if part == 0:
        return Field()
    # Of dark charge four neighbours' counts, and four parts of the pixel's own.
    counts = sample.counted(moved=True) + 20 * (sample.dark_2_s * sample.dark)
    # Charge that is shared is less noisy: dark charge keeps (1 - 4c)^2 + 4c^2 of its variance.
    noise = sample.counted() - sample.counted_alone()
    noise = noise + (20 * part**2 - 8 * part) * sample.dark_2_s * sample.dark
    return Field(
        sample.base - sample.alone + sample.dark_s * sample.spilt,
        variance=part**2 * counts,
        noise=noise,
    )


CROSSTALK = Effect(
    name="crosstalk",
    stream=14,
    kind="fixed",
    title="crosstalk between neighbouring photodiodes",
    model="A part c of the charge that falls on a pixel in a slot reaches each of its four "
    "neighbours instead, noise included: q + c laplacian(q). At the array's border nothing "
    "is lost: a pixel without a neighbour keeps that part.",
    cost="five reads a sample; a halo of one pixel around each tile",
    applied="to the charge of every slot, drawn, before it falls on PIX",
    parameters=(FRACTION,),
    reference={"neighbours": _smear},
    field=_field,
    sums=(Exchange(FRACTION, smeared),),
    fused=CannotHave("it goes through pixels one by one"),
    # Neighbours multiply what has to be counted.
    words=InLoop("exchanges", {"exchanged": FRACTION}),
    cost_ns=3.0,
    light_ns=0.5,
)
