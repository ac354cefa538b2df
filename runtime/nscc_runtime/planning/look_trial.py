"""Trials of programs whose pixels look at the light, on tiles of a scene.

If a pixel ends in another state, its exposure is a different measurement instead of an error.
Therefore two figures are measured: the fraction of such pixels, and the error of the remaining
pixels. If a program has kept states, later frames of a series begin in other states than the first
frame, so a whole series is simulated."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.caches import remembered
from nscc_runtime.effects import Effect, Selection, everything, registered
from nscc_runtime.effects.parts import Fading, Moving
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.effects.views import Scene
from nscc_runtime.execution.frames import Path
from nscc_runtime.execution.near_saturation import NO_PIXELS
from nscc_runtime.execution.pixel_array import light_at, tile_places
from nscc_runtime.interface import Executed
from nscc_runtime.light import Light
from nscc_runtime.looked_frames import next_planes
from nscc_runtime.looking.looking_program import BEFORE_WORDS, LookingProgram
from nscc_runtime.planning.differences import Difference, ExposureErrors
from nscc_runtime.planning.planned_scene import NONE, Move, Names, Setting, Trial
from nscc_runtime.planning.prices import SHIPPED
from nscc_runtime.planning.sample import Sample, sample_of
from nscc_runtime.reference.capture import scene_of
from nscc_runtime.reference.charge import Fallen, charge_of_rows
from nscc_runtime.reference.looks import Intervals, LookingReference

Bits = NDArray[np.bool_]
Values = NDArray[np.float64]

_TILES = 256
"""Number of tiles to draw."""
_SEEDS = 0, 0
_FRAMES = 16
"""Largest number of frames of a series."""
_SETTLED = 0.005
"""A series ends if at most this fraction of the pixels begins a frame with new values."""
_REFERENCE_NS = 1000.0
"""Additional nanoseconds per pixel if the reference simulates the frame."""
LOOKS = "pixels look at the light: each runs through the words that act in it"


@dataclass(frozen=True, eq=False)
class LookTrial(Trial):
    """The trial of a program whose pixels look at the light of a scene."""

    program: LookingProgram
    light: Light

    looks = True

    @property
    def sensor(self) -> Sensor:
        return self.program.sensor

    @property
    def pixels(self) -> int:
        return self.light.shape[0] * self.light.shape[1]

    @cached_property
    def absent(self) -> Names:
        steady = everything().names(Moving) if self.light.motion is None else frozenset()
        return steady | (frozenset() if self.program.fades else everything().names(Fading))

    # -- Sample and effects -------------------------------------------------------------------

    @cached_property
    def sample(self) -> Sample:
        return sample_of(self.light.sum_e, NO_PIXELS, self.sensor.full_well_e, _TILES)

    @cached_property
    def _places(self) -> NDArray[np.int64]:
        rows, cols = self.light.shape
        if not self.sample.side:
            return np.arange(rows * cols).reshape(rows, cols)
        return tile_places(self.sample.corners, self.sample.side, (rows, cols))

    @cached_property
    def _light(self) -> Light:
        return light_at(self.light, self._places)

    @cached_property
    def _loaded(self) -> Mapping[str, Bits]:
        planes = self.program.container.planes()
        return {name: plane.reshape(-1)[self._places] for name, plane in planes.items()}

    @cached_property
    def _measured(self) -> Bits:
        is_measured = np.zeros(self._places.size, np.bool_)
        is_measured[self.sample.inner] = True
        return is_measured.reshape(self._places.shape)

    # -- Exposures ----------------------------------------------------------------------------

    @cached_property
    def _film(self) -> list[tuple[Mapping[str, Bits], Executed]]:
        """A series of frames with all effects: for each frame, the planes at its start and its
        result.

        The series ends when nearly all pixels begin a frame with register values that they had
        before."""
        container, all_effects = self.program.container, everything()
        weight = np.zeros(self._places.size)
        inner_weight = self.sample.weight[: len(self.sample.inner)]
        weight[self.sample.inner] = inner_weight / max(inner_weight.sum(), 1e-300)
        loaded, series = self._loaded, list[tuple[Mapping[str, Bits], Executed]]()
        while len(series) < _FRAMES:
            seen_before = np.zeros(self._places.shape, np.bool_)
            for before, _ in series:
                seen_before |= np.all([loaded[name] == before[name] for name in loaded], axis=0)
            if series and float(weight[~seen_before.reshape(-1)].sum()) <= _SETTLED:
                break
            series.append((loaded, self._exposed(all_effects, len(series), loaded)))
            loaded = {**self._loaded, **next_planes(container, loaded, series[-1][1].planes)}
        return series

    def _exposed(self, effects: Selection, frame: int, loaded: Mapping[str, Bits]) -> Executed:
        if self.program.lacks(effects):
            reference = LookingReference(self.program.container, self.sensor, effects)
            return reference.expose(self._scene, loaded, _SEEDS, frame)
        before = frozenset(e.name for e in effects.effects if e.reference.keys() & BEFORE_WORDS)
        fallen = self._fallen(before, effects.noiseless, frame)
        return self.program.expose(
            self._scene, loaded, effects, _SEEDS, frame, fallen_in=lambda rows_of_part:
            fallen.rows(slice(rows_of_part.start, rows_of_part.stop)), among=self._measured,
        )  # fmt: skip

    @cached_property
    def _scene(self) -> Scene:
        return scene_of(self.program.container, self._light)

    @remembered
    def _fallen(self, before: Names, every_slot: bool, frame: int) -> Fallen:
        """Return the charge of a frame under the effects `before`, which act before words run."""
        effects = everything()
        effects = effects.without(*(e.name for e in effects.effects if e.name not in before))
        joined = Intervals.of(self.program.container, every_slot).joined(self._scene)
        rows = range(self._places.shape[0])
        return charge_of_rows(joined, None, self.sensor, effects, _SEEDS, frame, rows)

    @remembered
    def _of_film(self, dropped: Names) -> list[list[Executed]]:
        """Return the results of every frame of the series without the `dropped` effects; frames of
        small scenes are repeated `sample.frames` times with other random numbers."""
        effects = everything().without(*dropped)
        return [
            [
                full if not dropped and not turn
                else self._exposed(effects, number + turn * _FRAMES, loaded)
                for turn in range(self.sample.frames)
            ]
            for number, (loaded, full) in enumerate(self._film)
        ]  # fmt: skip

    def _between(self, dropped: Names, other_dropped: Names) -> ExposureErrors:
        """Return exposures without the effects `dropped` minus exposures without `other_dropped`.
        Pixels that end in different states are not compared."""
        size_e, compared, inner = [], [], self.sample.inner
        for mine, theirs in zip(self._of_film(dropped), self._of_film(other_dropped), strict=True):
            turns = [_difference(*pair) for pair in zip(mine, theirs, strict=True)]
            size_e.append(np.concatenate([away[:, inner] for away, _ in turns], axis=1))
            compared.append(np.concatenate([same[:, inner] for _, same in turns], axis=1))
        return ExposureErrors(np.concatenate(size_e), np.concatenate(compared), states=True)

    # -- Measurements -------------------------------------------------------------------------

    def executes(self, setting: Setting) -> Path:
        """Return "words", or "reference" if only the reference supports a kept effect."""
        kept_effects = self.requested_effects.without(*setting.dropped)
        return "reference" if self.program.lacks(kept_effects) else "words"

    def alone(self, effect: Effect, near_saturation: bool) -> ExposureErrors:
        other_dropped = self.forced_off - {effect.name}
        return self._between(other_dropped | {effect.name}, other_dropped)

    def together(self, setting: Setting) -> ExposureErrors:
        return self._between(self.forced_off | setting.dropped, NONE)

    def moves(self, free: Names) -> Sequence[Move]:
        """Return a move for each single free effect that costs time."""
        return [
            Move(frozenset({e.name}), self.saved_ns(e.name), e.name)
            for e in registered()
            if e.name in free - self.absent and self.saved_ns(e.name) > 0
        ]

    def noise_e(self) -> float:
        """Return the RMS noise of a frame in electrons, from pixels with equal states in two."""
        loaded, first = self._film[0]
        numbers, inner = range(1, 1 + self.sample.frames), self.sample.inner
        pairs = [
            _difference(self._exposed(everything(), number, loaded), first) for number in numbers
        ]
        away, same = (
            np.concatenate([pixel_array[:, inner] for pixel_array in both], axis=1)
            for both in zip(*pairs, strict=True)
        )
        difference = Difference(ExposureErrors(away, same), self.sample)
        return float(np.sqrt(difference.square_e2.mean() / 2))

    # -- Prices -------------------------------------------------------------------------------

    def reasons(self, setting: Setting) -> tuple[str, ...]:
        kept_effects = self.requested_effects.without(*setting.dropped)
        return self.program.lacks(kept_effects) or (LOOKS,)

    def saved_ns(self, name: str) -> float:
        all_effects = everything()
        lacks = self.program.lacks
        reference_ns = (
            _REFERENCE_NS if lacks(all_effects) and not lacks(all_effects.without(name)) else 0.0
        )
        return next(e.cost_ns for e in registered() if e.name == name) + reference_ns

    def frame_ns(self, setting: Setting) -> tuple[float, float]:
        kept_effects = self.requested_effects.without(*setting.dropped, *self.absent)
        effects = (e.name for e in kept_effects.effects if e.kind != "after")
        return SHIPPED.looked + sum(self.saved_ns(name) for name in effects), 0.0

    def planning_ms(self) -> float:
        pixels = min(self.pixels, 16 * _TILES)
        exposures = sum(e.kind != "after" for e in registered()) - len(self.absent) + 2
        films = 4 if self.program.container.machine.keeps else 1
        return SHIPPED.looked * exposures * pixels * films * 1e-6


def _difference(exposed: Executed, full: Executed) -> tuple[Values, Bits]:
    """Return the difference of two exposures, and where it is valid, both of shape (buckets,
    pixels).

    A difference is valid if both exposures are finite and the pixel ends in the same states.
    Invalid differences are 0."""
    valid = exposed.exposure.valid.all(axis=0) & full.exposure.valid.all(axis=0)
    same = valid & same_states(exposed, full)
    with np.errstate(invalid="ignore"):
        away = np.where(same, exposed.exposure.exposure_e - full.exposure.exposure_e, 0.0)
    shape = len(away), -1
    return away.reshape(shape), np.broadcast_to(same, away.shape).reshape(shape)


def same_states(exposed: Executed, full: Executed) -> Bits:
    """Return a mask (rows, cols) of the pixels that end two frames in the same states."""
    same = np.ones(full.exposure.valid.shape[1:], np.bool_)
    for name, plane in full.planes.items():
        same &= exposed.planes[name] == plane
    return same
