"""Lag of the previous frame."""

from __future__ import annotations

from nscc_runtime.effects.effect import Effect, parameter
from nscc_runtime.effects.parts import Echo

FRACTION = parameter(
    "lag_fraction",
    "light",
    0.002,
    "1",
    0,
    1,
    "part of the previous frame's light that comes again in the same slot",
    place=1,
)


LAG = Effect(
    name="lag",
    stream=12,
    kind="fixed",
    title="lag of the previous frame",
    model="A part l of the light of each slot of the previous frame comes again in the same slot. "
    "The previous frame is the same scene unless another is given.",
    cost="none for the same scene; else one more sum over the slots",
    applied="to the light of every slot",
    parameters=(FRACTION,),
    reference={
        "light": lambda slots, light: (
            light + FRACTION(slots.sensor) * slots.electrons(slots.scene.previous)
        )
    },
    size="rms and mean of l times the light of the frame before, the same scene",
    sums=(Echo(FRACTION),),
)
