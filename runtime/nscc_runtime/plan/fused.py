"""Plans so simple that everything is done in one go over the pixels.

They weigh the slots of a pixel 1 or 0: all effects that are kept declare that this loop has them,
and no pixel needs a slot loop. Each open slot lies in one bucket.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects import CannotHave
from nscc_runtime.effects.counts import LIGHT, count_key
from nscc_runtime.effects.parts import Converter, CountedLight, Soft, Well
from nscc_runtime.frame_file import Frame
from nscc_runtime.light import Light
from nscc_runtime.noise import RATE_CAP, key
from nscc_runtime.plan.layout import FUSED_BLOCK
from nscc_runtime.plan.masks import Masks
from nscc_runtime.plan.pool import in_parts
from nscc_runtime.plan.prepared import Prepared
from nscc_runtime.plan.program import Program
from nscc_runtime.plan.sums import on_frames
from nscc_runtime.reference.noise import SUM

_NO_TABLE, _NO_MASKS = np.zeros((1, 1), np.float32), np.zeros(1, np.uint8)
_SCRATCH = tuple(8 * FUSED_BLOCK * start for start in (0, 1, 2, 6, 7))
_SCRATCH_BYTES = 8 * FUSED_BLOCK * 8
"""Rows of the loop's scratch, in the order of its parameters; one has four of them."""
_MUCH = 1 << 21
"""Pixels x frames from which on a second thread is worth waking."""
_DRAWN_FRAMES = 32
"""What drawing numbers costs, in frames."""


@dataclass(frozen=True, eq=False)
class Fused:
    """A scene under a simple plan, laid out for the loop; everything but the keys of a frame.

    Streams of what counts light, with their draws of what is added as noise, and of the converter.
    """

    scene: Prepared
    frames: NDArray[np.float32]
    numbers: NDArray[np.float64]
    buckets: tuple[tuple[NDArray[Any], ...], ...]
    counters: list[int]
    sources: tuple[tuple[int, int], ...]
    read_by: list[int]
    switches: tuple[int, ...]

    @classmethod
    def of(cls, scene: Prepared) -> Fused | None:
        """None where the plan is not simple."""
        program, kept = scene.program, scene.kept
        if (
            scene.plan.slot_loop in ("all", "reference")
            or any(isinstance(effect.fused, CannotHave) for effect in kept.effects)
            or program.tables.decays
            or program.overlapping
            or len(scene.saturating)
        ):
            return None
        source = scene.source
        frames = np.require(source.frames, np.float32, ["C", "A"]).reshape(len(source.frames), -1)
        sensor, target = program.sensor, program.container.target
        sigmas, sources = [], []
        for effect, part in kept.errors():
            factor = part.sigma_e(sensor) * program.tables.noise(part.at, scene.wanted)[0]
            for draw in range(factor.shape[2]):
                if factor[:, :, draw].any():
                    sigmas.append(factor[:, :, draw])
                    sources.append((effect.stream, draw))
        shape = len(sigmas), len(program.container.encoding), len(program.container.buckets)
        sigma_e = np.array(sigmas).reshape(shape)
        limit_e = np.full(shape[1:], np.inf)
        clips = kept.part(Well) is not None and kept.part(Soft) is None
        if clips:
            single = program.tables.single(program.model(kept))
            limit_e = np.where(np.isnan(single), np.inf, single * scene.full_e)
        response = np.ones(1) if scene.response is None else scene.response
        converters = kept.having(Converter)
        numbers = [
            scene.factor, RATE_CAP, sensor.electrons_per_lsb, sensor.adc_offset_lsb,
            2.0**target.adc_bits - 1, *(part.sigma_lsb(sensor) for _, part in converters), 0.0,
        ]  # fmt: skip
        buckets = tuple(
            (
                *_layout(program, source, 1 << bucket),
                program.lanes,
                response,
                np.ascontiguousarray(limit_e[:, bucket]),
                np.ascontiguousarray(sigma_e[:, :, bucket]),
            )
            for bucket in range(shape[2])
        )
        counters = [effect.stream for effect, _ in kept.having(CountedLight)]
        switches = (
            int(scene.response is not None), len(counters), int(clips), len(sources),
            len(converters),
        )  # fmt: skip
        read_by = [effect.stream for effect, _ in converters]
        return cls(
            scene, frames, np.array(numbers), buckets, counters, tuple(sources), read_by, switches
        )

    @cached_property
    def addresses(self) -> tuple[tuple[int, ...], ...]:
        """The addresses of the arrays that the loop reads, in each bucket."""
        return tuple(
            tuple(_address(array) for array in (self.frames, *arrays)) for arrays in self.buckets
        )

    def expose(self, seed: int, frame: int, *, read_out: bool) -> Frame:
        """Frame number `frame`; without `read_out` its codes are left 0."""

        shape = (len(self.buckets), *self.scene.light.shape)
        exposure = np.empty(shape)
        codes, valid = np.zeros(shape, np.uint8), np.ones(shape, np.bool_)
        for bucket in range(len(self.buckets)):
            self._fill(
                bucket, seed, frame, read_out, (exposure[bucket], codes[bucket], valid[bucket])
            )
        return Frame(codes, exposure, valid)

    def _fill(
        self,
        bucket: int,
        seed: int,
        frame: int,
        read_out: bool,
        out: tuple[NDArray[np.float64], NDArray[np.uint8], NDArray[np.bool_]],
    ) -> None:
        """Expose one bucket into `out`: exposures, codes, and whether they are numbers."""
        from nscc_runtime.plan.compiled import entry_points

        scene, loop = self.scene, entry_points()["fused"]
        keys = [count_key(seed, each, LIGHT, frame, 1 << bucket) for each in self.counters]
        keys = keys or [np.uint64(0)]
        keys += [key(seed, stream, SUM, frame, draw) for stream, draw in self.sources]
        keys += [key(seed, stream, frame=frame, group=bucket) for stream in self.read_by]
        pixels, count = out[0].size, len(self.frames)
        lanes = len(scene.program.container.encoding)
        switches = *self.switches, int(read_out)
        words = np.array(keys, np.uint64)
        given = (_address(self.numbers), _address(words), *self.addresses[bucket])
        filled = [_address(array) for array in out]

        def run(begin: int, end: int) -> None:
            sizes = np.array([pixels, begin, end, count, lanes, *switches], np.int64)
            scratch = np.empty(_SCRATCH_BYTES, np.uint8)
            at = _address(scratch)
            loop(_address(sizes), *given, *(at + start for start in _SCRATCH), *filled)

        drawn = len(keys) > 1 or bool(self.counters)
        work = pixels * (count + _DRAWN_FRAMES * drawn)
        in_parts(run, pixels, scene.threads if work >= _MUCH else 1, FUSED_BLOCK)


def _address(array: NDArray[Any]) -> int:
    """Where an array begins."""
    return int(array.__array_interface__["data"][0])


def _layout(program: Program, light: Light, group: int) -> tuple[NDArray[Any], ...]:
    """What becomes of each frame of a light in a group of slots: kinds, weights, rows of masks,
    masks, table.
    """
    masks = program.masks(group)
    if light.in_order and masks is not None:
        return masks.kinds, light.weight.astype(np.float32), masks.rows, masks.planes, _NO_TABLE
    table = np.ascontiguousarray(on_frames(light, program.members(group)), np.float32)
    count = len(light.frames)
    kinds = np.full(count, Masks.TABLED, np.int64)
    return kinds, np.ones(count, np.float32), np.zeros(count, np.int64), _NO_MASKS, table
