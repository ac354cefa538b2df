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

import json
import shlex
from hashlib import sha256
from pathlib import Path
from struct import Struct
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.chips.load import target_dict, target_from_dict
from nscc.diagnostics.diagnostic import Rejected
from nscc.diagnostics.rejection import rejected
from nscc.words import machine_file, pictures_file
from nscc.words.container import Container, DecodeTable, Launch, Readout, StoredKernel
from nscc.words.machine import StateMachine, StatePlanes
from nscc.words.soundness import faults
from nscc.words.stored_arrays import StoredArray, packed, unpacked
from nscc.words.stream import Stream

MAGIC = b"\x89ICW\r\n\x1a\n"
VERSIONS = (1, 2, 3, 4)
"""File versions: fixed shutters, pixels that look, chips without logic, and programs with
images."""
_PREAMBLE = Struct("<8sIIQ")
_DIGEST = 32
LARGEST_FILE = 1 << 31
_CHUNK = 1 << 20


def _layout(header: dict[str, Any]) -> tuple[StoredArray, ...]:
    """Return the arrays that a header describes, in file order."""
    counts, target = header["counts"], header["target"]
    registers = len(target["registers"]["digital"]) if "registers" in target else 0
    buckets, fields = len(header["buckets"]), len(header["fields"])
    pixels = (target["array"]["rows"], target["array"]["cols"]) if counts["pixels"] else (0, 0)
    words = sum(count for _, count in header["kernels"])
    arrays = (
        StoredArray("slot_us", "<f8", (counts["slots"],)),
        StoredArray("codes", "<i8", (counts["codes"], fields)),
        StoredArray("shutter_of_code", "<i4", (counts["codes"],)),
        StoredArray("shutters", "?", (counts["shutters"], buckets, counts["slots"])),
        StoredArray("encoding", "?", (counts["shutters"], registers)),
        StoredArray("words", "<u4", (words, 5)),
        StoredArray("launches", "<i4", (counts["launches"], 2)),
        StoredArray("pixel_codes", "<i4", pixels),
    )
    if target.get("kind") == "stream":
        planes = (counts["slots"], pixels[0], -(-pixels[1] // 8))
        places = (StoredArray(name, "|i1", (counts["slots"],)) for name in ("ones", "zeros"))
        return (
            (*arrays, StoredArray("planes", "|u1", planes), *places) if counts["pixels"] else arrays
        )
    if "machine" not in header:
        return arrays
    of_machine = machine_file.layout_of(header["machine"], buckets, counts["slots"])
    return (*arrays, StoredArray("levels", "<i4", (counts["launches"],)), *of_machine)


def to_bytes(container: Container) -> bytes:
    """Return the container as a file; raise ValueError for an inconsistent container (a bug of its
    maker)."""
    problems = faults(container)
    if problems:
        raise ValueError(f"unsound container: {problems[0]}")
    header, arrays = _header(container), _arrays(container)
    text = json.dumps(header, sort_keys=True, separators=(",", ":"), allow_nan=False)
    sections = [text.encode("ascii"), *packed(_layout(header), arrays)]
    length = _PREAMBLE.size + sum(map(len, sections)) + _DIGEST
    if container.target.streamed:
        version = 3
    elif container.pictures is not None:
        version = 4
    else:
        version = 1 if container.machine is None else 2
    body = b"".join([_PREAMBLE.pack(MAGIC, version, len(sections[0]), length), *sections])
    return body + sha256(body).digest()


def _header(container: Container) -> dict[str, Any]:
    table, machine = container.table, container.machine
    looking = {}
    if machine is not None:
        looking["machine"] = machine_file.header_of(machine, container.state_planes)
    if container.pictures is not None:
        looking["pictures"] = pictures_file.header_of(container.pictures)
    return {
        **looking,
        "target": target_dict(container.target),
        "buckets": list(container.buckets),
        "fields": list(table.fields),
        "kernels": [[kernel.name, len(kernel.words)] for kernel in container.kernels],
        "code_registers": list(container.code_registers),
        "readouts": [[r.register, r.bucket, float(r.gain)] for r in container.readouts],
        "source_lines": list(container.source_lines),
        "notes": dict(container.notes),
        "counts": {
            "slots": container.slots,
            "codes": len(table.codes),
            "shutters": len(table.shutters),
            "launches": len(container.launches),
            "pixels": container.pixel_codes is not None,
        },
    }


def _arrays(container: Container) -> dict[str, NDArray[Any]]:
    table, pixels, machine = container.table, container.pixel_codes, container.machine
    of_machine: dict[str, NDArray[Any]] = {}
    if machine is not None:
        names = "behaviour", "values", "opens", "resets", "steps", "open_slots", "open_us"
        of_machine = {name: getattr(machine, name) for name in names}
        levels = [launch.level for launch in container.launches]
        none = machine_file.NO_LEVEL
        of_machine["levels"] = np.array([none if x is None else x for x in levels], "<i4")
    of_stream: dict[str, NDArray[Any]] = {}
    if container.stream is not None:
        of_stream = {name: getattr(container.stream, name) for name in ("planes", "ones", "zeros")}
    words = [word for kernel in container.kernels for word in kernel.words]
    launches = [(launch.instant, launch.kernel) for launch in container.launches]
    return {
        "slot_us": np.array(container.slot_us, dtype="<f8"),
        "codes": table.codes,
        "shutter_of_code": table.shutter_of_code,
        "shutters": table.shutters,
        "encoding": container.encoding,
        "words": np.array(words, dtype="<u4").reshape(-1, 5),
        "launches": np.array(launches, dtype="<i4").reshape(-1, 2),
        "pixel_codes": np.zeros((0, 0), "<i4") if pixels is None else pixels,
        **of_machine,
        **of_stream,
    }


def read_container(path: Path) -> Container:
    """Read the container in a file.

    Raises Rejected: NS0709 (status 2) if the file cannot be read, otherwise as `from_bytes` does.
    """
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
    """Return the container that `to_bytes` wrote; `name` is the file's name in messages.

    Everything is checked, and sizes before memory is allocated. Raises Rejected: NS0702 for data
    that is not a container, NS0704 for another version, NS0705 for a truncated file or data after
    its end, NS0706 for a wrong checksum, NS0707 for inconsistent contents. Words are not checked;
    `nscc.words.legality.decoded` checks them."""
    header_length = _check_frame(data, name)
    try:
        header = json.loads(data[_PREAMBLE.size : _PREAMBLE.size + header_length])
        container = _assembled(header, data, _PREAMBLE.size + header_length)
        problems = faults(container)
        if problems:
            raise ValueError(problems[0])
        if to_bytes(container) != data:
            raise ValueError("its encoding differs from the one that nscc writes")
    except ValueError as error:
        raise _rejected("NS0707", name, f"its contents are inconsistent: {error}") from None
    except (ArithmeticError, AttributeError, LookupError, RecursionError, TypeError):
        reason = "its contents are inconsistent: its header is malformed"
        raise _rejected("NS0707", name, reason) from None
    return container


def _rejected(code: str, name: str, reason: str) -> Rejected:
    again = "build the program again: `nscc build PROGRAM.nsl -o FILE.icw`"
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
    """Check magic, version, length and checksum; return the header's length."""
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


def _assembled(header: dict[str, Any], data: bytes, start: int) -> Container:
    """Return the container of a header and its arrays.

    If a value has another type than `_header` gives it, the container is written differently,
    or this raises an exception."""
    arrays = unpacked(_layout(header), data[:-_DIGEST], start)
    words = [(a, b, c, d, e) for a, b, c, d, e in arrays["words"].tolist()]
    kernels, first = [], 0
    for name, count in header["kernels"]:
        kernels.append(StoredKernel(str(name), tuple(words[first : first + count])))
        first += count
    machine: StateMachine | None = None
    planes: dict[str, StatePlanes] = {}
    levels: list[int | None] = [None] * len(arrays["launches"])
    if "machine" in header:
        machine, planes = machine_file.machine_from(header["machine"], arrays)
        none = machine_file.NO_LEVEL
        levels = [None if level == none else level for level in arrays["levels"].tolist()]
    sent = ("planes", "ones", "zeros")
    return Container(
        target=target_from_dict(header["target"]),
        slot_us=tuple(arrays["slot_us"].tolist()),
        buckets=tuple(map(str, header["buckets"])),
        table=DecodeTable(
            tuple(map(str, header["fields"])),
            *(arrays[name] for name in ("codes", "shutter_of_code", "shutters")),
        ),
        kernels=tuple(kernels),
        launches=tuple(
            Launch(instant, kernel, level)
            for (instant, kernel), level in zip(arrays["launches"].tolist(), levels, strict=True)
        ),
        code_registers=tuple(map(str, header["code_registers"])),
        encoding=arrays["encoding"],
        pixel_codes=arrays["pixel_codes"] if header["counts"]["pixels"] else None,
        readouts=tuple(Readout(str(r), str(b), float(gain)) for r, b, gain in header["readouts"]),
        source_lines=tuple(map(str, header["source_lines"])),
        notes={key: str(note) for key, note in header["notes"].items()},
        machine=machine,
        state_planes=planes,
        stream=Stream(*(arrays[name] for name in sent)) if sent[0] in arrays else None,
        pictures=pictures_file.pictures_from(header["pictures"]) if "pictures" in header else None,
    )
