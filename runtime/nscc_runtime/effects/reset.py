"""Reset (kTC) noise of PIX."""

from __future__ import annotations

from nscc_runtime.effects.effect import MOST_E, Effect, InLoop, parameter
from nscc_runtime.effects.parts import Errors

SIGMA = parameter(
    "reset_noise_e",
    "noise",
    40.0,
    "e",
    0,
    MOST_E,
    "of one reset of PIX; sqrt(kTC) of 10 fF at 300 K",
    place=1,
)


RESET = Effect(
    name="reset",
    stream=5,
    kind="random",
    title="reset (kTC) noise of PIX",
    model="Every reset leaves PIX off by sigma z until the next one. What is read twice without "
    "a reset in between and subtracted is free of it.",
    cost="one normal number a pixel and bucket for all words; one a reset near saturation",
    applied="to PIX by every rpix",
    absent="this sensor has none",
    parameters=(SIGMA,),
    reference={
        "resets": lambda pixels, level, word: (
            level + SIGMA(pixels.sensor) * pixels.error("reset", word)
        )
    },
    size="rms = sigma sqrt(resets), resets weighted with their squared coefficients",
    sums=(Errors("resets", SIGMA),),
    words=InLoop("reset_errors", {"reset_error": SIGMA}),
)
