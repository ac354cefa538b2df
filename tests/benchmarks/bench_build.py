"""Every example built at -O2 beside `nscc check` of it: time at most 40 times, memory under 1 GB.

    python tests/benchmarks/bench_build.py [ROUNDS]

Both are processes of their own, taken in turns, without the cache; the shortest of the rounds and
the largest peak of memory count.
"""

from __future__ import annotations

import os
import sys
from pathlib import Path
from tempfile import TemporaryDirectory
from time import perf_counter

ROOT = Path(__file__).resolve().parents[2]
MOST_RATIO = 40.0
MOST_MB = 1000.0


def main() -> int:
    """Measure and print; 1 if something is over what it may take."""
    rounds = int(sys.argv[1]) if len(sys.argv) > 1 else 3
    over = 0
    print(f"{'example':<20} {'check':>9} {'build -O2':>10} {'ratio':>7} {'peak':>9}")
    with TemporaryDirectory() as folder:
        for path in sorted((ROOT / "examples").glob("*.nsl")):
            check_s = build_s = float("inf")
            peak_mb = 0.0
            for _ in range(rounds):
                check_s = min(check_s, measured(["check", str(path)], folder)[0])
                out = f"{folder}/out.icw"
                taken_s, used_mb = measured(["build", str(path), "-O", "2", "-o", out], folder)
                build_s, peak_mb = min(build_s, taken_s), max(peak_mb, used_mb)
            wrong = build_s > MOST_RATIO * check_s or peak_mb > MOST_MB
            over += wrong
            print(
                f"{path.stem:<20} {check_s * 1e3:6.0f} ms {build_s * 1e3:7.0f} ms "
                f"x {build_s / check_s:5.1f} {peak_mb:6.0f} MB{'  OVER' if wrong else ''}",
                flush=True,
            )
    return 1 if over else 0


def measured(arguments: list[str], folder: str) -> tuple[float, float]:
    """Seconds and peak MB of one `nscc`, which must succeed."""
    path = os.pathsep.join(str(ROOT / part) for part in (".", "cli", "runtime", "training"))
    environment = {**os.environ, "PYTHONPATH": path, "NSCC_CACHE": "off"}
    quiet = [(os.POSIX_SPAWN_OPEN, n, os.devnull, os.O_WRONLY, 0) for n in (1, 2)]
    command = [sys.executable, "-m", "nscc_cli", *arguments]
    begin = perf_counter()
    process = os.posix_spawn(sys.executable, command, environment, file_actions=quiet)
    _, status, usage = os.wait4(process, 0)
    taken_s = perf_counter() - begin
    if status:
        raise SystemExit(f"nscc {' '.join(arguments)} failed (in {folder})")
    return taken_s, usage.ru_maxrss / 1024


if __name__ == "__main__":
    sys.exit(main())
