"""Frames of a chip that the vendor's host module receives.

Public users of SCAMP-5 drive it with a Python module of this kind: `open_usb(name)` or
`open_tcp(address, port)`, `routine()`, `get_packet()` and `close()`. A packet is a mapping or None.
A packet of a picture has `type` "data", `datatype` "SCAMP5_AOUT" (codes) or "SCAMP5_DOUT" (bits),
`loopcounter` (the number of the frame), `width`, `height` and `buffer` (a byte for each pixel, row
by row). The chip runs a program of its own, for instance the C++ that nscc writes; the host
receives what it shows."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import suppress
from importlib import import_module
from time import monotonic, sleep
from typing import Any

import numpy as np

from nscc.arrays import Bytes
from nscc.diagnostics.diagnostic import Rejected
from nscc.words.container import Container
from nscc_runtime.device.device_errors import rejected
from nscc_runtime.device.imported_frame import Orientation, frame_of_pictures, readout_names
from nscc_runtime.frame_file import FrameFile
from nscc_runtime.sensor import Sensor

PREFIX = "host:"
_PORT = 27888
"""TCP port of a relay if the user names none."""
_POLL_S = 0.002
_MOST_INCOMPLETE = 3
"""Number of frames without all pictures after which the chip is assumed to run another program."""
_ANALOG, _DIGITAL = "SCAMP5_AOUT", "SCAMP5_DOUT"
_FUNCTIONS = ("open_usb", "open_tcp", "routine", "get_packet", "close")
SHOWN_UPRIGHT = Orientation(flip="rows")
"""Public users of the module reverse the rows of its pictures before they show them."""

Pictures = dict[str, tuple[str, Bytes]]
"""By readout: the origin of the picture, for messages, and its values (rows, cols)."""


def expose_by_host(
    place: str, container: Container, sensor: Sensor | None, patience_s: float
) -> FrameFile:
    """Return the file of the next whole frame that a host module receives.

    `place`: host:MODULE for a chip at USB, or host:MODULE@ADDRESS[:PORT] for a relay at TCP.
    `container`: the program that runs on the chip. `sensor` converts converter codes to electrons,
    None for the program's default. `patience_s`: longest time without a picture. Raises Rejected
    (status 3): NS0795 for a module that cannot be used, a lost link, silence, or frames with other
    readouts than the program's, and NS0794 (status 2) for pictures of another size."""
    name, _, address = place.removeprefix(PREFIX).partition("@")
    module = _imported(name)
    try:
        _call(name, lambda: _open(module, address))
        analog, digital = readout_names(container)
        number, pictures = _next_frame(module, name, analog, tuple(digital), patience_s)
    finally:
        with suppress(Exception):  # a link that is lost already was reported
            module.close()
    about = {"host": name, "loopcounter": number}
    return frame_of_pictures(container, pictures, SHOWN_UPRIGHT, sensor, about)


def _imported(name: str) -> Any:
    """Return the vendor's module of this name; raise Rejected (NS0795) if it cannot be imported
    or lacks a function."""
    try:
        module = import_module(name)
    except Exception as error:  # the module is not ours, and may fail in any way
        raise _failed(f"the host module '{name[:60]}' cannot be imported: {error}") from error
    missing = [function for function in _FUNCTIONS if not callable(getattr(module, function, None))]
    if missing:
        raise _failed(f"the host module '{name[:60]}' has no function {', '.join(missing)}")
    return module


def _open(module: Any, address: str) -> None:
    """Open the chip by the vendor's `module`: at USB if `address` is "", else at TCP. `address` is
    ADDRESS or ADDRESS:PORT.

    Raises ValueError for an invalid port, and what the module raises."""
    if not address:
        module.open_usb("0")
        return
    host, mark, port = address.rpartition(":")
    if mark and not port.isdecimal():
        raise ValueError(f"'{port}' is not a port")
    module.open_tcp(host if mark else address, int(port) if mark else _PORT)


def _next_frame(
    module: Any, name: str, analog: tuple[str, ...], digital: tuple[str, ...], patience_s: float
) -> tuple[int, Pictures]:
    """Return number and pictures of the first frame that began after the link was opened.

    `module` is the vendor's and `name` its name in messages. `analog` and `digital` are the
    program's readouts, in the order in which the pictures of a frame come; these have one number.
    `patience_s`: longest time without a picture. Raises Rejected (NS0795) after that, for frames
    without all pictures, and for frames with more."""
    wanted = {_ANALOG: analog, _DIGITAL: digital}
    first: int | None = None
    number, pictures, last_picture_s = -1, dict[str, list[Bytes]](), monotonic()
    incomplete = 0
    while True:
        _call(name, module.routine)
        packet = _call(name, module.get_packet)
        if packet is None:
            if monotonic() - last_picture_s > patience_s:
                seen = sum(map(len, pictures.values()))
                raise _failed(
                    f"'{name}' received no whole frame for {patience_s:g} s",
                    f"the frame needs {len(analog)} pictures of codes and {len(digital)} of bits; "
                    f"{seen} came",
                )
            sleep(_POLL_S)
            continue
        kind = packet.get("datatype") if isinstance(packet, Mapping) else None
        if kind not in wanted or packet.get("type") != "data":
            continue  # texts and numbers of the program
        last_picture_s = monotonic()
        if packet["loopcounter"] != number:
            # Before the first frame there is none, and the first may have begun before.
            incomplete += number not in (-1, first)
            if incomplete == _MOST_INCOMPLETE:
                raise _failed(
                    f"{incomplete} frames that '{name}' received lack pictures",
                    f"the program has {len(analog)} of codes and {len(digital)} of bits; the last "
                    f"frame had {len(pictures[_ANALOG])} and {len(pictures[_DIGITAL])}",
                )
            number, pictures = packet["loopcounter"], {_ANALOG: [], _DIGITAL: []}
            first = number if first is None else first
        pictures[kind].append(_picture_of(packet, name))
        if number == first:
            continue  # its first pictures may have come before the link was opened
        if any(len(pictures[each]) > len(wanted[each]) for each in wanted):
            raise _failed(
                f"frame {number} of the chip has other readouts than the program",
                f"the program has {len(analog)} of codes and {len(digital)} of bits",
            )
        if all(len(pictures[each]) == len(wanted[each]) for each in wanted):
            return number, {
                readout: (f"{name}, frame {number}, {readout}", picture)
                for each, names in wanted.items()
                for readout, picture in zip(names, pictures[each], strict=True)
            }


def _picture_of(packet: Mapping[str, Any], name: str) -> Bytes:
    """Return the picture (rows, cols) of a packet of the module `name`. Raises Rejected (NS0795) if
    it has another number of bytes than pixels."""
    rows, cols, data = int(packet["height"]), int(packet["width"]), bytes(packet["buffer"])
    if len(data) != rows * cols:
        raise _failed(
            f"'{name}' received a picture of {rows} x {cols} pixels with {len(data)} bytes"
        )
    return np.frombuffer(data, np.uint8).reshape(rows, cols)


def _call(name: str, function: Callable[[], Any]) -> Any:
    """Return the result of `function`, which calls the module `name`. Raises Rejected (NS0795) if
    it fails in any way."""
    try:
        return function()
    except Rejected:
        raise
    except Exception as error:  # the module is not ours, and may fail in any way
        raise _failed(f"'{name}' lost the chip, or cannot reach it: {error}") from error


def _failed(message: str, *notes: str) -> Rejected:
    """Return the error (NS0795) `message` about a host module that cannot be used, with `notes`."""
    return rejected(
        "NS0795",
        message,
        "the chip must run the program already: build it with `nscc build --emit cpp`, and start "
        "it with the vendor's tools",
        notes=notes,
    )
