"""`nscc demo`: expose a photo or a clip, reconstruct it, and draw a sheet of pictures."""

from __future__ import annotations

from nscc_training.demo.run import BUILTIN, Demo, demo
from nscc_training.demo.sheet import readouts_text

__all__ = ["BUILTIN", "Demo", "demo", "readouts_text"]
