"""Intervals between the boundaries of a frame at which words run.

Between these boundaries charge is collected, registers leak and PIX may saturate, so the charge of
an interval is counted at once, which changes no distribution. While the words of a boundary run,
the fraction of the interval's charge that is collected follows from the light of its first slot."""

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
    """The intervals of a frame. `starts`: their first slots. `slot_us` (N,): slot lengths."""

    starts: tuple[int, ...]
    slot_us: Values

    @classmethod
    def of(cls, container: Container, every_slot: bool) -> Intervals:
        """Return a program's intervals; with `every_slot` one per slot, as exact exposures need."""
        at = {0, *(launch.instant for launch in container.launches)}
        slots = container.slots
        starts = range(slots) if every_slot else sorted(n for n in at if n < slots)
        return cls(tuple(starts), np.array(container.slot_us, np.float64))

    def __len__(self) -> int:
        return len(self.starts)

    @property
    def us(self) -> Values:
        """Length (intervals,) of each interval in microseconds."""
        return np.add.reduceat(self.slot_us, self.starts)

    def joined(self, scene: Scene) -> Scene:
        """Return a scene whose light is given in intervals instead of slots."""
        light = scene.light.joined(self.starts)
        same = scene.previous is scene.light
        previous = light if same else scene.previous.joined(self.starts)
        return Scene(light, previous, self.us * 1e-6)

    def paced(self, scene: Scene, effects: Selection) -> Callable[[slice, Values], Values]:
        """Return a function of a slice of rows and their light (intervals, rows, cols).

        The function returns the fraction of an interval's light that is collected per microsecond
        while words run, shape (intervals + 1, pixels), or (intervals + 1, 1) if all pixels have the
        same. The last row is for the words after the last slot, as if the light of that slot
        continued. All fractions are 0 if words take no time."""
        for choose in effects.at("scene"):
            scene = choose(scene)
        light = scene.light
        first = [*self.starts, len(self.slot_us) - 1]
        interval = [*range(len(self)), len(self) - 1]
        slot_us, us = self.slot_us[first][:, None], self.us[interval][:, None]
        if not effects.at("time"):
            return lambda _rows, _light: np.zeros((len(first), 1))
        if len(light.frames) == 1 and len(light.weight) == light.slots:
            # A still: the light of a slot is its weight times the only picture.
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
    """Return the fraction of an interval's light that is collected in one microsecond of its first
    slot; without light, the fraction of its time."""
    even = np.broadcast_to(slot_us / us, interval_light.shape).copy()
    return np.asarray(
        np.divide(slot_light, interval_light, out=even, where=interval_light > 0) / slot_us
    )
