"""Every example: built in every way, proved, disassembled and back, and run against an oracle."""

from __future__ import annotations

import json
from hashlib import sha256
from pathlib import Path

import numpy as np
import pytest
from checkout import ROOT
from example_shutters import RULES, shutters_of
from marks import slow
from nscc_command import Outcome, invoke

EXAMPLES = sorted((ROOT / "examples").glob("*.nsl"))
LOOKING = [path for path in EXAMPLES if "\nnsl 2\n" in path.read_text()]
"""Their shutters depend on the light: `test_looks_examples.py` has an oracle for each."""
PICTURED = [p for p in EXAMPLES if {"nsl 3", "nsl 4"} & {*p.read_text().splitlines()}]
"""They compute images: `test_neighbours_examples.py` and `test_laboratory_programs.py` have an
oracle for each."""
LONG = {"class_b_4096"}
"""Too long for light, frame and shutters of every pixel and slot in a test's memory."""

# Thirteen free bits leave no register to make edges with.
NO_EDGES = {"class_e"}
LATCH_SERVES = {
    "class_a",
    "class_b",
    "class_b_4096",
    "deblur",
    "foveated",
    "hdr_2x2",
    "hdr_doubling",
}

WORDS = ROOT / "tests" / "data" / "words"
"""How many words each example takes at each level, and their digest."""

examples = pytest.mark.parametrize("path", [pytest.param(p, id=p.stem) for p in EXAMPLES])
long_later = pytest.mark.parametrize(
    "path", [p if p.stem not in LONG else slow(p) for p in EXAMPLES], ids=lambda p: p.stem
)
fixed = pytest.mark.parametrize(
    "path", [pytest.param(p, id=p.stem) for p in EXAMPLES if p not in (*LOOKING, *PICTURED)]
)


def test_every_example_has_an_oracle_and_a_line_in_the_gallery() -> None:
    """Each example without looks or pictures has a numpy rule in `RULES`. Each example has a link
    in the gallery."""
    fixed_examples = {path.stem for path in EXAMPLES if path not in (*LOOKING, *PICTURED)}
    assert set(RULES) == fixed_examples
    gallery = (ROOT / "examples" / "README.md").read_text()
    assert [path.name for path in EXAMPLES if f"({path.name})" not in gallery] == []


@examples
def test_an_example_begins_with_its_purpose(path: Path) -> None:
    """The first line is a comment, and no line is longer than 100 characters."""
    assert path.read_text().startswith("# ")
    assert max(map(len, path.read_text().splitlines())) <= 100


@long_later
@pytest.mark.parametrize("level", ["0", "1", "2"])
def test_examples_have_the_recorded_proved_words(
    path: Path, level: str, tmp_path: Path, update_cases: bool
) -> None:
    """The words are those of tests/data/words; with --update-cases they are written there. Their
    assembly text gives the same container."""
    fine(["build", path, "-O", level, "-o", "a.icw", "--emit", "report"], tmp_path)
    report = json.loads((tmp_path / "a.report.json").read_text())
    assert report["proof"]["holds"]
    assert report["words_stored"] <= 1024
    fine(["prove", "a.icw"], tmp_path)
    text = fine(["disasm", "a.icw"], tmp_path).out
    (tmp_path / "a.asm").write_text(text)
    fine(["asm", "a.asm", "-o", "b.icw"], tmp_path)
    assert (tmp_path / "a.icw").read_bytes() == (tmp_path / "b.icw").read_bytes()
    lines = [line.split(";")[0].rstrip() for line in text[text.index("\n.wait") :].splitlines()]
    digest = sha256("\n".join(lines).encode()).hexdigest()[:16]
    beside = WORDS / f"{path.stem}-O{level}.txt"
    said = f"{report['words_stored']} words stored, sha256 {digest}\n"
    if update_cases:
        beside.write_text(said)
    assert said == beside.read_text(), "run with --update-cases if other words are meant"


@long_later
def test_every_example_is_built_and_proved_for_all_legal_codes(path: Path, tmp_path: Path) -> None:
    fine(["build", path, "--codes", "open", "-o", "a.icw"], tmp_path)
    fine(["prove", "a.icw"], tmp_path)


@fixed
def test_words_open_the_documented_shutters(path: Path, tmp_path: Path) -> None:
    """The shutters of 256 x 256 pixels, read from the words, are those of the example's numpy
    rule."""
    fine(["shutters", path, "-o", "s.npz"], tmp_path)
    with np.load(tmp_path / "s.npz") as data:
        _, rows, cols, slots = shape = tuple(data["shutter_shape"].tolist())
        found = np.unpackbits(data["shutter"], axis=-1, count=slots, bitorder="little")
    assert (rows, cols) == (256, 256)
    expected = shutters_of(path.stem, slots, rows, cols)
    assert expected.shape == shape
    assert np.array_equal(found, expected)


@fixed
@pytest.mark.parametrize("lowering", ["accumulate", "latch", "edges"])
def test_frames_are_the_light_of_open_slots(path: Path, lowering: str, tmp_path: Path) -> None:
    if path.stem in LONG:
        pytest.skip("a gigabyte of light; tests/benchmarks runs it")
    arguments = ["run", path, "--lowering", lowering, "-o", "f.npz", "--keep", "light,shutter"]
    arguments += ["--scene", "builtin:motion"]
    served = {"accumulate": set(RULES), "latch": LATCH_SERVES, "edges": set(RULES) - NO_EDGES}
    # This lowering cannot serve the example: the refusal is tested.
    if path.stem not in served[lowering]:
        refused = invoke(arguments, tmp_path)
        assert (refused.status, refused.codes[-1:]) == (1, ["NS0414"])
        return
    fine(arguments, tmp_path)
    with np.load(tmp_path / "f.npz") as data:
        light = data["light"].astype(np.float64)
        shutter = shutters_of(path.stem, len(light), *light.shape[1:])
        kept = np.unpackbits(data["shutter"], axis=-1, count=len(light), bitorder="little")
        assert np.array_equal(kept, shutter)
        oracle = np.einsum("nyx,byxn->byx", light, shutter, optimize=False)
        slack = 1e-6 * oracle + 1e-9 * light.sum(axis=0)
        assert np.all(np.abs(data["exposure_e"] - oracle) <= slack)
        lsb = json.loads(str(data["meta"]))["electrons_per_lsb"]
        assert np.array_equal(data["frame"], np.clip(np.rint(data["exposure_e"] / lsb), 0, 255))


def fine(arguments: list[str | Path], folder: Path) -> Outcome:
    """A command that must succeed, without a warning."""
    outcome = invoke(arguments, folder)
    assert outcome.status == 0, outcome.err
    assert "warning[" not in outcome.err
    return outcome
