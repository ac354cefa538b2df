"""The emulator against the plainest loop over the same shutter, side by side in one run.

    python tests/benchmarks/bench_emulator.py [--slots 64|4096]

Per program: milliseconds of `np.add(E, L[n], out=E, where=S[n])` over all slots (f64 E, f32 L),
of one capture (warm; decoding words and planes included), and their ratio. The goal is at most 4
for 64 slots, 2 for 4096. The best of several rounds, the two taken in turn. 4096 slots take some
1.4 GB of memory, nearly all of it the loop's own arrays.
"""

from __future__ import annotations

import argparse
import tempfile
from collections.abc import Iterator
from pathlib import Path
from time import perf_counter

import numpy as np

from nscc.compiler import compile_file
from nscc.diagnostics.diagnostic import Rejected
from nscc.pipeline import Options
from nscc.words.container import Container
from nscc_runtime.emulator import expose
from nscc_runtime.light import Light

_GOAL = {64: 4.0, 4096: 2.0}
_LOWERINGS = ("accumulate", "latch", "edges")


def programs(slots: int) -> Iterator[tuple[str, str]]:
    """Names and texts of the programs, classes a to d and a coarse exposure pattern."""
    head = f"nsl 1\ntarget scamp5\nframe {slots} slots of {300 if slots > 64 else 100}us\n"
    spread = f"1 + (x * 37 + y * 101) % {slots}"
    yield "a", head + "open when true\n"
    yield "b", head + f"code stop : 1..{slots}\nopen when n < stop\npixels stop = {spread}\n"
    stops = ", ".join(str(max(1, slots // part)) for part in (1024, 256, 64, 16))
    pattern = f"[[{', '.join(stops.split(', ')[:2])}], [{', '.join(stops.split(', ')[2:])}]]"
    pixels = f"pixels stop = tile {pattern}\n"
    yield "b, mostly closed", head + f"code stop : 1..{slots}\nopen when n < stop\n" + pixels
    last = slots - 8
    yield (
        "c",
        head + f"code start : 0..{last}\nopen when start <= n < start + 8\n"
        f"pixels start = (x * 37 + y * 101) % {last + 1}\n",
    )
    if slots <= 64:
        yield (
            "d",
            head + f"code start : 0..{slots - 1}\ncode stop : 1..{slots}\nrequire start < stop\n"
            "open when start <= n < stop\n"
            f"pixels start = (x * 5) % {slots // 2}\n"
            f"pixels stop = {slots // 2} + 1 + (y * 3) % {slots // 2}\n",
        )


def compiled(text: str, lowering: str) -> Container | None:
    """The program in that lowering, None where it does not fit."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "program.nsl"
        path.write_text(text)
        try:
            return compile_file(path, Options(lowering=lowering)).container
        except Rejected as rejected:
            print(f"  {lowering}: {rejected.diagnostics[-1].code}")
            return None


def shutter_of(container: Container) -> np.ndarray:
    """S bool (slots, rows, cols) of the container's own codes."""
    shutters = container.table.shutters[container.table.shutter_of_code, 0]
    return np.ascontiguousarray(shutters.T[:, container.pixel_codes])


def plain_loop(light: np.ndarray, shutter: np.ndarray) -> np.ndarray:
    """The loop to compare with."""
    exposure = np.zeros(light.shape[1:])
    for n in range(len(light)):
        np.add(exposure, light[n], out=exposure, where=shutter[n])
    return exposure


def seconds(function, *arguments) -> float:
    begin = perf_counter()
    function(*arguments)
    return perf_counter() - begin


def measure(name: str, container: Container, light: np.ndarray, still: bool) -> None:
    """Print one line."""
    slots = len(light)
    shutter = shutter_of(container)
    if still:
        scene = Light.of_still(light[0], np.linspace(0.5, 1.5, slots))
        light = scene.dense()
    else:
        scene = Light.of_clip(light)
    found = expose(container, scene).exposure_e[0]
    truth = plain_loop(light, shutter)
    total = scene.total_e()
    assert (np.abs(found - truth) <= 1e-6 * truth + 1e-9 * total).all(), name
    rounds = 9 if slots <= 64 else 3
    loops, captures = [], []
    for _ in range(rounds):
        loops.append(seconds(plain_loop, light, shutter))
        captures.append(seconds(expose, container, scene))
    loop, capture = min(loops) * 1e3, min(captures) * 1e3
    ratio = capture / loop
    verdict = "" if ratio <= _GOAL[slots] else "  <-- over the goal"
    print(f"  {name:<32} loop {loop:8.1f} ms  capture {capture:8.1f} ms  x{ratio:5.2f}{verdict}")


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--slots", type=int, choices=sorted(_GOAL), action="append")
    for slots in parser.parse_args().slots or sorted(_GOAL):
        print(f"{slots} slots, 256 x 256, goal x{_GOAL[slots]}")
        light = np.random.default_rng(1).random((slots, 256, 256), dtype=np.float32)
        for name, text in programs(slots):
            for lowering in _LOWERINGS if slots <= 64 else _LOWERINGS[1:]:
                container = compiled(text, lowering)
                if container is not None:
                    measure(f"{name}, {lowering}", container, light, still=False)
                    if name.startswith("b") and lowering == "edges":
                        measure(f"{name}, {lowering}, still", container, light, still=True)


if __name__ == "__main__":
    main()
