"""Frames in Python are those of `nscc run`: options, defaults, files; what is told otherwise."""

from __future__ import annotations

import inspect
import re
import warnings
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from nscc_command import invoke

import nscc
import nscc_runtime
from nscc.chips.load import builtin_target
from nscc_cli.run import command
from nscc_runtime.frame_file import KEEP
from nscc_runtime.request import Request

ROWS, COLS = 8, 6
TARGET = replace(builtin_target("scamp5"), rows=ROWS, cols=COLS)
TEXT = "nsl 1\nframe 8 slots of 1ms\ncode stop : 1..8\nopen when n < stop\n"
DATA = "pixels stop = 1 + (x + y) % 8\n"
LIGHT = np.random.default_rng(2).exponential(400.0, (8, ROWS, COLS))


@pytest.fixture(scope="module")
def program() -> nscc.ShutterProgram:
    return nscc.compile(TEXT + DATA, target=TARGET, level=1)


@pytest.mark.parametrize(
    ("options", "arguments"),
    [
        ({}, []),
        ({"effects": "auto", "seed": 3}, ["--effects", "auto", "--seed", "3"]),
        ({"tolerance": "2e", "repeat": 2}, ["--tolerance", "2e", "--repeat", "2"]),
        (
            {"effects": "shot,read", "fidelity": "reference", "device_seed": 1},
            ["--effects", "shot,read", "--fidelity", "reference", "--device-seed", "1"],
        ),
        (
            {"audit": True, "sensor": {"full_well_e": 20000, "prnu_fraction": 0.02}},
            ["--audit", "--sensor-set", "full_well_e=20000", "--sensor-set", "prnu_fraction=0.02"],
        ),
    ],
)
def test_frame_files_of_python_equal_those_of_nscc_run(
    options: dict[str, Any], arguments: list[str], tmp_path: Path
) -> None:
    """The files are equal byte for byte, with all arrays that can be kept."""
    (tmp_path / "p.nsl").write_text(TEXT + DATA)
    keep = KEEP
    line = [
        "run",
        "p.nsl",
        "--scene",
        "builtin:flat:30000",
        "-o",
        "c.npz",
        "--keep",
        ",".join(keep),
        *arguments,
    ]
    outcome = invoke(line, tmp_path)
    assert outcome.status == 0, outcome.err
    p = nscc.compile(tmp_path / "p.nsl")
    taken = nscc_runtime.capture(p, "builtin:flat:30000", **options)
    taken.save(tmp_path / "python.npz", keep=keep)
    assert (tmp_path / "python.npz").read_bytes() == (tmp_path / "c.npz").read_bytes()
    with np.load(tmp_path / "c.npz") as file:
        np.testing.assert_array_equal(taken.truth_e, file["truth_e"])


@pytest.mark.parametrize(
    ("options", "arguments", "shape"),
    [
        ({"fit": "tiles"}, ["--fit", "tiles"], (1, 300, 270)),
        ({"fit": "tiles", "color": True}, ["--fit", "tiles", "--color"], (3, 1, 300, 270)),
        (
            {"crop": (3, 5), "transfer": "linear"},
            ["--crop", "3,5", "--transfer", "linear"],
            (1, 256, 256),
        ),
    ],
)
def test_a_photo_of_any_size_is_exposed_as_by_the_command(
    options: dict[str, Any], arguments: list[str], shape: tuple[int, ...], tmp_path: Path
) -> None:
    import cv2

    photo = np.random.default_rng(4).integers(0, 255, (300, 270, 3), np.uint8)
    cv2.imwrite(str(tmp_path / "photo.png"), photo)
    (tmp_path / "p.nsl").write_text(TEXT + DATA)
    names = ("f.npz", "f.hdr", "f.png")
    p = nscc.compile(tmp_path / "p.nsl")
    with warnings.catch_warnings(action="ignore"):  # grey, or cut: told by the command, too
        scene = nscc_runtime.scene(tmp_path / "photo.png", exposure="30000@70", **options)
        taken = nscc_runtime.capture(p, scene, effects="shot", seed=1)
    assert taken.frame.shape == shape
    for name in names:
        line = ["run", "p.nsl", "--scene", "photo.png", "--exposure", "30000@70", "-o",
                f"c_{name}", "--effects", "shot", "--seed", "1", *arguments]  # fmt: skip
        outcome = invoke(line, tmp_path)
        assert outcome.status == 0, outcome.err
        saved = taken.save(tmp_path / name).read_bytes()
        assert saved == (tmp_path / f"c_{name}").read_bytes(), name


def test_only_formats_that_there_are_are_written(program: nscc.ShutterProgram) -> None:
    """A capture saved as `x.doc` gives NS0786."""
    with pytest.raises(nscc.Rejected, match="NS0786"):
        nscc_runtime.capture(program, LIGHT).save("x.doc")


def test_defaults_are_declared_once() -> None:
    """An option that is not given has no value in the command line, but Python's."""
    asked = command.make_context("run", ["program.nsl"]).params
    shared = inspect.signature(nscc_runtime.capture).parameters.keys() & asked.keys()
    for name in shared - {"program"}:
        assert asked[name] in (None, False), name
    signature = inspect.signature(nscc_runtime.capture).parameters
    for name in ("audit", "seed", "device_seed", "repeat", "threads"):
        assert signature[name].default == getattr(Request, name)
    told = inspect.signature(nscc_runtime.plan).parameters["tolerance"].default
    assert told == Request.tolerance


def test_scenes_are_named_and_loaded_for_each_program(
    program: nscc.ShutterProgram, tmp_path: Path
) -> None:
    np.savez(tmp_path / "light.npz", light=LIGHT)
    wanted = nscc_runtime.capture(program, LIGHT).exposure_e
    for light in (
        tmp_path / "light.npz",
        str(tmp_path / "light.npz"),
        nscc_runtime.scene(tmp_path / "light.npz"),
        LIGHT.tolist(),
        nscc_runtime.Light.of_clip(LIGHT.astype(np.float32)),
    ):
        np.testing.assert_array_equal(nscc_runtime.capture(program, light).exposure_e, wanted)
    bright = nscc_runtime.scene(tmp_path / "light.npz", exposure=30000)
    taken = nscc_runtime.capture(program, bright)
    assert np.percentile(taken.truth_e.sum(axis=0), 99) == pytest.approx(30000, rel=1e-3)


def test_a_plan_is_made_without_a_frame_and_used_for_others(program: nscc.ShutterProgram) -> None:
    """The plan made alone is that of a capture. It serves twice the light, and its error stays
    within the tolerance of 3 electrons."""
    plan = nscc_runtime.plan(program, LIGHT, tolerance=3)
    assert nscc_runtime.capture(program, LIGHT, tolerance=3, audit=True).plan == plan
    assert nscc_runtime.capture(program, 2 * LIGHT, plan=plan).plan.kept == plan.kept
    found = nscc_runtime.audit(program, LIGHT, plan=plan)
    assert found.holds
    # The tolerance of 3 electrons, with a tenth of slack.
    assert found.measured_rms_e <= 1.1 * 3
    assert "the promise holds" in str(found)
    first, *_ = str(plan).splitlines()
    assert first.split()[0] == "effect"


def test_a_plans_file_is_written_and_read_as_by_the_command(
    program: nscc.ShutterProgram, tmp_path: Path
) -> None:
    """The first capture with a path writes the bytes that `nscc run --plan` writes. The next one
    reads them and gives equal electrons."""
    program.save(tmp_path / "p.icw")
    np.savez(tmp_path / "light.npz", light=LIGHT)
    line = ["run", "p.icw", "--scene", "light.npz", "--plan", "c.json", "-o", "f.npz"]
    assert invoke(line, tmp_path).status == 0
    first = nscc_runtime.capture(program, LIGHT, plan=tmp_path / "python.json")
    assert (tmp_path / "python.json").read_bytes() == (tmp_path / "c.json").read_bytes()
    again = nscc_runtime.capture(program, LIGHT, plan=tmp_path / "c.json")
    assert again.exposure_e.tobytes() == first.exposure_e.tobytes()


def test_a_sensor_is_that_of_a_chip_with_some_numbers_changed(
    program: nscc.ShutterProgram, tmp_path: Path
) -> None:
    sensor = nscc_runtime.sensor_for(program, full_well_e=20000)
    file = tmp_path / "s.toml"
    file.write_text("full_well_e = 20000.0\n")
    assert sensor.full_well_e == nscc_runtime.sensor_for(program, file).full_well_e == 20000
    assert sensor.electrons_per_lsb == pytest.approx(20000 / 255)  # the well is the last code
    silent = nscc_runtime.sensor_for(program, file, adc_noise_lsb=0)
    assert (silent.full_well_e, silent.adc_noise_lsb) == (20000, 0)
    frames = {
        nscc_runtime.capture(program, LIGHT, effects="auto", sensor=given).frame.tobytes()
        for given in (file, {"full_well_e": 20000})
    }
    assert len(frames) == 1


def test_tensors_of_torch_are_accepted_as_arrays(program: nscc.ShutterProgram) -> None:
    """A tensor gives the frame of its array. One that requires a gradient is refused, with the
    differentiable function as a hint."""
    torch = pytest.importorskip("torch")
    light = torch.from_numpy(LIGHT)
    wanted = nscc_runtime.capture(program, LIGHT).exposure_e
    np.testing.assert_array_equal(nscc_runtime.capture(program, light).exposure_e, wanted)
    with pytest.raises(TypeError, match=r"Tensor \(8, 8, 6\) of float64\n.*\n.*differentiable_"):
        nscc_runtime.capture(program, light.clone().requires_grad_(True))


PICTURE = np.ones((ROWS, COLS), np.float32)
WRONG = {
    "swapped": (lambda p: nscc_runtime.capture(LIGHT, p), "takes a compiled program first, not an"),
    "two programs": (lambda p: nscc_runtime.capture(p, p), "the light is a ShutterProgram"),
    "a path": (lambda p: nscc_runtime.capture("p.nsl", LIGHT), r"nscc.compile\('p.nsl'\) returns"),
    "words": (lambda p: nscc_runtime.capture("p.icw", LIGHT), r"nscc.load\('p.icw'\) returns"),
    "nothing": (
        lambda p: nscc_runtime.capture(p, None),
        "a scene or the name of a scene, not None",
    ),
    "effects": (lambda p: nscc_runtime.capture(p, LIGHT, effects=1), "effects is text, not 1"),
    "plan": (lambda p: nscc_runtime.capture(p, LIGHT, plan=1), "a plan or a plan file, not 1"),
    "sensor": (lambda p: nscc_runtime.capture(p, LIGHT, sensor=1), "or numbers by name, not 1"),
    "seed": (lambda p: nscc_runtime.capture(p, LIGHT, seed=-1), "seed is a whole number from 0"),
    "fidelity": (lambda p: nscc_runtime.capture(p, LIGHT, fidelity="ref"), "'planned', 'referenc"),
    "repeat": (lambda p: nscc_runtime.capture(p, LIGHT, repeat=1.5), "from 1 to 10000, not 1.5"),
    "a scene of": (lambda p: nscc_runtime.scene(LIGHT), "takes the name of a scene, not an array"),
    "transfer": (lambda p: nscc_runtime.scene("x", transfer="sgb"), "did you mean `srgb`"),
    "pairs": (lambda p: nscc_runtime.captures([p] * 2, [LIGHT] * 3), "3 scenes for 2 programs"),
    "none": (lambda p: nscc_runtime.captures([], [LIGHT]), "1 scenes for 0 programs"),
    "path": (lambda p: nscc_runtime.capture(p, LIGHT).save(3), "save takes a path, not 3"),
    "keep": (
        lambda p: nscc_runtime.capture(p, LIGHT).save("x.npz", ["a"]),
        "keep is one of 'light'",
    ),
    "threads": (lambda p: nscc_runtime.capture(p, LIGHT, threads=0), "threads is a whole number"),
    "a number": (
        lambda p: nscc_runtime.sensor_for(p, full_well_e="a"),
        "full_well_e is a finite number",
    ),
    "a chip": (lambda p: nscc_runtime.sensor_for(TARGET), "takes a compiled program first"),
    "tolerance": (
        lambda p: nscc_runtime.plan(p, LIGHT, tolerance=[1]),
        "text or a number, not a list",
    ),
    "exposure": (lambda p: nscc_runtime.scene("x", exposure=[]), "exposure is text or a number"),
    "crop": (lambda p: nscc_runtime.scene("x", crop=5), "crop is text or 2 numbers, not 5"),
    "fps": (lambda p: nscc_runtime.scene("x", fps="a"), "fps is a finite number, not the text 'a'"),
    "ragged": (
        lambda p: nscc_runtime.capture(p, [[1, 2], [3]]),
        "cannot convert the light to an ar",
    ),
    "tone": (lambda p: nscc_runtime.capture(p, LIGHT).save("x.png", tone=5), "tone is one of"),
    "null": (lambda p: nscc_runtime.capture(p, LIGHT).save("a\0.npz"), "takes a path, not the te"),
    "flag": (lambda p: nscc_runtime.capture(p, LIGHT, audit="no"), "True or False, not the text"),
    "color": (lambda p: nscc_runtime.scene("x", color=1), "color is True or False, not 1"),
    "sensor file": (lambda p: nscc_runtime.sensor_for(p, {}), "takes a path, not a dict"),
    "huge": (lambda p: nscc_runtime.scene("x", fps=10**400), "fps is a finite number, not 1000"),
    "float64": (
        lambda p: nscc_runtime.Light.of_still(np.ones((2, 3)), np.ones(8)),
        r"frames are an array \(1, 2, 3\) of float64",
    ),
    "weight": (lambda p: nscc_runtime.Light.of_still(PICTURE, [np.nan]), "finite weight for each"),
    "weights": (lambda p: nscc_runtime.Light.of_still(PICTURE, ["a"]), "cannot convert the weigh"),
    "no slots": (lambda p: nscc_runtime.Light.of_clip(PICTURE[:0, None]), "at least one slot, not"),
    "a clip": (lambda p: nscc_runtime.Light.of_clip(None), "its frames are an array"),
    "fit": (lambda p: nscc_runtime.scene("x", fit="tile"), "did you mean `tiles`"),
    "first": (lambda p: nscc_runtime.scene("x", first=-1), "first is a whole number from 0"),
}


@pytest.mark.parametrize("wrong", WRONG)
def test_wrong_arguments_are_refused_in_a_sentence(
    wrong: str, program: nscc.ShutterProgram
) -> None:
    """Each call of `WRONG` gives an error that is both a TypeError and Rejected."""
    call, words = WRONG[wrong]
    with pytest.raises(TypeError, match=words) as caught:
        call(program)
    assert isinstance(caught.value, nscc.Rejected)


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"effects": "shott"}, "NS0756.*'shott'"),
        ({"sensor": {"full_well": 3}}, "NS0753.: a sensor has no .*\n.*did you mean `full_well_e`"),
        ({"sensor": {"full_well_e": float("nan")}}, "NS0754"),
        ({"tolerance": "5"}, "NS0746"),
        ({"effects": "auto", "fidelity": "reference"}, "NS0739.*effects auto with fidelity ref"),
    ],
)
def test_python_refuses_what_the_command_refuses(
    options: dict[str, Any], words: str, program: nscc.ShutterProgram
) -> None:
    with pytest.raises(nscc.Rejected, match=words):
        nscc_runtime.capture(program, LIGHT, **options)


@pytest.mark.parametrize("other", [1.0, np.nan, np.inf])
def test_negative_light_is_refused(other: float, program: nscc.ShutterProgram) -> None:
    """One pixel of -1 gives NS0736, also if the other pixels are NaN or infinite."""
    picture = np.full(PICTURE.shape, other, np.float32)
    picture[0, 0] = -1.0
    light = nscc_runtime.Light.of_still(picture, np.ones(8))
    with pytest.raises(nscc.Rejected, match=r"NS0736.*1 negative"):
        nscc_runtime.capture(program, light)


def test_light_that_is_not_a_number_is_marked(program: nscc.ShutterProgram) -> None:
    """The frame is made. Only the pixel that is NaN is not valid."""
    picture = np.ones(PICTURE.shape, np.float32)
    picture[0, 0] = np.nan
    light = nscc_runtime.Light.of_still(picture, np.ones(8))
    found = nscc_runtime.capture(program, light, effects="none")
    assert np.argwhere(~found.valid).tolist() == [[0, 0, 0]]


def test_masked_values_are_not_light(program: nscc.ShutterProgram) -> None:
    masked = np.ma.masked_greater(LIGHT, np.partition(LIGHT, -2, axis=None)[-2])
    with pytest.raises(nscc.Rejected, match=r"NS0736.*1 not a number"):
        nscc_runtime.capture(program, masked)


def test_a_program_without_data_has_no_frame() -> None:
    empty = nscc.compile(TEXT, target=TARGET, level=1)
    with pytest.raises(nscc.Rejected, match="NS0741"):
        nscc_runtime.capture(empty, LIGHT)


def test_pixels_that_look_have_frames_and_plans_but_no_shutters(root: Path) -> None:
    """For float_pixel the light comes back within 2 %, and the plan's promise holds. `shutters()`
    is refused, as they depend on the light."""
    p = nscc.compile(root / "examples" / "float_pixel.nsl", target=TARGET)
    light = np.full((ROWS, COLS), 2e6)  # electrons a second
    taken = nscc_runtime.capture(p, light)
    np.testing.assert_allclose(taken.light_e_per_s()[0], 2e6, rtol=0.02)
    assert taken.told["open_slots"].shape == (1, ROWS, COLS)
    with pytest.raises(nscc.Rejected, match="depend on the light"):
        p.shutters()
    made = nscc_runtime.plan(p, light)
    assert made.other_states is not None
    planned = nscc_runtime.capture(p, light, plan=made, audit=True)
    assert planned.audit is not None
    assert planned.audit.holds
    assert "<svg" not in p._repr_html_()


def test_repr_of_frames_plans_light_and_sensors_is_one_line(program: nscc.ShutterProgram) -> None:
    taken = nscc_runtime.capture(program, LIGHT, effects="auto", repeat=2)
    sensor = nscc_runtime.sensor_for(program)
    for value in (taken, taken.plan, taken.light, sensor):
        assert re.fullmatch(r"<nscc [^\n]{10,200}>", repr(value))


@pytest.mark.parametrize("threads", [0, -1, "a", 1.5])
def test_threads_of_many_captures_are_a_whole_number(
    threads: Any, program: nscc.ShutterProgram
) -> None:
    """0, -1, a text and 1.5 are refused with the argument's name."""
    with pytest.raises(nscc.Rejected, match="threads"):
        nscc_runtime.captures(program, [LIGHT], threads=threads)
