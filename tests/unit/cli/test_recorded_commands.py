"""What commands print and the texts that they write, compared with tests/data/commands.

Each session is a list of commands in one folder. `pytest --update-cases` records them again.
"""

from __future__ import annotations

import json
import re
import shutil
from collections.abc import Mapping
from pathlib import Path

import numpy as np
import pytest
from checkout import ROOT
from nscc_command import invoke
from recorded import compare_with_recorded

EXAMPLES = ROOT / "examples"
SESSIONS: Mapping[str, tuple[str, ...]] = {
    "targets": (
        "targets", "targets scamp5", "targets scamp5 --toml",
        "targets --compare scamp5 dual-tap class_b.nsl",
        "targets --compare scamp5 dual-tap class_d.nsl --json",
    ),
    "effects": (
        "effects", "effects shot", "effects analog", "effects black_sun", "effects --toml",
        "effects --json",
    ),
    "guide": (
        "examples", "explain NS0412", "explain NS0746", "new first.nsl", "check first.nsl",
        "new first.nsl",
    ),
    "schemas": tuple(
        f"sweep --schema {kind}"
        for kind in ("compile", "limits", "emulate", "train", "evaluate", "design")
    ),
    "checks": (
        "check class_b.nsl class_d.nsl float_pixel.nsl edges.nsl codebook.nsl two_buckets.nsl",
        "check class_e.nsl --message-format json", "check staggered.nsl --codes open",
        "check small.nsl --message-format github", "fmt small.nsl --check --diff",
    ),
    "builds": (
        "build small.nsl -o s.icw --emit report,asm", "disasm s.icw", "prove s.icw",
        "build small.nsl -o t.icw -O 0 --lowering accumulate", "diff s.icw t.icw",
        "build looks.nsl -o l.icw --emit report", "disasm l.icw", "diff s.icw l.icw",
        "build images.nsl -o i.icw --emit report", "disasm i.icw", "shutters s.icw -o s.npz",
    ),
    "runs": (
        "run small.nsl --scene builtin:hdr -o a.npz --effects none",
        "run small.nsl --scene builtin:motion -o b.npz --effects shot,adc --repeat 2",
        "run small.nsl --scene builtin:hdr -o c.npz --effects auto --tolerance 2%",
        "run looks.nsl --scene builtin:hdr -o l.npz --effects all",
        "run images.nsl --scene builtin:motion -o i.npz --effects none",
    ),
    "metrics": (
        "metrics t.npy r.npy --data-range 255", "metrics t.npy r.npy --data-range 255 --json",
        "metrics c.npy d.npy --data-range 1", "metrics c.npy d.npy --data-range 1 --json",
        "metrics t.npy c.npy --data-range 255",
    ),
    "devkit": (
        "build looks.nsl -o l.icw --emit cpp", "build images.nsl -o i.icw --emit cpp",
    ),
    "designs": (
        "design --scene builtin:hdr --looks 3 --target small.toml --slots 16 -o d.nsl",
        "design --scene builtin:hdr --criterion sve-risk --target small.toml -o e.nsl",
    ),
    "sensors": (
        "run open.nsl --scene builtin:flat:4000 --effects all --repeat 4 --sensor q.toml -o f1.npz",
        "run open.nsl --scene builtin:flat:9000 --effects all --repeat 4 --sensor q.toml -o f2.npz",
        "run open.nsl --scene builtin:flat:15000 --effects all --repeat 4 --sensor q.toml "
        "-o f3.npz",
        "run open.nsl --scene builtin:dark --effects all --repeat 4 --sensor q.toml -o d1.npz",
        "calibrate f1.npz f2.npz f3.npz --dark d1.npz --program open.nsl --target small.toml "
        "-o s.toml --json",
        "calibrate f1.npz f2.npz f3.npz --dark d1.npz --crosstalk 0 --target small.toml -o t.toml",
        "run open.nsl --scene builtin:flat:4000 --effects all --sensor s.toml -o g.npz",
    ),
    "masks": (
        "import-mask m.npz -o m.nsl --slots-axis last", "check m.nsl",
        "import-mask m.npz -o n.nsl --slots-axis last --slot-us 2000",
    ),
}  # fmt: skip
SMALL = """nsl 1
target "small.toml"
frame 16 slots of 250us
code start : 0..12
open when start <= n < start + 4
pixels start = (x + 2*y) % 13
"""
LOOKS = """nsl 2
target "small.toml"
frame 16 slots of 250us
sense bright when light > [30%, 45%] at n in [3, 8]
state closed : 0..2 = 0
next closed = looks when bright and closed == 0
open when closed == 0
read closed
"""
IMAGES = """nsl 3
target "small.toml"
frame 4 slots of 250us
open when true
outside 0
kernel sx = [[1, 0, -1], [2, 0, -2], [1, 0, -1]] / 8
image strength = abs(sx(exposure))
plane edge = strength > 6%
read edge, strength
"""


QUIET = """analog_noise_lsb = 0.2
adc_pattern_lsb = 0.5
adc_smooth_lsb = 0.5
adc_level_lsb = 0.1
"""
"""A sensor that few frames of a small array calibrate."""
OPEN = """nsl 1
target "small.toml"
frame 4 slots of 250us
open when true
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder with examples, programs of a small array, and arrays."""
    for path in EXAMPLES.glob("*.nsl"):
        shutil.copy(path, tmp_path)
    toml = invoke(["targets", "scamp5", "--toml"], tmp_path).out
    (tmp_path / "small.toml").write_text(
        toml.replace("rows = 256", "rows = 24").replace("cols = 256", "cols = 32")
    )
    for name, text in {"small": SMALL, "looks": LOOKS, "images": IMAGES, "open": OPEN}.items():
        (tmp_path / f"{name}.nsl").write_text(text)
    (tmp_path / "q.toml").write_text(QUIET)
    rng = np.random.default_rng(4)
    truth = rng.integers(0, 256, (24, 32))
    np.save(tmp_path / "t.npy", truth.astype(np.uint8))
    np.save(tmp_path / "r.npy", np.clip(truth + rng.integers(-9, 10, (24, 32)), 0, 255))
    clip = rng.random((3, 16, 20))
    np.save(tmp_path / "c.npy", clip)
    np.save(tmp_path / "d.npy", np.clip(clip + 0.05 * rng.standard_normal(clip.shape), 0, 1))
    np.savez(tmp_path / "m.npz", mask=rng.random((8, 4, 4)) < 0.5)
    return tmp_path


TEXTS = (".nsl", ".json", ".asm", ".cpp", ".hpp", ".toml", ".csv")


@pytest.mark.parametrize("name", SESSIONS)
def test_commands_print_the_recorded_text(name: str, folder: Path, update_cases: bool) -> None:
    """Texts that a command writes follow what it prints."""
    before, shown = {path.name for path in folder.iterdir()}, []
    for line in SESSIONS[name]:
        done = invoke(line.split(), folder)
        shown += [f"$ nscc {line}", done.out, done.err, f"status {done.status}"]
        for path in sorted(folder.iterdir()):
            if path.name not in before and path.suffix in TEXTS:
                shown += [f"--- {path.name}", path.read_text(encoding="utf-8")]
            if path.name not in before and path.suffix == ".npz":
                shown += arrays_of(path)
            before.add(path.name)
    text = "\n".join(shown).replace(str(folder), "FOLDER") + "\n"
    text = re.sub(r"; [0-9.e-]+ s$", "; some s", text, flags=re.MULTILINE)
    compare_with_recorded(text, f"commands/{name}", update_cases)


def arrays_of(path: Path) -> list[str]:
    """The arrays of a file with means of their values, and the settings of a frame."""
    lines = [f"--- {path.name}"]
    with np.load(path) as arrays:
        for name in sorted(arrays.files):
            array = arrays[name]
            if array.dtype.kind in "biuf":
                values = np.nan_to_num(array.astype(float), nan=0.0, posinf=0.0, neginf=0.0)
                spread = f"sum {values.sum():.9g}, of squares {np.sum(values**2):.9g}"
                lines.append(f"{name} {array.dtype} {array.shape} {spread}")
            elif name == "meta":
                settings = {**json.loads(str(array)), "plan": None}  # see tests/data/plans
                lines.append(json.dumps(settings, indent=1, sort_keys=True))
    return lines
