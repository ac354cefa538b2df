"""`nscc run` with sensor effects: files, repeats, what meta says, refusals."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path

import numpy as np
import pytest
from nscc_command import Outcome, invoke

from nscc_runtime.effects import optional, registered

PROGRAM = """nsl 1
target "small.toml"
frame 4 slots of 1ms
code stop : 0..4
open when n < stop
pixels stop = x % 5
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    text = invoke(["targets", "scamp5", "--toml"], tmp_path).out
    small = text.replace("rows = 256", "rows = 8").replace("cols = 256", "cols = 10")
    (tmp_path / "small.toml").write_text(small)
    (tmp_path / "p.nsl").write_text(PROGRAM)
    return tmp_path


def run(folder: Path, *arguments: str, scene: str = "builtin:flat:2000") -> Outcome:
    return invoke(["run", "p.nsl", "--scene", scene, "-o", "f.npz", *arguments], folder)


def loaded(folder: Path) -> tuple[dict[str, np.ndarray], dict[str, object]]:
    with np.load(folder / "f.npz") as file:
        arrays = {name: file[name] for name in file.files}
    return arrays, json.loads(str(arrays.pop("meta")))


REFERENCE = ("--fidelity", "reference", "--effects")


@pytest.mark.parametrize("lowering", ["accumulate", "latch", "edges"])
def test_all_effects_leave_a_frame_file(lowering: str, folder: Path) -> None:
    outcome = run(folder, *REFERENCE, "all", "--lowering", lowering, "--repeat", "3")
    assert outcome.status == 0, outcome.err
    arrays, meta = loaded(folder)
    assert arrays["frame"].shape == arrays["exposure_e"].shape == (3, 1, 8, 10)
    assert not np.array_equal(arrays["exposure_e"][0], arrays["exposure_e"][1])
    assert meta["fidelity"] == "reference"
    assert meta["lowering"] == lowering
    found = {row["name"]: row for row in meta["plan"]["effects"]}  # type: ignore[index]
    assert list(found) == [effect.name for effect in registered()]
    assert {name for name, row in found.items() if row["decision"] == "absent"} == {"motion"}
    assert not any(row["forced"] for row in found.values())
    assert "the first is described" in outcome.err


def test_meta_says_which_effects_were_forced_and_which_sensor(folder: Path) -> None:
    assert run(folder, "--effects", "none").status == 0
    before, plain = loaded(folder)
    status = run(
        folder,
        *REFERENCE,
        "all,-analog,-lag",
        "--sensor-set",
        "read_noise_e=3",
        "--seed",
        "7",
        "--device-seed",
        "8",
    ).status
    assert status == 0
    _, meta = loaded(folder)
    found = {row["name"]: row for row in meta["plan"]["effects"]}  # type: ignore[index]
    assert (found["lag"]["decision"], found["lag"]["forced"]) == ("dropped", True)
    assert (found["read"]["decision"], found["read"]["forced"]) == ("kept", False)
    assert (meta["seed"], meta["device_seed"]) == (7, 8)
    assert meta["sensor_sha256"] != plain["sensor_sha256"]
    none = {row["name"]: row["decision"] for row in plain["plan"]["effects"]}  # type: ignore[index]
    assert none == {**dict.fromkeys(optional(), "dropped"), "adc": "kept"}
    assert before["exposure_e"][0, 0, :5] == pytest.approx([0, 500, 1000, 1500, 2000])


def test_the_sensor_digest_in_meta_covers_all_values_with_their_defaults(folder: Path) -> None:
    from nscc.chips.load import load_target
    from nscc_runtime.sensor import default_sensor

    assert run(folder, "--effects", "none").status == 0
    _, meta = loaded(folder)
    values = dict(default_sensor(load_target("small.toml", folder)).values)
    text = json.dumps(values, sort_keys=True)
    assert meta["sensor_sha256"] == hashlib.sha256(text.encode()).hexdigest()


def test_a_sensor_file_and_a_change_give_the_same_frame(folder: Path) -> None:
    changes = ("--sensor-set", "read_noise_e=30", "--sensor-set", "electrons_per_lsb=10")
    printed = invoke(["effects", "--toml", *changes], folder).out
    (folder / "s.toml").write_text(printed)
    assert run(folder, *REFERENCE, "all", *changes).status == 0
    first = (folder / "f.npz").read_bytes()
    assert run(folder, *REFERENCE, "all", "--sensor", "s.toml").status == 0
    assert (folder / "f.npz").read_bytes() == first
    assert run(folder, *REFERENCE, "all", "--sensor", "s.toml", "--seed", "1").status == 0
    assert (folder / "f.npz").read_bytes() != first


def test_the_sensors_adc_reads_a_frame_without_effects(folder: Path) -> None:
    changes = ("--sensor-set", "electrons_per_lsb=25", "--sensor-set", "adc_offset_lsb=4")
    assert run(folder, *changes).status == 0
    arrays, meta = loaded(folder)
    assert arrays["frame"][0, 0, :5].tolist() == [4, 24, 44, 64, 84]
    assert (meta["electrons_per_lsb"], meta["adc_offset"]) == (25, 4)


def test_samples_move_within_slots_and_integrals_do_not(folder: Path) -> None:
    light = np.broadcast_to(np.array([1, 3, 2, 6], np.float32)[:, None, None] * 100, (4, 8, 10))
    np.savez(folder / "light.npz", light=light)
    for extra, expected in (
        ((), [0, 100, 400, 600, 1200]),
        (("--frames-are", "samples"), [0, 200, 450, 850, 1450]),
    ):
        outcome = run(folder, *REFERENCE, "motion", *extra, scene="light.npz")
        assert outcome.status == 0, outcome.err
        arrays, meta = loaded(folder)
        assert arrays["exposure_e"][0, 0, :5] == pytest.approx(expected)
        (motion,) = (row for row in meta["plan"]["effects"] if row["name"] == "motion")  # type: ignore[index]
        assert motion["decision"] == ("kept" if extra else "absent")
        assert motion["forced"]


def test_samples_with_a_frame_rate_move_across_slots(folder: Path) -> None:
    from nscc_runtime.scenes.exposure import scale
    from nscc_runtime.scenes.timing import check_fps, overlaps, spread, with_motion

    fps, slot_us = check_fps(400.0), (1000.0, 1500.0, 700.0, 2800.0)
    frames = np.array([10.0, 50.0, 20.0], np.float32)[:, None, None]
    parts = overlaps(slot_us, fps)
    light = spread(frames, parts, lambda open_sum: scale(open_sum, parse("100"), "clip"))
    moving = with_motion(light, parts.seconds, float(fps)).motion
    assert moving is not None
    edges_s = np.concatenate([[0], np.cumsum(slot_us)]) * 1e-6
    for n in range(4):
        t = np.linspace(edges_s[n], edges_s[n + 1], 200_001)
        values = np.interp(t, [0, 1 / 400, 2 / 400], [10.0, 50.0, 20.0])
        integral = np.trapezoid(values, t) * light.exposure_scale_e
        assert moving.slot(n)[0, 0] == pytest.approx(integral, rel=1e-5)


def parse(text: str) -> object:
    from nscc_runtime.scenes import parse_exposure

    return parse_exposure(text)


@pytest.mark.parametrize(
    ("arguments", "code"),
    [
        (["--effects", "auto", "--fidelity", "reference"], "NS0739"),
        ([*REFERENCE, "all", "--tolerance", "5e"], "NS0739"),
        ([*REFERENCE, "all", "--audit"], "NS0739"),
        ([*REFERENCE, "all", "--plan", "p.json"], "NS0739"),
        (["--effects", ""], "NS0756"),
        (["--tolerance", ""], "NS0746"),
        (["--tolerance", "5"], "NS0746"),
        (["--tolerance", "0e"], "NS0746"),
        (["--effects", "all", "--tolerance", "5 mV"], "NS0746"),
        ([*REFERENCE, "shots"], "NS0756"),
        ([*REFERENCE, "all,-adc"], "NS0756"),
        ([*REFERENCE, ""], "NS0756"),
        (["--sensor", "none.toml"], "NS0751"),
        (["--sensor-set", "read_noise_e"], "NS0755"),
        (["--sensor-set", "read_noise=1"], "NS0753"),
        (["--sensor-set", "read_noise_e=-1"], "NS0754"),
        (["--seed", "-1"], "NS0783"),
        (["--fidelity", "best"], "NS0783"),
    ],
)
def test_invalid_options_of_a_run_write_no_frame(
    arguments: list[str], code: str, folder: Path
) -> None:
    outcome = run(folder, *arguments)
    assert outcome.status == 2
    assert code in outcome.codes
    assert not (folder / "f.npz").exists()


def test_words_that_compare_light_are_refused_with_effects_only(folder: Path) -> None:
    (folder / "w.asm").write_text(
        ".target scamp5\n.wait 1000us\n.kernel k\n    all\n    where A\n    bus NEWS, PIX\n"
        "    bus A, NEWS\n    all\n.slot 1 k\n.bucket frame\n.readout A frame 1\n"
    )
    made = invoke(["asm", "w.asm", "-o", "w.icw"], folder)
    assert made.status == 0, made.err
    outcome = invoke(["run", "w.icw", "--scene", "builtin:dark", *REFERENCE, "shot"], folder)
    assert (outcome.status, outcome.codes) == (1, ["NS0442"])
    outcome = invoke(["run", "w.icw", "--scene", "builtin:dark"], folder)
    assert outcome.status == 0, outcome.err
