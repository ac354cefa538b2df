"""Crosstalk between neighbours."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects.effect import Contribution, Effect

CROSSTALK = Effect(
    name="crosstalk",
    stream=14,
    kind="fixed",
    title="crosstalk between neighbouring photodiodes",
    model="A part c of the charge that falls on a pixel in a slot reaches each of its four "
    "neighbours instead, noise included: q + c laplacian(q). At the array's border nothing "
    "is lost: a pixel without a neighbour keeps that part.",
    contribution="rms = c rms(sum S laplacian(E)); worst at saturated and moving edges",
    parameters=("crosstalk_fraction",),
    cost="five reads a sample; a halo of one pixel around each tile",
    applied="to the charge of every slot, drawn, before it falls on PIX",
    predict=lambda scene, sensor: Contribution(sensor.crosstalk_fraction * scene.rms_laplacian_e),
)


def smeared(charge: NDArray[np.float64], fraction: float) -> NDArray[np.float64]:
    """q + c laplacian(q) along the last two axes (rows, cols); the border reflects."""
    flow = np.zeros_like(charge)
    down = charge[..., 1:, :] - charge[..., :-1, :]
    right = charge[..., :, 1:] - charge[..., :, :-1]
    flow[..., :-1, :] += down
    flow[..., 1:, :] -= down
    flow[..., :, :-1] += right
    flow[..., :, 1:] -= right
    return np.asarray(charge + fraction * flow)
