"""Motion inside a slot."""

from __future__ import annotations

from dataclasses import replace

from nscc_runtime.effects.effect import Effect
from nscc_runtime.effects.parts import Moving
from nscc_runtime.effects.views import Scene


def _moving(scene: Scene) -> Scene:
    """Return the scene with the light that moves during a slot, if it has such light."""
    light, previous = (still.motion or still for still in (scene.light, scene.previous))
    return replace(scene, light=light, previous=previous)


MOTION = Effect(
    name="motion",
    stream=10,
    kind="fixed",
    title="motion inside a slot",
    model="Between the samples of a scene its light changes linearly; a slot collects the "
    "integral. Without the effect a sample stands for its whole time. Scenes whose frames are "
    "integrals have none.",
    cost="one more sum over the slots",
    applied="to the light of every slot",
    absent="the scene's frames are the slots' integrals",
    reference={"scene": _moving},
    size="rms and mean of sum S (integral - sample), about 1/2 rms of sum S dE",
    sums=(Moving(),),
    cost_ns=0.5,
)
