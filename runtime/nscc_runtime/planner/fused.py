"""Plans so simple that everything is done in one go over the pixels.

The open slots of a pixel have one weight: all effects that are kept declare that this loop has
them, and no pixel needs a slot loop. Each open slot lies in one bucket.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects import CannotHave
from nscc_runtime.effects.counts import LIGHT, count_key
from nscc_runtime.effects.parts import Codes, Converter, CountedLight, Soft, Well, WordGain
from nscc_runtime.frame_file import Frame, last_codes
from nscc_runtime.light import Light
from nscc_runtime.loop import Bound
from nscc_runtime.noise import RATE_CAP, key
from nscc_runtime.planner.chip import Chip
from nscc_runtime.planner.drawn import BLOCK, ROOM
from nscc_runtime.planner.fused_loop import Simple, fused
from nscc_runtime.planner.masks import Masks
from nscc_runtime.planner.prepared import Prepared
from nscc_runtime.planner.program import Program
from nscc_runtime.planner.sums import on_frames
from nscc_runtime.planner.weighing import ROUNDING, Weighing
from nscc_runtime.pool import in_parts
from nscc_runtime.reference.noise import SUM

_NO_TABLE, _NO_MASKS = np.zeros((1, 1), np.float32), np.zeros(1, np.uint8)
_NO_FACTORS = np.ones(1)
_MUCH = 1 << 21
"""Pixels x frames from which on a second thread is worth waking."""
_DRAWN_FRAMES = 32
"""What drawing numbers costs, in frames."""


@dataclass(frozen=True, eq=False)
class Kit:
    """What scenes under simple plans have in common: figures, and arrays of each bucket.

    `counter` and `converter` are the streams of what counts light and of the converter's noise, 0
    where there is none; `sources` those of what is added as noise, with their draws.
    """

    given: dict[str, float]
    arrays: tuple[dict[str, NDArray[Any]], ...]
    counter: int
    converter: int
    sources: tuple[tuple[int, int], ...]

    @classmethod
    def of(cls, chip: Chip) -> Kit | None:
        """None where an effect is kept that the loop has not."""
        program, kept = chip.program, chip.kept
        gain = program.even_weights(program.model(kept))
        if (
            any(isinstance(effect.fused, CannotHave) for effect in kept.effects)
            or program.tables.decays
            or program.overlapping
            or gain is None
        ):
            return None
        sensor, target = program.sensor, program.container.target
        sources, sigma_e = Weighing(chip, ()).noise
        limit_e = np.full(gain.shape, np.inf)
        clipped = kept.part(Well) is not None and kept.part(Soft) is None
        if clipped:
            single = program.tables.single(program.model(kept))
            limit_e = np.where(np.isnan(single), np.inf, single * chip.full_e)
        counters, converters = kept.having(CountedLight), kept.having(Converter)
        codes, mark = kept.part(Codes), kept.marking("well")
        patterned = kept.part(WordGain) is not None
        given = {
            "factor": chip.factor,
            "rate_cap": RATE_CAP,
            "electrons_per_code": codes.electrons(sensor) if codes else 1.0,
            "offset": codes.offset(sensor) if codes else 0.0,
            "top": float(target.top_code),
            "readout_noise": kept.converter_lsb(sensor),
            "lane_count": len(gain),
            "sources": len(sources),
            "uneven": chip.response is not None,
            "counted": len(counters),
            "clipped": clipped,
            "patterned": patterned,
            "well_bit": mark.bit if mark else 0,
            "full": 1.0 + ROUNDING,
            "readout_noisy": len(converters),
        }
        arrays = tuple(
            {
                "response": _NO_FACTORS if chip.response is None else chip.response,
                "gain": np.ascontiguousarray(gain[:, bucket]),
                "limit": np.ascontiguousarray(limit_e[:, bucket]),
                "pattern": chip.patterns[bucket] if patterned else _NO_FACTORS,
                "sigma": np.ascontiguousarray(sigma_e[:, bucket]),
            }
            for bucket in range(gain.shape[1])
        )
        counter, converter = (each[0][0].stream if each else 0 for each in (counters, converters))
        return cls(given, arrays, counter, converter, tuple(sources))


@dataclass(frozen=True, eq=False)
class Fused:
    """A scene's light under a simple plan, laid out for the loop; everything but the keys of a
    frame."""

    program: Program
    light: Light
    threads: int
    kit: Kit
    buckets: tuple[Bound, ...]

    @classmethod
    def of(cls, scene: Prepared) -> Fused | None:
        """None where the plan is not simple."""
        if scene.plan.slot_loop in ("all", "reference"):
            return None
        kit = scene.chip.own(Kit.of)
        if kit is None or len(scene.saturating):
            return None
        program, source = scene.program, scene.source
        frames = np.require(source.ended, np.float32, ["C", "A"]).reshape(len(source.frames), -1)
        buckets = tuple(
            fused.bound(
                frames=frames, lanes=program.lanes, **arrays,
                **_layout(program, source, 1 << bucket),
            )
            for bucket, arrays in enumerate(kit.arrays)
        )  # fmt: skip
        return cls(program, source, scene.threads, kit, buckets)

    def expose(self, seed: int, frame: int, *, read_out: bool) -> Frame:
        """Frame number `frame`; without `read_out` its codes are left 0."""
        shape = (len(self.buckets), *self.light.shape)
        found = Frame(
            np.zeros(shape, np.uint8), np.empty(shape), np.ones(shape, np.bool_),
            np.zeros(shape, np.uint8),
        )  # fmt: skip
        for bucket in range(len(self.buckets)):
            self._fill(found, bucket, seed, frame, read_out)
        if read_out:
            target = self.program.container.target
            np.bitwise_or(found.saturated_by, last_codes(found.frame, target), found.saturated_by)
        return found

    def _fill(self, found: Frame, bucket: int, seed: int, frame: int, read_out: bool) -> None:
        """Expose one bucket."""
        kit = self.kit
        noise_keys = [key(seed, stream, SUM, frame, draw) for stream, draw in kit.sources]
        pixels = found.exposure_e[bucket].size
        given: dict[str, Any] = {
            **kit.given,
            "count": len(self.light.frames),
            "pixels": pixels,
            "read_out": read_out,
            # Without what counts, and without noise of the converter, nobody asks for these.
            "count_key": count_key(seed, kit.counter, LIGHT, frame, 1 << bucket),
            "readout_key": key(seed, kit.converter, frame=frame, group=bucket),
        }
        filled = {
            "noise_keys": np.array(noise_keys, np.uint64),
            "exposure": found.exposure_e[bucket].reshape(-1),
            "frame": found.frame[bucket].reshape(-1),
            "valid": found.valid[bucket].view(np.uint8).reshape(-1),
            "marked": found.saturated_by[bucket].reshape(-1),
        }

        def run(begin: int, end: int) -> None:
            loop = self.buckets[bucket]
            loop(plan=Simple(**given, begin=begin, end=end), **_scratch(), **filled)

        drawn = bool(noise_keys or kit.counter or kit.converter)
        work = pixels * (given["count"] + _DRAWN_FRAMES * drawn)
        in_parts(run, pixels, self.threads if work >= _MUCH else 1, BLOCK)


def _scratch() -> dict[str, NDArray[Any]]:
    return {
        "part": np.empty(BLOCK, np.float32),
        "values": np.empty(BLOCK),
        "scratch": np.empty(ROOM),
        "few": np.empty(BLOCK),
        "places": np.empty(BLOCK, np.int64),
    }


def _layout(program: Program, light: Light, group: int) -> dict[str, NDArray[Any]]:
    """What becomes of each frame of a light in a group of slots."""
    masks = program.masks(group)
    if light.in_order and masks is not None:
        return {
            "kinds": masks.kinds,
            "frame_weight": light.weight.astype(np.float32),
            "mask_row": masks.rows,
            "masks": masks.planes,
            "table": _NO_TABLE,
        }
    count = len(light.frames)
    return {
        "kinds": np.full(count, Masks.TABLED, np.int64),
        "frame_weight": np.ones(count, np.float32),
        "mask_row": np.zeros(count, np.int64),
        "masks": _NO_MASKS,
        "table": np.ascontiguousarray(on_frames(light, program.members(group)), np.float32),
    }
