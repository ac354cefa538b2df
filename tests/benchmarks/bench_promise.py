"""The promise of plans in numbers: how often it holds, and how often its prediction comes true.

    python tests/benchmarks/bench_promise.py [--slots 16] [--sensors 60] [--programs "a;d edges"]
    python tests/benchmarks/bench_promise.py --kept-back 1000 [--first-seed 10000]

Arrays of 64 x 64, frames pooled to 65536 samples, the default sensor: every scene of
`tests/promise.py` x every program of `tests/plan_cases.py` x five tolerances; then programs, scenes
and sensors at random. A line a program: runs, broken promises, runs whose error is large enough to
be judged (a tenth of the tolerance), predictions within 15 % of the error among them, effects kept
at a cost though the tolerance could have spared them. Some minutes; it exits 1 where a promise
breaks or fewer than nine in ten predictions come true.

`--kept-back`: so many plans instead, programs, scenes, sensors, tolerances of every kind and of the
worst pixel drawn from seeds that no test uses, every promise of a plan looked at. Half an hour for
a thousand; it exits 1 where one breaks or the median of predicted over measured is off by more than
15 %.
"""

from __future__ import annotations

import argparse
import sys
import warnings
from collections.abc import Iterable
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / part) for part in ("", "runtime", "tests")]

from plan_cases import CASES, case  # noqa: E402
from promise import SCENES, TOLERANCES, Outcome, full_frames, outcome, pool, scene  # noqa: E402
from random_sensors import COLS, ROWS, draws, promises  # noqa: E402
from reference_programs import sensor_of  # noqa: E402

_PLANS_A_SEED = 4


def outcomes(program: str, slots: int) -> Iterable[Outcome]:
    """All scenes and tolerances of a program on the default sensor."""
    container = case(program, slots, "500us", ROWS, COLS)
    sensor = sensor_of(container)
    for name in SCENES:
        light = scene(name, slots, ROWS, COLS)
        full = full_frames(container, light, sensor, pool(light), 3, 5)
        for tolerance in TOLERANCES:
            yield outcome(container, light, sensor, tolerance, full)


def line(name: str, found: list[Outcome]) -> list[Outcome]:
    """Print what became of some runs."""
    judged = [each for each in found if each.counts]
    print(
        f"{name:<16}{len(found):>6}{sum(not each.kept for each in found):>8}{len(judged):>8}"
        f"{sum(each.foreseen for each in judged):>10}"
        f"{sum(bool(each.needless) for each in found):>10}",
        flush=True,
    )
    return found


def kept_back(plans: int, first_seed: int) -> int:
    """What became of plans that no test has seen; 0 where all is as promised."""
    found: list[Outcome] = []
    for seed in range(first_seed, first_seed + -(-plans // _PLANS_A_SEED)):
        for draw in promises(seed, plans=_PLANS_A_SEED)[: plans - len(found)]:
            found.append(draw.found)
            if draw.found.broken:
                print(f"broken: {draw.said}", flush=True)
    said = [what for each in found for what in each.broken]
    kinds = {
        kind: sum(each.startswith(kind) for each in said) for kind in ("rms", "worst", "noise")
    }
    judged = [each for each in found if each.counts]
    median = float(np.median([each.plan.predicted_e / each.err for each in judged]))
    bounded = sum(each.plan.tolerance_max_e is not None for each in found)
    noisy = sum(None not in (each.noise_ratio, each.plan.noise_ratio) for each in found)
    print(
        f"| promised | plans | broken (goal 0) |\n|---|---:|---:|\n"
        f"| root mean square | {len(found)} | {kinds['rms']} |\n"
        f"| worst pixel | {bounded} | {kinds['worst']} |\n"
        f"| noise | {noisy} | {kinds['noise']} |\n\n"
        f"predicted by measured: median {median:.3f} of {len(judged)} (goal 0.85 to 1.15)"
    )
    return 0 if not said and 0.85 <= median <= 1.15 else 1


def main() -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--slots", type=int, default=16, help="slots a frame, a multiple of 4")
    parser.add_argument("--sensors", type=int, default=60, help="settings drawn at random")
    parser.add_argument("--programs", default=";".join(CASES), help="separated by semicolons")
    parser.add_argument("--kept-back", type=int, metavar="N", help="plans that no test has seen")
    parser.add_argument("--first-seed", type=int, default=10_000, help="of plans kept back")
    chosen = parser.parse_args()
    warnings.simplefilter("ignore")  # scenes are bright, and effects forced off, on purpose
    if chosen.kept_back:
        return kept_back(chosen.kept_back, chosen.first_seed)
    print(f"{'':<16}{'runs':>6}{'broken':>8}{'judged':>8}{'foreseen':>10}{'needless':>10}")
    found: list[Outcome] = []
    for name in chosen.programs.split(";"):
        found += line(name, list(outcomes(name, chosen.slots)))
    found = line("all", found)
    random = [each.found for seed in range(chosen.sensors) for each in draws(seed)]
    found = found + line("random sensors", random)
    judged = [each for each in found if each.counts]
    foreseen = sum(each.foreseen for each in judged) >= 0.9 * len(judged)
    return 0 if foreseen and all(each.kept and not each.needless for each in found) else 1


if __name__ == "__main__":
    sys.exit(main())
