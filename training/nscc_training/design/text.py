"""Program texts of designs."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import count

from nscc.chips.target import Target
from nscc.program.looking import level_steps
from nscc.source import Source
from nscc.syntax.format import format_source
from nscc_training.design.looking import LookSchedule

SLOT_DECIMALS = 6
"""Decimals of a slot length in microseconds, finer than a chip's clock."""


def looking_text(
    schedule: LookSchedule,
    slots: int,
    slot_us: float,
    target: Target,
    chip: str | None,
    remark: str,
) -> str:
    """Return the text of a program whose pixels look at their light as a schedule says, in a frame
    of `slots` slots of `slot_us` microseconds.

    `target` is the chip, and `chip` its name in the text; None leaves it out. `remark` is the
    comment at the head."""
    levels = [level_text(steps, target) for steps in schedule.steps]
    level = levels[0] if len(set(levels)) == 1 else f"[{', '.join(levels)}]"
    at = ", ".join(map(str, schedule.at))
    return _formatted(
        [
            *_head("nsl 2", remark, chip, slots, slot_us),
            f"sense bright when light > {level} at n in [{at}]",
            "",
            f"state closed_at : 0..{len(schedule.at)} = 0".ljust(36) + "# 0: open to the end",
            "next closed_at = looks when bright and closed_at == 0",
            "",
            "open when closed_at == 0",
            "read closed_at",
        ]
    )


def tile_text(
    stops: Sequence[Sequence[int]], slots: int, slot_us: float, chip: str | None, remark: str
) -> str:
    """Return the text of a program with a fixed tile. `stops` (rows, cols) are the numbers of
    slots, from the first on, for which pixels are open, in a frame of `slots` slots of `slot_us`
    microseconds.

    `chip` is the target's name, None to leave it out; `remark` is the comment at the head."""
    rows = [f"[{', '.join(map(str, row))}]" for row in stops]
    return _formatted(
        [
            *_head("nsl 1", remark, chip, slots, slot_us),
            "code stop : 1..N",
            "open when n < stop",
            "",
            f"pixels stop = tile [{', '.join(rows)}]",
        ]
    )


def level_text(steps: int, target: Target) -> str:
    """Return a level of `steps` steps of IN as percent of a full well, with the fewest decimals
    from which the compiler gets the same number of steps, such as "22%". IN is the level sent to
    all pixels."""
    percent = 100 * steps * target.electrons_per_step / target.full_well_e
    candidates = (f"{percent:.{digits}f}" for digits in count())
    return next(f"{text}%" for text in candidates if level_steps(float(text), "%", target) == steps)


def _formatted(lines: Sequence[str]) -> str:
    """Return the program of these lines (without line ends) in the standard style, as `nscc fmt`
    writes it."""
    return format_source(Source("design.nsl", "\n".join(lines) + "\n"))


def frame_text(slots: int, slot_us: float) -> str:
    """Return the `frame` statement for `slots` slots of `slot_us` microseconds each, such as "frame
    16 slots of 125us"."""
    told_us = f"{slot_us:.{SLOT_DECIMALS}f}".rstrip("0").rstrip(".")
    return f"frame {slots} slots of {told_us}us"


def _head(
    language: str, remark: str, chip: str | None, slots: int, slot_us: float
) -> Sequence[str]:
    """Return the first lines of a program: `remark` as a comment, `language` (such as "nsl 2"), the
    target `chip` (None leaves it out), and the frame of `slots` slots of `slot_us` microseconds."""
    lines = [*(f"# {line}" for line in remark.splitlines()), language, ""]
    return [*lines, *([f"target {chip}"] if chip else []), frame_text(slots, slot_us), ""]
