"""The interface for planning, exposing and auditing a program on a scene."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.words.container import Container
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.execution.frames import Path
from nscc_runtime.frame_file import Frame
from nscc_runtime.light import Light
from nscc_runtime.loop import Loop
from nscc_runtime.planning.audit import Audit
from nscc_runtime.planning.plan import Plan
from nscc_runtime.planning.tolerance import Tolerance, with_readout_e
from nscc_runtime.planning.trial import NONE, Names, Trial


@dataclass(frozen=True, eq=False)
class PlannedScene(ABC):
    """A program on a scene, to be planned, exposed and audited.

    `threads`: number of threads (None: all processors); results do not depend on it.
    `torch_device`: the torch device that draws noise and adds up frames of programs with fixed
    shutters; None for the processor."""

    container: Container
    sensor: Sensor
    light: Light
    device_seed: int = 0
    threads: int | None = None
    torch_device: str | None = None

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
