"""The machine code of the loops: loaded from a file, or compiled with numba on first use.

    python -m nscc_runtime.emulator.compiled

compiles ahead (an installer's last step): some seconds once. Afterwards a process needs neither
numba nor a compiler (see `nscc_runtime.machine_code`); importing numba alone would cost more than
the whole capture.

The file lies in `__pycache__` beside this module or, where that cannot be written, in the user's
cache folder.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache
from pathlib import Path

from nscc_runtime import machine_code

ENTRY = "expose_block"
_PARAMETERS = 19
_SOURCES = ("loops.py", "steps.py")


@cache
def entry_point() -> Callable[..., None]:
    """`nscc_runtime.emulator.loops.expose_block` as machine code; takes 19 addresses."""
    return machine_code.load(object_code(folders()), {ENTRY: _PARAMETERS})[ENTRY]


def folders() -> tuple[Path, ...]:
    """Where the machine code may lie, best first."""
    return machine_code.folders(__file__)


def is_compiled() -> bool:
    """Whether the machine code is there: if not, its first use takes some seconds."""
    return machine_code.kept(_name(), folders()) is not None


def object_code(places: Sequence[Path]) -> bytes:
    """The object file: read from the first place that has it whole, else compiled and kept."""
    return machine_code.object_code(_name(), places, build)


def build() -> bytes:
    """Compile the loops to an object file for this machine's processor."""
    from nscc_runtime.emulator import loops

    return machine_code.build([(loops.expose_block, loops.SIGNATURE)])


def _name() -> str:
    return machine_code.name(ENTRY, [Path(__file__).with_name(source) for source in _SOURCES])


if __name__ == "__main__":
    entry_point()
