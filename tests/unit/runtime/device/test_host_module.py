"""`nscc run --on host:MODULE`: a fake of a vendor's module plays packets, and cuts them off."""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest
from checkout import ROOT
from nscc_command import invoke

EXAMPLES = ROOT / "examples"
PROGRAM = (
    "nsl 1\nframe 8 slots of 1ms\nbucket early open when n < 4\nbucket late open when n >= 4\n"
)
ROWS = COLS = 256
CODES = np.random.default_rng(4).integers(0, 256, (3, 2, ROWS, COLS)).astype(np.uint8)
"""Codes of three frames with two buckets."""


class FakeHost(ModuleType):
    """A module as its public users describe it; `packets` may contain exceptions to raise."""

    def __init__(self, packets: list[Any]) -> None:
        super().__init__("fake_host")
        self.packets: Iterator[Any] = iter(packets)
        self.opened: tuple[Any, ...] = ()
        self.closed = False

    def open_usb(self, name: str) -> None:
        self.opened = ("usb", name)

    def open_tcp(self, address: str, port: int) -> None:
        self.opened = ("tcp", address, port)

    def routine(self) -> None:
        pass

    def get_packet(self) -> Any:
        packet = next(self.packets, None)
        if isinstance(packet, Exception):
            raise packet
        return packet

    def close(self) -> None:
        self.closed = True


def packet(frame: int, picture: np.ndarray, kind: str = "SCAMP5_AOUT") -> dict[str, Any]:
    rows, cols = picture.shape
    return {
        "type": "data",
        "size": rows * cols,
        "datatype": kind,
        "loopcounter": frame,
        "channel": 0,
        "width": cols,
        "height": rows,
        "buffer": np.ascontiguousarray(picture[::-1]).tobytes(),
    }


def frames(numbers: range = range(3)) -> list[dict[str, Any]]:
    return [packet(10 + k, CODES[k, bucket]) for k in numbers for bucket in range(2)]


TEXT = {"type": "data", "datatype": "TEXT", "loopcounter": 11, "text": "2 launches came late"}


def run(
    folder: Path,
    monkeypatch: pytest.MonkeyPatch,
    packets: list[Any],
    *options: str,
    place: str = "host:fake_host",
    program: str = "p.nsl",
) -> tuple[Any, FakeHost]:
    (folder / "p.nsl").write_text(PROGRAM)
    host = FakeHost(packets)
    monkeypatch.setitem(sys.modules, "fake_host", host)
    line = ["run", program, "--on", place, "--patience", "0.1", "-o", "f.npz", *options]
    return invoke(line, folder), host


def test_the_first_whole_frame_is_taken_upright(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # The link was opened in the middle of frame 10.
    packets = [*frames()[1:3], TEXT, None, {"type": "status", "size": 4}, *frames()[3:]]
    done, host = run(tmp_path, monkeypatch, packets)
    assert done.status == 0, done.err
    with np.load(tmp_path / "f.npz") as file:
        np.testing.assert_array_equal(file["frame"], CODES[1])
        meta = json.loads(str(file["meta"]))
    assert meta["fidelity"] == "imported"
    assert meta["imported"]["host"] == "fake_host"
    assert (meta["imported"]["loopcounter"], meta["imported"]["flip"]) == (11, "rows")
    assert host.opened == ("usb", "0")
    assert host.closed


def test_pictures_of_bits_are_captured_through_a_relay(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    edge = (CODES[0, 0] > 200) * np.uint8(255)
    packets = [packet(k, edge, "SCAMP5_DOUT") for k in range(2)]
    program = str(EXAMPLES / "edges.nsl")
    for place, address in (
        ("host:fake_host@192.0.2.7", ("tcp", "192.0.2.7", 27888)),
        ("host:fake_host@chip.example:4000", ("tcp", "chip.example", 4000)),
    ):
        done, host = run(tmp_path, monkeypatch, packets, place=place, program=program)
        assert done.status == 0, done.err
        assert host.opened == address
        with np.load(tmp_path / "f.npz") as file:
            np.testing.assert_array_equal(file["plane_edge"], edge > 0)


@pytest.mark.parametrize(
    ("packets", "reason"),
    [
        ([], "received no whole frame for 0.1 s"),
        (frames()[:3], "received no whole frame for 0.1 s"),
        ([*frames()[:3], OSError("device unplugged")], "lost the chip, or cannot reach it: device"),
        ([packet(k, CODES[0, 0]) for k in range(9)], "3 frames that 'fake_host' received lack"),
        ([frames()[0], {**frames()[2], "buffer": b"cut"}], "256 x 256 pixels with 3 bytes"),
        ([frames()[0], {**frames()[2], "width": 128}], "256 x 128 pixels with 65536 bytes"),
    ],
)
def test_lost_and_cut_packets_are_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, packets: list[Any], reason: str
) -> None:
    done, host = run(tmp_path, monkeypatch, packets)
    assert done.status == 3, done.err
    assert "[NS0795]" in done.err
    assert reason in done.err
    assert host.closed
    assert not (tmp_path / "f.npz").exists()


def test_unusable_host_modules_options_and_packets_are_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    done, _ = run(tmp_path, monkeypatch, [], place="host:no_such_module")
    assert (done.status, "cannot be imported" in done.err) == (3, True)
    done, _ = run(tmp_path, monkeypatch, [], place="host:json")
    assert (done.status, "has no function open_usb" in done.err) == (3, True)
    done, _ = run(tmp_path, monkeypatch, [], place="host:fake_host@a:b")
    assert (done.status, "'b' is not a port" in done.err) == (3, True)
    for options in (["--effects", "all"], ["--repeat", "2"], ["--scene", "builtin:hdr"]):
        done, _ = run(tmp_path, monkeypatch, frames(), *options)
        assert (done.status, "[NS0770]" in done.err) == (2, True), done.err
    small = [packet(k, CODES[0, 0][:64, :64]) for k in range(2) for _ in range(2)]
    done, _ = run(tmp_path, monkeypatch, small)
    assert "[NS0794]" in done.err
    assert "64 x 64 pixels" in done.err
