"""Programs that look beside fixed shutters of as many slots, in one run: issue 15's time.

    python tests/benchmarks/bench_looks.py [--rounds 7]

256 x 256 pixels, 256 slots, the default sensor, `nscc_runtime.capture` of one frame, its planning
included: `examples/float_pixel.nsl` against a program of class b whose pixels have all 256 stops.
Seconds are those of the processor, the best of several rounds, taken in turn.
"""

from __future__ import annotations

import argparse
import tempfile
from pathlib import Path
from time import process_time

import numpy as np

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
        f"builtin:hdr, {exposure:g} e": scene("builtin:hdr", exposure=exposure).light(
            program.slot_us, program.container.target
        )
        for exposure in (3e4, 1e6)
    }
    clip = np.random.default_rng(1).exponential(60.0, (256, 256, 256)).astype(np.float32)
    return {**stills, "a clip": Light.of_clip(clip)}


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=7)
    rounds = parser.parse_args().rounds
    made = programs()
    for what, light in lights(made["float_pixel"]).items():
        for effects in ("all", "auto"):
            best = dict.fromkeys(made, float("inf"))
            for _ in range(rounds):
                for name, program in made.items():
                    begin = process_time()
                    capture(program, light, effects=effects)
                    best[name] = min(best[name], process_time() - begin)
            ratio = best["float_pixel"] / best["class_b_256"]
            print(
                f"{what:<22} --effects {effects:<5}"
                + "  ".join(f"{name} {each * 1e3:6.1f} ms" for name, each in best.items())
                + f"  x{ratio:.2f} (goal x{GOAL:g}){'' if ratio <= GOAL else '  <-- misses'}"
            )


if __name__ == "__main__":
    main()
