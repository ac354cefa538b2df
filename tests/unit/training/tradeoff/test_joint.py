"""`nscc tradeoff PROGRAM`: its errors are those of frames, its advice the fastest setting."""

from __future__ import annotations

import csv
import io
from functools import partial
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from nscc_command import invoke
from PIL import Image

from nscc.chips.load import builtin_target, target_toml
from nscc.compiler import compile_source
from nscc.containers import with_pixels
from nscc.pipeline import Options
from nscc.source import Source
from nscc_runtime import capture
from nscc_runtime.effects import selected
from nscc_runtime.pictures import sheet
from nscc_runtime.pictures.precision import Point
from nscc_runtime.planning.audit import audit
from nscc_runtime.planning.make import make_plan
from nscc_runtime.planning.plan import PlanRequest
from nscc_runtime.planning.planned_scene import PlannedScene
from nscc_runtime.scenes import Scene, scene_light
from nscc_runtime.sensor import default_sensor
from nscc_training.command_settings import STAGES, JointRequest
from nscc_training.experiments.study import NotMeasured, StudyResult
from nscc_training.experiments.study import measure as measure_study
from nscc_training.experiments.study_table import COLUMNS
from nscc_training.tradeoff.joint import Joint, advised, joint_diagram, joint_study, si_seconds
from nscc_training.tradeoff.joint_bench import Bench, rms_percent, scaled_text
from nscc_training.tradeoff.joint_stages import in_fewer, with_slot_us

SIDE, SLOTS = 32, 8
QUICK = Options(level=0)
TEXT = f"""nsl 1
target "small.toml"
frame {SLOTS} slots of 1ms    # a comment
code stop : 1..{SLOTS}
open when n < stop
pixels stop = tile [[1, 4], [6, 8]]
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder with a small target and a program for it."""
    text = target_toml(builtin_target("scamp5"))
    small = text.replace("rows = 256", f"rows = {SIDE}").replace("cols = 256", f"cols = {SIDE}")
    (tmp_path / "small.toml").write_text(small)
    (tmp_path / "p.nsl").write_text(TEXT)
    return tmp_path


def measure(request: JointRequest) -> tuple[Joint, StudyResult]:
    study = joint_study(request)
    assert isinstance(study.text, partial)
    return study.text.args[0], measure_study(study)


def point(error: float, time_ms: float) -> Point:
    return Point("effects", "m", f"{error}", error, "percent", (time_ms,))


def test_the_fastest_point_within_the_target_error_is_advised() -> None:
    points = [point(0.1, 30), point(0.9, 8), point(1.0, 6), point(1.1, 2)]
    assert advised(points, 1.0) == (points[2], True)


def test_if_no_point_is_within_the_target_error_the_fastest_of_the_best_is_advised() -> None:
    """No error is within 1 %. Of those near the best, the one of 8 ms is advised; without points,
    None."""
    points = [point(5.0, 30), point(5.2, 8), point(5.3, 2)]
    assert advised(points, 1.0) == (points[1], False)
    assert advised([], 1.0) == (None, False)


def test_errors_are_of_the_worst_bucket() -> None:
    """Pixels that do not count are left out. The first bucket's error of 3 is reported, and without
    any pixel infinity."""
    ideal = np.full((2, 1, 4), 100.0)
    seen = ideal + np.array([[[3.0, -3.0, 3.0, 999.0]], [[1.0, 1.0, 1.0, 1.0]]])
    counted = np.array([[[True, True, True, False]], [[True] * 4]])
    assert rms_percent(seen, ideal, counted, 100.0) == pytest.approx(3.0)
    assert rms_percent(seen, ideal, counted & False, 100.0) == np.inf


@pytest.mark.parametrize(
    ("text", "tenth"), [("1%", "0.1%"), ("5e", "0.5e"), (".5lsb", "0.05lsb"), ("1e2e", "10e")]
)
def test_a_part_of_a_target_error_keeps_its_unit(text: str, tenth: str) -> None:
    """A tenth of 1 %, 5e, .5lsb and 1e2e is written in the same unit."""
    assert scaled_text(text, 0.1) == tenth


@pytest.mark.parametrize(
    ("time_ms", "text"),
    [
        (0.0025, "2.5 us"),
        (31.4, "31.4 ms"),
        (1250.0, "1.25 s"),
        (1e-5, "10 ns"),
        (0.9999, "1 ms"),
        (999.6, "1 s"),
        (0.9994, "999 us"),
    ],
)
def test_times_are_in_si_units(time_ms: float, text: str) -> None:
    assert si_seconds(time_ms) == text


def test_advice_stays_readable_in_crowded_diagrams() -> None:
    """The recommended setting is named at the line of its stage, or in the legend."""
    rng = np.random.default_rng(0)
    crowd = rng.uniform(1.0, 1.3, (400, 2))
    for names in ("short", "a setting whose name is as long as the panel is wide, " * 3):
        points = [
            Point(stage, names, f"{i}", error, "percent", (time_ms,))
            for stage in STAGES
            for i, (error, time_ms) in enumerate(crowd)
        ]
        joint = Joint(JointRequest(Path("p.nsl"), Scene("s"), "1%"), 1.1, 1.2, 1e3)
        with sheet.style():
            figure = joint_diagram(joint, StudyResult(tuple(points)), "a card")
        beside = {text.get_text() for text in figure.axes[0].texts}
        [legend] = figure.legends
        told = {text.get_text() for text in legend.get_texts()}
        for stage, (each, _) in joint.advice(points).items():
            assert each is not None
            assert f"{stage}: {each.method}, {each.setting}" in beside | told


def test_other_slot_times_change_the_frame_alone() -> None:
    """Equal times change one number of the text. Unequal ones become a list, and the comment
    stays."""
    source = Source("p.nsl", TEXT)
    equal = with_slot_us(source, [2.5] * SLOTS).text
    assert equal == TEXT.replace("8 slots of 1ms", "8 slots of 2.5us")
    listed = with_slot_us(source, [1.0, 2.0]).text
    assert "frame slots [1.0us, 2.0us]    # a comment\n" in listed


def test_fewer_slots_are_open_where_half_of_them_was(folder: Path) -> None:
    own = with_pixels(compile_source(Source("p.nsl", TEXT), folder, QUICK).container, "p.nsl")
    source, codes = in_fewer(own, 4, Source("few.nsl", TEXT))
    y, x = np.mgrid[:SIDE, :SIDE]
    stop = np.array([[1, 4], [6, 8]])[y % 2, x % 2]
    opened = np.arange(SLOTS)[:, None, None] < stop
    wanted = opened.reshape(2, 4, SIDE, SIDE).mean(axis=1) >= 0.5
    options = Options(level=0, target=own.target)
    fewer = compile_source(source, folder, options).container
    fewer = with_pixels(fewer, "few.nsl", codes)
    found = fewer.table.shutters[fewer.table.shutter_of_code[fewer.pixel_codes]][:, :, 0]
    np.testing.assert_array_equal(found.transpose(2, 0, 1), wanted)
    # Four slots of 1 ms each become one.
    assert fewer.slot_us == (4000.0, 4000.0)
    with pytest.raises(NotMeasured, match="8 slots are not a multiple of 3"):
        in_fewer(own, 3, source)
    with pytest.raises(NotMeasured, match="fewer than 2 of 8 slots"):
        in_fewer(own, 8, source)


def test_fewer_slots_that_cannot_be_had_are_listed_with_the_reason(folder: Path) -> None:
    """Six slots can be halved, but not quartered, and the refusal says so."""
    (folder / "p.nsl").write_text(TEXT.replace("8 slots", "6 slots").replace("[6, 8]", "[6, 6]"))
    asked = JointRequest(
        folder / "p.nsl", Scene("builtin:flat:9000"), "2%", stages=("slots",), options=QUICK
    )
    _, found = measure(asked)
    assert {point.method for point in found.points} == {"6 slots", "3 slots"}
    assert [(each.setting, each.reason) for each in found.refused] == [
        ("quarters", "6 slots are not a multiple of 4")
    ]


def test_parts_of_a_target_that_are_no_tolerance_are_the_least_there_is(folder: Path) -> None:
    """Of a target of 2e-9 electrons, a tenth and three tenths lie below the least tolerance, which
    stands for them. Two notes say so."""
    asked = JointRequest(
        folder / "p.nsl", Scene("builtin:flat:9000"), "2e-9e", stages=("effects",), options=QUICK
    )
    joint, found = measure(asked)
    planned = [point.setting for point in found.points if point.method == "planned"]
    assert planned == ["auto 1e-09e", "auto 2e-09e", "auto 6e-09e", "all 2e-09e"]
    assert joint.notes == (
        "effects: no plan is made for 2e-10e: 1e-09e stands for it",
        "effects: no plan is made for 6e-10e: 1e-09e stands for it",
    )


@pytest.mark.parametrize("scene", ["builtin:hdr", "builtin:motion", "builtin:flat:9000"])
def test_less_light_falls_in_a_shorter_frame(folder: Path, scene: str) -> None:
    """A quarter of the frame's time has a quarter of the light, twice the time has twice the light,
    and fewer slots change nothing."""
    said: list[object] = []
    bench = Bench(JointRequest(folder / "p.nsl", Scene(scene), "2%", options=QUICK), said.append)
    for part, slots in ((0.25, 8), (2.0, 8), (0.5, 2)):
        text = TEXT.replace("8 slots of 1ms", f"{slots} slots of 1ms")
        source = with_slot_us(Source("p.nsl", text), [part * 8000 / slots] * slots)
        found = bench._light_in(compile_source(source, folder, QUICK).container)
        assert found.slots == slots
        whole_e = found.total_e().sum() / bench.light.total_e().sum()
        assert whole_e == pytest.approx(part, rel=1e-4)


def test_errors_of_plans_are_those_of_their_audits(folder: Path) -> None:
    asked = JointRequest(
        folder / "p.nsl",
        Scene("builtin:flat:9000"),
        "2%",
        stages=("effects",),
        options=QUICK,
        repeats=1,
    )
    joint, found = measure(asked)
    container = compile_source(Source("p.nsl", TEXT), folder, QUICK).container
    exact = capture(container, "builtin:flat:9000")
    assert joint.signal_e == pytest.approx(float(exact.exposure_e.mean()))
    light = Scene("builtin:flat:9000")
    scene = PlannedScene(
        container,
        default_sensor(container.target),
        scene_light(light, container.slot_us, container.target),
    )
    for tolerance in (0.2, 2.0, 6.0):
        plan = make_plan(scene, PlanRequest(selected("auto"), f"{tolerance:g}%"))
        percent = 100 * audit(scene, plan).measured_rms_e / joint.signal_e
        first, again = (p.error for p in found.points if p.setting == f"auto {tolerance:g}%")
        assert first == again == pytest.approx(percent)
        assert percent <= 1.1 * tolerance
    [reference] = [p for p in found.points if p.method == "reference"]
    assert reference.error == 0.0
    assert joint.target_percent == pytest.approx(2.0)


def test_errors_of_the_chip_are_those_of_its_frames(folder: Path) -> None:
    """The expected error compares a frame with every effect, corrected by its response, with the
    exact sums of light."""
    scene = "builtin:flat:20000"
    asked = JointRequest(folder / "p.nsl", Scene(scene), "2%", stages=("lowering",), options=QUICK)
    found = {p.method: p for p in measure(asked)[1].points}
    for lowering in ("accumulate", "edges"):
        options = Options(level=0, lowering=lowering)
        container = compile_source(Source("p.nsl", TEXT), folder, options).container
        exact_e = capture(container, scene).exposure_e
        frame = capture(container, scene, effects="all", tolerance=0.01 * float(exact_e.mean()))
        away = frame.response.electrons(frame.frame) - exact_e
        percent = 100 * np.sqrt((away**2).mean()) / exact_e.mean()
        assert found[lowering].error == pytest.approx(percent)
        frame_ms = SLOTS * compile_source(Source("p.nsl", TEXT), folder, options).shortest_slot_us
        assert found[lowering].time_ms == pytest.approx(frame_ms / 1e3)


def test_tradeoff_of_a_program_writes_table_and_diagram(folder: Path) -> None:
    stages = "compile,lowering"
    command = ["tradeoff", "p.nsl", "--scene", "builtin:flat:20000", "--stages", stages,
               "--levels", "0", "--repeats", "1", "-O", "0", "-o", "out"]  # fmt: skip
    done = invoke(command, folder)
    assert (done.status, done.err) == (0, "wrote out.csv, out.png\n")
    assert "1% is 1 % of the mean signal" in done.out
    rows = [*csv.reader(io.StringIO((folder / "out.csv").read_text()))]
    assert tuple(rows[0]) == COLUMNS
    assert {row[0].split(", ")[0] for row in rows[1:]} == set(stages.split(","))
    assert {row[3] for row in rows[1:]} == {"percent"}
    with Image.open(folder / "out.png") as picture:
        assert picture.width > 600
    assert not [*folder.glob("*.jsonl")]


def test_slots_of_different_lengths_are_printed_as_their_mean(folder: Path) -> None:
    uneven = TEXT.replace("8 slots of 1ms", "slots [1ms, 2ms, 4ms, 8ms, 16ms, 32ms, 64ms, 128ms]")
    (folder / "p.nsl").write_text(uneven)
    command = [
        "tradeoff",
        "p.nsl",
        "--scene",
        "builtin:flat:20000",
        "--stages",
        "slots",
        "--repeats",
        "1",
        "-O",
        "0",
    ]
    done = invoke(command, folder)
    assert done.status == 0
    assert "31875 us in the mean  " in done.out
    (folder / "p.nsl").write_text(TEXT)
    assert "in the mean" not in invoke(command, folder).out


@pytest.mark.parametrize(
    ("more", "code"),
    [
        (["--target-error", "0%"], "NS0827"),
        (["--target-error", "5"], "NS0827"),
        (["--target-error", "nan%"], "NS0827"),
        (["--target-error", "100%"], "NS0827"),
        (["--target-error", "1e9e"], "NS0827"),
        (["--scene", "builtin:dark"], "NS0826"),
        (["--scene", "p.nsl"], "NS0780"),
        (["--scene", ""], "NS0744"),
    ],
)
def test_invalid_requests_are_refused_before_measuring(
    folder: Path, more: list[str], code: str
) -> None:
    done = invoke(
        ["tradeoff", "p.nsl", "--scene", "builtin:flat:9000", *more, "-O", "0", "-o", "o"], folder
    )
    assert (done.status, done.codes, done.out) == (2, [code], "")
    assert not [*folder.glob("o.[cp]*")]


def test_a_program_that_reads_only_planes_has_no_signal(folder: Path) -> None:
    """Its planes are bits, so there is no signal to compare: NS0826."""
    text = "nsl 3 frame 1 slots of 1ms open when true plane p = exposure > 5% read p"
    (folder / "q.nsl").write_text(text)
    done = invoke(["tradeoff", "q.nsl", "--scene", "builtin:flat:9000"], folder)
    assert (done.status, done.codes) == (2, ["NS0826"])
    assert "'q.nsl' reads out no exposure" in done.err


def test_compiled_programs_have_no_optimisation_levels(folder: Path) -> None:
    """The stage `compile` says that the program is compiled already, and the stage `effects`
    runs."""
    assert invoke(["build", "p.nsl", "-O", "0", "-o", "p.icw"], folder).status == 0
    command = ["tradeoff", "p.icw", "--scene", "builtin:flat:9000", "--repeats", "1"]
    done = invoke([*command, "--stages", "compile,effects"], folder)
    assert done.status == 0
    assert "compile: 'p.icw' is compiled already" in done.out


def test_pixels_that_look_have_one_lowering(folder: Path) -> None:
    """The stage `lowering` says that there is one way. The study of the emulator is refused with
    NS0828."""
    text = 'nsl 2\ntarget "small.toml"\nframe 8 slots of 1ms\n' + (
        "sense lit when light > 30% at n in [2, 4]\nstate shut : 0..2 = 0\n"
        "next shut = looks when lit and shut == 0\nopen when shut == 0\nread shut\n"
    )
    (folder / "look.nsl").write_text(text)
    command = ["tradeoff", "look.nsl", "--scene", "builtin:flat:9000", "--repeats", "1", "-O", "0"]
    done = invoke([*command, "--stages", "compile,lowering,effects", "--levels", "0"], folder)
    assert (done.status, done.err) == (0, "")
    assert "lowering: there is one way for pixels that look" in done.out
    refused = invoke(["tradeoff", "emulator", "look.nsl", "--scene", "builtin:flat:9000"], folder)
    assert (refused.status, refused.codes) == (2, ["NS0828"])


def test_a_chip_that_is_sent_planes_has_no_plans(folder: Path) -> None:
    """For the chip `dual-tap` the stage `effects` lists NS0750, and the study of the emulator is
    refused with it."""
    (folder / "tap.nsl").write_text(
        "nsl 1\ntarget dual-tap\nframe 4 slots of 1ms\nopen when true\n"
    )
    command = ["tradeoff", "tap.nsl", "--scene", "builtin:flat:9000", "--repeats", "1", "-O", "0"]
    done = invoke([*command, "--stages", "effects"], folder)
    assert done.status == 1
    assert "(NS0750)" in done.out
    refused = invoke(["tradeoff", "emulator", "tap.nsl", "--scene", "builtin:flat:9000"], folder)
    assert (refused.status, refused.codes) == (2, ["NS0750"])


def test_misspelt_names_of_studies_and_runs_get_suggestions(folder: Path) -> None:
    """`emulater` proposes the study, and `hrd` lists the runs; both are NS0781."""
    done = invoke(["tradeoff", "emulater"], folder)
    assert (done.status, done.codes) == (2, ["NS0781"])
    assert "nscc tradeoff emulator" in done.err
    misspelt = invoke(["tradeoff", "hrd"], folder)
    assert misspelt.codes == ["NS0781"]
    assert "or a run: RUN, hdr, clip" in misspelt.err


@pytest.mark.slow
def test_the_decoders_of_a_run_are_compared(tmp_path: Path) -> None:
    pytest.importorskip("torch")
    command = [
        "tradeoff",
        "hdr",
        "--scene",
        "builtin:hdr",
        "--stages",
        "decoder",
        "--repeats",
        "1",
        "-O",
        "0",
    ]
    done = invoke(command, tmp_path)
    assert (done.status, done.err) == (0, "")
    for name in ("merged", "any", "f32", "bf16"):
        assert name in done.out


def test_shot_noise_is_a_share_of_the_signal() -> None:
    """The shot noise of 400 electrons is 5 %."""
    counts = np.random.default_rng(1).poisson(400.0, 100_000)
    bench = SimpleNamespace(ideal_e=np.full((1, 4, 4), 400.0), signal_e=lambda: 400.0)
    found = Bench.shot_percent.func(bench)  # type: ignore[attr-defined]
    assert found == pytest.approx(100 * counts.std() / counts.mean(), rel=0.02)
