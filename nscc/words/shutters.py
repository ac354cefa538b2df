"""The distinct shutters of a container as people look at them: in order, with names."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nscc.words.container import Container

_LONGEST_LABEL = 30


@dataclass(frozen=True, eq=False)
class Shutters:
    """The shutters that a picture shows, in the order in which it shows them.

    `rows` bool (rows, buckets, N); `labels` one a row; `rank` int (shutters of the table,), the
    place of each in the order, -1 for those that no pixel has.
    """

    rows: NDArray[np.bool_]
    labels: tuple[str, ...]
    rank: NDArray[np.int64]


def shutters_of(container: Container) -> Shutters:
    """The distinct shutters in use (all of a program without pixels), by opening and length."""
    table = container.table
    codes = container.pixel_codes
    used_codes = np.arange(len(table.codes)) if codes is None else np.unique(codes)
    used = np.unique(table.shutter_of_code[used_codes])
    patterns = table.shutters[used]
    slots = patterns.shape[2]
    union: NDArray[np.bool_] = np.any(patterns, axis=1)
    first = np.where(np.any(union, axis=1), np.argmax(union, axis=1), slots)
    order = np.lexsort((used, (patterns[:, 0] @ np.array(container.slot_us)), first))
    rank = np.full(len(table.shutters), -1, np.int64)
    rank[used[order]] = np.arange(len(used))
    codes_by_rank: list[list[int]] = [[] for _ in used]
    for code in used_codes:
        codes_by_rank[rank[table.shutter_of_code[code]]].append(int(code))
    labels = tuple(_label(container, alike) for alike in codes_by_rank)
    return Shutters(patterns[order], labels, rank)


def _label(container: Container, codes: list[int]) -> str:
    """The first code of a shutter in words, and how many more mean the same."""
    fields = container.table.fields
    if not fields:
        return "all pixels"
    values = container.table.codes[codes[0]]
    text = ", ".join(f"{name} {value}" for name, value in zip(fields, values, strict=True))
    text = text if len(text) <= _LONGEST_LABEL else text[: _LONGEST_LABEL - 1] + "…"
    return text if len(codes) == 1 else f"{text}  (+{len(codes) - 1})"
