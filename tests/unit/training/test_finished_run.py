"""Runs in Python: reconstructions are the command's, curves the file's, mistakes are told."""

from __future__ import annotations

import csv
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from notebook_page import checked
from nscc_command import invoke

pytest.importorskip("torch")

from small_runs import trained

import nscc
import nscc_runtime
import nscc_training


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> nscc_training.Run:
    # Without jitter the tile keeps its few codes, and a drawing shows each of them.
    few_codes = {"jitter": 0.0}
    return nscc_training.load_run(trained(tmp_path_factory.mktemp("runs") / "r", shutter=few_codes))


def test_reconstruct_in_python_equals_the_command(run: nscc_training.Run, tmp_path: Path) -> None:
    """A capture, its file, its codes as bytes and as whole numbers give the image that the command
    writes, in float32."""
    taken = nscc_runtime.capture(run.program, "builtin:hdr")
    path = taken.save(tmp_path / "frame.npz")
    outcome = invoke(["reconstruct", str(run.path), "frame.npz", "-o", "r.npz"], tmp_path)
    assert outcome.status == 0, outcome.err
    wanted = np.load(tmp_path / "r.npz")["image"]
    assert wanted.shape == taken.truth_e.shape
    for frame in (taken, path, taken.frame, taken.frame[0].astype(int)):
        found = run.reconstruct(frame)
        assert found.dtype == np.float32
        np.testing.assert_array_equal(found, wanted)


def test_capture_of_a_run_writes_the_frame_file_of_nscc_run_like(
    run: nscc_training.Run, tmp_path: Path
) -> None:
    """The file has the bytes that `nscc run --like` writes. `exposure=1e6` sets the light's 99th
    percentile."""
    line = ["run", "--like", str(run.path), "--scene", "builtin:hdr", "-o", "c.npz"]
    outcome = invoke(line, tmp_path)
    assert outcome.status == 0, outcome.err
    saved = run.capture("builtin:hdr").save(tmp_path / "python.npz")
    assert saved.read_bytes() == (tmp_path / "c.npz").read_bytes()
    bright = run.capture(nscc_runtime.scene("builtin:hdr", exposure=1e6))
    assert np.percentile(bright.truth_e, 99) == pytest.approx(1e6, rel=1e-3)


@pytest.mark.filterwarnings(r"ignore:warning\[NS0842\]")
def test_the_dark_level_is_subtracted(run: nscc_training.Run, tmp_path: Path) -> None:
    """With dark frames given, Python and `--dark` give the same image, from objects and from
    files."""
    taken = run.capture("builtin:hdr", effects="auto")
    dark = run.capture("builtin:dark", effects="auto", repeat=3)
    path, without = taken.save(tmp_path / "f.npz"), dark.save(tmp_path / "d.npz")
    line = ["reconstruct", str(run.path), "f.npz", "--dark", "d.npz", "-o", "r.npz"]
    outcome = invoke(line, tmp_path)
    assert outcome.status == 0, outcome.err
    wanted = np.load(tmp_path / "r.npz")["image"]
    np.testing.assert_array_equal(run.reconstruct(taken, dark=dark), wanted)
    np.testing.assert_array_equal(run.reconstruct(path, dark=without), wanted)


def test_colours_are_reconstructed_one_by_one(run: nscc_training.Run, tmp_path: Path) -> None:
    """A photo of 48 x 56 in three colours comes back in this shape, from the capture and from its
    file alike."""
    import cv2

    photo = np.random.default_rng(4).integers(0, 255, (48, 56, 3), np.uint8)
    cv2.imwrite(str(tmp_path / "photo.png"), photo)
    scene = nscc_runtime.scene(tmp_path / "photo.png", fit="tiles", color=True)
    taken = run.capture(scene)
    path = taken.save(tmp_path / "f.npz")
    found = run.reconstruct(taken)
    assert found.shape == (48, 56, 3)
    np.testing.assert_array_equal(found, run.reconstruct(path))


def test_a_frame_of_another_program_is_refused(run: nscc_training.Run) -> None:
    """NS0819 names the capture as the fault. With `force=True` it is a warning, and an image of the
    other size comes."""
    other = nscc.compile("nsl 1\nframe 4 slots of 8ms\nopen when true\n", level=1)
    taken = nscc_runtime.capture(other, "builtin:hdr")
    with pytest.raises(nscc.Rejected, match=r"NS0819.*the capture.*program is not the run's"):
        run.reconstruct(taken)
    with pytest.warns(UserWarning, match="NS0819"):
        assert run.reconstruct(taken, force=True).shape == other.shape


@pytest.mark.parametrize(
    ("frame", "words"),
    [
        (np.ones((256, 256)), r"its codes \(256, 256\), not an array \(256, 256\) of float64"),
        (np.ones((4, 4), np.uint8), r"not an array \(4, 4\) of uint8"),
        (np.full((256, 256), 300), r"codes must be 0..255, but these are 300..300"),
        (None, "not None"),
    ],
)
def test_files_that_are_not_frames_are_refused(
    run: nscc_training.Run, frame: Any, words: str
) -> None:
    """Codes in floating point, of another shape, above 255, and None each give a TypeError that
    says what was given."""
    with pytest.raises(TypeError, match=words):
        run.reconstruct(frame)


def test_only_one_exposure_is_reconstructed(run: nscc_training.Run) -> None:
    taken = nscc_runtime.capture(run.program, "builtin:dark", repeat=2)
    with pytest.raises(TypeError, match="one bucket of one exposure"):
        run.reconstruct(taken)


def test_folders_that_are_not_runs_are_refused(tmp_path: Path) -> None:
    """An empty folder gives NS0818. A number in place of a path gives a TypeError."""
    with pytest.raises(nscc.Rejected, match="NS0818"):
        nscc_training.load_run(tmp_path)
    with pytest.raises(TypeError, match="load_run takes a path, not 3"):
        nscc_training.load_run(3)  # type: ignore[arg-type]


def test_curves_of_a_run_have_the_values_of_metrics_csv(run: nscc_training.Run) -> None:
    """Each column of `metrics.csv` is a curve. An empty cell reads as NaN, and the split is true
    for `val`."""
    rows = [*csv.DictReader((run.path / "metrics.csv").read_text().splitlines())]
    assert [*run.curves] == [*rows[0]]
    for number, row in enumerate(rows):
        assert run.curves["split"][number] == (row["split"] == "val")
        for name in row.keys() - {"split"}:
            value = run.curves[name][number]
            assert np.isnan(value) if row[name] == "" else value == float(row[name])


def test_a_run_is_shown_as_a_line_and_as_curves_and_codes(run: nscc_training.Run) -> None:
    """Its `repr` is one line with the last PSNR. Its page names the curves, the stop codes and the
    program."""
    assert "\n" not in repr(run)
    assert f"{run.curves['psnr_db'][-1]:.2f} dB" in repr(run)
    words = {*checked(run).words}
    stops = {f"stop {stop}" for stop in np.unique(run.encoder.codes()["stop"])}
    assert stops | {"validation PSNR in dB", "training loss", "the program"} <= words
    assert run.program.codes["stop"].tolist() == sorted({*run.encoder.codes()["stop"].flat})


@pytest.mark.parametrize(("light", "warned"), [("3000000", True), ("3000", False)])
def test_a_mostly_saturated_frame_gives_a_warning(
    run: nscc_training.Run, tmp_path: Path, light: str, warned: bool
) -> None:
    """The decoder of a run and the decoder for any code both warn and reconstruct."""
    run.capture(f"builtin:flat:{light}").save(tmp_path / "f.npz")
    for decoder in (str(run.path), "any"):
        outcome = invoke(["reconstruct", decoder, "f.npz", "-o", "r.npz"], tmp_path)
        assert outcome.status == 0, outcome.err
        assert ("100 % of the pixels of 'f.npz' are saturated" in outcome.err) == warned
        assert ("NS0844" in outcome.err) == warned
