"""Files that commands read, damaged or with other arrays in them: the command does its work or says
one clear thing, and leaves nothing of what it would have written."""

from __future__ import annotations

import io
import json
import shlex
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from nscc_command import invoke

from nscc.chips.load import builtin_target, target_toml

pytestmark = pytest.mark.filterwarnings("error::RuntimeWarning")

FRAME = 'nsl 1\ntarget "small.toml"\nframe 4 slots of 1ms\n'
PROGRAMS = {
    "p.nsl": "code stop : 1..4\nopen when n < stop\npixels stop = 1 + (x + y) % 4\n",
    "flat.nsl": "open when true\n",
    "b.nsl": 'shutters book from "book.npz"\ncode id : row of book\nopen when book[id]\n'
    'pixels from "codes.npz"\n',
}
MADE = (
    "build p.nsl -o p.icw",
    "run p.nsl --scene builtin:hdr --effects auto --plan plan.json --keep light,truth -o f.npz",
    *(
        f"run flat.nsl --scene builtin:flat:{e} --effects shot,adc_noise --repeat 8 -o level{e}.npz"
        for e in (0, 4000, 20000)
    ),
)
CALIBRATE = (
    "calibrate level4000.npz level20000.npz --dark level0.npz -o out.toml --target small.toml"
)
READERS = {
    "p.nsl": ("check p.nsl", "build p.nsl -o out.icw"),
    "small.toml": ("check p.nsl", "run p.nsl --scene builtin:hdr -o out.npz"),
    "book.npz": ("check b.nsl",),
    "codes.npz": ("check b.nsl", "run p.nsl --scene builtin:dark --pixels codes.npz -o out.npz"),
    "p.icw": ("prove p.icw", "run p.icw --scene builtin:dark -o out.npz", "disasm p.icw"),
    "p.asm": ("asm p.asm -o out.icw",),
    "sensor.toml": (
        "run p.nsl --scene builtin:hdr --sensor sensor.toml --effects auto -o out.npz",
        "effects --sensor sensor.toml",
    ),
    "plan.json": ("run p.nsl --scene builtin:hdr --plan plan.json -o out.npz",),
    "f.npz": (
        "run p.nsl --scene f.npz --effects auto -o out.npz",
        "metrics f.npz f.npz --data-range 1",
    ),
    "level0.npz": (CALIBRATE,),
    "level4000.npz": (CALIBRATE,),
}
"""What reads each file."""


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """One of every kind of file, and nothing else."""
    made = tmp_path_factory.mktemp("files")
    small = replace(builtin_target("scamp5"), rows=16, cols=16, name="small")
    (made / "small.toml").write_text(target_toml(small))
    rng = np.random.default_rng(1)
    np.savez(made / "book.npz", book=rng.integers(0, 2, (4, 4)).astype(np.uint8))
    np.savez(made / "codes.npz", id=rng.integers(0, 4, (16, 16)), stop=np.full((16, 16), 2))
    for name, text in PROGRAMS.items():
        (made / name).write_text(FRAME + text)
    for line in MADE:
        outcome = invoke(shlex.split(line), made)
        assert outcome.status == 0, outcome.err
    (made / "sensor.toml").write_text(invoke(["effects", "--toml"], made).out)
    (made / "p.asm").write_text(invoke(["disasm", "p.icw"], made).out)
    return made


@pytest.mark.parametrize("name", READERS)
def test_whole_files_are_read(name: str, folder: Path) -> None:
    for line in READERS[name]:
        if name != "f.npz" or "metrics" not in line:  # which array is meant is not clear
            assert judge(folder, line) == 0


@settings(max_examples=15)
@given(data=st.data())
@pytest.mark.parametrize("name", READERS)
def test_damaged_files_are_refused_or_read(name: str, data: st.DataObject, folder: Path) -> None:
    whole = (folder / name).read_bytes()
    start = data.draw(st.integers(0, len(whole) - 1))
    end = data.draw(st.integers(start, min(len(whole), start + 64)))
    middle = data.draw(
        st.one_of(
            st.binary(max_size=8),
            st.sampled_from(
                [
                    b"1e400",
                    b"nan",
                    b"-1",
                    b"99999999999999999999",
                    b"\xed\xa0\x80",
                    b"null",
                    b"{",
                    b'"',
                ]
            ),
        )
    )
    rest = b"" if data.draw(st.booleans()) else whole[end:]
    read_as(folder, name, whole[:start] + middle + rest)


ARRAYS = [
    lambda a: a[None],
    lambda a: a.reshape(-1),
    lambda a: a[..., :-1],
    lambda a: a[:0],
    lambda a: a.T,
    lambda a: a.astype("c16"),
    lambda a: a.astype("f8") * np.nan,
    lambda a: a.astype("f8") - 1e308,
    lambda a: a.astype("f4") * np.float32(1e-45),
    lambda a: np.full(a.shape, -(2**63)),
    lambda a: np.full(a.shape, 2**64 - 1, np.uint64),
    lambda a: np.full(a.shape, "x"),
    lambda a: np.array(7),
    lambda a: np.zeros(a.shape, [("a", "i4")]),
    lambda a: np.array(json.dumps({"schema": 1})),
]


@settings(max_examples=15)
@given(data=st.data())
@pytest.mark.parametrize("name", [name for name in READERS if name.endswith(".npz")])
def test_files_of_other_arrays_are_refused_or_read(
    name: str, data: st.DataObject, folder: Path
) -> None:
    with np.load(folder / name) as file:
        arrays: dict[str, Any] = dict(file)
    key = data.draw(st.sampled_from([k for k, a in arrays.items() if a.dtype.kind != "U"]))
    arrays[key] = data.draw(st.sampled_from(ARRAYS))(np.atleast_1d(arrays[key]))
    stream = io.BytesIO()
    np.savez(stream, **arrays)
    read_as(folder, name, stream.getvalue())


def read_as(folder: Path, name: str, content: bytes) -> None:
    """Every reader of a file meets this content of it; afterwards it is what it was."""
    whole = (folder / name).read_bytes()
    (folder / name).write_bytes(content)
    try:
        for line in READERS[name]:
            judge(folder, line)
    finally:
        (folder / name).write_bytes(whole)


def judge(folder: Path, line: str) -> int:
    before = {path.name for path in folder.iterdir()}
    found = invoke(shlex.split(line), folder)
    assert found.status in (0, 1, 2), found.err
    left = {path.name for path in folder.iterdir()} - before
    if found.status:
        assert found.codes
        # What a broken promise was measured on is kept.
        assert not left or found.codes[-1] == "NS0749"
    for name in left:
        (folder / name).unlink()
    return found.status


@pytest.mark.parametrize("number", range(len(ARRAYS)))
def test_frame_files_with_other_arrays_are_drawn_or_refused(number: int, folder: Path) -> None:
    """The test replaces one array of a frame file at a time by an array of another kind."""
    whole = (folder / "f.npz").read_bytes()
    with np.load(folder / "f.npz") as file:
        arrays: dict[str, Any] = dict(file)
    try:
        for key in ("frame", "exposure_e"):
            with_other = {**arrays, key: ARRAYS[number](arrays[key])}
            np.savez(folder / "f.npz", **with_other)
            judge(folder, "view f.npz -o out.png")
    finally:
        (folder / "f.npz").write_bytes(whole)


@pytest.mark.parametrize(
    "table", [b"", b"\xff", b"step,split\n\0", b"step,split,psnr_db\nx,val,y\n"]
)
@pytest.mark.parametrize("result", [b"{}", b"[]", b'{"robustness": 1}', b'{"robustness": [1]}'])
def test_damaged_runs_are_drawn_or_refused(table: bytes, result: bytes, folder: Path) -> None:
    run = folder.parent / "a_run"
    run.mkdir(exist_ok=True)
    (run / "metrics.csv").write_bytes(table)
    (run / "result.json").write_bytes(result)
    judge(folder, f"view {run} -o out.png")
