"""`--tolerance 1%`: of the mean exposure without effects, wherever a tolerance is taken."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from nscc_command import Outcome, invoke
from PIL import Image
from plan_cases import case, moving_light

import nscc_runtime
from nscc.diagnostics.diagnostic import Rejected

CLIP = moving_light((8, 12, 16), 400.0).frames
FULL_E = 30000.0
LOOKING = """nsl 2
target "small.toml"
frame 8 slots of 1ms
sense bright when light > 45% at n in [1, 4]
state closed : 0..2 = 0
next closed = looks when bright and closed == 0
open when closed == 0
read closed
"""
FIXED = """nsl 1
target "small.toml"
frame 4 slots of 1ms
code stop : 1..4
open when n < stop
pixels stop = 1 + x % 4
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    text = invoke(["targets", "scamp5", "--toml"], tmp_path).out
    small = text.replace("rows = 256", "rows = 24").replace("cols = 256", "cols = 30")
    (tmp_path / "small.toml").write_text(small)
    (tmp_path / "looking.nsl").write_text(LOOKING)
    (tmp_path / "fixed.nsl").write_text(FIXED)
    return tmp_path


def run(folder: Path, program: str, *arguments: str) -> Outcome:
    return invoke(["run", program, "-o", "f.npz", *arguments], folder)


def found(folder: Path) -> dict[str, float | str | None]:
    """What the frame's meta says of the tolerance."""
    with np.load(folder / "f.npz") as file:
        plan = json.loads(str(file["meta"]))["plan"]
    return {name: plan[name] for name in ("tolerance", "tolerance_e")}


def assert_found(folder: Path, text: str, tolerance_e: float) -> None:
    said = found(folder)
    assert said["tolerance"] == text
    assert said["tolerance_e"] == pytest.approx(tolerance_e, rel=1e-5)


def signal_e(folder: Path, program: str, *scene: str) -> float:
    """The mean of the exposures of a frame without effects."""
    assert run(folder, program, *scene).status == 0
    with np.load(folder / "f.npz") as file:
        return float(np.minimum(file["exposure_e"], FULL_E).mean())


@pytest.mark.parametrize("scale", [1.0, 30.0])
@pytest.mark.parametrize("name", ["b accumulate", "c edges", "two buckets"])
def test_a_percentage_refers_to_the_mean_exposure_limited_to_the_full_well(
    name: str, scale: float
) -> None:
    program, light = case(name), scale * CLIP
    exact = nscc_runtime.capture(program, light, effects="none").exposure_e
    expected = np.minimum(exact, FULL_E).mean()
    plan = nscc_runtime.plan(program, light, tolerance="2.5%")
    assert plan.tolerance_e == pytest.approx(0.025 * expected, rel=1e-5)
    said = f"tolerance {plan.tolerance_e:.4g} e (2.5% of the mean signal, {expected:.4g} e)"
    assert said in str(plan)
    in_electrons = nscc_runtime.plan(program, light, tolerance=plan.tolerance_e)
    assert in_electrons.decisions == plan.decisions


@pytest.mark.parametrize("program", ["fixed.nsl", "looking.nsl"])
def test_meta_has_the_percentage_and_its_tolerance_in_electrons(folder: Path, program: str) -> None:
    scene = ("--scene", "builtin:hdr", "--exposure", "40000")
    expected = signal_e(folder, program, *scene)
    outcome = run(folder, program, *scene, "--tolerance", "1 %", "--audit")
    assert outcome.status == 0, outcome.err
    assert "(1% of the mean signal, " in outcome.err
    assert_found(folder, "1%", 0.01 * expected)


@pytest.mark.parametrize(
    ("asked", "said"), [("5e", "tolerance 5 e\n"), ("0.5lsb", " e (0.5lsb)\n")]
)
def test_tolerances_in_electrons_or_codes_do_not_depend_on_the_scene(
    folder: Path, asked: str, said: str
) -> None:
    outcome = run(folder, "fixed.nsl", "--scene", "builtin:dark", "--tolerance", asked, "--verbose")
    assert said in outcome.err
    assert found(folder)["tolerance"] == asked


@pytest.mark.parametrize("program", ["fixed.nsl", "looking.nsl"])
def test_a_percentage_is_refused_for_a_dark_scene(folder: Path, program: str) -> None:
    outcome = run(folder, program, "--scene", "builtin:dark", "--tolerance", "1%")
    assert (outcome.status, outcome.codes) == (2, ["NS0746"])
    assert "mean signal is 0 electrons" in outcome.err
    assert "--tolerance 5e" in outcome.err
    assert not (folder / "f.npz").exists()


@pytest.mark.parametrize("program", ["fixed.nsl", "looking.nsl"])
def test_a_plan_with_a_percentage_takes_its_tolerance_from_the_scene_it_is_used_on(
    folder: Path, program: str
) -> None:
    scene = ("--scene", "builtin:flat:4000")
    assert run(folder, program, *scene, "--tolerance", "1%", "--plan", "p.json").status == 0
    made = found(folder)
    assert run(folder, program, *scene, "--plan", "p.json").status == 0
    assert found(folder) == made
    assert run(folder, program, "--scene", "builtin:flat:8000", "--plan", "p.json").status == 0
    again = found(folder)
    assert again["tolerance"] == "1%"
    assert again["tolerance_e"] == 2 * made["tolerance_e"]
    dark = run(folder, program, "--scene", "builtin:dark", "--plan", "p.json")
    assert (dark.status, dark.codes) == (2, ["NS0746"])


def test_pieces_and_colours_of_a_picture_share_one_tolerance(folder: Path) -> None:
    """The lower half of the picture is black: by itself it would have no signal."""
    picture = np.zeros((48, 30, 3), np.uint8)
    picture[:24] = np.random.default_rng(3).integers(90, 255, (24, 30, 3))
    Image.fromarray(picture).save(folder / "picture.png")
    scene = ("--scene", "picture.png", "--exposure", "9000", "--fit", "tiles", "--color")
    expected = signal_e(folder, "fixed.nsl", *scene)
    outcome = run(folder, "fixed.nsl", *scene, "--tolerance", "2%", "--verbose")
    assert outcome.status == 0, outcome.err
    assert "the exposure with the largest error, of 6:" in outcome.out + outcome.err
    assert_found(folder, "2%", 0.02 * expected)


def test_percent_tolerances_of_a_study_refer_to_each_scene(folder: Path) -> None:
    line = ["tradeoff", "emulator", "fixed.nsl", "--repeats", "1", "--tolerances", "1%,5e"]
    scenes = ["--scene", "builtin:flat:4000", "--scene", "builtin:flat:8000"]
    done = invoke([*line, *scenes, "--csv", "s.csv"], folder)
    assert done.status == 0, done.err
    mean_e = np.mean(1 + np.arange(30) % 4) * np.array([1000.0, 2000.0])
    assert all(f" 1%, {each:.3g}e " in done.out for each in 0.01 * mean_e), done.out
    assert (folder / "s.csv").read_text().count(",1%,") == 8
    dark = invoke([*line, "--scene", "builtin:dark"], folder)
    assert (dark.status, dark.codes) == (2, ["NS0746"])


def test_python_takes_percent_and_refuses_darkness() -> None:
    program = case("c edges")
    taken = nscc_runtime.capture(program, CLIP, tolerance="1%", repeat=2)
    plan = nscc_runtime.plan(program, CLIP, tolerance="1%")
    assert (taken.plan.tolerance_e, taken.plan.tolerance) == (plan.tolerance_e, "1%")
    with pytest.raises(Rejected, match="NS0746"):
        nscc_runtime.capture(program, 0 * CLIP, tolerance="1%")
