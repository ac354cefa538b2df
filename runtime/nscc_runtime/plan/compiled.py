"""The machine code of a plan's loops: loaded from a file, or compiled with numba on first use.

    python -m nscc_runtime.plan.compiled

compiles ahead (an installer's last step): some seconds once. See `nscc_runtime.machine_code`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

from nscc_runtime import noise
from nscc_runtime.machine_code import Loops
from nscc_runtime.noise.compiled import SOURCES as NOISE_SOURCES

_SOURCES = (
    "layout.py",
    "masks.py",
    "charge_loop.py",
    "pixel_loop.py",
    "sum_loop.py",
    "fused_loop.py",
)


def _listed() -> Iterator[tuple[Callable[..., None], str]]:
    from nscc_runtime.plan import fused_loop, pixel_loop, sum_loop

    yield pixel_loop.run_pixels, pixel_loop.SIGNATURE
    yield sum_loop.weighted_sums, sum_loop.SIGNATURES["weighted_sums"]
    yield sum_loop.smeared_frames, sum_loop.SIGNATURES["smeared_frames"]
    yield fused_loop.fused, fused_loop.SIGNATURE


LOOPS = Loops(
    "plan",
    __file__,
    [
        *(Path(__file__).with_name(source) for source in _SOURCES),
        *(Path(noise.__file__).with_name(source) for source in NOISE_SOURCES),
    ],
    {"run_pixels": 29, "weighted_sums": 5, "smeared_frames": 5, "fused": 21},
    _listed,
)
entry_points, is_compiled = LOOPS.entry_points, LOOPS.is_compiled


if __name__ == "__main__":
    entry_points()
