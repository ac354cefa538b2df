"""What each effect does to the exposures of a sample of pixels: the matter of predictions.

Fixed effects are fields: the signed change of each exposure when the effect joins all others, with
the pixels' own patterns. Random ones are variances. Where pixels may saturate, what the words make
of the mean charge is found by running them.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects import Selection, selected
from nscc_runtime.effects.crosstalk import CROSSTALK
from nscc_runtime.effects.dark import DARK
from nscc_runtime.effects.photodiode import FULL_WELL, READ, RESET
from nscc_runtime.effects.photons import PRNU, SHOT
from nscc_runtime.effects.registers import ANALOG, LEAKAGE, REGISTER
from nscc_runtime.effects.timing import DEAD_TIME, DECAY, LAG, MOTION
from nscc_runtime.light import Light
from nscc_runtime.plan.sample import Sample
from nscc_runtime.plan.sums import sums_by_slot

if TYPE_CHECKING:
    from nscc_runtime.plan.capture import Program

Values = NDArray[np.float64]

BOTH = "full_well and register"
"""What saturation of PIX and of registers do together."""
_LEAK_STEP = 0.1
_CLIPPED_E = 1.0
_SIGMAS = 8


@dataclass(frozen=True, eq=False)
class Fields:
    """Predictions for a sample; arrays are (buckets, pixels of the sample).

    `fixed` and `variance` by effect; `shifts`: the electrons by which an effect changes the counts;
    `expected`: the exposure with every effect; `thinning[closed]`: the variance that sums leave out
    because counts are not spread over the slots, with closed slots counted or not;
    `neighbours[closed]`: the same of crosstalk; `noise_cut`: that the noise of words is drawn as at
    the mean leakage. These are 0 where pixels may saturate. All but what
    saturation loses is as if nothing saturated; `clipped`: where the full well is passed.
    """

    sample: Sample
    expected: Values
    fixed: dict[str, Values]
    variance: dict[str, Values]
    shifts: dict[str, Values]
    thinning: dict[bool, Values]
    neighbours: dict[bool, Values]
    noise_cut: Values
    clipped: NDArray[np.bool_]


def fields_of(program: Program, light: Light, sample: Sample, device_seed: int) -> Fields:
    """The fields of a scene."""
    return _Fields(program, light, sample, device_seed).found()


class _Fields:
    def __init__(self, program: Program, light: Light, sample: Sample, device_seed: int) -> None:
        self.program, self.light, self.sample = program, light, sample
        self.sensor, self.device_seed = program.sensor, device_seed
        self.places = sample.places
        self.lanes = program.lanes[self.places]
        self.buckets = range(len(program.container.buckets))
        self.lag = 1.0 + self.sensor.lag_fraction
        device = program.device(device_seed)
        self.response = device.response[self.places]
        self.current, self.leak = device.current[self.places], device.leak[self.places]
        self.error = device.pattern[self.places]
        self.scale = device.response
        flat = light.frames.reshape(len(light.frames), -1)
        self.frames = np.ascontiguousarray(flat[:, self.places])

    def found(self) -> Fields:
        """All fields, each effect against all others."""
        program, sensor = self.program, self.sensor
        full = program.full
        moving = self.light.motion or self.light
        variants = {
            "full": full,
            "gain": replace(full, gain=False),
            "leak": replace(full, leak_per_s=0.0),
            "spread": replace(full, leak_per_s=full.leak_per_s * (1 + _LEAK_STEP)),
            "dead": replace(full, dead_time=False),
            "decay": replace(full, decay=False),
        }
        sums = {
            name: self._sum(moving, self._each_bucket(program.tables.weights(model).slots))
            for name, model in variants.items()
            if name != "decay" or program.tables.decays
        }
        scale = self.lag * self.response
        plain, base = sums["full"], sums["full"] * scale
        fixed = {
            PRNU.name: plain * self.lag * (self.response - 1.0),
            LAG.name: plain * sensor.lag_fraction * self.response,
            DEAD_TIME.name: base - sums["dead"] * scale,
        }
        off = (self.leak / full.leak_per_s - 1.0) / _LEAK_STEP
        fixed[LEAKAGE.name] = base - (sums["leak"] - off * (sums["spread"] - plain)) * scale
        if program.tables.decays:
            fixed[DECAY.name] = base - sums["decay"] * scale
        shifts = {name: fixed[name] for name in (PRNU.name, LAG.name)}
        if self.light.motion is not None:
            still = self._sum(self.light, self._each_bucket(program.tables.weights(full).slots))
            fixed[MOTION.name] = shifts[MOTION.name] = base - still * scale
        pattern, more = (
            program.tables.pattern(variants[name]).T[:, self.lanes] * self.error
            for name in ("full", "spread")
        )
        # A plan that leaves leakage out still takes errors as at its mean.
        fixed[LEAKAGE.name] += off * (more - pattern)
        fixed[ANALOG.name] = base - sums["gain"] * scale + pattern
        open_s = np.einsum("n,nlb->bl", program.slot_s, program.tables.weights(full).slots)
        fixed[DARK.name] = open_s[:, self.lanes] * self.current
        squares = program.tables.weights(full).slots ** 2
        open_2 = np.einsum("n,nlb->bl", program.slot_s, squares)
        noise_cut = np.zeros((len(self.buckets), len(self.places)))
        variance = {
            SHOT.name: self._sum(moving, self._each_bucket(squares)) * scale,
            DARK.name: open_2[:, self.lanes] * self.current,
        }
        for effect, sigma in (
            (READ, sensor.read_noise_e),
            (RESET, sensor.reset_noise_e),
            (ANALOG, sensor.analog_noise_e),
        ):
            factor, rest = program.tables.noise(effect.name, full)
            total = ((factor**2).sum(axis=2) + rest).T
            variance[effect.name] = sigma**2 * total[:, self.lanes]
            other = program.tables.noise(effect.name, variants["spread"])[0] - factor
            cut = rest + (other**2).sum(axis=2) * (sensor.leakage_spread_fraction / _LEAK_STEP) ** 2
            noise_cut += sigma**2 * cut.T[:, self.lanes] * ~self.sample.near
        if sensor.crosstalk_fraction > 0:
            fixed[CROSSTALK.name] = self._smeared(moving)
            # Four neighbours' counts, and four parts of the pixel's own.
            noise = variance[SHOT.name] + variance[DARK.name]
            variance[CROSSTALK.name] = 20 * sensor.crosstalk_fraction**2 * noise
        expected = base + fixed[DARK.name] + pattern
        thinning, neighbours = self._left_out(moving, scale, self.current)
        none = np.zeros(expected.shape, np.bool_)
        fields = Fields(
            self.sample, expected, fixed, variance, shifts, thinning, neighbours, noise_cut, none
        )
        return self._saturated(fields) if self.sample.near.any() else fields

    def _each_bucket(self, slots: Values) -> list[Values]:
        return [slots[:, :, bucket] for bucket in self.buckets]

    def _sum(self, light: Light, weights: list[Values], frames: object = None) -> Values:
        chosen = self.frames if frames is None else np.asarray(frames)
        return sums_by_slot(light, chosen, self.lanes, weights)

    def _smeared(self, light: Light) -> Values:
        """What crosstalk moves into the pixels' exposures in the mean."""
        rows, cols = light.shape
        row, col = self.places // cols, self.places % cols
        flat = light.frames.reshape(len(light.frames), -1)
        flow = np.zeros_like(self.frames)
        own = self.frames * self.response.astype(np.float32)
        for there, place in (
            (row > 0, self.places - cols), (row < rows - 1, self.places + cols),
            (col > 0, self.places - 1), (col < cols - 1, self.places + 1),
        ):  # fmt: skip
            place = np.where(there, place, self.places)
            flow += flat[:, place] * self.scale[place].astype(np.float32)
            flow -= own
        weights = self._each_bucket(self.program.tables.weights(self.program.full).slots)
        return self.sensor.crosstalk_fraction * self.lag * self._sum(light, weights, flow)

    def _left_out(
        self, light: Light, scale: Values, current: Values
    ) -> tuple[dict[bool, Values], dict[bool, Values]]:
        """The variances of `Fields.thinning` and `Fields.neighbours`."""
        program, c = self.program, self.sensor.crosstalk_fraction
        full = program.tables.weights(program.full).slots
        means = program.mean_weights(program.full)
        shape = len(self.buckets), len(self.places)
        thinning = {closed: np.zeros(shape) for closed in (False, True)}
        neighbours = {closed: np.zeros(shape) for closed in (False, True)}
        near = ~self.sample.near
        for group in program.group_ids.tolist():
            members = program.members(group)
            time = program.slot_s @ members
            parts = np.divide(members, time, out=np.zeros_like(members), where=time > 0)
            rates = self._sum(light, [members])[0] * scale + time[self.lanes] * current
            for bucket in self.buckets:
                weight = full[:, :, bucket] * members
                mean = means[group][self.lanes, bucket]
                one, two = self._sum(light, [weight, weight**2]) * scale
                dark = program.slot_s @ weight, program.slot_s @ weight**2
                one, two = one + dark[0][self.lanes] * current, two + dark[1][self.lanes] * current
                counted = np.maximum(two - 2 * mean * one + mean**2 * rates, 0.0)
                thinning[True][bucket] += near * counted
                thinning[False][bucket] += near * (counted if group else two)
            if c > 0:
                for other in self._neighbouring_lanes():
                    # The neighbour's light is taken as the pixel's own.
                    lit = sums_by_slot(light, self.frames, other, [members])[0] * scale
                    for bucket in self.buckets:
                        seconds = full[:, :, bucket] * program.slot_s[:, None]
                        part = np.einsum("np,np->p", seconds[:, self.lanes], parts[:, other])
                        within = near * np.clip(part, 0.0, 1.0)
                        counted = c**2 * lit * within * (1.0 - within)
                        neighbours[True][bucket] += counted
                        neighbours[False][bucket] += counted if group else c**2 * lit * within
        return thinning, neighbours

    def _neighbouring_lanes(self) -> list[NDArray[np.int32]]:
        """The lanes of the neighbours, the pixel's own where there is none."""
        rows, cols = self.light.shape
        row, col = self.places // cols, self.places % cols
        return [
            self.program.lanes[np.where(there, self.places + step, self.places)]
            for there, step in (
                (row > 0, -cols), (row < rows - 1, cols), (col > 0, -1), (col < cols - 1, 1),
            )
        ]  # fmt: skip

    def _saturated(self, fields: Fields) -> Fields:
        """The same with what the words make of the pixels that may saturate."""
        near = self.sample.near
        well, register = FULL_WELL.name, REGISTER.name
        held = {
            names: self._held(Selection(selected("all").on - {*names, CROSSTALK.name}, frozenset()))
            for names in ((), (well,), (register,), (well, register))
        }
        blank = np.zeros_like(fields.expected)
        fixed = dict(fields.fixed)
        rare = self._rarely_lost(fields.expected[:, near])
        for name, lost, least in (
            (well, held[()] - held[(well,)], 0.0),
            (register, held[()] - held[(register,)], rare),
            (BOTH, held[()] - held[(well, register)], rare),
        ):
            fixed[name] = blank.copy()
            fixed[name][:, near] = np.where(np.abs(lost) < least, -least, lost)
        expected = fields.expected.copy()
        expected[:, near] = held[()]
        clipped = np.zeros(fields.expected.shape, np.bool_)
        clipped[:, near] = np.abs(held[(register,)] - held[(well, register)]) > _CLIPPED_E
        return replace(fields, expected=expected, fixed=fixed, clipped=clipped)

    def _rarely_lost(self, expected: Values) -> Values:
        """The RMS of what registers lose of exposures (buckets, pixels) that noise takes beyond
        their linear range: a few pixels in a frame, which no sample shows.
        """
        sensor, reach = self.sensor, self.program.reach
        lanes = self.lanes[self.sample.near]
        high = min(abs(sensor.register_min_e), sensor.register_max_e)
        knee = sensor.register_knee_fraction * high
        z = np.linspace(-_SIGMAS, _SIGMAS, 16 * _SIGMAS + 1)[:, None, None]
        density = np.exp(-z * z / 2)
        size = np.abs(expected) + reach.offset_e[lanes]
        sigma = np.sqrt(reach.sigma_e[lanes] ** 2 + np.abs(expected))
        over = np.maximum(size + sigma * z - knee, 0.0)
        room = max(high - knee, 1e-9)
        lost = over - room * np.tanh(over / room)
        # Of many pixels the one that goes farthest may carry all of it.
        count = max(2.0, self.sample.weight[self.sample.near].sum())
        farthest = np.argmin(np.abs(z[:, 0, 0] - (math.sqrt(2 * math.log(count)) + 1.0)))
        mean = (density * lost**2).sum(axis=0) / density.sum()
        return np.asarray(np.sqrt(np.maximum(mean, lost[farthest] ** 2 / count)))

    def _held(self, kept: Selection) -> Values:
        """What the words make of pixels that may saturate: noise alone may take them there."""
        return self.program.pixels.exposures(
            self.light,
            self.program.slot_s,
            self.places[self.sample.near],
            kept,
            device_seed=self.device_seed,
        )
