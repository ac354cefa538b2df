"""Launches (starts of kernels) after an exposure: loops of them, and what parameters change."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any, Literal

from nscc.record import Record
from nscc.words.machine import Length


class HostParam(Record):
    """A parameter: a number that the host sets before a frame, and that a frame does not change.

    It is at least `low` and at most `high`, and `start` until the host sets it. If `kind` is
    "level", these are steps of IN (the level sent to all pixels); if it is "integer", numbers
    without a unit."""

    name: str
    kind: Literal["level", "integer"]
    low: int
    high: int
    start: int

    @property
    def ends(self) -> tuple[int, int]:
        """The lowest and the highest value, as (low, high)."""
        return self.low, self.high


class Times(Record):
    """A number of steps: `offset` + `factor` times a parameter, 0 if that is negative.

    `param` is "" for a constant. `most` is the largest number over all values of the parameter."""

    offset: int
    most: Length
    param: str = ""
    factor: int = 0

    def at(self, params: Mapping[str, int]) -> int:
        """Return the number of steps for these values of parameters; a missing parameter counts as
        0."""
        return max(0, self.offset + self.factor * params.get(self.param, 0))


class LevelOf(Record):
    """How the value of IN (the level sent to all pixels) follows from a parameter: it is `factor`
    times `param`, in steps.

    `launch` is the index of a launch (start of a kernel), which sets it. A kernel is a list of
    words."""

    launch: Length
    param: str
    factor: int


class LoopValue(Record):
    """The register that holds a repeated image or plane before and after each step.

    It holds an image times `sign`; for a plane, `sign` is 1."""

    name: str
    register: str
    sign: Literal[-1, 1] = 1


class LaunchLoop(Record):
    """A loop: `launches` launches (starts of kernels), from the one with the index `first` on,
    which run `times` times.

    `values` are the registers of the names that change from step to step. A kernel is a list of
    words."""

    first: Length
    launches: Length
    times: Times
    values: tuple[LoopValue, ...]


class TailLaunch(Record):
    """The start of the kernel (list of words) with the index `kernel` after the exposure, with IN
    (the level sent to all pixels) at `level` steps.

    The level is None if the kernel does not read IN, or if a parameter determines it."""

    kernel: Length
    level: int | None


class SteeredLaunch(Record):
    """A launch (start of a kernel) after the exposure, and what the values of parameters change
    about it.

    `kernel` is the index of the kernel (a list of words). IN (the level sent to all pixels) is at
    `level` steps, or at the level `level_of` of a parameter; both are None if the kernel does not
    read IN. The launch belongs to step number `step`, from 0, of a loop of `times` steps, which a
    parameter sets; `times` is None for other launches. `is_start` tells whether it is part of the
    first frame only."""

    kernel: Length
    level: int | None
    level_of: LevelOf | None
    times: Times | None
    step: Length
    is_start: bool = False

    def shared(self, number: int) -> tuple[Any, ...]:
        """Return what launches (starts of kernels) have in common that are one row of a schedule.

        `number` is the place of this launch in the row, which grows with its step. A kernel is a
        list of words."""
        return self.is_start, self.level_of, self.times, self.times and self.step - number

    @property
    def is_changed(self) -> bool:
        """Whether a parameter, or the number of the frame, changes the launch (the start of a
        kernel). A kernel is a list of words."""
        return bool(self.is_start or self.level_of or self.times)


def every_step(
    launches: Sequence[TailLaunch],
    levels_of: Iterable[LevelOf],
    loops: Iterable[LaunchLoop],
    params: Mapping[str, int] | None,
) -> Iterator[SteeredLaunch]:
    """Yield the `launches` of a frame in order, with every step of its `loops`, which follow each
    other.

    `levels_of` names the launches (starts of kernels) whose level is that of a parameter. `params`
    has values of parameters by name; None stands for the largest number of steps of each loop. A
    kernel is a list of words."""
    # `next_launch` is the first launch that is not yielded yet.
    level_of, next_launch = {level.launch: level for level in levels_of}, 0

    def run(end: int, times: Times | None, step: int) -> Iterator[SteeredLaunch]:
        """Yield the launches from number `next_launch` on up to `end`, without it, as step number
        `step` of a loop of `times` steps (None for no loop). A launch is the start of a kernel, a
        list of words."""
        for number, launch in enumerate(launches[next_launch:end], next_launch):
            level = level_of.get(number)
            yield SteeredLaunch(launch.kernel, launch.level, level, times, step)

    for loop in loops:
        yield from run(loop.first, None, 0)
        next_launch, times = loop.first, loop.times
        # Without a parameter, the number of steps is constant, and no step can be left out.
        is_set = bool(times.param)
        for step in range(times.most if is_set and params is None else times.at(params or {})):
            yield from run(next_launch + loop.launches, times if is_set else None, step)
        next_launch += loop.launches
    yield from run(len(launches), None, 0)
