"""Peak memory of commands beside the scene they read: at most 300 MB.

python tests/benchmarks/bench_memory.py
"""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

ROOT = Path(__file__).resolve().parents[2]
LIMIT_MB = 300
SLOTS = 1024
LONG = "nsl 1 frame 4096 slots of 100us code stop : 1..N open when n < stop "
PIXELS = "pixels stop = 1 + (x + 256 * y) % N"


def peak_mb(arguments: list[str]) -> float:
    """Peak resident memory of one `nscc`, in MB."""
    folders = [ROOT, ROOT / "cli", ROOT / "runtime", ROOT / "training"]
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(map(str, folders))}
    quiet = (os.POSIX_SPAWN_OPEN, 2, os.devnull, os.O_WRONLY, 0)
    quiet_out = (os.POSIX_SPAWN_OPEN, 1, os.devnull, os.O_WRONLY, 0)
    command = [sys.executable, "-m", "nscc_cli", *arguments]
    process = os.posix_spawn(sys.executable, command, environment, file_actions=[quiet, quiet_out])
    _, status, usage = os.wait4(process, 0)
    if status:
        raise SystemExit(f"nscc {' '.join(arguments)} failed")
    return usage.ru_maxrss / 1024


def main() -> None:
    """Prints a line for each command: its peak, the scene, what is left."""
    with TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "long.nsl").write_text(LONG + PIXELS)
        # In a process of its own: a child's peak begins with its parent's.
        make = f"numpy.ones(({SLOTS}, 256, 256), numpy.float32)"
        code = f"import numpy; numpy.savez({str(folder / 'light.npz')!r}, light={make})"
        subprocess.run([sys.executable, "-c", code], check=True)
        (folder / "b.nsl").write_text(
            LONG.replace("4096", str(SLOTS)) + PIXELS.replace("256", "16")
        )
        out = str(folder / "out")
        cases: list[tuple[str, list[str], float]] = [
            ("check, 4096 stops", ["check", f"{folder}/long.nsl"], 0),
            ("build, 4096 stops", ["build", f"{folder}/long.nsl", "-o", f"{out}.icw"], 0),
            ("the same, all priced",
             ["build", f"{folder}/long.nsl", "-o", f"{out}.icw", "--emit", "report"], 0),
            ("prove, 4096 stops", ["prove", f"{out}.icw"], 0),
            ("run, 4096 slots, still",
             ["run", f"{out}.icw", "--scene", "builtin:hdr", "-o", f"{out}.npz"], 0),
            ("run, 1024 slots, light",
             ["run", f"{folder}/b.nsl", "--scene", f"{folder}/light.npz", "-o", f"{out}.npz"],
             SLOTS / 4),
        ]  # fmt: skip
        for what, arguments, scene_mb in cases:
            beside = peak_mb(arguments) - scene_mb
            verdict = "" if beside <= LIMIT_MB else "  OVER"
            print(f"{what:<24} {beside:6.0f} MB beside a scene of {scene_mb:.0f} MB{verdict}")


if __name__ == "__main__":
    main()
