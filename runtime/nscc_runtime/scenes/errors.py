"""Errors of unusable scenes, all with exit status 2."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.diagnostics.diagnostic import Diagnostic, Rejected, Severity
from nscc.diagnostics.rejection import rejected

Path_or_name = Path | str


def damaged(name: Path_or_name, reason: object, *, helps: Sequence[str] = ()) -> Rejected:
    """Return the error NS0732 for an undecodable file; `reason` is the text of its reader."""
    words = " ".join(str(reason).split())[:200]
    ending = Path(str(name)).suffix.lower()
    notes = (f"the reader says: {words}",) if words else ()
    return rejected(
        "NS0732",
        f"cannot read '{name}' as {f'a {ending} file' if ending else 'a scene'}",
        notes=notes,
        helps=helps or ("check that the file is complete and that its ending matches its format",),
    )


def unsupported(name: Path_or_name, reason: str, help_text: str) -> Rejected:
    """Return the error NS0732 for an intact file of a kind that is not decoded."""
    return rejected("NS0732", f"cannot use '{name}': {reason}", helps=(help_text,))


def size(shape: Sequence[int]) -> str:
    """Return a size as text: `256 x 256` for (256, 256)."""
    return " x ".join(str(n) for n in shape) if len(shape) else "a single number"


def clamped(name: str, count: int, total: int, low: float) -> Diagnostic:
    """Return the warning NS0740 for `count` pixels of a picture slightly below 0."""
    return Diagnostic(
        "NS0740",
        f"{count} of {total} pixels of '{name}' were negative and were set to 0",
        severity=Severity.WARNING,
        notes=(f"the lowest is {low:.3g}; filters produce such small negative values",),
        helps=("you need to do nothing; to avoid this message, clip the picture at 0",),
        data={"count": count},
    )


_NOT_LIGHT = {"NaN": "not a number (NaN)", "infinite": "too large", "negative": "negative"}


class Census:
    """Counts invalid light values, block by block, and stores the first place of each kind."""

    def __init__(self) -> None:
        self.counts = dict.fromkeys(_NOT_LIGHT, 0)
        self.first: dict[str, tuple[tuple[int, ...], float]] = {}

    def look(self, block: NDArray[Any], start: int = 0) -> None:
        """Count the invalid values of `block`, whose first axis begins at `start` (a 2-D block at
        0). Values above float32's range count as infinite."""
        if block.size == 0:
            return
        top = np.float64(np.finfo(np.float32).max)
        with np.errstate(invalid="ignore"):  # warnings of signalling NaN
            low, high = float(block.min()), float(block.max())
            if low >= 0.0 and high <= top:
                return
            if block.dtype.kind == "f" and block.dtype.itemsize < 8:
                block = block.astype(np.float64)  # `top` would be infinite in float16
        for kind, mask in (
            ("NaN", np.isnan(block)),
            ("infinite", np.abs(block) > top),
            ("negative", (block < 0) & (block >= -top)),
        ):
            self.counts[kind] += int(np.count_nonzero(mask))
            if self.counts[kind] and kind not in self.first:
                row, *place = (int(i) for i in np.argwhere(mask)[0])
                self.first[kind] = (row + start, *place), float(block[(row, *place)])

    def reject(self, name: Path_or_name, corner: tuple[int, int] = (0, 0)) -> None:
        """Raise NS0736 if any value was invalid. `corner`: position of the values in the file."""
        kinds = [kind for kind, count in self.counts.items() if count]
        if not kinds:
            return
        place, value = self.first[kinds[0]]
        place = (*place[:-2], *(at + start for at, start in zip(place[-2:], corner, strict=True)))
        counted = ", ".join(f"{self.counts[kind]} {_NOT_LIGHT[kind]}" for kind in kinds)
        total = sum(self.counts.values())
        axes = "[slot, row, column]" if len(place) == 3 else "[row, column]"
        raise rejected(
            "NS0736",
            f"{total} light value{'s' if total > 1 else ''} in '{name}' cannot be light: {counted}",
            notes=(
                f"the first of them is {value:g}, at {axes} = [{', '.join(map(str, place))}]",
                "light is a count of electrons: finite (below 3.4e38) and not negative",
            ),
            helps=("repair the array, for instance with np.nan_to_num and np.clip(a, 0, None)",),
            data={"count": total, "first": list(place)},
        )


def refuse_no_light(
    values: NDArray[Any], name: Path_or_name, corner: tuple[int, int] = (0, 0)
) -> None:
    """Raise NS0736 if any value is not light. `corner`: position of the values in the file."""
    census = Census()
    census.look(values)
    census.reject(name, corner)
