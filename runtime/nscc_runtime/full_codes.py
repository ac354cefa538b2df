"""Find the converter codes that mean saturation. Of frames from real chips only these codes are
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
from contextlib import suppress
from dataclasses import replace
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from nscc.arrays import Bytes, Floats
from nscc.diagnostics.diagnostic import Rejected
from nscc.words.container import Container
from nscc_runtime.effects import Sensor, everything
from nscc_runtime.effects.parts import Leak, Well, WordGain
from nscc_runtime.effects.views import OnDevice
from nscc_runtime.execution.program import AnalysedProgram, analysed
from nscc_runtime.frame_file import Frame
from nscc_runtime.reference.words import Marked, WordPixels
from nscc_runtime.response import converter_e2, shutter_response
from nscc_runtime.run_kinds import Sent

_LEVELS = np.geomspace(0.5, 16.0, 241)
"""Levels of steady light, in full wells over the time in which PIX collects light."""
_ALIKE = 7
"""Saturating elements at most this number of levels (10 % of light) apart are not distinguished."""
_SIGMAS = 4.0
"""Number of standard deviations by which noise may lower the code of a full pixel."""
_MOST_LANES = 256
"""Number of shutters that are simulated together."""


@lru_cache(maxsize=2)
def full_codes(container: Container, sensor: Sensor) -> Mapping[int, Floats]:
    """Return the smallest converter codes (buckets, rows, cols) that may mean saturation, by bit of
    `saturated_by`.

    A code is infinite if no code indicates saturation. The last two results are cached. Raises
    Rejected (NS0442) for words that open no shutters."""
    program = analysed(container, sensor)
    used, places = np.unique(program.lanes, return_inverse=True)
    lane_batches = np.array_split(used, -(-len(used) // _MOST_LANES))
    codes_by_batch = [_codes_of(program, lanes) for lanes in lane_batches]
    shape = program.lane.shape
    return {
        bit: np.concatenate([lane_codes[bit] for lane_codes in codes_by_batch], axis=1)[
            :, places
        ].reshape(-1, *shape)
        for bit in codes_by_batch[0]
    }


def _codes_of(program: AnalysedProgram, lanes: NDArray[np.integer]) -> dict[int, Floats]:
    """Return the smallest converter codes (buckets, lanes) that may mean saturation, by bit of
    `saturated_by`; infinite where no code does. `lanes`: numbers of lanes (the pixels of one
    distinct shutter each) of `program`."""
    exposure, marked = _steady(program, lanes)
    response = shutter_response(program.container, program.sensor, everything())
    noise_e2 = response.variance_e2 + converter_e2(program.sensor, everything())
    noise_e = _SIGMAS * np.sqrt(noise_e2)[lanes].T
    sensor, effects = program.sensor, everything()
    # The number of the first light level that sets any mark.
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


def _steady(program: AnalysedProgram, lanes: NDArray[np.integer]) -> tuple[Floats, Bytes]:
    """Return the mean exposures in electrons of steady light of each of `_LEVELS`, (buckets,
    levels, lanes), and their saturation marks, of the same shape.

    `lanes`: numbers of lanes (the pixels of one distinct shutter each) of `program`. A lane whose
    PIX (the photodiode) is never read gets no light."""
    container, sensor, effects = program.container, program.sensor, everything()
    seen_s = program.slot_s @ program.seen_slots(True)[:, lanes]
    never = seen_s <= 0
    scale = effects.require_part(Well).full_e(sensor) / np.where(never, 1.0, seen_s)
    rate = (_LEVELS[:, None] * np.where(never, 0.0, scale)).reshape(-1)
    pixels = _SteadyPixels(
        sensor=sensor,
        seed=0,
        device_seed=0,
        frame=0,
        places=np.arange(rate.size),
        container=container,
        effects=effects,
    )
    exposure, marked = pixels.run(program, rate, np.tile(lanes, len(_LEVELS)))
    shape = len(container.buckets), len(_LEVELS), len(lanes)
    return exposure.reshape(shape), marked.reshape(shape)


class _SteadyPixels(WordPixels):
    """Pixels of a chip without noise and without differences: errors are 0 and fixed patterns their
    means, arrays without axes, which fit all pixels."""

    def draw(self, name: str, number: int) -> Floats:
        """Return 0 without axes instead of the noise of an effect: all pixels are alike."""
        return np.zeros(())

    def fixed(self, make: OnDevice) -> Floats:
        """Return the mean over all chips, without axes, of the fixed pattern that `make` computes.
        Raises KeyError for patterns other than errors of words and leakage, which no word needs."""
        gain, leak = self.effects.require_part(WordGain), self.effects.require_part(Leak)
        means = {gain.error_e: gain.mean_e(self.sensor), leak.per_s: 1.0 / leak.tau_s(self.sensor)}
        return np.asarray(means[make])

    def run(self, program: AnalysedProgram, rate: Floats, lanes: NDArray[np.integer]) -> Marked:
        """Return exposures in electrons and saturation marks, each (buckets, pixels), of one frame
        in steady light. `rate` (pixels,): electrons per second. `lanes` (pixels,): number of each
        pixel's lane (the pixels of one distinct shutter)."""
        start_s = np.concatenate(([0.0], np.cumsum(program.slot_s)))
        now_s = 0.0
        for word in program.decayed:
            ends_s = start_s[word.boundary] + 1e-6 * sum(ends(word) for ends in self.at("time"))
            passed_s = max(0.0, float(ends_s) - now_s)
            now_s += passed_s
            self.fall(rate * passed_s)
            self.hold(passed_s)
            (self.reset if word.resets else self.bus)(word, word.lanes[lanes])
        self.hold(max(0.0, float(start_s[-1]) - now_s))
        return self.read_out()


def marked_frame(container: Container, frame: Frame, sent: Sent) -> Frame:
    """Return the frame of a chip with saturation marks that follow from its converter codes. It
    stays as it is if the chip sent electrons, or if the words of the program open no shutters."""
    saturated_by = frame.saturated_by
    if not sent.exact:
        with suppress(Rejected):  # NS0442: words that open no shutters
            for bit, codes in full_codes(container, sent.sensor).items():
                is_full = frame.frame >= codes
                saturated_by = saturated_by | np.where(is_full, np.uint8(bit), np.uint8(0))
    return replace(frame, saturated_by=saturated_by)
