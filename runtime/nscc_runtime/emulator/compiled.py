"""The machine code of the loops: loaded from a file, or compiled with numba on first use.

    python -m nscc_runtime.emulator.compiled

compiles ahead (an installer's last step): some seconds once. Afterwards a process needs neither
numba nor a compiler (see `nscc_runtime.machine_code`); importing numba alone would cost more than
the whole capture.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

from nscc_runtime.machine_code import Loops

_SOURCES = ("loops.py", "steps.py")


def _listed() -> Iterator[tuple[Callable[..., None], str]]:
    from nscc_runtime.emulator import loops

    yield loops.expose_block, loops.SIGNATURE


LOOPS = Loops(
    "expose_block",
    __file__,
    [Path(__file__).with_name(source) for source in _SOURCES],
    {"expose_block": 19},
    _listed,
)
is_compiled = LOOPS.is_compiled


def entry_point() -> Callable[..., None]:
    """`nscc_runtime.emulator.loops.expose_block` as machine code; takes 19 addresses."""
    return LOOPS.entry_points()["expose_block"]


if __name__ == "__main__":
    entry_point()
