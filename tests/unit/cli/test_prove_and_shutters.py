"""`nscc prove` and `nscc shutters` at the command line, on built and on hand-written words."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from nscc_command import invoke

STOPS = """nsl 1
frame 4 slots of 1ms
code stop : 1..4
open when n < stop
pixels stop = tile [[4, 3], [2, 1]]
"""
HAND = """.wait 1ms x3
.readout A
.slot 0 start
.slot 1..3 {step}
.kernel start
    all
    respix B
    res A
.kernel step
    bus NEWS, A, PIX
    bus A, NEWS, B
    respix
.kernel half
    bus2 NEWS, C, PIX
    bus A, NEWS
"""


def opened(path: Path) -> np.ndarray:
    """S (buckets, rows, cols, N) of a file that `nscc shutters` wrote."""
    with np.load(path) as arrays:
        buckets, rows, cols, slots = arrays["shutter_shape"]
        bits = np.unpackbits(arrays["shutter"], axis=3, count=slots, bitorder="little")
    assert bits.shape == (buckets, rows, cols, slots)
    return bits.astype(bool)


@pytest.fixture
def stops(tmp_path: Path) -> Path:
    """A folder with a built program."""
    (tmp_path / "stops.nsl").write_text(STOPS)
    assert invoke(["build", "stops.nsl"], tmp_path).status == 0
    return tmp_path


def test_a_built_container_is_proved(stops: Path) -> None:
    done = invoke(["prove", "stops.icw"], stops)
    assert done.status == 0
    assert "proved: 4 codes x 4 slots x 1 bucket, 2 frames" in done.out


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ("    all\n", "    where PIX\n", "`where PIX` makes FLAG depend on the light"),
        ("    REFRESH R2\n", "", "R2 has decayed: no frame writes it again"),
        ("    bus A, B, NEWS\n", "    bus A, B\n", "shutter"),
    ],
)
def test_a_changed_container_is_not_proved(stops: Path, old: str, new: str, says: str) -> None:
    text = invoke(["disasm", "stops.icw"], stops).out
    assert old in text
    (stops / "other.asm").write_text(text.replace(old, new, 1))
    assert invoke(["asm", "other.asm", "-o", "other.icw"], stops).status == 0
    done = invoke(["prove", "other.icw"], stops)
    assert done.status == 1
    assert done.codes == ["NS0440"]
    assert says in done.err


def test_the_command_shutters_writes_the_shutters_of_a_program(stops: Path) -> None:
    for name in ("stops.nsl", "stops.icw"):
        assert invoke(["shutters", name, "-o", "s.npz"], stops).status == 0
        tile = np.array([[4, 3], [2, 1]])[..., None] > np.arange(4)
        np.testing.assert_array_equal(opened(stops / "s.npz")[0], np.tile(tile, (128, 128, 1)))


def test_hand_written_words_have_shutters_and_nothing_to_prove(tmp_path: Path) -> None:
    (tmp_path / "hand.asm").write_text(HAND.format(step="step"))
    assert invoke(["asm", "hand.asm", "-o", "hand.icw"], tmp_path).status == 0
    done = invoke(["prove", "hand.icw"], tmp_path)
    assert (done.status, done.codes) == (1, ["NS0443"])
    assert invoke(["shutters", "hand.icw", "-o", "s.npz"], tmp_path).status == 0
    assert opened(tmp_path / "s.npz").all()


def test_shutters_of_hand_written_words_follow_their_planes(tmp_path: Path) -> None:
    plane = np.random.default_rng(0).random((256, 256)) < 0.5
    np.save(tmp_path / "plane.npy", plane)
    text = HAND.format(step="step").replace(".kernel step\n", ".kernel step\n    WHERE R3\n")
    (tmp_path / "hand.asm").write_text(text + ".plane R3 plane.npy\n")
    assert invoke(["asm", "hand.asm", "-o", "hand.icw"], tmp_path).status == 0
    assert invoke(["shutters", "hand.icw", "-o", "s.npz"], tmp_path).status == 0
    np.testing.assert_array_equal(opened(tmp_path / "s.npz")[0], np.repeat(plane[..., None], 3, 2))


@pytest.mark.parametrize(
    ("old", "new"),
    [("{step}", "half"), ("    all\n", ""), ("    all\n", "    where PIX\n")],
)
def test_words_that_do_not_act_as_a_shutter_are_refused_by_the_command_shutters(
    tmp_path: Path, old: str, new: str
) -> None:
    """The words count the light half, or only where FLAG happens to be 1."""
    text = HAND.replace(old, new).format(step="step")
    (tmp_path / "hand.asm").write_text(text)
    assert invoke(["asm", "hand.asm", "-o", "hand.icw"], tmp_path).status == 0
    done = invoke(["shutters", "hand.icw", "-o", "s.npz"], tmp_path)
    assert (done.status, done.codes) == (1, ["NS0442"])
    assert not (tmp_path / "s.npz").exists()
