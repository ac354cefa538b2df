"""Measure how many events of a still scene are noise: `examples/event_camera.nsl` with all effects.

    python docs/event_noise.py

The scene has 40 % of a full well in every pixel. The first two frames are left out, because the
reference of a pixel begins at 0.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

import nscc
import nscc_runtime

FRAMES, FIRST = 6, 2
LEVELS = ("1%", "4%", "6%", "10%")


def main() -> None:
    """Print the share of pixels that send an event in a frame, for each threshold."""
    program = nscc.compile(Path("examples/event_camera.nsl"))
    container = program.container
    target, slots = container.target, container.slots
    slot_e = 0.4 * target.full_well_e / slots
    light = np.full((FRAMES, slots, target.rows, target.cols), slot_e, np.float32)
    print("threshold   pixels with an event in a frame")
    for level in LEVELS:
        film = nscc_runtime.film(program, light, params={"t": level}, effects="all", seed=1)
        events = film.planes["on"][FIRST:] | film.planes["off"][FIRST:]
        print(f"{level:>9}   {100 * events.mean():.2g} %")


if __name__ == "__main__":
    main()
