"""The machine code of the loops: loaded from a file, or compiled with numba on first use.

    python -m nscc_runtime.noise.compiled

compiles ahead (an installer's last step): some seconds once. See `nscc_runtime.machine_code`.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from pathlib import Path

from nscc_runtime import machine_code

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


@cache
def entry_points() -> dict[str, Callable[..., None]]:
    """The loops as machine code, by name."""
    code = machine_code.object_code(_name(), machine_code.folders(__file__), _build)
    return machine_code.load(code, PARAMETERS)


def is_compiled() -> bool:
    """Whether the machine code is there: if not, its first use takes some seconds."""
    return machine_code.kept(_name(), machine_code.folders(__file__)) is not None


def _build() -> bytes:
    from nscc_runtime.noise import loops

    return machine_code.build(
        (getattr(loops, name), signature) for name, signature in loops.SIGNATURES.items()
    )


def _name() -> str:
    return machine_code.name("noise", [Path(__file__).with_name(source) for source in SOURCES])


if __name__ == "__main__":
    entry_points()
