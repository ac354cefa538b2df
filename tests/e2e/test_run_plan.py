"""`nscc run` by plan: files, audits, plans kept and used again, what is said and how it ends."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from nscc_command import Outcome, invoke

from nscc_runtime.effects import registered
from nscc_runtime.execution import frames

PROGRAM = """nsl 1
target "small.toml"
frame 4 slots of 1ms
code stop : 0..4
open when n < stop
pixels stop = x % 5
"""
META = {
    "tolerance_e",
    "predicted_e",
    "bound_e",
    "slot_loop",
    "slot_loop_reasons",
    "sampled_fraction",
    "worst_e",
    "effects",
}
EFFECT = {
    "name",
    "kind",
    "decision",
    "forced",
    "reason",
    "predicted_rms_e",
    "predicted_bias_e",
    "predicted_if_dropped_e",
    "cost_ms_model",
}
AUDIT = {
    "measured_rms_e",
    "bias_e",
    "std_ratio",
    "samples",
    "mc_error_e",
    "holds",
    "measured_max_e",
    "path_e",
    "path_mc_error_e2",
}


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    text = invoke(["targets", "scamp5", "--toml"], tmp_path).out
    small = text.replace("rows = 256", "rows = 24").replace("cols = 256", "cols = 30")
    (tmp_path / "small.toml").write_text(small)
    (tmp_path / "p.nsl").write_text(PROGRAM)
    return tmp_path


def run(folder: Path, *arguments: str, scene: str = "builtin:flat:2000") -> Outcome:
    return invoke(["run", "p.nsl", "--scene", scene, "-o", "f.npz", *arguments], folder)


def loaded(folder: Path, name: str = "f.npz") -> tuple[dict[str, np.ndarray], dict[str, Any]]:
    with np.load(folder / name) as file:
        arrays = {name: file[name] for name in file.files}
    return arrays, json.loads(str(arrays.pop("meta")))


def test_auto_makes_a_plan_and_says_it_all(folder: Path) -> None:
    outcome = run(
        folder,
        "--effects",
        "auto",
        "--tolerance",
        "2e",
        "--seed",
        "4",
        "--plan",
        "plan.json",
        "--verbose",
    )
    assert outcome.status == 0, outcome.err
    arrays, meta = loaded(folder)
    assert arrays["exposure_e"].shape == (1, 24, 30)
    assert meta["fidelity"] == "planned"
    assert meta["audit"] is None
    plan = meta["plan"]
    assert set(plan) >= META
    assert plan["tolerance_e"] == 2.0
    assert 0 < plan["predicted_e"] <= 1.8
    assert [each["name"] for each in plan["effects"]] == [effect.name for effect in registered()]
    assert all(set(each) >= EFFECT for each in plan["effects"])
    for each in plan["effects"]:
        assert f"\n{each['name']} " in outcome.err
    assert "predicted error" in outcome.err
    assert "words run one by one" in outcome.err
    assert "wrote f.npz" in outcome.err


def test_a_run_prints_one_line_of_its_plan_and_effects_prints_its_table(folder: Path) -> None:
    outcome = run(folder, "--tolerance", "2e", "--plan", "plan.json")
    [line] = [line for line in outcome.err.splitlines() if "simulated" in line]
    assert line.startswith("predicted error ")
    assert "tolerance 2 e" in line
    assert line.endswith(" s")
    assert "why" not in outcome.err
    tables = [invoke(["effects", "--plan", name], folder).out for name in ("plan.json", "f.npz")]
    assert tables[0] == tables[1]
    assert tables[0].splitlines()[0].split()[:2] == ["effect", "rms"]
    assert run(folder, "-o", "none.npz").status == 0
    refused = invoke(["effects", "--plan", "none.npz"], folder)
    assert "its frame was exposed without a plan" in refused.err
    refused = invoke(["effects", "--plan", "p.nsl"], folder)
    assert refused.status == 2
    assert "NS0747" in refused.err


def test_a_frame_that_measuring_would_not_pay_for_has_all_effects(folder: Path) -> None:
    """Figures that were not measured are null, and the table says why."""
    assert run(folder, "--effects", "all", "--seed", "4").status == 0
    every = loaded(folder)[0]["exposure_e"]
    assert "every effect simulated" in run(folder, "--effects", "auto", "--seed", "4").err
    outcome = run(folder, "--effects", "auto", "--seed", "4", "--verbose")
    assert outcome.status == 0, outcome.err
    arrays, meta = loaded(folder)
    assert arrays["exposure_e"].tobytes() == every.tobytes()
    plan = meta["plan"]
    assert [plan[name] for name in ("predicted_e", "bound_e", "worst_e")] == [None] * 3
    assert plan["tolerance"] == "0.15noise"
    assert plan["tolerance_e"] is None
    assert plan["sampled_fraction"] == 0.0
    for each in plan["effects"]:
        if each["decision"] == "kept" and each["kind"] != "after":
            assert each["predicted_rms_e"] is each["predicted_if_dropped_e"] is None
            assert each["reason"] == "choosing effects would take longer than it saves"
    assert "choosing effects would take longer than it saves" in outcome.err
    assert "no error was measured" in outcome.err


def test_options_that_need_a_plan_make_one_without_effects_auto(folder: Path) -> None:
    assert run(folder, "--effects", "auto").status == 0
    expected = (folder / "f.npz").read_bytes()
    assert run(folder, "--tolerance", "0.15noise").status == 0
    assert (folder / "f.npz").read_bytes() == expected
    found = []
    for option in (["--audit"], ["--plan", "plan.json"]):
        assert run(folder, *option).status == 0
        arrays, meta = loaded(folder)
        assert meta["plan"]["tolerance"] == "0.15noise"
        assert meta["plan"]["predicted_e"] <= meta["plan"]["tolerance_e"]
        found.append(arrays["exposure_e"].tobytes())
    assert found[0] == found[1]


def test_the_default_is_no_effects_and_predicts_nothing(folder: Path) -> None:
    assert run(folder).status == 0
    _, meta = loaded(folder)
    plan = meta["plan"]
    assert plan["tolerance_e"] is plan["predicted_e"] is plan["bound_e"] is None
    assert {each["decision"] for each in plan["effects"] if each["name"] != "adc"} == {"dropped"}


def test_a_tolerance_in_codes_is_converted_to_electrons(folder: Path) -> None:
    changes = ("--sensor-set", "electrons_per_lsb=40")
    assert run(folder, "--tolerance", "0.25lsb", *changes).status == 0
    assert loaded(folder)[1]["plan"]["tolerance_e"] == 10.0


@pytest.mark.parametrize("scene", ["builtin:flat:2000", "builtin:hdr", "builtin:dark"])
def test_run_writes_an_audit_that_holds_into_the_frame_file(scene: str, folder: Path) -> None:
    outcome = run(folder, "--audit", "--tolerance", "3e", scene=scene)
    assert outcome.status == 0, outcome.err
    _, meta = loaded(folder)
    report = meta["audit"]
    assert set(report) >= AUDIT
    assert report["holds"] is True
    assert report["measured_rms_e"] <= 3.3
    assert report["samples"] >= 2 * 24 * 30
    assert "the promise holds" in outcome.err


@pytest.mark.parametrize("wrong_e", [7.0, np.nan])
def test_an_audit_of_frames_that_differ_from_the_loop_exits_1(
    wrong_e: float, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Sums whose pixels are wrong by 7 electrons either way, far below their noise of 70, or one of
    which is not a number."""
    draw = frames.draw_exposures

    def wrong(*arguments: Any) -> np.ndarray:
        exposure_e: np.ndarray = draw(*arguments)
        if np.isnan(wrong_e):
            exposure_e[0, 5] = wrong_e
        else:
            exposure_e += wrong_e * (-1.0) ** np.arange(exposure_e.shape[1])
        return exposure_e

    monkeypatch.setattr(frames, "draw_exposures", wrong)
    outcome = run(folder, "--audit", "--tolerance", "5e", scene="builtin:flat:10000")
    assert outcome.status == 1
    assert "the frames differ from the loop by " in outcome.err
    report = loaded(folder)[1]["audit"]
    assert report["measured_rms_e"] < 5.5
    assert report["path_e"] == pytest.approx(1e30 if np.isnan(wrong_e) else 7.0, rel=0.05)


def test_an_audited_error_above_the_tolerance_exits_1_and_leaves_the_files(folder: Path) -> None:
    outcome = run(
        folder,
        "--effects",
        "auto,-shot",
        "--audit",
        "--tolerance",
        "1e",
        "--plan",
        "plan.json",
        "--png",
        "f.png",
        "--repeat",
        "2",
    )
    assert outcome.status == 1
    assert outcome.codes == ["NS0749", "NS0749"]
    assert "turned off: shot" in outcome.err
    assert "BROKEN" in outcome.err
    arrays, meta = loaded(folder)
    assert meta["audit"]["holds"] is False
    # Shot noise of the mean charge, (0 + 500 + .. + 2000) / 5 electrons, after two additions.
    expected_e = meta["sensor"]["analog_gain"] ** 2 * 1000**0.5
    assert meta["audit"]["measured_rms_e"] == pytest.approx(expected_e, rel=0.05)
    assert meta["plan"]["predicted_e"] == pytest.approx(expected_e, rel=0.05)
    assert arrays["frame"].shape == (2, 1, 24, 30)
    assert (folder / "plan.json").exists()
    assert (folder / "f.png").read_bytes().startswith(b"\x89PNG")


def test_effects_that_are_forced_off_give_a_warning(folder: Path) -> None:
    forced = "--effects", "auto,-shot", "--tolerance", "5e"
    outcome = run(folder, *forced)
    assert (outcome.status, outcome.codes) == (0, ["NS0749"])
    assert run(folder, *forced, "--deny-warnings").status == 1
    # Who names all effects one by one has made up their mind.
    assert run(folder, "--effects", "shot,read").codes == []
    assert run(folder, "--effects", "auto,-lag", "--tolerance", "50e").codes == []


def test_a_plan_is_written_once_and_used_again(folder: Path) -> None:
    first = run(folder, "--plan", "plan.json", "--tolerance", "7e")
    assert first.status == 0
    assert "wrote plan.json" in first.err
    kept = (folder / "plan.json").read_bytes()
    frame = (folder / "f.npz").read_bytes()
    again = run(folder, "--plan", "plan.json")
    assert again.status == 0, again.err
    assert (folder / "plan.json").read_bytes() == kept
    assert "wrote plan.json" not in again.err
    arrays, meta = loaded(folder)
    (folder / "g.npz").write_bytes(frame)
    before, plan = loaded(folder, "g.npz")
    assert arrays["exposure_e"].tobytes() == before["exposure_e"].tobytes()
    assert arrays["frame"].tobytes() == before["frame"].tobytes()
    assert meta["plan"]["tolerance_e"] == 7.0
    assert meta["plan"]["predicted_e"] == pytest.approx(plan["plan"]["predicted_e"], rel=1e-6)
    decided = [[(e["name"], e["decision"]) for e in m["plan"]["effects"]] for m in (meta, plan)]
    assert decided[0] == decided[1]


def test_a_plan_on_another_scene_is_predicted_there(folder: Path) -> None:
    assert (
        run(folder, "--plan", "plan.json", "--tolerance", "20e", scene="builtin:dark").status == 0
    )
    outcome = run(folder, "--plan", "plan.json", "--audit", scene="builtin:flat:20000")
    assert outcome.status == 1
    assert "made for another scene" in outcome.err
    _, meta = loaded(folder)
    assert meta["plan"]["predicted_e"] > 20
    assert meta["plan"]["predicted_e"] == pytest.approx(meta["audit"]["measured_rms_e"], rel=0.15)


def test_plans_of_other_programs_and_sensors_are_refused(folder: Path) -> None:
    assert run(folder, "--plan", "plan.json").status == 0
    (folder / "f.npz").unlink()
    outcome = run(folder, "--plan", "plan.json", "--sensor-set", "read_noise_e=3")
    assert (outcome.status, outcome.codes) == (2, ["NS0748"])
    assert "sensor" in outcome.err
    (folder / "p.nsl").write_text(PROGRAM.replace("x % 5", "y % 5"))
    outcome = run(folder, "--plan", "plan.json")
    assert (outcome.status, outcome.codes) == (2, ["NS0748"])
    assert "program" in outcome.err
    assert not (folder / "f.npz").exists()


@pytest.mark.parametrize("option", [["--effects", "auto"], ["--tolerance", "5e"]])
def test_an_existing_plan_cannot_be_combined_with_effects_or_a_tolerance(
    option: list[str], folder: Path
) -> None:
    assert run(folder, "--plan", "plan.json").status == 0
    outcome = run(folder, "--plan", "plan.json", *option)
    assert (outcome.status, outcome.codes) == (2, ["NS0739"])


@pytest.mark.parametrize(
    "content",
    [
        b"",
        b"{}",
        b"[]",
        b"null",
        b"\xff\xfe",
        b"[" * 100000,
        b"NaN",
        b'{"schema": "nscc-plan-1"}',
        b'{"schema": "nscc-plan-9", "plan": {}}',
        b'{"schema": ["nscc-plan-1"]}',
        b"7" * 5000,
    ],
)
def test_invalid_plan_files_are_refused_and_left_unchanged(content: bytes, folder: Path) -> None:
    (folder / "plan.json").write_bytes(content)
    outcome = run(folder, "--plan", "plan.json")
    assert (outcome.status, outcome.codes) == (2, ["NS0747"])
    assert "Error" not in outcome.err.replace("error[", "")  # in words, not Python's
    assert (folder / "plan.json").read_bytes() == content
    assert not (folder / "f.npz").exists()


def test_damaged_plans_are_refused_or_are_plans(folder: Path) -> None:
    """Every value of a plan's file replaced by another kind of value."""
    assert run(folder, "--plan", "plan.json").status == 0
    values = json.loads((folder / "plan.json").read_text())
    for name in values["plan"]:
        for junk in (None, "x", [], -1, float("nan"), float("inf"), {"a": 1}, 10**400):
            changed = {**values, "plan": {**values["plan"], name: junk}}
            (folder / "plan.json").write_text(json.dumps(changed))
            outcome = run(folder, "--plan", "plan.json")
            assert outcome.status in (0, 2), (name, junk, outcome.err)
            # Other damage may leave a plan that is valid.
            if outcome.status == 2:
                assert outcome.codes == ["NS0747"]


def test_a_folder_given_as_a_plan_is_refused(folder: Path) -> None:
    (folder / "plans").mkdir()
    outcome = run(folder, "--plan", "plans")
    assert (outcome.status, outcome.codes) == (2, ["NS0747"])


def test_the_same_input_gives_the_same_bytes(folder: Path, tmp_path: Path) -> None:
    arguments = ("--audit", "--repeat", "3", "--tolerance", "2e", "--device-seed", "9")
    assert run(folder, *arguments, "--plan", "a.json").status == 0
    first = (folder / "f.npz").read_bytes()
    assert run(folder, *arguments, "--plan", "b.json").status == 0
    assert (folder / "f.npz").read_bytes() == first
    assert (folder / "a.json").read_bytes() == (folder / "b.json").read_bytes()
    arrays, _ = loaded(folder)
    assert not np.array_equal(arrays["exposure_e"][0], arrays["exposure_e"][1])


def test_timings_have_separate_times_for_planning_and_exposing(folder: Path) -> None:
    assert run(folder, "--tolerance", "5e", "--audit", "--timings", "t.json").status == 0
    found = json.loads((folder / "t.json").read_text())
    assert set(found) >= {"compile_s", "analyse_s", "plan_s", "expose_s", "audit_s", "write_s"}
    assert all(value >= 0 for value in found.values())


def test_clips_of_samples_keep_the_effect_motion(folder: Path) -> None:
    light = np.random.default_rng(1).exponential(400.0, (4, 24, 30)).astype(np.float32)
    np.savez(folder / "light.npz", light=light)
    outcome = run(
        folder, "--tolerance", "2e", "--audit", "--frames-are", "samples", scene="light.npz"
    )
    assert outcome.status == 0, outcome.err
    found = {each["name"]: each for each in loaded(folder)[1]["plan"]["effects"]}
    assert found["motion"]["decision"] == "kept"


def test_words_that_compare_light_have_no_plan(folder: Path) -> None:
    (folder / "w.asm").write_text(
        ".target scamp5\n.wait 1000us\n.kernel k\n    all\n    where A\n    bus NEWS, PIX\n"
        "    bus A, NEWS\n    all\n.slot 1 k\n.bucket frame\n.readout A frame 1\n"
    )
    assert invoke(["asm", "w.asm", "-o", "w.icw"], folder).status == 0
    outcome = invoke(["run", "w.icw", "--scene", "builtin:dark", "--effects", "auto"], folder)
    assert (outcome.status, outcome.codes) == (1, ["NS0442"])


@pytest.mark.parametrize("value", [["9e"], []])
def test_a_tolerance_of_the_worst_pixel_is_refused(folder: Path, value: list[str]) -> None:
    """With and without a value, the message says what to use instead."""
    outcome = run(folder, "--tolerance", "5e", "--tolerance-max", *value)
    assert outcome.status == 2
    assert "no longer has --tolerance-max: use --tolerance" in outcome.err
    assert not (folder / "f.npz").exists()
