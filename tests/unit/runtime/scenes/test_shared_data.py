"""Every file of the shared data loads, whatever its format; skipped where the data is not there."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
import pytest
from checkout import ROOT
from one_scene import load_scene

from nscc.diagnostics.diagnostic import Diagnostic, Severity
from nscc_runtime.scenes import ExposureLevel

DATA = Path(os.environ.get("NSCC_DATA") or ROOT.parent / "shared" / "data")
FILES = sorted(
    path
    for path in DATA.rglob("*")
    if path.suffix in (".hdr", ".exr", ".mat", ".mp4") and path.is_file()
)

pytestmark = pytest.mark.skipif(
    not FILES, reason=f"no scenes in {DATA}: set NSCC_DATA to the folder that holds them"
)


@pytest.mark.parametrize("path", FILES, ids=lambda p: p.name)
def test_real_scenes_load_without_errors(path: Path) -> None:
    said: list[Diagnostic] = []
    light = load_scene(
        str(path),
        slot_us=(125.0,) * 8,
        rows=256,
        cols=256,
        exposure=ExposureLevel(30000.0),
        warn=said.append,
    )
    total = light.total_e()
    assert np.percentile(total, 99) == pytest.approx(30000.0, rel=1e-5)
    assert total.min() >= 0
    assert light.kind == ("still" if path.suffix in (".hdr", ".exr") else "clip")
    # What was cut to the array and turned grey is said, and nothing else.
    allowed = {"NS0773", "NS0740"} if path.name == "ilm_Desk.exr" else {"NS0773"}
    assert {d.code for d in said} <= allowed
    assert {d.severity for d in said if d.code == "NS0773"} <= {Severity.NOTE}


@pytest.mark.parametrize("name", ["runner.mat", "drop.mat"])
def test_benchmark_clips_are_their_own_frames(name: str) -> None:
    """The first eight frames of the file, divided by 255 and scaled, are the light of eight
    slots."""
    from scipy.io import loadmat

    path = next((p for p in FILES if p.name == name), None)
    if path is None:
        pytest.skip(f"{name} is not in {DATA}")
    orig = loadmat(path)["orig"]
    light = load_scene(
        str(path), slot_us=(1000.0,) * 8, rows=256, cols=256, exposure=ExposureLevel(30000.0)
    )
    frames = np.moveaxis(orig[:, :, :8] / 255.0, 2, 0)
    np.testing.assert_allclose(light.dense(), frames * light.exposure_scale_e, rtol=1e-6)
