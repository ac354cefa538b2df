"""Messages about devices: every way to fail has one, with a way out and exit status 3."""

from __future__ import annotations

import errno
import os
from collections.abc import Callable, Iterator
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import pytest
import serial
from device_sessions import TARGET, examples, new_host, python_loader
from device_simulation import Simulation

from nscc.diagnostics.diagnostic import Rejected
from nscc_runtime.device.device_chip import DeviceChip, channels_of, frame_of
from nscc_runtime.device.device_errors import check_fits, explained, port_trouble
from nscc_runtime.device.host import RequestRefused, Silent, Stalled
from nscc_runtime.device.link import SerialLink
from nscc_runtime.device.messages import Capability, Info, LoaderFailure, LoaderFault
from nscc_runtime.device.packets import PacketKind
from nscc_runtime.device.port import Port, PortGone, PortTrouble, list_ports, open_port
from nscc_runtime.sensor import default_sensor

EXAMPLE = examples()[0]


@pytest.fixture
def info() -> Info:
    """What a loader for the small target says."""
    host = new_host(1)
    Simulation(host, python_loader(EXAMPLE)).run(host.lasting(host.status))
    assert host.info is not None
    return host.info


def code_of(raised: BaseException) -> str:
    """The code of a message, which has to end in exit status 3 and to say what to do."""
    assert isinstance(raised, Rejected)
    assert raised.status == 3
    [diagnostic] = raised.diagnostics
    assert diagnostic.helps
    return diagnostic.code


@pytest.mark.parametrize(
    ("number", "kind"),
    [
        (errno.ENOENT, "missing"),
        (errno.ENXIO, "missing"),
        (errno.EACCES, "forbidden"),
        (errno.EPERM, "forbidden"),
        (errno.EBUSY, "busy"),
        (errno.EAGAIN, "busy"),
        (errno.ENOTTY, "unsuited"),
        (errno.EIO, "other"),
    ],
)
def test_errors_of_opening_a_port_are_explained(
    number: int, kind: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(*_: Any, **__: Any) -> None:
        raise serial.SerialException(number, os.strerror(number))

    monkeypatch.setattr(serial, "Serial", refuse)
    with pytest.raises(PortTrouble) as caught:
        open_port("/dev/ttyACM0", 9600)
    assert caught.value.kind == kind
    code = code_of(port_trouble("/dev/ttyACM0", caught.value))
    assert code == ("NS0761" if kind == "busy" else "NS0760")


def test_a_speed_that_the_port_does_not_support_is_refused_with_a_hint_at_baud(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The serial library refuses 12 345 baud with a ValueError. The user gets NS0760 with a help
    that names `--baud`."""

    def refuse(*_: Any, **__: Any) -> None:
        raise ValueError("Failed to set custom baud rate (12345)")

    monkeypatch.setattr(serial, "Serial", refuse)
    with pytest.raises(Rejected) as caught:
        SerialLink("/dev/ttyACM0", baud=12345)
    assert code_of(caught.value) == "NS0760"
    assert "--baud" in caught.value.diagnostics[0].helps[0]


def test_a_port_that_is_unplugged_raises_port_gone() -> None:
    """While the other end is there, bytes pass both ways. After it is closed, reading and writing
    raise PortGone."""
    master, slave = os.openpty()
    port = open_port(os.ttyname(slave), 9600)
    os.write(master, b"there")
    assert port.read() == b"there"
    assert port.write(b"back") == 4
    assert os.read(master, 10) == b"back"
    os.close(slave)
    os.close(master)
    with pytest.raises(PortGone):
        port.read()
    with pytest.raises(PortGone):
        port.write(b"x")
    port.close()
    closed = Port(SimpleNamespace(fileno=lambda: -1, close=lambda: None))
    with pytest.raises(PortGone):
        closed.read()


def test_the_list_of_ports_is_sorted(monkeypatch: pytest.MonkeyPatch) -> None:
    """Ports come in the order of their names. A port without a description has an empty one."""
    found = [SimpleNamespace(device=name, description=None) for name in ("/dev/b", "/dev/a")]
    monkeypatch.setattr("serial.tools.list_ports.comports", lambda: found)
    assert list_ports() == [("/dev/a", ""), ("/dev/b", "")]


@pytest.mark.parametrize(
    ("error", "code"),
    [
        (Silent(False, 0), "NS0762"),
        (Silent(False, 9), "NS0762"),
        (Silent(True, 0), "NS0766"),
        (Stalled(), "NS0766"),
        (RequestRefused(LoaderFailure(PacketKind.HELLO, LoaderFault.VERSION, 7)), "NS0762"),
        (RequestRefused(LoaderFailure(PacketKind.BEGIN, LoaderFault.TARGET, 0)), "NS0764"),
        (RequestRefused(LoaderFailure(PacketKind.CAPTURE, LoaderFault.HARDWARE, 0)), "NS0768"),
        (RequestRefused(LoaderFailure(PacketKind.CAPTURE, LoaderFault.NO_PROGRAM, 0)), "NS0771"),
        (RequestRefused(LoaderFailure(PacketKind.DATA, LoaderFault.WORD, 12)), "NS0767"),
        (RequestRefused(LoaderFailure(200, 99, 12)), "NS0767"),
    ],
)
def test_errors_of_the_host_are_explained(error: Exception, code: str) -> None:
    """Each error of the link, from a silent loader to an unknown fault number, has its code of
    NS076x or NS0771."""
    with pytest.raises(Rejected) as caught, explained("/dev/ttyACM0", 10.0):
        raise error
    assert code_of(caught.value) == code


@pytest.mark.parametrize(
    ("change", "code"),
    [
        ({"most_words": 1}, "NS0765"),
        ({"most_kernels": 1}, "NS0765"),
        ({"most_rows": 0}, "NS0765"),
        ({"most_runs": 1}, "NS0765"),
        ({"most_frame": 60 * 9 - 1}, "NS0765"),
        ({"target": bytes(32)}, "NS0764"),
        ({"target": bytes(32), "target_name": "other"}, "NS0764"),
    ],
)
def test_programs_that_do_not_fit_are_refused_before_sending(
    change: dict[str, Any], code: str, info: Info
) -> None:
    check_fits("port", EXAMPLE.upload, TARGET, info, 3)
    with pytest.raises(Rejected) as caught:
        check_fits("port", EXAMPLE.upload, TARGET, replace(info, **change), 3)
    assert code_of(caught.value) == code
    if code == "NS0765":
        data = caught.value.diagnostics[0].data
        assert data["required"] > data["available"]


def test_gains_need_a_loader_that_has_them(info: Info) -> None:
    """A loader that is only EXACT takes the example without gains and refuses the scaled one with
    NS0765."""
    scaled = examples()[3].upload
    check_fits("port", scaled, TARGET, info, 3)
    without = replace(info, capabilities=Capability.EXACT)
    check_fits("port", EXAMPLE.upload, TARGET, without, 3)
    with pytest.raises(Rejected) as caught:
        check_fits("port", scaled, TARGET, without, 3)
    assert code_of(caught.value) == "NS0765"


def test_exposures_follow_from_codes_alone(info: Info) -> None:
    """A chip gives no exposures: they are what its codes mean."""
    assert channels_of(info) == 3
    channels = channels_of(replace(info, capabilities=0))
    assert channels == 1
    frame = frame_of(bytes([0, 1, 255]), channels, (1, 1, 3), default_sensor(TARGET), TARGET)
    assert frame.frame.tolist() == [[[0, 1, 255]]]
    assert frame.exposure_e.tolist() == [[[0.0, 30000 / 255, 30000.0]]]
    assert frame.valid.all()


class Wire:
    """A link on a virtual clock, for `Chip`."""

    path = "/dev/virtual"

    def __init__(self) -> None:
        self.host = new_host(1)
        self.line = Simulation(self.host, python_loader(EXAMPLE))

    def run(self, work: Callable[[], Any]) -> Any:
        return self.line.run(self.host.lasting(work))

    def steps(self, work: Callable[[], Any], reached: Callable[[], int]) -> Iterator[int]:
        self.run(work)
        yield from range(reached())


def test_a_chip_exposes_and_shows_its_upload() -> None:
    """The captured frame holds the recorded electrons column by column. Progress counts one step
    for each 1024 bytes of the upload."""
    seen: list[tuple[str, int | None, int]] = []

    def progress(items: Any, label: str, total: int | None) -> Iterator[Any]:
        found = list(items)
        seen.append((label, total, len(found)))
        yield from found

    wire: Any = Wire()
    chip = DeviceChip(wire, progress=progress)
    chip.upload(EXAMPLE.container)
    frame = chip.capture(EXAMPLE.container).frame
    codes = TARGET.rows * TARGET.cols
    columns = frame.exposure_e.transpose(0, 2, 1)
    assert columns.tobytes() == EXAMPLE.frame[codes:]
    assert frame.valid.all()
    steps = len(EXAMPLE.upload.stream) // 1024
    assert seen == [("uploading", steps, steps)]


def test_a_frame_of_another_program_is_refused() -> None:
    """The chip sends one readout where the program has two: NS0767."""
    wire: Any = Wire()
    chip = DeviceChip(wire)
    chip.upload(EXAMPLE.container)
    chip._made = EXAMPLE.container, replace(EXAMPLE.upload, readouts=2)
    with pytest.raises(Rejected) as caught, explained("/dev/x", 1.0):
        chip.capture(EXAMPLE.container)
    assert code_of(caught.value) == "NS0767"
