"""The worker of `bench_emulator_effects.py --beside`: CPU milliseconds of whole captures by one
thread, planning included. It uses only what other versions have, too."""

from __future__ import annotations

import json
import warnings
from pathlib import Path
from time import process_time
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
SATURATING = (
    ("class_c", "builtin:hdr", "300000"),
    ("flutter", "builtin:hdr", "300000"),
    ("flutter", "builtin:motion", "30000"),
    ("hdr_2x2", "builtin:hdr", "300000"),
)
"""Programs and scenes that saturate many pixels."""
REPEATS, ROUNDS = 20, 5


def measure() -> dict[str, float]:
    """The least milliseconds of a capture, by its name."""
    import nscc
    from nscc_runtime import capture, scene

    warnings.simplefilter("ignore")
    asked: dict[str, dict[str, Any]] = {"all": {"effects": "all"}, "auto, 5 e": {"tolerance": 5.0}}
    found = {}
    for name, taken, exposure in (("class_b", "builtin:hdr", "10000"), *SATURATING):
        program = nscc.compile(str(ROOT / "examples" / f"{name}.nsl"))
        light = capture(program, scene(taken, exposure=exposure)).light
        for title, options in asked.items():
            for repeat in (1, REPEATS):
                least_s = float("inf")
                for _ in range(ROUNDS):
                    begin = process_time()
                    # A copy, about which nothing is known yet.
                    capture(program, light.scaled(1.0), threads=1, repeat=repeat, **options)
                    least_s = min(least_s, process_time() - begin)
                found[f"{name}, {taken}, {exposure} e, {title}, x{repeat}"] = 1e3 * least_s
    return found


if __name__ == "__main__":
    print(json.dumps(measure()))
