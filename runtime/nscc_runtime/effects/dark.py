"""Dark current, its spread and its shot noise."""

from __future__ import annotations

from nscc.arrays import Floats
from nscc_runtime.effects.effect import MOST_E, Effect, parameter
from nscc_runtime.effects.parts import CountedDark
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.effects.spread import log_normal
from nscc_runtime.effects.views import WITHOUT_LIGHT, Places, Slots
from nscc_runtime.noise import key, normals

CURRENT = parameter(
    "dark_current_e_per_s", "dark", 1000.0, "e/s", 0, MOST_E, "dark current, mean over the pixels"
)
SPREAD = parameter(
    "dark_spread_fraction",
    "dark",
    0.2,
    "1",
    0,
    10,
    "its standard deviation over the pixels, relative to the mean",
)


def current_e_per_s(sensor: Sensor, device_seed: int, pixels: Places) -> Floats:
    """Return the dark current of each pixel in electrons per second, (pixels,). `pixels`: places on
    the chip with the seed `device_seed`."""
    z = normals(key(device_seed, DARK.stream), pixels)
    return CURRENT(sensor) * log_normal(SPREAD(sensor), z)


def _fall(slots: Slots, charge: Floats) -> Floats:
    """Return `charge`, electrons (N, rows, cols) that fall in each slot, plus the counted electrons
    of the dark current."""
    rates = slots.scene.slot_s[:, None, None] * slots.fixed(current_e_per_s)
    return charge + slots.counted(DARK.stream, WITHOUT_LIGHT, rates)


DARK = Effect(
    name="dark",
    stream=3,
    kind="both",
    title="dark current, its spread and its shot noise",
    model="Charge falls on PIX without light, D electrons a second in the mean. Each pixel has "
    "D exp(s z - s^2/2), s^2 = ln(1 + d^2), z a standard normal number of the device: "
    "lognormal with mean D and standard deviation d D. It is counted as light is, in counts "
    "of its own.",
    cost="as for `shot`; none beside it for pixels that do not saturate",
    applied="with the light of every slot, open or not",
    absent="this sensor has none",
    parameters=(CURRENT, SPREAD),
    reference={"charge": _fall},
    size="bias = mean of D t, t the open time by weight, D of each pixel and what its "
    "neighbours spill; rms = sqrt(mean (D t)^2 + counts of variance D t)",
    sums=(CountedDark(current_e_per_s),),
    cost_ns=15.0,
)
