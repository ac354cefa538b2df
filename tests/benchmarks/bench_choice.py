"""What choosing effects saves: captures with `auto` beside those with all effects.

    python tests/benchmarks/bench_choice.py [--rounds 5]
    python tests/benchmarks/bench_choice.py --drawn 24 [--seed S] [--scenes FOLDER]

CPU seconds of this process, the least of several rounds taken in turns, of captures as users call
them, one thread. Of each program, scene and tolerance, as a part of the same with all effects:
`next`, a frame of a film of which enough frames are expected that a plan is measured, the check
whether the plan still serves included; `first`, a frame of such a film whose plan is known, on a
scene of which nothing is; `repeat`, 20 frames of one scene with the choice of effects; and
`single`, one frame. `of cheaper`: the next frame beside the cheaper of all effects and reference.
`plan` are the milliseconds that measuring takes.

`--drawn`: so many programs, scenes and exposures that are drawn anew each time, `repeat` alone;
scenes are the pictures in a folder, by default those that are built in. At the end medians, the
worst, and goals.
"""

from __future__ import annotations

import argparse
import sys
import time
import warnings
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import count
from pathlib import Path
from statistics import median
from time import process_time

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / part) for part in ("", "runtime", "tests")]

from nscc_runtime.planning.scenes import planning_of  # noqa: E402
from plan_cases import CASES as PROGRAMS  # noqa: E402
from plan_cases import book_rows  # noqa: E402

import nscc  # noqa: E402
from nscc.compiler import compile_file  # noqa: E402
from nscc.diagnostics.diagnostic import Rejected  # noqa: E402
from nscc.pipeline import Options  # noqa: E402
from nscc.words.container import Container  # noqa: E402
from nscc_runtime import capture  # noqa: E402
from nscc_runtime.effects import selected  # noqa: E402
from nscc_runtime.execution.frames import executed  # noqa: E402
from nscc_runtime.execution.program import analysed  # noqa: E402
from nscc_runtime.kept_plans import KeptPlans, Turn  # noqa: E402
from nscc_runtime.light import Light  # noqa: E402
from nscc_runtime.planning.make import PlanRequest, make_plan  # noqa: E402
from nscc_runtime.planning.plan import Plan  # noqa: E402
from nscc_runtime.planning.tolerance import DEFAULT, ToleranceInput  # noqa: E402
from nscc_runtime.scenes import load_scene  # noqa: E402
from nscc_runtime.scenes.exposure import parse_exposure  # noqa: E402
from nscc_runtime.sensor import default_sensor  # noqa: E402
from nscc_runtime.tradeoff.study import unknown  # noqa: E402

EXAMPLES = ROOT / "examples"
FIXED = (
    ("class_e", "builtin:hdr", "30000"), ("codebook", "builtin:motion", "30000"),
    ("class_c", "builtin:hdr", "30000"), ("hdr_doubling", "builtin:hdr", "30000"),
    ("class_b", "builtin:motion", "10000"), ("hdr_2x2", "builtin:hdr", "300000"),
    ("class_c", "builtin:flat:3000", None),
)  # fmt: skip
TOLERANCES: tuple[ToleranceInput, ...] = (0.5, 5.0, 50.0, DEFAULT)
NEXT: dict[ToleranceInput, float] = {5.0: 0.95, 50.0: 0.60, DEFAULT: 0.60}
"""Of a frame with all effects, in the median."""
FIRST, WORST_FIRST, WORST_NEXT, REPEAT, WORST_REPEAT = 1.10, 1.30, 1.05, 0.65, 1.02
REPEATS = 20


@dataclass(frozen=True)
class Row:
    """One program, scene and tolerance."""

    tolerance: ToleranceInput
    plan_ms: float
    first: float
    next: float
    of_cheaper: float
    repeat: float
    single: float


def least_s(runs: Sequence[Callable[[], object]], rounds: int) -> list[float]:
    """CPU seconds of the fastest round of each, in turns: a machine has slower minutes."""
    found: list[list[float]] = [[] for _ in runs]
    for _ in range(rounds):
        for run, took_s in zip(runs, found, strict=True):
            begin = process_time()
            run()
            took_s.append(process_time() - begin)
    return [min(took_s) for took_s in found]


def taken(
    container: Container, light: Light, tolerance: ToleranceInput, effects: str, **how: object
) -> None:
    """A capture of light of which nothing is known."""
    capture(
        container, unknown(light), effects=effects, tolerance=tolerance, threads=1,
        **how,  # type: ignore[arg-type]
    )  # fmt: skip


def film(
    container: Container, light: Light, tolerance: ToleranceInput, effects: str
) -> Callable[[], object]:
    """Takes the next frame of a film of one scene, whose first is taken here."""
    plans, numbers = KeptPlans(), count()

    def frame() -> object:
        return taken(container, light, tolerance, effects, turn=Turn(plans, next(numbers)))

    frame()
    return frame


def row(
    container: Container, light: Light, tolerance: ToleranceInput, reference_s: float, rounds: int
) -> Row:
    """Measure one tolerance."""
    sensor = default_sensor(container.target)

    def make(effects: str = "auto") -> Plan:
        scene = planning_of(container, sensor, unknown(light), threads=1)
        return make_plan(scene, PlanRequest(selected(effects), tolerance))

    def first(effects: str) -> Callable[[], object]:
        program, execution = analysed(container, sensor), make(effects).execution
        return lambda: executed(program, unknown(light), execution, threads=1).frame(0, 0)

    runs = [make, first("auto"), first("all")]
    for effects in ("auto", "all"):
        runs += [
            film(container, light, tolerance, effects),
            partial(taken, container, light, tolerance, effects, repeat=REPEATS),
            partial(taken, container, light, tolerance, effects),
        ]
    plan_s, first_s, first_all_s, *rest = least_s(runs, rounds)
    mine, every_s = rest[:3], rest[3:]
    parts = [one / other for one, other in zip(mine, every_s, strict=True)]
    of_cheaper = mine[0] / min(every_s[0], reference_s)
    return Row(tolerance, 1e3 * plan_s, first_s / first_all_s, parts[0], of_cheaper, *parts[1:])


def fixed(name: str, scene: str, exposure: str | None, rounds: int) -> list[Row]:
    """Measure and print one program on one scene."""
    container = compile_file(EXAMPLES / f"{name}.nsl", Options()).container
    assert container is not None
    light = scene_for(container, scene, exposure)
    taken(container, light, DEFAULT, "all")
    reference = partial(capture, container, light, effects="all", fidelity="reference", threads=1)
    [reference_s] = least_s([reference], 1)
    print(f"{name}, {scene}: reference {reference_s:.3f} s")
    found = []
    for tolerance in TOLERANCES:
        each = row(container, light, tolerance, reference_s, rounds)
        print(
            f"  {_named(tolerance):>9}: plan {each.plan_ms:5.1f} ms; of all: first "
            f"{each.first:.2f}, next {each.next:.2f} ({each.of_cheaper:.2f} of the cheaper), "
            f"repeat {each.repeat:.2f}, single {each.single:.2f}",
            flush=True,
        )
        found.append(each)
    return found


def scene_for(container: Container, scene: str, exposure: str | None) -> Light:
    """A scene on the program's array."""
    assert container.pixel_codes is not None
    rows, cols = container.pixel_codes.shape
    return load_scene(
        scene, slot_us=container.slot_us, rows=rows, cols=cols,
        exposure=None if exposure is None else parse_exposure(exposure),
    )  # fmt: skip


def any_program(rng: np.random.Generator) -> tuple[str, Container]:
    """An example with fixed shutters, or a program of `tests/plan_cases.py`."""
    while True:
        if rng.random() < 0.5:
            path = Path(str(rng.choice(sorted(map(str, EXAMPLES.glob("*.nsl"))))))
            name, container = path.stem, compile_file(path, Options()).container
        else:
            kind, slots = str(rng.choice(list(PROGRAMS))), int(rng.choice([8, 16, 32, 64]))
            text, lowering = PROGRAMS[kind]
            slot = f"{rng.choice([100, 250, 500, 1000])}us"
            shown = text.format(slots=slots, slot=slot, rows=book_rows(slots))
            name, container = f"{kind} {slots}", nscc.compile(shown, lowering=lowering).container
        if container and not container.machine.stages and container.pixel_codes is not None:
            return name, container


def drawn(number: int, seed: int, folder: Path | None) -> None:
    """Measure and print programs on scenes that are drawn at random."""
    rng, parts = np.random.default_rng(seed), []
    scenes = ["builtin:hdr", "builtin:motion"]
    if folder is not None:
        scenes = sorted(str(path) for path in folder.iterdir() if path.suffix in (".hdr", ".exr"))
    print(f"seed {seed}: {REPEATS} frames with auto at {DEFAULT}, of the same with all effects")
    while len(parts) < number:
        name, container = any_program(rng)
        scene, exposure = str(rng.choice(scenes)), f"{10 ** rng.uniform(3.5, 6.0):.4g}"
        try:
            light = scene_for(container, scene, exposure)
        except Rejected:
            continue
        runs = [
            partial(taken, container, light, DEFAULT, effects, repeat=REPEATS)
            for effects in ("auto", "all")
        ]
        auto_s, all_s = least_s(runs, 3)
        parts.append(auto_s / all_s)
        print(
            f"  {name:<20} {Path(scene).name:<32} at {exposure:>9} e: all "
            f"{1e3 * all_s / REPEATS:6.1f} ms a frame, auto {parts[-1]:.2f}",
            flush=True,
        )
    print(
        f"median {median(parts):.2f} (goal {REPEAT}), worst {max(parts):.2f} (goal {WORST_REPEAT})"
    )


def _named(tolerance: ToleranceInput) -> str:
    return tolerance if isinstance(tolerance, str) else f"{tolerance:g}e"


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--drawn", type=int, default=0)
    parser.add_argument("--seed", type=int, default=int(time.time()))
    parser.add_argument("--scenes", type=Path)
    chosen = parser.parse_args()
    warnings.simplefilter("ignore")
    if chosen.drawn:
        drawn(chosen.drawn, chosen.seed, chosen.scenes)
        return
    found = [each for one in FIXED for each in fixed(*one, chosen.rounds)]
    print(f"medians over {len(FIXED)} programs and scenes")
    columns = "plan_ms", "first", "next", "repeat", "single"
    print(f"{'tolerance':<10}" + "".join(f"{name:>10}" for name in columns) + "   goal of next")
    for tolerance in TOLERANCES:
        some = [each for each in found if each.tolerance == tolerance]
        shown = (median(getattr(each, name) for each in some) for name in columns)
        goal = f"{NEXT[tolerance]:.2f}" if tolerance in NEXT else ""
        print(f"{_named(tolerance):<10}" + "".join(f"{each:>10.2f}" for each in shown), f"  {goal}")
    print(
        f"goals of first: {FIRST} in the median, {WORST_FIRST} at worst; the worst of all: "
        f"first {max(each.first for each in found):.2f}, next "
        f"{max(each.of_cheaper for each in found):.2f} of the cheaper of all and reference "
        f"(goal {WORST_NEXT})"
    )


if __name__ == "__main__":
    main()
