"""What a program on a scene is to planning and to a run."""

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

    `threads`, None for all processors, change no bit; `torch_device`: where frames with fixed
    shutters are drawn and added up, None for the processor.
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
        """The loop that is compiled first."""

    @abstractmethod
    def ready(self) -> None:
        """Analyse the program. Raises Rejected where it cannot run."""

    @abstractmethod
    def signal_e(self) -> float:
        """The mean signal of a frame (`nscc_runtime.planning.tolerance.mean_signal_e`)."""

    def noise_e(self) -> float:
        """The frame's own noise: the root mean square over pixels and buckets of the standard
        deviation over frames with every effect, that of the readout and its rounding included."""
        return with_readout_e(self.trial(NONE).noise_e(), self.sensor)

    @abstractmethod
    def trial(self, forced_off: Names) -> Trial:
        """The scene, to be measured."""

    def slower_trial(self, trial: Trial, tolerance_e: float) -> Trial | None:
        """The same by what approximates less, None where nothing does."""
        return None

    def approximates(self, tolerance_e: float | None, noise_part: float | None) -> bool:
        """Whether what sums approximate is small for sure beside a tolerance, or beside a part of
        the noise where that is all that is known of it."""
        return True

    @abstractmethod
    def exact_path(self, tolerance: Tolerance | None) -> tuple[Path, str]:
        """What executes frames with every effect where nothing is measured, and why that is slower
        than sums, if it is."""

    @property
    def open_part(self) -> NDArray[np.float32]:
        """The part (rows, cols) of the frame whose light each pixel sees; all where they look."""
        return np.ones(self.light.shape, np.float32)

    def serves(self, plan: Plan) -> bool:
        """Whether a plan for a scene with light of the same kind, and no weaker, keeps its promise
        on this one: cheaper than a new plan. Errors by sums grow with light."""
        return True

    @abstractmethod
    def frames(self, plan: Plan, seed: int, count: int) -> Iterable[Frame]:
        """Frames 0 .. `count` - 1 under a plan; `seed` is that of their noise."""

    @abstractmethod
    def audit(self, plan: Plan, seed: int, count: int) -> Audit:
        """A plan's frames against the reference's."""
