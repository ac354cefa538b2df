"""The reference simulation: words and sensor effects, slot by slot, in float64."""

from __future__ import annotations

from nscc_runtime.effects.views import Scene
from nscc_runtime.reference.capture import Reference, frames

__all__ = ["Reference", "Scene", "frames"]
