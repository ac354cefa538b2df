"""Read noise of PIX."""

from __future__ import annotations

from nscc_runtime.effects.effect import MOST_E, Effect, InLoop, parameter
from nscc_runtime.effects.parts import Errors

SIGMA = parameter("read_noise_e", "noise", 10.0, "e", 0, MOST_E, "of one read of PIX")


READ = Effect(
    name="read",
    stream=4,
    kind="random",
    title="read noise of PIX",
    model="Every word that reads PIX finds it off by sigma z. Reads are independent normal "
    "numbers.",
    cost="one normal number a pixel and bucket for all words; one a read near saturation",
    applied="to PIX as a source of an analog word",
    absent="this sensor has none",
    parameters=(SIGMA,),
    reference={
        "reads": lambda pixels, level, word: (
            level + SIGMA(pixels.sensor) * pixels.error("read", word)
        )
    },
    size="rms = sigma sqrt(reads), reads weighted with their squared coefficients: a reset "
    "level that is subtracted k times counts k^2",
    sums=(Errors("reads", SIGMA),),
    words=InLoop("read_errors", {"read_error": SIGMA}),
)
