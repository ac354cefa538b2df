"""`nscc run` with a changed sensor, then `nscc calibrate`: the sensor comes back."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from nscc_command import invoke

SIZE = 128
FLAT_MS = (4, 8, 12, 16, 20, 24, 28, 60)
DARK_MS = (1, 30, 60)
SENSOR = {
    "full_well_e": 4400.0,
    "electrons_per_lsb": 20.0,
    "adc_offset_lsb": 14.0,
    "adc_noise_lsb": 0.0,
    "read_noise_e": 25.0,
    "dark_current_e_per_s": 2500.0,
    "dark_spread_fraction": 0.3,
    "prnu_fraction": 0.016,
    "crosstalk_fraction": 0.006,
}
LIGHT_E_PER_S = 100_000.0


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Programs that are open for some milliseconds, an evenly lit scene, a small chip."""
    toml = invoke(["targets", "scamp5", "--toml"], tmp_path).out
    for name in ("rows", "cols"):
        toml = toml.replace(f"\n{name} = 256", f"\n{name} = {SIZE}")
    (tmp_path / "small.toml").write_text(toml)
    np.savez(tmp_path / "lit.npz", light=np.full((SIZE, SIZE), LIGHT_E_PER_S, np.float32))
    np.savez(tmp_path / "dim.npz", light=np.zeros((SIZE, SIZE), np.float32))
    for ms in {*FLAT_MS, *DARK_MS}:
        (tmp_path / f"p{ms}.nsl").write_text(
            f"nsl 1\ntarget scamp5\nframe 4 slots of {250 * ms}us\nopen when n < 4\n"
        )
    return tmp_path


def taken(folder: Path, effects: str, sensor: list[str], seed: int = 0) -> list[str]:
    """Frame files of flats and darks as the arguments of `nscc calibrate`."""
    names: list[str] = []
    for kind, scene, times, count in (
        ("flat", "lit.npz", FLAT_MS, 10),
        ("dark", "dim.npz", DARK_MS, 8),
    ):
        names += ["--dark"] if kind == "dark" else []
        for ms in times:
            seed += 1
            name = f"{kind}{ms}.npz"
            found = invoke(
                [
                    "run",
                    f"p{ms}.nsl",
                    "--scene",
                    scene,
                    "--lowering",
                    "edges",
                    "--target",
                    "small.toml",
                    "--effects",
                    effects,
                    "--fidelity",
                    "reference",
                    "--repeat",
                    str(count),
                    "--seed",
                    str(seed),
                    "--device-seed",
                    "5",
                    "-o",
                    name,
                    *sensor,
                ],
                folder,
            )
            assert found.status == 0, found.err
            names.append(name)
    return names


def calibrated(folder: Path, names: list[str], *more: str) -> dict:
    words = ["calibrate", *names, "-o", "found.toml", "--json", "--target", "small.toml", *more]
    found = invoke(words, folder)
    assert found.status == 0, found.err
    return json.loads(found.out)


def test_calibration_finds_the_sensor_of_the_emulator(folder: Path) -> None:
    changes = [word for k, v in SENSOR.items() for word in ("--sensor-set", f"{k}={v}")]
    effects = "shot,prnu,dark,read,crosstalk,full_well"
    names = taken(folder, effects, changes)
    build = ["build", "p4.nsl", "--lowering", "edges", "--target", "small.toml", "-o", "p4.icw"]
    assert invoke(build, folder).status == 0
    found = calibrated(folder, names, "--program", "p4.icw")["parameters"]
    for name, value in SENSOR.items():
        choice = found[name]
        if name in ("adc_offset_lsb", "adc_noise_lsb"):
            assert choice["value"] == value
        else:
            assert choice["status"] == "measured"
            assert abs(choice["value"] - value) < 4 * choice["standard_error"], (name, choice)
            assert choice["standard_error"] < 0.05 * value or name == "crosstalk_fraction"
    assert abs(found["analog_bias_lsb"]["value"]) < 4 * found["analog_bias_lsb"]["standard_error"]
    pattern = found["adc_pattern_lsb"]
    assert pattern["value"] < 4 * pattern["standard_error"] < 0.5


def test_a_calibrated_emulator_takes_the_same_frames(folder: Path) -> None:
    """Frames with every effect have many noise sources; the calibrated file contains their sums."""
    changes = {
        **SENSOR,
        "adc_noise_lsb": 0.65,
        "analog_lsb_e": 20.0,
        "analog_noise_lsb": 0.75,
        "analog_bias_lsb": 0.3,
        "analog_pattern_lsb": 0.2,
        "adc_level_lsb": 0.0,
    }
    given = [word for k, v in changes.items() for word in ("--sensor-set", f"{k}={v}")]
    names = taken(folder, "all", given)
    build = ["build", "p4.nsl", "--lowering", "edges", "--target", "small.toml", "-o", "p4.icw"]
    assert invoke(build, folder).status == 0
    first = calibrated(folder, names, "--program", "p4.icw")
    again = taken(folder, "all", ["--sensor", "found.toml"], seed=100)
    second = calibrated(folder, again, "--program", "p4.icw")
    for name in ("dark_noise_lsb", "offset", "dsnu_lsb", "dark_current", "prnu", "dark_spread"):
        one, other = first["quantities"][name], second["quantities"][name]
        error = np.hypot(one["standard_error"], other["standard_error"])
        assert abs(one["value"] - other["value"]) < 4 * error + 0.01 * one["value"], name
    gain = first["quantities"]["system_gain"]
    unsure = 4 * gain["standard_error"] / gain["value"]
    assert unsure < 0.05
    for one, other in zip(first["flats"], second["flats"], strict=True):
        assert one["mean_lsb"] == pytest.approx(other["mean_lsb"], rel=unsure)
        assert one["variance_lsb2"] == pytest.approx(other["variance_lsb2"], rel=0.03 + unsure)
    for one, other in zip(first["darks"], second["darks"], strict=True):
        assert one["mean_lsb"] == pytest.approx(other["mean_lsb"], abs=0.05)
        assert one["variance_lsb2"] == pytest.approx(other["variance_lsb2"], rel=0.03)
