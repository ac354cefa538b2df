"""Moves of a search: changes of a tile's codes at many pixels together."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from nscc.arrays import Bools, Ints
from nscc_training.code_choices import ARRANGE, bits_of, opened_by_bits
from nscc_training.encoders.base import Codes, Encoder, ShutterSpec

Generator = np.random.Generator
Where = Bools

_PERIODS = (1, 2, 4, 8)
"""Sides of blocks, and distances of pixels that change together."""
MOST_AT_ONCE = 4
"""Most moves that a candidate combines."""
SINGLE_SHARE = 0.5
"""Probability that only the shutter of one pixel changes."""
_REPEATED = 0.25
"""Probability that a move of many pixels starts by copying one block over the whole tile."""


def candidate(
    encoder: Encoder, codes: Codes, generator: Generator, single_share: float = SINGLE_SHARE
) -> Codes:
    """Return other codes near `codes`, which stay unchanged, in the form of `Encoder.codes`.

    With the encoder's relaxation `arrange`, one to four pairs of places exchange their codes, four
    if `single_share` is 0. With the others, the codes are `moved`."""
    if encoder.relaxation != ARRANGE:
        return moved(encoder.spec, codes, generator, single_share)
    exchanges = int(generator.integers(1, MOST_AT_ONCE + 1)) if single_share else MOST_AT_ONCE
    return arranged(encoder.spec, codes, generator, exchanges)


def moved(
    spec: ShutterSpec, codes: Codes, generator: Generator, single_share: float = SINGLE_SHARE
) -> Codes:
    """Return codes after one to four random moves, in the form of `Encoder.codes`; `codes` stay
    unchanged.

    With the probability `single_share`, the shutter of a single pixel changes instead. Codes of a
    codebook include `book`. A move changes one pixel, a rectangle, all pixels at a period in each
    direction, or every other block. Their shutters shift in time, lengthen, shorten, or take or
    exchange the codes of pixels at a random offset. Before that, the tile may become copies of one
    of its blocks, each later than the one before. Codes stay legal for the class; a move may have
    no effect."""
    if generator.random() < single_share:
        place = np.zeros(spec.tile, bool)
        place.flat[generator.integers(place.size)] = True
        return MOVING[spec.kind](spec, codes, place, generator)
    changed_codes = repeated(spec, codes, generator) if generator.random() < _REPEATED else codes
    for _ in range(int(generator.integers(1, MOST_AT_ONCE + 1))):
        places = _somewhere(spec.tile, generator)
        kind = generator.random()
        # Half of the changes move codes. A quarter exchange codes with other pixels, a quarter copy
        # them.
        if kind < 0.5:
            changed_codes = MOVING[spec.kind](spec, changed_codes, places, generator)
        else:
            changed_codes = _from_beside(changed_codes, places, generator, exchange=kind < 0.75)
    return changed_codes


def arranged(spec: ShutterSpec, codes: Codes, generator: Generator, exchanges: int) -> Codes:
    """Return codes after this number of exchanges, each between two random places of the tile. No
    place gets another shutter than one of the tile; the rows of a codebook (`book`) stay."""
    order = np.arange(spec.places)
    for pair in generator.integers(spec.places, size=(exchanges, 2)):
        order[pair] = order[pair[::-1]]
    order = order.reshape(spec.tile)
    return codes | {name: np.take(codes[name], order) for name in codes if name != "book"}


def _somewhere(tile: tuple[int, int], generator: Generator) -> Where:
    """Return a random mask (rows, cols) of the pixels of a tile that change together: one pixel, a
    rectangle that may cross the edge, a grid, or every other block. On a small tile, a grid or
    blocks may have no pixel."""
    y, x = np.mgrid[: tile[0], : tile[1]]
    kind = generator.integers(4)
    if kind == 0:
        row, col = (generator.integers(side) for side in tile)
        return np.asarray((y == row) & (x == col))
    if kind == 1:
        high, wide = (generator.integers(1, side, endpoint=True) for side in tile)
        row, col = (generator.integers(side) for side in tile)
        return np.asarray(((y - row) % tile[0] < high) & ((x - col) % tile[1] < wide))
    down, across = generator.choice(_PERIODS, 2)
    if kind == 2:
        return np.asarray(
            (y % down == generator.integers(down)) & (x % across == generator.integers(across))
        )
    return np.asarray((y // down + x // across) % 2 == generator.integers(2))


def _from_beside(codes: Codes, places: Where, generator: Generator, *, exchange: bool) -> Codes:
    """Return codes in which the pixels `places` take the codes of pixels at a random offset. With
    `exchange`, those pixels, unless they are in `places` too, take the former codes in return. The
    tile wraps around; the rows of a codebook (`book`) stay."""
    # Up to two pixels down or up, and right or left.
    step = tuple(int(value) for value in generator.integers(-2, 3, 2))
    back = (-step[0], -step[1])
    exchanged = np.roll(places, step, axis=(0, 1)) & ~places
    changed_codes = dict(codes)
    for name, values in codes.items():
        if name == "book":
            continue
        changed = np.where(places, np.roll(values, back, axis=(0, 1)), values)
        if exchange:
            changed = np.where(exchanged, np.roll(values, step, axis=(0, 1)), changed)
        changed_codes[name] = changed
    return changed_codes


def repeated(spec: ShutterSpec, codes: Codes, generator: Generator) -> Codes:
    """Return the codes of a tile of copies of one of its blocks, each later than those above and to
    the left, by random steps. `codes` stay unchanged.

    Such regular codes are too far from others for small moves to reach them."""
    high, wide = (int(generator.choice([p for p in _PERIODS if p <= side])) for side in spec.tile)
    first_row, first_col = (int(generator.integers(side)) for side in spec.tile)
    down, right = (int(value) for value in generator.integers(0, spec.slots, 2))
    y, x = np.mgrid[: spec.tile[0], : spec.tile[1]]
    source = (first_row + y % high) % spec.tile[0], (first_col + x % wide) % spec.tile[1]
    block_codes = {
        name: values if name == "book" else values[source] for name, values in codes.items()
    }
    return _LATER[spec.kind](spec, block_codes, down * (y // high) + right * (x // wide))


def _by(slots: int, generator: Generator) -> int:
    """Return a random number of slots to move by, positive or negative: at least one, at most half
    a frame, uniform in the logarithm."""
    most = max(1, slots // 2)
    return int(generator.choice((-1, 1)) * np.rint(most ** generator.random()))


def _stops(spec: ShutterSpec, codes: Codes, places: Where, generator: Generator) -> Codes:
    """Return codes of class b in which the exposure times of the pixels `places` are multiplied by
    one random ratio, and changed by at least one slot."""
    stop = codes["stop"]
    # Longer or shorter by 7 % to a factor of 4.
    ratio = 2.0 ** (generator.choice((-1, 1)) * generator.uniform(0.1, 2))
    stops = np.rint(stop * ratio)
    stops = np.where(stops == stop, stop + np.sign(ratio - 1), stops)
    return {"stop": _clipped(np.where(places, stops, stop), 1, spec.slots)}


def _starts(spec: ShutterSpec, codes: Codes, places: Where, generator: Generator) -> Codes:
    """Return codes of class c in which the bumps of the pixels `places` are shifted by one random
    number of slots."""
    assert spec.length is not None
    start = codes["start"] + places * _by(spec.slots, generator)
    return {"start": _clipped(start, 0, spec.slots - spec.length)}


def _edges(spec: ShutterSpec, codes: Codes, places: Where, generator: Generator) -> Codes:
    """Return codes of class d in which the start, the stop or both of the pixels `places` are
    shifted by one random number of slots, as far as the bump stays within the frame and open for a
    slot."""
    start, stop = codes["start"], codes["stop"]
    by = places * _by(spec.slots, generator)
    kind = generator.integers(3)
    if kind == 0:
        by = np.clip(by, -start, spec.slots - stop)
        start, stop = start + by, stop + by
    elif kind == 1:
        start = np.clip(start + by, 0, stop - 1)
    else:
        stop = np.clip(stop + by, start + 1, spec.slots)
    return {"start": np.asarray(start, np.int64), "stop": np.asarray(stop, np.int64)}


def _bits(spec: ShutterSpec, codes: Codes, places: Where, generator: Generator) -> Codes:
    """Return codes of class e in which the shutters of the pixels `places` are changed by
    `_reshaped`."""
    opened = _reshaped(opened_by_bits(codes["bits"], spec.slots), generator)
    return {"bits": np.where(places, bits_of(opened), codes["bits"])}


def _rows(spec: ShutterSpec, codes: Codes, places: Where, generator: Generator) -> Codes:
    """Return codes of a codebook after one random change. The pixels `places` take one row, a row
    itself changes, or all rows become copies of one that are shifted in time, evenly over the
    frame."""
    book = codes["book"]
    row, kind = int(generator.integers(len(book))), generator.random()
    # Of ten changes, one makes all rows shifted copies; the others change pixels or a row, equally
    # often.
    if kind < 0.45:
        return {"id": np.where(places, row, codes["id"]), "book": book}
    if kind > 0.9:
        moments = np.arange(len(book)) * spec.slots // len(book)
        return {"id": codes["id"], "book": np.stack([np.roll(book[row], k) for k in moments])}
    book = book.copy()
    book[row] = _reshaped(book[row].reshape(-1, 1, 1) == 1, generator)[:, 0, 0]
    return {"id": codes["id"], "book": book}


def _reshaped(opened: Bools, generator: Generator) -> Bools:
    """Return shutters (N, rows, cols) that are all changed in the same random way: shifted in time,
    lengthened or shortened by a slot, or with one slot flipped.

    A shutter that would never open stays as it is."""
    kind = generator.integers(4)
    beside = np.roll(opened, int(generator.choice((-1, 1))), axis=0)
    if kind == 0:
        reshaped = np.roll(opened, _by(len(opened), generator), axis=0)
    elif kind == 1:
        reshaped = opened | beside
    elif kind == 2:
        reshaped = opened & beside
    else:
        reshaped = opened.copy()
        reshaped[generator.integers(len(opened))] ^= True
    return np.asarray(np.where(reshaped.any(axis=0), reshaped, opened))


def _shorter(spec: ShutterSpec, codes: Codes, lag: Ints) -> Codes:
    """Return codes of class b whose exposure times are halved `lag` (rows, cols) times; after one
    slot, the longest exposure follows."""
    octaves = np.log2(spec.slots)
    stops = 2.0 ** ((np.log2(codes["stop"]) - lag) % (octaves + 1))
    return {"stop": _clipped(np.rint(stops), 1, spec.slots)}


def _starts_later(spec: ShutterSpec, codes: Codes, lag: Ints) -> Codes:
    """Return codes of class c whose bumps are shifted by `lag` (rows, cols) slots, around the range
    of legal starts."""
    assert spec.length is not None
    return {"start": (codes["start"] + lag) % (spec.slots - spec.length + 1)}


def _edges_later(spec: ShutterSpec, codes: Codes, lag: Ints) -> Codes:
    """Return codes of class d whose bumps are shifted by `lag` (rows, cols) slots, around the
    frame. A bump that crosses the end of the frame is cut there."""
    # Starts wrap from the last slot to -`before`, so that a bump is cut at either end of the frame.
    before = codes["stop"] - codes["start"] - 1
    start = (codes["start"] + before + lag) % (spec.slots + before) - before
    stop = start + before + 1
    return {"start": _clipped(start, 0, spec.slots), "stop": _clipped(stop, 0, spec.slots)}


def _bits_later(spec: ShutterSpec, codes: Codes, lag: Ints) -> Codes:
    """Return codes of class e whose shutters are shifted by `lag` (rows, cols) slots, around the
    frame."""
    lag = lag % spec.slots
    bits, all_bits = codes["bits"], (1 << spec.slots) - 1
    return {"bits": (bits << lag & all_bits) | bits >> (spec.slots - lag)}


def _rows_later(_spec: ShutterSpec, codes: Codes, lag: Ints) -> Codes:
    """Return codes of a codebook in which each pixel uses the row that follows its own by `lag`
    (rows, cols). The rows stay."""
    return {"id": (codes["id"] + lag) % len(codes["book"]), "book": codes["book"]}


def _clipped(values: NDArray[np.number], low: int, high: int) -> Ints:
    """Return `values` limited to `low` and `high`, as int64. Fractions are cut off, so the caller
    rounds."""
    return np.asarray(np.clip(values, low, high), np.int64)


MOVING: dict[str, Callable[[ShutterSpec, Codes, Where, Generator], Codes]] = {
    "b": _stops,
    "c": _starts,
    "d": _edges,
    "e": _bits,
    "codebook": _rows,
}
"""The function that changes shutters at some pixels, by class."""

_LATER: dict[str, Callable[[ShutterSpec, Codes, Ints], Codes]] = {
    "b": _shorter,
    "c": _starts_later,
    "d": _edges_later,
    "e": _bits_later,
    "codebook": _rows_later,
}
"""The function that shifts shutters around the frame, by class; for stills it shortens
exposures."""
