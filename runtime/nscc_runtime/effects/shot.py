"""Photon shot noise."""

from __future__ import annotations

from nscc.arrays import Floats
from nscc_runtime.effects.effect import Effect
from nscc_runtime.effects.parts import CountedLight
from nscc_runtime.effects.views import LIGHT, Slots


def _count(slots: Slots, light: Floats) -> Floats:
    """Return the numbers of photons drawn for `light`, the expected electrons (N, rows, cols) of
    each slot."""
    return slots.counted(SHOT.stream, LIGHT, light)


SHOT = Effect(
    name="shot",
    stream=1,
    kind="random",
    title="photon shot noise",
    model="The light of a slot is counted in whole electrons: count ~ Poisson(rate), rate the "
    "slot's electrons. Slots between two words of a pixel are one count, Poisson(sum of rates).",
    cost="one Poisson number a pixel and bucket; one between two words for pixels near saturation",
    applied="when the charge of the slots is drawn, before it falls on PIX",
    reference={"count": _count},
    size="rms = sqrt(mean sum of w^2 E), w the weights of the slots' light E, neighbours' included",
    sums=(CountedLight(),),
    cost_ns=10.0,
    light_ns=0.5,
)
