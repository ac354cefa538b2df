"""The interface of a program on a scene for planning, exposing and auditing."""

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

    Results do not depend on `threads` (None: all processors). `torch_device`: the device that draws
    and adds up frames with fixed shutters; None for the processor.
    """

    container: Container
    sensor: Sensor
    light: Light
    device_seed: int = 0
    threads: int | None = None
    torch_device: str | None = None

    @property
    @abstractmethod
    def loop(self) -> Loop[Any]:
        """The loop that has to be compiled first."""

    @abstractmethod
    def ready(self) -> None:
        """Analyse the program. Raises Rejected where it cannot run."""

    @abstractmethod
    def signal_e(self) -> float:
        """Return the mean signal of a frame (`nscc_runtime.planning.tolerance.mean_signal_e`)."""

    def noise_e(self) -> float:
        """Return the noise of a frame with every effect, readout and rounding included: the
        standard deviation over frames, as a root mean square over pixels and buckets."""
        return with_readout_e(self.trial(NONE).noise_e(), self.sensor)

    @abstractmethod
    def trial(self, forced_off: Names) -> Trial:
        """Return the trial that measures effects on this scene."""

    def slower_trial(self, trial: Trial, tolerance_e: float) -> Trial | None:
        """Return a slower trial with smaller approximations; None if there is none."""
        return None

    def approximates(self, tolerance_e: float | None, noise_part: float | None) -> bool:
        """Whether the approximations of sums are certainly small relative to a tolerance, or to a
        fraction `noise_part` of the noise if the tolerance in electrons is unknown."""
        return True

    @abstractmethod
    def exact_path(self, tolerance: Tolerance | None) -> tuple[Path, str]:
        """Return the path for frames with every effect if nothing is measured, and the reason if it
        is not sums."""

    @property
    def open_part(self) -> NDArray[np.float32]:
        """Fraction (rows, cols) of the frame in which each pixel is open; 1 for pixels that
        look."""
        return np.ones(self.light.shape, np.float32)

    def serves(self, plan: Plan) -> bool:
        """Whether a plan for a scene with similar light, at least as strong, is valid for this one.
        Errors by sums grow with light, so it always is for fixed shutters."""
        return True

    @abstractmethod
    def frames(self, plan: Plan, seed: int, count: int) -> Iterable[Frame]:
        """Return frames 0 .. `count` - 1 under a plan, with noise from `seed`."""

    @abstractmethod
    def audit(self, plan: Plan, seed: int, count: int) -> Audit:
        """Compare frames under a plan with the reference."""
