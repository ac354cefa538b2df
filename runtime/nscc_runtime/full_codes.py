"""Find the codes of the converter that mean saturation, for real chips, of which only codes are
known.

A full well passes through a program's words, their gain and the registers' knee, and its code is
below the converter's last code. To find this code, the words are run over steady light of
increasing brightness, with the sensor's mean values, until a frame would mark saturation
(`nscc_runtime.effects.effect`). Noise may make a full pixel some standard deviations lower.

Light that changes within the frame may fill PIX before a late shutter opens, and bright light may
fill PIX before its reset level is read. Such a pixel has a lower code, which does not reveal the
saturation."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from nscc.words.container import Container
from nscc_runtime.effects import everything
from nscc_runtime.effects.parts import Leak, SlowWords, Soft, Well, WordGain
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.execution.program import AnalysedProgram, analysed
from nscc_runtime.reference.trace import AnalogWord
from nscc_runtime.reference.weights import error_sign
from nscc_runtime.reference.words import Marks
from nscc_runtime.response import converter_e2, shutter_response

Values = NDArray[np.float64]

_LEVELS = np.geomspace(0.5, 16.0, 241)
"""Levels of steady light, in full wells over the time in which PIX collects light."""
_ALIKE = 7
"""Saturating elements at most this number of levels (10 % of light) apart are not distinguished."""
_SIGMAS = 4.0
_MOST_LANES = 256
"""Number of shutters that are simulated together."""


def marked_by_codes(
    frame: NDArray[np.uint8], container: Container, sensor: Sensor
) -> NDArray[np.uint8]:
    """Return the bits of `saturated_by` that the codes of a chip's frame indicate, except the last
    code.

    `frame`: codes (.., buckets, rows, cols). Raises Rejected (NS0442) for words that open no
    shutters."""
    marked = np.zeros(frame.shape, np.uint8)
    for bit, codes in full_codes(container, sensor).items():
        marked |= np.where(frame >= codes, np.uint8(bit), np.uint8(0))
    return marked


@lru_cache(maxsize=2)
def full_codes(container: Container, sensor: Sensor) -> Mapping[int, Values]:
    """Return the smallest codes (buckets, rows, cols) that may mean saturation, by bit of
    `saturated_by`.

    A code is infinite if no code indicates saturation. Raises Rejected like `marked_by_codes`."""
    program = analysed(container, sensor)
    used, places = np.unique(program.lanes, return_inverse=True)
    lane_batches = np.array_split(used, -(-len(used) // _MOST_LANES))
    codes_by_batch = [_codes_of(program, lanes) for lanes in lane_batches]
    shape = program.reference.groups.lane.shape
    return {
        bit: np.concatenate([lane_codes[bit] for lane_codes in codes_by_batch], axis=1)[
            :, places
        ].reshape(-1, *shape)
        for bit in codes_by_batch[0]
    }


def _codes_of(program: AnalysedProgram, lanes: NDArray[np.integer]) -> dict[int, Values]:
    """Return the smallest codes (buckets, lanes) that may mean saturation, by bit."""
    exposure, marked = _steady(program, lanes)
    response = shutter_response(program.container, program.sensor, everything())
    noise_e2 = response.variance_e2 + converter_e2(program.sensor, everything())
    noise_e = _SIGMAS * np.sqrt(noise_e2)[lanes].T
    sensor, effects = program.sensor, everything()
    begin = (marked != 0).argmax(axis=1)
    codes_by_bit = {}
    for at in ("well", "registers"):
        mark = effects.marking(at)
        if mark is None:
            continue
        full = (marked & mark.bit) != 0
        first = np.where(full.any(axis=1), full.argmax(axis=1), len(_LEVELS))
        # In brighter light late shutters collect less again: PIX is full before they open.
        level = np.minimum(first, len(_LEVELS) - 1)[:, None]
        least = np.take_along_axis(exposure, level, axis=1)[:, 0] - noise_e
        least = np.where(first < begin + _ALIKE, least, np.inf)
        codes_by_bit[mark.bit] = np.floor(least / sensor.electrons_per_lsb + sensor.adc_offset_lsb)
    return codes_by_bit


def _steady(
    program: AnalysedProgram, lanes: NDArray[np.integer]
) -> tuple[Values, NDArray[np.uint8]]:
    """Return mean exposures (buckets, levels, lanes) of steady light, and saturation marks."""
    container, sensor, effects = program.container, program.sensor, everything()
    seen_s = program.slot_s @ program.tables.seen_slots()[:, lanes]
    never = seen_s <= 0
    scale = effects.require_part(Well).full_e(sensor) / np.where(never, 1.0, seen_s)
    rate = (_LEVELS[:, None] * np.where(never, 0.0, scale)).reshape(-1)
    pixels = _SteadyPixels(program, rate, np.tile(lanes, len(_LEVELS)))
    for word in program.tables.decayed:
        pixels.run(word)
    shape = len(container.buckets), len(_LEVELS), len(lanes)
    exposure, marked = np.empty((shape[0], rate.size)), np.empty((shape[0], rate.size), np.uint8)
    tau_s = effects.require_part(Leak).tau_s(sensor)
    for order, readout in enumerate(container.readouts):
        bucket = container.buckets.index(readout.bucket)
        waited_s = order * container.target.readout_us * 1e-6
        factor = readout.gain * np.exp(-(pixels.since_s() + waited_s) / tau_s)
        exposure[bucket] = pixels.register[readout.register] * factor
        marked[bucket] = pixels.marks.read_out(readout.register, readout.gain)
    return exposure.reshape(shape), marked.reshape(shape)


class _SteadyPixels:
    """Pixels in steady light of `rate` electrons per second while words run."""

    def __init__(self, program: AnalysedProgram, rate: Values, lanes: NDArray[np.integer]) -> None:
        self.program, self.rate, self.lanes = program, rate, lanes
        self.sensor, self.effects = program.sensor, everything()
        self.start_s = np.concatenate(([0.0], np.cumsum(program.slot_s)))
        self.now_s = 0.0
        names = (*program.container.target.analog_registers, "IN")
        self.register = {name: np.zeros(len(rate)) for name in names}
        self.charge = np.zeros(len(rate))
        self.marks = Marks(self.effects, self.sensor, (*names, "PIX"), len(rate))

    def since_s(self) -> float:
        """Return the seconds from the last word to the end of the frame."""
        return max(0.0, float(self.start_s[-1]) - self.now_s)

    def run(self, word: AnalogWord) -> None:
        """Collect the light up to a word's end, and execute the word."""
        slow = self.effects.find_part(SlowWords) is not None
        ends_s = float(self.start_s[word.boundary]) + slow * word.after_us * 1e-6
        passed_s = max(0.0, ends_s - self.now_s)
        self.now_s += passed_s
        charge, full_e = self.charge + self.rate * passed_s, self.effects.require_part(Well).full_e
        self.charge = np.minimum(charge, full_e(self.sensor))
        self.marks.fill(self.charge < charge)
        remaining = np.exp(-passed_s / self.effects.require_part(Leak).tau_s(self.sensor))
        self.register = {name: value * remaining for name, value in self.register.items()}
        acting = word.lanes[self.lanes]
        if word.resets:
            self.charge = np.where(acting, 0.0, self.charge)
            self.marks.empty(acting)
            return
        total = sum(self.charge if n == "PIX" else self.register[n] for n in word.op.sources)
        gain, soft = self.effects.require_part(WordGain), self.effects.require_part(Soft)
        exact = -gain.gain(self.sensor) * total / word.op.operation.divisor
        nowhere = np.zeros(len(self.lanes), np.bool_)
        full, lost_e = self.marks.gathered(word.op, nowhere, nowhere)
        for name in word.op.destinations:
            sign = error_sign(name, self.program.container)
            value = exact + sign * gain.mean_e(self.sensor)
            over_e = soft.lost_e(self.sensor, np.abs(value))
            value = value - np.copysign(over_e, value)
            self.register[name] = np.where(acting, value, self.register[name])
            self.marks.write(name, acting, full, lost_e + over_e)
