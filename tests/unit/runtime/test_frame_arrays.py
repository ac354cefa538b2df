"""One check of frame files: every command refuses the same damaged ones, each with its own code."""

from __future__ import annotations

import json
import shlex
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from nscc_command import RunNscc

from nscc.npy import InvalidArrays
from nscc_runtime.frame_arrays import read_frame_arrays
from nscc_runtime.frame_file import SCHEMA

SHAPE = (1, 6, 8)
META = {
    "schema": SCHEMA,
    "plan": None,
    "adc_offset": 0,
    "electrons_per_lsb": 10.0,
    "frame_us": 1000.0,
}


def arrays(**changes: Any) -> dict[str, Any]:
    """The arrays of a sound frame file; None takes one out."""
    whole: dict[str, Any] = {
        "frame": np.full(SHAPE, 9, np.uint8), "exposure_e": np.full(SHAPE, 90.0),
        "valid": np.ones(SHAPE, bool), "saturated": np.zeros(SHAPE, bool),
        "saturated_by": np.zeros(SHAPE, np.uint8), "open_slots": np.full(SHAPE, 4),
        "light_e_per_s": np.full(SHAPE, 5.0), "light_sd_e_per_s": np.full(SHAPE, 1.0),
        "meta": np.array(json.dumps(META)),
    }  # fmt: skip
    return {name: values for name, values in (whole | changes).items() if values is not None}


DAMAGED: dict[str, tuple[dict[str, Any], str]] = {
    "no frame": ({"frame": None}, "array `frame` is missing"),
    "no meta": ({"meta": None}, "array `meta` is missing"),
    "NaN codes": ({"frame": np.full(SHAPE, np.nan)}, "`frame` is float64"),
    "wide codes": ({"frame": np.full(SHAPE, 1009)}, "`frame` is int64"),
    "uint16": ({"frame": np.full(SHAPE, 9, np.uint16)}, "`frame` is uint16"),
    "empty": ({"frame": np.zeros((1, 0, 8), np.uint8)}, "its frame is (1, 0, 8)"),
    "flat": ({"frame": np.zeros(48, np.uint8)}, "its frame is (48,)"),
    "other shape": ({"saturated": np.zeros((1, 8, 6), bool)}, "`saturated` is (1, 8, 6)"),
    "other kind": ({"valid": np.ones(SHAPE)}, "`valid` is float64"),
    "huge light": ({"light_e_per_s": np.full(SHAPE, 1e300)}, "values above 1e+30"),
    "slots": ({"open_slots": np.ones(SHAPE)}, "`open_slots` is float64"),
    "schema": ({"meta": np.array('{"schema": 1}')}, "its schema is not"),
    "complex": ({"decode_gain": np.ones(3, complex)}, "`decode_gain` is complex128"),
    "no JSON": ({"meta": np.array("{")}, "its schema is not"),
    "nested": ({"meta": np.array("[" * 100_000)}, "its schema is not"),
    "plan": (
        {"meta": np.array(json.dumps(META | {"plan": {"effects": [1]}}))},
        "does not list its effects",
    ),
}  # fmt: skip


def test_a_sound_file_is_read(tmp_path: Path) -> None:
    """The frame, the meta data and the chosen array `valid` are read, and no other array."""
    np.savez(tmp_path / "f.npz", **arrays())
    found, meta = read_frame_arrays(tmp_path / "f.npz", "valid".__eq__)
    assert {*found} == {"frame", "valid", "meta"}
    assert meta == META


@pytest.mark.parametrize("name", DAMAGED)
def test_damaged_frame_files_are_refused_with_the_reason(tmp_path: Path, name: str) -> None:
    """Each damage of `DAMAGED` raises InvalidArrays with the reason that stands beside it."""
    changes, said = DAMAGED[name]
    np.savez(tmp_path / "f.npz", **arrays(**changes))
    with pytest.raises(InvalidArrays) as raised:
        read_frame_arrays(tmp_path / "f.npz")
    assert said in str(raised.value)


READERS: dict[str, tuple[str, Callable[[str], bool]]] = {
    "reconstruct any f.npz -o out.png": ("NS0819", lambda name: name not in (
        "huge light", "other kind", "slots")),
    "reconstruct hdr f.npz -o out.png": ("NS0819", lambda name: name not in (
        "huge light", "other kind", "complex")),
    "reconstruct f.npz -o out.png": ("NS0819", lambda name: name in (
        "no frame", "no meta", "huge light", "schema", "empty", "plan")),
    "view f.npz -o out.png": ("NS0801", lambda name: name not in (
        "huge light", "other kind", "other shape", "slots", "complex")),
    "calibrate f.npz --dark f.npz -o out.toml": ("NS0757", lambda name: name not in (
        "huge light", "other shape", "slots", "no meta", "complex", "schema", "no JSON", "nested")),
}  # fmt: skip
"""Commands that read frame files: their code, and what they read of the file."""


@pytest.mark.parametrize("line", READERS)
def test_every_command_refuses_damage_in_the_arrays_that_it_reads(
    tmp_path: Path, run_nscc: RunNscc, line: str
) -> None:
    """A command that reads the damaged array gives its own code and writes no file."""
    code, is_read = READERS[line]
    for name, (changes, said) in DAMAGED.items():
        if not is_read(name):
            continue
        np.savez(tmp_path / "f.npz", **arrays(**changes))
        outcome = run_nscc(shlex.split(line), tmp_path)
        assert outcome.codes == [code], (name, outcome.err)
        if code == "NS0819" and line.startswith("reconstruct any"):
            assert said in outcome.err
        assert [path.name for path in tmp_path.iterdir()] == ["f.npz"], name


@pytest.mark.parametrize("name", ["decode_gain", "decode_bias_e", "decode_variance_e2"])
def test_responses_have_the_shape_of_the_shutters(
    tmp_path: Path, run_nscc: RunNscc, name: str
) -> None:
    """A response array whose second axis is empty gives NS0819: responses of other shapes."""
    (tmp_path / "p.nsl").write_text("nsl 1\nframe 4 slots of 1ms\nopen when n < 2\n")
    line = "run p.nsl --scene builtin:dark -o f.npz"
    assert run_nscc(line.split(), tmp_path).status == 0
    with np.load(tmp_path / "f.npz") as file:
        whole = dict(file)
    np.savez(tmp_path / "f.npz", **whole | {name: whole[name][:, :0]})
    outcome = run_nscc(["reconstruct", "any", "f.npz", "-o", "out.png"], tmp_path)
    assert outcome.codes == ["NS0819"], outcome.err
    assert "responses of other shapes" in outcome.err
