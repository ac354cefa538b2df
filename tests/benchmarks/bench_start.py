"""CPU time of commands from the shell, beside `python -c "import numpy"`.

    python tests/benchmarks/bench_start.py [ROUNDS]

All commands run in turn, each in its own process; the best of the rounds counts, so that the load
of the machine has little influence.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
NSCC = (str(Path(sys.executable).with_name("nscc")),)
BASE = "import numpy"
CHECK_A = "check class_a.nsl"

# Name, arguments, what it is compared with, and the most that it may be of that.
RUNS: tuple[tuple[str, tuple[str, ...], str, float | None], ...] = (
    (BASE, (sys.executable, "-c", "import numpy"), BASE, None),
    ("nscc --version", (*NSCC, "--version"), BASE, None),
    ("nscc --help", (*NSCC, "--help"), BASE, 1.0),
    *(
        (f"check {path.name}", (*NSCC, "check", str(path)), BASE, 3.0)
        for path in sorted((ROOT / "examples").glob("*.nsl"))
    ),
    (
        "build, all 4096 stops",
        (
            *(*NSCC, "build", str(ROOT / "examples/class_b_4096.nsl")),
            *("-O", "1", "--codes", "open", "-o", "out.icw"),
        ),
        CHECK_A,
        10.0,
    ),
    (
        "run class_b.nsl",
        (*NSCC, "run", str(ROOT / "examples/class_b.nsl"), "--scene", "builtin:hdr", "-o", "f.npz"),
        BASE,
        8.0,
    ),
)


def main() -> int:
    """Measure and print; 1 if something is over what it may take."""
    rounds = int(sys.argv[1]) if len(sys.argv) > 1 else 5
    best_s: dict[str, float] = {}
    with tempfile.TemporaryDirectory() as folder:
        for _name, command, _base, _most in RUNS:
            seconds(command, folder)  # what is written and compiled once is not what is measured
        for _ in range(rounds):
            for name, command, _base, _most in RUNS:
                taken_s = seconds(command, folder)
                best_s[name] = min(taken_s, best_s.get(name, taken_s))
    slow = 0
    print(f"best of {rounds} rounds, Python {sys.version.split()[0]}")
    for name, _command, base, most in RUNS:
        ratio = best_s[name] / best_s[base]
        limit = "" if most is None else f"  (at most {most:g})"
        mark = "" if most is None or ratio <= most else "  OVER"
        slow += bool(mark)
        print(f"{name:28}{best_s[name] * 1e3:8.0f} ms {ratio:6.2f} x {base}{limit}{mark}")
    return 1 if slow else 0


def seconds(command: tuple[str, ...], folder: str) -> float:
    """CPU time of one process, which must succeed."""
    environment = os.environ | {"OMP_NUM_THREADS": "1", "NUMBA_NUM_THREADS": "1"}
    environment.pop("PYTHONDONTWRITEBYTECODE", None)  # users' second run finds compiled modules
    quiet = subprocess.DEVNULL
    process = subprocess.Popen(command, cwd=folder, env=environment, stdout=quiet, stderr=quiet)
    _, status, usage = os.wait4(process.pid, 0)
    if status:
        raise SystemExit(f"{' '.join(command)} fails with status {status}")
    return usage.ru_utime + usage.ru_stime


if __name__ == "__main__":
    sys.exit(main())
