"""Variants of a program with other slot lengths, or with fewer, longer slots."""

from __future__ import annotations

from collections.abc import Sequence
from decimal import Decimal

import numpy as np

from nscc.arrays import Ints32
from nscc.limits.families import MOST_DIGITS, book_text
from nscc.pipeline import KINDS
from nscc.source import Source
from nscc.syntax.parse import parse
from nscc.syntax.tree import EqualSlots, ListedSlots
from nscc.words.container import Container
from nscc_training.experiments.study import NotMeasured


def with_slot_us(source: Source, slot_us: Sequence[float]) -> Source:
    """Return the program `source` in which the first frame statement is replaced: its slots have
    the lengths `slot_us` in microseconds, whose number may differ from before. Raise ValueError if
    its text has no frame statement."""
    tree, _ = parse(source)
    spans = [s.span for s in tree.statements if isinstance(s, EqualSlots | ListedSlots)]
    if not spans:
        raise ValueError(f"{source.name} has no frame")
    times = [f"{Decimal(repr(float(us))):f}us" for us in slot_us]
    frame = f"frame {len(times)} slots of {times[0]}"
    if len(set(times)) > 1:
        frame = f"frame slots [{', '.join(times)}]"
    text = source.text
    return Source(source.name, text[: spans[0].start] + frame + text[spans[0].end :])


def in_fewer(container: Container, join: int, source: Source) -> tuple[Source, dict[str, Ints32]]:
    """Return a program in which each slot joins `join` successive slots of a program, and the codes
    of its pixels: `id`, int32 (rows, cols).

    `container` is the compiled program and `source` its text, which gives the name. A joined slot
    is open if the pixel is open for at least half of its time. Raises NotMeasured if the slots
    cannot be joined, pixels have no codes, or there are too many shutters for a codebook."""
    codes, slots = container.pixel_codes, container.slots
    if codes is None or not KINDS.of(container).shutters_known:
        raise NotMeasured("programs with pixels that look keep their own slots")
    if slots % join:
        raise NotMeasured(f"{slots} slots are not a multiple of {join}")
    if slots // join < 2:
        raise NotMeasured(f"fewer than 2 of {slots} slots would remain")
    slot_us = np.array(container.slot_us).reshape(-1, join)
    used, row = np.unique(container.table.shutter_of_code[codes], return_inverse=True)
    opened = container.table.shutters[used].reshape(len(used), -1, *slot_us.shape)
    share = (opened * slot_us).sum(axis=3) / slot_us.sum(axis=1)
    rows, same = np.unique(share >= 0.5, axis=0, return_inverse=True)
    if rows.size > MOST_DIGITS:
        raise NotMeasured(
            f"{len(rows)} shutters are a codebook of {rows.size} digits, more than {MOST_DIGITS}"
        )
    if (rows.sum(axis=1) > 1).any():
        raise NotMeasured("two buckets would be open in one slot, each for half of it")
    text = book_text(slot_us.sum(axis=1).tolist(), container.buckets, rows)
    ids = same.reshape(-1)[row].reshape(codes.shape).astype(np.int32)
    return Source(source.name, text), {"id": ids}
