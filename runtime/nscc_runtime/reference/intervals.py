"""The time between the boundaries of a frame at which words run.

Between them nothing happens but that charge falls, registers leak and PIX may fill: the charge of
such an interval is counted as one, which changes no distribution. While the words of its boundary
run, so much of it falls as the light of its first slot is of its light.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.words.container import Container
from nscc_runtime.effects import Selection
from nscc_runtime.effects.views import Scene

Values = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Intervals:
    """`starts` are their first slots; `slot_us` (N,) how long the slots are."""

    starts: tuple[int, ...]
    slot_us: Values

    @classmethod
    def of(cls, container: Container, every_slot: bool) -> Intervals:
        """Those of a program; with `every_slot` each slot is one, as exact exposures have it."""
        at = {0, *(launch.instant for launch in container.launches)}
        slots = container.slots
        starts = range(slots) if every_slot else sorted(n for n in at if n < slots)
        return cls(tuple(starts), np.array(container.slot_us, np.float64))

    def __len__(self) -> int:
        return len(self.starts)

    @property
    def us(self) -> Values:
        """How long each lasts."""
        return np.add.reduceat(self.slot_us, self.starts)

    def joined(self, scene: Scene) -> Scene:
        """A scene in intervals instead of slots."""
        light = scene.light.joined(self.starts)
        same = scene.previous is scene.light
        previous = light if same else scene.previous.joined(self.starts)
        return Scene(light, previous, self.us * 1e-6)

    def paced(self, scene: Scene, effects: Selection) -> Callable[[slice, Values], Values]:
        """Of some rows and their light in the intervals: what part of an interval's light falls in
        a microsecond while words run, (intervals + 1, pixels), or (.., 1) where all pixels have the
        same. The last is for the words after the last slot: the light goes on as in that slot.
        Nothing where words take no time.
        """
        for choose in effects.at("scene"):
            scene = choose(scene)
        light = scene.light
        first = [*self.starts, len(self.slot_us) - 1]
        interval = [*range(len(self)), len(self) - 1]
        slot_us, us = self.slot_us[first][:, None], self.us[interval][:, None]
        if not effects.at("time"):
            return lambda _rows, _light: np.zeros((len(first), 1))
        if len(light.frames) == 1 and len(light.weight) == light.slots:
            # A still: the light of slots is their weight of the one picture.
            slot_light = light.weight[first][:, None]
            interval_light = np.add.reduceat(light.weight, self.starts)[interval][:, None]
            return lambda _rows, _light: _light_share_per_us(
                slot_light, interval_light, slot_us, us
            )

        def of_rows(rows: slice, all_of_it: Values) -> Values:
            slot_light = np.stack([light.slot(n, rows).reshape(-1) for n in first])
            return _light_share_per_us(
                slot_light, all_of_it[interval].reshape(len(interval), -1), slot_us, us
            )

        return of_rows


def _light_share_per_us(
    slot_light: NDArray[Any], interval_light: NDArray[Any], slot_us: Values, us: Values
) -> Values:
    """The fraction of an interval's light that falls in one microsecond of its first slot; without
    light, the fraction of its time."""
    even = np.broadcast_to(slot_us / us, interval_light.shape).copy()
    return np.asarray(
        np.divide(slot_light, interval_light, out=even, where=interval_light > 0) / slot_us
    )
