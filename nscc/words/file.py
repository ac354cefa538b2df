"""Container files (`.icw`): `to_bytes` and `from_bytes` are exact inverses.

All integers are little endian. Nothing is compressed, so the bytes do not depend on a library's
version.

    8   magic 89 49 43 57 0d 0a 1a 0a (as in PNG, it detects text conversion and truncation)
    4   version
    4   length of the header
    8   length of the whole file
    ..  header: canonical JSON (sorted keys, no blanks, ASCII)
    ..  arrays, without gaps, in the order of `_layout`
    32  SHA-256 of everything before it

A container has exactly one form: `from_bytes` refuses bytes that `to_bytes` would not write, so
that reading and writing a file does not change it."""

from __future__ import annotations

import shlex
from collections.abc import Mapping
from dataclasses import dataclass
from hashlib import sha256
from pathlib import Path
from struct import Struct
from typing import Annotated

import numpy as np
from numpy.typing import NDArray

from nscc.arrays import Array, Bools, Floats, Ints32
from nscc.chips.load import target_dict, target_from_dict
from nscc.chips.target import Target
from nscc.codec import LATER, from_json, to_json
from nscc.diagnostics.diagnostic import Rejected, rejected
from nscc.record import Record
from nscc.words.container import Container, DecodeTable, Launch, Readout, StoredKernel
from nscc.words.machine import NO_LOOKS, Length
from nscc.words.pictures import NO_PICTURES, Pictures
from nscc.words.soundness import faults
from nscc.words.stored_arrays import StoredArray, layout_of, packed, unpacked
from nscc.words.stored_machine import StoredMachine, stored_machine
from nscc.words.stream import Stream

MAGIC = b"\x89ICW\r\n\x1a\n"
"""The first bytes of every file."""
VERSIONS = (1, 2, 3, 4, 5)
"""File versions: fixed shutters, pixels that look, chips without logic, programs with images, and
those with parameters, input planes, kept or repeated images."""
_PREAMBLE = Struct("<8sIIQ")
"""Magic, version, length of the header, and length of the file, before the header."""
_DIGEST = 32
"""Bytes of the SHA-256 digest that ends a file."""
LARGEST_FILE = 1 << 31
"""Largest container file that is read, in bytes."""
_CHUNK = 1 << 20
"""Bytes read first; if they begin like a container, the file is read on."""
_NO_LEVEL = -(2**31)
"""The stored level of a launch that does not set IN."""


@dataclass(frozen=True)
class _Counts:
    """The lengths of a file's arrays.

    `pixels` tells whether there are pixel codes, whose number is that of the target's pixels."""

    slots: Length
    codes: Length
    shutters: Length
    launches: Length
    pixels: bool


@dataclass(frozen=True)
class _Header:
    """The header of a file: all of a container (a compiled program) but its arrays.

    `target` is the target's table, `kernels` has the name and the number of words of each.
    `machine` and `pictures` are None for programs without them."""

    target: Mapping[str, object]
    buckets: tuple[str, ...]
    fields: tuple[str, ...]
    kernels: tuple[tuple[str, Length], ...]
    code_registers: tuple[str, ...]
    readouts: tuple[Readout, ...]
    source_lines: tuple[str, ...]
    notes: Mapping[str, str]
    counts: _Counts
    machine: Annotated[StoredMachine | None, LATER] = None
    pictures: Annotated[Pictures | None, LATER] = None


class _Times(Record):
    """The first array of a file."""

    slot_us: Annotated[Floats, "slots"]


class _Words(Record):
    """The arrays of a file that follow the decode table."""

    encoding: Annotated[Bools, "shutters registers"]
    words: Annotated[NDArray[np.uint32], "words word"]
    launches: Annotated[Ints32, "launches launch"]
    pixel_codes: Annotated[Ints32, "rows cols"]


class _Levels(Record):
    """The value of IN (the level sent to all pixels), in steps, that each launch (start of a
    kernel) sets; `_NO_LEVEL` if it sets none.

    Only files of programs with senses have this array. A kernel is a list of words."""

    levels: Annotated[Ints32, "launches"]


def _layout(header: _Header, target: Target) -> list[StoredArray]:
    """Return the arrays that a header describes, with types and shapes, in file order.

    `target` is the header's target, which determines the numbers of registers and pixels."""
    counts = header.counts
    rows, cols = (target.rows, target.cols) if counts.pixels else (0, 0)
    sizes = {
        "slots": counts.slots, "codes": counts.codes, "shutters": counts.shutters,
        "launches": counts.launches, "launch": 2, "fields": len(header.fields),
        "buckets": len(header.buckets), "registers": len(target.digital_registers),
        "words": sum(count for _, count in header.kernels), "word": 5,
        "rows": rows, "cols": cols, "row_bytes": -(-cols // 8),
    }  # fmt: skip
    kinds: list[type] = [_Times, DecodeTable, _Words]
    if counts.pixels and not target.has_logic:
        kinds.append(Stream)
    if header.machine is not None:
        kinds.append(_Levels)
    layout = [array for kind in kinds for array in layout_of(kind, sizes)]
    if header.machine is not None:
        layout += header.machine.layout(len(header.buckets), counts.slots)
    return layout


def to_bytes(container: Container) -> bytes:
    """Return the container (a compiled program) as the bytes of a file.

    Raises ValueError for an inconsistent container, which is a fault of whoever made it. Words are
    not checked."""
    problems = faults(container)
    if problems:
        raise ValueError(f"unsound container: {problems[0]}")
    header, target = _header(container), container.target
    text = to_json(header).encode("ascii")
    sections = [text, *packed(_layout(header, target), _arrays(container))]
    length = _PREAMBLE.size + sum(map(len, sections)) + _DIGEST
    if not target.has_logic:
        version = 3
    elif container.pictures.outputs:
        version = 5 if container.pictures.is_of_version_4 else 4
    else:
        version = 2 if container.machine.stages else 1
    body = b"".join([_PREAMBLE.pack(MAGIC, version, len(text), length), *sections])
    return body + sha256(body).digest()


def _header(container: Container) -> _Header:
    """Return the header of a container file: everything but the arrays and words. A container is a
    compiled program."""
    table, machine = container.table, container.machine
    return _Header(
        target=target_dict(container.target),
        buckets=container.buckets,
        fields=table.fields,
        kernels=tuple((kernel.name, len(kernel.words)) for kernel in container.kernels),
        code_registers=container.code_registers,
        readouts=container.readouts,
        source_lines=container.source_lines,
        notes=container.notes,
        counts=_Counts(
            container.slots,
            len(table.codes),
            len(table.shutters),
            len(container.launches),
            container.pixel_codes is not None,
        ),
        machine=stored_machine(machine, container.state_planes) if machine.stages else None,
        pictures=container.pictures if container.pictures.outputs else None,
    )


def _arrays(container: Container) -> dict[str, Array]:
    """Return the arrays of a container (a compiled program) by their names in files, also those
    that its file does not need.

    Without pixel codes, `pixel_codes` has no pixels."""
    words = [word for kernel in container.kernels for word in kernel.words]
    launches = [(launch.instant, launch.kernel) for launch in container.launches]
    levels = [_NO_LEVEL if row.level is None else row.level for row in container.launches]
    parts = (container.table, container.machine, container.stream)
    arrays = {name: array for part in parts if part for name, array in vars(part).items()}
    if container.pixel_codes is not None:
        arrays["pixel_codes"] = container.pixel_codes
    else:
        arrays["pixel_codes"] = np.zeros((0, 0), np.int32)
    return arrays | {
        "slot_us": np.array(container.slot_us, np.float64),
        "encoding": container.encoding,
        "words": np.array(words, np.uint32).reshape(-1, 5),
        "launches": np.array(launches, np.int32).reshape(-1, 2),
        "levels": np.array(levels, np.int32),
    }


def read_container(path: Path) -> Container:
    """Return the container (a compiled program) in the file `path`.

    Raises Rejected: NS0709 (status 2) if the file cannot be read. For a file that is no container,
    is damaged or has another version, it is NS0702 or NS0704 to NS0707 (status 1)."""
    try:
        with open(path, "rb") as file:
            data = file.read(_CHUNK)
            # Read no more bytes than the largest container has, whatever the path refers to.
            while data.startswith(MAGIC) and len(data) <= LARGEST_FILE:
                chunk = file.read(max(_CHUNK, len(data)))
                if not chunk:
                    break
                data += chunk
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise rejected("NS0709", f"cannot read '{path}': {reason}") from None
    return from_bytes(data, str(path))


def from_bytes(data: bytes, name: str) -> Container:
    """Return the container (a compiled program) that `to_bytes` wrote; `name` is the file's name in
    messages.

    Everything is checked, and sizes before memory is allocated. Raises Rejected: NS0702 for data
    that is not a container, NS0704 for another version, NS0705 for a truncated file or data after
    its end, NS0706 for a wrong checksum, NS0707 for inconsistent contents. Words are not checked;
    `nscc.words.legality.decoded` checks them."""
    header_length = _check_frame(data, name)
    try:
        container = _assembled(data, _PREAMBLE.size + header_length)
        problems = faults(container)
        if problems:
            raise ValueError(problems[0])
        if to_bytes(container) != data:
            raise ValueError("its encoding differs from the one that nscc writes")
    except ValueError as error:
        raise _rejected("NS0707", name, f"its contents are inconsistent: {error}") from None
    return container


def _rejected(code: str, name: str, reason: str) -> Rejected:
    """Return the error `code` that the container file `name` cannot be used, for `reason`.

    The help is to build a container (a compiled program); a program text (.nsl) gets the command
    that compiles it."""
    again = "`nscc build PROGRAM.nsl -o FILE.icw` writes a valid container"
    if name.endswith(".nsl"):
        build = shlex.join(["nscc", "build", name])
        again = f"it is a program: compile it first with `{build}`, and name the .icw file"
    return rejected(
        code,
        f"'{name}' cannot be used: {reason}",
        status=1,
        helps=(again,),
        data={"file": name},
    )


def _check_frame(data: bytes, name: str) -> int:
    """Check magic, version, length and checksum of a file, and return the length of its header in
    bytes.

    Raises Rejected (status 1), which names the file `name`: NS0702 for another magic, NS0704 for an
    unknown version, NS0705 for another length than the file states, NS0706 for a wrong checksum,
    and NS0707 for a header that is longer than the file."""
    if not data.startswith(MAGIC):
        reason = "it is empty" if not data else "it is not a container of instruction words (.icw)"
        raise _rejected("NS0702", name, reason)
    if len(data) < _PREAMBLE.size + _DIGEST:
        raise _rejected("NS0705", name, f"it is incomplete: it has only {len(data)} bytes")
    _, version, header_length, length = _PREAMBLE.unpack_from(data)
    if version not in VERSIONS:
        known = f"{VERSIONS[0]} to {VERSIONS[-1]}"
        reason = f"it has version {version} of the format, but this nscc reads versions {known}"
        raise _rejected("NS0704", name, reason)
    if len(data) != length:
        reason = f"it has {len(data)} bytes, but the container has {length}"
        if len(data) < length:
            reason = f"it is incomplete: it has {len(data)} bytes of {length}"
        raise _rejected("NS0705", name, reason)
    if sha256(memoryview(data)[:-_DIGEST]).digest() != data[-_DIGEST:]:
        reason = "it is damaged: its checksum does not match its contents"
        raise _rejected("NS0706", name, reason)
    if header_length > len(data) - _PREAMBLE.size - _DIGEST:
        raise _rejected("NS0707", name, "its contents are inconsistent: the header is too long")
    return int(header_length)


def _assembled(data: bytes, start: int) -> Container:
    """Return the container (a compiled program) of a file whose header ends, and whose arrays
    begin, at byte `start`.

    Raises ValueError for a header, or arrays, that no container has."""
    header = from_json(_Header, data[_PREAMBLE.size : start])
    target = target_from_dict(header.target)
    arrays = unpacked(_layout(header, target), data[:-_DIGEST], start)
    # The words of all kernels are stored in one array, one kernel after the other.
    words = [(a, b, c, d, e) for a, b, c, d, e in arrays["words"].tolist()]
    kernels, first = [], 0
    for name, count in header.kernels:
        kernels.append(StoredKernel(name, tuple(words[first : first + count])))
        first += count
    levels: list[int | None] = [None] * len(arrays["launches"])
    machine, stream = header.machine, None
    if "planes" in arrays:
        stream = Stream(*(arrays[name] for name in Stream.field_names))
    if machine is not None:
        levels = [None if level == _NO_LEVEL else level for level in arrays["levels"].tolist()]
    return Container(
        target=target,
        slot_us=tuple(arrays["slot_us"].tolist()),
        buckets=header.buckets,
        table=DecodeTable(header.fields, *(arrays[name] for name in DecodeTable.field_names[1:])),
        kernels=tuple(kernels),
        launches=tuple(
            Launch(instant, kernel, level)
            for (instant, kernel), level in zip(arrays["launches"].tolist(), levels, strict=True)
        ),
        code_registers=header.code_registers,
        encoding=arrays["encoding"],
        pixel_codes=arrays["pixel_codes"] if header.counts.pixels else None,
        readouts=header.readouts,
        source_lines=header.source_lines,
        notes=header.notes,
        machine=NO_LOOKS if machine is None else machine.machine(arrays),
        state_planes={} if machine is None else machine.state_planes(),
        stream=stream,
        pictures=header.pictures or NO_PICTURES,
    )
