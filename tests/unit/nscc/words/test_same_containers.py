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
"""SHA-256 of each file's container at -O1, stored by the last commit before version 4 (fb2d3e8a).

Left out are `class_b_4096`, which takes long, `direction`, whose text has changed, and programs for
which the search finds fewer words on purpose: `scrambled_bits`, and those whose pixels store times
of events, such as `class_b`."""


@pytest.mark.parametrize("name", DIGESTS)
def test_a_program_builds_to_the_same_bytes(name: str) -> None:
    path = ROOT / name
    source = Source(path.name, path.read_text())
    made = run_passes(source, path.parent, Options(level=1, cache=False))
    assert made.container is not None
    assert sha256(to_bytes(made.container)).hexdigest() == DIGESTS[name]
