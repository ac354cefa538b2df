"""Decay of digital registers."""

from __future__ import annotations

from nscc_runtime.effects.effect import PUBLISHED, Effect, parameter
from nscc_runtime.effects.parts import Fading

RETENTION = parameter(
    "digital_retention_us",
    "memory",
    None,
    "us",
    0,
    1e15,
    "a digital register reads 0 when it was not written for longer",
    f"{PUBLISHED}the chip's library; the target table",
    low_excluded=True,
)


DECAY = Effect(
    name="decay",
    stream=13,
    kind="fixed",
    title="decay of digital registers",
    model="A digital register that no word has written for longer than its retention time reads "
    "0. Code registers are loaded just before the frame.",
    cost="none; a property of the schedule",
    applied="when the digital words are replayed",
    absent="every register is written again in time",
    parameters=(RETENTION,),
    reference={"digital": RETENTION},
    size="rms and mean of the difference that wrong bits make, found by running the words with "
    "them and without",
    sums=(Fading(),),
)
