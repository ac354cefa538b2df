"""Programs whose pixels look at the light, tried on tiles of a scene.

Exposures of a pixel that ends in another state are no error but another measurement: the part of
the pixels that do is measured beside the errors of the others. Where states are kept, a film's
later frames begin in others than its first: all of them are tried.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects import Effect, Selection, everything, registered
from nscc_runtime.effects.parts import Fading, Moving
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.effects.views import Scene
from nscc_runtime.execution.frames import Path
from nscc_runtime.execution.near import NO_PIXELS
from nscc_runtime.execution.pixel_array import light_at, tile_places
from nscc_runtime.interface import Executed
from nscc_runtime.light import Light
from nscc_runtime.looked_frames import next_planes
from nscc_runtime.looking.ways import BEFORE_WORDS, Ways
from nscc_runtime.planning.differences import Difference, Errors
from nscc_runtime.planning.prices import SHIPPED
from nscc_runtime.planning.sample import Sample, sample_of
from nscc_runtime.planning.trial import NONE, Move, Names, Setting, Trial
from nscc_runtime.reference.capture import scene_of
from nscc_runtime.reference.charge import Fallen, charge_of_rows
from nscc_runtime.reference.intervals import Intervals
from nscc_runtime.reference.looks import LookingReference
from nscc_runtime.remembered import remembered

Bits = NDArray[np.bool_]
Values = NDArray[np.float64]

_TILES = 256
"""How many tiles are drawn."""
_SEEDS = 0, 0
_FRAMES = 16
"""At most so many frames of a film are tried."""
_SETTLED = 0.005
"""A film has shown what it does once no more than this part of its pixels begins a frame as it has
begun none before."""
_REFERENCE_NS = 1000.0
"""What a pixel costs more in the reference."""
LOOKS = "pixels look at the light: each runs through the words that act in it"


@dataclass(frozen=True, eq=False)
class LookTrial(Trial):
    """A program whose pixels look on a scene."""

    ways: Ways
    light: Light

    looks = True

    @property
    def sensor(self) -> Sensor:
        """The sensor."""
        return self.ways.sensor

    @property
    def pixels(self) -> int:
        """How many pixels the scene has."""
        return self.light.shape[0] * self.light.shape[1]

    @cached_property
    def absent(self) -> Names:
        """Effects that change nothing here for sure."""
        steady = everything().names(Moving) if self.light.motion is None else frozenset()
        return steady | (frozenset() if self.ways.fades else everything().names(Fading))

    # -- What is measured where ---------------------------------------------------------------

    @cached_property
    def sample(self) -> Sample:
        """The measured pixels."""
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
        planes = self.ways.container.planes()
        return {name: plane.reshape(-1)[self._places] for name, plane in planes.items()}

    @cached_property
    def _measured(self) -> Bits:
        where = np.zeros(self._places.size, np.bool_)
        where[self.sample.inner] = True
        return where.reshape(self._places.shape)

    # -- Exposures ----------------------------------------------------------------------------

    @cached_property
    def _film(self) -> list[tuple[Mapping[str, Bits], Executed]]:
        """The registers with which each frame starts, and the frame with all effects: as many as
        it takes until pixels begin them as they have begun others."""
        container, every = self.ways.container, everything()
        weight = np.zeros(self._places.size)
        once = self.sample.weight[: len(self.sample.inner)]
        weight[self.sample.inner] = once / max(once.sum(), 1e-300)
        loaded, film = self._loaded, list[tuple[Mapping[str, Bits], Executed]]()
        while len(film) < _FRAMES:
            seen = np.zeros(self._places.shape, np.bool_)
            for before, _ in film:
                seen |= np.all([loaded[name] == before[name] for name in loaded], axis=0)
            if film and float(weight[~seen.reshape(-1)].sum()) <= _SETTLED:
                break
            film.append((loaded, self._exposed(every, len(film), loaded)))
            loaded = {**self._loaded, **next_planes(container, loaded, film[-1][1].planes)}
        return film

    def _exposed(self, effects: Selection, frame: int, loaded: Mapping[str, Bits]) -> Executed:
        rows = range(self._places.shape[0])
        if self.ways.lacks(effects):
            reference = LookingReference(self.ways.container, self.sensor, effects)
            return reference.expose(self._scene, loaded, _SEEDS, frame)
        before = frozenset(e.name for e in effects.effects if e.reference.keys() & BEFORE_WORDS)
        fallen = self._fallen(before, effects.noiseless, frame)
        return self.ways.run(
            self._scene, loaded, effects, _SEEDS, frame, rows,
            lambda part: fallen.rows(slice(part.start, part.stop)), among=self._measured,
        )  # fmt: skip

    @cached_property
    def _scene(self) -> Scene:
        return scene_of(self.ways.container, self._light)

    @remembered
    def _fallen(self, before: Names, every_slot: bool, frame: int) -> Fallen:
        """The charge under the effects that make it, which are fewer than all."""
        effects = everything()
        effects = effects.without(*(e.name for e in effects.effects if e.name not in before))
        joined = Intervals.of(self.ways.container, every_slot).joined(self._scene)
        rows = range(self._places.shape[0])
        return charge_of_rows(joined, None, self.sensor, effects, _SEEDS, frame, rows)

    @remembered
    def _of_film(self, dropped: Names) -> list[list[Executed]]:
        """Every frame of the film without some effects, as often as it is exposed."""
        effects = everything().without(*dropped)
        return [
            [
                full if not dropped and not turn
                else self._exposed(effects, number + turn * _FRAMES, loaded)
                for turn in range(self.sample.frames)
            ]
            for number, (loaded, full) in enumerate(self._film)
        ]  # fmt: skip

    def _between(self, dropped: Names, others: Names) -> Errors:
        """Exposures without some effects less those without others, of pixels that end in the
        same states."""
        size_e, compared, inner = [], [], self.sample.inner
        for mine, theirs in zip(self._of_film(dropped), self._of_film(others), strict=True):
            turns = [_difference(*pair) for pair in zip(mine, theirs, strict=True)]
            size_e.append(np.concatenate([away[:, inner] for away, _ in turns], axis=1))
            compared.append(np.concatenate([same[:, inner] for _, same in turns], axis=1))
        return Errors(np.concatenate(size_e), np.concatenate(compared), states=True)

    # -- What planning asks -------------------------------------------------------------------

    def executes(self, setting: Setting) -> Path:
        """The words, or the reference where only that has an effect."""
        kept = self.wanted.without(*setting.dropped)
        return "reference" if self.ways.lacks(kept) else "words"

    def alone(self, effect: Effect, near: bool) -> Errors:
        """Beside all other effects that are wanted."""
        others = self.forced_off - {effect.name}
        return self._between(others | {effect.name}, others)

    def together(self, setting: Setting) -> Errors:
        """Beside frames with every effect."""
        return self._between(self.forced_off | setting.dropped, NONE)

    def moves(self, free: Names) -> Sequence[Move]:
        """Effects one by one."""
        return [
            Move(frozenset({e.name}), self.saved_ns(e.name), e.name)
            for e in registered()
            if e.name in free - self.absent and self.saved_ns(e.name) > 0
        ]

    def noise_e(self) -> float:
        """The root mean square over pixels and buckets of the standard deviation of exposures with
        every effect: of those that end in the same states."""
        loaded, first = self._film[0]
        numbers, inner = range(1, 1 + self.sample.frames), self.sample.inner
        pairs = [
            _difference(self._exposed(everything(), number, loaded), first) for number in numbers
        ]
        away, same = (
            np.concatenate([each[:, inner] for each in both], axis=1)
            for both in zip(*pairs, strict=True)
        )
        found = Difference(Errors(away, same), self.sample)
        return float(np.sqrt(found.square_e2.mean() / 2))

    # -- Prices -------------------------------------------------------------------------------

    def reasons(self, setting: Setting) -> tuple[str, ...]:
        """Why pixels run through their words, or why the reference runs."""
        kept = self.wanted.without(*setting.dropped)
        return self.ways.lacks(kept) or (LOOKS,)

    def saved_ns(self, name: str) -> float:
        """Nanoseconds a pixel that leaving an effect out saves."""
        every = everything()
        lacks = self.ways.lacks
        much = _REFERENCE_NS if lacks(every) and not lacks(every.without(name)) else 0.0
        return next(e.cost_ns for e in registered() if e.name == name) + much

    def frame_ns(self, setting: Setting) -> tuple[float, float]:
        """By words, or by the reference."""
        kept = self.wanted.without(*setting.dropped, *self.absent)
        effects = (e.name for e in kept.effects if e.kind != "after")
        return SHIPPED.looked + sum(self.saved_ns(name) for name in effects), 0.0

    def planning_ms(self) -> float:
        """Every frame of the sample is exposed with all effects, and without each."""
        pixels = min(self.pixels, 16 * _TILES)
        exposures = sum(e.kind != "after" for e in registered()) - len(self.absent) + 2
        machine = self.ways.container.machine
        films = 4 if machine is not None and machine.keeps else 1
        return SHIPPED.looked * exposures * pixels * films * 1e-6


def _difference(some: Executed, full: Executed) -> tuple[Values, Bits]:
    """Exposures (buckets, pixels) less others, 0 where they are not compared, and where they are:
    of pixels that end in the same states."""
    valid = some.exposure.valid.all(axis=0) & full.exposure.valid.all(axis=0)
    same = valid & same_states(some, full)
    with np.errstate(invalid="ignore"):
        away = np.where(same, some.exposure.exposure_e - full.exposure.exposure_e, 0.0)
    shape = len(away), -1
    return away.reshape(shape), np.broadcast_to(same, away.shape).reshape(shape)


def same_states(some: Executed, full: Executed) -> Bits:
    """Where (rows, cols) two frames end in the same states."""
    same = np.ones(full.exposure.valid.shape[1:], np.bool_)
    for name, plane in full.planes.items():
        same &= some.planes[name] == plane
    return same
