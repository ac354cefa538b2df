"""`nscc demo`: from a photo or a clip to a sheet of what a coded exposure makes of it."""

from __future__ import annotations

from nscc_training.demo.expose import Settings
from nscc_training.demo.run import BUILTIN, Demo, demo
from nscc_training.demo.sheet import readouts_text

__all__ = ["BUILTIN", "Demo", "Settings", "demo", "readouts_text"]
