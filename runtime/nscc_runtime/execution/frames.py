"""Expose frames of a scene by sums (with pixels near saturation by words), by words, or by the
reference.

Random numbers are those of the reference (`nscc_runtime.effects`). Frames differ from the reference
only by dropped effects and by the approximations of sums."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects import Selection
from nscc_runtime.effects.parts import Counted, Saturates
from nscc_runtime.emulator.capture import check_size
from nscc_runtime.execution.chip import SimulatedChip, chip_of
from nscc_runtime.execution.near_saturation import near_saturation
from nscc_runtime.execution.pixels import KnownCounts, Running
from nscc_runtime.execution.program import AnalysedProgram
from nscc_runtime.execution.summed import LoopConverter, SummedScene
from nscc_runtime.frame_file import Frame, check_adc, converted
from nscc_runtime.interface import Exposure
from nscc_runtime.light import Light
from nscc_runtime.pool import threads_of
from nscc_runtime.reference.capture import Reference, scene_of

Values = NDArray[np.float64]
Marked = NDArray[np.uint8]
Path = Literal["sums", "words", "reference"]


@dataclass(frozen=True)
class Execution:
    """How a frame is exposed, and with which effects.

    Attributes
    ----------
    path : {"sums", "words", "reference"}
        "sums": weighted sums over slots, except that pixels near saturation run through their
        words. "words": all pixels run through their words. "reference": slot by slot.
    kept_effects : Selection
        The effects that are simulated.
    near_effects : Selection
        The effects that are simulated for pixels near saturation on the path "sums". If
        `kept_effects` contains no effect that saturates, no pixel runs through its words.
    requested_effects : Selection
        All effects that the user did not force off. They decide which pixels are near saturation,
        and the weights of the noise of words.
    exact : bool
        Whether pixels near saturation draw counts and split them between slots like the reference.
        Otherwise they use the counts of sums.
    """

    path: Path
    kept_effects: Selection
    near_effects: Selection
    requested_effects: Selection
    exact: bool = False


@dataclass(frozen=True, eq=False)
class ExecutedScene:
    """A program and a light on one chip, exposed frame by frame. `threads`: number of threads;
    results do not depend on it."""

    program: AnalysedProgram
    light: Light
    execution: Execution
    device_seed: int
    threads: int

    @cached_property
    def chip(self) -> SimulatedChip:
        """The simulated chip."""
        execution = self.execution
        return chip_of(
            self.program, self.device_seed, execution.kept_effects, execution.requested_effects
        )

    def expose(self, seed: int, frame: int) -> Exposure:
        """Return the exposure of frame number `frame`, before the converter."""
        if self.execution.path == "reference":
            scene = scene_of(self.program.container, self.light)
            return self._reference.expose(scene, seed, self.device_seed, frame, self.threads)
        return self._exposure(*self._exposed(seed, frame))

    def frame(self, seed: int, frame: int) -> Frame:
        """Return frame number `frame` with converter codes."""
        if self.execution.path == "reference":
            return self._converted(self.expose(seed, frame), seed, frame)
        return self._read_out(*self._exposed(seed, frame), seed, frame)

    def frames(self, seed: int, count: int) -> Iterator[Frame]:
        """Yield frames 0 to `count` - 1 with converter codes. Raises ValueError if `count` < 1."""
        if count < 1:
            raise ValueError(f"{count} frames")
        check_adc(self.program.container.target)
        yield from (self.frame(seed, number) for number in range(count))

    @cached_property
    def summed(self) -> SummedScene:
        """The scene, simulated by weighted sums."""
        return SummedScene(self.chip, self.light, self.threads)

    def _exposed(self, seed: int, frame: int) -> tuple[Values, Marked]:
        """Return exposures (buckets, pixels) and saturation marks, computed by sums or by words."""
        if self.execution.path == "words":
            return self._all_by_words.expose(seed, frame)
        away = self.summed.away(seed, frame)
        exposure = self.summed.expose(seed, frame, away)
        marked = np.zeros(exposure.shape, np.uint8)
        if self._near_saturation is not None:
            self._run_near(exposure, marked, away, seed, frame)
        return exposure, marked

    def _run_near(
        self, exposure: Values, marked: Marked, away: Values, seed: int, frame: int
    ) -> None:
        """Replace the exposures of pixels near saturation by the results of their words.
        Neighbours' counts are taken from sums if `counts_agree`."""
        assert self._near_saturation is not None
        running, places = self._near_saturation, self._near_saturation.chosen
        known_counts = (
            KnownCounts(self.chip.counted, away) if counts_agree(self.execution) else None
        )
        exposure[:, places], marked[:, places] = running.expose(seed, frame, known_counts)

    @cached_property
    def _near_saturation(self) -> Running | None:
        near_places = near_pixels(self.program, self.light, self.device_seed, self.execution)
        if not len(near_places):
            return None
        wired = self.program.wired(self.execution.near_effects, self.device_seed)
        return Running(wired, self.light, near_places, self.threads)

    @cached_property
    def _all_by_words(self) -> Running:
        wired = self.program.wired(self.execution.kept_effects, self.device_seed)
        return Running(wired, self.light, self.program.array.places, self.threads)

    def _exposure(self, exposure: Values, marked: Marked) -> Exposure:
        shape = len(exposure), *self.light.shape
        valid = np.isfinite(exposure)
        return Exposure(exposure.reshape(shape), valid.reshape(shape), marked.reshape(shape))

    def _read_out(self, exposure: Values, marked: Marked, seed: int, frame: int) -> Frame:
        readout = self.chip.compute_once(LoopConverter.of)
        if readout is None:
            return self._converted(self._exposure(exposure, marked), seed, frame)
        return readout.frame(exposure, marked, self.light.shape, (seed, frame), self.threads)

    def _converted(self, exposure: Exposure, seed: int, frame: int) -> Frame:
        target, seeds = self.program.container.target, (seed, self.device_seed)
        kept_effects = self.execution.kept_effects
        return converted(exposure, target, self.program.sensor, kept_effects, seeds, frame)

    @cached_property
    def _reference(self) -> Reference:
        return Reference.of(
            self.program.container, self.program.sensor, self.execution.kept_effects
        )


def near_pixels(
    program: AnalysedProgram, light: Light, device_seed: int, execution: Execution
) -> NDArray[np.int64]:
    """Return the places (row * cols + col) of the pixels that run through their words on the path
    "sums"; empty on other paths."""
    if execution.path != "sums" or not execution.kept_effects.names(Saturates):
        return np.empty(0, np.int64)
    return near_saturation(program, light, device_seed, execution.requested_effects).places


def counts_agree(execution: Execution) -> bool:
    """Return whether sums and words draw equal counts, so that words can use the counts of sums."""
    counted = (
        effects.names(Counted) for effects in (execution.kept_effects, execution.near_effects)
    )
    return not execution.exact and len({*counted}) == 1


def executed(
    program: AnalysedProgram,
    light: Light,
    execution: Execution,
    *,
    device_seed: int = 0,
    threads: int | None = None,
) -> ExecutedScene:
    """Return a scene to be exposed frame by frame. Raises Rejected if light and program do not fit,
    like `nscc_runtime.emulator.expose`."""
    check_size(program.container, light)
    return ExecutedScene(program, light, execution, device_seed, threads_of(threads))
