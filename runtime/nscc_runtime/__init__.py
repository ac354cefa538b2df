"""Run compiled shutter programs: scenes, the emulated chip, devices, frame files and pictures.

    import nscc, nscc_runtime

    p = nscc.compile("examples/hdr_2x2.nsl")
    taken = nscc_runtime.capture(p, "builtin:hdr", effects="auto")
    taken.frame     # uint8 (buckets, rows, cols)

This package executes words. It imports the definitions of words and targets from `nscc`, but not
the compiler. Most of it needs `nscc[run]`. `docs/python.md` describes the whole package."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from nscc.lazy import attribute

if TYPE_CHECKING:
    from nscc_runtime.captured import Capture
    from nscc_runtime.exposing import audit, capture, captures, film, plan, scene, sensor_for
    from nscc_runtime.light import Light
    from nscc_runtime.sensor import Sensor

_NAMES = {
    "captured": ("Capture",),
    "exposing": ("audit", "capture", "captures", "film", "plan", "scene", "sensor_for"),
    "light": ("Light",),
    "sensor": ("Sensor",),
}
"""The public names, by module."""

__all__ = [
    "Capture",
    "Light",
    "Sensor",
    "audit",
    "capture",
    "captures",
    "film",
    "plan",
    "scene",
    "sensor_for",
]


def __getattr__(name: str) -> Any:
    return attribute("nscc_runtime", _NAMES, name)


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
