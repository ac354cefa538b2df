"""Shared parts of resource errors: the origin of the limit, the required amount, times."""

from __future__ import annotations

from math import ceil, floor, log10

from nscc.diagnostics.diagnostic import Label
from nscc.program.program import Program


def chip_label(program: Program, text: str) -> tuple[Label, ...]:
    """Return the second label of a resource error: the statement that names the chip, labelled with
    `text`. Empty if the program does not name its chip."""
    return (Label(program.target_span, text),) if program.target_span is not None else ()


def chip_note(program: Program, text: str) -> tuple[str, ...]:
    """Return `text`, after the name of the chip, as a note if the program does not name its chip;
    else empty, because `chip_label` shows it."""
    return () if program.target_span is not None else (f"{program.target.name}: {text}",)


def resource(
    name: str, required: float, available: float, *, proved: bool
) -> dict[str, str | float | bool]:
    """Return the machine-readable data of a resource error.

    `name` is the resource; `required` and `available` are amounts of it, in the unit that the name
    implies. `proved` is False if only this compiler's search needs so much."""
    return {"resource": name, "required": required, "available": available, "proved": proved}


def at_least(us: float) -> str:
    """Return a time in microseconds, above 0, as text in s, ms, us or ns, rounded up to three
    digits."""
    # The unit of the third digit.
    digit_us = 10.0 ** (floor(log10(us)) - 2)
    return time_text(ceil(us / digit_us - 1e-9) * digit_us)


def time_text(us: float) -> str:
    """Return a time in microseconds as text in s, ms, us or ns: the largest of which it is at least
    1, else ns. It is rounded to four digits."""
    for unit, size in (("s", 1e6), ("ms", 1e3), ("us", 1.0)):
        if us >= size:
            return f"{us / size:.4g} {unit}"
    return f"{us * 1e3:.4g} ns"
