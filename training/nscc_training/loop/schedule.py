"""The schedule of a run: restarts of the codes, settling, and cycles of learning rates.

A run learns codes and decoder together, from each start of the codes in turn. Then the codes
settle: they are frozen, and only the decoder learns. Each of these parts has its own cycle of
learning rates."""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Iterable

from torch.optim import Optimizer

from nscc_training.loop.setup import TrainingSetup
from nscc_training.settings import RunSettings

_WARM_UP, _SHARE = 20, 50
"""Most steps in which the rates rise; they are at most one in `_SHARE` of a cycle's steps."""


def settling_step(settings: RunSettings) -> int:
    """Return the step from which the codes stay as they are and only the decoder learns; the number
    of steps if the run has no such phase."""
    # Rounded first: an error of floating point must not add a step.
    return math.ceil(round((1 - settings.settle_share) * settings.train.steps, 6))


def _starts(settings: RunSettings) -> int:
    """Return in how many cycles the codes learn: one, and one more for each restart. It is 1 if
    codes are not learned."""
    return 1 + settings.shutter.restarts if settings.shutter.learn else 1


def cycle_of(settings: RunSettings, step: int) -> tuple[int, int]:
    """Return the first step of the cycle that contains `step`, and the first step after that cycle.

    A cycle is the time between two restarts of the codes, or the time in which they are settled. A
    step beyond the last belongs to the last cycle."""
    settled, starts = settling_step(settings), _starts(settings)
    bounds = [settled * number // starts for number in range(starts + 1)]
    if settled < settings.train.steps:
        bounds.append(settings.train.steps)
    # Limited, so that steps before the first and beyond the last have a cycle, too.
    after = min(max(1, bisect_right(bounds, step)), len(bounds) - 1)
    return bounds[after - 1], bounds[after]


def codes_learn(settings: RunSettings, step: int) -> bool:
    """Return whether the codes change in this step (0 is the first); never if `settings` do not let
    them learn. They stay as they are in the fraction `warm_up` of a cycle after each start, so that
    the decoder adapts first, and from `settling_step` on."""
    first, last = cycle_of(settings, step)
    waiting = settings.shutter.warm_up * settings.train.steps / _starts(settings)
    learning = settings.shutter.learn and last <= settling_step(settings)
    return learning and first + waiting <= step < last


def anneal(setup: TrainingSetup, step: int) -> None:
    """Set temperature (softness of relaxed codes) and noise of the encoder of `setup` for a step.
    While the codes settle, both have their last values. Within a cycle, the temperature falls
    geometrically from its first to its last value, and the noise linearly to 0."""
    settings = setup.settings
    first, last = cycle_of(settings, step)
    settled = step >= settling_step(settings)
    progress_share = 1.0 if settled else (step - first) / max(1, last - first - 1)
    warm, cold = settings.shutter.temperature
    setup.encoder.temperature = warm * (cold / warm) ** progress_share
    setup.encoder.noise = settings.shutter.noise * (1 - progress_share)


def set_rates(optimizers: Iterable[Optimizer], settings: RunSettings, step: int) -> None:
    """Set the learning rates of the optimizers for a step, in place, from the rate `base` of each
    parameter group.

    They rise from 0 in the first steps of a cycle, at most `_WARM_UP`, and with the schedule
    `cosine` fall to 0 at its end. They rise because Adam's first steps have the size of the rate
    whatever the gradient: all weights of a wide network together would drive its output out of
    range."""
    first, last = cycle_of(settings, step)
    factor = min(1.0, (step - first + 1) / (1 + min(_WARM_UP, (last - first) // _SHARE)))
    if settings.train.schedule == "cosine":
        factor *= 0.5 * (1 + math.cos(math.pi * (step - first) / (last - first)))
    for optimizer in optimizers:
        for group in optimizer.param_groups:
            group["lr"] = group["base"] * factor
