"""The loops that a web page loads give the frames of this machine's own loops."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from web_loops import WebLoops

import nscc
import nscc_runtime
from nscc.examples import examples
from nscc_runtime.loop import Loop

SETTINGS: dict[str, dict[str, Any]] = {
    "none": {},
    "auto": {"effects": "auto"},
    "all": {"effects": "all"},
    "reference": {"effects": "all", "fidelity": "reference"},
}

pytestmark = [pytest.mark.slow, pytest.mark.xdist_group("webassembly")]


@pytest.fixture(scope="module")
def library(tmp_path_factory: pytest.TempPathFactory) -> Path:
    for name in ("wasmtime", "ziglang"):
        pytest.importorskip(name)
    library: Path = tmp_path_factory.mktemp("web") / "loops.wasm"
    command = [sys.executable, "-m", "nscc_runtime.compile_ahead", "--wasm", library]
    subprocess.run(command, check=True)
    return library


@pytest.fixture(scope="module")
def web(library: Path) -> WebLoops:
    return WebLoops(library)


@pytest.fixture
def in_web(web: WebLoops, monkeypatch: pytest.MonkeyPatch) -> Iterator[WebLoops]:
    monkeypatch.setattr(Loop, "__call__", lambda loop, **values: web.call(loop, **values))
    return web


def capture(name: str, settings: dict[str, Any]) -> nscc_runtime.Capture:
    program = nscc.compile(examples()[name], level=1)
    scene = nscc_runtime.scene("builtin:hdr", exposure=1e6)
    return nscc_runtime.capture(program, scene, seed=1, threads=1, **settings)


@pytest.mark.parametrize("settings", SETTINGS)
@pytest.mark.parametrize("name", ["hdr_2x2", "spike", "edges"])
def test_frames_in_webassembly_equal_native_ones(
    name: str, settings: str, in_web: WebLoops
) -> None:
    in_web.calls.clear()
    ours = capture(name, SETTINGS[settings])
    assert in_web.calls
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Loop, "__call__", NATIVE)
        native = capture(name, SETTINGS[settings])
    assert np.array_equal(ours.frame, native.frame)
    assert ours.told.keys() == native.told.keys()
    for key, values in native.told.items():
        assert np.allclose(ours.told[key], values, rtol=1e-9, equal_nan=True), key
    assert np.allclose(ours.exposure_e, native.exposure_e, rtol=1e-12, atol=1e-9, equal_nan=True)


NATIVE = Loop.__call__


def test_the_library_is_small(library: Path) -> None:
    assert library.stat().st_size < 1_000_000
