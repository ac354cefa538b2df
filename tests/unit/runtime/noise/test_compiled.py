"""The noise's machine code gives every process the same numbers."""

from __future__ import annotations

import os
import subprocess
import sys


def test_numbers_do_not_depend_on_the_process():
    program = (
        "import numpy as np; from nscc_runtime.noise import key, poisson;"
        "counts, _ = poisson(key(1, 2), np.arange(99), np.linspace(0, 60, 99));"
        "print(counts.tobytes().hex())"
    )
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    runs = {
        subprocess.run(
            [sys.executable, "-c", program], check=True, env=environment, capture_output=True
        ).stdout
        for _ in range(2)
    }
    assert len(runs) == 1
