"""Packets on the wire: byte stuffing, checksums, and finding the next packet after noise."""

from __future__ import annotations

import binascii

import pytest

from nscc_runtime.device.packets import (
    MOST_BODY,
    Packet,
    Unpacker,
    stuffed,
    unpacked,
    unstuffed,
)


@pytest.mark.parametrize(
    ("plain", "wire"),
    [
        # The examples of the paper that describes the method, and of its Wikipedia article.
        ("", "01"),
        ("00", "0101"),
        ("0000", "010101"),
        ("11220033", "0311220233"),
        ("11223344", "0511223344"),
        ("11000000", "0211010101"),
        (
            "".join(f"{i:02x}" for i in range(1, 255)),
            "ff" + "".join(f"{i:02x}" for i in range(1, 255)) + "01",
        ),
        (
            "00" + "".join(f"{i:02x}" for i in range(1, 254)),
            "01fe" + "".join(f"{i:02x}" for i in range(1, 254)),
        ),
    ],
)
def test_stuffing_equals_the_published_cobs_examples(plain: str, wire: str) -> None:
    assert stuffed(bytes.fromhex(plain)).hex() == wire
    assert unstuffed(bytes.fromhex(wire)) == bytes.fromhex(plain)


@pytest.mark.parametrize("wire", ["05112233", "0311220033", "ff01", "0300"])
def test_invalid_stuffed_bytes_are_refused(wire: str) -> None:
    """Bytes with a count that passes the end, or with a zero in the data, are None."""
    assert unstuffed(bytes.fromhex(wire)) is None


def test_a_packet_is_laid_out_as_the_protocol_says() -> None:
    """Between two zero bytes stand kind, sequence, session and body in little-endian order, and a
    CRC-32 at the end."""
    wire = Packet(0x05, 0x1234, 0xAABBCCDD, b"\0abc").wire()
    assert wire[0] == wire[-1] == 0
    plain = unstuffed(wire[1:-1])
    assert plain is not None
    assert plain[:-4].hex() == "05003412ddccbbaa" + b"\0abc".hex()
    assert int.from_bytes(plain[-4:], "little") == binascii.crc32(plain[:-4])


def test_packets_come_out_of_a_stream_cut_anywhere() -> None:
    """Read in pieces of 1, 7 or 250 bytes or at once, a stream gives its 39 packets and no
    damage."""
    packets = [Packet(n, n, n + 1, bytes([n]) * (n * 37 % MOST_BODY)) for n in range(1, 40)]
    stream = b"".join(packet.wire() for packet in packets)
    for step in (1, 7, 250, len(stream)):
        unpacker = Unpacker()
        pieces = (stream[i : i + step] for i in range(0, len(stream), step))
        assert [p for piece in pieces for p in unpacker.feed(piece)] == packets
        assert unpacker.damaged == 0


def test_noise_costs_no_packet_after_it() -> None:
    """Text before a packet, and a packet with a flipped bit, count as one damaged packet each. The
    next packet is read."""
    packet = Packet(1, 2, 3, b"body")
    unpacker = Unpacker()
    assert unpacker.feed(b"\x55noise" + packet.wire()) == [packet]
    assert unpacker.damaged == 1
    broken = bytearray(packet.wire())
    broken[5] ^= 0x40
    assert unpacker.feed(bytes(broken) + packet.wire()) == [packet]
    assert unpacker.damaged == 2


def test_an_endless_packet_takes_no_room() -> None:
    """100 000 bytes without an end give no packet. They count as one damaged packet, and the next
    is read."""
    unpacker = Unpacker()
    for _ in range(100):
        assert unpacker.feed(b"\xff" * 1000) == []
    packet = Packet(9, 9, 9)
    assert unpacker.feed(packet.wire()) == [packet]
    assert unpacker.damaged == 1


def test_a_body_that_is_too_long_is_refused() -> None:
    """A body of MOST_BODY bytes is read; one byte more is None."""
    assert unpacked(Packet(1, 1, 1, b"x" * MOST_BODY).wire()[1:-1]) is not None
    assert unpacked(Packet(1, 1, 1, b"x" * (MOST_BODY + 1)).wire()[1:-1]) is None


def test_every_flipped_bit_is_noticed() -> None:
    plain = bytearray(unstuffed(Packet(3, 4, 5, b"some bytes").wire()[1:-1]) or b"")
    for bit in range(8 * len(plain)):
        plain[bit // 8] ^= 1 << bit % 8
        assert unpacked(stuffed(bytes(plain))) is None
        plain[bit // 8] ^= 1 << bit % 8
