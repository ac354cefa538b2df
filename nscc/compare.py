"""Comparison of one program on several chips: whether it fits, shortest slots, data rates."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

from nscc.chips.target import Target
from nscc.columns import columns
from nscc.compiler import compile_file
from nscc.diagnostics.diagnostic import Diagnostic, Rejected, Severity
from nscc.lower.resources import time_text
from nscc.mappings import JsonObject
from nscc.options import Options
from nscc.pipeline import KINDS, Compiled
from nscc.program.problems import counted
from nscc.stream.sending_report import rate_text
from nscc.words.container import Container

NoiseOf = Callable[[Container], tuple[float, float] | None]
"""A function that returns the expected noise in electrons: in the dark, and at half a full well."""


@dataclass(frozen=True, eq=False)
class OnChip:
    """A program compiled for the chip `target`, or the first error.

    `compiled` is None if the program does not fit, and `first_error` if it fits. `shortest_slot_us`
    is in microseconds and None if unknown; `frame_us` includes the readout. `sent_bits` is the
    amount of data per frame, `bits_per_us` the data rate while data is sent; None if there is an
    error. `stored` describes the chip's memory use. `noise_e` is the noise in electrons in the dark
    and at half a full well, None if unknown."""

    target: Target
    compiled: Compiled | None = None
    first_error: Diagnostic | None = None
    shortest_slot_us: float | None = None
    frame_us: float | None = None
    sent_bits: int | None = None
    bits_per_us: float | None = None
    stored: str = "?"
    noise_e: tuple[float, float] | None = None


def compare(
    path: Path, targets: Sequence[Target], level: int, noise_of: NoiseOf | None = None
) -> list[OnChip]:
    """Compile the program in a file for each chip, at optimisation level `level`.

    `noise_of` returns the noise of a compiled program; None leaves the noise out. The result has
    one entry for each of `targets`, in their order. Raises Rejected for errors that do not depend
    on the chip: syntax, names and types."""
    return [_compile_for_chip(path, target, level, noise_of) for target in targets]


def _compile_for_chip(path: Path, target: Target, level: int, noise_of: NoiseOf | None) -> OnChip:
    """Compile the program at `path` for one chip, at optimisation level `level`; return its
    figures, or the first error if it does not fit.

    If only the slots are too short, `shortest_slot_us` of the result is the length that the chip
    needs. Raises Rejected for errors that do not depend on the chip (NS01.., NS02..). `noise_of`
    returns the noise of the compiled program; None leaves it out."""
    try:
        compiled = compile_file(path, Options(level=level, target=target))
    except Rejected as error:
        first_error = next(d for d in error.diagnostics if d.severity is Severity.ERROR)
        if first_error.code[:4] in ("NS01", "NS02"):
            raise
        # If only the slots are too short, the error says how long they must be.
        late = first_error.data.get("resource") == "slot_us"
        needed = float(first_error.data["required"]) if late else None
        return OnChip(target, first_error=first_error, shortest_slot_us=needed)
    container = compiled.built
    noise = noise_of(container) if noise_of is not None else None
    kind, layout = KINDS.of(container), compiled.layout
    planes = counted(len(container.code_registers), "plane of code", "planes of code")
    words = container.words_stored
    stored = f"{counted(words, 'word')}, {planes}" if words else "nothing"
    return OnChip(
        target,
        compiled,
        shortest_slot_us=layout.shortest_slot_us,
        frame_us=layout.frame_us + kind.readout_us(container),
        sent_bits=layout.bits_a_frame,
        bits_per_us=layout.bits_per_us,
        stored=stored,
        noise_e=noise,
    )


def compared_text(chips: Sequence[OnChip]) -> str:
    """Return a text: a table with one column for each chip, then the error and the alternatives of
    chips that do not fit."""
    rows: list[tuple[str, ...]] = [("", *(chip.target.name for chip in chips))]
    for title, cell_text in _ROWS.items():
        rows.append((title, *(cell_text(chip) for chip in chips)))
    lines = [columns(rows)]
    for chip in chips:
        if chip.first_error is not None:
            lines += [
                "",
                f"{chip.target.name}: {chip.first_error.message} [{chip.first_error.code}]",
            ]
            lines += [f"  {text}" for text in (*chip.first_error.ways_out, *chip.first_error.helps)]
    return "\n".join(lines)


def compared_json(chips: Sequence[OnChip]) -> list[JsonObject]:
    """Return the comparison of `chips` as JSON values: an object for each chip, in their order.
    Unknown values are null."""
    return [
        {
            "target": chip.target.name,
            "kind": chip.target.kind,
            "rows": chip.target.rows,
            "cols": chip.target.cols,
            "fits": chip.compiled is not None,
            "code": None if chip.first_error is None else chip.first_error.code,
            "reason": None if chip.first_error is None else chip.first_error.message,
            "shortest_slot_us": chip.shortest_slot_us,
            "frame_us": chip.frame_us,
            "sent_bits_a_frame": chip.sent_bits,
            "sent_bits_per_us": chip.bits_per_us,
            "noise_dark_e": noise[0],
            "noise_half_well_e": noise[1],
        }
        for chip in chips
        for noise in [chip.noise_e or (None, None)]
    ]


def _time(us: float | None) -> str:
    """Return a length of time in microseconds as text: ? if unknown, "any" if 0."""
    return "?" if us is None else time_text(us) if us else "any"


def _noise(index: int) -> Callable[[OnChip], str]:
    """Return the function that shows the noise of a chip: in the dark (index 0) or at half a full
    well (1)."""
    return lambda chip: "?" if chip.noise_e is None else f"{chip.noise_e[index]:.3g} e"


def _sent(chip: OnChip) -> str:
    """Return the amount of data for each frame as text, "?" if unknown."""
    if chip.sent_bits is None:
        return "?"
    return f"{chip.sent_bits} bits" if chip.sent_bits else "nothing"


def _mean_rate(chip: OnChip) -> str:
    """Return the data rate of a chip while it receives data, and the mean over a frame, as text;
    what `_sent` says ("?" or "nothing") if it receives none."""
    if not chip.sent_bits:
        return _sent(chip)
    assert chip.bits_per_us is not None
    assert chip.frame_us is not None
    return f"{rate_text(chip.bits_per_us)}, mean {rate_text(chip.sent_bits / chip.frame_us)}"


_ROWS: dict[str, Callable[[OnChip], str]] = {
    "fits": lambda chip: "yes" if chip.compiled is not None else f"no, {chip.first_error.code}",  # type: ignore[union-attr]
    "pixels": lambda chip: f"{chip.target.rows} x {chip.target.cols}",
    "shortest slot": lambda chip: _time(chip.shortest_slot_us),
    "frame with readout": lambda chip: _time(chip.frame_us),
    "kept in the chip": lambda chip: chip.stored,
    "sent for a frame": _sent,
    "data rate": _mean_rate,
    "noise in the dark": _noise(0),
    "noise at half a well": _noise(1),
}
