"""The schedule of bit planes, with a check that there is time to load them."""

from __future__ import annotations

from dataclasses import dataclass

from nscc.diagnostics.diagnostic import Diagnostic, Label
from nscc.lower.resources import at_least, chip_label, chip_note, resource, time_text
from nscc.program.problems import counted
from nscc.program.program import Program
from nscc.stream.route import Route
from nscc.words.stream import Loading, schedule


@dataclass(frozen=True, eq=False)
class Sending:
    """A program's route on a chip without logic, and the times of its bit planes."""

    program: Program
    route: Route

    @property
    def loadings(self) -> tuple[Loading, ...]:
        """The times at which the plane of each slot is sent and takes effect."""
        return tuple(schedule(self.program.target, self.program.frame.slot_us))

    @property
    def shortest_slot_us(self) -> float:
        """The shortest slot in microseconds: the time to load a plane."""
        return self.program.target.plane_load_us

    @property
    def bits_a_frame(self) -> int:
        """The number of bits sent for a frame."""
        target = self.program.target
        return len(self.program.frame.slot_us) * target.rows * target.cols

    @property
    def bits_per_us(self) -> float:
        """The data rate while a plane loads, in bits per microsecond."""
        return self.program.target.cols / self.program.target.row_load_us

    @property
    def frame_us(self) -> float:
        """The time from the start of the first slot to the end of the last, in microseconds."""
        return sum(self.program.frame.slot_us)


def late_fault(sending: Sending) -> Diagnostic | None:
    """Return the error (NS0508) if a slot is shorter than the load time of a plane, else None."""
    program, target = sending.program, sending.program.target
    slots_us, needed_us = program.frame.slot_us, target.plane_load_us
    # If light waits for the plane, a slot as short as the load time has no light.
    late = [
        n
        for n, us in enumerate(slots_us)
        if us < needed_us * (1 - 1e-9) or (not target.pipelined and us <= needed_us)
    ]
    if not late:
        return None
    worst = min(late, key=slots_us.__getitem__)
    takes = f"{target.rows} rows x {time_text(target.row_load_us)}"
    longer_text = "or longer" if target.pipelined else "and more"
    rows = int(slots_us[worst] / target.row_load_us)
    fewer: tuple[str, ...] = ()
    if rows:
        fits_text = f"a target of at most {counted(rows, 'row')} fits slots of "
        fewer = (f"{fits_text}{time_text(slots_us[worst])}: `nscc targets {target.name} --toml`",)
    count = int(sum(slots_us) / needed_us)
    fewer_slots = f"; {counted(count, 'slot')} of that fit into this frame's time" if count else ""
    return Diagnostic(
        "NS0508",
        f"slot {worst} is shorter than the loading of its bits: it lasts "
        f"{time_text(slots_us[worst])}, but {takes} take {time_text(needed_us)}",
        source=program.source,
        label=Label(program.frame.span, f"{len(late)} of {len(slots_us)} slots too short"),
        related=chip_label(program, f"{takes} a plane"),
        notes=(
            *chip_note(program, f"{takes} a plane"),
            "certain: every slot needs its own bit plane, which is sent row by row",
        ),
        helps=(
            f"slots of {at_least(needed_us)} {longer_text} are long enough{fewer_slots}",
            *fewer,
        ),
        data=resource("slot_us", needed_us, slots_us[worst], proved=True),
    )
