"""The promise of plans in numbers: how often it holds, and how often its prediction comes true.

    python tests/benchmarks/bench_promise.py [--slots 16] [--sensors 60] [--programs "a;d edges"]
    python tests/benchmarks/bench_promise.py --kept-back 1000 [--first-seed 10000]
    python tests/benchmarks/bench_promise.py --rare 240 [--first-seed 10000]
    python tests/benchmarks/bench_promise.py --successions 500 [--first-seed 10000]

Arrays of 64 x 64, frames pooled to 65536 samples, the default sensor: every scene of
`tests/helpers/promise.py` x every program of `tests/helpers/plan_cases.py` x five tolerances; then
programs, scenes and sensors at random. A line a program: runs, broken promises, runs whose error
is large enough to
be judged (a tenth of the tolerance), predictions within 15 % of the error among them, effects kept
at a cost though the tolerance could have spared them. Some minutes; it exits 1 where a promise
breaks or fewer than nine in ten predictions come true.

`--kept-back`: so many plans instead, of programs, scenes, sensors and tolerances drawn from seeds
that no test uses, half of them on arrays of 128 x 128: how often a promise breaks. `--rare`: plans
for scenes of 256 x 256 in which few pixels have most of the error: lamps, flashes, suns, disks.
`--successions`: series of scenes that share plans (`tests/helpers/successions.py`). It exits 1
where a promise breaks in more than one of 2000 plans, or predictions come true too seldom.
"""

from __future__ import annotations

import argparse
import sys
import warnings
from collections.abc import Iterable
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / part) for part in ("", "runtime", "tests/helpers")]

from plan_cases import CASES, case  # noqa: E402
from promise import SCENES, TOLERANCES, Outcome, full_frames, outcome, pool, scene  # noqa: E402
from random_sensors import COLS, ROWS, draws, promises, rare_pixels  # noqa: E402
from reference_programs import sensor_of  # noqa: E402
from successions import broken_successions  # noqa: E402

_PLANS_A_SEED = 4


def outcomes(program: str, slots: int) -> Iterable[Outcome]:
    """All scenes and tolerances of a program on the default sensor."""
    container = case(program, slots, "500us", ROWS, COLS)
    sensor = sensor_of(container)
    for name in SCENES:
        light = scene(name, slots, ROWS, COLS)
        full = full_frames(container, light, sensor, pool(light))
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
    for number in range(-(-plans // _PLANS_A_SEED)):
        side, frames = ((48, 6), (128, 2))[number % 2]
        drawn = promises(first_seed + number, plans=_PLANS_A_SEED, side=side, frames=frames)
        for draw in drawn[: plans - len(found)]:
            found.append(draw.found)
            if not draw.found.kept:
                print(f"broken: {draw.said}", flush=True)
    judged = [each for each in found if each.counts]
    parts = np.array([each.plan.predicted_e / each.err for each in judged])
    near = float(np.mean(np.abs(parts - 1.0) <= 0.15))
    broken = sum(not each.kept for each in found)
    print("| | plans | failed |\n|---|---:|---:|")
    print(f"| error above 1.1 x the tolerance | {len(found)} | {broken} |")
    print(
        f"\npredicted by measured: median {np.median(parts):.3f}, within 15 % in {near:.1%} of "
        f"{len(judged)} (goal 90 %)"
    )
    return 0 if broken <= plans / 2000 and near >= 0.9 else 1


def rare(plans: int, first_seed: int) -> int:
    """What became of plans for scenes in which few pixels have most of the error."""
    broken = 0
    for seed in range(first_seed, first_seed + plans):
        draw = rare_pixels(seed)
        broken += not draw.found.kept
        if not draw.found.kept:
            print(f"broken: {draw.said}", flush=True)
    print(f"rare pixels: {broken} of {plans} plans broken (goal 0)")
    return 1 if broken else 0


def successions(count: int, first_seed: int) -> int:
    """What became of successions of scenes that share plans."""
    broken = broken_successions(range(first_seed, first_seed + count))
    print("\n".join(broken))
    print(f"successions of scenes: {len(broken)} broken promises in {count} (goal 0)")
    return 1 if broken else 0


def main() -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--slots", type=int, default=16, help="slots a frame, a multiple of 4")
    parser.add_argument("--sensors", type=int, default=60, help="settings drawn at random")
    parser.add_argument("--programs", default=";".join(CASES), help="separated by semicolons")
    parser.add_argument("--kept-back", type=int, metavar="N", help="plans that no test has seen")
    parser.add_argument("--rare", type=int, metavar="N", help="plans where few pixels decide")
    parser.add_argument("--successions", type=int, metavar="N", help="series that share plans")
    parser.add_argument("--first-seed", type=int, default=10_000, help="of plans kept back")
    chosen = parser.parse_args()
    warnings.simplefilter("ignore")  # scenes are bright, and effects forced off, on purpose
    if chosen.successions:
        return successions(chosen.successions, chosen.first_seed)
    if chosen.rare:
        return rare(chosen.rare, chosen.first_seed)
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
