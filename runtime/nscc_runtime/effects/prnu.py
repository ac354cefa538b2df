"""The pixels' unequal response to light."""

from __future__ import annotations

import numpy as np

from nscc.arrays import Floats
from nscc_runtime.effects.effect import Effect, parameter
from nscc_runtime.effects.parts import Response
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.effects.views import Places
from nscc_runtime.noise import key, normals

SPREAD = parameter(
    "prnu_fraction",
    "light",
    0.01,
    "1",
    0,
    0.2,
    "standard deviation of the pixels' response to light",
)


def response(sensor: Sensor, device_seed: int, pixels: Places) -> Floats:
    """Return the response factor of each pixel, (pixels,), with mean 1, at least 0. `pixels`:
    places on the chip with the seed `device_seed`."""
    z = normals(key(device_seed, PRNU.stream), pixels)
    return np.asarray(np.maximum(1.0 + SPREAD(sensor) * z, 0.0))


PRNU = Effect(
    name="prnu",
    stream=2,
    kind="fixed",
    title="photo-response non-uniformity",
    model="Each pixel turns light into electrons with a factor of its own: max(0, 1 + p z), z a "
    "standard normal number of the device.",
    cost="one product a pixel",
    applied="to the light of every slot, before it is counted",
    parameters=(SPREAD,),
    reference={"response": lambda slots, light: light * slots.fixed(response)},
    size="rms and mean of the light that the pixels' own factors add or take, about p rms(L)",
    sums=(Response(response),),
    cost_ns=5.0,
)
