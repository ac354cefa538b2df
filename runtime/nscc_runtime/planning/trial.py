"""The interface for measuring the errors of effects on a scene."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import ClassVar

from nscc_runtime.effects import CannotHave, Effect, Selection, everything, registered
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.execution.frames import Path
from nscc_runtime.planning.differences import Difference, ExposureErrors
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
    """Effects that can only be dropped together. `saved_ns`: nanoseconds saved per pixel of a
    frame. `field`: the effect whose measured error it causes; None if `Trial.square_e2` computes
    it."""

    names: Names
    saved_ns: float
    field: str | None


@dataclass(frozen=True, eq=False)
class Trial(ABC):
    """A scene on which settings are measured, on a sample of its pixels.

    The truth is the exposure by the reference with every effect.
    """

    forced_off: Names

    looks: ClassVar[bool] = False
    """Whether the program has states."""
    approximations: ClassVar[Sequence[str]] = ()
    """The approximations, compared with the reference with the same effects."""

    @property
    @abstractmethod
    def sensor(self) -> Sensor:
        """The sensor."""

    @property
    @abstractmethod
    def pixels(self) -> int:
        """Number of pixels of the scene."""

    @property
    @abstractmethod
    def sample(self) -> Sample:
        """The sampled pixels."""

    @property
    @abstractmethod
    def absent(self) -> Names:
        """Effects of the exposure that certainly change nothing on this scene."""

    @cached_property
    def requested_effects(self) -> Selection:
        """All effects except those that the user forced off."""
        return everything().without(*self.forced_off)

    @cached_property
    def slow(self) -> Names:
        """The effects that only the reference supports."""
        return frozenset(e.name for e in registered() if isinstance(e.words, CannotHave))

    @abstractmethod
    def executes(self, setting: Setting) -> Path:
        """Return the path that executes frames of a setting."""

    @property
    def alike(self) -> bool:
        """Whether an effect that changes no sampled pixel changes no pixel at all."""
        return False

    @abstractmethod
    def alone(self, effect: Effect, near_saturation: bool) -> ExposureErrors:
        """What leaving out one effect changes, every other wanted effect being there;
        `near_saturation`: in pixels near saturation, too, where that saves time."""

    @abstractmethod
    def together(self, setting: Setting) -> ExposureErrors:
        """Return the error of exposures under a setting."""

    def forced(self) -> ExposureErrors:
        """Return the error of the effects that the user forced off."""
        return self.together(Setting(NONE, exact=True))

    def approximated(self) -> Difference | None:
        """Return the error of the approximations with every effect; None if there are none."""
        return None

    @abstractmethod
    def moves(self, free: Names) -> Sequence[Move]:
        """Return the moves that drop some of the `free` effects and save time."""

    def too_large(self, tolerance_e: float) -> Names:
        """Return effects whose error certainly exceeds a tolerance."""
        return NONE

    def square_e2(self, names: Names) -> float:
        """Return the mean square error of a move without a field."""
        raise ValueError(f"the effects {', '.join(sorted(names))} have fields")

    def settings(self, dropped: Names) -> Sequence[Setting]:
        """Return the settings that drop these effects; those that save most come first."""
        return [Setting(dropped)]

    def unseen_e2(self, setting: Setting) -> float:
        """Return an allowance for the mean square error of rare pixels that the sample misses."""
        return 0.0

    @abstractmethod
    def noise_e(self) -> float:
        """Return the standard deviation over frames with every effect, as a root mean square over
        pixels and buckets."""

    def noise_ratio(self, setting: Setting) -> float | None:
        """Return the noise of a setting divided by that with every effect; None if it was not
        measured, or there is no noise."""
        return None

    @abstractmethod
    def reasons(self, setting: Setting) -> tuple[str, ...]:
        """Return the reasons why pixels run through their words, or why the reference runs."""

    @abstractmethod
    def saved_ns(self, name: str) -> float:
        """Return the nanoseconds per pixel saved by dropping an effect."""

    @abstractmethod
    def frame_ns(self, setting: Setting) -> tuple[float, float]:
        """Return the nanoseconds per pixel of a frame, and the part due to pixels near
        saturation."""

    @abstractmethod
    def planning_ms(self) -> float:
        """Return the milliseconds of measuring this scene."""


def slow_reason(effect: Effect) -> str:
    """Return the reason why an effect requires the reference."""
    assert isinstance(effect.words, CannotHave)
    return f"{effect.name}: only the reference has it ({effect.words.reason})"
