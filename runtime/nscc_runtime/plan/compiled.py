"""The machine code of a plan's loops: loaded from a file, or compiled with numba on first use.

    python -m nscc_runtime.plan.compiled

compiles ahead (an installer's last step): some seconds once. See `nscc_runtime.machine_code`.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from pathlib import Path

from nscc_runtime import machine_code, noise
from nscc_runtime.noise.compiled import SOURCES as NOISE_SOURCES

PARAMETERS = {"run_pixels": 29, "weighted_sums": 5, "smeared_frames": 5, "fused": 21}
"""The loops, with how many addresses each takes."""

_SOURCES = (
    "layout.py",
    "masks.py",
    "charge_loop.py",
    "pixel_loop.py",
    "sum_loop.py",
    "fused_loop.py",
)


@cache
def entry_points() -> dict[str, Callable[..., None]]:
    """The loops as machine code, by name."""
    code = machine_code.object_code(_name(), machine_code.folders(__file__), _build)
    return machine_code.load(code, PARAMETERS)


def is_compiled() -> bool:
    """Whether the machine code is there: if not, its first use takes some seconds."""
    return machine_code.kept(_name(), machine_code.folders(__file__)) is not None


def _build() -> bytes:
    from nscc_runtime.plan import fused_loop, pixel_loop, sum_loop

    return machine_code.build(
        [
            (pixel_loop.run_pixels, pixel_loop.SIGNATURE),
            (sum_loop.weighted_sums, sum_loop.SIGNATURES["weighted_sums"]),
            (sum_loop.smeared_frames, sum_loop.SIGNATURES["smeared_frames"]),
            (fused_loop.fused, fused_loop.SIGNATURE),
        ]
    )


def _name() -> str:
    here, there = Path(__file__).parent, Path(noise.__file__).parent
    sources = [*(here / name for name in _SOURCES), *(there / name for name in NOISE_SOURCES)]
    return machine_code.name("plan", sources)


if __name__ == "__main__":
    entry_points()
