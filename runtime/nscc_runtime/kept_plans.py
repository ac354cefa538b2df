"""Share plans between scenes: the next frames of a film are exposed under an earlier plan, while
its error, measured on a sample of each new scene, is within the tolerance."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable
from concurrent.futures import Future
from dataclasses import dataclass, replace
from threading import Condition
from typing import TYPE_CHECKING

if TYPE_CHECKING:  # captures without effects start without planning
    from nscc_runtime.planning.plan import Plan

_AGAIN = 8
"""After this number of scenes a new plan is made, because it may be faster in less light; the next
one after twice as many scenes, and so on."""


@dataclass(frozen=True)
class _KeptPlan:
    """A plan with its error on the last scene, the number of scenes that it has served (`scenes`,
    the one that it was made for included), and the number after which a new plan is made
    (`most_scenes`)."""

    plan: Plan
    scenes: int = 1
    most_scenes: int = _AGAIN


class KeptPlans:
    """The plans (choices of the effects that are simulated) of a series of frames, or of the scenes
    of a batch, numbered from 0.

    Frames that are exposed one after the other need no announcement. For scenes that are exposed at
    the same time, announce their numbers with `expect` before the first begins. Each scene then
    waits for the plans of lower numbers, so results do not depend on timing. A capture that fails
    also releases the next scene."""

    def __init__(self) -> None:
        """Begin without plans (choices of the effects that are simulated)."""
        self._last: dict[Hashable, Future[_KeptPlan]] = {}
        self._expected: set[int] = set()
        self._changed = Condition()

    def expect(self, numbers: Iterable[int]) -> None:
        """Announce the numbers of scenes that may be exposed at the same time. No scene is planned
        before those with lower numbers have passed."""
        with self._changed:
            self._expected.update(numbers)

    def passed(self, number: int) -> None:
        """Note that scene `number` has its plan (the effects that are simulated) or needs none."""
        with self._changed:
            self._expected.discard(number)
            self._changed.notify_all()

    def plan(
        self,
        turn: Turn,
        request: Hashable,
        make: Callable[[int], Plan],
        measure: Callable[[Plan], Plan | None],
    ) -> Plan:
        """Return the last plan for the same `request` if it is valid for this scene, else
        `make(frames)`.

        `measure(plan)` returns an earlier plan with its error on this scene, None if it is not
        valid here. `frames` is the expected number of frames for which a new plan is valid:
        `turn.frames` at first, later the number of scenes that the last plan served."""
        with self._changed:
            # Until all announced scenes with lower numbers have passed; without any, no wait.
            self._changed.wait_for(lambda: turn.number <= min(self._expected, default=turn.number))
        mine: Future[_KeptPlan] = Future()
        last, self._last[request] = self._last.get(request), mine
        self.passed(turn.number)
        try:
            earlier = None if last is None or last.exception() else last.result()
            if earlier is None:
                kept = _KeptPlan(make(turn.frames))
            else:
                is_due = earlier.scenes >= earlier.most_scenes
                measured = None if is_due else measure(earlier.plan)
                if measured is None:
                    most_scenes = 2 * earlier.most_scenes if is_due else _AGAIN
                    new_plan = make(min(turn.frames, earlier.scenes))
                    kept = _KeptPlan(new_plan, most_scenes=most_scenes)
                else:
                    kept = replace(earlier, plan=measured, scenes=earlier.scenes + 1)
        except BaseException as error:
            mine.set_exception(error)
            raise
        mine.set_result(kept)
        return kept.plan


@dataclass(frozen=True, eq=False)
class Turn:
    """A scene's position among the scenes that share plans (choices of the effects that are
    simulated).

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
