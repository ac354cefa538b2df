"""Any sound container survives bytes and text; damaged ones are always refused in words."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from hashlib import sha256
from pathlib import Path
from typing import TypeVar

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from nscc.chips.load import builtin_target
from nscc.diagnostics.diagnostic import Rejected
from nscc.operations import OPERATIONS, READ_LINES, Op, op
from nscc.source import Source
from nscc.words.assembly import assemble
from nscc.words.container import Container, DecodeTable, Launch, Readout, StoredKernel
from nscc.words.disassembly import disassemble
from nscc.words.encoding import encode, matching
from nscc.words.file import from_bytes, to_bytes
from nscc.words.legality import decoded

Result = TypeVar("Result")
SCAMP5 = builtin_target("scamp5")
TARGETS = [
    replace(SCAMP5, rows=4, cols=6),
    replace(SCAMP5, rows=3, cols=3, name="tiny", or_sources=2, where_reads_flag=True),
    replace(builtin_target("scamp7"), rows=2, cols=5),
]


@st.composite
def operations(draw: st.DrawFn) -> Op:
    row = draw(st.sampled_from(OPERATIONS))
    names = st.lists(st.sampled_from(sorted(READ_LINES)), max_size=5)
    try:
        return op(row.name, draw(names), draw(names))
    except (ValueError, KeyError):
        return op("nop")


INTEGER = st.integers(0, 2**32 - 1)
WORDS = st.one_of(
    operations().map(encode),
    st.tuples(INTEGER, INTEGER, INTEGER, INTEGER, INTEGER),
)
PAIRS = st.sampled_from(["R1", "R5", "R12"]).flatmap(
    lambda d: st.sampled_from(["OR", "NOR", "REFRESH"]).flatmap(
        lambda kind: st.sets(st.sampled_from(["R2", "R3", "FLAG"]), max_size=3).map(
            lambda extra: [
                encode(op(f"{kind}.read", (), [d] if kind == "REFRESH" else [d, *extra])),
                encode(op(f"{kind}.write", [d])),
            ]
        )
    )
)
NAMES = st.one_of(
    st.sampled_from(["frame", "step", "a.b", "R1", "x", "1", "-", "né", 'q"uote', "a b", ";#"]),
    st.text(st.characters(categories=["L", "N", "P", "S"]), min_size=1, max_size=8),
)
TIMES = st.one_of(
    st.sampled_from([125.0, 0.1, 1e-7, 5e5, 1 / 3]),
    st.floats(1e-9, 1e14, allow_nan=False),
)


def result_or_codes(call: Callable[[], Result]) -> Result | set[str]:
    """What a call returns, or the codes of the diagnostics that it was rejected with."""
    try:
        return call()
    except Rejected as rejected:
        return {diagnostic.code for diagnostic in rejected.diagnostics}


def names(low: int, high: int) -> st.SearchStrategy[list[str]]:
    return st.lists(NAMES, min_size=low, max_size=high, unique=True)


@st.composite
def containers(draw: st.DrawFn) -> Container:
    target = draw(st.sampled_from(TARGETS))
    slots, kernel_names = draw(st.integers(1, 40)), draw(names(0, 4))
    buckets, fields = draw(names(1, 3)), draw(names(0, 2))
    rng = np.random.default_rng(draw(st.integers(0, 2**32)))
    codes, shutters = draw(st.integers(1, 5)), draw(st.integers(1, 4))
    lists = st.lists(st.one_of(WORDS.map(lambda w: [w]), PAIRS), max_size=6)
    kernels = tuple(
        StoredKernel(n, tuple(w for part in draw(lists) for w in part)) for n in kernel_names
    )
    launches = []
    if kernels:
        pairs = st.tuples(st.integers(0, slots), st.integers(0, len(kernels) - 1))
        drawn = draw(st.lists(pairs, max_size=60))
        launches = [Launch(i, k) for i, k in sorted(drawn, key=lambda pair: pair[0])]
    times = draw(st.lists(TIMES, min_size=1, max_size=3))
    lows = draw(st.sampled_from([0, -(2**63)]))
    density = draw(st.sampled_from([0.0, 0.1, 0.5, 1.0]))
    pixels = None
    if draw(st.booleans()):
        pixels = rng.integers(0, codes, (target.rows, target.cols), dtype=np.int32)
        if draw(st.booleans()):
            pixels = np.tile(pixels[:2, :2], (target.rows, target.cols))
            pixels = np.ascontiguousarray(pixels[: target.rows, : target.cols])
    return Container(
        target=target,
        slot_us=tuple(times[min(i, len(times) - 1)] for i in range(slots)),
        buckets=tuple(buckets),
        table=DecodeTable(
            tuple(fields),
            rng.integers(lows, 2**63 - 1, (codes, len(fields)), dtype=np.int64),
            rng.integers(0, shutters, codes, dtype=np.int32),
            rng.random((shutters, len(buckets), slots)) < density,
        ),
        kernels=kernels,
        launches=tuple(launches),
        code_registers=tuple(draw(st.permutations(target.digital_registers))[: rng.integers(0, 4)]),
        encoding=rng.random((shutters, len(target.digital_registers))) < 0.5,
        pixel_codes=pixels,
        readouts=tuple(
            Readout(draw(st.sampled_from("AB")), b, draw(st.floats(-1e9, 1e9))) for b in buckets
        ),
        source_lines=tuple(
            draw(st.lists(st.one_of(st.text(max_size=9), st.just(" a;b ")), max_size=3))
        ),
        notes=draw(st.dictionaries(st.text(max_size=6), st.text(max_size=9), max_size=2)),
    )


@settings(max_examples=60, deadline=None)
@given(containers())
def test_bytes_and_text_give_the_same_container(container: Container) -> None:
    data = to_bytes(container)
    assert to_bytes(from_bytes(data, "x.icw")) == data
    text = disassemble(from_bytes(data, "x.icw"))
    assert to_bytes(assemble(Source("x.asm", text), Path())) == data
    kernels = result_or_codes(lambda: decoded(container))
    if isinstance(kernels, set):
        assert kernels <= {"NS0701", "NS0703", "NS0708"}
    else:
        assert [tuple(map(encode, ops)) for ops in kernels] == [k.words for k in container.kernels]


@settings(max_examples=60, deadline=None)
@given(containers(), st.data())
def test_a_damaged_container_is_refused(container: Container, data: st.DataObject) -> None:
    good = to_bytes(container)
    at = data.draw(st.integers(0, len(good) - 1))
    bad = data.draw(
        st.sampled_from(
            [
                good[:at],
                good + b"\0",
                good[:at] + bytes([good[at] ^ 1 << data.draw(st.integers(0, 7))]) + good[at + 1 :],
                good[:at] + good[at + 1 :],
            ]
        )
    )
    with pytest.raises(Rejected) as caught:
        from_bytes(bad, "x.icw")
    assert caught.value.diagnostics[0].code in {"NS0702", "NS0704", "NS0705", "NS0706"}


@settings(max_examples=150, deadline=None)
@given(containers(), st.data())
def test_a_forged_container_is_refused_or_written_back_unchanged(
    container: Container, data: st.DataObject
) -> None:
    """The checksum of a forged container is valid, so only checks of the contents can refuse it."""
    body = bytearray(to_bytes(container)[:-32])
    header_end = 24 + int.from_bytes(body[12:16], "little")
    for _ in range(data.draw(st.integers(1, 3))):
        at = data.draw(st.integers(24, min(len(body), header_end + 200) - 1))
        body[at] = data.draw(st.sampled_from([*b'0123456789-[]{}",.eN', 0, 255, body[at] ^ 1]))
    forged = bytes(body) + sha256(body).digest()
    found = result_or_codes(lambda: from_bytes(forged, "x.icw"))
    # A set holds the codes of the errors: the file was refused.
    if isinstance(found, set):
        assert found == {"NS0707"}
    else:
        assert to_bytes(found) == forged


@settings(max_examples=60, deadline=None)
@given(st.binary(max_size=200), st.booleans())
def test_random_bytes_are_refused(data: bytes, magic: bool) -> None:
    with pytest.raises(Rejected):
        from_bytes((b"\x89ICW\r\n\x1a\n" if magic else b"") + data, "x.icw")


@settings(max_examples=100, deadline=None)
@given(st.tuples(INTEGER, INTEGER, INTEGER, INTEGER, INTEGER))
def test_random_words_are_no_operation(word: tuple[int, int, int, int, int]) -> None:
    """The table contains few of 2^160 words, so a random word must not be in it."""
    found = matching(word)
    assert found is None or encode(found) == word
