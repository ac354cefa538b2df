"""Plans kept from scene to scene: the next frames of a film are exposed under the plan of an
earlier one, as long as their light is of the same kind and no stronger.

What is left out of a frame errs in proportion to light, to its steps between neighbours, or steeper
where pixels saturate; so a plan goes on being good while none of these has grown by more than the
room that plans leave below their tolerance. Where pixels look, it also hangs on how many of them
stand near a level, and the plan is tried on the new scene.
"""

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
    ROWS,
    SQUARE,
    STEPS,
    ArraySize,
    sizes_of,
)

if TYPE_CHECKING:  # captures without effects start without planning
    from nscc_runtime.planning.plan import Plan

Values = NDArray[np.float64]

_MORE = 1.03
"""By what factor light may grow: plans leave a tenth of their tolerance."""
_LESS, _LESS_OF_PART = 0.5, 0.95
"""Below these factors a plan is made anew: a cheaper one may do; a tolerance that is a part of the
scene has become smaller."""
_STEEP = (EIGHTH, LARGEST, OPEN + EIGHTH, OPEN + LARGEST)
"""Sizes by which more saturates."""
_SHIFTED = 0.02
"""The part of the light that may fall in other slots."""
_WITHOUT_END = 1e30
"""Light that is taken to have no end."""
_SOME = 8
"""Of each row and column every one of so many says when light falls."""


@dataclass(frozen=True, eq=False)
class Statistics:
    """What of a scene's light decides on the errors of a plan.

    `sizes`, in electrons: of the light of a pixel over the frame the mean, the root of the mean
    square, that of the eighth power, the largest; these again of the light while pixels are open;
    and the root mean square of steps between neighbours. `course` (frames,): what part of all light
    has fallen by the end of each of the scene's frames.
    """

    light: Light
    sizes: Values
    course: Values

    @classmethod
    def of(cls, light: Light, open_part: NDArray[np.float32]) -> Statistics:
        """Of a scene, in one pass over its frames; `open_part` (rows, cols): how much of the frame
        each pixel is open."""
        return cls(light, _sizes(light.sum_e, open_part), _course(light))

    def resembles(
        self, other_statistics: Statistics, *, saturating: bool = True, least: float = _LESS
    ) -> bool:
        """Whether the other scene's light is of this kind and no stronger.

        It may saturate more pixels only with `saturating`, that is, if saturation is simulated. Its
        mean is at least `least` times that of this scene.
        """
        own_sizes, other_sizes = self.sizes.tolist(), other_statistics.sizes.tolist()
        pairs = [*zip(own_sizes, other_sizes, strict=True)]
        return (
            all(size < _WITHOUT_END for size in (*own_sizes, *other_sizes))
            and all(other_size >= least * own_size for own_size, other_size in pairs[:EIGHTH])
            and all(
                # Of what saturates a little more light may lose much more.
                other_size <= own_size * (_MORE if saturating or kind not in _STEEP else 1.0)
                for kind, (own_size, other_size) in enumerate(pairs)
            )
            and _alike(self.light, other_statistics.light)
            and bool(np.abs(other_statistics.course - self.course).max(initial=0.0) <= _SHIFTED)
        )

    def covers(self, other_statistics: Statistics, plan: Plan) -> bool:
        """Whether a plan that was made for this scene will do for another one."""
        follows = plan.allowed is None or plan.allowed.follows
        least = _LESS_OF_PART if follows else _LESS
        return self.resembles(other_statistics, saturating=not plan.drops_saturation, least=least)


def _course(light: Light) -> Values:
    """See `Statistics.course`."""
    weight, frames = light.frame_weight, light.frames
    if len(frames) == 1:
        return np.ones(1)
    with np.errstate(over="ignore", invalid="ignore"):
        course = np.cumsum(weight * frames[:, ::_SOME, ::_SOME].mean(axis=(1, 2)))
        course /= course[-1] if len(course) and course[-1] > 0 else 1.0
    return course


def _sizes(total: Values, open_part: NDArray[np.float32]) -> Values:
    """See `Statistics.sizes`."""
    (rows, cols), columns = total.shape, np.empty((KINDS, total.shape[1]))
    sizes_of(
        pixels=ArraySize(rows=rows, cols=cols), total=total, open_fraction=open_part,
        lit=np.empty(ROWS * cols), column_sums=columns,
    )  # fmt: skip
    sizes: Values = columns.sum(axis=1)
    for first in (0, OPEN):
        sizes[first : first + LARGEST] /= rows * cols
        sizes[first + SQUARE] **= 0.5
        sizes[first + EIGHTH] **= 0.125
        sizes[first + LARGEST] = columns[first + LARGEST].max()
    sizes[STEPS] = (sizes[STEPS] / max(rows * (cols - 1) + cols * (rows - 1), 1)) ** 0.5
    return sizes


def _alike(light: Light, other_light: Light) -> bool:
    """Whether frames of these lights fall in the same slots."""
    if light.shape != other_light.shape or (light.motion is None) != (other_light.motion is None):
        return False
    return light.timing == other_light.timing and (
        light.motion is None
        or other_light.motion is None
        or _alike(light.motion, other_light.motion)
    )


@dataclass(frozen=True, eq=False)
class _KeptPlan:
    """A plan, or one that is being made, with what its scene is like; `scenes`: how many of that
    kind there were so far."""

    statistics: Statistics
    future: Future[Plan]
    scenes: int

    @cached_property
    def again(self) -> Plan:
        """The plan as that of another scene."""
        return replace(self.future.result(), reused=True)


class KeptPlans:
    """The plans of a series of frames, or of the scenes of a batch, numbered from 0.

    Frames that are exposed one after the other need no announcement. For scenes that are exposed
    at the same time, announce their numbers with `expect` before the first begins. Each scene then
    waits for the plans of lower numbers, so the result does not depend on timing. A capture that
    fails also releases the next scene.
    """

    def __init__(self) -> None:
        self._last: dict[Hashable, _KeptPlan] = {}
        self._expected: set[int] = set()
        self._changed = Condition()

    def expect(self, numbers: Iterable[int]) -> None:
        """Scenes with these numbers will be exposed, maybe at the same time: none is planned before
        those with lower numbers have passed."""
        with self._changed:
            self._expected.update(numbers)

    def passed(self, number: int) -> None:
        """Scene `number` has its plan, or needs none."""
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
        """Return the plan of a scene: the last plan for the same `request` if it covers this scene
        and `serves` it, else the result of `make(frames)`.

        `frames` is the expected number of frames with light of this kind: `turn.frames` at first,
        later the number of scenes of the last kind. If no two scenes are alike, measuring does not
        pay.
        """
        with self._changed:
            self._changed.wait_for(lambda: turn.number <= min(self._expected, default=turn.number))
        mine: Future[Plan] = Future()
        try:
            last, scenes, frames = self._last.get(request), 1, turn.frames
            if last is not None:
                frames = min(turn.frames, last.scenes)
            # Most scenes that differ are told apart before the last plan is there.
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
    """A scene's place among those that share their plans.

    Attributes
    ----------
    plans : KeptPlans
        Where plans are kept.
    number : int
        The scene's number among them.
    frames : int
        How many frames of one kind are expected at most: choosing effects has to pay by them.
    """

    plans: KeptPlans
    number: int
    frames: int = 1000
