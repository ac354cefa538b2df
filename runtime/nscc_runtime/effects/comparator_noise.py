"""The noise of a comparison."""

from __future__ import annotations

from nscc_runtime.effects.comparator_offset import NO_LOOK, ONLY_LOOKS
from nscc_runtime.effects.effect import CannotHave, Effect, InLoop
from nscc_runtime.effects.full_well import FULL
from nscc_runtime.effects.parameters import parameter
from nscc_runtime.effects.views import Pixels, Values, Word

SIGMA = parameter(
    "comparator_noise_fraction", "comparator", 0.02, "1", 0, 1,
    "standard deviation of one comparison, in full wells", place=1,
)  # fmt: skip


def _seen(pixels: Pixels, total: Values, word: Word) -> Values:
    size_e = SIGMA(pixels.sensor) * FULL(pixels.sensor)
    return total + size_e * pixels.error("comparator_noise", word)


COMPARATOR_NOISE = Effect(
    name="comparator_noise",
    stream=18,
    kind="random",
    title="noise of the comparators",
    model="Each `where` compares the sum of its sources and s F z with 0: F the full well, z a "
    "standard normal number of its own for each pixel and word.",
    cost="one normal number a comparison that a pixel depends on",
    applied="to every `where`",
    absent=NO_LOOK,
    parameters=(SIGMA, FULL),
    reference={"compare": _seen},
    size="the part of the pixels that it takes to other states; nothing where no pixel looks",
    sums=CannotHave(ONLY_LOOKS),
    words=InLoop(
        "compares_noisy",
        {"compare_noise": lambda sensor: SIGMA(sensor) * FULL(sensor)},
        draws_key="compares",
    ),
    cost_ns=20.0,
)
