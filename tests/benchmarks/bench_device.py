"""10,000 sessions over bad cables: wrong frames, hangs, leaks; and what a good line takes.

python tests/benchmarks/bench_device.py [SESSIONS]
"""

from __future__ import annotations

import sys
from importlib import import_module
from pathlib import Path

if __name__ == "__main__":
    sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "helpers"))
    sys.exit(import_module("device_measures").main())
