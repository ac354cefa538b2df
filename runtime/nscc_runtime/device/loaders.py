"""The loaders that come with nscc, what they have room for, and the notes of `nscc check` about
programs that one of them cannot take."""

from __future__ import annotations

from itertools import groupby
from typing import NamedTuple

from nscc.diagnostics.diagnostic import Diagnostic, Label, Severity
from nscc.source import Source, Span
from nscc.words.container import Container, steered_launches, with_picture_words


class Loader(NamedTuple):
    """The limits of a loader, as in `limits.hpp` of its `folders` in `runtime/firmware`. `kernels`,
    `rows` and `runs` are the most kernels (lists of words), rows of the schedule and runs of equal
    slots of a program. `name` is for messages."""

    name: str
    folders: tuple[str, ...]
    kernels: int
    rows: int
    runs: int


LOADERS = (
    Loader("the loader on a computer", ("host",), 1024, 16384, 4096),
    Loader("the firmware", ("scamp5d", "qemu"), 256, 1024, 64),
)


def loader_notes(container: Container, source: Source, frame: Span) -> list[Diagnostic]:
    """Return a note (NS0507) for each loader that has too little room for a program's words; none
    for a target without logic, which no loader runs.

    `frame` is the place of the statement `frame` in the program's text `source`."""
    if not container.target.has_logic:
        return []
    sent = with_picture_words(container)
    # A launch takes at most two rows, so that the rows of few launches need not be counted.
    rows = 2 * len(sent.launches)
    if rows > min(loader.rows for loader in LOADERS):
        from nscc_runtime.device.objects import schedule_rows  # `nscc check` loads no device

        rows = sum(1 for _ in schedule_rows(sent, steered_launches(container)))
    # What the program needs is compared with the room of each loader, by the same names.
    needed = {
        "kernels": len(sent.kernels),
        "rows of its schedule": rows,
        "runs of equal slots": sum(1 for _ in groupby(container.slot_us)),
    }
    notes = []
    for loader in LOADERS:
        room = zip(needed.items(), (loader.kernels, loader.rows, loader.runs), strict=True)
        short = [(what, count, most) for (what, count), most in room if count > most]
        if short:
            texts = (f"{count} {what}, but it holds {most}" for what, count, most in short)
            notes.append(
                Diagnostic(
                    "NS0507",
                    f"{loader.name} cannot take this program: it needs {'; '.join(texts)}",
                    severity=Severity.NOTE,
                    source=source,
                    label=Label(frame, "use fewer slots, or fewer shutters"),
                    data={
                        what: {"required": count, "available": most} for what, count, most in short
                    },
                )
            )
    return notes
