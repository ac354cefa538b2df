"""`nscc fmt --check` of a program with a large tile, as a ratio to `nscc check` of the same file.

    python tests/benchmarks/bench_format.py [--rounds 3]

Milliseconds of the processor, the least of some rounds, each in a process of its own. It exits 1
where the ratio is above 4.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
from pathlib import Path
from resource import RUSAGE_CHILDREN, getrusage
from tempfile import TemporaryDirectory

_SIDE = 128
_MOST = 4.0


def large_tile() -> str:
    """A program whose tile has a number for each of _SIDE x _SIDE pixels."""
    rows = (", ".join(str(1 + (x * y) % 64) for x in range(_SIDE)) for y in range(_SIDE))
    lines = ",\n                   ".join(f"[{row}]" for row in rows)
    head = "nsl 1\nframe 64 slots of 1ms\ncode stop : 1..64\nopen when n < stop\n"
    return f"{head}pixels stop = tile [{lines}]\n"


def processor_ms(folder: Path, *arguments: str) -> float:
    """What a command takes of the processor."""
    before = getrusage(RUSAGE_CHILDREN)
    subprocess.run([sys.executable, "-m", "nscc_cli", *arguments], cwd=folder, capture_output=True)
    after = getrusage(RUSAGE_CHILDREN)
    return 1e3 * (after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime)


def main() -> int:
    """Measure and print; 1 where formatting takes too long."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--rounds", type=int, default=3)
    rounds = range(parser.parse_args().rounds)
    with TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "tile.nsl").write_text(large_tile())
        check_ms = min(processor_ms(folder, "check", "tile.nsl") for _ in rounds)
        format_ms = min(processor_ms(folder, "fmt", "--check", "tile.nsl") for _ in rounds)
    ratio = format_ms / check_ms
    print(
        f"check {check_ms:.0f} ms, fmt --check {format_ms:.0f} ms: {ratio:.2f} of check "
        f"(at most {_MOST:g})"
    )
    return 0 if ratio <= _MOST else 1


if __name__ == "__main__":
    sys.exit(main())
