"""Frames of programs that look, by the compiled loop over paths: the reference's numbers, faster.

With the same effects and seeds, results equal those of `nscc_runtime.reference.looks` except for
rounding, and exactly without effects. `lacks` names the effects that only the reference supports.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property, partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.words.container import Container
from nscc_runtime.caches import remembered
from nscc_runtime.effects import CannotHave, Selection, everything
from nscc_runtime.effects.in_loops import device_keys, draws_keys
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.effects.views import Scene
from nscc_runtime.execution.layout import (
    LoopProgram,
    OnDevice,
    PixelState,
)
from nscc_runtime.execution.loop_words import (
    numbers_of,
    program_of,
    readouts_of,
    switches_of,
)
from nscc_runtime.interface import Executed, Exposure
from nscc_runtime.looking.path_loop import (
    BLOCK,
    BlockScratch,
    Charge,
    PathKeys,
    PathSizes,
    Segments,
    WordKeys,
    run_paths,
)
from nscc_runtime.looking.paths import Paths, paths_of
from nscc_runtime.pool import in_parts
from nscc_runtime.reference.charge import Fallen, charge_of_rows
from nscc_runtime.reference.looks import WORD_DRAWS, Intervals
from nscc_runtime.reference.trace import retention_us
from nscc_runtime.reference.words import most_destinations

Bits = NDArray[np.bool_]

_CELLS = 1 << 18
"""Number of intervals x pixels whose charge is computed at once, so that it stays in the cache."""
BEFORE_WORDS = {"scene", "light", "response", "count", "charge", "neighbours"}
"""Stages before the words of a frame: the reference computes the charge."""
_AFTER_WORDS = {"converter", "codes"}
"""Stages after the words of a frame: the reference computes the codes."""


@dataclass(frozen=True, eq=False)
class LookingProgram:
    """A program whose pixels look, on a sensor, prepared for any scene and effects."""

    container: Container
    sensor: Sensor

    @remembered
    def lacks(self, effects: Selection) -> tuple[str, ...]:
        """Return the reasons why only the reference supports these effects; empty if none."""
        reasons = [
            f"{effect.name}: only the reference has it ({effect.words.reason})"
            for effect in effects.effects
            if isinstance(effect.words, CannotHave)
            and not effect.reference.keys() <= BEFORE_WORDS | _AFTER_WORDS
        ]
        paths = self._paths(effects)
        if isinstance(paths, str):
            reasons.append(f"the words run one by one: {paths}")
        return tuple(reasons)

    @cached_property
    def fades(self) -> bool:
        """Whether a digital register may decay within a frame."""
        frame_us = float(sum(self.container.slot_us))
        return retention_us(everything(), self.sensor) < frame_us

    def expose(
        self,
        scene: Scene,
        loaded: Mapping[str, Bits],
        effects: Selection,
        seeds: tuple[int, int],
        frame: int,
        rows: range | None = None,
        threads: int = 1,
        fallen_in: Callable[[range], Fallen] | None = None,
        among: Bits | None = None,
    ) -> Executed:
        """Return a frame, or consecutive rows of it, like `LookingReference.expose`. Results do not
        depend on `threads`.

        `fallen_in`: returns the charge of rows; None to draw it. `among` (rows, cols): the pixels
        whose words run, None for all. The results of other pixels are meaningless. Raises
        ValueError if `lacks` returns reasons."""
        lacking, paths = self.lacks(effects), self._paths(effects)
        if lacking or isinstance(paths, str):
            raise ValueError("; ".join(lacking))
        begins = paths.begins(loaded, scene.light.shape)
        if among is not None:
            begins = np.where(among, begins, -1)  # these pixels have ended already
        intervals = Intervals.of(self.container, every_slot=effects.noiseless)
        pace = intervals.paced(scene, effects)
        rows = range(scene.light.shape[0]) if rows is None else rows
        fall = fallen_in or partial(
            charge_of_rows, intervals.joined(scene), None, self.sensor, effects, seeds, frame
        )
        shared: dict[str, Any] = {
            "switches": switches_of(self.container, effects),
            "numbers": numbers_of(self.container, self.sensor, effects),
            "device": OnDevice(**device_keys(OnDevice, seeds[1])),
            "keys": PathKeys(**draws_keys(PathKeys, seeds[0], WORD_DRAWS)),
            "program": self.loop_words(paths, intervals.starts),
            "segments": Segments(paths.start, paths.acting, paths.following),
            "readouts": readouts_of(self.container),
        }
        cols = scene.light.shape[1]
        shape = (len(self.container.buckets), len(rows), cols)
        exposure, saturated_by = np.empty(shape), np.empty(shape, np.uint8)
        valid, ends = np.empty(shape[1:], np.bool_), np.empty(shape[1:], np.int32)
        step = max(1, _CELLS // (len(intervals) * cols))

        def fill(first: int, stop: int) -> None:
            for top in range(first, stop, step):
                part_rows = rows[top : min(top + step, stop)]
                out_rows = slice(top, top + len(part_rows))
                of_array = slice(part_rows.start, part_rows.stop)
                fallen = fall(part_rows)
                charge = Charge(
                    np.require(fallen.charge.reshape(len(intervals), -1), np.float64, ["C"]),
                    np.require(pace(of_array, fallen.light), np.float64, ["C"]),
                )
                exposure[:, out_rows], saturated_by[:, out_rows], ends[out_rows] = self._loop(
                    shared, paths, charge, begins[of_array], part_rows.start * cols, frame
                )
                valid[out_rows] = fallen.valid

        in_parts(fill, len(rows), threads)
        endings = paths.endings.items()
        planes = {name: bits.astype(np.bool_)[ends] for name, bits in endings}
        is_valid = np.isfinite(exposure) & valid
        return Executed(Exposure(exposure, is_valid, saturated_by), planes)

    def _loop(
        self, shared: Mapping[str, Any], paths: Paths, charge: Charge,
        begins: NDArray[np.int64], first_place: int, frame: int,
    ) -> tuple[NDArray[Any], ...]:  # fmt: skip
        """Return exposures and saturation marks (buckets, rows, cols), and endings (rows, cols).
        `shared`: the arguments of the loop that do not depend on the rows."""
        container, pixels = self.container, begins.size
        sizes = PathSizes(
            pixels=pixels,
            first_place=first_place,
            intervals=len(charge.electrons),
            segments=len(paths.following),
            steps=len(paths.words),
            numbered=most_destinations(container.target),
            paces=charge.pace.shape[1],
            frame=frame,
        )
        out = np.empty((len(container.buckets), pixels))
        marked = np.empty(out.shape, np.uint8)
        ends = np.empty(pixels, np.int32)
        run_paths(
            **shared, sizes=sizes, begins=begins.reshape(-1), charge=charge, out=out, marked=marked,
            ends=ends,
            of_word=WordKeys(
                reads=np.empty(sizes.steps, np.uint64),
                resets=np.empty(sizes.steps, np.uint64),
                compares=np.empty(sizes.steps, np.uint64),
                words=np.empty(sizes.steps * sizes.numbered, np.uint64),
            ),
            block=BlockScratch(
                head=np.full(sizes.segments, -1, np.int64), behind=np.empty(BLOCK, np.int64),
                reached=np.empty(BLOCK, np.int64), fallen_fraction=np.empty(BLOCK),
                normals=np.empty((1 + sizes.numbered) * BLOCK),
            ),
            state=PixelState.of(len(container.target.analog_registers), BLOCK),
        )  # fmt: skip
        shape = (len(out), *begins.shape)
        return out.reshape(shape), marked.reshape(shape), ends.reshape(begins.shape)

    def _paths(self, effects: Selection) -> Paths | str:
        """Return the paths under `effects`, or the reason why they cannot be found."""
        return paths_of(self.container, retention_us(effects, self.sensor))

    @remembered
    def loop_words(self, paths: Paths, starts: tuple[int, ...]) -> LoopProgram:
        """Return the words for the loop; `starts` are the first slots of the intervals."""
        return program_of(self.container, paths.words, starts)
