"""Effects of time: motion within a slot, gates that switch under light, lag, fading registers."""

from __future__ import annotations

from nscc_runtime.effects.effect import Contribution, Effect

MOTION = Effect(
    name="motion",
    stream=10,
    kind="fixed",
    title="motion inside a slot",
    model="Between the samples of a scene its light changes linearly; a slot collects the "
    "integral. Without the effect a sample stands for its whole time. Scenes whose frames are "
    "integrals have none.",
    contribution="rms and mean of sum S (integral - sample), about 1/2 rms of sum S dE",
    parameters=(),
    cost="one more sum over the slots",
    applied="to the light of every slot",
    predict=lambda scene, sensor: Contribution(scene.rms_motion_e, scene.mean_motion_e),
)

DEAD_TIME = Effect(
    name="dead_time",
    stream=11,
    kind="fixed",
    title="gates that switch while light falls",
    model="Words take their time (launch and clock of the target) at the start of the slot, and "
    "the slot's charge goes on falling at an even rate: a read finds it up to the word's end, a "
    "reset loses it. After the last slot the light goes on as in that slot.",
    contribution="read and reset every slot: lost fraction x rms L; edges: each moves by its "
    "words' time",
    parameters=(),
    cost="a factor for each code; a slot loop in the reference",
    applied="between the words of a boundary",
    predict=lambda scene, sensor: Contribution(scene.rms_dead_e, scene.mean_dead_e),
)

LAG = Effect(
    name="lag",
    stream=12,
    kind="fixed",
    title="lag of the previous frame",
    model="A part l of the light of each slot of the previous frame comes again in the same slot. "
    "The previous frame is the same scene unless another is given.",
    contribution="rms = l rms(previous), bias = l mean(previous)",
    parameters=("lag_fraction",),
    cost="none for the same scene; else one more sum over the slots",
    applied="to the light of every slot",
    predict=lambda scene, sensor: Contribution(
        sensor.lag_fraction * scene.rms_previous_e, sensor.lag_fraction * scene.mean_previous_e
    ),
)

DECAY = Effect(
    name="decay",
    stream=13,
    kind="fixed",
    title="decay of digital registers",
    model="A digital register that no word has written for longer than its retention time reads "
    "0. Code registers are loaded just before the frame.",
    contribution="rms and mean of the difference that wrong bits make; from the schedule",
    parameters=("digital_retention_us",),
    cost="none; a property of the schedule",
    applied="when the digital words are replayed",
    predict=lambda scene, sensor: Contribution(scene.rms_decay_e, scene.mean_decay_e),
)
