"""Dead time: words take time while light is collected."""

from __future__ import annotations

from nscc_runtime.effects.effect import Effect, InLoop
from nscc_runtime.effects.parts import SlowWords

DEAD_TIME = Effect(
    name="dead_time",
    stream=11,
    kind="fixed",
    title="gates that switch while light falls",
    model="Words take their time (launch and clock of the target) at the start of the slot, and "
    "the slot's charge goes on falling at an even rate: a read finds it up to the word's end, a "
    "reset loses it. After the last slot the light goes on as in that slot.",
    cost="a factor for each code; a slot loop in the reference",
    applied="between the words of a boundary",
    reference={"time": lambda word: word.after_us},
    size="rms and mean of what falls meanwhile, and of its counts: read and reset every slot: "
    "lost fraction x rms L; edges: each moves by its words' time; without that in the "
    "level of a reset",
    sums=(SlowWords(),),
    words=InLoop("slow_words"),
    cost_ns=1.5,
)
