"""A sweep of 200 programs on two workers: at least 1.6 times as fast as one after the other, and at
most 50 ms a point that is not its own work.

    python tests/benchmarks/bench_sweep.py [POINTS]

Both are whole commands, the cluster's start included. The work of a point is what `times.csv` says
of it, at least 0.3 s of it; what is left of the workers' time between the first point and the last
is overhead. Processor seconds of both commands are printed beside: they mean something on a busy
machine, too. So does what two commands without workers gain, each with half of the points: two
processors that share caches are not twice as fast as one.
"""

from __future__ import annotations

import csv
import os
import resource
import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory
from time import perf_counter

POINTS = 200
WORKERS = 2
LEAST_RATIO = 1.6
MOST_OVERHEAD_MS = 50.0
LEAST_WORK_S = 0.3
GRID = """
kind = "compile"

[bumps]
rule = '''
code start : 0..N - 4
open when start <= n < start + 4'''
slots = {slots}
codes = "open"
level = 1
target = "scamp5"
lowering = "accumulate"
"""
FEWEST_SLOTS = 1100
ALONE = {**os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
"""One after the other is on one core: threads of numpy's would use the second."""


def main() -> int:
    """Measure and print; 1 if a goal is missed."""
    points = int(sys.argv[1]) if len(sys.argv) > 1 else POINTS
    with TemporaryDirectory() as folder:
        grid = Path(folder) / "grid.toml"
        write(grid, range(points))
        serial_s, _, serial_cpu_s = swept(grid, 0)
        two_s, between_s, two_cpu_s = swept(grid, WORKERS)
        work_s = [float(row["seconds"]) for row in times(grid.with_name(str(WORKERS)))]
        halves_s = halved_s(Path(folder), points)
        tables = {(grid.with_name(out) / "table.csv").read_bytes() for out in ("0", str(WORKERS))}
    ratio = serial_s / two_s
    overhead_ms = (between_s * WORKERS - sum(work_s)) / len(work_s) * 1e3
    print(f"{len(work_s)} points, of {min(work_s):.2f} to {max(work_s):.2f} s each")
    print(
        f"serial {serial_s:.1f} s, {WORKERS} workers {two_s:.1f} s: x {ratio:.2f} "
        f"(goal: {LEAST_RATIO})"
    )
    print(
        f"two commands with half of the points each {halves_s:.1f} s: x {serial_s / halves_s:.2f}"
    )
    print(f"overhead {overhead_ms:.1f} ms a point (goal: at most {MOST_OVERHEAD_MS:g})")
    print(f"processors: serial {serial_cpu_s:.1f} s, {WORKERS} workers {two_cpu_s:.1f} s")
    print(f"the same table: {'yes' if len(tables) == 1 else 'NO'}")
    met = ratio >= LEAST_RATIO and overhead_ms <= MOST_OVERHEAD_MS and len(tables) == 1
    if min(work_s) < LEAST_WORK_S:
        print(f"points of less than {LEAST_WORK_S} s say little of what the goals are about")
    return 0 if met else 1


def write(grid: Path, points: range) -> None:
    """The grid of so many programs, each of another length."""
    slots = ",\n".join(str(FEWEST_SLOTS + point) for point in points)
    grid.write_text(GRID.format(slots=f"[{slots}]"))


def command(grid: Path, workers: int) -> list[str]:
    """The sweep of a grid, in a folder beside it that has the number of workers for its name."""
    out = str(grid.with_name(str(workers)))
    arguments = ["sweep", str(grid), "--out", out, "--workers", str(workers)]
    return [sys.executable, "-m", "nscc_cli", *arguments]


def halved_s(folder: Path, points: int) -> float:
    """Seconds of two commands side by side, every second point in each."""
    grids = [folder / f"half{first}" / "grid.toml" for first in range(2)]
    for first, grid in enumerate(grids):
        grid.parent.mkdir()
        write(grid, range(first, points, 2))
    begin = perf_counter()
    started = [
        subprocess.Popen(
            command(grid, 0), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env=ALONE
        )
        for grid in grids
    ]
    for process in started:
        if process.wait():
            raise subprocess.CalledProcessError(process.returncode, process.args)
    return perf_counter() - begin


def swept(grid: Path, workers: int) -> tuple[float, float, float]:
    """Seconds of the whole command, from the first begin of a point to the last end, and of
    processors, those of its workers with it."""
    out = grid.with_name(str(workers))
    begin, before_s = perf_counter(), spent_s()
    subprocess.run(command(grid, workers), check=True, capture_output=True, env=ALONE)
    whole_s, cpu_s = perf_counter() - begin, spent_s() - before_s
    ended_s = [float(row["ended_s"]) for row in times(out)]
    began_s = [
        end_s - float(row["seconds"]) for end_s, row in zip(ended_s, times(out), strict=True)
    ]
    return whole_s, max(ended_s) - min(began_s), cpu_s


def spent_s() -> float:
    """Processor seconds of all commands that have ended."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def times(out: Path) -> list[dict[str, str]]:
    """What a sweep wrote about its points."""
    with open(out / "times.csv", newline="") as file:
        return [*csv.DictReader(file)]


if __name__ == "__main__":
    sys.exit(main())
