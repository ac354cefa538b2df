"""What choosing effects saves: plans for several tolerances beside all effects and the reference.

    python tests/benchmarks/bench_choice.py [--rounds 5]

CPU seconds of this process, the least of several rounds, of captures as users call them. Of each
program, scene and tolerance: planning as a part of the first frame; the first frame as a part of
that with all effects to the same tolerance, planning included in both; the check whether a kept
plan serves the next frames, as a part of one; these as a part of the next ones with all effects,
the check included in both; both by the cheaper of that and the reference. Beside them the floor:
light, shot noise and the converter alone, as a part of the next frames with all effects; and what
the plan's table says of first frames. At the end medians and the worst, beside the goals.
"""

from __future__ import annotations

import argparse
import warnings
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import count
from pathlib import Path
from statistics import median
from time import process_time

from nscc.compiler import compile_file
from nscc.pipeline import Options
from nscc.words.container import Container
from nscc_runtime import capture
from nscc_runtime.effects import selected
from nscc_runtime.kept_plans import KeptPlans, Statistics, Turn
from nscc_runtime.light import Light
from nscc_runtime.planner.choose import plan_for
from nscc_runtime.planner.frames import made_ready
from nscc_runtime.planner.plan import Plan
from nscc_runtime.planner.program import Program
from nscc_runtime.planner.tolerance import DEFAULT, Given
from nscc_runtime.scenes import load_scene
from nscc_runtime.scenes.exposure import parse_exposure
from nscc_runtime.sensor import default_sensor
from nscc_runtime.tradeoff.study import unknown

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
CASES = (
    ("class_e", "builtin:hdr", "30000"), ("codebook", "builtin:motion", "30000"),
    ("class_c", "builtin:hdr", "30000"), ("hdr_doubling", "builtin:hdr", "30000"),
    ("class_b", "builtin:motion", "10000"), ("hdr_2x2", "builtin:hdr", "300000"),
    ("class_c", "builtin:flat:3000", None),
)  # fmt: skip
_LARGE_E = 1e6
"""A tolerance to which no short cut matters."""
TOLERANCES: tuple[Given, ...] = (0.5, 5.0, 50.0, DEFAULT)
ASKED: dict[Given, float] = {DEFAULT: 0.5, 50.0: 0.25}
"""Of a frame with all effects, in the median."""


@dataclass(frozen=True)
class Row:
    """One program, scene and tolerance. `planning`, of the first frame; `check`, of the next ones;
    `first`, `next` and `floor` of all, and what the plan's table says of `first`; `worst_first`,
    `worst_next` of the cheaper of all and reference."""

    tolerance: Given
    planning: float
    check: float
    first: float
    said: float
    next: float
    floor: float
    worst_first: float
    worst_next: float


def least_s(runs: Sequence[Callable[[], object]], rounds: int) -> list[float]:
    """CPU seconds of the fastest round of each, in turns: a machine has slower minutes."""
    found: list[list[float]] = [[] for _ in runs]
    for _ in range(rounds):
        for run, took_s in zip(runs, found, strict=True):
            begin = process_time()
            run()
            took_s.append(process_time() - begin)
    return [min(took_s) for took_s in found]


def film(
    container: Container, light: Light, tolerance: Given, effects: str
) -> Callable[[], object]:
    """Takes the next frame of a film of one scene, whose first is taken here."""
    plans, numbers = KeptPlans(), count()

    def frame() -> object:
        turn = Turn(plans, next(numbers))
        return capture(
            container, unknown(light), effects=effects, tolerance=tolerance, turn=turn, threads=1
        )

    frame()
    return frame


def row(program: Program, light: Light, tolerance: Given, reference_s: float, rounds: int) -> Row:
    """Measure one tolerance."""
    container = program.container
    simple = plan_for(program, unknown(light), _LARGE_E, selected("shot"))

    def make() -> Plan:
        return plan_for(program, unknown(light), tolerance, selected("auto"))

    def check() -> object:
        return Statistics.of(unknown(light), program.open_part)

    def first(effects: str) -> Callable[[], object]:
        return lambda: capture(
            container, unknown(light), effects=effects, tolerance=tolerance, threads=1
        )

    runs = (
        make, check, first("auto"), first("all"),
        film(container, light, tolerance, "auto"), film(container, light, tolerance, "all"),
        lambda: capture(container, unknown(light), plan=simple, threads=1),
    )  # fmt: skip
    planning_s, check_s, first_s, first_all_s, next_s, all_s, floor_s = least_s(runs, rounds)
    cost = make().cost
    assert cost is not None
    return Row(
        tolerance, planning_s / first_s, check_s / next_s, first_s / first_all_s,
        cost.total_ms / cost.all_ms, next_s / all_s, floor_s / all_s,
        first_s / min(first_all_s, reference_s), next_s / min(all_s, reference_s),
    )  # fmt: skip


def case(name: str, scene: str, exposure: str | None, rounds: int) -> list[Row]:
    """Measure and print one program on one scene."""
    container: Container | None = compile_file(EXAMPLES / f"{name}.nsl", Options()).container
    assert container is not None
    assert container.pixel_codes is not None
    rows, cols = container.pixel_codes.shape
    light = load_scene(
        scene, slot_us=container.slot_us, rows=rows, cols=cols,
        exposure=None if exposure is None else parse_exposure(exposure),
    )  # fmt: skip
    program = made_ready(container, default_sensor(container.target))
    capture(container, unknown(light), effects="all", threads=1)

    def by_reference() -> object:
        return capture(container, unknown(light), effects="all", fidelity="reference", threads=1)

    [reference_s] = least_s([by_reference], 1)
    print(f"{name}, {scene}: reference {reference_s:.3f} s")
    found = []
    for tolerance in TOLERANCES:
        each = row(program, light, tolerance, reference_s, rounds)
        print(
            f"  {_named(tolerance):>9}: planning {each.planning:.2f} of the first frame, check "
            f"{each.check:.2f} of the next; first {each.first:.2f} (said {each.said:.2f}), next "
            f"{each.next:.2f} of all (floor {each.floor:.2f}); {each.worst_first:.2f} and "
            f"{each.worst_next:.2f} of the cheaper",
            flush=True,
        )
        found.append(each)
    return found


def _named(tolerance: Given) -> str:
    return tolerance if isinstance(tolerance, str) else f"{tolerance:g}e"


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=5)
    chosen = parser.parse_args()
    warnings.simplefilter("ignore")
    found = [each for one in CASES for each in case(*one, chosen.rounds)]
    print(f"medians over {len(CASES)} programs and scenes")
    columns = "planning", "first", "said", "check", "next", "floor"
    print(f"{'tolerance':<10}" + "".join(f"{name:>10}" for name in columns))
    for tolerance in TOLERANCES:
        some = [each for each in found if each.tolerance == tolerance]
        shown = (median(getattr(each, name) for each in some) for name in columns)
        print(f"{_named(tolerance):<10}" + "".join(f"{each:>10.2f}" for each in shown))
    print(
        "goals: planning 0.40, check 0.15, "
        + ", ".join(f"next frames {part} at {_named(each)}" for each, part in ASKED.items())
    )
    print(
        f"the worst of all: planning {max(e.planning for e in found):.2f} (0.4), check "
        f"{max(e.check for e in found):.2f} (0.15); of the cheaper of all and reference first "
        f"{max(e.worst_first for e in found):.2f} (1.45), next "
        f"{max(e.worst_next for e in found):.2f} (1.05)"
    )


if __name__ == "__main__":
    main()
