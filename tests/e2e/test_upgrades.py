"""Programs, containers, frames and runs of the version before open in this one."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import numpy as np
import pytest
from checkout import ROOT
from nscc_command import invoke

PREVIOUS = ROOT / "tests/data/previous"
PROGRAMS = ("stops", "looks")


@pytest.fixture
def old(tmp_path: Path) -> Path:
    shutil.copytree(PREVIOUS, tmp_path / "old")
    return tmp_path / "old"


@pytest.mark.parametrize("name", PROGRAMS)
def test_programs_of_the_previous_version_compile(name: str, old: Path) -> None:
    found = invoke(["build", f"{name}.nsl", "-o", "again.icw"], old)
    assert found.status == 0, found.err
    same = invoke(["diff", f"{name}.icw", "again.icw"], old)
    # What an old chip's table did not say is as it was: the target is the same, key by key.
    assert "target:" not in same.out


def test_words_of_a_version_1_program_keep_their_bytes(old: Path) -> None:
    invoke(["build", "stops.nsl", "-o", "again.icw"], old)
    assert (old / "again.icw").read_bytes() == (old / "stops.icw").read_bytes()


@pytest.mark.parametrize("name", PROGRAMS)
def test_containers_prove_and_expose_the_light_of_old_frames(name: str, old: Path) -> None:
    assert invoke(["prove", f"{name}.icw"], old).status == 0
    line = f"run {name}.icw --scene builtin:flat:20000 -o new.npz"
    found = invoke(line.split(), old)
    assert found.status == 0, found.err
    with np.load(old / f"{name}.npz") as before, np.load(old / "new.npz") as now:
        assert {*before.files} - {"shutter", "shutter_shape", "codes_stop"} <= {*now.files}
        # Photons and reads: sqrt(20000) and some 14 electrons off, at most six times that.
        assert np.abs(before["exposure_e"] - now["exposure_e"]).max() < 6 * 145
        if "shutter" in before.files:
            invoke(["shutters", f"{name}.icw", "-o", "s.npz"], old)
            with np.load(old / "s.npz") as shutters:
                assert np.array_equal(shutters["shutter"], before["shutter"])


@pytest.mark.parametrize("name", PROGRAMS)
def test_frames_are_reconstructed_and_drawn(name: str, old: Path) -> None:
    pytest.importorskip("torch")
    by = ["any"] if name == "stops" else []  # pixels that looked tell their light themselves
    found = invoke(["reconstruct", *by, f"{name}.npz", "-o", "light.npz"], old)
    assert found.status == 0, found.err
    with np.load(old / "light.npz") as light:
        (image,) = (light[key] for key in light.files if light[key].ndim == 2)
        assert np.median(image) == pytest.approx(20000, rel=0.1)
    assert invoke(["view", f"{name}.npz", "-o", "frame.png"], old).status == 0


def test_an_old_run_decodes_to_the_recorded_clip(old: Path) -> None:
    pytest.importorskip("torch")
    assert invoke(["reconstruct", "run", "like.npz", "-o", "again.npz"], old).status == 0
    with np.load(old / "video.npz") as before, np.load(old / "again.npz") as now:
        np.testing.assert_allclose(now["video"], before["video"], rtol=1e-4, atol=1e-2)
    found = invoke(["run", "--like", "run", "--scene", "builtin:motion", "-o", "frame.npz"], old)
    assert found.status == 0, found.err
    with np.load(old / "like.npz") as before, np.load(old / "frame.npz") as now:
        old_meta, new_meta = (json.loads(str(each["meta"])) for each in (before, now))
        assert np.array_equal(now["frame"], before["frame"])
        assert new_meta["program_sha256"] == old_meta["program_sha256"]
        assert new_meta["electrons_per_lsb"] == old_meta["electrons_per_lsb"]


def test_files_of_later_versions_are_refused(old: Path) -> None:
    """Files of the next version, opened in this one."""
    data = bytearray((old / "stops.icw").read_bytes())
    data[8] = 99
    (old / "next.icw").write_bytes(data)
    (old / "next.nsl").write_text("nsl 99\nframe 4 slots of 1ms\nopen when true\n")
    for line, code in (("prove next.icw", "NS0704"), ("check next.nsl", "NS0106")):
        found = invoke(line.split(), old)
        assert found.status != 0
        assert found.codes == [code]
        assert "help:" in found.err
