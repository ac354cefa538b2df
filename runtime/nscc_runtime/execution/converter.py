"""Converter codes of exposures, by the compiled loop."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.chips.target import Target
from nscc_runtime.effects import Selection
from nscc_runtime.effects.parts import Codes, Converter
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.execution.block_draws import BLOCK
from nscc_runtime.execution.frame_loop import Reading, convert
from nscc_runtime.frame_file import Frame
from nscc_runtime.noise import key
from nscc_runtime.pool import in_parts

Values = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class FastConverter:
    """The converter as a compiled loop. `figures`: its parameters. `stream`: random stream of its
    noise, 0 without noise."""

    figures: dict[str, Any]
    stream: int

    @classmethod
    def of(cls, target: Target, sensor: Sensor, kept_effects: Selection) -> FastConverter | None:
        """Return the converter of a chip; None if other effects act after the exposure."""
        converters, codes = kept_effects.having(Converter), kept_effects.having(Codes)
        known = {effect.name for effect, _ in (*converters, *codes)}
        after = {e.name for at in ("converter", "codes") for e, _ in kept_effects.acting(at)}
        if not after <= known:
            return None
        mark = kept_effects.marking("codes")
        ((_, code),) = codes
        figures = {
            "noisy": len(converters),
            "last_bit": mark.bit if mark else 0,
            "electrons_per_code": code.electrons(sensor),
            "offset": code.offset(sensor),
            "top": float(target.top_code),
            "readout_noise": kept_effects.converter_lsb(sensor),
        }
        stream = converters[0][0].stream if converters else 0
        return cls(figures, stream)

    def frame(
        self, values: Values, marked: NDArray[np.uint8], shape: tuple[int, int],
        seed_and_number: tuple[int, int], threads: int,
    ) -> Frame:  # fmt: skip
        """Convert exposures (buckets, pixels) to a frame; add marks of codes to `marked`."""
        (buckets, pixels), (seed, number) = values.shape, seed_and_number
        frame, valid = np.empty(values.shape, np.uint8), np.empty(values.shape, np.bool_)
        keys = [key(seed, self.stream, frame=number, group=bucket) for bucket in range(buckets)]

        def run(begin: int, end: int) -> None:
            convert(
                reading=Reading(
                    begin=begin, end=end, pixels=pixels, buckets=buckets, **self.figures
                ),
                keys=np.array(keys, np.uint64),
                places=np.arange(pixels, dtype=np.int64),
                exposure=values,
                scratch=np.empty(BLOCK),
                frame=frame,
                valid=valid.view(np.uint8),
                marked=marked,
            )  # fmt: skip

        in_parts(run, pixels, threads, BLOCK)
        whole = buckets, *shape
        return Frame(
            frame.reshape(whole), values.reshape(whole), valid.reshape(whole), marked.reshape(whole)
        )
