"""`nscc tradeoff emulator`: its errors are those of the frames themselves, by sums made here."""

from __future__ import annotations

import csv
import io
from pathlib import Path

import numpy as np
import pytest
from nscc_command import invoke
from PIL import Image

from nscc.chips.load import builtin_target, target_toml
from nscc.compiler import compile_source
from nscc.pipeline import Options
from nscc.source import Source
from nscc_runtime import capture
from nscc_runtime.effects import selected
from nscc_runtime.execution.program import AnalysedProgram
from nscc_runtime.frame_file import Frame
from nscc_runtime.light import Light
from nscc_runtime.reference import frames as reference_frames
from nscc_runtime.sensor import default_sensor
from nscc_training.command_settings import EmulatorStudySettings
from nscc_training.experiments.study import measure as measure_study
from nscc_training.tradeoff.emulator import (
    DRAWN,
    ELECTRONS,
    LSB,
    OTHER_DRAWS,
    PLANNED,
    REFERENCE,
    SUMMED,
    WITH_PLANNING,
    EmulatorStudy,
    Naive,
    NamedLight,
    copy_gb_per_s,
    error,
    floor_ms,
)
from nscc_training.tradeoff.emulator_study import EmulatorBenches, studies_text

ROWS, COLS, SLOTS = 48, 32, 4
TEXT = f"""nsl 1
target "small.toml"
frame {SLOTS} slots of 1ms
code stop : 1..{SLOTS}
open when n < stop
pixels stop = tile [[4, 3], [2, 1]]
"""
POOLED = 43
"""Frames of 48 x 32 pixels that make 65536."""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder with a small target and a program for it."""
    text = target_toml(builtin_target("scamp5"))
    small = text.replace("rows = 256", f"rows = {ROWS}").replace("cols = 256", f"cols = {COLS}")
    (tmp_path / "small.toml").write_text(small)
    (tmp_path / "p.nsl").write_text(TEXT)
    return tmp_path


@pytest.fixture
def program(folder: Path) -> AnalysedProgram:
    container = compile_source(Source("p.nsl", TEXT), folder, Options()).container
    return AnalysedProgram.of(container, default_sensor(container.target))


def clip(scale: float = 400.0) -> Light:
    rng = np.random.default_rng(3)
    return Light.of_clip((scale * rng.random((SLOTS, ROWS, COLS))).astype(np.float32))


def opened() -> np.ndarray:
    """Which pixels are open in which slot (SLOTS, ROWS, COLS), from the program's text."""
    y, x = np.mgrid[:ROWS, :COLS]
    stop = np.array([[4, 3], [2, 1]])[y % 2, x % 2]
    return np.arange(SLOTS)[:, None, None] < stop


def measure(
    program: AnalysedProgram, scenes: list[NamedLight], settings: EmulatorStudySettings
) -> tuple[EmulatorStudy, ...]:
    benches = EmulatorBenches.of(program, scenes, settings)
    return benches.results(measure_study(benches.study()))


def rms(away: np.ndarray) -> float:
    return float(np.sqrt(np.mean(away.astype(np.float64) ** 2)))


def test_errors_of_the_study_equal_those_computed_from_the_frames(program: AnalysedProgram) -> None:
    light = clip()
    settings = EmulatorStudySettings((2.0, 40.0), 10.0, 2, 3, seed=5, device_seed=6)
    scenes = [NamedLight("a", light), NamedLight("b", clip(30.0))]
    first, second = measure(program, scenes, settings)
    assert (first.scene, second.scene) == ("a", "b")

    container, sensor = program.container, program.sensor
    truth = [
        *reference_frames(
            container, light, sensor, selected("all"), seed=5, device_seed=6, count=POOLED
        )
    ]
    exposures = np.stack([each.exposure_e for each in truth])[:, 0]
    codes = np.stack([each.frame for each in truth])[:, 0].astype(float)
    found = {(p.method, p.setting, p.error_unit): p for p in first.points}
    assert list(found) == [
        (*key, unit)
        for unit in (ELECTRONS, LSB)
        for key in (
            (REFERENCE, "all"),
            (OTHER_DRAWS, "all"),
            (SUMMED, "none"),
            (DRAWN, "shot"),
            (PLANNED, "2e"),
            (PLANNED, "40e"),
            (WITH_PLANNING, "2e"),
            (WITH_PLANNING, "40e"),
        )
    ]

    def is_found(key: tuple[str, str], away_e: float, away_lsb: float) -> None:
        assert found[(*key, ELECTRONS)].error == pytest.approx(away_e, rel=1e-6)
        assert found[(*key, LSB)].error == pytest.approx(away_lsb, rel=1e-9)

    is_found((REFERENCE, "all"), 0.0, 0.0)
    is_found((OTHER_DRAWS, "all"), rms(exposures[1:] - exposures[:-1]), rms(codes[1:] - codes[:-1]))
    assert first.resolution(ELECTRONS) == found[OTHER_DRAWS, "all", ELECTRONS].error
    assert first.resolution(LSB) == found[OTHER_DRAWS, "all", LSB].error
    plain = (light.frames * opened()).sum(axis=0)
    plain_codes = np.clip(np.rint(plain / sensor.electrons_per_lsb), 0, 255)
    is_found((SUMMED, "none"), rms(exposures - plain), rms(codes - plain_codes))
    for tolerance, asked in zip((2.0, 40.0), first.measured_plans, strict=True):
        taken = capture(container, light, sensor=sensor, plan=asked.plan, device_seed=6, audit=True)
        away_e = taken.audit.measured_rms_e
        is_found((PLANNED, f"{tolerance:g}e"), away_e, away_e / sensor.electrons_per_lsb)
        assert asked.tolerance_e == tolerance
        assert asked.measured_e == pytest.approx(away_e)
        assert asked.keeps_promise
    assert first.budget.tolerance_e == 10.0
    for point in first.points:
        assert len(point.times_ms) == (POOLED if "reference" in point.method else 3)
        assert min(point.times_ms) > 0
    for unit in (ELECTRONS, LSB):
        plan_known, plan_made = (found[m, "2e", unit] for m in (PLANNED, WITH_PLANNING))
        assert plan_known.error == plan_made.error
        pairs = zip(plan_known.times_ms, plan_made.times_ms, strict=True)
        assert all(known < made for known, made in pairs)


@pytest.mark.parametrize(("frames", "repeats"), [(1, 1), (2, 0)])
def test_too_few_frames_or_repeats_are_refused(
    program: AnalysedProgram, frames: int, repeats: int
) -> None:
    """One frame, or no repeat, gives a ValueError with both numbers."""
    with pytest.raises(ValueError, match=f"{frames} frames, {repeats} repeats"):
        measure(program, [], EmulatorStudySettings(frames=frames, repeats=repeats))


def test_naive_simulations_give_the_frames_of_the_emulator(
    program: AnalysedProgram, monkeypatch: pytest.MonkeyPatch
) -> None:
    light = clip(50.0)
    ready = Naive(program, light)
    summed, drawn = ready.summed(), ready.drawn(1)
    plain = (light.frames * opened()).sum(axis=0, dtype=np.float64)
    np.testing.assert_allclose(summed.exposure_e[0], plain, rtol=1e-6)
    away = (drawn.exposure_e[0] - plain) / np.sqrt(plain)
    assert abs(away.mean()) < 5 / np.sqrt(away.size), "Poisson has its mean"
    assert abs((away**2).mean() - 1) < 5 * np.sqrt(2.2 / away.size), "and its variance"
    assert np.array_equal(drawn.exposure_e, np.rint(drawn.exposure_e))
    assert not np.array_equal(drawn.exposure_e, ready.drawn(2).exposure_e)
    monkeypatch.setattr("nscc_training.tradeoff.emulator._MOST_BYTES", 0)
    by_slot = Naive(program, light)
    np.testing.assert_array_equal(by_slot.summed().exposure_e, summed.exposure_e)
    np.testing.assert_array_equal(by_slot.drawn(1).exposure_e, drawn.exposure_e)


def test_each_bucket_has_its_own_shutter(folder: Path) -> None:
    text = TEXT.replace(
        "open when n < stop", "bucket early open when n < stop\nbucket late open when n >= stop"
    )
    container = compile_source(Source("p.nsl", text), folder, Options()).container
    light = clip()
    found = Naive(AnalysedProgram.of(container, default_sensor(container.target)), light).summed()
    for bucket, here in (("early", opened()), ("late", ~opened())):
        values = found.exposure_e[container.buckets.index(bucket)]
        np.testing.assert_allclose(values, (light.frames * here).sum(axis=0), rtol=1e-5, atol=1e-3)


def test_a_study_with_light_too_bright_for_numpy_leaves_out_the_method_that_draws_with_it(
    program: AnalysedProgram,
) -> None:
    settings = EmulatorStudySettings((5.0,), repeats=1)
    [study] = measure(program, [NamedLight("bright", clip(1e25))], settings)
    [refused] = study.refused
    assert refused.method == DRAWN
    assert {p.method for p in study.points} == {
        REFERENCE,
        OTHER_DRAWS,
        SUMMED,
        PLANNED,
        WITH_PLANNING,
    }
    assert f"no {DRAWN}: {refused.reason}" in studies_text([study], 1.0)


def frame(exposure: list[list[float]], codes: list[list[int]], valid: list[list[bool]]) -> Frame:
    """Two buckets of two pixels."""
    return Frame(
        np.array(codes, np.uint8)[:, None],
        np.array(exposure, np.float64)[:, None],
        np.array(valid)[:, None],
        np.zeros((len(codes), 1, len(codes[0])), np.uint8),
    )


def test_errors_are_of_the_worst_bucket_and_of_valid_pixels() -> None:
    all_valid = [[True, True], [True, True]]
    zero = frame([[0, 0], [0, 0]], [[0, 0], [0, 0]], all_valid)
    found = frame([[3, 4], [1, np.nan]], [[0, 0], [2, 0]], [[True, True], [True, False]])
    # Electrons: sqrt((9 + 16) / 2) of the first bucket. Codes: 2 in the only valid pixel of the
    # second.
    assert error([found], [zero]) == (pytest.approx(np.sqrt(12.5)), 2.0)
    assert error([zero], [found]) == error([found], [zero]), "codes do not wrap around"
    assert error([found, zero], [zero, zero]) == (
        pytest.approx(np.sqrt(25 / 4)),
        pytest.approx(np.sqrt(4 / 3)),
    )
    nothing = frame([[0, 0], [0, 0]], [[0, 0], [0, 0]], [[True, True], [False, False]])
    assert error([nothing], [zero]) == (np.inf, np.inf)


def test_the_floor_is_the_time_of_copying_the_light() -> None:
    """A still of 1000 float32 pixels at 4 GB/s takes 1 us, however many slots show it."""
    assert copy_gb_per_s() > 0.01
    still = Light.of_still(np.ones((10, 100), np.float32), np.ones(64))
    assert floor_ms(still, 4.0) == pytest.approx(1e-3), "4000 bytes, of 64 slots or one"


@pytest.fixture
def study(program: AnalysedProgram) -> EmulatorStudy:
    [found] = measure(program, [NamedLight("s", clip())], EmulatorStudySettings((5.0,), repeats=1))
    return found


def test_an_exceeded_tolerance_is_reported(study: EmulatorStudy, folder: Path, monkeypatch) -> None:
    [asked] = study.measured_plans
    assert asked.keeps_promise
    # The tolerance of 5 electrons has a tenth of slack.
    assert asked._replace(measured_e=5.49).keeps_promise
    assert "BROKEN" not in studies_text([study], 1.0)
    broken = study._replace(measured_plans=(asked._replace(measured_e=5.51),))
    assert not broken.measured_plans[0].keeps_promise
    assert "PROMISE BROKEN" in studies_text([broken], 1.0)
    monkeypatch.setattr(EmulatorBenches, "results", lambda *_: (broken,))
    done = invoke(["tradeoff", "emulator", "p.nsl", "-o", "out"], folder)
    assert done.status == 1
    assert (folder / "out.csv").exists(), "what was measured is there to be looked at"


ARGUMENTS = [
    "tradeoff",
    "emulator",
    "p.nsl",
    "--scene",
    "builtin:hdr",
    "--scene",
    "builtin:flat:100",
    "--tolerances",
    "20e,0.1lsb",
    "--repeats",
    "2",
]


def test_command_writes_tables_csv_and_pictures(folder: Path) -> None:
    done = invoke([*ARGUMENTS, "-o", "out", "--budget", "3e"], folder)
    assert done.status == 0, done.err
    pictures = ["out.png", "out_calibration.png", "out_budget.png"]
    assert f"wrote {', '.join(['out.csv', *pictures])}" in done.err
    for name in pictures:
        Image.open(folder / name).load()
    rows = list(csv.DictReader(io.StringIO((folder / "out.csv").read_text())))
    assert [(row["method"], row["setting"]) for row in rows if row["error_unit"] == LSB] == [
        (f"{scene}, {method}", setting)
        for scene in ("builtin:hdr", "builtin:flat:100")
        for method, settings in (
            (REFERENCE, ["all"]),
            (OTHER_DRAWS, ["all"]),
            (SUMMED, ["none"]),
            (DRAWN, ["shot"]),
            (PLANNED, ["0.1lsb", "20e"]),
            (WITH_PLANNING, ["0.1lsb", "20e"]),
        )
        for setting in settings
    ]
    for row in rows:
        scene = row["method"].split(",")[0]
        better = [
            other
            for other in rows
            if other["method"].split(",")[0] == scene
            and other["error_unit"] == row["error_unit"]
            and float(other["error"]) <= float(row["error"])
            and float(other["time_ms"]) <= float(row["time_ms"])
            and (other["error"], other["time_ms"]) != (row["error"], row["time_ms"])
        ]
        assert row["dominated"] == ("yes" if better else "no")
    assert done.out.count("error budget of 3 e") == 2
    assert done.out.count(f"  0.1lsb, {0.1 * 30000 / 255:.3g}e  ") == 2
    for name in ("shot", "crosstalk", "adc"):
        assert f"\n  {name} " in done.out
    again = invoke([*ARGUMENTS, "--csv", "again.csv"], folder)
    assert again.status == 0
    repeated = list(csv.DictReader(io.StringIO((folder / "again.csv").read_text())))
    same = ("method", "setting", "error", "error_unit", "device")
    assert [[row[k] for k in same] for row in repeated] == [[row[k] for k in same] for row in rows]
    other = invoke([*ARGUMENTS, "--csv", "other.csv", "--seed", "1"], folder)
    assert other.status == 0
    assert (folder / "other.csv").read_text() != (folder / "again.csv").read_text()
    assert sorted(path.name for path in folder.iterdir()) == sorted(
        ["p.nsl", "small.toml", "out.csv", "again.csv", "other.csv", *pictures]
    )


@pytest.mark.parametrize(
    ("more", "code"),
    [
        (["--tolerances", "5"], "NS0746"),
        (["--tolerances", ""], "NS0746"),
        (["--tolerances", "1e,0e"], "NS0746"),
        (["--budget", "x"], "NS0746"),
        (["--frames", "1"], "NS0783"),
        (["--csv", "a", "--png", "a"], "NS0745"),
        (["--png", "a.jpg"], "NS0786"),
        (["--csv", "out_budget.png"], "NS0745"),
        (["--repeats", "0"], "NS0783"),
        (["--scene", "builtin:none"], "NS0731"),
        (["--sensor-set", "no_such=1"], "NS0753"),
    ],
)
def test_tradeoff_emulator_refuses_wrong_usage(folder: Path, more: list[str], code: str) -> None:
    done = invoke(["tradeoff", "emulator", "p.nsl", "-o", "out", *more], folder)
    assert (done.status, done.codes) == (2, [code]), done.err
    assert not (folder / "out.csv").exists()


def test_files_with_equal_names_are_distinguished(folder: Path) -> None:
    """Two scenes `s.npy` are named with their folders. One alone is named `s`."""
    for name in ("a", "b"):
        (folder / name).mkdir()
        np.save(folder / name / "s.npy", clip().frames)
    arguments = ["tradeoff", "emulator", "p.nsl", "--tolerances", "5e", "--repeats", "1"]
    done = invoke([*arguments, "--scene", "a/s.npy", "--scene", "b/s.npy"], folder)
    assert done.status == 0, done.err
    assert "\na/s.npy: " in done.out
    assert "\nb/s.npy: " in done.out
    done = invoke([*arguments, "--scene", "a/s.npy"], folder)
    assert "\ns: " in done.out
