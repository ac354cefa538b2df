"""The fixed offset of each pixel's comparator."""

from __future__ import annotations

import numpy as np

from nscc_runtime.effects.effect import CannotHave, Effect, InLoop
from nscc_runtime.effects.full_well import FULL
from nscc_runtime.effects.parameters import parameter
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.effects.views import Pixels, Places, Values, Word
from nscc_runtime.noise import key, normals

SPREAD = parameter(
    "comparator_offset_fraction", "comparator", 0.01, "1", 0, 1,
    "standard deviation over the pixels of a comparator's offset, in full wells",
)  # fmt: skip
ONLY_LOOKS = "programs whose pixels look at the light have no sums over slots"
NO_LOOK = "no word of this program compares the light"


def offset_e(sensor: Sensor, device_seed: int, pixels: Places) -> Values:
    """Return the offset of each pixel."""
    z = normals(key(device_seed, COMPARATOR_OFFSET.stream), pixels)
    return np.asarray(SPREAD(sensor) * FULL(sensor) * z)


def _seen(pixels: Pixels, total: Values, word: Word) -> Values:
    return total + pixels.fixed(offset_e)


COMPARATOR_OFFSET = Effect(
    name="comparator_offset",
    stream=17,
    kind="fixed",
    title="offset of the comparators",
    model="`where` compares the sum of its sources and an offset o F z with 0: F the full well, z "
    "a standard normal number of the device for each pixel.",
    cost="one normal number a pixel and a sum a comparison",
    applied="to every `where`",
    absent=NO_LOOK,
    parameters=(SPREAD, FULL),
    reference={"compare": _seen},
    size="the part of the pixels that it takes to other states; nothing where no pixel looks",
    sums=CannotHave(ONLY_LOOKS),
    words=InLoop(
        "compares_off",
        {"compare_offset": lambda sensor: SPREAD(sensor) * FULL(sensor)},
        "offset",
    ),
    cost_ns=10.0,
)
