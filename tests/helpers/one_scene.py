"""Scenes of one array, for tests of what a scene's name and options mean."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from nscc_runtime.light import Light
from nscc_runtime.scenes import Scene, laid_scene

MORE = "warn", "progress"
"""What `laid_scene` takes beside a `Scene`."""


def load_scene(
    spec: str, *, slot_us: Sequence[float], rows: int, cols: int, **options: Any
) -> Light:
    """The light of the scene `spec` on an array of `rows` x `cols` pixels, in slots of `slot_us`
    microseconds. `options` are fields of `Scene`, or `warn` and `progress`."""
    more = {name: options.pop(name) for name in MORE if name in options}
    scene = Scene(spec, **options)
    return laid_scene(scene, slot_us=slot_us, rows=rows, cols=cols, **more).light
