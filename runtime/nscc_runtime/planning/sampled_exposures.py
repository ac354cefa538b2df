"""Exposures of sampled pixels of programs with fixed shutters: by sums, by words, by the reference.

Tiles are exposed side by side as a separate array, with the random numbers of their places on the
chip. Their exposures therefore equal those of the whole frame. Pixels near saturation run through
their words on the whole array."""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.caches import remembered
from nscc_runtime.effects import Selection
from nscc_runtime.effects.parts import Counted, Echo, Moving, Response, Saturates
from nscc_runtime.execution.chip import SimulatedChip
from nscc_runtime.execution.frames import Execution, counts_agree
from nscc_runtime.execution.pixel_array import PixelArray, light_at, tile_places
from nscc_runtime.execution.pixels import KnownCounts, Running
from nscc_runtime.execution.program import AnalysedProgram
from nscc_runtime.execution.summed import SummedScene
from nscc_runtime.light import Light
from nscc_runtime.planning.sample import Sample
from nscc_runtime.reference.capture import Reference, scene_of
from nscc_runtime.reference.charge import Groups

Values = NDArray[np.float64]

SEED = 0
"""Noise seed of trials, independent of the seed of a run."""
_SIDE = 3
"""Side of the tiles around pixels near saturation."""


@dataclass(frozen=True, eq=False)
class SampledExposures:
    """Cached exposures (buckets, pixels) of the sampled pixels of a scene, in electrons."""

    program: AnalysedProgram
    light: Light
    sample: Sample
    device_seed: int
    threads: int

    @remembered
    def expose(self, execution: Execution, frame: int) -> Values:
        """Return exposures (buckets, pixels) of all sampled pixels by an execution."""
        if execution.path == "words":
            return self.by_words(execution.kept_effects, slice(None), frame)
        far_exposure_e = self.by_sums(
            execution.kept_effects, execution.requested_effects, "far", frame
        )
        if execution.kept_effects.names(Saturates):
            near_exposure_e = self._near_by_words(execution, frame)
        else:
            near_exposure_e = self.by_sums(
                execution.kept_effects, execution.requested_effects, "near", frame
            )
        return np.concatenate([far_exposure_e, near_exposure_e], axis=1)

    @remembered
    def by_sums(
        self, kept_effects: Selection, requested_effects: Selection, region: str, frame: int
    ) -> Values:
        """Return exposures (buckets, pixels) by sums of the sampled pixels "far" from or "near"
        saturation (`region`)."""
        inner = self._arrays[region][2]
        if not len(inner):
            return np.empty((len(self.program.container.buckets), 0))
        summed = self._summed(kept_effects, requested_effects, region)
        exposures = [
            summed.expose(SEED, number, self._away(summed, number))[:, inner]
            for number in self._numbers(frame)
        ]
        return np.concatenate(exposures, axis=1)

    def by_words(
        self,
        effects: Selection,
        chosen: slice | NDArray[np.intp],
        frame: int = 0,
        known_counts: Sequence[KnownCounts] | None = None,
    ) -> Values:
        """Return exposures (buckets, pixels) by words of the `chosen` sampled pixels.
        `known_counts`: neighbours' counts for each repeated exposure; None to draw them."""
        wired, places = self.program.wired(effects, self.device_seed), self.sample.places[chosen]
        exposed = np.empty((len(self.program.container.buckets), len(places)))
        for turn, number in enumerate(self._numbers(frame)):
            in_turn = np.flatnonzero(self.sample.frame[chosen] == turn)
            running = Running(wired, self.light, places[in_turn], self.threads)
            counts = None if known_counts is None else known_counts[turn]
            exposed[:, in_turn] = running.expose(SEED, number, counts)[0]
        return exposed

    @remembered
    def by_reference(self, effects: Selection) -> Values:
        """Return exposures (buckets, pixels) of all sampled pixels by the reference."""
        exposures = [np.empty((len(self.program.container.buckets), 0))]
        whole_chip = Reference.of(self.program.container, self.program.sensor, effects)
        for array, light, inner in self._arrays.values():
            if not len(inner):
                continue
            groups = Groups(whole_chip.groups.of_slot, array.lanes.astype(np.intp), array.places)
            reference = replace(whole_chip, groups=groups)
            scene = scene_of(self.program.container, light)
            for number in self._numbers(0):
                exposed = reference.expose(scene, SEED, self.device_seed, number, self.threads)
                by_place = exposed.exposure_e.reshape(len(exposed.exposure_e), -1)
                exposures.append(by_place[:, inner])
        return np.concatenate(exposures, axis=1)

    def _numbers(self, frame: int) -> range:
        """Return the frame numbers of the repeated exposures that stand for frame `frame`."""
        frames = self.sample.frames
        return range(frame * frames, (frame + 1) * frames)

    def _near_by_words(self, execution: Execution, frame: int) -> Values:
        """Return exposures by words of pixels near saturation. Neighbours' counts are taken from
        sums if these have the same counts."""
        known_counts = None
        if counts_agree(execution) and len(self.sample.places[self.sample.near_pixels]):
            summed = self._summed(execution.kept_effects, execution.requested_effects, "near")
            known_counts = []
            for number in self._numbers(frame):
                away = np.zeros((len(summed.chip.counted), self.program.array.lanes.size))
                away[:, summed.chip.array.places] = self._away(summed, number)
                known_counts.append(KnownCounts(summed.chip.counted, away))
        return self.by_words(execution.near_effects, self.sample.near_pixels, frame, known_counts)

    @cached_property
    def _arrays(self) -> dict[str, tuple[PixelArray, Light, NDArray[np.int64]]]:
        """For each region, "far" from saturation and "near" it: the array of tiles, its light, and
        the indices of the sampled pixels in this array."""
        sample, whole_array, shape = self.sample, self.program.array, self.light.shape
        near_places = sample.places[sample.near_pixels]
        near_places = near_places[sample.frame[sample.near_pixels] == 0]
        if not sample.side:
            return {
                "far": (whole_array, self.light, sample.inner),
                "near": (whole_array, self.light, near_places),
            }
        corners = np.stack(np.divmod(near_places, shape[1]), axis=1) - 1
        centers = _SIDE * len(near_places) + np.arange(len(near_places)) * _SIDE + 1
        arrays = {}
        for region, tiles, side, inner in (
            ("far", sample.corners, sample.side, sample.inner), ("near", corners, _SIDE, centers)
        ):  # fmt: skip
            places = tile_places(tiles, side, shape)
            arrays[region] = whole_array.at(places), light_at(self.light, places), inner
        return arrays

    @remembered
    def _summed(
        self, kept_effects: Selection, requested_effects: Selection, region: str
    ) -> SummedScene:
        array, light, _ = self._arrays[region]
        chip = SimulatedChip(self.program, array, self.device_seed, kept_effects, requested_effects)
        return SummedScene(chip, light, 1, self._sums)

    def _away(self, summed: SummedScene, frame: int) -> Values:
        """Return the deviations of a frame's photon counts from their means, cached for all sets of
        effects with the same rates."""
        effects = summed.chip.kept_effects.names(Counted, Echo, Response, Moving)
        key = summed.chip.array, frame, effects
        if key not in self._counts:
            self._counts[key] = summed.away(SEED, frame)
        return self._counts[key]

    @cached_property
    def _sums(self) -> dict[Hashable, tuple[Values, Values]]:
        return {}

    @cached_property
    def _counts(self) -> dict[Hashable, Values]:
        return {}
