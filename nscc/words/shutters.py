"""The distinct shutters of a container for display, sorted and labelled."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from nscc.arrays import Bools, Ints
from nscc.words.container import Container

_LONGEST_LABEL = 30
"""Most characters of a label."""


@dataclass(frozen=True, eq=False)
class Shutters:
    """The shutters of a figure, in order.

    `rows` bool (rows, buckets, N) are the shutters, each with an entry of `labels`. `rank` int64
    (shutters of the decode table,) is the row of each shutter, -1 if no pixel has it."""

    rows: Bools
    labels: tuple[str, ...]
    rank: Ints


def shutters_of(container: Container) -> Shutters:
    """Return the shutters that pixels have (all that codes have if there are no pixel codes),
    sorted by their first open slot, then by open time.

    A shutter that never opens comes last. The first open slot is that of any bucket; the open time
    is that of the first bucket."""
    table = container.table
    codes = container.pixel_codes
    used_codes = np.arange(len(table.codes)) if codes is None else np.unique(codes)
    used = np.unique(table.shutter_of_code[used_codes])
    patterns = table.shutters[used]
    slots = patterns.shape[2]
    union: Bools = np.any(patterns, axis=1)
    first = np.where(np.any(union, axis=1), np.argmax(union, axis=1), slots)
    # By first open slot of any bucket, then by the open time of the first bucket.
    order = np.lexsort((used, (patterns[:, 0] @ np.array(container.slot_us)), first))
    rank = np.full(len(table.shutters), -1, np.int64)
    rank[used[order]] = np.arange(len(used))
    codes_by_rank: list[list[int]] = [[] for _ in used]
    for code in used_codes:
        codes_by_rank[rank[table.shutter_of_code[code]]].append(int(code))
    labels = tuple(_label(container, alike) for alike in codes_by_rank)
    return Shutters(patterns[order], labels, rank)


def _label(container: Container, codes: list[int]) -> str:
    """Return the label of a shutter: the fields of its first code, and how many other codes it has.

    `codes` are rows of the decode table, at least one. A program without fields gives "all pixels".
    """
    fields = container.table.fields
    if not fields:
        return "all pixels"
    values = container.table.codes[codes[0]]
    text = ", ".join(f"{name} {value}" for name, value in zip(fields, values, strict=True))
    text = text if len(text) <= _LONGEST_LABEL else text[: _LONGEST_LABEL - 1] + "…"
    return text if len(codes) == 1 else f"{text}  (+{len(codes) - 1})"
