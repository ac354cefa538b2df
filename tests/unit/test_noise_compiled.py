"""The noise's machine code: complete, and used without the compiler that made it."""

from __future__ import annotations

import os
import subprocess
import sys

from nscc_runtime.noise import compiled, loops


def test_every_loop_is_linked_with_its_parameters():
    assert set(compiled.entry_points()) == set(compiled.PARAMETERS) == set(loops.SIGNATURES)
    for name, signature in loops.SIGNATURES.items():
        assert signature.count("CPointer") == compiled.PARAMETERS[name]
    assert compiled.is_compiled()


def test_a_warm_start_imports_neither_numba_nor_scipy():
    compiled.entry_points()
    program = (
        "import sys, numpy as np; from nscc_runtime.noise import key, poisson;"
        "poisson(key(1, 2), np.arange(9), np.ones(9), exact=True);"
        "sys.exit(any(name in sys.modules for name in ('numba', 'scipy')))"
    )
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    subprocess.run([sys.executable, "-c", program], check=True, env=environment)


def test_numbers_do_not_depend_on_the_process():
    program = (
        "import numpy as np; from nscc_runtime.noise import key, poisson;"
        "counts, _ = poisson(key(1, 2), np.arange(99), np.linspace(0, 60, 99), exact=False);"
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
