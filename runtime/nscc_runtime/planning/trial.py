"""A scene that planning measures, whatever executes its frames."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import ClassVar

from nscc_runtime.effects import CannotHave, Effect, Selection, everything, registered
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.execution.frames import Path
from nscc_runtime.planning.differences import Difference, Errors
from nscc_runtime.planning.sample import Sample

Names = frozenset[str]
NONE: Names = frozenset()


@dataclass(frozen=True)
class Setting:
    """Which effects an execution leaves out: `dropped` ones, and those of them that pixels near
    saturation lack as well; `exact`: see `nscc_runtime.execution.frames.Execution`."""

    dropped: Names
    near_dropped: Names = NONE
    exact: bool = False


NOTHING = Setting(NONE)


@dataclass(frozen=True)
class Move:
    """What may be left out together. `saved_ns`: nanoseconds a pixel of a frame that it saves;
    `field`: the effect whose measured difference it makes, None where `Trial.square_e2` tells what
    it adds to the mean square."""

    names: Names
    saved_ns: float
    field: str | None


@dataclass(frozen=True, eq=False)
class Trial(ABC):
    """A scene on which executions are tried, on a sample of its pixels.

    The truth is what the reference exposes with every effect.
    """

    forced_off: Names

    looks: ClassVar[bool] = False
    """Whether pixels end in states."""
    approximations: ClassVar[Sequence[str]] = ()
    """How exposures differ from the reference with the same effects."""

    @property
    @abstractmethod
    def sensor(self) -> Sensor:
        """The sensor."""

    @property
    @abstractmethod
    def pixels(self) -> int:
        """How many pixels the scene has."""

    @property
    @abstractmethod
    def sample(self) -> Sample:
        """The measured pixels."""

    @property
    @abstractmethod
    def absent(self) -> Names:
        """Effects of the exposure that change nothing on this scene for sure."""

    @cached_property
    def requested_effects(self) -> Selection:
        """All effects but those that the user forced off."""
        return everything().without(*self.forced_off)

    @cached_property
    def slow(self) -> Names:
        """The effects that only the reference has."""
        return frozenset(e.name for e in registered() if isinstance(e.words, CannotHave))

    @abstractmethod
    def executes(self, setting: Setting) -> Path:
        """What executes frames."""

    @property
    def alike(self) -> bool:
        """Whether an effect that changes no measured pixel changes none."""
        return False

    @abstractmethod
    def alone(self, effect: Effect, near_saturation: bool) -> Errors:
        """What leaving out one effect changes, every other wanted effect being there;
        `near_saturation`: in pixels near saturation, too, where that saves time."""

    @abstractmethod
    def together(self, setting: Setting) -> Errors:
        """How far exposures under a setting are from those with every effect."""

    def forced(self) -> Errors:
        """How far what the user forced off takes exposures from those with every effect."""
        return self.together(Setting(NONE, exact=True))

    def approximated(self) -> Difference | None:
        """How far exposures with every effect are from the truth; None: not at all."""
        return None

    @abstractmethod
    def moves(self, free: Names) -> Sequence[Move]:
        """What may be left out of the `free` effects and saves time."""

    def too_large(self, tolerance_e: float) -> Names:
        """Effects that make more than a tolerance for sure."""
        return NONE

    def square_e2(self, names: Names) -> float:
        """What a move without a field adds to the mean square."""
        raise ValueError(f"the effects {', '.join(sorted(names))} have fields")

    def settings(self, dropped: Names) -> Sequence[Setting]:
        """The executions that leave out these effects, what saves most first."""
        return [Setting(dropped)]

    def unseen_e2(self, setting: Setting) -> float:
        """What a setting may add to the mean square that no measured pixel shows."""
        return 0.0

    @abstractmethod
    def noise_e(self) -> float:
        """The root mean square over pixels and buckets of the standard deviation of exposures over
        frames with every effect."""

    def noise_ratio(self, setting: Setting) -> float | None:
        """The standard deviation of exposures over frames by that with every effect; None where
        that is not measured, or nothing is random."""
        return None

    @abstractmethod
    def reasons(self, setting: Setting) -> tuple[str, ...]:
        """Why pixels run through their words, or why the reference runs."""

    @abstractmethod
    def saved_ns(self, name: str) -> float:
        """Nanoseconds a pixel that leaving out an effect saves."""

    @abstractmethod
    def frame_ns(self, setting: Setting) -> tuple[float, float]:
        """Nanoseconds a pixel of a frame, and those of them of pixels near saturation."""

    @abstractmethod
    def planning_ms(self) -> float:
        """What measuring this scene takes."""


def slow_reason(effect: Effect) -> str:
    """Why the reference runs for an effect."""
    assert isinstance(effect.words, CannotHave)
    return f"{effect.name}: only the reference has it ({effect.words.reason})"
