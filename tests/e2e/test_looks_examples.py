"""The examples whose pixels look at the light, run as a user runs them, against their comments."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from checkout import ROOT
from nscc_command import Outcome, invoke
from numpy.typing import NDArray

LOOKING = [p for p in (ROOT / "examples").glob("*.nsl") if "\nnsl 2\n" in p.read_text()]
STEP_E = 30000 / 127
Floats = NDArray[np.float64]
Expected = tuple[Floats, dict[str, NDArray[np.int64]]]
"""The exposure (rows, cols), and the states that are read."""


def float_pixel(gathered: Floats) -> Expected:
    """`gathered` (N + 1, rows, cols): the light before every boundary."""
    exposure, closed_at = gathered[-1].copy(), np.zeros(gathered.shape[1:], np.int64)
    level = round(0.45 * 30000 / STEP_E) * STEP_E
    for look, boundary in enumerate((1, 2, 4, 8, 16, 32, 64, 128), 1):
        now = (closed_at == 0) & (gathered[boundary] > level)
        closed_at[now] = look
        exposure[now] = gathered[boundary][now]
    return exposure, {"closed_at": closed_at}


def first_light(gathered: Floats) -> Expected:
    lit = gathered[1:] > round(0.10 * 30000 / STEP_E) * STEP_E
    arrived = np.where(lit.any(axis=0), lit.argmax(axis=0) + 1, 0)
    stop = np.where(arrived > 0, arrived, 31)
    return np.take_along_axis(gathered, stop[None], axis=0)[0], {"arrived": arrived}


def auto_exposure(gathered: Floats) -> Expected:
    """The first frame: all are open to its end."""
    full = gathered[16] > round(0.80 * 30000 / STEP_E) * STEP_E
    return gathered[16], {"was": np.full(full.shape, 4), "stop": np.where(full, 3, 4)}


def spike(gathered: Floats) -> Expected:
    fills, reset_at = np.zeros(gathered.shape[1:], np.int64), np.zeros(gathered.shape[1:])
    for boundary in range(4, 65, 4):
        full = gathered[boundary] - reset_at > round(0.80 * 30000 / STEP_E) * STEP_E
        fills += full
        reset_at = np.where(full, gathered[boundary], reset_at)
    return gathered[4], {"fills": fills}


ORACLES: dict[str, Callable[[Floats], Expected]] = {
    oracle.__name__: oracle for oracle in (auto_exposure, first_light, float_pixel, spike)
}


def test_every_example_that_looks_has_an_oracle() -> None:
    assert {path.stem for path in LOOKING} == set(ORACLES)


@pytest.mark.parametrize("name", ORACLES)
def test_frames_match_the_comments_of_the_examples(name: str, tmp_path: Path) -> None:
    """Electrons and states are those of a numpy rule over the running sum of the light. Each state
    takes several values."""
    path = ROOT / "examples" / f"{name}.nsl"
    scene = ["--scene", "builtin:hdr", "--exposure", "300000"]
    fine(["run", path, *scene, "-o", "f.npz", "--keep", "light,truth"], tmp_path)
    with np.load(tmp_path / "f.npz") as data:
        light = data["light"].astype(np.float64)
        gathered = np.concatenate([np.zeros((1, *light.shape[1:])), np.cumsum(light, axis=0)])
        exposure, states = ORACLES[name](gathered)
        np.testing.assert_allclose(data["exposure_e"][0], exposure, rtol=1e-9, atol=1e-6)
        for state, values in states.items():
            assert np.array_equal(data[f"states_{state}"], values)
            assert len(np.unique(values)) > 1 or name == "auto_exposure"


def test_the_example_float_pixel_is_reconstructed_to_1_percent(tmp_path: Path) -> None:
    """Above 5000 electrons, the median error is below 1 %, while shutters close at different
    slots."""
    path = ROOT / "examples" / "float_pixel.nsl"
    scene = ["--scene", "builtin:hdr", "--exposure", "300000"]
    fine(["run", path, *scene, "-o", "f.npz", "--keep", "truth"], tmp_path)
    fine(["reconstruct", "f.npz", "-o", "r.npz"], tmp_path)
    with np.load(tmp_path / "r.npz") as data:
        image = data["image"]
    with np.load(tmp_path / "f.npz") as data:
        truth = data["truth_e"]
        assert len(np.unique(data["open_slots"])) > 3
    bright = truth > 5000
    assert np.median(np.abs(image / truth - 1)[bright]) < 0.01


def test_the_example_auto_exposure_settles_within_six_frames(tmp_path: Path) -> None:
    path = ROOT / "examples" / "auto_exposure.nsl"
    scene = ["--scene", "builtin:hdr", "--exposure", "100000@90"]
    fine(["run", path, *scene, "-o", "f.npz", "--repeat", "6", "--keep", "truth"], tmp_path)
    with np.load(tmp_path / "f.npz") as data:
        was, exposure, truth = data["states_was"], data["exposure_e"][:, 0], data["truth_e"]
    assert np.array_equal(was[1:], data_of(tmp_path, "states_stop")[:-1])
    reachable = (truth > 0.35 * 30000) & (truth < 0.7 * 30000 * 16)
    settled = (exposure[-1] > 0.29 * 30000) & (exposure[-1] < 0.82 * 30000)
    assert settled[reachable].mean() > 0.99
    assert not ((exposure[0] > 0.29 * 30000) & (exposure[0] < 0.82 * 30000))[reachable].all()


def data_of(folder: Path, key: str) -> NDArray[np.int64]:
    """An array of the frame file."""
    with np.load(folder / "f.npz") as data:
        return np.asarray(data[key])


def test_a_look_takes_at_most_fourteen_words(tmp_path: Path) -> None:
    path = ROOT / "examples" / "float_pixel.nsl"
    fine(["build", path, "-O", "2", "-o", "a.icw", "--emit", "report"], tmp_path)
    report = json.loads((tmp_path / "a.report.json").read_text())
    assert report["looks"]["boundaries"] == [1, 2, 4, 8, 16, 32, 64, 128]
    assert (report["words_total"] - report["kernels"][0]["words"]) / 9 <= 14
    assert len(report["digital_registers"]) <= 13


def test_unsupported_outputs_and_lowerings_of_looks_are_refused(tmp_path: Path) -> None:
    path = ROOT / "examples" / "float_pixel.nsl"
    for arguments, code in (
        (["shutters", path, "-o", "s.npz"], "NS0444"),
        (["build", path, "-o", "a.icw", "--lowering", "accumulate"], "NS0414"),
    ):
        refused = invoke(arguments, tmp_path)
        assert (refused.status, refused.codes[-1:]) == (1, [code])


def fine(arguments: list[str | Path], folder: Path) -> Outcome:
    """A command that must succeed, without a warning."""
    outcome = invoke(arguments, folder)
    assert outcome.status == 0, outcome.err
    assert "warning[" not in outcome.err
    return outcome
