"""Plans so simple that everything is done in one go over the pixels.

They weigh the slots of a pixel 1 or 0: no effect on weights is kept, no crosstalk, no dark charge,
and no pixel needs a slot loop. Each open slot lies in one bucket.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects.crosstalk import CROSSTALK
from nscc_runtime.effects.dark import DARK
from nscc_runtime.effects.photodiode import FULL_WELL
from nscc_runtime.effects.photons import LIGHT, PRNU, SHOT
from nscc_runtime.effects.photons import count_key as key_of_counts
from nscc_runtime.effects.readout import ADC_NOISE
from nscc_runtime.effects.registers import ANALOG, LEAKAGE, REGISTER
from nscc_runtime.effects.timing import DEAD_TIME, DECAY
from nscc_runtime.frame_file import Frame
from nscc_runtime.light import Light
from nscc_runtime.loop import Bound
from nscc_runtime.noise import RATE_CAP, key
from nscc_runtime.plan.fused_loop import BLOCK, Simple, fused
from nscc_runtime.plan.masks import Masks
from nscc_runtime.plan.pool import in_parts
from nscc_runtime.plan.sums import on_frames
from nscc_runtime.reference.noise import SUM

if TYPE_CHECKING:
    from nscc_runtime.plan.capture import Planned
    from nscc_runtime.plan.program import Program

_COMPLEX = frozenset(effect.name for effect in (CROSSTALK, DARK, ANALOG, LEAKAGE, DEAD_TIME, DECAY))
_NO_TABLE, _NO_MASKS = np.zeros((1, 1), np.float32), np.zeros(1, np.uint8)
_MUCH = 1 << 21
"""Pixels x frames from which on a second thread is worth waking."""
_DRAWN_FRAMES = 32
"""What drawing numbers costs, in frames."""


@dataclass(frozen=True, eq=False)
class Fused:
    """A scene under a simple plan, laid out for the loop; everything but the keys of a frame."""

    scene: Planned
    frames: NDArray[np.float32]
    numbers: dict[str, float]
    buckets: tuple[Bound, ...]
    sources: tuple[tuple[int, int], ...]

    @classmethod
    def of(cls, scene: Planned) -> Fused | None:
        """None where the plan is not simple."""
        program, kept = scene.program, scene.plan.kept
        if (
            scene.plan.slot_loop == "all"
            or kept.on & _COMPLEX
            or program.tables.decays
            or program.overlapping
            or len(scene.saturating)
        ):
            return None
        source = scene.source
        frames = np.require(source.frames, np.float32, ["C", "A"]).reshape(len(source.frames), -1)
        sensor, target = program.sensor, program.container.target
        sigmas, sources = [], []
        for effect, sigma in program.noises:
            if effect in kept:
                factor = sigma * program.tables.noise(effect.name, scene.wanted)[0]
                for draw in range(factor.shape[2]):
                    if factor[:, :, draw].any():
                        sigmas.append(factor[:, :, draw])
                        sources.append((effect.stream, draw))
        shape = len(sigmas), len(program.container.encoding), len(program.container.buckets)
        sigma_e = np.array(sigmas).reshape(shape)
        single = program.tables.single(program.model(kept))
        limit_e = np.where(np.isnan(single), np.inf, single * sensor.full_well_e)
        response = scene.response if PRNU in kept else np.ones(1)
        numbers = {
            "factor": scene.factor,
            "rate_cap": RATE_CAP,
            "electrons_per_code": sensor.electrons_per_lsb,
            "offset": sensor.adc_offset_lsb,
            "top": 2.0**target.adc_bits - 1,
            "readout_noise": sensor.adc_noise_lsb,
        }
        buckets = tuple(
            fused.bound(
                frames=frames,
                lanes=program.lanes,
                response=response,
                limit=np.ascontiguousarray(limit_e[:, bucket]),
                sigma=np.ascontiguousarray(sigma_e[:, :, bucket]),
                **_layout(program, source, 1 << bucket),
            )
            for bucket in range(shape[2])
        )
        return cls(scene, frames, numbers, buckets, tuple(sources))

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
        scene, kept, loop = self.scene, self.scene.plan.kept, self.buckets[bucket]
        noise_keys = [key(seed, stream, SUM, frame, draw) for stream, draw in self.sources]
        count_key = readout_key = np.uint64(0)
        if SHOT in kept:
            count_key = key_of_counts(seed, SHOT, LIGHT, frame, 1 << bucket)
        if ADC_NOISE in kept:
            readout_key = key(seed, ADC_NOISE.stream, frame=frame, group=bucket)
        pixels = out[0].size
        given: dict[str, Any] = {
            **self.numbers,
            "pixels": pixels,
            "count": len(self.frames),
            "lane_count": len(scene.program.container.encoding),
            "sources": len(noise_keys),
            "uneven": PRNU in kept,
            "counted": SHOT in kept,
            "clipped": FULL_WELL in kept and REGISTER not in kept,
            "readout_noisy": ADC_NOISE in kept,
            "read_out": read_out,
            "count_key": count_key,
            "readout_key": readout_key,
        }
        exposure, codes, valid = out
        filled = {
            "noise_keys": np.array(noise_keys, np.uint64),
            "exposure": exposure.reshape(-1),
            "frame": codes.reshape(-1),
            "valid": valid.view(np.uint8).reshape(-1),
        }

        def run(begin: int, end: int) -> None:
            loop(plan=Simple(**given, begin=begin, end=end), **_scratch(), **filled)

        drawn = bool(noise_keys) or SHOT in kept or ADC_NOISE in kept
        work = pixels * (len(self.frames) + _DRAWN_FRAMES * drawn)
        in_parts(run, pixels, scene.threads if work >= _MUCH else 1, BLOCK)


def _scratch() -> dict[str, NDArray[Any]]:
    return {
        "part": np.empty(BLOCK, np.float32),
        "values": np.empty(BLOCK),
        "scratch": np.empty(4 * BLOCK),
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
