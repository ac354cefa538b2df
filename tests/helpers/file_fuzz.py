"""Seeded mutations of every kind of file that nscc reads, and the commands that read each kind."""

from __future__ import annotations

import io
import json
import re
import resource
import shlex
import signal
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from hashlib import sha256
from pathlib import Path
from random import Random
from struct import Struct
from types import FrameType
from typing import Any

import cv2
import numpy as np
from nscc_command import Outcome, invoke
from small_runs import trained

from nscc.chips.load import builtin_target, target_toml

SECONDS = 60
"""No command may take longer."""
MOST_KB = 2_000_000
"""No command may take more memory: 2 GB, as `getrusage` counts it."""

PROGRAMS = {
    "p.nsl": 'nsl 1\ntarget "small.toml"\nframe 4 slots of 1ms\ncode stop : 1..4\n'
    "open when n < stop\npixels stop = 1 + (x + y) % 4\n",
    "flat.nsl": 'nsl 1\ntarget "small.toml"\nframe 4 slots of 1ms\nopen when true\n',
    "look.nsl": 'nsl 2\ntarget "small.toml"\nframe 5 slots of 1ms\n'
    "sense full when exposure > 30% at n == 5\nstate short : bit = 0 kept\n"
    "state was : bit = 0\nnext was = short\nnext short = full\n"
    "open when n < 4 and (not short or n < 2)\nread short, was\n",
}
_DARK = "--scene builtin:dark -o out.npz"
_SCENE = "--fit scale --exposure 4000 -o out.npz"
READERS: dict[str, tuple[str, ...]] = {
    "p.nsl": ("check p.nsl", "fmt --check p.nsl", "build p.nsl -o out.icw"),
    "look.nsl": ("check look.nsl", "build look.nsl -o out.icw"),
    "p.icw": ("prove p.icw", f"run p.icw {_DARK}", "disasm p.icw -o out.asm"),
    "look.icw": (
        "prove look.icw", f"run look.icw {_DARK}", "disasm look.icw -o out.asm",
        "run look.icw --scene builtin:hdr --effects shot,read -o out.npz",
        "view look.icw -o out.png",
    ),
    "p.asm": ("asm p.asm -o out.icw",),
    "small.toml": ("check p.nsl", f"run flat.nsl {_DARK}"),
    "sensor.toml": ("run p.nsl --scene builtin:hdr --sensor sensor.toml --effects all -o out.npz",),
    "plan.json": ("run p.nsl --scene builtin:hdr --plan plan.json -o out.npz",),
    "f.npz": (
        "reconstruct any f.npz -o out.png", "view f.npz -o out.png", "reconstruct f.npz -o out.png",
        "calibrate f.npz --dark f.npz -o out.toml --target small.toml",
    ),
    "look.npz": ("reconstruct look.npz -o out.png", "view look.npz -o out.png"),
    "codes.npz": (f"run p.nsl --pixels codes.npz {_DARK}",),
    "scene.npz": (
        "run p.nsl --scene scene.npz -o out.npz", "metrics scene.npz scene.npz --data-range 9",
    ),
    "scene.mat": (
        "run p.nsl --scene scene.mat -o out.npz", "metrics scene.mat scene.mat --data-range 9",
    ),
    **{f"pic.{kind}": (f"run flat.nsl --scene pic.{kind} {_SCENE}",)
       for kind in ("hdr", "exr", "tiff", "png", "jpg", "pfm")},
    **{f"clip.{kind}": (f"run flat.nsl --scene clip.{kind} {_SCENE}",)
       for kind in ("avi", "gif", "tiff", "webp")},
    "v73.mat": ("metrics v73.mat v73.mat --data-range 9",),
    "meas.npz": ("reconstruct any meas.npz -o out.npz",),
    "config.toml": (
        "train config.toml --out out --set train.steps=1 --set train.batch=1 --set data.patch=16 "
        "--set data.scenes=2 --set data.val_items=1 --set shutter.slots=8",
    ),
    "run/decoder.safetensors": ("reconstruct run run_frame.npz -o out.png",),
    "run/result.json": ("view run -o out.png", "reconstruct run run_frame.npz -o out.png"),
}  # fmt: skip
"""What reads each file."""

QUICK = tuple(name for name in READERS if name != "config.toml" and "/" not in name)
"""Files whose readers need no run of `nscc train`."""


def make_files(folder: Path, *, with_run: bool) -> None:
    """Write one file of every kind into an empty folder."""
    small = replace(builtin_target("scamp5"), rows=12, cols=16, name="small")
    (folder / "small.toml").write_text(target_toml(small))
    for name, text in PROGRAMS.items():
        (folder / name).write_text(text)
    rng = np.random.default_rng(5)
    light = rng.random((4, 12, 16)).astype(np.float32) * 900
    np.savez(folder / "codes.npz", stop=np.full((12, 16), 2))
    np.savez(folder / "scene.npz", light=light)
    from scipy.io import savemat

    savemat(folder / "scene.mat", {"light": light}, do_compression=True)
    _make_pictures(folder, rng)
    made = (
        "build p.nsl -o p.icw",
        "build look.nsl -o look.icw",
        "disasm p.icw -o p.asm",
        "run p.nsl --scene builtin:hdr --effects auto --plan plan.json -o f.npz",
        "run look.nsl --scene builtin:hdr -o look.npz",
        "effects --toml sensor.toml",
    )
    for line in made[:-1]:
        outcome = invoke(shlex.split(line), folder)
        assert outcome.status == 0, (line, outcome.err)
    (folder / "sensor.toml").write_text(invoke(["effects", "--toml"], folder).out)
    if with_run:
        (folder / "config.toml").write_text(_CONFIG)
        trained(folder / "run", shutter={"class": "b", "slots": 8, "tile": [2, 2]})
        line = f"run run/shutter.nsl {_DARK.replace('out', 'run_frame')}"
        outcome = invoke(shlex.split(line), folder)
        assert outcome.status == 0, outcome.err


_CONFIG = """[shutter]
class = "b"
slots = 8
tile = [2, 2]

[data]
patch = 16
scenes = 2
val_items = 1

[train]
steps = 1
batch = 1
validate_every = 1
"""


def _make_pictures(folder: Path, rng: np.random.Generator) -> None:
    import h5py
    import OpenEXR
    from PIL import Image

    picture = rng.integers(0, 255, (24, 32, 3), np.uint8)
    for kind in ("hdr", "pfm", "tiff", "png", "jpg"):
        linear = kind in ("hdr", "pfm")
        cv2.imwrite(str(folder / f"pic.{kind}"), picture.astype("f4") if linear else picture)
    header = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}
    with OpenEXR.File(header, {"RGB": picture.astype("f4")}) as file:
        file.write(str(folder / "pic.exr"))
    frames = [np.roll(picture, k, axis=1) for k in range(5)]
    first, *others = map(Image.fromarray, frames)
    first.save(folder / "clip.gif", save_all=True, append_images=others)
    for kind in ("tiff", "webp"):
        first.save(folder / f"clip.{kind}", save_all=True, append_images=others)
    with h5py.File(folder / "v73.mat", "w", userblock_size=512) as hdf5:
        hdf5.create_dataset("image", data=rng.random((24, 32)), compression="gzip")
    mask = rng.integers(0, 2, (24, 32, 4))
    np.savez(folder / "meas.npz", mask=mask, meas=rng.random((24, 32)))
    code = cv2.VideoWriter_fourcc(*"MJPG")  # type: ignore[attr-defined]
    clip = cv2.VideoWriter(str(folder / "clip.avi"), code, 25, (32, 24))
    for frame in frames:
        clip.write(frame)
    clip.release()


_VALUES: tuple[Any, ...] = (
    0, 1, -1, 2, 255, 2**31 - 1, 2**31, 2**63, -(2**63), 10**30, 0.5, -0.0, 1e-300, 1e300, 1e15,
    1e-6, None, True, False, "", "x", "frame", "\ud800", [], [0], [[]], {}, {"a": 1},
)  # fmt: skip
_TEXTS = (
    "0", "-1", "1", "1e400", "nan", "inf", "1e-300", "99999999999999999999", "true", '""', "[]",
    "[1, 2]", "{}", "null", '"x"', "\n", "[", "]", "{", "é", "\x00",
)  # fmt: skip


def mutated(choose: Random, name: str, whole: bytes) -> bytes:
    """A changed copy of a file; files with checksums are signed anew."""
    kind = name.rpartition(".")[2]
    if choose.random() < 0.15:
        return _mutated_bytes(choose, whole)
    match kind:
        case "icw":
            return _mutated_container(choose, whole)
        case "npz":
            return _mutated_arrays(choose, whole)
        case "json":
            return json.dumps(_mutated_value(choose, json.loads(whole))).encode()
        case "nsl" | "toml" | "asm":
            return _mutated_text(choose, whole.decode()).encode("utf-8", "surrogatepass")
        case "safetensors":
            size = int.from_bytes(whole[:8], "little")
            header = json.dumps(_mutated_value(choose, json.loads(whole[8 : 8 + size]))).encode()
            return len(header).to_bytes(8, "little") + header + whole[8 + size :]
    return _mutated_bytes(choose, whole)


def _mutated_bytes(choose: Random, data: bytes) -> bytes:
    for _ in range(choose.choice((1, 1, 2, 5))):
        # Headers decide more than what follows them.
        begin = choose.randrange(
            len(data) + 1 if choose.random() < 0.5 else min(200, len(data)) + 1
        )
        end = min(len(data), begin + choose.choice((0, 1, 1, 2, 4, 8, 64)))
        middle = choose.choice(
            (
                b"",
                b"\x00",
                b"\xff",
                b"\xff\xff\xff\x7f",
                choose.randbytes(4),
                data[:end][-64:],
            )
        )
        data = data[:begin] + middle + (b"" if choose.random() < 0.1 else data[end:])
    return data


def _mutated_text(choose: Random, text: str) -> str:
    for _ in range(choose.choice((1, 1, 2))):
        tokens = [*re.finditer(r'[\w.+-]+|"[^"]*"|\S', text)]
        if not tokens:
            return text + choose.choice(_TEXTS)
        old, other = choose.choice(tokens), choose.choice(tokens)
        new = choose.choice((choose.choice(_TEXTS), other.group(), "", old.group() * 2))
        text = text[: old.start()] + new + text[old.end() :]
    return text


def _mutated_value(choose: Random, value: Any) -> Any:
    """A JSON value with one part of it replaced, removed or repeated."""
    if isinstance(value, dict) and value and choose.random() < 0.95:
        key = choose.choice([*value])
        if choose.random() < 0.1:
            return {name: part for name, part in value.items() if name != key}
        return {**value, key: _mutated_value(choose, value[key])}
    if isinstance(value, list) and value and choose.random() < 0.9:
        place = choose.randrange(len(value))
        if choose.random() < 0.15:
            return value[:place] + value[place + 1 :] + value[:1] * choose.choice((0, 1, 2))
        return [*value[:place], _mutated_value(choose, value[place]), *value[place + 1 :]]
    if type(value) in (int, float) and choose.random() < 0.6:
        return choose.choice((value + 1, value - 1, -value, value * 2, value * 1e9))
    return choose.choice(_VALUES)


_PREAMBLE = Struct("<8sIIQ")


def _mutated_container(choose: Random, whole: bytes) -> bytes:
    magic, version, size, _ = _PREAMBLE.unpack_from(whole)
    start = _PREAMBLE.size
    text, arrays = whole[start : start + size], bytearray(whole[start + size : -32])
    if choose.random() < 0.6:
        header = _mutated_value(choose, json.loads(text))
        try:
            text = json.dumps(header, sort_keys=True, separators=(",", ":")).encode("ascii")
        except TypeError:  # keys of several kinds
            return whole
    else:
        for _ in range(choose.choice((1, 1, 2, 8))):
            place = choose.randrange(len(arrays))
            arrays[place : place + 8] = choose.choice(
                (
                    bytes([choose.randrange(256)]) + arrays[place + 1 : place + 8],
                    np.float64(choose.choice((np.nan, np.inf, -1.0, 1e300, 1e-300))).tobytes(),
                    choose.randbytes(8),
                )
            )[: len(arrays[place : place + 8])]
    length = start + len(text) + len(arrays) + 32
    body = _PREAMBLE.pack(magic, version, len(text), length) + text + bytes(arrays)
    return body + sha256(body).digest()


_ARRAYS: tuple[Callable[[Any], Any], ...] = (
    lambda a: a[None], lambda a: a.reshape(-1), lambda a: a[..., :-1], lambda a: a[:0],
    lambda a: a.T, lambda a: a.astype("c16"), lambda a: a.astype("f8") * np.nan,
    lambda a: a.astype("f8") - 1e308, lambda a: a.astype("f4") * np.float32(1e-45),
    lambda a: a.astype("i8") + 1000, lambda a: np.full(a.shape, -(2**63)),
    lambda a: np.full(a.shape, 2**64 - 1, np.uint64), lambda a: np.full(a.shape, "x"),
    lambda a: np.array(7), lambda a: np.zeros(a.shape, [("a", "i4")]),
    lambda a: np.where(np.arange(a.size).reshape(a.shape) % 7 == 0, np.inf, a.astype("f8")),
)  # fmt: skip


def _mutated_arrays(choose: Random, whole: bytes) -> bytes:
    with np.load(io.BytesIO(whole)) as file:
        arrays: dict[str, Any] = dict(file)
    name = choose.choice([*arrays])
    if choose.random() < 0.1:
        del arrays[name]
    elif arrays[name].dtype.kind == "U":
        meta = json.dumps(_mutated_value(choose, json.loads(str(arrays[name]))))
        arrays[name] = np.array(meta)
    else:
        with np.errstate(all="ignore"):
            arrays[name] = choose.choice(_ARRAYS)(np.atleast_1d(arrays[name]))
    stream = io.BytesIO()
    np.savez(stream, **arrays)
    return stream.getvalue()


def sign_run(folder: Path) -> None:
    """Give the result of the run in a folder the digests of the files that it has now."""
    path = folder / "run" / "result.json"
    result = json.loads(path.read_bytes())
    weights = (folder / "run" / "decoder.safetensors").read_bytes()
    result["files"]["decoder.safetensors"] = sha256(weights).hexdigest()
    path.write_text(json.dumps(result))


@contextmanager
def other_content(folder: Path, name: str, content: bytes) -> Iterator[None]:
    """Within it a file of the folder has this content."""
    signed = name.endswith(".safetensors")
    names = (name, "run/result.json") if signed else (name,)
    before = {path: (folder / path).read_bytes() for path in names}
    (folder / name).write_bytes(content)
    try:
        if signed:
            sign_run(folder)
        yield
    finally:
        for path, data in before.items():
            (folder / path).write_bytes(data)


@contextmanager
def no_longer_than(seconds: int, what: str) -> Iterator[None]:
    """Raises TimeoutError in a command that hangs."""

    def stop(_number: int, _frame: FrameType | None) -> None:
        raise TimeoutError(f"longer than {seconds} s: {what}")

    old = signal.signal(signal.SIGALRM, stop)
    signal.alarm(seconds)
    try:
        yield
    finally:
        signal.alarm(0)
        signal.signal(signal.SIGALRM, old)


def run_in_process(folder: Path, line: str) -> Outcome:
    """A command in this process; AssertionError where it takes too much memory."""
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    with no_longer_than(SECONDS, line):
        outcome = invoke(shlex.split(line), folder)
    after = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    assert after <= max(before, MOST_KB), f"{after} kB"
    return outcome


def run_command(folder: Path, line: str) -> Outcome:
    """The same in a process of its own."""
    command = [sys.executable, "-m", "nscc_cli", *shlex.split(line)]
    done = subprocess.run(command, cwd=folder, capture_output=True, timeout=SECONDS)
    assert resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss <= MOST_KB
    return Outcome(done.returncode, done.stdout.decode(), done.stderr.decode())


def fault_of(folder: Path, line: str, run: Callable[[Path, str], Outcome]) -> str | None:
    """What a command does that it must not; None where it works or refuses its input in words."""
    before = {path.name for path in folder.iterdir()}
    try:
        outcome = run(folder, line)
    except (Exception, SystemExit) as error:
        return f"{line}: {type(error).__name__}: {error}"[:300]
    products = {path for path in folder.iterdir() if path.name not in before}
    names = sorted(path.name for path in products)
    for path in products:
        if path.is_dir():
            for inner in path.iterdir():
                inner.unlink()
            path.rmdir()
        else:
            path.unlink()
    if outcome.status not in (0, 1, 2) or "Traceback" in outcome.err:
        return f"{line}: status {outcome.status}: {outcome.err[-1500:]}"
    if outcome.status and not outcome.codes and "fmt" not in line:
        return f"{line}: status {outcome.status} without a message"
    if outcome.status and names and "NS0749" not in outcome.codes:
        return f"{line}: failed, and left {names}"
    if any(not name.startswith("out") for name in names):
        return f"{line}: wrote {names}"
    return None


def faults(
    folder: Path,
    names: tuple[str, ...],
    seed: int,
    count: int,
    run: Callable[[Path, str], Outcome] = run_in_process,
) -> list[str]:
    """Mutate `count` files of those `names` in turn, each with its own seed, and list what the
    commands that read them do wrong."""
    found = []
    for number in range(count):
        name = names[number % len(names)]
        choose = Random(f"{seed} {number}")
        content = mutated(choose, name, (folder / name).read_bytes())
        line = choose.choice(READERS[name])
        with other_content(folder, name, content):
            fault = fault_of(folder, line, run)
        if fault is not None:
            found.append(f"seed {seed}, number {number}, {name}: {fault}")
    return found
