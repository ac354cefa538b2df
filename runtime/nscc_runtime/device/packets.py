"""Packets on the wire: COBS between zero bytes, a header of eight bytes, CRC-32 at the end.

A byte stream may lose, change or cut anything. `Unpacker` returns packets with a valid checksum,
drops the rest, and buffers at most one packet."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from struct import Struct
from zlib import crc32

VERSION = 2
"""Version of the protocol that this host uses."""
MOST_DATA = 1024
"""Largest number of bytes of an object or a frame in one packet."""
MOST_BODY = MOST_DATA + 16
"""Largest body of a packet: data after a head of at most 16 bytes."""

_HEADER = Struct("<BBHI")
_CRC = Struct("<I")
OVERHEAD = _HEADER.size + _CRC.size
_LARGEST = OVERHEAD + MOST_BODY
_BLOCK = 254
"""Largest number of bytes without a zero that one overhead byte can count."""


class PacketKind(IntEnum):
    """The kind of a packet. A reply has the number of its request plus 0x80."""

    HELLO = 0x01
    STATUS = 0x02
    BEGIN = 0x03
    DECLARE = 0x04
    DATA = 0x05
    FINISH = 0x06
    CAPTURE = 0x07
    READ = 0x08
    CANCEL = 0x09
    CAPTURE_WITH = 0x0A
    LOAD = 0x0B
    BOOTED = 0xF0
    ERROR = 0xFF


REPLY = 0x80
"""Added to the kind of a request in its reply."""


@dataclass(frozen=True, slots=True)
class Packet:
    """A packet. `kind`: see `PacketKind`. `sequence`: number of the request. `session`: number of
    the host's session. A reply repeats both numbers. `body`: at most MOST_BODY bytes."""

    kind: int
    sequence: int
    session: int
    body: bytes = b""

    def wire(self) -> bytes:
        """Return the encoded packet, with its checksum, between two zero bytes; the first ends
        noise on the line."""
        plain = _HEADER.pack(self.kind, 0, self.sequence, self.session) + self.body
        return b"\0" + stuffed(plain + _CRC.pack(crc32(plain))) + b"\0"


def unpacked(stuffed_bytes: bytes) -> Packet | None:
    """Return the packet in `stuffed_bytes`, the bytes between two zero bytes. Return None if they
    are damaged: no valid stuffing, a wrong length or checksum, or a reserved byte that is not 0."""
    plain = unstuffed(stuffed_bytes)
    if plain is None or not OVERHEAD <= len(plain) <= _LARGEST:
        return None
    (checksum,) = _CRC.unpack_from(plain, len(plain) - _CRC.size)
    if crc32(plain[: -_CRC.size]) != checksum:
        return None
    kind, reserved, sequence, session = _HEADER.unpack_from(plain)
    if reserved:
        return None
    return Packet(kind, sequence, session, plain[_HEADER.size : -_CRC.size])


class Unpacker:
    """Finds the packets in a stream of bytes. `damaged`: number of pieces between zero bytes that
    were dropped."""

    def __init__(self) -> None:
        """Begin without bytes of a packet."""
        self.damaged = 0
        self._waiting = b""
        self._overlong = False

    def feed(self, data: bytes) -> list[Packet]:
        """Return the packets that `data` completes, together with bytes of earlier calls. Damaged
        ones are left out and counted."""
        *pieces, tail = (self._waiting + data).split(b"\0")
        packets = []
        for piece in pieces:
            overlong, self._overlong = self._overlong, False
            if not piece and not overlong:
                continue
            packet = None if overlong else unpacked(piece)
            if packet is None:
                self.damaged += 1
            else:
                packets.append(packet)
        # No packet is that long: its bytes are not stored, and what follows up to a zero is
        # dropped.
        if len(tail) > LONGEST_WIRE:
            tail, self._overlong = b"", True
        self._waiting = tail
        return packets


def stuffed(data: bytes) -> bytes:
    """Return `data` encoded without zero bytes (consistent overhead byte stuffing); the result is
    longer by at least one byte and at most 1/254."""
    out = bytearray()
    for piece in data.split(b"\0"):
        while len(piece) >= _BLOCK:
            out += b"\xff" + piece[:_BLOCK]
            piece = piece[_BLOCK:]
        out += bytes([len(piece) + 1]) + piece
    return bytes(out)


def unstuffed(data: bytes) -> bytes | None:
    """Return the bytes that `stuffed` has encoded as `data` (COBS); None for bytes that it cannot
    produce: a zero, or a block that is cut off."""
    out = bytearray()
    position = 0
    while position < len(data):
        length = data[position]
        if length == 0 or position + length > len(data):
            return None
        out += data[position + 1 : position + length]
        position += length
        # A full block is not followed by a zero, nor is the last block.
        if length < 0xFF and position < len(data):
            out.append(0)
    return bytes(out)


LONGEST_WIRE = _LARGEST + _LARGEST // _BLOCK + 2
"""Largest number of bytes between two zero bytes."""
