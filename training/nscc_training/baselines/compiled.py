"""The machine code of the loop: loaded from a file, or compiled with numba on first use.

    python -m nscc_training.baselines.compiled

compiles ahead (an installer's last step): some seconds once. See `nscc_runtime.machine_code`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

from nscc_runtime.machine_code import Loops


def _listed() -> Iterator[tuple[Callable[..., None], str]]:
    from nscc_training.baselines import loops

    yield loops.denoise, loops.SIGNATURE


LOOPS = Loops("denoise", __file__, [Path(__file__).with_name("loops.py")], {"denoise": 7}, _listed)
is_compiled = LOOPS.is_compiled


def entry_point() -> Callable[..., None]:
    """`nscc_training.baselines.loops.denoise` as machine code; takes 7 addresses."""
    return LOOPS.entry_points()["denoise"]


if __name__ == "__main__":
    entry_point()
