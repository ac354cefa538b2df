"""Crosstalk between neighbours."""

from __future__ import annotations

import numpy as np

from nscc.arrays import Floats
from nscc_runtime.effects.effect import Effect, parameter
from nscc_runtime.effects.parts import Exchange

FRACTION = parameter(
    "crosstalk_fraction",
    "light",
    0.005,
    "1",
    0,
    0.2,
    "part of a pixel's charge that each of its four neighbours gets",
)


def smeared(charge: Floats, fraction: float) -> Floats:
    """Return the charge after each pixel has given the part `fraction` of its own to each of its
    neighbours: q + fraction laplacian(q) of charge q (.., rows, cols), as a new array. A pixel at
    the border keeps what a missing neighbour would get."""
    flow = np.zeros_like(charge)
    down = charge[..., 1:, :] - charge[..., :-1, :]
    right = charge[..., :, 1:] - charge[..., :, :-1]
    flow[..., :-1, :] += down
    flow[..., 1:, :] -= down
    flow[..., :, :-1] += right
    flow[..., :, 1:] -= right
    return np.asarray(charge + fraction * flow)


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
    reference={"neighbours": lambda slots, charge: smeared(charge, FRACTION(slots.sensor))},
    size="rms and mean of c sum S laplacian(E), dark charge included, and of the noise of the "
    "counts that pass between pixels; worst at saturated and moving edges",
    sums=(Exchange(FRACTION, smeared),),
    cost_ns=20.0,
    light_ns=0.8,
)
