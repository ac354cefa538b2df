"""The interface for planning, exposing and auditing a program on a scene."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from nscc.words.container import Container
from nscc_runtime.effects import CannotHave, Effect, Selection, everything, registered
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.execution.frames import Path
from nscc_runtime.frame_file import Frame
from nscc_runtime.light import Light
from nscc_runtime.loop import Loop
from nscc_runtime.planning.audit import Audit
from nscc_runtime.planning.differences import Difference, ExposureErrors
from nscc_runtime.planning.plan import Plan
from nscc_runtime.planning.sample import Sample
from nscc_runtime.planning.tolerance import Tolerance, with_readout_e

Names = frozenset[str]
NONE: Names = frozenset()


@dataclass(frozen=True)
class Setting:
    """The effects that an execution leaves out. `dropped`: for all pixels, except that pixels near
    saturation only lack `near_dropped`. `exact`: see `nscc_runtime.execution.frames.Execution`."""

    dropped: Names
    near_dropped: Names = NONE
    exact: bool = False


NOTHING = Setting(NONE)


@dataclass(frozen=True)
class Move:
    """Effects that can only be dropped together.

    `names`: the effects. `saved_ns`: nanoseconds saved per pixel of a frame. `field`: the effect
    whose measured error stands for the move; None if `Trial.square_e2` computes the error."""

    names: Names
    saved_ns: float
    field: str | None


@dataclass(frozen=True, eq=False)
class Trial(ABC):
    """Measurements of settings on a sample of the pixels of a scene.

    Errors are relative to the exposure by the reference with every effect. `forced_off`: names of
    the effects that the user switched off."""

    forced_off: Names

    looks: ClassVar[bool] = False
    """Whether the program has states."""
    approximations: ClassVar[Sequence[str]] = ()
    """Descriptions of the approximations relative to the reference with the same effects."""

    @property
    @abstractmethod
    def sensor(self) -> Sensor:
        """The sensor that is simulated."""

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
        """Names of the effects of the exposure that certainly change nothing on this scene."""

    @cached_property
    def requested_effects(self) -> Selection:
        """All effects except those that the user forced off."""
        return everything().without(*self.forced_off)

    @cached_property
    def slow(self) -> Names:
        """Names of the effects that only the reference supports."""
        return frozenset(e.name for e in registered() if isinstance(e.words, CannotHave))

    @abstractmethod
    def executes(self, setting: Setting) -> Path:
        """Return the path that executes frames of a setting: sums, words or the reference."""

    @property
    def alike(self) -> bool:
        """Whether an effect that changes no sampled pixel changes no pixel at all."""
        return False

    @abstractmethod
    def alone(self, effect: Effect, near_saturation: bool) -> ExposureErrors:
        """Return the error of dropping one effect while every other requested effect is simulated.

        `near_saturation`: also measure pixels near saturation, if dropping the effect there saves
        time."""

    @abstractmethod
    def together(self, setting: Setting) -> ExposureErrors:
        """Return the error of exposures under a setting."""

    def forced(self) -> ExposureErrors:
        """Return the error of dropping only the effects that the user forced off."""
        return self.together(Setting(NONE, exact=True))

    def approximated(self) -> Difference | None:
        """Return the error of the approximations with every effect; None without approximations."""
        return None

    @abstractmethod
    def moves(self, free: Names) -> Sequence[Move]:
        """Return the moves that drop some of the `free` effects and save time."""

    def too_large(self, tolerance_e: float) -> Names:
        """Return the names of effects whose error certainly exceeds a tolerance in electrons."""
        return NONE

    def square_e2(self, names: Names) -> float:
        """Return the mean square error, in square electrons, of a move whose `field` is None."""
        raise ValueError(f"the effects {', '.join(sorted(names))} have fields")

    def settings(self, dropped: Names) -> Sequence[Setting]:
        """Return settings that drop these effects, cheapest first."""
        return [Setting(dropped)]

    def unseen_e2(self, setting: Setting) -> float:
        """Return an allowance in square electrons for rare pixels that the sample lacks."""
        return 0.0

    @abstractmethod
    def noise_e(self) -> float:
        """Return the standard deviation over frames with every effect, as a root mean square over
        pixels and buckets, in electrons."""

    def noise_ratio(self, setting: Setting) -> float | None:
        """Return the noise of a setting divided by the noise with every effect; None if it was not
        measured, or if there is no noise."""
        return None

    @abstractmethod
    def reasons(self, setting: Setting) -> tuple[str, ...]:
        """Return reasons why pixels need words, or all need the reference; empty for sums alone."""

    @abstractmethod
    def saved_ns(self, name: str) -> float:
        """Return the nanoseconds per pixel saved by dropping the effect `name`."""

    @abstractmethod
    def frame_ns(self, setting: Setting) -> tuple[float, float]:
        """Return the nanoseconds per pixel of a frame, and those due to pixels near saturation."""

    @abstractmethod
    def planning_ms(self) -> float:
        """Return the predicted milliseconds for measuring effects on this scene."""


@dataclass(frozen=True, eq=False)
class PlannedScene(ABC):
    """A program on a scene, to be planned, exposed and audited.

    `threads`: number of threads (None: all processors); results do not depend on it."""

    container: Container
    sensor: Sensor
    light: Light
    device_seed: int = 0
    threads: int | None = None

    @property
    @abstractmethod
    def loop(self) -> Loop[Any]:
        """The numba loop that must be compiled before the first frame."""

    @abstractmethod
    def ready(self) -> None:
        """Analyse the program. Raises Rejected if it cannot be simulated."""

    @abstractmethod
    def signal_e(self) -> float:
        """Return the mean signal of a frame without effects, in electrons (see `mean_signal_e`)."""

    def noise_e(self) -> float:
        """Return the noise of a frame with every effect, including readout and rounding, in
        electrons.

        This is the standard deviation over frames, as a root mean square over pixels and buckets.
        """
        return with_readout_e(self.trial(NONE).noise_e(), self.sensor)

    @abstractmethod
    def trial(self, forced_off: Names) -> Trial:
        """Return the trial that measures effects on this scene with `forced_off` switched off."""

    def slower_trial(self, trial: Trial, tolerance_e: float) -> Trial | None:
        """Return a slower trial with smaller errors than `trial`; None if there is none."""
        return None

    def approximates(self, tolerance_e: float | None, noise_part: float | None) -> bool:
        """Return whether the approximations of sums are certainly small. They are compared with
        `tolerance_e`, or, if that is None, with the fraction `noise_part` of the noise."""
        return True

    @abstractmethod
    def exact_path(self, tolerance: Tolerance | None) -> tuple[Path, str]:
        """Return how frames with every effect are executed if nothing is measured, and the reason
        if this is not by sums."""

    @property
    def open_part(self) -> NDArray[np.float32]:
        """Fraction (rows, cols) of the frame that each pixel is open; 1 for pixels that look."""
        return np.ones(self.light.shape, np.float32)

    def serves(self, plan: Plan) -> bool:
        """Return whether a plan for a scene with similar light, at least as strong, is valid for
        this scene.

        This is always true for fixed shutters, because errors by sums grow with light."""
        return True

    @abstractmethod
    def frames(self, plan: Plan, seed: int, count: int) -> Iterable[Frame]:
        """Return frames 0 to `count` - 1 under a plan, with noise from `seed`."""

    @abstractmethod
    def audit(self, plan: Plan, seed: int, count: int) -> Audit:
        """Compare up to `count` frames under a plan with the reference; return their errors."""
