"""Errors of unusable scenes, all with exit status 2."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np

from nscc.arrays import Array
from nscc.diagnostics.diagnostic import Diagnostic, Rejected, Severity, rejected

Path_or_name = Path | str
Warn = Callable[[Diagnostic], object]
"""A function that is called with messages about a scene."""


def unheard(_message: Diagnostic) -> None:
    """Ignore a message: the default of arguments of the type `Warn`."""


def damaged(name: Path_or_name, reason: object) -> Rejected:
    """Return the error NS0732 that the file or scene `name` cannot be decoded.

    `reason` is what its reader said, an exception or a text: the first 200 characters become a
    note, and an empty one none."""
    words = " ".join(str(reason).split())[:200]
    ending = Path(str(name)).suffix.lower()
    notes = (f"the reader says: {words}",) if words else ()
    return rejected(
        "NS0732",
        f"cannot read '{name}' as {f'a {ending} file' if ending else 'a scene'}",
        notes=notes,
        helps=("check that the file is complete and that its ending matches its format",),
    )


def unsupported(name: Path_or_name, reason: str, help_text: str) -> Rejected:
    """Return the error NS0732 that the intact file `name` is of a kind that is not decoded.
    `reason` says what it has and completes the message, `help_text` is the remedy."""
    return rejected("NS0732", f"cannot use '{name}': {reason}", helps=(help_text,))


def size(shape: Sequence[int]) -> str:
    """Return a size as text: `256 x 256` for (256, 256), "a single number" for ()."""
    return " x ".join(str(n) for n in shape) if len(shape) else "a single number"


def clamped(name: str, count: int, total: int, low: float) -> Diagnostic:
    """Return the warning NS0740 that `count` of the `total` pixels of the picture `name` were
    slightly below 0 and became 0; `low` is the lowest light, where white is 1."""
    return Diagnostic(
        "NS0740",
        f"{count} of {total} pixels of '{name}' were negative and were set to 0",
        severity=Severity.WARNING,
        notes=(f"the lowest is {low:.3g}; filters produce such small negative values",),
        helps=("you need to do nothing; to avoid this message, clip the picture at 0",),
        data={"count": count},
    )


_NOT_LIGHT = ("not a number (NaN)", "too large", "negative")


def refuse_no_light(values: Array, name: Path_or_name, corner: tuple[int, int] = (0, 0)) -> None:
    """Raise NS0736 if any of `values` is NaN, negative, or above float32's range, which counts as
    infinite. An empty array passes.

    `values` has the axes (.., rows, cols). `name` is the scene in messages. `corner` is the row and
    column in the file of the first row and column of `values`; the message counts from the file's
    corner."""
    if values.size == 0:
        return
    top = np.float64(np.finfo(np.float32).max)
    with np.errstate(invalid="ignore"):  # warnings of signalling NaN
        # A NaN makes both comparisons false, so it is counted below.
        if float(values.min()) >= 0.0 and float(values.max()) <= top:
            return
        if values.dtype.kind == "f" and values.dtype.itemsize < 8:
            values = values.astype(np.float64)  # `top` would be infinite in float16
    masks = np.isnan(values), np.abs(values) > top, (values < 0) & (values >= -top)
    counts = [int(np.count_nonzero(mask)) for mask in masks]
    first = np.argwhere(next(mask for mask in masks if mask.any()))[0]
    value = values[tuple(first)]
    first[-2:] += corner
    position = first.tolist()
    kinds = zip(counts, _NOT_LIGHT, strict=True)
    counted = ", ".join(f"{count} {kind}" for count, kind in kinds if count)
    total = sum(counts)
    axes = "[slot, row, column]" if len(position) == 3 else "[row, column]"
    raise rejected(
        "NS0736",
        f"{total} light value{'s' if total > 1 else ''} in '{name}' cannot be light: {counted}",
        notes=(
            f"the first of them is {value:g}, at {axes} = [{', '.join(map(str, position))}]",
            "light is a count of electrons: finite (below 3.4e38) and not negative",
        ),
        helps=("repair the array, for instance with np.nan_to_num and np.clip(a, 0, None)",),
        data={"count": total, "first": position},
    )
