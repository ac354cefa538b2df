"""Programs of versions 1 to 3 build to the bytes that they had before version 4 of the language."""

from __future__ import annotations

import json
from hashlib import sha256

import pytest
from checkout import ROOT

from nscc.pipeline import Options, run_passes
from nscc.source import Source
from nscc.words.file import to_bytes

DIGESTS: dict[str, str] = json.loads((ROOT / "tests/data/container_digests.json").read_text())
"""SHA-256 of each file's container at -O1, by the last commit before version 4 (fb2d3e8a)."""
CASES = "tests/cases/pass"
FEWER_WORDS = {
    "examples/class_b.nsl",
    "examples/class_b_4096.nsl",
    "examples/class_c.nsl",
    "examples/class_d.nsl",
    "examples/flutter.nsl",
    "examples/two_readouts.nsl",
    *(f"{CASES}/{name}.nsl" for name in ("bump_cut", "class_c", "class_d", "no_pixels")),
    *(f"{CASES}/{name}.nsl" for name in ("require_couples", "scrambled_bits")),
}
"""Programs for which the search finds fewer words on purpose: pixels that store times of events."""
CHANGED = {"examples/direction.nsl"}
"""Programs whose text has changed since."""
TOO_LARGE = {f"{CASES}/pictures_registers.nsl", f"{CASES}/undecided.nsl"}
"""Programs that are valid, but do not fit the chip."""


def test_every_program_of_versions_1_to_3_has_a_digest_or_a_reason() -> None:
    paths = [*(ROOT / "examples").glob("*.nsl"), *(ROOT / CASES).glob("*.nsl")]
    old = {path for path in paths if "nsl 4" not in path.read_text()}
    names = {path.relative_to(ROOT).as_posix() for path in old}
    assert names == DIGESTS.keys() | FEWER_WORDS | CHANGED | TOO_LARGE


@pytest.mark.parametrize("name", DIGESTS)
def test_a_program_builds_to_the_same_bytes(name: str) -> None:
    """Built at level 1 without a cache, the container has the recorded SHA-256."""
    path = ROOT / name
    source = Source(path.name, path.read_text())
    made = run_passes(source, path.parent, Options(level=1, cache=False))
    assert made.container is not None
    assert sha256(to_bytes(made.container)).hexdigest() == DIGESTS[name]
