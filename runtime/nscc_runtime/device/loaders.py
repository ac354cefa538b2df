"""The loaders that come with nscc, what they have room for, and the notes of `nscc check` about
programs that one of them cannot take."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import groupby
from typing import NamedTuple

from nscc.diagnostics.diagnostic import Diagnostic, Label, Severity
from nscc.source import Source, Span
from nscc.words.container import Container
from nscc.words.legality import loader_fault


class Loader(NamedTuple):
    """The limits of a loader, as in `limits.hpp` of its `folder` in `runtime/firmware`.

    `kernels`, `rows`, `runs`, `frame_bytes` and `frame_ms` are the most of these resources.
    `gains`: whether it scales readouts. `name` is for messages."""

    name: str
    folder: str
    kernels: int
    rows: int
    runs: int
    frame_bytes: int
    frame_ms: int
    gains: bool


LOADERS = (
    Loader("the loader on a computer", "host", 1024, 16384, 4096, 1 << 23, 1200000, True),
    Loader("the firmware", "scamp5d", 256, 1024, 64, 7 << 16, 1200000, False),
    Loader("the firmware in QEMU", "qemu", 256, 1024, 64, 1 << 20, 48000, True),
)
MOST_PARAMS, MOST_CHANGES = 16, 64
"""Largest numbers of parameters and of changes that a loader stores."""
_SMALLER = "use fewer slots, or fewer shutters"
RESOURCES = {
    "words": ("words", _SMALLER),
    "kernels": ("kernels", _SMALLER),
    "rows": ("rows of its schedule", _SMALLER),
    "runs": ("runs of equal slots", "use slots of equal length"),
    "frame_bytes": ("bytes of a frame", "read out fewer buckets, images or planes"),
    "frame_ms": ("milliseconds of exposure", "use fewer slots, or shorter ones"),
    "params": ("parameters", "use fewer parameters"),
    "changes": ("changes of its schedule by parameters", "use each parameter less often"),
}
"""For each resource of a loader, its name in messages, and how a program needs less of it."""


class Shortage(NamedTuple):
    """A resource of which a program needs more than a loader has."""

    resource: str
    required: int
    available: int

    def __str__(self) -> str:
        """Return what the program needs and what the loader has, as text."""
        name, _ = RESOURCES[self.resource]
        return f"{self.required} {name}, but the loader supports {self.available}"


def shortages(needed: Mapping[str, int], room: Mapping[str, int]) -> list[Shortage]:
    """Return the resources of which `needed` is more than the `room`, in the order of RESOURCES;
    both are by the names of resources. A resource without a room is not limited."""
    return [
        Shortage(name, needed[name], room[name])
        for name in RESOURCES
        if name in room and needed[name] > room[name]
    ]


def loader_notes(container: Container, source: Source, frame: Span) -> Iterator[Diagnostic]:
    """Yield a note (NS0507) for each loader that cannot take a program; nothing for a target
    without logic, which no loader runs.

    `frame` is the place of the statement `frame` in the program's text `source`."""
    if not container.target.has_logic or _is_small(container):
        return

    def note(message: str, remedy: str, short: list[Shortage]) -> Diagnostic:
        """Return a note with a `message`, the `remedy` at the frame, and the numbers of `short`."""
        numbers = {s.resource: {"required": s.required, "available": s.available} for s in short}
        return Diagnostic(
            "NS0507",
            message,
            severity=Severity.NOTE,
            source=source,
            label=Label(frame, remedy),
            data=numbers,
        )

    fault = loader_fault(container)
    if fault is not None:
        yield note(f"no loader can take this program: {fault}", "run it on the emulator", [])
        return
    from nscc_runtime.device.messages import Channel  # `nscc check` of small programs loads
    from nscc_runtime.device.objects import program_of  # nothing of devices

    program = program_of(container, bytes(32), with_planes=False)
    needed = program.needs(Channel.CODES | Channel.STATES | Channel.REPORTS)
    for loader in LOADERS:
        room = {"params": MOST_PARAMS, "changes": MOST_CHANGES, **loader._asdict()}
        short = shortages(needed, room)
        if short:
            remedy = "; ".join(dict.fromkeys(RESOURCES[s.resource][1] for s in short))
            needs = "; ".join(map(str, short))
            yield note(f"{loader.name} cannot take this program: it needs {needs}", remedy, short)
        elif program.gains and not loader.gains:
            message = f"{loader.name} cannot take this program: it scales its readouts"
            yield note(message, "build it with another --lowering", [])


def _is_small(container: Container) -> bool:
    """Return whether every loader has room for a program, as its size alone shows."""
    pictures, least = container.pictures, LOADERS[1]
    pixels = container.target.rows * container.target.cols
    reads = len(container.readouts) + len(pictures.reads) + len(pictures.reports)
    return (
        len(container.kernels) + len(pictures.kernels) < least.kernels
        # A launch takes at most two rows.
        and 2 * (len(container.launches) + len(pictures.launches)) <= least.rows
        and sum(1 for _ in groupby(container.slot_us)) <= least.runs
        and sum(container.slot_us) <= 1000 * min(loader.frame_ms for loader in LOADERS)
        and 2 * reads * pixels <= least.frame_bytes
        and all(readout.gain == 1 for readout in container.readouts)
        and not pictures.params
        and not pictures.kept_images
    )
