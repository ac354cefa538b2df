"""A SCAMP-like chip in software: executes the words of a compiled program and nothing else."""

from __future__ import annotations

from nscc_runtime.emulator.capture import expose

__all__ = ["expose"]
