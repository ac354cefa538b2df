"""Soft saturation of analog registers."""

from __future__ import annotations

import math

import numpy as np

from nscc.arrays import Floats
from nscc_runtime.effects.effect import MOST_E, TARGET, Effect, InLoop, Mark, parameter
from nscc_runtime.effects.parts import Soft
from nscc_runtime.effects.sensor import Sensor

_KNEE = 0.9
"""Default of the part of a register's range in which it is linear; so the target's own limits,
which are divided by it, are the ends of the linear part."""
_BEYOND = f"{TARGET}, over {_KNEE}: codes of a chip are clipped by its converter, not registers"
LOWEST = parameter(
    "register_min_e",
    "range",
    lambda target, _values: target.register_min_e / _KNEE,
    "e",
    -MOST_E,
    0,
    "least value of an analog register",
    _BEYOND,
    high_excluded=True,
)
HIGHEST = parameter(
    "register_max_e",
    "range",
    lambda target, _values: target.register_max_e / _KNEE,
    "e",
    0,
    MOST_E,
    "largest value of an analog register",
    _BEYOND,
    low_excluded=True,
)
KNEE = parameter(
    "register_knee_fraction",
    "range",
    _KNEE,
    "1",
    0,
    1,
    "a register is linear up to this part of its range and soft beyond; 1: clips hard",
)


def soft(value: Floats, sensor: Sensor) -> Floats:
    """Return the content of registers after `value` (any shape, electrons) is written: exactly
    `value` up to the knee, beyond it less, and never more than the range. NaN stays NaN. The result
    may be `value` itself."""
    knee = KNEE(sensor)
    limit = np.where(value < 0, -LOWEST(sensor), HIGHEST(sensor))
    size = np.abs(value)
    if not np.any(size > knee * limit):
        return value
    if knee == 1.0:
        return np.asarray(np.where(size > limit, np.copysign(limit, value), value))
    room = (1.0 - knee) * limit
    bent = knee * limit + room * np.tanh(np.maximum(size - knee * limit, 0.0) / room)
    return np.asarray(np.where(size > knee * limit, np.copysign(bent, value), value))


def _high(sensor: Sensor) -> float:
    """Return the smaller of the absolute limits of a register in electrons: sums do not know the
    sign of a register's value."""
    return min(abs(LOWEST(sensor)), HIGHEST(sensor))


def _linear(sensor: Sensor) -> float:
    """Return the value (e) up to which a register is linear."""
    return KNEE(sensor) * _high(sensor)


def _compute_loss_e(sensor: Sensor, size: Floats) -> Floats:
    """Return how many electrons a register loses of values of the absolute `size` (any shape, e),
    whatever their sign; 0 in the linear range."""
    over = np.maximum(size - _linear(sensor), 0.0)
    # With a knee of 1 there is no room: everything beyond is lost, without a division by 0.
    room = max(_high(sensor) - _linear(sensor), 1e-9)
    return np.asarray(over - room * np.tanh(over / room))


def _half_slope_loss_e(sensor: Sensor) -> float:
    """Return the loss in electrons at which a register stores half of a further increment: where
    the slope of tanh is 1/2. It is 0 for registers that clip hard."""
    half = math.acosh(math.sqrt(2.0))
    return (half - math.tanh(half)) * (_high(sensor) - _linear(sensor))


REGISTER = Effect(
    name="register",
    stream=8,
    kind="fixed",
    title="soft saturation of analog registers",
    model="A register is linear up to k M and holds M (k + (1 - k) tanh((v / M - k) / (1 - k))) "
    "beyond, M its largest value; the same below 0.",
    cost="none where no partial sum passes the knee; else a loop over the words of pixels near it",
    applied="to every result of a bus word",
    absent="no pixel comes near it",
    parameters=(LOWEST, HIGHEST, KNEE),
    reference={"registers": lambda pixels, value: soft(value, pixels.sensor)},
    size="rms and mean of what is lost by the largest partial sums, of pixels that come near "
    "the knee; of those that noise alone takes there, what a frame loses to it",
    sums=(Soft(_linear, _compute_loss_e),),
    words=InLoop("registers_bend", {"lowest": LOWEST, "highest": HIGHEST, "knee": KNEE}),
    marks={"registers": Mark(bit=2, name="register", least_e=_half_slope_loss_e)},
)
