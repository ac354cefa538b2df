"""What choosing effects saves: plans for several tolerances beside all effects and the reference.

    python tests/benchmarks/bench_choice.py [--rounds 5]

CPU seconds of this process, the least of several rounds, with the reference = 1: a frame with all
effects, planning included; for each tolerance planning, and a frame under the plan.
"""

from __future__ import annotations

import argparse
import warnings
from collections.abc import Callable
from pathlib import Path
from time import process_time

from nscc.compiler import compile_file
from nscc.pipeline import Options
from nscc_runtime import capture
from nscc_runtime.effects import selected
from nscc_runtime.planner.choose import plan_for
from nscc_runtime.planner.frames import made_ready
from nscc_runtime.scenes import load_scene
from nscc_runtime.scenes.exposure import parse_exposure
from nscc_runtime.sensor import default_sensor
from nscc_runtime.tradeoff.study import unknown

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
CASES = (
    ("class_e", "builtin:hdr"), ("codebook", "builtin:motion"), ("class_c", "builtin:hdr"),
    ("hdr_doubling", "builtin:hdr"),
)  # fmt: skip
TOLERANCES_E = (0.5, 5.0, 50.0)


def least_s(run: Callable[[], object], rounds: int) -> float:
    """CPU seconds of the fastest round."""
    found = []
    for _ in range(rounds):
        begin = process_time()
        run()
        found.append(process_time() - begin)
    return min(found)


def case(name: str, scene: str, rounds: int) -> None:
    """Print one program on one scene."""
    container = compile_file(EXAMPLES / f"{name}.nsl", Options()).container
    assert container is not None
    assert container.pixel_codes is not None
    rows, cols = container.pixel_codes.shape
    light = load_scene(
        scene, slot_us=container.slot_us, rows=rows, cols=cols, exposure=parse_exposure("30000")
    )
    program = made_ready(container, default_sensor(container.target))
    capture(container, unknown(light), effects="all")
    reference_s = least_s(
        lambda: capture(container, unknown(light), effects="all", fidelity="reference"), 1
    )
    all_s = least_s(lambda: capture(container, unknown(light), effects="all"), rounds)
    print(f"{name}, {scene}: reference {reference_s:.3f} s, all {all_s / reference_s:.4f}")
    for tolerance_e in TOLERANCES_E:

        def make(tolerance_e: float = tolerance_e) -> object:
            return plan_for(program, unknown(light), tolerance_e, selected("auto"))

        plan = plan_for(program, unknown(light), tolerance_e, selected("auto"))
        planning_s = least_s(make, rounds)
        frame_s = least_s(lambda plan=plan: capture(container, unknown(light), plan=plan), rounds)
        print(
            f"  {tolerance_e:4g} e: planning {planning_s / reference_s:.4f}, frame "
            f"{frame_s / reference_s:.4f}, together {(planning_s + frame_s) / all_s:.2f} of all, "
            f"from the second frame on {frame_s / all_s:.2f}"
        )


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=5)
    chosen = parser.parse_args()
    warnings.simplefilter("ignore")
    for name, scene in CASES:
        case(name, scene, chosen.rounds)


if __name__ == "__main__":
    main()
