"""The machine code of the loops: loaded from a file, or compiled with numba on first use.

    python -m nscc_runtime.noise.compiled

compiles ahead (an installer's last step): some seconds once. See `nscc_runtime.machine_code`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

from nscc_runtime.machine_code import Loops

PARAMETERS = {"fill_uniforms": 4, "fill_normals": 4, "fill_poisson": 7, "fill_thin": 6}
"""The loops of `nscc_runtime.noise.loops`, with how many addresses each takes."""

SOURCES = (
    "counter.py",
    "gaussian.py",
    "gaussian_fast.py",
    "poisson_law.py",
    "binomial_law.py",
    "loops.py",
)
"""What the machine code depends on."""


def _listed() -> Iterator[tuple[Callable[..., None], str]]:
    from nscc_runtime.noise import loops

    for name, signature in loops.SIGNATURES.items():
        yield getattr(loops, name), signature


LOOPS = Loops(
    "noise", __file__, [Path(__file__).with_name(name) for name in SOURCES], PARAMETERS, _listed
)
entry_points, is_compiled = LOOPS.entry_points, LOOPS.is_compiled


if __name__ == "__main__":
    entry_points()
