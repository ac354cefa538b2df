"""Where the machine code comes from: a whole file, or a new compilation."""

from __future__ import annotations

import hashlib
import os
import subprocess
import sys

import pytest

from nscc_runtime import machine_code
from nscc_runtime.emulator import compiled


@pytest.fixture
def no_compiler(monkeypatch):
    """Compiling takes seconds: count it instead."""
    calls = []

    def build(_loops):
        calls.append(1)
        return b"machine code"

    monkeypatch.setattr(machine_code, "build", build)
    return calls


def test_compiled_once_and_read_afterwards(tmp_path, no_compiler):
    place = tmp_path / "cache"
    assert compiled.LOOPS.object_code([place]) == b"machine code"
    assert compiled.LOOPS.object_code([place]) == b"machine code"
    assert len(no_compiler) == 1
    assert len(list(place.iterdir())) == 1


def test_damaged_code_is_never_run(tmp_path, no_compiler):
    compiled.LOOPS.object_code([tmp_path])
    (file,) = tmp_path.iterdir()
    data = file.read_bytes()
    assert hashlib.sha256(b"machine code").digest() + b"machine code" == data
    for damaged in (b"", data[:20], data[:-1], data[:-1] + b"x"):
        file.write_bytes(damaged)
        assert compiled.LOOPS.object_code([tmp_path]) == b"machine code"
        assert file.read_bytes() == data
    assert len(no_compiler) == 5


def test_next_place_where_the_first_cannot_be_written(tmp_path, no_compiler):
    blocked = tmp_path / "file"
    blocked.write_text("not a folder")
    second = tmp_path / "second"
    for _ in range(2):
        assert compiled.LOOPS.object_code([blocked, second]) == b"machine code"
    assert len(no_compiler) == 1
    assert compiled.LOOPS.object_code([blocked]) == b"machine code"


def test_a_warm_start_imports_neither_numba_nor_scipy():
    compiled.entry_point()
    program = (
        "import sys; from nscc_runtime.emulator.compiled import entry_point; entry_point();"
        "sys.exit(any(name in sys.modules for name in ('numba', 'scipy')))"
    )
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    subprocess.run([sys.executable, "-c", program], check=True, env=environment)
