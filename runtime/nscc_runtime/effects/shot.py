"""Photon shot noise."""

from __future__ import annotations

from nscc_runtime.effects.effect import Effect, InLoop
from nscc_runtime.effects.parts import CountedLight
from nscc_runtime.effects.views import LIGHT, Slots, Values


def _count(slots: Slots, light: Values) -> Values:
    return slots.counted(SHOT.stream, LIGHT, light)


SHOT = Effect(
    name="shot",
    stream=1,
    kind="random",
    title="photon shot noise",
    model="The light of a slot is counted in whole electrons: count ~ Poisson(rate), rate the "
    "slot's electrons. One count a pixel, source and group of slots (those open in the same "
    "buckets), Poisson(sum of rates), is spread over the group's slots by binomial thinning.",
    cost="one Poisson number a pixel and group of slots; the reference adds one binomial a slot",
    applied="when the charge of the slots is drawn, before it falls on PIX",
    reference={"count": _count},
    size="rms = sqrt(mean sum of w^2 E), w the weights of the slots' light E, neighbours' included",
    sums=(CountedLight(),),
    words=InLoop(),
    cost_ns=10.0,
    light_ns=0.5,
)
