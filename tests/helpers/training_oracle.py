"""What shutter classes mean, in plain Python loops, for tests of the trainer."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray


def shutters_of(
    kind: str, slots: int, codes: Mapping[str, NDArray[np.int64]], length: int | None = None
) -> NDArray[np.bool_]:
    """S (N, rows, cols) of codes on a tile; class a has no codes and one place."""
    shape = (1, 1) if not codes else next(v.shape for k, v in codes.items() if k != "book")
    found = np.zeros((slots, *shape), bool)
    for row in range(shape[0]):
        for col in range(shape[1]):
            code = {k: int(v[row, col]) for k, v in codes.items() if k != "book"}
            for n in range(slots):
                found[n, row, col] = {
                    "a": lambda c, n: True,
                    "b": lambda c, n: n < c["stop"],
                    "c": lambda c, n: c["start"] <= n < c["start"] + int(length or 0),
                    "d": lambda c, n: c["start"] <= n < c["stop"],
                    "e": lambda c, n: bool(c["bits"] >> n & 1),
                    "codebook": lambda c, n: bool(codes["book"][c["id"], n]),
                }[kind](code, n)
    return found


def small_target(text: str, rows: int, cols: int) -> str:
    """A target file (as `nscc targets --toml` prints it) with another array."""
    lines = []
    for line in text.splitlines():
        key = line.partition("=")[0].strip()
        size = {"rows": rows, "cols": cols}.get(key)
        lines.append(f"{key} = {size}" if size is not None else line)
    return "\n".join(lines) + "\n"
