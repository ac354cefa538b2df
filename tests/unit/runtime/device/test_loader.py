"""What a loader takes and what it refuses: the firmware's core and its Python twin alike."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import count, pairwise
from struct import pack
from zlib import adler32, crc32

import pytest
from device_lockstep import Lockstep
from device_sessions import BOTH, TARGET, chip_of, examples, python_loader, sanitized

from nscc.operations import Op, op, pair
from nscc.words.encoding import encode
from nscc_runtime.device.firmware import RunningFirmware
from nscc_runtime.device.messages import (
    DATA,
    Begin,
    CaptureReply,
    CaptureRequest,
    Declare,
    Hello,
    Info,
    LoaderFailure,
    LoaderFault,
    LoaderState,
    ObjectEntry,
    ReadRequest,
    Status,
    UploadProgress,
)
from nscc_runtime.device.objects import (
    MOST_LAUNCHES,
    Object,
    ObjectKind,
    program_digest,
    target_digest,
    upload_of,
)
from nscc_runtime.device.packets import REPLY, Packet, PacketKind, Unpacker

pytestmark = pytest.mark.xdist_group("firmware")
EXAMPLE = examples()[0]
SESSION = 77
ZEROS = bytes(32)


class Talk:
    """Sends packets to a loader and gives back what it says, at once."""

    def __init__(self, loader: RunningFirmware) -> None:
        self.loader = loader
        self.unpacker = Unpacker()
        self.sequence = 0
        self.now_us = count(1000, 1000)

    def __call__(self, kind: int, body: bytes = b"", session: int = SESSION) -> list[Packet]:
        self.sequence += 1
        return self.raw(Packet(kind, self.sequence, session, body).wire())

    def raw(self, data: bytes) -> list[Packet]:
        """What comes back for bytes on the line."""
        self.loader.receive(data, next(self.now_us))
        out = b"".join(self.loader.poll(next(self.now_us), 4096) for _ in range(4))
        return self.unpacker.feed(out)

    def one(self, kind: PacketKind, body: bytes = b"", session: int = SESSION) -> bytes:
        """The body of the one reply, which has to be that of the request."""
        [reply] = self(kind, body, session)
        assert (reply.kind, reply.sequence, reply.session) == (kind | REPLY, self.sequence, session)
        return reply.body

    def failure(self, kind: int, body: bytes = b"", session: int = SESSION) -> tuple[int, int]:
        """Fault and detail of the one reply, which has to be an error."""
        [reply] = self(kind, body, session)
        assert reply.kind == PacketKind.ERROR, reply
        failure = LoaderFailure.unpack(reply.body)
        assert failure.request == kind
        return failure.fault, failure.detail

    def hello(self) -> Info:
        return Info.unpack(self.one(PacketKind.HELLO, Hello(2, 2).pack()))

    def send(self, objects: Sequence[Object], target: bytes | None = None) -> list[Packet]:
        """Announce, declare and send a program of these objects; the last reply."""
        found = target_digest(TARGET) if target is None else target
        entries = tuple(each.entry for each in objects)
        digest = program_digest(found, ZEROS, b"".join(entry.pack() for entry in entries))
        stream = b"".join(each.data for each in objects)
        replies = self(
            PacketKind.BEGIN, Begin(found, digest, ZEROS, len(stream), len(objects)).pack()
        )
        if replies[-1].kind == PacketKind.ERROR:
            return replies
        replies = self(PacketKind.DECLARE, Declare(0, entries).pack())
        for start in range(0, len(stream), 1000):
            if replies[-1].kind != PacketKind.ERROR:
                replies = self(PacketKind.DATA, DATA.pack(start) + stream[start : start + 1000])
        return replies if replies[-1].kind == PacketKind.ERROR else self(PacketKind.FINISH, digest)

    def refused(self, objects: Sequence[Object]) -> tuple[int, int]:
        """Why a program of these objects is refused."""
        reply = self.send(objects)[-1]
        assert reply.kind == PacketKind.ERROR, reply
        failure = LoaderFailure.unpack(reply.body)
        return failure.fault, failure.detail


@pytest.fixture(scope="module")
def core() -> Iterator[Lockstep]:
    """The firmware's core, one process for this file."""
    loader = Lockstep(sanitized(), chip_of(EXAMPLE))
    yield loader
    assert loader.close() == 0, "a sanitizer complained"


@pytest.fixture(params=["python", "firmware"])
def silent(request: pytest.FixtureRequest) -> Talk:
    """A loader that has just started."""
    if request.param == "python":
        return Talk(python_loader(EXAMPLE))
    loader: Lockstep = request.getfixturevalue("core")
    loader.chip = chip_of(EXAMPLE)
    loader.announce()
    return Talk(loader)


@pytest.fixture
def talk(silent: Talk) -> Talk:
    """A loader that has been said hello to."""
    silent.raw(b"")
    silent.hello()
    return silent


def test_the_loader_announces_its_start_and_its_description(silent: Talk) -> None:
    """The first packet is BOOTED in session 0. HELLO then gets version 2, an empty store, the size
    6 x 10 and the target."""
    [booted] = silent.raw(b"")
    assert (booted.kind, booted.session) == (PacketKind.BOOTED, 0)
    info = silent.hello()
    assert (info.version, info.state, info.rows, info.cols) == (2, LoaderState.EMPTY, 6, 10)
    assert info.target == target_digest(TARGET)
    assert (info.most_words, info.target_name) == (TARGET.store_words, "scamp5")
    assert info.program == info.label == ZEROS


def test_packets_without_a_session_are_refused(silent: Talk) -> None:
    """Before HELLO, and in a session of another number, each packet gets NO_SESSION. After it they
    are answered."""
    silent.raw(b"")
    for kind in (PacketKind.STATUS, PacketKind.BEGIN, PacketKind.CANCEL, 0x44):
        assert silent.failure(kind) == (LoaderFault.NO_SESSION, 0)
    silent.hello()
    assert silent.failure(PacketKind.STATUS, session=SESSION + 1) == (LoaderFault.NO_SESSION, 0)
    assert Status.unpack(silent.one(PacketKind.STATUS)).state == LoaderState.EMPTY


def test_another_version_is_refused_with_its_own(silent: Talk) -> None:
    """A HELLO for version 3, or whose highest version is 1, gets the fault VERSION with 2. A range
    up to 9 gets version 2."""
    silent.raw(b"")
    assert silent.failure(PacketKind.HELLO, Hello(3, 9).pack()) == (LoaderFault.VERSION, 2)
    assert silent.failure(PacketKind.HELLO, Hello(0, 1).pack()) == (LoaderFault.VERSION, 2)
    assert Info.unpack(silent.one(PacketKind.HELLO, Hello(0, 9).pack())).version == 2


def test_a_program_is_taken_and_a_frame_is_the_emulators(talk: Talk) -> None:
    [reply] = talk.send(EXAMPLE.upload.objects)
    assert reply.kind == PacketKind.FINISH | REPLY
    state = UploadProgress.unpack(reply.body)
    total = len(EXAMPLE.upload.stream)
    assert state == UploadProgress(LoaderState.READY, 0, len(EXAMPLE.upload.objects), total)
    asked = CaptureRequest(5, BOTH).pack()
    assert not CaptureReply.unpack(talk.one(PacketKind.CAPTURE, asked)).ready
    captured = CaptureReply.unpack(talk.one(PacketKind.CAPTURE, asked))
    assert captured.ready
    assert (captured.length, captured.readouts) == (len(EXAMPLE.frame), 1)
    assert captured.complete, "it is small enough to be kept at once"
    assert (captured.crc32, captured.adler32) == (crc32(EXAMPLE.frame), adler32(EXAMPLE.frame))
    pieces = talk(PacketKind.READ, ReadRequest(5, 0, captured.length, 0, 100).pack())
    assert b"".join(piece.body[12:] for piece in pieces) == EXAMPLE.frame
    # 540 bytes of a frame in packets of at most 100, after a head of 12.
    assert [len(piece.body) - 12 for piece in pieces] == [100] * 5 + [40]
    [piece] = talk(PacketKind.READ, ReadRequest(5, 7, 20, 0, 1024).pack())
    assert piece.body == pack("<QI", 5, 7) + EXAMPLE.frame[7:27]


def test_repeated_packets_change_nothing(talk: Talk) -> None:
    upload = EXAMPLE.upload
    stream, entries = upload.stream, tuple(each.entry for each in upload.objects)
    script = [
        (PacketKind.HELLO, Hello(2, 2).pack()),
        (PacketKind.BEGIN, upload.begin.pack()),
        (PacketKind.DECLARE, Declare(0, entries[:2]).pack()),
        (PacketKind.DECLARE, Declare(2, entries[2:]).pack()),
        *(
            (PacketKind.DATA, DATA.pack(at) + stream[at : at + 700])
            for at in range(0, len(stream), 700)
        ),
        (PacketKind.FINISH, upload.digest),
    ]
    for kind, body in script:
        first = talk.one(kind, body)
        assert talk.one(kind, body) == first
    begun = talk.one(PacketKind.CAPTURE, CaptureRequest(9, 1).pack())
    ready = talk.one(PacketKind.CAPTURE, CaptureRequest(9, 1).pack())
    assert talk.one(PacketKind.CAPTURE, CaptureRequest(9, 1).pack()) == ready
    started = [CaptureReply.unpack(body).started_us for body in (begun, ready)]
    assert started[0] == started[1], "it was exposed once"
    for kind, body in script[1:]:
        assert UploadProgress.unpack(talk.one(kind, body)).position == len(stream)
    assert talk.one(PacketKind.CAPTURE, CaptureRequest(9, 1).pack()) == ready


def test_the_loader_takes_only_the_bytes_that_follow_those_it_has(talk: Talk) -> None:
    upload = EXAMPLE.upload
    talk.one(PacketKind.BEGIN, upload.begin.pack())
    assert talk.failure(PacketKind.DATA, DATA.pack(0) + b"x") == (LoaderFault.WRONG_STATE, 0)
    talk.one(PacketKind.DECLARE, Declare(0, tuple(each.entry for each in upload.objects)).pack())

    def sent(at: int, size: int) -> int:
        body = DATA.pack(at) + upload.stream[at : at + size]
        return UploadProgress.unpack(talk.one(PacketKind.DATA, body)).position

    assert sent(10, 10) == 0
    assert sent(0, 10) == 10
    assert sent(0, 100) == 10
    assert sent(20, 10) == 10
    assert sent(10, 10) == 20
    assert UploadProgress.unpack(talk.one(PacketKind.BEGIN, upload.begin.pack())).position == 20
    assert talk.hello().program == upload.digest, "another hello does not lose it"


def test_an_object_whose_digest_does_not_fit_comes_again(talk: Talk) -> None:
    """A flipped bit counts as a failure and sets the position back to 0. The right bytes are then
    accepted."""
    upload = EXAMPLE.upload
    talk.one(PacketKind.BEGIN, upload.begin.pack())
    talk.one(PacketKind.DECLARE, Declare(0, tuple(each.entry for each in upload.objects)).pack())
    first = upload.objects[0].data
    wrong = bytes([first[0] ^ 1]) + first[1:]
    reply = UploadProgress.unpack(talk.one(PacketKind.DATA, DATA.pack(0) + wrong))
    assert (reply.state, reply.failures, reply.position) == (LoaderState.RECEIVING, 1, 0)
    reply = UploadProgress.unpack(talk.one(PacketKind.DATA, DATA.pack(0) + first))
    assert (reply.failures, reply.position) == (1, len(first))


def test_a_program_for_another_target_is_refused(talk: Talk) -> None:
    other = replace(TARGET, digital_word_us=0.3)
    [reply] = talk.send(EXAMPLE.upload.objects, target_digest(other))
    assert LoaderFailure.unpack(reply.body).fault == LoaderFault.TARGET


def test_a_program_whose_digest_is_another_is_refused(talk: Talk) -> None:
    upload = EXAMPLE.upload
    begin = replace(upload.begin, program=bytes(32))
    talk.one(PacketKind.BEGIN, begin.pack())
    declare = Declare(0, tuple(each.entry for each in upload.objects)).pack()
    assert talk.failure(PacketKind.DECLARE, declare) == (LoaderFault.DIGEST, 0)
    assert talk.failure(PacketKind.DATA, DATA.pack(0) + upload.stream[:10]) == (
        LoaderFault.DIGEST,
        0,
    )
    assert talk.failure(PacketKind.FINISH, upload.digest) == (LoaderFault.DIGEST, 0)
    assert talk.failure(PacketKind.CAPTURE, CaptureRequest(1, 1).pack()) == (LoaderFault.DIGEST, 0)
    state = UploadProgress.unpack(talk.one(PacketKind.CANCEL))
    assert state == UploadProgress(LoaderState.EMPTY, 0, 0, 0)
    assert talk.failure(PacketKind.CAPTURE, CaptureRequest(1, 1).pack()) == (
        LoaderFault.NO_PROGRAM,
        0,
    )
    assert talk.send(upload.objects)[-1].kind == PacketKind.FINISH | REPLY


def kernels(*ops_of: Sequence[Op] | Sequence[tuple[int, ...]]) -> Object:
    """A KERNELS object, laid out by hand, of operations or of raw words."""
    words = [
        [pack("<5I", *(encode(w) if isinstance(w, Op) else w)) for w in each] for each in ops_of
    ]
    head = pack(f"<{1 + len(words)}I", len(words), *(len(each) for each in words))
    return Object(ObjectKind.KERNELS, 0, head + b"".join(b"".join(each) for each in words))


def schedule(
    slots: int,
    runs: Sequence[tuple[int, float]],
    rows: Sequence[tuple[int, int, int]],
    grace_ns: int = 0,
) -> Object:
    """A SCHEDULE object, laid out by hand."""
    data = pack("<4I", slots, grace_ns, 0, len(runs)) + b"".join(pack("<Id", *run) for run in runs)
    data += pack("<I", len(rows)) + b"".join(pack("<IHH", *row) for row in rows)
    return Object(ObjectKind.SCHEDULE, 0, data)


def readouts(*found: tuple[int, float]) -> Object:
    """A READOUTS object, laid out by hand."""
    data = pack("<I", len(found)) + b"".join(pack("<B7xd", *each) for each in found)
    return Object(ObjectKind.READOUTS, 0, data)


GOOD_READOUT = readouts((0, 1.0))
GOOD_KERNELS = kernels([op("nop")], [op("rpix"), op("nop")])
GOOD_SCHEDULE = schedule(4, [(4, 2.5)], [(0, 1, 1), (1, 0, 4)])
PLANE = bytes([0xFF] * 7 + [0x0F])


def plane(register: int, data: bytes = PLANE) -> Object:
    """A PLANE object of 60 pixels."""
    return Object(ObjectKind.PLANE, register, data)


def reports(*rows: tuple[int, int]) -> Object:
    """A REPORTS object of registers and their most coordinates, without margins."""
    packed = (pack("<B3xI4H", register, most, 0, 0, 0, 0) for register, most in rows)
    return Object(ObjectKind.REPORTS, 0, pack("<I", len(rows)) + b"".join(packed))


def test_small_programs_by_hand_are_taken(talk: Talk) -> None:
    for objects in (
        [GOOD_READOUT, GOOD_KERNELS, GOOD_SCHEDULE],
        [GOOD_KERNELS, GOOD_SCHEDULE, GOOD_READOUT, plane(3), plane(0)],
        [GOOD_READOUT, kernels(), schedule(1, [(1, 1.0)], [])],
        [GOOD_READOUT, GOOD_KERNELS, GOOD_SCHEDULE, plane(12), plane(0)],
    ):
        assert talk.send(objects)[-1].kind == PacketKind.FINISH | REPLY


@pytest.mark.parametrize(
    "word",
    [
        (0, 0, 0, 0, 0),
        (0xFFFFFFFF,) * 5,
        tuple(part | 1 << 31 for part in encode(op("nop"))),
        encode(op("rpix"))[::-1],
        encode(op("MOV", ["R13"], ["R1"])),
        encode(op("WHERE", (), ["FLAG", "R1"])),
        encode(pair("OR", "R1", ["R1"])[0]),
        encode(pair("NOR", "R1", ["R1"])[1]),
    ],
    ids=[
        "zeros",
        "ones",
        "a bit too many",
        "parts swapped",
        "another chip's register",
        "WHERE of FLAG",
        "a first half alone",
        "a second half alone",
    ],
)
def test_words_that_the_target_does_not_take_are_refused(talk: Talk, word: tuple[int, ...]) -> None:
    objects = [GOOD_READOUT, kernels([op("nop")], [encode(op("nop")), word]), GOOD_SCHEDULE]
    fault, detail = talk.refused(objects)
    assert fault == LoaderFault.WORD
    assert detail in (2, 3)


def test_halves_of_different_pairs_are_refused(talk: Talk) -> None:
    """A pair of one OR half and one NOR half, or a pair across two kernels, gets the fault WORD
    with its place."""
    mixed = [pair("OR", "R1", ["R1"])[0], pair("NOR", "R1", ["R1"])[1]]
    assert talk.refused([GOOD_READOUT, kernels(mixed), GOOD_SCHEDULE]) == (LoaderFault.WORD, 2)
    across = pair("OR", "R1", ["R1"])
    found = talk.refused([GOOD_READOUT, kernels(across[:1], across[1:]), GOOD_SCHEDULE])
    assert found == (LoaderFault.WORD, 1)


@pytest.mark.parametrize(
    ("objects", "fault"),
    [
        ([GOOD_READOUT, GOOD_KERNELS], LoaderFault.NO_PROGRAM),
        ([GOOD_KERNELS, GOOD_SCHEDULE], LoaderFault.NO_PROGRAM),
        ([GOOD_READOUT, GOOD_SCHEDULE, GOOD_KERNELS], LoaderFault.SCHEDULE),
        ([GOOD_READOUT, GOOD_KERNELS, GOOD_SCHEDULE, kernels([])], LoaderFault.NO_PROGRAM),
        ([GOOD_READOUT, kernels([op("nop")] * 1025)], LoaderFault.TOO_LARGE),
        ([GOOD_READOUT, kernels(*[[]] * 1025)], LoaderFault.TOO_LARGE),
        ([readouts((7, 1.0))], LoaderFault.READOUT),
        ([readouts((0, float("nan")))], LoaderFault.READOUT),
        ([readouts((0, float("inf")))], LoaderFault.READOUT),
        ([Object(ObjectKind.READOUTS, 0, b"")], LoaderFault.READOUT),
        ([Object(ObjectKind.READOUTS, 0, b"\1\0")], LoaderFault.READOUT),
        ([Object(ObjectKind.READOUTS, 0, GOOD_READOUT.data + b"x")], LoaderFault.READOUT),
        ([Object(ObjectKind.KERNELS, 0, pack("<I", 0xFFFFFFFF))], LoaderFault.TOO_LARGE),
        ([Object(ObjectKind.KERNELS, 0, pack("<3I", 2, 0xFFFFFFFF, 2))], LoaderFault.TOO_LARGE),
        ([Object(ObjectKind.KERNELS, 0, GOOD_KERNELS.data[:-1])], LoaderFault.MALFORMED),
        ([Object(ObjectKind.KERNELS, 0, GOOD_KERNELS.data + b"\0")], LoaderFault.MALFORMED),
        ([GOOD_KERNELS, schedule(0, [], [])], LoaderFault.SCHEDULE),
        ([GOOD_KERNELS, schedule(1 << 21, [(1 << 21, 1.0)], [])], LoaderFault.SCHEDULE),
        ([GOOD_KERNELS, schedule(4, [(3, 1.0)], [])], LoaderFault.SCHEDULE),
        ([GOOD_KERNELS, schedule(4, [(4, 1.0), (0, 1.0)], [])], LoaderFault.SCHEDULE),
        ([GOOD_KERNELS, schedule(4, [(4, 0.0)], [])], LoaderFault.SCHEDULE),
        ([GOOD_KERNELS, schedule(4, [(4, float("nan"))], [])], LoaderFault.SCHEDULE),
        ([GOOD_KERNELS, schedule(4, [(4, 1e16)], [])], LoaderFault.SCHEDULE),
        ([GOOD_KERNELS, schedule(4, [(4, 1.0)], [(5, 0, 1)])], LoaderFault.SCHEDULE),
        ([GOOD_KERNELS, schedule(4, [(4, 1.0)], [(1, 0, 5)])], LoaderFault.SCHEDULE),
        ([GOOD_KERNELS, schedule(4, [(4, 1.0)], [(0, 2, 1)])], LoaderFault.SCHEDULE),
        ([GOOD_KERNELS, schedule(4, [(4, 1.0)], [(0, 0, 0)])], LoaderFault.SCHEDULE),
        (
            [GOOD_KERNELS, schedule(4, [(4, 1.0)], [(0, 0, 65535)] * (MOST_LAUNCHES // 65535 + 1))],
            LoaderFault.SCHEDULE,
        ),
        ([GOOD_KERNELS, schedule(4, [(4, 1.0)], [(0x80000000, 0, 2)])], LoaderFault.SCHEDULE),
        ([plane(13)], LoaderFault.PLANE),
        ([plane(1), plane(1)], LoaderFault.PLANE),
        ([plane(1, PLANE[:-1])], LoaderFault.PLANE),
        ([plane(1, PLANE[:-1] + b"\x1f")], LoaderFault.PLANE),
        ([plane(1, PLANE + b"\0")], LoaderFault.TOO_LARGE),
        ([plane(0), plane(12)], LoaderFault.PLANE),
        ([Object(ObjectKind.REPORTS, 0, b"")], LoaderFault.READOUT),
        ([reports((13, 0))], LoaderFault.READOUT),
        ([reports((5, 61))], LoaderFault.READOUT),
        ([reports((5, 1), (5, 1))], LoaderFault.READOUT),
        ([Object(ObjectKind.STATES, 0, pack("<IB", 1, 5)), reports((5, 1))], LoaderFault.READOUT),
        ([Object(ObjectKind.REPORTS, 0, reports((5, 1)).data + b"x")], LoaderFault.READOUT),
        ([Object(ObjectKind.REPORTS, 0, pack("<I", 14))], LoaderFault.READOUT),
        ([reports(*[(5, 1)] * 14)], LoaderFault.TOO_LARGE),
        ([Object(9, 0, b"abc")], LoaderFault.MALFORMED),  # type: ignore[arg-type]
    ],
)
def test_objects_that_make_no_sense_are_refused(
    talk: Talk, objects: list[Object], fault: LoaderFault
) -> None:
    assert talk.refused(objects)[0] == fault
    assert talk.one(PacketKind.CANCEL)
    assert talk.send(EXAMPLE.upload.objects)[-1].kind == PacketKind.FINISH | REPLY


LEVELS = Object(ObjectKind.LEVELS, 0, pack("<I3h", 3, 5, 5, 5))
"""Levels for the rows of WITH_LOOP, whose last one follows the exposure."""
WITH_LOOP = schedule(4, [(4, 2.5)], [(0, 1, 1), (4, 0, 1), (0, 0, 3)])


def params(
    ranges: Sequence[tuple[int, int, int]], *changes: tuple[int, int, int, int, int]
) -> Object:
    """A PARAMS object, laid out by hand: (low, high, start); (row, parameter, change, factor,
    offset)."""
    data = pack("<I", len(ranges)) + b"".join(pack("<3i", *each) for each in ranges)
    data += pack("<I", len(changes)) + b"".join(pack("<IBBhi", *each) for each in changes)
    return Object(ObjectKind.PARAMS, 0, data)


GOOD_PARAMS = params([(-2, 9, 3)], (1, 0, 0, 2, 0), (2, 0, 1, -1, 4), (2, 0, 2, 0, 0))


@pytest.mark.parametrize(
    ("params_object", "fault"),
    [
        (params([(4, 9, 3)]), LoaderFault.PARAM),
        (params([(0, 9, 10)]), LoaderFault.PARAM),
        (params([(0, 9, 3)], (3, 0, 1, 1, 0)), LoaderFault.SCHEDULE),
        (params([(0, 9, 3)], (2, 1, 1, 1, 0)), LoaderFault.SCHEDULE),
        (params([(0, 9, 3)], (2, 0, 3, 1, 0)), LoaderFault.SCHEDULE),
        (params([(0, 9, 3)], (1, 0, 1, 1, 0)), LoaderFault.SCHEDULE),
        (params([(0, 9, 3)], (1, 0, 2, 0, 0)), LoaderFault.SCHEDULE),
        (params([(0, 9, 3)], (2, 0, 1, 1, 0), (1, 0, 0, 1, 0)), LoaderFault.SCHEDULE),
        (params([(0, 9, 3)], (1, 0, 0, 200, 0)), LoaderFault.SCHEDULE),
        (params([(-9, 0, 0)], (1, 0, 0, 200, 0)), LoaderFault.SCHEDULE),
        (params([(0, 9, 3)] * 17), LoaderFault.TOO_LARGE),
        (params([(0, 9, 3)], *[(2, 0, 1, 1, 0)] * 65), LoaderFault.TOO_LARGE),
        (Object(ObjectKind.PARAMS, 0, GOOD_PARAMS.data[:-1]), LoaderFault.SCHEDULE),
        (Object(ObjectKind.PARAMS, 0, GOOD_PARAMS.data + b"x"), LoaderFault.SCHEDULE),
        (Object(ObjectKind.PARAMS, 0, b""), LoaderFault.SCHEDULE),
    ],
)
def test_params_that_make_no_sense_are_refused(
    talk: Talk, params_object: Object, fault: LoaderFault
) -> None:
    before = [GOOD_READOUT, GOOD_KERNELS, LEVELS, WITH_LOOP]
    assert talk.refused([*before, params_object])[0] == fault
    assert talk.send([*before, GOOD_PARAMS])[-1].kind == PacketKind.FINISH | REPLY


def test_params_need_a_schedule_and_levels_that_they_change(talk: Talk) -> None:
    """Parameters before the schedule get the fault SCHEDULE. Parameters that change a level, in a
    program without levels, get a fault of detail 10."""
    fault, _ = talk.refused([GOOD_READOUT, GOOD_KERNELS, GOOD_PARAMS, WITH_LOOP])
    assert fault == LoaderFault.SCHEDULE
    assert talk.refused([GOOD_READOUT, GOOD_KERNELS, WITH_LOOP, GOOD_PARAMS])[1] == 10


def test_a_frame_takes_a_value_for_each_parameter(talk: Talk) -> None:
    talk.send([GOOD_READOUT, GOOD_KERNELS, LEVELS, WITH_LOOP, GOOD_PARAMS])
    capture = CaptureRequest(1, 1).pack()
    for values, failure in (
        ((), (LoaderFault.MALFORMED, 1)),
        ((1, 1), (LoaderFault.MALFORMED, 1)),
        ((10,), (LoaderFault.PARAM, 0)),
        ((-3,), (LoaderFault.PARAM, 0)),
    ):
        body = capture + pack(f"<{len(values)}i", *values)
        assert talk.failure(PacketKind.CAPTURE_WITH, body) == failure
    talk.one(PacketKind.CAPTURE_WITH, capture + pack("<i", -2))


def test_a_plane_is_loaded_where_the_program_has_one(talk: Talk) -> None:
    def load(register: int, position: int, data: bytes) -> bytes:
        return pack("<B3xI", register, position) + data

    assert talk.failure(PacketKind.LOAD, load(0, 0, PLANE))[0] == LoaderFault.NO_PROGRAM
    talk.send([GOOD_READOUT, GOOD_KERNELS, GOOD_SCHEDULE, plane(12), plane(3), plane(0)])
    for register, position, data, answer in (
        (3, 0, PLANE[:4], 4),
        (3, 6, PLANE[6:], 4),  # bytes between them were lost
        (3, 4, PLANE[4:], 8),
        (3, 4, PLANE[4:], 8),  # and the answer was lost
        (0, 4, PLANE[4:], 0),
        (0, 0, PLANE, 8),
    ):
        assert DATA.unpack(talk.one(PacketKind.LOAD, load(register, position, data))) == (answer,)
    for register, data, failure in (
        (5, PLANE, (LoaderFault.PLANE, 5)),
        (13, PLANE, (LoaderFault.PLANE, 13)),
        (12, PLANE, (LoaderFault.PLANE, 12)),  # its mask has a plane, which it would need
        (3, PLANE + b"x", (LoaderFault.PLANE, 3)),
        (3, PLANE[:-1] + b"\x1f", (LoaderFault.PLANE, 3)),
        (3, b"", (LoaderFault.MALFORMED, 0)),
    ):
        assert talk.failure(PacketKind.LOAD, load(register, 0, data)) == failure


def test_declared_lengths_beyond_the_memory_are_refused(talk: Talk) -> None:
    """An object of 4 GiB of each kind gets TOO_LARGE with its length. So does a program of 65
    objects."""
    found = target_digest(TARGET)
    for kind in ObjectKind:
        entry = ObjectEntry(kind, 0, 0xFFFFFFFF, ZEROS)
        digest = program_digest(found, ZEROS, entry.pack())
        talk.one(PacketKind.BEGIN, Begin(found, digest, ZEROS, 0xFFFFFFFF, 1).pack())
        failure = talk.failure(PacketKind.DECLARE, Declare(0, (entry,)).pack())
        assert failure == (LoaderFault.TOO_LARGE, 0xFFFFFFFF)
    # A loader has room for 64 objects.
    assert (
        talk.failure(PacketKind.BEGIN, Begin(found, ZEROS, ZEROS, 0, 65).pack())[0]
        == LoaderFault.TOO_LARGE
    )


@pytest.mark.parametrize(
    ("kind", "body"),
    [
        (PacketKind.HELLO, b""),
        (PacketKind.HELLO, bytes(5)),
        (PacketKind.STATUS, b"x"),
        (PacketKind.BEGIN, bytes(103)),
        (PacketKind.DECLARE, b"\0"),
        (PacketKind.DECLARE, pack("<HH", 0, 1) + bytes(37)),
        (PacketKind.FINISH, bytes(31)),
        (PacketKind.CAPTURE, bytes(11)),
        (PacketKind.CAPTURE_WITH, bytes(11)),
        (PacketKind.LOAD, bytes(8)),
        (PacketKind.READ, bytes(23)),
        (PacketKind.CANCEL, b"x"),
    ],
)
def test_bodies_of_another_length_are_refused(talk: Talk, kind: PacketKind, body: bytes) -> None:
    assert talk.failure(kind, body)[0] == LoaderFault.MALFORMED


def test_reads_outside_the_frame_are_refused(talk: Talk) -> None:
    talk.send(EXAMPLE.upload.objects)
    assert (
        talk.failure(PacketKind.READ, ReadRequest(5, 0, 10, 0, 64).pack())[0]
        == LoaderFault.NO_FRAME
    )
    talk.one(PacketKind.CAPTURE, CaptureRequest(5, 1).pack())
    pixels = TARGET.rows * TARGET.cols
    for read in (
        ReadRequest(5, 0, pixels + 1, 0, 64),
        ReadRequest(5, pixels, 1, 0, 64),
        ReadRequest(5, 0xFFFFFFFF, 2, 0, 64),
        ReadRequest(5, 0, 0xFFFFFFFF, 0, 64),
        ReadRequest(5, 0, 0, 0, 64),
        ReadRequest(5, 0, 10, 0, 0),
        ReadRequest(5, 0, 10, 0, 1025),
    ):
        assert talk.failure(PacketKind.READ, read.pack())[0] == LoaderFault.MALFORMED
    assert (
        talk.failure(PacketKind.READ, ReadRequest(6, 0, 10, 0, 64).pack())[0]
        == LoaderFault.NO_FRAME
    )
    assert talk.failure(PacketKind.CAPTURE, CaptureRequest(6, 4).pack())[0] == LoaderFault.MALFORMED
    assert talk.failure(PacketKind.CAPTURE, CaptureRequest(6, 0).pack())[0] == LoaderFault.MALFORMED


def test_no_more_reads_wait_than_there_is_room_for(talk: Talk) -> None:
    """Of nine reads at once, eight are answered in order with two packets each. The ninth gets
    BUSY."""
    talk.send(EXAMPLE.upload.objects)
    for _ in range(2):
        talk.one(PacketKind.CAPTURE, CaptureRequest(5, BOTH).pack())
    asked = b"".join(
        Packet(PacketKind.READ, n, SESSION, ReadRequest(5, 0, 32, 0, 16).pack()).wire()
        for n in range(9)
    )
    replies = talk.raw(asked)
    failures = [LoaderFailure.unpack(p.body) for p in replies if p.kind == PacketKind.ERROR]
    assert failures == [LoaderFailure(PacketKind.READ, LoaderFault.BUSY, 0)]
    assert [p.sequence for p in replies if p.kind != PacketKind.ERROR] == [
        n for n in range(8) for _ in "12"
    ]


def test_a_chip_that_fails_is_said_to_have_failed(talk: Talk) -> None:
    talk.send(EXAMPLE.upload.objects)

    def broken(_: object) -> None:
        raise RuntimeError("no light")

    talk.loader.board = talk.loader.chip = None  # type: ignore[attr-defined]
    chip = chip_of(EXAMPLE)
    chip.scene = broken  # type: ignore[assignment]
    talk.loader.board = talk.loader.chip = chip  # type: ignore[attr-defined]
    talk(PacketKind.CAPTURE, CaptureRequest(5, 1).pack())
    assert talk.failure(PacketKind.CAPTURE, CaptureRequest(5, 1).pack()) == (
        LoaderFault.HARDWARE,
        0,
    )
    talk.loader.board = talk.loader.chip = chip_of(EXAMPLE)  # type: ignore[attr-defined]
    talk.one(PacketKind.CAPTURE, CaptureRequest(6, 1).pack())
    assert CaptureReply.unpack(talk.one(PacketKind.CAPTURE, CaptureRequest(6, 1).pack())).ready


def test_a_restart_of_the_loader_ends_the_session_and_forgets_the_program(talk: Talk) -> None:
    """After a restart the old session gets NO_SESSION. A new HELLO shows another boot number and an
    empty store."""
    talk.send(EXAMPLE.upload.objects)
    before = talk.hello()
    assert (before.state, before.label) == (LoaderState.READY, ZEROS)
    talk.loader.announce()
    assert [packet.kind for packet in talk.raw(b"")] == [PacketKind.BOOTED]
    assert talk.failure(PacketKind.STATUS) == (LoaderFault.NO_SESSION, 0)
    after = Info.unpack(talk.one(PacketKind.HELLO, Hello(2, 2).pack(), 123456))
    assert after.boot != before.boot
    assert (after.state, after.program) == (LoaderState.EMPTY, ZEROS)


def test_the_objects_of_a_container_are_those_of_the_protocol() -> None:
    container = examples()[1].container
    made = upload_of(container, ZEROS)
    kinds = [each.kind for each in made.objects]
    planes = list(container.planes().items())
    assert kinds == [ObjectKind.READOUTS, ObjectKind.KERNELS, ObjectKind.SCHEDULE] + [
        ObjectKind.PLANE
    ] * len(planes)
    assert made.objects[0] == readouts((0, 1.0))
    assert made.objects[1] == kernels(*(list(kernel.words) for kernel in container.kernels))
    runs = [(3, 100.0), (3, 200.0), (2, 300.0)]
    assert [container.slot_us.count(us) for _, us in runs] == [n for n, _ in runs]
    rows = [(1 if launch.instant else 0, launch.kernel, 1) for launch in container.launches]
    assert all(one != other for one, other in pairwise(rows)), "no two rows are one"
    assert made.objects[2] == schedule(8, runs, rows, grace_ns=2000)
    for sent, (register, plane_bits) in zip(made.objects[3:], planes, strict=True):
        assert TARGET.digital_registers[sent.register] == register
        bits = [sent.data[i // 8] >> i % 8 & 1 for i in range(plane_bits.size)]
        assert bits == plane_bits.reshape(-1).tolist()
