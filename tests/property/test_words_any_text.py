"""Whatever the text, the assembler gives a container or explains: no other exception."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from nscc.diagnostics.diagnostic import Rejected
from nscc.macros import MNEMONICS
from nscc.source import Source
from nscc.words.assembly import assemble, assemble_words
from nscc.words.directives import DIRECTIVES
from nscc.words.file import from_bytes, to_bytes

PIECES = st.sampled_from(
    [
        *DIRECTIVES,
        *MNEMONICS,
        "R0",
        "R1",
        "R12",
        "A",
        "NEWS",
        "PIX",
        "FLAG",
        "scamp5",
        "frame",
        "125us",
        "x4",
        "0..3",
        "1,2",
        "0x10000",
        "never",
        "tile",
        "plane",
        "1",
        "0",
        "-1",
        "main",
        '"a b"',
        '"\\ud800"',
        '"',
        "\\",
        ",",
        ", ",
        " ",
        "\t",
        "\n",
        "\n",
        "\n.",
        "| ",
        "|= ",
        ";",
        "#",
        "\r",
        "99999999999999999999",
        "1e999",
        "nan",
        "é",
        "\x00",
        "\u2028",
        "\xa0",
    ]
)
TEXTS = st.one_of(
    st.text(max_size=80),
    st.lists(PIECES, max_size=40).map(" ".join),
    st.lists(PIECES, max_size=40).map("".join),
)
START = ".wait 1us x3\n.kernel main\nnop\n.slot 0..2 main\n.readout A frame\n"


@settings(max_examples=300, deadline=None)
@given(TEXTS, st.booleans())
def test_any_text_is_assembled_or_explained(text: str, sound_start: bool) -> None:
    source = Source("x.asm", (START if sound_start else "") + text)
    try:
        container = assemble(source, Path("/nowhere"))
    except Rejected as rejected:
        # Every message can be shown: its places lie in the text.
        for diagnostic in rejected.diagnostics:
            if diagnostic.label is not None and diagnostic.source is source:
                assert 0 <= diagnostic.label.span.start <= diagnostic.label.span.end
                assert diagnostic.label.span.start <= len(source.text)
    else:
        data = to_bytes(container)
        assert to_bytes(from_bytes(data, "x.icw")) == data


@pytest.mark.parametrize(
    "text",
    [
        "nop " * 2_500_000,
        '"' + "\\" * 5_000_000,
        ".note " + '"' * 1_000_000,
        "SET " + "R1," * 1_000_000,
        ".target\n" + "| [" + "[" * 900,
        ".target\n" + "| a" + ".a" * 400 + " = 1",
        ".wait " + "9" * 100_000 + "us",
        ".code " + "9" * 100_000,
        ".slot " + "0," * 100_000 + "0 main",
        "\n" * 1_000_000,
        "nop\n" * 300_000,
    ],
    ids=lambda text: text[:8],
)
def test_huge_assembly_text_is_refused(text: str) -> None:
    with pytest.raises(Rejected):
        assemble(Source("x.asm", text), Path("/nowhere"))


@settings(max_examples=100, deadline=None)
@given(st.lists(PIECES, max_size=12).map(" ".join))
def test_assembled_words_are_five_32_bit_integers(text: str) -> None:
    try:
        words = assemble_words(Source("-", text), Path("/nowhere"))
    except Rejected:
        return
    assert all(len(word) == 5 and min(word) >= 0 and max(word) < 2**32 for word in words)
