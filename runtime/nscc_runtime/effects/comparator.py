"""The comparators of the pixels: the fixed offset of each, and the noise of a comparison."""

from __future__ import annotations

import numpy as np

from nscc.arrays import Floats
from nscc.mappings import NamedValues
from nscc_runtime.effects.effect import CannotHave, Effect, InLoop, parameter
from nscc_runtime.effects.full_well import FULL
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.effects.views import Places
from nscc_runtime.noise import key, normals

SPREAD = parameter(
    "comparator_offset_fraction",
    "comparator",
    0.01,
    "1",
    0,
    1,
    "standard deviation over the pixels of a comparator's offset, in full wells",
)
SIGMA = parameter(
    "comparator_noise_fraction",
    "comparator",
    0.02,
    "1",
    0,
    1,
    "standard deviation of one comparison, in full wells",
    place=1,
)
_OF_BOTH: NamedValues = {
    "applied": "to every `where`",
    "absent": "no word of this program compares the light",
    "size": "the part of the pixels that it takes to other states; nothing where no pixel looks",
    "sums": CannotHave("programs whose pixels look at the light have no sums over slots"),
}


def offset_e(sensor: Sensor, device_seed: int, pixels: Places) -> Floats:
    """Return the offset of each pixel's comparator in electrons, (pixels,). `pixels`: places on the
    chip with the seed `device_seed`."""
    z = normals(key(device_seed, COMPARATOR_OFFSET.stream), pixels)
    return np.asarray(SPREAD(sensor) * FULL(sensor) * z)


COMPARATOR_OFFSET = Effect(
    name="comparator_offset",
    stream=17,
    kind="fixed",
    title="offset of the comparators",
    model="`where` compares the sum of its sources and an offset o F z with 0: F the full well, z "
    "a standard normal number of the device for each pixel.",
    cost="one normal number a pixel and a sum a comparison",
    parameters=(SPREAD, FULL),
    reference={"compare": lambda pixels, total, _word: total + pixels.fixed(offset_e)},
    words=InLoop("compares_off", patterns={"offset_e": offset_e}),
    cost_ns=10.0,
    **_OF_BOTH,
)

COMPARATOR_NOISE = Effect(
    name="comparator_noise",
    stream=18,
    kind="random",
    title="noise of the comparators",
    model="Each `where` compares the sum of its sources and s F z with 0: F the full well, z a "
    "standard normal number of its own for each pixel and word.",
    cost="one normal number a comparison that a pixel depends on",
    parameters=(SIGMA, FULL),
    reference={
        "compare": lambda pixels, total, word: (
            total
            + SIGMA(pixels.sensor) * FULL(pixels.sensor) * pixels.error("comparator_noise", word)
        )
    },
    words=InLoop(
        "compares_noisy",
        {"compare_noise": lambda sensor: SIGMA(sensor) * FULL(sensor)},
        draws="compares",
    ),
    cost_ns=20.0,
    **_OF_BOTH,
)
