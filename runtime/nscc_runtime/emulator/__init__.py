"""A SCAMP-like chip in software that executes only the words of a compiled program."""

from __future__ import annotations

from nscc_runtime.emulator.capture import expose

__all__ = ["expose"]
