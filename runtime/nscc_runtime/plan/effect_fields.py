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
from nscc_runtime.effects.photodiode import FULL_WELL
from nscc_runtime.effects.photons import PRNU, SHOT
from nscc_runtime.effects.registers import ANALOG, LEAKAGE, REGISTER
from nscc_runtime.effects.timing import DEAD_TIME, DECAY, LAG, MOTION
from nscc_runtime.light import Light
from nscc_runtime.plan.sample import Sample
from nscc_runtime.plan.sums import sums_by_slot

if TYPE_CHECKING:
    from nscc_runtime.plan.program import Program

Values = NDArray[np.float64]
Frames = NDArray[np.float32]

FORCED = "forced off"
"""What all that is forced off does where pixels run through their words: random parts included."""
BOTH = "full_well and register"
"""What saturation of PIX and of registers do together."""
_LEAK_STEP = 0.1
_CLIPPED_E = 1.0
_SIGMAS = 8
_MOST_LIGHT = np.float32(1e30)
"""Beyond it float32 has no room for what neighbours add."""


@dataclass(frozen=True, eq=False)
class Fields:
    """Predictions for a sample; arrays are (buckets, pixels of the sample).

    `fixed` and `variance` by effect; `shifts`: the electrons by which an effect changes the counts;
    `expected`: the exposure with every effect; `thinning[closed]`: the variance that sums leave out
    because counts are not spread over the slots, with closed slots counted or not;
    `neighbours[closed]`: the same of crosstalk; `noise_cut`: that the noise of words is drawn as at
    the mean leakage. All but what
    saturation loses is as if nothing saturated; `clipped`: where the full well is passed;
    `after`: the fields there of fixed effects that act on what the well lets through.
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
    after: dict[str, Values]


def fields_of(
    program: Program,
    light: Light,
    sample: Sample,
    device_seed: int,
    forced_off: frozenset[str] = frozenset(),
) -> Fields:
    """The fields of a scene; `forced_off` are effects that pixels near saturation lack as well."""
    return _Fields(program, light, sample, device_seed, forced_off).found()


class _Fields:
    def __init__(
        self,
        program: Program,
        light: Light,
        sample: Sample,
        device_seed: int,
        forced_off: frozenset[str],
    ) -> None:
        self.forced_off = forced_off
        self.program, self.light, self.sample = program, light, sample
        self.sensor, self.device_seed = program.sensor, device_seed
        self.places = sample.places
        self.lanes = program.lanes[self.places]
        self.buckets = range(len(program.container.buckets))
        self.lag = 1.0 + self.sensor.lag_fraction
        self.device = program.device(device_seed)
        self.response = self.device.response[self.places]
        flat = light.frames.reshape(len(light.frames), -1)
        self.frames = np.minimum(flat[:, self.places], _MOST_LIGHT)
        self.beside = self._beside() if self.sensor.crosstalk_fraction > 0 else []

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
        own, seen, even = self._seen()
        if not program.tables.decays:
            del variants["decay"]
        weights = [
            each
            for model in variants.values()
            for each in self._each_bucket(program.tables.weights(model).slots)
        ]
        summed = self._sum(moving, weights, seen).reshape(len(variants), len(self.buckets), -1)
        sums = dict(zip(variants, summed, strict=True))
        slots = self._each_bucket(program.tables.weights(full).slots)
        base = sums["full"] * self.lag
        alone = self._sum(moving, slots, own) * self.lag
        alike = self._sum(moving, slots, even) * self.lag
        fixed = {
            PRNU.name: base - alike,
            LAG.name: sums["full"] * sensor.lag_fraction,
            DEAD_TIME.name: base - sums["dead"] * self.lag,
        }
        off = (self.device.leak[self.places] / full.leak_per_s - 1.0) / _LEAK_STEP
        step = off * (sums["spread"] - sums["full"])
        fixed[LEAKAGE.name] = base - (sums["leak"] - step) * self.lag
        if program.tables.decays:
            fixed[DECAY.name] = base - sums["decay"] * self.lag
        shifts = {
            PRNU.name: alone * (1.0 - 1.0 / np.maximum(self.response, 1e-3)),
            LAG.name: alone * (sensor.lag_fraction / self.lag),
        }
        if self.light.motion is not None:
            still = self._sum(self.light, slots, seen) * self.lag
            fixed[MOTION.name] = shifts[MOTION.name] = base - still
        error = self.device.pattern[self.places]
        pattern, more = (
            program.tables.pattern(variants[name]).T[:, self.lanes] * error
            for name in ("full", "spread")
        )
        # A plan that leaves leakage out still takes errors as at its mean.
        fixed[LEAKAGE.name] += off * (more - pattern)
        fixed[ANALOG.name] = base - sums["gain"] * self.lag + pattern
        open_s = np.einsum("n,nlb->bl", program.slot_s, program.tables.weights(full).slots)
        current = self.device.current[self.places]
        spilt = self._spilt(current)
        fixed[DARK.name] = open_s[:, self.lanes] * (current + spilt)
        squares = program.tables.weights(full).slots ** 2
        open_2 = np.einsum("n,nlb->bl", program.slot_s, squares)
        noise_cut = np.zeros((len(self.buckets), len(self.places)))
        squared = self._each_bucket(squares)
        variance = {
            SHOT.name: self._sum(moving, squared, self._counted(smeared=True)) * self.lag,
            DARK.name: open_2[:, self.lanes] * current,
        }
        for effect, sigma in program.noises:
            factor, rest = program.tables.noise(effect.name, full)
            total = ((factor**2).sum(axis=2) + rest).T
            variance[effect.name] = sigma**2 * total[:, self.lanes]
            other = program.tables.noise(effect.name, variants["spread"])[0] - factor
            cut = rest + (other**2).sum(axis=2) * (sensor.leakage_spread_fraction / _LEAK_STEP) ** 2
            noise_cut += sigma**2 * cut.T[:, self.lanes]
        if sensor.crosstalk_fraction > 0:
            fixed[CROSSTALK.name] = base - alone + open_s[:, self.lanes] * spilt
            counted = self._sum(moving, squared, self._counted(smeared=False)) * self.lag
            # Of dark charge four neighbours' counts, and four parts of the pixel's own.
            dark = 20 * variance[DARK.name]
            variance[CROSSTALK.name] = sensor.crosstalk_fraction**2 * (counted + dark)
        expected = base + fixed[DARK.name] + pattern
        thinning, neighbours = self._left_out(moving, current)
        none = np.zeros(expected.shape, np.bool_)
        fields = Fields(
            self.sample,
            expected,
            fixed,
            variance,
            shifts,
            thinning,
            neighbours,
            noise_cut,
            none,
            {},
        )
        return self._saturated(fields, pattern) if self.sample.near.any() else fields

    def _each_bucket(self, slots: Values) -> list[Values]:
        return [slots[:, :, bucket] for bucket in self.buckets]

    def _sum(self, light: Light, weights: list[Values], frames: Frames) -> Values:
        return sums_by_slot(light, frames, self.lanes, weights)

    def _seen(self) -> tuple[Frames, Frames, Frames]:
        """Frames of the pixels' own light; of what falls on them with their neighbours' light; the
        same as if all pixels responded alike.
        """
        own = self.frames * self.response.astype(np.float32)
        c = np.float32(self.sensor.crosstalk_fraction)
        seen, even = own.copy(), self.frames.copy()
        for there, _, frames, part in self.beside:
            seen += c * (frames * part - there * own)
            even += c * (frames - there * self.frames)
        return own, seen, even

    def _counted(self, smeared: bool) -> Frames:
        """Frames whose sums have the variance of counts: with crosstalk, or of what it moves, that
        by the square of the fraction.
        """
        c = np.float32(self.sensor.crosstalk_fraction)
        own = self.frames * self.response.astype(np.float32)
        flow = np.zeros_like(self.frames)
        count = np.zeros(len(self.places), np.float32)
        for there, _, frames, part in self.beside:
            flow += frames * part
            count += there
        if smeared:
            return np.asarray((1 - c * count) ** 2 * own + c**2 * flow)
        return np.asarray(count**2 * own + flow)

    def _spilt(self, current: Values) -> Values:
        """What crosstalk adds to the pixels' dark current."""
        found = np.zeros_like(current)
        for there, place, _, _ in self.beside:
            found += there * (self.device.current[place] - current)
        return self.sensor.crosstalk_fraction * found

    def _beside(self) -> list[tuple[Frames, NDArray[np.int64], Frames, Frames]]:
        """In each direction: 1 where pixels have a neighbour, else 0; its place, its frames (0
        where there is none), its response.
        """
        rows, cols = self.light.shape
        row, col = self.places // cols, self.places % cols
        flat = self.light.frames.reshape(len(self.light.frames), -1)
        found = []
        for inside, step in (
            (row > 0, -cols), (row < rows - 1, cols), (col > 0, -1), (col < cols - 1, 1),
        ):  # fmt: skip
            there, place = inside.astype(np.float32), np.where(inside, self.places + step, 0)
            part = self.device.response[place].astype(np.float32)
            frames = there * np.minimum(flat[:, place], _MOST_LIGHT)
            found.append((there, place, frames, part))
        return found

    def _left_out(
        self, light: Light, current: Values
    ) -> tuple[dict[bool, Values], dict[bool, Values]]:
        """The variances of `Fields.thinning` and `Fields.neighbours`."""
        program, c = self.program, self.sensor.crosstalk_fraction
        full = program.tables.weights(program.full).slots
        means = program.mean_weights(program.full)
        shape = len(self.buckets), len(self.places)
        thinning = {closed: np.zeros(shape) for closed in (False, True)}
        neighbours = {closed: np.zeros(shape) for closed in (False, True)}
        scale = self.lag * self.response
        for group in program.group_ids.tolist():
            members = program.members(group)
            time = program.slot_s @ members
            parts = np.divide(members, time, out=np.zeros_like(members), where=time > 0)
            for bucket in self.buckets:
                weight = full[:, :, bucket] * members
                mean = means[group][self.lanes, bucket]
                summed = self._sum(light, [members, weight, weight**2], self.frames) * scale
                rates, one, two = summed[0] + time[self.lanes] * current, summed[1], summed[2]
                dark = program.slot_s @ weight, program.slot_s @ weight**2
                one, two = one + dark[0][self.lanes] * current, two + dark[1][self.lanes] * current
                counted = np.maximum(two - 2 * mean * one + mean**2 * rates, 0.0)
                thinning[True][bucket] += counted
                thinning[False][bucket] += counted if group else two
            for _, place, frames, part in self.beside:
                other = program.lanes[place]
                lit = sums_by_slot(light, frames * part, other, [members])[0] * self.lag
                for bucket in self.buckets:
                    seconds = full[:, :, bucket] * program.slot_s[:, None]
                    inside = np.einsum("np,np->p", seconds[:, self.lanes], parts[:, other])
                    within = np.clip(inside, 0.0, 1.0)
                    counted = c**2 * lit * within * (1.0 - within)
                    neighbours[True][bucket] += counted
                    neighbours[False][bucket] += counted if group else c**2 * lit * within
        return thinning, neighbours

    def _saturated(self, fields: Fields, pattern: Values) -> Fields:
        """The same with what the words make of the pixels that may saturate."""
        near = self.sample.near
        well, register = FULL_WELL.name, REGISTER.name
        held = {
            names: self._held(Selection(selected("all").on - {*names, CROSSTALK.name}, frozenset()))
            for names in ((), (well,), (register,), (well, register))
        }
        blank = np.zeros_like(fields.expected)
        fixed = dict(fields.fixed)
        rare = self._rarely_lost(held[(register,)])
        for name, lost, least in (
            (well, held[()] - held[(well,)], 0.0),
            (register, held[()] - held[(register,)], rare),
            (BOTH, held[()] - held[(well, register)], self._rarely_lost(held[(well, register)])),
        ):
            fixed[name] = blank.copy()
            fixed[name][:, near] = np.where(np.abs(lost) < least, -least, lost)
        if self.forced_off:
            everything = selected("all").on
            whole, less = (
                self._held(Selection(on, frozenset()))
                for on in (everything, everything - self.forced_off)
            )
            fixed[FORCED] = blank.copy()
            fixed[FORCED][:, near] = whole - less
        expected = fields.expected.copy()
        expected[:, near] = held[()]
        clipped = np.zeros(fields.expected.shape, np.bool_)
        clipped[:, near] = np.abs(held[(register,)] - held[(well, register)]) > _CLIPPED_E
        # Of the charge that effects after the well act on, the part that it lets through.
        free, part = fields.expected - pattern, np.ones_like(expected)
        part[:, near] = (held[(register,)] - pattern[:, near]) / np.maximum(free[:, near], 1.0)
        after = {
            ANALOG.name: pattern + (fields.fixed[ANALOG.name] - pattern) * part,
            LEAKAGE.name: fields.fixed[LEAKAGE.name] * part,
        }
        return replace(fields, expected=expected, fixed=fixed, clipped=clipped, after=after)

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
