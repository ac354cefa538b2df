"""Construction of encoders by class name, and ordered and scattered starts of their codes."""

from __future__ import annotations

from math import inf

import numpy as np

from nscc.arrays import Bools, Floats, Ints
from nscc.diagnostics.arguments import require_type
from nscc.toml.arguments import argument
from nscc.toml.kinds import Integer
from nscc_training.code_choices import (
    LOOKS,
    ORDERED,
    RANKS,
    SCATTERED,
    SLOPED,
    STARTS,
    YARDSTICKS,
    bits_of,
)
from nscc_training.encoders.base import Codes, Encoder, ShutterSpec
from nscc_training.encoders.bumps import AlwaysOpen, Bump, Start, StartStop, Stop
from nscc_training.encoders.looks_encoder import LooksEncoder
from nscc_training.encoders.patterns import Bits, Codebook

_SIXTEENTHS = {"rows": 8, "checker": 8, "overlapping-rows": 11}
"""Length of the bumps of a start in sixteenths of the frame; 4 for the others."""
_SIDE = 4
"""Rows and columns of the repeating tile."""


_KINDS = ("c", "d", "e", "codebook")
"""Classes whose bumps may begin in any slot."""


def ordered(name: str, spec: ShutterSpec) -> Codes:
    """Return the codes of a tile for the start `name`, one of ORDERED or YARDSTICKS.

    A pixel measures the light of its bump, and its neighbours the light of other bumps. The 2 x 2
    pattern has edges at three times within the frame; these tiles have edges at more times.

    Bumps have the length of the class, or a quarter of the frame. For a codebook, the item `book`
    contains the shapes. Raises ValueError for classes and tiles without such a start.

    `two-phase`: the 2 x 2 pattern, with every other 2 x 2 block later by half a bump, or by as much
    as the frame allows. `staggered`: sixteen start times from the beginning of the frame to the
    last at which a bump fits. `cyclic`: sixteen start times around the frame; a bump that reaches
    the end continues at the beginning. `rows`: every other row opens in the second half of the
    frame. `checker`: every other pixel does. `overlapping-rows`: as `rows`, with bumps of 11/16 of
    the frame."""
    if spec.kind not in _KINDS:
        raise ValueError(f"the start {name} has bumps for clips: use class {', '.join(_KINDS)}")
    period = 2 if name in YARDSTICKS else _SIDE
    if any(side % period for side in spec.tile):
        raise ValueError(
            f"the start {name} repeats every {period} x {period} places: the tile must be a "
            f"multiple of that, but is {spec.tile[0]} x {spec.tile[1]}"
        )
    if name == "cyclic" and spec.kind in "cd":
        raise ValueError(
            f"bumps of class {spec.kind} end with the frame, but those of the start cyclic "
            "continue at its start: use class e or a codebook of 16 rows"
        )
    # In sixteenths of the frame, rounded up: 4 unless the start names another number.
    length = spec.length or -(-spec.slots * _SIXTEENTHS.get(name, 4) // 16)
    first = _first(name, spec, length)
    if spec.kind == "c":
        return {"start": first}
    if spec.kind == "d":
        return {"start": first, "stop": first + length}
    if spec.kind == "e":
        return {"bits": bits_of(_opened(spec, first, length))}
    return _shapes(spec, first, length)


def _first(name: str, spec: ShutterSpec, length: int) -> Ints:
    """Return the slot in which each pixel of the tile opens, int64 (rows, cols), in the start
    `name`. Bumps have `length` slots, at most the number of slots of `spec`; only those of "cyclic"
    may reach beyond the end of the frame."""
    y, x = np.mgrid[: spec.tile[0], : spec.tile[1]]
    last = spec.slots - length
    if name in YARDSTICKS:
        first = (y + x if name == "checker" else y) % 2 * last
    elif name == "two-phase":
        late = (y // 2 + x // 2) % 2 * (length // 2)
        first = np.minimum(np.rint((y % 2 * 2 + x % 2) * (last / 3)) + late, last)
    else:
        rank = RANKS[y % _SIDE, x % _SIDE]
        around = name == "cyclic"
        first = rank * (spec.slots / RANKS.size if around else last / (RANKS.size - 1))
        first = np.floor(first + 0.5)
    return np.asarray(first, np.int64)


def _opened(spec: ShutterSpec, first: Ints, length: int) -> Bools:
    """Return the shutters (N, rows, cols) of bumps that open in the slots `first` for `length`
    slots. A bump that reaches the end of the frame continues at its start."""
    n = np.arange(spec.slots).reshape(-1, 1, 1)
    return np.asarray((n - first) % spec.slots < length)


def _shapes(spec: ShutterSpec, first: Ints, length: int) -> Codes:
    """Return a codebook `book` (K, N) of bumps that open in the slots `first` (rows, cols), and the
    row `id` of each pixel.

    Raises ValueError if the codebook has fewer rows than there are different bumps."""
    begins, row_of_place = np.unique(first, return_inverse=True)
    if spec.rows is None or len(begins) > spec.rows:
        raise ValueError(
            f"its {len(begins)} shutters do not fit into the codebook's {spec.rows} rows: add rows"
        )
    # Unused rows of the codebook repeat used ones.
    begins = np.resize(begins, spec.rows)
    book = _opened(spec, begins[:, None], length)[..., 0].T
    return {"id": row_of_place.reshape(spec.tile), "book": book.astype(np.int64)}


CLASSES: dict[str, type[Encoder]] = {
    "a": AlwaysOpen,
    "b": Stop,
    "c": Start,
    "d": StartStop,
    "e": Bits,
    "codebook": Codebook,
    LOOKS: LooksEncoder,
}

_MOST_LEVELS = 16
"""Most exposure times that are scattered individually; with more, powers of two are used."""


def make_encoder(
    spec: ShutterSpec, start: str = "random", seed: int = 0, relaxation: str = "straight-through"
) -> Encoder:
    """Make an encoder of the class that `spec` names.

    Parameters
    ----------
    spec : ShutterSpec
    start : str
        The initial codes, one of `nscc_training.code_choices.STARTS`: "random", "uniform" (equal
        at all pixels), "quad" (a 2 x 2 pattern), or a published pattern.
    seed : int
        Seed of random starts; others ignore it.
    relaxation : str
        How codes are learned: one of `nscc_training.code_choices.RELAXATIONS`.

    Returns
    -------
    Encoder

    Raises
    ------
    ValueError
        For a start or a relaxation that the class does not support, and for invalid numbers.
    """
    require_type("make_encoder", "spec", spec, ShutterSpec, "ShutterSpec('b', 8, (2, 2))")
    if spec.kind not in CLASSES:
        raise ValueError(f"unknown class {spec.kind!r}: the classes are {', '.join(CLASSES)}")
    argument("ShutterSpec", "slots", Integer(1, inf), spec.slots)
    argument("ShutterSpec", "buckets", Integer(1, 2), spec.buckets)
    pair = isinstance(spec.tile, tuple | list) and len(spec.tile) == 2
    for side in spec.tile if pair else (str(spec.tile),):
        argument("ShutterSpec", "each of the two sides of the tile", Integer(1, inf), side)
    encoder = CLASSES[spec.kind](spec, relaxation)
    if relaxation not in SLOPED and spec.kind == "a":
        raise ValueError("class a is always open and has no parameters to try")
    if relaxation not in (*SLOPED, "tried") and spec.kind == LOOKS:
        raise ValueError("a search changes the codes of places, but pixels that look have levels")
    if start not in STARTS:
        raise ValueError(f"unknown start {start!r}: the starts are {', '.join(STARTS)}")
    if start in SCATTERED:
        _scatter(encoder, start, np.random.default_rng(seed))
    elif start in (*ORDERED, *YARDSTICKS):
        encoder.load_codes(ordered(start, spec))
    elif start == "random":
        encoder.start_random(np.random.default_rng(seed))
    else:
        (encoder.start_quad if start == "quad" else encoder.start_uniform)()
    return encoder


def _scatter(encoder: Encoder, start: str, generator: np.random.Generator) -> None:
    """Set the codes of an encoder so that equal exposure times are far apart in the tile.

    `start` names the pattern, one of SCATTERED. If the class has more than `_MOST_LEVELS` values,
    only values at distances 0, 1, 3, 7, .. from the lowest are used. Raises ValueError unless the
    codes are of class b or c."""
    if not isinstance(encoder, Bump) or len(encoder.limits) != 1:
        raise ValueError(
            f"the start {start} needs codes with one field: only classes b and c have them"
        )
    ((name, (low, high)),) = encoder.limits.items()
    levels = np.arange(low, high + 1)
    if len(levels) > _MOST_LEVELS:
        doubling = low + 2 ** np.arange(int(np.log2(high - low + 1)) + 1) - 1
        levels = np.unique(np.minimum(doubling, high))
    encoder.load_codes({name: scattered(start, levels, encoder.spec.tile, generator)})


def scattered(
    name: str, levels: Ints, tile: tuple[int, int], generator: np.random.Generator
) -> Ints:
    """Return one of `levels` (values,) for each pixel of a tile (rows, cols), so that equal values
    are apart. `name` is one of SCATTERED (another raises KeyError). There is at least one level.

    The patterns are those of L-SVPE (Nguyen, Martel and Wetzstein, "Learning Spatially Varying
    Pixel Exposures for Motion Deblurring", ICCP 2022). Tiles repeat, so neighbourhoods wrap around
    edges."""
    pattern = {"poisson-disc": _poisson_disc, "non-adjacent": _non_adjacent}[name]
    chosen: Ints = levels[pattern(len(levels), tile, generator)]
    return chosen


def _poisson_disc(count: int, tile: tuple[int, int], generator: np.random.Generator) -> Ints:
    """Return the index of a level, 0 to `count` - 1, for each pixel of a tile (rows, cols); pixels
    of one level keep a distance from each other.

    Each level in turn takes its share of free pixels, nearest to the points of a Poisson-disc
    sampler. Each remaining pixel gets the level whose own pixels are farthest away; a level without
    pixels is infinitely far."""
    from scipy.stats.qmc import PoissonDisk

    rows, cols = tile
    chosen = np.full(tile, -1, np.int64)
    y, x = np.mgrid[:rows, :cols]
    share = -(-rows * cols // count)
    for level in generator.permutation(count).tolist():
        # Discs of half that radius around `share` points cover about 70 % of the tile.
        sampler = PoissonDisk(d=2, radius=min(0.95 / share**0.5, 1.0), rng=generator)
        for down, across in sampler.random(share) * tile:
            away = np.hypot(_around(y + 0.5 - down, rows), _around(x + 0.5 - across, cols))
            away[chosen >= 0] = np.inf
            if away.min() <= 1.0:
                chosen[np.unravel_index(int(away.argmin()), tile)] = level
    for row, col in np.argwhere(chosen < 0).tolist():
        away = np.hypot(_around(y - row, rows), _around(x - col, cols))
        distances = [away[chosen == level].min(initial=np.inf) for level in range(count)]
        chosen[row, col] = int(np.argmax(distances))
    return chosen


def _non_adjacent(count: int, tile: tuple[int, int], generator: np.random.Generator) -> Ints:
    """Return a random index of a level, 0 to `count` - 1, for each pixel of a tile (rows, cols).

    In random order, each pixel gets one of the levels that are least frequent among its eight
    neighbours: if possible, none of them has it."""
    rows, cols = tile
    chosen = np.full(tile, -1, np.int64)
    for row, col in generator.permutation(np.argwhere(chosen < 0)).tolist():
        around = [
            chosen[(row + down) % rows, (col + across) % cols]
            for down in (-1, 0, 1)
            for across in (-1, 0, 1)
        ]
        times = np.bincount([level for level in around if level >= 0], minlength=count)
        chosen[row, col] = generator.choice(np.flatnonzero(times == times.min()))
    return chosen


def _around(distance: Floats, length: int) -> Floats:
    """Return the distances along an axis of `length` pixels that wraps around: at most half of
    `length`."""
    away = np.abs(distance) % length
    return np.asarray(np.minimum(away, length - away))
