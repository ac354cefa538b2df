"""`nscc run` and `nscc view` from the command line, on a small target."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from nscc_cli.main import main

PROGRAM = """nsl 1
target "small.toml"
frame 4 slots of 1ms
code stop : 1..4
open when n < stop
"""
PIXELS = "pixels stop = tile [[4, 3], [2, 1]]\n"


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A temporary current folder in every test of this file, with a small target and two
    programs."""
    from nscc.chips.load import builtin_target, target_toml

    monkeypatch.chdir(tmp_path)
    text = target_toml(builtin_target("scamp5"))
    small = text.replace("rows = 256", "rows = 8").replace("cols = 256", "cols = 6")
    Path("small.toml").write_text(small)
    Path("ok.nsl").write_text(PROGRAM + PIXELS)
    Path("open.nsl").write_text(PROGRAM)
    return tmp_path


def run(*arguments: str, capsys: pytest.CaptureFixture[str]) -> tuple[int, str]:
    status = main(["run", *arguments])
    return status, capsys.readouterr().err


def oracle(file: str) -> np.ndarray:
    """Sum of the light in the open slots, from the program's own text."""
    data = np.load(file)
    y, x = np.mgrid[:8, :6]
    stop = np.array([[4, 3], [2, 1]])[y % 2, x % 2]
    opened = np.arange(4)[:, None, None] < stop
    return (data["light"].astype(np.float64) * opened).sum(axis=0)


@pytest.mark.parametrize(
    ("shape", "words"),
    [
        ((8, 6, 4), "np.moveaxis(a, -1, 0)"),
        ((8, 6, 9), "np.moveaxis(a, -1, 0)"),
        ((8, 6, 3), "luminance"),
        ((4, 8, 6, 3), "luminance"),
        ((4, 8, 6, 2), "two or three dimensions"),
        ((6, 8), "the array is 8 x 6"),
    ],
)
def test_light_with_the_axes_of_other_tools_is_refused(
    shape: tuple[int, ...], words: str, capsys: pytest.CaptureFixture[str]
) -> None:
    np.savez("s.npz", light=np.ones(shape, np.float32))
    status, err = run("ok.nsl", "--scene", "s.npz", capsys=capsys)
    assert status == 2
    assert words in err


def test_light_that_fits_is_not_taken_for_colour(capsys: pytest.CaptureFixture[str]) -> None:
    """Three slots of 3 x 3 pixels have the shape of a colour picture."""
    text = Path("small.toml").read_text().replace("rows = 8", "rows = 3")
    Path("small.toml").write_text(text.replace("cols = 6", "cols = 3"))
    Path("three.nsl").write_text(PROGRAM.replace("frame 4", "frame 3") + "pixels stop = 1 + x % 3")
    np.savez("s.npz", light=np.ones((3, 3, 3), np.float32))
    assert run("three.nsl", "--scene", "s.npz", capsys=capsys)[0] == 0


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("photo.hdr", "--scene", "ok.nsl"), "write `nscc run ok.nsl --scene photo.hdr`"),
        (("my photo.png", "--scene", "ok.icw"), "write `nscc run ok.icw --scene 'my photo.png'`"),
        (("ok.nsl", "--scene", "ok.nsl"), "--scene 'ok.nsl' is a program"),
    ],
)
def test_swapped_program_and_scene_are_recognised(
    arguments: tuple[str, ...], words: str, capsys: pytest.CaptureFixture[str]
) -> None:
    status, err = run(*arguments, capsys=capsys)
    assert status == 2
    assert "NS0780" in err
    assert words in err


def test_a_frame_is_the_sum_of_open_slots(capsys: pytest.CaptureFixture[str]) -> None:
    for scene in ("builtin:hdr", "builtin:motion", "builtin:flat:100"):
        arguments = ("ok.nsl", "--scene", scene, "-o", "f.npz", "--png", "f.png")
        status, err = run(*arguments, "--keep", "light,truth,shutter,codes", capsys=capsys)
        assert status == 0, err
        assert "wrote f.npz" in err
        data = np.load("f.npz")
        np.testing.assert_allclose(data["exposure_e"][0], oracle("f.npz"), rtol=1e-6)
        lsb = json.loads(str(data["meta"]))["electrons_per_lsb"]
        codes = np.clip(np.rint(data["exposure_e"] / lsb), 0, 255)
        np.testing.assert_array_equal(data["frame"], codes)
        opened = np.unpackbits(data["shutter"], axis=-1, count=4, bitorder="little")
        np.testing.assert_array_equal(opened[0].sum(axis=-1), data["codes_stop"])
        assert Path("f.png").read_bytes().startswith(b"\x89PNG")


def test_containers_and_sources_give_the_same_file(capsys: pytest.CaptureFixture[str]) -> None:
    """The frame files of `ok.nsl` and of its container have equal bytes."""
    assert main(["build", "ok.nsl", "-o", "ok.icw"]) == 0
    assert run("ok.nsl", "--scene", "builtin:hdr", capsys=capsys)[0] == 0
    assert run("ok.icw", "--scene", "builtin:hdr", "-o", "b.npz", capsys=capsys)[0] == 0
    assert Path("ok.frame.npz").read_bytes() == Path("b.npz").read_bytes()


def test_pixel_codes_are_read_from_a_file(capsys: pytest.CaptureFixture[str]) -> None:
    """Without codes NS0741. With stop 3 everywhere, three of four equal slots give 75 of 100
    electrons."""
    arguments = ("open.nsl", "--scene", "builtin:flat:100")
    status, err = run(*arguments, capsys=capsys)
    assert status == 2
    assert "NS0741" in err
    np.savez("codes.npz", stop=np.full((8, 6), 3))
    status, err = run(*arguments, "--pixels", "codes.npz", capsys=capsys)
    assert status == 0, err
    np.testing.assert_allclose(np.load("open.frame.npz")["exposure_e"], 75.0, rtol=1e-6)


def test_json_messages_of_a_run_omit_the_summary(capsys: pytest.CaptureFixture[str]) -> None:
    """Each line on stderr is JSON. The frames and the file of times are written."""
    arguments = ("ok.nsl", "--scene", "builtin:dark", "--repeat", "3", "--timings", "t.json")
    status, err = run(*arguments, "--message-format", "json", capsys=capsys)
    assert status == 0
    assert all(json.loads(line) for line in err.splitlines())
    assert np.load("ok.frame.npz")["frame"].shape == (3, 1, 8, 6)
    assert set(json.loads(Path("t.json").read_text())) >= {"compile_s", "scene_s", "expose_s"}


@pytest.mark.parametrize(
    ("arguments", "code"),
    [
        (["ok.nsl"], "NS0744"),
        (["ok.nsl", "--scene", "builtin:hrd"], "NS0731"),
        (["ok.nsl", "--scene", "builtin:hdr", "--tolerance", "5"], "NS0746"),
        (["ok.nsl", "--scene", "builtin:hdr", "--plan", "ok.nsl"], "NS0747"),
        (["ok.nsl", "--scene", "builtin:hdr", "--effects", "shots"], "NS0756"),
        (["ok.nsl", "--scene", "builtin:hdr", "--sensor-set", "a=1"], "NS0753"),
        (["ok.nsl", "--scene", "builtin:hdr", "--sensor", "none.toml"], "NS0751"),
        (["ok.nsl", "--on", "/dev/nowhere", "--effects", "none"], "NS0770"),
        (["ok.nsl", "--scene", "builtin:hdr", "--keep", "ligth"], "NS0739"),
        (["ok.nsl", "--scene", "builtin:hdr", "--exposure", "x"], "NS0738"),
        (["ok.nsl", "--scene", "builtin:hdr", "-o", "x", "--png", "x"], "NS0745"),
    ],
)
def test_refused_runs_write_no_file(
    arguments: list[str], code: str, folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    before = sorted(folder.iterdir())
    status, err = run(*arguments, capsys=capsys)
    assert status == 2
    assert code in err
    assert sorted(folder.iterdir()) == before


def test_view_draws_both_kinds(capsys: pytest.CaptureFixture[str]) -> None:
    """Programs of fixed and open codes and a container each give a PNG file, and nothing on
    stdout."""
    assert main(["build", "ok.nsl", "-o", "ok.icw"]) == 0
    for program in ("ok.nsl", "open.nsl", "ok.icw"):
        assert main(["view", program, "-o", program + ".png"]) == 0
        assert Path(program + ".png").read_bytes().startswith(b"\x89PNG")
    assert capsys.readouterr().out == ""


def test_shutters_that_light_decides_are_refused_before_it_falls(
    root: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """The function that exposes is taken away, so NS0444 must come before it. No file is
    written."""
    from nscc_runtime import pieces

    monkeypatch.setattr(pieces, "simulate_scene", None)  # nothing is exposed
    looking = str(root / "examples" / "float_pixel.nsl")
    line = ("--scene", "builtin:dark", "--keep", "shutter,light", "-o", "f.npz")
    status, err = run(looking, *line, capsys=capsys)
    assert status == 1
    assert "NS0444" in err
    assert not Path("f.npz").exists()
