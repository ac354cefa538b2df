"""The light of pixels that run through their words, and of those beside them: what frames of one
scene on one chip have in common."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.light import Light
from nscc_runtime.planner.layout import Keys, Numbers
from nscc_runtime.planner.site_loop import Laying, lay_out
from nscc_runtime.pool import in_parts

_FEWEST = 256
"""Sites that are worth a thread."""


@dataclass(frozen=True, eq=False)
class Sites:
    """Sites as the loop over words takes them: `number` int32 (rows, cols) is that of each place;
    `rows` int64 and `scales` (sites, 2) say where in `sums` the light and the dark charge of each
    begin, and by what they are multiplied.
    """

    number: NDArray[np.int32]
    rows: NDArray[np.int64]
    scales: NDArray[np.float64]
    sums: NDArray[np.float64]


def is_even(light: Light) -> bool:
    """Whether all slots have the same light of one frame."""
    one = len(light.frames) == 1 and len(light.weight) == light.slots
    return one and bool(np.all(light.weight == light.weight[0]))


def with_neighbours(chosen: NDArray[np.int64], shape: tuple[int, int]) -> NDArray[np.int64]:
    """Places of an array, row * cols + col, and the four beside each of them, in order."""
    needed = np.zeros((shape[0] + 2, shape[1] + 2), np.bool_)
    rows, cols = np.divmod(chosen, shape[1])
    for down, right in ((1, 1), (0, 1), (2, 1), (1, 0), (1, 2)):
        needed[rows + down, cols + right] = True
    return np.flatnonzero(needed[1:-1, 1:-1])


def sites_of(
    light: Light,
    places: NDArray[np.int64],
    lanes: NDArray[np.int32],
    of_slot: NDArray[np.int32],
    groups: int,
    slot_s: NDArray[np.float64],
    numbers: Numbers,
    keys: Keys,
    switches: dict[str, int],
    threads: int,
) -> Sites:
    """The sites at `places`, of pixels with these `lanes` (rows, cols), whose slots are of the
    `groups` that `of_slot` (lanes, N) names and `slot_s` (N,) long. `switches` are those of
    `Laying` that effects have.
    """
    pixels, count = lanes.size, len(places)
    at = lanes.reshape(-1)[places]
    used = np.bincount(at, minlength=len(of_slot)) > 0
    here, lane = np.flatnonzero(used), (np.cumsum(used) - 1)[at]
    apart = of_slot[here, None, :] == np.arange(groups)[:, None]
    even, row = is_even(light), groups * (light.slots + 1)
    own = len(here) if even else count
    sums = np.zeros((own + len(here), groups, light.slots + 1))
    if even:
        np.cumsum(apart, axis=2, out=sums[:own, :, 1:])
    np.cumsum(apart * slot_s, axis=2, out=sums[own:, :, 1:])
    rows = np.stack([lane if even else np.arange(count), own + lane], axis=1) * row
    number = np.full(lanes.shape, -1, np.int32)
    number.reshape(-1)[places] = np.arange(count)
    found = Sites(number, np.ascontiguousarray(rows), np.empty((count, 2)), sums)
    bound = lay_out.bound(
        numbers=numbers, keys=keys, places=places, lanes=lanes.reshape(-1), of_slot=of_slot,
        frames=np.require(light.frames, np.float32, ["C", "A"]).reshape(len(light.frames), -1),
        row_start=np.require(light.row_start, np.int64, ["C", "A"]),
        frame_index=np.require(light.frame_index, np.int32, ["C", "A"]),
        weight=np.require(light.weight, np.float64, ["C", "A"]),
        scales=found.scales, sums=sums,
    )  # fmt: skip
    given: dict[str, Any] = {
        "pixels": pixels, "slots": light.slots, "groups": groups, "even": even, **switches
    }  # fmt: skip

    def fill(begin: int, end: int) -> None:
        bound(laying=Laying(begin=begin, end=end, **given))

    in_parts(fill, count, threads, _FEWEST)
    return found
