"""What an effect is, and what a prediction of its contribution is made from."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import sqrt
from typing import Literal

from nscc_runtime.sensor.sensor import Sensor

Kind = Literal["fixed", "random", "both", "after"]


@dataclass(frozen=True)
class Statistics:
    """A frame in a bucket, as far as predictions need it: means over the pixels.

    L is the exposure in electrons. `rms_*_e` are root mean squares of what one effect alone
    does to the exposure, signed and summed over the slots. `reads`, `resets` and `words` count how
    often the noise of a PIX read, of a reset and of an analog word reaches the exposure, each
    weighted with its squared coefficient; `word_sum` and `word_sum_rms` are mean and rms of the
    signed sum of the words' coefficients, which offsets common to all words add up with.
    """

    mean_e: float = 0.0
    rms_e: float = 0.0
    open_s: float = 0.0
    rms_open_s: float = 0.0
    reads: float = 0.0
    resets: float = 0.0
    words: float = 0.0
    word_sum: float = 0.0
    word_sum_rms: float = 0.0
    mean_gain_loss_e: float = 0.0
    rms_gain_loss_e: float = 0.0
    mean_leaked_e: float = 0.0
    rms_leaked_e: float = 0.0
    mean_well_loss_e: float = 0.0
    rms_well_loss_e: float = 0.0
    mean_register_loss_e: float = 0.0
    rms_register_loss_e: float = 0.0
    mean_motion_e: float = 0.0
    rms_motion_e: float = 0.0
    mean_dead_e: float = 0.0
    rms_dead_e: float = 0.0
    mean_decay_e: float = 0.0
    rms_decay_e: float = 0.0
    rms_laplacian_e: float = 0.0
    mean_previous_e: float = 0.0
    rms_previous_e: float = 0.0


@dataclass(frozen=True)
class Contribution:
    """What an effect does to an exposure: root mean square of the whole change, and its mean."""

    rms_e: float
    bias_e: float = 0.0


@dataclass(frozen=True)
class Effect:
    """One effect of the sensor.

    `stream` is its number in the keys of random numbers and never changes. `kind`: the same in
    every frame; new in every frame; both; after the exposure, in the readout only. `model` is
    the effect in words with its formula, `contribution` the formula of `predict`, `parameters` the
    sensor's parameters it depends on, `cost` what simulating it takes, `applied` where the
    reference does. `always` effects cannot be left out.
    """

    name: str
    stream: int
    kind: Kind
    title: str
    model: str
    contribution: str
    parameters: tuple[str, ...]
    cost: str
    applied: str
    predict: Callable[[Statistics, Sensor], Contribution]
    always: bool = False


def quadrature(*parts: float) -> float:
    """Root of the sum of squares."""
    return sqrt(sum(part * part for part in parts))
