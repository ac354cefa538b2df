"""Programs that look beside fixed shutters of as many slots, in one run: issue 15's time.

    python tests/benchmarks/bench_looks.py [--rounds 3] [--beside CHECKOUT]

256 x 256 pixels, 256 slots, the default sensor, `nscc_runtime.capture` of one frame, its planning
included: `examples/float_pixel.nsl` against a program of class b whose pixels have all 256 stops.
Seconds are those of the processor, the best of several rounds, taken in turn; with `--beside` also
those of another checkout.
"""

from __future__ import annotations

import argparse
import json
import tempfile
from pathlib import Path
from time import process_time

import numpy as np
from beside import add_option, in_turns, show

import nscc
from nscc_runtime import capture, scene
from nscc_runtime.light import Light

ROOT = Path(__file__).resolve().parents[2]
GOAL = 2.0
CLASS_B_256 = """nsl 1
frame 256 slots of 125us
code stop : 1..N
open when n < stop
pixels stop = 1 + (21 * (x % 16) + 16 * (y % 16)) % N
"""


def programs() -> dict[str, nscc.ShutterProgram]:
    """The two, compiled."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "class_b_256.nsl"
        path.write_text(CLASS_B_256)
        fixed = nscc.compile(path)
    return {"class_b_256": fixed, "float_pixel": nscc.compile(ROOT / "examples/float_pixel.nsl")}


def lights(program: nscc.ShutterProgram) -> dict[str, Light]:
    """Stills and a clip, dim to saturated."""
    stills = {
        f"builtin:hdr, {exposure:g} e": capture(
            program, scene("builtin:hdr", exposure=exposure)
        ).light
        for exposure in (3e4, 1e6)
    }
    clip = np.random.default_rng(1).exponential(60.0, (256, 256, 256)).astype(np.float32)
    return {**stills, "a clip": Light.of_clip(clip)}


def measure() -> dict[str, float]:
    """The least CPU milliseconds by "light, effects: program"."""
    made, best = programs(), dict[str, float]()
    for what, light in lights(made["float_pixel"]).items():
        for effects in ("all", "auto"):
            for _ in range(3):
                for name, program in made.items():
                    begin = process_time()
                    capture(program, light, effects=effects)
                    key = f"{what}, {effects}: {name}"
                    best[key] = min(best.get(key, np.inf), 1e3 * (process_time() - begin))
    return best


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=3)
    add_option(parser)
    chosen = parser.parse_args()
    if chosen.worker:
        print(json.dumps(measure()))
        return
    mine, other = in_turns(str(Path(__file__).resolve()), [], chosen.beside, chosen.rounds)
    show(mine, other, "ms")
    for key in mine:
        if key.endswith(": float_pixel"):
            ratio = mine[key] / mine[key.replace("float_pixel", "class_b_256")]
            print(f"{key} x{ratio:.2f} (goal x{GOAL:g}){'' if ratio <= GOAL else '  <-- misses'}")


if __name__ == "__main__":
    main()
