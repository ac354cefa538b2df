"""Share plans between scenes: the next frames of a film are exposed under an earlier plan, as long
as their light is similar and not stronger.

The error of dropped effects grows in proportion to light, to its differences between neighbours, or
faster where pixels saturate. So a plan stays valid while none of these has grown by more than the
margin that plans leave below their tolerance. If pixels look, the error also depends on how many
pixels are close to a level, so the plan is tested on the new scene."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable
from concurrent.futures import Future
from dataclasses import dataclass, replace
from functools import cached_property
from threading import Condition
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.light import Light
from nscc_runtime.sizes_loop import (
    EIGHTH,
    KINDS,
    LARGEST,
    OPEN,
    SQUARE,
    STEPS,
    ArraySize,
    sizes_of,
)

if TYPE_CHECKING:  # captures without effects start without planning
    from nscc_runtime.planning.plan import Plan

Values = NDArray[np.float64]

_MORE = 1.03
"""Largest factor by which light may grow: plans leave a tenth of their tolerance as margin."""
_LESS, _LESS_OF_PART = 0.5, 0.95
"""A new plan is made if light falls below `_LESS` of the earlier light, because it may be cheaper.
For a relative tolerance, which becomes smaller with light, the limit is `_LESS_OF_PART`."""
_STEEP = (EIGHTH, LARGEST, OPEN + EIGHTH, OPEN + LARGEST)
"""Sizes that decide how many pixels saturate."""
_SHIFTED = 0.02
"""Largest fraction of the light that may move to other slots."""
_WITHOUT_END = 1e30
"""Light above this value counts as infinite."""
_SOME = 8
"""The time course of light is computed from every `_SOME`-th row and column."""


@dataclass(frozen=True, eq=False)
class Statistics:
    """The properties of a scene's light that determine the errors of a plan.

    `sizes`, in electrons: mean, root mean square, eighth root of the mean eighth power, and maximum
    of the light of a pixel over the frame; the same for the light while pixels are open; the root
    mean square of differences between neighbours. `course` (frames,): fraction of all light that is
    collected by the end of each of the scene's frames."""

    light: Light
    sizes: Values
    course: Values

    @classmethod
    def of(cls, light: Light, open_part: NDArray[np.float32]) -> Statistics:
        """Compute the statistics of a scene. `open_part` (rows, cols): fraction of the frame in
        which each pixel is open."""
        weight, frames = light.frame_weight, light.frames
        course = np.ones(1)
        if len(frames) > 1:
            with np.errstate(over="ignore", invalid="ignore"):
                course = np.cumsum(weight * frames[:, ::_SOME, ::_SOME].mean(axis=(1, 2)))
                course /= course[-1] if course[-1] > 0 else 1.0
        return cls(light, _sizes(light.sum_e, open_part), course)

    def resembles(
        self, other_statistics: Statistics, *, saturating: bool = True, least: float = _LESS
    ) -> bool:
        """Return whether the other scene's light is similar to this scene's light and not stronger.

        More pixels may saturate only with `saturating`, that is, if saturation is simulated. The
        other light must be at least `least` times this scene's."""
        own_sizes, other_sizes = self.sizes.tolist(), other_statistics.sizes.tolist()
        pairs = [*zip(own_sizes, other_sizes, strict=True)]
        return (
            all(size < _WITHOUT_END for size in (*own_sizes, *other_sizes))
            and all(other_size >= least * own_size for own_size, other_size in pairs[:EIGHTH])
            and all(
                # With saturation, a little more light may cause a much larger error.
                other_size <= own_size * (_MORE if saturating or kind not in _STEEP else 1.0)
                for kind, (own_size, other_size) in enumerate(pairs)
            )
            and self.light.shape == other_statistics.light.shape
            and self.light.timing == other_statistics.light.timing
            and bool(np.abs(other_statistics.course - self.course).max(initial=0.0) <= _SHIFTED)
        )

    def covers(self, other_statistics: Statistics, plan: Plan) -> bool:
        """Return whether a plan that was made for this scene is also valid for another scene."""
        follows = plan.allowed is None or plan.allowed.follows
        least = _LESS_OF_PART if follows else _LESS
        return self.resembles(other_statistics, saturating=not plan.drops_saturation, least=least)


def _sizes(total: Values, open_part: NDArray[np.float32]) -> Values:
    """Return mean, powers, maximum and differences of light `total` (see `Statistics.sizes`)."""
    (rows, cols), columns = total.shape, np.empty((KINDS, total.shape[1]))
    sizes_of(
        pixels=ArraySize(rows=rows, cols=cols), total=total, open_fraction=open_part,
        column_sums=columns,
    )  # fmt: skip
    sizes: Values = columns.sum(axis=1)
    for first in (0, OPEN):
        sizes[first : first + LARGEST] /= rows * cols
        sizes[first + SQUARE] **= 0.5
        sizes[first + EIGHTH] **= 0.125
        sizes[first + LARGEST] = columns[first + LARGEST].max()
    sizes[STEPS] = (sizes[STEPS] / max(rows * (cols - 1) + cols * (rows - 1), 1)) ** 0.5
    return sizes


@dataclass(frozen=True, eq=False)
class _KeptPlan:
    """A plan, or a plan that is being made, with the statistics of its scene. `scenes`: number of
    scenes of this kind so far."""

    statistics: Statistics
    future: Future[Plan]
    scenes: int

    @cached_property
    def again(self) -> Plan:
        """The plan, marked as reused from another scene."""
        return replace(self.future.result(), reused=True)


class KeptPlans:
    """The plans of a series of frames, or of the scenes of a batch, numbered from 0.

    Frames that are exposed one after the other need no announcement. For scenes that are exposed at
    the same time, announce their numbers with `expect` before the first begins. Each scene then
    waits for the plans of lower numbers, so results do not depend on timing. A capture that fails
    also releases the next scene."""

    def __init__(self) -> None:
        self._last: dict[Hashable, _KeptPlan] = {}
        self._expected: set[int] = set()
        self._changed = Condition()

    def expect(self, numbers: Iterable[int]) -> None:
        """Announce the numbers of scenes that may be exposed at the same time. No scene is planned
        before those with lower numbers have passed."""
        with self._changed:
            self._expected.update(numbers)

    def passed(self, number: int) -> None:
        """Note that scene `number` has its plan or needs none."""
        with self._changed:
            self._expected.discard(number)
            self._changed.notify_all()

    def plan(
        self,
        turn: Turn,
        request: Hashable,
        statistics: Statistics,
        make: Callable[[int], Plan],
        serves: Callable[[Plan], bool],
    ) -> Plan:
        """Return the last plan for the same `request` if it is valid for this scene, else
        `make(frames)`.

        A plan is valid if its statistics cover this scene and `serves(plan)` is true. `frames` is
        the expected number of frames with similar light: `turn.frames` at first, later the number
        of scenes of the last kind. If no two scenes are similar, measuring does not pay."""
        with self._changed:
            self._changed.wait_for(lambda: turn.number <= min(self._expected, default=turn.number))
        mine: Future[Plan] = Future()
        try:
            last, scenes, frames = self._last.get(request), 1, turn.frames
            if last is not None:
                frames = min(turn.frames, last.scenes)
            # Different scenes are usually recognised before the last plan is complete.
            alike = last is not None and last.statistics.resembles(statistics)
            if last is not None and alike and last.future.exception() is None:
                scenes, earlier = last.scenes + 1, last.again
                frames = min(turn.frames, scenes)
                covers = earlier.measured and last.statistics.covers(statistics, earlier)
                if covers and serves(earlier):
                    self._last[request] = replace(last, scenes=scenes)
                    return earlier
            self._last[request] = _KeptPlan(statistics, mine, scenes)
        finally:
            self.passed(turn.number)
        try:
            mine.set_result(make(frames))
        except BaseException as error:
            mine.set_exception(error)
            raise
        return mine.result()


@dataclass(frozen=True, eq=False)
class Turn:
    """A scene's position among the scenes that share plans.

    Attributes
    ----------
    plans : KeptPlans
        The shared plans.
    number : int
        Number of the scene.
    frames : int
        Expected largest number of similar frames: choosing effects has to pay within this number.
    """

    plans: KeptPlans
    number: int
    frames: int = 1000
