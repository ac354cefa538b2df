"""Frames that a chip's own host saved: `nscc import-frame` beside the frames of `nscc run`."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest
from checkout import ROOT
from nscc_command import invoke

from nscc_runtime.effects import everything
from nscc_runtime.readout_noise import ReadoutNoise
from nscc_runtime.sensor import Sensor

PROGRAM = (
    "nsl 1\nframe 8 slots of 1ms\ncode stop : 1..8\nopen when n < stop\npixels stop = 1 + x % 8\n"
)
BUCKETS = (
    "nsl 1\nframe 8 slots of 1ms\nbucket early open when n < 4\nbucket late open when n >= 4\n"
)
EXAMPLES = ROOT / "examples"


def exposed(folder: Path, program: str) -> dict[str, np.ndarray]:
    """The arrays of a frame with every effect."""
    arguments = ["run", program, "--scene", "builtin:hdr", "--exposure", "2e5", "--effects", "all"]
    done = invoke([*arguments, "-o", "frame.npz"], folder)
    assert done.status == 0, done.err
    with np.load(folder / "frame.npz") as file:
        return dict(file)


def imported(folder: Path, program: str, *arguments: str) -> dict[str, np.ndarray]:
    done = invoke(["import-frame", program, *arguments, "-o", "imported.npz"], folder)
    assert done.status == 0, done.err
    assert "no picture tells how the host turned the array" in done.err
    with np.load(folder / "imported.npz") as file:
        return dict(file)


def saved(path: Path, picture: np.ndarray) -> None:
    """Save a picture as hosts do; Radiance and other formats of light are not among them."""
    if path.suffix == ".npy":
        np.save(path, picture)
    elif path.suffix == ".csv":
        np.savetxt(path, picture, fmt="%d", delimiter=",")
    else:
        assert cv2.imwrite(str(path), picture)


@pytest.mark.parametrize("ending", ["png", "bmp", "tiff", "npy", "csv"])
@pytest.mark.parametrize(
    ("turn", "options"),
    [
        (lambda codes: codes, []),
        (lambda codes: codes[::-1], ["--flip", "rows"]),
        (lambda codes: codes[:, ::-1], ["--flip", "cols"]),
        (lambda codes: codes[::-1, ::-1], ["--flip", "both"]),
        (lambda codes: codes.T, ["--transpose"]),
        (lambda codes: codes.T[::-1], ["--flip", "rows", "--transpose"]),
        (lambda codes: np.pad(codes, ((3, 9), (5, 1))), ["--crop", "3,5"]),
        (
            lambda codes: np.pad(codes.T[:, ::-1], ((2, 0), (0, 4))),
            ["--crop", "2,0", "--flip", "cols", "--transpose"],
        ),
    ],
)
def test_pictures_lie_as_the_user_says(
    tmp_path: Path, ending: str, turn: Any, options: list[str]
) -> None:
    (tmp_path / "p.nsl").write_text(PROGRAM)
    codes = np.random.default_rng(len(options)).integers(0, 256, (256, 256)).astype(np.uint8)
    saved(tmp_path / f"c.{ending}", np.ascontiguousarray(turn(codes)))
    arrays = imported(tmp_path, "p.nsl", f"c.{ending}", *options)
    np.testing.assert_array_equal(arrays["frame"][0], codes)


def test_an_imported_frame_is_the_frame_without_its_scene(tmp_path: Path) -> None:
    (tmp_path / "p.nsl").write_text(PROGRAM)
    made = exposed(tmp_path, "p.nsl")
    saved(tmp_path / "c.png", made["frame"][0])
    arrays = imported(tmp_path, "p.nsl", "c.png")
    meta, made_meta = (json.loads(str(each["meta"])) for each in (arrays, made))
    np.testing.assert_array_equal(arrays["decode_gain"], made["decode_gain"])
    lsb_e = made_meta["electrons_per_lsb"]
    inside = (made["frame"] > 0) & (made["frame"] < 255)
    # Codes add the noise and the fixed pattern of the readout and their rounding.
    sensor = Sensor(made_meta["sensor"])
    errors = ReadoutNoise.of(
        sensor, everything(), made_meta["device_seed"], made["frame"].shape[1:]
    )
    readout_lsb = errors.codes(made_meta["seed"], 0, 1)
    error_lsb = (arrays["exposure_e"] - made["exposure_e"]) / lsb_e - readout_lsb
    # Rounding to codes is half a code.
    assert np.abs(error_lsb[inside]).max() < 0.51
    assert meta["fidelity"] == "imported"
    assert [meta[key] for key in ("seed", "device_seed", "scene_sha256", "plan")] == [None] * 4
    assert meta["program_sha256"] == made_meta["program_sha256"]
    assert meta["imported"]["files"]["frame"]["file"] == "c.png"
    assert (meta["imported"]["flip"], meta["imported"]["transpose"]) == ("none", False)
    # What decodes and draws frames takes it as any other frame.
    for command in (
        ["reconstruct", "any", "imported.npz", "--method", "merge", "-o", "light.npz"],
        ["view", "imported.npz", "-o", "frame.png"],
    ):
        done = invoke(command, tmp_path)
        assert done.status == 0, done.err
    merged = invoke(
        ["reconstruct", "any", "frame.npz", "--method", "merge", "-o", "same.npz"], tmp_path
    )
    assert merged.status == 0
    light, same = (np.load(tmp_path / name)["image"] for name in ("light.npz", "same.npz"))
    assert np.median(np.abs(light - same)) < 0.02 * np.median(same)


def test_pictures_are_assigned_by_name_or_in_order(tmp_path: Path) -> None:
    """A file `e.png` or `edge=e.png` fills the readout `edge`. Two files come in the order of the
    buckets, or by name."""
    program = str(EXAMPLES / "edges.nsl")
    made = exposed(tmp_path, program)
    saved(tmp_path / "e.png", made["plane_edge"].astype(np.uint8) * 255)
    for given in ("e.png", "edge=e.png"):
        arrays = imported(tmp_path, program, given)
        np.testing.assert_array_equal(arrays["plane_edge"], made["plane_edge"])
        np.testing.assert_array_equal(arrays["margin"], made["margin"])
    (tmp_path / "b.nsl").write_text(BUCKETS)
    made = exposed(tmp_path, "b.nsl")
    for number, name in enumerate(("early", "late")):
        saved(tmp_path / f"{name}.npy", made["frame"][number])
    for given in (["early.npy", "late.npy"], ["late=late.npy", "early=early.npy"]):
        np.testing.assert_array_equal(imported(tmp_path, "b.nsl", *given)["frame"], made["frame"])


def test_registers_of_states_give_the_states(tmp_path: Path) -> None:
    program = str(EXAMPLES / "float_pixel.nsl")
    made = exposed(tmp_path, program)
    listed = invoke(["import-frame", program, "x.png", "-o", "i.npz"], tmp_path)
    names = listed.err.split("in this order: ")[1].splitlines()[0].split(", ")
    assert names[0] == "frame"
    # The value of a state is found by trying: all pixels with a register set, and none.
    saved(tmp_path / "frame.npy", made["frame"][0])
    files = ["frame=frame.npy"]
    generator = np.random.default_rng(1)
    for name in names[1:]:
        saved(tmp_path / f"{name}.npy", generator.random((256, 256)) < 0.5)
        files.append(f"{name}={name}.npy")
    arrays = imported(tmp_path, program, *files)
    bits = np.stack([np.load(tmp_path / f"{name}.npy") for name in names[1:]])
    states = arrays["states_closed_at"]
    for pattern in np.unique(bits.reshape(len(bits), -1), axis=1).T:
        chosen = (bits == pattern[:, None, None]).all(axis=0)
        assert len(np.unique(states[chosen])) == 1


@pytest.mark.parametrize(
    ("files", "reason"),
    [
        (["c.png", "c.png"], "has 1 readouts, but 2 pictures are given"),
        (["other=c.png"], "reads no 'other'"),
        (["missing.png"], "no such file"),
        (["p.nsl"], "its ending is none of .bmp, .png"),
        (["small.png"], "it has 8 x 9 pixels, but the array has 256 x 256"),
        (["c.png", "--crop", "1,0"], "it has 255 x 256 pixels after --crop"),
        (["c.png", "--crop", "x"], "not a row and a column"),
        (["deep.png"], "but codes are whole, 0 to 255"),
        (["colour.png"], "a picture in colour"),
        (["text.csv"], "not a table of numbers"),
        (["half.npy"], "it has the value 0.5"),
        (["nan.npy"], "it has the value nan"),
        (["cut.npy"], "cut short"),
        (["cut.png"], "cut.png"),
    ],
)
def test_unsuitable_pictures_are_refused(tmp_path: Path, files: list[str], reason: str) -> None:
    (tmp_path / "p.nsl").write_text(PROGRAM)
    codes = np.arange(65536, dtype=np.uint32).reshape(256, 256)
    saved(tmp_path / "c.png", (codes % 256).astype(np.uint8))
    saved(tmp_path / "small.png", np.zeros((8, 9), np.uint8))
    saved(tmp_path / "deep.png", codes.astype(np.uint16))
    saved(tmp_path / "colour.png", np.dstack([codes % 256, codes % 7, codes % 9]).astype(np.uint8))
    (tmp_path / "text.csv").write_text("a,b\nc,d\n")
    np.save(tmp_path / "half.npy", np.full((256, 256), 0.5))
    np.save(tmp_path / "nan.npy", np.full((256, 256), np.nan))
    for name in ("c.png", "half.npy"):
        cut = tmp_path / f"cut{Path(name).suffix}"
        cut.write_bytes((tmp_path / name).read_bytes()[:-99])
    done = invoke(["import-frame", "p.nsl", *files, "-o", "i.npz"], tmp_path)
    assert done.status == 2, done.err
    assert reason in done.err
    assert not (tmp_path / "i.npz").exists()


def test_a_readout_of_bits_with_more_than_two_values_is_refused(tmp_path: Path) -> None:
    """A picture of 256 values cannot be the two values of a register: status 2."""
    saved(tmp_path / "e.png", np.arange(65536, dtype=np.uint32).reshape(256, 256).astype(np.uint8))
    done = invoke(["import-frame", str(EXAMPLES / "edges.nsl"), "e.png", "-o", "i.npz"], tmp_path)
    assert done.status == 2
    assert "256 values, but the bits of a register are 0 and one other" in done.err
