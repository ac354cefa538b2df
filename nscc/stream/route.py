"""The route of light on a chip without logic, for every pixel and slot.

A bit chooses between two destinations, which are the same for all pixels in a slot. A program that
needs more destinations does not fit."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nscc.chips.target import Target
from nscc.words.stream import DRAIN


@dataclass(frozen=True, eq=False)
class Route:
    """The two destinations of each slot, and the bits that choose between them.

    `ones` and `zeros` int8 (N,) are the destinations for bit 1 and 0: the index of a tap, or DRAIN.
    `bits` bool (shutters, N) are the chosen bits."""

    ones: NDArray[np.int8]
    zeros: NDArray[np.int8]
    bits: NDArray[np.bool_]


@dataclass(frozen=True)
class NoRoute:
    """The reason why there is no route, as half a sentence, with a help and the first such `slot`.

    `bucket` is the index of the bucket that the message points at."""

    reason: str
    help: str
    slot: int | None = None
    bucket: int = 0


def route(shutters: NDArray[np.bool_], buckets: tuple[str, ...], target: Target) -> Route | NoRoute:
    """Return the route of the light of `shutters` (shutters, buckets, N), with bucket b at tap b.

    Light that no bucket collects goes to the drain, or to a tap without a bucket."""
    taps = len(target.taps)
    if len(buckets) > taps:
        most = f"keep at most {taps} buckets, one for each tap"
        return NoRoute(f"{len(buckets)} buckets need as many taps, but the chip has {taps}", most,
                       bucket=len(buckets) - 1)  # fmt: skip
    both = shutters.sum(axis=1) > 1
    if both.any():
        slot = int(np.flatnonzero(both.any(axis=0))[0])
        first, second = np.flatnonzero(shutters[both[:, slot].argmax(), :, slot])[:2]
        return NoRoute(
            f"in slot {slot} a pixel is open in `{buckets[first]}` and in "
            f"`{buckets[second]}`, but its light can go to only one tap",
            "let the buckets' rules exclude each other", slot, int(second),
        )  # fmt: skip
    away = DRAIN if target.drain else len(buckets) if len(buckets) < taps else None
    open_in = np.where(shutters.any(axis=1), shutters.argmax(axis=1), _NOWHERE)
    return _chosen(open_in.astype(np.int8), away, buckets, target)


_NOWHERE = 127


def _chosen(
    open_in: NDArray[np.int8], away: int | None, buckets: tuple[str, ...], target: Target
) -> Route | NoRoute:
    """Return the route for `open_in` (shutters, N): the index of the open bucket, or _NOWHERE."""
    slots = open_in.shape[1]
    ones, zeros = np.zeros(slots, np.int8), np.zeros(slots, np.int8)
    for slot in range(slots):
        places = np.unique(open_in[:, slot]).tolist()
        if len(places) > 2:
            names = [f"`{buckets[p]}`" if p != _NOWHERE else "no bucket" for p in places]
            listed = f"{', '.join(names[:-1])} and {names[-1]}"
            return NoRoute(
                f"in slot {slot} light has {len(places)} destinations ({listed}), but a bit "
                "chooses between two",
                "use at most two destinations in every slot: two buckets, or one bucket and "
                    "the drain", slot,
                len(buckets) - 1,
            )  # fmt: skip
        if away is None and _NOWHERE in places:
            return NoRoute(
                f"in slot {slot} a pixel is open in no bucket, but {target.name} has no "
                "drain: light always goes to a tap",
                f"let one bucket collect the remaining light: `bucket {buckets[-1]} open "
                    "when not (..)`", slot,
                len(buckets) - 1,
            )  # fmt: skip
        named = [place for place in places if place != _NOWHERE]
        ones[slot] = named[0] if named else 0
        other_buckets = [place for place in range(len(buckets)) if place != ones[slot]]
        zeros[slot] = named[1] if len(named) > 1 else away if away is not None else other_buckets[0]
    return Route(ones, zeros, open_in == ones)
