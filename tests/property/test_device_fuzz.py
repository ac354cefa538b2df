"""Any bytes at all, at both ends: nothing breaks, and the twins agree on every answer."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from device_lockstep import Lockstep
from device_sessions import (
    BOTH,
    TARGET,
    chip_of,
    examples,
    new_host,
    sanitized,
    uploaded_and_captured,
)
from hypothesis import given
from hypothesis import strategies as st
from loader_twin.loader import Loader, packed_info

from nscc.operations import OPERATIONS
from nscc.words.encoding import encode, matching
from nscc.words.legality import picture_fault
from nscc_runtime.device.host import (
    Contested,
    Host,
    Implausible,
    RequestRefused,
    SessionLost,
    Silent,
    Stalled,
)
from nscc_runtime.device.messages import (
    DATA,
    Begin,
    Capability,
    CaptureReply,
    CaptureRequest,
    Declare,
    Hello,
    Info,
    LoaderFailure,
    LoaderFault,
    LoaderState,
    ReadRequest,
    UploadProgress,
)
from nscc_runtime.device.objects import Object, ObjectKind, program_digest, target_digest
from nscc_runtime.device.packets import REPLY, Packet, PacketKind, Unpacker

pytestmark = pytest.mark.xdist_group("firmware")
EXAMPLE = examples()[0]
HOST_NAME = "nscc-loader 2 (host)"
ZEROS = bytes(32)


@pytest.fixture(scope="module")
def core() -> Iterator[Lockstep]:
    """The firmware's core with sanitizers: one process for all examples of this file."""
    loader = Lockstep(sanitized(), chip_of(EXAMPLE))
    yield loader
    assert loader.close() == 0, "a sanitizer complained"


def said(loader: Loader | Lockstep, pieces: list[bytes]) -> list[bytes]:
    """What a loader that has just started says to each of some pieces of bytes."""
    loader.announce()
    out, now = [], 1000
    for piece in pieces:
        loader.receive(piece, now)
        out.append(b"".join(loader.poll(now + k, 4096) for k in range(3)))
        now += 1000
    return out


def twin() -> Loader:
    return Loader(TARGET, chip_of(EXAMPLE), HOST_NAME)


numbers32 = st.one_of(
    st.integers(0, 70), st.sampled_from([1 << 31, (1 << 32) - 1]), st.integers(0, (1 << 32) - 1)
)
entries = st.lists(
    st.one_of(
        st.sampled_from([each.entry for each in EXAMPLE.upload.objects]),
        st.builds(
            lambda kind, reg, data: Object(kind, reg, data).entry,  # type: ignore[arg-type]
            st.integers(0, 6),
            st.integers(0, 20),
            st.binary(max_size=30),
        ),
    ),
    max_size=4,
).map(tuple)
stream = EXAMPLE.upload.stream
bodies = st.one_of(
    st.builds(Hello, st.integers(0, 3), st.integers(0, 3)).map(Hello.pack),
    st.just(EXAMPLE.upload.begin.pack()),
    st.builds(
        Begin,
        st.sampled_from([target_digest(TARGET), ZEROS]),
        st.binary(min_size=32, max_size=32),
        st.just(ZEROS),
        numbers32,
        st.integers(0, 70),
    ).map(Begin.pack),
    st.builds(Declare, st.integers(0, 9), entries).map(Declare.pack),
    st.just(Declare(0, tuple(each.entry for each in EXAMPLE.upload.objects)).pack()),
    st.integers(0, len(stream)).flatmap(
        lambda at: st.integers(0, 1024).map(lambda n: DATA.pack(at) + stream[at : at + n])
    ),
    st.builds(lambda at, data: DATA.pack(at) + data, numbers32, st.binary(max_size=40)),
    st.just(EXAMPLE.upload.digest),
    st.builds(CaptureRequest, st.integers(0, 3), st.integers(0, 5)).map(CaptureRequest.pack),
    st.builds(
        ReadRequest, st.integers(0, 3), numbers32, numbers32, numbers32, st.integers(0, 1100)
    ).map(ReadRequest.pack),
    st.binary(max_size=200),
)
KINDS = [kind for kind in PacketKind if kind < REPLY]
packets = st.builds(
    lambda kind, sequence, session, body: Packet(kind, sequence, session, body).wire(),
    st.one_of(st.sampled_from(KINDS), st.integers(0, 255)),
    st.integers(0, 3),
    st.sampled_from([7, 7, 7, 7, 7, 8, 0]),
    bodies,
)
HELLO = Packet(PacketKind.HELLO, 1, 7, Hello(2, 2).pack()).wire()
WHOLE_UPLOAD = [
    HELLO,
    Packet(PacketKind.BEGIN, 2, 7, EXAMPLE.upload.begin.pack()).wire(),
    Packet(
        PacketKind.DECLARE, 3, 7, Declare(0, tuple(e.entry for e in EXAMPLE.upload.objects)).pack()
    ).wire(),
    *(
        Packet(PacketKind.DATA, 4, 7, DATA.pack(at) + stream[at : at + 1024]).wire()
        for at in range(0, len(stream), 1024)
    ),
    Packet(PacketKind.FINISH, 5, 7, EXAMPLE.upload.digest).wire(),
    Packet(PacketKind.CAPTURE, 6, 7, CaptureRequest(1, BOTH).pack()).wire(),
]


@given(st.lists(st.binary(max_size=300), max_size=8))
def test_noise_gets_no_answer_from_either_twin(core: Lockstep, pieces: list[bytes]) -> None:
    spoken = said(core, pieces)
    assert spoken == said(twin(), pieces)
    booted = Packet(PacketKind.BOOTED, 0, 0).wire()
    assert b"".join(spoken) in (b"", booted)


@given(
    st.integers(0, len(WHOLE_UPLOAD)),
    st.lists(st.one_of(packets, packets, st.binary(max_size=60)), max_size=12),
)
def test_the_twins_answer_packets_alike(core: Lockstep, begun: int, more: list[bytes]) -> None:
    """After any part of an upload and any packets or bytes, firmware and Python answer the same
    bytes."""
    pieces = [*WHOLE_UPLOAD[:begun], *more]
    assert said(core, pieces) == said(twin(), pieces)


@given(
    st.lists(
        st.tuples(st.integers(0, len(b"".join(WHOLE_UPLOAD)) - 1), st.integers(0, 255)), max_size=6
    )
)
def test_firmware_and_twin_answer_damaged_uploads_alike_and_confirm_only_whole_ones(
    core: Lockstep, spoiled: list[tuple[int, int]]
) -> None:
    wire = bytearray(b"".join(WHOLE_UPLOAD))
    for at, value in spoiled:
        wire[at] = value
    pieces = [bytes(wire[i : i + 500]) for i in range(0, len(wire), 500)]
    spoken = said(core, pieces)
    assert spoken == said(twin(), pieces)
    unpacker = Unpacker()
    for packet in unpacker.feed(b"".join(spoken)):
        if packet.kind == PacketKind.FINISH | REPLY:
            state = UploadProgress.unpack(packet.body)
            assert (state.state, state.position) == (LoaderState.READY, len(stream))


legal_words = st.sampled_from(
    [word for each in examples() for kernel in each.container.kernels for word in kernel.words]
)
bits = st.integers(0, 159)
flipped = st.builds(
    lambda word, some: tuple(
        part ^ sum(1 << bit % 32 for bit in some if bit // 32 == i) for i, part in enumerate(word)
    ),
    legal_words,
    st.sets(bits, max_size=4),
)
any_words = st.tuples(*[st.integers(0, (1 << 32) - 1)] * 5)
rows = st.sampled_from(OPERATIONS)
operands = st.lists(
    st.sampled_from(
        ["A", "B", "NEWS", "XN", "XE", "PIX", "IN", "R0", "R1", "R2", "R12", "R13", "FLAG"]
    ),
    max_size=5,
)


def made(row: object, destinations: list[str], sources: list[str]) -> tuple[int, ...]:
    """The lines of an operation and of any operands, whether it takes them or not."""
    from nscc.words.encoding import masks

    found = masks()
    words = [found.fixed[row.name]]  # type: ignore[attr-defined]
    words += [found.written[name] for name in destinations if name in found.written]
    words += [found.read[name] for name in sources]
    total = [0] * 5
    for word in words:
        total = [one | other for one, other in zip(total, word, strict=True)]
    return tuple(total)


@given(
    st.lists(
        st.one_of(legal_words, flipped, any_words, st.builds(made, rows, operands, operands)),
        min_size=1,
        max_size=1,
    )
)
def test_the_firmware_takes_the_words_that_the_table_takes(
    core: Lockstep, words: list[tuple[int, int, int, int, int]]
) -> None:
    from struct import pack

    data = pack("<2I", 1, len(words)) + b"".join(pack("<5I", *word) for word in words)
    kernels = Object(ObjectKind.KERNELS, 0, data)
    target = target_digest(TARGET)
    digest = program_digest(target, ZEROS, kernels.entry.pack())
    pieces = [
        HELLO,
        Packet(PacketKind.BEGIN, 2, 7, Begin(target, digest, ZEROS, len(data), 1).pack()).wire(),
        Packet(PacketKind.DECLARE, 3, 7, Declare(0, (kernels.entry,)).pack()).wire(),
        Packet(PacketKind.DATA, 4, 7, DATA.pack(0) + data).wire(),
    ]
    operation = matching(words[0])
    whole = operation is not None and operation.operation.phase.name == "WHOLE"
    legal = whole and operation is not None and picture_fault(operation, TARGET) is None
    [*_, last] = Unpacker().feed(said(core, pieces)[-1])
    failure = LoaderFailure.unpack(last.body)
    assert failure.fault == (LoaderFault.NO_PROGRAM if legal else LoaderFault.WORD)
    if operation is not None:
        assert encode(operation) == words[0]


replies = st.one_of(
    st.binary(max_size=200),
    st.builds(
        UploadProgress, st.integers(0, 7), st.integers(0, 255), st.integers(0, 70), numbers32
    ).map(UploadProgress.pack),
    st.builds(
        CaptureReply,
        st.integers(0, 3),
        st.integers(0, 1),
        st.integers(0, 3),
        st.integers(0, 9),
        st.integers(0, 2000),
        numbers32,
        *[st.integers(0, 2)] * 9,
    ).map(CaptureReply.pack),
    st.builds(LoaderFailure, st.integers(0, 255), st.integers(0, 30), numbers32).map(
        LoaderFailure.pack
    ),
    st.just(
        packed_info(
            Info(
                2,
                0,
                1024,
                16384,
                3,
                Capability.EXACT,
                1024,
                99,
                99,
                99,
                1 << 20,
                512,
                99,
                6,
                10,
                target_digest(TARGET),
                ZEROS,
                ZEROS,
                "scamp5",
                "an enemy",
            )
        )
    ),
)


@given(st.lists(st.tuples(st.sampled_from(list(PacketKind)), replies), max_size=30), st.data())
def test_a_host_ends_after_any_answers_of_a_loader(
    answers: list[tuple[PacketKind, bytes]], data: st.DataObject
) -> None:
    """The host gets the answers to its latest request, or any others, and then silence."""
    host = new_host(1)
    now, unpacker, latest = 0.0, Unpacker(), None
    waiting = list(answers)
    with pytest.raises((Silent, Stalled, RequestRefused, Contested, Implausible)):  # noqa: PT012
        work = uploaded_and_captured(host, EXAMPLE.upload, 1)
        host.start(host.lasting(work), now)
        for _ in range(3000):
            for packet in unpacker.feed(host.poll(now)):
                latest = packet
            if waiting and latest is not None:
                kind, body = waiting.pop(0)
                kind_now = latest.kind | REPLY if data.draw(st.booleans()) else kind
                answer = Packet(int(kind_now), latest.sequence, latest.session, body)
                host.receive(answer.wire(), now)
                now += 0.001
            else:
                now = max(host.deadline, now)


@given(st.lists(st.binary(max_size=500), max_size=10))
def test_a_host_does_not_listen_to_noise(pieces: list[bytes]) -> None:
    host: Host = new_host(1)
    host.start(host.lasting(host.status), 0.0)
    for piece in pieces:
        host.receive(piece, 0.001)
    assert host.running
    with pytest.raises((Silent, SessionLost)) as caught:  # noqa: PT012
        while host.running:
            host.poll(host.deadline)
    assert isinstance(caught.value, Silent)
