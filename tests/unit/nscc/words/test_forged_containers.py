"""Containers whose machine somebody changed and signed anew: refused in words, not believed."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from hashlib import sha256
from pathlib import Path
from struct import Struct
from typing import Any

import numpy as np
import pytest
from nscc_command import RunNscc

from nscc.chips.load import builtin_target
from nscc.diagnostics.diagnostic import Rejected
from nscc.pipeline import Options, run_passes
from nscc.source import Source
from nscc.words.container import Container
from nscc.words.file import from_bytes, to_bytes
from nscc.words.soundness import faults

KEPT = """nsl 2
frame 5 slots of 1ms
sense full when exposure > 30% at n == 5
state short : bit = 0 kept
state was : bit = 0
next was = short
next short = full
open when n < 4 and (not short or n < 2)
read short, was
"""
TWO_SENSES = """nsl 2
frame 6 slots of 1ms
code late : 0..1
sense low when light < 20% at n in [2, 4]
sense high when light > 60% at n in [2, 3]
state held : 0..3 = 0
next held = looks when (high or low and late == 1) and held == 0
open when held == 0 and n < 5
read held
pixels late = x % 2
"""
PICTURED = """nsl 3
frame 4 slots of 1ms
open when true
outside 0
kernel line = [[1, 1, 1]] / 4
image i = line(exposure)
plane p = i > 6%
state h : bit = 0 kept
next h = h or p
read i, h
"""


def built(text: str) -> Container:
    """The container for a small array."""
    target = replace(builtin_target("scamp5"), rows=12, cols=16)
    options = Options(level=1, target=target, cache=False)
    container = run_passes(Source("test.nsl", text), Path(), options).container
    assert container is not None
    return container


_PREAMBLE = Struct("<8sIIQ")


@pytest.fixture(scope="module")
def kept() -> Container:
    """A program with a state that is kept and one that is not."""
    return built(KEPT)


def forged(container: Container, change: Callable[[dict[str, Any]], object]) -> bytes:
    """The container's file with another header, signed."""
    whole = to_bytes(container)
    magic, version, size, _ = _PREAMBLE.unpack_from(whole)
    start = _PREAMBLE.size
    header = json.loads(whole[start : start + size])
    change(header)
    text = json.dumps(header, sort_keys=True, separators=(",", ":")).encode("ascii")
    arrays = whole[start + size : -32]
    length = start + len(text) + len(arrays) + 32
    body = _PREAMBLE.pack(magic, version, len(text), length) + text + arrays
    return body + sha256(body).digest()


def _unhashable_bit(header: dict[str, Any]) -> None:
    header["machine"]["planes"][0][3][0][0] = []


def _true_as_a_bit(header: dict[str, Any]) -> None:
    header["machine"]["planes"][0][3][0][0] = True


def _other_value(header: dict[str, Any]) -> None:
    header["machine"]["planes"][0][2][0] = 77


def _one_value_twice(header: dict[str, Any]) -> None:
    header["machine"]["planes"][0][2][1] = header["machine"]["planes"][0][2][0]


def _not_loaded(header: dict[str, Any]) -> None:
    header["code_registers"] = []


@pytest.mark.parametrize(
    "change", [_unhashable_bit, _true_as_a_bit, _other_value, _one_value_twice, _not_loaded]
)
def test_forged_headers_are_refused(
    kept: Container, change: Callable[[dict[str, Any]], object], tmp_path: Path, run_nscc: RunNscc
) -> None:
    from_bytes(forged(kept, lambda _: None), "a.icw")  # as it is, it is sound
    data = forged(kept, change)
    with pytest.raises(Rejected) as raised:
        from_bytes(data, "a.icw")
    assert [each.code for each in raised.value.diagnostics] == ["NS0707"]
    (tmp_path / "a.icw").write_bytes(data)
    for line in ("prove a.icw", "run a.icw --scene builtin:dark -o f.npz", "view a.icw -o a.png"):
        outcome = run_nscc(line.split(), tmp_path)
        assert (outcome.status, outcome.codes) == (1, ["NS0707"]), line


def _word(value: Any) -> Callable[[dict[str, Any]], object]:
    """Replace a number in a word of images."""
    return lambda pictures: pictures["words"][0][0].__setitem__(0, value)


def _level(value: Any) -> Callable[[dict[str, Any]], object]:
    """Replace the level of IN at a launch of images."""
    return lambda pictures: pictures["launches"][0].__setitem__(1, value)


@pytest.mark.parametrize(
    ("change", "text"),
    [
        (_word(1 << 32), "`pictures.words[0][0][0]` is 4294967296, but 0 to 4294967295 is"),
        (_word(-1), "`pictures.words[0][0][0]` is -1, but 0 to 4294967295 is allowed"),
        (_word(1.0), "`pictures.words[0][0][0]` is 1.0, not an integer"),
        (_word(True), "`pictures.words[0][0][0]` is True, not an integer"),
        (_level(127), "names no kernel, or a level that IN cannot have"),
        (_level(-128), "names no kernel, or a level that IN cannot have"),
        (_level(1.0), "`pictures.launches[0].level` is 1.0, not an integer"),
        (lambda pictures: pictures.update(outside=2), "`pictures.outside` is 2, but 0 to 1"),
        (lambda pictures: pictures.update(limits_e={}), "one largest exposure for each bucket"),
        (lambda pictures: pictures.update(count_steps=-1), "`pictures.count_steps` is -1, but"),
        (lambda pictures: pictures.update(kernels=[]), "names a kernel that does not exist"),
        (lambda pictures: pictures["items"].reverse(), "reads a name that is not computed before"),
        (lambda pictures: pictures.update(reads=[]), "neither read out nor report anything"),
        (lambda pictures: pictures.update(reads=["z"]), "neither read out nor report anything"),
        (lambda pictures: pictures["registers"].pop("h"), "lack the register of a state"),
    ],
)
def test_forged_pictures_are_refused(change: Callable[[dict[str, Any]], object], text: str) -> None:
    pictured = built(PICTURED)
    assert faults(pictured) == []
    largest = _word((1 << 32) - 1)
    from_bytes(forged(pictured, lambda header: largest(header["pictures"])), "a.icw")
    with pytest.raises(Rejected) as raised:
        from_bytes(forged(pictured, lambda header: change(header["pictures"])), "a.icw")
    [error] = raised.value.diagnostics
    assert error.code == "NS0707"
    assert text in error.message + "".join(error.notes)


@pytest.mark.parametrize("time_us", [np.nan, np.inf, -2.0, 5e-324, 1e300])
def test_invalid_times_are_refused(kept: Container, time_us: float) -> None:
    """An open time of NaN, infinity, below 0, denormal or 1e300 us is the fault that is named."""
    assert faults(kept) == []
    open_us = kept.machine.open_us.copy()
    open_us[-1, 0] = time_us
    changed = replace(kept, machine=replace(kept.machine, open_us=open_us))
    assert faults(changed) == ["the open times of its machine are invalid"]


def test_every_behaviour_has_one_start() -> None:
    """Its start is overwritten by another node, so the first behaviour has none."""
    container = built(TWO_SENSES)
    machine = container.machine
    assert len(container.encoding) > 1
    behaviour = machine.behaviour.copy()
    first = machine.nodes(0)
    behaviour[first] = behaviour[first][::-1]
    behaviour[first.start] = behaviour[first.start + 1]
    changed = replace(container, machine=replace(machine, behaviour=behaviour))
    assert "a behaviour of its machine has no start" in faults(changed)


@pytest.mark.parametrize(("length_us", "sound"), [(1e-9, True), (9e-10, False), (1e-300, False)])
def test_slots_shorter_than_a_femtosecond_are_refused(length_us: float, sound: bool) -> None:
    """Slots of 1e-9 us are valid; shorter ones are a fault."""
    container = built("nsl 1\nframe 4 slots of 1ms\nopen when n < 2\n")
    changed = replace(container, slot_us=(length_us,) * container.slots)
    assert (faults(changed) == []) == sound
