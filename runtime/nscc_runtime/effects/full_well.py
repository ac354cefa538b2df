"""Saturation of PIX."""

from __future__ import annotations

import numpy as np

from nscc_runtime.effects.effect import MOST_E, TARGET, Effect, InLoop, Mark, parameter
from nscc_runtime.effects.parts import Well

FULL = parameter(
    "full_well_e",
    "range",
    None,
    "e",
    0,
    MOST_E,
    "charge that PIX holds above its reset level",
    TARGET,
    low_excluded=True,
)


FULL_WELL = Effect(
    name="full_well",
    stream=6,
    kind="fixed",
    title="saturation of PIX",
    model="PIX holds min(charge since the last reset, full well), whether the shutter is open or "
    "not, dark charge included.",
    cost="none where the whole frame's charge stays below the well; else a loop over the words of "
    "pixels near it",
    applied="to PIX whenever charge falls on it",
    absent="no pixel comes near it",
    parameters=(FULL,),
    reference={
        # NaN stays NaN.
        "well": lambda pixels, charge: np.minimum(charge, FULL(pixels.sensor))
    },
    size="rms and mean of the charge that is lost, of pixels that come near the well",
    sums=(Well(FULL),),
    words=InLoop("well_clips", {"well": FULL}),
    marks={"well": Mark(bit=1, name="well"), "subtracted": Mark(bit=8, name="reset level")},
)
