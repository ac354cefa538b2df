"""Recipe: an effect of another distribution's, from its sensor file to the audit of its plans."""

import json
from pathlib import Path

import numpy as np
import pytest
from added_package import add_package, nscc_with

SOURCE = """
from nscc_runtime.effects import CannotHave, Effect, parameter
from nscc_runtime.noise import key, normals
def offsets_e(sensor, device_seed, places):  # row * 256 + col
    return sensor.columns_e * normals(key(device_seed, COLUMNS.stream), places % 256)
SLOW = CannotHave("nobody has written it")
COLUMNS = Effect(
    name="columns", stream=1000, kind="fixed", title="offsets of the columns' amplifiers",
    model="exposure + sigma z, z a standard normal number of the device and the column",
    cost="one sum a pixel", applied="to exposures as they leave the pixels",
    absent="this sensor has none",
    parameters=(parameter("columns_e", "readout", 0.0, "e", 0, 1e6, "sigma of a column", "ours"),),
    reference={"readout": lambda pixels, value, bucket: value + pixels.fixed(offsets_e)},
    size="rms of the columns' offsets", sums=SLOW, words=SLOW, cost_ns=1.0,
)
"""
RUN = ("run", "a.nsl", "--scene", "builtin:motion", "--exposure", "20000", "-o", "f.npz")


def test_an_effect_of_another_package_works_in_files_runs_plans_and_audits(tmp_path: Path) -> None:
    add_package(tmp_path, SOURCE, "nscc.effects", "columns", "COLUMNS")
    (tmp_path / "a.nsl").write_text("nsl 1\nframe 4 slots of 1ms\nopen when true\n")
    assert "the columns' offsets" in nscc_with(tmp_path, "effects", "columns").stdout
    toml = nscc_with(tmp_path, "effects", "--toml", "--sensor-set", "columns_e=40").stdout
    (tmp_path / "s.toml").write_text(toml)
    for words in (("none",), ("+columns", "--fidelity", "reference")):
        assert nscc_with(tmp_path, *RUN, "--effects", *words).returncode == 0
    for tolerance, effects, choice in (
        ("5e", "auto", "kept"),
        ("5e", "all", "kept"),
        ("99e", "auto", "dropped"),
        ("60e", "-columns", "dropped"),
    ):
        words = (
            "--sensor",
            "s.toml",
            "--tolerance",
            tolerance,
            "--effects",
            effects,
            "--audit",
            "--verbose",
        )
        done = nscc_with(tmp_path, *RUN, *words)
        assert done.returncode == 0, done.stderr
        meta = json.loads(str(np.load(tmp_path / "f.npz")["meta"]))
        plan, audit = meta["plan"], meta["audit"]
        assert plan["effects"][-1]["decision"] == choice
        assert ("columns: only the reference has it" in done.stderr) == (choice == "kept")
        assert audit["measured_rms_e"] == pytest.approx(plan["predicted_e"], rel=0.15, abs=1e-6)


def test_missing_parts_of_an_effect_are_named(tmp_path: Path) -> None:
    lacking = SOURCE.replace("rms of the columns' offsets", "")
    add_package(tmp_path, lacking, "nscc.effects", "columns", "COLUMNS")
    refused = nscc_with(tmp_path, "effects").stderr
    assert "[NS0905]: the effect 'columns' cannot be used: it lacks `size`" in refused
