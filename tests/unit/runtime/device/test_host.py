"""The host's end: time on the line, taking up again what was lost, and giving up."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from device_sessions import (
    TARGET,
    ChipAtOnce,
    chip_of,
    emulated,
    examples,
    new_host,
    python_loader,
    uploaded_and_captured,
)
from device_simulation import Simulation
from emulator_programs import container_of, target_of
from loader_twin.loader import Loader, packed_info
from loader_twin.parsing import Held

from nscc.operations import op
from nscc_runtime.device import tasks
from nscc_runtime.device.host import Contested, Implausible, RequestRefused, Silent, Stalled
from nscc_runtime.device.messages import Channel, Hello, Info, LoaderFault, UploadProgress
from nscc_runtime.device.objects import Upload, upload_of
from nscc_runtime.device.packets import MOST_DATA, REPLY, VERSION, Packet, PacketKind, Unpacker
from nscc_runtime.device.serving import LineFaults
from nscc_runtime.device.tasks import FrameRequest
from nscc_runtime.light import Light

LARGE = target_of((256, 256))
BITS_A_BYTE, BAUD = 10, 3e6


def large_upload() -> Upload:
    """1024 different words in 256 kernels, 13 planes of random codes: about 127 kB."""
    numbers = np.random.default_rng(0)
    planes = {name: numbers.random((256, 256)) < 0.5 for name in LARGE.digital_registers}
    destinations = [(["R1"], [f"R{a}", f"R{b}"]) for a in range(2, 13) for b in range(2, a)]
    words = [op("NOR", *destinations[n % len(destinations)]) for n in range(1024)]
    kernels = [words[n : n + 4] for n in range(0, 1024, 4)]
    container = container_of(LARGE, planes, kernels, [(n, n) for n in range(256)], 256)
    return upload_of(container, bytes(32))


class Sink:
    """A chip for which nothing is exposed."""

    def expose(self, held: Held, channels: int) -> None:
        raise AssertionError("no frame was asked for")

    def exposed(self) -> bytes | None:
        raise AssertionError("no frame was asked for")


@pytest.fixture(scope="module")
def large() -> Upload:
    return large_upload()


def line_of(faults: LineFaults | None = None) -> Simulation:
    """A large chip at 3 Mbit/s."""
    return Simulation(new_host(1), Loader(LARGE, Sink(), "test"), faults, baud=BAUD)


def upload(line: Simulation, program: Upload) -> None:
    line.run(line.host.lasting(lambda: tasks.upload(line.host, program)))


def test_a_large_program_takes_half_a_second_of_line(large: Upload) -> None:
    """The upload of about 127 kB takes at most 0.50 s of simulated time, and nothing is sent
    twice."""
    # 13 planes of 8192 bytes and 1024 words of 20 bytes are 126 976 bytes; more are heads.
    assert 126_976 <= len(large.stream) <= 132_000
    line = line_of(LineFaults(delay_s=0.001))
    upload(line, large)
    assert line.now <= 0.50
    assert line.up.busy_s <= line.up.bytes * BITS_A_BYTE / BAUD + 1e-9 <= 0.47
    assert line.host.resent == 0


def test_a_program_that_the_loader_already_has_is_not_sent_again(large: Upload) -> None:
    line = line_of()
    upload(line, large)
    sent = line.up.bytes
    upload(line, large)
    assert line.up.bytes - sent < 1000


@pytest.mark.parametrize("after", [5_000, 60_000, 125_000])
@pytest.mark.parametrize("outage_s", [0.05, 2.0])
def test_a_lost_link_is_resumed_where_it_broke(large: Upload, after: int, outage_s: float) -> None:
    """The link breaks after some bytes. The upload then takes the time of the unsent bytes, and
    only a window of bytes comes twice."""
    line = line_of(LineFaults(disconnect_after=after, outage_s=outage_s))
    upload(line, large)
    [(broke, _)] = line.events
    again_s = line.now - (broke + outage_s)
    unsent_s = (len(large.stream) - after) * BITS_A_BYTE / BAUD
    assert again_s <= 2.0 + 1.1 * unsent_s
    window = 16384
    assert line.up.bytes <= 1.05 * len(large.stream) + window + 4000, (
        "only what was lost comes twice"
    )


def test_an_upload_resumes_after_a_line_was_dead_for_three_seconds() -> None:
    """The port does not notice the pulled cable. Bytes vanish for a time, and then arrive again."""
    example = examples()[1]
    host, loader = new_host(1), python_loader(example)
    line = Simulation(host, loader, baud=1e5)
    original, dead = loader.receive, (0.05, 3.05)

    def receive(data: bytes, now_us: int) -> None:
        if not dead[0] <= line.now < dead[1]:
            original(data, now_us)

    loader.receive = receive  # type: ignore[method-assign]
    work = uploaded_and_captured(host, example.upload, 1)
    taken = line.run(host.lasting(work))
    assert isinstance(taken, tasks.FetchedFrame)
    assert taken.data == example.frame
    whole_s = (len(example.upload.stream) + len(example.frame)) * BITS_A_BYTE / 1e5
    assert dead[1] < line.now <= dead[1] + 2.0 + 1.5 * whole_s


def test_after_a_reboot_of_the_loader_the_host_sends_the_program_again() -> None:
    """The loader restarts after 1900 bytes. The host sends more than two whole programs and gets
    the expected frame."""
    example = examples()[0]
    host = new_host(1)
    line = Simulation(host, python_loader(example), LineFaults(reboot_after=1900))
    taken = line.run(host.lasting(uploaded_and_captured(host, example.upload, 1)))
    assert isinstance(taken, tasks.FetchedFrame)
    assert taken.data == example.frame
    assert [what for _, what in line.events] == ["reboot"]
    assert line.up.bytes > 2 * len(example.upload.stream)


class Stranger:
    """Something at the other end that is no loader; `says` makes answers of packets."""

    busy = False

    def __init__(self, says: Callable[[Packet], bytes], noise: bytes = b"") -> None:
        self.says, self.out, self.unpacker = says, noise, Unpacker()

    def receive(self, data: bytes, now_us: int) -> None:
        for packet in self.unpacker.feed(data):
            self.out += self.says(packet)

    def poll(self, now_us: int, room: int) -> bytes:
        out, self.out = self.out, b""
        return out

    def announce(self) -> None:
        raise AssertionError

    def watched(self) -> list[int]:
        return []


def test_silence_and_noise_are_given_up() -> None:
    """A port that says nothing, or prints text that is no packet, raises Silent after the patience
    of 2 s. The error keeps the text."""
    for noise in (b"", b"login: \0\0garbage\0" * 3):
        host = new_host(1, patience_s=2.0)
        line = Simulation(host, Stranger(lambda _: b"", noise))
        with pytest.raises(Silent) as caught:
            line.run(host.lasting(host.status), limit_s=10)
        assert not caught.value.ever
        assert bool(caught.value.noise) == bool(noise)
        # After the patience, and at most a few waits later.
        assert 2.0 <= line.now < 4.0


def test_a_loader_that_falls_silent_is_given_up() -> None:
    """The loader answers once and then nothing more. The error Silent says that it had answered
    (`ever`)."""
    example = examples()[0]
    host, loader = new_host(1, patience_s=2.0), python_loader(example)
    line = Simulation(host, loader)
    line.run(host.lasting(host.status))
    loader.poll = lambda now_us, room: b""  # type: ignore[method-assign]
    with pytest.raises(Silent) as caught:
        line.run(host.lasting(uploaded_and_captured(host, example.upload, 1)), limit_s=20)
    assert caught.value.ever


def test_a_loader_that_never_gets_on_is_given_up() -> None:
    """The loader answers every packet, but reports that it has received no byte."""
    example = examples()[0]
    host, loader = new_host(1, patience_s=0.05), python_loader(example)
    line = Simulation(host, loader)
    loader._data = lambda packet: UploadProgress(1, 0, 99, 0).pack()  # type: ignore[method-assign]
    with pytest.raises(Stalled):
        line.run(host.lasting(uploaded_and_captured(host, example.upload, 1)), limit_s=60)


def test_a_loader_that_restarts_repeatedly_is_given_up() -> None:
    example = examples()[0]
    host, loader = new_host(1), python_loader(example)
    line = Simulation(host, loader)
    begun = loader._begin

    def begin_and_die(packet: Packet) -> bytes:
        begun(packet)
        loader.announce()
        return b""

    loader._begin = begin_and_die  # type: ignore[method-assign]
    with pytest.raises(Stalled):
        line.run(host.lasting(uploaded_and_captured(host, example.upload, 1)), limit_s=120)


def test_a_frame_that_is_spoiled_inside_the_loader_is_not_accepted() -> None:
    example = examples()[0]
    host, loader = new_host(1), python_loader(example)
    line = Simulation(host, loader)
    watch = loader._watch_exposure

    def spoil() -> None:
        watch()
        if loader.frame is not None and loader.frame.data is not None:
            loader.frame.data = b"\xee" + loader.frame.data[1:]

    loader._watch_exposure = spoil  # type: ignore[method-assign]
    assert example.frame[:1] != b"\xee"
    with pytest.raises(RequestRefused) as caught:
        line.run(host.lasting(uploaded_and_captured(host, example.upload, 1)))
    assert caught.value.fault == LoaderFault.DIGEST


def test_the_host_stops_a_frame_that_the_loader_still_exposes_for_another_host() -> None:
    """A loader that still exposes for somebody else is made free."""
    first, second = examples()[:2]
    chip = chip_of(second)
    exposed = {"calls": 0}

    class Slow:
        def expose(self, held: Held, channels: int) -> None:
            exposed["calls"] += 1
            chip.expose(held, channels)

        def exposed(self) -> bytes | None:
            exposed["calls"] += 1
            return chip.exposed() if exposed["calls"] > 300 else None

    host = new_host(1)
    line = Simulation(host, Loader(TARGET, Slow(), "slow"))
    line.run(host.lasting(lambda: tasks.upload(host, first.upload)))
    host.send(PacketKind.CAPTURE, bytes([1] * 8 + [3, 0, 0, 0]))
    taken = line.run(host.lasting(uploaded_and_captured(host, second.upload, 2)))
    assert isinstance(taken, tasks.FetchedFrame)
    assert taken.data == second.frame


def test_a_refused_program_leaves_a_loader_that_takes_another() -> None:
    """A program for another target is refused with TARGET. The loader then takes a right one on the
    same line."""
    example = examples()[0]
    host = new_host(1)
    line = Simulation(host, python_loader(example))
    wrong = replace(example.upload, target=bytes(32))
    with pytest.raises(RequestRefused) as caught:
        line.run(host.lasting(lambda: tasks.upload(host, wrong)))
    assert caught.value.fault == LoaderFault.TARGET
    line.run(host.lasting(lambda: tasks.upload(host, example.upload)))


def test_the_masked_register_is_loaded_before_its_mask(large: Upload) -> None:
    """The order does not depend on the container: the chip writes R12 only where R0 is 1."""
    assert [each.register for each in large.objects[3:]] == [12, *range(12)]


def test_packets_grow_small_on_a_bad_line_and_large_on_a_good_one(large: Upload) -> None:
    def sizes(faults: LineFaults) -> list[int]:
        line = line_of(faults)
        seen: list[int] = []
        send = line.host.send

        def watched(kind: PacketKind, body: bytes = b"") -> int:
            if kind == PacketKind.DATA:
                seen.append(len(body) - 4)
            return send(kind, body)

        line.host.send = watched  # type: ignore[method-assign]
        upload(line, large)
        return seen

    assert min(sizes(LineFaults())[:-1]) == MOST_DATA
    spoiled = sizes(LineFaults(corrupt=2e-3, seed=5))
    assert np.median(spoiled) <= 256
    assert REPLY == 0x80


@pytest.mark.parametrize("delay_s", [0.3, 0.7, 1.5])
def test_a_slow_line_only_takes_longer(delay_s: float) -> None:
    """A reply takes longer than the host waits at first: it has to learn that."""
    example = examples()[1]
    host = new_host(1)
    line = Simulation(host, python_loader(example), LineFaults(delay_s=delay_s))
    taken = line.run(host.lasting(uploaded_and_captured(host, example.upload, 1)), limit_s=100)
    assert isinstance(taken, tasks.FetchedFrame)
    assert taken.data == example.frame
    # Hello, begin, declare, data, finish, capture (some), read; and what learning took.
    assert line.now <= 12 * 2 * delay_s + 2.0


@pytest.mark.parametrize("bytes_a_second", [960, 200])
def test_a_frame_arrives_over_a_line_slower_than_its_stated_speed(bytes_a_second: int) -> None:
    """The host learns the real speed from lost packets. It takes at most four times the time of the
    useful bytes, and 20 s."""
    small = target_of((48, 48))
    numbers = np.random.default_rng(1)
    planes = {name: numbers.random((48, 48)) < 0.5 for name in small.digital_registers[1:7]}
    kernels = [[op("NOR", ["R1"], ["R2", "R3"])] * 4 for _ in range(40)]
    container = container_of(small, planes, kernels, [(n, n) for n in range(40)], 40)
    container = replace(container, slot_us=(100.0,) * 40)
    light = Light.of_clip(numbers.random((40, 48, 48), np.float32) * 900)
    chip = ChipAtOnce(lambda _: light, small)
    upload, host = upload_of(container, bytes(32)), new_host(1)
    line = Simulation(host, Loader(small, chip, "slow"), baud=10 * bytes_a_second)
    taken = line.run(host.lasting(uploaded_and_captured(host, upload, 1, Channel.CODES)))
    assert isinstance(taken, tasks.FetchedFrame)
    assert taken.data == emulated(container, light)[: len(taken.data)]
    assert len(taken.data) == 48 * 48
    useful_s = (len(upload.stream) + len(taken.data)) / bytes_a_second
    assert line.now <= 4 * useful_s + 20


def test_a_second_host_on_the_line_is_reported() -> None:
    """The second host says hello each time that the loader receives bytes of the first one."""
    example = examples()[0]
    loader = python_loader(example)
    heard = loader.receive

    def disturbed(data: bytes, now_us: int) -> None:
        heard(data, now_us)
        if data:
            heard(Packet(PacketKind.HELLO, 1, 999, Hello(VERSION, VERSION).pack()).wire(), now_us)

    loader.receive = disturbed  # type: ignore[method-assign]
    host = new_host(1)
    with pytest.raises(Contested):
        Simulation(host, loader).run(host.lasting(uploaded_and_captured(host, example.upload, 1)))


def test_loader_and_host_compute_the_same_frame_size() -> None:
    example = examples()[0]
    upload = example.upload
    pixels = TARGET.rows * TARGET.cols
    wanted = FrameRequest(1, 3, upload)
    # A byte for the code and eight for the exposure of each pixel.
    assert wanted.bytes(upload.readouts) == 9 * pixels * upload.readouts
    assert wanted.bytes(upload.readouts + 1) == 0
    # Estimates of 2^32 - 1 ms are not waited for.
    assert wanted.longest_s < 2 * (sum(example.container.slot_us) * 1e-6 + 1) + 11
    held = FrameRequest(1, 1, None, pixels)
    assert held.bytes(2) == 2 * pixels
    # Twice the twenty minutes of `LONGEST_US`.
    assert held.longest_s < 3600
    loader, host = python_loader(example), new_host(1)
    announced = replace(upload, readouts=upload.readouts + 1)
    with pytest.raises(Implausible):
        Simulation(host, loader).run(host.lasting(uploaded_and_captured(host, announced, 1)))


def test_the_name_of_a_loader_cannot_control_a_terminal() -> None:
    said = hello_of(python_loader(examples()[0]))
    info = replace(said, firmware="\x1b[2J\x07ok", target_name="a\nb")
    found = Info.unpack(packed_info(info))
    assert (found.firmware, found.target_name) == ("\ufffd[2J\ufffdok", "a\ufffdb")


def hello_of(loader: Loader) -> Info:
    """What a loader says of itself."""
    loader.receive(Packet(PacketKind.HELLO, 1, 7, Hello(VERSION, VERSION).pack()).wire(), 1)
    *_, reply = Unpacker().feed(loader.poll(2, 4096))
    return Info.unpack(reply.body)
