"""The emulator with sensor effects against numpy, side by side in one run.

    python tests/benchmarks/bench_emulator_effects.py [--rounds 15] [--slots 16]
    python tests/benchmarks/bench_emulator_effects.py --beside CHECKOUT [--rounds 3]

With `--beside`, only whole captures are measured, in turns with those of another checkout. Else:
256 x 256 pixels, float32 light, through `nscc_runtime.capture`. Every line prints its goal beside
what was measured; times are the best of several rounds, taken in turn, of light that may lie in the
cache, and CPU time where one thread works:

* one frame under a plan, against `L.sum(0)`: without noise, and with shot noise, read noise, the
  full well and the ADC, for a mean charge above and below 20 electrons;
* the same noisy frame against numpy's Poisson drawn for every slot;
* whole captures, planning included, single-thread against numpy's Poisson drawn for every slot;
  of 1024 x 1024 pixels, with all threads, against copying the scene in memory; each of 20 repeats
  against a single capture, of scenes that saturate many pixels, too; a pixel and slot of 4096 slots
  against 256;
* peak memory of a capture, its scene included, beyond that of a process that has captured a tiny
  scene, against the scene as float32.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import tempfile
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path
from statistics import median
from time import perf_counter, process_time
from typing import Any

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "helpers"))

from beside import add_option, in_turns, show
from one_scene import load_scene
from whole_captures import SATURATING

from nscc.compiler import compile_file
from nscc.pipeline import Options
from nscc.words.container import Container
from nscc_runtime import capture
from nscc_runtime.effects import everything, selected
from nscc_runtime.light import Light
from nscc_runtime.planning.make import make_plan
from nscc_runtime.planning.plan import Plan, PlanRequest
from nscc_runtime.planning.planned_scene import PlannedScene
from nscc_runtime.scenes import light_of_array
from nscc_runtime.scenes.exposure import parse_exposure
from nscc_runtime.sensor import default_sensor
from nscc_training.tradeoff.emulator import unknown

ROOT = Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "examples"
SIDE = 256
QUIET_GOAL, BRIGHT_GOAL, DIM_GOAL = 1.5, 6.0, 15.0
PER_SLOT_GOAL = 20.0
MEMORY_GOAL = 4.0
WHOLE_GOALS = {"auto, 5 e": 0.25, "all": 0.35}
COPIES_GOAL = 10.0
REPEATS, REPEAT_GOAL = 20, 0.4
SLOTS_GOAL = 1.2
NOISY = "shot,read,full_well"
PROGRAMS = {
    "all open": "open when true\n",
    "4 stops": "code stop : 1..{slots}\nopen when n < stop\n"
    "pixels stop = tile [[1, {half}], [{slots}, 2]]\n",
}


def container(
    name: str, slots: int, target: str = "target scamp5\n", side: int = SIDE, slot_us: int = 1000
) -> Container:
    """One of PROGRAMS, compiled, for side x side pixels."""
    text = "nsl 1\n" + target + f"frame {slots} slots of {slot_us}us\n" + PROGRAMS[name]
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "program.nsl"
        path.write_text(text.format(slots=slots, half=slots // 2))
        found = compile_file(path, Options()).container
    assert found is not None
    if found.pixel_codes is None:
        found = replace(found, pixel_codes=np.zeros((SIDE, SIDE), np.int32))
    times = -(-side // SIDE)
    codes = np.tile(found.pixel_codes, (times, times))[:side, :side]
    chip = replace(found.target, rows=side, cols=side)
    return replace(found, target=chip, pixel_codes=np.ascontiguousarray(codes))


def times_ms(
    runs: dict[str, Callable[[], object]], rounds: int, clock: Callable[[], float] = perf_counter
) -> dict[str, tuple[float, float]]:
    """The best time of each and the median, taken in turn."""
    times: dict[str, list[float]] = {name: [] for name in runs}
    for run in runs.values():
        run()
    names = list(runs)
    for turn in range(rounds):
        # Each comes first and last now and then: what ran before decides what is in the caches.
        for name in names[turn % len(names) :] + names[: turn % len(names)]:
            begin = clock()
            runs[name]()
            times[name].append((clock() - begin) * 1e3)
    return {name: (min(each), median(each)) for name, each in times.items()}


def verdict(holds: bool) -> str:
    """The end of a line."""
    return "" if holds else "  <-- misses the goal"


def plan_of(program: Container, light: Light, effects: str, tolerance_e: float = 5.0) -> Plan:
    """The plan of these effects."""
    scene = PlannedScene(program, default_sensor(program.target), unknown(light))
    return make_plan(scene, PlanRequest(selected(effects), tolerance_e))


def frames(name: str, slots: int, rounds: int) -> None:
    """One frame against the sum, and against Poisson drawn slot by slot."""
    program = container(name, slots)
    unit = np.random.default_rng(1).random((slots, SIDE, SIDE), dtype=np.float32) * 2
    print(f"one frame, {name}, {slots} slots")
    cases = (
        ("no effects", "none", 100.0, QUIET_GOAL),
        ("noisy, bright", NOISY, 100.0, BRIGHT_GOAL),
        ("noisy, dim", NOISY, 5.0 / slots, DIM_GOAL),
    )
    for what, effects, mean_e, goal in cases:
        array = unit * np.float32(mean_e)
        light = light_of_array(array, slot_us=program.slot_us, rows=SIDE, cols=SIDE)
        plan = plan_of(program, light, effects)
        random = np.random.default_rng(2)
        runs: dict[str, Callable[[], object]] = {
            "sum": lambda array=array: array.sum(0),
            "light": lambda light=light, plan=plan: capture(program, unknown(light), plan=plan),
            "array": lambda array=array, plan=plan: capture(program, array, plan=plan),
        }
        if effects != "none":
            runs["numpy"] = lambda array=array, random=random: random.poisson(array).sum(0)
        found = times_ms(runs, rounds)
        charge_e = float(capture(program, light, effects="none").exposure_e.mean())
        (total, total_median), (frame, frame_median) = found["sum"], found["light"]
        ratio, checked = frame / total, found["array"][0]
        print(
            f"  {what:<14} mean {charge_e:7.4g} e   sum {total:6.2f} ms   capture {frame:6.2f} ms  "
            f"x{ratio:5.2f} (goal x{goal:g}; of medians x{frame_median / total_median:.2f})"
            f"{verdict(ratio <= goal)}\n"
            f"  {'':<14} of an array, checked first: {checked:6.2f} ms  x{checked / total:5.2f}"
        )
        if "numpy" in found:
            times = found["numpy"][0] / frame
            print(
                f"  {'':<14} Poisson slot by slot in numpy: {found['numpy'][0]:6.1f} ms, "
                f"{times:5.1f} x slower (goal {PER_SLOT_GOAL:g}){verdict(times >= PER_SLOT_GOAL)}"
            )


def whole(slots: int, rounds: int) -> None:
    """Captures with their planning: of SIDE x SIDE pixels by one thread, of 1024 x 1024 by all."""
    program = container("4 stops", slots)
    array = np.random.default_rng(1).random((slots, SIDE, SIDE), dtype=np.float32) * 200
    light = light_of_array(array, slot_us=program.slot_us, rows=SIDE, cols=SIDE)
    random = np.random.default_rng(2)
    asked: dict[str, dict[str, Any]] = {"auto, 5 e": {"tolerance": 5.0}, "all": {"effects": "all"}}
    print(f"whole captures, 4 stops, {slots} slots, one thread")
    runs: dict[str, Callable[[], object]] = {"numpy": lambda: random.poisson(array).sum(0)}
    for name, how in asked.items():
        runs[name] = partial(_fresh, program, light, threads=1, **how)
        runs[f"{name}, repeats"] = partial(_fresh, program, light, threads=1, repeat=REPEATS, **how)
    found = times_ms(runs, min(5, rounds), process_time)
    for name, goal in WHOLE_GOALS.items():
        ratio = found[name][0] / found["numpy"][0]
        each = found[f"{name}, repeats"][0] / REPEATS / found[name][0]
        print(
            f"  {name:<14} {found[name][0]:6.1f} ms, numpy's Poisson {found['numpy'][0]:6.1f} ms, "
            f"x{ratio:5.3f} (goal x{goal:g}){verdict(ratio <= goal)}\n"
            f"  {'':<14} each of {REPEATS} repeats x{each:5.3f} of it (goal x{REPEAT_GOAL:g})"
            f"{verdict(each <= REPEAT_GOAL)}"
        )
    side = 1024
    program = container("4 stops", slots, side=side)
    array = np.random.default_rng(1).random((slots, side, side), dtype=np.float32) * 200
    light = light_of_array(array, slot_us=program.slot_us, rows=side, cols=side)
    room = np.empty_like(array)
    found = times_ms(
        {
            "copy": lambda: np.copyto(room, array),
            "auto": lambda: _fresh(program, light, tolerance=5.0),
        },
        min(3, rounds),
    )
    copies = found["auto"][0] / found["copy"][0]
    print(
        f"  {side} x {side}, 5 e, all threads: {found['auto'][0]:6.1f} ms, {copies:5.1f} copies of "
        f"the scene (goal {COPIES_GOAL:g}){verdict(copies <= COPIES_GOAL)}"
    )


def _fresh(program: Container, light: Light, **how: Any) -> None:
    """A capture of light about which nothing is known yet."""
    capture(program, unknown(light), **how)


def saturating(rounds: int) -> None:
    """Repeats of scenes of which many pixels run through their words, all effects, one thread."""
    print(f"each of {REPEATS} repeats against a single capture, all effects, one thread")
    for name, scene, exposure in SATURATING:
        program: Container | None = compile_file(EXAMPLES / f"{name}.nsl", Options()).container
        assert program is not None
        light = load_scene(
            scene,
            slot_us=program.slot_us,
            rows=program.target.rows,
            cols=program.target.cols,
            exposure=parse_exposure(exposure),
        )
        planned = PlannedScene(program, default_sensor(program.target), light)
        part = len(planned.near_pixels(everything()).places)
        one = partial(_fresh, program, light, threads=1, effects="all")
        runs: dict[str, Callable[[], object]] = {"one": one, "many": partial(one, repeat=REPEATS)}
        found = times_ms(runs, min(3, rounds), process_time)
        each = found["many"][0] / REPEATS / found["one"][0]
        print(
            f"  {name:<10} {scene:<15} at {exposure:>6} e, {part / light.frames[0].size:6.1%} near "
            f"saturation: {found['one'][0]:6.1f} ms, x{each:5.3f} (goal x{REPEAT_GOAL:g})"
            f"{verdict(each <= REPEAT_GOAL)}"
        )


def many_slots(rounds: int) -> None:
    """Frames under their plans in 4096 slots and in 256, equally long and bright."""
    runs: dict[str, Callable[[], object]] = {}
    work: dict[str, int] = {}
    for slots, side in ((256, 256), (4096, 128)):
        slot_us = 1000 * 256 // slots
        program = container("4 stops", slots, side=side, slot_us=slot_us)
        array = np.random.default_rng(1).random((slots, side, side), dtype=np.float32)
        array *= np.float32(20 * slot_us / 1000)
        light = light_of_array(array, slot_us=program.slot_us, rows=side, cols=side)
        name = f"{slots} slots of {side} x {side} pixels"
        plan = plan_of(program, light, "auto")
        runs[name] = partial(_fresh, program, light, threads=1, plan=plan)
        work[name] = array.size
    found = times_ms(runs, min(5, rounds), process_time)
    few, many = ((name, found[name][0] * 1e6 / work[name]) for name in runs)
    ratio = many[1] / few[1]
    print(
        f"a pixel and slot of {many[0]}: {many[1]:.3f} ns, x{ratio:5.2f} of {few[0]} "
        f"(goal x{SLOTS_GOAL:g}){verdict(ratio <= SLOTS_GOAL)}"
    )


_CHILD = """
import sys
sys.path[:0] = [{here!r}]
import bench_emulator_effects as bench
bench.memory_child({slots}, {effects!r})
"""


def memory_child(slots: int, effects: str) -> None:
    """Prints by how many bytes a capture's peak is above what the process had before."""
    program = container("4 stops", slots)
    small = container("4 stops", 4)
    capture(small, np.ones((4, SIDE, SIDE), np.float32), effects=effects)
    before = memory("VmRSS")
    Path("/proc/self/clear_refs").write_text("5")
    light = np.random.default_rng(1).random((slots, SIDE, SIDE), dtype=np.float32)
    light *= np.float32(100)
    capture(program, light, effects=effects)
    print(memory("VmHWM") - before)


def memory(name: str) -> int:
    """Bytes of a line of this process's status."""
    for line in Path("/proc/self/status").read_text().splitlines():
        if line.startswith(name + ":"):
            return int(line.split()[1]) * 1024
    raise OSError(f"no {name}")


def memories(slots: int) -> None:
    """Peak memory of captures in processes of their own; Linux only."""
    if not Path("/proc/self/clear_refs").exists():
        print("peak memory: not measured on this system")
        return
    print("peak memory of one capture, planning included, from an array")
    folders = [ROOT, ROOT / "cli", ROOT / "runtime", ROOT / "training"]
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(map(str, folders))}
    for count in (slots, 8 * slots):
        for effects in ("none", NOISY, "auto"):
            code = _CHILD.format(here=str(Path(__file__).parent), slots=count, effects=effects)
            done = subprocess.run(
                [sys.executable, "-c", code], env=environment, capture_output=True, text=True
            )
            if done.returncode:
                raise SystemExit(done.stderr)
            scene = 4 * count * SIDE * SIDE
            ratio = int(done.stdout) / scene
            print(
                f"  {count:4} slots, {effects:<19} {int(done.stdout) / 1e6:7.1f} MB, x{ratio:5.2f} "
                f"the scene (goal x{MEMORY_GOAL:g}){verdict(ratio <= MEMORY_GOAL)}"
            )


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=15)
    parser.add_argument("--slots", type=int, default=16)
    add_option(parser)
    arguments = parser.parse_args()
    if arguments.beside is not None:
        worker = str(Path(__file__).with_name("whole_captures.py").resolve())
        show(*in_turns(worker, [], arguments.beside, arguments.rounds), "ms")
        return
    for name in PROGRAMS:
        frames(name, arguments.slots, arguments.rounds)
    whole(arguments.slots, arguments.rounds)
    saturating(arguments.rounds)
    many_slots(arguments.rounds)
    memories(arguments.slots)


if __name__ == "__main__":
    main()
