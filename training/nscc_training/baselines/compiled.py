"""The machine code of the loop: loaded from a file, or compiled with numba on first use.

    python -m nscc_training.baselines.compiled

compiles ahead (an installer's last step): some seconds once. See `nscc_runtime.machine_code`.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from pathlib import Path

from nscc_runtime import machine_code

ENTRY = "denoise"
_PARAMETERS = 7


@cache
def entry_point() -> Callable[..., None]:
    """`nscc_training.baselines.loops.denoise` as machine code; takes 7 addresses."""
    code = machine_code.object_code(_name(), machine_code.folders(__file__), _build)
    return machine_code.load(code, {ENTRY: _PARAMETERS})[ENTRY]


def is_compiled() -> bool:
    """Whether the machine code is there: if not, its first use takes some seconds."""
    return machine_code.kept(_name(), machine_code.folders(__file__)) is not None


def _build() -> bytes:
    from nscc_training.baselines import loops

    return machine_code.build([(loops.denoise, loops.SIGNATURE)])


def _name() -> str:
    return machine_code.name(ENTRY, [Path(__file__).with_name("loops.py")])


if __name__ == "__main__":
    entry_point()
