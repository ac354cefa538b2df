"""nscc compiles per-pixel shutter programs for SCAMP-5 class vision chips.

    import nscc

    p = nscc.compile("examples/hdr_2x2.nsl")
    p.shutters()  # bool (buckets, codes, slots)

`docs/python.md` documents the Python interface. This package is the compiler. It needs lark,
networkx and numpy, and does not import nscc_runtime, nscc_training or nscc_cli."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from nscc.lazy import attribute
from nscc.version import __version__

if TYPE_CHECKING:
    from nscc.cell_magic import load_ipython_extension
    from nscc.chips.target import Target
    from nscc.diagnostics.diagnostic import Diagnostic, Rejected
    from nscc.shutter_program import ShutterProgram, compile, load

_NAMES = {
    "cell_magic": ("load_ipython_extension",),
    "diagnostics.diagnostic": ("Diagnostic", "Rejected"),
    "shutter_program": ("ShutterProgram", "compile", "load"),
    "chips.target": ("Target",),
}
"""The public names, by module."""

__all__ = [
    "Diagnostic",
    "Rejected",
    "ShutterProgram",
    "Target",
    "__version__",
    "compile",
    "load",
    "load_ipython_extension",
]


def __getattr__(name: str) -> Any:
    return attribute("nscc", _NAMES, name)


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
