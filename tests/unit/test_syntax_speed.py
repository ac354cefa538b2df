"""No text of the permitted size takes long: nothing in the parser is worse than linear."""

from __future__ import annotations

from time import process_time

import pytest
from syntax_text import read

from nscc.diagnostics.render import render

_SIZE = 40_000
_SLOWEST_S = 2.0  # several times what any of them takes


@pytest.mark.parametrize(
    "piece",
    ["(", "[", "let ", "nsl 1 ", '"', '"\n', "#", "#\n", "# ", "\n", "a", "1", "1_", "1.", "- ",
     "not ", "fram\n", "let 1 ", "let a = 1;\n", "let a = 1\n", "code code : ", "bucket open ",
     "module x\n", "target a-b ", ";", "\u00e9", "\v", "pixels a = tile [[1,\n"],
)  # fmt: skip
def test_one_piece_over_and_over(piece: str) -> None:
    repeated = piece * (_SIZE // len(piece.encode()))
    for text in (repeated, f"nsl 1\nlet a = {repeated}"):
        began = process_time()
        _, errors = read(text)
        render(errors, "human")
        render(errors, "json")
        assert process_time() - began < _SLOWEST_S


@pytest.mark.parametrize("cells", ["1,", "1+x,"])
def test_a_large_tile(cells: str) -> None:
    row = "[" + cells * 64 + "1]"
    began = process_time()
    file, errors = read("nsl 1\npixels a = tile [" + ",\n".join([row] * (_SIZE // len(row))) + "]")
    assert process_time() - began < _SLOWEST_S
    assert not errors
    assert len(file.statements) == 2
